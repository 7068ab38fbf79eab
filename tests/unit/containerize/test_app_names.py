"""The names of an app's images, and the places to which they go."""

from __future__ import annotations

import dataclasses
import shutil
from pathlib import Path

import pytest

from fakes.apps import services
from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.cli.containerize import containerize
from rosml.containerize import inputs as app_inputs
from rosml.containerize.names import Names
from rosml.machine.services import Services

__all__ = ["services"]

NAMES = ["robot", "me/robot", "me/a.b_c__d---e/f", "ghcr.io/me/robot", "localhost/robot", "127.0.0.1:5000/me/robot"]
OTHERS = [".", "..", "a/../b", "a//b", "/a", "a/", "-a", "a-", "a..b", "a___b", "a._b", "a:5000", "my robot"]


@pytest.fixture
def docker(services: Services) -> Services:
    """A user's Docker, without a registry."""
    return dataclasses.replace(services, registry="", builder_kind="user")


def names(services: Services, **inputs: str) -> Names:
    values = app_inputs.values({name.replace("_", "-"): value for name, value in inputs.items()}, services.state, {})
    return Names(values, "robot", services)


@pytest.mark.parametrize("name", NAMES)
def test_names_are_those_that_registries_take(name: str, docker: Services) -> None:
    assert names(docker, image_name=name).app == name


@pytest.mark.parametrize("name", OTHERS)
def test_other_names_are_refused(name: str, docker: Services) -> None:
    for inputs in ({"image_name": name}, {"image_name": "robot", "dev_image_name": name}):
        with pytest.raises(RosmlError, match="is no name of an image") as caught:
            names(docker, **inputs)
        assert caught.value.exit_code == 2


@pytest.mark.parametrize(("version", "raw"), [("20.10.24+dfsg1", True), ("23.0.1", False), ("", False)])
def test_an_old_docker_gets_layers_that_it_can_read(
    version: str, raw: bool, docker: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    executable(tmp_path / "docker", f"echo {version}")
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    app = names(docker)
    assert app.loads and ("compression=uncompressed" in app.loading) is raw


def test_images_go_to_docker_if_there_is_one(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: f"/usr/bin/{name}")
    user = dataclasses.replace(services, builder_kind="user")
    name = "ghcr.io/me/robot"
    app = names(user, image_name=name)
    assert app.loads and app.reference("run") == f"{name}:latest"
    with pytest.raises(RosmlError, match="Docker holds images of one platform"):
        names(user, image_name=name, platform="amd64,arm64")
    with pytest.raises(RosmlError, match="robot names no registry"):
        names(dataclasses.replace(user, registry=""), image_name="robot", push="true")
    values = app_inputs.values({"image-name": "robot"}, services.state, {})
    assert Names(values, "robot", user, for_podman=True).reference("run").startswith(services.registry)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert names(user, image_name="robot").reference("run").startswith(services.registry)


def test_it_says_where_images_are_that_nobody_pushed() -> None:
    lines = [*containerize.where("127.0.0.1:5000", ["127.0.0.1:5000/robot:1", "127.0.0.1:5000/robot:1-dev"])]
    assert "in the local registry" in lines[0] and " save 127.0.0.1:5000/robot:1 -o " in lines[1]
    for registry, images in (("127.0.0.1:5000", ["robot:1"]), ("", ["robot:1"]), ("127.0.0.1:5000", [])):
        assert not [*containerize.where(registry, images)]
