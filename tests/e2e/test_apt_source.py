"""ROS's apt source, verified by a local replacement: components/ros/install.sh runs as in a build, against signed repositories.

Where ROS's repositories and GitHub can be reached, the same scripts ask them.
"""

from __future__ import annotations

import functools
import hashlib
import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import pytest
import yaml

from rosml import ROOT
from rosml.images.bake import targets
from rosml.images.builds import sync
from rosml.images.image_set import apt_repository, load
from tests.e2e.calls import Run
from tests.e2e.local_apt import (
    APT_SOURCE,
    LIVE,
    SNAPSHOT,
    Image,
    Keys,
    Repository,
    Server,
    apt_source,
    package,
    require_one_sentence,
    ros_packages,
    signing_keys,
)

TOOLS = ("apt-get", "chroot", "curl", "dpkg-deb", "gpg", "unshare")

CATALOGUE = load.load(ROOT / "matrix.yaml")
ROWS = [name for name, distribution in CATALOGUE.matrix.distributions.items() if distribution.apt]
TARGETS = targets.of(CATALOGUE)
STRUCTURE_TEST = ROOT / "tests" / "structure" / "checks" / "apt_source.sh"


def arguments_of(target: str) -> dict[str, str]:
    """A target's arguments, with what a variable may override as matrix.yaml has it. Nobody says of when the repository is."""
    values = TARGETS[target].arguments.items()
    facts = {name: value.fact if isinstance(value, targets.Overridable) else value for name, value in values}
    return {name: fact for name, fact in facts.items() if isinstance(fact, str)}


def missing() -> str:
    """Why this machine cannot hold the local replacement; empty if it can."""
    if os.geteuid() != 0:
        return "the local replacement of an image needs root, for an overlay and chroot"
    if absent := [tool for tool in TOOLS if shutil.which(tool) is None]:
        return f"the local replacement of an image is made of this machine, which lacks {', '.join(absent)}"
    with tempfile.TemporaryDirectory() as folder:
        for name in ("upper", "work", "root"):
            (Path(folder) / name).mkdir()
        script = 'mount -t overlay overlay -o "lowerdir=/,upperdir=$0/upper,workdir=$0/work" "$0/root"'
        script += ' && chroot "$0/root" apt-get --version'
        done = subprocess.run(["unshare", "--mount", "sh", "-c", script, folder], capture_output=True, text=True)
    return f"no overlay of this machine can be made: {done.stderr.strip()}" if done.returncode else ""


@pytest.fixture(scope="module", autouse=True)
def able() -> None:
    """Without Docker, set-up and tests need root anyway; with it, these tests alone do."""
    assert not (reason := missing()), reason


@pytest.fixture(scope="module")
def keys() -> Iterator[Keys]:
    with signing_keys("live", "snapshots", "stranger", "expired") as keys:
        yield keys


@pytest.fixture(scope="module")
def debs(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], list[Path]]:
    """The packages of a distribution, built once."""
    return functools.cache(lambda distro: ros_packages(tmp_path_factory.mktemp("debs"), distro))


