"""Writes the bake file of an app: the stages of components/containerize/Dockerfile, and the images that join them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.containerize.base_image.base import Base
from rosml.containerize.build.stage_cache import BASE
from rosml.containerize.inputs import Values
from rosml.containerize.names import DESK, SLIM, Names
from rosml.images.builds import adopted
from rosml.images.builds.base_images import native_architecture
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set.labels import APP, PREFIX, REVISION, TITLE
from rosml.machine import buildx, exported
from rosml.machine.services import Services

SCRIPTS = ROOT / "components"
"""The scripts that steps of the build call."""

FOREIGN = ("scripts/containerize/workspace.sh", "scripts/containerize/test.sh")
"""Scripts that run code of the packages. Others may run a script of the repository; if that fails, they say so."""

BASE_NAME = "org.opencontainers.image.base.name"
BASE_DIGEST = "org.opencontainers.image.base.digest"

LOCK = f"{PREFIX}lock"
"""The label with an image's inputs, as in the lock file."""

REPLACED = f"{PREFIX}replaced"
"""The label of an app whose packages replace something of its base image: what, as far as `NAMED` names go. Such an app is on no other
base image without a build."""

NAMED = 10

REPORT, RESULTS, ASKED = "report", "results", "identified"
"""The targets that leave an archive: the reports of rosml's own steps, the test reports, and the packages for each key of rosdep, in
case these cannot be installed."""

PASSED = "passed"
"""The stage that fails if a test did."""

TESTS = "tests"
"""The target of that stage: its name is shown before each step that it waits for."""

FAILED = "target-results"
"""The target that leaves the reports of the app's own tests alone, in the archive of `RESULTS`."""

STAGES = ("app", "runtime", "workspace")
"""Stages that images join."""

SLIM_STAGES = ("slim-app", "slim-runtime")
"""Stages that a slim image joins."""

PACKAGES = "packages"
"""The group of all targets before the images."""

_MIRRORS = {"os-apt-mirror": "OS_APT_MIRROR", "ros-apt-mirror": "ROS_APT_MIRROR"}


@dataclass(frozen=True)
class Inputs:
    """The inputs of an app's build.

    Attributes:
        base: the base image.
        distribution: its ROS distribution.
        slim: the base image of the slim image, if there will be one.
        values: the user's inputs.
        contexts: folders with sources, manifests and requests, by their names in the Dockerfile.
        empty: a folder without files.
        hooked: a script changes the sources before their dependencies are read.
        rosdep: the digest of rosdep's lists, if they are from a registry.
        conditions: the ROS with which conditions in manifests compare.
        commit: the commit of the sources.
        time: the time of that commit, in seconds since 1970.
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
        """Stages that images join."""
        return STAGES + (SLIM_STAGES if self.slim else ())


def render(
    inputs: Inputs,
    names: Names,
    services: Services,
    environment: Iterable[str],
    left: Mapping[str, Path],
    known: Mapping[str, str],
    kept: Mapping[str, str],
    replaced: Mapping[str, Sequence[str]] | None = None,
    lock: str = "",
) -> str:
    """The bake file.

    Args:
        environment: the names of set variables.
        left: the archives of the targets `REPORT`, `RESULTS` and `ASKED`.
        known: references of stages that a registry has.
        kept: references to which other stages go.
        replaced: of images that do not link the app onto their base image, the packages and files of it that the app replaces. They
            start from the stage with the app's packages.
        lock: the inputs of the images, for a label.
    """
    values, replaced = inputs.values, replaced or {}
    base, stages = _contexts(inputs, known)
    common = _common(inputs, names, services, environment, base | stages)
    before, tested = "slim-" if inputs.slim else "", values.tests
    targets: dict[str, Any] = {
        REPORT: {**common, "target": f"{before}{REPORT}", "output": [exported.output(left[REPORT])]}
    }
    if tested:
        targets[RESULTS] = {**common, "target": f"{before}{RESULTS}", "output": [exported.output(left[RESULTS])]}
    elif values.downstream_workspace:  # built all the same, without output
        targets[RESULTS] = {**common, "target": "downstream-built", "output": ["type=cacheonly"]}
    if tested and not kept:  # a cache gets all stages: whoever mends the test builds on them
        targets[TESTS] = {**common, "target": PASSED, "output": ["type=cacheonly"]}
    first = [*targets]
    if tested:
        targets[FAILED] = {**common, "target": FAILED, "output": [exported.output(left[RESULTS])]}
    targets[ASKED] = {**common, "target": ASKED, "output": [exported.output(left[ASKED])]}
    for stage in inputs.stages:
        targets[stage] = {**common, "target": stage}
    targets |= _adopted(inputs, names, services, environment, known)
    for stage, reference in kept.items():
        output = f"type=image,name={reference},push=true,{COMPRESSION}"
        own = targets[BASE] if stage == BASE else {**common, "target": stage}
        targets[f"keep-{stage}"] = {**own, "output": [output]}
    for target in names.targets:
        targets[target] = {
            "context": str(inputs.empty),
            "dockerfile-inline": _dockerfile(target, inputs, target not in replaced),
            "platforms": list(names.platforms),
            "contexts": base
            | {name: stages.get(name, f"target:{name}") for name in _used(target, target not in replaced)},
            "args": {"SOURCE_DATE_EPOCH": str(inputs.time), **_variables(target, inputs)},
            "labels": {**_labels(inputs, names.app, target, replaced.get(target, ())), LOCK: lock},
            "tags": names.tags(target),
            "output": [_output(names)],
        }
    groups = {PACKAGES: {"targets": [*first, *(f"keep-{stage}" for stage in kept)]}}
    return json.dumps(_literal({"group": groups, "target": targets}), indent=2) + "\n"


def render_desk(
    inputs: Inputs, names: Names, services: Services, environment: Iterable[str], left: Path, known: Mapping[str, str]
) -> str:
    """The bake file of the image for `rosml dev`. It names no commit: an image with the same content has the same digest.

    Args:
        environment: the names of set variables.
        left: the archive of the target `ASKED`.
        known: references of stages that a registry has.
    """
    base, stages = _contexts(inputs, known)
    common = _common(inputs, names, services, environment, base | stages)
    targets = {
        ASKED: {**common, "target": ASKED, "output": [exported.output(left)]},
        **_adopted(inputs, names, services, environment, known),
        f"{DESK}-stage": {**common, "target": DESK},
        DESK: {
            "context": str(inputs.empty),
            "dockerfile-inline": _dockerfile(DESK, inputs, linked=False),
            "platforms": list(names.platforms),
            "contexts": {DESK: f"target:{DESK}-stage"},
            "args": {"SOURCE_DATE_EPOCH": str(inputs.time), **_variables(DESK, inputs)},
            "labels": {TITLE: f"{names.app} ({DESK})", BASE_NAME: inputs.base.name, BASE_DIGEST: inputs.base.digest},
            "tags": names.tags(DESK),
            "output": [_output(names)],
        },
    }
    return json.dumps(_literal({"target": targets}), indent=2) + "\n"


def _output(names: Names) -> str:
    """The builder's output of an image: into Docker, or to a registry."""
    return names.loading if names.loads else f"type=image,push=true,{COMPRESSION}"


