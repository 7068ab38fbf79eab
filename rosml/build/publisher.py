"""One image, all the way: base image, build, push by digest, structure tests, index, tags.

The order is what makes tags trustworthy: a tag moves only after the very digest that it will point at passed its
tests. Interrupted at any point, nothing is tagged; the builder and the registry keep what was finished, and the next
call carries on from there.
"""

from __future__ import annotations

import json
import shlex
import shutil
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.base.problems import listed, unknown
from rosml.build import structure_tests, sync
from rosml.build.push import push_by_digest, write_excerpt
from rosml.images import apt_source, missing
from rosml.images.image_set import Catalogue, Image, tags_of
from rosml.images.labels import OCI
from rosml.machine import base_images, buildx, disk, regctl
from rosml.machine.progress import Step
from rosml.machine.services import NAMESPACE, Services
from rosml.matrix import names


@dataclass
class Result:
    """What publishing one image came to.

    Attributes:
        target: the bake target.
        reference: what to put after FROM: the main tag.
        tags: all references that point at the image.
        digest: digest of the index behind the tags; manifest: of the image manifest that was tested.
        moved: tags that pointed elsewhere, or nowhere, before.
        compressed, unpacked: bytes.
        payloads: bytes of `compressed` that are payloads, which images of a stack share.
        uploaded: bytes that this call added to the registry.
        passed, failed: structure tests. versions: of what was found inside.
        seconds: wall time by phase, in order.
        work: seconds of the builder's work by kind of step.
        reused: what was there already.
        base: where the base images came from.
        builder: the command that builds a Dockerfile on top of it with the same builder.
    """

    target: str
    reference: str = ""
    tags: list[str] = field(default_factory=list)
    digest: str = ""
    manifest: str = ""
    moved: list[str] = field(default_factory=list)
    compressed: int = 0
    payloads: int = 0
    unpacked: int = 0
    uploaded: int = 0
    passed: int = 0
    failed: int = 0
    versions: dict[str, str] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)
    work: dict[str, float] = field(default_factory=dict)
    reused: list[str] = field(default_factory=list)
    base: str = ""
    builder: str = ""

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


class TestsFailed(RosmlError):
    """Structure tests failed: no tag was moved."""

    __test__ = False  # its name does not make it a test

    def __init__(self, result: Result, report: structure_tests.Report, folder: Path) -> None:
        self.result = result
        self.names = tuple(f"{outcome.file}: {outcome.name}" for outcome in report.failed)
        lines = [f"    {outcome.file}: {outcome.name}\n{_indent(outcome.detail)}" for outcome in report.failed]
        super().__init__(
            f"{len(report.failed)} of {len(report.outcomes)} structure tests of {result.target} failed; no tag was moved\n"
            + "\n".join(lines)
            + f"\n  all reports: {folder}",
            f"mend the component or the test, then run it again; the untested image stays at {result.manifest}",
        )


def require_buildable(image: Image, architecture: str = "") -> None:
    """Checks, before anything is set up, that an image can be built for an architecture; the machine's own if empty.

    Raises:
        RosmlError: a lock is missing (exit code 2).
    """
    # Tags are for all platforms, and need all locks; one platform alone needs its own.
    if any(lock.split("/")[2] == architecture for lock in image.unlocked) or (image.unlocked and not architecture):
        text = f"{image.target} cannot be built yet: {missing.reason(image)}"
        raise RosmlError(text, missing.remedy(image), exit_code=2)
    native = base_images.native_architecture()
    if (architecture or native) not in image.architectures:
        raise RosmlError(
            f"{image.target} exists for {listed(image.architectures)} only"
            + ("" if architecture else f", and this machine is {native}"),
            "use such a machine, or another target: make list",
            exit_code=2,
        )


def architecture_of(catalogue: Catalogue, platform: str) -> str:
    """The architecture of a platform such as `linux/arm64`.

    Raises:
        RosmlError: the matrix has no such platform (exit code 2).
    """
    known = {facts.platform: name for name, facts in catalogue.matrix.architectures.items()}
    if platform not in known:
        raise RosmlError(unknown("platform", platform, known), f"take one of {listed(list(known))}", exit_code=2)
    return known[platform]


def turn_file(services: Services, target: str, architecture: str) -> Path:
    """What calls in one checkout wait for that build or test an image, or assemble a payload, for an architecture."""
    native = architecture == base_images.native_architecture()
    return services.state / "turns" / (target if native else f"{target}-{architecture}")


