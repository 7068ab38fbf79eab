"""What `rosml dev` keeps: a folder with what is built, and a record of the inputs of its image."""

from __future__ import annotations

import hashlib
import json
import os
import re
import tempfile
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from pydantic import ConfigDict, ValidationError

from rosml import __version__
from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.containerize import inputs as app_inputs
from rosml.containerize import lock
from rosml.containerize.build import bake_file, stage_cache
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.inputs import Values
from rosml.containerize.packages import workspace
from rosml.containerize.sources import repos_file

KEPT = ".rosml/dev"
"""The folder with what is built, in that of the packages. In a container it is the workspace."""

MARKS = ("COLCON_IGNORE", "CATKIN_IGNORE")

POINTS = ("src/target", "src/upstream")
"""The folders of the workspace on which sources are mounted. Without them, the engine would make them, for root."""

_FIXED: dict[str, Any] = {
    "platform": "",
    "push": False,
    "target": "dev",
    "enable_push_as_latest": False,
    "enable_slim": False,
    "image_tag": "latest",
    "dev_image_name": "",
    "dev_image_tag": "",
    "command": "",
    "downstream_workspace": "",
    "tests": False,
}

UNUSED = {
    name.replace("_", "-") for name in (*_FIXED, "image_name", "slim_base_image", "slim_image_name", "slim_image_tag")
}
"""Inputs of `rosml containerize` that say nothing of the image."""


class ImageRecord(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")

    key: str  # the digest of its inputs
    image: str  # its name, as in `ShellImage`
    id: str  # in the engine
    upstream: str  # the folder with the imported repositories; empty if there are none


def image_name(folder: Path) -> str:
    slug = re.sub("[^a-z0-9]+", "-", folder.name.lower()).strip("-") or "workspace"
    return f"rosml-dev/{slug[:40].strip('-')}-{hashlib.sha256(os.fsencode(folder)).hexdigest()[:8]}"


def image_values(values: Values, folder: Path) -> Values:
    """The inputs of the image, from those of `rosml containerize`: it is for this machine alone, and has no app."""
    return replace(values, **_FIXED, image_name=image_name(folder))


def record_file(folder: Path, state: Path) -> Path:
    """It is not in the folder: that may be a stranger's, and the record names an image to start."""
    return state / "desk" / f"{image_name(folder).rpartition('/')[2]}.json"


def read_record(file: Path) -> ImageRecord | None:
    """The record in a file; None if there is none, or if another release of rosml wrote it."""
    try:
        return ImageRecord.model_validate(untrusted.json_value(file.read_bytes()))
    except (OSError, ValueError, ValidationError):
        return None


def write_record(file: Path, record: ImageRecord) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    files.write(file, record.model_dump_json() + "\n")


def inputs_digest(folder: Path, values: Values) -> str:
    """The digest of all inputs of the image on this machine. The base image and upstream branches are looked up only if it is made."""
    paths = [*workspace.manifests(folder, ignored=IgnoredFiles(folder))]
    paths += repos_file.find(folder) if values.enable_recursive_vcs_import else [folder / values.vcs_import_file]
    paths.append(lock.place(folder, values.lock_file, renew=False))
    secret = {name.replace("-", "_") for name in app_inputs.SECRET}
    facts: list[object] = [__version__, sorted(item for item in asdict(values).items() if item[0] not in secret)]
    for path in paths:
        content = files.regular(path, workspace.LARGEST_TEXT) or b""
        facts.append([os.path.relpath(path, folder), hashlib.sha256(content).hexdigest()])
    with tempfile.TemporaryDirectory() as scratch:
        requests = Path(scratch, "requests")
        workspace.write_requests(values, folder, Path(scratch, "none"), {}, requests)
        facts.append(stage_cache.tree(requests))
    for path in workspace.additional_files(values.additional_files_dir, folder):
        facts.append([path.name, stage_cache.tree(path)])
    scripts = [bake_file.SCRIPTS / part for part in ("containerize", "build", "ros")]
    facts += [stage_cache.tree(folder, {"__pycache__"}) for folder in scripts]
    return hashlib.sha256(json.dumps(facts).encode("utf-8", "surrogateescape")).hexdigest()


def require_owner(folder: Path, uid: int) -> None:
    """Checks that a user can keep files in a folder, and that these will be theirs."""
    owner = folder.stat().st_uid
    if uid == 0 and owner != 0:
        text = f"{folder} belongs to the user {owner}, and you are root: what is built there would be root's"
        raise RosmlError(text, "call it as that user, without sudo", exit_code=2)
    if not os.access(folder, os.W_OK | os.X_OK):
        text = f"{folder} belongs to the user {owner}, and you cannot write there"
        raise RosmlError(text, "copy it to a folder of yours, or let its owner give it to you", exit_code=2)
    for path in _kept_folders(folder):
        if path.is_symlink() or (path.exists() and not path.is_dir()):
            raise RosmlError(f"{path} is no folder, and rosml dev keeps files there", "move it away", exit_code=2)
        if path.exists() and path.stat().st_uid != uid:
            text = f"{path} belongs to the user {path.stat().st_uid}, and builds run as you"
            raise RosmlError(text, f"remove it: sudo rm -rf '{folder / KEPT}'", exit_code=2)


def _kept_folders(folder: Path) -> list[Path]:
    """The folders that rosml makes itself, from the outermost on."""
    return [(folder / KEPT).parent, folder / KEPT, *(folder / KEPT / place for place in ("src", *POINTS))]


def make(folder: Path) -> None:
    """Makes the folder for what is built. git and builds leave it out."""
    for path in _kept_folders(folder):
        path.mkdir(exist_ok=True)
    kept = folder / KEPT
    for mark in MARKS:
        if not (kept / mark).is_file() or (kept / mark).is_symlink():
            files.write(kept / mark, "", within=folder)
    files.write(kept / ".gitignore", "*\n", within=folder)
