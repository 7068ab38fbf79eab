"""Many apps on newer base images, in a registry in this process; and the way back."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.rebasing import BASE_FACTS, FILES, OTHER_BUILD, OWN, App, Place, changed, package, place
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.containerize.rebase import fleet
from rosml.containerize.rebase.fleet import Entry, Fleet, Outcome
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.containerize.rebase.screen import Screen, require_advisory
from rosml.images.publish import undo
from rosml.images.records.store import Records
from rosml.images.scan import vex
from rosml.images.scan.trivy import Report
from rosml.registry import place as places
from rosml.registry.client import Registries, Registry

DATE = "2026-11-27T03:00:00Z"

UPPER = {**OWN, "files": ["x"], "packages": [], "libraries": []}
"""Facts of an app on another one."""

ODD = changed(OWN, packages=[package("python3-angles", "1.16", depends="python3 (<< 3.11.2-2)", files=[])])
"""Facts of an app that does not go onto `NEWER`."""

NEWER = changed(BASE_FACTS, packages=[package("python3", "3.11.2-5")])


__all__ = ["place"]


def put(place: Place, base: str, name: str, **more: Any) -> str:
    return App(base, name=name, **more).put(place.registry, "latest", index=name == "lower")


def run(
    place: Place,
    *apps: str | Entry,
    linked: list[str] | None = None,
    refuses: str = "",
    screen: Screen | None = None,
    dry_run: bool = False,
) -> dict[str, Outcome]:
    """Runs a fleet; the builder notes what it links, and refuses one app."""

    def link(rebased: Any, *_: Any) -> None:
        (linked if linked is not None else []).append(rebased.app)
        if refuses and refuses in rebased.app:
            raise RosmlError("the app does not find libgone.so", "build it again", exit_code=2)

    entries = [Entry(app=app) if isinstance(app, str) else app for app in apps]
    with Registries() as registries, Rebaser(place.services, registries, place.messages.append) as rebaser:
        night = Fleet(rebaser, DATE, link, say=place.messages.append, screen=screen)
        return {outcome.app.rpartition("/")[2]: outcome for outcome in night.run(entries, dry_run)}


def states(outcomes: dict[str, Outcome]) -> dict[str, str]:
    return {name: outcome.state for name, outcome in outcomes.items()}


def test_a_night(place: Place) -> None:
    base = place.base()
    names = {name: put(place, base, name) for name in ("arm", "camera")} | {"odd": put(place, base, "odd", facts=ODD)}
    lower = put(place, base, "lower")
    upper = put(place, lower, "upper", facts=UPPER)
    before = {name: place.digest(reference) for name, reference in names.items()}
    place.base(base_facts=NEWER, files=FILES)

    apps = [upper, lower, *names.values()]
    outcomes = run(place, *apps)
    moved = {f"{name}:latest": "moved" for name in ("upper", "lower", "arm", "camera")}
    assert states(outcomes) == moved | {"odd:latest": "refused"}
    assert "python3-angles needs python3 (<< 3.11.2-2)" in outcomes["odd:latest"].reason
    assert place.digest(names["odd"]) == before["odd"]
    below, above = outcomes["lower:latest"].rebased, outcomes["upper:latest"].rebased
    assert below and above and above.base_digest == below.digest, "the app on another one came after it"
    for name in ("arm", "camera"):
        digest = place.digest(names[name])
        assert digest != before[name] and place.registry.head(f"me/{name}", "latest-20261127") == digest
    assert {*states(run(place, *apps)).values()} == {"there", "refused"}

    records = Records(places.Place(place.registry, "me"))
    undo.undo(records, DATE, undo.find(records))
    for name in ("arm", "camera"):
        assert place.digest(names[name]) == before[name], "and back"
        assert not place.registry.head(f"me/{name}", "latest-20261127")

    for _ in range(2):
        assert {*states(run(place, *apps[1:])).values()} == {"held", "refused"}
        assert {name: place.digest(names[name]) for name in before} == before, "no run does it again"
    place.base(base_facts=NEWER, files=("usr/bin/env", "bin", "fixed"))
    assert run(place, *apps)["camera:latest"].state == "moved", "onto another base image"


def test_libraries_that_need_a_link(place: Place) -> None:
    base = place.base()
    names = [put(place, base, name) for name in ("arm", "camera")]
    before = place.digest(names[1])
    others = [item for item in BASE_FACTS["libraries"] if item["path"] != OTHER_BUILD["path"]]
    place.base(base_facts=changed(BASE_FACTS, libraries=[*others, OTHER_BUILD]), files=FILES)
    linked: list[str] = []
    outcomes = run(place, *names, linked=linked, refuses="camera")
    assert sorted(linked) == sorted(names)
    assert states(outcomes) == {"arm:latest": "moved", "camera:latest": "refused"}
    assert place.digest(names[1]) == before and "libgone.so" in outcomes["camera:latest"].reason
    assert not place.registry.head("me/camera", "latest-20261127"), "no tag of it moved"


def test_tags_by_a_pattern(place: Place) -> None:
    """Neither another name, nor a dated tag, nor a list of attached things."""
    base = place.base()
    for tag in ("v1", "v2", "next", "v1-20261120"):
        App(base).put(place.registry, tag)
    assert sorted(run(place, f"{place.server.address}/me/robot:v*")) == ["robot:v1", "robot:v2"]


def test_what_fails_fails_alone(place: Place) -> None:
    """A pattern without a match, an app that is gone, and a registry that lists no tags."""
    app = put(place, place.base(), "robot")
    place.base(files=FILES)
    place.server.fault("GET", "me/closed/tags", 401, 100)
    others = [f"{place.server.address}/me/{name}" for name in ("robot:w*", "none:latest", "closed:v*")]
    outcomes = run(place, *others, app)
    assert states(outcomes) == {
        "robot:w*": "refused",
        "none:latest": "refused",
        "closed:v*": "failed",
        "robot:latest": "moved",
    }
    assert "matches w*" in outcomes["robot:w*"].reason and outcomes["robot:w*"].remedy


def test_a_dry_run_of_many(place: Place) -> None:
    """It tells of all, also of an app on another one that would move, and changes nothing."""
    base = place.base()
    lower = put(place, base, "lower")
    apps = (put(place, lower, "upper", facts=UPPER), lower, put(place, base, "odd", facts=ODD))
    place.base(base_facts=NEWER, files=FILES)
    before = place.content()
    outcomes = run(place, *apps, dry_run=True)
    assert states(outcomes) == {"upper:latest": "planned", "lower:latest": "planned", "odd:latest": "refused"}
    assert f"once {lower} has moved" in outcomes["upper:latest"].reason and not fleet.places(outcomes.values())
    assert place.content() == before


def test_an_app_that_is_named_twice(place: Place) -> None:
    """Its own entry counts more than a pattern; two of the same kind have to agree."""
    base = place.base()
    for tag in ("v1", "v2"):
        App(base).put(place.registry, tag)
    new = place.base("newer")
    name = f"{place.server.address}/me/robot"
    every = Entry(app=f"{name}:v*")
    for entries in ((Entry(app=f"{name}:v1", base=new), every), (every, Entry(app=f"{name}:v1", base=new))):
        assert states(run(place, *entries)) == {"robot:v1": "moved", "robot:v2": "there"}
        place.registry.tag("me/robot", place.digest(f"{name}:v2"), "v1")
    for other in (Entry(app=f"{name}:v*", base=new), Entry(app=f"{name}:v?", check="link")):
        with pytest.raises(RosmlError, match=r"robot:v1 is named twice, and differently") as caught:
            run(place, every, other)
        assert caught.value.exit_code == 2
    assert len(run(place, every, every)) == 2


@pytest.mark.parametrize(
    ("has_registry", "spellings", "full"),
    [
        (True, ("me/robot", "me/robot:latest", "HERE/me/robot"), "HERE/me/robot:latest"),
        (False, ("robot", "robot:latest", "docker.io/library/robot"), "docker.io/library/robot:latest"),
        (False, ("me/robot", "docker.io/me/robot:latest"), "docker.io/me/robot:latest"),
    ],
)
def test_an_app_is_one_whichever_way_its_name_is_spelled(
    has_registry: bool, spellings: tuple[str, ...], full: str, place: Place
) -> None:
    """It would get two dated tags, and two moves in the record. Without a local registry, Docker Hub has it."""

    def unreachable(host: str) -> Registry:
        raise RosmlError(f"{host} does not answer", "try again later")

    here = place.server.address
    entries = [Entry(app=spelling.replace("HERE", here)) for spelling in spellings]
    with Rebaser(replace(place.services, registry=here if has_registry else ""), unreachable) as rebaser:
        outcomes = Fleet(rebaser, DATE, lambda *_: None).run(entries)
    assert [outcome.app for outcome in outcomes] == [full.replace("HERE", here)]


def test_a_registry_that_has_any_tag(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    app = put(place, place.base(), "robot")
    place.base(files=FILES)
    head = Registry.head

    def any_tag(self: Registry, repository: str, reference: str) -> str:
        return head(self, repository, reference) or (f"sha256:{'1' * 64}" if "latest-" in reference else "")

    monkeypatch.setattr(Registry, "head", any_tag)
    outcome = run(place, app)["robot:latest"]
    assert outcome.state == "failed" and "has no free tag of the day" in outcome.reason


def test_an_app_that_can_never_move(place: Place) -> None:
    base = place.base()
    pinned = f"{base.rpartition(':')[0]}@{place.digest(base)}"
    app = put(place, pinned, "robot")
    place.base(files=FILES)
    assert run(place, app)["robot:latest"].state == "there"
    assert f"{pinned} never moves, and apps that name it as their base image stay" in place.messages[0]


@pytest.mark.parametrize(
    ("content", "place_in_file", "says"),
    [
        ("apps: []", "1:1", "add at least one entry"),
        ("apps:\n- app: a/b:c@sha256:12", "2:3", "expected an app by its tag, without a digest"),
        ("apps:\n- app: a b", "2:3", "expected an app by its tag"),
        ("apps:\n- app: a/b:c\n  check: yes", "3:3", "expected auto, metadata, link or run"),
        ("apps:\n- app: a/b:c\n  check: run", "3:3", "add 'command: …'"),
        ("apps:\n- app: a/b:c\n  command: ls", "3:3", "only check: run starts a command"),
    ],
)
def test_a_wrong_file_is_refused(tmp_path: Path, content: str, place_in_file: str, says: str) -> None:
    file = tmp_path / "apps.yaml"
    file.write_text(content)
    with pytest.raises(InputError) as caught:
        fleet.read(file)
    assert caught.value.message.startswith(f"{file}:{place_in_file}: ") and says in caught.value.message
    assert caught.value.exit_code == 2


def report(sbom: bytes, _subject: str) -> Report:
    """The scanner's words: libssl3 3.0.1 has something, other versions have not."""
    components = json.loads(sbom)["components"]
    bad = [item for item in components if (item["name"], item["version"]) == ("libssl3", "3.0.1")]
    item = {"VulnerabilityID": "CVE-2026-1", "PkgName": "libssl3", "InstalledVersion": "3.0.1", "Severity": "HIGH"}
    results = [{"Vulnerabilities": [item | {"FixedVersion": "3.0.2"}] * len(bad)}]
    return Report.model_validate({"SchemaVersion": 2, "Results": results})


