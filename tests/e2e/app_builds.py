"""Repositories of a few small packages, and calls of `rosml containerize` that make images of them."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.machine.services import Services
from tests.e2e.calls import Run, run

BASE = "ros1-bookworm-core"
RUNTIME = "ros1-bookworm-core-run"
CANARY = "canary-9d1f"
"""A password that nothing may say."""

PACKAGE = """<package format="2"><name>{0}</name><version>1.0.0</version><description>{0}</description>
<maintainer email="nobody@example.org">nobody</maintainer><license>Apache-2.0</license>
<buildtool_depend>catkin</buildtool_depend>{1}</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.16)
project({0} C)
find_package(catkin REQUIRED)
catkin_package()
file(WRITE ${{CMAKE_CURRENT_BINARY_DIR}}/said "${{GREETING}}\\n")
install(FILES ${{CMAKE_CURRENT_BINARY_DIR}}/said DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
"""


def write(folder: Path, files: Mapping[str, str]) -> Path:
    """Writes files by their paths; programs can be executed. Gives the folder."""
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(0o755 if text.startswith("#!") else 0o644)
    return folder


def package(folder: Path, needs: str = "", lines: str = "", files: Mapping[str, str] | None = None) -> Path:
    """Writes a package of a folder's name.

    Args:
        needs: elements of its manifest. lines: of its CMakeLists.txt. files: of the repository, beside these.
    """
    name = folder.name
    texts = {"package.xml": PACKAGE.format(name, needs), "CMakeLists.txt": CMAKE.format(name) + lines}
    return write(folder, {**texts, **(files or {})})


def commit(folder: Path) -> None:
    init = ("init", "--quiet", "--initial-branch=master")
    for command in (init, ("add", "--all", "--force"), ("commit", "--quiet", "--message", "All")):
        names = ("-c", "user.name=nobody", "-c", "user.email=nobody@example.org")
        subprocess.run(["git", "-C", str(folder), *names, *command], check=True)


def repos(*folders: Path) -> str:
    """A `.repos` file that names repositories of this machine."""
    entries = (f"{folder.name}: {{type: git, url: 'file://{folder}', version: master}}" for folder in folders)
    return f"repositories: {{{', '.join(entries)}}}\n"


def containerize(folder: Path, options: Mapping[str, str], *flags: str) -> Run:
    """The command. An option with the value `true` is a flag."""
    words = [
        word for name, value in options.items() for word in (f"--{name}", value) if word != "true" or name == "command"
    ]
    command = (sys.executable, str(ROOT / "src"), "containerize", str(folder), "--json", "--allow-file-urls")
    return run(*command, *words, *flags)


def build_app(folder: Path, options: Mapping[str, str], *flags: str) -> dict[str, Any]:
    """What the command says of images that it made; each image by its target as well."""
    outcome = containerize(folder, options, *flags)
    assert outcome.code == 0, outcome.err + outcome.out
    result: dict[str, Any] = json.loads(outcome.out)
    return result | {image["target"]: image for image in result["images"]}


def pinned(image: Mapping[str, str]) -> str:
    """The reference of an image by its digest."""
    return f"{image['reference'].rpartition(':')[0]}@{image['digest']}"


def log_of(services: Services, name: str, kind: str = "") -> str:
    """The log of the last build of an app."""
    return (services.state / f"log/containerize-{name.replace('/', '+')}@latest{kind}.log").read_text()


def stages_run(services: Services, name: str) -> set[str]:
    """The stages of which a step ran, and was not in the cache, in the last build of an app."""
    log = log_of(services, name)
    return set(re.findall(r"^[\d.]+ s \[(?:[a-z-]+ )?([a-z-]+) \d+/\d+\] RUN", log, re.MULTILINE))


def hears(count: int, file: str, entrypoint: str = "/entrypoint.sh") -> str:
    """A step of a Dockerfile that starts the image's command, the compass, until it has heard so many directions."""
    start = f'/tini -s -- {entrypoint} bash -c "exec bash -c \\"$DEFAULT_CMD\\""'
    listen = f"/entrypoint.sh timeout 30 rostopic echo -n {count} /direction"
    return f"RUN bash -c '({start} & for try in {{1..200}}; do {listen} && break; done >{file}; kill $!; wait) 2>&1'"
