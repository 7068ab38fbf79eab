"""What moving an app would give, and what it gave."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from rosml.containerize.base_image.base import Base
from rosml.containerize.rebase.attachments import BaseContents
from rosml.containerize.rebase.compatibility import Judgement
from rosml.containerize.rebase.trial import Pair
from rosml.images.image_set.labels import BASE_DIGEST, BASE_NAME
from rosml.images.join.layers import Joined, Source
from rosml.images.join.transfer import Transferred
from rosml.registry import oci
from rosml.registry.references import Reference


@dataclass
class Rebased(Transferred):
    """An app on another base image, as `--json` prints it. `before` is the digest of the app's image, and `back` that of the tag, until now.
    `verdict` is `safe` or `check by link`, or empty after `--back`."""

    app: str = ""
    reference: str = ""
    digest: str = ""
    before: str = ""
    base: str = ""
    base_digest: str = ""
    old_base: str = ""
    old_base_digest: str = ""
    back: str = ""
    moved: bool = False
    verdict: str = ""
    reasons: list[str] = field(default_factory=list)
    linked: bool = False

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


@dataclass(frozen=True)
class Member:
    """An app for one platform, its new image, and what is on the new base image."""

    app: Source
    image: Joined
    base: BaseContents


@dataclass(frozen=True)
class Plan:
    """A new image of an app that is in no registry yet. `tag_digest` is where the tag was, empty if there was none."""

    app: Reference
    app_name: str
    target: Reference
    tag_digest: str
    base: Base
    members: Mapping[str, Member]  # by platform
    judgement: Judgement
    document: bytes
    is_index: bool

    @property
    def digest(self) -> str:
        return oci.digest_of(self.document)

    @property
    def changes_nothing(self) -> bool:
        return self.tag_digest == self.digest

    def needs_link(self, check: str) -> bool:
        """Whether a step in the builder has to link the app, by `--check`."""
        return check in ("link", "run") or (check == "auto" and bool(self.judgement.undecided))

    @property
    def pairs(self) -> dict[str, Pair]:
        new, present = (f"{where.host}/{where.repository}" for where in (self.target, self.app))
        return {
            platform: Pair(f"{new}@{member.image.digest}", f"{present}@{member.app.digest}")
            for platform, member in self.members.items()
        }

    @property
    def rebased(self) -> Rebased:
        labels = next(iter(self.members.values())).app.labels
        return Rebased(
            app=self.app_name,
            reference=str(self.target),
            digest=self.digest,
            before=self.app.reference,
            base=self.base.name,
            base_digest=self.base.digest,
            old_base=labels.get(BASE_NAME, ""),
            old_base_digest=labels.get(BASE_DIGEST, ""),
            back=self.tag_digest,
            verdict=self.judgement.words,
            reasons=[*self.judgement.reasons],
        )
