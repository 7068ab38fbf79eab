"""Builds, joins and tests images for a publishing run.

The run itself decides what is due, writes the records, and moves tags.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Protocol

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.builds import base_images, contents, disk, package_state, structure_tests
from rosml.images.builds.part import PartBuilder
from rosml.images.builds.push import Push, push, push_together, write_excerpt
from rosml.images.builds.variables import base, sync_dates, variables
from rosml.images.image_set import missing_locks
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.image_set.restricted import Declared
from rosml.images.join.joiner import Joiner
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry.oci import Manifest
from rosml.registry.place import Place
from rosml.registry.references import Reference

OUTPUT_LINES = 8
"""How many lines of each failed test are kept: the last ones, which say why."""


@dataclass(frozen=True)
class NewImage:
    """A part or an image in the registry."""

    digest: str  # of its manifest
    parts: Mapping[str, str] = field(default_factory=dict)  # digests of the images and parts below it, by target
    package_state: str = ""  # state of the repositories that its packages came from; empty if it does not depend on any
    base: str = ""  # reference of the base image that it starts from; empty if it starts from one of its parts
    sbom: str = ""  # digest of the artifact with its SBOM; empty for a joined image


@dataclass(frozen=True)
class Verdict:
    """The result of an image's structure tests."""

    passed: int = 0
    failures: tuple[str, ...] = ()
    unpacked: int = 0  # bytes of the image's root file system; 0 if unknown
    versions: Mapping[str, str] = field(default_factory=dict)  # of packages and programs in the image
    output: str = ""  # the last lines of each failed test, below its name


@dataclass(frozen=True)
class BuildRequest:
    """A part or a ROS image to build; `parts` and `packages` are those of `Maker.build_image`."""

    thing: Image | Part
    architecture: str
    parts: Mapping[str, str] = field(default_factory=dict)
    packages: str = ""

    @property
    def key(self) -> tuple[str, str]:
        return self.thing.target, self.architecture


def require_buildable(image: Image, architecture: str) -> None:
    """Checks, before anything is set up, that an image can be built for an architecture."""
    # Tags cover all platforms, and need all locks. A build for another platform needs only its own lock.
    native = base_images.native_architecture()
    if missing_locks.on(image, architecture) or (image.unlocked and architecture == native):
        text = f"{image.target} cannot be built yet: {missing_locks.reason(image)}"
        raise RosmlError(text, missing_locks.remedy(image), exit_code=2)
    if architecture not in image.architectures:
        raise RosmlError(
            f"{image.target} exists for {listed(image.architectures)} only"
            + (f", and this machine is {native}" if architecture == native else ""),
            "use such a machine, or choose another target: rosml list",
            exit_code=2,
        )


class Maker(Protocol):
    """Makes images and parts for one architecture at a time, and pushes them by digest. It moves no tag."""

    def build_part(self, part: Part, architecture: str) -> NewImage:
        """Builds a part from its lock, and pushes it."""

    def build_image(self, image: Image, architecture: str, parts: Mapping[str, str], packages: str) -> NewImage:
        """Builds a ROS image on the one below it, by its digest, and pushes it. `packages` is the state of the package repositories."""

    def build_together(self, requests: Sequence[BuildRequest]) -> None:
        """Builds and describes what needs nothing of each other at once. `build_part` and `build_image` return it, or raise its error."""

    def describe(self, thing: Image | Part, digest: str) -> str:
        """Attaches the list of files, the facts and the SBOM to a pushed ROS image or part. Returns the SBOM's digest."""

    def join(self, image: Image, architecture: str, parts: Mapping[str, str]) -> str:
        """Joins a ROS image and parts, in this order, by their digests. Returns the digest of the manifest."""

    def test(
        self, image: Image, architecture: str, digest: str, parts: Mapping[str, str], names: tuple[str, ...]
    ) -> Verdict:
        """Runs structure tests of an image, by the names of their files. Failed tests are no error."""


