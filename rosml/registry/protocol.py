"""What records need of a registry's client: `oci.Registry` is one, and what stands in for it has the same methods.

The records, provenance and SBOMs, and whatever looks through a registry, name this instead of that class: tests hand them one
that is in memory. Builds and copies, which stream blobs and mount them, need `oci.Registry` itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

from rosml.registry.oci import Manifest


class Client(Protocol):
    """A client of one registry, safe to share among threads.

    A repository is a path without the registry; a reference is a tag or a digest. Every method raises RosmlError where the
    registry does not answer or refuses, unless it says otherwise.
    """

    def manifest(self, repository: str, reference: str, /) -> Manifest | None:
        """What is behind a reference; None if there is nothing."""

    def head(self, repository: str, reference: str, /) -> str:
        """The digest behind a reference; empty if there is nothing."""

    def tags(self, repository: str, /) -> list[str]:
        """All tags of a repository; none if there is no such repository."""

    def blob(self, repository: str, digest: str, /) -> bytes:
        """A blob; also an error where there is none."""

    def referrers(self, repository: str, digest: str, artifact_type: str = "", /) -> list[dict[str, Any]]:
        """Descriptors of what is attached to a manifest: of one type of artifacts, or of all."""

    def put_blob(self, repository: str, data: bytes, /) -> str:
        """Puts a blob, unless it is there. Gives its digest."""

    def put_manifest(self, repository: str, reference: str, content: Mapping[str, Any], media_type: str, /) -> str:
        """Puts a manifest or index under a tag, or by its digest alone if the reference is that or empty. Gives its digest."""

    def tag(self, repository: str, digest: str, name: str, /) -> None:
        """Moves a tag to a manifest or index that is in the repository; also an error where it is not."""

    def attach(
        self,
        repository: str,
        subject: Mapping[str, Any],
        artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str],
        /,
    ) -> str:
        """Attaches an artifact, of one layer with a media type, to the manifest that a descriptor is of. Gives its digest."""

    def detach(self, repository: str, subject: str, digest: str, /) -> None:
        """Removes an artifact that is attached to a manifest; both by digest."""

    def delete(self, repository: str, reference: str, /) -> None:
        """Removes a manifest with its tags; or a tag, where the registry can. Nothing there is no error; `oci.Undeletable` where
        the registry deletes no manifest at all."""

    def discard(self, repository: str, digest: str, /) -> bool:
        """Removes a manifest that nothing leads to any more, and says whether it is gone: never an error."""

    def forget(self, repository: str, subject: str, /) -> None:
        """Removes what a registry without the referrers API keeps of a manifest that is gone."""
