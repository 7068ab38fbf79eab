"""Where missing layers of an archive come from: another archive, or a registry. `engine.py` has a third kind."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Protocol

from rosml.delivery.archive import Archive, Send, Write
from rosml.delivery.image import Layer
from rosml.registry.client import Registry


@dataclass(frozen=True)
class LayerBlob:
    """A layer as a source has it: `digest` is the layer's digest, or its diff ID if it is not compressed. `size` is in bytes."""

    layer: Layer
    digest: str
    size: int
    send: Send


class Source(Protocol):
    """Where missing layers come from."""

    @property
    def name(self) -> str:
        """For messages."""

    def has(self, layer: Layer) -> bool:
        """Whether it has a layer, compressed or not."""

    def take(self, layers: Sequence[Layer]) -> Iterable[LayerBlob]:
        """Layers that it has. Each must be sent before the next is asked for."""


def send_blob(file: Archive, digest: str, write: Write) -> None:
    """A `Send` of a blob of an archive."""
    write(file.blocks(digest))


@dataclass(frozen=True)
class InArchive:
    """Layers of another archive."""

    file: Archive

    @property
    def name(self) -> str:
        return self.file.name

    def has(self, layer: Layer) -> bool:
        return self._digest(layer) != ""

    def take(self, layers: Sequence[Layer]) -> Iterable[LayerBlob]:
        for layer in layers:
            digest = self._digest(layer)
            size = self.file.size(digest)
            assert size is not None
            yield LayerBlob(layer, digest, size, partial(send_blob, self.file, digest))

    def _digest(self, layer: Layer) -> str:
        return next((name for name in (layer.digest, layer.diff_id) if self.file.size(name) is not None), "")


@dataclass(frozen=True)
class InRegistry:
    """Layers of a repository."""

    registry: Registry
    repository: str

    @property
    def name(self) -> str:
        return f"{self.registry.host}/{self.repository}"

    def has(self, layer: Layer) -> bool:
        return self.registry.has_blob(self.repository, layer.digest)

    def take(self, layers: Sequence[Layer]) -> Iterable[LayerBlob]:
        for layer in layers:
            yield LayerBlob(layer, layer.digest, layer.size, partial(self._send, layer))

    def _send(self, layer: Layer, write: Write) -> None:
        self.registry.read_blob(self.repository, layer.digest, write, layer.size)
