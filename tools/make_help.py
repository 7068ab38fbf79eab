"""What `make` prints: its commands in groups, with an example each; and for a command or a variable that there is not,
which was meant.

Needs nothing but Python 3.9, since it is the first thing that a newcomer calls."""

from __future__ import annotations

import difflib
import os
import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

MAKEFILE = Path(__file__).resolve().parent.parent / "Makefile"

GROUPS = {
    "Images": ("image", "list", "explain"),
    "Change": ("generate", "locks", "diff", "plan", "docs"),
    "Check": ("lint", "unit", "test", "test-all", "page", "test-scanner", "test-signer", "bench"),
    "Publish": ("publish", "standing", "catalogue"),
    "This machine": ("up", "client", "status", "down", "clean", "emulation", "scanner", "signer", "room"),
}
REST = "More"
"""The group of what is in no other."""


OF_MAKE = ("TARGET_ARCH", "TARGET_MACH")
"""Variables of make's own rules that are near one of ours."""


def commands(text: str) -> dict[str, tuple[str, str]]:
    """Every command that people are told of, with what it does and an example, which may be empty."""
    found = {}
    for name, words in re.findall(r"^([a-z0-9-]+):.*?## (.*)$", text, re.MULTILINE):
        what, colon, example = words.partition(": make ")
        found[name] = (what, f"make {example}" if colon else "")
    return found


def grouped(found: dict[str, tuple[str, str]]) -> dict[str, list[str]]:
    """The commands by group; those of no group last."""
    groups = {title: [name for name in names if name in found] for title, names in GROUPS.items()}
    known = {name for names in groups.values() for name in names}
    return {**groups, REST: [name for name in found if name not in known]}


def lines(found: dict[str, tuple[str, str]], colour: bool) -> Iterator[str]:
    """What `make` prints."""
    bold, dim, end = ("\x1b[1m", "\x1b[2m", "\x1b[0m") if colour else ("", "", "")
    for title, names in grouped(found).items():
        if not names:
            continue
        yield f"{bold}{title}{end}"
        for name in names:
            what, example = found[name]
            yield f"  make {name:<12} {what}"
            if example:
                yield f"{'':<20}{dim}{example}{end}"


def unknown(name: str, found: dict[str, tuple[str, str]], given: Iterable[str] = ()) -> str:
    """What to say of a command that there is not.

    Args:
        given: all words of the call. One of them may be a command whose example begins with a variable: that of the name.
    """
    near = [f"make {other}" for other in difflib.get_close_matches(name, found, n=3, cutoff=0.5)]
    examples = [found[word][1] for word in given if word in found]
    if not near:
        near = [f"{match[0]}{name}" for text in examples if (match := re.match(r"make [a-z-]+ (TARGET|GROUP)=", text))]
    guess = f"; did you mean {' or '.join(near)}?" if near else ""
    return f"error: make has no command '{name}'{guess}\nremedy: see all with: make"


def variables(text: str) -> tuple[set[str], set[str]]:
    """The variables that are for people: with a default that they may change, or asked for in a recipe; and all names that
    the Makefile has."""
    ours = set(re.findall(r"^([A-Z_]+) (?:\?=|:=$)|\$\(if \$\(([A-Z_]+)\)", text, re.MULTILINE))
    names = {name for pair in ours for name in pair if name}
    return names, names | set(re.findall(r"\b[A-Z][A-Z_]+\b", text))


def mistyped(name: str, text: str) -> str:
    """What to say of a variable that is nearly one of ours; nothing of any other one: make has many of its own."""
    ours, known = variables(text)
    if name in known or name in OF_MAKE:
        return ""
    near = difflib.get_close_matches(name.upper(), sorted(ours), n=3, cutoff=0.7)
    if not near:
        return ""
    guess = " or ".join(f"{other}=" for other in near)
    return (
        f"error: make has no variable '{name}'; did you mean {guess}?\nremedy: see commands with their variables: make"
    )


def coloured(stream_is_terminal: bool) -> bool:
    """Whether to colour: on a terminal that can, unless somebody does not want it (https://no-color.org)."""
    return stream_is_terminal and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def main(arguments: list[str]) -> int:
    """Prints the list; or says which commands, or variables, are mistyped, and gives 2."""
    text = MAKEFILE.read_text(encoding="utf-8")
    if arguments[:1] == ["--variables"]:
        said = [line for name in arguments[1:] if (line := mistyped(name, text))]
        print("\n".join(said), file=sys.stderr, end="\n" if said else "")
        return 2 if said else 0
    found = commands(text)
    if arguments[:1] == ["--commands"]:
        said = [unknown(name, found, arguments) for name in arguments[1:] if name not in found]
        print("\n".join(said), file=sys.stderr, end="\n" if said else "")
        return 2 if said else 0
    print("\n".join(lines(found, coloured(sys.stdout.isatty()))))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
