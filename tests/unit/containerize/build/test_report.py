"""Reports of a build are files with a shape: nothing that its steps left reaches this machine in another way."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from fakes import archives
from fakes.apps import APP, DEPENDENCIES
from rosml.base.errors import RosmlError
from rosml.containerize.build import junit, report
from rosml.machine import exported

SUITE = '<testsuite><testcase name="good"/></testsuite>'
LINK = "it is a link, and not a file"
ONE = ("linux/amd64",)


def of_app(folder: Path, entries: dict[str, archives.Content]) -> report.AppReport:
    archives.write(folder / "report.tar", entries)
    return report.of_app(folder / "report.tar", folder / "files", ONE)


def of_tests(folder: Path, entries: dict[str, archives.Content], *platforms: str) -> report.TestResults:
    archives.write(folder / "results.tar", entries)
    return report.of_tests(folder / "results.tar", folder / "report", platforms or ONE)


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("results/robot/a.xml", (archives.LINK, "/proc/self/environ"), LINK),
        ("results/robot/a.xml", (archives.HARD_LINK, "results/robot/b.xml"), LINK),
        ("results/robot/a.xml", (archives.PIPE, ""), "it is a pipe, and not a file"),
        ("results/robot/a.xml", (archives.DEVICE, ""), "it is a device, and not a file"),
        ("results", (archives.LINK, "/"), LINK),
        ("results/robot/a\x1b[2J.xml", SUITE, "its name cannot be shown"),
        ("results/../../escaped.xml", SUITE, "its path leads elsewhere"),
        ("/results/robot/a.xml", SUITE, "its path leads elsewhere"),
        ("results/robot/a.xml", b" " * (exported.TESTS.each + 1), "it has 16 MB, and 16 MB are read at most"),
        ("results/other/b.xml/c.xml", SUITE, "there cannot be a file of that name"),
    ],
)
def test_what_tests_left_that_is_no_file_counts_as_failed(
    name: str, content: archives.Content, reason: str, tmp_path: Path
) -> None:
    tests = of_tests(tmp_path, {"results/other/b.xml": SUITE, name: content}).target
    assert tests.count == 2 and [line.rpartition(": ")[2] for line in tests.failures] == [reason]
    assert tests.failures[0].isprintable()
    files = [path for path in tmp_path.rglob("*") if path.suffix == ".xml" or path.is_symlink()]
    assert files == [tmp_path / "report/results/other/b.xml"]


def test_tests_say_nothing_of_the_images(tmp_path: Path) -> None:
    names = ("app.json", "dependencies.json", "contents-run/packages.json", "results/images.json", "slim.json")
    results = of_tests(tmp_path, {**dict.fromkeys(names, "{}"), "results/failed/a.xml": SUITE})
    assert results == report.TestResults(junit.Tests(1)), "a package may be called failed"
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
    assert of_tests(tmp_path, entries, "linux/amd64", "linux/arm64") == report.TestResults(
        junit.Tests(3, 0, ("robot: left no report",)),
        junit.Tests(1, 0, (f"linux_arm64/slim/robot/a.xml: {LINK}",)),
        junit.Tests(1, 0, (f"linux_amd64/downstream/user/a.xml: {LINK}",)),
    )
    assert (tmp_path / "report/linux_amd64/results/robot/output.log").read_text() == "1 != 2"


@pytest.mark.parametrize(
    ("limits", "says"),
    [(exported.Limits(entries=8), "8 files"), (exported.Limits(total=8 * len(SUITE)), "0 MB of reports")],
)
def test_tests_may_not_leave_too_much(limits: exported.Limits, says: str, tmp_path: Path) -> None:
    archives.write(tmp_path / "results.tar", {f"results/robot/{number}.xml": SUITE for number in range(9)})
    with pytest.raises(RosmlError, match=f"the build left more than {says}") as caught:
        exported.unpack(tmp_path / "results.tar", tmp_path / "out", limits=limits)
    assert caught.value.remedy


def test_a_report_has_a_shape(tmp_path: Path) -> None:
    files: dict[str, archives.Content] = {"contents-run/packages.json": "{}", "contents-run/files.gz": b"\x1f"}
    files |= {"contents-dev/packages.json": "{}", "contents-dev/files.gz": b"\x1f"}
    app = of_app(tmp_path, {"app.json": json.dumps(APP), "dependencies.json": json.dumps(DEPENDENCIES), **files})
    assert app.apps()[0].apt == {"libfoo": "1.0"} and [*app.dependencies().packages] == ["robot"]
    assert app.details() == {
        "run/linux/amd64/packages.json": b"{}",
        "run/linux/amd64/files.gz": b"\x1f",
        "dev/linux/amd64/packages.json": b"{}",
    }
    with pytest.raises(RosmlError, match=r"the build left no contents-slim/files\.gz"):
        app.detail("slim/linux/amd64/files.gz")
    with pytest.raises(RosmlError, match=r"the build left no slim\.json"):
        app.apps(report.SLIM_APP)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("[]", "app.json"),
        ("[" * 100_000, "app.json: invalid JSON"),
        (b"\xff", "app.json: it is not UTF-8"),
        (json.dumps({**APP, "packages": "libfoo"}), "app.json: packages: "),
        (json.dumps({**APP, "apt": {"libfoo; rm": "1"}}), "app.json: apt."),
        (json.dumps({**APP, "apt": {"libfoo": "1 && true"}}), "app.json: apt."),
        (json.dumps({**APP, "pip": ["--index-url=https://evil.example"]}), "app.json: pip"),
        (json.dumps({name: value for name, value in APP.items() if name != "removed"}), "app.json: removed: "),
        ((archives.LINK, "/proc/self/environ"), f"app.json: {LINK}"),
    ],
)
def test_a_damaged_report_is_refused(content: archives.Content, says: str, tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=f"the build says of the app is damaged: {re.escape(says)}") as caught:
        of_app(tmp_path, {"app.json": content}).apps()
    assert caught.value.remedy and "environ" not in caught.value.message


@pytest.mark.parametrize("data", [None, b"", b"no archive", b"\0" * 5000])
def test_an_archive_that_cannot_be_read_is_refused(data: bytes | None, tmp_path: Path) -> None:
    if data is not None:
        (tmp_path / "report.tar").write_bytes(data)
    with pytest.raises(RosmlError, match=r"the build left no|is damaged") as caught:
        report.of_app(tmp_path / "report.tar", tmp_path / "files", ONE).apps()
    assert caught.value.remedy
