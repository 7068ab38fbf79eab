"""`rosml run --export quadlet`: podman and systemd start what `rosml run` would, with the same words."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from fakes import units
from fakes.exports import ME, PODMAN, text
from rosml.base.errors import RosmlError
from rosml.run.context import Engine
from tests.pages import blocks, commands

QUIET = ("--no-tz", "--no-user")
GENERATOR = shutil.which("quadlet", path=f"/usr/libexec/podman:/usr/lib/podman:{os.environ['PATH']}")


def unit(*line: str, **facts: Any) -> str:
    return text(*line, kind="quadlet", **facts)


def options(*line: str, **facts: Any) -> list[str]:
    """The options that systemd hands to podman because of a line, without those that rosml always adds."""
    always = units.argv(unit(*QUIET, "x", **facts))
    return [word for word in units.argv(unit(*QUIET, *line, "x", **facts)) if word not in always]


def keys(*line: str, **facts: Any) -> dict[str, str]:
    """The keys outside of the container's section."""
    return {key: value for part, key, value in units.values(unit(*line, **facts)) if part != "[Container]"}


def test_the_file_that_the_page_shows() -> None:
    shown = [block for block in blocks(ROOT / "docs/deploy.md") if block.section == "Start at boot"]
    command = shlex.split(next(commands(shown[0])).partition(">")[0])
    assert command[:4] == ["rosml", "run", "--export", "quadlet"]
    assert next(block.text for block in shown if block.title == "robot.container") == unit(*command[4:])


def test_a_unit_of_the_system() -> None:
    document = unit("x", person=replace(ME, uid=0, gid=0, name="root"))
    assert "sudo systemctl start robot" in document and "linger" not in document
    assert "WantedBy=multi-user.target" in document and "After=network-online.target" in document


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        (["-e", "A=1", "-e", "A=2"], ["--env=A=2"]),
        (["-l", "a", "--annotation", "b=c d"], ["--label=a=", "--annotation=b=c d"]),
        (["-v", "/a:/b:ro", "-v", "data:/d", "-v", "./x y:/z"], ["--volume=/a:/b:ro", "--volume=data:/d", "--volume=/home/jo/robot/x y:/z"]),
        (["-u", "1", "--user=2:3"], ["--user=2:3"]),
        (["-w", "/a b", "-w", "/c"], ["--workdir=/c"]),
        (["--device", "/dev/video0", "--device=/dev/a b"], ["--device=/dev/video0", "--device=/dev/a b"]),
        (["-p", "80:80", "-p", "[::1]:1:1"], ["--publish=80:80", "--publish=[::1]:1:1"]),
        (["--net=host", "--ipc", "host"], ["--network=host", "--ipc=host"]),
        (["--security-opt", "seccomp=./p.json"], ["--security-opt=seccomp=/home/jo/robot/p.json"]),
        (["--security-opt", "label=disable"], ["--security-opt=label=disable"]),
        (["--env-file", "../e"], ["--env-file=/home/jo/e"]),
        (["--gpus", '"device=0,GPU-1"'], ["--device=nvidia.com/gpu=0", "--device=nvidia.com/gpu=GPU-1"]),
        (["--gpus", "2"], ["--device=nvidia.com/gpu=0", "--device=nvidia.com/gpu=1"]),
        (["--init=false", "--read-only"], ["--init=false", "--read-only"]),
        (["-v", ":/b"], ["--volume=:/b"]),
        (["-it", "--rm", "-d", "--restart", "no"], []),
    ],
)  # fmt: skip
def test_an_option_as_podman_gets_it(typed: list[str], expected: list[str]) -> None:
    assert sorted(options(*typed)) == sorted(expected)


@pytest.mark.parametrize("name", ["volume", "network"])
def test_a_name_is_no_other_file_of_the_generator(name: str) -> None:
    """`x.volume:/d` would be the volume of x.volume beside it; as a word of podman it is a name."""
    document = unit(f"--{name}=x.{name}{':/d' if name == 'volume' else ''}", "me/x.image")
    assert f"PodmanArgs=--{name}=x.{name}" in document and "Image=docker.io/me/x.image:latest\n" in document


@pytest.mark.parametrize(
    ("engine", "image", "expected"),
    [
        (Engine(), "ros:jazzy", "docker.io/library/ros:jazzy"),
        (Engine(), "localhost:5000/a/b@sha256:" + "0" * 64, "localhost:5000/a/b@sha256:" + "0" * 64),
        (PODMAN, "ros:jazzy", "ros:jazzy"),
    ],
)
def test_the_image_has_the_name_that_the_engine_means(engine: Engine, image: str, expected: str) -> None:
    assert f"\nImage={expected}\n" in unit(image, engine=engine)


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ([], {"Restart": "always"}),
        (["--restart", "unless-stopped"], {"Restart": "always"}),
        (["--restart=on-failure"], {"Restart": "on-failure"}),
        (["--stop-timeout", "30"], {}),
        (["--stop-timeout", "120"], {"TimeoutStopSec": "180"}),
        (["--stop-timeout=-1"], {"TimeoutStopSec": "infinity"}),
    ],
)
def test_what_systemd_does(typed: list[str], expected: dict[str, str]) -> None:
    written = keys(*typed, "x")
    assert written.items() >= expected.items() and ("TimeoutStopSec" in written) == ("TimeoutStopSec" in expected)


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (["--restart=on-failure:3", "x"], "--restart on-failure:3 does not go with"),
        (["--gpus=device=0,1", "x"], "says both how many and which"),
        *(([f"--gpus={count}", "x"], "asks for no GPU") for count in ("0", "99999")),
        (["--gpus=device=a b", "x"], "is no id of a GPU"),
        (["-e", "A\nExec b", "x"], "is no name of a variable"),
        *(([option, "x"], f"{option} does not go with --export quadlet") for option in ("--sound", "--ssh-agent")),
        (["sha256:" + "b" * 64], "is an id of docker's"),
        *((["x", "find", word], f"the word '{word}' does not go with") for word in ("", ";")),
        (["x", "a\x80"], "U+0080"),
    ],
)
def test_a_unit_that_is_refused(line: list[str], says: str) -> None:
    with pytest.raises(RosmlError) as caught:
        unit(*line, id="b" * 64)
    assert says in caught.value.message and caught.value.remedy and caught.value.exit_code == 2


@pytest.mark.skipif(not GENERATOR, reason="no podman with a generator of units is here")
def test_podmans_own_generator_takes_it(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "out").mkdir()
    line = ["--mws", "-v./a b:/b", "--gpus=2", "-eA=%h $X\n", "--ulimit=rtprio=99", "--cap-add=SYS_NICE", "x", "a b"]
    (tmp_path / "in/robot.container").write_text(unit(*line))
    environment = {**os.environ, "QUADLET_UNIT_DIRS": str(tmp_path / "in")}
    done = subprocess.run([str(GENERATOR), "-user", "-no-kmsg-log", str(tmp_path / "out")], env=environment, check=True, capture_output=True, text=True)  # fmt: skip
    unit_text = (tmp_path / "out/robot.service").read_text()
    (started,) = [line for line in unit_text.split("\n") if line.startswith("ExecStart=")]
    for word in ("A=%%h", "$$X", "--ulimit=rtprio=99", "nvidia.com/gpu=1", "sys_nice"):
        assert word in started, (done.stderr, started)
