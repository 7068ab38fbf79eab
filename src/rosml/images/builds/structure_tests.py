"""Structure tests of an image in a registry: their inputs, how they run, and their report."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.images.builds import base_images
from rosml.images.image_set import labels
from rosml.images.image_set.model import Image
from rosml.machine import buildx, exported
from rosml.machine.services import Services


@dataclass(frozen=True)
class Outcome:
    """The outcome of one structure test; `detail` is its output."""

    file: str
    name: str
    passed: bool
    seconds: float
    detail: str = ""


@dataclass(frozen=True)
class Report:
    """The report of an image's structure tests, with versions that were recorded when its parts were built."""

    outcomes: tuple[Outcome, ...]
    unpacked: int  # size of the root file system in bytes; 0 if unknown
    versions: Mapping[str, str] = field(default_factory=dict)

    def failures(self, most: int = 0) -> str:
        """The failed tests with their output: of each the last `most` lines, or all if that is 0."""
        lines = list[str]()
        for outcome in self.failed:
            output = outcome.detail.strip().splitlines()[-most:]
            lines += [f"    {outcome.file}: {outcome.name}", *(f"      {line}" for line in output)]
        return "\n".join(lines)

    @property
    def passed(self) -> int:
        return sum(outcome.passed for outcome in self.outcomes)

    @property
    def failed(self) -> tuple[Outcome, ...]:
        return tuple(outcome for outcome in self.outcomes if not outcome.passed)


def expected_labels(image: Image) -> dict[str, str]:
    """The labels that an image must have, from the matrix."""
    facts = {
        "distribution": image.distribution,
        "component": image.component,
        "framework": image.framework,
        "os": image.os,
        "python": image.python,
        "ros": str(image.ros),
        **({"stack": image.stack} if image.stack else {}),
        **{item.name: item.version for item in image.brought},
        **{f"gpu.{name}": fact for name, fact in image.gpu.items()},
    }
    return {labels.PREFIX + name: value for name, value in facts.items()}


def expected_environment(image: Image) -> dict[str, str]:
    """The environment that the runtime contract promises, from the matrix."""
    promised = {
        "LANG": "C.UTF-8",
        "WORKSPACE": "/docker-ros/ws",
        "DOCKER_USER": "dockeruser",
        "DOCKER_UID": "",
        "DOCKER_GID": "",
        "NVIDIA_VISIBLE_DEVICES": "all",
        "NVIDIA_DRIVER_CAPABILITIES": "all",
        "UV_CONSTRAINT": "/usr/local/share/rosml/constraints.d/all.txt",
        "ROS_DISTRO": image.ros_distro,
        "ROS_VERSION": str(image.ros),
    }
    return promised | labels.environment(image.brought)


def metadata_test(image: Image) -> dict[str, Any]:
    """The structure test of an image's config, in container-structure-test's schema."""
    return {
        "schemaVersion": "2.0.0",
        "metadataTest": {
            "envVars": [{"key": key, "value": value} for key, value in expected_environment(image).items()],
            "labels": [{"key": key, "value": value} for key, value in expected_labels(image).items()],
            "entrypoint": ["/tini", "--", "/entrypoint.sh"],
            "cmd": ["bash"],
            "workdir": "/docker-ros/ws",
        },
    }


def flat_config(config: Mapping[str, Any]) -> dict[str, Any]:
    """The tested part of a config. A label that changes with every commit would make the builder run the same tests again."""
    inner = config.get("config", {})
    image_labels = inner.get("Labels") or {}
    return {
        "config": {
            "Env": inner.get("Env") or [],
            "Entrypoint": inner.get("Entrypoint") or [],
            "Cmd": inner.get("Cmd") or [],
            "WorkingDir": inner.get("WorkingDir", ""),
            "Labels": {key: value for key, value in sorted(image_labels.items()) if key.startswith(labels.PREFIX)},
        }
    }


