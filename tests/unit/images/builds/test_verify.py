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
    assert structure_tests.expected_labels(small.image("alpha-core-torch-cu1")) == {
        "io.rosml.distribution": "alpha",
        "io.rosml.component": "core",
        "io.rosml.framework": "torch",
        "io.rosml.os": "ubuntu-24.04",
        "io.rosml.python": "3.12",
        "io.rosml.ros": "2",
        "io.rosml.stack": "cu1",
        "io.rosml.torch": "2.10.0",
        "io.rosml.cuda": "12.8.90",
        "io.rosml.cudnn": "9.10.2.21",
    }
    assert "io.rosml.stack" not in structure_tests.expected_labels(small.image("alpha-core"))
    environment = structure_tests.expected_environment(small.image("alpha-core-ml-cu1"))
    assert (environment["TORCH_VERSION"], environment["TENSORFLOW_VERSION"]) == ("2.10.0", "2.20.0")
    bare = structure_tests.expected_environment(small.image("alpha-core"))
    assert not {"TORCH_VERSION", "CUDA_VERSION"} & bare.keys()
    renamed = parse(changed("  alpha:\n", "  alpha:\n    ros_distro: of-its-own\n")).image("alpha-core")
    assert structure_tests.expected_environment(renamed)["ROS_DISTRO"] == "of-its-own"


def test_flat_configs_have_one_order_and_no_gaps() -> None:
    """The same labels are the same bytes: otherwise the builder would run the same tests again."""
    empty = {"Env": [], "Entrypoint": [], "Cmd": [], "WorkingDir": "", "Labels": {}}
    configs: tuple[dict[str, Any], ...] = ({}, {"config": {}}, {"config": {"Env": None, "Labels": None, "Cmd": None}})
    for config in configs:
        assert structure_tests.flat_config(config) == {"config": empty}
    labels = [("io.rosml.os", "x"), ("io.rosml.ros", "2")]
    one, other = ({"config": {"Labels": dict(items)}} for items in (labels, reversed(labels)))
    assert json.dumps(structure_tests.flat_config(one)) == json.dumps(structure_tests.flat_config(other))


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
    image = small.image("alpha-core-torch-cu1")
    config = {
        "architecture": "amd64",
        "config": {
            "Env": ["A=b"],
            "Entrypoint": ["/tini"],
            "Cmd": ["bash"],
            "WorkingDir": "/w",
            "Labels": {"io.rosml.os": "x", "org.opencontainers.image.revision": "changes with every commit"},
        },
    }
    folder = tmp_path / "a" / "metadata"
    for _ in range(2):
        structure_tests.write_metadata(folder, image, config)
    assert json.loads((folder / "config.json").read_text()) == {
        "config": {
            "Env": ["A=b"],
            "Entrypoint": ["/tini"],
            "Cmd": ["bash"],
            "WorkingDir": "/w",
            "Labels": {"io.rosml.os": "x"},
        }
    }
    test = json.loads((folder / "metadata.yaml").read_text())
    assert test["schemaVersion"] == "2.0.0"
    assert {"key": "io.rosml.torch", "value": "2.10.0"} in test["metadataTest"]["labels"]
    assert {"key": "TORCH_VERSION", "value": "2.10.0"} in test["metadataTest"]["envVars"]
    assert test["metadataTest"]["entrypoint"] == ["/tini", "--", "/entrypoint.sh"]


# ---- Reports ---------------------------------------------------------------------------------------------------------


def reported(folder: Path, **files: str) -> Report:
    """The report of a folder with these JSON files."""
    folder.mkdir(exist_ok=True)
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


@pytest.mark.parametrize("text", [results(), '{"Results": null}'])
def test_a_file_without_a_test_is_a_failure(tmp_path: Path, text: str) -> None:
    report = reported(tmp_path, contract=results({"Name": "a", "Pass": True}), torch=text)
    assert report.passed == 1
    assert report.failed == (Outcome("torch", "the test file", False, 0.0, "it holds no test"),)


@pytest.mark.parametrize("text", ["", "{", "{}", "[]", "null", "Segmentation fault"])
def test_a_report_that_is_none_is_a_failure(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path).failed == (Outcome("contract", "the test runner", False, 0.0, "did not start"),)
    (tmp_path / "other.json").write_text(results({"Name": "a", "Pass": True}))
    (tmp_path / "torch.log").write_text("x" * 5000 + "killed")
    (failure,) = reported(tmp_path, torch=text).failed
    assert (failure.file, failure.name, len(failure.detail)) == ("torch", "the test runner", 2000)
    assert failure.detail.endswith("killed")


@pytest.mark.parametrize("text", ["", "much", None])
def test_size_that_was_not_measured(tmp_path: Path, text: str | None) -> None:
    if text is not None:
        (tmp_path / "unpacked").write_text(text)
    assert reported(tmp_path, contract=results({"Name": "a", "Pass": True})).unpacked == 0


def test_long_output_is_cut_to_its_end(tmp_path: Path) -> None:
    (failure,) = reported(tmp_path, a=results({"Name": "a", "Pass": False, "Stdout": "x" * 9000 + "end"})).failed
    assert len(failure.detail) == 3000
    assert failure.detail.endswith("xend")


def test_a_full_disk_is_no_failed_test() -> None:
    full = Outcome("torch", "it imports", False, 1.0, "OSError: [Errno 28] No space left on device: '/tmp/x'")
    with pytest.raises(RosmlError, match="the disk got full while alpha-core was tested"):
        structure_tests.require_space(Report((full,), 0), "alpha-core")
    structure_tests.require_space(Report((Outcome("torch", "it imports", False, 1.0, "no module"),), 0), "alpha-core")
