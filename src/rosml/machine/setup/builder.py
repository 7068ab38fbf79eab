"""The builder: starts, checks, restarts and stops it, and removes all traces of a killed one."""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.units import duration
from rosml.machine.services import Services
from rosml.machine.setup import fitness, network, step_network
from rosml.machine.setup.builder_cache import CacheLimits
from rosml.machine.setup.daemon import START_SECONDS, Daemon, fingerprint, processes, wait_until
from rosml.machine.setup.installer import which_system
from rosml.machine.setup.process import Call, output_of, run, tail
from rosml.machine.setup.state import State
from rosml.machine.setup.step_network import Bridge, Container, Place
from rosml.registry import certificates

UNUSABLE = (":", ",", "\\", '"')
"""Characters that the path of an overlay's layer must not have."""
DOCKER_FOLDER = Path("/var/lib/docker")
SHARED = "build steps share this machine's network: code of a repository reaches what listens here"
DOCKERS_NETWORK = (
    "build steps have Docker's network: code of a repository reaches what listens on this machine's addresses, except on "
    "loopback; BUILDX_BUILDER=rosml rosml setup makes a builder that is closed"
)
NO_START = "as it does not start with a bridge"


def config(
    registry: str,
    mirror: bool,
    paths: Mapping[str, str] | None = None,
    trusted: Mapping[str, Sequence[Path]] | None = None,
    bridge: Bridge | None = None,
    limits: CacheLimits = CacheLimits(),  # noqa: B008 (it is frozen)
) -> str:
    """buildkitd.toml.

    Args:
        mirror: the local registry replaces Docker Hub.
        paths: ``root``, ``socket``, ``otel`` and ``runc`` of our own buildkitd; None for one in a container.
        trusted: files with authorities for registries, by host.
        bridge: the bridge for steps with their own network; None for the machine's network.
    """
    q = json.dumps  # a JSON string is a TOML basic string
    lines: list[str] = []
    if paths:
        lines += [f"root = {q(paths['root'])}"]
    if paths or bridge:
        lines += ['insecure-entitlements = ["network.host"]']
    if paths:
        lines += ["[grpc]", f"  address = [{q('unix://' + paths['socket'])}]"]
        lines += ["[otel]", f"  socketPath = {q(paths['otel'])}"]
        lines += ["[cdi]", "  disabled = true"]
        lines += ["[worker.containerd]", "  enabled = false"]
    lines += ["[worker.oci]", "  enabled = true", "  gc = true"]
    if bridge:
        lines += bridge.lines()
    elif paths:
        lines += ['  networkMode = "host"']
    if paths:
        lines += [f"  binary = {q(paths['runc'])}"]
    lines += ["[[worker.oci.gcpolicy]]", "  all = true", *limits.lines()]
    lines += [f"[registry.{q(registry)}]", "  http = true", "  insecure = true"]
    for host, authorities in sorted((trusted or {}).items()):
        if host not in (registry, "docker.io"):
            # The digest is for a builder in Docker, which gets copies: with it, a renewed file changes the configuration.
            lines += [f"# {fingerprint(file)}" for file in authorities]
            lines += [f"[registry.{q(host)}]", "  http = false"]
            lines += [f"  ca = [{', '.join(q(str(file)) for file in authorities)}]"]
    if mirror:
        lines += ['[registry."docker.io"]', f"  mirrors = [{q(registry)}]"]
    return "\n".join(lines) + "\n"


def daemon(state: State) -> Daemon:
    """Our own buildkitd."""
    file = state.run / "buildkitd.toml"
    # If it is killed, its temporary mount points would stay in /tmp.
    temporary = state.folder / "tmp"
    temporary.mkdir(parents=True, exist_ok=True)
    # The network plugins call iptables, which a plain user's PATH lacks.
    env = dict(os.environ, TMPDIR=str(temporary))
    env["PATH"] = f"{env.get('PATH', os.defpath)}:/usr/local/sbin:/usr/sbin:/sbin"
    if state.ca_bundle:
        env["SSL_CERT_FILE"] = state.ca_bundle
    # Its mounts are private. If the whole machine saw them, a search or an indexer in the checkout could
    # hold the root of a build step open. Then unmounting fails, and buildkitd next removes that step's result.
    launcher = ("unshare", "--mount", "--propagation", "slave")
    return Daemon(state, "buildkitd", (str(state.bin / "buildkitd"), "--config", str(file)), file, env, launcher)


