"""What the design asks of the project's own matrix; skipped in a fork, which has a matrix of its own."""

from __future__ import annotations

import datetime

import pytest
from conftest import ROOT

from rosml.images.image_set import locked
from rosml.images.image_set.explain import why_not
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import combinations, names


def test_every_axis(real: ImageSet) -> None:
    """As many images as the design asks for."""
    assert len([image for image in real.images if not image.addons and not image.environment]) == 801
    with_addon = {name: [image for image in real.images if image.addons == (name,)] for name in real.matrix.addons}
    assert all(with_addon.values()), "each is tested somewhere"
    assert len([tag for images in with_addon.values() for image in images for tag in image.tags]) <= 30
    assert len([tag for image in real.images if len(image.platforms) == 2 for tag in image.tags]) > 300


def test_every_distribution_has_every_framework_that_its_facts_allow(real: ImageSet) -> None:
    kinds: dict[str, set[str]] = {}
    for image in (image for image in real.images if not image.addons):
        kinds.setdefault(image.distribution, set()).add("-".join(filter(None, [image.framework, image.stack])))
    cuda = {"none", "cuda-cu121", "cuda-cu128", "cuda-cu130", "cuda-cu132"}
    torch = cuda | {"torch-cu128", "torch-cu130", "torch-cpu"}
    newest = {"torch-cu132"}
    ml = torch | {"tensorflow-cu128", "tensorflow-cpu", "ml-cu128", "ml-cpu"}
    for name in ("humble", "iron"):  # no PyTorch of CUDA 13.2 for Python 3.10
        assert kinds[name] == ml
    for name in ("jazzy", "kilted", "ros1-bookworm", "ros1-trixie", "jazzy-wheels"):
        assert kinds[name] == ml | newest
    for name in ("lyrical", "rolling"):  # no TensorFlow for Python 3.14
        assert kinds[name] == torch | newest
    for name in ("noetic", "foxy"):  # Python 3.8; torch and TensorFlow contradict each other there
        assert kinds[name] == cuda | {"torch-cu121", "torch-cpu38", "tensorflow-cpu38"}


def test_latest_is_the_newest_long_term_release_with_every_framework(real: ImageSet) -> None:
    latest = {tag: image.target for image in real.images for tag in image.tags if tag.endswith(":latest")}
    assert latest == {
        "ros:latest": "jazzy-base",
        "ros-cuda:latest": "jazzy-base-cuda-cu130",
        "ros-torch:latest": "jazzy-base-torch-cu130",
        "ros-tf:latest": "jazzy-base-tensorflow-cu128",
        "ros-ml:latest": "jazzy-base-ml-cu128",
        "ros-onnx:latest": "jazzy-base-onnx-cu130",
    }


def rows(page: str, head: str) -> list[list[str]]:
    """The rows of a page's table that begins with a head."""
    table = (ROOT / page).read_text().partition(head)[2].partition("\n\n")[0]
    lines = [line for line in table.splitlines() if line.startswith("| `")]
    return [[cell.strip().strip("`") for cell in line.strip("|").split("|")] for line in lines]


def test_the_page_about_gpus_says_what_the_labels_do(real: ImageSet) -> None:
    matrix = real.matrix
    titles = {"torch": "PyTorch", "tensorflow": "TensorFlow", "onnxruntime": "ONNX Runtime"}
    lines = []
    for name, stack in matrix.stacks.items():
        facts = combinations.gpu(
            matrix, name, [part.name for part in matrix.parts if part.release in (None, *stack.releases)]
        )
        built = {family: [facts.pop(f"{family}.{x}", "") for x in ("amd64", "arm64")] for family in titles}
        driver = facts.pop("driver", "")
        assert not facts, "a column or a library that the page lacks"
        lines += [[name, driver, titles[family], *columns] for family, columns in built.items() if any(columns)]
    assert sorted(rows("docs/gpus.md", "| stack | driver |")) == sorted(lines)


