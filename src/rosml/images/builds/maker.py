"""Builds, joins and tests images for a publishing run.

`Maker` is the interface for the run. It pushes results into the registry by digest. `BuildKitMaker` implements it with
the builder. The run itself decides what is due, writes the records, and moves tags.
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
from rosml.images.builds import part as parts
from rosml.images.builds.push import push_together, pushed, pushing, write_excerpt
from rosml.images.builds.variables import base, variables
from rosml.images.image_set import missing
from rosml.images.image_set.model import Image, ImageSet, Part, repository_of
from rosml.images.image_set.restricted import Declared
from rosml.images.join.joiner import Joiner
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry.oci import Manifest
from rosml.registry.place import Place
from rosml.registry.references import Reference

SAID = 8
"""How many lines of each failed test are kept: the last ones, which say why."""


@dataclass(frozen=True)
class Made:
    """The result of building an image or part.

    Attributes:
        digest: of its manifest.
        parts: digests of the images and parts below it, by target.
        package_state: state of the repositories that its packages came from; empty if it does not depend on any.
        base: reference of the base image that it starts from; empty if it starts from one of its parts.
        sbom: digest of the artifact with its SBOM; empty for a joined image.
    """

    digest: str
    parts: Mapping[str, str] = field(default_factory=dict)
    package_state: str = ""
    base: str = ""
    sbom: str = ""


@dataclass(frozen=True)
class Checked:
    """The result of an image's structure tests.

    Attributes:
        passed: how many tests passed.
        failures: the tests that failed.
        unpacked: bytes of the image's root file system; 0 if unknown.
        versions: of packages and programs found in the image.
        said: the last lines of each failed test, below its name.
    """

    passed: int = 0
    failures: tuple[str, ...] = ()
    unpacked: int = 0
    versions: Mapping[str, str] = field(default_factory=dict)
    said: str = ""


@dataclass(frozen=True)
class Wanted:
    """What to build.

    Attributes:
        thing: a part or a ROS image.
        architecture: to build for.
        parts, packages: of an image, as for `Maker.build_image`.
    """

    thing: Image | Part
    architecture: str
    parts: Mapping[str, str] = field(default_factory=dict)
    packages: str = ""

    @property
    def key(self) -> tuple[str, str]:
        """What it is called in the records."""
        return self.thing.target, self.architecture


def require_buildable(image: Image, architecture: str) -> None:
    """Checks, before anything is set up, that an image can be built for an architecture.

    Raises:
        RosmlError: a lock is missing, or the image does not exist for the architecture (exit code 2).
    """
    # Tags cover all platforms, and need all locks. A build for another platform needs only its own lock.
    native = base_images.native_architecture()
    if missing.on(image, architecture) or (image.unlocked and architecture == native):
        text = f"{image.target} cannot be built yet: {missing.reason(image)}"
        raise RosmlError(text, missing.remedy(image), exit_code=2)
    if architecture not in image.architectures:
        raise RosmlError(
            f"{image.target} exists for {listed(image.architectures)} only"
            + (f", and this machine is {native}" if architecture == native else ""),
            "use such a machine, or choose another target: rosml list",
            exit_code=2,
        )


class Maker(Protocol):
    """Makes images and parts for one architecture at a time, and pushes them by digest. It moves no tag.

    Every method raises RosmlError if it fails.
    """

    def build_part(self, part: Part, architecture: str) -> Made:
        """Builds a part from its lock, and pushes it."""

    def build_image(self, image: Image, architecture: str, parts: Mapping[str, str], packages: str) -> Made:
        """Builds a ROS image, and pushes it.

        Args:
            image: the ROS image.
            architecture: to build for.
            parts: digest of the image below it, by target; none for the first component, which starts from the base
                image.
            packages: the state of the package repositories; empty if the image does not depend on any.
        """

    def build_together(self, wanted: Sequence[Wanted]) -> None:
        """Builds and describes ROS images and parts that need nothing of each other, all at once. `build_part` and `build_image` then find
        them.

        If one of them cannot be built, `build_part` or `build_image` says so.
        """

    def describe(self, thing: Image | Part, digest: str) -> str:
        """Attaches to a pushed ROS image or part what belongs beside it: list of files, facts, SBOM. What is there stays.
        Gives the digest of the SBOM.

        Args:
            thing: the ROS image or part.
            digest: of its manifest.
        """

    def join(self, image: Image, architecture: str, parts: Mapping[str, str]) -> str:
        """Joins a ROS image and parts in the registry; gives the digest of the manifest.

        Args:
            image: the joined image.
            architecture: to join for.
            parts: digests by target: first the ROS image, then the parts.
        """

    def test(
        self, image: Image, architecture: str, digest: str, parts: Mapping[str, str], names: tuple[str, ...]
    ) -> Checked:
        """Runs structure tests of an image. Failed tests are no error.

        Args:
            image: the image.
            architecture: to test on.
            digest: of the image's manifest.
            parts: digests of the images and parts below it, by target.
            names: of the tests' files.
        """


@dataclass
class BuildKitMaker:
    """Builds and tests in the builder, and joins in the registry.

    Attributes:
        services: the builder and the registry of this checkout.
        image_set: all that the matrix describes.
        place: where images go.
        say: prints a line of progress.
        force: whether to build without the builder's cache.
        forecast: the image set with measured sizes; the matrix's sizes count if None.
    """

    services: Services
    image_set: ImageSet
    place: Place
    say: Callable[[str], None]
    force: bool = False
    forecast: ImageSet | None = None
    _there: set[str] = field(default_factory=set)  # names of the parts and targets that the builder has
    _pushed: dict[tuple[str, str], tuple[str, str]] = field(default_factory=dict)
    """The base and the digest of what `build_together` made, by target and architecture."""
    _sboms: dict[str, str] = field(default_factory=dict)
    """Digests of the SBOMs of what `build_together` made, by digest of the manifest."""

    def build_part(self, part: Part, architecture: str) -> Made:
        """Builds a part from its lock."""
        start, digest = self._push(Wanted(part, architecture))
        return Made(digest, base=start, sbom=self._describe(part, digest))

    def build_image(self, image: Image, architecture: str, parts: Mapping[str, str], packages: str) -> Made:
        """Builds a ROS image on the image below it, which it takes from the registry."""
        start, digest = self._push(Wanted(image, architecture, parts, packages))
        return Made(digest, parts, packages, "" if parts else start, self._describe(image, digest))

    def build_together(self, wanted: Sequence[Wanted]) -> None:
        """Builds what one call can build: with the same values of the bake file's variables, such as the base images."""
        values: dict[str, str] = {}
        calls: dict[tuple[str, str], tuple[str, buildx.Bake]] = {}
        for one in wanted:
            try:
                start, call = self._call(one)
            except RosmlError:  # said when its turn comes
                continue
            if all(values.get(key, value) == value for key, value in call.variables.items()):
                values |= call.variables
                calls[one.key] = start, call
        if len(calls) < 2:
            return
        self._make_room_for(*(one for one in wanted if one.key in calls))
        targets = [target for target, _ in calls]
        self.say(f"build {listed(targets)} at once")
        file = write_excerpt(self.services, self.image_set, *targets)
        name = f"build-{'-'.join(dict.fromkeys(architecture for _, architecture in calls))}-together"
        try:
            digests = push_together(self.services, [call for _, call in calls.values()], file, name)
        except RosmlError as error:
            self.say(f"{error.message}\nnow one after the other")
            return
        self._pushed |= {key: (start, digests[call.target]) for key, (start, call) in calls.items()}
        images = [
            (self.place.path(repository_of(one.thing)), self._pushed[one.key][1]) for one in wanted if one.key in calls
        ]
        with suppress(RosmlError):  # `_describe` tries each alone, and says why it fails
            self._sboms |= contents.attach(self.services, self.image_set, self.place.client, images, self.say)

    def _push(self, wanted: Wanted) -> tuple[str, str]:
        """Builds and pushes a part or an image, unless that was done together with others. Gives the reference of its base image and
        its digest."""
        if made := self._pushed.pop(wanted.key, None):
            return made
        start, call = self._call(wanted)
        self._make_room_for(wanted)
        _, metadata = buildx.run(self.services, call)
        return start, pushed(call, metadata)

    def _call(self, wanted: Wanted) -> tuple[str, buildx.Bake]:
        """The call that builds and pushes a part or an image, and the reference of its base image."""
        if isinstance(wanted.thing, Image):
            start, call = self._call_of_image(wanted.thing, wanted)
        else:
            prefix, platforms = str(self.place), [self._platform(wanted.architecture)]
            under, call = parts.bake(
                self.services, self.image_set, wanted.thing, self.say, prefix, platforms, self.force
            )
            start = under.reference
        return start, pushing(call, self.place.reference(repository_of(wanted.thing)))

    def _call_of_image(self, image: Image, wanted: Wanted) -> tuple[str, buildx.Bake]:
        architecture, packages = wanted.architecture, wanted.packages
        self._require_builder(architecture)
        given = self.variables(image, architecture, package_state.ros_date(packages))
        given |= {"DIGESTS": json.dumps(wanted.parts)}
        sets = [f"{image.target}.tags="]
        # The first component is built with its parent, the essentials, which are packages of the operating system.
        installing = [image.target] if wanted.parts else [image.parent, image.target]
        if self.force:
            sets += [f"{target}.no-cache=true" for target in installing]
        elif packages:  # makes the builder install the packages again after they moved, which it cannot know itself
            folder = self._changes_with(image, packages)
            sets += [f"{target}.contexts.upstream={folder}" for target in installing]
        bake_file = write_excerpt(self.services, self.image_set, image.target)
        name = f"build-{image.target}-{architecture}"
        return base(image, given), buildx.Bake(image.target, name, bake_file, tuple(sets), given, shares=buildx.IMAGES)

    def describe(self, thing: Image | Part, digest: str) -> str:
        """Has the builder list what is in a pushed ROS image or part, and attaches that."""
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
    ) -> Checked:
        """Tests an image in a root file system of the layers in its manifest.

        The builder takes a ROS image by its digest. It joins a joined image from the same parts by their digests. The
        layers are the same, and the builder needs to unpack each part only once, not for each image.
        """
        self._require_builder(architecture)
        manifest = self.place.client.manifest(self.place.path(image.repository), digest)
        if manifest is None:
            raise RosmlError(f"{image.target} is not in the registry any more", "run it again")
        sizes = [layer.size for layer in manifest.layers]
        if image.stack:
            self._require_same_layers(image, parts, manifest)
        digests = self._digests(parts) if image.stack else {image.target: digest}
        given = self.variables(image, architecture) | {"DIGESTS": json.dumps(digests)}
        file = write_excerpt(self.services, self.image_set, image.target, image.test_target)
        reference = self.place.reference(image.repository, digest)
        of_parts = zip(image.parts, sizes[-len(image.parts) :], strict=False)
        size = sum(size for part, size in of_parts if part in image.budgeted)
        room = disk.tested_mb(self._sizes, image, self._there)
        self._make_room(room, *image.parts, image.parent, *([] if image.stack else [image.target]))
        config = self.place.client.config(self.place.path(image.repository), manifest).content
        report, folder = structure_tests.run(self.services, image, architecture, config, file, given, names, size)
        failures = tuple(f"{outcome.file}: {outcome.name}" for outcome in report.failed)
        if failures:
            self.say(
                f"{len(failures)} of {len(report.outcomes)} structure tests of {image.target} failed; it gets no tag\n"
                f"{report.failures()}\n  all reports: {folder}\n  the image that failed: {reference}"
            )
        return Checked(report.passed, failures, report.unpacked, report.versions, report.failures(SAID))

    def variables(self, image: Image, architecture: str, date: str = "") -> dict[str, str]:
        """Variables of the bake file for an image; see `builds/variables.py`."""
        return variables(self.services, self.image_set, image, architecture, str(self.place), self.say, date)

    @property
    def _sizes(self) -> ImageSet:
        return self.forecast or self.image_set

    def _make_room_for(self, *wanted: Wanted) -> None:
        """Makes room to build parts and ROS images."""
        needed, coming = 0, set[str]()
        for thing in (one.thing for one in wanted):
            if isinstance(thing, Image):
                needed += disk.needed_mb(self._sizes, thing, self._there)
                coming |= {thing.parent, thing.target}
            else:
                needed += disk.part_mb(thing)
                coming.add(thing.name)
        self._make_room(needed, *coming)

    def _make_room(self, needed: int, *coming: str) -> None:
        """Makes room for a build.

        Args:
            needed: megabytes.
            coming: names of the parts and targets that the builder will have after it.
        """
        if disk.make_room(self.services, needed, self.say):
            self._there.clear()
        self._there.update(coming)

    @cached_property
    def _joiner(self) -> Joiner:
        """Joins images. It reads each part once."""
        declared = Declared.of(self.image_set.matrix)
        return Joiner(lambda _: self.place.client, say=self.say, declared=lambda: declared)

    @cached_property
    def _repositories(self) -> dict[str, str]:
        """Repositories of images and parts by target, without the prefix."""
        things: list[Image | Part] = [*self.image_set.images, *self.image_set.parts]
        return {thing.target: repository_of(thing) for thing in things}

    def _platform(self, architecture: str) -> str:
        return self.image_set.matrix.architectures[architecture].platform

    def _require_builder(self, architecture: str) -> None:
        """Checks that the builder is up, and can run programs of an architecture."""
        native = architecture == base_images.native_architecture()
        self.services.require_builder("" if native else self._platform(architecture))

    def _describe(self, thing: Image | Part, digest: str) -> str:
        if sbom := self._sboms.pop(digest, ""):
            return sbom
        image = self.place.path(repository_of(thing)), digest
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
        known = {part.target: part.name for part in self.image_set.parts}
        return {known.get(target, target): digest for target, digest in parts.items()}

    def _require_same_layers(self, image: Image, parts: Mapping[str, str], manifest: Manifest) -> None:
        """Checks that a joined image has exactly the layers of its parts, since the tests use these.

        Raises:
            RosmlError: it has other layers.
        """
        layers: list[str] = []
        for target, digest in parts.items():
            found = self.place.client.manifest(self.place.path(self._repositories[target]), digest)
            layers += [layer.digest for layer in found.layers] if found else []
        if layers != [layer.digest for layer in manifest.layers]:
            raise RosmlError(f"{image.target} does not consist of its parts' layers", "join it again: --force")
