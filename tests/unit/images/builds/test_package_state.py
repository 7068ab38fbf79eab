"""Of when packages are: by the lists of packages of the archives that the base image's apt sources name, and not by the date that
these write several times a day; of ROS's own repository by its date."""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from conftest import WHEELS, changed, parse

from fakes.apt_mirror import AptMirror
from fakes.release_files import DATE, FACTS, PATHS, RELEASE, SYNC, release_server
from rosml.base.errors import RosmlError
from rosml.images.builds import apt_sources, package_state
from rosml.images.matrix.model import Matrix
from rosml.machine.services import Services

ROWS = {"omega": "bookworm", "alpha": "noble", "sigma": "noble"}
"""Rows whose ROS is the system's own, from ROS's repository, and from wheels: the suite that their system is of."""
SYSTEMS = {"ubuntu-24.04": "noble", "ubuntu-26.04": "bookworm"}
SOURCES = """\
deb {address}/debian {suite} main universe
deb {address}/debian {suite}-updates main universe
deb {address}/debian-security {suite}-security main universe
"""


def at(address: str) -> Matrix:
    """A matrix with a live row, one from wheels, and omega, whose ROS is the system's own."""
    text = changed("    codename: resolute\n", "", WHEELS.replace("http://ros.test", address))
    text = changed("    apt: {channel: snapshot, date: 2026-11-01}\n", "", text)
    packages = "packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n    default_stack: cpu"
    return parse(changed(packages, packages.replace("-{ros_distro}", ""), text)).matrix


@dataclass
class Machine:
    """Asks of when packages are. The base images have `sources`, by system."""

    services: Services
    sources: dict[str, str] = field(default_factory=dict)

    def name(self, address: str, text: str = SOURCES) -> None:
        """Has all base images name the archive at an address."""
        self.sources = {system: text.format(address=address, suite=suite) for system, suite in SYSTEMS.items()}

    def state(self, matrix: Matrix, row: str, environ: Mapping[str, str] | None = None) -> str:
        return package_state.state(self.services, matrix, row, environ or {})

    def repositories(self, matrix: Matrix, row: str, state: str) -> list[tuple[str, str]]:
        return package_state.repositories(self.services, matrix, row, state)


@pytest.fixture
def mirror(monkeypatch: pytest.MonkeyPatch) -> Iterator[AptMirror]:
    with release_server(monkeypatch) as server:
        yield server


@pytest.fixture
def machine(tmp_path: Path, mirror: AptMirror, monkeypatch: pytest.MonkeyPatch) -> Machine:
    """One whose base images name the local replacement."""
    asking = Machine(Services.load(tmp_path, required=False))
    asking.name(mirror.address)

    def sources(_services: object, _systems: object, system: str) -> tuple[apt_sources.Source, ...]:
        return apt_sources.parse({"etc/apt/sources.list": asking.sources[system]}, system)

    monkeypatch.setattr(apt_sources, "sources", sources)
    return asking


@pytest.mark.parametrize("row", ROWS)
def test_another_list_of_packages_is_another_state(machine: Machine, mirror: AptMirror, row: str) -> None:
    matrix, paths = at(mirror.address), PATHS[ROWS[row]]
    before = machine.state(matrix, row)
    assert f"debian {ROWS[row]} " in before
    assert sorted(mirror.requests) == sorted([*paths, *([SYNC] if row == "alpha" else [])])
    for path, what in itertools.product(paths, ("amd64", "arm64", "universe")):
        whole = mirror.files[path]
        mirror.files[path] = RELEASE.format(**FACTS | {what: "d" * 64}).encode()
        assert machine.state(matrix, row) != before, (path, what)
        mirror.files[path] = whole
        assert machine.state(matrix, row) == before
    later = RELEASE.format(**FACTS | {"date": "Sun, 22 Nov 2026 16:00:00 UTC", "other": "e" * 64}).encode()
    mirror.files |= dict.fromkeys(paths, later)
    assert machine.state(matrix, row) == before, "neither another date nor lists that no image is installed from"


def test_the_state_of_an_archive_is_the_same_on_every_machine(machine: Machine, mirror: AptMirror) -> None:
    """Records compare it, of images that were built on other architectures, whose base image names other addresses."""
    matrix = at(mirror.address)
    lists = " ".join(["a" * 64, "b" * 64, "f" * 64])
    digest = hashlib.sha256(" ".join([lists] * 3).encode()).hexdigest()[:16]
    assert machine.state(matrix, "omega") == f"debian bookworm {digest}"
    machine.name(f"{mirror.address}/ports")
    mirror.files = {f"/ports{path}": body for path, body in mirror.files.items()}
    assert machine.state(matrix, "omega") == f"debian bookworm {digest}"


