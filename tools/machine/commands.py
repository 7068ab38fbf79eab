"""The commands of scripts/bootstrap.py: tools, client, linters, browser, up, suite, emulate, engine, scanner, signer, room, down,
clean, status."""

from __future__ import annotations

import argparse
import difflib
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from types import FrameType
from typing import Any, Callable, NoReturn

from machine import emulation, mounts, network, services
from machine.console import Failure, colour, elapsed, say
from machine.install import (
    ACTIONLINT,
    BUILDKITD,
    BUILDX,
    COSIGN,
    GO_TOOLS,
    REGCTL,
    REGISTRY,
    TRIVY,
    Installer,
    dotted,
    output_of,
    parse_pin,
    version_in,
    which_system,
)
from machine.services import BUILDER, Tools
from machine.state import State, read_json, write_atomically

OLDEST_REGCTL = (0, 11)
OLDEST_BUILDX = (0, 26)
OLDEST_UV = (0, 9)


BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome", "chromium-headless-shell")
"""What the tests of the catalogue's page take: the first one that is there."""


def docker_is_there(installer: Installer) -> bool:
    """Whether the user's Docker daemon can be reached."""
    docker = shutil.which("docker", path=installer.outer_path())
    return docker is not None and bool(
        (output_of([docker, "info", "--format", "{{.ServerVersion}}"], 10.0) or "").strip()
    )


def docker_has_buildkit(installer: Installer) -> bool:
    """Whether the user's Docker has BuildKit's image already, so that Docker Hub need not answer."""
    docker = shutil.which("docker", path=installer.outer_path())
    return docker is not None and output_of([docker, "image", "inspect", buildkit_image(installer.state)]) is not None


def buildkit_image(state: State) -> str:
    """BuildKit's image of the same release as the buildkitd that is built where there is no Docker."""
    pin = parse_pin((state.root / "tools" / "go" / BUILDKITD.folder / "go.mod").read_text())
    return f"moby/buildkit:{pin.version}"


def buildx_of(installer: Installer) -> tuple[str, ...] | None:
    """The machine's own buildx that is new enough: Docker's plugin, or one on PATH."""
    path = installer.outer_path()
    for name, argv in (("docker", ("docker", "buildx")), ("buildx", ("buildx",))):
        program = shutil.which(name, path=path)
        version = version_in(output_of([program, *argv[1:], "version"]) or "") if program else ()
        if version >= OLDEST_BUILDX:
            installer.have.append(f"{' '.join(argv)} v{dotted(version)} (found on PATH)")
            return argv if name == "docker" else (str(program),)
    return None


def choose_builder(installer: Installer, hub: bool) -> tuple[str, str]:
    """Kind and name of the builder: the one that BUILDX_BUILDER names, one in Docker, or buildkitd on its own.

    Raises:
        Failure: there is no Docker, and this user may not run buildkitd.
    """
    name = os.environ.get("BUILDX_BUILDER", "")
    if name and name != BUILDER:
        return "user", name
    if docker_is_there(installer) and (hub or docker_has_buildkit(installer)):
        return "docker", BUILDER
    if os.geteuid() != 0:
        raise Failure(
            "no Docker daemon answers, and without one the builder needs root",
            "start Docker (or get access to it), or call this as root",
        )
    return "buildkitd", BUILDER


def missing_packages(kind: str, hub: bool) -> dict[str, str]:
    """Debian packages to install, and what each is for."""
    packages: dict[str, str] = {}
    if kind == "buildkitd" and not (which_system("runc") or which_system("crun")):
        packages["runc"] = "runs build steps"
    if not hub and not which_system("mmdebstrap"):
        packages["mmdebstrap"] = "makes Debian base images, since Docker Hub does not answer"
    return packages


def engine_packages(installer: Installer) -> dict[str, str]:
    """Docker, where neither a daemon answers nor one can be started."""
    there = docker_is_there(installer) or which_system("dockerd")
    return {} if there else {"docker.io": "runs images for the tests of the runtime contract"}