def up(state: State, services: Services, image: str) -> None:
    """Makes sure that the builder runs and buildx knows it. `image`: BuildKit's, for a builder in Docker."""
    if services.builder_kind == "engine":
        _up_engine(state, services)
    elif services.builder_kind == "user":
        _up_user(state, services)
    elif services.builder_kind == "docker":
        _up_docker(state, services, image)
    else:
        _up_own(state, services)


def in_container(state: State) -> bool:
    """Whether a builder in a container of the user's Docker was made here."""
    return _docker_config(state).exists()


def _up_engine(state: State, services: Services) -> None:
    """The BuildKit in the user's Docker. Raises Unfit."""
    started = time.monotonic()
    fitness.require(services)
    state.say(
        f"builder: your Docker's own, '{services.builder}'; it was tried in {duration(time.monotonic() - started)}"
    )
    state.say(f"builder: {DOCKERS_NETWORK}")


def _up_user(state: State, services: Services) -> None:
    """The builder that BUILDX_BUILDER names. It is the user's, so we only check it."""
    try:
        _boot(state, services)
    except RosmlError as error:
        remedy = "start that builder, or unset BUILDX_BUILDER to have one made"
        raise RosmlError(f"BUILDX_BUILDER={services.builder}: {error.message}", remedy) from None
    state.say(f"builder: yours, '{services.builder}' (BUILDX_BUILDER); it must reach http://{services.registry}")
    try:
        fitness.require(services)
    except fitness.Unfit as unfit:  # pods do not reach this machine's loopback, and push elsewhere (--registry)
        state.say(f"builder: it could not push a small image there; name a registry that it reaches: {unfit.message}")
    state.say("builder: its configuration decides whether code of a repository reaches what listens there")


def _up_docker(state: State, services: Services, image: str) -> None:
    """A builder in a container of the user's Docker, on the host's network, to reach the registry on loopback.

    If it is the first one, it is tried. Raises Unfit.
    """
    is_first = not in_container(state)
    try:
        _make_docker(state, services, image)
        if is_first:
            fitness.require(services)
    except RosmlError:
        if is_first:  # the next setup looks for a builder again, since this one has no cache
            with contextlib.suppress(RosmlError, OSError):
                stop_docker(state, services)
            _docker_config(state).unlink(missing_ok=True)
        raise


def _make_docker(state: State, services: Services, image: str) -> None:
    """Its steps get their own network if possible. If not, the reason is kept until the builder is made again."""
    started = time.monotonic()
    reason_file, bridge = _reason(state), Bridge.read(_docker_config(state))
    reason = reason_file.read_text() if reason_file.exists() else ""
    try:
        if _start_docker(state, services, image, bridge) or bridge:
            reason_file.unlink(missing_ok=True)
            reason = ""
    except RosmlError:
        if not bridge:
            raise
        reason_file.unlink(missing_ok=True)
        reason = NO_START
    container = Container.of(_record(state, services), image)
    if not reason:
        reason = _bridge_docker(state, services, container) if container else "as buildx does not tell its place"
    if reason and not reason_file.exists():
        if not _is_configured(state, services, _docker_text(state, services, image, None)):
            _start_docker(state, services, image, None)
        files.write(reason_file, reason)
    state.say(f"builder: '{services.builder}' in your Docker, up in {duration(time.monotonic() - started)}")
    if reason:
        state.say(f"builder: {SHARED}, {reason}")


def _bridge_docker(state: State, services: Services, container: Container) -> str:
    """Gives steps of a running builder in Docker their own network. Returns why not; empty if it works."""
    bridge = container.bridge(state.root)
    if isinstance(bridge, str):
        return bridge
    proven = bridge == container.running()
    try:
        if proven:  # it may be another checkout's: they share the builder
            files.write(_docker_config(state), _docker_text(state, services, container.image, bridge))
        else:
            _start_docker(state, services, container.image, bridge)
        services.require_builder()
    except RosmlError:
        return NO_START
    return step_network.enclose(bridge, container.place(), proven)


