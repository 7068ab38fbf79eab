"""How pages, help texts and messages are written: the rules of docs/style.md that a program can hold without erring often."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from tests.pages import pages
from tests.prose import Sentence, messages, sentences

ROOT = Path(__file__).resolve().parents[2]
WORDS = [
    rule for rules in yaml.safe_load((Path(__file__).parent / "words.yaml").read_text()).values() for rule in rules
]
"""What finds a word, what to write instead, and a sentence that has the word."""

LONGEST = 35
"""Words in a sentence. A span of code is one."""

TALLEST = {"README.md": 120, "CHANGELOG.md": 100_000}
"""Lines of a page; others have at most 200."""


def faults(sentence: Sentence) -> Iterator[str]:
    """What is wrong with a sentence."""
    for pattern, instead, _ in WORDS:
        if match := re.search(rf"(?<![\w-])(?:{pattern})(?![\w-])", sentence.text, re.IGNORECASE):
            yield f"{match[0]!r}: write {instead}"
    if (count := len(sentence.text.split())) > LONGEST:
        yield f"{count} words: a sentence has at most {LONGEST}"


def report(read: list[Sentence]) -> None:
    """Fails with all faults, each with its place."""
    assert len(read) > 1000
    lines = [
        f"{sentence.file}:{sentence.line}: {fault}: {sentence.text}" for sentence in read for fault in faults(sentence)
    ]
    if lines:
        pytest.fail("\n".join(lines), pytrace=False)


def test_pages() -> None:
    report([s for page in pages() for s in sentences(str(page.relative_to(ROOT)), page.read_text())])


def test_a_page_answers_one_need() -> None:
    lines = {str(page.relative_to(ROOT)): len(page.read_text().splitlines()) for page in pages()}
    too_long = {name: count for name, count in lines.items() if count > TALLEST.get(name, 200)}
    assert too_long == {}, "cut them by what a reader needs: docs/style.md"


def test_help_and_messages() -> None:
    files = [file for folder in ("src/rosml", "scripts", "bench") for file in sorted((ROOT / folder).rglob("*.py"))]
    report([s for file in files for s in messages(str(file.relative_to(ROOT)), file.read_text())])


@pytest.mark.parametrize(("instead", "example"), [rule[1:] for rule in WORDS])
def test_each_word_is_found(instead: str, example: str) -> None:
    (fault,) = faults(Sentence("", 1, example))
    assert fault.endswith(f": write {instead}")


@pytest.mark.parametrize(
    "text",
    [
        "A key whose owner signs.",
        "Where to look is in the log.",
        "Use the mirror; it is near.",
    ],
)
def test_plain_sentences_pass(text: str) -> None:
    assert list(faults(Sentence("", 1, text))) == []


def test_long_sentences_are_found() -> None:
    assert list(faults(Sentence("", 1, "word " * 35))) == []
    assert list(faults(Sentence("", 1, "word " * 36))) == ["36 words: a sentence has at most 35"]


PAGE = """\
# A page

One `sentence with code.` goes
on. Two [is short](page.md#anchor)!

```sh
echo "No prose. At all."
```

- An item
- Another. <!-- a comment. -->

| a cell | `code` |
| --- | --- |
| one: **two** | three. Four |

<details><summary>Five</summary>Six.</details>
"""


def test_a_page_is_read_by_sentences() -> None:
    texts = [(s.line, s.text) for s in sentences("page", PAGE)]
    assert texts == [
        *((1, "A page"), (3, "One § goes on."), (4, "Two [is short]!"), (10, "- An item"), (11, "- Another.")),
        *((13, "a cell"), (15, "one: two"), (15, "three."), (15, "Four"), (17, "Five"), (17, "Six.")),
    ]