def test_the_page_about_parts_says_what_goes_with_pytorch(real: ImageSet) -> None:
    for name, torch, *others in rows("docs/parts.md", "| stack | PyTorch | torchvision |"):
        stacks = name.replace("`", "").split(", ")
        assert torch == ", ".join(real.matrix.stacks[stack].releases["torch"] for stack in stacks)
        company = combinations.company(real.matrix, stacks[0], ["torch"])
        for package, other in zip(("torchvision", "torchaudio"), others, strict=True):
            assert other == company[package] if package in company else other.startswith("none"), (name, package)


@pytest.mark.parametrize("family", ["torch", "tensorflow", "onnxruntime"])
def test_every_release_with_cuda_says_what_it_was_built_for(real: ImageSet, family: str) -> None:
    for version, release in real.matrix.releases[family].items():
        cuda = [name for name in release.wheels if real.matrix.stacks[name].accelerator == "cuda"]
        assert release.gpus.keys() == {name for stack in cuda for name in release.wheels[stack]}, version


def test_every_lock_is_there_but_those_that_pytorchs_own_index_knows(real: ImageSet) -> None:
    assert {lock for lock in real.locks if not (ROOT / lock).is_file()} == {
        "locks/cpu/amd64/3.11/torch.txt",
        "locks/cpu/amd64/3.14/torch.txt",
        "locks/cpu38/amd64/3.8/torch.txt",
    }


def test_every_lock_is_used(real: ImageSet) -> None:
    assert locked.locks(ROOT) - real.locks == set()


def test_what_is_experimental(real: ImageSet) -> None:
    """ROS 2 from wheels: one component, for the one architecture that they are for."""
    rows = real.matrix.distributions.items()
    assert [name for name, row in rows if row.experimental or row.wheels] == ["jazzy-wheels"]
    images = [image for image in real.images if image.distribution == "jazzy-wheels"]
    assert {image.platforms for image in images} == {("linux/amd64",)}
    assert {image.component for image in images} == {"core"}
    assert real.image("jazzy-wheels-core").tags == ("ros:jazzy-wheels-core",)


def test_distributions_past_their_end_of_life_come_from_the_last_snapshot(real: ImageSet) -> None:
    rows = real.matrix.distributions.items()
    assert [name for name, row in rows if row.apt and row.apt.channel == "final"] == ["noetic", "foxy", "iron"]
    # Its last packages are published some weeks after that day, and the snapshot of them is made.
    over = datetime.date.today() - datetime.timedelta(days=60)
    live = [name for name, row in rows if row.apt and row.apt.channel == "live" and row.eol and row.eol < over]
    assert live == [], "past their end of life: apt: {channel: final} in matrix.yaml, then rosml generate"


def test_every_part_is_in_a_budget(real: ImageSet) -> None:
    """Of a framework, or of an add-on, which no image with a tag may have. For a Python that one framework lacks, others say it."""
    without = {(image.combination, image.stack) for image in real.images if image.stack and not image.budget}
    assert not without
    budgeted = {real.part_by_name[name] for image in real.images for name in image.budgeted}
    assert {(part.kind, part.stack) for part in real.parts_of_stacks} == {(part.kind, part.stack) for part in budgeted}


def test_budgets_leave_room_for_the_forecast_and_little_more(real: ImageSet) -> None:
    parts, sizes = real.part_by_name, real.matrix.disk.parts
    for image in (image for image in real.images if image.budget):
        budgeted = [parts[name] for name in image.budgeted]
        forecast = sum(sizes[part.stack][part.kind].compressed for part in budgeted)
        most = forecast * 1.5 + 5 if image.addons else 2 * forecast
        assert forecast <= (image.budget or 0) <= most, (image.target, forecast)


