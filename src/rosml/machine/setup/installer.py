"""Programs: finds them on the machine, or installs them into ``.state/bin``."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.programs import Pin, parse_pin
from rosml.base.units import duration, size
from rosml.machine import docker
from rosml.machine.docker import Docker
from rosml.machine.setup import go_in_docker
from rosml.machine.setup.process import Call, detached, end_group, output_of, run
from rosml.machine.setup.state import State
from rosml.machine.setup.tool_cache import ToolCache

Version = tuple[int, ...]

BUILD_BYTES = 6_000_000_000
"""Disk space for the builds of the services' Go tools together, and for trivy and cosign each. It is freed afterwards."""

OLDEST_GO: Version = (1, 21)
"""From this release on, Go itself fetches the newer toolchain that a go.mod requires."""

ENGINE = ("docker", "dockerd", "containerd", "containerd-shim-runc-v2", "runc")
"""A current Docker Engine, for tests."""
GO_PROGRAMS = ("regctl", "registry", "buildx", "buildkitd", "trivy", "cosign", "actionlint", "composecheck", *ENGINE)
"""Programs that are built from Go modules; `tools/go/<name>` pins each, with all dependencies by hash."""

VERSIONS = {
    "buildx": "github.com/docker/buildx/version.Version={}",
    "buildkitd": "github.com/moby/buildkit/version.Version={}",
    "trivy": "github.com/aquasecurity/trivy/pkg/version/app.ver={}",
    "docker": "github.com/docker/cli/cli/version.Version={}",
    "dockerd": "github.com/moby/moby/v2/dockerversion.Version=29-{}",  # the module of Docker 29 has a number of its own
}
"""Variables that the linker sets to the version. A build in the program's own repository would know it."""

FLAGS = {
    "docker": "-gcflags=github.com/docker/cli/...=-lang=go1.26",  # its module has no go.mod, which would say so
    "runc": "-tags=seccomp",
}
"""Further flags of builds."""
C_PROGRAMS = {"runc"}
"""Programs that need a C compiler."""


def version_in(text: str) -> Version:
    """The first dotted number in a text: ``VCSTag: v0.11.7`` -> (0, 11, 7). Empty if there is none."""
    match = re.search(r"\d+(?:\.\d+)+", text)
    return tuple(int(number) for number in match[0].split(".")) if match else ()


def dotted(version: Version) -> str:
    return ".".join(str(number) for number in version)


