"""The builder: started, checked, restarted, stopped, without a trace of what a killed one left."""

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
from rosml.machine.setup import network, step_network
from rosml.machine.setup.daemon import START_SECONDS, Daemon, fingerprint, processes, wait_until
from rosml.machine.setup.installer import which_system
from rosml.machine.setup.process import output_of, run, tail
from rosml.machine.setup.state import State
from rosml.machine.setup.step_network import Bridge
from rosml.registry import certificates

UNUSABLE = (":", ",", "\\", '"')
"""Characters that a path of an overlay's layer must not have."""
CACHE_BYTES = "40GB"
"""Most disk the builder's cache keeps."""
FREE_BYTES = "12GB"
"""Disk the builder leaves free: it prunes its cache below that."""
SHARED = "build steps share this machine's network: code of a repository reaches what listens here"
"""What is said of a builder whose steps have no network of their own."""


def config(
    registry: str,
    mirror: bool,
    own: Mapping[str, str] | None = None,
    trusted: Mapping[str, Sequence[Path]] | None = None,
    bridge: Bridge | None = None,
) -> str:
    """buildkitd.toml.

    Args:
        registry: address of the local registry.
        mirror: the local registry stands in for Docker Hub.
        own: ``root``, ``socket``, ``otel`` and ``runc`` of a buildkitd of our own; nothing for one in a container.
        trusted: files with the authorities that are trusted for registries, by host.
        bridge: gives the steps of a buildkitd of our own a network of their own; nothing for the machine's.
    """
    q = json.dumps  # a JSON string is a TOML basic string
    lines: list[str] = []
    if own:
        lines += [f"root = {q(own['root'])}", 'insecure-entitlements = ["network.host"]']
        lines += ["[grpc]", f"  address = [{q('unix://' + own['socket'])}]"]
        lines += ["[otel]", f"  socketPath = {q(own['otel'])}"]
        lines += ["[cdi]", "  disabled = true"]
        lines += ["[worker.containerd]", "  enabled = false"]
    lines += ["[worker.oci]", "  enabled = true", "  gc = true"]
    if own:
        lines += bridge.lines() if bridge else ['  networkMode = "host"']
        lines += [f"  binary = {q(own['runc'])}"]
    lines += ["[[worker.oci.gcpolicy]]", "  all = true"]
    lines += [f"  maxUsedSpace = {q(CACHE_BYTES)}", f"  minFreeSpace = {q(FREE_BYTES)}"]
    lines += [f"[registry.{q(registry)}]", "  http = true", "  insecure = true"]
    for host, found in sorted((trusted or {}).items()):
        if host not in (registry, "docker.io"):
            # The digest is for a builder in Docker, which gets copies: a renewed file makes another configuration.
            lines += [f"# {fingerprint(file)}" for file in found]
            lines += [
                f"[registry.{q(host)}]",
                "  http = false",
                f"  ca = [{', '.join(q(str(file)) for file in found)}]",
            ]
    if mirror:
        lines += ['[registry."docker.io"]', f"  mirrors = [{q(registry)}]"]
    return "\n".join(lines) + "\n"


def daemon(state: State) -> Daemon:
    """buildkitd of our own."""
    file = state.run / "buildkitd.toml"
    # Its temporary mount points would stay in /tmp whenever it is killed.
    temporary = state.folder / "tmp"
    temporary.mkdir(parents=True, exist_ok=True)
    # The plugins of networks call iptables, which a plain user's PATH leaves out.
    env = dict(os.environ, TMPDIR=str(temporary))
    env["PATH"] = f"{env.get('PATH', os.defpath)}:/usr/local/sbin:/usr/sbin:/sbin"
    if state.ca_bundle:
        env["SSL_CERT_FILE"] = state.ca_bundle
    # Its mounts are its own. If the whole machine saw them, a search or an indexer that walks through the checkout could
    # hold the root of a build step open: unmounting fails then, and what buildkitd removes next is that step's result.
    launcher = ("unshare", "--mount", "--propagation", "slave")
    return Daemon(state, "buildkitd", (str(state.bin / "buildkitd"), "--config", str(file)), file, env, launcher)


