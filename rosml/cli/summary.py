"""The end of `make image`: what was made and where the time went, on one screen or as JSON."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.units import duration, size
from rosml.images.image_set import Image, tags_of
from rosml.machine import buildx
from rosml.publish.pipeline import Pipeline
from rosml.records.ledger import INDEX, Entry
from rosml.records.tag_moves import Move


@dataclass
class Summary:
    """What publishing one image came to.

    Attributes:
        target: the bake target.
        reference: what to put after FROM: the main tag; the digest where no tag is made.
        tags: all references that point at the image. moved: tags that pointed elsewhere, or nowhere, before.
        digest: digest of the index behind the tags. manifest: of the image manifest that was tested.
        compressed, unpacked: bytes. parts: bytes of `compressed` that are parts, which images of a stack share.
        uploaded: bytes that this call added to the registry.
        passed, failed: structure tests. versions: of what was found inside.
        seconds: time by step. made: targets that were built or joined now.
        builder: the command that builds a Dockerfile on top of it with the same builder.
    """

    target: str
    reference: str
    digest: str = ""
    manifest: str = ""
    tags: list[str] = field(default_factory=list)
    moved: list[str] = field(default_factory=list)
    compressed: int = 0
    parts: int = 0
    unpacked: int = 0
    uploaded: int = 0
    passed: int = 0
    failed: int = 0
    versions: dict[str, str] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)
    made: list[str] = field(default_factory=list)
    builder: str = ""

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)

    def text(self) -> str:
        """The summary as aligned lines."""
        shared = f" ({size(self.parts)} of it parts, which other images share)" if self.parts else ""
        tagged = [
            ("digest", self.digest),
            ("tags", ", ".join(tag.rsplit("/", 1)[1] for tag in self.tags)),
            ("tags moved", ", ".join(self.moved) or "none: all pointed here already"),
        ]
        seconds = ", ".join(f"{name} {duration(value)}" for name, value in self.seconds.items())
        rows = [
            ("FROM", self.reference),
            *(tagged if self.tags else [("tags", "none: a tag is for all platforms of an image")]),
            ("build on it", self.builder),
            ("size", f"{size(self.compressed)} compressed{shared}, {size(self.unpacked)} unpacked"),
            ("new in registry", size(self.uploaded)),
            ("made now", ", ".join(self.made) or "nothing: all of it was there"),
            ("structure tests", f"{self.passed} passed, {self.failed} failed"),
            ("time", seconds or "nothing to do"),
        ]
        width = max(len(name) for name, _ in rows)
        title = f"{self.target} is built, tested and {'published' if self.tags else 'pushed by its digest'}"
        return "\n".join(["", title, "-" * len(title), *(f"{name.ljust(width)}  {value}" for name, value in rows)])


def of_image(run: Pipeline, image: Image, architecture: str, moves: list[Move] | None) -> Summary:
    """What a run came to for one image.

    Args:
        run: that ended. image, architecture: of which.
        moves: of tags; None where it was to move none.

    Raises:
        RosmlError: the image is not as it should be; says which step failed first, or what it waits for.
    """
    agenda = run.agenda
    entry = agenda.known.get((image.target, architecture)) or Entry(image.target, architecture)
    item = agenda.by_key[image.target, architecture]
    failed = next((outcome for outcome in run.outcomes if outcome.state == "failed"), None)
    if failed:
        known = agenda.known.get((failed.target, failed.architecture or INDEX))
        remedy = known.failed.get("remedy", "") if known else ""
        text = f"{failed.step} of {failed.target} failed, so {image.target} gets no tag: {failed.reason}"
        raise RosmlError(text, remedy or "mend what failed, then run it again: what was finished is kept")
    index = agenda.known.get((image.target, INDEX)) or Entry(image.target, INDEX)
    settled = agenda.unready(image, run.serving) if moves is not None else "; ".join(agenda.reasons(item))
    if settled or (moves is not None and index.held):
        waits = next((o.reason for o in run.outcomes if o.target == image.target and o.state == "waits"), settled)
        raise RosmlError(
            f"{image.target} gets no tag: {waits}", "see what is to be done: make plan, or make it anew: FORCE=1"
        )
    repository = run.reference(image.repository)
    tags = [f"{repository}:{tag}" for tag in tags_of(image)] if moves is not None else []
    seconds: dict[str, float] = {}
    for outcome in run.outcomes:
        if outcome.seconds:
            seconds[outcome.step] = seconds.get(outcome.step, 0.0) + outcome.seconds
    parts = [agenda.known.get((agenda.catalogue.payload_by_name[name].target, architecture)) for name in image.parts]
    return Summary(
        image.target,
        tags[0] if tags else f"{repository}@{entry.digest}",
        index.digest if tags else "",
        entry.digest,
        tags,
        [move.tag for move in moves or [] if move.repository == image.repository and move.new == index.digest],
        entry.size,
        sum(part.size for part in parts if part),
        entry.unpacked,
        run.uploaded,
        entry.passed,
        len(entry.failures),
        dict(entry.versions),
        seconds,
        [
            outcome.target
            for outcome in run.outcomes
            if outcome.step in ("build", "compose") and outcome.state == "done"
        ],
        buildx.command_on_it(agenda.services),
    )
