"""What the structure tests are told about an image, and what their reports become."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from conftest import changed, parse

from rosml.base.errors import RosmlError
from rosml.images.builds import structure_tests
from rosml.images.builds.structure_tests import Outcome, Report
from rosml.images.image_set.model import ImageSet


def test_labels(small: ImageSet) -> None:
    facts = {"distribution": "alpha", "component": "core", "framework": "torch", "os": "ubuntu-24.04", "python": "3.12"}
    facts |= {"ros": "2", "stack": "cu1", "torch": "2.10.0", "cuda": "12.8.90", "cudnn": "9.10.2.21"}
    expected = {f"io.rosml.{name}": fact for name, fact in facts.items()}
    assert structure_tests.expected_labels(small.image("alpha-core-torch-cu1")) == expected
    assert "io.rosml.stack" not in structure_tests.expected_labels(small.image("alpha-core"))
    environment = structure_tests.expected_environment(small.image("alpha-core-ml-cu1"))
    assert (environment["TORCH_VERSION"], environment["TENSORFLOW_VERSION"]) == ("2.10.0", "2.20.0")
    bare = structure_tests.expected_environment(small.image("alpha-core"))
    assert not {"TORCH_VERSION", "CUDA_VERSION"} & bare.keys()
    renamed = parse(changed("  alpha:\n", "  alpha:\n    ros_distro: of-its-own\n")).image("alpha-core")
    assert structure_tests.expected_environment(renamed)["ROS_DISTRO"] == "of-its-own"


GPUS = changed(
    "stacks:\n",
    'drivers: {"12": "525"}\nstacks:\n',
    changed('"3.14"], wheels: {cu1', '"3.14"], gpus: {arm64: [sm_110], amd64: [sm_80, sm_90]}, wheels: {cu1'),
)


def test_labels_about_gpus() -> None:
    image_set = parse(GPUS)
    expected = {"driver": "525", "torch.amd64": "sm_80 sm_90", "torch.arm64": "sm_110"}
    labels = structure_tests.expected_labels(image_set.image("alpha-core-ml-cu1"))
    assert {name.removeprefix("io.rosml.gpu."): value for name, value in labels.items() if ".gpu." in name} == expected
    assert image_set.image("alpha-core-cuda-cu1").gpu == {"driver": "525"}
    for target in ("alpha-core", "alpha-core-torch-cpu"):
        assert image_set.image(target).gpu == {}
        assert "NVIDIA_REQUIRE_CUDA" not in structure_tests.expected_environment(image_set.image(target))
    assert structure_tests.expected_environment(image_set.image("alpha-core-cuda-cu1"))["NVIDIA_REQUIRE_CUDA"] == (
        "cuda>=12.0"
    )


def test_a_generation_of_cuda_without_a_driver() -> None:
    with pytest.raises(RosmlError, match=r"stacks\.cu1\.cuda: 'drivers' does not say which driver CUDA 12 needs"):
        parse(GPUS.replace('"12": "525"', '"13": "580"'))
    with pytest.raises(RosmlError, match=r"gpus.*: no architecture named 'arm63'"):
        parse(GPUS.replace("arm64: [sm_110]", "arm63: [sm_110]"))


def test_what_the_test_stage_gets(tmp_path: Path, small: ImageSet) -> None:
    """The same labels are the same bytes: otherwise the builder would run the same tests again."""
    tested: dict[str, Any] = {"Env": ["A=b"], "Entrypoint": ["/tini"], "Cmd": ["bash"], "WorkingDir": "/w"}
    labels = {"io.rosml.ros": "2", "org.opencontainers.image.revision": "changes with every commit", "io.rosml.os": "x"}
    config = {"architecture": "amd64", "config": {**tested, "Labels": labels}}
    folder = tmp_path / "a" / "metadata"
    for _ in range(2):
        structure_tests.write_metadata(folder, small.image("alpha-core-torch-cu1"), config)
    expected = {"config": {**tested, "Labels": {"io.rosml.os": "x", "io.rosml.ros": "2"}}}
    assert (folder / "config.json").read_text() == json.dumps(expected, indent=1)
    test = json.loads((folder / "metadata.yaml").read_text())["metadataTest"]
    assert {"key": "io.rosml.torch", "value": "2.10.0"} in test["labels"]
    assert {"key": "TORCH_VERSION", "value": "2.10.0"} in test["envVars"]
    assert test["entrypoint"] == ["/tini", "--", "/entrypoint.sh"]
    bare = structure_tests.flat_config({"config": {"Env": None, "Labels": None}})["config"]
    assert bare == {"Env": [], "Entrypoint": [], "Cmd": [], "WorkingDir": "", "Labels": {}}


# ---- Reports ---------------------------------------------------------------------------------------------------------


def reported(folder: Path, **files: str) -> Report:
    """The report of a folder with these JSON files."""
    for name, text in files.items():
        (folder / f"{name}.json").write_text(text)
    return structure_tests.read_report(folder, tuple(files) or ("contract",))


def results(*results: dict[str, Any]) -> str:
    return json.dumps({"Pass": 0, "Fail": 0, "Total": len(results), "Results": results})


def test_report(tmp_path: Path) -> None:
    (tmp_path / "unpacked").write_text("2048\t/\n")
    report = reported(
        tmp_path,
        contract=results({"Name": "Command Test: tini", "Pass": True, "Duration": 1_500_000_000, "Stdout": "ok"}),
        torch=results(
            {"Name": "Command Test: import", "Pass": False, "Errors": ["no torch", "no CUDA"], "Stderr": "Traceback"},
            {"Name": "File Existence Test: x", "Pass": True, "Errors": None, "Duration": 1},
        ),
    )
    assert (report.passed, report.unpacked) == (2, 2048 * 1024)
    assert report.outcomes[0] == Outcome("contract", "tini", True, 1.5, "ok")
    assert report.failed == (Outcome("torch", "import", False, 0.0, "no torch\nno CUDA\nTraceback"),)
    (tmp_path / "unpacked").write_text("much")
    report = reported(tmp_path, a=results({"Name": "a", "Pass": False, "Stdout": "x" * 9000 + "end"}))
    assert report.unpacked == 0 and report.failed[0].detail.endswith("xend") and len(report.failed[0].detail) == 3000


@pytest.mark.parametrize("text", [results(), '{"Results": null}'])
def test_a_file_without_a_test_is_a_failure(tmp_path: Path, text: str) -> None:
    report = reported(tmp_path, contract=results({"Name": "a", "Pass": True}), torch=text)
    assert report.passed == 1
    assert report.failed == (Outcome("torch", "the test file", False, 0.0, "it holds no test"),)


@pytest.mark.parametrize("text", ["", "{}", "[]", "Segmentation fault"])
def test_a_report_that_is_none_is_a_failure(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path).failed == (Outcome("contract", "the test runner", False, 0.0, "did not start"),)
    (tmp_path / "torch.log").write_text("x" * 5000 + "killed")
    (failure,) = reported(tmp_path, torch=text).failed
    assert failure.name == "the test runner" and failure.detail.endswith("killed") and len(failure.detail) == 2000


def test_a_full_disk_is_no_failed_test() -> None:
    full = Outcome("torch", "it imports", False, 1.0, "OSError: [Errno 28] No space left on device: '/tmp/x'")
    with pytest.raises(RosmlError, match="the disk got full while alpha-core was tested"):
        structure_tests.require_space(Report((full,), 0), "alpha-core")
    structure_tests.require_space(Report((Outcome("torch", "it imports", False, 1.0, "no module"),), 0), "alpha-core")
