"""Checks content against its digest."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from typing import Any

from rosml.base.errors import RosmlError
from rosml.registry.references import is_digest

_DAMAGED = "it is damaged: push it again"


def require_digest(digest: str) -> None:
    if not is_digest(digest):
        raise RosmlError(f"{digest[:200]!r} is no digest", "name one as sha256: and 64 digits, or a tag")


def verified(data: bytes, digest: str) -> bytes:
    return b"".join(verified_blocks([data], digest))


def verified_blocks(blocks: Iterable[bytes], digest: str, size: int | None = None) -> Iterator[bytes]:
    """Gives the pieces of a blob. After the last one, it checks the digest. At most `size` bytes may come."""
    require_digest(digest)
    state: Any = hashlib.new(digest.partition(":")[0])
    received = 0
    for block in blocks:
        received += len(block)
        if size is not None and received > size:
            text = f"the registry's content for {digest} has more than the {size} bytes that its manifest says"
            raise RosmlError(text, _DAMAGED)
        state.update(block)
        yield block
    if state.hexdigest() != digest.partition(":")[2]:
        raise RosmlError(f"the registry's content for {digest} has another digest", _DAMAGED)
