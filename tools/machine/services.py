"""The services: a local registry and a builder. Started, checked, restarted, stopped, described in services.json."""

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
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from machine import mounts, network
from machine.console import Failure, elapsed, run, say, tail
from machine.daemon import Daemon, fingerprint, processes, wait_until
from machine.install import output_of
from machine.state import State, read_json, write_atomically

BUILDER = "rosml"
START_SECONDS = 60.0
INSPECT_SECONDS = 30.0
UNUSABLE = (":", ",", "\\", '"')
"""Characters that a path of an overlay's layer must not have."""
CACHE_BYTES = "40GB"
"""Most disk the builder's cache keeps."""
FREE_BYTES = "12GB"
"""Disk the builder leaves free: it prunes its cache below that."""


@dataclass(frozen=True)
class Tools:
    """What the services run with.

    Attributes:
        kind: of the builder: ``buildkitd`` (our own), ``docker`` (a container of the user's Docker) or ``user``
            (BUILDX_BUILDER names one).
        builder: its name.
        buildx: the command, e.g. ``("docker", "buildx")``.
        buildkitd, runc: paths, only for the kind ``buildkitd``.
    """

    kind: str
    builder: str
    buildx: tuple[str, ...]
    regctl: str
    registry: str
    uv: str
    buildkitd: str = ""
    runc: str = ""


# ---- registry -------------------------------------------------------------------------------------------------------
def registry_config(storage: Path, port: int) -> str:
    """Configuration of the registry. JSON is YAML: paths need no further quoting."""
    config = {
        "version": 0.1,
        "log": {"level": "warn", "accesslog": {"disabled": True}},
        "storage": {
            "filesystem": {"rootdirectory": str(storage)},
            "delete": {"enabled": True},
            "maintenance": {
                "uploadpurging": {"enabled": True, "age": "24h", "interval": "6h", "dryrun": False},
            },
        },
        "http": {"addr": f"127.0.0.1:{port}"},
    }
    return json.dumps(config, indent=2) + "\n"


def registry_daemon(state: State, program: str) -> Daemon:
    """The registry. REGISTRY_* variables would change its configuration, and it would look for a trace collector."""
    env = {name: value for name, value in os.environ.items() if not name.startswith(("REGISTRY_", "OTEL_"))}
    env["OTEL_TRACES_EXPORTER"] = "none"
    config = state.run / "registry.yaml"
    return Daemon(state, "registry", (program, "serve", str(config)), config, env)


def registry_port(state: State) -> int | None:
    """Port of the last run."""
    address = ((read_json(state.run / "registry.yaml") or {}).get("http") or {}).get("addr", "")
    port = str(address).rpartition(":")[2]
    return int(port) if port.isdigit() else None


def up_registry(state: State, program: str) -> str:
    """Makes sure that the registry runs and answers; gives its address. Keeps the port while it is free.

    Raises:
        Failure: it does not start; with the end of its log.
    """
    daemon = registry_daemon(state, program)
    port = registry_port(state)
    if port and daemon.pid() and daemon.current() and network.registry_answers(f"127.0.0.1:{port}"):
        say(f"registry: runs at 127.0.0.1:{port}")
        return f"127.0.0.1:{port}"
    if daemon.stop(patience=5.0):
        say("registry: does not answer; restarting it")
    started = time.monotonic()
    for _attempt in range(3):
        if port and not network.port_is_free(port):
            say(f"registry: port {port} is taken by something else; choosing another")
            port = None
        port = port or network.free_port()
        write_atomically(daemon.config, registry_config(state.folder / "registry", port))
        daemon.start()
        if wait_until(partial(registry_settled, daemon, port), START_SECONDS) and daemon.pid():
            say(f"registry: started at 127.0.0.1:{port} in {elapsed(started)}")
            return f"127.0.0.1:{port}"
        daemon.stop()
        if network.port_is_free(port):  # so that was not the reason
            break
    raise Failure(f"the registry does not start. The end of its log:\n{tail(daemon.log)}  whole log: {daemon.log}")


def registry_settled(daemon: Daemon, port: int) -> bool:
    """Whether a registry that was just started answers, or has ended."""
    return not daemon.pid() or network.registry_answers(f"127.0.0.1:{port}")


