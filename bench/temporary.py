"""What is put into a registry for a measurement, and removed again."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Any

import httpx

from rosml.base.errors import RosmlError
from rosml.registry import oci, references
from rosml.registry.client import Registry

REMOVERS = 16
"""How many manifests are removed at a time."""


class Temporary(Registry):
    """A client that removes at the end of its `with` every tag and manifest that it put, whatever ended it.

    Only for what nobody else puts: a manifest that was there before goes as well. Blobs stay until somebody collects them.
    """

    def __init__(self, host: str, *, ca_bundle: str = "") -> None:
        super().__init__(host, ca_bundle=ca_bundle)
        self._tags: set[tuple[str, str]] = set()
        self._manifests: set[tuple[str, str]] = set()

    def __enter__(self) -> Temporary:
        return self

    def __exit__(self, *_: object) -> None:
        for found in (self._tags, self._manifests):  # tags first: with none left a manifest goes sooner
            with ThreadPoolExecutor(REMOVERS) as pool:
                list(pool.map(self._remove, found))
        super().__exit__()

    def _remove(self, what: tuple[str, str]) -> None:
        with suppress(RosmlError):  # a registry that deletes nothing has told so before, or tells it to `prune`
            self.delete(*what)

    def send_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str
    ) -> tuple[str, httpx.Headers]:
        data = content if isinstance(content, bytes) else oci.encoded(content)
        self._manifests.add((repository, oci.digest_of(data)))  # before it is sent: nobody knows where that ends
        if reference and not references.is_digest(reference):
            self._tags.add((repository, reference))
        return super().send_manifest(repository, reference, data, media_type)
