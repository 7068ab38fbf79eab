"""A row whose ROS comes from an apt archive of somebody's own, as docs/extend/archive.md has it: the entry of the page, the key, a build.
The archive is one that the test signs; the address of the page is answered by a mirror on this machine."""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.containerize.ci import files as ci_files
from rosml.images.bake import targets
from rosml.images.builds import base_images
from rosml.images.image_set import load
from rosml.images.matrix.source import read
from rosml.images.records import store
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.place import Place
from tests import regctl, walk
from tests.e2e.apt_stand_in import Image, Keys, Repository, Server, package
from tests.e2e.conftest import NAMESPACE, Run, run
from tests.e2e.images import NATIVE, PLATFORM, build
from tests.pages import commands

PAGE = "ROS from your own archive"
OURS = "Our packages"
WHEN = "2026-11-20T21:14:09Z"
"""When the test's archives are of."""


@pytest.fixture(scope="module")
def keys() -> Iterator[Keys]:
    with tempfile.TemporaryDirectory(prefix="gpg-") as home:  # short: gpg's sockets are in it
        made = Keys(Path(home))
        try:
            for name in ("ours", "stranger"):
                made.make(name)
            yield made
        finally:
            made.close()


@pytest.fixture
def archive(tmp_path: Path, keys: Keys) -> Iterator[tuple[Server, Repository]]:
    """The archive of the page, signed, with packages for two components."""
    (tmp_path / "web").mkdir()
    (tmp_path / "debs").mkdir()
    server = Server(tmp_path / "web")
    repository = Repository(server.folder / "packages.example.com/ros2", "bookworm", keys)
    setup = {"opt/ros/jazzy/setup.bash": "export ROS_DISTRO=jazzy\n"}
    repository.debs = [
        package(tmp_path / "debs", "ros-jazzy-ros-core", files=setup),
        package(tmp_path / "debs", "ros-jazzy-ros-base", "ros-jazzy-ros-core"),
    ]
    repository.publish("ours")
    yield server, repository
    server.close()


def row(project: Path) -> None:
    """Puts the page's entry into a project."""
    [entry] = [block for block in walk.section(PAGE) if block.title]
    walk.insert(project, entry)


@pytest.mark.full(proof="apt")
def test_the_page_is_followed_to_an_image(
    checkout: Path, archive: tuple[Server, Repository], keys: Keys, services: Services, tmp_path: Path
) -> None:
    """Its commands, with the key of this archive; the image is built, and not tested: there is no real ROS in it."""
    server, _ = archive
    for name in (
        "matrix.schema.json",
        "catalogue.schema.json",
        "docs/tags.md",
        "docs/images/layers.svg",
        "docs/images/rebase.svg",
        *ci_files.FILES,
    ):
        (checkout / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, checkout / name)
    row(checkout)
    export, generate, explain, image = [
        command for block in walk.section(PAGE) if block.language == "sh" for command in commands(block)
    ]
    env = {"GNUPGHOME": str(keys.home)}
    done = run("bash", "-c", export.replace(OURS, "ours@example.org"), cwd=checkout, env=env)
    assert done.code == 0, done.err
    walk.run(checkout, generate)
    assert "ros-jazzy-ros-core installed" in walk.run(checkout, explain)
    target = image.removeprefix("./rosml image ")
    place = f"{services.registry}/{NAMESPACE}-archive"
    argv = [sys.executable, "src", "publish", "build", "--only", target, "--registry", place, "--json"]
    done = run(*argv, cwd=checkout, env={"ROS_APT_MIRROR": server.url})
    assert done.code == 0, done.err
    with Registry(services.registry) as registry:
        entry = store.Records(Place(registry, f"{NAMESPACE}-archive")).read(target, NATIVE)
    assert entry and entry.package_state.startswith(f"{WHEN}, debian bookworm ")
    config = regctl.image_config(services, f"{place}/ros@{entry.digest}", PLATFORM)["config"]
    assert config["Labels"]["io.rosml.ros.sync"] == WHEN
    assert "ROS_DISTRO=jazzy" in config["Env"] and f"ROS_SYNC_DATE={WHEN}" in config["Env"]

    # The same on an image of somebody else: Debian's own.
    systems = load.load(ROOT / "matrix.yaml").matrix.operating_systems
    debian = base_images.reference(services, systems, "bookworm", NATIVE)
    plain = f"{services.registry}/{NAMESPACE}-archive/debian:plain"
    (tmp_path / "plain").mkdir()
    (tmp_path / "plain/Dockerfile").write_text(f"FROM {debian}\n")
    build(services, tmp_path / "plain", "--output", f"type=image,name={plain},push=true")
    argv = [sys.executable, "src", "image", target, "--on", plain, "--namespace", f"{NAMESPACE}-archive", "--json"]
    done = run(*argv, cwd=checkout, env={"ROS_APT_MIRROR": server.url})
    assert done.code == 0, done.err
    config = regctl.image_config(services, json.loads(done.out)["reference"], PLATFORM)["config"]
    assert "ROS_DISTRO=jazzy" in config["Env"] and f"ROS_SYNC_DATE={WHEN}" in config["Env"]