def up(state: State, services: Services, image: str) -> None:
    """Makes sure that the builder runs and buildx knows it. ``image``: BuildKit's, for a builder in Docker.

    Raises:
        RosmlError: it does not start; with what it says.
    """
    if services.builder_kind == "user":
        _up_user(state, services)
    elif services.builder_kind == "docker":
        _up_docker(state, services, image)
    else:
        _up_own(state, services)


def _up_user(state: State, services: Services) -> None:
    """The builder that BUILDX_BUILDER names; it is the user's, so it is only looked at."""
    try:
        _boot(state, services)
    except RosmlError as error:
        raise RosmlError(
            f"BUILDX_BUILDER={services.builder}: {error.message}",
            "start that builder, or unset BUILDX_BUILDER to have one made",
        ) from None
    state.say(f"builder: yours, '{services.builder}' (BUILDX_BUILDER); it must reach http://{services.registry}")
    state.say("builder: its configuration decides whether code of a repository reaches what listens there")


def _up_docker(state: State, services: Services, image: str) -> None:
    """A builder in a container of the user's Docker, on the host's network, to reach the registry on loopback. buildx copies
    the configuration when it makes the container."""
    file = state.run / "buildkitd-docker.toml"
    text = f"# {image}\n{config(services.registry, bool(services.bases), trusted=certificates.by_host())}"
    started = time.monotonic()
    if not (file.exists() and file.read_text() == text and _known(state, services)):
        state.say("builder: making one in your Docker")
        file.unlink(missing_ok=True)
        waiting = file.with_suffix(".new.toml")
        files.write(waiting, text)
        options = ["--driver", "docker-container", "--driver-opt", f"network=host,image={image}"]
        _create(services, [*options, "--buildkitd-config", str(waiting)])
        os.replace(waiting, file)
    _boot(state, services)
    state.say(f"builder: '{services.builder}' in your Docker, up in {duration(time.monotonic() - started)}")
    state.say(f"builder: {SHARED}")


def _boot(state: State, services: Services) -> None:
    """Starts a builder that buildx manages, and waits for it."""
    argv = [*services.buildx, "inspect", "--bootstrap", services.builder]
    run(state.say, f"builder '{services.builder}'", argv, state.log / "builder.log", env=services.environment())


def _create(services: Services, options: Sequence[str]) -> None:
    """(Re)creates buildx' record of the builder."""
    env = services.environment()
    output_of([*services.buildx, "rm", "--force", "--keep-state", services.builder], 60.0, env=env)
    argv = [*services.buildx, "create", "--name", services.builder, *options]
    done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=env, check=False)
    if done.returncode != 0:
        raise RosmlError(f"buildx cannot create the builder '{services.builder}': {done.stderr.strip()}")


def _known(state: State, services: Services) -> bool:
    """Whether buildx has a record of the builder."""
    return (state.folder / "buildx/instances" / services.builder).exists()


def _up_own(state: State, services: Services) -> None:
    """A buildkitd of our own. Its steps get a network of their own, if that can be had; why not is kept while it runs."""
    if any(character in str(state.folder) for character in UNUSABLE):
        raise RosmlError(
            f"the path {state.root} has one of {' '.join(UNUSABLE)} in it, which overlay file systems cannot take",
            "move the checkout to a path without it",
        )
    kept = _reason(state)
    tried = kept.exists() and daemon(state).pid()
    found = kept.read_text() if tried else step_network.bridge(state.root)
    if isinstance(found, Bridge):
        kept.unlink(missing_ok=True)
        found = _start_own(state, services, found)
        if not found:
            return
        files.write(kept, found)
    _start_own(state, services, None)
    state.say(f"builder: {SHARED}, {found}")


def _reason(state: State) -> Path:
    """The file that says why steps share the machine's network, though all that a bridge needs is there."""
    return state.run / "shared-network"