def test_lists_are_those_of_the_components_that_the_source_names(machine: Machine, mirror: AptMirror) -> None:
    machine.name(mirror.address, SOURCES.replace("main universe", "main contrib"))
    before = machine.state(at(mirror.address), "omega")
    path = PATHS["bookworm"][0]
    mirror.files[path] += b" " + b"e" * 64 + b" 1 contrib/binary-amd64/Packages\n"
    assert machine.state(at(mirror.address), "omega") != before
    machine.name(mirror.address, "deb {address}/flat ./\ndeb {address} more/\n")
    for path in ("/flat/Release", "/more/Release"):
        mirror.files[path] = f"SHA256:\n {'a' * 64} 12 Packages\n {'b' * 64} 1 main/binary-amd64/Packages\n".encode()
    digest = hashlib.sha256(" ".join(["a" * 64] * 2).encode()).hexdigest()[:16]
    assert machine.state(at(mirror.address), "omega") == f"apt ./ {digest}", "a flat repository has no components"


def test_backports_do_not_count(machine: Machine, mirror: AptMirror) -> None:
    """apt installs nothing from there on its own; unless their Release file says otherwise."""
    matrix, path = at(mirror.address), "/debian/dists/bookworm-backports/Release"
    before = machine.state(matrix, "omega")
    machine.name(mirror.address, "deb {address}/debian {suite}-backports main\n" + SOURCES)
    for packages in ("d", "e"):
        lists = RELEASE.format(**FACTS | {"amd64": packages * 64}).encode()
        mirror.files[path] = b"NotAutomatic: yes\nButAutomaticUpgrades: yes\n" + lists
        assert machine.state(matrix, "omega") == before
    assert path in mirror.requests
    mirror.files[path] = b"NotAutomatic: no\n" + lists
    assert machine.state(matrix, "omega").startswith("debian bookworm-backports ")


@pytest.mark.parametrize("path", PATHS["bookworm"])
@pytest.mark.parametrize("body", [None, b"Origin: Debian\n", b"\xff"])
def test_what_is_not_there_is_an_error(machine: Machine, mirror: AptMirror, path: str, body: bytes | None) -> None:
    mirror.files.pop(path)
    if body is not None:
        mirror.files[path] = body
    with pytest.raises(RosmlError, match="HTTP Error 404" if body is None else "names no lists") as caught:
        machine.state(at(mirror.address), "omega")
    assert path in caught.value.message and caught.value.remedy


@pytest.mark.parametrize("scheme", ["http", "https"])
def test_a_mirror_is_asked_in_the_place_of_the_archive(machine: Machine, mirror: AptMirror, scheme: str) -> None:
    matrix = at(mirror.address)
    before = machine.state(matrix, "omega")
    machine.name(f"{scheme}://debian.test")
    mirror.files = {f"/debian.test{path}": body for path, body in mirror.files.items()}
    assert machine.state(matrix, "omega", {"OS_APT_MIRROR": f"{mirror.address}/"}) == before
    with pytest.raises(RosmlError, match="OS_APT_MIRROR is not an address") as caught:
        machine.state(matrix, "omega", {"OS_APT_MIRROR": "nowhere"})
    assert caught.value.exit_code == 2


def test_nobody_who_answers(machine: Machine, mirror: AptMirror) -> None:
    machine.name("http://user:secret@127.0.0.1:1")
    for environ in ({}, {"OS_APT_MIRROR": "http://127.0.0.1:1"}):
        with pytest.raises(RosmlError, match="does not answer") as caught:
            machine.state(at(mirror.address), "omega", environ)
        assert "secret" not in caught.value.message


def test_each_repository_has_its_own_state(
    machine: Machine, mirror: AptMirror, monkeypatch: pytest.MonkeyPatch
) -> None:
    matrix = at(mirror.address)
    state = machine.state(matrix, "alpha")
    ros, archive = state.split(", ")
    assert package_state.ros_date(state) == package_state.ros_date(DATE) == ros == DATE
    archives = [(f"{mirror.address}/{name}", archive) for name in ("debian", "debian-security")]
    assert machine.repositories(matrix, "alpha", state) == [(f"{mirror.address}/ros2/ubuntu", DATE), *archives]
    omega = machine.state(matrix, "omega")
    assert package_state.ros_date(omega) == package_state.ros_date("") == ""
    machine.name("http://user:secret@debian.test")
    assert machine.repositories(matrix, "omega", omega) == [
        ("http://debian.test/debian", omega),
        ("http://debian.test/debian-security", omega),
    ]
    assert machine.repositories(matrix, "omega", "") == []
    machine.sources["ubuntu-24.04"] = "deb nothing\n"
    assert machine.repositories(matrix, "alpha", state) == [(f"{mirror.address}/ros2/ubuntu", DATE)]


def test_a_base_image_without_an_archive_that_can_be_asked(machine: Machine, mirror: AptMirror) -> None:
    machine.name(mirror.address, "deb cdrom:[Debian 12]/ {suite} main\n")
    assert machine.state(at(mirror.address), "alpha") == DATE
    assert machine.state(at(mirror.address), "sigma") == ""
    assert mirror.requests == [SYNC]
