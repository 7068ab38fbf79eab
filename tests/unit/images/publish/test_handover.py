"""What a scan hands over to a job that may write, and what that one makes of it."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, parse, write_locks

from fakes.memory_registry import NEXT, Publisher, Run, publisher
from fakes.projects import copy
from fakes.stubs import NO_FORMAT_1, services
from rosml.base.errors import RosmlError
from rosml.images.image_set import locked
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import scan_results
from rosml.images.records import store
from rosml.images.scan.results import Results

CORE = ("alpha-core", "amd64")


@pytest.fixture
def image_set(tmp_path: Path) -> ImageSet:
    project = copy(tmp_path / "project")
    found = parse(SMALLER.replace("components: [core, base]", "components: [core]"))
    write_locks(project, found)
    return locked.with_locks(found, locked.current_locks(found, project))


@pytest.fixture
def registry(image_set: ImageSet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    found = publisher(tmp_path / "project", services(tmp_path / "project"), monkeypatch)
    found.publish(image_set, only=["alpha-core"])
    return found


@pytest.fixture
def run(registry: Publisher, image_set: ImageSet) -> Callable[[], Run]:
    return lambda: registry.run(image_set, date=NEXT, only=["alpha-core"])


def scan(found: Run, file: Path, outcome: str = "clean") -> str:
    """What a scan hands over: an entry."""
    results = Results(file, found.state.date)
    entry = found.state.entries[CORE]
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
    found = run()
    assert found.state.entries[CORE].scanned == ""
    scan_results.record(found, tmp_path / "scan.json")
    entry = run().state.entries[CORE]
    assert (entry.scanned, entry.scan, entry.digest) == ("clean", {"policy": "sha256:1"}, digest)
    assert entry.passed == 5, "tests are no business of a scan"


def test_what_was_made_anew_since_is_not_vouched_for(run: Callable[[], Run], tmp_path: Path) -> None:
    scan(run(), tmp_path / "scan.json")
    found = run()
    entry = found.state.entries[CORE]
    found.state.entries[CORE] = entry.with_digest(f"sha256:{'7' * 64}")
    scan_results.record(found, tmp_path / "scan.json")
    assert run().state.entries[CORE].scanned == ""
    assert [(o.state, o.reason) for o in found.outcomes] == [("waits", "it was rebuilt after the scan")]


@pytest.mark.parametrize(
    "change",
    [
        {"version": 2},
        {"entries": [{"target": "alpha-core", "architecture": "amd64", "digest": "x", "scanned": "clean"}]},
        {"entries": [{"target": "a", "architecture": "b", "digest": f"sha256:{'1' * 64}", "scanned": "fine"}]},
        {"entries": [{"target": "a", "architecture": "b", "digest": f"sha256:{'1' * 64}", "scanned": "clean", "x": 1}]},
    ],
)
def test_a_file_that_is_not_what_it_should_be(run: Callable[[], Run], tmp_path: Path, change: dict[str, Any]) -> None:
    """All of it is refused: it comes from a job that nobody trusts with the registry."""
    file = tmp_path / "scan.json"
    scan(run(), file)
    content = json.loads(file.read_text())
    file.write_text(json.dumps(content | change))
    found = run()
    with pytest.raises(RosmlError, match="does not hold the results of a scan") as caught:
        scan_results.record(found, file)
    assert caught.value.exit_code == 2
    assert run().state.entries[CORE].scanned == ""


@pytest.mark.parametrize(
    ("text", "says"),
    [
        *NO_FORMAT_1,
        (b'{"version": 1, "entries": {}}', "entries: input should be a valid array"),
        (b'{"version": 1, "entries": ["x"]}', "an entry has no outcome of a scan"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_in_words(
    run: Callable[[], Run], tmp_path: Path, text: bytes, says: str
) -> None:
    file = tmp_path / "scan.json"
    file.write_bytes(text)
    with pytest.raises(RosmlError, match=rf"does not hold the results of a scan: {re.escape(says)}") as caught:
        scan_results.record(run(), file)
    assert caught.value.remedy == "write it again with: rosml publish scan --output FILE"


def test_a_file_of_results_that_is_not_there(run: Callable[[], Run], tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=r"scan: No such file or directory$"):
        scan_results.record(run(), tmp_path / "scan.json")