# ---- builder --------------------------------------------------------------------------------------------------------
def buildkit_config(
    registry: str,
    mirror: bool,
    own: Mapping[str, str] | None = None,
    certificates: Mapping[str, Sequence[str]] | None = None,
) -> str:
    """buildkitd.toml.

    Args:
        registry: address of the local registry.
        mirror: the local registry stands in for Docker Hub.
        own: ``root``, ``socket``, ``otel`` and ``runc`` of a buildkitd of our own; nothing for one in a container.
        certificates: files with the authorities that are trusted for registries, by host.
    """
    q = json.dumps  # a JSON string is a TOML basic string
    lines: list[str] = []
    if own:
        lines += [f"root = {q(own['root'])}", "[grpc]", f"  address = [{q('unix://' + own['socket'])}]"]
        lines += ["[otel]", f"  socketPath = {q(own['otel'])}"]
        lines += ["[cdi]", "  disabled = true"]
        lines += ["[worker.containerd]", "  enabled = false"]
    lines += ["[worker.oci]", "  enabled = true", "  gc = true"]
    if own:
        lines += ['  networkMode = "host"', f"  binary = {q(own['runc'])}"]
    lines += ["[[worker.oci.gcpolicy]]", "  all = true"]
    lines += [f"  maxUsedSpace = {q(CACHE_BYTES)}", f"  minFreeSpace = {q(FREE_BYTES)}"]
    lines += [f"[registry.{q(registry)}]", "  http = true", "  insecure = true"]
    for host, files in sorted((certificates or {}).items()):
        if host not in (registry, "docker.io"):
            # The digest is for a builder in Docker, which gets copies: a renewed file makes another configuration.
            lines += [f"# {fingerprint(Path(file))}" for file in files]
            lines += [f"[registry.{q(host)}]", "  http = false", f"  ca = [{', '.join(map(q, files))}]"]
    if mirror:
        lines += ['[registry."docker.io"]', f"  mirrors = [{q(registry)}]"]
    return "\n".join(lines) + "\n"


def buildkit_daemon(state: State, program: str) -> Daemon:
    """buildkitd of our own."""
    config = state.run / "buildkitd.toml"
    env = dict(os.environ)
    bundle = network.ca_bundle(env)
    if bundle:
        env["SSL_CERT_FILE"] = bundle
    # Its temporary mount points would stay in /tmp whenever it is killed.
    temporary = state.folder / "tmp"
    temporary.mkdir(parents=True, exist_ok=True)
    env["TMPDIR"] = str(temporary)
    # Its mounts are its own. If the whole machine saw them, a search or an indexer that walks through the checkout could
    # hold the root of a build step open: unmounting fails then, and what buildkitd removes next is that step's result.
    launcher = ("unshare", "--mount", "--propagation", "slave")
    return Daemon(state, "buildkitd", (program, "--config", str(config)), config, env, launcher)


def buildx_environment(state: State, kind: str) -> dict[str, str]:
    """Environment for buildx: our own configuration folder, so that the user's builders stay as they are."""
    env = dict(os.environ)
    if kind != "user":
        env.pop("BUILDX_BUILDER", None)
        env["BUILDX_CONFIG"] = str(state.buildx_config)
    return env


def builder_runs(state: State, tools: Tools) -> bool:
    """Whether buildx reaches its builder."""
    env = buildx_environment(state, tools.kind)
    text = output_of([*tools.buildx, "inspect", tools.builder], INSPECT_SECONDS, env=env)
    return text is not None and re.search(r"^Status:\s+running$", text, re.MULTILINE) is not None


def boot_builder(state: State, tools: Tools) -> None:
    """Starts a builder that buildx manages, and waits for it.

    Raises:
        Failure: it does not start; with what buildx says.
    """
    argv = [*tools.buildx, "inspect", "--bootstrap", tools.builder]
    run(f"builder '{tools.builder}'", argv, state.log / "builder.log", env=buildx_environment(state, tools.kind))


def create_builder(state: State, tools: Tools, options: Sequence[str]) -> None:
    """(Re)creates buildx' record of the builder.

    Raises:
        Failure: buildx does not want to.
    """
    env = buildx_environment(state, tools.kind)
    output_of([*tools.buildx, "rm", "--force", "--keep-state", tools.builder], 60.0, env=env)
    argv = [*tools.buildx, "create", "--name", tools.builder, *options]
    done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=env, check=False)
    if done.returncode != 0:
        raise Failure(f"buildx cannot create the builder '{tools.builder}': {done.stderr.strip()}")