@dataclass
class Row:
    """The page's row with a stand-in for its image, in which the Dockerfile's step runs."""

    keys: Keys
    server: Server
    repository: Repository
    image: Image
    arguments: dict[str, dict[str, str]]

    def build(self, component: str = "core", **arguments: str) -> Run:
        env = {**self.arguments[component], **arguments}
        script = "/run/components/ros/install.sh"
        return self.image.run(script, env=env, ros_apt_mirror=self.server.url, os_apt_mirror="")

    def pin(self, key: str) -> None:
        (self.image.components / "archive-keys/key.asc").write_text(self.keys.armored(key))


@pytest.fixture
def ours(tmp_path: Path, keys: Keys, archive: tuple[Server, Repository]) -> Row:
    project = tmp_path / "project"
    project.mkdir()
    shutil.copy(ROOT / "matrix.yaml", project)
    row(project)
    found = targets.of(load.image_set(read(project / "matrix.yaml")))
    arguments = {
        component: {
            name: fact
            for name, value in found[f"jazzy-ours-{component}"].arguments.items()
            if isinstance(fact := value.fact if isinstance(value, targets.Overridable) else value, str)
        }
        for component in ("core", "base")
    }
    arguments["core"]["ROS_TOOLS"] = "ros-jazzy-ros-core"  # Debian's own tools are no matter of this archive
    (tmp_path / "image").mkdir()
    server, repository = archive
    made = Row(keys, server, repository, Image(tmp_path / "image", "trixie"), arguments)
    made.pin("ours")
    return made


def test_packages_come_from_the_archive(ours: Row) -> None:
    """On a system of another name than the suite; the source and the key stay for what is installed later."""
    for component in ("core", "base"):
        done = ours.build(component, ROS_SYNC_DATE=WHEN)
        assert done.code == 0, done.out + done.err
    assert ours.image.read("etc/apt/sources.list.d/ros2-archive.sources") == (
        "Types: deb\nURIs: http://packages.example.com/ros2\nSuites: bookworm\nComponents: main\n"
        "Signed-By: /usr/share/keyrings/ros2-archive-keyring.asc\n"
    )
    assert ours.image.read("usr/local/share/rosml/versions.d/ros").endswith(
        "ros-channel archive\nros-source http://packages.example.com/ros2\n"
    )
    check = (ROOT / "tests/structure/checks/apt_source.sh").read_text()
    assert ours.image.run("bash", "-c", check, env={"ROS_SYNC_DATE": WHEN}).code == 0


def unsigned(row: Row) -> None:
    suite = row.repository.folder / "dists/bookworm"
    (suite / "InRelease").write_text((row.repository.folder / "Release").read_text())


def stranger(row: Row) -> None:
    row.repository.publish("stranger")


def other_suite(row: Row) -> None:
    row.repository.publish("ours", says="sid")


def empty(row: Row) -> None:
    row.repository.debs = []
    row.repository.publish("ours")


def no_metapackage(row: Row) -> None:
    row.repository.debs = row.repository.debs[1:]
    row.repository.publish("ours")


def no_key(row: Row) -> None:
    (row.image.components / "archive-keys/key.asc").unlink()


def no_public_key(row: Row) -> None:
    (row.image.components / "archive-keys/key.asc").write_text("<html>not found</html>\n")


def nothing_there(row: Row) -> None:
    shutil.rmtree(row.repository.folder)


def moved(row: Row) -> None:
    row.arguments["core"]["ROS_SYNC_DATE"] = "2026-11-13T00:00:00Z"


FAULTS: dict[str, tuple[Callable[[Row], None], str, str]] = {
    "not signed": (unsigned, "has no valid signature", "check the mirror"),
    "signed by another key": (stranger, "which is not a pinned one", "components/archive-keys"),
    "another suite": (other_suite, "has the suite 'sid' in the place of 'bookworm'", "check the mirror"),
    "empty": (empty, "no apt source has a package", "check its name in matrix.yaml, and whether http"),
    "without the metapackage": (no_metapackage, "no apt source has a package", "check its name in matrix.yaml"),
    "no key": (no_key, "components/archive-keys/ours.asc is no public key", "gpg --armor --export"),
    "a page in the place of the key": (no_public_key, "ours.asc is no public key", "gpg --armor --export"),
    "no archive": (nothing_there, "there is no such apt repository", "'archive', in matrix.yaml"),
    "moved meanwhile": (moved, f"is of {WHEN}, and not of 2026-11-13T00:00:00Z any more", "run it again"),
}
"""What goes wrong, what is said about it, and what the remedy names."""


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_sentence_with_its_remedy(name: str, ours: Row) -> None:
    fault, problem, remedy = FAULTS[name]
    fault(ours)
    done = ours.build()
    assert done.code == 1, done.out + done.err
    errors = [line for line in done.err.splitlines() if line.startswith("error: ")]
    assert len(errors) == 1, done.out + done.err
    said, _, advice = errors[0].rpartition("; ")
    assert problem in said, errors[0]
    assert remedy in advice, errors[0]
