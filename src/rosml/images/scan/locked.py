"""Judges locks by the policy, like the SBOMs of images each night: you see what a scan will refuse when you make the lock."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from datetime import datetime
from typing import Any

from rosml.base.problems import counted, some
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import ImageSet
from rosml.images.scan import cyclonedx, judge, packages
from rosml.images.scan.judge import Outcome
from rosml.images.scan.policy import Rules
from rosml.images.scan.sbom import Sbom, Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy


@dataclass(frozen=True)
class Refused:
    """A locked package that keeps images from their tags."""

    package: str
    version: str
    id: str  # of the advisory
    severity: str
    fixed: str  # the version that fixes it; empty if there is none
    locks: tuple[str, ...]  # the locks that pin the version
    images: tuple[str, ...]  # the targets that the scan will stop, in the order of the matrix

    def __str__(self) -> str:
        fix = f"fixed in {self.fixed}" if self.fixed else "not fixed"
        return (
            f"{self.package} {self.version}: {self.id} ({self.severity}, {fix}) stops"
            f" {counted(len(self.images), 'image')}, such as {self.images[0]}; in {some(list(self.locks))}"
        )

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


class Locks(Shelf):
    """The pins of locks instead of SBOMs in a registry. The digest of a part is the path of its lock."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self.texts = texts

    def load(self, repository: str, digest: str) -> Sbom:
        pinned = lock_file.versions(self.texts[digest]).items()
        wheels = [packages.Python(name=name, version=version) for name, version in pinned]
        contents = packages.Packages(system=packages.System(name="", version=""), apt=[], python=wheels, ros=[])
        return Sbom(cyclonedx.document(contents, digest))


def refused(
    image_set: ImageSet,
    texts: Mapping[str, str],
    rules: Rules,
    trivy: Trivy,
    now: datetime,
    say: Callable[[str], None] = lambda line: None,
) -> list[Refused]:
    """The packages in locks, by path, that the policy does not allow. Fetches the database if there is none that is young enough."""
    try:
        trivy.database().require_fresh(rules.policy.database, now)
    except ScannerFailed:
        trivy.fetch(rules.policy.database, say=say)
    images = [
        judge.Image(image.target, architecture, tuple(judge.Part(path, "", "", path, ros=False) for path in locks))
        for image in image_set.images
        for architecture in image.architectures
        if (locks := [path for path in image.locks if path in texts and path.split("/")[2] == architecture])
    ]
    scans = judge.scan_images(images, rules, judge.Scanner(trivy, Locks(texts)), now)
    if failed := next((scan for scan in scans if scan.outcome is Outcome.SCANNER_FAILED), None):
        raise ScannerFailed(failed.reason)
    places = defaultdict[tuple[str, str, str, str, str], tuple[dict[str, None], dict[str, None]]](lambda: ({}, {}))
    for scan in scans:
        for finding in scan.failing:
            key = finding.package, finding.installed, finding.id, finding.severity, finding.fixed
            pins, targets = places[key]
            pins[finding.part] = targets[scan.target] = None
    return [Refused(*facts, tuple(pins), tuple(targets)) for facts, (pins, targets) in sorted(places.items())]
