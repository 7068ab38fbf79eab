"""Restricted parts: to which registries they may go, and each command that pushes images."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, changed, parse
from hypothesis import given
from hypothesis import strategies as st

from fakes.rebasing import Place as Apps
from fakes.rebasing import moving
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.cli.images import call
from rosml.containerize import inputs as app_inputs
from rosml.containerize.base_image import base as app_base
from rosml.containerize.build import step_order as build
from rosml.images.bake import targets
from rosml.images.builds import part
from rosml.images.image_set import labels, restricted, selection
from rosml.images.image_set.model import ImageSet
from rosml.images.image_set.restricted import Declared
from rosml.images.join.joiner import Joiner
from rosml.images.matrix import registries
from rosml.images.publish import survey
from rosml.machine import buildx
from rosml.registry import oci, references
from rosml.registry.client import Registries
from rosml.registry.references import Reference
from tests.e2e import parts

HELD = changed("{name: torch, title: PyTorch", "{name: torch, distribution: restricted, title: PyTorch")
"""The small matrix, whose part torch is restricted."""

TORCH_LABEL = {labels.RESTRICTED: "torch"}


# ---- Which registry --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("host", "declared", "allowed"),
    [
        ("localhost:5000", Declared(), True),
        ("127.0.0.1:5000", Declared(), True),
        ("[::1]:5000", Declared(), True),
        ("127.0.0.1.example.com", Declared(), False),
        ("localhost.example.com", Declared(), False),
        ("10.0.0.1:5000", Declared(), False),
        ("registry.example.com", Declared(), False),
        ("registry.example.com", Declared(("registry.example.com",)), True),
        ("Registry.example.com:5000", Declared(("registry.example.com",)), True),
        ("registry.example.com:5000", Declared(("registry.example.com:5000",)), True),
        ("registry.example.com:5001", Declared(("registry.example.com:5000",)), False),
        ("other.registry.example.com", Declared(("registry.example.com",)), False),
        ("ghcr.io", Declared(("registry.example.com",)), False),
        ("ghcr.io", Declared((), ("ghcr.io/me/robots",)), True),
        ("ghcr.io", Declared((), ("ghcr.io/me/robot",)), False),
        ("quay.io", Declared((), ("ghcr.io/me/robots",)), False),
    ],
)
def test_where_it_may_go(host: str, declared: Declared, allowed: bool) -> None:
    if allowed:
        claim = restricted.require(["torch"], "robot:1", host, "me/robots/run", declared)
        assert bool(claim) == (host == "ghcr.io"), "a claim to have the rights is repeated"
        assert not claim or "goes to ghcr.io/me/robots: you declared that you have the rights" in claim
        return
    with pytest.raises(RosmlError, match=f"robot:1 has the restricted part torch, and {host} is ") as caught:
        restricted.require(["torch"], "robot:1", host, "me/robots/run", declared)
    assert caught.value.exit_code == 2
    public = host in ("ghcr.io", "quay.io")
    assert ("i_have_the_rights" in caught.value.remedy) == public, "of a public host nobody says that it is private"
    assert (restricted.VARIABLE in caught.value.remedy) != public


def test_what_is_free_goes_everywhere() -> None:
    assert restricted.require((), "robot:1", "ghcr.io", "me/robots", Declared()) == ""


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("private: [ghcr.io]", r"private\[0\]: ghcr.io is a public registry"),
        ("private: [index.docker.io:443]", "is a public registry"),
        ("private: [https://registry.example.com]", "the host of a registry"),
        ("i_have_the_rights: [ghcr.io]", "add the path in ghcr.io"),
    ],
)
def test_a_declaration_that_is_none(line: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        parse(changed("registry: localhost:5000\n", f"registry: localhost:5000\n{line}\n"))


@pytest.mark.parametrize(("value", "says"), [("ghcr.io", "a public registry"), ("a/b", "no host of a registry")])
def test_a_variable_that_is_none(small: ImageSet, value: str, says: str) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        Declared.of(small.matrix, {restricted.VARIABLE: value})
    assert caught.value.exit_code == 2


def test_a_variable_adds_to_the_matrix() -> None:
    text = changed("registry: localhost:5000\n", "registry: localhost:5000\nprivate: [one.example.com]\n")
    declared = Declared.of(parse(text).matrix, {restricted.VARIABLE: " two.example.com  Three.example.com:1 "})
    assert declared.private == ("one.example.com", "two.example.com", "three.example.com:1")


@given(st.text(min_size=1))
def test_anything_in_the_label_is_a_restriction(text: str) -> None:
    names = restricted.parts_of({labels.RESTRICTED: text})
    assert names
    assert all(len(name) <= 64 and name.isprintable() for name in names)


# ---- Labels ----------------------------------------------------------------------------------------------------------


def test_labels_of_a_join_are_those_of_a_build(real: ImageSet) -> None:
    """About licences; every image with parts has those of all of them."""
    text = (ROOT / "matrix.yaml").read_text().replace("    slot: 3\n", "    slot: 3\n    distribution: restricted\n", 1)
    assert [entry.name for entry in real.matrix.parts if entry.licence is None] == []
    assert labels.together(["MIT OR Apache-2.0", "", "MIT AND BSD-3-Clause", "MIT"], []) == {
        labels.LICENSES: "(MIT OR Apache-2.0) AND MIT AND BSD-3-Clause"
    }
    for image_set in (real, parse(text)):
        bake_targets = targets.of(image_set)

        def claims(target: str, bake_targets: Mapping[str, targets.Target] = bake_targets) -> dict[str, str]:
            texts = {name: bake_targets[target].labels.get(name) for name in (labels.LICENSES, labels.RESTRICTED)}
            return {name: str(text) for name, text in texts.items() if text}

        for image in image_set.images:
            if image.stack:
                below = [
                    claims(name) for name in (image.parent, *(image_set.part_by_name[x].target for x in image.parts))
                ]
                joined = labels.together(
                    [one.get(labels.LICENSES, "") for one in below],
                    [x for one in below for x in restricted.parts_of(one)],
                )
                assert joined == claims(image.target), image.target
                kinds = [image_set.part_by_name[name].kind for name in image.parts]
                assert (labels.RESTRICTED in joined) == bool(restricted.of(image_set.matrix, kinds))


# ---- The doors -------------------------------------------------------------------------------------------------------


@pytest.fixture
def apps(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Apps]:
    """A registry that is not on this machine, as far as the rule sees."""
    monkeypatch.setattr(registries, "is_here", lambda host: False)
    monkeypatch.delenv(restricted.VARIABLE, raising=False)
    with moving(tmp_path, monkeypatch) as place:
        yield place


def test_join(apps: Apps, monkeypatch: pytest.MonkeyPatch) -> None:
    host = apps.server.address
    ros = apps.base()
    put_parts = parts.stack(apps.registry, "me/part", ("cuda", "common"))
    torch = parts.part("torch")
    put_parts.append(replace(torch, labels={**torch.labels, **TORCH_LABEL}).put(apps.registry, "me/part", "torch"))

    def join() -> str:
        with Joiner(Registries(), say=apps.messages.append) as joiner:
            return joiner.join(ros, put_parts, f"{host}/me/mine:1").manifests["linux/amd64"]

    before = {*apps.server.manifests}
    with pytest.raises(
        RosmlError, match=f"me/mine:1 has the restricted part torch, and {host} is not declared"
    ) as caught:
        join()
    assert caught.value.exit_code == 2 and {*apps.server.manifests} == before
    with Joiner(Registries()) as joiner, pytest.raises(RosmlError, match="has the restricted part torch"):
        joiner.manifest(*_by_digest(apps, ros, put_parts), host, "me/mine")  # as a publishing run does
    assert {*apps.server.manifests} == before
    monkeypatch.setenv(restricted.VARIABLE, host)
    manifest = apps.registry.manifest("me/mine", join())
    assert manifest and apps.registry.config("me/mine", manifest).labels[labels.RESTRICTED] == "torch"


def _by_digest(apps: Apps, ros: str, part_names: Sequence[str]) -> tuple[Reference, list[Reference]]:
    """Images for one platform."""
    places = []
    for name in (ros, *part_names):
        place = references.parse(name)
        index = apps.registry.manifest(place.repository, place.reference)
        assert index
        places.append(place._replace(reference=index.members[0].digest))
    return places[0], places[1:]


def test_rebase(apps: Apps, monkeypatch: pytest.MonkeyPatch) -> None:
    app, held = apps.app(apps.base()), apps.base("held", labels=TORCH_LABEL)
    assert "me/robot:latest has the restricted part torch" in apps.refused(app, held)
    monkeypatch.setenv(restricted.VARIABLE, apps.server.address)
    assert apps.rebase(app, held).moved
    monkeypatch.delenv(restricted.VARIABLE)
    assert apps.rebase(app, apps.base("newer")).moved, "onto a base image without it"


def test_an_image_of_two_platforms_is_held_by_one(apps: Apps) -> None:
    reference = apps.base("held", platforms=("linux/amd64",))
    other = apps.base("other", platforms=("linux/arm64",), labels=TORCH_LABEL)
    members = [
        entry
        for name in (reference, other)
        if (manifest := apps.registry.manifest("rosml/ros", name.rpartition(":")[2]))
        for entry in manifest.content["manifests"]
    ]
    index = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": members}
    apps.registry.put_manifest("rosml/ros", "both", index, oci.INDEX)
    name = f"{apps.server.address}/rosml/ros:both"
    assert restricted.parts_of(app_base.find(name, apps.services, ("linux/amd64", "linux/arm64")).labels) == ("torch",)
    assert restricted.parts_of(app_base.find(name, apps.services, ("linux/amd64",)).labels) == ()


class BuilderCalled(Exception):
    """The builder was asked, so nothing was refused."""


@pytest.fixture
def builder(monkeypatch: pytest.MonkeyPatch) -> None:
    def run(*_: Any) -> None:
        raise BuilderCalled

    monkeypatch.setattr(buildx, "run", run)


@pytest.mark.usefixtures("builder")
@pytest.mark.parametrize("where", ["image", "cache", "latest of a slim image"])
def test_containerize(apps: Apps, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str) -> None:
    """Of what a base image has, the app has all; and stages in a cache stand on it."""
    folder = tmp_path / "robot"
    (folder / "src/robot").mkdir(parents=True)
    (folder / "src/robot/package.xml").write_text("<package><name>robot</name></package>")
    here, public = apps.server.address, "ghcr.io/me/robot"
    monkeypatch.setattr(registries, "is_here", lambda host: host == here)
    base = apps.base("held", labels=TORCH_LABEL, environment=("ROS_DISTRO=jazzy",))
    free = apps.base("free", environment=("ROS_DISTRO=jazzy",))
    values = {"base-image": base, "command": "x", "push": "true", "target": "run", "platform": "amd64"}
    values |= {"image-name": f"{here}/me/robot"}
    if where == "image":
        values["image-name"] = public
    elif where == "cache":
        values["cache"] = f"{public}/cache"
    else:
        values |= {"base-image": free, "enable-slim": "true", "slim-base-image": base}
        values |= {"slim-image-name": public, "enable-push-as-latest": "true"}
    monkeypatch.setattr(app_base, "require_kept", lambda *_: None)  # asks the registry
    app = build.new_call(folder, app_inputs.values(values, folder, {}), {}, apps.services, apps.messages.append)
    with pytest.raises(
        RosmlError, match=r"rosml/ros:held has the restricted part torch, and ghcr\.io is a public"
    ) as caught:
        build.build_images(app)
    assert caught.value.exit_code == 2
    text = ROOT / "matrix.yaml"
    matrix_of_set = tmp_path / "matrix.yaml"
    matrix_of_set.write_text(
        text.read_text().replace("\nversion: 1\n", f"\nversion: 1\ni_have_the_rights: [{public}]\n", 1)
    )
    monkeypatch.setattr(restricted, "MATRIX", matrix_of_set)
    with pytest.raises((BuilderCalled, RosmlError)) as caught_build:
        build.build_images(app)
    assert "restricted" not in str(caught_build.value)
    assert any("goes to ghcr.io/me/robot: you declared that you have the rights" in line for line in apps.messages)


@pytest.mark.usefixtures("builder")
def test_a_part(tmp_path: Path) -> None:
    image_set, lines = parse(HELD), list[str]()
    torch = part.by_name(image_set, "torch-cu1-py312")

    def push(prefix: str) -> None:
        part.PartBuilder(services(tmp_path), image_set, prefix, lines.append).bake(torch, ["linux/amd64"])

    with pytest.raises(
        RosmlError, match=r"torch-cu1-py312 has the restricted part torch, and registry\.example\.com is"
    ) as caught:
        push("registry.example.com/me")
    assert caught.value.exit_code == 2
    push("localhost:5000/me")
    assert lines[-1].startswith("part torch-cu1-py312 for linux/amd64, built on ")


@dataclass
class Surveyed(Exception):
    """What a run would ask the registry for."""

    request: Any


@pytest.fixture
def matrix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The small matrix, for runs that end before they ask a registry."""

    def ask(request: Any) -> None:
        raise Surveyed(request)

    (tmp_path / "matrix.yaml").write_text(HELD)
    services(tmp_path)
    monkeypatch.delenv(restricted.VARIABLE, raising=False)
    monkeypatch.setattr(call, "ROOT", tmp_path)
    monkeypatch.setattr(survey, "survey", ask)
    return tmp_path / "matrix.yaml"


