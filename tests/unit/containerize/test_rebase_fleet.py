"""Many apps on newer base images, in a registry in this process; and the way back."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fakes.rebasing import BASE_FACTS, OTHER_BUILD, OWN, App, Place, changed, moving, package
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.containerize.rebase import fleet
from rosml.containerize.rebase.fleet import Entry, Fleet, Outcome
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.containerize.rebase.screen import Screen, require_advisory
from rosml.images.publish import undo
from rosml.images.records.store import Records
from rosml.images.scan.trivy import Report
from rosml.registry import place as places
from rosml.registry.client import Registries, Registry


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as found:
        yield found


DATE = "2026-11-27T03:00:00Z"


def run(
    place: Place,
    *entries: Entry,
    date: str = DATE,
    linked: list[str] | None = None,
    refuses: str = "",
    screen: Screen | None = None,
    dry_run: bool = False,
) -> dict[str, Outcome]:
    """Runs a fleet; the builder notes what it links, and refuses one app."""

    def link(found: Any, _pairs: Any) -> None:
        (linked if linked is not None else []).append(found.app)
        if refuses and refuses in found.app:
            raise RosmlError("the app does not find libgone.so", "build it again", exit_code=2)

    with Registries() as registries, Rebaser(place.services, registries, place.said.append) as rebaser:
        one = Fleet(rebaser, date, link, lambda *_: None, say=place.said.append, screen=screen)
        found = one.run(entries, dry_run)
    return {outcome.app.rpartition("/")[2]: outcome for outcome in found}


def test_a_night(place: Place) -> None:
    old = place.base()
    names = {name: App(old, name=name).put(place.registry, "latest") for name in ("arm", "camera", "odd")}
    two = App(old, name="lower").put(place.registry, "latest", index=True)
    upper = App(two, {**OWN, "files": ["x"], "packages": [], "libraries": []}, name="upper").put(
        place.registry, "latest"
    )
    before = {name: place.digest(reference) for name, reference in names.items()}
    odd = changed(OWN, packages=[package("python3-angles", "1.16", depends="python3 (<< 3.11.2-2)", files=[])])
    App(old, odd, name="odd").put(place.registry, "latest")
    before["odd"] = place.digest(names["odd"])
    place.base(
        said=changed(BASE_FACTS, packages=[package("python3", "3.11.2-5")]), files=("usr/bin/env", "bin", "usr/bin/new")
    )

    entries = [Entry(app=item) for item in (upper, two, *names.values())]
    found = run(place, *entries)
    assert {name: outcome.state for name, outcome in found.items()} == {
        "upper:latest": "moved",
        "lower:latest": "moved",
        "arm:latest": "moved",
        "camera:latest": "moved",
        "odd:latest": "refused",
    }
    assert "python3-angles needs python3 (<< 3.11.2-2)" in found["odd:latest"].reason
    assert place.digest(names["odd"]) == before["odd"]
    lower, on_it = found["lower:latest"].rebased, found["upper:latest"].rebased
    assert lower and on_it and on_it.base_digest == lower.digest, "the app on another one came after it"
    for name in ("arm", "camera"):
        moved = place.digest(names[name])
        assert moved != before[name] and place.registry.head(f"me/{name}", "latest-20261127") == moved
    assert {outcome.state for name, outcome in run(place, *entries).items() if name != "odd:latest"} == {"there"}

    records = Records(places.Place(place.registry, "me"))
    undo.undo(records, DATE)
    for name in ("arm", "camera"):
        assert place.digest(names[name]) == before[name], "and back"
        assert not place.registry.head(f"me/{name}", "latest-20261127")

    for _ in range(2):
        again = run(place, *entries[1:])
        assert {outcome.state for name, outcome in again.items() if name != "odd:latest"} == {"held"}
        assert {name: place.digest(names[name]) for name in before} == before, "no run does it again"
    place.base(
        said=changed(BASE_FACTS, packages=[package("python3", "3.11.2-5")]), files=("usr/bin/env", "bin", "fixed")
    )
    assert run(place, *entries)["camera:latest"].state == "moved", "onto another base image"


def test_libraries_that_need_a_link(place: Place) -> None:
    old = place.base()
    names = [App(old, name=name).put(place.registry, "latest") for name in ("arm", "camera")]
    before = [place.digest(name) for name in names]
    others = [item for item in BASE_FACTS["libraries"] if item["path"] != OTHER_BUILD["path"]]
    place.base(said=changed(BASE_FACTS, libraries=[*others, OTHER_BUILD]), files=("usr/bin/env", "bin", "usr/bin/new"))
    linked: list[str] = []
    found = run(place, *(Entry(app=name) for name in names), linked=linked, refuses="camera")
    assert sorted(linked) == sorted(names)
    assert [outcome.state for outcome in found.values()] == ["moved", "refused"]
    assert place.digest(names[1]) == before[1] and "libgone.so" in found["camera:latest"].reason
    assert not place.registry.head("me/camera", "latest-20261127"), "no tag of it moved"


def test_tags_by_a_pattern(place: Place) -> None:
    old = place.base()
    for tag in ("v1", "v2", "next", "v1-20261120"):
        App(old).put(place.registry, tag)
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    found = run(place, Entry(app=f"{place.server.address}/me/robot:v*"))
    assert sorted(found) == ["robot:v1", "robot:v2"], (
        "neither another name, nor a dated tag, nor a list of attached things"
    )


def test_a_pattern_without_a_match_fails_alone(place: Place) -> None:
    app, odd = App(place.base()).put(place.registry, "latest"), f"{place.server.address}/me/robot:w*"
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    found = run(place, Entry(app=odd), Entry(app=app))
    assert {name: outcome.state for name, outcome in found.items()} == {"robot:w*": "refused", "robot:latest": "moved"}
    assert "matches w*" in found["robot:w*"].reason and found["robot:w*"].remedy


def test_a_dry_run_of_many(place: Place) -> None:
    """It tells of all, also of an app on another one that would move, and changes nothing."""
    old = place.base()
    lower = App(old, name="lower").put(place.registry, "latest", index=True)
    own = {**OWN, "files": ["x"], "packages": [], "libraries": []}
    upper = App(lower, own, name="upper").put(place.registry, "latest")
    odd = changed(OWN, packages=[package("python3-angles", "1.16", depends="python3 (<< 3.11.2-2)", files=[])])
    refused = App(old, odd, name="odd").put(place.registry, "latest")
    place.base(
        said=changed(BASE_FACTS, packages=[package("python3", "3.11.2-5")]), files=("usr/bin/env", "bin", "usr/bin/new")
    )
    before = {*place.server.manifests}, {name: dict(tags) for name, tags in place.server.tags.items()}
    entries = [Entry(app=name) for name in (upper, lower, refused)]
    found = run(place, *entries, dry_run=True)
    states = {"upper:latest": "planned", "lower:latest": "planned", "odd:latest": "refused"}
    assert {name: outcome.state for name, outcome in found.items()} == states
    assert f"once {lower} has moved" in found["upper:latest"].reason and not fleet.places(found.values())
    assert ({*place.server.manifests}, {name: dict(tags) for name, tags in place.server.tags.items()}) == before
    planned, done = found["lower:latest"].rebased, run(place, *entries)["lower:latest"].rebased
    assert planned and done and planned.digest == done.digest != planned.before, "and it would be that"


def test_an_app_that_is_named_twice(place: Place) -> None:
    """Its own entry counts more than a pattern; two of the same kind have to agree."""
    old = place.base()
    for tag in ("v1", "v2"):
        App(old).put(place.registry, tag)
    new = place.base("newer")
    name = f"{place.server.address}/me/robot"
    every = Entry(app=f"{name}:v*")
    for entries in ((Entry(app=f"{name}:v1", base=new), every), (every, Entry(app=f"{name}:v1", base=new))):
        found = run(place, *entries)
        assert {name: outcome.state for name, outcome in found.items()} == {"robot:v1": "moved", "robot:v2": "there"}
        place.registry.tag("me/robot", place.digest(f"{name}:v2"), "v1")
    for other in (Entry(app=f"{name}:v*", base=new), Entry(app=f"{name}:v?", check="link")):
        with pytest.raises(RosmlError, match=r"robot:v1 is named twice, and differently") as caught:
            run(place, every, other)
        assert caught.value.exit_code == 2
    assert len(run(place, every, every)) == 2


def test_a_registry_that_has_any_tag(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    app = App(place.base()).put(place.registry, "latest")
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    head = Registry.head

    def any_tag(self: Registry, repository: str, reference: str) -> str:
        return head(self, repository, reference) or (f"sha256:{'1' * 64}" if "latest-" in reference else "")

    monkeypatch.setattr(Registry, "head", any_tag)
    found = run(place, Entry(app=app))
    assert [outcome.state for outcome in found.values()] == ["failed"]
    assert "has no free tag of the day" in found["robot:latest"].reason


def test_a_registry_that_lists_no_tags_does_not_stop_the_others(place: Place) -> None:
    app = App(place.base()).put(place.registry, "latest")
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    place.server.fault("GET", "me/closed/tags", 401, 100)
    found = run(place, Entry(app=f"{place.server.address}/me/closed:v*"), Entry(app=app))
    assert [outcome.state for outcome in found.values()] == ["failed", "moved"]


def test_an_app_that_can_never_move_is_told(place: Place) -> None:
    base = place.base()
    pinned = f"{base.rpartition(':')[0]}@{place.digest(base)}"
    app = App(pinned).put(place.registry, "latest")
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    assert run(place, Entry(app=app))["robot:latest"].state == "there"
    assert f"{pinned} never moves, and apps that name it as their base image stay" in place.said[0]


def test_an_app_that_is_gone_does_not_stop_the_others(place: Place) -> None:
    old = place.base()
    app = App(old).put(place.registry, "latest")
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    found = run(place, Entry(app=f"{place.server.address}/me/none:latest"), Entry(app=app))
    assert [outcome.state for outcome in found.values()] == ["refused", "moved"]


MEANT = "expected an app by its tag, without a digest or spaces, such as ghcr.io/me/robot:latest or ghcr.io/me/robot:v*"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "1:1: the file is empty; it needs at least 'apps: [{app: ghcr.io/me/robot:latest}]'"),
        ("- app: a/b:c", "1:1: expected keys and values, such as 'apps: …', found a list"),
        ("apps: null", "1:1: apps: expected a list, such as '- app: …', found nothing"),
        ("apps: []", "1:1: apps: nothing is there; add at least one entry, such as '- app: …'"),
        ("apps:\n- a/b:c", "2:3: apps[0]: expected keys and values, such as 'app: …', found 'a/b:c'"),
        ("apps:\n- base: a/b:c", "2:3: apps[0]: 'app' is missing; add 'app: …' (the app, or a pattern of its tags)"),
        ("apps:\n- app: a/b:c\n  bsae: x", "3:3: apps[0].bsae: unknown key 'bsae'; did you mean 'base'?"),
        ("apps:\n- app: a/b:c@sha256:12", f"2:3: apps[0].app: {MEANT}, found 'a/b:c@sha256:12'"),
        ("apps:\n- app: a b", f"2:3: apps[0].app: {MEANT}, found 'a b'"),
        ("apps:\n- app: 5", f"2:3: apps[0].app: {MEANT}, found the number 5"),
        ("apps:\n- app:", f"2:3: apps[0].app: {MEANT}, found nothing"),
        (
            "apps:\n- app: a/b:c\n  check: yes",
            "3:3: apps[0].check: expected auto, metadata, link or run, found 'yes'",
        ),
        (
            "apps:\n- app: a/b:c\n  check: run",
            "3:3: apps[0].check: check: run needs the command that it starts; add 'command: …'",
        ),
        (
            "apps:\n- app: a/b:c\n  command: ls",
            "3:3: apps[0].command: only check: run starts a command; add 'check: run', or remove the command",
        ),
        (
            "apps:\n- app: a/b:c\n  app: a/b:d",
            "3:3: apps[0].app: the key 'app' is there twice, first on line 2; keep one",
        ),
        ("apps:\n\t- app: a/b:c", "2:1: not YAML: this line is indented with a tab; indent with spaces"),
    ],
)
def test_a_wrong_file_is_refused(tmp_path: Path, content: str, message: str) -> None:
    file = tmp_path / "apps.yaml"
    file.write_text(content)
    with pytest.raises(InputError) as caught:
        fleet.read(file)
    assert caught.value.message == f"{file}:{message}" and caught.value.exit_code == 2


def report(sbom: bytes, _subject: str) -> Report:
    """The scanner's words: libssl3 3.0.1 has something, other versions have not."""
    components = json.loads(sbom)["components"]
    bad = [item for item in components if (item["name"], item["version"]) == ("libssl3", "3.0.1")]
    said = {"VulnerabilityID": "CVE-2026-1", "PkgName": "libssl3", "InstalledVersion": "3.0.1", "Severity": "HIGH"}
    return Report.model_validate(
        {"SchemaVersion": 2, "Results": [{"Vulnerabilities": [said | {"FixedVersion": "3.0.2"}] * len(bad)}]}
    )


