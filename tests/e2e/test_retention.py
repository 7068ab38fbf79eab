"""What stays in a registry and what goes: the real program, where it deletes and where it refuses to, as ghcr.io does.

Images are put into it without a builder; index, promote, undo and prune are the commands that people call.
"""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.builds import contents
from rosml.images.image_set import labels
from rosml.images.image_set.model import Image
from rosml.images.publish.state import Request
from rosml.images.publish.survey import survey
from rosml.images.records import store
from rosml.images.records.store import Records
from rosml.images.records.tag_moves import UNDO
from rosml.images.scan import sbom
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from tests import regctl
from tests.e2e import mini as minis
from tests.e2e import secure
from tests.e2e.calls import Run, run, succeeds
from tests.e2e.images import NATIVE
from tests.e2e.mini import Mini
from tests.e2e.parts import CREATED, Tiny
from tests.registry_calls import CALLS

ONLY = ("--only", "ros1-bookworm-core", "--only", "ros1-bookworm-base")
NIGHTS = tuple((datetime.now(UTC) - timedelta(days=number)).strftime("%Y-%m-%dT03:00:00Z") for number in (4, 3, 2))


@contextmanager
def place(project: Mini, folder: Path, deletes: bool) -> Iterator[Mini]:
    """The small project with a registry of its own."""
    with secure.plain(folder / "registry", deletes) as address:
        yield replace(project.elsewhere(), services=replace(project.services, registry=address))


def night(mini: Mini, date: str) -> None:
    """What builders and tests leave in a night: other ROS images than before, whose tests passed; then their tags move."""
    place = mini.place()
    client, book = place.client, Records(place)
    request = Request(Services.load(mini.folder), mini.image_set, place, date, tuple(ONLY[1::2]), (NATIVE,))
    state = survey(request)
    assert {item.target for item in state.items} == set(ONLY[1::2])
    for item in state.items:
        image = item.thing
        assert isinstance(image, Image)
        texts = labels.about_image(labels.ImageKind(image.distribution, image.component, "1"), [])
        texts |= {f"org.opencontainers.image.{name}": text for name, text in FACTS.items()}
        path = book.place.path(item.repository)
        digest, size = Tiny(texts, salt=date).put_manifest(client, path, f"linux/{NATIVE}")
        subject = {"mediaType": oci.IMAGE, "digest": digest, "size": size}
        described = client.attach(path, subject, sbom.MEDIA_TYPE, SBOM, sbom.MEDIA_TYPE, sbom.FORMAT)
        facts = {"inputs": state.inputs.digest(*item.key), "repository": item.repository, "size": size, "date": date}
        facts |= {"sbom": described, "described": contents.FORMAT}
        facts |= {"parts": {target: state.entries[target, NATIVE].digest for target in item.needs}, "changed": date}
        facts |= {
            "package_state": state.package_state.get(image.distribution, ""),
            "tested": state.tests.digest(item, state.tests.to_run(item)),
            "passed": 5,
        }
        before = state.entries.get(item.key) or store.Entry(*item.key)
        state.entries[item.key] = before.with_digest(digest, **facts)
        book.write(state.entries[item.key], state.inputs.of(*item.key))
    for step in ("index", "promote"):
        done = mini.publish(step, *ONLY, "--serve", NATIVE, "--date", date, "--json")
        assert done.code == 0 and '"waits"' not in done.out, done.out + done.err


SBOM = b'{"bomFormat": "CycloneDX"}'
FACTS = {
    "created": CREATED,
    "licenses": "Apache-2.0",
    "base.name": "debian:bookworm",
    "base.digest": oci.digest_of(b"a base image"),
    "source": minis.SOURCE,
}


def pull(mini: Mini, folder: Path) -> int:
    """Pulls what every tag points at, with regctl, whole; gives how many there are."""
    tags = mini.tags()
    for number, tag in enumerate(tags):
        regctl.regctl(mini.services, "image", "copy", f"{mini.registry}/{tag}", f"ocidir://{folder}/{number}:one")
    return len(tags)


def clone(mini: Mini, folder: Path) -> Path:
    """A checkout on another machine: nothing was set up, and there are neither locks nor build files."""
    for name in ("src", "scripts"):
        shutil.copytree(mini.folder / name, folder / name)
    shutil.copy(mini.folder / "matrix.yaml", folder)
    return folder


def called(folder: Path, mini: Mini, *arguments: str) -> Run:
    """`rosml publish` of a checkout, for a project's place."""
    return run(sys.executable, str(folder / "src"), "publish", *arguments, "--registry", mini.registry, cwd=folder)