@dataclass
class BuildKitMaker:
    """Builds and tests in the builder, and joins in the registry."""

    services: Services
    image_set: ImageSet
    place: Place
    say: Callable[[str], None]
    force: bool = False
    forecast: ImageSet | None = None  # the image set with measured sizes; the matrix's sizes count if None
    _present: set[str] = field(default_factory=set)  # names of the parts and targets that the builder has
    _pushed: dict[tuple[str, str], tuple[str, str]] = field(default_factory=dict)
    """The base image and the digest of each thing that `build_together` built, by target and architecture."""
    _sboms: dict[str, str] = field(default_factory=dict)
    """Digests of the SBOMs that `build_together` attached, by digest of the manifest."""

    def build_part(self, part: Part, architecture: str) -> NewImage:
        start, digest = self._push(BuildRequest(part, architecture))
        return NewImage(digest, base=start, sbom=self._describe(part, digest))

    def build_image(self, image: Image, architecture: str, parts: Mapping[str, str], packages: str) -> NewImage:
        start, digest = self._push(BuildRequest(image, architecture, parts, packages))
        return NewImage(digest, parts, packages, "" if parts else start, self._describe(image, digest))

    def build_together(self, requests: Sequence[BuildRequest]) -> None:
        """Builds what one call can build: with the same values of the bake file's variables, such as the base images."""
        values: dict[str, str] = {}
        pushes: dict[tuple[str, str], tuple[str, Push]] = {}
        for request in requests:
            try:
                start, it = self._call(request)
            except RosmlError:  # its own call raises it again
                continue
            if all(values.get(key, value) == value for key, value in it.call.variables.items()):
                values |= it.call.variables
                pushes[request.key] = start, it
        if len(pushes) < 2:
            return
        self._make_room_for(*(request for request in requests if request.key in pushes))
        targets = [target for target, _ in pushes]
        self.say(f"build {listed(targets)} at once")
        file = write_excerpt(self.services, self.image_set, *targets)
        name = f"build-{'-'.join(dict.fromkeys(architecture for _, architecture in pushes))}-together"
        try:
            digests = push_together(self.services, [it for _, it in pushes.values()], file, name)
        except RosmlError as error:
            self.say(f"{error.message}\nnow one after the other")
            return
        self._pushed |= {key: (start, digests[it.call.target]) for key, (start, it) in pushes.items()}
        things = {request.key: request.thing for request in requests}
        images = [(self.place.path(things[key].repository), self._pushed[key][1]) for key in pushes]
        with suppress(RosmlError):  # `_describe` tries each alone, and says why it fails
            self._sboms |= contents.attach(self.services, self.image_set, self.place.client, images, self.say)

    def _push(self, request: BuildRequest) -> tuple[str, str]:
        """Builds and pushes a part or an image, unless `build_together` did."""
        if pair := self._pushed.pop(request.key, None):
            return pair
        start, it = self._call(request)
        self._make_room_for(request)
        return start, push(self.services, it)

    def _call(self, request: BuildRequest) -> tuple[str, Push]:
        """The reference of the base image, and the push of a part or an image."""
        if isinstance(request.thing, Image):
            start, call = self._call_of_image(request.thing, request)
        else:
            builder = PartBuilder(self.services, self.image_set, str(self.place), self.say, self.force)
            assembler, call = builder.bake(request.thing, [self._platform(request.architecture)])
            start = assembler.reference
        repository = self.place.reference(request.thing.repository)
        return start, Push(call, repository, self.image_set.matrix.compression)

    def _call_of_image(self, image: Image, request: BuildRequest) -> tuple[str, buildx.Bake]:
        architecture, packages = request.architecture, request.packages
        self._require_builder(architecture)
        values = self.variables(image, architecture, package_state.ros_date(packages))
        values |= {"DIGESTS": json.dumps(request.parts)}
        sets = [f"{image.target}.tags="]
        # The first component is built with its parent, the essentials, which are packages of the operating system.
        installing = [image.target] if request.parts else [image.parent, image.target]
        if self.force:
            sets += [f"{target}.no-cache=true" for target in installing]
        elif packages:  # makes the builder install the packages again after they moved, which it cannot know itself
            folder = self._changes_with(image, packages)
            sets += [f"{target}.contexts.upstream={folder}" for target in installing]
        file = write_excerpt(self.services, self.image_set, image.target)
        name = f"build-{image.target}-{architecture}"
        return base(image, values), buildx.Bake(image.target, name, file, tuple(sets), values, shares=buildx.IMAGES)

    def describe(self, thing: Image | Part, digest: str) -> str:
        self._make_room(thing.disk.unpacked + thing.disk.compressed, thing.target)
        return self._describe(thing, digest)

    def join(self, image: Image, architecture: str, parts: Mapping[str, str]) -> str:
        """Joins an image by its manifest. No layer in the registry is read or sent."""
        registry = self.place.client
        ros, *others = (
            Reference(registry.host, self.place.path(self._repositories[target]), digest)
            for target, digest in parts.items()
        )
        return self._joiner.manifest(ros, others, registry.host, self.place.path(image.repository)).digest

    def test(
        self, image: Image, architecture: str, digest: str, parts: Mapping[str, str], names: tuple[str, ...]
    ) -> Verdict:
        """Tests the layers of an image's manifest. The builder joins a joined image from its parts, and so unpacks each part once."""
        self._require_builder(architecture)
        path = self.place.path(image.repository)
        manifest = self.place.client.manifest(path, digest)
        if manifest is None:
            raise RosmlError(f"{image.target} is not in the registry any more", "run it again")
        if image.stack:
            self._require_same_layers(image, parts, manifest)
        digests = self._digests(parts) if image.stack else {image.target: digest}
        values = self.variables(image, architecture) | {"DIGESTS": json.dumps(digests)}
        file = write_excerpt(self.services, self.image_set, image.target, image.test_target)
        room = disk.tested_mb(self._sizes, image, self._present)
        self._make_room(room, *image.parts, image.parent, *([] if image.stack else [image.target]))
        config = self.place.client.config(path, manifest).content
        subject = structure_tests.Subject(image, architecture, config, _budgeted_bytes(image, manifest))
        report, folder = structure_tests.run(self.services, subject, file, values, names)
        failures = tuple(f"{outcome.file}: {outcome.name}" for outcome in report.failed)
        if failures:
            self.say(
                f"{len(failures)} of {len(report.outcomes)} structure tests of {image.target} failed; it gets no tag\n"
                f"{report.failures()}\n  all reports: {folder}\n"
                f"  the image that failed: {self.place.reference(image.repository, digest)}"
            )
        return Verdict(report.passed, failures, report.unpacked, report.versions, report.failures(OUTPUT_LINES))

    def variables(self, image: Image, architecture: str, date: str = "") -> dict[str, str]:
        values = variables(self.services, self.image_set, image, architecture, str(self.place))
        return values | sync_dates(self.services, self.image_set, image.distribution, self.say, date)

    @property
    def _sizes(self) -> ImageSet:
        return self.forecast or self.image_set

    def _make_room_for(self, *requests: BuildRequest) -> None:
        needed, coming = 0, set[str]()
        for thing in (request.thing for request in requests):
            if isinstance(thing, Image):
                needed += disk.needed_mb(self._sizes, thing, self._present)
                coming |= {thing.parent, thing.target}
            else:
                needed += disk.part_mb(thing)
                coming.add(thing.name)
        self._make_room(needed, *coming)

    def _make_room(self, needed: int, *coming: str) -> None:
        """Makes room of some megabytes for a build, after which the builder has the `coming` parts and targets."""
        if disk.make_room(self.services, needed, self.say):
            self._present.clear()
        self._present.update(coming)

    @cached_property
    def _joiner(self) -> Joiner:
        declared = Declared.of(self.image_set.matrix)
        return Joiner(lambda _: self.place.client, say=self.say, declared=lambda: declared)

    @cached_property
    def _repositories(self) -> dict[str, str]:
        """By target, without the prefix."""
        things: list[Image | Part] = [*self.image_set.images, *self.image_set.parts]
        return {thing.target: thing.repository for thing in things}

    def _platform(self, architecture: str) -> str:
        return self.image_set.matrix.architectures[architecture].platform

    def _require_builder(self, architecture: str) -> None:
        """Checks that the builder is up, and can run programs of an architecture."""
        native = architecture == base_images.native_architecture()
        self.services.require_builder("" if native else self._platform(architecture))

    def _describe(self, thing: Image | Part, digest: str) -> str:
        if sbom := self._sboms.pop(digest, ""):
            return sbom
        image = self.place.path(thing.repository), digest
        return contents.attach(self.services, self.image_set, self.place.client, [image], self.say)[digest]

    def _changes_with(self, image: Image, packages: str) -> Path:
        """A folder that changes with the state of a distribution's package repositories, for the builder's cache."""
        folder = self.services.state / "package-state" / image.distribution
        folder.mkdir(parents=True, exist_ok=True)
        files.write(
            folder / "moment", packages + "\n"
        )  # the cache's keys contain the file's name, so it stays "moment"
        return folder

    def _digests(self, parts: Mapping[str, str]) -> dict[str, str]:
        """Digests by name, as the bake file's variable DIGESTS needs them."""
        part_names = {part.target: part.name for part in self.image_set.parts}
        return {part_names.get(target, target): digest for target, digest in parts.items()}

    def _require_same_layers(self, image: Image, parts: Mapping[str, str], manifest: Manifest) -> None:
        """Checks that a joined image has exactly the layers of its parts, since the tests use these."""
        layers: list[str] = []
        for target, digest in parts.items():
            part = self.place.client.manifest(self.place.path(self._repositories[target]), digest)
            layers += [layer.digest for layer in part.layers] if part else []
        if layers != [layer.digest for layer in manifest.layers]:
            raise RosmlError(f"{image.target} does not consist of its parts' layers", "join it again: --force")


def _budgeted_bytes(image: Image, manifest: Manifest) -> int:
    """Bytes of the parts that count for an image's budget: each part is one of its last layers."""
    sizes = [layer.size for layer in manifest.layers][-len(image.parts) :]
    return sum(size for part, size in zip(image.parts, sizes, strict=False) if part in image.budgeted)
