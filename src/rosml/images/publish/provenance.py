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
    """Who makes images."""

    builder: str  # its identity
    invocation: str  # identifies this run of the builder

    @classmethod
    def here(cls, date: str, environ: Mapping[str, str] = os.environ) -> Machine:
        """On GitHub, the workflow and its run. Elsewhere, somebody's own machine and the date of the publishing run."""
        server, workflow = environ.get("GITHUB_SERVER_URL", ""), environ.get("GITHUB_WORKFLOW_REF", "")
        if environ.get("GITHUB_ACTIONS") != "true" or not server or not workflow:
            return cls(OWN_MACHINE, date)
        run = f"{server}/{environ.get('GITHUB_REPOSITORY', '')}/actions/runs/{environ.get('GITHUB_RUN_ID', '')}"
        return cls(f"{server}/{workflow}", f"{run}/attempts/{environ.get('GITHUB_RUN_ATTEMPT', '1')}")


def definition(parameters: Mapping[str, str], inputs: str, dependencies: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """What decides an image, and what it was made from: the predicate's `buildDefinition`."""
    return {
        "buildType": BUILD_TYPE,
        "externalParameters": {name: text for name, text in parameters.items() if text},
        "internalParameters": {"inputs": inputs},
        "resolvedDependencies": list(dependencies),
    }


# ---- What an image was made from -------------------------------------------------------------------------------------


def image(name: str, repository: str, digest: str, **annotations: str) -> dict[str, Any]:
    """The descriptor of an image or part."""
    descriptor = {"name": name, "uri": purl(repository, digest), "digest": _digest(digest)}
    return descriptor | ({"annotations": annotations} if annotations else {})


def purl(repository: str, digest: str) -> str:
    """A package URL of an image, with the registry."""
    name = repository.rpartition("/")[2]
    return PackageURL("oci", None, name, digest, {"repository_url": repository}).to_string()


def base(reference: str, expected: str) -> dict[str, Any]:
    """The descriptor of a system's image, such as `debian:bookworm@sha256:…`; it says if the digest is not the expected one."""
    name, _, digest = reference.removeprefix("docker-image://").partition("@")
    repository = re.sub(r":[^/:]+$", "", name)
    if "/" not in repository:
        repository = f"library/{repository}"
    host, _, path = repository.partition("/")
    if not re.search(r"[.:]", host):
        host, path = DOCKER_HUB, repository
    difference = {} if digest == expected else {"differs": "matrix.yaml names another base image"}
    return image(name, f"{host}/{path}", digest, **difference)


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
    """The descriptor of the checkout, with its revision; none if the folder is no git checkout. If files differ from
    the revision, the descriptor says so, and the digest of the inputs counts."""
    commit = git.commit(root)
    if commit is None or git.top(root) != root.resolve():
        return []
    descriptor: dict[str, Any] = {"name": "source", "digest": {"gitCommit": commit.hash}}
    if address := _public(_git(root, "config", "--get", "remote.origin.url")):
        descriptor["uri"] = f"git+{address}"
    if _git(root, "status", "--porcelain", "--", *CONTENT):
        descriptor["annotations"] = {"differs": "files of the checkout differ from the revision"}
    return [descriptor]


def _public(address: str) -> str:
    """An https address without user and password; empty for any other address, since a local path means nothing
    elsewhere."""
    parts = urlsplit(address)
    if parts.scheme != "https" or not parts.hostname:
        return ""
    return f"https://{parts.netloc.rpartition('@')[2]}{parts.path}"


def _git(root: Path, *arguments: str) -> str:
    try:
        return git.ask(root, *arguments).decode(errors="replace").strip()
    except RosmlError:
        return ""


def _digest(digest: str) -> dict[str, str]:
    algorithm, _, value = digest.partition(":")
    return {algorithm: value}


# ---- The statement ---------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Statement:
    """What is said about a manifest."""

    repository: str
    digest: str
    definition: Mapping[str, Any]  # what it was made from
    machine: Machine
    started: str  # time such as 2026-11-22T03:00:00Z, and so is `finished`
    finished: str

    def content(self) -> dict[str, Any]:
        """The in-toto statement."""
        metadata = {"invocationId": self.machine.invocation, "startedOn": self.started, "finishedOn": self.finished}
        return {
            "_type": STATEMENT,
            "subject": [{"name": self.repository, "digest": _digest(self.digest)}],
            "predicateType": PREDICATE,
            "predicate": {
                "buildDefinition": self.definition,
                "runDetails": {"builder": {"id": self.machine.builder}, "metadata": metadata},
            },
        }


def attach(client: Registry, statement: Statement, recorded: str = "") -> str:
    """Attaches a statement to its manifest, unless the registry has the recorded one of the same builder. Returns the artifact's digest.

    Other attached statements do not count: everybody with write access can attach one that names any builder.
    """
    if recorded and client.head(statement.repository, recorded):
        return recorded
    subject = client.manifest(statement.repository, statement.digest)
    if subject is None:
        raise RosmlError(
            f"{statement.repository}@{statement.digest} is not in the registry any more", "publish it again"
        )
    builder = statement.machine.builder
    annotations = {PREDICATE_ANNOTATION: PREDICATE, BUILDER: builder, CREATED: statement.finished}
    data = encoded(statement.content())
    return client.attach(statement.repository, subject.descriptor, MEDIA_TYPE, data, MEDIA_TYPE, annotations)
