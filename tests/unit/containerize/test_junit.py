"""What the tests of packages left: files of JUnit and of CTest, as they are counted and told."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from rosml.containerize.build import junit

SUITE = """<testsuites><testsuite name="robot">
<testcase name="good" classname="a"/><testcase name="later" classname="a"><skipped/></testcase>
<testcase name="bad" classname="a"><failure message="1 is not&#x0A;2"/></testcase>
</testsuite></testsuites>"""


def test_failures_are_named_with_what_they_said(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/a.xml").write_text(SUITE)
    (tmp_path / "failed").write_text("robot: build/robot/a.xml: 3 tests, 1 failure\n")
    assert junit.read(tmp_path) == junit.Tests(3, 1, ("robot: a.bad: 1 is not 2",))


def test_an_error_is_a_failure(tmp_path: Path) -> None:
    """A test that crashed, or whose set-up did."""
    (tmp_path / "robot").mkdir()
    case = '<testcase name="crashed" classname="a"><error message="SIGSEGV"/></testcase>'
    (tmp_path / "robot/a.xml").write_text(f"<testsuite>{case}</testsuite>")
    assert junit.read(tmp_path) == junit.Tests(1, 0, ("robot: a.crashed: SIGSEGV",))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            "Traceback:\ntest/test_a.py:1: in &lt;module&gt;\nE   ModuleNotFoundError: No module named 'cv3'",
            ": ModuleNotFoundError: No module named 'cv3'",
        ),
        (
            'E     File "test_a.py", line 1\nE       def a(:\nE   SyntaxError: invalid syntax',
            ": SyntaxError: invalid syntax",
        ),
        ("", ""),
    ],
)
def test_a_module_that_pytest_cannot_import_is_told_with_the_reason(text: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    error = f'<error message="collection failure">{text}</error>'
    (tmp_path / "robot/a.xml").write_text(
        f'<testsuite><testcase classname="" name="test.test_a">{error}</testcase></testsuite>'
    )
    told = f"robot: test.test_a: its tests could not be collected{reason}"
    assert junit.read(tmp_path) == junit.Tests(1, 0, (told,))


def test_what_left_no_report_counts_as_failed(tmp_path: Path) -> None:
    """Whatever other packages report."""
    (tmp_path / "robot").mkdir()
    (tmp_path / "failed").write_text("tests do not build\nrobot: left no report\narm: left no report\n")
    found = junit.read(tmp_path)
    assert found == junit.Tests(3, 0, ("tests do not build", "robot: left no report", "arm: left no report"))
    (tmp_path / "robot/a.xml").write_text(SUITE[:40])
    assert junit.read(tmp_path).failures == (
        "robot: a.xml is no XML: its program was ended",
        "tests do not build",
        "arm: left no report",
    )


@pytest.mark.parametrize("encoding", ["klingon", "shift_jis"])
def test_an_encoding_that_cannot_be_read_is_said(encoding: str, tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/a.xml").write_text(f'<?xml version="1.0" encoding="{encoding}"?>{SUITE}')
    assert junit.read(tmp_path).failures == ("robot: a.xml has an encoding that cannot be read: write it in UTF-8",)


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
def test_a_large_report_takes_no_time(text: str, tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/a.xml").write_text(text)
    started = time.process_time()
    assert len(junit.read(tmp_path).failures) <= junit.MOST + 1
    assert time.process_time() - started < 10


@pytest.mark.parametrize("counts", ['failures="1"', 'tests="3" failures="0" errors="2"'])
def test_a_suite_that_names_no_test_may_have_failed(counts: str, tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    suites = f'<testsuite name="bad" {counts}/><testsuite name="good" failures="0" errors="0"/>'
    (tmp_path / "robot/a.xml").write_text(f"<testsuites>{suites}</testsuites>")
    assert junit.read(tmp_path) == junit.Tests(1, 0, ("robot: bad: failed, and its report names no test",))


def test_a_namespace_hides_no_test(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/a.xml").write_text(SUITE.replace("<testsuites>", '<testsuites xmlns="http://junit.org/x">'))
    assert junit.read(tmp_path) == junit.Tests(3, 1, ("robot: a.bad: 1 is not 2",))


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


def test_tests_of_ctest_count_where_no_junit_file_has_them(tmp_path: Path) -> None:
    (tmp_path / "robot/Testing/1").mkdir(parents=True)
    (tmp_path / "robot/Testing/1/Test.xml").write_text(CTEST)
    (tmp_path / "robot/a.xml").write_text(SUITE)
    (tmp_path / "robot/b.xml").write_text('<testsuite><testcase name="good"/></testsuite>')
    ours = ("robot: a.bad: 1 is not 2", "robot: bad: last", "robot: c: SEGFAULT")
    assert junit.read(tmp_path) == junit.Tests(4 + 4, 1 + 1, ours)


def test_a_long_name_or_message_is_cut(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    case = f'<testcase name="{"n" * 999}"><failure message="{"m" * 999}"/></testcase>'
    (tmp_path / "robot/a.xml").write_text(f"<testsuite>{case}</testsuite>")
    assert junit.read(tmp_path).failures == (f"robot: {'n' * junit.SHOWN}: {'m' * junit.SHOWN}",)
