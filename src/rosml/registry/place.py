"""Where images are: a registry, and the path before the names of its repositories."""

from __future__ import annotations

from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.registry import oci, references
from rosml.registry.client import Registry

REPOSITORY_TYPE = "application/vnd.rosml.repository.v1"
"""The type of the artifact that creates a repository. It has no tag."""


@dataclass(frozen=True)
class Place:
    """A registry, and the path before the names of its repositories, such as `me/rosml`; it may be empty."""

    client: Registry
    prefix: str = ""

    @classmethod
    def at(cls, text: str, ca_bundle: str = "") -> Place:
        """The place of a text such as `ghcr.io/me/rosml`. This sends no request."""
        host, _, prefix = text.rstrip("/").partition("/")
        if not references.is_place(host, prefix):
            scheme, mark, rest = text.partition("://")
            remedy = "name a registry and a path in it, such as ghcr.io/me/rosml"
            remedy = f"leave out {scheme}{mark}, and write {rest}" if mark and rest else remedy
            raise RosmlError(f"{text!r} is no place for images", remedy, exit_code=2)
        return cls(Registry(host, ca_bundle=ca_bundle), prefix)

    def path(self, repository: str) -> str:
        return f"{self.prefix}/{repository}" if self.prefix else repository

    def reference(self, repository: str, digest: str = "") -> str:
        return f"{self.client.host}/{self.path(repository)}" + (f"@{digest}" if digest else "")

    def __str__(self) -> str:
        return f"{self.client.host}/{self.prefix}".rstrip("/")

    def make(self, repository: str) -> bool:
        """Creates a repository by a push of a small artifact, and returns whether the artifact was missing.

        Registries such as ghcr.io create a repository at its first push, and refuse other pushes into it meanwhile.
        """
        path = self.path(repository)
        artifact = oci.encoded(oci.artifact(REPOSITORY_TYPE, oci.EMPTY_BLOB, oci.EMPTY))
        if self.client.head(path, oci.digest_of(artifact)):
            return False
        self.client.put_blob(path, oci.EMPTY_BLOB)
        self.client.put_manifest(path, "", artifact)
        return True