@dataclass
class LocalDistribution:
    """A distribution of matrix.yaml with the local replacements that its build asks; a test breaks one of them."""

    distro: str
    keys: Keys
    server: Server
    image: Image
    repository: Repository
    arguments: dict[str, str]

    @property
    def key(self) -> str:
        """The key that signs what this distribution asks."""
        return "live" if self.arguments["ROS_CHANNEL"] == "live" else "snapshots"

    def publish(self, **changes: str) -> None:
        """Publishes its repository again, with its key."""
        self.repository.publish(self.key, **changes)

    def remove(self, name: str) -> None:
        """Publishes it without a package."""
        self.repository.debs = [deb for deb in self.repository.debs if name not in deb.name]
        self.publish()

    def pin(self, key: str, codename: str = "") -> None:
        """Publishes ROS's package with a key in it, and pins its digest as matrix.yaml would."""
        generation = "ros" if self.arguments["ROS_VERSION"] == "1" else "ros2"
        codename = codename or self.repository.codename
        deb = apt_source(self.server.folder, generation, codename, self.keys.armored(key))
        address = APT_SOURCE.format(generation=generation, version="1.2.0", codename=self.repository.codename)
        release = self.server.folder / address.partition("://")[2]
        release.parent.mkdir(parents=True, exist_ok=True)
        deb.rename(release)
        self.arguments["ROS_APT_SOURCE"] = f"{address}@sha256:{hashlib.sha256(release.read_bytes()).hexdigest()}"

    def pin_keys(self, **files: str) -> None:
        """Puts keys made here into components/ros/keys."""
        for file, key in files.items():
            (self.image.components / "ros" / "keys" / f"{file}.asc").write_text(self.keys.armored(key))

    def build(self, component: str = "core", mirror: str | None = None, os_mirror: str = "", **arguments: str) -> Run:
        """The step of the Dockerfile that installs a component, with the arguments of docker-bake.hcl."""
        mirror = self.server.url if mirror is None else mirror
        env = {**arguments_of(f"{self.distro}-{component}"), **self.arguments, **arguments}
        return self.image.run("/run/components/ros/install.sh", env=env, ros_apt_mirror=mirror, os_apt_mirror=os_mirror)

    def builds(self, component: str = "core", mirror: str | None = None, os_mirror: str = "", **arguments: str) -> Run:
        """The same; it must not fail."""
        done = self.build(component, mirror, os_mirror, **arguments)
        assert done.code == 0, done.out + done.err
        return done

    def versions(self) -> str:
        """What the image says of its ROS."""
        return self.image.read("usr/local/share/rosml/versions.d/ros")

    def apt_source_test(self) -> Run:
        """The structure test of the apt source."""
        return self.image.run("bash", "-c", STRUCTURE_TEST.read_text(), env={"ROS_SYNC_DATE": ""})

    def mentions(self) -> list[Path]:
        """The files of the image that name the mirror."""
        return [path for path in files(self.image.upper) if self.server.url.encode() in path.read_bytes()]


Make = Callable[[str], LocalDistribution]


@pytest.fixture
def make(tmp_path: Path, keys: Keys, debs: Callable[[str], list[Path]]) -> Iterator[Make]:
    with ExitStack() as stack:

        def one(distro: str) -> LocalDistribution:
            of_component = ("ROS_PACKAGES", "ROS_TOOLS")  # the others are the distribution's
            arguments = {
                name: fact for name, fact in arguments_of(f"{distro}-core").items() if name not in of_component
            }
            codename = arguments["ROS_CODENAME"]
            for name in ("web", "image"):
                (tmp_path / name).mkdir()
            server = Server(tmp_path / "web")
            stack.callback(server.close)
            generation = "ros" if arguments["ROS_VERSION"] == "1" else "ros2"
            live = arguments["ROS_CHANNEL"] == "live"
            where = LIVE.format(generation=generation) if live else SNAPSHOT.format(ros_distro=distro, day="final")
            repository = Repository(server.folder / where.removeprefix("http://"), codename, keys, debs(distro))
            local = LocalDistribution(distro, keys, server, Image(tmp_path / "image", codename), repository, arguments)
            local.publish()
            local.pin_keys(live="live", snapshots="snapshots")
            if live:
                local.pin("live")
            return local

        yield one


# ---- What works ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("distro", ROWS)
def test_a_row_gets_its_packages(distro: str, make: Make) -> None:
    """The first component through a mirror, of which nothing stays in the image: it names the official address."""
    local = make(distro)
    local.builds()
    command = "source /opt/ros/$0/setup.bash && [[ $ROS_DISTRO == $0 ]] && cat /etc/apt/sources.list.d/*"
    inside = local.image.run("bash", "-c", command, distro).out
    address = f"http://{local.repository.folder.relative_to(local.server.folder)}"
    assert inside.count("URIs: ") == inside.count(f"\nURIs: {address}\nSuites: {local.repository.codename}\n") == 1
    names = [path.name for path in (local.image.upper / "etc/apt/sources.list.d").iterdir()]
    assert len(names) == 1 and names[0].startswith("ros2" if local.arguments["ROS_VERSION"] == "2" else "ros-")
    assert local.versions() == (
        f"ros-distro {distro}\nros-version {local.arguments['ROS_VERSION']}\n"
        f"ros-channel {local.arguments['ROS_CHANNEL']}\nros-source {address}\n"
    )
    assert "/rosdep/base.yaml\n" in local.image.read("etc/ros/rosdep/sources.list.d/20-default.list")
    assert local.mentions() == []
    assert list((local.image.upper / "root").iterdir()) == []
    if local.arguments["ROS_VERSION"] == "2":
        assert local.apt_source_test().code == 0