def records(mini: Mini) -> list[str]:
    return [name for name in mini.client().tags(f"{mini.prefix}/records") if name.startswith(UNDO)]


def test_a_registry_that_refuses_to_delete(project: Mini, tmp_path: Path) -> None:
    """Published twice, undone, pruned: everything works but removing, which says how much stays and what to do."""
    with place(project, tmp_path, deletes=False) as mini:
        elsewhere = clone(mini, tmp_path / "clone")
        night(mini, NIGHTS[0])
        first = mini.tags()
        night(mini, NIGHTS[1])
        second = mini.tags()
        mini.check()
        assert second["ros:ros1-bookworm-core"] != first["ros:ros1-bookworm-core"]

        called(elsewhere, mini, "undo", NIGHTS[1])
        back = mini.tags()
        assert {tag: back[tag] for tag in first} == first
        mini.check()
        again = called(elsewhere, mini, "undo", NIGHTS[1], "--json")
        outcomes = {item["target"]: item for item in json.loads(again.out)["outcomes"]}
        for tag in back.keys() - first.keys():  # dated tags that the registry keeps are named, with what to do
            assert outcomes[tag]["state"] == "failed" and "delete with its own tools" in outcomes[tag]["reason"]

        night(mini, NIGHTS[2])
        kept, entries = mini.tags(), len(records(mini))
        dry = called(elsewhere, mini, "prune", "--days", "0", "--newest", "0")
        assert dry.code == 0 and "nothing was removed" in dry.out, dry.err
        pruned = called(elsewhere, mini, "prune", "--days", "0", "--newest", "0", "--apply")
        assert pruned.code == 1
        message = " ".join(pruned.err.split())
        assert "deletes nothing" in message and "could go, and stay" in message and "manifest" in message
        assert "remedy: ask its operator to allow it, or delete with its own tools" in message and "ghcr.io" in message
        now = mini.tags()
        assert now.items() <= kept.items() and {tag for tag in kept if not tag[-8:].isdigit()} <= now.keys()
        assert len(records(mini)) == entries
        mini.check()
        assert pull(mini, tmp_path / "pulled") >= 4


def test_every_kept_tag_pulls_after_pruning(project: Mini, tmp_path: Path) -> None:
    """Three nights; then what only the first ones led to goes, and its bytes with it."""
    with place(project, tmp_path, deletes=True) as mini:
        elsewhere = clone(mini, tmp_path / "clone")
        for date in NIGHTS:
            night(mini, date)
        tags = mini.tags()
        dated = {tag for tag in tags if tag[-8:].isdigit()}
        assert len(dated) == 2 * len(NIGHTS)
        whole = stored(tmp_path)
        pruned = called(elsewhere, mini, "prune", "--apply", "--days", "0", "--newest", "1", "--json")
        assert pruned.code == 0, pruned.err
        assert len(json.loads(pruned.out)["tags"]) == 4 and not (elsewhere / ".state").exists()
        day = NIGHTS[-1][:10].replace("-", "")
        assert mini.tags() == {tag: digest for tag, digest in tags.items() if tag not in dated or tag.endswith(day)}
        mini.check()
        again = json.loads(called(elsewhere, mini, "prune", "--days", "0", "--newest", "1", "--json").out)
        assert (again["tags"], again["manifests"], again["records"]) == ([], [], [])
        succeeds(str(ROOT / ".state/bin/registry"), "garbage-collect", str(tmp_path / "registry/config.json"))
        assert stored(tmp_path) < whole
        mini.check()
        assert pull(mini, tmp_path / "pulled") == len(mini.tags()) >= 4
        plan = mini.says("plan", *ONLY, "--serve", NATIVE)
        assert not [task for task in plan["tasks"] if task["steps"]], "pruning took what the next run needs"


def stored(folder: Path) -> int:
    """How many blobs the registry's folder holds."""
    return sum(1 for path in (folder / "registry/storage/docker/registry/v2/blobs").rglob("data") if path.is_file())


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Registry]:
    folder = tmp_path_factory.mktemp("calls") / "registry"
    with secure.plain(folder, deletes=True) as address, Registry(address) as registry:
        yield registry


@pytest.mark.parametrize("name", CALLS)
def test_the_real_registry_does_what_its_imitations_do(client: Registry, name: str) -> None:
    CALLS[name](client, f"calls/{name.replace('_', '-')}")
