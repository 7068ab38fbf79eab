"""What `rosml image` prints at its end: what was built and where the time went, on one screen or as JSON."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.units import size, time_taken
from rosml.cli import command
from rosml.images.builds import base_images
from rosml.images.image_set.model import Image, tags_of
from rosml.images.publish.items import ABSENT, WAITING
from rosml.images.publish.run import Run
from rosml.images.records.store import INDEX
from rosml.images.records.tag_moves import Move
from rosml.machine import buildx


@dataclass(frozen=True)
class Summary:
    """The result of publishing one image."""

    target: str
    reference: str  # what to put after FROM: the main tag, or the digest if no tag moved
    digest: str  # of the index behind the tags
    manifest: str  # digest of the image that was tested
    tags: list[str]  # all references that point at the image
    moved: list[str]  # tags that pointed elsewhere, or nowhere, before
    compressed: int  # bytes
    parts: int  # bytes of `compressed` that are parts, which images of a stack share
    unpacked: int  # bytes
    uploaded: int  # bytes that this call added to the registry
    passed: int  # structure tests
    failed: int
    versions: dict[str, str]  # of packages and programs in the image
    seconds: dict[str, float]  # time by step
    waited: dict[str, float]  # how much of it other builds had the builder, by step
    built: list[str]  # targets that this call built or joined
    builder: str  # the command that builds a Dockerfile on top of the image with the same builder

    def to_json(self) -> dict[str, Any]:
        return {"made" if name == "built" else name: value for name, value in vars(self).items()}

    def text(self) -> str:
        """The summary as aligned lines."""
        shared = f" ({size(self.parts)} of it parts, which other images share)" if self.parts else ""
        tagged = [
            ("digest", self.digest),
            ("tags", ", ".join(tag.rsplit("/", 1)[1] for tag in self.tags)),
            ("tags moved", ", ".join(self.moved) or "none: all pointed here already"),
        ]
        untagged = [("tags", "none: a tag is for all platforms of an image that is no test of an add-on")]
        times = (f"{name} {time_taken(value, self.waited.get(name, 0.0))}" for name, value in self.seconds.items())
        rows = [
            ("FROM", self.reference),
            *(tagged if self.tags else untagged),
            ("try it", f"{command.call()} run {self.reference}"),
            ("build on it", self.builder),
            ("size", f"{size(self.compressed)} compressed{shared}, {size(self.unpacked)} unpacked"),
            ("new in registry", size(self.uploaded)),
            ("made now", ", ".join(self.built) or "nothing: all of it was there"),
            ("structure tests", f"{self.passed} passed, {self.failed} failed"),
            ("time", ", ".join(times) or "nothing to do"),
        ]
        width = max(len(name) for name, _ in rows)
        title = f"{self.target} is built, tested and {'published' if self.tags else 'pushed by its digest'}"
        return "\n".join(["", title, "-" * len(title), *(f"{name.ljust(width)}  {value}" for name, value in rows)])


def require_makeable(run: Run, image: Image, architecture: str) -> None:
    """Checks before a run that an image can be made here, such as that its base image is there: parts take an hour."""
    state, key = run.state, (image.target, architecture)
    if not state.is_current(key) and (reason := state.task(state.by_key[key]).hindered):
        raise _no_tag(image, reason)


def _no_tag(image: Image, why: str) -> RosmlError:
    remedy = "rebuild it: --force, or ROSML_FORCE=1 for make"
    if why.startswith(ABSENT):
        remedy = "try it later, or build from ROS's packages before their release: ROS_CHANNEL=testing rosml image"
    elif why.startswith(WAITING):
        remedy = f"use a machine that reaches the base image, or {base_images.name_another(image.os)}; without a name of an image,"
        remedy += f" {command.call()} image builds one that this machine can build"
    return RosmlError(f"{image.target} gets no tag: {why}", remedy)


def _require_complete(run: Run, image: Image, architecture: str, tagged: bool) -> None:
    """Checks that an image is complete after a run. The message says which step failed first, or what the image waits
    for."""
    state = run.state
    if failed := next((outcome for outcome in run.outcomes if outcome.state == "failed"), None):
        entry = state.entries.get((failed.target, failed.architecture or INDEX))
        remedy = entry.failed.get("remedy", "") if entry else ""
        text = f"{failed.step} of {failed.target} failed, so {image.target} gets no tag: {failed.reason}"
        raise RosmlError(text, remedy or "correct what failed, then run it again: what was finished is kept")
    if tagged:
        index = state.index_of(image)
        held = f"its tags were moved back on {index.held[:10]}" if index and index.held else ""
        reason = state.unready(image) or held
    else:
        reason = "; ".join(state.reasons(state.by_key[image.target, architecture]))
    if reason:
        waits = (o.reason for o in run.outcomes if o.target == image.target and o.state == "waits")
        raise _no_tag(image, next(waits, reason))


def of_image(run: Run, image: Image, architecture: str, moves: list[Move] | None) -> Summary:
    """The result of a run for one image. `moves` of tags are None if the run was to move none."""
    _require_complete(run, image, architecture, tagged=moves is not None)
    state, repository = run.state, run.state.place.reference(image.repository)
    entry = state.entries[image.target, architecture]
    tags, digest, moved = list[str](), "", list[str]()
    if moves is not None and image.tags:
        tags, digest = [f"{repository}:{tag}" for tag in tags_of(image)], state.entries[image.target, INDEX].digest
        moved = [move.tag for move in moves if (move.repository, move.new) == (image.repository, digest)]
    seconds: dict[str, float] = {}
    waited: dict[str, float] = {}
    for outcome in run.outcomes:
        if outcome.seconds:
            seconds[outcome.step] = seconds.get(outcome.step, 0.0) + outcome.seconds
            waited[outcome.step] = waited.get(outcome.step, 0.0) + outcome.waited
    return Summary(
        target=image.target,
        reference=tags[0] if tags else f"{repository}@{entry.digest}",
        digest=digest,
        manifest=entry.digest,
        tags=tags,
        moved=moved,
        compressed=entry.size,
        parts=sum(state.entries[state.image_set.part_by_name[name].target, architecture].size for name in image.parts),
        unpacked=entry.unpacked,
        uploaded=run.uploaded,
        passed=entry.passed,
        failed=len(entry.failures),
        versions=dict(entry.versions),
        seconds=seconds,
        waited=waited,
        built=[it.target for it in run.outcomes if it.state == "done" and it.step in ("build", "join")],
        builder=buildx.command_on_it(state.request.services),
    )
