#!/usr/bin/env python3
"""Makes a site of the documentation, and fails if a link leads nowhere."""

from __future__ import annotations

import html
import json
import posixpath
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src"))

import rosml.base.environment  # noqa: F401 (first: says what to do if the others are missing)

# isort: split

import click

from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.project_addresses import addresses
from rosml.cli import command

CONFIG = "mkdocs.yml"
BESIDE = ("README.md", "CHANGELOG.md", "SECURITY.md", "CONTRIBUTING.md")
"""Pages outside of docs/, because forges expect them elsewhere."""

_LINK = re.compile(r"(?<=\]\()[^)\s#]+")


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--output",
    type=click.Path(path_type=Path, file_okay=False),
    default=ROOT / ".state/docs",
    help="Where to make it; .state/docs if left out. The site is in its folder site.",
)
def main(output: Path) -> None:
    """Makes a site of the pages in docs/ and of README.md, CHANGELOG.md, SECURITY.md and CONTRIBUTING.md. It needs no server.

    \b
    Examples:
      uv run scripts/docs.py                  into .state/docs/site (make docs)
      uv run scripts/docs.py --output /tmp/x  into /tmp/x/site
    """
    stage(ROOT, output)
    build(output)
    click.echo(files.shown(output / "site/index.html"))


def build(folder: Path) -> None:
    """Builds the site of a staged folder. It fails if a link or an anchor leads nowhere, or a page is not in the navigation."""
    argv = [sys.executable, "-m", "zensical", "build", "--strict", "--clean", "--config-file", CONFIG]
    done = subprocess.run(argv, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    messages = f"{done.stdout}{done.stderr}".partition("Traceback (most recent call last)")[0].strip()
    if done.returncode or not (folder / "site/index.html").is_file():
        raise RosmlError(f"the site cannot be built:\n{messages}", "correct the named place; the pages are in docs/")


def footer(project_addresses: dict[str, str]) -> str:
    """Where to report a problem, below every page: the project's addresses, by name."""
    links = [f'<a href="{html.escape(address)}">{html.escape(name)}</a>' for name, address in project_addresses.items()]
    return " · ".join(links) or "Report a problem, or ask, in the repository that these pages are from."


def stage(root: Path, folder: Path) -> None:
    """Copies every page, and every file of the repository to which a page links, to the same place below the folder `docs`.

    So a page may link to a file that is no page, as on a forge.
    """
    shutil.rmtree(folder / "docs", ignore_errors=True)
    (folder / "docs").mkdir(parents=True)
    config = (root / CONFIG).read_text(encoding="utf-8")
    (folder / CONFIG).write_text(f"{config}copyright: {json.dumps(footer(addresses()))}\n", encoding="utf-8")
    waiting = [str(file.relative_to(root)) for file in (root / "docs").rglob("*") if file.is_file()] + [*BESIDE]
    done = set()
    while waiting:
        source = waiting.pop()
        if source in done or not (root / source).is_file():
            continue
        done.add(source)
        place = folder / "docs" / source
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / source, place)
        if source.endswith(".md"):
            links = _LINK.findall(place.read_text(encoding="utf-8"))
            waiting += [posixpath.normpath(posixpath.join(posixpath.dirname(source), link)) for link in links]


if __name__ == "__main__":
    sys.exit(command.run(main))