def test_only_apps_with_a_vulnerability_move(place: Place) -> None:
    """Those whose new base image has the fix."""
    old = place.base()
    place.sbom("rosml/ros", old, ["libssl3@3.0.1"])
    own = changed(OWN, packages=[package("libssl3", "3.0.1", files=[])])
    names = {
        name: App(old, said, name=name).put(place.registry, "latest")
        for name, said in (("has", OWN), ("itself", own), ("not", OWN))
    }
    for name, packages in (("has", ["libssl3@3.0.1"]), ("itself", ["libssl3@3.0.1"]), ("not", ["libssl3@3.0.2"])):
        place.sbom(f"me/{name}", names[name], packages)
    new = place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    place.sbom("rosml/ros", new, ["libssl3@3.0.2"])
    screen = Screen("CVE-2026-1", report)
    found = run(place, *(Entry(app=name) for name in names.values()), screen=screen)
    assert {name: outcome.state for name, outcome in found.items()} == {
        "has:latest": "moved",
        "itself:latest": "refused",
        "not:latest": "unaffected",
    }
    assert "libssl3 3.0.1 (fixed in 3.0.2) has CVE-2026-1, and" in found["itself:latest"].reason
    with pytest.raises(RosmlError, match="is no name of an advisory"):
        require_advisory("the bad one")
