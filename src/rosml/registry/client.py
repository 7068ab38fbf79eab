"""A client of container registries: the part of the OCI distribution API that rosml needs."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Self

from rosml.registry import credentials as docker
from rosml.registry.blobs import BLOB_BYTES, CONFIG_BYTES
from rosml.registry.credentials import Credentials
from rosml.registry.manifests import Undeletable
from rosml.registry.referrers import Referrers
from rosml.registry.transport import Transport

__all__ = ["BLOB_BYTES", "CONFIG_BYTES", "Registries", "Registry", "Undeletable"]


class Registry(Referrers):
    """One registry. Safe to share among threads; close it, or use it in a `with`.

    If the registry does not answer, refuses, or breaks the specification, each method raises a RosmlError with a remedy.
    """

    def __init__(
        self,
        host: str,
        *,
        plain: bool
        | None = None,  # whether to speak http; only to this machine without certificates in certs.d if None
        ca_bundle: str = "",  # a file of certificates to trust; that of SSL_CERT_FILE, or the usual one, if empty
        credentials: Callable[[str], Credentials | None] = docker.from_docker,  # called once, when the registry asks
    ) -> None:
        super().__init__(Transport(host, plain, ca_bundle, credentials))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        self.transport.client.close()

    @property
    def uploaded(self) -> int:
        """Bytes of bodies sent so far, including failed attempts."""
        return self.transport.uploaded

    @property
    def sent_by_this_thread(self) -> int:
        """As `uploaded`, of this thread alone."""
        return self.transport.sent_by_this_thread


class Registries:
    """The clients of registries by host, each made once. Safe to share among threads; use it in a `with`."""

    def __init__(self, ca_bundle: str = "") -> None:
        self._ca_bundle = ca_bundle
        self._clients: dict[str, Registry] = {}
        self._lock = threading.Lock()

    def __call__(self, host: str) -> Registry:
        with self._lock:
            if host not in self._clients:
                self._clients[host] = Registry(host, ca_bundle=self._ca_bundle)
            return self._clients[host]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for client in self._clients.values():
            client.close()
