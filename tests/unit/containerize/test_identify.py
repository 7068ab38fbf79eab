"""What an app's packages need: what is said of keys of rosdep that become no package.

rosdep and catkin_pkg are in images alone, so these have their shape here.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from fakes.stubs import script_of_a_build

RULES: dict[str, dict[str, Any]] = {
    "angles": {"debian": ["libangles-dev"]},
    "boost": {"debian": ["libboost-dev"]},
    "nodelet": {"debian": ["libnodelet-dev", "libnodeletlib-dev", "python3-nodelet"]},
    "only_on_ubuntu": {"ubuntu": ["libfoo-dev"]},
    "only_old_debian": {"debian": {"buster": ["libbar-dev"], "bookworm": None}, "fedora": None},
    "null_rule": {"debian": None},
    "by_source": {"debian": ("source", {"uri": "https://example.org/x.rdmanifest", "md5sum": "abc"})},
    "by_snap": {"debian": ("snap", ["x"])},
    "above": {"debian": ["above"]},
    "rti-connext-dds-6.0.1": {"ubuntu": {"jammy": ["rti"]}, "rhel": ["rti"]},
}


class View:
    """rosdep's view of lists."""

    def keys(self) -> list[str]:
        return [*RULES]

    def lookup(self, key: str) -> Any:
        """By the rules of Debian bookworm. A rule is a list of apt's packages, or a way with anything."""

        def rule_for_platform(*_: object) -> tuple[str, Any]:
            rule = RULES[key].get("debian")
            if isinstance(rule, list):
                return "apt", rule
            if isinstance(rule, tuple):
                return rule
            raise KeyError(key)

        return SimpleNamespace(data=RULES[key], get_rule_for_platform=rule_for_platform)


APT = SimpleNamespace(resolve=lambda rule: rule, get_depends=lambda rule: ["by_source"] if rule == ["above"] else [])


@pytest.fixture
def identify(monkeypatch: pytest.MonkeyPatch) -> Any:
    """identify.py as a module, with a rosdep on Debian bookworm that knows RULES and asks no network."""
    fakes: dict[str, dict[str, Any]] = {
        "catkin_pkg": {},
        "catkin_pkg.package": {"parse_package": None},
        "rosdep2": {"RosdepLookup": None, "create_default_installer_context": None, "get_default_installer": None},
        "rosdep2.lookup": {"ResolutionError": RuntimeError},
        "rosdep2.rospkg_loader": {"DEFAULT_VIEW_KEY": "*"},
        "rosdep2.sources_list": {"SourcesListLoader": None},
    }
    for name, content in fakes.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.delitem(sys.modules, "manifests", raising=False)
    module = script_of_a_build("containerize/identify.py")

    class Rosdep(module.Rosdep):  # type: ignore[name-defined, misc]
        def __init__(self, *_: object) -> None:
            self._view, self._may_ask, self.failure = View(), False, ""
            self._context = SimpleNamespace(get_installer={"apt": APT}.__getitem__)
            self._platform = ("debian", "bookworm", ["apt", "pip"], "apt")

    monkeypatch.setattr(module, "Rosdep", Rosdep)
    vars(module)["has"] = module.provided
    monkeypatch.setattr(module, "provided", set)
    return module


def printed(identify: Any, capsys: pytest.CaptureFixture[str], *keys: str) -> str:
    """The messages about keys that a package `arm` asks for."""
    with pytest.raises(SystemExit) as caught:
        identify.answers({"arm": {"exec": {*keys}}, "moveit_arm": {}}, set(), identify.Rosdep())
    return f"{capsys.readouterr().err}{caught.value}"


@pytest.mark.parametrize(
    ("key", "why"),
    [
        ("angels", "there is angles"),
        ("moveit_arms", "there is moveit_arm"),
        ("nothing_like_it", "no list has it"),
        ("only_on_ubuntu", "there is one for ubuntu"),
        ("only_old_debian", "there is one for debian buster"),
        ("null_rule", "there is one for no other system"),
    ],
)
def test_a_key_without_a_package_is_told_with_its_reason(
    identify: Any, capsys: pytest.CaptureFixture[str], key: str, why: str
) -> None:
    what = f"has no rule for {key} on Debian bookworm" if "one for" in why else f"does not know {key}"
    text = printed(identify, capsys, key, "boost")
    assert text.startswith(f"error: rosdep {what}, which arm asks for ({why}); correct a wrong name in package.xml; ")
    assert text.endswith(f"--skip-keys '{key}'") and "\n" not in text, "one cause is one error"