@pytest.mark.parametrize(
    ("name", "called"),
    [
        ("jazzy-base-tf-cu128", "jazzy-base-tensorflow-cu128"),
        ("jazzy-base-pytorch-cu130", "jazzy-base-torch-cu130"),
        ("JAZZY-BASE", "jazzy-base"),
        ("rwthika/ros2-torch:jazzy", "ros-torch:jazzy"),
        ("ros:jazzy-ros-base", "ros:jazzy-base"),
    ],
)
def test_names_in_the_words_of_others(real: ImageSet, name: str, called: str) -> None:
    assert why_not(real, name) == f"{name} is called {called}."


def test_parts_are_assembled_for_the_architectures_that_locks_are_made_for(real: ImageSet) -> None:
    """assemble.sh runs where matrix.yaml is not at hand."""
    script = (ROOT / "components/part/assemble.sh").read_text()
    for name, facts in real.matrix.architectures.items():
        machine = facts.wheels.partition("-")[0]
        assert f"  {name}) platform={facts.wheels} TRIPLET={machine}-linux-gnu ;;" in script


GLIBC = {"bookworm": 36, "trixie": 41, "ubuntu-20.04": 31, "ubuntu-22.04": 35, "ubuntu-24.04": 39, "ubuntu-26.04": 42}
"""The second number of the glibc 2.x that an operating system has, at least."""


def test_every_operating_system_takes_every_part_for_its_python(real: ImageSet) -> None:
    """Of Debian's family, with a glibc as new as the wheels ask for: so join need not tell systems apart."""
    needed = {int(facts.wheels.rpartition("_")[2]) for facts in real.matrix.architectures.values()}
    for name, system in real.matrix.operating_systems.items():
        assert system.image.startswith(("docker.io/library/debian:", "docker.io/library/ubuntu:")), name
        assert name in GLIBC, f"{name} is new: look up its glibc"
        assert GLIBC[name] >= max(needed), f"{name} has glibc 2.{GLIBC[name]}, and wheels ask for 2.{max(needed)}"
        for family, releases in real.matrix.releases.items():
            for version, release in releases.items():
                if release.glibc and system.python in release.python:
                    assert GLIBC[name] >= int(release.glibc.partition(".")[2]), (name, family, version)


def test_everything_is_tested_somewhere_in_each_row(real: ImageSet) -> None:
    """What images share runs in one of them that can be built, on all of their architectures, with all of their parts."""
    for image in real.images:
        proofs = [real.by_target[name] for name in image.proven_by]
        assert set(image.shared) <= {test for proof in proofs for test in (*proof.tests, *proof.shared)}, image.target
        assert {proof.distribution for proof in proofs} <= {image.distribution}
        assert all(set(image.architectures) <= set(proof.architectures) for proof in proofs), image.target
        if image.locked and image.stack:
            carrier = real.by_target[image.carriers[0]]
            beside = {names.environment_part(image.environment, image.python)}
            assert carrier.locked and set(image.parts) - beside <= set(carrier.parts)
            assert set(image.carried) <= {*carrier.tests, *(carrier.shared if image.environment else ())}
    workspaces = {image.target for image in real.images if "ros1-workspace" in image.tests}
    assert workspaces >= {f"ros1-bookworm-core{end}" for end in ("", "-ml-cu128", "-torch-cu130", "-tensorflow-cpu")}
    assert not {"ros1-bookworm-base", "ros1-bookworm-core-torch-cu128", "ros1-trixie-core-tensorflow-cpu"} & workspaces


def test_images_run_a_part_of_all_tests_that_hold_in_them(real: ImageSet) -> None:
    """The long ones (a workspace, compilers, pip) a tenth as often as there are images."""
    built = [image for image in real.images if image.locked]
    long = {"ros1-workspace", "ros2-workspace", "pip", "torch-build", "tensorflow-build", "cuda-build"}
    run = sum(test in long for image in built for test in image.tests)
    hold = sum(test in long for image in built for test in (*image.tests, *image.shared))
    assert 0 < run < hold / 6