@dataclass
class Publisher:
    """Publishes images of a catalogue into the local registry.

    Attributes:
        services: registry and builder.
        catalogue: all that the matrix describes.
        say: told what is going on, a line at a time.
        namespace: first part of the repositories' names.
        architecture: what to build for. An image for another architecture than the machine's own is built and tested
            under emulation, and gets no tag: a tag is for all of an image's platforms.
        host: the registry; the local one if empty.
    """

    services: Services
    catalogue: Catalogue
    say: Callable[[str], None]
    namespace: str = NAMESPACE
    architecture: str = field(default_factory=base_images.native_architecture)
    host: str = ""

    @property
    def native(self) -> bool:
        """Whether it builds for the machine's own architecture."""
        return self.architecture == base_images.native_architecture()

    @property
    def prefix(self) -> str:
        """Value of the bake variable REGISTRY."""
        return f"{self.host or self.services.registry}/{self.namespace}".rstrip("/")

    def publish(self, target: str) -> Result:
        """Builds, tests and tags one image.

        Raises:
            RosmlError: unknown target, no room, a service is down, the build failed.
            TestsFailed: the structure tests failed; tags are where they were.
        """
        image = self.catalogue.image(target)
        target = image.target  # a tag is a name as well
        apt_source.source(self.catalogue.matrix, image.distribution)  # a channel that there is not is told first
        require_buildable(image, "" if self.native else self.architecture)
        self.services.require_registry()
        platform = self.catalogue.matrix.architectures[self.architecture].platform
        self.services.require_builder("" if self.native else platform)
        built = disk.Built(self.services.state)
        disk.require(
            self.services.state, disk.needed_mb(self.catalogue, image, built.names() if self.native else ()), target
        )
        with turn(
            turn_file(self.services, target, self.architecture),
            lambda: self.say(f"waiting for another call that builds or tests {target}"),
        ):
            return self._publish(image, built)

    def _publish(self, image: Image, built: disk.Built) -> Result:
        target = image.target
        result = Result(target)
        clock = _Clock(result.seconds)

        self.say("base image")
        variables = self.variables(image, result)
        bake_file = self._bake_file(image)
        clock.lap("base image")

        self.say(f"build {target} and push it by digest")
        self._build(image, bake_file, variables, result)
        if self.native:
            built.add([target, image.parent, *image.parts])
        clock.lap("build and push")

        self.say("structure tests, inside the image")
        config = self.test(image, bake_file, variables, result)
        clock.lap("structure tests")

        if not self.native:
            result.reference = f"{self.prefix}/{image.repository}@{result.manifest}"
            result.builder = builder_command(self.services)
            return result
        self.say("index and tags")
        self._tag(image, config, result)
        clock.lap("index and tags")
        return result

    def _bake_file(self, image: Image) -> Path:
        """The part of the bake file that an image and its tests need."""
        return write_excerpt(self.services, self.catalogue, image.target, image.test_target)

    def variables(self, image: Image, result: Result, moment: str = "") -> dict[str, str]:
        """Variables of the bake file: the registry, the platform, of when ROS's apt repository is, and where base images
        are, which are made if need be.

        Args:
            image: what is to be built.
            result: what the image starts from is noted there.
            moment: of when ROS's apt repository is taken to be: the build fails where it is of another time by then. It
                is asked if nothing is said.
        """
        assembled_on = {self.catalogue.payload_by_name[name].os for name in image.parts}
        systems = self.catalogue.matrix.operating_systems
        assembler = self.catalogue.matrix.default.assembler
        variables = {
            "REGISTRY": self.prefix,
            "PLATFORM": self.catalogue.matrix.architectures[self.architecture].platform,
        }
        for name in sorted({image.os, assembler} | assembled_on):
            reference = base_images.ensure(self.services, systems[name], self.architecture, self.say)
            variables[names.os_variable(name)] = f"docker-image://{reference}"
            if name == image.os:
                made = "made with mmdebstrap, because Docker Hub does not answer"
                result.base = f"{reference} ({made if self.services.mirror else 'the official image'})"
        return variables | self._sync_date(image, moment)

    def _sync_date(self, image: Image, moment: str) -> dict[str, str]:
        """The bake variable that says of when ROS's apt repository is: a new state of it is installed anew."""
        source = apt_source.source(self.catalogue.matrix, image.distribution)
        if source is None:
            return {}
        if moment:
            return {"ROS_SYNC_DATES": json.dumps({image.distribution: moment})}
        try:
            day = sync.published(source)
            sync.remember(self.services.state, source, day)
        except RosmlError as error:  # what the builder has of it may be enough
            if error.exit_code == 2:
                raise
            day = sync.remembered(self.services.state, source)
            self.say(f"{error.message}; taken for as it was last time: {day or 'never asked'}")
        self.say(f"ROS's apt repository {source.address}, published {day or 'nobody knows when'}")
        return {"ROS_SYNC_DATES": json.dumps({image.distribution: day})}

    def _build(self, image: Image, bake_file: Path, variables: dict[str, str], result: Result) -> None:
        repository = f"{self.prefix}/{image.repository}"
        sets = (f"{image.target}.tags=",)
        before = stored_blobs(self.services.state / "registry")
        progress, result.manifest = push_by_digest(
            self.services, buildx.Bake(image.target, f"build-{image.target}", bake_file, sets, variables), repository
        )
        result.work.update(progress.phases())
        result.reused = _reused(progress.reused())
        layers = regctl.layers(self.services, f"{repository}@{result.manifest}")
        sizes = [layer.size for layer in layers]
        result.compressed = sum(sizes)
        result.uploaded = sum(layer.size for layer in layers if layer.digest.removeprefix("sha256:") not in before)
        result.payloads = sum(sizes[-len(image.parts) :]) if image.parts else 0

    def test(self, image: Image, bake_file: Path, variables: dict[str, str], result: Result) -> dict[str, Any]:
        """Runs the structure tests on what `result.manifest` names; returns the image's config, which they saw.

        Raises:
            TestsFailed: some of them failed.
        """
        reference = f"{self.prefix}/{image.repository}@{result.manifest}"
        folder = (
            self.services.state / "tests" / (image.target if self.native else f"{image.target}-{self.architecture}")
        )
        metadata, report_folder = folder / "metadata", folder / "report"
        shutil.rmtree(report_folder, ignore_errors=True)
        config = regctl.image_config(self.services, reference, variables["PLATFORM"])
        structure_tests.write_metadata(metadata, image, config)
        # A run that failed is in the builder's cache like any other: another attempt has to be told apart.
        attempts = folder / "failed-attempts"
        attempt = attempts.read_text().strip() if attempts.exists() else "0"
        if not attempt.isdecimal():  # damaged: any number that no earlier attempt had
            attempt = str(time.time_ns())
        name = image.test_target
        sets = (
            f"{name}.target=test-report",
            f"{name}.output=type=local,dest={report_folder}",
            f"{name}.contexts.metadata={metadata}",
            f"{name}.args.TEST_ATTEMPT={attempt}",
        )
        progress, _ = buildx.run(self.services, buildx.Bake(name, f"test-{image.target}", bake_file, sets, variables))
        for phase, seconds in progress.phases().items():
            result.work[phase] = result.work.get(phase, 0.0) + seconds
        if any("/run/tests/run.sh" in step.name for step in progress.reused()):
            result.reused.append("structure tests (same image, same tests)")
        report = structure_tests.read_report(report_folder, (*image.tests, "metadata"))
        if image.budget is not None:
            report = report.with_outcome(structure_tests.within_budget(image.budget, result.payloads))
        result.passed, result.failed, result.unpacked = report.passed, len(report.failed), report.unpacked
        result.versions = dict(report.versions)
        if report.failed:
            attempts.write_text(str(int(attempt) + 1))
            raise TestsFailed(result, report, report_folder)
        return config

    def _tag(self, image: Image, config: dict[str, Any], result: Result) -> None:
        """Makes the index and moves the tags to it, the most specific first, the floating ones last."""
        repository = f"{self.prefix}/{image.repository}"
        labels = config.get("config", {}).get("Labels") or {}
        annotations = {name: text for name, text in labels.items() if name.startswith(OCI)}
        result.digest = regctl.create_index(self.services, repository, [result.manifest], annotations)
        tags = tags_of(image)
        for name in tags:
            if regctl.digest(self.services, f"{repository}:{name}") != result.digest:
                regctl.tag(self.services, repository, result.digest, name)
                result.moved.append(name)
        result.tags = [f"{repository}:{name}" for name in tags]
        result.reference = result.tags[0]
        result.builder = builder_command(self.services)


