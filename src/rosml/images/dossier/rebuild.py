"""How an image is made again: its lock, and the commands, as far as its labels say."""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass

from rosml.images.image_set.labels import (
    APP,
    BASE_DIGEST,
    BASE_NAME,
    ENVIRONMENT,
    ENVIRONMENTS,
    PREFIX,
    REVISION,
    SOURCE,
    TITLE,
)
from rosml.images.matrix.names import environments_end

DISTRIBUTION = f"{PREFIX}distribution"

LOCK_FILE = "containerize.lock"

_WORD = re.compile(r"[A-Za-z0-9][\w.:/@+-]{0,300}")


@dataclass(frozen=True)
class Rebuild:
    """Commands, and what they need besides."""

    commands: tuple[str, ...]
    notes: tuple[str, ...]


def is_ours(labels: Mapping[str, str]) -> bool:
    """Whether labels look like those of an image that rosml made."""
    return any(labels.get(name) for name in (APP, DISTRIBUTION, ENVIRONMENT))


def of(labels: Mapping[str, str], has_lock: bool, commit: str = "") -> Rebuild:
    """The labels are a stranger's words: one that is no word of a command is left out. `commit` is by the provenance, if they have none."""
    title, source = (_word(labels.get(name, "")) for name in (TITLE, SOURCE))
    revision = _word(labels.get(REVISION) or commit)
    commands = [f"git clone {source} ."] if source.startswith("https://") else []
    notes = ["archives drop old packages: then a build stops, or takes newer ones"]
    commands += [f"git checkout {revision}"] if revision else []
    if not revision:
        notes.insert(0, "the image does not say of which commit it is")
    if labels.get(APP):
        name, digest = _word(labels.get(BASE_NAME, "")), _word(labels.get(BASE_DIGEST, ""))
        base = f" --base-image {name.partition('@')[0]}@{digest}" if name and digest else ""
        commands.append(f"rosml containerize{base}{f' --lock-file {LOCK_FILE}' if has_lock else ''}")
        notes.insert(0, "with the inputs of the first build: they are in the repository's CI file")
    elif environment := _word(labels.get(ENVIRONMENT, "")):
        commands.append(f"./rosml env build {environment}")
        notes = ["with its locks, which are in the folder environments"]
    elif title:
        names = [name for name in map(_word, labels.get(ENVIRONMENTS, "").split()) if name]
        commands.append(f"./rosml image {title.removesuffix(environments_end(names))}")
        if environments := " ".join(f"env:{name}" for name in names):
            notes.insert(0, f"its environments come afterwards: rosml join IMAGE {environments} --tag REFERENCE")
    return Rebuild(tuple(commands), tuple(notes))


def _word(text: str) -> str:
    return shlex.quote(text) if _WORD.fullmatch(text) else ""
