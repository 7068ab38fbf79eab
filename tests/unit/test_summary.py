"""The end of `make image`, word for word."""

from __future__ import annotations

import pytest

from rosml.base import units
from rosml.build.publisher import Result
from rosml.cli import summary


def test_size() -> None:
    sizes = (0, 999, 1000, 1_234_567, 999_000_000, 3_612_345_678, 2_500_000_000_000)
    assert [units.size(count) for count in sizes] == [
        *("0 B", "999 B", "1.0 kB", "1.2 MB", "999.0 MB", "3.61 GB", "2500.00 GB")
    ]


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "0.0 s"), (3.14, "3.1 s"), (59.9, "59.9 s"), (60, "1 min 0 s"), (75.2, "1 min 15 s"), (119.6, "2 min 0 s")],
)
def test_duration(seconds: float, text: str) -> None:
    assert units.duration(seconds) == text


def result() -> Result:
    return Result(
        target="a-core-torch-cu1",
        reference="127.0.0.1:5000/rosml/ros-torch:a-core-cu1",
        tags=["127.0.0.1:5000/rosml/ros-torch:a-core-cu1", "127.0.0.1:5000/rosml/ros-torch:latest"],
        digest="sha256:index",
        manifest="sha256:manifest",
        moved=["latest"],
        compressed=3_612_345_678,
        unpacked=7_000_000_000,
        uploaded=1_600,
        passed=25,
        builder="buildx build --builder b .",
        seconds={"base image": 0.5, "build and push": 80.0},
        work={"assemble payloads": 62.0},
        reused=["ROS packages", "essentials"],
        base="debian:x@sha256:base (the official image)",
    )


def test_text() -> None:
    assert (
        summary.text(result())
        == """
a-core-torch-cu1 is built, tested and published
-----------------------------------------------
FROM             127.0.0.1:5000/rosml/ros-torch:a-core-cu1
digest           sha256:index
tags             ros-torch:a-core-cu1, ros-torch:latest
tags moved       latest
base image       debian:x@sha256:base (the official image)
build on it      buildx build --builder b .
size             3.61 GB compressed, 7.00 GB unpacked
new in registry  1.6 kB
structure tests  25 passed, 0 failed
time             1 min 20 s: base image 0.5 s, build and push 1 min 20 s
builder's work   assemble payloads 1 min 2 s
reused           ROS packages, essentials"""
    )


def test_a_second_call() -> None:
    """Nothing moved, nothing worked, nothing uploaded: a registry that cleaned up meanwhile gives no negative size."""
    second = result()
    second.moved, second.work, second.reused, second.uploaded = [], {}, [], -4096
    lines = summary.text(second).splitlines()
    assert "tags moved       none: all pointed here already" in lines
    assert "new in registry  0 B" in lines
    assert not [line for line in lines if line.startswith(("builder's work", "reused"))]
