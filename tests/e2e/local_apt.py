"""Local replacements for ROS's apt repositories, for GitHub's release of ros-apt-source, and for an image that uses them.

Repositories are signed folders of real packages on a local web server, in the layout of the originals. It answers as a
mirror (each host a folder) and as an HTTP proxy (official addresses). The image is this machine's own system as an
overlay in namespaces of its own, with nothing installed and an os-release that says what Ubuntu's would.
"""

from __future__ import annotations

import gzip
import hashlib
import os
import re
import shutil
import socket
import subprocess
import tempfile
import urllib.parse
from collections.abc import Collection, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from rosml import ROOT
from tests.e2e.calls import Run
from tests.e2e.local_servers import Handler, serving

ADDRESSES = yaml.safe_load((ROOT / "matrix.yaml").read_text())["ros_archive"]
LIVE, SNAPSHOT, APT_SOURCE = ADDRESSES["live"], ADDRESSES["snapshot"], ADDRESSES["apt_source"]
"""Where ROS's repositories are, and the package that sets up the live one; components/ros/source.sh has to ask there."""

SYNC = "Fri, 20 Nov 2026 21:14:09 UTC"
PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"

PACKAGES = {
    "ros-{distro}-ros-workspace": "",
    "ros-{distro}-ros2cli": "ros-{distro}-ros-workspace",
    "ros-{distro}-rclpy": "ros-{distro}-ros-workspace",
    "ros-{distro}-ros-core": "ros-{distro}-ros2cli, ros-{distro}-rclpy, ros-{distro}-ros-workspace",
    "ros-{distro}-tf2-ros": "ros-{distro}-ros-workspace",
    "ros-{distro}-rosbag2": "ros-{distro}-ros-workspace",
    "ros-{distro}-ros-base": "ros-{distro}-ros-core, ros-{distro}-tf2-ros, ros-{distro}-rosbag2",
    "ros-{distro}-robot": "ros-{distro}-ros-base",
    "ros-{distro}-image-transport": "",
    "ros-{distro}-vision-opencv": "",
    "ros-{distro}-perception-pcl": "",
    "ros-{distro}-perception": (
        "ros-{distro}-ros-base, ros-{distro}-image-transport, ros-{distro}-vision-opencv, ros-{distro}-perception-pcl"
    ),
    "ros-{distro}-rviz2": "",
    "ros-{distro}-rqt": "",
    "ros-{distro}-desktop": "ros-{distro}-ros-base, ros-{distro}-rviz2, ros-{distro}-rqt",
    "ros-{distro}-simulation": "ros-{distro}-ros-base",
    "ros-{distro}-desktop-full": "ros-{distro}-desktop, ros-{distro}-perception, ros-{distro}-simulation",
    "ros-{distro}-demo-nodes-py": "ros-{distro}-rclpy",
    "ros-{distro}-broken": "ros-{distro}-nowhere",
    "python3-colcon-common-extensions": "",
    "python3-rosdep": "",
    "python3-vcstool": "",
}
"""Packages of a repository with what they depend on, as REP 2001 has the variants."""


# ---- Keys ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Keys:
    """Signing keys, made here: of the live repository, of the snapshots, of a stranger, and one that has expired."""

    home: Path

    PAST = "20250101T000000"

    def make(self, name: str) -> None:
        """Makes a key; `expired` had thirty days in the past."""
        arguments = ["--passphrase", "", "--quick-generate-key", f"{name} <{name}@example.org>", "ed25519", "sign"]
        self._gpg(name, *arguments, "30d" if name == "expired" else "0")

    def armored(self, name: str) -> str:
        """The public key as text."""
        return self._gpg(name, "--armor", "--export", f"{name}@example.org")

    def sign(self, name: str, text: Path, signed: Path) -> None:
        """Writes a text with its signature inside."""
        self._gpg(name, "--local-user", f"{name}@example.org", "--output", str(signed), "--clear-sign", str(text))

    def _gpg(self, name: str, *arguments: str) -> str:
        then = ["--faked-system-time", self.PAST] if name == "expired" else []
        argv = ["gpg", "--homedir", str(self.home), "--batch", "--yes", "--quiet", *then, *arguments]
        return subprocess.run(argv, check=True, capture_output=True, text=True).stdout


