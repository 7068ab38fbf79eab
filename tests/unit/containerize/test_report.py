"""What a build says is taken in as files with a shape: nothing that its steps left reaches this machine in another way."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from fakes import archives
from rosml.base.errors import RosmlError
from rosml.containerize.build import junit, report
from rosml.machine import exported

APP: dict[str, Any] = {
    "packages": ["libfoo:all"],
    "changed": [],
    "replaced": [],
    "removed": [],
    "built": ["robot"],
    "lost": [],
    "absent": [],
    "forgotten": {},
    "outside": [],
    "architecture": "amd64",
    "apt": {"libfoo": "1.0"},
    "pip": [],
}
DEPENDENCIES = {"packages": {"robot": {"build": ["roscpp"]}}, "keys": {}, "skipped": []}
SUITE = '<testsuite><testcase name="good"/></testsuite>'
ONE = ("linux/amd64",)


def said(folder: Path, entries: dict[str, archives.Content], *platforms: str) -> report.AppReport:
    archives.write(folder / "report.tar", entries)
    return report.of_app(folder / "report.tar", folder / "said", platforms or ONE)


def left_by_tests(folder: Path, entries: dict[str, archives.Content], *platforms: str) -> report.TestResults:
    archives.write(folder / "results.tar", entries)
    return report.of_tests(folder / "results.tar", folder / "report", platforms or ONE)


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("results/robot/a.xml", (archives.LINK, "/proc/self/environ"), "it is a link, and not a file"),
        ("results/robot/a.xml", (archives.HARD_LINK, "results/robot/b.xml"), "it is a link, and not a file"),
        ("results/robot/a.xml", (archives.PIPE, ""), "it is a pipe, and not a file"),
        ("results/robot/a.xml", (archives.DEVICE, ""), "it is a device, and not a file"),
        ("results", (archives.LINK, "/"), "it is a link, and not a file"),
        ("results/robot/a\x1b[2J.xml", SUITE, "its name cannot be shown"),
        ("results/../../escaped.xml", SUITE, "its path leads elsewhere"),
        ("/results/robot/a.xml", SUITE, "its path leads elsewhere"),
        ("results/robot/a.xml", b" " * (exported.TESTS.each + 1), "it has 16 MB, and 16 MB are read at most"),
    ],
)
def test_what_tests_left_that_is_no_file_counts_as_failed(
    name: str, content: archives.Content, reason: str, tmp_path: Path
) -> None:
    found = left_by_tests(tmp_path, {name: content, "results/other/b.xml": SUITE}).target
    assert found.count == 2 and [line.rpartition(": ")[2] for line in found.failures] == [reason]
    assert found.failures[0].isprintable()
    kept = [path for path in tmp_path.rglob("*") if path.suffix == ".xml" or path.is_symlink()]
    assert kept == [tmp_path / "report/results/other/b.xml"]


def test_tests_say_nothing_else(tmp_path: Path) -> None:
    """What the images hold, and what a job of CI made, is not for them to say."""
    names = ("app.json", "dependencies.json", "contents-run/packages.json", "results/images.json", "slim.json")
    found = left_by_tests(tmp_path, {**dict.fromkeys(names, "{}"), "results/robot/a.xml": SUITE})
    assert found.target == junit.Tests(1)
    assert [path.name for path in (tmp_path / "report").rglob("*") if path.is_file()] == ["a.xml"]


def test_results_are_of_their_packages_platforms_and_images(tmp_path: Path) -> None:
    link = (archives.LINK, "/etc/passwd")
    entries: dict[str, archives.Content] = {
        "linux_amd64/results/robot/a.xml": SUITE,
        "linux_amd64/results/failed": "robot: left no report\n",
        "linux_amd64/results/robot/output.log": "1 != 2",
        "linux_arm64/results/robot/a.xml": SUITE,
        "linux_arm64/slim/robot/a.xml": link,
        "linux_amd64/downstream/user/a.xml": link,
    }
    found = left_by_tests(tmp_path, entries, "linux/amd64", "linux/arm64")
    assert found.target == junit.Tests(3, 0, ("robot: left no report",))
    assert (tmp_path / "report/linux_amd64/results/robot/output.log").read_text() == "1 != 2"
    reason = "it is a link, and not a file"
    assert found.slim == junit.Tests(1, 0, (f"linux_arm64/slim/robot/a.xml: {reason}",))
    assert found.downstream == junit.Tests(1, 0, (f"linux_amd64/downstream/user/a.xml: {reason}",))


def test_tests_may_not_leave_too_much(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    entries: dict[str, archives.Content] = {f"results/robot/{number}.xml": SUITE for number in range(9)}
    archives.write(tmp_path / "results.tar", entries)
    limits = exported.Limits(entries=8)
    with pytest.raises(RosmlError, match="the build left more than 8 files") as caught:
        exported.unpack(tmp_path / "results.tar", tmp_path / "out", limits=limits)
    assert caught.value.remedy
    limits = exported.Limits(total=8 * len(SUITE))
    with pytest.raises(RosmlError, match="the build left more than 0 MB of reports"):
        exported.unpack(tmp_path / "results.tar", tmp_path / "out", limits=limits)


def test_what_the_build_says_has_a_shape(tmp_path: Path) -> None:
    files: dict[str, archives.Content] = {"contents-run/packages.json": "{}", "contents-run/files.gz": b"\x1f"}
    found = said(tmp_path, {"app.json": json.dumps(APP), "dependencies.json": json.dumps(DEPENDENCIES), **files})
    assert found.apps()[0].apt == {"libfoo": "1.0"} and [*found.dependencies().packages] == ["robot"]
    assert found.details() == {"run/linux/amd64/packages.json": b"{}", "run/linux/amd64/files.gz": b"\x1f"}
    with pytest.raises(RosmlError, match=r"the build left no contents-slim/files\.gz"):
        found.detail("slim/linux/amd64/files.gz")
    with pytest.raises(RosmlError, match=r"the build left no slim\.json"):
        found.slim_apps()


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("[]", "app.json"),
        ("{", "app.json: invalid JSON"),
        ("[" * 100_000, "app.json: invalid JSON"),
        (b"\xff", "app.json: it is not UTF-8"),
        (json.dumps({**APP, "packages": "libfoo"}), "app.json: packages: "),
        (json.dumps({**APP, "apt": {"libfoo; rm": "1"}}), "app.json: apt."),
        (json.dumps({**APP, "apt": {"libfoo": "1 && true"}}), "app.json: apt."),
        (json.dumps({**APP, "pip": ["--index-url=https://evil.example"]}), "app.json: pip"),
        (json.dumps({name: value for name, value in APP.items() if name != "removed"}), "app.json: removed: "),
        ((archives.LINK, "/proc/self/environ"), "app.json: it is a link, and not a file"),
    ],
)
def test_a_damaged_report_is_said(content: archives.Content, says: str, tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=f"the build says of the app is damaged: {re.escape(says)}") as caught:
        said(tmp_path, {"app.json": content}).apps()
    assert caught.value.remedy and "environ" not in caught.value.message


@pytest.mark.parametrize("name", [f"results/{'a' * 250}/{'b' * 250}/" * 9 + "c.xml", "results/robot/a.xml/b.xml"])
def test_a_name_that_cannot_be_is_no_crash(name: str, tmp_path: Path) -> None:
    found = left_by_tests(tmp_path, {"results/robot/a.xml": SUITE, name: SUITE, "results/failed/x.xml": SUITE}).target
    assert [line.rpartition(": ")[2] for line in found.failures] == ["there cannot be a file of that name"]
    assert found.count == 3, "a package may be called failed"


@pytest.mark.parametrize("data", [None, b"", b"no archive", b"\0" * 5000])
def test_an_archive_that_cannot_be_read_is_said(data: bytes | None, tmp_path: Path) -> None:
    if data is not None:
        (tmp_path / "report.tar").write_bytes(data)
    with pytest.raises(RosmlError, match=r"the build left no|is damaged") as caught:
        report.of_app(tmp_path / "report.tar", tmp_path / "said", ONE).apps()
    assert caught.value.remedy
