"""Stand-ins for ROS's apt repositories, for GitHub's release of ros-apt-source, and for an image that uses them.

Repositories are signed folders of real packages on a local web server, in the layout of the originals. It answers as a
mirror (each host a folder) and as an HTTP proxy (official addresses). The image is this machine's own system as an
overlay in namespaces of its own, with nothing installed and an os-release that says what Ubuntu's would.
"""

from __future__ import annotations

import gzip
import hashlib
import http.server
import os
import shutil
import socket
import subprocess
import threading
import urllib.parse
from dataclasses import dataclass, field
from pathlib import Path

from rosml import ROOT
from tests.e2e.conftest import Run

GITHUB = "github.com/ros-infrastructure/ros-apt-source/releases/download"
SYNC = "Fri, 20 Nov 2026 21:14:09 UTC"
PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"

PACKAGES = {
    "ros-{distro}-ros-workspace": "",
    "ros-{distro}-ros2cli": "ros-{distro}-ros-workspace",
    "ros-{distro}-ros-core": "ros-{distro}-ros2cli, ros-{distro}-ros-workspace",
    "ros-{distro}-ros-base": "ros-{distro}-ros-core",
    "ros-{distro}-broken": "ros-{distro}-nowhere",
    "python3-colcon-common-extensions": "",
    "python3-rosdep": "",
    "python3-vcstool": "",
}
"""Packages of a repository with what they depend on."""


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

    def close(self) -> None:
        """Stops the agent that gpg starts."""
        subprocess.run(["gpgconf", "--homedir", str(self.home), "--kill", "all"], check=False)

    def _gpg(self, name: str, *arguments: str) -> str:
        then = ["--faked-system-time", self.PAST] if name == "expired" else []
        argv = ["gpg", "--homedir", str(self.home), "--batch", "--yes", "--quiet", *then, *arguments]
        return subprocess.run(argv, check=True, capture_output=True, text=True).stdout


# ---- Packages and repositories ---------------------------------------------------------------------------------------


def package(
    folder: Path, name: str, depends: str = "", files: dict[str, str] | None = None, version: str = "1"
) -> Path:
    """Builds a package with some files; a text that begins with -> is a link."""
    tree = folder / "tree" / name
    control = f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: nobody <nobody@example.org>\n"
    control += (f"Depends: {depends}\n" if depends else "") + "Description: stand-in\n"
    for path, text in {"DEBIAN/control": control, **(files or {})}.items():
        file = tree / path
        file.parent.mkdir(parents=True, exist_ok=True)
        if text.startswith("->"):
            file.symlink_to(text.removeprefix("->"))
        else:
            file.write_text(text)
            file.chmod(0o755 if "/bin/" in path else 0o644)
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
        f"Types: deb deb-src\nURIs: http://packages.ros.org/{generation}/ubuntu\nSuites: {codename}\nComponents: main\n"
        f"Signed-By:{f' /{keyring}' if codename == 'focal' else embedded}\n"
    )
    files = {
        keyring: key,
        f"usr/share/ros-apt-source/{generation}.sources": source,
        f"etc/apt/sources.list.d/{generation}.sources": f"->/usr/share/ros-apt-source/{generation}.sources",
    }
    return package(folder, f"{generation}-apt-source", "", files, f"1.2.0~{codename}")


def ros_packages(folder: Path, distro: str) -> list[Path]:
    """The packages of a distribution: its components, and a command `ros2` that needs its setup.bash."""
    opt = f"opt/ros/{distro}"
    command = '#!/bin/sh\n[ -n "$ROS_DISTRO" ] && echo "usage: ros2, of $ROS_DISTRO"\n'
    files = {
        f"ros-{distro}-ros-workspace": {f"{opt}/setup.bash": f"export ROS_DISTRO={distro} PATH=/{opt}/bin:$PATH\n"},
        f"ros-{distro}-ros2cli": {f"{opt}/bin/ros2": command},
    }
    folder.mkdir(parents=True, exist_ok=True)
    filled = {name.format(distro=distro): depends.format(distro=distro) for name, depends in PACKAGES.items()}
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
        release += "Architectures: amd64 arm64\nComponents: main\nDescription: stand-in\nSHA256:\n"
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
        self.asked: dict[str, int] = {}
        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), self._handler())
        self.url = f"http://127.0.0.1:{self._server.server_port}"
        threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()

    def fail(self, fault: str, times: int) -> None:
        """From now on, the first `times` requests for each file fail: `500`, or `reset` in the middle of an answer."""
        self.fault, self.failures, self.asked = fault, times, {}

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()

    def _handler(self) -> type[http.server.BaseHTTPRequestHandler]:
        server = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                url = urllib.parse.urlsplit(self.path)
                path = f"{url.hostname or ''}/{urllib.parse.unquote(url.path).lstrip('/')}".lstrip("/")
                server.asked[path] = server.asked.get(path, 0) + 1
                failing = server.asked[path] <= server.failures
                file = server.folder / path
                if failing and server.fault == "500":
                    self.send_error(500)
                elif not file.is_file():
                    self.send_error(404)
                else:
                    data = file.read_bytes()
                    self.send_response(200)
                    self.send_header("Content-Length", str(len(data)))
                    self.end_headers()
                    self.wfile.write(data[: len(data) // 2] if failing else data)
                    if failing:
                        self.close_connection = True
                        self.connection.shutdown(socket.SHUT_RDWR)

            def log_message(self, format: str, *args: object) -> None:
                pass

        return Handler


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
    "run/components",
    "run/secrets",
    "var/lib/dpkg/info",
    "var/lib/dpkg/triggers",
    "var/lib/dpkg/updates",
    "usr/local/sbin",
    "var/cache/apt/archives/partial",
    "var/log/apt",
)

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
        self.write("etc/apt/apt.conf.d/no-delay", 'Acquire::Retries::Delay "false";\n')
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

    def run(self, *command: str, env: dict[str, str] | None = None, mirror: str = "") -> Run:
        """Runs a command in it, as the builder does: only the arguments are in its environment."""
        secret = self.write("run/secrets/ros-apt-mirror", mirror)
        # What ends the namespaces' first process ends the mounts with it.
        namespaces = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]
        enter = ["bash", "-c", ENTER, "enter", str(self.folder), str(self.components)]
        done = subprocess.run(
            [*namespaces, *enter, *command],
            env={"PATH": PATH, "ROOT": str(self.folder / "root"), "LANG": "C.utf8", "HOME": "/root", **(env or {})},
            cwd="/",
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        secret.unlink()
        return Run(done.returncode, done.stdout, done.stderr)
