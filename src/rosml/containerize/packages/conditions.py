"""Conditions in package.xml, such as `$ROS_VERSION == 2 and $ROS_DISTRO != foxy`: https://ros.org/reps/rep-0149.html."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping

_TOKEN = re.compile(r"""\s*(==|!=|<=|>=|<|>|\(|\)|"[^"]*"|'[^']*'|\$?[\w.-]+)\s*""")

_COMPARISONS: Mapping[str, Callable[[str, str], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}

LONGEST = 1_000  # characters


def holds(text: str, variables: Mapping[str, str]) -> bool:
    """Whether a condition holds. An empty one does, and a broken one: the build says what is wrong with it. Variables without a value
    in `variables` are empty."""
    if len(text) > LONGEST or _TOKEN.sub("", text):
        return True
    tokens = _TOKEN.findall(text)[::-1]  # the last one first
    try:
        return _joined(tokens, variables) or bool(tokens)
    except (LookupError, RecursionError, ValueError):
        return True


def _joined(tokens: list[str], variables: Mapping[str, str], words: tuple[str, ...] = ("or", "and")) -> bool:
    """The value of what stands between these words, of which the later bind stronger."""
    if not words:
        return _comparison(tokens, variables)
    values = [_joined(tokens, variables, words[1:])]
    while tokens and tokens[-1] == words[0]:
        tokens.pop()
        values.append(_joined(tokens, variables, words[1:]))
    return any(values) if words[0] == "or" else all(values)


def _comparison(tokens: list[str], variables: Mapping[str, str]) -> bool:
    first = tokens.pop()
    if first == "(":
        value = _joined(tokens, variables)
        if tokens.pop() != ")":
            raise ValueError(first)
        return value
    compare = _COMPARISONS[tokens.pop()]
    return compare(_text(first, variables), _text(tokens.pop(), variables))


def _text(token: str, variables: Mapping[str, str]) -> str:
    return variables.get(token[1:], "") if token.startswith("$") else token.strip("\"'")
