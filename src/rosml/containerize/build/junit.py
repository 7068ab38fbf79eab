"""Test reports of packages: JUnit files, and those of CTest."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from xml.etree import ElementTree

FAILED, PRINTED = "failed", "output.log"
"""The file that lists tests without a report, a line each; and that with the output of such tests of a package."""

_WRONG = ("failures", "errors")

MOST, END, NAMES, SHOWN = 1000, 1 << 16, 16, 160
"""The most failed tests to name, characters to read of a command line or output, files of a command line, and characters of a message."""

_ODD = re.compile(r"""[ "'&$!`/\\]""")
"""Characters that rostest replaces in the name of a report."""

UNCOLLECTED = "collection failure"
"""pytest's message about a module that it cannot import."""

NOT_COLLECTED = "its tests could not be collected"


@dataclass(frozen=True)
class Tests:
    """Tests that ran. `failures` has a line for each failed one: its name and message."""

    count: int = 0
    skipped: int = 0
    failures: tuple[str, ...] = ()


def total(results: Iterable[Tests]) -> Tests:
    """The sum. Only the first MOST failures have a line each."""
    count = skipped = more = 0
    failures: list[str] = []
    for tests in results:
        count, skipped = count + tests.count, skipped + tests.skipped
        kept = tests.failures[: MOST - len(failures)]
        failures += kept
        more += len(tests.failures) - len(kept)
    return Tests(count, skipped, (*failures, *([f"and {more} more tests failed"] if more else ())))


def read(folder: Path) -> Tests:
    """The tests below a folder that has a folder for each package.

    If a test of CTest writes a JUnit file, the tests in it count instead. The lines `PACKAGE: …` of the file `failed`, such as of tests that
    do not build, count if no test of that package failed.
    """
    reported = total(_package(path) for path in sorted(folder.glob("*")) if path.is_dir())
    if not (folder / FAILED).is_file():
        return reported
    lines = (folder / FAILED).read_text(errors="replace").split("\n")
    failed_packages = {line.partition(": ")[0] for line in reported.failures}
    others = tuple(text for line in lines if (text := _clean(line)) and text.partition(": ")[0] not in failed_packages)
    return total((reported, Tests(len(others), 0, others)))


def _package(folder: Path) -> Tests:
    results: list[Tests] = []
    passed_reports: set[str] = set()
    failed_reports: set[str] = set()
    ctest: list[ElementTree.Element] = []
    launched: dict[str, set[str]] = {}
    for path in sorted(path for path in folder.rglob("*.xml") if path.is_file()):
        try:
            root = ElementTree.parse(path).getroot()
        except ElementTree.ParseError:
            results.append(_unreadable(path, folder, "is no XML: its program was ended"))
            continue
        except (LookupError, ValueError):  # Python does not know the encoding, or expat refuses it
            results.append(_unreadable(path, folder, "has an encoding that cannot be read: write it in UTF-8"))
            continue
        if root.tag == "Site":
            ctest += (test for test in root.iter("Test") if "Status" in test.attrib)
            continue
        for element in root.iter():  # some programs write JUnit files with a namespace
            if isinstance(element.tag, str):
                element.tag = element.tag.rpartition("}")[2]
        tests, report = _junit(root, folder.name), f"/{folder.name}/{path.relative_to(folder)}"
        (failed_reports if tests.failures else passed_reports).add(report)
        launched[report] = _launched(root, PurePosixPath(report))
        results.append(tests)
    failed_reports |= {report for report, others in launched.items() if others & failed_reports}
    results += [_ctest(test, folder.name, passed_reports, failed_reports) for test in ctest]
    return total(results)


def _launched(root: ElementTree.Element, report: PurePosixPath) -> set[str]:
    """The reports of the tests that a rostest launched, by the names that rostest gives them. Its own report says that they ran."""
    if not report.name.startswith("rostest-"):
        return set()
    names = [case.get("name", "").removeprefix("test") for case in root.iter("testcase")]
    return {str(report.with_name(f"rosunit-{_ODD.sub('_', name)}.xml")) for name in names[:MOST]}


