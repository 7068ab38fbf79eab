"""YAML that every reader reads alike: of compose, of Kubernetes, of version 1.1 and of 1.2."""

from __future__ import annotations

import re
from typing import Any

import yaml

PLAIN = re.compile(r"[A-Za-z_/][A-Za-z0-9_/.@:-]*|\./[A-Za-z0-9_/.:-]*|\.")
"""Texts without quotes. Others get them, such as `1e3`, which is a number in YAML 1.2."""

WORDS = re.compile("y|n|yes|no|on|off|true|false|null|nan|inf", re.IGNORECASE)
"""Words that are no texts to some reader: `y` is a switch in Kubernetes."""


def text(content: Any) -> str:
    """The text of dictionaries, lists, texts, numbers and switches. It has no anchors."""
    return yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1_000_000)


class _Dumper(yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        return True


def _quoted(dumper: yaml.SafeDumper, text: str) -> yaml.Node:
    plain = PLAIN.fullmatch(text) and not WORDS.fullmatch(text)
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=None if plain else '"')


_Dumper.add_representer(str, _quoted)


def nested(path: str, value: Any) -> dict[str, Any]:
    """`a.b` and its content, as `{a: {b: …}}`."""
    first, _, rest = path.partition(".")
    return {first: nested(rest, value) if rest else value}


def merged(first: Any, second: Any) -> Any:
    """Both; of two texts, numbers or switches the second one."""
    if isinstance(first, dict) and isinstance(second, dict):
        both = {key: merged(first[key], second[key]) for key in first if key in second}
        return {**first, **second, **both}
    if isinstance(first, list) and isinstance(second, list):
        return [*first, *(item for item in second if item not in first)]
    return second