def _start_docker(state: State, services: Services, image: str, bridge: Bridge | None) -> bool:
    """Starts it, and returns whether it made a container: buildx copies the configuration only when it makes one."""
    file, text = _docker_config(state), _docker_text(state, services, image, bridge)
    outdated = not _is_configured(state, services, text)
    if outdated:
        network_note = ", whose steps have a network of their own" if bridge else ""
        state.say(f"builder: making one in your Docker{network_note}")
        if Bridge.read(file):
            with contextlib.suppress(RosmlError):
                stop_docker(state, services)
        file.unlink(missing_ok=True)
        waiting = file.with_suffix(".new.toml")
        files.write(waiting, text)
        # A restart of the machine removes the rules. If Docker then restarted the builder by itself, steps would run without them.
        restart = ",restart-policy=no" if bridge else ""
        options = ["--driver", "docker-container", "--driver-opt", f"network=host,image={image}{restart}"]
        _create(services, [*options, "--buildkitd-config", str(waiting)])
        os.replace(waiting, file)
    _boot(state, services)
    return outdated


def _is_configured(state: State, services: Services, text: str) -> bool:
    file = _docker_config(state)
    return file.exists() and file.read_text() == text and _record(state, services).exists()


def _docker_config(state: State) -> Path:
    return state.run / "buildkitd-docker.toml"


def _docker_text(state: State, services: Services, image: str, bridge: Bridge | None) -> str:
    limits = CacheLimits.kept(_docker_config(state), DOCKER_FOLDER if DOCKER_FOLDER.is_dir() else state.folder)
    text = config(services.registry, bool(services.bases), trusted=certificates.by_host(), bridge=bridge, limits=limits)
    return f"# {image}\n{text}"


def stop_docker(state: State, services: Services, remove: bool = False) -> None:
    """Stops a builder in Docker, and removes the bridge and its rules. `remove`: also the container and its volume."""
    file = _docker_config(state)
    bridge = Bridge.read(file)
    image = file.read_text().splitlines()[0].removeprefix("# ") if bridge else ""
    container = Container.of(_record(state, services), image)
    argv = [*services.buildx, *(["rm", "--force"] if remove else ["stop"]), services.builder]
    run(state.say, Call("builder in Docker", argv, state.log / "builder.log", services.environment()))
    if bridge and container:
        step_network.tidy(bridge, container.beside())


def _boot(state: State, services: Services) -> None:
    argv = [*services.buildx, "inspect", "--bootstrap", services.builder]
    run(state.say, Call(f"builder '{services.builder}'", argv, state.log / "builder.log", services.environment()))


def _create(services: Services, options: Sequence[str]) -> None:
    env = services.environment()
    output_of([*services.buildx, "rm", "--force", "--keep-state", services.builder], 60.0, env=env)
    argv = [*services.buildx, "create", "--name", services.builder, *options]
    done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=env, check=False)
    if done.returncode != 0:
        raise RosmlError(f"buildx cannot create the builder '{services.builder}': {done.stderr.strip()}")


def _record(state: State, services: Services) -> Path:
    return state.folder / "buildx/instances" / services.builder


def _up_own(state: State, services: Services) -> None:
    """Our own buildkitd. Its steps get their own network if possible. If not, the reason is kept while it runs."""
    if any(character in str(state.folder) for character in UNUSABLE):
        text = f"the path {state.root} has one of {' '.join(UNUSABLE)} in it, which overlay file systems cannot take"
        raise RosmlError(text, "move the checkout to a path without it")
    reason_file = _reason(state)
    tried = reason_file.exists() and daemon(state).pid()
    bridge = reason_file.read_text() if tried else step_network.bridge(state.root)
    if isinstance(bridge, str):
        reason = bridge
    else:
        reason_file.unlink(missing_ok=True)
        reason = _start_own(state, services, bridge)
        if not reason:
            return
        files.write(reason_file, reason)
    _start_own(state, services, None)
    state.say(f"builder: {SHARED}, {reason}")


def _reason(state: State) -> Path:
    return state.run / "shared-network"


