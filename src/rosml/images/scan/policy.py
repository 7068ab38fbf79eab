"""scan.yaml: the policy about which known vulnerabilities keep an image from its tags, and which are ignored, why, and until when."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass
from datetime import date, timedelta
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import BeforeValidator, Field, model_validator

from rosml import ROOT
from rosml.base.problems import Problem, counted
from rosml.images.matrix import source, validate
from rosml.images.matrix.patterns import Facts, only_whole

LONGEST = 128
"""The most characters of each thing that the records say about a finding; the policy's reasons may be longer."""

Severity = Literal["critical", "high", "medium", "low", "unknown"]

SEVERITIES: tuple[Severity, ...] = ("critical", "high", "medium", "low", "unknown")
"""The worst first."""

Status = Literal["affected", "not_affected", "fixed", "under_investigation"]
"""VEX's words for how a vulnerability concerns an image."""

Justification = Literal[
    "component_not_present",
    "vulnerable_code_not_present",
    "vulnerable_code_not_in_execute_path",
    "vulnerable_code_cannot_be_controlled_by_adversary",
    "inline_mitigations_already_exist",
]
"""VEX's reasons why an image is not affected: https://github.com/openvex/spec/blob/main/OPENVEX-SPEC.md"""

SOON = timedelta(days=30)
"""So long before an entry ends, runs say so."""

ADVISORY = r"^[A-Z][A-Za-z0-9]*(-[A-Za-z0-9]+)+$"
PACKAGE = r"^[A-Za-z0-9][A-Za-z0-9._+-]*$"
GLOB = r"^[a-z0-9*?][a-z0-9*?.-]*$"
REASON = r"\S+\s+\S+"
REPOSITORY = (
    r"^[a-z0-9]([a-z0-9.-]*[a-z0-9])?(:[1-9][0-9]{0,4})?(/[a-z0-9]+([._-]+[a-z0-9]+)*)+(:[A-Za-z0-9_][A-Za-z0-9._-]*)?$"
)
MEANING = {
    ADVISORY: "the name of an advisory, such as CVE-2026-12345 or GHSA-abcd-efgh-ijkl",
    PACKAGE: "the name of a package, such as libssl3 or torch",
    GLOB: 'a pattern of bake targets, such as "jazzy-*"',
    REASON: "a reason of more than one word",
    REPOSITORY: "a repository with its registry, such as ghcr.io/aquasecurity/trivy-db:2",
}


class Ignored(Facts):
    """A vulnerability that does not stop images, for a reason and for some time."""

    id: Annotated[str, Field(pattern=ADVISORY, max_length=64)] = Field(
        description="the advisory, such as CVE-2026-12345"
    )
    package: Annotated[str, Field(pattern=PACKAGE, max_length=128)] | None = Field(
        default=None, description="only in this package; in all of them if left out"
    )
    targets: Annotated[str, Field(pattern=GLOB, max_length=128)] = Field(
        default="*", description="only in images whose bake target matches this pattern"
    )
    status: Status = Field(default="affected", description="whether it concerns these images, in VEX's words")
    justification: Justification | None = Field(
        default=None, description="for status not_affected, and only for it: why not"
    )
    reason: Annotated[str, Field(pattern=REASON, max_length=400)] = Field(description="why it does not stop images")
    action: Annotated[str, Field(pattern=REASON, max_length=400)] | None = Field(
        default=None, description="for status affected: what users can do, beside an image with a newer package"
    )
    expires: date = Field(description="the last day on which it is ignored")

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        if (self.status == "not_affected") != bool(self.justification):
            raise ValueError("'status: not_affected' and 'justification' belong together")
        if self.action and self.status != "affected":
            raise ValueError("'action' is for images that are affected")
        return self

    def covers(self, target: str, advisory: str, package: str) -> bool:
        return self.id == advisory and self.package in (None, package) and self.is_for(target)

    def is_for(self, target: str) -> bool:
        return fnmatchcase(target, self.targets)