def _contexts(inputs: Inputs, known: Mapping[str, str]) -> tuple[dict[str, str], dict[str, str]]:
    """The contexts of the base images, and those of stages that a registry has."""
    stages = {name: f"docker-image://{reference}" for name, reference in known.items()}
    onto = inputs.base.adopted if BASE not in known else None
    base = {BASE: f"target:{BASE}" if onto else stages.pop(BASE, f"docker-image://{inputs.base.reference}")}
    if inputs.slim:
        base["slim"] = f"docker-image://{inputs.slim.reference}"
    return base | {name: f"target:{_with_addons(name)}" for name in _joined(inputs)}, stages


def _common(
    inputs: Inputs, names: Names, services: Services, environment: Iterable[str], contexts: Mapping[str, str]
) -> dict[str, Any]:
    """The fields of all targets that are stages of the Dockerfile.

    Args:
        contexts: beside the scripts and folders.
    """
    values = inputs.values
    common = steps(services, environment, names.platforms)
    if values.parallel_jobs:  # as a secret: the result does not depend on it, so steps need not run again
        common["secret"].append("type=env,id=parallel-jobs,env=PARALLEL_JOBS")
    folders = {name: str(path) for name, path in inputs.contexts.items()}
    return {
        **common,
        "context": str(inputs.empty),
        "dockerfile": str(SCRIPTS / "containerize/Dockerfile"),
        "contexts": {"scripts": str(SCRIPTS), **folders, **contexts},
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


def _adopted(
    inputs: Inputs, names: Names, services: Services, environment: Iterable[str], known: Mapping[str, str]
) -> dict[str, Any]:
    """The targets that join add-ons to base images, or install ROS on one; none of the latter if it has ROS, or if a registry has the
    result."""
    # Some stages run on the builder's own platform, whatever the app's is.
    every = [*dict.fromkeys([*names.platforms, f"linux/{native_architecture()}"])]
    found = {_with_addons(name): _joining(base, inputs, every) for name, base in _joined(inputs).items()}
    onto = inputs.base.adopted
    if onto is None or BASE in known:
        return found
    own = steps(services, environment, every)
    return adopted.base_targets(onto, BASE, own, inputs.empty, adopted.stage(services, onto))


def _with_addons(name: str) -> str:
    """The target of a base image with add-ons, by the name of its context."""
    return f"{name}-with-addons"


def _joined(inputs: Inputs) -> dict[str, Base]:
    """The base images with add-ons, by the names of their contexts."""
    return {name: base for name, base in ((BASE, inputs.base), ("slim", inputs.slim)) if base and base.addons}


def _joining(base: Base, inputs: Inputs, platforms: Sequence[str]) -> dict[str, Any]:
    """The target that joins add-ons to a base image."""
    assert base.addons
    return {
        "context": str(inputs.empty),
        "dockerfile-inline": base.addons.dockerfile("without"),
        "contexts": {"without": f"docker-image://{base.reference}", **base.addons.contexts()},
        "platforms": list(platforms),
        "labels": dict(base.addons.labels),
    }


def render_base(
    base: Base,
    services: Services,
    environment: Iterable[str],
    platforms: Iterable[str],
    tag: str,
    output: str,
    empty: Path,
) -> str:
    """The bake file of a base image that gets ROS, without an app.

    Args:
        environment: the names of set variables.
        tag: its full name; empty if it gets none.
        output: the builder's output.
        empty: a folder without files.
    """
    assert base.adopted
    onto, own = base.adopted, steps(services, environment, platforms)
    targets = adopted.base_targets(onto, BASE, own, empty, adopted.stage(services, onto))
    said = targets[BASE]["labels"] | {TITLE: f"{base.adopted.image.target} on {base.name}"}
    said |= {BASE_NAME: base.name, BASE_DIGEST: base.digest}
    targets[BASE] |= {"tags": [tag] if tag else [], "output": [output], "labels": said}
    return json.dumps(_literal({"target": targets}), indent=2) + "\n"


def steps(services: Services, environment: Iterable[str], platforms: Iterable[str]) -> dict[str, Any]:
    """The common fields of all targets with steps."""
    secrets = [f"type=env,id={name},env={item}" for name, item in _MIRRORS.items() if item in environment]
    if services.ca_bundle:
        secrets.append(f"type=file,id=ca-bundle,src={services.ca_bundle}")
    host = {"network": "host"} if buildx.local_servers(services) else {}
    return {"platforms": list(platforms), "secret": secrets, **host}


def mirrors_with_a_password(environment: Mapping[str, str]) -> list[str]:
    """The variables with a mirror whose address has a user or a password."""
    return [name for name in _MIRRORS.values() if "@" in environment.get(name, "").partition("?")[0]]


def _literal(value: Any) -> Any:
    """A value with escapes, so that bake expands nothing."""
    if isinstance(value, str):
        return value.replace("${", "$${").replace("%{", "%%{")
    if isinstance(value, Mapping):
        return {_literal(key): _literal(item) for key, item in value.items()}
    return [_literal(item) for item in value] if isinstance(value, list | tuple) else value


def _variables(target: str, inputs: Inputs) -> dict[str, str]:
    """The variables of an image that its base image does not have."""
    values = inputs.values
    found = {"WORKSPACE": "/docker-ros/ws"}
    base = inputs.slim if target == SLIM and inputs.slim else inputs.base
    if inputs.distribution != base.environment.get("ROS_DISTRO"):
        found["ROS_DISTRO"] = inputs.distribution
    if values.rmw_implementation:
        found["RMW_IMPLEMENTATION"] = values.rmw_implementation
    if target not in (DESK, "dev"):
        found["DEFAULT_CMD"] = values.command
    return {f"APP_{name}": value for name, value in found.items()}


def _used(target: str, linked: bool) -> tuple[str, ...]:
    """The stages that the Dockerfile of an image names: the builder makes all of its contexts, also those that no line names.

    Args:
        linked: as in `_dockerfile`.
    """
    if target == "dev":
        return ("workspace",)
    before = "slim-" if target == SLIM else ""
    return (f"{before}app",) if linked else (f"{before}runtime", f"{before}app")


def _dockerfile(target: str, inputs: Inputs, linked: bool) -> str:
    """The Dockerfile that joins an image without running anything. Values are arguments, as they may have several lines."""
    lines, command = [f"FROM {DESK if target == DESK else 'workspace'}"], ["bash"]
    if target not in (DESK, "dev"):
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


def _labels(inputs: Inputs, name: str, target: str, replaced: Sequence[str]) -> dict[str, str]:
    base = inputs.slim if target == SLIM and inputs.slim else inputs.base
    return {
        TITLE: name if target == "run" else f"{name} ({target})",
        BASE_NAME: base.name,
        BASE_DIGEST: base.digest,
        REVISION: inputs.commit,
        APP: target,
        **({REPLACED: " ".join(replaced[:NAMED])} if replaced else {}),
    }
