"""What a scan hands over to a job that may write, and what that one makes of it."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import SMALLER, parse, write_locks

from fakes.memory_registry import NEXT, Publisher, Run, publisher
from fakes.projects import copy
from fakes.stubs import NO_FORMAT_1, services
from rosml.base.errors import RosmlError
from rosml.images.image_set import locked
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import scan_results
from rosml.images.publish.scan_results import Results
from rosml.images.records import store

CORE = ("alpha-core", "amd64")


@pytest.fixture
def image_set(tmp_path: Path) -> ImageSet:
    project = copy(tmp_path / "project")
    image_set = parse(SMALLER.replace("components: [core, base]", "components: [core]"))
    write_locks(project, image_set)
    return locked.with_locks(image_set, locked.current_locks(image_set, project))


@pytest.fixture
def registry(image_set: ImageSet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    place = publisher(tmp_path / "project", services(tmp_path / "project"), monkeypatch)
    place.publish(image_set, only=["alpha-core"])
    return place


@pytest.fixture
def run(registry: Publisher, image_set: ImageSet) -> Callable[[], Run]:
    return lambda: registry.run(image_set, date=NEXT, only=["alpha-core"])


def scan(run: Run, file: Path, outcome: str = "clean") -> str:
    """What a scan hands over: an entry."""
    results = Results(file, run.state.date)
    entry = run.state.entries[CORE]
    changed = store.parse(entry.to_json() | {"scanned": outcome, "scan": {"policy": "sha256:1"}, "passed": 99})
    assert changed
    results.add(changed)
    results.write()
    return entry.digest


def test_a_scan_writes_nothing_and_a_record_what_it_found(
    run: Callable[[], Run], registry: Publisher, tmp_path: Path
) -> None:
    before = registry.registry.writes
    digest = scan(run(), tmp_path / "scan.json")
    assert registry.registry.writes == before
    recording = run()
    assert recording.state.entries[CORE].scanned == ""
    scan_results.record(recording, tmp_path / "scan.json")
    entry = run().state.entries[CORE]
    assert (entry.scanned, entry.scan, entry.digest) == ("clean", {"policy": "sha256:1"}, digest)
    assert entry.passed == 5, "tests are no business of a scan"


def test_what_was_made_anew_since_is_not_vouched_for(run: Callable[[], Run], tmp_path: Path) -> None:
    scan(run(), tmp_path / "scan.json")
    recording = run()
    entry = recording.state.entries[CORE]
    recording.state.entries[CORE] = entry.with_digest(f"sha256:{'7' * 64}")
    scan_results.record(recording, tmp_path / "scan.json")
    assert run().state.entries[CORE].scanned == ""
    assert [(o.state, o.reason) for o in recording.outcomes] == [("waits", "it was rebuilt after the scan")]


ENTRY = {"target": "a", "architecture": "b", "digest": f"sha256:{'1' * 64}", "scanned": "clean"}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        *NO_FORMAT_1,
        (b'{"version": 1, "entries": {}}', "entries: input should be a valid array"),
        *(
            (json.dumps({"version": 1, "entries": [entry]}).encode(), "an entry has no outcome of a scan")
            for entry in ("x", ENTRY | {"digest": "x"}, ENTRY | {"scanned": "fine"}, ENTRY | {"x": 1})
        ),
        (None, "No such file or directory"),
    ],
)
def test_a_file_with_anything_else_is_refused(
    run: Callable[[], Run], tmp_path: Path, text: bytes | None, reason: str
) -> None:
    """All of it: it comes from a job that nobody trusts with the registry."""
    file = tmp_path / "scan.json"
    if text is not None:
        file.write_bytes(text)
    with pytest.raises(RosmlError, match=re.escape(reason)) as caught:
        scan_results.record(run(), file)
    assert caught.value.exit_code == 2
    assert run().state.entries[CORE].scanned == ""
