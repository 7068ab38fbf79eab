"""The local registry and the builder together: starts them, stops them, and reports on them."""

from __future__ import annotations

import shutil
from contextlib import suppress
from dataclasses import replace
from typing import Any

from rosml.base.errors import RosmlError
from rosml.machine.services import Services
from rosml.machine.setup import builder, registry, tools
from rosml.machine.setup.installer import GO_PROGRAMS
from rosml.machine.setup.state import State


def up(state: State, tools_of_machine: Services) -> None:
    services = replace(tools_of_machine, registry=registry.up(state))
    builder.up(state, services, tools.buildkit_image(state))
    services.save()


def down(state: State, remove: bool = False) -> list[str]:
    """Stops both. Returns the stopped services. `remove`: also the container and the volume of a builder in Docker."""
    stopped: list[str] = []
    services = written(state)
    if not (services and services.builder_kind == "docker"):
        # What `down` stopped, or a later setup left aside for another builder, has its container still.
        services = tools.builder_in_container(state) if remove else None
    if services:
        with suppress(RosmlError):
            builder.stop_docker(state, services, remove)
            stopped.append("builder in Docker")
    if builder.stop(state):
        stopped.append("buildkitd")
    if registry.daemon(state).stop():
        stopped.append("registry")
    (state.folder / "services.json").unlink(missing_ok=True)
    shutil.rmtree(state.short_run, ignore_errors=True)
    return stopped


def written(state: State) -> Services | None:
    """The content of services.json; None if it is missing or damaged."""
    try:
        return Services.load(state.root)
    except RosmlError:
        return None


def status(state: State) -> dict[str, Any]:
    services, version, answers = written(state) or Services.load(state.root, required=False), "", False
    with suppress(RosmlError):
        version, answers = services.require_builder(), True
    return {
        "state": str(state.folder),
        "up": bool(services.registry),
        "registry": {"address": services.registry, "answers": _registry_answers(services)},
        "builder": {
            "name": services.builder,
            "kind": services.builder_kind,
            "no_engine": services.no_engine,
            "version": version,
            "answers": answers,
        },
        "docker_hub": not services.bases if services.registry else None,
        "ca_bundle": services.ca_bundle,
        "installed": sorted(name for name in GO_PROGRAMS if (state.bin / f".{name}.pin").exists()),
        "disk_free_gb": round(shutil.disk_usage(state.root).free / 1e9, 1),
    }


def _registry_answers(services: Services) -> bool:
    try:
        services.require_registry()
    except RosmlError:
        return False
    return True
