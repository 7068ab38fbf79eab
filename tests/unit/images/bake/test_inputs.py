"""What decides an image: every change that matters changes the digests of just the images that it reaches."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from conftest import ROOT, SMALL, changed, parse

from fakes.counting import calls
from fakes.projects import LOCK, copy
from rosml.base.errors import RosmlError
from rosml.images.bake import dockerfile, targets
from rosml.images.bake.inputs import MISSING, TARGET, Inputs
from rosml.images.image_set import expand, load
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import model, source

PARTS = {"cuda", "common", "torch", "tensorflow-cc", "tensorflow"}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return copy(tmp_path / "project")


def items(image_set: ImageSet) -> Iterator[Image | Part]:
    yield from image_set.images
    yield from image_set.parts


def digests(root: Path, text: str = SMALL) -> dict[tuple[str, str], str]:
    """The digests of all images and parts by target and architecture; `all` stands for all architectures."""
    inputs = Inputs(root, parse(text))
    by_architecture = {
        (item.target, name): value for item in items(inputs.image_set) for name, value in inputs.digests(item).items()
    }
    return by_architecture | {(item.target, "all"): inputs.together(item) for item in items(inputs.image_set)}


def differing(before: dict[tuple[str, str], str], after: dict[tuple[str, str], str]) -> set[tuple[str, str]]:
    assert before.keys() == after.keys()
    return {key for key in before if before[key] != after[key]}


def reached(image_set: ImageSet, images: bool, parts: set[str]) -> set[tuple[str, str]]:
    """Parts of the parts and the images that have them, or all images."""
    parts = {part.name for part in image_set.parts if part.kind in parts}
    targets: list[Image | Part] = [image for image in image_set.images if images or parts & set(image.parts)]
    targets += [image_set.part_by_name[name] for name in parts]
    return {(item.target, name) for item in targets for name in (*item.architectures, "all")}


# ---- Files -----------------------------------------------------------------------------------------------------------

FILES: dict[str, tuple[bool, set[str]]] = {
    "components/build/clean.sh": (True, set()),
    "components/build/network.sh": (True, PARTS),
    "components/ros/install.sh": (True, set()),
    "components/torch/files.sh": (False, {"torch"}),
    "components/torch/cmake/TorchConfig.cmake.in": (False, {"torch"}),
    "components/tensorflow-cc/keep.txt": (False, {"tensorflow-cc"}),
    "components/cuda/prune.txt": (False, {"cuda"}),
    "components/part/records.py": (False, PARTS),
    "tools/requirements.txt": (False, PARTS),
    "tests/structure/run.sh": (False, set()),
    "README.md": (False, set()),
    "components/torch/__pycache__/x.pyc": (False, set()),
}
"""A file, whether it reaches all images, and the parts that it reaches."""


@pytest.mark.parametrize("file", FILES)
def test_a_file_changes_what_uses_it(file: str, project: Path, small: ImageSet) -> None:
    before = digests(project)
    (project / file).parent.mkdir(parents=True, exist_ok=True)
    with (project / file).open("a") as stream:
        stream.write("# changed\n")
    assert differing(before, digests(project)) == reached(small, *FILES[file])


def test_the_executable_bit_counts(project: Path, small: ImageSet) -> None:
    before = digests(project)
    (project / "components/ros/install.sh").chmod(0o644)
    assert differing(before, digests(project)) == reached(small, True, set())


def test_a_lock_changes_one_stack_python_architecture_and_part(project: Path, small: ImageSet) -> None:
    """As well if it goes."""
    before = digests(project)
    (project / LOCK).unlink()
    users = [image.target for image in small.images if "torch-cu1-py312" in image.parts]
    assert {"alpha-core-torch-cu1", "alpha-desktop-ml-cu1"} <= set(users)
    users_digests = {(target, name) for target in [*users, "part-torch-cu1-py312"] for name in ("amd64", "all")}
    assert differing(before, digests(project)) == users_digests
    assert Inputs(project, small).of("part-torch-cu1-py312", "amd64")[LOCK] == MISSING


def test_the_same_everywhere(project: Path, tmp_path: Path) -> None:
    other = copy(tmp_path / "b" / "elsewhere")
    for file in other.rglob("*"):
        os.utime(file, (1, 1))
    assert digests(project) == digests(other)


def used(image_set: ImageSet) -> set[str]:
    """The names of all inputs of all images and parts, with the project's own files."""
    inputs = Inputs(ROOT, image_set)
    todo = {(item.target, architecture) for item in items(image_set) for architecture in item.architectures}
    seen: set[tuple[str, str]] = set()
    names: set[str] = set()
    while todo:
        target, architecture = todo.pop()
        seen.add((target, architecture))
        inputs_of_target = inputs.of(target, architecture)
        names |= inputs_of_target.keys()
        todo |= {
            (name.removeprefix(TARGET), architecture) for name in inputs_of_target if name.startswith(TARGET)
        } - seen
    return names


