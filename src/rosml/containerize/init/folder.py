"""The folder for which `rosml init` writes: what its repository says beside the packages, and the writing itself."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize import lock
from rosml.containerize.init.file_texts import DOCKERFILE, GITLAB

LARGEST = 256 << 10


# ---- What it says ----------------------------------------------------------------------------------------------------


def env(folder: Path) -> tuple[dict[str, str], tuple[str, str] | None]:
    """The variables of its `.env`; none if that is broken, with the problem and its remedy."""
    try:
        return app_inputs.of_file(folder), None
    except RosmlError as error:
        return {}, (error.message, error.remedy)


def locked_base_image(folder: Path, env: Mapping[str, str]) -> str:
    """The base image of its lock file, as that names it; empty if there is none, or one that `rosml containerize` refuses."""
    with contextlib.suppress(RosmlError):
        file = lock.place(folder, env.get("LOCK_FILE") or app_inputs.default("lock-file"), renew=False)
        content = lock.read(file, folder)
        return content.base_image.name if content else ""
    return ""


def hints(folder: Path, environment: Mapping[str, str]) -> Iterator[tuple[frozenset[str], str]]:
    """Words among which may be a ROS distribution, the most telling first, and a clause that says what has them."""
    if sourced := environment.get("ROS_DISTRO", ""):
        yield frozenset([sourced]), f"ROS_DISTRO is {sourced} here"
    head = text_of(folder / ".git/HEAD").strip()
    if branch := head.removeprefix("ref: refs/heads/") if head.startswith("ref: ") else "":
        yield _words(branch), f"git's branch is {branch}"
    workflows = sorted((folder / ".github/workflows").glob("*.y*ml"))
    text = "\n".join(map(text_of, (*workflows, folder / GITLAB, folder / ".travis.yml")))
    yield _words(text), "files for CI name it"
    yield _words(text_of(folder / DOCKERFILE)), f"{DOCKERFILE} names it"


def _words(text: str) -> frozenset[str]:
    words = frozenset(re.findall(r"[a-z0-9]+(?:-[a-z0-9]+)*", text))
    return words | {piece for word in words for piece in word.split("-")}


def ignores_env(folder: Path) -> bool:
    """Whether git leaves out its `.env`, by the usual lines of a `.gitignore`."""
    lines = text_of(folder / ".gitignore").split("\n")
    return not {".env", "/.env", "*.env", ".env*"}.isdisjoint(line.strip() for line in lines)


def text_of(file: Path) -> str:
    """The text of a file of the repository; empty if it cannot be read, or a link is in its place."""
    with contextlib.suppress(RosmlError):
        return (files.regular(file, LARGEST) or b"").decode("utf-8", "replace")
    return ""


# ---- What is written -------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class File:
    """A file to begin with. What `exists` at its path stays; it is the `same` if it is a file with this text."""

    path: str
    text: str
    exists: bool
    same: bool


def compared(folder: Path, texts: Mapping[str, str]) -> list[File]:
    places = {path: folder / path for path in texts}
    exists = {path: os.path.lexists(place) for path, place in places.items()}
    return [
        File(path, text, exists[path], exists[path] and text_of(places[path]) == text) for path, text in texts.items()
    ]


def write(folder: Path, first_files: list[File]) -> None:
    """Writes all files whose place is free, or none. A link may not lead out of the folder."""
    new = {folder / file.path: file.text for file in first_files if not file.exists}
    for file in new:
        if not file.parent.resolve().is_relative_to(folder.resolve()):
            text = f"{file}: cannot be written: a link leads out of {folder}, to {file.parent.resolve()}"
            raise RosmlError(text, "remove the link, then run it again")
    new_folders = [place for file in new for place in reversed(file.parents) if not os.path.lexists(place)]
    try:
        for file in new:
            try:
                file.parent.mkdir(parents=True, exist_ok=True)
            except OSError as error:
                text = f"{files.shown(file)}: cannot be written: {error.strerror}"
                raise RosmlError(text, files.WRITABLE) from None
        files.write_all(new, within=folder)
    except BaseException:
        for place in reversed(new_folders):
            with contextlib.suppress(OSError):
                place.rmdir()
        raise
