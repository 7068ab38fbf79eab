"""What `make bench` measures in a registry: joined tags, and a run over everything that finds nothing to do; and that it
leaves nothing behind. On a registry in this process, with images of some bytes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from registry_stand_in import StandIn, standing_in
from stubs import services

from bench import idle_run, many_tags
from bench.here import Here
from bench.second_image import NAMESPACE, Comparison, Side
from rosml.images.builds import base_images, package_state
from rosml.images.builds.maker import Checked, Made, Maker
from rosml.images.image_set.model import Image, ImageSet, Part, repository_of
from rosml.registry.client import Registry
from rosml.registry.repositories import repository_path
from tests.e2e import parts

TARGET = "alpha-core-torch-cu1"
DAY = "2026-11-22T03:00:00Z"
USUAL = Comparison(
    target=TARGET,
    ours=Side(),
    usual=Side(build_and_push_seconds=60.0, registry_new_bytes=1_000),
    versions={},
    packages=1,
    assembling_seconds=0.0,
)


SBOM = f"sha256:{'5' * 64}"


@dataclass
class Builder(Maker):
    """Puts images of some bytes where a builder would push real ones."""

    registry: Registry

    def build_part(self, part: Part, architecture: str) -> Made:
        tiny = parts.part(part.kind, part.stack, "3.12", {"cuda": "12.8.90", "torch": "2.10.0"})
        return Made(tiny.put_manifest(self.registry, repository_path(NAMESPACE, repository_of(part)))[0], sbom=SBOM)

    def build_image(self, image: Image, architecture: str, below: Mapping[str, str], moment: str) -> Made:
        tiny = parts.ros(image.distribution, image.component, "3.12")
        return Made(
            tiny.put_manifest(self.registry, repository_path(NAMESPACE, repository_of(image)))[0], below, sbom=SBOM
        )

    def join(self, image: Image, architecture: str, below: Mapping[str, str]) -> str:
        raise AssertionError("the bench joins images by itself")

    def test(
        self, image: Image, architecture: str, digest: str, parts: Mapping[str, str], names: tuple[str, ...]
    ) -> Checked:
        raise AssertionError("the bench tests no image")


def measured(here: Here) -> many_tags.Grown:
    """What `make bench` measures, with few tags."""
    maker = Builder(Registry(here.services.registry))
    return many_tags.measure(here, TARGET, USUAL, (2, 3), maker)


@pytest.fixture
def registry() -> Iterator[StandIn]:
    with standing_in() as found:
        yield found


@pytest.fixture
def here(registry: StandIn, image_set: ImageSet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Here:
    monkeypatch.setattr(package_state, "state", lambda *_: "monday")
    monkeypatch.setattr(package_state, "lacking", lambda *_: [])
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    found = services(tmp_path / "project", registry.address)
    return Here(found, image_set, lambda _: None, NAMESPACE, "amd64")


def left(registry: StandIn, *words: str) -> Mapping[str, object]:
    """What manifests and tags are in repositories whose names hold some words."""
    manifests = [key for key in registry.manifests if any(word in key[0] for word in words)]
    tags = {name: tags for name, tags in registry.tags.items() if tags and any(word in name for word in words)}
    return {"manifests": manifests, "tags": tags} if manifests or tags else {}


def test_tags_are_joined_counted_and_removed(here: Here, registry: StandIn) -> None:
    found = measured(here)
    assert [row.tags for row in found.rows] == [2, 3]
    for row in found.rows:
        assert row.seconds > 0 and 500 < row.uploaded / row.tags < 10_000
        assert (row.usual_seconds, row.usual_bytes) == (60.0 * row.tags, 1_000 * row.tags)
    assert found.rows[1].uploaded > found.rows[0].uploaded
    assert registry.count(r"^PUT /v2/bench/growth-\w+/manifests/\d+$") == 5
    assert left(registry, "growth-", "night-") == {}


# ---- A second run ----------------------------------------------------------------------------------------------------


def test_a_second_run_finds_nothing_to_do(here: Here, image_set: ImageSet, registry: StandIn) -> None:
    found = idle_run.measure(here.services, image_set, "bench/night", DAY, lambda _: None)
    things: list[Image | Part] = [*image_set.images, *image_set.parts]
    architectures = [name for thing in things for name in thing.architectures]
    assert found.items == len(architectures)
    assert (found.uploaded, found.steps) == (0, 0) and found.seconds > 0
    asked = [line for line in registry.requests if "/manifests/" in line]
    written = max(number for number, line in enumerate(asked) if line.startswith("PUT"))
    after = asked[written + 1 :]
    for image in image_set.images:  # everything was there, and was asked for
        for tag in image.tags:
            repository, _, name = tag.partition(":")
            assert f"HEAD /v2/bench/night/{repository}/manifests/{name}" in after
    assert left(registry, "night") == {}
