"""Programs: taken from the machine where they are, installed into ``.state/bin`` where they are not."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from machine.console import Failure, elapsed, end_group, run, say
from machine.state import State, write_atomically

Version = tuple[int, ...]

BUILD_BYTES = 6_000_000_000
"""Disk that the builds of the services' Go tools need together, and those of trivy and cosign each by itself; removed
afterwards."""

OLDEST_GO: Version = (1, 21)
"""From this release on Go fetches the newer toolchain that a go.mod asks for by itself."""


OLDEST_PYTHON: Version = (3, 11)
"""That the commands run with, as pyproject.toml has it."""


GROUPS = ("app", "dev", "page")
"""Of Python packages, each with those before it: of the commands; of linters and tests; of the page's tests."""


@dataclass(frozen=True)
class GoTool:
    """A program built from its Go module; ``tools/go/<folder>`` pins it and all its dependencies by hash."""

    name: str
    folder: str


REGCTL = GoTool("regctl", "regctl")
REGISTRY = GoTool("registry", "registry")
BUILDX = GoTool("buildx", "buildx")
BUILDKITD = GoTool("buildkitd", "buildkit")
TRIVY = GoTool("trivy", "trivy")
COSIGN = GoTool("cosign", "cosign")
ACTIONLINT = GoTool("actionlint", "actionlint")
GO_TOOLS = (REGCTL, REGISTRY, BUILDX, BUILDKITD, TRIVY, COSIGN, ACTIONLINT)


LAUNCHER = """\
#!{python}
import sys

sys.path.insert(0, {root!r})

import rosml.base.environment
from rosml.cli.main import run

sys.exit(run())
"""
"""The command `rosml` of this checkout, in `.state/bin`."""


@dataclass(frozen=True)
class Pin:
    """What a go.mod says of its tool: the package to build (``.``: the main.go beside it) and the version of its module."""

    package: str
    version: str


def parse_pin(go_mod: str) -> Pin:
    """Reads a go.mod: with one ``tool`` line, or that of a program of our own, which requires one module directly.

    Raises:
        ValueError: neither says what to build, or the tool's module is not required.
    """
    required = re.findall(r"^(?:require)?\s+(\S+) (v\S+)( // indirect)?$", go_mod, re.MULTILINE)
    tool = re.search(r"^tool (\S+)$", go_mod, re.MULTILINE)
    if not tool:
        direct = [version for _module, version, indirect in required if not indirect]
        if len(direct) != 1:
            raise ValueError("no tool line, and not one module that is required directly")
        return Pin(".", direct[0])
    package = tool[1]
    modules = [
        (module, version)
        for module, version, _indirect in required
        if package == module or package.startswith(f"{module}/")
    ]
    if not modules:
        raise ValueError(f"no module provides {package}")
    return Pin(package, max(modules)[1])


def version_in(text: str) -> Version:
    """The first dotted number in a text: ``VCSTag: v0.11.7`` -> (0, 11, 7). Empty where there is none."""
    match = re.search(r"\d+(?:\.\d+)+", text)
    return tuple(int(number) for number in match[0].split(".")) if match else ()


def dotted(version: Version) -> str:
    """(0, 11, 7) -> ``0.11.7``."""
    return ".".join(str(number) for number in version)


