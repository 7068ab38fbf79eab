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
    """The text of a content: dictionaries, lists, texts, numbers, switches. It has no anchors."""
    return yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1_000_000)


class _Dumper(yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        return True


def _quoted(dumper: yaml.SafeDumper, found: str) -> yaml.Node:
    plain = PLAIN.fullmatch(found) and not WORDS.fullmatch(found)
    return dumper.represent_scalar("tag:yaml.org,2002:str", found, style=None if plain else '"')


_Dumper.add_representer(str, _quoted)
