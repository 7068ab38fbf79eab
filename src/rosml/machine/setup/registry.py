"""The local registry: starts, checks and restarts it, on the same port while that is free."""

from __future__ import annotations

import base64
import json
import os
import secrets
import time
from functools import partial
from pathlib import Path

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.units import duration
from rosml.machine.services import registry_answers
from rosml.machine.setup import network
from rosml.machine.setup.daemon import START_SECONDS, Daemon, wait_until
from rosml.machine.setup.process import tail
from rosml.machine.setup.state import State
from rosml.registry import credentials

PASSWORD = "registry.password"

USER = "rosml"
"""The user name for the registry's password; any other works, too."""


def config(storage: Path, port: int, password: Path) -> str:
    """The registry's configuration. JSON is YAML, so paths need no further quoting.

    Only pushes need the password: if Docker Hub does not answer, the registry is its mirror, and everybody pulls from it.
    """
    content = {
        "version": 0.1,
        "log": {"level": "warn", "accesslog": {"disabled": True}},
        "storage": {
            "filesystem": {"rootdirectory": str(storage)},
            "delete": {"enabled": True},
            "maintenance": {"uploadpurging": {"enabled": True, "age": "24h", "interval": "6h", "dryrun": False}},
        },
        "http": {"addr": f"127.0.0.1:{port}"},
        "auth": {"writers": {"path": str(password)}},
    }
    return json.dumps(content, indent=2) + "\n"


def daemon(state: State) -> Daemon:
    """The registry, without REGISTRY_* variables, which would change its configuration, and without trace collection."""
    env = {name: value for name, value in os.environ.items() if not name.startswith(("REGISTRY_", "OTEL_"))}
    env["OTEL_TRACES_EXPORTER"] = "none"
    file = state.run / "registry.yaml"
    return Daemon(state, "registry", (str(state.bin / "registry"), "serve", str(file)), file, env)


def last_port(state: State) -> int | None:
    try:
        return int(untrusted.json_value((state.run / "registry.yaml").read_bytes())["http"]["addr"].rpartition(":")[2])
    except (OSError, ValueError, KeyError, TypeError, AttributeError):  # never run, or damaged
        return None


def up(state: State) -> str:
    """Makes sure that the registry runs and answers. Returns its address. Keeps the port while that is free."""
    registry, port, say = daemon(state), last_port(state), state.say
    if port:
        _write(state, port)
    if port and registry.pid() and registry.current() and registry_answers(f"127.0.0.1:{port}"):
        say(f"registry: runs at 127.0.0.1:{port}")
        return f"127.0.0.1:{port}"
    if registry.stop(patience=5.0):
        say("registry: does not answer, or has an old configuration; restarting it")
    started = time.monotonic()
    for _attempt in range(3):
        if port and not network.port_is_free(port):
            say(f"registry: port {port} is taken by something else; choosing another")
            port = None
        port = port or network.free_port()
        _write(state, port)
        registry.start()
        if wait_until(partial(_settled, registry, port), START_SECONDS) and registry.pid():
            say(f"registry: started at 127.0.0.1:{port} in {duration(time.monotonic() - started)}")
            return f"127.0.0.1:{port}"
        registry.stop()
        if network.port_is_free(port):  # so that was not the reason
            break
    raise RosmlError(f"the registry does not start. {tail(registry.log)}")


def _write(state: State, port: int) -> None:
    """Writes the registry's files, and those of its clients that push."""
    auth = base64.b64encode(f"{USER}:{password(state)}".encode()).decode()
    files.write(daemon(state).config, config(state.folder / "registry", port, state.run / PASSWORD))
    (state.folder / credentials.OWN).parent.mkdir(exist_ok=True)
    _write_private(state.folder / credentials.OWN, json.dumps({"auths": {f"127.0.0.1:{port}": {"auth": auth}}}) + "\n")


def password(state: State) -> str:
    """The password for pushes to the registry. Build steps never get it."""
    file = state.run / PASSWORD
    stored_password = file.read_text().strip() if file.exists() else ""
    if stored_password:
        return stored_password
    new_password = secrets.token_urlsafe(24)
    _write_private(file, f"{new_password}\n")
    return new_password


def _write_private(file: Path, text: str) -> None:
    file.touch(mode=0o600)
    file.chmod(0o600)
    files.write(file, text)


def _settled(registry: Daemon, port: int) -> bool:
    return not registry.pid() or registry_answers(f"127.0.0.1:{port}")
