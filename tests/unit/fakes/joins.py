"""A registry in this process, and joins of tiny images in it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.http_registry import LocalRegistry, local_registry
from rosml.base.errors import RosmlError
from rosml.images.image_set import labels
from rosml.images.join.joiner import Joiner, JoinReport
from rosml.registry import references, retries
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest
from tests.e2e import parts
from tests.e2e.parts import Tiny, ros

AMD64 = "linux/amd64"
BOTH = (AMD64, "linux/arm64")
TORCH: tuple[str, ...] = ("cuda", "common", "torch")
TENSORFLOW: tuple[str, ...] = ("common", "tensorflow-cc", "tensorflow")
GRAPH: tuple[str, ...] = ("graph-cc", "graph")


class Place:
    """A registry, and who joins in it."""

    def __init__(self, server: LocalRegistry) -> None:
        self.server, self.lines = server, list[str]()
        self.registry = Registry(server.address)
        self.clients: dict[str, Registry] = {server.address: self.registry}

    def ros(self, tag: str = "ros1-bookworm-core", platforms: Sequence[str] = BOTH[:1], **facts: Any) -> str:
        return ros(**facts).put(self.registry, "me/ros", tag, platforms)

    def labelled_ros(self, **changes: str) -> str:
        """A ROS image with other labels."""
        image = ros()
        more = {f"io.rosml.{name}": text for name, text in changes.items() if name != "title"}
        title = {labels.TITLE: changes["title"]} if "title" in changes else {}
        return replace(image, labels={**image.labels, **title, **more}).put(self.registry, "me/ros", "latest")

    def stack(self, kinds: Sequence[str] = TORCH, name: str = "cu128", **facts: Any) -> list[str]:
        return parts.stack(self.registry, "me/part", kinds, name, **facts)

    def put(self, image: Tiny, tag: str, platforms: Sequence[str] = BOTH[:1]) -> str:
        return image.put(self.registry, "me/part", tag, platforms)

    def join(self, *images: str, tag: str = "mine", allow: bool = False, **options: Any) -> JoinReport:
        target = f"{self.server.address}/{options.pop('repository', 'me/mine')}:{tag}"
        with Joiner(self.clients.__getitem__, allow_unlisted=allow, say=self.lines.append) as joiner:
            local = f"{self.server.address}/local"
            return joiner.join(images[0], images[1:], target, options.pop("platforms", ()), local)

    def manifest(self, repository: str, reference: str) -> Manifest:
        manifest = self.registry.manifest(repository, reference)
        assert manifest
        return manifest

    def image(self, report: JoinReport, platform: str = AMD64) -> tuple[dict[str, Any], dict[str, Any]]:
        """Manifest and config of an image of `me/mine`."""
        content = self.manifest("me/mine", report.manifests[platform]).content
        return content, self.registry.json_blob("me/mine", content["config"]["digest"])

    def labels(self, report: JoinReport) -> dict[str, str]:
        config = self.image(report)[1]["config"]
        return {name: str(text) for name, text in config["Labels"].items()}

    def layers(self, *images: str) -> list[str]:
        """Layers of images for one platform, through their indexes."""
        places = [references.parse(image) for image in images]
        members = [(item.repository, self.manifest(item.repository, item.reference).members[0]) for item in places]
        return [layer.digest for path, member in members for layer in self.manifest(path, member.digest).layers]

    def refused(self, *images: str, **options: Any) -> RosmlError:
        """The error of a join; nothing was pushed, and no tag was made."""
        with pytest.raises(RosmlError) as caught:
            self.join(*images, **options)
        assert self.registry.tags("me/mine") == []
        assert not [name for repository, name in self.server.manifests if repository == "me/mine"]
        assert "\n" not in caught.value.message and caught.value.remedy
        return caught.value


@contextlib.contextmanager
def joining(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(folder / "docker"))
    with local_registry() as server:
        place = Place(server)
        yield place
        for registry in place.clients.values():
            registry.close()
