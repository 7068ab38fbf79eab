"""End-to-end tests build, enter and publish real images with the services that `rosml setup` started.

They publish into a namespace of their own, so that they never move a tag that somebody uses.
"""

from __future__ import annotations

import dataclasses
import json
import logging
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.bake import bake_file
from rosml.images.image_set import load
from rosml.images.image_set.model import Image, ImageSet
from rosml.machine.services import Services
from tests import regctl
from tests.e2e.builders import builder

NAMESPACE = "rosml-test"
LOG = logging.getLogger("e2e")

HANGS = 720.0
"""Seconds after which a command that a test waits for hangs; less than a test's own limit (tests/limits.py)."""

# What a build needs of a checkout; the rest is documentation and tests.
CHECKOUT = (
    "Dockerfile",
    ".dockerignore",
    bake_file.NAME,
    bake_file.TESTS,
    "matrix.yaml",
    "components",
    "locks",
    "src",
    "scripts",
    "tools",
)


FIRST = (
    "images",
    "publisher",
    "fleet",
    "secure_registry",
    "attached",
    "workflows",
    "contract",
    "containerize",
    "examples",
    "ros",
    "documentation",
    "join",
)
"""Test files that are begun before the others. Two run side by side (`--dist=loadfile`): while one of them builds the
first real images, the other one runs those that have a builder of their own. Nothing long is left to run alone at the end."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    rank = {f"test_{name}": number for number, name in enumerate(FIRST)}
    items.sort(key=lambda item: rank.get(item.path.stem, len(rank)))
    for item in items:
        if item.path.parent == Path(__file__).parent:
            item.add_marker(pytest.mark.e2e)


SESSION = "ROSML_TEST_SESSION"
"""Variable that names a folder which all processes of a run share: what was published, and the builder for small projects."""

CLOSING = pytest.StashKey[ExitStack]()


def pytest_sessionstart(session: pytest.Session) -> None:
    """Starts, once for all processes of a run, a builder for small projects: where real images are built they would wait for
    minutes."""
    if os.environ.get("PYTEST_XDIST_WORKER") or session.config.option.collectonly:
        return
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="rosml-e2e-")))
        stack.enter_context(pytest.MonkeyPatch.context()).setenv(SESSION, str(folder))
        with suppress(RosmlError):  # without services each test that needs them says so
            found = Services.load(ROOT)
            found.require_builder()
            if found.builder_kind == "buildkitd":
                name = f"small-{os.getpid()}"
                stack.enter_context(builder(name, folder / "builder", found))
                (folder / "name").write_text(name)
        session.config.stash[CLOSING] = stack.pop_all()


def pytest_sessionfinish(session: pytest.Session) -> None:
    if stack := session.config.stash.get(CLOSING, None):
        stack.close()


@dataclass(frozen=True)
class Run:
    """A command that ended: exit code, standard output, standard error."""

    code: int
    out: str
    err: str


def run(*command: str, cwd: Path = ROOT, env: dict[str, str] | None = None) -> Run:
    """Runs a command; its progress lines appear in the test's log while it works."""
    process = subprocess.Popen(
        command,
        cwd=cwd,
        env={**os.environ, **(env or {})},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stderr and process.stdout
    lines = []
    for line in process.stderr:
        LOG.info("%s", line.rstrip())
        lines.append(line)
    return Run(process.wait(), process.stdout.read(), "".join(lines))


def publish(target: str, *options: str, root: Path = ROOT) -> Run:
    """`rosml image`, as `make image` calls it, in the tests' namespace."""
    return run(
        sys.executable, str(root / "src"), "image", target, "--namespace", NAMESPACE, "--json", *options, cwd=root
    )


@pytest.fixture(scope="session")
def services() -> Services:
    try:
        found = Services.load(ROOT)
        found.require_registry()
        found.require_builder()
    except RosmlError as error:
        pytest.fail(f"{error.message}; {error.remedy}", pytrace=False)
    return found


@pytest.fixture(scope="session")
def beside(services: Services) -> Services:
    """The services with the builder for small projects; the usual one where Docker has it: one container is enough."""
    name = Path(os.environ[SESSION], "name")
    if not name.is_file():
        return services
    return dataclasses.replace(services, builder=name.read_text(), builder_kind="user")


@pytest.fixture(scope="session")
def own_builders(services: Services) -> None:
    """For tests that start, tell and kill builders of their own."""
    if services.builder_kind != "buildkitd":
        pytest.skip("Docker is the builder here, and these tests start and kill a buildkitd of their own")


def small_file_system(folder: Path, size: str, services: Services) -> None:
    """Mounts one of a size, such as `50m`; whoever calls it unmounts it."""
    if os.geteuid() != 0:
        assert services.builder_kind != "buildkitd", "without Docker, set-up and tests need root"
        pytest.skip("Docker is the builder here, and only root may mount a file system")
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)], check=True)


@pytest.fixture(scope="session")
def image_set() -> ImageSet:
    return load.load(ROOT / "matrix.yaml")


@dataclass(frozen=True)
class Published:
    """A published image: its facts, what the command reported, and where it is."""

    image: Image
    result: dict[str, Any]
    repository: str
    services: Services

    @property
    def reference(self) -> str:
        return f"{self.repository}@{self.result['manifest']}"

    @property
    def layers(self) -> list[str]:
        return [layer.digest for layer in regctl.layers(self.services, self.reference)]


@pytest.fixture(scope="session")
def published(services: Services, image_set: ImageSet) -> Callable[[str], Published]:
    """Publishes a target once per run, whichever process is the first to want it."""
    folder = Path(os.environ[SESSION])

    def once(target: str) -> Published:
        file = folder / f"{target}.json"
        with turn(folder / f"{target}.lock", lambda: LOG.info("%s: another test publishes it", target)):
            if not file.exists():
                outcome = publish(target)
                assert outcome.code == 0, outcome.err
                file.write_text(outcome.out)
        image = image_set.image(target)
        repository = f"{services.registry}/{NAMESPACE}/{image.repository}"
        return Published(image, json.loads(file.read_text()), repository, services)

    return once


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A copy of what a build needs, in another folder, on the same services: tests may break it."""
    for name in CHECKOUT:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, tmp_path / name)
    shutil.copytree(ROOT / "tests" / "structure", tmp_path / "tests" / "structure")
    (tmp_path / ".state").mkdir()
    for name in ("services.json", "registry", "base", "auth", "bin"):
        if (ROOT / ".state" / name).exists():
            (tmp_path / ".state" / name).symlink_to(ROOT / ".state" / name)
    return tmp_path
