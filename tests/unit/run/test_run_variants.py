"""The image of an app for this machine's GPU and driver."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from fakes.desks import DOCKER, OURS, Desk
from rosml.containerize.rebase import image as rebased
from rosml.run import variants
from rosml.run.context import Context, Engine, Host, Image, Person
from rosml.run.words import split

STACKS = "cpu cu128:525 cu130:580 cu132:580"


def chosen(
    root: Path,
    *words: str,
    driver: str = "",
    label: str = STACKS,
    own: str = "cpu",
    image: str = "a/robot:latest",
    nvidia: bool = True,
) -> str:
    for name, content in (("dev/nvidiactl", ""), ("sys/module/nvidia/version", driver)) if driver else ():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(content)
    line = split([*words, image], {"--no-gpu"})
    said = Image(labels={variants.LABEL: label, variants.STACK: own})
    return variants.for_this_machine(
        Context(line, Engine(nvidia=nvidia), Person(1000, 1000, "me", "/home/me"), said, Host(root))
    )


@pytest.mark.parametrize(
    ("words", "own", "found"),
    [
        (["--gpus", "1"], "cpu", "a/robot:latest-cu128"),
        (["--device", "nvidia.com/gpu=all"], "cpu", "a/robot:latest-cu128"),
        (["--gpus", "1"], "cu130", ""),
        ([], "cpu", ""),
        ([], "cu130", ""),
        (["--no-gpu"], "cu130", "a/robot:latest-cpu"),
    ],
)
def test_a_file_for_another_machine_has_the_image_that_the_call_asks_for(
    words: list[str], own: str, found: str
) -> None:
    """Whatever GPU this desk has."""
    said = Image(labels={variants.LABEL: STACKS, variants.STACK: own})
    line = split([*words, "a/robot:latest"], {"--no-gpu"})
    context = Context(line, Engine(), Person(1000, 1000, "me", "/home/me"), said, Host(Path("/nowhere")))
    assert variants.for_another_machine(context) == found


@pytest.mark.parametrize(
    ("driver", "own", "found"),
    [
        ("580.65.06", "cpu", "a/robot:latest-cu132"),
        ("535.1", "cpu", "a/robot:latest-cu128"),
        ("470.1", "cpu", ""),
        ("470.1", "cu130", "a/robot:latest-cpu"),
        ("", "cu130", "a/robot:latest-cpu"),
        ("", "cpu", ""),
        ("580.65.06", "cu132", ""),
    ],
)
def test_the_newest_cuda_that_the_driver_runs(tmp_path: Path, driver: str, own: str, found: str) -> None:
    assert chosen(tmp_path, driver=driver, own=own) == found


@pytest.mark.parametrize(
    ("image", "found"),
    [
        ("robot", "robot:latest-cu132"),
        ("localhost:5000/robot", "localhost:5000/robot:latest-cu132"),
        ("a/robot:v1", "a/robot:v1-cu132"),
        ("a/robot:v1-cu128", ""),
        ("a/robot:v1-cpu", ""),
        ("a/robot:v1-20261127", ""),
        ("a/robot:v1-20261127.2", ""),
        (f"a/robot@sha256:{'1' * 64}", ""),
        (f"a/robot:v1@sha256:{'1' * 64}", ""),
    ],
)
def test_names(tmp_path: Path, image: str, found: str) -> None:
    assert chosen(tmp_path, driver="580.1", image=image) == found


@pytest.mark.parametrize(
    "label",
    [
        "",
        "cpu ../x:580",
        "cpu cu130:580:1",
        "cu130:580",
        " ".join(["cpu", *(f"cu{n}:1" for n in range(20))]),
        "cpu CU:5",
    ],
)
def test_a_label_that_says_something_else(tmp_path: Path, label: str) -> None:
    assert chosen(tmp_path, driver="580.1", label=label) == ""


def test_a_machine_that_hands_in_no_gpu(tmp_path: Path) -> None:
    assert chosen(tmp_path, driver="580.1", nvidia=False, own="cu130") == "a/robot:latest-cpu"
    assert chosen(tmp_path, "--no-gpu", driver="580.1", own="cu130") == "a/robot:latest-cpu"
    assert chosen(tmp_path, "--gpus", "all", driver="580.1", nvidia=False) == "a/robot:latest-cu132"


def test_the_label_is_that_of_rebase() -> None:
    assert variants.LABEL == rebased.VARIANTS


def test_it_is_pulled_and_started(tmp_path: Path) -> None:
    """The named image is there, the one for the machine is not."""
    desk = Desk(tmp_path)
    desk.trust(ours=True)
    for name, content in (("dev/nvidiactl", ""), ("sys/module/nvidia/version", "580.1")):
        (desk.root / name).parent.mkdir(parents=True)
        (desk.root / name).write_text(content)
    labels = {variants.LABEL: "cpu cu130:580", variants.STACK: "cpu"}
    told = {"ours:latest": {"Labels": labels}, "ours:latest-cu130": {"Labels": {**labels, variants.STACK: "cu130"}}}
    facts: dict[str, Any] = {"info": {**DOCKER, "Runtimes": {"nvidia": {}}}, "configs": told}
    desk.engine(images={"ours:latest": OURS}, registry={"ours:latest-cu130": OURS}, **facts)
    done = desk.call("ours:latest")
    assert done.returncode == 0, done.stderr
    assert "ours:latest-cu130 is the one for this machine" in done.stderr
    assert desk.called("pull") and "ours:latest-cu130" in desk.ran

    desk.engine(images={}, registry={"ours:latest": OURS, "ours:latest-cu130": OURS}, **facts)
    done = desk.call("ours:latest")
    assert done.returncode == 0 and "ours:latest-cu130" in desk.calls[-1], done.stderr
    shown = desk.call("--export", "compose", "ours:latest")
    assert shown.returncode == 0 and "ours:latest-cu130" in shown.stdout, shown.stderr