def _start_own(state: State, services: Services, bridge: Bridge | None) -> str:
    """Starts it, or sees that it runs. Gives why its steps cannot have a network of their own, if there is a bridge for it."""
    root, say = state.folder / "buildkit", state.say
    buildkitd = daemon(state)
    address = state.socket("buildkitd.sock")
    state.prepare_socket(address)
    own = {
        "root": str(root),
        "socket": str(address),
        "otel": str(address.with_name("otel.sock")),
        "runc": which_system("runc") or which_system("crun") or "",
    }
    before = Bridge.read(buildkitd.config)
    text = config(services.registry, bool(services.bases), own, certificates.by_host(), bridge)
    files.write(buildkitd.config, text)
    record = ["--driver", "remote", f"unix://{address}"]
    if buildkitd.pid() and buildkitd.current():
        if not _known(state, services):
            _create(services, record)
        with contextlib.suppress(RosmlError):
            services.require_builder()
            say(f"builder: '{services.builder}', buildkitd runs")
            return _enclosed(bridge, buildkitd, root)
        say("builder: buildkitd does not answer; restarting it")
    elif buildkitd.pid():
        say("builder: buildkitd has an old configuration; restarting it")
    buildkitd.stop()
    if network.socket_answers(str(address)):  # its record is lost, or names another place: it is not ours to cut off
        raise RosmlError(
            f"another buildkitd answers at {address}", "end it (pkill buildkitd), then run 'rosml setup' again"
        )
    _tidy(root)
    if before:
        step_network.tidy(before)
    started = time.monotonic()
    address.unlink(missing_ok=True)
    buildkitd.start()
    wait_until(lambda: network.socket_answers(str(address)) or not buildkitd.pid(), START_SECONDS)
    no_bridge = f"as buildkitd does not start with a bridge ({buildkitd.log} says why)"
    if not buildkitd.pid():
        if bridge:
            return no_bridge
        raise RosmlError(f"buildkitd does not start. {tail(buildkitd.log)}")
    _create(services, record)
    try:
        services.require_builder()
    except RosmlError:
        if bridge:  # it answers a moment before it tries the bridge
            return no_bridge
        raise RosmlError(f"buildkitd does not answer. {tail(buildkitd.log)}") from None
    took = duration(time.monotonic() - started)
    say(f"builder: '{services.builder}', started buildkitd in {took}, since no Docker daemon can be used")
    return _enclosed(bridge, buildkitd, root)


def _enclosed(bridge: Bridge | None, buildkitd: Daemon, root: Path) -> str:
    """Why steps cannot have the network of the bridge, if there is one; empty if they can."""
    pid = buildkitd.pid()
    return step_network.enclose(bridge, pid, root / "net/cni") if bridge and pid else ""


def stop(state: State) -> bool:
    """Stops a buildkitd of our own, if one runs; what it stored stays. Gives whether one ran."""
    stopped = daemon(state).stop()
    _tidy(state.folder / "buildkit")
    if bridge := Bridge.read(state.run / "buildkitd.toml"):
        step_network.tidy(bridge)
    _reason(state).unlink(missing_ok=True)
    return stopped


def _tidy(root: Path) -> None:
    """Ends what a killed buildkitd left: build steps, which would go on for nobody, mounts, and its list of networks. ``root``: its folder."""
    for pid in processes():
        if pid != os.getpid() and is_build_step(pid, root):
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
    unmount_below(root)
    shutil.rmtree(root / "net", ignore_errors=True)


def is_build_step(pid: int, root: Path) -> bool:
    """Whether a process has for its root file system an overlay that lies in the builder's folder."""
    try:
        lines = Path(f"/proc/{pid}/mountinfo").read_text(errors="surrogateescape").splitlines()
    except OSError:
        return False
    escaped = "".join(f"\\{ord(c):03o}" if c in " \t\n\\" else c for c in str(root))
    return any(line.split(" ")[4] == "/" and " - overlay " in line and f"={escaped}/" in line for line in lines)


def unmount_below(folder: Path) -> None:
    """Unmounts what a killed builder left mounted, so that removing its files stays within the folder.

    Raises:
        RosmlError: something stays mounted.
    """
    for point in reversed(mounted_below(folder)):
        output_of(["umount", "--lazy", point])
    if left := mounted_below(folder):
        raise RosmlError(f"still mounted: {', '.join(left)}", f"umount --lazy {left[-1]}")


def mounted_below(folder: Path) -> list[str]:
    """Mount points in a folder, outer ones first."""
    lines = Path("/proc/self/mounts").read_text().splitlines()
    points = [re.sub(r"\\([0-7]{3})", lambda match: chr(int(match[1], 8)), line.split(" ")[1]) for line in lines]
    return [point for point in points if point.startswith(f"{folder}/")]