@contextmanager
def signing_keys(*names: str) -> Iterator[Keys]:
    """Makes keys by name."""
    with tempfile.TemporaryDirectory(prefix="gpg-") as home:  # short: gpg's sockets are in it
        keys = Keys(Path(home))
        try:
            for name in names:
                keys.make(name)
            yield keys
        finally:
            subprocess.run(["gpgconf", "--homedir", home, "--kill", "all"], check=False)  # the agent that gpg starts


# ---- Packages and repositories ---------------------------------------------------------------------------------------


def package(
    folder: Path, name: str, depends: str = "", files: dict[str, str] | None = None, version: str = "1"
) -> Path:
    """Builds a package with some files; a text that begins with -> is a link."""
    tree = folder / "tree" / name
    control = f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: nobody <nobody@example.org>\n"
    control += (f"Depends: {depends}\n" if depends else "") + "Description: local replacement\n"
    for path, text in {"DEBIAN/control": control, **(files or {})}.items():
        file = tree / path
        file.parent.mkdir(parents=True, exist_ok=True)
        if text.startswith("->"):
            file.symlink_to(text.removeprefix("->"))
        else:
            file.write_text(text)
            file.chmod(0o755 if text.startswith("#!") else 0o644)
    deb = folder / f"{name}_{version}_all.deb"
    argv = ["dpkg-deb", "--root-owner-group", "-Zgzip", "-z1", "--build", str(tree), str(deb)]
    subprocess.run(argv, check=True, capture_output=True)
    shutil.rmtree(tree)
    return deb


def apt_source(folder: Path, generation: str, codename: str, key: str) -> Path:
    """ROS's package, laid out as release 1.2.0: no scripts, a link to the source, which holds the key for new apts."""
    embedded = "\n".join(f" {line or '.'}" for line in key.strip().splitlines())
    keyring = f"usr/share/keyrings/{generation}-archive-keyring.gpg"
    source = (
        f"Types: deb deb-src\nURIs: {LIVE.format(generation=generation)}\nSuites: {codename}\nComponents: main\n"
        f"Signed-By:{f' /{keyring}' if codename == 'focal' else embedded}\n"
    )
    files = {
        keyring: key,
        f"usr/share/ros-apt-source/{generation}.sources": source,
        f"etc/apt/sources.list.d/{generation}.sources": f"->/usr/share/ros-apt-source/{generation}.sources",
    }
    return package(folder, f"{generation}-apt-source", "", files, f"1.2.0~{codename}")


def contents(distro: str) -> dict[str, dict[str, str]]:
    """Files of packages: what the entrypoint sources, in the place where ROS has it. No program of ROS is replaced: images with
    real ones run those."""
    return {f"ros-{distro}-ros-workspace": {f"opt/ros/{distro}/setup.bash": f"export ROS_DISTRO={distro}\n"}}


def ros_packages(folder: Path, distro: str) -> list[Path]:
    """The packages of a distribution: its components, and what they need."""
    files = contents(distro)
    folder.mkdir(parents=True, exist_ok=True)
    filled = {name.format(distro=distro): depends.format(distro=distro) for name, depends in PACKAGES.items()}
    assert files.keys() <= filled.keys()
    return [package(folder, name, depends, files.get(name)) for name, depends in filled.items()]


@dataclass
class Repository:
    """A signed apt repository in a folder, as aptly publishes it."""

    folder: Path
    codename: str
    keys: Keys
    debs: list[Path] = field(default_factory=list)

    def publish(self, key: str, says: str | None = None) -> None:
        """Writes index and signature; `says` is the suite that its Release file claims to be."""
        pool = self.folder / "pool" / "main"
        suite = self.folder / "dists" / self.codename
        shutil.rmtree(suite, ignore_errors=True)
        pool.mkdir(parents=True, exist_ok=True)
        for deb in self.debs:
            if not (pool / deb.name).exists():
                (pool / deb.name).hardlink_to(deb)
        index = "\n".join(self._entry(pool / deb.name) for deb in self.debs).encode()
        files = {f"main/binary-{name}/Packages": index for name in ("amd64", "arm64")} | {"main/source/Sources": b""}
        files |= {f"{name}.gz": gzip.compress(data, mtime=0) for name, data in files.items()}
        for name, data in files.items():
            (suite / name).parent.mkdir(parents=True, exist_ok=True)
            (suite / name).write_bytes(data)
        says = says or self.codename
        release = f"Origin: . {says}\nLabel: . {says}\nSuite: {says}\nCodename: {says}\nDate: {SYNC}\n"
        release += "Architectures: amd64 arm64\nComponents: main\nDescription: local replacement\nSHA256:\n"
        release += "".join(f" {hashlib.sha256(data).hexdigest()} {len(data)} {name}\n" for name, data in files.items())
        text = self.folder / "Release"
        text.write_text(release)
        self.keys.sign(key, text, suite / "InRelease")

    def _entry(self, deb: Path) -> str:
        control = subprocess.run(["dpkg-deb", "--field", str(deb)], check=True, capture_output=True, text=True).stdout
        data = deb.read_bytes()
        where = f"Filename: {deb.relative_to(self.folder)}\nSize: {len(data)}\n"
        return f"{control}{where}SHA256: {hashlib.sha256(data).hexdigest()}\n"


