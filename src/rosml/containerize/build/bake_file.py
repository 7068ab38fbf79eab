"""Writes the bake file of an app: the stages of components/containerize/Dockerfile, and the images that join them."""

from __future__ import annotations

import json
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.containerize.base_image.base import Base
from rosml.containerize.build.call import Call
from rosml.containerize.inputs import Values
from rosml.containerize.names import DESK, DEV, SLIM
from rosml.images.builds import adopted
from rosml.images.builds.base_images import native_architecture
from rosml.images.builds.push import COMPRESSION, compression
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME, COMPRESSED, LOCK, PREFIX, REVISION, TITLE
from rosml.machine import buildx, exported, mirrors
from rosml.machine.services import Services

BASE = "base"
"""The stage that installs ROS on an image without it."""

SCRIPTS = ROOT / "components"

FOREIGN = ("scripts/containerize/workspace.sh", "scripts/containerize/test.sh")
"""Scripts that run code of the packages. Others may run a script of the repository; if that fails, they say so."""

REPLACED = f"{PREFIX}replaced"
"""The label with what the app's packages replace of the base image. Such an app gets another base image only by a build."""

NAMES_IN_LABEL = 10

REPORT, RESULTS, ASKED = "report", "results", "identified"
"""The targets that leave an archive: the reports of rosml's own steps, the test reports, and the packages for each key of rosdep."""

PASSED, TESTS = "passed", "tests"
"""The stage that fails if a test did, and its target: that name is shown before each step that it waits for."""

FAILED = "target-results"
"""The target that leaves the reports of the app's own tests alone, in the archive of `RESULTS`."""

DOCKER_ROS = {
    "COLCON_HOME": "/docker-ros/ws/.colcon",
    "DOCKER_ROS": "1",
    "RCUTILS_COLORIZED_OUTPUT": "1",
    "WORKSPACE": "/docker-ros/ws",
}
"""Variables of docker-ros' images. Steps have them by components/containerize/Dockerfile."""

STAGES = ("app", "runtime", "workspace")
SLIM_STAGES = ("slim-app", "slim-runtime")
PACKAGES = "packages"


@dataclass(frozen=True)
class Inputs:
    targets: tuple[str, ...]  # the images to build
    base: Base
    slim: Base | None  # the base image of the slim image, if there will be one
    distribution: str  # the base image's
    conditions: str  # the ROS with which conditions in manifests compare
    values: Values
    contexts: Mapping[str, Path]  # folders, by their names in the Dockerfile
    empty: Path  # a folder without files
    hooked: bool  # a script changes the sources before their dependencies are read
    commit: str
    time: int  # of the commit, in seconds since 1970
    rosdep: str = ""  # the digest of rosdep's lists, if they are from a registry

    @property
    def stages(self) -> tuple[str, ...]:
        return STAGES + (SLIM_STAGES if self.slim else ())

    def base_of(self, target: str) -> Base:
        return self.slim if target == SLIM and self.slim else self.base


@dataclass(frozen=True)
class Recipe:
    """All from which the bake file of an app follows."""

    call: Call
    inputs: Inputs
    cached_stages: Mapping[str, str] = field(default_factory=dict)  # references of stages that a registry has
    pushed_stages: Mapping[str, str] = field(default_factory=dict)  # references to which others go

    def archive(self, name: str) -> Path:
        """The archive of the target `REPORT`, `RESULTS` or `ASKED`."""
        return self.call.state / f"{name}.tar"


def render(recipe: Recipe, replaced: Mapping[str, Sequence[str]] | None = None, lock: str = "") -> str:
    """The bake file.

    Args:
        replaced: what the app replaces of an image's base. Such an image starts from the stage with the app's packages.
        lock: the inputs of the images, for a label.
    """
    inputs, names, replaced = recipe.inputs, recipe.call.names, replaced or {}
    base, stages = _contexts(recipe)
    common = _common(recipe, base | stages)
    targets = _report_targets(recipe, common)
    groups = {PACKAGES: {"targets": [*targets, *(f"keep-{stage}" for stage in recipe.pushed_stages)]}}
    if inputs.values.tests:
        targets[FAILED] = _leaving(recipe, common, FAILED, RESULTS)
    targets[ASKED] = _leaving(recipe, common, ASKED, ASKED)
    targets |= {stage: {**common, "target": stage} for stage in inputs.stages} | _base_targets(recipe)
    for stage, reference in recipe.pushed_stages.items():
        output = f"type=image,name={reference},push=true,{COMPRESSION}"
        stage_target = targets[BASE] if stage == BASE else {**common, "target": stage}
        targets[f"keep-{stage}"] = {**stage_target, "output": [output]}
    for target in inputs.targets:
        linked = target not in replaced
        contexts = base | {name: stages.get(name, f"target:{name}") for name in _joined_stages(target, linked)}
        labels = {**_labels(inputs, names.app, target, replaced.get(target, ())), LOCK: lock}
        targets[target] = _image(recipe, target, linked, contexts, labels)
    return _text({"group": groups, "target": targets})