def browser_packages() -> dict[str, str]:
    """Chromium, where there is no browser of its kind."""
    there = any(which_system(name) for name in BROWSERS)
    return {} if there else {"chromium": "opens the catalogue's page in its tests"}


def install_tools(state: State, hub: bool, bundle: str, tests: bool = False) -> Tools:
    """Finds or installs all that the services and builds need; with ``tests`` also what `make test` needs.

    apt and uv wait for the network for the most part, so they work beside Go's compiler.
    """
    installer = Installer(state, bundle)
    kind, builder = choose_builder(installer, hub)
    packages = missing_packages(kind, hub)
    if tests:
        packages = {**packages, **engine_packages(installer), **browser_packages()}
    if packages:
        installer.apt(packages)  # whether it may is told now, not after minutes of compiling
    regctl = installer.found("regctl", ["version"], OLDEST_REGCTL)
    buildx = buildx_of(installer)
    linter = not tests or installer.found_exactly(ACTIONLINT, ["--version"])
    wanted = [tool for tool, there in ((REGCTL, regctl), (BUILDX, buildx), (ACTIONLINT, linter)) if not there]
    wanted += [REGISTRY, *([BUILDKITD] if kind == "buildkitd" else [])]
    built: dict[str, str] = {}

    def beside() -> str:
        installer.debian_packages(packages)
        uv = installer.uv(OLDEST_UV)
        installer.packages(uv, "page" if tests else "dev")
        return uv

    with ThreadPoolExecutor(1) as pool, installer.fetching(wanted):
        others = pool.submit(beside)
        for tool in wanted:
            if others.done():
                others.result()  # a failure ends it now
            built[tool.name] = installer.go_tool(tool)
        uv = others.result()
    runc = (which_system("runc") or which_system("crun") or "") if kind == "buildkitd" else ""
    installer.drop_go_caches()
    installer.report()
    offer_path(state)
    return Tools(
        kind,
        builder,
        buildx or (built[BUILDX.name],),
        regctl or built[REGCTL.name],
        built[REGISTRY.name],
        uv,
        built.get(BUILDKITD.name, ""),
        runc,
    )


def tools(state: State) -> Tools:
    """Command ``tools``."""
    return prepare(state)[0]


def python_tools(state: State) -> None:
    """Command ``tools --python``."""
    installer = Installer(state, network.ca_bundle(os.environ))
    installer.packages(installer.uv(OLDEST_UV))


PREINSTALLED = (
    "/usr/local/lib/android",
    "/usr/share/dotnet",
    "/usr/share/swift",
    "/usr/local/.ghcup",
    "/opt/ghc",
    "/opt/hostedtoolcache/CodeQL",
)
"""What GitHub's machines bring that takes gigabytes and is not used here."""


def room(_state: State) -> None:
    """Command ``room``."""
    if os.environ.get("RUNNER_ENVIRONMENT") != "github-hosted":
        say("this is none of GitHub's own machines: nothing is removed")
        return
    before = shutil.disk_usage("/").free
    folders = [folder for folder in PREINSTALLED if os.path.isdir(folder)]
    if folders:
        subprocess.run(["sudo", "rm", "-rf", *folders], stdin=subprocess.DEVNULL, check=False)
    free = shutil.disk_usage("/").free
    say(f"removed {len(folders)} folders, {(free - before) / 1e9:.1f} GB; {free / 1e9:.1f} GB are free")


def offer_path(state: State) -> None:
    """Lets the next steps of a job in CI find the programs that were installed here."""
    if path := os.environ.get("GITHUB_PATH"):
        with open(path, "a", encoding="utf-8") as stream:
            stream.write(f"{state.bin}\n")


