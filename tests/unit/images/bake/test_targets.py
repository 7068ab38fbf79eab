"""What buildx makes of the bake file and what Python takes it for are the same, whatever the variables say: inputs are
digested from the one, images are built from the other."""

from __future__ import annotations

import datetime
import json
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL, WHEELS, changed, parse

from fakes.bakes import evaluated, printed, whole
from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file, targets
from rosml.images.bake.targets import Context, Dependency, Locks, NoInput, Overridable, Target, Value
from rosml.images.image_set import load, locked
from rosml.images.image_set.model import ImageSet

# ---- What Python says ------------------------------------------------------------------------------------------------


class Caller:
    """Who calls bake, with values for its variables."""

    def __init__(self, image_set: ImageSet, values: Mapping[str, str]) -> None:
        self.variables = {**bake_file.variables(image_set.matrix), **values}
        self.digests: dict[str, str] = json.loads(self.variables["DIGESTS"] or "{}")
        self.dates: dict[str, str] = json.loads(self.variables["ROS_SYNC_DATES"] or "{}")

    def text(self, value: Value | Context) -> str | None:
        """A value; None where it is left out."""
        match value:
            case str():
                return value
            case Locks(folder):
                return folder
            case Overridable():
                return self.variables[value.variable] or value.fact
            case Dependency(target, name, repository):
                digest = self.digests.get(name)
                image = f"docker-image://{self.variables['REGISTRY']}/{repository}@{digest}"
                return image if digest else f"target:{target}"
            case NoInput(what, of):
                return self._no_input(what, of)

    def _no_input(self, what: str, of: str) -> str | None:
        match what:
            case "variable":
                return self.variables[of] or None
            case "sync date":
                return self.dates.get(of, "")
            case "root":
                return "/" if self.digests.get(of) else "/out/"
            case "base name":
                name = self.variables[of].removeprefix("docker-image://").partition("@")[0]
                return name.replace(self.variables["DOCKER_HUB"], "docker.io/")
            case "base digest":
                return self.variables[of].partition("@")[2]
            case _:
                moment = datetime.datetime.fromtimestamp(int(self.variables[of]), datetime.UTC)
                return moment.strftime("%Y-%m-%dT%H:%M:%SZ")

    @property
    def secrets(self) -> list[dict[str, str]]:
        certificates, ros, os = (self.variables[name] for name in ("CA_BUNDLE", "ROS_APT_MIRROR", "OS_APT_MIRROR"))
        secrets = [{"id": "ca-bundle", "src": certificates}] if certificates else []
        secrets += [{"id": "ros-apt-mirror", "env": "ROS_APT_MIRROR"}] if ros else []
        return secrets + ([{"id": "os-apt-mirror", "env": "OS_APT_MIRROR"}] if os else [])

    def printed(self, target: Target) -> dict[str, Any]:
        """A target as `bake --print` has it."""
        every = {
            "context": ".",
            "dockerfile": "Dockerfile",
            "target": target.stage,
            "dockerfile-inline": target.join.dockerfile() if target.join else "",
            "description": target.description,
            "contexts": {name: self.text(value) for name, value in target.contexts.items()},
            "args": {name: text for name, value in target.arguments.items() if (text := self.text(value)) is not None},
            "labels": {name: text for name, value in target.labels.items() if (text := self.text(value))},
            "tags": [f"{self.variables['REGISTRY']}/{tag}" for tag in target.tags],
            "platforms": self._platforms(target),
            "secret": self.secrets,
            "network": self.variables["STEP_NETWORK"],
            "entitlements": ["network.host"] if self.variables["STEP_NETWORK"] == "host" else [],
            "output": [{"type": "cacheonly"}] if target.stage == "test" else [],
        }
        return {name: value for name, value in every.items() if value}

    def _platforms(self, target: Target) -> list[str]:
        chosen = self.variables["PLATFORM"]
        return [chosen] if chosen and target.platforms else list(target.platforms)


# ---- Matrices and callers --------------------------------------------------------------------------------------------


ASIDE = changed("desktop: {builds_on: robot}", "desktop: {builds_on: core}")
RMW = changed(
    "    apt: {channel: live}",
    "    apt: {channel: live}\n    usual_rmw: rmw_zenoh_cpp\n    rmw: [rmw_cyclonedds_cpp, rmw_zenoh_cpp]",
)
BOTH = changed("wheels: {cu1: [amd64], cpu: [arm64]}", "wheels: {cu1: [amd64], cpu: [amd64, arm64]}", WHEELS)