def _leaving(recipe: Recipe, common: Mapping[str, Any], stage: str, archive: str) -> dict[str, Any]:
    """A target that leaves a stage in an archive."""
    return {**common, "target": stage, "output": [exported.output(recipe.archive(archive))]}


def _report_targets(recipe: Recipe, common: Mapping[str, Any]) -> dict[str, Any]:
    before, values = "slim-" if recipe.inputs.slim else "", recipe.inputs.values
    targets = {REPORT: _leaving(recipe, common, f"{before}{REPORT}", REPORT)}
    if values.tests:
        targets[RESULTS] = _leaving(recipe, common, f"{before}{RESULTS}", RESULTS)
    elif values.downstream_workspace:  # built all the same, without output
        targets[RESULTS] = {**common, "target": "downstream-built", "output": ["type=cacheonly"]}
    if values.tests and not recipe.pushed_stages:  # a cache gets all stages: whoever corrects the test builds on them
        targets[TESTS] = {**common, "target": PASSED, "output": ["type=cacheonly"]}
    return targets


def _image(
    recipe: Recipe, target: str, linked: bool, contexts: Mapping[str, str], labels: Mapping[str, str]
) -> dict[str, Any]:
    inputs, names = recipe.inputs, recipe.call.names
    pushed = f"type=image,push=true,{compression(inputs.base_of(target).labels.get(COMPRESSED, ''))}"
    return {
        "context": str(inputs.empty),
        "dockerfile-inline": _dockerfile(target, inputs, linked),
        "platforms": list(names.platforms),
        "contexts": contexts,
        "args": {"SOURCE_DATE_EPOCH": str(inputs.time), **_variables(target, inputs)},
        "labels": labels,
        "tags": names.tags(target),
        "output": [names.loading if names.loads else pushed],
    }


def render_shell_image(recipe: Recipe) -> str:
    """The bake file of the image for `rosml dev`. It names no commit, so that the same content has the same digest."""
    inputs = recipe.inputs
    base, stages = _contexts(recipe)
    common = _common(recipe, base | stages)
    title = f"{recipe.call.names.app} ({DESK})"
    labels = {TITLE: title, BASE_NAME: inputs.base.name, BASE_DIGEST: inputs.base.digest}
    targets = {
        ASKED: _leaving(recipe, common, ASKED, ASKED),
        **_base_targets(recipe),
        f"{DESK}-stage": {**common, "target": DESK},
        DESK: _image(recipe, DESK, False, {DESK: f"target:{DESK}-stage"}, labels),
    }
    return _text({"target": targets})


def _contexts(recipe: Recipe) -> tuple[dict[str, str], dict[str, str]]:
    """The contexts of the base images, and those of stages that a registry has."""
    inputs, cached = recipe.inputs, recipe.cached_stages
    stages = {name: f"docker-image://{reference}" for name, reference in cached.items()}
    built_here = inputs.base.adopted and BASE not in cached
    base = {BASE: f"target:{BASE}" if built_here else stages.pop(BASE, f"docker-image://{inputs.base.reference}")}
    if inputs.slim:
        base["slim"] = f"docker-image://{inputs.slim.reference}"
    return base | {name: f"target:{name}-with-addons" for name in _bases_with_addons(inputs)}, stages


def _common(recipe: Recipe, contexts: Mapping[str, str]) -> dict[str, Any]:
    """The fields of all targets that are stages of the Dockerfile."""
    inputs, values = recipe.inputs, recipe.inputs.values
    common = steps(recipe.call.services, recipe.call.environment, recipe.call.names.platforms)
    if values.parallel_jobs:  # as a secret: the result does not depend on it, so steps need not run again
        common["secret"].append("type=env,id=parallel-jobs,env=PARALLEL_JOBS")
    if values.allow_script_secrets:
        common["secret"] += [
            f"type=env,id={variable.lower().replace('_', '-')},env={variable}" for variable in script_secrets(values)
        ]
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
            "CONDITIONS": inputs.conditions,
            "MANIFESTS": "changed" if inputs.hooked else "manifests",
            "DOWNSTREAM": "downstream-results" if values.downstream_workspace else "nothing",
            # Their values are in no key of the builder's cache, so a step with them is another one than a step without.
            **({"SCRIPT_SECRETS": "true"} if values.allow_script_secrets else {}),
            **({"RMW_IMPLEMENTATION": values.rmw_implementation} if values.rmw_implementation else {}),
        },
    }


def script_secrets(values: Values) -> dict[str, str]:
    """The variables that scripts of the repository get if the user allows it."""
    names = ("git-https-server", "git-https-user", "git-https-password")
    return {name.upper().replace("-", "_"): text for name in names if (text := values.text(name))}


def _base_targets(recipe: Recipe) -> dict[str, Any]:
    inputs, services = recipe.inputs, recipe.call.services
    # Some stages run on the builder's own platform, whatever the app's is.
    platforms = [*dict.fromkeys([*recipe.call.names.platforms, f"linux/{native_architecture()}"])]
    ros = inputs.base.adopted
    if ros is None or BASE in recipe.cached_stages:
        joined = _bases_with_addons(inputs).items()
        return {f"{name}-with-addons": _joining(base, inputs, platforms) for name, base in joined}
    common = steps(services, recipe.call.environment, platforms)
    return adopted.base_targets(ros, BASE, common, inputs.empty, adopted.stage(services, ros))