# ---- The web server --------------------------------------------------------------------------------------------------


class Server:
    """Serves a folder of hosts, as a mirror and as a proxy; may fail the first requests for each file."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.fault = ""
        self.failures = 0
        self.requests: dict[str, int] = {}
        self._stack = ExitStack()
        self.url = f"http://{self._stack.enter_context(serving(self._handler()))}"

    def fail(self, fault: str, times: int) -> None:
        """From now on, the first `times` requests for each file fail: `500`, or `reset` in the middle of an answer."""
        self.fault, self.failures, self.requests = fault, times, {}

    def close(self) -> None:
        self._stack.close()

    def _handler(self) -> type[Handler]:
        server = self

        class Host(Handler):
            def do_GET(self) -> None:
                url = urllib.parse.urlsplit(self.path)
                path = f"{url.hostname or ''}/{urllib.parse.unquote(url.path).lstrip('/')}".lstrip("/")
                server.requests[path] = server.requests.get(path, 0) + 1
                failing = server.requests[path] <= server.failures
                file = server.folder / path
                if failing and server.fault == "500":
                    self.send_error(500)
                elif not file.is_file():
                    self.send_error(404)
                elif failing:
                    data = file.read_bytes()
                    self.reply(200, data[: len(data) // 2], {"Content-Length": str(len(data))})
                    self.close_connection = True
                    self.connection.shutdown(socket.SHUT_RDWR)
                else:
                    self.reply(200, file.read_bytes())

        return Host


# ---- The image -------------------------------------------------------------------------------------------------------

EMPTY = (
    *("etc/apt", "opt", "root", "run", "tmp", "usr/local"),
    *("var/cache", "var/lib/apt", "var/lib/dpkg", "var/log", "var/tmp"),
)
"""What the image has of its own, instead of this machine's."""

DIRECTORIES = (
    "etc/apt/apt.conf.d",
    "etc/apt/preferences.d",
    "etc/apt/sources.list.d",
    "etc/apt/trusted.gpg.d",
    "etc/sudoers.d",
    "run/components",
    "run/secrets",
    "var/lib/dpkg/info",
    "var/lib/dpkg/triggers",
    "var/lib/dpkg/updates",
    "usr/local/bin",
    "usr/local/sbin",
    "var/cache/apt/archives/partial",
    "var/log/apt",
)

PASSWD = """\
root:x:0:0:root:/root:/bin/bash
daemon:x:1:1:daemon:/usr/sbin:/usr/sbin/nologin
_apt:x:42:65534::/nonexistent:/usr/sbin/nologin
nobody:x:65534:65534:nobody:/nonexistent:/usr/sbin/nologin
ubuntu:x:1000:1000:Ubuntu:/home/ubuntu:/bin/bash
"""
GROUP = "root:x:0:\ndaemon:x:1:\nsudo:x:27:ubuntu\nvideo:x:44:ubuntu\nnogroup:x:65534:\nubuntu:x:1000:\n"
"""Ubuntu's own image has a user since 24.04."""

ENTER = """\
set -e
mount -t overlay overlay -o "lowerdir=/,upperdir=$1/upper,workdir=$1/work" "$1/root"
mount --bind "$2" "$1/root/run/components"
mount --rbind /dev "$1/root/dev"
mount -t proc proc "$1/root/proc"
shift 2
exec chroot "$ROOT" "$@"
"""