def _start_own(state: State, services: Services, bridge: Bridge | None) -> str:
    """Starts it unless it runs. Returns why its steps cannot use the bridge; empty if they can, or without a bridge."""
    root, buildkitd, address = state.folder / "buildkit", daemon(state), state.socket("buildkitd.sock")
    state.prepare_socket(address)
    previous_bridge = Bridge.read(buildkitd.config)
    files.write(buildkitd.config, _own_config(state, services, bridge))
    if buildkitd.pid() and buildkitd.current():
        if not _record(state, services).exists():
            _create(services, ["--driver", "remote", f"unix://{address}"])
        with contextlib.suppress(RosmlError):
            services.require_builder()
            state.say(f"builder: '{services.builder}', buildkitd runs")
            return _enclosed(state, bridge)
        state.say("builder: buildkitd does not answer; restarting it")
    elif buildkitd.pid():
        state.say("builder: buildkitd has an old configuration; restarting it")
    buildkitd.stop()
    if network.socket_answers(str(address)):  # its record is lost, or names another place: it is not ours to stop
        remedy = "end it (pkill buildkitd), then run 'rosml setup' again"
        raise RosmlError(f"another buildkitd answers at {address}", remedy)
    _tidy(root)
    if previous_bridge:
        step_network.tidy(previous_bridge)
    return _launch(state, services, bridge)


def _own_config(state: State, services: Services, bridge: Bridge | None) -> str:
    address, file = state.socket("buildkitd.sock"), daemon(state).config
    paths = {
        "root": str(state.folder / "buildkit"),
        "socket": str(address),
        "otel": str(address.with_name("otel.sock")),
        "runc": which_system("runc") or which_system("crun") or "",
    }
    limits = CacheLimits.kept(file, state.folder)
    return config(services.registry, bool(services.bases), paths, certificates.by_host(), bridge, limits)


def _launch(state: State, services: Services, bridge: Bridge | None) -> str:
    """Starts our own buildkitd, which does not run. Returns as `_start_own`."""
    buildkitd, address, started = daemon(state), state.socket("buildkitd.sock"), time.monotonic()
    address.unlink(missing_ok=True)
    buildkitd.start()
    wait_until(lambda: network.socket_answers(str(address)) or not buildkitd.pid(), START_SECONDS)
    no_bridge = f"as buildkitd does not start with a bridge ({buildkitd.log} says why)"
    if not buildkitd.pid():
        if bridge:
            return no_bridge
        raise RosmlError(f"buildkitd does not start. {tail(buildkitd.log)}")
    _create(services, ["--driver", "remote", f"unix://{address}"])
    try:
        services.require_builder()
    except RosmlError:
        if bridge:  # it answers a moment before it uses the bridge
            return no_bridge
        raise RosmlError(f"buildkitd does not answer. {tail(buildkitd.log)}") from None
    took = duration(time.monotonic() - started)
    state.say(f"builder: '{services.builder}', started buildkitd in {took}, since no Docker daemon can be used")
    return _enclosed(state, bridge)


def _enclosed(state: State, bridge: Bridge | None) -> str:
    pid = daemon(state).pid()
    return step_network.enclose(bridge, Place.here(pid, state.folder / "buildkit/net/cni")) if bridge and pid else ""


def stop(state: State) -> bool:
    stopped = daemon(state).stop()
    _tidy(state.folder / "buildkit")
    if bridge := Bridge.read(state.run / "buildkitd.toml"):
        step_network.tidy(bridge)
    _reason(state).unlink(missing_ok=True)
    return stopped


def _tidy(root: Path) -> None:
    """Removes the remains of a killed buildkitd: running build steps, mounts, and its list of networks."""
    for pid in processes():
        if pid != os.getpid() and is_build_step(pid, root):
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
    unmount_below(root)
    shutil.rmtree(root / "net", ignore_errors=True)


def is_build_step(pid: int, root: Path) -> bool:
    try:
        lines = Path(f"/proc/{pid}/mountinfo").read_text(errors="surrogateescape").splitlines()
    except OSError:
        return False
    escaped = "".join(f"\\{ord(c):03o}" if c in " \t\n\\" else c for c in str(root))
    return any(line.split(" ")[4] == "/" and " - overlay " in line and f"={escaped}/" in line for line in lines)


def unmount_below(folder: Path) -> None:
    """Unmounts the mounts of a killed builder, so that removing its files stays within the folder."""
    for point in reversed(mounted_below(folder)):
        output_of(["umount", "--lazy", point])
    if mounts := mounted_below(folder):
        raise RosmlError(f"still mounted: {', '.join(mounts)}", f"umount --lazy {mounts[-1]}")


def mounted_below(folder: Path) -> list[str]:
    lines = Path("/proc/self/mounts").read_text().splitlines()
    points = [re.sub(r"\\([0-7]{3})", lambda match: chr(int(match[1], 8)), line.split(" ")[1]) for line in lines]
    return [point for point in points if point.startswith(f"{folder}/")]
