"""The tools of services, builds and tests, and the source of each."""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from types import MappingProxyType
from typing import NamedTuple

from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_image
from rosml.machine import docker
from rosml.machine.services import Services
from rosml.machine.setup import builder, fitness, step_network
from rosml.machine.setup.installer import ENGINE, Installer, dotted, version_in, which_system
from rosml.machine.setup.process import output_of
from rosml.machine.setup.state import State

OLDEST_REGCTL = (0, 11)
OLDEST_BUILDX = (0, 26)
BUILDER = "rosml"

BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome", "chromium-headless-shell")


def docker_has_buildkit(installer: Installer) -> bool:
    """Whether the user's Docker has BuildKit's image already, so that Docker Hub need not answer."""
    return _docker(installer, "image", "inspect", buildkit_image(installer.state)) != ""


def _docker(installer: Installer, *arguments: str) -> str:
    program = installer.docker_program
    return output_of([program, *arguments], docker.SECONDS) if program else ""


def buildkit_image(state: State) -> str:
    return pinned_image(state.root, "moby/buildkit")


def buildx_of(installer: Installer) -> tuple[str, ...]:
    """The machine's own buildx if it is new enough: Docker's plugin, or one on PATH; empty if there is none."""
    for argv in (("docker", "buildx"), ("buildx",)):
        program = shutil.which(argv[0], path=installer.outer_path())
        version = version_in(output_of([program, *argv[1:], "version"])) if program else ()
        if program and version >= OLDEST_BUILDX:
            installer.have.append(f"{' '.join(argv)} v{dotted(version)} (found on PATH)")
            return argv if argv[0] == "docker" else (program,)
    return ()


def builder_in_container(state: State) -> Services | None:
    """The builder in a container of the user's Docker that was made here, as buildx calls it; None if there is none."""
    if not builder.in_container(state):
        return None
    buildx = buildx_of(Installer(state)) or (str(state.bin / "buildx"),)
    return Services(state.root, "", buildx, BUILDER, "docker", state.folder / "buildx", "", "", bases=())


class Choice(NamedTuple):
    """The kind and the name of a builder, as in Services. `no_engine`: why it is not in Docker itself."""

    kind: str
    name: str
    no_engine: str = ""


Unfits = Mapping[str, fitness.Unfit]
"""Why builders of the user's Docker cannot build our images, by their kind; without those that were not tried."""
NONE: Unfits = MappingProxyType({})


def choose_builder(installer: Installer, hub: bool, unfit: Unfits = NONE) -> Choice:
    """The builder that BUILDX_BUILDER names, Docker's own, one in a container of Docker, or our own buildkitd."""
    name = os.environ.get("BUILDX_BUILDER", "")
    if name and name != BUILDER:
        # buildx calls the BuildKit in a Docker as Docker calls its context, and lets nobody else have that name.
        return Choice("engine" if _docker(installer, "context", "inspect", name) else "user", name)
    no_engine = f"BUILDX_BUILDER={BUILDER} asks for another one" if name else _no_engine(installer, unfit)
    if not no_engine:
        return Choice("engine", _docker(installer, "context", "show").strip() or "default")
    return Choice(*_other_builder(installer, hub, unfit), no_engine)


def _no_engine(installer: Installer, unfit: Unfits) -> str:
    """Why the builder cannot be the BuildKit in the user's Docker, as far as we know; empty if it can."""
    if not installer.docker.answers:
        return "no Docker answers"
    if obstacle := _obstacle(installer.docker, unfit):
        return obstacle.message
    if "engine" in unfit:
        return unfit["engine"].message.splitlines()[0]
    if not installer.docker.containerd_store:
        return f"its image store is not containerd's; to change that, {docker.CONTAINERD_STORE}"
    if builder.in_container(installer.state):
        return "the builder in a container, which was made before, has the cache"
    return ""


def _obstacle(engine: docker.Docker, unfit: Unfits) -> RosmlError | None:
    """Why no builder of the user's Docker can serve this machine; None if one can."""
    if not engine.answers:
        return RosmlError(engine.silence, engine.remedy)
    if engine.is_elsewhere:
        text = f"Docker is on another machine, {engine.machine}, which does not reach the local registry of this one"
        return RosmlError(text, "take this machine's Docker (unset DOCKER_HOST; docker context use default)")
    if any(isinstance(error, fitness.Unreached) for error in unfit.values()):
        text = "Docker does not reach the local registry, as it has a network of its own"
        newer = "update it to Docker 29.5 or newer"  # https://github.com/moby/moby/pull/47103
        return RosmlError(
            text, newer if engine.rootless else "take a Docker Engine on this machine (docker context ls)"
        )
    return None


