"""An image that somebody else made: what is read of it, and how steps run on it."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import tarfile
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.http_registry import StandIn
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import adopt
from rosml.containerize.inputs import Values
from rosml.images.builds import adopted
from rosml.images.builds.adopted import Adopted, Sought
from rosml.images.image_set import load
from rosml.machine import buildx
from rosml.machine.services import Services

RELEASE = "ID=debian\nVERSION_CODENAME=bookworm\n"
VALUES = Values()


@pytest.fixture
def services(stand_in: StandIn, tmp_path: Path) -> Services:
    return Services(tmp_path, stand_in.address, ("buildx",), "rosml", "buildkitd", None, "", "", bases=())


WHOLE = ("bin/bash", "bin/apt-get", "dpkg/status", "apt/debian.sources")
"""What an image has on which ROS can be installed, besides its os-release."""


def leaves(
    monkeypatch: pytest.MonkeyPatch,
    *files: str,
    whole: Iterable[str] = WHOLE,
    contents: Mapping[str, str] | None = None,
) -> None:
    """Lets the builder copy these files out of an image, and an os-release."""
    texts = {"apt/debian.sources": "Types: deb\nURIs: http://x\n", **(contents or {})}

    def run(_services: Services, bake: buildx.Bake) -> None:
        assert bake.glance, "nobody waits for another build to hear that an image does not fit"
        [output] = json.loads(Path(bake.file).read_text())["target"]["system"]["output"]
        with tarfile.open(output.partition("dest=")[2], "w") as archive:
            for name in ("etc/os-release", *whole, *files):
                text = texts.get(name, RELEASE)
                entry = tarfile.TarInfo(name)
                entry.size = len(text)
                archive.addfile(entry, io.BytesIO(text.encode()))

    monkeypatch.setattr(buildx, "run", run)


def test_a_ros_that_the_matrix_does_not_have(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is installed beside it, as beside one that it has."""
    leaves(monkeypatch, "opt/ros/setup.bash")
    with pytest.raises(RosmlError, match="vendor:1 has another ROS in /opt/ros") as caught:
        adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print)
    assert caught.value.remedy == "add --ros-distro NAME"


def test_an_image_that_cannot_be_looked_at(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    leaves(monkeypatch, *(f"etc/os-release/{number}" for number in range(300)))
    with pytest.raises(RosmlError, match=r"vendor:1 cannot be examined: .*200 files") as caught:
        adopted.look(services, "vendor:1", "linux/amd64", Sought(("jazzy",)))
    assert caught.value.remedy == "name another base image"
    assert not [*services.state.rglob("*.tar")], "it may be large"

    def fails(_services: Services, bake: buildx.Bake) -> None:
        raise RosmlError('failed to calculate checksum of ref x::y: "/etc/os-release": not found', "run 'rosml locks'")

    monkeypatch.setattr(buildx, "run", fails)
    with pytest.raises(RosmlError, match="is a link that leads nowhere") as caught:
        adopted.look(services, "vendor:1", "linux/amd64", Sought(("jazzy",)))
    assert caught.value.remedy == "name another base image"


@pytest.mark.parametrize(
    ("lacking", "sources", "says"),
    [
        ("dpkg/status", "Types: deb\n", "has no /var/lib/dpkg/status, so ROS cannot be installed on it"),
        ("apt/debian.sources", "", "has no source for apt, so ROS cannot be installed on it"),
        ("", "# deb http://x y main\nTypes: deb-src\n", "has no source for apt"),
    ],
)
def test_what_an_installation_needs(
    services: Services, monkeypatch: pytest.MonkeyPatch, lacking: str, sources: str, says: str
) -> None:
    """Its files say so at once, while another build may have the builder."""
    whole = [name for name in WHOLE if name != lacking]
    leaves(monkeypatch, whole=whole, contents={"apt/debian.sources": sources})
    with pytest.raises(RosmlError, match=says) as caught:
        adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print)
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_what_is_too_large_to_copy_is_there(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """The list of dpkg, in an image with a thousand packages."""
    leaves(monkeypatch, contents={"dpkg/status": "x" * (5 << 20)})
    assert adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print).adopted


