"""Compares the checkout with an earlier revision, read from git."""

from __future__ import annotations

import io
import os
import tarfile
import tempfile
from dataclasses import replace
from pathlib import Path

from rosml import matrix_of
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.images.bake.diff import Difference, between
from rosml.images.bake.inputs import Inputs
from rosml.images.image_set import load, locked
from rosml.images.image_set import model as sets
from rosml.images.matrix import extends
from rosml.machine import git


def since(version: str, now: Inputs) -> Difference:
    """The difference from a git revision; or from another matrix file, with all other files of this checkout."""
    if os.path.isfile(version):
        return between(Inputs(now.root, load.load(Path(version))), now)
    with tempfile.TemporaryDirectory() as folder:
        _unpack(version, now.root, Path(folder))
        return between(Inputs(Path(folder), _image_set(version, Path(folder))), now)


def _image_set(revision: str, folder: Path) -> sets.ImageSet:
    if not (base := folder / "matrix.yaml").is_file():
        raise RosmlError(f"revision {revision} has no matrix.yaml", remedy="name a later one", exit_code=2)
    try:
        file = matrix_of(folder)
        document = extends.read(file, base)
        document = replace(document, name=f"{revision}:{file.name}")
        return locked.with_environments(load.image_set(document), folder)
    except InputError as error:
        reason = f"this version of the project does not understand the matrix of revision {revision}:\n{error.message}"
        raise RosmlError(reason, remedy="compare with a later revision", exit_code=2) from None


def _unpack(revision: str, root: Path, folder: Path) -> None:
    commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if not commit:
        remedy = "see the revisions with: git log --oneline --all (a shallow clone lacks most: git fetch --unshallow)"
        raise RosmlError(f"no revision and no file named {revision!r}", remedy=remedy, exit_code=2)
    content = _git(root, "archive", "--format=tar", commit.decode().strip())
    try:
        with tarfile.open(fileobj=io.BytesIO(content)) as archive:
            archive.extraction_filter = getattr(tarfile, "data_filter", lambda member, path: member)
            archive.extractall(folder)
    except tarfile.TarError as error:
        raise RosmlError(f"revision {revision} cannot be unpacked: {error}", "compare with another one") from None


def _git(root: Path, *arguments: str) -> bytes:
    try:
        return git.ask(root, *arguments)
    except RosmlError as error:
        raise RosmlError(error.message, f"{error.remedy}, or name another matrix file") from None