class Image:
    """A system that build steps change, as they do in an image; what they write stays in `upper`."""

    def __init__(self, folder: Path, codename: str) -> None:
        self.folder = folder
        self.upper = folder / "upper"
        self.components = folder / "components"
        shutil.copytree(ROOT / "components", self.components)
        for name in ("work", "root"):
            (folder / name).mkdir()
        for name in EMPTY:
            (self.upper / name).mkdir(parents=True)
            os.setxattr(self.upper / name, "trusted.overlay.opaque", b"y")
        for name in ("tmp", "var/tmp"):
            (self.upper / name).chmod(0o1777)
        for name in DIRECTORIES:
            (self.upper / name).mkdir(parents=True, exist_ok=True)
        self.write("var/lib/dpkg/status", "")
        self.write("usr/lib/os-release", f'NAME="Ubuntu"\nID=ubuntu\nVERSION_CODENAME={codename}\n')
        # The pauses between two tries are for mirrors; nobody has to wait for this one.
        self.write("usr/local/sbin/sleep", "#!/bin/sh\n").chmod(0o755)
        # This machine's own files, which lie below, are no part of the image.
        places = " ".join(f"/{name}" for name in ("etc", "opt", "root", "usr/local", "var/cache", "var/lib/dpkg"))
        narrow = f'#!/bin/sh\nif [ "$1" = / ]; then shift; set -- {places} "$@"; fi\nexec /usr/bin/find "$@"\n'
        self.write("usr/local/sbin/find", narrow).chmod(0o755)
        self.write("usr/local/bin/cmake", "#!/bin/sh\necho cmake version 3.28.3\n").chmod(0o755)
        self.write("etc/apt/apt.conf.d/no-delay", 'Acquire::Retries::Delay "false";\n')
        self.write("etc/passwd", PASSWD)
        self.write("etc/group", GROUP)
        self.write("etc/shadow", "root:*:20000:0:99999:7:::\nubuntu:!:20000:0:99999:7:::\n").chmod(0o640)
        self.write("etc/gshadow", "root:*::\nsudo:*::ubuntu\nvideo:*::\nubuntu:!::\n").chmod(0o640)
        for path in (self.write("home/ubuntu/.profile", ""), self.upper / "home/ubuntu"):
            os.chown(path, 1000, 1000)
        self.write("etc/dpkg/dpkg.cfg.d/docker-apt-speedup", "force-unsafe-io\n")  # as in Ubuntu's own image

    def write(self, path: str, text: str) -> Path:
        """Writes a file of the image."""
        file = self.upper / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def read(self, path: str) -> str:
        """A file that a step wrote."""
        return (self.upper / path).read_text()

    def put_tests(self) -> None:
        """The structure tests, where a build mounts them."""
        shutil.copytree(ROOT / "tests/structure", self.upper / "run/tests", dirs_exist_ok=True)

    def failures(self, file: str, env: dict[str, str], leave: Collection[str] = ()) -> list[str]:
        """What a file of structure tests finds wrong, but for tests that are left out."""
        tests = yaml.safe_load((ROOT / "tests/structure" / f"{file}.yaml").read_text())["commandTests"]
        assert set(leave) <= {test["name"] for test in tests}
        wrong = []
        for test in tests:
            variables = {item["key"]: item["value"] for item in test.get("envVars", ())}
            if test["name"] in leave:
                continue
            done = self.run(test["command"], *map(str, test.get("args", ())), env={**env, **variables})
            expected = test.get("expectedOutput", ())
            if done.code != test.get("exitCode", 0) or not all(re.search(words, done.out) for words in expected):
                wrong.append(f"{file}: {test['name']}: {done}")
        return wrong

    def run(self, *command: str, env: dict[str, str] | None = None, **secrets: str) -> Run:
        """Runs a command in it, as the builder does: only the arguments are in its environment, secrets are files."""
        files = [self.write(f"run/secrets/{name.replace('_', '-')}", text) for name, text in secrets.items()]
        # What ends the namespaces' first process ends the mounts with it.
        namespaces = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]
        enter = ["bash", "-c", ENTER, "enter", str(self.folder), str(self.components)]
        done = subprocess.run(
            [*namespaces, *enter, *command],
            env={"PATH": PATH, "ROOT": str(self.folder / "root"), "LANG": "C.UTF-8", "HOME": "/root", **(env or {})},
            cwd="/",
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        for file in files:
            file.unlink()
        return Run(done.returncode, done.stdout, done.stderr)


def require_one_sentence(done: Run, problem: str, remedy: str) -> None:
    """Asserts that a step failed with one error, which names the problem and what to do."""
    assert done.code == 1, done.out + done.err
    errors = [line for line in done.err.splitlines() if line.startswith("error: ")]
    assert len(errors) == 1, done.out + done.err
    sentence, _, advice = errors[0].rpartition("; ")
    assert problem in sentence and remedy in advice, errors[0]
