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
from rosml.images.scan import judge, packages
from rosml.images.scan.judge import Outcome
from rosml.images.scan.policy import Rules
from rosml.images.scan.sbom import Sbom, Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy


@dataclass(frozen=True)
class Refused:
    """A locked package that keeps images from their tags.

    Attributes:
        id, severity: the advisory and its severity.
        fixed: the version that fixes it; empty if there is none.
        locks: the locks that pin the version.
        images: the targets that the scan will stop, in the order of the matrix.
    """

    package: str
    version: str
    id: str
    severity: str
    fixed: str
    locks: tuple[str, ...]
    images: tuple[str, ...]

    def __str__(self) -> str:
        mended = f"fixed in {self.fixed}" if self.fixed else "not fixed"
        return (
            f"{self.package} {self.version}: {self.id} ({self.severity}, {mended}) stops"
            f" {counted(len(self.images), 'image')}, such as {self.images[0]}; in {some(list(self.locks))}"
        )

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


class Locks(Shelf):
    """The pins of locks instead of SBOMs in a registry. The digest of a part is the path of its lock."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self.texts = texts

    def load(self, repository: str, digest: str) -> Sbom:
        """The pins of a lock as an SBOM."""
        pinned = lock_file.versions(self.texts[digest]).items()
        wheels = [packages.Python(name=name, version=version) for name, version in pinned]
        found = packages.Packages(system=packages.System(name="", version=""), apt=[], python=wheels, ros=[])
        return Sbom(packages.cyclonedx(found, digest))


def refused(
    image_set: ImageSet,
    texts: Mapping[str, str],
    rules: Rules,
    trivy: Trivy,
    now: datetime,
    say: Callable[[str], None] = lambda line: None,
) -> list[Refused]:
    """The packages in locks that the policy does not allow. Fetches the database if there is none that is young enough.

    Args:
        image_set: the images that are made of the locks.
        texts: the texts of the locks, by path.
        now: the time, by which entries of the policy expire.
        say: gets messages, a line each.

    Raises:
        ScannerFailed: the scanner failed.
    """
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
    run = judge.scan_images(images, rules, trivy, Locks(texts), now=now, whole=False)
    if failed := next((image for image in run.images if image.outcome is Outcome.SCANNER_FAILED), None):
        raise ScannerFailed(failed.reason)
    found = defaultdict[tuple[str, str, str, str, str], tuple[dict[str, None], dict[str, None]]](lambda: ({}, {}))
    for image in run.images:
        for it in image.failing:
            pinned, targets = found[it.package, it.installed, it.id, it.severity, it.fixed]
            pinned[it.part] = targets[image.target] = None
    return [Refused(*facts, tuple(pinned), tuple(targets)) for facts, (pinned, targets) in sorted(found.items())]
