"""The prose that users read, sentence by sentence: pages, help texts, messages."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass


@dataclass(frozen=True)
class Sentence:
    """A sentence, and the line on which it begins. A span of code in it is the one word `§`."""

    file: str
    line: int
    text: str


_FENCE = re.compile(r"^ *(?P<fence>```+).*?^ *(?P=fence) *$", re.MULTILINE | re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_BLOCK = re.compile(r"^( *[-*] | *\d+\. |#+ |\||</?\w)|\n *\n|(?<= )\|(?=[ \n])|(?<=[a-z]>)", re.MULTILINE)
"""Where a paragraph, an item of a list, a heading or a cell begins or ends."""

_END = re.compile(r"(?<=[.!?])[)\"*_]*\s+(?=[(\"*_\[]*[\w§])|\x00")
"""Where a sentence ends: at a full stop, or with its block."""


def sentences(file: str, text: str, first: int = 1) -> Iterator[Sentence]:
    """The sentences of a text in Markdown, without its code. `first` is the number of the text's first line."""
    for pattern in (_FENCE, _COMMENT):
        text = pattern.sub(lambda match: "\n" * match[0].count("\n"), text)
    text = re.sub(r"`+[^`]+`+", lambda match: "§" + "\n" * match[0].count("\n"), text)
    text = re.sub(r"\]\([^)\s]*\)", "]", text)
    text = _BLOCK.sub(lambda match: "\x00" + match[0], text)
    begin = 0
    for end in [*_END.finditer(text), None]:
        piece = text[begin : end.start() if end else None]
        words = " ".join(re.sub(r"</?[a-z][^>]*>|[#|*_]+", " ", piece).split())
        if re.search(r"[A-Za-z]", words):
            lead = len(piece) - len(piece.lstrip())
            yield Sentence(file, first + text.count("\n", 0, begin + lead), words)
        if end:
            begin = end.end()


def messages(file: str, text: str) -> Iterator[Sentence]:
    """The sentences in the strings of a Python file that may reach a user.

    Docstrings count if they are a command's help. Code is left out: strings with several lines, or with `|` or a backslash, and what stands below `\\b` in help.
    """
    tree = ast.parse(text)
    inner = {id(value) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for value in node.values}
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        command = isinstance(node, ast.FunctionDef) and any(
            "click" in ast.unparse(name) for name in node.decorator_list
        )
        if isinstance(node, ast.Module | ast.FunctionDef) and (command or (node is tree and "help=__doc__" in text)):
            words = ast.get_docstring(node) or ""
            words = re.sub(r"\x08.*?(?=\n *\n|$)", lambda match: "\n" * match[0].count("\n"), words, flags=re.DOTALL)
            yield from sentences(file, words, node.body[0].lineno)
        if id(node) in inner or id(node) in silent:
            continue
        if isinstance(node, ast.JoinedStr):
            words = "".join(str(value.value) if isinstance(value, ast.Constant) else "§" for value in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            words = node.value
        else:
            continue
        if " " in words and not re.search(r"\n.*\n|[|\\]", words):
            yield from sentences(file, words, node.lineno)