def builder_command(services: Services) -> str:
    """What a person types to build a Dockerfile of their own with the builder that was set up."""
    config = f"BUILDX_CONFIG={shlex.quote(str(services.buildx_config))} " if services.buildx_config else ""
    return f"{config}{shlex.join(services.buildx)} build --builder {services.builder} ."


class _Clock:
    """Wall time by phase."""

    def __init__(self, laps: dict[str, float]) -> None:
        self._laps = laps
        self._last = time.monotonic()

    def lap(self, name: str) -> None:
        now = time.monotonic()
        self._laps[name] = now - self._last
        self._last = now


def _reused(steps: list[Step]) -> list[str]:
    """What the builder had already, in the words of the summary."""
    kinds = {
        "assemble payloads": "assembled payloads",
        "install ROS packages": "ROS packages",
        "install essentials": "essentials",
        "join payloads": "joined payload layers",
    }
    return list(dict.fromkeys(kinds[step.phase] for step in steps if step.phase in kinds))


def stored_blobs(storage: Path) -> frozenset[str]:
    """Digests, without their algorithm, of all that the local registry has in its folder."""
    return frozenset(file.name for file in storage.glob("docker/registry/v2/blobs/sha256/*/*"))


def _indent(text: str) -> str:
    return "\n".join(f"      {line}" for line in text.strip().splitlines())