def test_every_file_that_reaches_the_builder_is_an_input(small: ImageSet, real: ImageSet) -> None:
    """Also of a component's file that nothing uses. The small matrix has every part, whatever the real one holds."""
    files = {path for path in (ROOT / "components").rglob("*") if path.is_file()}
    no_images = {"__pycache__", "containerize"}  # these are of apps
    needed_files = {path.relative_to(ROOT).as_posix() for path in files if not no_images & set(path.parts)}
    locks = small.locks | real.locks
    needed_files |= {name for name in (*locks, "tools/requirements.txt", ".dockerignore") if (ROOT / name).is_file()}
    assert {name for name in used(small) | used(real) if (ROOT / name).is_file()} == needed_files


# ---- The matrix ------------------------------------------------------------------------------------------------------

INDIFFERENT = {
    "comment": ("version: 1\n", "# a comment\nversion: 1 # another\n"),
    "registry": ("registry: localhost:5000", "registry: example.org/images"),
    "disk": ("torch: {unpacked: 2000, compressed: 200}", "torch: {unpacked: 2001, compressed: 201}"),
    "end of life": ("eol: 2029-05-31", "eol: 2030-05-31"),
    "long-term support": ("lts: true", "lts: false"),
    "groups": ("group: [alpha-core]", "group: [alpha-base, omega-core]"),
    "default": ("targets: [alpha-core-torch-cu1]", "targets: [alpha-core]"),
    "tags": ("default_stack: cu1", "default_stack: cpu"),
    "repository": ("repository: ros-ml,", "repository: ros-all,"),
}


@pytest.mark.parametrize("name", INDIFFERENT)
def test_what_does_not_matter_does_not_count(name: str, project: Path) -> None:
    assert digests(project) == digests(project, changed(*INDIFFERENT[name]))


TWINS = SMALL.replace(
    "components:\n  core:",
    f"""\
  another-24.04:
    image: docker.io/library/ubuntu:24.04
    digest: sha256:{"4" * 64}
    python: "3.12"
    numpy: "<2"
    architectures: [amd64, arm64]
    tools: colcon
components:
  core:""",
    1,
)
"""The small matrix with a second operating system for one Python."""


def turned(value: Any) -> Any:
    return {key: turned(value[key]) for key in reversed(value)} if isinstance(value, dict) else value


def sorted_by_name(value: Any) -> Any:
    return {key: sorted_by_name(value[key]) for key in sorted(value)} if isinstance(value, dict) else value


@pytest.mark.parametrize("text", [SMALL, TWINS], ids=["small", "twins"])
@pytest.mark.parametrize("order", [turned, sorted_by_name])
def test_the_order_of_the_matrix_does_not_count(order: Callable[[Any], Any], text: str, project: Path) -> None:
    assert digests(project, text) == digests(project, yaml.safe_dump(order(yaml.safe_load(text)), sort_keys=False))


def on(system: str) -> Callable[[ImageSet], set[str]]:
    """All that stands on an operating system, or has a part that was assembled on it."""

    def standing(image_set: ImageSet) -> set[str]:
        parts = {part.name: part.target for part in image_set.parts if part.os == system}
        images = {item.target for item in image_set.images if item.os == system or parts.keys() & set(item.parts)}
        return images | set(parts.values())

    return standing


def begins_with(start: str) -> Callable[[ImageSet], set[str]]:
    return lambda image_set: {item.target for item in items(image_set) if item.target.startswith(start)}


def images(that: Callable[[Image], bool]) -> Callable[[ImageSet], set[str]]:
    return lambda image_set: {image.target for image in image_set.images if that(image)}


