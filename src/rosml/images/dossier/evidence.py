"""Who made an image, and what vouches for it: provenance, VEX and signatures that are attached to it."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.images.dossier.bill import Item, items, text
from rosml.images.image_set.labels import SBOM, VEX
from rosml.images.join.layers import Source
from rosml.images.publish import cosign, provenance
from rosml.images.records.store import CREATED
from rosml.images.scan import vex
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

BUNDLE = "application/vnd.dev.sigstore.bundle"
"""The beginning of the types of artifacts with a signature, as cosign writes them. Older ones are under a tag."""

LARGEST = 32 << 20
"""The most bytes of a statement."""

MOST = 32
"""The most artifacts of a kind that are read."""


@dataclass(frozen=True)
class Statement:
    """A document that is attached to an image. `vouched`: a signature covers it, of the index that names it by its digest, or its own."""

    digest: str
    content: Item
    vouched: bool
    created: str = ""


def provenance_of(registry: Registry, image: Source) -> tuple[list[Statement], int]:
    """The statements of provenance that the index names; and how many others are attached, which count for nothing."""
    names = image.annotations.get(provenance.COVERED, "").split()[:MOST]
    statements = [*_statements(registry, image, names, vouched=True)]
    attached = {entry["digest"] for entry in registry.referrers(image.repository, image.digest, provenance.MEDIA_TYPE)}
    return statements, len(attached - {*names})


def vex_of(registry: Registry, image: Source, is_signed: Callable[[str], bool]) -> Statement | None:
    """The newest VEX that the index names, or that `is_signed` says of; else the newest that is attached. A newer VEX of an image whose
    index stays has a signature of its own."""
    attached = {entry["digest"] for entry in registry.referrers(image.repository, image.digest, vex.MEDIA_TYPE)}
    covered = {word.rpartition("@")[2] for word in image.annotations.get(VEX, "").split()}
    every = [*_statements(registry, image, sorted(attached)[:MOST], vouched=False)]
    newest = sorted(every, key=lambda it: (it.created, it.digest), reverse=True)
    for it in newest:
        if it.digest in covered or is_signed(it.digest):
            return replace(it, vouched=True)
    return next(iter(newest), None)


def _statements(registry: Registry, image: Source, digests: Sequence[str], vouched: bool) -> Iterator[Statement]:
    for digest in digests:
        artifact = registry.manifest(image.repository, digest) if references.is_digest(digest) else None
        if artifact and artifact.subject == image.digest and artifact.layers:
            content = registry.json_blob(image.repository, artifact.layers[0].digest, LARGEST)
            yield Statement(digest, content, vouched, artifact.annotations.get(CREATED, ""))


def names_sbom(image: Source, artifact: str) -> bool:
    """Whether the image's index names this artifact as its SBOM."""
    return any(name.startswith(SBOM) and value.endswith(f"@{artifact}") for name, value in image.annotations.items())


# ---- What a statement of provenance says -----------------------------------------------------------------------------


@dataclass(frozen=True)
class Origin:
    """What an image was made from, and by whom, as a statement says."""

    builder: str
    invocation: str
    finished: str
    inputs: Mapping[str, str]
    materials: tuple[tuple[str, str, str], ...]  # name, URI and digest

    @property
    def commit(self) -> str:
        """The commit of the checkout that made it; empty if it does not say."""
        digests = (digest for name, _, digest in self.materials if name == "source")
        return next(digests, "").removeprefix("gitCommit:")

    @classmethod
    def of(cls, statement: Item) -> Origin:
        definition = _object(statement, "predicate", "buildDefinition")
        details = _object(statement, "predicate", "runDetails")
        parameters = definition.get("externalParameters")
        return cls(
            text(details, "builder", "id"),
            text(details, "metadata", "invocationId"),
            text(details, "metadata", "finishedOn"),
            {str(name): it for name, it in parameters.items() if isinstance(it, str)}
            if isinstance(parameters, dict)
            else {},
            tuple(map(_material, items(definition, "resolvedDependencies"))),
        )


def _object(item: Item, *path: str) -> Item:
    value: Any = item
    for name in path:
        value = value.get(name) if isinstance(value, Mapping) else None
    return value if isinstance(value, Mapping) else {}


def _material(item: Item) -> tuple[str, str, str]:
    digests = item.get("digest")
    first = next(iter(digests.items()), ("", "")) if isinstance(digests, Mapping) else ("", "")
    return text(item, "name"), text(item, "uri"), ":".join(map(str, first)).strip(":")


# ---- Signatures ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Signature:
    """`state` is `verified`, `signed, not verified`, `not signed by …` or `none`. `why` explains it."""

    state: str
    why: str
    signer: str = ""


def signature_of(registry: Registry, repository: str, manifest: Manifest, signer: str, root: Path) -> Signature:
    """The signature of what a tag points at.

    Args:
        signer: whom the caller trusts: a file with a public key, or the identity of a workflow, `https://…`; empty if nobody.
        root: of the checkout, which may have cosign.
    """
    attached = registry.referrers(repository, manifest.digest)
    signed = any(str(entry.get("artifactType")).startswith(BUNDLE) for entry in attached)
    if not signed and not registry.head(repository, f"{manifest.digest.replace(':', '-')}.sig"):
        return Signature("none", "nobody signed it")
    if not signer:
        return Signature("signed, not verified", "name the signer that you trust with --signer")
    reference = f"{registry.host}/{repository}@{manifest.digest}"
    try:
        cosign.Signer.trusted(root, signer, os.environ).verify(reference)
    except cosign.SignerFailed as error:
        state = "signed, not verified" if error.remedy == cosign.INSTALL else "not verified"
        return Signature(state, f"{error.message}; {error.remedy}" if error.remedy == cosign.INSTALL else error.message)
    return Signature("verified", "cosign verified it", signer)


def is_signed(host: str, repository: str, digest: str, signer: str, root: Path) -> bool:
    """Whether a signer vouches for an artifact; no, if nobody is trusted or cosign is not here."""
    try:
        return bool(signer) and cosign.Signer.trusted(root, signer, os.environ).signed(f"{host}/{repository}@{digest}")
    except cosign.SignerFailed:
        return False


def encoded(content: Item) -> str:
    """JSON for a file of the dossier."""
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"


def lock_of(labels: Mapping[str, str], name: str) -> str:
    """The lock file of an app, which a label has; empty if there is none. Raises RosmlError."""
    if not (words := labels.get(name, "")):
        return ""
    value = untrusted.json_object(words)
    if value is None:
        raise RosmlError(f"its label {name} is damaged")
    return encoded(value)