class Installer:
    """`folder`: the place of the Go programs; `.state/bin` if None."""

    def __init__(self, state: State, folder: Path | None = None) -> None:
        self.state = state
        self._programs = folder or state.bin
        self.have: list[str] = []
        self._cache = ToolCache(state.cache / "tools")

    def report(self) -> None:
        """Prints the programs that were installed already. In CI, lets the next steps of the job find all programs."""
        if self.have:
            self.state.say(f"tools: {', '.join(self.have)}")
        if path := os.environ.get("GITHUB_PATH"):
            with open(path, "a", encoding="utf-8") as stream:
                stream.write(f"{self.state.bin}\n")

    # ---- what the machine has -------------------------------------------------------------------------------------
    def on_path(self, name: str, version_argument: str, oldest: Version = ()) -> str | None:
        """A program on the user's PATH (``.state/bin`` does not count), if its version fits.

        Args:
            version_argument: the argument that prints its version.
            oldest: the oldest version that fits. Without it, only the pinned one fits, because its results depend on it.
        """
        path = shutil.which(name, path=self.outer_path())
        if path is None:
            return None
        version = version_in(output_of([path, version_argument]))
        required = oldest or version_in(self.pin(name).version)
        if version == required or (oldest and version > oldest):
            self.have.append(f"{name} v{dotted(version)} (found on PATH)")
            return path
        label = f"v{dotted(version)}" if version else "of unknown version"
        reason = f"older than v{dotted(required)}" if oldest else f"not v{dotted(required)}, which is pinned"
        self.state.say(f"{name}: the one on PATH ({path}, {label}) is {reason}: not used")
        return None

    def outer_path(self) -> str:
        entries = os.environ.get("PATH", os.defpath).split(os.pathsep)
        return os.pathsep.join(entry for entry in entries if entry and Path(entry) != self.state.bin)

    @property
    def docker_program(self) -> str:
        return shutil.which("docker", path=self.outer_path()) or ""

    @cached_property
    def docker(self) -> Docker:
        return docker.ask(self.docker_program)

    # ---- Go -------------------------------------------------------------------------------------------------------
    def module(self, name: str) -> Path:
        return self.state.root / "tools" / "go" / name

    def pin(self, name: str) -> Pin:
        return parse_pin((self.module(name) / "go.mod").read_text())

    def is_built(self, name: str) -> bool:
        """Whether a program is in its folder, and its stamp says that it has the present pins."""
        stamp = self._stamp(name)
        return (self._programs / name).exists() and stamp.exists() and stamp.read_text() == self._stamp_text(name)

    def has(self, name: str) -> bool:
        """Whether a program need not be built: it is in its folder or in the user's cache."""
        return self.is_built(name) or self._cache.has(name, self._stamp_text(name))

    def _stamp(self, name: str) -> Path:
        return self._programs / f".{name}.pin"

    def _stamp_text(self, name: str) -> str:
        module = sorted(self.module(name).iterdir())
        pins = b"".join(file.read_bytes() for file in module if file.name.endswith((".go", ".mod", ".sum")))
        return f"{self.pin(name).version} {hashlib.sha256(pins).hexdigest()[:16]}\n"

    @contextmanager
    def fetching(self, names: Sequence[str]) -> Iterator[None]:
        """Fetches the modules of Go programs that are not built yet, in the background, while others compile.

        It ignores failures: the build, which waits for its modules, reports them. Nothing runs after the block.
        """
        missing = [name for name in names if not self.has(name)]
        go = shutil.which("go", path=self.go_path())
        if not missing or go is None:
            yield
            return
        self.state.say(f"Go modules of {', '.join(missing)}: fetching them in the background")
        script = 'go=$1; shift; for folder; do cd "$folder" && "$go" mod download; done'
        argv = ["sh", "-c", script, "sh", go, *(str(self.module(name)) for name in missing)]
        process = detached(Call("Go", argv, self.state.log / "go-modules.log", self.go_environment()))
        try:
            yield
        finally:
            end_group(process)

    def go_program(self, name: str) -> str:
        """The path of a Go program in its folder, copied from the user's cache or built if it is missing or its pins have changed.

        You may interrupt it: what comes has another name first, and the program's stamp comes last.
        """
        pin, program = self.pin(name), self._programs / name
        title = f"{name} {pin.version}"
        if self.is_built(name):
            self.have.append(title)
            return str(program)
        self._programs.mkdir(parents=True, exist_ok=True)
        self._stamp(name).unlink(missing_ok=True)
        for remainder in self._programs.glob(f".{name}.*.partial"):
            remainder.unlink()
        partial = self._programs / f".{name}.{os.getpid()}.partial"  # the build of a killed setup may still be running
        pins = self._stamp_text(name)
        if self._cache.take(name, pins, partial):
            self.have.append(f"{title} (built for another checkout)")
        else:
            self._build(name, partial)
            self._cache.keep(name, pins, partial)
        partial.replace(program)
        files.write(self._stamp(name), pins)
        return str(program)

    def _build(self, name: str, program: Path) -> None:
        pin = self.pin(name)
        title = f"{name} {pin.version}"
        has_go = shutil.which("go", path=self.go_path()) is not None or name in C_PROGRAMS
        in_docker = self.docker_program if not has_go and self.docker.answers else ""
        go = "go" if in_docker else self.go()
        free = shutil.disk_usage(self.state.folder).free
        if free < BUILD_BYTES:
            text = f"{size(free)} of disk are free; building {name} takes {size(BUILD_BYTES)} for the moment"
            raise RosmlError(text, "free some disk space")
        where = " in your Docker, as Go is not installed" if in_docker else ""
        self.state.say(f"{title}: building from its Go module{where}")
        started = time.monotonic()
        link = f"-s -w -X {VERSIONS[name].format(pin.version)}" if name in VERSIONS else "-s -w"
        flags = ["-trimpath", "-ldflags", link, *([FLAGS[name]] if name in FLAGS else [])]
        if in_docker:
            go_in_docker.build(self.state, in_docker, self.module(name), [go, *flags, pin.package], program)
        else:
            argv, log = [go, "build", *flags, "-o", str(program), pin.package], self.state.log / f"build-{name}.log"
            env = {**self.go_environment(), "CGO_ENABLED": "1" if name in C_PROGRAMS else "0"}
            run(self.state.say, Call(title, argv, log, env, self.module(name)))
        self.state.say(f"{title}: built from its Go module in {duration(time.monotonic() - started)}")

    def go(self) -> str:
        path = shutil.which("go", path=self.go_path())
        remedy = f"install Docker, or Go {dotted(OLDEST_GO)} or newer (https://go.dev/dl), and call this again"
        if path is None:
            raise RosmlError("Go is not installed; it builds the tools that this machine lacks", remedy)
        version = version_in(output_of([path, "version"]))
        if version < OLDEST_GO:
            text = f"{path} is Go {dotted(version)}; too old to build the tools that this machine lacks"
            raise RosmlError(text, remedy)
        return path

    def go_path(self) -> str:
        """The folders in which we look for Go: PATH, and the usual one of its archive."""
        return f"{self.outer_path()}{os.pathsep}/usr/local/go/bin"

    def go_environment(self) -> dict[str, str]:
        """The environment of a Go build: caches in the state folder, none of the user's flags."""
        dropped = ("GOOS", "GOARCH", "GO111MODULE", "GOEXPERIMENT")
        env = {name: value for name, value in os.environ.items() if name not in dropped}
        cache = self.state.folder / "go"
        (cache / "tmp").mkdir(parents=True, exist_ok=True)
        env |= {"GOMODCACHE": str(cache / "modules"), "GOCACHE": str(cache / "build"), "GOTMPDIR": str(cache / "tmp")}
        env |= {"GOFLAGS": "-mod=readonly -modcacherw -buildvcs=false", "GOWORK": "off"}
        if self.state.ca_bundle:
            env["SSL_CERT_FILE"] = self.state.ca_bundle
        return env

    def drop_go_caches(self) -> None:
        """Removes the builds' caches, more than 2 GB, in the background, as it can take a minute."""
        doomed = self.state.folder / f"go-{os.getpid()}"
        with suppress(FileNotFoundError):
            (self.state.folder / "go").rename(doomed)
            subprocess.Popen(["rm", "-rf", str(doomed)], stdin=subprocess.DEVNULL, start_new_session=True)

    # ---- Debian ---------------------------------------------------------------------------------------------------
    def apt(self, packages: Mapping[str, str], root: Sequence[str] = ()) -> str:
        missing = f"missing: {reasons_of(packages)}"
        apt = which_system("apt-get")
        if apt is None:
            raise RosmlError(f"{missing}; and this machine has no apt-get", f"install {' '.join(packages)}")
        if os.geteuid() != 0 and not root:
            raise RosmlError(f"{missing}; only root may install it", f"sudo sh -c '{by_hand(packages)}'")
        return apt

    def debian_packages(self, packages: Mapping[str, str], root: Sequence[str] = ()) -> None:
        if not packages:
            return
        apt, say = self.apt(packages, root), self.state.say
        say(f"this changes the system: installs the Debian packages {reasons_of(packages)}")
        started = time.monotonic()
        env = dict(os.environ, DEBIAN_FRONTEND="noninteractive", LC_ALL="C.UTF-8")
        options = ["-o", "DPkg::Lock::Timeout=300", "-o", "Dpkg::Use-Pty=0", "-o", "Acquire::Retries=3"]
        log = self.state.log / "apt.log"
        install = [*root, apt, *options, "install", "--yes", "--no-install-recommends", *packages]
        try:
            run(say, Call("apt-get update", [*root, apt, *options, "update"], log, env))
            run(say, Call("apt-get install", install, log, env, finish_on_interrupt=True))
        except RosmlError as error:
            raise RosmlError(error.message, f"put it right by hand: {by_hand(packages)}") from None
        say(f"Debian packages {' '.join(packages)}: installed in {duration(time.monotonic() - started)}")


def reasons_of(packages: Mapping[str, str]) -> str:
    return ", ".join(f"{package} ({why})" for package, why in packages.items())


def by_hand(packages: Mapping[str, str]) -> str:
    return f"apt-get update && apt-get install --no-install-recommends {' '.join(packages)}"


def which_system(name: str) -> str | None:
    """A program on PATH, or in the system folders that a plain user's PATH lacks."""
    return shutil.which(name) or shutil.which(name, path="/usr/local/sbin:/usr/sbin:/sbin")
