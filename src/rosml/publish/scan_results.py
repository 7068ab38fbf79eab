"""Records what a scan found that might not write into the registry (scan/results.py). All that is made of it is the outcome
in entries that are about the very same image, and SBOMs beside manifests that are there.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.publish.pipeline import Outcome as Done
from rosml.publish.pipeline import Pipeline
from rosml.records import store
from rosml.registry.oci import is_digest, is_place
from rosml.registry.repositories import repository_path
from rosml.scan.judge import Outcome
from rosml.scan.sbom import Sbom, Shelf
from rosml.scan.trivy import WRITTEN_BYTES


class _Facts(BaseModel):
    model_config = ConfigDict(frozen=True, strict=True)


class _HandedSbom(_Facts):
    repository: str
    digest: str
    scanner: str
    content: str


class _Handed(_Facts):
    """What the file says, as `scan/results.py` writes it."""

    version: Literal[1]
    entries: list[Any]
    sboms: list[_HandedSbom]


def record(pipeline: Pipeline, file: Path) -> None:
    """Writes into the registry what a scan handed over.

    Raises:
        RosmlError: the file cannot be read, or the registry fails.
    """
    try:
        data = file.read_bytes()
        content = _Handed.model_validate_json(data)
        untrusted.json_value(data, WRITTEN_BYTES)  # within the limits: entries go into the records as they are
        entries = [_entry(item) for item in content.entries]
        sboms = [_sbom(item, pipeline.host, pipeline.prefix) for item in content.sboms]
    except (OSError, ValueError) as error:
        reason = first_of(error) if isinstance(error, ValidationError) else getattr(error, "strerror", "") or error
        text = f"{file} holds no results of a scan: {reason}"
        raise RosmlError(text, "write it again with: rosml publish scan --output FILE", exit_code=2) from None
    entry_of = {(pipeline.repository(entry.repository), entry.digest): entry for entry in pipeline.plan.known.values()}
    for repository, digest, scanner, sbom in sboms:
        of = entry_of.get((repository, digest))
        if of is None or not pipeline.registry.head(repository, digest):  # it was made again since it was scanned
            continue
        shelf = Shelf(pipeline.registry, scanner, {digest: of.sbom}, pipeline.record_sbom)
        if shelf.load(repository, digest) is None:
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


def _sbom(item: _HandedSbom, host: str, prefix: str) -> tuple[str, str, str, Sbom]:
    """Repository, digest, scanner and SBOM.

    Raises:
        ValueError: it is no SBOM, or one of something else.
    """
    repository, digest = item.repository, item.digest
    ours = is_place(host, repository) and repository.startswith(repository_path(prefix, ""))
    if not is_digest(digest) or not ours:
        raise ValueError(f"{repository}@{digest} is none of our images")
    sbom = Sbom(item.content.encode())
    try:
        if not sbom.is_of(digest):
            raise ValueError(f"an SBOM in it is not of {digest}")
    except RosmlError as error:
        raise ValueError(error.message) from None
    return repository, digest, item.scanner, sbom
