"""What `rosml image` prints at its end: what was built and where the time went, on one screen or as JSON."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.units import size, time_taken
from rosml.cli import checkout
from rosml.images.builds import base_images
from rosml.images.image_set.model import Image, tags_of
from rosml.images.publish.run import Run
from rosml.images.publish.state import ABSENT, WAITING
from rosml.images.records.store import INDEX
from rosml.images.records.tag_moves import Move
from rosml.machine import buildx


@dataclass
class Summary:
    """The result of publishing one image.

    Attributes:
        target: the bake target.
        reference: what to put after FROM: the main tag, or the digest if no tag moved.
        digest: digest of the index behind the tags.
        manifest: digest of the image manifest that was tested.
        tags: all references that point at the image.
        moved: tags that pointed elsewhere, or nowhere, before.
        compressed: bytes.
        parts: bytes of `compressed` that are parts, which images of a stack share.
        unpacked: bytes.
        uploaded: bytes that this call added to the registry.
        passed: structure tests.
        failed: structure tests.
        versions: of packages and programs found in the image.
        seconds: time by step.
        waited: how much of it other builds had the builder, by step.
        made: targets that this call built or joined.
        builder: the command that builds a Dockerfile on top of the image with the same builder.
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
    waited: dict[str, float] = field(default_factory=dict)
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
        times = (f"{name} {time_taken(value, self.waited.get(name, 0.0))}" for name, value in self.seconds.items())
        rows = [
            ("FROM", self.reference),
            *(
                tagged
                if self.tags
                else [("tags", "none: a tag is for all platforms of an image that is no test of an add-on")]
            ),
            ("try it", f"{checkout.call()} run {self.reference}"),
            ("build on it", self.builder),
            ("size", f"{size(self.compressed)} compressed{shared}, {size(self.unpacked)} unpacked"),
            ("new in registry", size(self.uploaded)),
            ("made now", ", ".join(self.made) or "nothing: all of it was there"),
            ("structure tests", f"{self.passed} passed, {self.failed} failed"),
            ("time", ", ".join(times) or "nothing to do"),
        ]
        width = max(len(name) for name, _ in rows)
        title = f"{self.target} is built, tested and {'published' if self.tags else 'pushed by its digest'}"
        return "\n".join(["", title, "-" * len(title), *(f"{name.ljust(width)}  {value}" for name, value in rows)])


def require_makeable(run: Run, image: Image, architecture: str) -> None:
    """Checks before a run that an image can be made here, such as that its base image is there: parts take an hour.

    Raises:
        RosmlError: it cannot be.
    """
    state, key = run.state, (image.target, architecture)
    if not state.made(key) and (reason := state.task(state.by_key[key]).hindered):
        raise _no_tag(image, reason)


def _no_tag(image: Image, why: str) -> RosmlError:
    """The error about an image that is not complete, with the remedy for what it waits for."""
    remedy = "rebuild it: --force, or ROSML_FORCE=1 for make"
    if why.startswith(ABSENT):
        remedy = "try it later, or build from ROS's packages before their release: ROS_CHANNEL=testing rosml image"
    elif why.startswith(WAITING):
        remedy = f"use a machine that reaches the base image, or {base_images.name_another(image.os)}"
    return RosmlError(f"{image.target} gets no tag: {why}", remedy)


def require_whole(run: Run, image: Image, architecture: str, tagged: bool) -> None:
    """Checks that an image is complete after a run.

    Raises:
        RosmlError: it is not; the message says which step failed first, or what the image waits for.
    """
    state = run.state
    if failed := next((outcome for outcome in run.outcomes if outcome.state == "failed"), None):
        known = state.known.get((failed.target, failed.architecture or INDEX))
        remedy = known.failed.get("remedy", "") if known else ""
        text = f"{failed.step} of {failed.target} failed, so {image.target} gets no tag: {failed.reason}"
        raise RosmlError(text, remedy or "correct what failed, then run it again: what was finished is kept")
    if tagged:
        index = state.index_of(image)
        wrong = state.unready(image) or (
            f"its tags were moved back on {index.held[:10]}" if index and index.held else ""
        )
    else:
        wrong = "; ".join(state.reasons(state.by_key[image.target, architecture]))
    if wrong:
        waits = next((o.reason for o in run.outcomes if o.target == image.target and o.state == "waits"), wrong)
        raise _no_tag(image, waits)


def of_image(run: Run, image: Image, architecture: str, moves: list[Move] | None) -> Summary:
    """The result of a run for one image.

    Args:
        run: the run, which ended.
        image: the image.
        architecture: the architecture.
        moves: moves of tags; None if the run was to move none.

    Raises:
        RosmlError: the image is not complete.
    """
    require_whole(run, image, architecture, tagged=moves is not None)
    state, repository = run.state, run.state.place.reference(image.repository)
    entry = state.known[image.target, architecture]
    parts = [state.known[state.image_set.part_by_name[name].target, architecture] for name in image.parts]
    seconds: dict[str, float] = {}
    waited: dict[str, float] = {}
    for outcome in run.outcomes:
        if outcome.seconds:
            seconds[outcome.step] = seconds.get(outcome.step, 0.0) + outcome.seconds
            waited[outcome.step] = waited.get(outcome.step, 0.0) + outcome.waited
    done = [outcome for outcome in run.outcomes if outcome.state == "done"]
    found = Summary(
        image.target,
        f"{repository}@{entry.digest}",
        manifest=entry.digest,
        compressed=entry.size,
        parts=sum(part.size for part in parts),
        unpacked=entry.unpacked,
        uploaded=run.uploaded,
        passed=entry.passed,
        failed=len(entry.failures),
        versions=dict(entry.versions),
        seconds=seconds,
        waited=waited,
        made=[outcome.target for outcome in done if outcome.step in ("build", "join")],
        builder=buildx.command_on_it(state.request.services),
    )
    if moves is not None and image.tags:
        found.tags = [f"{repository}:{tag}" for tag in tags_of(image)]
        found.reference, found.digest = found.tags[0], state.known[image.target, INDEX].digest
        found.moved = [m.tag for m in moves if (m.repository, m.new) == (image.repository, found.digest)]
    return found
