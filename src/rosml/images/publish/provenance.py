"""Where an image came from: SLSA provenance in an in-toto statement, attached to the image's manifest.

The statement is apart from the image, so that no manifest contains times or machines: the same inputs give the same
digest on any day. A manifest has one statement for each builder that made it, from the first time. An index names the
statements about its images by their digests, so that its signature covers them.
https://slsa.dev/spec/v1.0/provenance says what the fields mean.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from packageurl import PackageURL

from rosml.base.errors import RosmlError
from rosml.images.records.store import CREATED
from rosml.machine import git
from rosml.registry.client import Registry
from rosml.registry.credentials import DOCKER_HUB
from rosml.registry.oci import encoded

MEDIA_TYPE = "application/vnd.in-toto+json"
"""The media type of a statement without a signature; also the type of the artifact."""

STATEMENT = "https://in-toto.io/Statement/v1"
PREDICATE = "https://slsa.dev/provenance/v1"

BUILD_TYPE = "https://rosml.invalid/build/v1"
"""How an image is made, and what the parameters mean: docs/publishing/attached.md. Nobody can own a name below .invalid."""

OWN_MACHINE = "https://rosml.invalid/builder/own-machine"
"""The builder's identity if a person calls the publisher: nobody vouches for that machine."""

COVERED = "io.rosml.provenance"
"""The annotation of an image in its index with the digests of the statements about it."""

PREDICATE_ANNOTATION = "in-toto.io/predicate-type"
BUILDER = "io.rosml.builder"
"""The annotation of our statements that names the builder of the image."""

CONTENT = ("Dockerfile", ".dockerignore", "matrix.yaml", "set.yaml", "components", "locks", "src/rosml")
"""The files of a checkout that can decide an image. Other files, such as plans and reports of a job, do not."""


@dataclass(frozen=True)
class Machine:
    """Who makes images.

    Attributes:
        builder: the builder's identity.
        invocation: identifies this run of the builder.
    """

    builder: str
    invocation: str

    @classmethod
    def here(cls, date: str, environ: Mapping[str, str] = os.environ) -> Machine:
        """On GitHub, the workflow and its run. Elsewhere, somebody's own machine and the date of the publishing run."""
        server, workflow = environ.get("GITHUB_SERVER_URL", ""), environ.get("GITHUB_WORKFLOW_REF", "")
        if environ.get("GITHUB_ACTIONS") != "true" or not server or not workflow:
            return cls(OWN_MACHINE, date)
        run = f"{server}/{environ.get('GITHUB_REPOSITORY', '')}/actions/runs/{environ.get('GITHUB_RUN_ID', '')}"
        return cls(f"{server}/{workflow}", f"{run}/attempts/{environ.get('GITHUB_RUN_ATTEMPT', '1')}")