@pytest.mark.parametrize("path", ["", "/opt/conda/bin", "/usr/bin:/bin", "$PATH:/usr/sbin"])
def test_a_path_without_the_systems_programs(services: Services, path: str) -> None:
    for environment in ({"PATH": path}, {"PATH": path, "ROS_DISTRO": "jazzy"}):
        with pytest.raises(RosmlError, match=r"vendor:1: its PATH lacks /usr/s?bin") as caught:
            adopt.with_ros(Base("vendor:1", "sha256:1", environment), services, VALUES, ("linux/amd64",), print)
        assert "with ENV PATH=$PATH:/usr/" in caught.value.remedy


@pytest.mark.parametrize(
    ("entrypoint", "script", "off", "called", "says"),
    [
        (("/entrypoint.sh",), 'exec "$@"', False, "/usr/local/lib/rosml/entrypoint.sh", "runs before each command"),
        (("bash", "/start.sh"), 'exec "$@"', False, "bash /start.sh", "runs before each command"),
        (("/start.sh",), "exec nginx", False, "", 'is left out, it is no script that ends in exec "$@"'),
        (("/start.sh",), 'exec sleep 1000\nexec "$@"', False, "", "is left out"),
        (("/start.sh",), 'set -- nginx "$@"\nexec "$@"', False, "", "is left out"),
        (("/start.sh",), 'exit 0\nexec "$@"', False, "", "is left out"),
        (
            ("/start.sh",),
            'exec 3>&1\nif x; then\n  exec y\nfi\nexec "$@"',
            False,
            "/start.sh",
            "runs before each command",
        ),
        (("/start.sh",), None, False, "", "is left out"),
        (("sleep", "1000"), 'exec "$@"', False, "", "is left out"),
        (("/start.sh",), 'exec "$@"', True, "", "is left out, as --no-base-entrypoint says"),
    ],
)
def test_an_entrypoint_runs_before_the_command_if_it_becomes_it(
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
    entrypoint: tuple[str, ...],
    script: str | None,
    off: bool,
    called: str,
    says: str,
) -> None:
    """After a server, no app would ever start."""
    scripts = {"entrypoint/0/x.sh": f"#!/bin/sh\n{script}\n"} if script and not off else {}
    leaves(monkeypatch, *scripts, contents=scripts)
    said: list[str] = []
    values = Values(base_entrypoint=not off)
    base = Base("vendor:1", "sha256:1", {}, entrypoint=entrypoint)
    onto = adopt.with_ros(base, services, values, ("linux/amd64",), said.append).adopted
    assert onto and " ".join(onto.entrypoint) == called
    assert [line for line in said if says in line]
    assert len({replace(onto, entrypoint=words).inputs for words in ((), ("x",))}) == 2, "a cache has one of both"


def test_steps_run_as_on_our_own_images(tmp_path: Path) -> None:
    """What an image says of shells and tools is for its programs, and it has it in the end."""
    image_set = load.load(ROOT / "matrix.yaml")
    environment = {"RUNTIME": 'a\n"$b"', "ROS_VERSION": "9", "PERL5OPT": "-Mnone", "LANG": "de"}
    image = image_set.by_target["ros1-bookworm-core"]
    onto = Adopted("vendor@sha256:1", image_set, image, environment, shell=("conda", "run", "/bin/bash", "-c"))
    found = adopted.base_targets(onto, "base", {}, tmp_path, tmp_path)
    first, last = found["base-system"]["dockerfile-inline"], found["base"]
    [shell, *emptied, _path] = re.findall("^(?:ENV|SHELL) (.*)", first, re.M)
    assert emptied == ["RUNTIME=", "ROS_VERSION="], "an argument without a value would have that of the image"
    image_variables = {
        "PATH": os.environ["PATH"],
        "RUNTIME": "",
        "PERL5OPT": "-Mnone",
        "BASH_ENV": "/etc/noise",
        "LANG": "de",
    }
    command = [*json.loads(shell), "echo said && env"]
    done = subprocess.run(command, env=image_variables, capture_output=True, text=True, check=True)
    said, *variables = done.stdout.splitlines()
    assert said == "said" and {"RUNTIME=", "LANG=C.UTF-8", f"PATH={os.environ['PATH']}"} <= {*variables}
    assert not re.search("PERL5OPT|BASH_ENV", done.stdout)
    assert 'SHELL ["conda", "run", "/bin/bash", "-c"]\n' in last["dockerfile-inline"]
    assert last["args"] == {"KEPT_RUNTIME": 'a\n"$b"', "KEPT_LANG": "de"}


