"""The bake file of an app: the stages of components/containerize/Dockerfile, and the images that are joined from them."""

from __future__ import annotations

import json
from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.containerize.app_base import Base
from rosml.containerize.app_inputs import Values
from rosml.containerize.names import SLIM, Names
from rosml.containerize.stage_cache import BASE
from rosml.images.builds import adopted
from rosml.images.builds.base_images import native_architecture
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set.labels import APP, PREFIX, REVISION, TITLE
from rosml.machine import buildx, exported
from rosml.machine.services import Services

SCRIPTS = ROOT / "components"
"""What steps of the build call."""

FOREIGN = ("scripts/containerize/workspace.sh", "scripts/containerize/test.sh")
"""Those that run code of the packages. Others that run a script of the repository say so, if that is what failed."""

BASE_NAME = "org.opencontainers.image.base.name"
BASE_DIGEST = "org.opencontainers.image.base.digest"

LOCK = f"{PREFIX}lock"
"""The label that says what an image was built from, as the lock file does."""

REPORT, RESULTS, ASKED = "report", "results", "identified"
"""The targets that leave an archive: one with what rosml's own steps say of the app, one with what its tests left, and one with
which keys of rosdep became which packages, for when these cannot be installed."""

STAGES = ("app", "runtime", "workspace")
"""Stages that images are joined from."""

SLIM_STAGES = ("slim-app", "slim-runtime")
"""Those that a slim image is joined from."""

PACKAGES = "packages"
"""The group of all that is built before the images."""

_MIRRORS = {"os-apt-mirror": "OS_APT_MIRROR", "ros-apt-mirror": "ROS_APT_MIRROR"}


@dataclass(frozen=True)
class Inputs:
    """What an app is built from.

    Attributes:
        base: the base image. distribution: its ROS. slim: the base image of the slim image, if there is to be one.
        values: of the user's inputs.
        contexts: folders with sources, manifests and requests, by the names of the Dockerfile. empty: one without files.
        hooked: a script changes the sources before their dependencies are read.
        rosdep: the digest of rosdep's lists, if a registry has them.
        conditions: the ROS that conditions in manifests compare with.
        commit, time: of the sources, in seconds since 1970.
    """

    base: Base
    distribution: str
    values: Values
    contexts: Mapping[str, Path]
    empty: Path
    hooked: bool
    commit: str
    time: int
    slim: Base | None = None
    rosdep: str = ""
    conditions: str = ""

    @property
    def stages(self) -> tuple[str, ...]:
        """Stages that images are joined from."""
        return STAGES + (SLIM_STAGES if self.slim else ())


def render(
    inputs: Inputs,
    names: Names,
    services: Services,
    environment: Iterable[str],
    left: Mapping[str, Path],
    known: Mapping[str, str],
    kept: Mapping[str, str],
    unlinked: Container[str] = (),
    lock: str = "",
) -> str:
    """The bake file.

    Args:
        environment: variables that are set.
        left: the archives for what the targets `REPORT`, `RESULTS` and `ASKED` leave.
        known: stages that are in a registry, with their references. kept: where others go, by stage.
        unlinked: images that are not their base image and the app: they start from the stage that has the app's packages.
        lock: what the images are built from, for a label.
    """
    values = inputs.values
    steps = _steps(services, environment, names.platforms)
    if values.parallel_jobs:  # as a secret, for the result does not depend on it: steps need not run again
        steps["secret"].append("type=env,id=parallel-jobs,env=PARALLEL_JOBS")
    stages = {name: f"docker-image://{reference}" for name, reference in known.items()}
    onto = inputs.base.adopted if BASE not in known else None
    base = {BASE: f"target:{BASE}" if onto else stages.pop(BASE, f"docker-image://{inputs.base.reference}")}
    if inputs.slim:
        base["slim"] = f"docker-image://{inputs.slim.reference}"
    contexts = {name: str(path) for name, path in inputs.contexts.items()}
    common = {
        **steps,
        "context": str(inputs.empty),
        "dockerfile": str(SCRIPTS / "containerize/Dockerfile"),
        "contexts": {**base, "scripts": str(SCRIPTS), **contexts, **stages},
        "args": {
            "CMAKE_ARGS": values.cmake_args,
            "COLCON_ARGS": values.colcon_args,
            "SKIP_KEYS": values.skip_keys,
            "ROSDEP_DAY": f"{datetime.now(UTC):%F}",
            "ROS_DISTRO": inputs.distribution,
            "CONDITIONS": inputs.conditions or inputs.distribution,
            "MANIFESTS": "changed" if inputs.hooked else "manifests",
            "DOWNSTREAM": "downstream-results" if values.downstream_workspace else "nothing",
        },
    }
    before, tested = "slim-" if inputs.slim else "", values.tests
    targets: dict[str, Any] = {
        REPORT: {**common, "target": f"{before}{REPORT}", "output": [exported.output(left[REPORT])]}
    }
    if tested:
        targets[RESULTS] = {**common, "target": f"{before}{RESULTS}", "output": [exported.output(left[RESULTS])]}
    elif values.downstream_workspace:  # built all the same, for nobody to take
        targets[RESULTS] = {**common, "target": "downstream-built", "output": ["type=cacheonly"]}
    first = [*targets]
    targets[ASKED] = {**common, "target": ASKED, "output": [exported.output(left[ASKED])]}
    for stage in inputs.stages:
        targets[stage] = {**common, "target": stage}
    if onto:
        # Some stages run on the builder's own platform, for whichever one the app is.
        every = [*dict.fromkeys([*names.platforms, f"linux/{native_architecture()}"])]
        own = {**steps, "platforms": every}
        targets |= adopted.base_targets(onto, BASE, own, inputs.empty, adopted.stage(services, onto))
    for stage, reference in kept.items():
        output = f"type=image,name={reference},push=true,{COMPRESSION}"
        own = targets[BASE] if stage == BASE else {**common, "target": stage}
        targets[f"keep-{stage}"] = {**own, "output": [output]}
    for target in names.targets:
        targets[target] = {
            "context": str(inputs.empty),
            "dockerfile-inline": _dockerfile(target, inputs, target not in unlinked),
            "platforms": list(names.platforms),
            "contexts": base | {name: stages.get(name, f"target:{name}") for name in inputs.stages},
            "args": {"SOURCE_DATE_EPOCH": str(inputs.time), **_variables(target, inputs)},
            "labels": {**_labels(inputs, names.app, target), LOCK: lock},
            "tags": names.tags(target),
            "output": [names.loading if names.loads else f"type=image,push=true,{COMPRESSION}"],
        }
    groups = {PACKAGES: {"targets": [*first, *(f"keep-{stage}" for stage in kept)]}}
    return json.dumps(_literal({"group": groups, "target": targets}), indent=2) + "\n"