SEVERAL = ("jazzy", "iron", "noetic")
"""A live repository, a final snapshot, and ROS 1: the other rows differ from them in names."""


@pytest.mark.parametrize(
    "distro", [name if name in SEVERAL else pytest.param(name, marks=pytest.mark.full(proof="apt")) for name in ROWS]
)
def test_all_components_of_a_row(distro: str, make: Make) -> None:
    """Each on the one below it, whose apt source it finds, in a system with Ubuntu's user, and with the image's own contract; then the structure tests of
    the topmost one, but for those that run ROS's programs: only real ones show that."""
    local = make(distro)
    assert "ubuntu" in local.image.run("getent", "passwd", "1000").out
    done = local.image.run("/run/components/base/contract.sh", env={"SOURCE_DATE_EPOCH": targets.EPOCH})
    assert done.code == 0, done.err
    assert local.image.run("getent", "passwd", "1000").code == 2
    assert "ubuntu" not in local.image.read("etc/group") and not (local.image.upper / "home/ubuntu").exists()
    alone = [image for image in CATALOGUE.images if image.distribution == distro and image.stack is None]
    components = [image for image in alone if "runtime" not in image.tests]
    assert len(components) > 2
    for image in components:
        done = local.builds(image.component)
        assert image.component == "core" or not any("-apt-source_" in path for path in local.server.requests)
        local.server.requests.clear()
    assert local.mentions() == []
    # As a user does: from the official address, here by way of a proxy.
    install = f"apt-get update && apt-get install --yes ros-{distro}-demo-nodes-py"
    done = local.image.run("bash", "-c", install, env={"http_proxy": local.server.url})
    assert done.code == 0, done.out + done.err
    assert local.image.run("/entrypoint.sh", "printenv", "ROS_DISTRO").out == f"{distro}\n"
    promised = dict(pair.split("=") for pair in arguments_of(components[-1].test_target)["EXPECT"].split())
    env = {f"EXPECT_{name.upper()}": text for name, text in promised.items()}
    env |= {"ROS_DISTRO": distro, "ROS_VERSION": local.arguments["ROS_VERSION"], "ROS_SYNC_DATE": ""}
    local.image.put_tests()
    assert local.image.failures("contract", env, OF_A_WHOLE_IMAGE) == []
    top = components[-1]
    tested = [file for file in (*top.tests, *top.shared) if file.startswith("ros") and file not in OF_REAL_ROS]
    assert len(tested) == len(components) + (local.arguments["ROS_VERSION"] == "2")
    for file in tested:
        assert local.image.failures(file, env, names_of_programs(file)) == []
    if local.arguments["ROS_VERSION"] == "2":
        source = f"deb {SNAPSHOT.format(ros_distro=distro, day='final')} {local.repository.codename} main"
        local.image.write("etc/apt/sources.list.d/ros2-mine.list", source)
        assert "ros2-mine.list" in local.apt_source_test().err


@pytest.mark.parametrize("distro", ["jazzy", "noetic"])
def test_a_row_that_only_runs(distro: str, make: Make) -> None:
    """It has the apt source and ROS's packages, and nothing to build with."""
    local = make(distro)
    for component in ("core-run", "base-run"):
        done = local.builds(component)
    names = [f"ros-{distro}-{name}" for name in ("ros-core", "ros-base", "demo-nodes-py")]
    states = local.image.run("dpkg-query", "--show", "--showformat", "${db:Status-Status} ", *names[:2])
    assert states.out == "installed installed ", states.err
    assert local.versions().startswith(f"ros-distro {distro}\n")
    assert not (local.image.upper / "etc/ros/rosdep").exists()
    done = local.image.run(
        "bash", "-c", f"apt-get update && apt-get install --yes {names[2]}", env={"http_proxy": local.server.url}
    )
    assert done.code == 0, done.out + done.err