def test_keys_with_rules_elsewhere_can_be_left_out_by_a_line_to_copy(
    identify: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    """A typo is none of them."""
    text = printed(identify, capsys, "angels", "only_on_ubuntu", "rti-connext-dds-6.0.1")
    assert text.endswith("--skip-keys 'only_on_ubuntu rti-connext-dds-6.0.1'")
    many = printed(identify, capsys, *(f"of_nobody_{number:02d}" for number in range(30)))
    assert many.count("rosdep does not know") == 12 and "and 18 keys more\n" in many
    assert many.count("error: ") == 1


@pytest.mark.parametrize(
    ("ros", "key", "other"), [("1", "rclcpp", "2"), ("2", "catkin", "1"), ("2", "rclcpp", ""), ("", "rclpy", "")]
)
def test_packages_of_the_other_ros_are_named(
    identify: Any, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, ros: str, key: str, other: str
) -> None:
    """A repository may have packages of both, each to be left out where the other one is built."""
    monkeypatch.setenv("ROS_VERSION", ros)
    text = printed(identify, capsys, key)
    assert (f"has ROS {ros}, and arm asks for packages of ROS {other};" in text) == bool(other)
    assert (f"does not know {key}" in text) == ("--skip-keys" in text) != bool(other)


def test_a_package_with_nodelets_gets_the_program_that_loads_them(identify: Any) -> None:
    [answer] = identify.answers({"arm": {"exec": {"nodelet"}}}, set(), identify.Rosdep())["nodelet"]
    assert answer.names == (*RULES["nodelet"]["debian"], "libnodeletlib-tools")


def test_packages_of_cmake_without_a_manifest_are_those_of_the_workspace(identify: Any, tmp_path: Path) -> None:
    """colcon builds them first; what rosdep knows is installed all the same."""
    for place, text in (
        ("upstream/Sophus", "cmake_minimum_required(VERSION 3.16)\n  PROJECT( Sophus VERSION 1.0 )\n"),
        ("upstream/boost", 'project("boost")'),
        ("upstream/nameless", "# project(no)\n"),
        ("upstream/hidden/COLCON_IGNORE", ""),
        ("upstream/hidden", "project(hidden)"),
        ("target/arm", "project(arm)"),
        ("target/arm/package.xml", "<package/>"),
    ):
        file = tmp_path / place if "." in place or "IGNORE" in place else tmp_path / place / "CMakeLists.txt"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    plain = identify.manifests.plain(tmp_path)
    assert plain == {"Sophus", "boost"}
    assert [*identify.answers({"arm": {"exec": {"Sophus", "boost"}}}, set(), identify.Rosdep(), plain)] == ["boost"]


def test_a_list_of_packages_to_leave_out_may_be_older_than_the_sources(
    identify: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("arm", "leg"):
        (tmp_path / "src/target" / name).mkdir(parents=True)
        (tmp_path / "src/target" / name / "package.xml").touch()
    monkeypatch.setattr(identify.manifests, "parse_package", lambda path: SimpleNamespace(name=Path(path).parent.name))
    (tmp_path / "list").write_text("leg\nmessage_tf_frame_transformer\n")
    packages = identify.manifests.packages(tmp_path / "src", tmp_path / "list")
    assert [package.name for _, package in packages] == ["arm"]
    assert "warning: no package is called message_tf_frame_transformer" in capsys.readouterr().err


def test_what_the_base_image_has_is_not_installed(
    identify: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As packages that were built, and as wheels."""
    for name in ("install/share/arm/package.xml", "install/leg/share/leg/package.xml"):
        (tmp_path / name).parent.mkdir(parents=True)
        (tmp_path / name).touch()
    for name in ("ros_sensor_msgs-5.3.6", "ros_rclpy-7.1.6", "lark_parser-0.12.0"):
        (tmp_path / "lib/python3.11/site-packages" / f"{name}.dist-info").mkdir(parents=True)
    monkeypatch.setattr(identify, "WORKSPACES", (tmp_path,))
    monkeypatch.setattr(identify, "ROS", tmp_path)
    assert identify.has() == {"arm", "leg", "sensor_msgs", "rclpy"}


def test_lists_that_were_not_fetched_may_have_a_key(
    identify: Any, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """No other name is proposed for it: that would be a guess from half of the lists."""
    offline = identify.Rosdep()
    offline.failure = "https://a: no name"
    monkeypatch.setattr(identify, "Rosdep", lambda: offline)
    text = printed(identify, capsys, "angels", "only_on_ubuntu")
    assert text.startswith("rosdep does not know angels, which arm asks for\n") and text.count("error: ") == 1
    assert "no rule for only_on_ubuntu on Debian bookworm, which arm asks for (there is one for ubuntu)\n" in text
    assert "rosdep's lists could not be fetched: https://a: no name; those of the image do not know all keys" in text


def test_all_hosts_that_fail_are_named(identify: Any) -> None:
    """As rosdep says it: each at once, and all again at the end."""
    error = "ERROR: unable to process source [https://{0}/base.yaml]:\n\t<urlopen error {1}> (https://{0}/base.yaml)\n"
    both = error.format("a", "timed out") + error.format("b", "HTTP Error 404")
    output = f"{both}ERROR: Not all sources were able to be updated.\n[[[\n{both}]]]\n"
    reasons = "https://a/base.yaml: <urlopen error timed out>; https://b/base.yaml: <urlopen error HTTP Error 404>"
    assert identify.reasons(output) == reasons
    both = error.format("a", "no name") + error.format("b", "no name")
    assert identify.reasons(both) == "https://a/base.yaml, https://b/base.yaml: <urlopen error no name>"
    assert identify.reasons("ERROR: error loading sources list:\n\t<urlopen error x>\n") == "<urlopen error x>"
    assert identify.reasons(" \n") == ""


@pytest.mark.parametrize(
    ("error", "calls"), [("HTTP Error 503: busy", 3), ("HTTP Error 429: many", 3), ("HTTP Error 404", 1)]
)
def test_a_server_of_lists_that_is_too_busy_is_asked_again(
    identify: Any, monkeypatch: pytest.MonkeyPatch, error: str, calls: int
) -> None:
    called = []

    def run(command: list[str], **_: object) -> Any:
        called.append(command)
        return SimpleNamespace(returncode=1, stderr=error.encode())

    monkeypatch.setattr(identify.subprocess, "run", run)
    monkeypatch.setattr(identify, "PAUSES", (0.001, 0.001))
    assert identify.failure(["rosdep", "update"], {}) == error
    assert len(called) == calls


@pytest.mark.parametrize("words", ["only_on_ubuntu null_rule", " only_on_ubuntu,\nnull_rule ,"])
def test_keys_to_leave_out_are_separated_by_blanks_or_commas(
    identify: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, words: str
) -> None:
    monkeypatch.setenv("SKIP_KEYS", words)
    monkeypatch.setattr(identify, "read", lambda *_: {"arm": {"exec": {"boost", "only_on_ubuntu", "null_rule"}}})
    identify.main(tmp_path, tmp_path, tmp_path, tmp_path, tmp_path / "out")
    facts = json.loads((tmp_path / "out/dependencies.json").read_text())
    assert (facts["skipped"], [*facts["keys"]]) == (["null_rule", "only_on_ubuntu"], ["boost"])


def test_conditions_compare_with_the_release_of_the_base_image(
    identify: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    contexts = list[dict[str, str]]()
    attributes: dict[str, Any] = {attribute: [] for group in identify.KINDS.values() for attribute in group}
    package = SimpleNamespace(name="robot", evaluate_conditions=contexts.append, **attributes)
    monkeypatch.setattr(identify.manifests, "packages", lambda *_: [(Path("target/robot"), package)])
    monkeypatch.setenv("ROS_DISTRO", "Debian")
    for conditions in ("noetic", ""):
        monkeypatch.setenv("CONDITIONS", conditions)
        identify.read(tmp_path, tmp_path)
    assert [context["ROS_DISTRO"] for context in contexts] == ["noetic", "Debian"]


@pytest.mark.parametrize(
    ("key", "problem"),
    [("by_source", r"source: .*x\.rdmanifest"), ("by_snap", "--skip-keys by_snap"), ("above", "source: ")],
)
def test_a_rule_that_no_image_can_follow_is_named(identify: Any, key: str, problem: str) -> None:
    """One of sources asks the network as soon as rosdep looks at it."""
    packages = {name: {"exec": {key}} for name in ("robot", "arm")}
    with pytest.raises(SystemExit, match=f"rule for {key}, which arm, robot asks for, .*{problem}"):
        identify.answers(packages, set(), identify.Rosdep())
