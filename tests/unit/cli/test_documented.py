"""Commands that the documentation shows are ones that there are, with options that they have; scripts that it shows work."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
from itertools import pairwise
from pathlib import Path

import click
import pytest
from conftest import ROOT

from bench import cli as bench
from fakes.workflows import accepted
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.images import generate
from rosml.images.image_set import own_set
from rosml.images.image_set.explain import explained
from rosml.images.image_set.model import ImageSet
from tests.pages import SHELLS, blocks, commands, pages

SCRIPTS = {"bench": bench.main, "scripts/generate_bake.py": generate.main}
MAKEFILE = (ROOT / "Makefile").read_text()
EXTEND = "docs/extend"
"""How the pages begin whose examples are not in our own matrix; test_extend.py follows them."""

SHOWN = sorted(
    {
        (command, block.page)
        for page in pages()
        for block in blocks(page)
        if block.language in SHELLS
        for command in commands(block)
    }
)


# ---- Commands --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("page", sorted({page for _, page in SHOWN}))
def test_parsers_accept_what_a_page_shows(page: str, real: ImageSet) -> None:
    wrong = []
    for command in (command for command, where in SHOWN if where == page):
        try:
            parsed(command, real, page)
        except (AssertionError, LookupError, RosmlError, ValueError, click.UsageError) as error:
            wrong.append(f"{command}: {error}")
    assert wrong == []


def parsed(command: str, image_set: ImageSet, page: str) -> None:
    argv = [word for word in shlex.split(command) if "…" not in word]
    while argv and re.match(r"[A-Z_]+=", argv[0]):
        argv = argv[1:]
    if argv[:1] == ["make"]:
        check_make(argv[1:], image_set if not page.startswith(EXTEND) else None)
    elif argv[:1] in (["rosml"], ["./rosml"]):
        if "--help" not in argv:
            accepted(main.cli, argv[1:])
            if argv[1] in ("image", "explain") and not page.startswith(EXTEND) and "--addons" not in argv:
                explained(image_set, next(word for word in argv[2:] if not word.startswith("-")), {})
    elif argv[:3] == ["uv", "run", "python"]:
        if argv[4] in SCRIPTS:
            accepted(SCRIPTS[argv[4]], argv[5:])
    elif argv[:2] == ["uv", "run"] and argv[2] in SCRIPTS and argv[3:] != ["--help"]:
        accepted(SCRIPTS[argv[2]], argv[3:])


@pytest.mark.parametrize("page", sorted({page for _, page in SHOWN}))
def test_base_images_that_a_page_shows_are_called_like_that(page: str, real: ImageSet) -> None:
    """Outside of a checkout, a name without a registry would be one of Docker Hub."""
    wrong = []
    for command in (command for command, where in SHOWN if where == page):
        argv = shlex.split(command)
        names = [value for option, value in pairwise(argv) if option in ("--base-image", "--base") and ":" in value]
        for name in names if argv[0] in ("rosml", "./rosml") else []:
            _, slash, tag = name.partition("@")[0].rpartition("/")
            ours = re.match(r"ros(-[a-z]+)?:", tag)
            if (ours and not real.by_tag(tag)) or not (slash or argv[0] == "./rosml"):
                wrong.append(command)
    assert wrong == []


def check_make(words: list[str], image_set: ImageSet | None) -> None:
    targets = {line.split(":")[0] for line in MAKEFILE.splitlines() if re.match(r"[a-z0-9-]+:.* ## ", line)}
    for word in words:
        name, equals, value = word.partition("=")
        if not equals:
            assert word in targets, f"make has no target {word}"
            continue
        assert re.search(rf"^{name} [?:]=|\$\({name}\)", MAKEFILE, re.MULTILINE), f"make has no variable {name}"
        if name == "TARGET" and image_set:
            explained(image_set, value, {})


# ---- Scripts ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("failing", "code"),
    [({}, 0), ({"all": 1}, 1), ({"scan": 3, "all": 1}, 3), ({"scan": 4}, 4), ({"prune": 1}, 1), ({"setup": 2}, 2)],
)
@pytest.mark.parametrize("whose", ["the page's", "a set's"])
def test_a_night_without_github(tmp_path: Path, real: ImageSet, whose: str, failing: dict[str, int], code: int) -> None:
    """The script of docs/registry.md, and that of a set, with a local replacement for rosml of which some steps fail: it ends there while it sets
    up, and goes on later; its code is the first failure's. What it calls is what the nightly workflow calls, or `all` in the
    place of steps."""
    (script,) = [block.text for block in blocks(ROOT / "docs/registry.md") if block.title == "night.sh"]
    if whose == "a set's":
        choice = own_set.chosen(real, [], [], "registry.example.com/robots", "")
        script = own_set.files(real, choice, own_set.Upstream("https://git.example.com/me/rosml", "0" * 40))[
            own_set.NIGHT
        ]
    (tmp_path / "night.sh").write_text(script)
    cases = "".join(f"{step}) exit {failed} ;; " for step, failed in failing.items())
    text = f'#!/bin/sh\necho "$@" >>calls\n[ "$1" != publish ] || shift\ncase "$1" in {cases}esac\n'
    (tmp_path / "rosml").write_text(text)
    (tmp_path / "rosml").chmod(0o755)
    done = subprocess.run(["bash", tmp_path / "night.sh"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (code, "")
    calls = [shlex.split(line) for line in (tmp_path / "calls").read_text().splitlines()]
    assert calls[0] == ["setup"]
    if "setup" in failing:
        assert len(calls) == 1
        return
    assert calls[1] == ["setup", "scanner"]
    steps = [call[1] if call[0] == "publish" else call[0] for call in calls[2:]]
    assert steps == ["scan", "all", "rosdep", "status", "prune"]
    night = (ROOT / ".github/workflows/nightly.yml").read_text()
    options = {word for call in calls[2:] for word in call if word.startswith("--")}
    assert [option for option in sorted(options) if option not in night] == []


def test_a_second_night_leaves_the_log_of_the_first_alone(tmp_path: Path) -> None:
    (crontab,) = [block for block in blocks(ROOT / "docs/registry.md") if block.title == "crontab"]
    command = crontab.text.split(maxsplit=5)[5]
    folder = tmp_path / "rosml"
    folder.mkdir()
    (folder / "night.sh").write_text('echo begun; bash -c "$SECOND"; echo refused: $?\n')
    environment = {**os.environ, "HOME": str(tmp_path), "SECOND": command}
    for nights in (1, 2):
        done = subprocess.run(["bash", "-c", command], env=environment, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
        assert (folder / ".state/night.log").read_text() == "begun\nrefused: 1\n" * nights
