"""Scans images for known vulnerabilities, and records the results."""

from __future__ import annotations

import hashlib
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

from rosml.images.image_set import restricted
from rosml.images.image_set.expand import expand
from rosml.images.image_set.model import ImageSet
from rosml.images.publish.run import Outcome, Run
from rosml.images.publish.state import State
from rosml.images.records.store import Entry
from rosml.images.scan import judge, sarif
from rosml.images.scan.policy import Rules
from rosml.images.scan.results import Results
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy


def scan(
    run: Run,
    rules: Rules,
    trivy: Trivy | ScannerFailed,
    reports: Path | None = None,
    results: Results | None = None,
) -> judge.Run:
    """Scans all images in the registry, on all architectures: a scan reads only the registry. Each result is recorded
    at once, so that it is kept if the run ends early.

    If an image was clean by the same policy and the same database before, it is not scanned again.

    Args:
        run: the run.
        rules: the policy.
        trivy: the scanner, with its database; or why there is none.
        reports: a folder for a SARIF file of each image.
        results: takes the results. Then nothing is written into the registry.
    """
    state, policy, database = run.state, policy_digest(rules, run.state.date), _database(trivy)

    def keep(found: judge.Scanned) -> None:
        facts = {
            "policy": policy,
            "database": found.database.digest if found.database else "",
            "updated": found.database.updated if found.database else "",
            "packages": found.packages,
            "findings": dict(Counter(finding.severity for finding in found.findings)),
            "failing": sorted({finding.id for finding in found.failing}),
            "named": found.named,
        }
        key = found.target, found.architecture
        entry = replace(state.known[key], scanned=found.outcome.value, scan=facts, changed=state.date)
        if results is None:
            run.write(state.by_key[key], entry)
        else:
            results.add(entry)

    wanted = _wanted(run, lambda entry: _is_clean(entry, policy, database))
    # Missing images do not count: they may lack a lock, or have restricted parts that may not go to this registry.
    there = {item.key for item in state.items if item.kind != "part"} & state.present
    whole = wanted.keys() == there and not _others(state)
    started, date, targets = time.monotonic(), _time(state.date), state.image_set.by_target
    missing = left_out(state.image_set)
    images = list(wanted.values())
    if isinstance(trivy, ScannerFailed):
        found = judge.summarise(judge.unscanned(images, trivy, keep), rules, date.date(), whole, targets, missing)
    else:
        facts: dict[str, Any] = {"now": date, "whole": whole, "targets": targets, "left_out": missing}
        shelf = Shelf(state.place.client, {entry.digest: entry.sbom for entry in state.known.values() if entry.sbom})
        found = judge.scan_images(images, rules, trivy, shelf, **facts, say=run.say, keep=keep)
    seconds = (time.monotonic() - started) / max(1, len(found.images))
    for image in found.images:
        clean = image.outcome is judge.Outcome.CLEAN
        reason = image.reason if clean else f"{image.outcome.value}: {image.reason}"
        key = image.target, image.architecture
        run.outcomes.append(Outcome("scan", *key, "done" if clean else "failed", reason, seconds))
    if reports:
        sarif.write(reports, found)
    run.outcomes += [Outcome("scan", "policy", "", "failed", problem) for problem in found.problems]
    return found


def left_out(image_set: ImageSet) -> set[str]:
    """The targets that a set does not have, and the matrix that it extends has; none if it is no set."""
    return set(expand(image_set.base).by_target) - set(image_set.by_target) if image_set.base else set()


def _others(state: State) -> set[str]:
    """The targets that this registry may have, and that were not requested."""
    every, place = state.image_set.images, state.place
    refused, _ = restricted.refused(state.image_set, every, place.client.host, place.prefix)
    return {image.target for image in every} - {image.target for image in state.images} - refused.keys()


def _wanted(run: Run, clean: Callable[[Entry], bool]) -> dict[tuple[str, str], judge.Image]:
    """The images to scan, by target and architecture."""
    state, found = run.state, dict[tuple[str, str], judge.Image]()
    for item in state.items:
        entry = state.known.get(item.key)
        if item.kind == "part" or entry is None or not entry.digest or item.key not in state.present or clean(entry):
            continue
        needs = item.needs if item.kind == "joined" else (item.target,)
        parts = tuple(_part(state, target, item.architecture) for target in needs)
        found[item.key] = judge.Image(*item.key, parts)
    return found


def _part(state: State, target: str, architecture: str) -> judge.Part:
    """A finished ROS image or part, as a scan knows it."""
    part, place = state.by_key[target, architecture], state.place
    digest = state.known[part.key].digest
    return judge.Part(target, place.client.host, place.path(part.repository), digest, part.kind == "ros")


def _is_clean(entry: Entry, policy: str, database: str) -> bool:
    """Whether an image was found clean by a policy and a database before."""
    same = database and entry.scan.get("policy") == policy and entry.scan.get("database") == database
    return bool(same and entry.scanned == judge.Outcome.CLEAN.value)


def _database(trivy: Trivy | ScannerFailed) -> str:
    """The digest of the scanner's database; empty if there is none. Then the scan reports that."""
    try:
        return "" if isinstance(trivy, ScannerFailed) else trivy.database().digest
    except ScannerFailed:
        return ""


def policy_digest(rules: Rules, date: str) -> str:
    """A digest of the meaning of a scan policy on a run's date. It does not cover expired ignore entries, so that a
    scan which was clean because of one does not count any more."""
    return hashlib.sha256(rules.in_force(_time(date).date()).model_dump_json().encode()).hexdigest()


def _time(date: str) -> datetime:
    """The date of a run as a time."""
    return datetime.fromisoformat(date.replace("Z", "+00:00"))