def up_builder(state: State, tools: Tools, registry: str, mirror: bool, image: str) -> None:
    """Makes sure that the builder runs and buildx knows it. ``image``: BuildKit's, for a builder in Docker."""
    if tools.kind == "user":
        up_user_builder(state, tools, registry)
    elif tools.kind == "docker":
        up_docker_builder(state, tools, registry, mirror, image)
    else:
        up_own_builder(state, tools, registry, mirror)


def up_user_builder(state: State, tools: Tools, registry: str) -> None:
    """The builder that BUILDX_BUILDER names; it is the user's, so it is only looked at."""
    try:
        boot_builder(state, tools)
    except Failure as failure:
        raise Failure(
            f"BUILDX_BUILDER={tools.builder}: {failure.message}",
            "start that builder, or unset BUILDX_BUILDER to have one made",
        ) from None
    say(f"builder: yours, '{tools.builder}' (BUILDX_BUILDER); it must reach http://{registry}")


def docker_builder_options(config: Path, image: str) -> list[str]:
    """How a builder in the user's Docker is made: on the host's network, to reach the registry on loopback."""
    options = ["--driver", "docker-container", "--driver-opt", f"network=host,image={image}"]
    return [*options, "--buildkitd-config", str(config)]


def up_docker_builder(state: State, tools: Tools, registry: str, mirror: bool, image: str) -> None:
    """A builder in a container of the user's Docker. buildx copies the configuration when it makes the container."""
    config = state.run / "buildkitd-docker.toml"
    trusted = network.registry_certificates(os.environ)
    text = f"# {image}\n{buildkit_config(registry, mirror, certificates=trusted)}"
    started = time.monotonic()
    if not (config.exists() and config.read_text() == text and known(state, tools)):
        say("builder: making one in your Docker")
        config.unlink(missing_ok=True)
        waiting = config.with_suffix(".new.toml")
        write_atomically(waiting, text)
        create_builder(state, tools, docker_builder_options(waiting, image))
        os.replace(waiting, config)
    boot_builder(state, tools)
    say(f"builder: '{tools.builder}' in your Docker, up in {elapsed(started)}")


def known(state: State, tools: Tools) -> bool:
    """Whether buildx has a record of the builder."""
    return (state.buildx_config / "instances" / tools.builder).exists()


def up_own_builder(state: State, tools: Tools, registry: str, mirror: bool) -> None:
    """A buildkitd of our own.

    Raises:
        Failure: it does not start, or the checkout's path cannot hold its files.
    """
    root = state.folder / "buildkit"
    if any(character in str(root) for character in UNUSABLE):
        raise Failure(
            f"the path {state.root} has one of {' '.join(UNUSABLE)} in it, which overlay file systems cannot take",
            "move the checkout to a path without it",
        )
    daemon = buildkit_daemon(state, tools.buildkitd)
    address = state.socket("buildkitd.sock")
    state.prepare_socket(address)
    own = {
        "root": str(root),
        "socket": str(address),
        "otel": str(address.with_name("otel.sock")),
        "runc": tools.runc,
    }
    trusted = network.registry_certificates(os.environ)
    write_atomically(daemon.config, buildkit_config(registry, mirror, own, trusted))
    record = ["--driver", "remote", f"unix://{address}"]
    if daemon.pid() and daemon.current():
        if not known(state, tools):
            create_builder(state, tools, record)
        if builder_runs(state, tools):
            say(f"builder: '{tools.builder}', buildkitd runs")
            return
        say("builder: buildkitd does not answer; restarting it")
    elif daemon.pid():
        say("builder: buildkitd has an old configuration; restarting it")
    daemon.stop()
    if network.socket_answers(str(address)):  # its record is lost, or names another place: it is not ours to cut off
        raise Failure(f"another buildkitd answers at {address}", "end it (pkill buildkitd), then run 'make up' again")
    tidy_builder(root)
    started = time.monotonic()
    address.unlink(missing_ok=True)
    daemon.start()
    wait_until(lambda: network.socket_answers(str(address)) or not daemon.pid(), START_SECONDS)
    if not daemon.pid():
        raise Failure(f"buildkitd does not start. The end of its log:\n{tail(daemon.log)}  whole log: {daemon.log}")
    create_builder(state, tools, record)
    if not builder_runs(state, tools):
        raise Failure(f"buildkitd does not answer. The end of its log:\n{tail(daemon.log)}  whole log: {daemon.log}")
    say(f"builder: '{tools.builder}', started buildkitd in {elapsed(started)}, since no Docker daemon can be used")


