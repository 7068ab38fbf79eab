"""Commands in the words of who is told: messages say `make locks`, and the command `rosml` says `rosml locks` for it."""

from __future__ import annotations

import os
import re
from typing import Final

from rosml.base.environment import program

CALLED: Final = "ROSML_CALLED"
"""Set to `rosml` where the command became another program, which has another name."""

_VALUE = r"('[^']*'|\"[^\"]*\"|[^\s;,)']+)"

_WORDS = (
    (rf"\bmake explain TARGET={_VALUE}", r"rosml explain \1"),
    (rf"\bmake image TARGET={_VALUE}", r"rosml image \1"),
    (rf"\bmake list GROUP={_VALUE}", r"rosml list \1"),
    (rf"\bmake diff REV={_VALUE}", r"rosml diff \1"),
    (rf"\bmake plan SHARDS={_VALUE}", r"rosml generate --shards \1"),
    (r"\bmake locks UPGRADE=1", "rosml locks --upgrade"),
    (r"\bmake (client|down|clean|scanner|signer)\b", r"rosml setup \1"),
    (r"\bmake up\b", "rosml setup"),
    (r"\bmake emulation\b", "rosml setup emulate"),
    (r"\bmake machine\b", "rosml setup status"),
    (r"\bmake publish\b", "rosml publish all"),
    (r"\bmake (list|locks|generate|status|catalogue|image)\b", r"rosml \1"),
    (r"(\buv run )?(\bscripts/)?\bpublish\.py (image|part|plan|status)\b", r"rosml \3"),
    (r"(\buv run )?(\bscripts/)?\bpublish\.py ([a-z]+)\b", r"rosml publish \3"),
)
"""What `make` and the scripts call something, and `rosml` calls it; docs/use.md has the same as a table."""


def in_words(text: str) -> str:
    """A text for people in the words of the command that they called."""
    if program() == "rosml" or os.environ.get(CALLED) == "rosml":
        for pattern, word in _WORDS:
            text = re.sub(pattern, word, text)
    return text
