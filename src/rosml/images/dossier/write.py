"""Writes a dossier: a folder, or a ZIP file with the same files."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.dossier import page
from rosml.images.dossier.gather import Dossier

FACTS = "dossier.json"
"""What the dossier says, for programs. A folder with this file is one that a dossier may replace."""

PAGE = "index.html"

NAMES = (
    *("sbom.cdx.json", "sbom.spdx.json", "vex.openvex.json", "scan.json", "licences.txt", "licence-texts.txt"),
    "containerize.lock",
    *("provenance.json", *(f"provenance-{number}.json" for number in range(2, 33)), FACTS, PAGE),
)
"""All names of files that a dossier may have."""


def contents(dossier: Dossier) -> dict[str, str]:
    """The files by name."""
    facts = json.dumps(dossier.to_json(), indent=2, ensure_ascii=False) + "\n"
    whole = {**dossier.files, FACTS: facts}
    return {**whole, PAGE: page.render(dossier, [*whole, PAGE])}


def write(dossier: Dossier, output: Path) -> list[Path]:
    """Writes the dossier; gives its files, the page last. RosmlError if there is something else in the folder."""
    every = contents(dossier)
    if output.suffix == ".zip":
        _zip(output, every)
        return [output]
    require_free(output)
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RosmlError(f"{files.shown(output)}: {error.strerror}", files.WRITABLE) from None
    files.write_all({output / name: content for name, content in every.items()}, within=output)
    for name in NAMES:
        if name not in every:  # of a dossier that was there before
            (output / name).unlink(missing_ok=True)
    return [output / name for name in every]


def require_free(output: Path) -> None:
    """Checks that a folder is not there, is empty or has a dossier; of a ZIP file, that it is no folder."""
    if output.suffix == ".zip":
        if output.is_dir():
            raise RosmlError(f"{files.shown(output)} is a folder", "name a file, or another folder", exit_code=2)
    elif output.exists() and not output.is_dir():
        text = f"{files.shown(output)} is a file, and a folder is needed"
        raise RosmlError(text, "name a folder, or a file that ends in .zip", exit_code=2)
    elif output.is_dir() and any(output.iterdir()) and not (output / FACTS).is_file():
        text = f"{files.shown(output)} has other files than those of a dossier"
        raise RosmlError(text, "name a folder that is empty, or not there", exit_code=2)


def _zip(output: Path, every: dict[str, str]) -> None:
    """The same dossier gives the same bytes: entries have the first time that ZIP knows."""
    with files.whole(output) as stream, zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(every):
            archive.writestr(zipfile.ZipInfo(f"{output.stem}/{name}"), every[name], zipfile.ZIP_DEFLATED)