OF_REAL_ROS = (
    *("ros1", "ros1-beside", "ros1-components", "ros1-workspace"),
    *("ros2-beside", "ros2-components", "ros2-workspace"),
)
"""Structure tests that are programs of ROS, all of them."""

OF_A_WHOLE_IMAGE = (
    "the Python is the one that the tag promises",
    "the banner and the recorded versions are what the tag promises",
    "no index address, proxy or certificate of the builder is left",
    "no program has the rights of another user but those that we know",
    "pip and uv keep to what parts hold, all of it and nothing else",
)
"""Structure tests of what this machine's own system has below the local replacement."""


def names_of_programs(file: str) -> list[str]:
    """The structure tests of a file that run programs of ROS; the others look at what was installed."""
    tests = yaml.safe_load((ROOT / "tests/structure" / f"{file}.yaml").read_text())["commandTests"]
    return [test["name"] for test in tests if test["command"] == "/entrypoint.sh"]


def files(folder: Path) -> list[Path]:
    return [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]


def test_packages_before_their_release(make: Make) -> None:
    """The testing repository, which the key of the live one signs: of a distribution that is not in that yet."""
    local = make("rolling")
    live = local.repository.folder
    testing = live.parent.parent / "ros2-testing" / live.name
    testing.parent.mkdir(parents=True)
    live.rename(testing)
    local.builds(ROS_CHANNEL="testing")
    assert local.versions().endswith("ros-channel testing\nros-source http://packages.ros.org/ros2-testing/ubuntu\n")
    assert not any("-apt-source_" in path for path in local.server.requests)
    assert local.apt_source_test().code == 0


def test_a_snapshot_of_a_day(make: Make) -> None:
    local = make("iron")
    final = local.repository.folder.parent
    final.rename(final.with_name("2026-08-07"))
    local.builds(ROS_CHANNEL="snapshot", ROS_SNAPSHOT="2026-08-07")
    address = SNAPSHOT.format(ros_distro="iron", day="2026-08-07")
    assert local.versions().endswith(f"ros-channel snapshot\nros-source {address}\n")


def test_the_state_of_the_repository_is_the_one_that_labels_name(make: Make) -> None:
    """Asked before a build, and compared in it with the signed file."""
    local = make("jazzy")
    source = apt_repository.of(CATALOGUE.matrix, "jazzy", {})
    assert source
    when = sync.published(source, {"ROS_APT_MIRROR": local.server.url})
    assert when == "2026-11-20T21:14:09Z"
    assert local.build(ROS_SYNC_DATE=when).code == 0


@pytest.mark.parametrize("component", ["core", "base"])
def test_a_sync_in_between_stops_the_build(component: str, make: Make) -> None:
    """Of any component: an image names one moment, of which all its packages are."""
    local = make("jazzy")
    if component == "base":
        assert local.build().code == 0
    done = local.build(component, ROS_SYNC_DATE="2026-11-13T00:00:00Z")
    assert done.code != 0
    assert "is of 2026-11-20T21:14:09Z, and not of 2026-11-13T00:00:00Z any more; run it again" in done.err
    if component == "base":
        assert local.build(component, ROS_SYNC_DATE="2026-11-20T21:14:09Z").code == 0


def test_what_a_step_wrote_has_the_time_of_the_epoch(make: Make) -> None:
    """And what it only found has its own."""
    local = make("jazzy")
    earlier = local.image.write("etc/found", "")
    os.utime(earlier, (1, 1))
    assert local.build().code == 0
    written = local.image.upper / "usr/local/share/rosml/versions.d/ros"
    assert (written.stat().st_mtime, earlier.stat().st_mtime) == (float(targets.EPOCH), 1)


def test_the_live_channel_needs_a_pinned_package(make: Make) -> None:
    done = make("foxy").build(ROS_CHANNEL="live")
    assert done.code != 0
    assert "no ros2-apt-source is pinned for focal; add apt_sources" in done.err


