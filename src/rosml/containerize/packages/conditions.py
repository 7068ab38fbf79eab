"""Conditions in package.xml, such as `$ROS_VERSION == 2 and $ROS_DISTRO != foxy`: https://ros.org/reps/rep-0149.html."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping

_TOKEN = re.compile(r"""\s*(==|!=|<=|>=|<|>|\(|\)|"[^"]*"|'[^']*'|\$?[\w.-]+)\s*""")

_COMPARED: Mapping[str, Callable[[str, str], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}

MOST = 1_000
"""The most characters of a condition."""


def holds(text: str, variables: Mapping[str, str]) -> bool:
    """Whether a condition holds. An empty one does, and a broken one: the build says what is wrong with it.

    Args:
        variables: values of ROS_VERSION and ROS_DISTRO; others are empty.
    """
    if not text.strip():
        return True
    try:
        tokens = _tokens(text)
        found = _either(tokens, variables)
        return found if not tokens else True
    except (LookupError, RecursionError, ValueError):
        return True


def _tokens(text: str) -> list[str]:
    """The tokens, the last one first. ValueError: the text has something else."""
    found, place = list[str](), 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None or len(text) > MOST:
            raise ValueError(text)
        found.append(token[1])
        place = token.end()
    return found[::-1]


def _either(tokens: list[str], variables: Mapping[str, str]) -> bool:
    found = _both(tokens, variables)
    while tokens and tokens[-1] == "or":
        tokens.pop()
        found = _both(tokens, variables) or found
    return found


def _both(tokens: list[str], variables: Mapping[str, str]) -> bool:
    found = _one(tokens, variables)
    while tokens and tokens[-1] == "and":
        tokens.pop()
        found = _one(tokens, variables) and found
    return found


def _one(tokens: list[str], variables: Mapping[str, str]) -> bool:
    first = tokens.pop()
    if first == "(":
        found = _either(tokens, variables)
        if tokens.pop() != ")":
            raise ValueError(first)
        return found
    compared = _COMPARED[tokens.pop()]
    return compared(_value(first, variables), _value(tokens.pop(), variables))


def _value(token: str, variables: Mapping[str, str]) -> str:
    return variables.get(token[1:], "") if token.startswith("$") else token.strip("\"'")