MATRICES: dict[str, Callable[[], ImageSet]] = {
    "ours": lambda: load.load(ROOT / "matrix.yaml"),
    "small": lambda: parse(SMALL),
    "from wheels": lambda: parse(WHEELS),
    "without locks": lambda: locked.with_locks(parse(WHEELS), []),
    "components side by side": lambda: parse(ASIDE),
    "more middlewares": lambda: parse(RMW),
    "no address": lambda: parse(changed("source: https://example.org/images\n", "")),
    "fewer platforms": lambda: parse(BOTH),
}
OTHERS = [name for name in MATRICES if name != "ours"]
"""Small ones: buildx takes seconds for the whole of ours."""


@cache
def image_set(name: str) -> ImageSet:
    return MATRICES[name]()


def callers(image_set: ImageSet) -> dict[str, dict[str, str]]:
    """Values of the bake file's variables by what a caller says: nothing, or something for every variable."""
    published = [*(image.target for image in image_set.images), *(part.name for part in image_set.parts)]
    systems = [
        name for name in bake_file.variables(image_set.matrix) if name.startswith("OS_") and name != "OS_APT_MIRROR"
    ]
    rows = list(image_set.matrix.distributions)
    everything = {
        "REGISTRY": "registry.test:5001/some/where",
        **{name: f"docker-image://mirror.test/{name.lower()}:x@sha256:{'a' * 64}" for name in systems},
        "DOCKER_HUB": "mirror.test/",
        "PLATFORM": "linux/riscv64",
        "SOURCE_DATE_EPOCH": "86400",
        "REVISION": "0123abc",
        "DIGESTS": json.dumps({name: f"sha256:{n:064x}" if n % 5 else "" for n, name in enumerate(published) if n % 3}),
        "ROS_SYNC_DATES": json.dumps({name: f"2026-11-{n + 1:02}" if n % 3 else "" for n, name in enumerate(rows)}),
        "ROS_CHANNEL": "snapshot",
        "ROS_SNAPSHOT": "2026-10-01",
        "CA_BUNDLE": str(ROOT / "matrix.yaml"),  # any file
        "ROS_APT_MIRROR": "http://ros.mirror.test",
        "OS_APT_MIRROR": "http://os.mirror.test",
        "STEP_NETWORK": "host",
        "HTTP_PROXY": "http://proxy.test:1",
        "HTTPS_PROXY": "http://proxy.test:2",
        "NO_PROXY": "intern.test",
    }  # fmt: skip
    undigested = {name: f"docker-image://intern.test/{name.lower()}" for name in systems}
    digests = json.dumps(dict.fromkeys(published, f"sha256:{'b' * 64}"))
    return {
        "nothing": {},
        "everything": everything,
        "a little": {**undigested, "DIGESTS": digests, "ROS_CHANNEL": "final"},
    }


def differences(image_set: ImageSet, text: str, values: Mapping[str, str], folder: Path) -> dict[str, tuple[Any, Any]]:
    """The targets of a bake file that Python and buildx take for something else, by both."""
    caller = Caller(image_set, values)
    by_python = {name: caller.printed(target) for name, target in targets.of(image_set).items()}
    file = folder / "bake.hcl"
    group = f'group "everything" {{ targets = {json.dumps(list(by_python))} }}'  # names are slow one by one
    file.write_text(f"{text}\n{group}\n")
    by_buildx = printed("everything", file=file, **values)
    return {
        name: (by_python.get(name), by_buildx.get(name))
        for name in by_python | by_buildx
        if by_python.get(name) != by_buildx.get(name)
    }


# ---- The same --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "says"),
    [("ours", "everything"), *((name, says) for name in OTHERS for says in ("nothing", "everything", "a little"))],
)
def test_every_target_is_what_buildx_makes_of_it(name: str, says: str, tmp_path: Path) -> None:
    tested = image_set(name)
    assert differences(tested, whole(tested), callers(tested)[says], tmp_path) == {}


@pytest.mark.parametrize("name", OTHERS)
def test_every_group_is_what_buildx_makes_of_it(name: str, tmp_path: Path) -> None:
    tested = image_set(name)
    file = tmp_path / "bake.hcl"
    file.write_text(whole(tested))
    if not tested.groups:
        with pytest.raises(RosmlError, match="failed to find target default"):
            evaluated("default", file=file)
        return
    names = tested.groups.keys() - {"default"}
    printed_groups = evaluated(*names, file=file)["group"]  # `default` has these names here
    printed_groups |= evaluated("default", file=file)["group"]
    members = {name: set(group["targets"]) for name, group in printed_groups.items()}
    assert members == {name: set(targets) for name, targets in tested.groups.items()}


@pytest.mark.parametrize("name", MATRICES)
def test_no_variable_is_left_unsaid(name: str) -> None:
    tested = image_set(name)
    values, defaults = callers(tested)["everything"], bake_file.variables(tested.matrix)
    assert values.keys() == defaults.keys()
    assert all(values[variable] not in ("", default) for variable, default in defaults.items())
