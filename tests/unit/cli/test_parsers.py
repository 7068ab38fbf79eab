"""Parsers of what others wrote take any document: they read it, or say what is wrong and what to do, in seconds and 200 MB."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from fakes import fuzz, parsers

# 200 documents for each parser in a second or so; the proof `properties` has more:
#   HYPOTHESIS_PROFILE=thorough uv run pytest tests/unit/cli/test_parsers.py
COUNT = 5_000 if os.environ.get("HYPOTHESIS_PROFILE") == "thorough" else 200


@pytest.mark.parametrize("name", parsers.PARSERS)
def test_a_parser_takes_any_document(name: str) -> None:
    problems = [*fuzz.problems("fakes.parsers", name, COUNT)]
    assert not problems, f"{len(problems)} of {COUNT}:\n" + "\n".join(problems[:20])


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("hang", "it ends the process with -27"),  # SIGPROF
        ("crash", "it ends the process with -11"),
        ("slow", "it (takes 3|ends the process with -27)"),
        ("waste", "MemoryError"),
        ("traceback", "KeyError: 'name'"),
        ("helpless", "no remedy"),
        ("script", "no remedy"),
    ],
)
def test_the_fuzz_catches_what_no_parser_may_do(name: str, says: str) -> None:
    problems = [*fuzz.problems("fakes.bad_parsers", name, 1)]
    assert len(problems) == 1 and re.match(f"{name} 0: {says}", problems[0]), problems


@pytest.mark.parametrize("name", parsers.PARSERS)
def test_a_parser_reads_valid_documents(name: str, tmp_path: Path) -> None:
    """Otherwise, all that is made wrong is wrong already."""
    parser = parsers.PARSERS[name]
    for number, document in enumerate(parser.documents):
        (folder := tmp_path / str(number)).mkdir()
        parser.read(document, folder)