def client(state: State) -> None:
    """Command ``client``."""
    bundle = network.ca_bundle(os.environ)
    installer = Installer(state, bundle)
    uv = installer.uv(OLDEST_UV)
    installer.packages(uv, "app")
    installer.report()
    offer_path(state)
    if not state.services.exists():
        nothing = Tools(kind="", builder="", buildx=(), regctl="", registry="", uv=uv)
        facts = services.describe(state, nothing, registry="", hub=True, bundle=bundle)
        write_atomically(state.services, json.dumps(facts, indent=2) + "\n")


def linters(state: State) -> None:
    """Command ``linters``."""
    installer = Installer(state, network.ca_bundle(os.environ))
    installer.packages(installer.uv(OLDEST_UV))
    if not installer.found_exactly(ACTIONLINT, ["--version"]):
        installer.go_tool(ACTIONLINT)
        installer.drop_go_caches()


def browser(state: State) -> None:
    """Command ``browser``.

    Raises:
        Failure: there is none, and it cannot be installed.
    """
    installer = Installer(state, network.ca_bundle(os.environ))
    installer.packages(installer.uv(OLDEST_UV), "page")
    installer.debian_packages(browser_packages())


def scanner(state: State, tests: bool = False) -> None:
    """Command ``scanner``. ``tests``: also what its tests need."""
    installer = Installer(state, network.ca_bundle(os.environ))
    path = installer.found_exactly(TRIVY, ["--version"]) or installer.go_tool(TRIVY)
    if tests:
        for_tests(installer)
    installer.drop_go_caches()
    installer.report()
    write_atomically(state.scanner, json.dumps({"trivy": path}, indent=2) + "\n")


def signer(state: State, tests: bool = False) -> None:
    """Command ``signer``. ``tests``: also what its tests need."""
    installer = Installer(state, network.ca_bundle(os.environ))
    path = installer.found_exactly(COSIGN, ["version"]) or installer.go_tool(COSIGN)
    if tests:
        for_tests(installer)
    installer.drop_go_caches()
    installer.report()
    write_atomically(state.signer, json.dumps({"cosign": path}, indent=2) + "\n")


def for_tests(installer: Installer) -> None:
    """What tests of the scanner and the signer need: a registry's program, and pytest."""
    installer.go_tool(REGISTRY)
    installer.packages(installer.uv(OLDEST_UV))


def prepare(state: State, tests: bool = False) -> tuple[Tools, bool, str]:
    """Looks at the network, then at the tools: those, whether Docker Hub answers, and the user's CA bundle."""
    bundle = network.ca_bundle(os.environ)
    hub = network.docker_hub_answers(os.environ, bundle)
    say("Docker Hub: answers" if hub else "Docker Hub: does not answer; Debian base images are made here")
    return install_tools(state, hub, bundle, tests), hub, bundle


def up(state: State, tests: bool = False) -> None:
    """Command ``up``."""
    started = time.monotonic()
    found, hub, bundle = prepare(state, tests)
    services.up(state, found, hub, bundle, buildkit_image(state))
    say(f"set-up: done in {elapsed(started)}")


def suite(state: State) -> None:
    """Command ``suite``."""
    up(state, tests=True)


def emulate(state: State) -> None:
    """Command ``emulate``."""
    if emulation.ensure(Installer(state, network.ca_bundle(os.environ))):
        services.stop_builder(state)  # it looks once which architectures there are
    up(state)


def engine(state: State) -> None:
    """Command ``engine``.

    Raises:
        Failure: there is none, and it cannot be installed.
    """
    installer = Installer(state, network.ca_bundle(os.environ))
    installer.debian_packages(engine_packages(installer))


def down(state: State) -> None:
    """Command ``down``."""
    stopped = services.down(state) if state.folder.exists() else []
    say(f"stopped: {', '.join(stopped)}" if stopped else "nothing was running")


def clean(state: State) -> None:
    """Command ``clean``."""
    stopped = services.down(state, remove=True) if state.folder.exists() else []
    if stopped:
        say(f"stopped: {', '.join(stopped)}")
    mounts.unmount_below(state.folder)
    freed = 0
    for folder in (state.folder, state.root / ".venv", *byte_code(state.root)):
        if folder.exists():
            freed += disk_usage(folder)
            if folder.name != "__pycache__":
                say(f"removing {folder}")
            remove(folder)
    say(f"freed {freed / 1e9:.1f} GB" if freed else "nothing to remove")


