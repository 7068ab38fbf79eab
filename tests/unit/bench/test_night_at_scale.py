"""`python -m bench scale`: the simulation of a night. Its facts stand where they say, and the requests are counted again here."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, cast

import pytest

from bench import cli, results, scale
from bench.results import Result
from bench.scale_facts import FACTS, STEPS, Step, fact
from bench.scale_night import LOCKS, MOVED, USUAL, Bucket, Disk, Load, Night, scaled
from fakes.http_registry import local_registry
from fakes.memory_registry import DAY, NEXT, Publisher, publisher
from fakes.rebasing import BASE_FACTS, App, changed, moving, package
from fakes.stubs import services
from rosml import ROOT
from rosml.base.clock import now
from rosml.cli import command
from rosml.containerize.rebase.fleet import Entry, Fleet
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.images.image_set.model import ImageSet
from rosml.images.publish.steps import STEPS as REAL
from rosml.registry.client import Registries, Registry

SMALL = Load(images=200, stacks=7, pulls=300, apps=200, machines=4)


def numbers(night: Night) -> tuple[Any, ...]:
    """What a night comes to."""
    disks = [place.peak for place in night.disks]
    return night.new_bytes, night.egress, night.fetched, night.minutes, night.refused, night.shards, night.phases, disks


@pytest.mark.parametrize("name", FACTS)
def test_facts_stand_where_they_say(name: str) -> None:
    source, words = FACTS[name].source, FACTS[name].words
    if source.startswith("https://") or source == "assumed":
        assert words
    else:
        assert words in " ".join((ROOT / source).read_text().split())


def counted(requests: list[str], items: int, sent: int = 0) -> Step:
    """Requests of each item, rounded."""
    writes = sum(request.startswith(("PUT", "POST", "PATCH", "DELETE")) for request in requests)
    return Step(round((len(requests) - writes) / items), round(writes / items), sent // items)


def close(step: Step, again: Step) -> bool:
    """Whether a count is within a tenth of a fact, or one request, and the bytes within a fifth."""
    pairs = ((step.reads, again.reads), (step.writes, again.writes))
    return all(abs(a - b) <= max(1, a / 10) for a, b in pairs) and abs(step.sent - again.sent) <= step.sent / 5


def test_requests_of_a_night(image_set: ImageSet, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the second night, in which packages have changed, in a registry without the referrers API."""
    here = publisher(project, services(project), monkeypatch)
    steps: dict[str, Step] = {}
    with local_registry() as server:
        for date, state in ((DAY, "1"), (NEXT, "2")):
            here.packages = dict.fromkeys(image_set.matrix.distributions, state)
            for step, function in REAL.items():
                with Registry(server.address) as client:
                    server.requests.clear()
                    run = Publisher(here.services, cast(Any, client), here.packages).run(
                        image_set, date, packages=state
                    )
                    survey = counted(server.requests, len(run.state.entries) or 1)
                    server.requests.clear()
                    function(run)
                    items = sum(outcome.state == "done" for outcome in run.outcomes)
                    steps[step] = counted(server.requests, items, run.uploaded)
    steps["survey"] = survey
    assert {name: again for name, again in steps.items() if not close(STEPS[name], again)} == {}