def test_steps_have_the_arguments_of_the_dockerfiles() -> None:
    """And the seed, without which bytecode differs from build to build."""
    script = (ROOT / "components/containerize/step.sh").read_text()
    names = {*re.findall(r"[A-Za-z0-9_]+", script.partition("for name in")[2].partition("; do")[0])}
    assert "PYTHONHASHSEED" in names
    for dockerfile, stages in (
        ("Dockerfile", ("base", "ros", "ros-wheels")),
        ("components/containerize/Dockerfile", None),
    ):
        for stage in re.split(r"^FROM ", (ROOT / dockerfile).read_text(), flags=re.MULTILINE)[1:]:
            if stages is None or re.match(r".* AS (\S+)", stage)[1] in stages:  # type: ignore[index]
                lines = re.findall(r"^ARG (.+)$", stage, re.MULTILINE)
                assert {word.partition("=")[0] for line in lines for word in line.split()} <= names, stage


def test_each_step_on_a_base_image_has_its_own_variables() -> None:
    """But for those that run code of the packages."""
    dockerfile = (ROOT / "components/containerize/Dockerfile").read_text().replace("\\\n", "")
    steps = re.findall(r"^RUN (?:--mount=\S+ +)*(.*)$", dockerfile, re.MULTILINE)
    others = [step for step in steps if not step.startswith('["/run/scripts/containerize/step.sh", ')]
    assert len(steps) > len(others) > 0
    assert {step.split(".sh ")[0].rpartition("/")[2] for step in others} == {"workspace", "test"}


def test_a_script_of_the_repository_has_the_variables_of_the_image() -> None:
    """And those of the step, such as apt's settings."""
    folder = ROOT / "components/containerize"
    script = f"export APT_CONFIG=ours && source {folder}/image_variables.sh && env -0"
    variables = {
        "PATH": os.environ["PATH"],
        "SDK": "a\nb",
        "APT_CONFIG": "theirs",
        "HOME": "/none",
        "BASH_FUNC_x%%": "() { :; }",
    }
    done = subprocess.run(
        [str(folder / "step.sh"), "bash", "-ec", script], env=variables, capture_output=True, check=True
    )
    found = dict(item.partition("=")[::2] for item in done.stdout.decode().split("\0"))
    assert (found["SDK"], found["APT_CONFIG"], found["HOME"]) == ("a\nb", "ours", "/none")


def test_what_an_image_claims_to_be_of_ours(tmp_path: Path) -> None:
    """Its labels say nothing to `rosml join`, which would look for an image without compilers, or take it for an app."""
    image_set = load.load(ROOT / "matrix.yaml")
    claims = {"io.rosml.runtime": "core-run", "io.rosml.app": "run", "io.rosml.python": "3.8", "maintainer": "me"}
    onto = Adopted("vendor@sha256:1", image_set, image_set.by_target["ros1-bookworm-core"], labels=claims)
    found = adopted.base_targets(onto, "base", {}, tmp_path, tmp_path)["base"]["labels"]
    wanted = ("io.rosml.runtime", "io.rosml.app", "io.rosml.python", "maintainer")
    assert [found.get(name) for name in wanted] == ["", "", "3.11", None]


def test_a_framework_that_no_variable_names(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """`rosml join` asks the label: two releases of torch in one folder would work with neither."""
    leaves(monkeypatch, "carries/torch/__init__.py", "carries/cuda/version.json")
    base = adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print)
    assert base.adopted
    found = adopted.base_targets(base.adopted, "base", {}, services.state, services.state)
    assert found["base"]["labels"]["io.rosml.own"] == "cuda torch"
