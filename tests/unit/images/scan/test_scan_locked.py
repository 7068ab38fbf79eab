"""Locks held against the policy: what a scan will refuse is known when it is locked, and so is that nobody knows."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from fakes.scanning import NOW, World, advisory, rules
from rosml.cli.images import locks as script
from rosml.images.image_set.model import ImageSet
from rosml.images.scan import locked
from rosml.images.scan.trivy import ScannerFailed

TORCH = "locks/cu1/amd64/3.12/torch.txt"
PIN = "torch==2.10.0+cu128 \\\n    --hash=sha256:{}\nnumpy==1.26.4 \\\n    --hash=sha256:{}\n".format(
    "e" * 64, "f" * 64
)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path, advisories={"torch": [advisory("CVE-2026-1", "HIGH", "3.0")]})


def test_what_a_scan_will_refuse(world: World, small: ImageSet) -> None:
    """Each version once, with its locks and the images; numpy, of which the database knows nothing, is fine."""
    (found,) = locked.refused(small, {TORCH: PIN}, rules(), world.trivy(), NOW)
    assert (found.package, found.version, found.id, found.fixed) == ("torch", "2.10.0+cu128", "CVE-2026-1", "3.0")
    assert found.locks == (TORCH,)
    assert found.images and set(found.images) == {image.target for image in small.images if TORCH in image.locks}
    assert str(found).startswith("torch 2.10.0+cu128: CVE-2026-1 (high, fixed in 3.0) stops ")
    assert len(world.calls("sbom")) == 1, "a lock is scanned once for all of its images"


def test_what_the_policy_allows_is_not_refused(world: World, small: ImageSet) -> None:
    """An entry that is for some of the images leaves the others."""
    all_of = locked.refused(small, {TORCH: PIN}, rules(), world.trivy(), NOW)[0].images
    entry = (
        f"- {{id: CVE-2026-1, package: torch, targets: '{all_of[0]}', reason: not reachable, expires: 2027-01-31}}\n"
    )
    (found,) = locked.refused(small, {TORCH: PIN}, rules(entry), world.trivy(), NOW)
    assert found.images == all_of[1:]
    everywhere = entry.replace(f"targets: '{all_of[0]}', ", "")
    assert locked.refused(small, {TORCH: PIN}, rules(everywhere), world.trivy(), NOW) == []


@pytest.mark.parametrize("fail", [{"sbom": "crash"}, {"fetch": "crash"}, {"missed": 1}])
def test_a_scanner_that_fails_says_nothing_of_locks(world: World, small: ImageSet, fail: dict[str, Any]) -> None:
    world.fail = fail
    with pytest.raises(ScannerFailed):
        locked.refused(small, {TORCH: PIN}, rules(), world.trivy(), NOW)


def test_the_command_says_that_nobody_knows(tmp_path: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(script, "ROOT", tmp_path)
    stopped, unknown = script.judged(small, {TORCH: PIN})
    assert stopped == [] and "the scanner is not installed; run 'rosml setup scanner'" in unknown
    assert script.refused_table([], unknown).startswith("\nCannot tell which locked")


def test_the_command_says_what_the_scan_will_stop(world: World, small: ImageSet) -> None:
    found = locked.refused(small, {TORCH: PIN}, rules(), world.trivy(), NOW)
    table = script.refused_table(found, "")
    assert f"| torch | 2.10.0+cu128 | CVE-2026-1 | high | 3.0 | {len(found[0].images)} |" in table
    said = json.loads(script.to_json(stopped=found))
    assert said["refused"][0]["locks"] == [TORCH] and said["refused_unknown"] == ""
