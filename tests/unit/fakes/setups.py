"""A checkout that is set up, and local replacements for the programs that setup calls."""

from __future__ import annotations

from pathlib import Path

from rosml.machine.services import Services
from rosml.machine.setup.state import State


def new_state(root: Path) -> State:
    state = State(root, print, uv="/uv", cache=root / "cache")
    for folder in (state.bin, state.log, state.run):
        folder.mkdir(parents=True)
    return state


def program(folder: Path, name: str, text: str) -> Path:
    """Makes a shell program."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def go_module(state: State, name: str, version: str = "v1.2.3") -> None:
    """Pins a Go program in the checkout."""
    module = state.root / "tools/go" / name
    module.mkdir(parents=True)
    pin = f"tool example.org/{name}/cmd/{name}\nrequire example.org/{name} {version}\n"
    (module / "go.mod").write_text(pin)


def services_of(state: State, kind: str, buildx: str = "buildx", registry: str = "127.0.0.1:5001") -> Services:
    config = None if kind == "user" else state.folder / "buildx"
    return Services(state.root, registry, (buildx,), "rosml", kind, config, "/uv", "", bases=())
