"""An app to build: a repository with a package, a base image in a registry, and a builder that leaves reports."""

from __future__ import annotations

import copy
import dataclasses
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from fakes import archives
from fakes.http_registry import LocalRegistry
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order
from rosml.containerize.build.result import Result
from rosml.containerize.inputs import Values
from rosml.containerize.sources import fetch as sources
from rosml.images.builds.base_images import native_architecture
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

PACKAGE = "<package><name>{}</name></package>"
NATIVE = f"linux/{native_architecture()}"

APP: dict[str, Any] = {
    **{name: [] for name in ("changed", "replaced", "removed", "lost", "absent", "outside", "pip")},
    "packages": ["libfoo:all"],
    "built": ["robot"],
    "forgotten": {},
    "architecture": "amd64",
    "apt": {"libfoo": "1.0"},
}
DEPENDENCIES: dict[str, Any] = {"packages": {"robot": {"build": ["roscpp"]}}, "keys": {}, "skipped": []}

NOBLE = {
    "etc/os-release": "ID=ubuntu\nVERSION_ID=24.04\n",
    **dict.fromkeys(("bin/bash", "bin/apt-get", "dpkg/status"), ""),
    "apt/ubuntu.sources": "Types: deb\n",
    "entrypoint/0/start.sh": '#!/bin/sh\nexec "$@"\n',
}
"""What the builder copies out of an image of Ubuntu."""


def put(services: Services, name: str, *platforms: str, config: Mapping[str, object] | None = None, **env: str) -> str:
    """Puts an image into the registry, for this machine's platform or others. Returns the digest of its index."""
    repository, _, tag = name.partition(":")
    with Registry(services.registry) as client:
        entries = []
        for system, architecture in (platform.split("/") for platform in platforms or (NATIVE,)):
            settings = {"Env": [f"{name}={value}" for name, value in env.items()], **(config or {})}
            blob = oci.encoded({"os": system, "architecture": architecture, "config": settings})
            client.put_blob(repository, blob)
            image = {
                "schemaVersion": 2,
                "mediaType": oci.IMAGE,
                "config": oci.descriptor(oci.CONFIG, blob),
                "layers": [],
            }
            manifest = oci.encoded(image)
            client.put_manifest(repository, "", manifest)
            platform = {"os": system, "architecture": architecture}
            entries.append({**oci.descriptor(oci.IMAGE, manifest), "platform": platform})
        index = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        return client.put_manifest(repository, tag, index, oci.INDEX)


class Robot:
    """An app, what its builds say, and the targets that the builder builds."""

    def __init__(self, folder: Path, services: Services) -> None:
        self.folder, self.services = folder, services
        self.messages: list[str] = []
        self.targets: list[dict[str, Any]] = []
        self.app, self.slim_app, self.dependencies = map(copy.deepcopy, (APP, APP, DEPENDENCIES))
        self.contents = dict[str, str]()  # what a build says of images, by place in its report
        self.cache = f"{services.registry}/me/cache"

    def write(self, name: str, text: str = "") -> None:
        """Writes a file; with a manifest, also the files by which colcon builds packages."""
        place = self.folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text)
        if place.name == "package.xml":
            (place.parent / "CMakeLists.txt").touch()
            (place.parent / "setup.py").touch()

    def put(self, name: str = "rosml/ros:jazzy", *platforms: str, **options: Any) -> str:
        return put(self.services, name, *platforms, **{"ROS_DISTRO": "jazzy", **options})

    def values(self, **inputs: str) -> Values:
        inputs = {"base_image": "ros:jazzy", "command": "true", **inputs}
        return app_inputs.values({name.replace("_", "-"): value for name, value in inputs.items()}, self.folder, {})

    def call(
        self, environment: Mapping[str, str] | None = None, renew: bool = False, /, **inputs: str
    ) -> step_order.Call:
        values = self.values(**inputs)
        return step_order.new_call(self.folder, values, environment or {}, self.services, self.messages.append, renew)

    def build(self, environment: Mapping[str, str] | None = None, /, **inputs: str) -> Result:
        return step_order.build_images(self.call(environment, **inputs))

    def renew(self, **inputs: str) -> Result:
        """Builds with `--lock`."""
        return step_order.build_images(self.call(None, True, **inputs))

    @property
    def names(self) -> list[str]:
        return [target["name"] for target in self.targets]

    @property
    def bake_file(self) -> dict[str, Any]:
        [file] = self.services.state.rglob("bake.json")
        content: dict[str, Any] = json.loads(file.read_text())
        return content

    def messages_with(self, word: str) -> list[str]:
        return [line for line in self.messages if word in line]

    def run(self, services: Services, bake: buildx.Bake) -> tuple[None, dict[str, str]]:
        targets = json.loads(bake.file.read_text())["target"]
        target = targets.get(bake.target) or targets["report"]
        self.targets.append({**target, "name": bake.target, "variables": bake.variables})
        reports = {"dependencies.json": self.dependencies, "app.json": self.app, "slim.json": self.slim_app}
        if bake.target == "system":
            leave(targets["system"], NOBLE)
        if bake.target == "packages":
            leave(targets["report"], {name: json.dumps(content) for name, content in reports.items()} | self.contents)
            leave(targets.get("results", {}), {})
        return None, {"containerimage.digest": "sha256:1"}

    def run_all(self, services: Services, bake: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        calls = {target: dataclasses.replace(bake, target=target) for target in (bake.target, *bake.beside)}
        return None, {target: self.run(services, call)[1] for target, call in calls.items()}


def leave(target: Mapping[str, Any], entries: Mapping[str, archives.Content]) -> None:
    """Writes the archive that a target leaves."""
    place = target.get("output", [""])[0].partition("dest=")[2]
    if place:
        archives.write(Path(place), entries)


@pytest.fixture
def services(server: LocalRegistry, tmp_path: Path) -> Services:
    return Services(tmp_path / "rosml", server.address, ("buildx",), "rosml", "buildkitd", None, "", "", bases=())


@pytest.fixture
def robot(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Robot:
    robot = Robot(tmp_path / "Robot", services)
    robot.write("src/robot/package.xml", PACKAGE.format("robot"))
    robot.put()
    monkeypatch.setattr(buildx, "run_all", robot.run_all)
    monkeypatch.setattr(sources, "fetch", lambda *_, **__: [])
    return robot
