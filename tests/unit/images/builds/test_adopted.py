"""ROS on an image of somebody else: what is read of the image, and how steps run on it."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.archives import write
from fakes.http_registry import LocalRegistry
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import adopt
from rosml.containerize.inputs import Values
from rosml.images.builds import adopted
from rosml.images.builds.adopted import Adopted, Query
from rosml.images.image_set import load
from rosml.machine import buildx
from rosml.machine.services import Services

WHOLE = {
    "etc/os-release": "ID=debian\nVERSION_CODENAME=bookworm\n",
    **dict.fromkeys(("bin/bash", "bin/apt-get", "dpkg/status"), "x"),
    "apt/debian.sources": "Types: deb\nURIs: http://x\n",
}
"""The files that ROS needs of an image."""


@pytest.fixture
def services(server: LocalRegistry, tmp_path: Path) -> Services:
    return Services(tmp_path, server.address, ("buildx",), "rosml", "buildkitd", None, "", "", bases=())


def has_files(monkeypatch: pytest.MonkeyPatch, files: Mapping[str, str]) -> None:
    """Lets the builder copy these files out of an image."""

    def run(_services: Services, bake: buildx.Bake) -> None:
        assert bake.glance, "nobody waits for another build to hear that an image does not fit"
        [output] = json.loads(Path(bake.file).read_text())["target"]["system"]["output"]
        write(Path(output.partition("dest=")[2]), files)

    monkeypatch.setattr(buildx, "run", run)


def with_ros(services: Services, lines: list[str] | None = None, **config: object) -> Base:
    off = config.pop("off", False)
    base = Base("vendor:1", "sha256:1", **{"environment": {}, **config})  # type: ignore[arg-type]
    say = (lines if lines is not None else []).append
    return adopt.with_ros(base, services, Values(base_entrypoint=not off), ("linux/amd64",), say)


def with_ros_1(**config: object) -> Adopted:
    """An image that gets the ROS of ros1-bookworm-core."""
    image_set = load.load(ROOT / "matrix.yaml")
    ros = image_set.by_target["ros1-bookworm-core"]
    return Adopted("vendor@sha256:1", image_set, ros, **config)  # type: ignore[arg-type]


def targets(tmp_path: Path, **config: object) -> dict[str, dict[str, object]]:
    """The bake targets that install ROS."""
    return adopted.base_targets(with_ros_1(**config), "base", {}, tmp_path, tmp_path)


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"opt/ros/setup.bash": "x"}, "vendor:1 has another ROS in /opt/ros"),
        ({"dpkg/status": ""}, "has no /var/lib/dpkg/status, so ROS cannot be installed on it"),
        ({"apt/debian.sources": ""}, "has no source for apt"),
        ({"apt/debian.sources": "# deb http://x y main\nTypes: deb-src\n"}, "has no source for apt"),
    ],
)
def test_an_image_that_cannot_get_ros(
    services: Services, monkeypatch: pytest.MonkeyPatch, changes: dict[str, str], reason: str
) -> None:
    files = {**WHOLE, **changes}
    has_files(monkeypatch, {name: text for name, text in files.items() if text or name not in changes})
    with pytest.raises(RosmlError, match=reason) as caught:
        with_ros(services)
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_an_image_that_cannot_be_examined(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    has_files(monkeypatch, {f"etc/os-release/{number}": "" for number in range(300)})
    with pytest.raises(RosmlError, match=r"vendor:1 cannot be examined: .*200 files"):
        adopted.look(services, "vendor:1", "linux/amd64", Query(("jazzy",)))
    assert not [*services.state.rglob("*.tar")], "it may be large"

    def fails(_services: Services, bake: buildx.Bake) -> None:
        raise RosmlError('failed to calculate checksum of ref x::y: "/etc/os-release": not found', "run 'rosml locks'")

    monkeypatch.setattr(buildx, "run", fails)
    with pytest.raises(RosmlError, match="is a link that leads nowhere") as caught:
        adopted.look(services, "vendor:1", "linux/amd64", Query(("jazzy",)))
    assert caught.value.remedy == "name another base image"


def test_a_file_that_is_too_large_to_copy_counts(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    has_files(monkeypatch, {**WHOLE, "dpkg/status": "x" * (5 << 20)})
    assert with_ros(services).adopted


@pytest.mark.parametrize("path", ["", "/usr/bin:/bin", "$PATH:/usr/sbin"])
@pytest.mark.parametrize("more", [{}, {"ROS_DISTRO": "jazzy"}])
def test_a_path_without_the_systems_programs(services: Services, path: str, more: dict[str, str]) -> None:
    with pytest.raises(RosmlError, match=r"vendor:1: its PATH lacks /usr/s?bin") as caught:
        with_ros(services, environment={"PATH": path, **more})
    assert "with ENV PATH=$PATH:/usr/" in caught.value.remedy


START, RUNS, OUT = ("/start.sh",), "runs before each command", "is left out"


@pytest.mark.parametrize(
    ("entrypoint", "script", "called", "line"),
    [
        (("/entrypoint.sh",), 'exec "$@"', "/usr/local/lib/rosml/entrypoint.sh", RUNS),
        (("bash", "/start.sh"), 'exec "$@"', "bash /start.sh", RUNS),
        (START, 'exec 3>&1\nif x; then\n  exec y\nfi\nexec "$@"', "/start.sh", RUNS),
        (START, "exec nginx", "", 'is left out, it is no script that ends in exec "$@"'),
        (START, 'exec sleep 1000\nexec "$@"', "", OUT),
        (START, 'set -- nginx "$@"\nexec "$@"', "", OUT),
        (START, 'exit 0\nexec "$@"', "", OUT),
        (START, "", "", OUT),
        (("sleep", "1000"), 'exec "$@"', "", OUT),
        (START, "off", "", "is left out, as --no-base-entrypoint says"),
    ],
)
def test_an_entrypoint_runs_before_the_command_if_it_becomes_it(
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
    entrypoint: tuple[str, ...],
    script: str,
    called: str,
    line: str,
) -> None:
    """After a server, no app would ever start."""
    off, lines = script == "off", list[str]()
    has_files(monkeypatch, WHOLE | ({"entrypoint/0/x.sh": f"#!/bin/sh\n{script}\n"} if script and not off else {}))
    onto = with_ros(services, lines, entrypoint=entrypoint, off=off).adopted
    assert onto and " ".join(onto.entrypoint) == called
    assert [text for text in lines if line in text]


def test_a_cache_is_for_one_entrypoint() -> None:
    image = with_ros_1()
    assert image.inputs != replace(image, entrypoint=("x",)).inputs


def test_steps_run_as_on_our_own_images(tmp_path: Path) -> None:
    """What an image says of shells and tools is for its programs, and it has it in the end."""
    environment = {"RUNTIME": 'a\n"$b"', "ROS_VERSION": "9", "PERL5OPT": "-Mnone", "LANG": "de"}
    bake = targets(tmp_path, environment=environment, shell=("conda", "run", "/bin/bash", "-c"))
    first, last = str(bake["base-system"]["dockerfile-inline"]), bake["base"]
    [shell, *emptied, _path] = re.findall("^(?:ENV|SHELL) (.*)", first, re.M)
    assert emptied == ["RUNTIME=", "ROS_VERSION="], "an argument without a value would have that of the image"
    path = os.environ["PATH"]
    variables = {"PATH": path, "RUNTIME": "", "PERL5OPT": "-Mnone", "BASH_ENV": "/etc/noise", "LANG": "de"}
    done = subprocess.run([*json.loads(shell), "env"], env=variables, capture_output=True, text=True, check=True)
    assert {"RUNTIME=", "LANG=C.UTF-8", f"PATH={path}"} <= {*done.stdout.splitlines()}
    assert not re.search("PERL5OPT|BASH_ENV", done.stdout)
    assert 'SHELL ["conda", "run", "/bin/bash", "-c"]\n' in str(last["dockerfile-inline"])
    assert last["args"] == {"KEPT_RUNTIME": 'a\n"$b"', "KEPT_LANG": "de"}


def test_steps_have_the_arguments_of_the_dockerfiles() -> None:
    """And the seed, without which bytecode differs from build to build."""
    script = (ROOT / "components/containerize/step.sh").read_text()
    names = {*re.findall(r"[A-Za-z0-9_]+", script.partition("for name in")[2].partition("; do")[0])}
    assert "PYTHONHASHSEED" in names
    ours = ("base", "ros", "ros-wheels")
    for dockerfile, stages in (("Dockerfile", ours), ("components/containerize/Dockerfile", None)):
        for stage in re.split(r"^FROM ", (ROOT / dockerfile).read_text(), flags=re.MULTILINE)[1:]:
            if stages is None or re.match(r".* AS (\S+)", stage)[1] in stages:  # type: ignore[index]
                lines = re.findall(r"^ARG (.+)$", stage, re.MULTILINE)
                assert {word.partition("=")[0] for line in lines for word in line.split()} <= names, stage


def test_only_steps_that_run_code_of_packages_have_other_variables() -> None:
    dockerfile = (ROOT / "components/containerize/Dockerfile").read_text().replace("\\\n", "")
    steps = re.findall(r"^RUN (?:--mount=\S+ +)*(.*)$", dockerfile, re.MULTILINE)
    others = [step for step in steps if not step.startswith('["/run/scripts/containerize/step.sh", ')]
    assert len(steps) > len(others) > 0
    assert {step.split(".sh ")[0].rpartition("/")[2] for step in others} == {"workspace", "test"}


def test_a_script_of_the_repository_has_the_variables_of_the_image_and_of_the_step() -> None:
    folder = ROOT / "components/containerize"
    script = f"export APT_CONFIG=ours && source {folder}/image_variables.sh && env -0"
    variables = {"PATH": os.environ["PATH"], "SDK": "a\nb", "APT_CONFIG": "theirs", "HOME": "/none"}
    variables["BASH_FUNC_x%%"] = "() { :; }"
    command = [str(folder / "step.sh"), "bash", "-ec", script]
    done = subprocess.run(command, env=variables, capture_output=True, check=True)
    values = dict(item.partition("=")[::2] for item in done.stdout.decode().split("\0"))
    assert (values["SDK"], values["APT_CONFIG"], values["HOME"]) == ("a\nb", "ours", "/none")


def test_labels_that_claim_to_be_ours_count_for_nothing(tmp_path: Path) -> None:
    """`rosml join` would look for an image without compilers, or take it for an app."""
    claims = {"io.rosml.runtime": "core-run", "io.rosml.app": "run", "io.rosml.python": "3.8", "maintainer": "me"}
    labels = targets(tmp_path, labels=claims)["base"]["labels"]
    assert isinstance(labels, dict)
    assert [labels.get(name) for name in claims] == ["", "", "3.11", None]


def test_a_framework_that_no_variable_names(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """`rosml join` asks the label: two releases of torch in one folder would work with neither."""
    has_files(monkeypatch, {**WHOLE, "carries/torch/__init__.py": "", "carries/cuda/version.json": ""})
    base = with_ros(services)
    assert base.adopted
    bake = adopted.base_targets(base.adopted, "base", {}, services.state, services.state)
    assert bake["base"]["labels"]["io.rosml.own"] == "cuda torch"