def _bases_with_addons(inputs: Inputs) -> dict[str, Base]:
    return {name: base for name, base in ((BASE, inputs.base), ("slim", inputs.slim)) if base and base.addons}


def _joining(base: Base, inputs: Inputs, platforms: Sequence[str]) -> dict[str, Any]:
    assert base.addons
    return {
        "context": str(inputs.empty),
        "dockerfile-inline": base.addons.dockerfile("without"),
        "contexts": {"without": f"docker-image://{base.reference}", **base.addons.contexts()},
        "platforms": list(platforms),
        "labels": dict(base.addons.labels),
    }


def render_base(base: Base, services: Services, common: Mapping[str, Any], tag: str, output: str, empty: Path) -> str:
    """The bake file of a base image that gets ROS, without an app. `common`: the result of `steps`. Other arguments: as of `adopt.make`."""
    assert base.adopted
    targets = adopted.base_targets(base.adopted, BASE, common, empty, adopted.stage(services, base.adopted))
    labels = targets[BASE]["labels"] | {TITLE: f"{base.adopted.image.target} on {base.name}"}
    labels |= {BASE_NAME: base.name, BASE_DIGEST: base.digest}
    targets[BASE] |= {"tags": [tag] if tag else [], "output": [output], "labels": labels}
    return _text({"target": targets})


def steps(services: Services, environment: Container[str], platforms: Iterable[str]) -> dict[str, Any]:
    """The common fields of all targets with steps. `environment`: the names of set variables."""
    secrets = mirrors.secrets(environment)
    if services.ca_bundle:
        secrets.append(f"type=file,id=ca-bundle,src={services.ca_bundle}")
    host = {"network": "host"} if buildx.local_servers(services) else {}
    return {"platforms": list(platforms), "secret": secrets, **host}


def _text(content: Mapping[str, Any]) -> str:
    return json.dumps(_literal(content), indent=2) + "\n"


def _literal(value: Any) -> Any:
    """A value with escapes, so that bake expands nothing."""
    if isinstance(value, str):
        return value.replace("${", "$${").replace("%{", "%%{")
    if isinstance(value, Mapping):
        return {_literal(key): _literal(item) for key, item in value.items()}
    return [_literal(item) for item in value] if isinstance(value, list | tuple) else value


def _variables(target: str, inputs: Inputs) -> dict[str, str]:
    """The variables of an image that its base image does not have, as arguments of its Dockerfile."""
    values = inputs.values
    variables = dict(DOCKER_ROS)
    if inputs.distribution != inputs.base_of(target).environment.get("ROS_DISTRO"):
        variables["ROS_DISTRO"] = inputs.distribution
    if values.rmw_implementation:
        variables["RMW_IMPLEMENTATION"] = values.rmw_implementation
    if target not in (DESK, DEV):
        variables["DEFAULT_CMD"] = values.command
    return {f"APP_{name}": value for name, value in variables.items()}


def _joined_stages(target: str, linked: bool) -> tuple[str, ...]:
    """The stages that an image's Dockerfile names: the builder makes all contexts, also those that no line names."""
    if target == DEV:
        return ("workspace",)
    before = "slim-" if target == SLIM else ""
    return (f"{before}app",) if linked else (f"{before}runtime", f"{before}app")


def _dockerfile(target: str, inputs: Inputs, linked: bool) -> str:
    """The Dockerfile that joins an image without a step. Values are arguments, as they may have several lines. A `linked` app is a layer on
    the base image, and not on the stage with its packages."""
    lines, command = [f"FROM {DESK if target == DESK else 'workspace'}"], ["bash"]
    if target not in (DESK, DEV):
        before = "slim-" if target == SLIM else ""
        base = (target if before else "base") if linked else f"{before}runtime"
        lines = [f"FROM {base}", f"COPY --link --from={before}app / /"]
        user = inputs.base_of(target).user
        if not linked and user:  # steps ran as root there
            lines.append(f"USER {user}")
        # bash becomes a simple command, so that this gets the signals.
        command = ["bash", "-c", 'exec bash -c "$DEFAULT_CMD"']
    for name in (*_variables(target, inputs), "APP_TARGETARCH"):
        lines += [f"ARG {name}", f"ENV {name.removeprefix('APP_')}=${{{name}}}"]
    # Of each platform its own, so it is no value that bake passes.
    return "\n".join(["ARG APP_TARGETARCH=${TARGETARCH}", *lines, f"CMD {json.dumps(command)}", ""])


def _labels(inputs: Inputs, name: str, target: str, replaced: Sequence[str]) -> dict[str, str]:
    base = inputs.base_of(target)
    return {
        TITLE: name if target == "run" else f"{name} ({target})",
        BASE_NAME: base.name,
        BASE_DIGEST: base.digest,
        REVISION: inputs.commit,
        APP: target,
        **({REPLACED: " ".join(replaced[:NAMES_IN_LABEL])} if replaced else {}),
    }
