"""`rosml image --env`: what does not fit is said before anything is built; the image with the environment has a tag of its own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.joins import Place, joining
from rosml import MATRIX
from rosml.base.errors import RosmlError
from rosml.cli.images import env
from rosml.images.environments import add, build, image
from rosml.images.environments.build import BuiltEnvironment
from rosml.images.environments.declaration import Declaration
from rosml.images.environments.lock import Lock
from rosml.images.image_set import labels, load
from rosml.images.join.joiner import Joiner
from rosml.machine.services import Services
from tests.e2e.parts import environment

TARGET = "ros1-bookworm-core-torch-cu128"
TORCH = {"torch": "2.10.0"}


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with joining(tmp_path, monkeypatch) as place:
        yield place


@pytest.mark.parametrize(
    ("python", "releases", "problem"),
    [
        ("3.11", TORCH, ""),
        ("3.12", TORCH, "has no lock for Python 3.11"),
        ("3.11", {"torch": "2.9.0"}, f"takes torch 2.9.0 of its image, and {TARGET} has torch 2.10.0"),
        ("3.11", {"tensorflow": "2.20.0"}, f"and {TARGET} has no tensorflow"),
    ],
)
def test_only_an_environment_for_the_image(python: str, releases: dict[str, str], problem: str, tmp_path: Path) -> None:
    target = load.load_one(MATRIX, TARGET).by_target[TARGET]
    lock = Lock("policy", python, "amd64", 36, releases, releases, ())
    add.write(tmp_path / "policy", [lock], Declaration(requirements=["a"]))
    if not problem:
        assert image.read(target, ["policy"], tmp_path, ["amd64"]) == {"policy": [lock]}
        return
    with pytest.raises(RosmlError, match=problem) as caught:
        image.read(target, ["policy"], tmp_path, ["amd64"])
    assert "rosml env add policy --image " in caught.value.remedy and caught.value.exit_code == 2


def test_the_image_with_it_has_a_tag_of_its_own(place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    prefixes = list[str]()

    def publish(*arguments: object) -> BuiltEnvironment:
        prefixes.append(str(arguments[3]))
        policy = environment().put(place.registry, "me/env", "policy-py311")
        return BuiltEnvironment("policy", policy, "", {}, 0.0)

    monkeypatch.setattr(build, "publish", publish)
    services, base = Services.load(tmp_path, required=False), place.ros()
    report = image.join(services, load.load_one(MATRIX, TARGET), base, {"policy": []}, place.lines.append)
    assert report.reference == f"{base}-env-policy" and prefixes == [f"{place.server.address}/me"]
    manifest = place.manifest("me/ros", report.manifests["linux/amd64"])
    assert place.registry.config("me/ros", manifest).labels[labels.ENVIRONMENTS] == "policy"


def test_the_tags_of_several(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Other environments have another tag, in whatever order they are named; one that is too long is refused before a build."""
    target, tags = load.load_one(MATRIX, TARGET).by_target[TARGET], list[str]()
    monkeypatch.setattr(Joiner, "join", lambda *it: tags.append(it[3].rpartition("-env-")[2]))
    monkeypatch.setattr(build, "publish", lambda *_: BuiltEnvironment("", "", "", {}, 0.0))
    for names in (["a-b", "c"], ["c", "a-b"], ["a", "b-c"]):
        every = {name: list[Lock]() for name in names}
        image.join(Services.load(tmp_path, required=False), load.load_one(MATRIX, TARGET), "h/r:t", every, print)
    assert tags == ["a-b_c", "a-b_c", "a_b-c"]
    long = [letter * 60 for letter in "ab"]
    for name in long:
        add.write(tmp_path / name, [Lock(name, "3.11", "amd64", 36, TORCH, TORCH, ())])
    with pytest.raises(RosmlError, match="a tag has at most 128 characters"):
        image.read(target, long, tmp_path, ["amd64"])


@pytest.mark.parametrize(
    ("options", "prefix"),
    [
        ([], "localhost:1/rosml"),
        (["--namespace", "team"], "localhost:1/team"),
        (["--registry", "ghcr.io/Me/rosml"], "ghcr.io/me/rosml"),
    ],
)
def test_where_it_is_built_to(options: list[str], prefix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    services = replace(Services.load(tmp_path, required=False), registry="localhost:1")
    monkeypatch.setattr(Services, "load", lambda *_, **__: services)
    for check in ("require_registry", "require_builder"):
        monkeypatch.setattr(Services, check, lambda *_: None)
    prefixes = list[object]()

    def publish(*arguments: object) -> BuiltEnvironment:
        prefixes.append(arguments[3])
        return BuiltEnvironment("policy", "", "", {}, 0.0)

    monkeypatch.setattr(build, "publish", publish)
    add.write(tmp_path / "policy", [Lock("policy", "3.11", "amd64", 36, {}, {}, ())])
    env.main.main(["build", "policy", "--folder", str(tmp_path), *options], standalone_mode=False)
    assert prefixes == [prefix]