def tidy_builder(root: Path) -> None:
    """Ends what a killed buildkitd left: build steps, which would go on for nobody, and mounts. ``root``: its folder."""
    for pid in processes():
        if pid != os.getpid() and is_build_step(pid, root):
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
    mounts.unmount_below(root)


def is_build_step(pid: int, root: Path) -> bool:
    """Whether a process has for its root file system an overlay that lies in the builder's folder."""
    try:
        lines = Path(f"/proc/{pid}/mountinfo").read_text(errors="surrogateescape").splitlines()
    except OSError:
        return False
    escaped = "".join(f"\\{ord(c):03o}" if c in " \t\n\\" else c for c in str(root))
    return any(line.split(" ")[4] == "/" and " - overlay " in line and f"={escaped}/" in line for line in lines)


# ---- all of it ------------------------------------------------------------------------------------------------------
def stop_builder(state: State) -> None:
    """Stops a buildkitd of our own, if one runs; what it stored stays."""
    buildkit_daemon(state, str(state.bin / "buildkitd")).stop()
    tidy_builder(state.folder / "buildkit")


def describe(state: State, tools: Tools, registry: str, hub: bool, bundle: str) -> dict[str, Any]:
    """Content of services.json."""
    return {
        "registry": registry,
        "buildx": list(tools.buildx),
        "builder": tools.builder,
        "builder_kind": tools.kind,
        "buildx_config": None if tools.kind == "user" else str(state.buildx_config),
        "regctl": tools.regctl,
        "uv": tools.uv,
        "ca_bundle": bundle,
        "docker_hub": hub,
        "bases": [] if hub else [str(state.root / ".venv" / "bin" / "python"), str(state.root / "tools" / "offline")],
    }


def regctl_config(registry: str, certificates: Mapping[str, Sequence[str]]) -> str:
    """regctl's config.json. The registry speaks plain http, and its port may have changed since regctl was told.

    Args:
        registry: address of the local registry.
        certificates: files with the authorities that are trusted for registries, by host; regctl takes their text.
    """
    hosts = {
        host: {"tls": "enabled", "hostname": host, "regcert": "".join(Path(file).read_text() for file in files)}
        for host, files in certificates.items()
    }
    hosts[registry] = {"tls": "disabled", "hostname": registry}
    return json.dumps({"hosts": hosts}, indent=2) + "\n"


def up(state: State, tools: Tools, hub: bool, bundle: str, image: str) -> dict[str, Any]:
    """Starts what does not run and writes services.json. ``image``: BuildKit's, for a builder in Docker."""
    mirror = not hub
    registry = up_registry(state, tools.registry)
    up_builder(state, tools, registry, mirror, image)
    facts = describe(state, tools, registry, hub, bundle)
    text = regctl_config(facts["registry"], network.registry_certificates(os.environ))
    write_atomically(state.folder / "regctl" / "config.json", text)
    write_atomically(state.services, json.dumps(facts, indent=2) + "\n")
    return facts


def down(state: State, remove: bool = False) -> list[str]:
    """Stops what was started; gives what was stopped. ``remove``: also the container and volume of one in Docker."""
    stopped: list[str] = []
    facts = read_json(state.services) or {}
    if facts.get("builder_kind") == "docker":
        env = dict(os.environ, BUILDX_CONFIG=str(state.buildx_config))
        action = ["rm", "--force"] if remove else ["stop"]
        if output_of([*facts["buildx"], *action, str(facts["builder"])], 60.0, env=env) is not None:
            stopped.append("builder in Docker")
    daemons = (
        buildkit_daemon(state, str(state.bin / "buildkitd")),
        registry_daemon(state, str(state.bin / "registry")),
    )
    stopped += [daemon.name for daemon in daemons if daemon.stop()]
    tidy_builder(state.folder / "buildkit")
    state.services.unlink(missing_ok=True)
    shutil.rmtree(state.short_run, ignore_errors=True)
    return stopped