DECISIVE: dict[str, tuple[str, str, Callable[[ImageSet], set[str]]]] = {
    "digest of a system": (f"digest: sha256:{'2' * 64}", f"digest: sha256:{'3' * 64}", on("ubuntu-26.04")),
    "what pip keeps numpy to": ('numpy: "<2"', 'numpy: "<1.27"', images(lambda i: i.os == "ubuntu-24.04")),
    "day of the snapshot": ("date: 2026-11-01", "date: 2026-11-02", begins_with("omega-")),
    "apt channel": ("channel: snapshot, date: 2026-11-01", "channel: final", begins_with("omega-")),
    "address of ROS's snapshots": (
        "http://snapshots.ros.test",
        "http://old.test",
        lambda image_set: images(lambda i: bool(image_set.matrix.distributions[i.distribution].apt))(image_set),
    ),
    "suite": ("codename: resolute", "codename: questing", begins_with("omega-")),
    "package list": ("{builds_on: robot}", "{builds_on: robot, metapackage: x}", begins_with("alpha-desktop")),
    "label": ("source: https://example.org/images", "source: https://example.org/x", images(lambda _: True)),
    "system of the assembler": (
        "assembler: ubuntu-24.04",
        "assembler: ubuntu-26.04",
        lambda image_set: {target for target, _ in reached(image_set, False, {"cuda"})},
    ),
    "version": (
        "cudnn: 9.10.2.21",
        "cudnn: 9.10.2.22",
        lambda image_set: images(lambda i: "cuda-cu1" in i.parts)(image_set) | {"part-cuda-cu1"},
    ),
}


@pytest.mark.parametrize("name", DECISIVE)
def test_a_fact_changes_what_it_reaches(name: str, project: Path, small: ImageSet) -> None:
    before, after, reach = DECISIVE[name]
    changes = differing(digests(project), digests(project, changed(before, after)))
    assert {target for target, _ in changes} == reach(small) != set()
    assert changes == {(target, name) for target, name in digests(project) if target in reach(small)}


@dataclasses.dataclass(frozen=True)
class Unknown:
    """A way to decide a value that src/rosml/images/bake/inputs.py knows nothing of."""

    what: str


