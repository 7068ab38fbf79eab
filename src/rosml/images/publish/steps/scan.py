"""Scans images for known vulnerabilities, and records the results."""

from __future__ import annotations

import hashlib
import time
from collections import Counter
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

from rosml.images.image_set import restricted
from rosml.images.image_set.expand import expand
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import vex
from rosml.images.publish.items import Item, Key
from rosml.images.publish.run import Outcome, Run
from rosml.images.publish.scan_results import Results
from rosml.images.publish.state import State
from rosml.images.records.store import Entry
from rosml.images.scan import judge, sarif
from rosml.images.scan.policy import Rules
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.images.scan.vex import digest as vex_digest


def scan(
    run: Run,
    rules: Rules,
    trivy: Trivy | ScannerFailed,
    reports: Path | None = None,
    results: Results | None = None,
) -> judge.Run:
    """Scans all images in the registry that were not clean by the same policy and database. Each result is recorded at once: a run may end.

    `reports` is a folder for SARIF; `results` takes what else would go into the registry."""
    state, policy = run.state, policy_digest(rules, run.state.date)

    def keep(scanned: judge.Scanned) -> None:
        key = scanned.target, scanned.architecture
        before = state.entries[key]
        statements = vex.statements(scanned, before)
        digest = before.scan.get("vex", "") if statements is None else vex_digest(statements)
        entry = replace(before, scanned=scanned.outcome.value, scan={**_facts(scanned, policy), "vex": digest})
        new = statements if statements and vex.is_new(before, statements) else []
        if results is None:
            run.write(vex.attach(state.place, entry, new, state.date) if new else entry)
        else:
            results.add(entry, new)

    images = _images(state, policy, _database(trivy))
    started, date, targets = time.monotonic(), _time(state.date), state.image_set.by_target
    whole, missing = _is_whole(state, images), left_out(state.image_set)
    if isinstance(trivy, ScannerFailed):
        scans = judge.unscanned([*images.values()], trivy, keep)
    else:
        shelf = Shelf(state.place.client, {entry.digest: entry.sbom for entry in state.entries.values() if entry.sbom})
        scans = judge.scan_images([*images.values()], rules, judge.Scanner(trivy, shelf, run.say), date, keep)
    verdict = judge.summarise(scans, rules, date.date(), whole, targets, missing)
    run.outcomes += _outcomes(verdict, time.monotonic() - started)
    if reports:
        sarif.write(reports, verdict)
    return verdict


def left_out(image_set: ImageSet) -> set[str]:
    """The targets that a set does not have, and the matrix that it extends has; none if it is no set."""
    return set(expand(image_set.base).by_target) - set(image_set.by_target) if image_set.base else set()


def _facts(scanned: judge.Scanned, policy: str) -> dict[str, Any]:
    """What an entry says about a scan."""
    return {
        "policy": policy,
        "database": scanned.database.digest if scanned.database else "",
        "updated": scanned.database.updated if scanned.database else "",
        "packages": scanned.packages,
        "findings": dict(Counter(finding.severity for finding in scanned.findings)),
        "failing": sorted({finding.id for finding in scanned.failing}),
        "named": scanned.recorded,
    }


def _outcomes(verdict: judge.Run, seconds: float) -> list[Outcome]:
    outcomes = []
    for image in verdict.images:
        clean = image.outcome is judge.Outcome.CLEAN
        reason = image.reason if clean else f"{image.outcome.value}: {image.reason}"
        share = seconds / len(verdict.images)
        outcomes.append(Outcome("scan", image.target, image.architecture, "done" if clean else "failed", reason, share))
    return outcomes + [Outcome("scan", "policy", "", "failed", problem) for problem in verdict.problems]


def _is_whole(state: State, images: dict[Key, judge.Image]) -> bool:
    """Whether a scan covers all that this registry may have. Missing images may lack a lock, or have parts that may not go there."""
    present = {item.key for item in state.items if item.kind != "part"} & state.present
    every, place = state.image_set.images, state.place
    refused, _ = restricted.refused(state.image_set, every, place.client.host, place.prefix)
    not_requested = {image.target for image in every} - {image.target for image in state.images} - refused.keys()
    return images.keys() == present and not not_requested


def _images(state: State, policy: str, database: str) -> dict[Key, judge.Image]:
    """The images to scan, by target and architecture."""
    images = dict[Key, judge.Image]()
    for item in state.items:
        entry = state.entries.get(item.key)
        if item.kind == "part" or entry is None or not entry.digest or item.key not in state.present:
            continue
        if not _is_clean(entry, policy, database):
            needs = item.needs if item.kind == "joined" else (item.target,)
            images[item.key] = judge.Image(
                *item.key, tuple(_part(state, state.by_key[target, item.architecture]) for target in needs)
            )
    return images


def _part(state: State, item: Item) -> judge.Part:
    place = state.place
    repository, digest = place.path(item.repository), state.entries[item.key].digest
    return judge.Part(item.target, place.client.host, repository, digest, item.kind == "ros")


def _is_clean(entry: Entry, policy: str, database: str) -> bool:
    """Whether an image was clean by the same policy and database before."""
    same = database and entry.scan.get("policy") == policy and entry.scan.get("database") == database
    return bool(same and entry.scanned == judge.Outcome.CLEAN.value)


def _database(trivy: Trivy | ScannerFailed) -> str:
    """The digest of the scanner's database; empty if there is none. Then the scan reports that."""
    try:
        return "" if isinstance(trivy, ScannerFailed) else trivy.database().digest
    except ScannerFailed:
        return ""


def policy_digest(rules: Rules, date: str) -> str:
    """A digest of a scan policy on a run's date, without expired ignore entries: a scan that was clean by one of these counts no more."""
    return hashlib.sha256(rules.in_force(_time(date).date()).model_dump_json().encode()).hexdigest()


def _time(date: str) -> datetime:
    return datetime.fromisoformat(date.replace("Z", "+00:00"))