def test_official_addresses_through_a_proxy(make: Make) -> None:
    """Without a mirror: what is asked for are the official addresses."""
    local = make("iron")
    done = local.builds(mirror="", http_proxy=local.server.url)
    address = SNAPSHOT.format(ros_distro="iron", day="final")
    assert f"Get:1 {address} jammy InRelease" in done.out
    assert local.mentions() == []


@pytest.mark.parametrize(("distro", "both"), [("jazzy", True), ("iron", False)], ids=["both mirrors", "this one alone"])
def test_a_mirror_of_the_operating_system(distro: str, both: bool, make: Make, tmp_path: Path) -> None:
    """What ROS needs of the archive that the base image names, whichever it is, comes by way of a mirror, in which ROS's
    packages are not: nothing of either mirror stays, and apt has the official addresses again."""
    local = make(distro)
    archive = Repository(local.server.folder / "archive.test/ubuntu", local.repository.codename, local.keys)
    archive.debs = [package(tmp_path, "python3-of-ubuntu")]
    archive.publish("stranger")
    local.image.write("etc/apt/trusted.gpg.d/ubuntu.asc", local.keys.armored("stranger"))
    sources = f"deb http://archive.test/ubuntu {archive.codename} main\n"
    local.image.write("etc/apt/sources.list", sources)
    local.remove("vcstool")
    local.repository.debs.append(package(tmp_path, "python3-vcstool", "python3-of-ubuntu", version="2"))
    local.publish()
    proxy = {} if both else {"http_proxy": local.server.url, "no_proxy": "127.0.0.1"}
    ros = (LIVE if both else SNAPSHOT).removeprefix("http://").partition("/")[0]
    for component in ("core", "base"):  # the second finds ROS's source in the image
        done = local.builds(component, local.server.url if both else "", local.server.url, **proxy)
        assert f"{local.server.url}/archive.test/ubuntu" in done.out
        assert (f"{local.server.url}/{ros}" in done.out) == both
    assert "Package: python3-of-ubuntu\n" in local.image.read("var/lib/dpkg/status")
    assert local.image.read("etc/apt/sources.list") == sources
    assert local.mentions() == []
    assert list((local.image.upper / "tmp").iterdir()) == []


@pytest.mark.parametrize(("distro", "fault"), [("jazzy", "reset"), ("foxy", "500")])
def test_a_mirror_that_fails_now_and_then(distro: str, fault: str, make: Make) -> None:
    local = make(distro)
    local.server.fail(fault, 2)
    local.builds()
    assert min(local.server.requests.values()) > 0 and max(local.server.requests.values()) > 2


# ---- What stops a build ----------------------------------------------------------------------------------------------


def expired(local: LocalDistribution) -> None:
    local.repository.publish("expired")
    local.pin_keys(**{local.key: "expired"})
    if local.key == "live":
        local.pin("expired")


def other_hash(local: LocalDistribution) -> None:
    local.arguments["ROS_APT_SOURCE"] = f"{local.arguments['ROS_APT_SOURCE'].partition('@')[0]}@sha256:{'0' * 64}"


def other_release(local: LocalDistribution) -> None:
    local.arguments["ROS_APT_SOURCE"] = local.arguments["ROS_APT_SOURCE"].replace("1.2.0", "1.2.9")


def changed_package(local: LocalDistribution) -> None:
    """A mirror that is not whole: a package differs from what the signed index says."""
    pool = local.repository.folder / "pool" / "main"
    deb = next(pool.glob("*ros-core*"))
    data = bytearray(deb.read_bytes())
    deb.unlink()  # it is a link to a file of all tests
    data[-1] ^= 1
    deb.write_bytes(data)


def changed_index(local: LocalDistribution) -> None:
    release = local.repository.folder / "dists" / local.repository.codename / "InRelease"
    release.write_text(release.read_text().replace("Description: local replacement", "Description: standing"))


def second_source(local: LocalDistribution) -> None:
    local.image.write("etc/apt/sources.list.d/mine.list", f"deb {LIVE.format(generation='ros2')} noble main\n")


