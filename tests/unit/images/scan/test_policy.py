"""scan.yaml: what it may say, which vulnerabilities its entries ignore, and which entries are wrong, over or useless."""

from __future__ import annotations

from collections.abc import Callable
from datetime import date
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.scanning import NOW, POLICY, World, advisory, digest, image, rules
from rosml.base.problems import InputError, counted
from rosml.images.image_set import load
from rosml.images.matrix import source
from rosml.images.scan import judge, policy
from rosml.images.scan.judge import Outcome

IGNORE = "- {id: CVE-2026-1, reason: not reachable, expires: 2027-01-31}\n"
USELESS = IGNORE.replace("CVE-2026-1", "CVE-2026-9")
EXPIRED = IGNORE.replace("2027-01-31", "2026-11-21")


def test_the_projects_policy() -> None:
    """It stops what can be fixed, and its database is young."""
    project = policy.load(ROOT / "scan.yaml").policy
    assert project.fail == ("critical", "high") and project.fixable_only
    assert project.database.max_age_hours <= 48 and len(project.database.repositories) > 1


def test_the_projects_policy_lets_old_pythons_have_images() -> None:
    """What no newer package fixes for Python 3.8, or of keras for 3.10, is ignored there, and only there."""
    images = load.image_set(source.read(ROOT / "matrix.yaml"))
    systems = images.matrix.operating_systems
    old_pythons = {it.target for it in images.images if systems[it.os].python == "3.8"}
    project = policy.load(ROOT / "scan.yaml")
    entries = project.policy.ignore
    reached = {(target, entry.package) for target in images.by_target for entry in entries if entry.is_for(target)}
    assert {target for target, _ in reached} & old_pythons
    elsewhere = {(images.by_target[target].python, package) for target, package in reached if target not in old_pythons}
    assert elsewhere == {("3.10", "keras")}
    for target in {it.target for it in images.images if it.framework == "torch"} & old_pythons:
        assert any(entry.covers(target, "CVE-2025-32434", "torch") for entry in entries), target
    assert not project.for_nobody(images.by_target), "an entry whose pattern fits no image"


@pytest.mark.parametrize(
    ("before", "after", "problem"),
    [
        ("high]", "hihg]", "scan.yaml:2:18: fail[1]: expected critical, high, medium, low or unknown"),
        ("[critical, high]", "[]", "scan.yaml:2:1: fail: nothing is there"),
        ("example.org/db:2", "db", "database.repositories[0]: expected a repository with its registry"),
    ],
)
def test_a_mistake_is_named_with_its_line(before: str, after: str, problem: str) -> None:
    assert POLICY.count(before) == 1
    with pytest.raises(InputError) as caught:
        policy.parsed(source.parse(POLICY.replace(before, after).encode(), "scan.yaml"))
    assert problem in caught.value.message and caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("before", "after", "problem"),
    [
        (", expires: 2027-01-31", "", "scan.yaml:6:3: ignore[0]: 'expires' is missing"),
        ("not reachable", "none", "expected a reason of more than one word"),
        ("CVE-2026-1", "cve-2026-1", "ignore[0].id: expected the name of an advisory"),
        ("reason", "status: harmless, reason", "ignore[0].status: expected affected, not_affected, fixed or under_"),
        ("reason", "status: not_affected, reason", "'status: not_affected' and 'justification' belong together"),
        ("reason", "justification: component_not_present, reason", "'justification' belong together"),
        ("reason", "status: fixed, action: wait for it, reason", "'action' is for images that are affected"),
    ],
)
def test_a_wrong_entry_is_named_with_its_line(before: str, after: str, problem: str) -> None:
    with pytest.raises(InputError) as caught:
        rules(IGNORE.replace(before, after))
    assert problem in caught.value.message


def test_what_an_entry_covers() -> None:
    entry = rules(IGNORE.replace("reason", 'package: libssl3, targets: "jazzy-*-cu12?", reason')).policy.ignore[0]
    assert entry.covers("jazzy-base-torch-cu128", "CVE-2026-1", "libssl3")
    for target, advisory_id, package in (
        ("kilted-base-torch-cu128", "CVE-2026-1", "libssl3"),
        ("jazzy-base-torch-cu128", "CVE-2026-2", "libssl3"),
        ("jazzy-base-torch-cu128", "CVE-2026-1", "openssl"),
    ):
        assert not entry.covers(target, advisory_id, package)
    assert rules(IGNORE).policy.ignore[0].covers("any", "CVE-2026-1", "any")


# ---- Entries in a scan ----------------------------------------------------------------------------------------------


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path, advisories={"libc6": [advisory("CVE-2026-1")]})


def base(world: World) -> judge.Image:
    """An image with CVE-2026-1."""
    return image("alpha-base", world.part("alpha-base", "bash", "libc6", ros=True))


def harmless(world: World, target: str = "c") -> judge.Image:
    return image(target, world.part(target, "bash", ros=True))


def test_an_entry_ignores(world: World) -> None:
    scan = world.run(base(world), rules=rules(IGNORE)).images[0]
    assert (scan.outcome, scan.matched) == (Outcome.CLEAN, (0,))
    assert (scan.findings[0].ignored, scan.findings[0].until) == ("not reachable", "2027-01-31")


