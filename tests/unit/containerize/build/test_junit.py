"""What the tests of packages left: files of JUnit and of CTest, as they are counted and named."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from rosml.containerize.build import junit

SUITE = """<testsuites><testsuite name="robot">
<testcase name="good" classname="a"/><testcase name="later" classname="a"><skipped/></testcase>
<testcase name="bad" classname="a"><failure message="1 is not&#x0A;2"/></testcase>
</testsuite></testsuites>"""
BAD = "robot: a.bad: 1 is not 2"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot").mkdir()
    return tmp_path


def read(folder: Path, text: str) -> junit.Tests:
    """The tests of a package with one report."""
    (folder / "robot/a.xml").write_text(text)
    return junit.read(folder)


def test_failures_are_named_with_their_messages(folder: Path) -> None:
    (folder / "failed").write_text("robot: build/robot/a.xml: 3 tests, 1 failure\n")
    assert read(folder, SUITE) == junit.Tests(3, 1, (BAD,))


IMPORTS = "Traceback:\ntest/test_a.py:1: in &lt;module&gt;\nE   ModuleNotFoundError: No module named 'cv3'"
SYNTAX = 'E     File "test_a.py", line 1\nE       def a(:\nE   SyntaxError: invalid syntax'


@pytest.mark.parametrize(
    ("error", "says"),
    [
        ('message="SIGSEGV">', "SIGSEGV"),  # the test crashed, or its set-up did
        (
            f'message="collection failure">{IMPORTS}',
            "could not be collected: ModuleNotFoundError: No module named 'cv3'",
        ),
        (f'message="collection failure">{SYNTAX}', "could not be collected: SyntaxError: invalid syntax"),
        ('message="collection failure">', "could not be collected"),
        (f'message="{"m" * 999}">', "m" * junit.SHOWN),
    ],
)
def test_an_error_is_a_failure_with_its_reason(error: str, says: str, folder: Path) -> None:
    tests = read(
        folder, f'<testsuite><testcase name="{"n" * 999}" classname=""><error {error}</error></testcase></testsuite>'
    )
    [line] = tests.failures
    assert tests.count == 1 and line.startswith(f"robot: {'n' * junit.SHOWN}: ") and line.endswith(says)


def test_what_left_no_report_counts_as_failed(folder: Path) -> None:
    """Whatever other packages report."""
    lines = ("tests do not build", "robot: left no report", "arm: left no report")
    (folder / "failed").write_text("\n".join(lines))
    assert junit.read(folder) == junit.Tests(3, 0, lines)
    assert read(folder, SUITE[:40]).failures == ("robot: a.xml is no XML: its program was ended", lines[0], lines[2])


@pytest.mark.parametrize("encoding", ["klingon", "shift_jis"])
def test_an_encoding_that_cannot_be_read_is_said(encoding: str, folder: Path) -> None:
    [line] = read(folder, f'<?xml version="1.0" encoding="{encoding}"?>{SUITE}').failures
    assert line.startswith("robot: a.xml has an encoding that cannot be read")


@pytest.mark.parametrize(
    "text",
    [
        "<testsuite>" * 40_000 + "</testsuite>" * 40_000,
        f"<testsuite>{'<testcase><failure/></testcase>' * 100_000}</testsuite>",
        f"<Site><TestList/>{'<Test Status=`failed`><Name>a</Name></Test>' * 60_000}</Site>".replace("`", '"'),
        f"<testsuite><testcase><failure>{'x ' * 4_000_000}</failure></testcase></testsuite>",
    ],
    ids=["deep", "many", "ctest", "long"],
)
def test_a_large_report_takes_no_time(text: str, folder: Path) -> None:
    started = time.process_time()
    assert len(read(folder, text).failures) <= junit.MOST + 1
    assert time.process_time() - started < 10


@pytest.mark.parametrize("counts", ['failures="1"', 'tests="3" failures="0" errors="2"'])
def test_a_suite_that_names_no_test_may_have_failed(counts: str, folder: Path) -> None:
    suites = f'<testsuite><testsuite name="bad" {counts}/></testsuite><testsuite name="good" failures="0" errors="0"/>'
    tests = read(folder, f"<testsuites>{suites}</testsuites>")
    assert tests == junit.Tests(1, 0, ("robot: bad: failed, and its report names no test",))


def test_a_namespace_hides_no_test(folder: Path) -> None:
    text = SUITE.replace("<testsuites>", '<testsuites xmlns="http://junit.org/x">')
    assert read(folder, text) == junit.Tests(3, 1, (BAD,))


CTEST = """<Site><Testing><TestList><Test>./good</Test></TestList>
<Test Status="passed"><Name>good</Name><FullCommandLine>good</FullCommandLine></Test>
<Test Status="failed"><Name>bad</Name><FullCommandLine>bad</FullCommandLine><Results>
  <Measurement><Value>first\n[NON-XML-CHAR-0x1B][31m\u202elast[NON-XML-CHAR-0x0]\n\n</Value></Measurement></Results></Test>
<Test Status="notrun"><Name>off</Name><Results>
  <NamedMeasurement name="Completion Status"><Value>Disabled</Value></NamedMeasurement></Results></Test>
<Test Status="failed"><Name>a</Name><FullCommandLine>a --xml "/ws/build/robot/a.xml"</FullCommandLine></Test>
<Test Status="passed"><Name>b</Name><FullCommandLine>b --xml "/ws/build/robot/b.xml"</FullCommandLine></Test>
<Test Status="failed"><Name>c</Name><FullCommandLine>c --xml "/ws/build/robot/b.xml"</FullCommandLine><Results>
  <NamedMeasurement name="Exit Code"><Value>SEGFAULT</Value></NamedMeasurement></Results></Test>
</Testing></Site>"""


def test_tests_of_ctest_count_if_no_junit_file_has_them(folder: Path) -> None:
    (folder / "robot/Testing/1").mkdir(parents=True)
    (folder / "robot/Testing/1/Test.xml").write_text(CTEST)
    (folder / "robot/b.xml").write_text('<testsuite><testcase name="good"/></testsuite>')
    assert read(folder, SUITE) == junit.Tests(4 + 4, 1 + 1, (BAD, "robot: bad: last", "robot: c: SEGFAULT"))


def test_a_failed_test_of_a_rostest_is_told_once(folder: Path) -> None:
    """By the report of the test itself. rostest's own report says that it ran, and CTest that rostest ended with 2."""
    reports = folder / "robot/test_results/robot"
    reports.mkdir(parents=True)
    launcher = '<testsuite><testcase classname="rostest.runner.RosTest" name="testnear home"/></testsuite>'
    (reports / "rostest-test_home.xml").write_text(launcher)
    (reports / "rosunit-near_home.xml").write_text(
        '<testsuite><testcase classname="Home" name="near"><failure message="too far"/></testcase></testsuite>'
    )
    command = 'run_tests.py "/ws/build/robot/test_results/robot/rostest-test_home.xml" "rostest home.test"'
    (folder / "robot/Test.xml").write_text(
        f"<Site><TestList/><Test Status='failed'><Name>home</Name><FullCommandLine>{command}</FullCommandLine></Test></Site>"
    )
    assert junit.read(folder).failures == ("robot: Home.near: too far",)
    (reports / "rosunit-near_home.xml").write_text("<testsuite><testcase name='near'/></testsuite>")
    assert junit.read(folder).failures == ("robot: home",), "another reason, which no report has"