def write_metadata(folder: Path, image: Image, config: Mapping[str, Any]) -> None:
    """Writes the build context `metadata` of the test stage."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "metadata.yaml").write_text(json.dumps(metadata_test(image), indent=1))  # JSON is YAML
    (folder / "config.json").write_text(json.dumps(flat_config(config), indent=1))


@dataclass(frozen=True)
class Subject:
    """The image under test."""

    image: Image
    architecture: str
    config: Mapping[str, Any]  # of the image in the registry
    part_bytes: int = 0  # bytes of the budgeted parts in the registry


def run(
    services: Services, subject: Subject, bake_file: Path, variables: Mapping[str, str], files: tuple[str, ...]
) -> tuple[Report, Path]:
    """Runs structure tests by the names of their files. Returns the report, and the folder with the report of each file."""
    image, name = subject.image, subject.image.test_target
    native = subject.architecture == base_images.native_architecture()
    folder = services.state / "tests" / (image.target if native else f"{image.target}-{subject.architecture}")
    metadata, reports, archive = folder / "metadata", folder / "report", folder / "report.tar"
    archive.unlink(missing_ok=True)
    write_metadata(metadata, image, subject.config)
    # The builder caches failed runs, too. Another number makes it run the tests again.
    attempts = folder / "failed-attempts"
    attempt = attempts.read_text() if attempts.exists() else "0"
    sets = (
        f"{name}.target=test-report",
        f"{name}.output={exported.output(archive)}",
        f"{name}.contexts.metadata={metadata}",
        f"{name}.args.TEST_ATTEMPT={attempt}",
        f"{name}.args.TESTS={' '.join(files)}",
    )
    log = f"test-{image.target}-{subject.architecture}"
    buildx.run(services, buildx.Bake(name, log, bake_file, sets, dict(variables), shares=buildx.IMAGES))
    exported.unpack(archive, reports)
    report = read_report(reports, (*files, "metadata"))
    if image.budget is not None:
        report = replace(report, outcomes=(*report.outcomes, _size(image.budget, subject.part_bytes)))
    if report.failed:
        attempts.write_text(str(time.time_ns()))
    require_space(report, image.target)
    return report, reports


def require_space(report: Report, target: str) -> None:
    """Checks that no test failed because the disk was full, which says nothing of the image."""
    if any("no space left on device" in outcome.detail.lower() for outcome in report.failed):
        raise RosmlError(f"the disk got full while {target} was tested", buildx.NO_SPACE_REMEDY)


def _size(budget: int, part_bytes: int) -> Outcome:
    """The test of a size budget in MB (10^6 bytes)."""
    detail = f"{part_bytes / 1e6:.0f} MB; matrix.yaml: disk.budgets allows {budget} MB"
    return Outcome("size", "the parts keep within their budget", part_bytes <= budget * 1_000_000, 0.0, detail)


def read_report(folder: Path, files: tuple[str, ...]) -> Report:
    """Reads the results of the test stage. A file without a report, or without a test, counts as one failure."""
    outcomes = [outcome for file in files for outcome in _outcomes(folder, file)]
    try:
        unpacked = int((folder / "unpacked").read_text().split()[0]) * 1024
    except (OSError, ValueError, IndexError):
        unpacked = 0
    return Report(tuple(outcomes), unpacked, _versions(folder / "versions"))


def _versions(file: Path) -> dict[str, str]:
    """Versions by name from lines such as `torch 2.10.0`."""
    if not file.is_file():
        return {}
    lines = (line.split(maxsplit=1) for line in file.read_text(errors="replace").split("\n"))
    return {line[0]: line[1] for line in lines if len(line) == 2}


class _Result(Shape):
    """A test in the report of container-structure-test. The duration is in nanoseconds."""

    Name: str
    Pass: bool
    Duration: float = 0
    Errors: list[str] | None = None
    Stdout: str = ""
    Stderr: str = ""


class _Results(Shape):
    Results: list[_Result] | None


def _outcomes(folder: Path, file: str) -> list[Outcome]:
    try:
        content = untrusted.json_value((folder / f"{file}.json").read_bytes())
        results = _Results.model_validate(content).Results
    except (OSError, ValueError):
        log = folder / f"{file}.log"
        output = log.read_text(errors="replace")[-2000:] if log.exists() else "did not start"
        return [Outcome(file, "the test runner", False, 0.0, output)]
    if not results:
        return [Outcome(file, "the test file", False, 0.0, "it holds no test")]
    return [
        Outcome(
            file,
            test.Name.removeprefix("Command Test: "),
            test.Pass,
            test.Duration / 1e9,
            "\n".join(filter(None, [*(test.Errors or []), test.Stdout, test.Stderr]))[-3000:],
        )
        for test in results
    ]