class DatabaseRules(Facts):
    repositories: Annotated[
        tuple[Annotated[str, Field(pattern=REPOSITORY, max_length=200)], ...], Field(min_length=1)
    ] = Field(description="repositories of trivy's database; if one does not answer, the next one is asked")
    max_age_hours: Annotated[int, Field(ge=1, le=24 * 365)] = Field(
        description="a database that was made earlier than that is too old to vouch for anything"
    )


class Policy(Facts):
    version: Annotated[Literal[1], BeforeValidator(only_whole)] = Field(description="version of this file's format")
    fail: Annotated[tuple[Severity, ...], Field(min_length=1)] = Field(description="severities that stop an image")
    unknown: Literal["fail", "list"] = Field(
        default="fail", description="whether a vulnerability that nobody has rated stops an image, or is only listed"
    )
    fixable_only: bool = Field(description="whether only vulnerabilities that a newer package fixes stop an image")
    database: DatabaseRules
    ignore: tuple[Ignored, ...] = Field(default=(), description="what does not stop images, though it is found")

    def stops(self, severity: str) -> bool:
        return severity in self.fail or (severity == "unknown" and self.unknown == "fail")


@dataclass(frozen=True)
class Rules:
    """A policy, and its file with the place of each value."""

    policy: Policy
    document: source.Document

    def expired(self, today: date) -> dict[int, Problem]:
        """The expired entries of `ignore`, by index, each with its message."""
        text = "{0.id} was ignored until {0.expires}; look at it again: give it a new date, or remove it"
        entries = enumerate(self.policy.ignore)
        return {index: self._problem(index, text.format(entry)) for index, entry in entries if entry.expires < today}

    def ending(self, today: date) -> list[Problem]:
        """The entries of `ignore` that end within thirty days, each with its message."""
        text = "{0.id} is ignored until {0.expires}, {1} from now; look at it again"
        return [
            self._problem(index, text.format(entry, counted((entry.expires - today).days, "day")))
            for index, entry in enumerate(self.policy.ignore)
            if today <= entry.expires <= today + SOON
        ]

    def in_force(self, today: date) -> Policy:
        """The policy without expired entries of `ignore`."""
        expired = self.expired(today)
        entries = tuple(entry for index, entry in enumerate(self.policy.ignore) if index not in expired)
        return self.policy.model_copy(update={"ignore": entries})

    def unmatched(self, matched: Iterable[int], judged: Iterable[int]) -> list[Problem]:
        """Problems of entries that matched nothing; `judged` are those whose images were all scanned. Both are indexes."""
        return [
            self._problem(index, f"{self.policy.ignore[index].id} is in no image that the entry is for; remove it")
            for index in sorted({*judged} - {*matched})
        ]

    def for_nobody(self, targets: Collection[str]) -> list[Problem]:
        """Problems of entries whose pattern matches none of all targets."""
        text = "{0.targets!r} matches no image of the matrix; correct the pattern, or remove the entry"
        entries = enumerate(self.policy.ignore)
        return [self._problem(index, text.format(it)) for index, it in entries if not any(map(it.is_for, targets))]

    def _problem(self, index: int, text: str) -> Problem:
        return self.document.problem(("ignore", index), text)


def load(file: Path) -> Rules:
    """Reads a policy. Raises an `InputError` with every problem of the file."""
    return parsed(source.read(file, "--policy"))


def ending(file: Path, today: date) -> list[str]:
    """The entries of a policy that end within thirty days, each with its file and line. A checkout that scans nothing has no
    policy, and no entries. Raises as `load`."""
    if file == ROOT / "scan.yaml" and not file.exists():
        return []
    rules = load(file)
    return [problem.message(rules.document.name) for problem in rules.ending(today)]


def parsed(document: source.Document) -> Rules:
    return Rules(validate.checked(document, Policy, MEANING), document)