def render_base(
    base: Base,
    services: Services,
    environment: Iterable[str],
    platforms: Iterable[str],
    tag: str,
    output: str,
    empty: Path,
) -> str:
    """The bake file of a base image that gets ROS, alone.

    Args:
        environment: variables that are set. tag: its full name. output: where it goes. empty: a folder without files.
    """
    assert base.adopted
    onto, own = base.adopted, _steps(services, environment, platforms)
    targets = adopted.base_targets(onto, BASE, own, empty, adopted.stage(services, onto))
    said = targets[BASE]["labels"] | {TITLE: f"{base.adopted.image.target} on {base.name}"}
    said |= {BASE_NAME: base.name, BASE_DIGEST: base.digest}
    targets[BASE] |= {"tags": [tag], "output": [output], "labels": said}
    return json.dumps(_literal({"target": targets}), indent=2) + "\n"


def _steps(services: Services, environment: Iterable[str], platforms: Iterable[str]) -> dict[str, Any]:
    """What all targets with steps have in common."""
    secrets = [f"type=env,id={name},env={item}" for name, item in _MIRRORS.items() if item in environment]
    if services.ca_bundle:
        secrets.append(f"type=file,id=ca-bundle,src={services.ca_bundle}")
    host = {"network": "host"} if buildx.local_servers(services) else {}
    return {"platforms": list(platforms), "secret": secrets, **host}


def mirrors_with_a_password(environment: Mapping[str, str]) -> list[str]:
    """The variables that name a mirror with a user or a password in its address."""
    return [name for name in _MIRRORS.values() if "@" in environment.get(name, "").partition("?")[0]]


def _literal(value: Any) -> Any:
    """A value in which bake expands nothing."""
    if isinstance(value, str):
        return value.replace("${", "$${").replace("%{", "%%{")
    if isinstance(value, Mapping):
        return {_literal(key): _literal(item) for key, item in value.items()}
    return [_literal(item) for item in value] if isinstance(value, list | tuple) else value


def _variables(target: str, inputs: Inputs) -> dict[str, str]:
    """The environment of an image, beside its base image's."""
    values = inputs.values
    found = {"WORKSPACE": "/docker-ros/ws"}
    base = inputs.slim if target == SLIM and inputs.slim else inputs.base
    if inputs.distribution != base.environment.get("ROS_DISTRO"):
        found["ROS_DISTRO"] = inputs.distribution
    if values.rmw_implementation:
        found["RMW_IMPLEMENTATION"] = values.rmw_implementation
    if target != "dev":
        found["DEFAULT_CMD"] = values.command
    return {f"APP_{name}": value for name, value in found.items()}


def _dockerfile(target: str, inputs: Inputs, linked: bool) -> str:
    """How an image is joined: nothing runs. Values come as arguments, since a value of several lines cannot stand here."""
    lines, command = ["FROM workspace"], ["bash"]
    if target != "dev":
        before = "slim-" if target == SLIM else ""
        base = (target if before else "base") if linked else f"{before}runtime"
        lines = [f"FROM {base}", f"COPY --link --from={before}app / /"]
        own = inputs.slim if target == SLIM and inputs.slim else inputs.base
        if not linked and own.user:  # steps ran as root there
            lines.append(f"USER {own.user}")
        # bash becomes a simple command, so that this gets the signals.
        command = ["bash", "-c", 'exec bash -c "$DEFAULT_CMD"']
    for name in _variables(target, inputs):
        lines += [f"ARG {name}", f"ENV {name.removeprefix('APP_')}=${{{name}}}"]
    return "\n".join([*lines, f"CMD {json.dumps(command)}", ""])


def _labels(inputs: Inputs, name: str, target: str) -> dict[str, str]:
    base = inputs.slim if target == SLIM and inputs.slim else inputs.base
    return {
        TITLE: name if target == "run" else f"{name} ({target})",
        BASE_NAME: base.name,
        BASE_DIGEST: base.digest,
        REVISION: inputs.commit,
        APP: target,
    }
