"""The image of an app for this machine's GPU and driver."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from fakes.desks import DOCKER, OURS, docker_desk
from rosml.containerize.rebase import image as rebased
from rosml.run import variants
from rosml.run.context import Context, Engine, Host, Image, Person
from rosml.run.words import split

STACKS = "cpu cu128:525 cu130:580 cu132:580"
ME = Person(1000, 1000, "me", "/home/me")


def gpu_machine(root: Path, driver: str) -> None:
    for name, content in (("dev/nvidiactl", ""), ("sys/module/nvidia/version", driver)):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(content)


def context(
    root: Path, *words: str, image: str = "a/robot:latest", stack: str = "cpu", label: str = STACKS, nvidia: bool = True
) -> Context:
    labels = {variants.LABEL: label, variants.STACK: stack}
    line = split([*words, image], {"--no-gpu"})
    return Context(line, Engine(nvidia=nvidia), ME, Image(labels=labels), Host(root))


@pytest.mark.parametrize(
    ("words", "stack", "expected"),
    [
        (["--gpus", "1"], "cpu", "a/robot:latest-cu128"),
        (["--gpus", "1"], "cu130", ""),
        ([], "cpu", ""),
        (["--no-gpu"], "cu130", "a/robot:latest-cpu"),
    ],
)
def test_a_call_for_another_machine(words: list[str], stack: str, expected: str) -> None:
    assert variants.for_another_machine(context(Path("/nowhere"), *words, stack=stack)) == expected


@pytest.mark.parametrize(
    ("driver", "stack", "expected"),
    [
        ("580.65.06", "cpu", "a/robot:latest-cu132"),
        ("470.1", "cpu", ""),
        ("470.1", "cu130", "a/robot:latest-cpu"),
        ("", "cu130", "a/robot:latest-cpu"),
        ("580.65.06", "cu132", ""),
    ],
)
def test_the_newest_cuda_that_the_driver_runs(tmp_path: Path, driver: str, stack: str, expected: str) -> None:
    if driver:
        gpu_machine(tmp_path, driver)
    assert variants.for_this_machine(context(tmp_path, stack=stack)) == expected


@pytest.mark.parametrize(
    ("words", "facts", "expected"),
    [
        *(([], {"image": name}, f"{name}:latest-cu132") for name in ("robot", "localhost:5000/robot")),
        *(([], {"image": f"a/robot:v1-{end}"}, "") for end in ("cu128", "cpu", "20261127", "20261127.2")),
        *(([], {"image": f"{name}@sha256:{'1' * 64}"}, "") for name in ("a/robot", "a/robot:v1")),
        *(([], {"label": label}, "") for label in ("", "cpu ../x:580", "cpu cu130:580:1", "cu130:580", "cpu CU:5")),
        ([], {"label": " ".join(["cpu", *(f"cu{n}:1" for n in range(20))])}, ""),
        ([], {"nvidia": False, "stack": "cu130"}, "a/robot:latest-cpu"),
        (["--no-gpu"], {"stack": "cu130"}, "a/robot:latest-cpu"),
        (["--gpus", "all"], {"nvidia": False}, "a/robot:latest-cu132"),
    ],
)
def test_images_on_a_machine_with_a_gpu(tmp_path: Path, words: list[str], facts: Any, expected: str) -> None:
    """Full names, odd labels and engines that hand in no GPU."""
    gpu_machine(tmp_path, "580.1")
    assert variants.for_this_machine(context(tmp_path, *words, **facts)) == expected


def test_the_label_is_that_of_rebase() -> None:
    assert variants.LABEL == rebased.VARIANTS


def test_the_variant_is_pulled_and_started(tmp_path: Path) -> None:
    desk = docker_desk(tmp_path)
    gpu_machine(desk.root, "580.1")
    labels = {variants.LABEL: "cpu cu130:580", variants.STACK: "cpu"}
    configs = {"ours:latest": {"Labels": labels}, "ours:latest-cu130": {"Labels": {**labels, variants.STACK: "cu130"}}}
    facts: dict[str, Any] = {"info": {**DOCKER, "Runtimes": {"nvidia": {}}}, "configs": configs}
    desk.engine(images={"ours:latest": OURS}, registry={"ours:latest-cu130": OURS}, **facts)
    done = desk.call("ours:latest")
    assert done.returncode == 0 and "ours:latest-cu130 is the one for this machine" in done.stderr
    assert desk.called("pull") and "ours:latest-cu130" in desk.ran

    desk.engine(images={}, registry={"ours:latest": OURS, "ours:latest-cu130": OURS}, **facts)
    assert desk.call("ours:latest").returncode == 0 and "ours:latest-cu130" in desk.calls[-1]
    assert "ours:latest-cu130" in desk.call("--export", "compose", "ours:latest").stdout
