"""End-to-end tests build, enter and publish real images with the services that `rosml setup` started."""

from __future__ import annotations

import dataclasses
import json
import os
import tempfile
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.image_set import load
from rosml.images.image_set.model import ImageSet
from rosml.machine.services import Services
from tests.e2e import images
from tests.e2e import mini as minis
from tests.e2e.app_builds import BASE
from tests.e2e.builders import builder
from tests.e2e.calls import LOG, NAMESPACE, publish
from tests.e2e.images import BuildOn, Publish, Published
from tests.e2e.mini import Mini

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
            services = Services.load(ROOT)
            services.require_builder()
            if services.builder_kind == "buildkitd":
                name = f"small-{os.getpid()}"
                stack.enter_context(builder(name, folder / "builder", services))
                (folder / "name").write_text(name)
        session.config.stash[CLOSING] = stack.pop_all()


def pytest_sessionfinish(session: pytest.Session) -> None:
    if stack := session.config.stash.get(CLOSING, None):
        stack.close()


@pytest.fixture(scope="session")
def services() -> Services:
    try:
        services = Services.load(ROOT)
        services.require_registry()
        services.require_builder()
    except RosmlError as error:
        pytest.fail(f"{error.message}; {error.remedy}", pytrace=False)
    return services


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


@pytest.fixture(scope="session")
def image_set() -> ImageSet:
    return load.load(ROOT / "matrix.yaml")


@pytest.fixture(scope="session")
def published(services: Services, image_set: ImageSet) -> Publish:
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


@pytest.fixture(scope="session")
def base(published: Publish) -> str:
    """The reference of the base image of most apps."""
    return published(BASE).reference


@pytest.fixture
def build_on(services: Services, published: Publish, tmp_path: Path) -> BuildOn:
    """Builds steps on a published image, as `images.context` says; gives what the builder said."""

    def build(target: str, steps: Sequence[str], name: str = "") -> str:
        images.context(published(target).reference, tmp_path, steps, name)
        return images.build(services, tmp_path)

    return build


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A copy of what a build needs, in another folder, on the same services: tests may break it."""
    minis.copy_checkout(tmp_path, "services.json")
    return tmp_path


@pytest.fixture(scope="module")
def project(beside: Services, tmp_path_factory: pytest.TempPathFactory) -> Mini:
    """The small project; a module may add to it."""
    return minis.make(tmp_path_factory.mktemp("mini"), beside)


@pytest.fixture
def mini(project: Mini) -> Mini:
    """The small project with nothing broken, and an empty place in the registry."""
    project.mark()
    project.poison(poisoned=False)
    return project.elsewhere()