def definition(parameters: Mapping[str, str], inputs: str, dependencies: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """What decides an image, and what it was made from: the predicate's `buildDefinition`.

    Args:
        parameters: what was to be built: target, platform, channel.
        inputs: digest of everything in the checkout that decides the image's content.
        dependencies: resource descriptors: base image, parts, locks, the checkout, packages.
    """
    return {
        "buildType": BUILD_TYPE,
        "externalParameters": {name: text for name, text in parameters.items() if text},
        "internalParameters": {"inputs": inputs},
        "resolvedDependencies": list(dependencies),
    }


# ---- What an image was made from -------------------------------------------------------------------------------------


def image(name: str, repository: str, digest: str, **annotations: str) -> dict[str, Any]:
    """The descriptor of an image or part.

    Args:
        name: what it is called here.
        repository: with the registry.
        digest: of the manifest.
        annotations: further facts.
    """
    said = {"annotations": annotations} if annotations else {}
    return {"name": name, "uri": purl(repository, digest), "digest": _digest(digest), **said}


def purl(repository: str, digest: str) -> str:
    """A package URL of an image, with the registry."""
    name = repository.rpartition("/")[2]
    return PackageURL("oci", None, name, digest, {"repository_url": repository}).to_string()


def base(reference: str, expected: str) -> dict[str, Any]:
    """The descriptor of an operating system's image.

    Args:
        reference: such as `debian:bookworm@sha256:…`.
        expected: digest of the base image in matrix.yaml. If the image has another digest, the descriptor says so.
    """
    name, _, digest = reference.removeprefix("docker-image://").partition("@")
    repository = re.sub(r":[^/:]+$", "", name)
    if "/" not in repository:
        repository = f"library/{repository}"
    host, _, path = repository.partition("/")
    if not re.search(r"[.:]", host):
        host, path = DOCKER_HUB, repository
    said = {} if digest == expected else {"differs": "matrix.yaml names another base image"}
    return image(name, f"{host}/{path}", digest, **said)


def locks(root: Path, names: Iterable[str]) -> list[dict[str, Any]]:
    """Descriptors of locks, by their paths in the checkout."""
    return [
        {"name": name, "digest": {"sha256": hashlib.sha256((root / name).read_bytes()).hexdigest()}}
        for name in sorted(names)
    ]


def packages(address: str, state: str) -> dict[str, Any]:
    """The descriptor of an apt repository that packages came from, with its state."""
    return {"name": "apt", "uri": address, "annotations": {"state": state}}


def source(root: Path) -> list[dict[str, Any]]:
    """The descriptor of the checkout, with its revision; none if the folder is no git checkout.

    If files differ from that revision, the descriptor says so. Then the digest of the inputs counts.
    """
    commit = git.commit(root)
    if commit is None or git.top(root) != root.resolve():
        return []
    found: dict[str, Any] = {"name": "source", "digest": {"gitCommit": commit.hash}}
    if address := _public(_asked(root, "config", "--get", "remote.origin.url")):
        found["uri"] = f"git+{address}"
    if _asked(root, "status", "--porcelain", "--", *CONTENT):
        found["annotations"] = {"differs": "files of the checkout differ from the revision"}
    return [found]


def _public(address: str) -> str:
    """An https address without user and password; empty for any other address, since a local path means nothing
    elsewhere."""
    parts = urlsplit(address)
    if parts.scheme != "https" or not parts.hostname:
        return ""
    return f"https://{parts.netloc.rpartition('@')[2]}{parts.path}"


def _asked(root: Path, *arguments: str) -> str:
    """The output of git; empty if git fails."""
    try:
        return git.ask(root, *arguments).decode(errors="replace").strip()
    except RosmlError:
        return ""


def _digest(digest: str) -> dict[str, str]:
    algorithm, _, value = digest.partition(":")
    return {algorithm: value}


# ---- The statement ---------------------------------------------------------------------------------------------------


def statement(
    name: str, digest: str, definition: Mapping[str, Any], machine: Machine, started: str, finished: str
) -> dict[str, Any]:
    """The in-toto statement about a manifest.

    Args:
        name: the manifest's repository.
        digest: the manifest's digest.
        definition: what it was made from.
        machine: who made it.
        started: time such as 2026-11-22T03:00:00Z.
        finished: time such as 2026-11-22T03:00:00Z.
    """
    metadata = {"invocationId": machine.invocation, "startedOn": started, "finishedOn": finished}
    return {
        "_type": STATEMENT,
        "subject": [{"name": name, "digest": _digest(digest)}],
        "predicateType": PREDICATE,
        "predicate": {
            "buildDefinition": definition,
            "runDetails": {"builder": {"id": machine.builder}, "metadata": metadata},
        },
    }


def attach(
    client: Registry,
    repository: str,
    digest: str,
    definition: Mapping[str, Any],
    machine: Machine,
    started: str,
    finished: str,
    recorded: str = "",
) -> str:
    """Attaches a statement to a manifest, unless the registry has the one of the same builder that the records name.

    Other attached statements do not count: everybody with write access can attach one that names any builder.

    Args:
        client: of the registry.
        repository: the manifest's repository.
        digest: the manifest's digest.
        definition: what it was made from.
        machine: who made it.
        started: as in `statement`.
        finished: as in `statement`.
        recorded: digest of the artifact with this builder's earlier statement, by the records.

    Returns:
        Digest of the artifact with the builder's statement.

    Raises:
        RosmlError: there is no such manifest; the registry does not answer or refuses.
    """
    if recorded and client.head(repository, recorded):
        return recorded
    subject = client.manifest(repository, digest)
    if subject is None:
        raise RosmlError(f"{repository}@{digest} is not in the registry any more", "publish it again")
    said = statement(repository, digest, definition, machine, started, finished)
    annotations = {PREDICATE_ANNOTATION: PREDICATE, BUILDER: machine.builder, CREATED: finished}
    return client.attach(repository, subject.descriptor, MEDIA_TYPE, encoded(said), MEDIA_TYPE, annotations)