def output_of(argv: Sequence[str], seconds: float = 20.0, env: Mapping[str, str] | None = None) -> str | None:
    """What a short command prints, or nothing where it is missing, fails or hangs."""
    try:
        done = subprocess.run(
            argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=seconds, env=env, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None


class Installer:
    """Finds or installs programs for one checkout."""

    def __init__(self, state: State, ca_bundle: str) -> None:
        self.state = state
        self.ca_bundle = ca_bundle
        self.have: list[str] = []

    def report(self) -> None:
        """Says in one line what was there already."""
        if self.have:
            say(f"tools: {', '.join(self.have)}")

    # ---- what the machine has -------------------------------------------------------------------------------------
    def found(self, name: str, ask: Sequence[str], oldest: Version) -> str | None:
        """A program on the user's PATH (``.state/bin`` does not count), if its version will do."""
        path = shutil.which(name, path=self.outer_path())
        if path is None:
            return None
        version = version_in(output_of([path, *ask]) or "")
        if version >= oldest:
            self.have.append(f"{name} v{dotted(version)} (found on PATH)")
            return path
        has = f"v{dotted(version)}" if version else "of unknown version"
        say(f"{name}: the one on PATH ({path}, {has}) is older than v{dotted(oldest)}: not used")
        return None

    def found_exactly(self, tool: GoTool, ask: Sequence[str]) -> str | None:
        """A program on the user's PATH that is of the very version that is pinned: for a tool whose findings depend on
        its version."""
        path = shutil.which(tool.name, path=self.outer_path())
        if path is None:
            return None
        wanted = version_in(self.pin(tool).version)
        version = version_in(output_of([path, *ask]) or "")
        if version == wanted:
            self.have.append(f"{tool.name} v{dotted(version)} (found on PATH)")
            return path
        has = f"v{dotted(version)}" if version else "of unknown version"
        say(f"{tool.name}: the one on PATH ({path}, {has}) is not v{dotted(wanted)}, which is pinned: not used")
        return None

    def outer_path(self) -> str:
        """PATH without our own folder."""
        entries = os.environ.get("PATH", os.defpath).split(os.pathsep)
        return os.pathsep.join(entry for entry in entries if entry and Path(entry) != self.state.bin)

    # ---- Go -------------------------------------------------------------------------------------------------------
    def pin(self, tool: GoTool) -> Pin:
        """What pins a Go program."""
        return parse_pin((self.module(tool) / "go.mod").read_text())

    def module(self, tool: GoTool) -> Path:
        """Folder of the Go module that pins a program."""
        return self.state.root / "tools" / "go" / tool.folder

    def stamp(self, tool: GoTool) -> Path:
        """The file that vouches for a program in ``.state/bin``."""
        return self.state.bin / f".{tool.name}.pin"

    def stamp_text(self, tool: GoTool) -> str:
        """What that file says where the program is the pinned one."""
        return f"{self.pin(tool).version} {pins_digest(self.module(tool))}\n"

    def is_built(self, tool: GoTool) -> bool:
        """Whether a program is in ``.state/bin`` as it is pinned now."""
        stamp = self.stamp(tool)
        built = (self.state.bin / tool.name).exists() and stamp.exists()
        return built and stamp.read_text() == self.stamp_text(tool)

    @contextmanager
    def fetching(self, tools: Sequence[GoTool]) -> Iterator[None]:
        """Fetches the modules of Go programs that are not built yet in the background, while others compile.

        A failure is not told: the build, which waits for what it needs, tells it. Nothing runs on after the block.
        """
        folders = [str(self.module(tool)) for tool in tools if not self.is_built(tool)]
        go = shutil.which("go", path=self.go_path())
        if not folders or go is None:
            yield
            return
        say(f"Go modules of {', '.join(Path(folder).name for folder in folders)}: fetching them in the background")
        script = 'go=$1; shift; for folder; do cd "$folder" && "$go" mod download; done'
        with (self.state.log / "go-modules.log").open("ab") as log:
            process = subprocess.Popen(
                ["sh", "-c", script, "sh", go, *folders],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                env=self.go_environment(),
                start_new_session=True,
            )
        try:
            yield
        finally:
            end_group(process)

    def go_tool(self, tool: GoTool) -> str:
        """Path of a Go program in ``.state/bin``, built if it is not there or its pins have changed.

        Safe to interrupt: the build goes to another name, and the stamp that vouches for the program comes last.
        """
        module = self.module(tool)
        pin = self.pin(tool)
        wanted = self.stamp_text(tool)
        program = self.state.bin / tool.name
        stamp = self.stamp(tool)
        if self.is_built(tool):
            self.have.append(f"{tool.name} {pin.version}")
            return str(program)
        go = self.go()
        free = shutil.disk_usage(self.state.folder).free
        if free < BUILD_BYTES:
            raise Failure(
                f"{free / 1e9:.1f} GB of disk are free; building {tool.name} takes {BUILD_BYTES / 1e9:.0f} GB for the moment",
                "free some disk space",
            )
        say(f"{tool.name} {pin.version}: building from its Go module")
        started = time.monotonic()
        stamp.unlink(missing_ok=True)
        for left in self.state.bin.glob(f".{tool.name}.*.partial"):
            left.unlink()
        partial = self.state.bin / f".{tool.name}.{os.getpid()}.partial"  # a killed set-up's build may still be running
        link = f"-s -w {version_flag(pin)}".strip()
        run(
            f"{tool.name} {pin.version}",
            [go, "build", "-trimpath", "-ldflags", link, "-o", str(partial), pin.package],
            self.state.log / f"build-{tool.name}.log",
            env=self.go_environment(),
            cwd=module,
        )
        os.replace(partial, program)
        write_atomically(stamp, wanted)
        say(f"{tool.name} {pin.version}: built from its Go module in {elapsed(started)}")
        return str(program)

    def go(self) -> str:
        """Path of the Go command.

        Raises:
            Failure: there is none, or it is too old to fetch the release that the pins need.
        """
        path = shutil.which("go", path=self.go_path())
        remedy = f"install Go {dotted(OLDEST_GO)} or newer (https://go.dev/dl) and call this again"
        if path is None:
            raise Failure("Go is not installed; it builds the tools that this machine lacks", remedy)
        version = version_in(output_of([path, "version"]) or "")
        if version < OLDEST_GO:
            raise Failure(f"{path} is Go {dotted(version)}; too old to build the tools that this machine lacks", remedy)
        return path

    def go_path(self) -> str:
        """Where Go is looked for: on PATH, and where its own archive is unpacked."""
        return f"{self.outer_path()}{os.pathsep}/usr/local/go/bin"

    def go_environment(self) -> dict[str, str]:
        """Environment of a Go build: caches in the state folder, none of the user's flags, no C compiler needed."""
        env = dict(os.environ)
        for name in ("GOOS", "GOARCH", "GO111MODULE", "GOEXPERIMENT"):
            env.pop(name, None)
        cache = self.state.folder / "go"
        (cache / "tmp").mkdir(parents=True, exist_ok=True)
        env.update(
            GOMODCACHE=str(cache / "modules"),
            GOCACHE=str(cache / "build"),
            GOTMPDIR=str(cache / "tmp"),
            GOFLAGS="-mod=readonly -modcacherw -buildvcs=false",
            GOWORK="off",
            CGO_ENABLED="0",
        )
        if self.ca_bundle:
            env["SSL_CERT_FILE"] = self.ca_bundle
        return env

    def drop_go_caches(self) -> None:
        """Removes what the builds left, more than 2 GB: beside the work, as it can take a minute.

        The module cache is writable: ``-modcacherw``.
        """
        old = self.state.folder / f"go-{os.getpid()}"
        try:
            (self.state.folder / "go").rename(old)
            subprocess.Popen(["rm", "-rf", str(old)], stdin=subprocess.DEVNULL, start_new_session=True)
        except OSError:
            shutil.rmtree(self.state.folder / "go", ignore_errors=True)

    # ---- Python ---------------------------------------------------------------------------------------------------
    def uv(self, oldest: Version) -> str:
        """Path of uv: the user's, or the pinned Python package's program in ``.state/bin``."""
        path = self.found("uv", ["--version"], oldest)
        if path:
            return path
        requirements = self.state.root / "tools" / "requirements.txt"
        wanted = requirements.read_text()
        version = re.search(r"^uv==(\S+)", wanted, re.MULTILINE)
        name = f"uv {version[1] if version else ''}"
        program = self.state.bin / "uv"
        stamp = self.state.bin / ".uv.pin"
        if program.exists() and stamp.exists() and stamp.read_text() == wanted:
            self.have.append(name)
            return str(program)
        started = time.monotonic()
        if output_of([sys.executable, "-c", "import ensurepip, venv"]) is None:
            self.debian_packages({"python3-venv": "installs uv"})
        say(f"{name}: installing its Python package")
        stamp.unlink(missing_ok=True)
        shutil.rmtree(self.state.folder / "tools", ignore_errors=True)
        venv = self.state.folder / "tools" / f"uv-{os.getpid()}"
        log = self.state.log / "install-uv.log"
        env = dict(os.environ, PIP_DISABLE_PIP_VERSION_CHECK="1", PIP_NO_INPUT="1")
        if self.ca_bundle:
            env.setdefault("PIP_CERT", self.ca_bundle)
        run(name, [sys.executable, "-m", "venv", str(venv)], log, env=env)
        pip = [str(venv / "bin" / "python"), "-m", "pip", "install", "--require-hashes", "--no-deps"]
        run(name, [*pip, "--no-cache-dir", "--requirement", str(requirements)], log, env=env)
        os.replace(venv / "bin" / "uv", program)
        shutil.rmtree(self.state.folder / "tools", ignore_errors=True)
        write_atomically(stamp, wanted)
        say(f"{name}: installed from its Python package in {elapsed(started)}")
        return str(program)

    def packages(self, uv: str, group: str = "dev") -> None:
        """Installs the Python packages of ``tools/requirements-<group>.txt`` into ``.venv``, and removes others.

        Args:
            group: of ``GROUPS``. Where a larger one was installed before, it stays: otherwise a command would take away what
                the tests beside it import.

        Raises:
            Failure: a package has none of the hashes in the file, or cannot be had.
        """
        started = time.monotonic()
        venv, log = self.state.root / ".venv", self.state.log / "packages.log"
        env = dict(os.environ, UV_COMPILE_BYTECODE="1")
        for name in ("UV_QUIET", "VIRTUAL_ENV", "UV_PYTHON"):
            env.pop(name, None)
        env.setdefault("UV_CACHE_DIR", str(self.state.folder / "uv"))
        if self.ca_bundle:
            env["SSL_CERT_FILE"] = self.ca_bundle
        python = venv / "bin" / "python"
        fresh = output_of([str(python), "-c", ""]) is None
        if fresh:
            say("Python packages: installing into .venv")
            make = [uv, "venv", "--clear", "--no-project", "--python", f">={dotted(OLDEST_PYTHON)}", str(venv)]
            run("Python packages", make, log, env=env, cwd=self.state.root)
        known = venv / "group"
        before = known.read_text() if known.exists() else ""
        group = max(group, before if before in GROUPS else group, key=GROUPS.index)
        file = self.state.root / "tools" / f"requirements-{group}.txt"
        # A build would fetch what it needs by itself, without a hash: wheels alone.
        sync = [uv, "pip", "sync", "--python", str(python), "--require-hashes", "--no-build", str(file)]
        run("Python packages", sync, log, env=env, cwd=self.state.root)
        write_atomically(known, group)
        launcher = self.state.bin / "rosml"
        write_atomically(launcher, LAUNCHER.format(python=python, root=str(self.state.root)))
        launcher.chmod(0o755)
        if fresh:
            say(f"Python packages: installed into .venv in {elapsed(started)}")

    # ---- Debian ---------------------------------------------------------------------------------------------------
    def apt(self, packages: Mapping[str, str]) -> str:
        """Path of apt-get, which may install packages. ``packages``: as in ``debian_packages``.

        Raises:
            Failure: this is no Debian or Ubuntu, or this user may not.
        """
        missing = f"missing: {reasons_of(packages)}"
        apt = which_system("apt-get")
        if apt is None:
            raise Failure(f"{missing}; and this machine has no apt-get", f"install {' '.join(packages)}")
        if os.geteuid() != 0:
            raise Failure(f"{missing}; only root may install it", f"sudo sh -c '{by_hand(packages)}'")
        return apt

    def debian_packages(self, packages: Mapping[str, str]) -> None:
        """Installs Debian packages, and says so before. ``packages``: their names, and what each is for.

        Raises:
            Failure: this is no Debian or Ubuntu, this user may not, or apt fails.
        """
        if not packages:
            return
        apt = self.apt(packages)
        names = " ".join(packages)
        say(f"this changes the system: installs the Debian packages {reasons_of(packages)}")
        started = time.monotonic()
        env = dict(os.environ, DEBIAN_FRONTEND="noninteractive", LC_ALL="C.UTF-8")
        options = ["-o", "DPkg::Lock::Timeout=300", "-o", "Dpkg::Use-Pty=0", "-o", "Acquire::Retries=3"]
        log = self.state.log / "apt.log"
        install = [apt, *options, "install", "--yes", "--no-install-recommends", *packages]
        try:
            run("apt-get update", [apt, *options, "update"], log, env=env)
            run("apt-get install", install, log, env=env, finish_on_interrupt=True)
        except Failure as failure:
            raise Failure(failure.message, f"put it right by hand: {by_hand(packages)}") from None
        say(f"Debian packages {names}: installed in {elapsed(started)}")


def reasons_of(packages: Mapping[str, str]) -> str:
    """``runc (runs build steps), mmdebstrap (...)``."""
    return ", ".join(f"{package} ({why})" for package, why in packages.items())


def by_hand(packages: Mapping[str, str]) -> str:
    """The command that installs Debian packages."""
    return f"apt-get update && apt-get install --no-install-recommends {' '.join(packages)}"


def which_system(name: str) -> str | None:
    """A program on PATH or in the system folders that a plain user's PATH leaves out."""
    return shutil.which(name) or shutil.which(name, path="/usr/local/sbin:/usr/sbin:/sbin")


def pins_digest(module: Path) -> str:
    """Hash of all that a tool's build depends on."""
    content = b"".join(
        file.read_bytes() for file in sorted(module.iterdir()) if file.name.endswith((".go", ".mod", ".sum"))
    )
    return hashlib.sha256(content).hexdigest()[:16]


def version_flag(pin: Pin) -> str:
    """Linker flag that tells a program its version, which it would have from its own repository."""
    places = {
        "github.com/docker/buildx/cmd/buildx": "github.com/docker/buildx/version.Version",
        "github.com/moby/buildkit/cmd/buildkitd": "github.com/moby/buildkit/version.Version",
        "github.com/aquasecurity/trivy/cmd/trivy": "github.com/aquasecurity/trivy/pkg/version/app.ver",
    }
    return f"-X {places[pin.package]}={pin.version}" if pin.package in places else ""