def test_an_expired_entry_ignores_nothing_and_fails_the_run(world: World) -> None:
    result = world.run(base(world), harmless(world), rules=rules(EXPIRED))
    assert [it.outcome for it in result.images] == [Outcome.POLICY_FAILED, Outcome.CLEAN]
    (problem,) = result.problems
    assert problem.startswith("scan.yaml:6:3: ignore[0]: CVE-2026-1 was ignored until 2026-11-21; look at it again")
    result = world.run(harmless(world), rules=rules(EXPIRED), whole=False)
    assert (result.images[0].outcome, result.outcome) == (Outcome.CLEAN, Outcome.POLICY_FAILED)


@pytest.mark.parametrize(
    ("last", "days"),
    [("2026-11-21", None), ("2026-11-22", 0), ("2026-12-22", 30), ("2026-12-23", None)],
)
def test_an_entry_that_ends_soon_is_named(world: World, last: str, days: int | None) -> None:
    """It fails nothing before its day has passed."""
    result = world.run(base(world), rules=rules(IGNORE.replace("2027-01-31", last)))
    if days is None:
        assert result.ending == ()
    else:
        place = "scan.yaml:6:3: ignore[0]: CVE-2026-1 is ignored until"
        assert result.ending == (f"{place} {last}, {counted(days, 'day')} from now; look at it again",)
        assert result.outcome is Outcome.CLEAN and result.to_json()["ending"] == [*result.ending]


def test_entries_expire_by_the_runs_date(world: World) -> None:
    scanner, part = judge.Scanner(world.ready(), world.shelf()), base(world)
    world.write()
    for day, outcome in ((date(2027, 1, 31), Outcome.CLEAN), (date(2027, 2, 1), Outcome.POLICY_FAILED)):
        assert judge.scan(part, rules(IGNORE), scanner, day).outcome is outcome


def test_an_entry_that_matches_nothing_fails_the_run(world: World) -> None:
    result = world.run(base(world), rules=rules(IGNORE + USELESS))
    assert (result.images[0].outcome, result.outcome) == (Outcome.CLEAN, Outcome.POLICY_FAILED)
    assert result.problems == ("scan.yaml:7:3: ignore[1]: CVE-2026-9 is in no image that the entry is for; remove it",)


def test_an_entry_for_other_images_matches_nothing_here(world: World) -> None:
    policy = rules(IGNORE.replace("reason", 'targets: "omega-*", reason'))
    result = world.run(base(world), rules=policy, targets=["alpha-base", "omega-base"])
    assert result.images[0].outcome is Outcome.POLICY_FAILED
    assert result.problems == (), "nothing is known about omega-base"


@pytest.mark.parametrize(
    ("fields", "problem", "fails_elsewhere"),
    [
        ('targets: "omega-*"', "", False),
        ('expires: 2026-11-01, targets: "omega-*"', "", True),
        ("", "", False),
        ('targets: "alpha-*"', "ignore[0]: CVE-2026-9 is in no image that the entry is for", False),
        ('expires: 2026-11-01, targets: "*"', "ignore[0]: CVE-2026-9 was ignored until 2026-11-01", True),
        ('targets: "omga-*"', "ignore[0]: 'omga-*' matches no image of the matrix", True),
    ],
)
def test_entries_about_images_that_a_set_leaves_out_are_silent(
    world: World, fields: str, problem: str, fails_elsewhere: bool
) -> None:
    """They are in the policy of the matrix that it extends, whose own run names those of no use."""
    text = USELESS.replace(", expires: 2027-01-31", "") if "expires" in fields else USELESS
    policy = rules(text.replace("reason", f"{fields}, reason") if fields else text)
    bash = harmless(world, "alpha-base")
    result = world.run(bash, rules=policy, targets=["alpha-base"], left_out=["omega-base"])
    assert [problem in text for text in result.problems] == [True] * bool(problem)
    whole = world.run(bash, rules=policy, targets=["alpha-base", "omega-base"], whole=False)
    assert bool(whole.problems) == fails_elsewhere


def _of_some_images(world: World) -> judge.Run:
    return world.run(base(world), rules=rules(USELESS), whole=False)


def _of_an_unknown_image(world: World) -> judge.Run:
    world.fail = {digest("broken"): "crash"}
    return world.run(harmless(world, "broken"), rules=rules(USELESS))


@pytest.mark.parametrize("case", [_of_some_images, _of_an_unknown_image])
def test_an_entry_is_not_called_useless_too_soon(world: World, case: Callable[[World], judge.Run]) -> None:
    assert case(world).problems == ()


def test_shards_are_summed_up(world: World) -> None:
    """An entry that matches in one shard is not useless because of another."""
    policy = rules(IGNORE + USELESS)
    shards = [world.run(part, rules=policy, whole=False) for part in (base(world), harmless(world))]
    scans = [scan for shard in shards for scan in shard.images]
    whole = judge.summarise(scans, policy, NOW.date(), whole=True)
    assert [problem.split(": ")[2][:10] for problem in whole.problems] == ["CVE-2026-9"]