def requested(matrix: Path, registry: str, *only: str, reading: bool = False) -> set[str]:
    """The images of a run."""
    with pytest.raises(Surveyed) as caught:
        call.Call(registry=registry, matrix=matrix, only=only).survey(reading)
    request = caught.value.request
    return {image.target for image in selection.select(request.image_set, request.only)}


def test_publish(matrix: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    every = {image.target for image in parse(HELD).images}
    free = {name for name in every if not {"torch", "ml"} & {*name.split("-")}}
    assert free and free < every
    assert requested(matrix, "localhost:5000/me") == every
    assert not capsys.readouterr().err
    assert requested(matrix, "ghcr.io/me") == free
    held = len(every) - len(free)
    assert (
        f"left out, because their restricted parts may not go to ghcr.io/me: {held} images" in capsys.readouterr().err
    )
    assert requested(matrix, "ghcr.io/me", "alpha-core", "alpha-core-cuda-cu1") == {"alpha-core", "alpha-core-cuda-cu1"}
    assert requested(matrix, "ghcr.io/me", "alpha-core-*", reading=True) > {"alpha-core-torch-cu1"}
    for only in ("alpha-core-torch-cu1", "*-ml-*", "alpha-*"):
        with pytest.raises(RosmlError, match=r"the restricted part torch, and ghcr\.io is a public registry") as caught:
            call.Call(registry="ghcr.io/me", matrix=matrix, only=(only,)).survey()
        assert caught.value.exit_code == 2
    monkeypatch.setenv(restricted.VARIABLE, "registry.example.com")
    assert requested(matrix, "registry.example.com/me") == every
    line = "registry: localhost:5000\n"
    matrix.write_text(HELD.replace(line, f"{line}i_have_the_rights: [ghcr.io/me]\n"))
    assert requested(matrix, "ghcr.io/me") == every
    assert "goes to ghcr.io/me: you declared that you have the rights" in capsys.readouterr().err
