"""JSON and YAML from outside: what is read, and what is refused before it harms anybody."""

from __future__ import annotations

import json

import pytest
import yaml

from rosml.base import untrusted
from rosml.base.errors import RosmlError


def test_json_is_read() -> None:
    value = {"a": [1, -1.5, None, True, "é\U0001f916"], "b": 2**64 - 1}
    assert untrusted.json_value(json.dumps(value).encode("utf-8-sig")) == value
    assert untrusted.json_value(json.dumps(value)) == value
    deepest = "[" * untrusted.DEPTH + "]" * untrusted.DEPTH
    assert json.dumps(untrusted.json_value(deepest)) == deepest
    assert untrusted.json_values(' {"a": 1}\n"b" 3') == [{"a": 1}, "b", 3]
    assert untrusted.json_values(" \n") == []


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (b"", "Expecting value"),
        (b"{} {}", "something follows its value"),
        (b"\xff", r"it is not UTF-8 \(byte 0xff\)"),
        (b"[" * 1_000_000, "it is nested more than 100 levels deep"),
        (b"1" * 5_000, "it has a number of 5000 digits"),
        (b"1e999", "it has a number that is too large"),
        (b"[NaN]", "it has NaN"),
        (b'{"a": 1, "a": 2}', "a key is there twice"),
        (b'"\\ud800"', "it has half of a surrogate pair"),
        (b'"' + b"x" * 1_000 + b'"', "it has more than 1,000 bytes"),
    ],
)
def test_json_that_would_harm_is_refused(text: bytes, why: str) -> None:
    limit = 1_000 if b"xxx" in text else untrusted.SIZE
    with pytest.raises(ValueError, match=f"^{why}"):
        untrusted.json_value(text, limit)


def test_yaml_is_read() -> None:
    text = "a: &a [1, 2026-11-22, yes]\nb: {c: *a, <<: {d: é}}\n"
    assert untrusted.yaml_of(text.encode("utf-8-sig"), "it") == yaml.safe_load(text)
    assert untrusted.yaml_of(b"", "it") is None


BOMB = "a0: &a0 [x]\n" + "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 9))
CHAIN = "a0: &a0 [x]\n" + "".join(f"a{n}: &a{n} [*a{n - 1}]\n" for n in range(1, 200))


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[" * 40_000, "line 1: nested more than 100 levels deep"),
        (CHAIN, "line 100: nested more than 100 levels deep"),
        (BOMB, "line 7: its aliases make too much of it"),
        ("a: &a [*a]", "line 1: the alias a leads nowhere, or into itself"),
        ("a: [", "line 2: did not find"),
        ("a: 0x_", "invalid literal"),
        ("a: !!timestamp x", "a value is none of its type"),
        ("a: " + "1" * 5_000, "line 1: a number is too long"),
        ("? [a]\n: b", "line 1: found unhashable key"),
        ("a: \x00", "it has a character that YAML does not allow"),
    ],
)
def test_yaml_that_would_harm_is_refused(text: str, why: str) -> None:
    with pytest.raises(RosmlError, match=f"^the list is no YAML: {why}") as caught:
        untrusted.yaml_of(text.encode(), "the list", remedy="take another")
    assert (caught.value.remedy, caught.value.exit_code) == ("take another", 1)
