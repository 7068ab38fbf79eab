"""A distribution whose ROS comes from an apt archive of somebody's own, as docs/extend/archive.md has it: the entry of the page, the key, a build.
The archive is one that the test signs; the address of the page is answered by a mirror on this machine."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.containerize.ci import files as ci_files
from rosml.images.bake import targets
from rosml.images.image_set import load
from rosml.images.matrix.source import read
from rosml.images.records import store
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.place import Place
from tests import walk
from tests.e2e.calls import NAMESPACE, Run, rosml, succeeds
from tests.e2e.images import NATIVE, build_file, config, system
from tests.e2e.local_apt import Image, Keys, Repository, Server, package, require_one_sentence, signing_keys
from tests.pages import commands

PAGE = "ROS from your own archive"
OURS = "Our packages"
WHEN = "2026-11-20T21:14:09Z"
"""When the test's archives are of."""


@pytest.fixture(scope="module")
def keys() -> Iterator[Keys]:
    with signing_keys("ours", "stranger") as keys:
        yield keys


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


def add_entry(project: Path) -> None:
    """Puts the page's entry into a project."""
    [entry] = [block for block in walk.section(PAGE) if block.title]
    walk.insert(project, entry)


@pytest.mark.full(proof="apt")
def test_the_page_is_followed_to_an_image(
    checkout: Path, archive: tuple[Server, Repository], keys: Keys, services: Services, tmp_path: Path
) -> None:
    """Its commands, with the key of this archive; the image is built, and not tested: there is no real ROS in it."""
    server, _ = archive
    documents = ("docs/tags.md", "docs/images/layers.svg", "docs/images/rebase.svg")
    for name in ("matrix.schema.json", "catalogue.schema.json", *documents, *ci_files.FILES):
        (checkout / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, checkout / name)
    add_entry(checkout)
    export, generate, explain, image = [
        command for block in walk.section(PAGE) if block.language == "sh" for command in commands(block)
    ]
    succeeds("bash", "-c", export.replace(OURS, "ours@example.org"), cwd=checkout, env={"GNUPGHOME": str(keys.home)})
    walk.run(checkout, generate)
    assert "ros-jazzy-ros-core installed" in walk.run(checkout, explain)
    target = image.removeprefix("./rosml image ")
    place = f"{services.registry}/{NAMESPACE}-archive"
    env = {"ROS_APT_MIRROR": server.url}
    rosml("publish", "build", "--only", target, "--registry", place, "--json", root=checkout, env=env)
    with Registry(services.registry) as registry:
        entry = store.Records(Place(registry, f"{NAMESPACE}-archive")).read(target, NATIVE)
    assert entry and entry.package_state.startswith(f"{WHEN}, debian bookworm ")
    start = config(services, f"{place}/ros@{entry.digest}")
    assert start["Labels"]["io.rosml.ros.sync"] == WHEN
    assert {"ROS_DISTRO=jazzy", f"ROS_SYNC_DATE={WHEN}"} <= {*start["Env"]}

    # The same on an image of somebody else: Debian's own.
    plain, output = f"{place}/debian:plain", f"type=image,name={place}/debian:plain,push=true"
    build_file(services, tmp_path / "plain", f"FROM {system(services, 'bookworm')}\n", "--output", output)
    words = ("image", target, "--on", plain, "--namespace", f"{NAMESPACE}-archive", "--json")
    start = config(services, json.loads(rosml(*words, root=checkout, env=env).out)["reference"])
    assert {"ROS_DISTRO=jazzy", f"ROS_SYNC_DATE={WHEN}"} <= {*start["Env"]}


@dataclass
class LocalDistribution:
    """The page's distribution with a local replacement for its image, in which the Dockerfile's step runs."""

    keys: Keys
    server: Server
    repository: Repository
    image: Image
    arguments: dict[str, dict[str, str]]

    def build(self, component: str = "core", **arguments: str) -> Run:
        env = {**self.arguments[component], **arguments}
        script = "/run/components/ros/install.sh"
        return self.image.run(script, env=env, ros_apt_mirror=self.server.url, os_apt_mirror="")

    def offer(self, debs: list[Path]) -> None:
        """Publishes other packages."""
        self.repository.debs = debs
        self.repository.publish("ours")

    @property
    def key(self) -> Path:
        return self.image.components / "archive-keys/key.asc"


@pytest.fixture
def ours(tmp_path: Path, keys: Keys, archive: tuple[Server, Repository]) -> LocalDistribution:
    project = tmp_path / "project"
    project.mkdir()
    shutil.copy(ROOT / "matrix.yaml", project)
    add_entry(project)
    bake = targets.of(load.image_set(read(project / "matrix.yaml")))
    arguments = {
        component: {
            name: fact
            for name, value in bake[f"jazzy-ours-{component}"].arguments.items()
            if isinstance(fact := value.fact if isinstance(value, targets.Overridable) else value, str)
        }
        for component in ("core", "base")
    }
    arguments["core"]["ROS_TOOLS"] = "ros-jazzy-ros-core"  # Debian's own tools are no matter of this archive
    (tmp_path / "image").mkdir()
    server, repository = archive
    local = LocalDistribution(keys, server, repository, Image(tmp_path / "image", "trixie"), arguments)
    local.key.write_text(keys.armored("ours"))
    return local


def test_packages_come_from_the_archive(ours: LocalDistribution) -> None:
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


def unsigned(local: LocalDistribution) -> None:
    folder = local.repository.folder
    (folder / "dists/bookworm/InRelease").write_text((folder / "Release").read_text())


def moved(local: LocalDistribution) -> None:
    local.arguments["core"]["ROS_SYNC_DATE"] = "2026-11-13T00:00:00Z"


FAULTS: dict[str, tuple[Callable[[LocalDistribution], object], str, str]] = {
    "not signed": (unsigned, "has no valid signature", "check the mirror"),
    "another key": (lambda it: it.repository.publish("stranger"), "which is not a pinned one", "components/archive-keys"),
    "another suite": (lambda it: it.repository.publish("ours", "sid"), "'sid' in the place of 'bookworm'", "check the mirror"),
    "empty": (lambda it: it.offer([]), "no apt source has a package", "check its name in matrix.yaml, and whether http"),
    "no metapackage": (lambda it: it.offer(it.repository.debs[1:]), "no apt source has a package", "check its name in matrix"),
    "no key": (lambda it: it.key.unlink(), "components/archive-keys/ours.asc is no public key", "gpg --armor --export"),
    "a page for the key": (lambda it: it.key.write_text("<html>not found</html>\n"), "ours.asc is no public key", "gpg --armor --export"),
    "no archive": (lambda it: shutil.rmtree(it.repository.folder), "there is no such apt repository", "'archive', in matrix"),
    "moved meanwhile": (moved, f"is of {WHEN}, and not of 2026-11-13T00:00:00Z any more", "run it again"),
}  # fmt: skip
"""What goes wrong, what is said about it, and what the remedy names."""


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_sentence_with_its_remedy(name: str, ours: LocalDistribution) -> None:
    fault, problem, remedy = FAULTS[name]
    fault(ours)
    require_one_sentence(ours.build(), problem, remedy)
