"""Locks by the policy: what a scan will refuse is known when it is locked, and so is that nobody knows."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from fakes.scanning import NOW, World, advisory, rules
from rosml.cli.images import locks as script
from rosml.images.image_set.model import ImageSet
from rosml.images.scan import locked
from rosml.images.scan.locked import Refused
from rosml.images.scan.trivy import ScannerFailed

TORCH = "locks/cu1/amd64/3.12/torch.txt"
PIN = f"torch==2.10.0+cu128 \\\n    --hash=sha256:{'e' * 64}\nnumpy==1.26.4 \\\n    --hash=sha256:{'f' * 64}\n"


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path, advisories={"torch": [advisory("CVE-2026-1", "HIGH", "3.0")]})


def refused(world: World, small: ImageSet, ignore: str = "") -> list[Refused]:
    return locked.refused(small, {TORCH: PIN}, rules(ignore), world.trivy(), NOW)


def test_what_a_scan_will_refuse(world: World, small: ImageSet) -> None:
    """Each version once, with its locks and the images; numpy, of which the database knows nothing, is fine."""
    (package,) = refused(world, small)
    assert package.images and set(package.images) == {image.target for image in small.images if TORCH in image.locks}
    facts = (package.package, package.version, package.id, package.fixed, package.locks)
    assert facts == ("torch", "2.10.0+cu128", "CVE-2026-1", "3.0", (TORCH,))
    assert str(package).startswith("torch 2.10.0+cu128: CVE-2026-1 (high, fixed in 3.0) stops ")
    assert len(world.calls("sbom")) == 1, "a lock is scanned once for all of its images"
    row = f"| torch | 2.10.0+cu128 | CVE-2026-1 | high | 3.0 | {len(package.images)} |"
    assert row in script.refused_table([package], "")
    content = json.loads(script.to_json(script.Changes(refused=[package])))
    assert content["refused"][0]["locks"] == [TORCH] and content["refused_unknown"] == ""


def test_an_entry_for_some_images_leaves_the_others(world: World, small: ImageSet) -> None:
    first, *others = refused(world, small)[0].images
    entry = "- {{id: CVE-2026-1, package: torch, {}reason: not reachable, expires: 2027-01-31}}\n"
    (package,) = refused(world, small, entry.format(f"targets: '{first}', "))
    assert package.images == (*others,)
    assert refused(world, small, entry.format("")) == []


@pytest.mark.parametrize("fail", [{"sbom": "crash"}, {"fetch": "crash"}, {"missed": 1}])
def test_a_scanner_that_fails_says_nothing_of_locks(world: World, small: ImageSet, fail: dict[str, Any]) -> None:
    world.fail = fail
    with pytest.raises(ScannerFailed):
        refused(world, small)


def test_the_command_without_a_scanner(tmp_path: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(script, "ROOT", tmp_path)
    stopped, unknown = script.judged(small, {TORCH: PIN})
    assert stopped == [] and "the scanner is not installed; run 'rosml setup scanner'" in unknown
    assert script.refused_table([], unknown).startswith("\nCannot tell which locked")