def test_only_apps_with_a_vulnerability_move(place: Place) -> None:
    """Those whose new base image has the fix."""
    base = place.base()
    place.sbom("rosml/ros", base, ["libssl3@3.0.1"])
    with_ssl = changed(OWN, packages=[package("libssl3", "3.0.1", files=[])])
    names = {
        name: put(place, base, name, facts=app_facts)
        for name, app_facts in (("below", OWN), ("itself", with_ssl), ("fixed", OWN))
    }
    for name, version in (("below", "3.0.1"), ("itself", "3.0.1"), ("fixed", "3.0.2")):
        place.sbom(f"me/{name}", names[name], [f"libssl3@{version}"])
    place.sbom("rosml/ros", place.base(files=FILES), ["libssl3@3.0.2"])
    outcomes = run(place, *names.values(), screen=Screen("CVE-2026-1", report))
    assert states(outcomes) == {"below:latest": "moved", "itself:latest": "refused", "fixed:latest": "unaffected"}
    assert "libssl3 3.0.1 (fixed in 3.0.2) has CVE-2026-1, and" in outcomes["itself:latest"].reason
    (statement,) = vex.read(place.registry, "me/below", place.digest(names["below"]))
    assert (statement.advisory, statement.status) == ("CVE-2026-1", "fixed") and "libssl3 3.0.1" in statement.reason
    with pytest.raises(RosmlError, match="is no name of an advisory"):
        require_advisory("the bad one")