def byte_code(root: Path) -> list[Path]:
    """Folders that Python made beside the project's modules."""
    return [found for name in ("rosml", "scripts", "tools", "tests") for found in (root / name).rglob("__pycache__")]


def disk_usage(folder: Path) -> int:
    """Bytes on disk below a folder."""
    total = 0
    seen: set[tuple[int, int]] = set()
    for parent, _folders, files in os.walk(folder):
        for name in files:
            try:
                facts = os.lstat(os.path.join(parent, name))
            except OSError:
                continue
            if (facts.st_dev, facts.st_ino) not in seen:
                seen.add((facts.st_dev, facts.st_ino))
                total += facts.st_blocks * 512
    return total


def remove(folder: Path) -> None:
    """Removes a folder.

    Raises:
        Failure: something is left, e.g. because it belongs to root.
    """
    shutil.rmtree(folder, ignore_errors=True)
    if folder.exists():
        raise Failure(f"cannot remove all of {folder}", f"remove it as the user who made it: sudo rm -rf {folder}")


def status(state: State) -> dict[str, Any]:
    """Facts for the command ``status``."""
    facts: dict[str, Any] = read_json(state.services) or {}
    registry = str(facts.get("registry", ""))
    tools_found = Tools(
        kind=str(facts.get("builder_kind", "")),
        builder=str(facts.get("builder", "")),
        buildx=tuple(facts.get("buildx", ())),
        regctl=str(facts.get("regctl", "")),
        registry="",
        uv=str(facts.get("uv", "")),
    )
    return {
        "state": str(state.folder),
        "up": bool(registry),
        "registry": {"address": registry, "answers": bool(registry) and network.registry_answers(registry)},
        "builder": {
            "name": tools_found.builder,
            "kind": tools_found.kind,
            "answers": bool(facts) and services.builder_runs(state, tools_found),
        },
        "docker_hub": facts.get("docker_hub"),
        "ca_bundle": facts.get("ca_bundle", ""),
        "installed": sorted(tool.name for tool in GO_TOOLS if (state.bin / f".{tool.name}.pin").exists()),
        "disk_free_gb": round(shutil.disk_usage(state.root).free / 1e9, 1),
    }


def print_status(state: State, as_json: bool) -> None:
    """Command ``status``."""
    facts = status(state)
    if as_json:
        say(json.dumps(facts, indent=2))
        return
    if not facts["up"]:
        rows = [("services", "not up (make up)")]
    else:
        registry, builder = facts["registry"], facts["builder"]
        rows = [
            ("registry", f"{registry['address']}, {'answers' if registry['answers'] else 'DOES NOT ANSWER (make up)'}"),
            (
                "builder",
                f"{builder['name']} ({builder['kind']}), {'answers' if builder['answers'] else 'DOES NOT ANSWER (make up)'}",
            ),
            ("base images", "official ones, from Docker Hub" if facts["docker_hub"] else "made here with mmdebstrap"),
            ("CA bundle", facts["ca_bundle"] or "the system's"),
        ]
    rows += [
        ("built tools", ", ".join(facts["installed"]) or "none"),
        ("disk free", f"{facts['disk_free_gb']} GB"),
        ("state", facts["state"]),
    ]
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        say(f"{name:<{width}}  {value}")


