"""The texts of licences, out of an image's layers. Each layer is downloaded for them, so a dossier has them only if somebody asks."""

from __future__ import annotations

import tarfile
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rosml.base import archives, units
from rosml.base.errors import RosmlError
from rosml.images.join.layers import Source
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor

LARGEST = 1 << 20
"""The most bytes of a text. The largest of Debian's has some 600 kB."""

TOGETHER = 200_000_000
"""The most bytes of all texts of an image."""

UNPACKED, FILE = 64 << 30, 4 << 30
"""More than any layer has, unpacked, and more than any file in it: tarfile takes a second to pass over 8 GiB that are not there."""


def read(registry: Registry, image: Source, places: set[str], say: Callable[[str], None]) -> dict[str, str]:
    """The texts at these paths of an image, by path; a link has none. A layer's text counts more than that of a layer below."""
    texts = dict[str, str]()
    for number, layer in enumerate(image.manifest.layers):
        say(f"read layer {number + 1} of {len(image.manifest.layers)}, {units.size(layer.size)}")
        texts |= of_layer(registry, image.repository, layer, places)
        if sum(map(len, texts.values())) > TOGETHER:
            raise RosmlError(f"the texts of licences have more than {units.size(TOGETHER)}")
    return texts


def of_layer(registry: Registry, repository: str, layer: Descriptor, places: set[str]) -> Mapping[str, str]:
    """The texts of one layer."""

    def read(blocks: Iterator[bytes]) -> dict[str, str]:
        try:
            with (
                archives.stream(blocks) as stream,
                tarfile.open(fileobj=stream, mode="r|", tarinfo=archives.Entry) as archive,
            ):
                texts = dict(_texts(archive, places))
            for _ in blocks:  # at the end, the digest is checked
                pass
            return texts
        except (tarfile.TarError, EOFError, OSError, OverflowError, ValueError) as error:
            raise RosmlError(f"the layer {layer.digest} cannot be read: {error}", "push the image again") from None

    return registry.read_blob(repository, layer.digest, read, layer.size)


def _texts(archive: Any, places: set[str]) -> Iterator[tuple[str, str]]:
    room = TOGETHER
    while entry := archive.next():
        archive.members.clear()  # tarfile keeps all members, a hundred thousand in some layers
        if archive.offset > UNPACKED or entry.size > FILE:
            raise ValueError(f"it has more than {units.size(UNPACKED)}, or a file of more than {units.size(FILE)}")
        path = entry.name.removeprefix("./").lstrip("/")
        if path not in places or not entry.isreg() or entry.size > min(LARGEST, room):
            continue
        room -= entry.size
        yield path, archive.extractfile(entry).read().decode(errors="replace")


def listing(texts: Mapping[str, str]) -> str:
    """One file with all texts. Those that are the same are there once, below all their paths."""
    by_text = dict[str, list[str]]()
    for path in sorted(texts):
        by_text.setdefault(texts[path].strip(), []).append(path)
    rule = "=" * 100
    return "\n\n".join("\n".join([rule, *paths, rule, "", text]) for text, paths in by_text.items()) + "\n"
