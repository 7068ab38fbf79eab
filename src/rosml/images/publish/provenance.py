"""Where an image came from: SLSA provenance in an in-toto statement, attached to the manifest that it is about.

It is kept apart from the image, so that times and machines are in no manifest: the same inputs give the same digest on
any day. Each manifest has one statement of each builder that made it: of the first time, since that holds on. An index names the statements
about its images by their digests, so that its signature covers them.
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
"""Of a statement without a signature; also the type of the artifact."""

STATEMENT = "https://in-toto.io/Statement/v1"
PREDICATE = "https://slsa.dev/provenance/v1"

BUILD_TYPE = "https://rosml.invalid/build/v1"
"""How an image is made, and what the parameters mean: docs/publishing.md. Nobody can own a name below .invalid."""

OWN_MACHINE = "https://rosml.invalid/builder/own-machine"
"""The builder, where a person calls the publisher: nobody vouches for that machine."""

COVERED = "io.rosml.provenance"
"""The annotation of an image in its index that names the artifacts with statements about it, by their digests."""

PREDICATE_ANNOTATION = "in-toto.io/predicate-type"
BUILDER = "io.rosml.builder"
"""The annotation of our statements that says who made the image."""

CONTENT = ("Dockerfile", ".dockerignore", "matrix.yaml", "components", "locks", "src/rosml")
"""What of a checkout can decide an image; plans and reports of a job lie beside it."""


@dataclass(frozen=True)
class Machine:
    """Who makes images: the builder's identity, and what this call of it is known by."""

    builder: str
    invocation: str

    @classmethod
    def here(cls, date: str, environ: Mapping[str, str] = os.environ) -> Machine:
        """The workflow and its run on GitHub; elsewhere somebody's own machine, and the date of the publishing run."""
        server, workflow = environ.get("GITHUB_SERVER_URL", ""), environ.get("GITHUB_WORKFLOW_REF", "")
        if environ.get("GITHUB_ACTIONS") != "true" or not server or not workflow:
            return cls(OWN_MACHINE, date)
        run = f"{server}/{environ.get('GITHUB_REPOSITORY', '')}/actions/runs/{environ.get('GITHUB_RUN_ID', '')}"
        return cls(f"{server}/{workflow}", f"{run}/attempts/{environ.get('GITHUB_RUN_ATTEMPT', '1')}")


def definition(parameters: Mapping[str, str], inputs: str, dependencies: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """What decides an image, and what it was made from: the predicate's `buildDefinition`.

    Args:
        parameters: what was asked for: target, platform, channel.
        inputs: digest of everything in the checkout that decides its content.
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
        name: what it is called here. repository: with the registry. digest: of its manifest.
        annotations: what else is to be said.
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
        expected: digest of the one that matrix.yaml names; where it is another one, the descriptor says so.
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
    """The descriptor of an apt repository that packages came from: of when it was."""
    return {"name": "apt", "uri": address, "annotations": {"state": state}}


def source(root: Path) -> list[dict[str, Any]]:
    """The descriptor of the checkout: its revision; nothing where it is none of git.

    Where files differ from that revision, it says so: the digest of the inputs counts then.
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
    """An address on the web, without whom it is asked as; empty for any other: a path of a machine tells nobody anything."""
    parts = urlsplit(address)
    if parts.scheme != "https" or not parts.hostname:
        return ""
    return f"https://{parts.netloc.rpartition('@')[2]}{parts.path}"


def _asked(root: Path, *arguments: str) -> str:
    """What git says; empty if it fails."""
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
    """What is said of a manifest.

    Args:
        name: its repository. digest: its own.
        definition: what it was made from. machine: who made it.
        started, finished: when, as 2026-11-22T03:00:00Z.
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
    """Attaches a statement to a manifest, unless the records name one of the same builder that is there.

    Others that are attached do not count: whoever may push into a repository may attach one that names any builder.

    Args:
        recorded: digest of the artifact with the statement that this builder made before, as the records say.

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