COMMANDS = {
    "tools": "find the tools that builds need, install those that are missing",
    "client": "find or install uv and the commands' Python packages: enough to read and write a registry",
    "linters": "the Python packages, and actionlint, which is built in some seconds",
    "up": "the same, then start the local registry and the builder",
    "suite": "the same for `make test`: with Docker, Chromium and actionlint where there are none",
    "emulate": "let this machine build and test for the other architecture, with QEMU",
    "engine": "install Docker where there is none: tests run images in it",
    "browser": "install Chromium where there is none: tests open the catalogue's page in it",
    "scanner": "find or build trivy, which looks for known vulnerabilities in images: 10 minutes",
    "signer": "find or build cosign, which signs images: a quarter of an hour",
    "room": "remove what GitHub's machines bring and nobody needs here; on those only",
    "down": "stop the registry and the builder; keeps what they stored",
    "clean": "stop them and remove all that was made (.state, .venv)",
    "status": "say what is running",
}
"""What there is to call, with what it does."""

DESCRIPTION = """\
Sets this machine up for building images: tools, a local registry, a builder. All that it makes is in .state;
Debian packages are installed only where they are missing, and it says so.
"""

EPILOG = """\
Environment:
  ROSML_DOCKER_HUB=0|1  do not ask whether Docker Hub answers
  ROSML_CA_BUNDLE       a company's certificates; also SSL_CERT_FILE, REQUESTS_CA_BUNDLE, CURL_CA_BUNDLE
  BUILDX_BUILDER        use this builder

Examples:
  python3 scripts/bootstrap.py up
  python3 scripts/bootstrap.py status --json
"""


def parser() -> argparse.ArgumentParser:
    """The command line."""
    top = argparse.ArgumentParser(
        prog="bootstrap.py",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    found = {name: commands.add_parser(name, help=what) for name, what in COMMANDS.items()}
    found["tools"].add_argument(
        "--python", action="store_true", help="only uv and the Python packages: enough for linters and lists"
    )
    for name in ("scanner", "signer"):
        found[name].add_argument(
            "--tests", action="store_true", help="also what its tests need: a registry, and pytest"
        )
    found["status"].add_argument("--json", action="store_true", help="for machines")
    return top


def unknown(name: str) -> str:
    """What to say of a command that there is not."""
    near = difflib.get_close_matches(name, COMMANDS, n=3, cutoff=0.5)
    guess = f"; did you mean {' or '.join(near)}?" if near else ""
    return f"no command '{name}'{guess}"


def terminate(_number: int, _frame: FrameType | None) -> NoReturn:
    """SIGTERM ends as Ctrl-C does: what was started for the moment is ended, half-made files are left unused."""
    raise KeyboardInterrupt


def main(root: Path, argv: Sequence[str]) -> int:
    """Runs a command; gives the exit code: 0, 1 (failed), 2 (usage), 130 (interrupted)."""
    if argv and not argv[0].startswith("-") and argv[0] not in COMMANDS:
        print(colour("error: ", 31) + unknown(argv[0]), file=sys.stderr)
        print("remedy: see all with: python3 scripts/bootstrap.py --help", file=sys.stderr)
        return 2
    arguments = parser().parse_args(argv)
    signal.signal(signal.SIGTERM, terminate)
    state = State(root)
    try:
        if arguments.command == "status":
            print_status(state, arguments.json)
            return 0
        if not sys.platform.startswith("linux"):
            raise Failure("this set-up needs Linux", "use a Linux machine, a virtual one, or WSL")
        table: dict[str, Callable[[State], Any]] = {
            "tools": tools,
            "client": client,
            "linters": linters,
            "browser": browser,
            "up": up,
            "suite": suite,
            "emulate": emulate,
            "engine": engine,
            "scanner": scanner,
            "signer": signer,
            "room": room,
            "down": down,
            "clean": clean,
        }
        work: Callable[..., Any] = python_tools if getattr(arguments, "python", False) else table[arguments.command]
        if getattr(arguments, "tests", False):
            work = partial(work, tests=True)
        if work in (down, clean) and not state.folder.exists():
            work(state)
            return 0
        state.prepare()
        with state.lock():
            work(state)
    except Failure as failure:
        print(colour("error: ", 31) + failure.message, file=sys.stderr)
        if failure.remedy:
            print(f"remedy: {failure.remedy}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted; call it again to carry on", file=sys.stderr)
        return 130
    return 0