def _other_builder(installer: Installer, hub: bool, unfit: Unfits) -> tuple[str, str]:
    obstacle = _obstacle(installer.docker, unfit) or unfit.get("docker")
    if not obstacle and (hub or docker_has_buildkit(installer)):
        return "docker", BUILDER
    if os.geteuid() == 0:
        return "buildkitd", BUILDER
    if obstacle:
        text = f"without Docker the builder needs root: {obstacle.message}"
        raise RosmlError(text, f"{obstacle.remedy}; or call this as root" if obstacle.remedy else "call this as root")
    image = buildkit_image(installer.state)
    text = f"Docker Hub does not answer, and Docker has no {image}, which it needs to build"
    store = "" if installer.docker.containerd_store else f"; or do without that image: {docker.CONTAINERD_STORE}"
    raise RosmlError(text, f"call it again when Docker Hub answers, or: docker pull {image}{store}")


def missing_packages(kind: str, hub: bool) -> dict[str, str]:
    packages: dict[str, str] = {}
    if kind == "buildkitd" and not (which_system("runc") or which_system("crun")):
        packages["runc"] = "runs build steps"
    if not hub and not which_system("mmdebstrap"):
        packages["mmdebstrap"] = "makes Debian base images, since Docker Hub does not answer"
    return packages


def _debian_packages(installer: Installer, packages: dict[str, str], kind: str) -> None:
    """Installs packages, and, if possible, those for the network of build steps: the builder works without them."""
    installer.debian_packages(packages)
    if kind == "buildkitd":
        with suppress(RosmlError):
            installer.debian_packages(step_network.missing_packages())


def engine_packages(installer: Installer) -> dict[str, str]:
    """Docker, if no daemon answers and none can be started."""
    if installer.docker.answers or which_system("dockerd"):
        return {}
    return {"docker.io": "runs images for the tests of the runtime contract"}


def kept_engine(installer: Installer) -> None:
    """Takes a current Docker Engine for tests, if it was built before, and the machine's Docker does not answer."""
    engine = _engine(installer.state)
    if not installer.docker.answers and all(engine.has(name) for name in ENGINE):
        _make(engine)


def build_engine(installer: Installer) -> None:
    """Builds a current Docker Engine for tests, if no Docker answers, which they would use. It takes minutes, and a C compiler for runc."""
    if installer.docker.answers:
        installer.state.say("engine: tests use your Docker")
        return
    installer.debian_packages(compiler_packages())
    engine = _engine(installer.state)
    with engine.fetching(ENGINE):
        _make(engine)
    installer.drop_go_caches()


def _engine(state: State) -> Installer:
    """Its programs have a folder of their own: only tests may take them for the machine's."""
    return Installer(state, state.folder / "engine")


def _make(engine: Installer) -> None:
    for name in ENGINE:
        engine.go_program(name)
    engine.report()


def compiler_packages() -> dict[str, str]:
    """What cgo and libseccomp's bindings need."""
    if output_of(["pkg-config", "--modversion", "libseccomp"]) and which_system("gcc"):
        return {}
    return dict.fromkeys(("gcc", "libc6-dev", "libseccomp-dev", "pkg-config"), "builds runc for the tests' Docker")


def browser_packages() -> dict[str, str]:
    if any(which_system(name) for name in BROWSERS):
        return {}
    return {"chromium": "opens the catalogue's page in its tests"}


def install(state: State, hub: bool, tests: bool = False, unfit: Unfits = NONE) -> Services:
    """Finds or installs all tools of the services and builds; with `tests` also those of `make test`. `unfit`: see `choose_builder`.

    The services in the result have no registry, which is not started here.
    """
    installer = Installer(state)
    choice = choose_builder(installer, hub, unfit)
    if choice.no_engine and installer.docker.answers and not unfit:
        state.say(f"builder: not Docker's own: {choice.no_engine}")
    packages = missing_packages(choice.kind, hub)
    if tests:
        packages = {**packages, **engine_packages(installer), **browser_packages()}
    if packages:
        installer.apt(packages)  # fails now if it may not, not after minutes of compiling
    buildx = buildx_of(installer)
    programs = ["registry"]
    programs += [] if buildx else ["buildx"]
    programs += ["buildkitd"] if choice.kind == "buildkitd" else []
    if tests:
        programs += ["composecheck"]
        programs += [] if installer.on_path("regctl", "version", OLDEST_REGCTL) else ["regctl"]
        programs += [] if installer.on_path("actionlint", "--version") else ["actionlint"]
    # apt mostly waits for the network, so it runs beside Go's compiler.
    with ThreadPoolExecutor(1) as pool, installer.fetching(programs):
        apt = pool.submit(_debian_packages, installer, packages, choice.kind)
        for name in programs:
            if apt.done():
                apt.result()  # raises its failure now
            installer.go_program(name)
        apt.result()
    if tests:
        kept_engine(installer)
    installer.drop_go_caches()
    installer.report()
    return Services(
        root=state.root,
        registry="",
        buildx=buildx or (str(state.bin / "buildx"),),
        builder=choice.name,
        builder_kind=choice.kind,
        buildx_config=None if choice.kind == "user" else state.folder / "buildx",
        uv=state.uv,
        ca_bundle=state.ca_bundle,
        bases=() if hub else (str(state.root / ".venv/bin/python"), str(state.root / "tools/offline")),
        no_engine=choice.no_engine,
        docker_address=docker.address(installer.docker_program) if choice.kind == "engine" else "",
    )
