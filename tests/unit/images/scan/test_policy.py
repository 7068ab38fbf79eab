"""scan.yaml: what it may say, and what is said of entries that are wrong, over or useless."""

from __future__ import annotations

from datetime import date
from pathlib import Path

import pytest

from fakes.scanning import POLICY, rules
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.images.image_set import load
from rosml.images.matrix import source
from rosml.images.matrix.source import parse
from rosml.images.scan import policy

ROOT = Path(__file__).resolve().parents[3]

ENTRY = "- {id: CVE-2026-1, reason: not reachable, expires: 2027-01-31}\n"


def test_the_projects_policy() -> None:
    """It stops what can be mended, and its database is young."""
    found = policy.load(ROOT / "scan.yaml").policy
    assert found.fail == ("critical", "high")
    assert found.fixable_only
    assert found.database.max_age_hours <= 48
    assert len(found.database.repositories) > 1


def test_the_projects_policy_lets_old_pythons_have_images() -> None:
    """What no newer package mends for Python 3.8, or of keras for 3.10, is ignored there, and only there."""
    images = load.image_set(source.read(ROOT / "matrix.yaml"))
    systems = images.matrix.operating_systems
    old = {image.target for image in images.images if systems[image.os].python == "3.8"}
    entries = policy.load(ROOT / "scan.yaml").policy.ignore
    reached = {(target, entry.package) for target in images.by_target for entry in entries if entry.is_for(target)}
    assert {target for target, _ in reached} & old
    elsewhere = {(images.by_target[target].python, package) for target, package in reached if target not in old}
    assert elsewhere == {("3.10", "keras")}
    torch = {image.target for image in images.images if image.framework == "torch"} & old
    for target in torch:
        assert any(entry.covers(target, "CVE-2025-32434", "torch") for entry in entries), target
    assert not policy.load(ROOT / "scan.yaml").for_nobody(images.by_target), "an entry whose pattern fits no image"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("version: 1", "version: 2", "scan.yaml:1:1: version: expected 1, found the number 2"),
        ("fixable_only", "fixable_onyl", "scan.yaml:3:1: fixable_onyl: unknown key 'fixable_onyl'; did you mean"),
        ("fixable_only: true", "fixable_only: yes", "scan.yaml:3:1: fixable_only: YAML reads yes as true or false"),
        (
            "high]",
            "hihg]",
            "scan.yaml:2:18: fail[1]: expected critical, high, medium, low or unknown, found 'hihg'",
        ),
        ("high]", "critical]", "scan.yaml:2:18: fail[1]: 'critical' is there twice; keep one"),
        ("[critical, high]", "[]", "scan.yaml:2:1: fail: nothing is there; add at least one entry, such as [a, b]"),
        ("48}", "0}", "scan.yaml:4:46: database.max_age_hours: expected at least 1, found the number 0"),
        (
            "48}",
            "'48'}",
            "scan.yaml:4:46: database.max_age_hours: expected a whole number, found '48'",
        ),
        (
            "example.org/db:2",
            "db",
            "database.repositories[0]: expected a repository with its registry, such as ghcr.io",
        ),
    ],
)
def test_a_mistake_is_told_with_its_line(old: str, new: str, says: str) -> None:
    assert POLICY.count(old) == 1
    with pytest.raises(InputError) as caught:
        policy.parsed(parse(POLICY.replace(old, new).encode(), "scan.yaml"))
    assert says in caught.value.message
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("entry", "says"),
    [
        (
            ENTRY.replace("reason: not reachable, ", ""),
            "scan.yaml:6:3: ignore[0]: 'reason' is missing; add 'reason: …'",
        ),
        (ENTRY.replace(", expires: 2027-01-31", ""), "scan.yaml:6:3: ignore[0]: 'expires' is missing"),
        (ENTRY.replace("not reachable", "none"), "expected a reason of more than one word"),
        (ENTRY.replace("2027-01-31", "2027-02-31"), "scan.yaml:6:43: ignore[0].expires: 2027-02-31 is not a day"),
        (ENTRY.replace("2027-01-31", "never"), "ignore[0].expires: expected a day, such as 2028-06-30, without quotes"),
        (ENTRY.replace("CVE-2026-1", "cve-2026-1"), "ignore[0].id: expected the name of an advisory, such as CVE-"),
        (
            ENTRY.replace("reason", "target: x, reason"),
            "ignore[0].target: unknown key 'target'; did you mean 'targets'?",
        ),
    ],
)
def test_a_wrong_entry_is_told_with_its_line(entry: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        rules(entry)
    assert says in caught.value.message


def test_every_mistake_at_once() -> None:
    with pytest.raises(InputError) as caught:
        rules(ENTRY.replace("not reachable", "none").replace("2027-01-31", "never"), version="3")
    assert len(caught.value.problems) == 3


def test_no_file(tmp_path: Path) -> None:
    with pytest.raises(RosmlError) as caught:
        policy.load(tmp_path / "scan.yaml")
    assert "no such file" in caught.value.message
    assert caught.value.remedy == "name the file with --policy"
    assert caught.value.exit_code == 2


def test_an_entry_holds_on_its_last_day() -> None:
    found = rules(ENTRY)
    assert not found.expired(date(2027, 1, 31))
    problem = found.expired(date(2027, 2, 1))[0]
    assert problem.message("scan.yaml") == (
        "scan.yaml:6:3: ignore[0]: CVE-2026-1 was ignored until 2027-01-31; look at it again: "
        "give it a new date, or remove it"
    )


def test_what_an_entry_covers() -> None:
    entry = rules(ENTRY.replace("reason", 'package: libssl3, targets: "jazzy-*-cu12?", reason')).policy.ignore[0]
    assert entry.covers("jazzy-base-torch-cu128", "CVE-2026-1", "libssl3")
    assert not entry.covers("kilted-base-torch-cu128", "CVE-2026-1", "libssl3")
    assert not entry.covers("jazzy-base-torch-cu128", "CVE-2026-2", "libssl3")
    assert not entry.covers("jazzy-base-torch-cu128", "CVE-2026-1", "openssl")
    assert rules(ENTRY).policy.ignore[0].covers("any", "CVE-2026-1", "any")
