"""The Dockerfile as data: its stages, the base of each, and the files that it takes from the checkout."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass

from rosml.base import untrusted

_FROM = re.compile(r"FROM\s+(?:--\S+\s+)*(?P<base>\S+)(?:\s+AS\s+(?P<name>\S+))?")
_COMMENT = re.compile(r"\s*#(?!\s*(?:syntax|escape)\s*=)")
"""A comment, but for the directives at a Dockerfile's top."""


@dataclass(frozen=True)
class Stage:
    """A stage. Values may have `${ARGUMENTS}`, as written."""

    digest: str  # of its instructions, without comments and blank lines
    stages: tuple[str, ...]  # its base (the first one), and stages, contexts and images from which it takes files
    sources: tuple[str, ...]  # files and folders of the checkout that it copies or mounts
    defaults: dict[str, str]  # of its arguments that have one


def parse(text: str) -> dict[str, Stage]:
    """The stages by name. The lines before the first one are the stage "", whose arguments apply to all."""
    head, *sections = re.split(r"^(?=FROM\s)", text, flags=re.MULTILINE)
    stages = {"": _stage(head, ())}
    for number, section in enumerate(sections):
        match = _FROM.match(section)
        if match:
            stages[match["name"] or str(number)] = _stage(section, (match["base"],))
    return stages


def _stage(text: str, base: tuple[str, ...]) -> Stage:
    lines = [line.rstrip() for line in text.splitlines() if line.strip() and not _COMMENT.match(line)]
    # In a here-document such lines are content.
    decisive = text if "<<" in text else "\n".join(lines)
    instructions = "\n".join(lines).replace("\\\n", " ").splitlines()
    inputs = [item for instruction in instructions for item in _instruction(instruction)]
    return Stage(
        hashlib.sha256(decisive.encode()).hexdigest(),
        base + tuple(value for kind, value in inputs if kind == "stage"),
        tuple(value for kind, value in inputs if kind == "source"),
        {name: default for kind, value in inputs if kind == "default" for name, default in [value.split("=", 1)]},
    )


def _instruction(text: str) -> Iterator[tuple[str, str]]:
    """The stages, sources and defaults of arguments that an instruction uses."""
    word, _, rest = text.strip().partition(" ")
    words = rest.split()
    flags = [flag.removeprefix("--").partition("=")[::2] for flag in words if flag.startswith("--")]
    if word.upper() == "ARG":
        yield from (("default", item.replace('"', "")) for item in words if "=" in item)
    elif word.upper() == "RUN":
        for options in (
            dict(item.partition("=")[::2] for item in value.split(",")) for key, value in flags if key == "mount"
        ):
            if "from" in options:
                yield "stage", options["from"]
            elif options.get("type", "bind") == "bind":
                yield "source", options.get("source", options.get("src", "."))
    elif word.upper() in ("COPY", "ADD"):
        copied = dict(flags)
        paths = [item for item in words if not item.startswith("--")]
        if paths and paths[0].startswith("["):
            paths = untrusted.json_value(" ".join(paths))
        if "from" in copied:
            yield "stage", copied["from"]
        else:
            yield from (("source", path) for path in paths[:-1])