def _unreadable(path: Path, folder: Path, why: str) -> Tests:
    return Tests(1, 0, (f"{folder.name}: {path.name} {why}",))


def _junit(root: ElementTree.Element, package: str) -> Tests:
    count = skipped = 0
    failures = []
    for suite in _innermost_without_tests(root):  # a suite that could not begin has only numbers
        if any(suite.get(kind, "0") not in ("", "0") for kind in _WRONG):
            count += 1
            failures.append(_failure(package, suite.get("name", ""), "failed, and its report names no test"))
    for case in root.iter("testcase"):
        count += 1
        skipped += case.find("skipped") is not None
        wrong = next((item for kind in ("failure", "error") if (item := case.find(kind)) is not None), None)
        if wrong is not None:
            name = ".".join(filter(None, (case.get("classname"), case.get("name"))))
            failures.append(_failure(package, name, _reason(wrong.get("message") or "", wrong.text or "")))
    return Tests(count, skipped, tuple(failures))


def _reason(message: str, text: str) -> str:
    """Why a test failed. Of a module that pytest cannot import, the last line of the text says it."""
    if message != UNCOLLECTED:
        return message or text
    lines = [line for line in text[-END:].splitlines() if line.startswith("E ")]
    return f"{NOT_COLLECTED}: {lines[-1][1:].strip()}" if lines else NOT_COLLECTED


def _innermost_without_tests(root: ElementTree.Element) -> list[ElementTree.Element]:
    suites: list[ElementTree.Element] = []
    parents: set[ElementTree.Element] = set()
    for element in reversed([*root.iter()]):  # children before their parents
        if any(child in parents or child.tag in ("testcase", "testsuite") for child in element):
            parents.add(element)
        elif element.tag == "testsuite":
            suites.append(element)
    return suites[::-1]


def _ctest(test: ElementTree.Element, package: str, passed_reports: set[str], failed_reports: set[str]) -> Tests:
    """A test of CTest; nothing if its own JUnit file has the same result."""
    values = {item.get("name", ""): item.findtext("Value", "") for item in test.iter("NamedMeasurement")}
    status = test.get("Status")
    skipped = status == "notrun" and re.match("SKIP|Disabled", values.get("Completion Status", "")) is not None
    right = status == "passed" or skipped
    written = set(_written(test.findtext("FullCommandLine", ""), package))
    if written & failed_reports or (right and written & passed_reports):
        return Tests()
    if right:
        return Tests(1, int(skipped))
    output = [line for line in test.findtext("Results/Measurement/Value", "")[-END:].splitlines() if _clean(line)]
    reason = output[-1] if output else values.get("Exit Code", "")
    return Tests(1, 0, (_failure(package, test.findtext("Name", ""), reason),))


def _written(command: str, package: str) -> Iterator[str]:
    """The files below a package's folder that a command line may name, up to NAMES."""
    start = f"/{package}/"
    for begin in list(re.finditer(re.escape(start), command[:END]))[:NAMES]:
        for end in list(re.finditer(r"\.xml", command[begin.start() : END]))[:NAMES]:
            yield command[begin.start() : begin.start() + end.end()]


def _failure(package: str, name: str, reason: str) -> str:
    return f"{package}: {_clean(name)}: {_clean(reason)}".rstrip(": ")


def _clean(text: str) -> str:
    """A line without control characters, and not too long."""
    text = re.sub(r"(\x1b|\[NON-XML-CHAR-0x1B\])\[[0-?]*[ -/]*[@-~]|\[NON-XML-CHAR-\w+\]", "", text[:END])
    return " ".join("".join(sign if sign.isprintable() else " " for sign in text).split())[:SHOWN]
