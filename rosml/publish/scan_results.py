"""What a scan found, from a job that may only read the registry to one that may write.

The scanner is a large program that reads whatever is in the images and fetches a database; it gets no right to publish.
What its job hands over is data: for each image an outcome, and SBOMs. All that the other job makes of it is those two
fields of entries that are about the very same image, and SBOMs beside manifests that are there.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.publish.pipeline import Outcome as Done
from rosml.publish.pipeline import Pipeline
from rosml.records import store
from rosml.registry.oci import digest_of, encoded, is_digest, is_place
from rosml.registry.protocol import Client
from rosml.registry.repositories import repository_path
from rosml.scan.judge import Outcome
from rosml.scan.sbom import MEDIA_TYPE, SCANNER_ANNOTATION, Sbom, Shelf

FORMAT = 1
"""Version of the file's format."""

READS = ("manifest", "head", "blob", "has_blob", "tags", "referrers", "uploaded")


class Reader:
    """A registry that is only read: entries of the records and SBOMs that are put into it are kept for the file.

    Args:
        client: the registry.
    """

    def __init__(self, client: Client) -> None:
        self._client = client
        self.entries: list[dict[str, Any]] = []
        self.sboms: list[dict[str, str]] = []

    def __getattr__(self, name: str) -> Any:
        if name in READS:
            return getattr(self._client, name)
        if name.startswith("_"):
            raise AttributeError(name)
        return partial(_refuse, name)

    def put_blob(self, _repository: str, data: bytes) -> str:
        """Keeps nothing: an entry's facts are in its manifest."""
        return digest_of(data)

    def put_manifest(self, _repository: str, _reference: str, content: Mapping[str, Any], _media_type: str) -> str:
        """Keeps an entry of the records.

        Raises:
            RosmlError: it is something else.
        """
        text = (content.get("annotations") or {}).get(store.ANNOTATION)
        if text is None:
            raise RosmlError("a scan that hands its results over puts only entries of the records", "record them first")
        self.entries.append(json.loads(text))
        return digest_of(encoded(content))

    def discard(self, _repository: str, _digest: str) -> bool:
        """Removes nothing: the entry that another run replaced meanwhile is not this job's."""
        return False

    def attach(
        self,
        repository: str,
        subject: Mapping[str, Any],
        _artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str] | None = None,
    ) -> str:
        """Keeps an SBOM."""
        if media_type != MEDIA_TYPE:
            raise RosmlError(f"a scan attaches no {media_type}", "record SBOMs only")
        scanner = (annotations or {}).get(SCANNER_ANNOTATION, "")
        found = {"repository": repository, "digest": str(subject["digest"]), "scanner": scanner}
        self.sboms.append(found | {"content": part.decode()})
        return digest_of(part)

    def write(self, file: Path, date: str) -> None:
        """Writes the file."""
        entries = [
            {name: entry.get(name) for name in ("target", "architecture", "digest", "scanned", "scan")}
            for entry in self.entries
        ]
        files.write(file, json.dumps({"version": FORMAT, "date": date, "entries": entries, "sboms": self.sboms}))


def _refuse(name: str, *_: Any, **__: Any) -> None:
    """Any other method.

    Raises:
        RosmlError: always.
    """
    text = f"a scan that hands its results over does not {name.replace('_', ' ')}"
    raise RosmlError(text, "run the scan without --output, where it may write")


def record(pipeline: Pipeline, file: Path) -> None:
    """Writes into the registry what a scan handed over.

    Raises:
        RosmlError: the file cannot be read, or the registry fails.
    """
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        if content["version"] != FORMAT:
            raise ValueError(f"it has format {content['version']}")
        entries = [_entry(item) for item in content["entries"]]
        sboms = [_sbom(item, pipeline.host, pipeline.prefix) for item in content["sboms"]]
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        text = f"{file} holds no results of a scan: {error}"
        raise RosmlError(text, "write it with: publish.py scan --output FILE", exit_code=2) from None
    for repository, digest, scanner, sbom in sboms:
        shelf = Shelf(pipeline.registry, scanner)
        if pipeline.registry.head(repository, digest) and shelf.load(repository, digest) is None:
            shelf.store(repository, digest, sbom)
    for found in entries:
        key = found.target, found.architecture
        known = pipeline.plan.known.get(key)
        if known is None or known.digest != found.digest:
            pipeline.outcomes.append(Done("record", *key, "waits", "it was made anew since it was scanned"))
            continue
        entry = replace(known, scanned=found.scanned, scan=found.scan, changed=pipeline.plan.date)
        pipeline.records.write(entry)
        pipeline.plan.known[key] = entry
        pipeline.outcomes.append(Done("record", *key, "done", found.scanned))


def _entry(item: Any) -> store.Entry:
    found = store.parse(item)
    if found is None or found.scanned not in {outcome.value for outcome in Outcome} or not is_digest(found.digest):
        raise ValueError("an outcome in it is none")
    return found


def _sbom(item: Mapping[str, str], host: str, prefix: str) -> tuple[str, str, str, Sbom]:
    """Repository, digest, scanner and SBOM.

    Raises:
        ValueError: it is no SBOM, or one of something else.
    """
    repository, digest, scanner = (str(item[name]) for name in ("repository", "digest", "scanner"))
    ours = is_place(host, repository) and repository.startswith(repository_path(prefix, ""))
    if not is_digest(digest) or not ours:
        raise ValueError(f"{repository}@{digest} is none of our images")
    sbom = Sbom(item["content"].encode())
    try:
        if not sbom.is_of(digest):
            raise ValueError(f"an SBOM in it is not of {digest}")
    except RosmlError as error:
        raise ValueError(error.message) from None
    return repository, digest, scanner, sbom
