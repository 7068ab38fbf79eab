"""Where in a registry images go: its address, the path before the names of repositories, and paths below it."""

from __future__ import annotations

from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.registry import oci, references
from rosml.registry.client import Registry


def repository_path(prefix: str, repository: str) -> str:
    """Path of a repository in a registry, below a prefix such as `me/rosml`; that may be empty."""
    return f"{prefix}/{repository}" if prefix else repository


@dataclass(frozen=True)
class Destination:
    """Where images go: the registry's address, and the path of its repositories."""

    host: str
    prefix: str


def destination(text: str) -> Destination:
    """The place that a text such as `ghcr.io/me/rosml` names.

    Raises:
        RosmlError: it names none (exit code 2).
    """
    host, _, prefix = text.rstrip("/").partition("/")
    if not references.is_place(host, prefix):
        text = f"{text!r} is no place for images"
        raise RosmlError(text, "name a registry and a path in it, such as ghcr.io/me/rosml", exit_code=2)
    return Destination(host, prefix)


MADE = "application/vnd.rosml.repository.v1"
"""The type of the artifact by which a repository is made. It has no tag."""


def make(registry: Registry, repository: str) -> bool:
    """Has a registry make a repository, by an artifact of some bytes, if it did not do so before.

    Registries such as ghcr.io make a repository when somebody pushes into it first, and refuse others who push there meanwhile.

    Returns:
        Whether it was made now.

    Raises:
        RosmlError: the registry does not answer or refuses.
    """
    artifact = oci.encoded(oci.artifact(MADE, oci.EMPTY_BLOB, oci.EMPTY))
    if registry.head(repository, oci.digest_of(artifact)):
        return False
    registry.put_blob(repository, oci.EMPTY_BLOB)
    registry.put_manifest(repository, "", artifact)
    return True
