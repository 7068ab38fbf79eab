"""Labels of images and parts that say absurd things. Each join reads them by the same function: test_join.py."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from rosml.base.errors import RosmlError
from rosml.images.join import label_claims
from tests.e2e.parts import part, ros

MANY = " ".join(f"p{number}" for number in range(100_000))
PART = dict(part("graph", "cpu").labels)


def label(name: str, value: str) -> dict[str, str]:
    return {f"io.rosml.{name}": value}


@pytest.mark.parametrize(
    "labels", [ros().labels, PART, part("cuda").labels, {}, label("parts", ""), label("python", "any")]
)
def test_our_own_labels(labels: Mapping[str, str]) -> None:
    label_claims.require(labels, "x")


@pytest.mark.parametrize(
    ("labels", "reason"),
    [
        (label("parts", MANY), "it has 100,000 names, and at most 64 are read"),
        (label("parts", "common common"), "'common' is there twice"),
        (label("addons", "\x1b[31m"), r"'\x1b[31m' is no name"),
        (label("addons", "x" * 65), f"'{'x' * 64}' is no name"),
        (label("stack", "cpu\n"), r"'cpu\n' is no name"),
        (label("distribution", "jazzy\nremedy: x"), r"'jazzy\nremedy: x' is no name"),
        (PART | label("addons", "graph"), "'graph' names no parts"),
        (PART | label("addons", f"graph={MANY.replace(' ', ',')}"), "it has 100,000 names"),
        (PART | label("frameworks", "x=../y"), "'../y' is no name"),
        (PART | label("brings", "graph:graph"), "'graph:graph' names no software"),
        (PART | label("brings", "ld/x::") | label("ld/x", "1"), "'ld/x' is no name, version or value"),
        (PART | label("graph", '1"\nRUN x'), "is no name, version or value"),
        (PART | label("brings", "graph:graph:\x1b[1m"), r"'\x1b[1m' is no name, version or value"),
        (PART | label("graph.environment", 'A_B=1"x'), "'1\"x' is no name, version or value"),
        (PART | label("graph.environment", "path=x"), "'graph:graph:GRAPH' names no software"),
        (PART | label("graph.environment", " ".join(f"A_{number}=1" for number in range(99))), "more than 64 variables"),
        (PART | label("brings", "graph:: graph::"), "'graph' is there twice"),
    ],
)  # fmt: skip
def test_damaged_labels(labels: Mapping[str, str], reason: str) -> None:
    with pytest.raises(RosmlError) as caught:
        label_claims.require(labels, "ghcr.io/me/x:1")
    message = caught.value.message
    assert message.startswith("ghcr.io/me/x:1: its label io.rosml.") and reason in message
    assert len(message) < 300 and message.isprintable() and caught.value.exit_code == 2 and caught.value.remedy