def test_requests_of_an_app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that more apps of the same base image take."""
    few, many = 5, 25
    with moving(tmp_path, monkeypatch) as place:

        def requests(count: int, version: str) -> list[str]:
            base = place.base()
            apps = [App(base, name=f"app-{count}-{number}").put(place.registry, "latest") for number in range(count)]
            place.base(base_facts=changed(BASE_FACTS, packages=[package("python3", version)]), files=("usr/bin/new",))
            place.server.requests.clear()
            with Registries() as registries, Rebaser(place.services, registries, place.messages.append) as rebaser:
                moved = Fleet(rebaser, now(), lambda *_: None).run([Entry(app=app) for app in apps])
            assert {outcome.state for outcome in moved} == {"moved"}
            return list(place.server.requests)

        one, other = (counted(requests(count, f"3.11.2-{count}"), 1) for count in (few, many))
    each = Step(*(round((getattr(other, kind) - getattr(one, kind)) / (many - few)) for kind in ("reads", "writes")))
    assert close(STEPS["rebase"], each), each


def test_a_seed_decides() -> None:
    one, again, other = (numbers(scale.simulate(replace(SMALL, seed=seed), MOVED)) for seed in (1, 1, 2))
    assert one == again != other


def test_twice_the_images_are_joined_from_the_same_parts() -> None:
    once, twice = (
        scale.simulate(replace(SMALL, images=images, pulls=0, apps=0, machines=2), LOCKS) for images in (900, 1_800)
    )
    assert 1.8 < twice.steps["join"] / once.steps["join"] < 2.1
    assert 1 <= twice.steps["part"] / once.steps["part"] < 1.02, "the smaller set may lack a part that few images have"


def test_a_part_is_built_on_one_machine() -> None:
    night = scale.simulate(replace(SMALL, pulls=0, apps=0), LOCKS)
    assert len(night.shards) == 4
    assert night.steps["part"] == sum(len(part.architectures) for part in night.image_set.parts)


def test_the_usual_way_stores_each_layer_again() -> None:
    usual, here = (scale.simulate(SMALL, way) for way in (USUAL, MOVED))
    joined = sum(len(image.architectures) for image in here.image_set.images if image.stack)
    assert usual.steps["pip"] == here.steps["join"] == joined
    ros = sum(count for (what, _), count in here.stored.items() if what == "ROS")
    manifest = 20e3 + fact("SBOM bytes")
    assert (
        here.new_bytes
        < ros + joined * manifest + SMALL.apps * (400e3 + fact("SBOM bytes")) + len(here.image_set.images) * 30e3
    )
    layers = {name: count for (what, name), count in usual.stored.items() if what == "image"}
    assert len(layers) == joined and usual.new_bytes > ros + sum(layers.values()) > ros + joined * 500e6


def test_who_has_yesterdays_image_pulls_ros_alone() -> None:
    none, every, usual = (
        scale.simulate(replace(SMALL, held=held), way) for held, way in ((0, MOVED), (1, MOVED), (1, USUAL))
    )
    assert every.egress < 0.6 * none.egress < usual.egress


def test_a_disk_that_is_too_small() -> None:
    large, small = (scale.simulate(replace(SMALL, disk_mb=size), LOCKS) for size in (72_000, 18_000))
    assert [limit.what for limit in scale.broken(small)] == ["disk of a machine"] and scale.broken(large) == []
    assert small.steps["fetch"] > large.steps["fetch"], "what the builder pruned is fetched again"


def test_a_builder_prunes_what_was_used_longest_ago() -> None:
    """After a step it keeps half of a disk, and before one it makes room."""
    place = Disk(60_000)
    for name, size in (("one", 10_000), ("two", 15_000), ("one", 10_000), ("three", 20_000)):
        missing = place.hold({name: size})
    assert (missing, [*place.held], place.peak) == (["three"], ["one", "three"], 45_000)
    place.hold({"four": 40_000})
    assert place.peak == 45_000


def test_the_registrys_limit_is_kept() -> None:
    """A minute's requests may come at once, and then as many as the limit says."""
    load = replace(SMALL, images=0, pulls=0, apps=2_000)
    night, free = (scale.simulate(replace(load, limited=limited), MOVED) for limited in (True, False))
    writes = load.apps * STEPS["rebase"].writes
    assert night.phases["apps"] >= 60 * (writes / fact("writes a minute") - 1) > 0.9 * night.phases["apps"]
    assert free.phases["apps"] < night.phases["apps"] and night.refused > 0 == free.refused
    assert night.steps["rebase"] == load.apps and night.failed == 0
    bucket = Bucket(10)
    assert [bucket.take(at, 1_000) for at in (0, 0, 5)] == [600, 0, 50]


def test_the_knob_is_one_that_helps(monkeypatch: pytest.MonkeyPatch) -> None:
    """More shards do not, if each has one distribution already."""
    load, limit = replace(SMALL, images=100, pulls=0, apps=0), scale.LIMITS[0]
    night = scale.simulate(load, MOVED)
    monkeypatch.setitem(
        FACTS, "minutes of a shard", replace(FACTS["minutes of a shard"], value=scale.longest(night) / 1.2)
    )
    growth = partial(scale.Growth, "images", "images", 100, 2)
    dealt = scale.grown(load, growth({}))
    assert (dealt.limit, dealt.knob) == (limit.what, "ROSML_SHARDS")
    monkeypatch.setitem(FACTS, "minutes of a shard", replace(FACTS["minutes of a shard"], value=1))
    alone = scale.grown(replace(load, machines=40), growth({}))
    assert (alone.fits, alone.breaks, alone.knob) == (None, 100, "")


@pytest.mark.parametrize("knob", [knob for limit in scale.LIMITS for knob, _ in limit.knobs])
def test_knobs_are_settings(knob: str) -> None:
    """The workflows and the pages name them."""
    pages = (
        ".github/workflows/nightly.yml",
        "docs/nightly.md",
        "docs/rebase.md",
        "docs/registry.md",
        "docs/publishing.md",
    )
    text = "".join((ROOT / page).read_text() for page in pages)
    assert all(word in text for word in knob.split())


def test_the_image_set_is_the_projects() -> None:
    """More stacks and distributions, each with the sizes of a real one."""
    image_set = scaled(1_100, 9)
    assert len(image_set.images) in range(1_090, 1_101) and len(image_set.matrix.stacks) == 9
    sizes = image_set.matrix.disk.parts
    assert sizes["cu128x2"] == sizes["cu128"] != sizes["cu130x2"] == sizes["cu130"]


def test_the_command_keeps_both_results(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    loads: list[Load] = []

    def measure(load: Load, text: str, _say: object) -> tuple[Result, ...]:
        loads.append(load)
        nights = [scale.simulate(SMALL, way) for way in (USUAL, MOVED, LOCKS)]
        return tuple(Result(name, text, ("a", "b", "c"), scale.table(nights)) for name in ("scale", "scale-limits"))

    monkeypatch.setattr(scale, "measure", measure)
    monkeypatch.setattr(results, "FOLDER", tmp_path)
    assert command.run(cli.main, arguments=["scale", "--disk", "36", "--held", "0.5"]) == 0
    assert loads == [Load(disk_mb=36_000, held=0.5)]
    kept: Mapping[str, Result] = results.load()
    assert kept.keys() == {"scale", "scale-limits"} and "--disk 36" in kept["scale"].command
    assert all(len(row.values) == 3 for row in kept["scale"].rows)
