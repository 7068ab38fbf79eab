"""What the ledger said of images, from the images themselves: for a registry whose ledger was lost.

Every promoted image has its entry attached. Where the ledger has none for an image whose main tag is there, the entries
of what that tag leads to take its place; records of where tags were, and what was never promoted, are gone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from rosml.images.image_set import Image, Payload, repository_of, tags_of
from rosml.records import ledger
from rosml.records.ledger import INDEX, Entry, Ledger

Found = dict[tuple[str, str], tuple[Entry, dict[str, str]]]
"""Entries, with their inputs by name, by target and architecture."""


def entries(book: Ledger, things: Iterable[Image | Payload], known: Mapping[tuple[str, str], Entry]) -> Found:
    """Entries that the ledger lacks, from what is attached to the images that main tags lead to.

    Args:
        book: the ledger. things: images and payloads that are asked for. known: the entries that it has.

    Raises:
        RosmlError: the registry does not answer.
    """
    lacking = [
        thing for thing in things if any((thing.target, name) not in known for name in (*thing.architectures, INDEX))
    ]
    with ThreadPoolExecutor(ledger.READERS) as pool:
        found: Found = {}
        for some in pool.map(lambda thing: _of(book, thing), lacking):
            found |= {key: item for key, item in some.items() if key not in known}
        return found


def _of(book: Ledger, thing: Image | Payload) -> Found:
    repository, main = repository_of(thing), tags_of(thing)[0]
    index: Any = book.registry.manifest(book.path(repository), main)
    members = (index.content.get("manifests") or []) if index else []
    found: Found = {}
    for digest in [*(str(item.get("digest", "")) for item in members), *([index.digest] if members else [])]:
        if digest and (item := book.attached(repository, digest)):
            entry = item[0]
            if entry.target == thing.target and (entry.architecture == INDEX) == (digest == index.digest):
                found[entry.target, entry.architecture] = item
    return found