@pytest.mark.parametrize("where", ["arguments", "labels", "contexts"])
def test_a_value_that_nobody_declared_is_an_error(
    where: str, project: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    every = targets.of(small)
    core = every["alpha-core"]
    name = "parent" if where == "contexts" else "NEW"
    values: dict[str, Any] = {where: {**getattr(core, where), name: Unknown("one")}}
    wrong = dataclasses.replace(core, **values)
    monkeypatch.setattr(targets, "of", lambda _: {**every, "alpha-core": wrong})
    with pytest.raises(RosmlError, match=f"alpha-core, {where.removesuffix('s')} {name} is Unknown") as caught:
        Inputs(project, small).digest("alpha-core", "amd64")
    assert "src/rosml/images/bake/targets.py" in caught.value.remedy


def test_the_time_of_files_counts(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = digests(project)
    monkeypatch.setattr(targets, "EPOCH", "1")
    assert differing(before, digests(project)) == before.keys()


# ---- The Dockerfile --------------------------------------------------------------------------------------------------

STAGES: dict[str, tuple[str, str, bool, set[str]]] = {
    "comment": ("# ---- ROS ---", "\n# ---- ROS, a comment\n\n# ---", False, set()),
    "comment in a stage": ("ARG ROS_PACKAGES ROS_TOOLS", "# why\n\nARG ROS_PACKAGES ROS_TOOLS", False, set()),
    "ros": ("ARG ROS_PACKAGES ROS_TOOLS", "ARG X=1 ROS_PACKAGES ROS_TOOLS", True, set()),
    "assembler": ("ENV PATH=/opt/uv/bin", "ENV X=1 PATH=/opt/uv/bin", False, PARTS),
    "part-assembler": ("FROM assembler AS part-assembler\n", "FROM assembler AS part-assembler\nARG X\n", False, PARTS),
    "test-run": ("ARG TESTS EXPECT", "ARG TESTS EXPECT X", False, set()),
    "all": ("# ---- ROS -", "ARG X\n# ---- ROS -", True, PARTS),
    "syntax": ("", "# syntax=docker/dockerfile:1\n", True, PARTS),
    "escape": ("", "# escape=`\n", True, PARTS),
}


@pytest.mark.parametrize("name", STAGES)
def test_a_stage_changes_what_is_built_with_it(name: str, project: Path, small: ImageSet) -> None:
    instruction, replacement, images, parts = STAGES[name]
    before = digests(project)
    file = project / "Dockerfile"
    assert instruction in file.read_text()
    file.write_text(file.read_text().replace(instruction, replacement, 1))
    assert differing(before, digests(project)) == reached(small, images, parts)


def test_a_file_counts_as_soon_as_the_dockerfile_uses_it(project: Path, small: ImageSet) -> None:
    text = (project / "Dockerfile").read_text()
    (project / "Dockerfile").write_text(
        text.replace("FROM assembler AS part-assembler\n", "FROM assembler AS part-assembler\nCOPY ${PART}* /\n")
    )
    before = digests(project)
    assert Inputs(project, small).of("part-torch-cu1-py312", "amd64")["torch*"] == MISSING
    (project / "torch1").write_text("")
    changed_targets = {target for target, _ in differing(before, digests(project))}
    assert changed_targets == {target for target, _ in reached(small, False, {"torch"})}


@pytest.mark.parametrize("source", ["components/${NOWHERE}/x", "."])
def test_what_cannot_be_followed_is_an_error(source: str, project: Path, small: ImageSet) -> None:
    with (project / "Dockerfile").open("a") as stream:
        stream.write(f"FROM os AS base\nCOPY {source} /x\n")
    with pytest.raises(RosmlError, match="Dockerfile"):
        Inputs(project, small).digest("alpha-core", "amd64")


def test_a_component_without_structure_tests_is_an_error(project: Path, small: ImageSet) -> None:
    (project / "tests/structure/ros2-desktop.yaml").unlink()
    with pytest.raises(RosmlError, match=r"tests/structure has no ros2-desktop\.yaml"):
        Inputs(project, small).check()


@pytest.mark.parametrize("gone", ["components/torch", "components/base/install.sh"])
def test_what_is_not_there_is_an_error(gone: str, project: Path, small: ImageSet) -> None:
    (project / "locks/cu1/amd64/3.12/torch.txt").unlink()
    (project / gone).rename(project / "elsewhere")
    with pytest.raises(RosmlError, match=rf"^{gone}: not there") as caught:
        Inputs(project, small).check()
    assert "git checkout" in caught.value.remedy


def test_rules_of_dockerignore_count_and_its_comments_do_not(project: Path) -> None:
    rules = project / ".dockerignore"
    rules.write_text("*.pyc\n")
    before = digests(project)
    rules.write_text("# why\n\n*.pyc  \n")
    assert digests(project) == before
    rules.write_text("*.pyc\ncomponents/ros/keys\n")
    assert differing(before, digests(project)) == set(before)


def test_a_link_is_what_it_leads_to_by_name(project: Path, small: ImageSet) -> None:
    """The builder gets the link itself, which may lead nowhere there."""
    before = digests(project)
    clean = project / "components/build/clean.sh"
    clean.rename(project / "clean.sh")
    clean.symlink_to("../../clean.sh")
    moved = digests(project)
    assert differing(before, moved) == reached(small, True, set())
    clean.unlink()
    clean.symlink_to("nowhere")
    assert differing(moved, digests(project)) == reached(small, True, set())


def test_stages_as_data() -> None:
    stages = dockerfile.parse(
        "# first\nARG A=cpu\nFROM --platform=$B one AS two\nARG C D=1\n"
        'COPY --chmod=755 a b/ /\nCOPY ["c", "/"]\nADD --from=three --link d /\n'
        "RUN --mount=type=bind,src=e,target=/e \\\n  # why\n  --mount=from=four,target=/f \\\n"
        "  --mount=type=secret,id=g --mount=type=cache,target=/h \\\n  /e --mount=source=i\nFROM two-${A}\n"
    )
    assert list(stages) == ["", "two", "1"]
    assert stages[""].defaults == {"A": "cpu"}
    assert stages["two"].defaults == {"D": "1"}
    assert stages["two"].stages == ("one", "three", "four")
    assert stages["two"].sources == ("a", "b/", "c", "e", "i")
    assert stages["1"].stages == ("two-${A}",)


def test_comments_in_a_here_document_are_content() -> None:
    one, two = (dockerfile.parse(f"FROM x AS y\nRUN <<EOF\n# {word}\nEOF\n")["y"] for word in ("a", "b"))
    assert one.digest != two.digest


# ---- Structure tests -------------------------------------------------------------------------------------------------


def inputs_of_tests(root: Path, image_set: ImageSet) -> dict[str, dict[str, str]]:
    """The inputs of each image's tests, without the image."""
    inputs = Inputs(root, image_set)
    by_target = {image.target: inputs.of(image.test_target, image.architectures[0]) for image in image_set.images}
    return {
        target: {name: value for name, value in of.items() if not name.startswith(TARGET)}
        for target, of in by_target.items()
    }


def retested(project: Path, image_set: ImageSet, file: str) -> set[str]:
    """The images whose tests a change of a file in tests/structure reaches."""
    before = inputs_of_tests(project, image_set)
    with (project / "tests/structure" / file).open("a") as stream:
        stream.write("# changed\n")
    after = inputs_of_tests(project, image_set)
    return {target for target in before if before[target] != after[target]}


@pytest.mark.parametrize(
    ("file", "of"),
    [
        ("torch.yaml", {"torch"}),
        ("programs/torch/main.cpp", {"torch-build"}),  # which a script beside it builds
        ("tensorflow.yaml", {"tensorflow"}),
        ("checks/replaces_nothing.py", {"torch", "tensorflow"}),
        ("programs/roscore.sh", set()),  # of ROS 1, which the small matrix has not
        ("programs/rclpy/talk.py", {"contract"}),  # through checks/rmw.sh
        ("checks/setuid.txt", {"contract"}),
        ("contract.yaml", {"contract"}),
        ("run.sh", {"contract"}),
        ("summary.py", {"contract"}),
    ],
)
def test_a_structure_test_reaches_the_images_that_it_runs_in(
    file: str, of: set[str], project: Path, small: ImageSet
) -> None:
    users = {image.target for image in small.images if of.intersection(image.tests)}
    assert retested(project, small, file) == users
    assert len(users) < len(small.images) or "contract" in of


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("torch.yaml", "      command: /run/tests/checks/$NAME.sh"),
        ("torch.yaml", "      args: [-c, 'cd /run/tests && bash torch.sh']"),
        ("programs/torch/build_and_run.sh", "for check in /run/tests/checks/*.sh; do $check; done"),
        ("programs/torch/build_and_run.sh", "cd $here/.."),
        ("programs/torch/build_and_run.sh", '"$(dirname "$here")/$1"'),
        ("programs/torch/build_and_run.sh", '"${here%/*}/$1"'),
        ("programs/torch/company.py", "(Path(__file__).parent.parent / name).read_text()"),
        ("checks/replaces_nothing.py", "sys.path.append(os.path.dirname(os.path.dirname(__file__)))"),
        ("checks/dangling_links.sh", '"$here/$1"'),
    ],
)
def test_where_nobody_can_tell_what_is_called_everything_counts(
    file: str, text: str, project: Path, small: ImageSet
) -> None:
    with (project / "tests/structure" / file).open("a") as stream:
        stream.write(f"{text}\n")
    images = retested(project, small, "programs/workspace/build_and_run.sh")
    users = {image.target for image in small.images if "torch-build" in image.tests}
    assert users and images >= users and "alpha-core-cuda-cu1" not in images


def test_every_file_of_structure_tests_is_run_somewhere(real: ImageSet) -> None:
    files = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "tests/structure").rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    by_target = inputs_of_tests(ROOT, real)
    assert files - {name for of in by_target.values() for name in of} == set()
    assert not any(files <= of.keys() for of in by_target.values()), "nobody can tell what some test calls"


# ---- Work ------------------------------------------------------------------------------------------------------------


def test_five_hundred_images_on_two_architectures_at_once() -> None:
    small = load.image_set(source.parse(SMALL.encode())).matrix
    rows = {f"d{number}": small.distributions["alpha"] for number in range(28)}
    image_set = expand.expand(model.Matrix.model_construct(**{**dict(small), "distributions": rows}))
    all_digests: set[str] = set()

    def digests() -> None:
        inputs = Inputs(ROOT, image_set)
        all_digests.update(inputs.together(image) for image in image_set.images)

    assert calls(digests) < 1_000 * 504
    assert len(all_digests) == len(image_set.images) == 504