def mirrored_source(local: LocalDistribution) -> None:
    """Of another channel than the build's, as an image of a company may have it."""
    address = SNAPSHOT.format(ros_distro="jazzy", day="2026-08-07").replace("://", "s://mirror.test/")
    local.image.write("etc/apt/sources.list.d/mine.sources", f"Types: deb\nURIs: {address}\n")


def to_bionic(local: LocalDistribution) -> None:
    local.image.write("usr/lib/os-release", 'NAME="Ubuntu"\nVERSION_CODENAME=bionic\n')


def other_live_address(local: LocalDistribution) -> None:
    local.arguments["ROS_LIVE_ADDRESS"] = "http://live.test/ros2/ubuntu"


FAULTS: dict[str, tuple[str, Callable[[LocalDistribution], object], str, str]] = {
    "wrong hash": ("jazzy", other_hash, "and not the pinned 000", "pin its digest"),
    "no such release": ("jazzy", other_release, "does not exist", "check apt_sources"),
    "wrong key in the package": ("jazzy", lambda it: it.pin("stranger"), "another key than", "put the key of that release"),
    "wrong suite in the package": ("jazzy", lambda it: it.pin("live", "jammy"), "not say 'Suites: noble'", "apt_sources"),
    "wrong key": ("jazzy", lambda it: it.repository.publish("stranger"), "which is not a pinned one", "check the mirror"),
    "expired key, live": ("jazzy", expired, "key of an apt source has expired", "pin a newer release"),
    "expired key, final": ("iron", expired, "key of an apt source has expired", "prolonged key"),
    "snapshot for live": ("jazzy", lambda it: it.repository.publish("snapshots"), "keys/snapshots.asc", "mixed up"),
    "live for the snapshot": ("iron", lambda it: it.repository.publish("live"), "keys/live.asc", "mixed up"),
    "changed index": ("iron", changed_index, "no valid signature", "check the mirror"),
    "wrong base image": ("jazzy", to_bionic, "is 'bionic', and matrix.yaml says 'noble'", "check image"),
    "wrong suite": ("jazzy", lambda it: it.publish(says="bionic"), "suite 'bionic' in the place of 'noble'", "check the mirror"),
    "no such package": ("jazzy", lambda it: it.remove("ros-core"), "no apt source has a package", "{channel: final}"),
    "no such dependency": ("jazzy", lambda it: it.remove("ros2cli"), "ros-jazzy-ros2cli", "universe"),
    "changed package": ("jazzy", changed_package, "packages did not arrive, after 5 tries", "ROS_APT_MIRROR"),
    "no such snapshot": ("iron", lambda it: shutil.rmtree(it.repository.folder), "no such apt repository", "check 'apt' and"),
    "a second source": ("jazzy", second_source, "already (/etc/apt/sources.list.d/mine.list)", "without one"),
    "a mirror's source": ("jazzy", mirrored_source, "already (/etc/apt/sources.list.d/mine.sources)", "without"),
    "wrong address in the package": ("jazzy", other_live_address, "not say 'URIs: http://live.test", "check ros_archive"),
    "always failing": ("jazzy", lambda it: it.server.fail("500", 1000), "not answer, after 5 tries", "ROS_APT_MIRROR"),
    "unreachable": ("iron", lambda it: it.server.close(), "not answer, after 5 tries", "ROS_APT_MIRROR"),
}  # fmt: skip
"""A distribution of the matrix, what goes wrong, what is said about it, and what the remedy names."""


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_sentence_with_its_remedy(name: str, make: Make) -> None:
    distro, fault, problem, remedy = FAULTS[name]
    local = make(distro)
    fault(local)
    require_one_sentence(local.build(), problem, remedy)


@pytest.mark.parametrize("variable", ["ROS_APT_MIRROR", "OS_APT_MIRROR"])
def test_a_mirror_that_is_not_an_address(make: Make, variable: str) -> None:
    mirrors = {"ROS_APT_MIRROR": "mirror", "OS_APT_MIRROR": "os_mirror"}
    done = make("jazzy").build(**{mirrors[variable]: "host|e;id"})
    assert (done.code, done.out) == (1, "")
    assert done.err == f"error: {variable} is not an address; set it to one such as http://host:3142, or unset it\n"
