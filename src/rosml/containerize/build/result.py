"""What people and `--json` get of a build: images, the lock file, and a summary."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.base.units import time_taken
from rosml.containerize import lock
from rosml.containerize.build import bases
from rosml.containerize.build.bake_file import Inputs
from rosml.containerize.build.call import Call
from rosml.containerize.build.contexts import Fetched
from rosml.containerize.build.junit import Tests
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.report import TestResults
from rosml.containerize.lock import Lock
from rosml.containerize.sources.fetch import Repository

SHOWN = 3


@dataclass(frozen=True)
class Image:
    """A new image. `digest` is its digest in the registry, or its id in Docker."""

    target: str
    reference: str
    digest: str


@dataclass(frozen=True)
class ShellImage:
    """The image for `rosml dev`."""

    reference: str  # its name in Docker, or its name by digest in a registry
    loaded: bool  # into Docker
    upstream: Path | None = None  # the folder with the imported repositories


@dataclass(frozen=True)
class Result:
    base: str  # by its digest
    images: Sequence[Image]
    outcome: Outcome  # what another build from the same would repeat
    unstarted: Sequence[str] = ()  # the files of `outcome.forgotten` that the command starts
    upstream: Sequence[Repository] = ()
    downstream: Sequence[Repository] = ()
    lock: Lock | None = None
    lock_file: str = ""  # if it was written
    described: Sequence[str] = ()  # images with an SBOM and a list of files in the registry
    tests: TestResults = field(default_factory=TestResults)
    reports: str = ""  # the folder of JUnit files; empty if an earlier build passed the tests
    seconds: float = 0.0
    waited: float = 0.0  # how many of the seconds other builds had the builder

    def to_json(self) -> dict[str, Any]:
        fields = asdict(self)
        tests = fields.pop("tests")
        fields |= {"tests": tests["target"], "slim_tests": tests["slim"], "downstream_tests": tests["downstream"]}
        fields |= {"lock": self.lock.model_dump() if self.lock else None, "locked": fields.pop("lock_file")}
        del fields["outcome"]
        return fields | self.outcome.model_dump()

    def summary(self) -> Iterator[tuple[str, str]]:
        """Lines for people at the end: a subject and a sentence."""
        outcome = self.outcome
        packages = counted(len(outcome.packages), "ROS package")
        yield "app", f"{packages}, {counted(len(outcome.installed), 'package')} of apt added"
        for base, replaced in (
            ("the base image", outcome.replaced),
            ("the base image of the slim one", outcome.slim_replaced),
        ):
            if replaced:
                changes = f"its packages change {counted(len(replaced), 'thing')}: {_first(replaced)}"
                yield "", f"not joined to {base}, and rosml rebase cannot move it: {changes}"
        if outcome.outside:
            names = _first([f"/{name}" for name in outcome.outside])
            yield "", f"installed outside of the install space, and in no image: {names}"
        for subject, lines in (
            ("the run image lacks what the build has", outcome.lost),
            ("the slim image lacks what the build has", outcome.slim_lost),
            ("neither the build nor an image has", outcome.absent),
            ("the command starts what is in no image", self.unstarted),
        ):
            if lines:
                more = f"; and {len(lines) - SHOWN} more" if len(lines) > SHOWN else ""
                yield "", f"{subject}: {'; '.join(lines[:SHOWN])}{more}"
        where = f"reports: {files.shown(Path(self.reports))}" if self.reports else "in an earlier build from the same"
        tests = self.tests
        yield "tests", f"{_passed(tests.target)}; {where}" if tests.target.count else "none ran"
        if tests.slim.count:
            yield "", f"in the slim image: {_passed(tests.slim)}"
        if tests.downstream.count or self.downstream:
            yield "", f"of packages that use yours: {_passed(tests.downstream)}"
        if self.lock_file:
            yield "lock", self.lock_file
        if self.described:
            yield "sbom", f"beside {' and '.join(self.described)} in the registry"
        yield "time", time_taken(self.seconds, self.waited)


def _first(names: Sequence[str]) -> str:
    return ", ".join(names[:SHOWN]) + (" …" if len(names) > SHOWN else "")


def _passed(tests: Tests) -> str:
    return f"{tests.count - tests.skipped} passed, {tests.skipped} skipped"


def lock_of(call: Call, inputs: Inputs, outcome: Outcome, fetched: Fetched, followed_lock: Lock | None) -> Lock:
    if followed_lock and not followed_lock.lacks(call.names.platforms):
        return followed_lock  # it may have more: of another platform, or of a slim image
    slim = lock.Image(name=call.values.slim_base_image, digest=inputs.slim.digest) if inputs.slim else None
    index, rosdep = call.values.rosdep_index, None
    if inputs.rosdep and (index or call.renew):  # otherwise they change every day, and the image does not
        rosdep = lock.Image(name=index, digest=inputs.rosdep)
    parts = bases.parts(inputs.base, inputs.slim)
    return Lock(
        addons={name: reference.rpartition("@")[2] for name, reference in parts.items()} or None,
        base_image=lock.Image(name=call.values.base_image, digest=inputs.base.digest),
        slim_base_image=slim,
        rosdep_index=rosdep,
        repositories=_pins(fetched.upstream),
        downstream=_pins(fetched.downstream),
        apt=outcome.added.apt,
        pip=outcome.added.pip,
    )


def _pins(repositories: Iterable[Repository]) -> dict[str, lock.Pin]:
    return {item.path: lock.Pin(url=item.url, version=item.version, commit=item.commit) for item in repositories}


def write_lock(call: Call, new_lock: Lock, inputs: Inputs) -> str:
    """Writes the lock file, if the call asks for it. Says which of its packages are lost. Returns its path."""
    if not call.renew:
        return ""
    try:
        replaced_lock = lock.read(call.lock_file, call.folder)
    except RosmlError as error:
        call.say(f"written again: {error.message}")
        replaced_lock = None
    if replaced_lock:
        new_lock = new_lock.with_other_architectures(replaced_lock)
        if lost := sorted(replaced_lock.apt.keys() - new_lock.apt.keys()):
            call.say(f"the lock file has no packages for {', '.join(lost)} any more: name all platforms at once")
    files.write(call.lock_file, new_lock.text(), within=call.folder)
    if inputs.base.adopted:
        text = "it has no versions of the ROS that was installed on the base image: keep that image with --cache"
        call.say(f"{call.lock_file}: {text}")
    return str(call.lock_file)
