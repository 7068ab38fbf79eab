"""A set of somebody's own: the file that extends rosml's matrix, and the files to begin with."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from datetime import date
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner
from conftest import ROOT

from fakes.http_registry import local_registry
from rosml.base.problems import InputError
from rosml.cli import main, options
from rosml.images.image_set import explain, load, locked, own_set
from rosml.images.image_set.model import ImageSet
from rosml.images.image_set.own_set import Upstream
from tests import walk
from tests.pages import blocks, commands

SET = """\
extends: rosml
registry: registry.example.com/robots
default: {targets: [jazzy-base-torch-cu130], group: [jazzy-core]}
distributions:
  jazzy:
  humble: {components: [core, base], aliases: [hum], lts: }
frameworks:
  none:
  torch:
stacks:
  cu130:
"""


def loaded(tmp_path: Path, text: str) -> ImageSet:
    (tmp_path / "set.yaml").write_text(text)
    return load.load(tmp_path / "set.yaml", ROOT)


def problems(tmp_path: Path, text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        loaded(tmp_path, text)
    return [f"{problem.line}: {problem.path}: {problem.text}" for problem in caught.value.problems]


# ---- The file --------------------------------------------------------------------------------------------------------


def test_a_set_has_what_it_names_and_nothing_else(tmp_path: Path, real: ImageSet) -> None:
    image_set = loaded(tmp_path, SET)
    assert {image.target for image in image_set.images} == {
        image.target
        for image in real.images
        if (image.distribution == "jazzy" or (image.distribution == "humble" and image.component in ("core", "base")))
        and image.framework in ("none", "torch")
        and image.stack in (None, "cu130")
        and not image.addons
    }, "also without the add-ons, which it does not name"
    assert (
        image_set.matrix.registry == "registry.example.com/robots" and not image_set.matrix.distributions["humble"].lts
    )
    assert image_set.image("jazzy-base-torch-cu130") == real.image("jazzy-base-torch-cu130"), "the same tags and locks"
    assert set(image_set.matrix.disk.parts) == set(image_set.matrix.disk.budgets) == {"cu130"}
    assert "torch" in image_set.matrix.releases and "tensorflow" not in image_set.matrix.releases
    assert image_set.matrix.operating_systems == real.matrix.operating_systems


def test_a_set_adds_what_is_its_own(tmp_path: Path) -> None:
    text = SET.replace(
        "  humble:",
        "  mine: {os: bookworm, ros: 1, packages: ros-core, components: [core], default_stack: cu130}\n  humble:",
    )
    text = text.replace("  cu130:\n", "  cu130: {releases: {einops: 0.8.1}}\n").replace(
        "  torch:\n", "  torch: {parts: [cuda, common, torch, einops]}\n"
    )
    text += """\
parts:
  - {name: einops, title: einops, slot: 16, release: einops, needs: [torch]}
releases:
  einops:
    0.8.1: {python: ["3.10", "3.11", "3.12"], wheels: {cu130: [amd64]}}
disk: {parts: {cu130: {einops: {unpacked: 1, compressed: 1}}}}
"""
    image_set = loaded(tmp_path, text)
    assert image_set.image("mine-core").os == "bookworm"
    assert [part.kind for part in image_set.parts if part.kind == "einops"]
    torch = image_set.image("jazzy-base-torch-cu130")
    assert torch.parts[-1].startswith("einops") and torch.versions["torch"]
    assert problems(tmp_path, text.replace("slot: 16", "slot: 1")) == [
        "14: parts[einops].slot: slot 1 is that of common; free is 3"
    ]
    nameless = problems(tmp_path, text.replace("{name: einops, title", "{title: none}\n  - {name: einops, title"))
    assert nameless[0].startswith("14: parts[0]: 'name' is missing"), "by its own index"
    changed = problems(tmp_path, text.replace("- {name: einops", "- {name: torch, slot: x}\n  - {name: einops"))
    assert changed[0].startswith("14: parts[torch].slot: expected a whole number")


@pytest.mark.parametrize(
    ("name", "reason_part"),
    [
        ("humble-desktop", "the component desktop of humble; it is in rosml: name it in set.yaml."),
        ("ros:noetic", "the distribution noetic; it is in rosml"),
        (
            "noetic-base-tensorflow-cpu38",
            "the distribution noetic, the framework tensorflow and the stack cpu38; it is ",
        ),
        ("jazzy-base-tf-cu128", "the framework tensorflow and the stack cu128; it is in rosml"),
        ("foxy-core-torch-cu130", "the distribution foxy, and is not in rosml either: torch "),
    ],
)
def test_what_a_set_leaves_out_is_no_fact_about_ros(name: str, reason_part: str, tmp_path: Path) -> None:
    reason = explain.why_not(loaded(tmp_path, SET), name) or ""
    assert f" does not exist in this set, which does not choose {reason_part}" in reason


def test_what_neither_has_is_told_as_it_is(tmp_path: Path, real: ImageSet) -> None:
    image_set = loaded(tmp_path, SET)
    for name in ("humble-robot", "jazzy-robot"):
        reason = explain.why_not(image_set, name)
        assert reason == explain.why_not(real, name) and reason and "no robot metapackage" in reason
    assert (
        explain.why_not(image_set, "jazzy-base-torch")
        == "jazzy-base-torch names no stack; there is jazzy-base-torch-cu130."
    )
    assert explain.why_not(image_set, "jazzy-nothing") is None


def test_one_architecture_and_one_accelerator(tmp_path: Path, real: ImageSet) -> None:
    text = SET.replace("cu130:", "cpu:").replace("-torch-cu130", "-torch-cpu") + "architectures:\n  amd64:\n"
    image_set = loaded(tmp_path, text)
    assert {image.architectures for image in image_set.images} == {("amd64",)}
    assert image_set.matrix.distributions["jazzy"].default_stacks == ("cpu",), "those of rosml are gone"
    assert "ros-torch:jazzy" in image_set.image("jazzy-base-torch-cpu").tags
    text = "extends: rosml\narchitectures:\n  arm64:\ndefault: {targets: [jazzy-core], group: [jazzy-core]}\n"
    assert {image.target for image in loaded(tmp_path, text).images} == {
        image.target for image in real.images if "arm64" in image.architectures and not image.addons
    }


def test_a_set_with_an_addon_and_no_framework(tmp_path: Path, real: ImageSet) -> None:
    text = """\
extends: rosml
default: {targets: [ros1-bookworm-core], group: [ros1-bookworm-core]}
distributions:
  ros1-bookworm: {components: [core]}
frameworks:
  none:
stacks:
  cpu:
addons:
  onnx:
"""
    tests_onnx = "ros1-bookworm-core-onnx-cpu"
    image = loaded(tmp_path, text).image(tests_onnx)
    assert {*image.budgeted} > {*real.image(tests_onnx).budgeted}, "those that TensorFlow has in rosml"
    assert image.budget is None, "rosml's is for fewer parts"
    assert loaded(tmp_path, text + "disk: {budgets: {cpu: {onnx: 60}}}\n").image(tests_onnx).budget == 60
    with_frameworks = loaded(tmp_path, text.replace("frameworks:\n  none:\n", "")).image(tests_onnx)
    assert (with_frameworks.budget, with_frameworks.budgeted) == (40, real.image(tests_onnx).budgeted)


def test_where_a_sets_images_go(tmp_path: Path) -> None:
    file = tmp_path / "set.yaml"
    for text, place in (
        (SET, "registry.example.com/robots"),
        ("extends: rosml\n", ""),
        ("extends: rosml\nregistry: 1\n", ""),
    ):
        file.write_text(text)
        assert options.registry_of_set(file) == place
    assert options.registry_of_set(ROOT / "matrix.yaml") == "", "the bake file's, and not where people publish"


@pytest.mark.parametrize(
    ("line", "replacement", "problem"),
    [
        ("  none:\n", "", "7: frameworks: add 'none:', since images with a framework stand on those without one"),
        ("stacks:", "architectures:\n  x86_64:\nstacks:", "11: architectures.x86_64: no architecture in rosml named"),
        ("extends: rosml", "extends: ours", "1: extends: expected rosml: a set extends the matrix of the rosml that "),
        ("  jazzy:", "  jazy:", "5: distributions.jazy: no distribution in rosml named 'jazy'; did you mean 'jazzy'?"),
        ("  cu130:", "  cu999:", "11: stacks.cu999: no stack in rosml named 'cu999'; "),
        ("  none:", "  nothing: {}", "8: frameworks.nothing: no framework in rosml named 'nothing'; "),
        (
            "distributions:",
            "distribution:",
            "4: distribution: unknown key 'distribution'; did you mean 'distributions'?",
        ),
        ("lts: }", "ros: 3}", "6: distributions.humble.ros: expected 1 or 2, found the number 3"),
        ("lts: }", "ros: 1, ros: 2}", "6: distributions.humble.ros: the key 'ros' is there twice, first on line 6"),
        ("[jazzy-core]", "[jazy-core]", "3: default.group[0]: no image named 'jazy-core'; did you mean 'jazzy-core'"),
        ("stacks:\n  cu130:\n", "stacks: [cu130]\n", "10: stacks: it is a list; write each name on its own line"),
        ("frameworks:\n  none:\n  torch:\n", "frameworks: 1\n", "7: frameworks: expected keys and values, found "),
        ("  humble: {", "  rolling: {os: , ", "6: distributions.rolling: 'os' is missing; add 'os: …'"),
        (
            "  torch:",
            "  tensorflow:",
            "9: frameworks.tensorflow: none of the stacks of this set has its part tensorflow",
        ),
        (
            "default: {targets: [jazzy-base-torch-cu130], group: [jazzy-core]}\n",
            "",
            "1: default.group: rosml's are not all in this set; name its own, such as [jazzy-core]",
        ),
        ("registry:", "version: 2\nregistry:", "2: version: expected 1, found the number 2"),
    ],
)
def test_mistakes_have_their_line_in_the_sets_file(line: str, replacement: str, problem: str, tmp_path: Path) -> None:
    assert line in SET
    assert problems(tmp_path, SET.replace(line, replacement, 1))[0].startswith(problem)


@pytest.mark.parametrize(
    "section", ["parts", "releases", "disk", "default", "components", "operating_systems", "distributions"]
)
@pytest.mark.parametrize(
    "value", ["", "1", "[]", "[1]", "{}", "{a: }", "{a: 1}", "[{name: 1}]", "{cu130: [1]}", "{jazzy: 1}"]
)
def test_no_value_is_a_traceback(section: str, value: str, tmp_path: Path) -> None:
    (tmp_path / "set.yaml").write_text(f"extends: rosml\n{section}: {value}\n")
    try:
        load.load(tmp_path / "set.yaml", ROOT)
    except InputError as error:
        assert all(problem.text for problem in error.problems)


# ---- The files to begin with -----------------------------------------------------------------------------------------


@pytest.fixture
def upstream(tmp_path: Path) -> Upstream:
    """A rosml whose command says which matrix it sees."""
    folder = tmp_path / "upstream"
    folder.mkdir()
    (folder / "rosml").write_text('#!/bin/sh\ncd "$(dirname "$0")"\ncat set.yaml components/key version\necho "$@"\n')
    (folder / "rosml").chmod(0o755)
    (folder / ".gitignore").write_text("/.state/\n")
    (folder / "version").write_text("one\n")
    (folder / "components").mkdir()
    (folder / "components/key").write_text("rosml's\n")
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "one"]):
        walk.git(folder, *arguments)
    return Upstream(str(folder), walk.git(folder, "rev-parse", "HEAD").strip())


def written(folder: Path, real: ImageSet, upstream: Upstream) -> Path:
    choice = own_set.chosen(
        real, ["jazzy", "humble"], [], "registry.example.com/robots", "https://github.com/robots/images"
    )
    for name, text in own_set.files(real, choice, upstream).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    (folder / own_set.COMMAND).chmod(0o755)
    return folder


def call(folder: Path, *words: str) -> list[str]:
    done = subprocess.run([folder / own_set.COMMAND, *words], cwd="/", capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def test_the_sets_command_is_rosml_at_its_commit_with_the_sets_files(
    tmp_path: Path, real: ImageSet, upstream: Upstream
) -> None:
    folder = written(tmp_path / "own", real, upstream)
    text = (folder / "set.yaml").read_text().splitlines()
    assert call(folder, "list", "two words") == [*text, "rosml's", "one", "list two words"]
    (folder / "components").mkdir()
    (folder / "components/key").write_text("ours\n")
    Path(upstream.repository, "version").write_text("two\n")
    walk.git(Path(upstream.repository), "commit", "--quiet", "--all", "--message", "two")
    assert call(folder)[-3:] == ["ours", "one", ""], "the commit is that of the file"
    newer = walk.git(Path(upstream.repository), "rev-parse", "HEAD").strip()
    command = folder / own_set.COMMAND
    command.write_text(command.read_text().replace(upstream.commit, newer))
    (folder / "components/key").unlink()
    assert call(folder)[-3:] == ["rosml's", "two", ""]
    assert walk.git(folder / ".rosml", "status", "--porcelain") == "?? set.yaml\n"


def test_a_call_leaves_files_that_another_one_reads(tmp_path: Path, real: ImageSet, upstream: Upstream) -> None:
    folder = written(tmp_path / "own", real, upstream)
    call(folder)
    (folder / "components").mkdir()
    (folder / "components/key").write_text("ours\n")
    call(folder)
    before = (folder / ".rosml/components/key").stat()
    (folder / "set.yaml").write_text("another\n")
    assert call(folder)[0] == "another"
    assert (folder / ".rosml/components/key").stat() == before


@pytest.mark.parametrize(
    ("broken", "message"),
    [
        ("no set", "error: there is no set.yaml in "),
        ("a branch", "error: the line commit= in rosml names no commit of rosml\nremedy: write all 40 digits"),
        ("another commit", "error: git cannot fetch commit 1111"),
    ],
)
def test_the_sets_command_says_what_it_lacks(
    broken: str, message: str, tmp_path: Path, real: ImageSet, upstream: Upstream
) -> None:
    folder = written(tmp_path / "own", real, upstream)
    command = folder / own_set.COMMAND
    if broken == "no set":
        (folder / "set.yaml").rename(folder / "set.yml")
    commit = {"a branch": "main", "another commit": "1" * 40}.get(broken, upstream.commit)
    command.write_text(command.read_text().replace(upstream.commit, commit))
    done = subprocess.run([command, "list"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and message in done.stderr and "\nremedy: " in done.stderr


def test_on_github_the_workflow_names_the_commit(tmp_path: Path, real: ImageSet, upstream: Upstream) -> None:
    choice = own_set.chosen(real, [], [], "ghcr.io/me/images", "")
    address = "https://github.com/rosml/rosml"
    files = own_set.files(real, choice, Upstream(address, upstream.commit))
    assert f"nightly.yml@{upstream.commit}\n" in files[own_set.WORKFLOW]
    assert upstream.commit not in files[own_set.COMMAND]
    for name, text in files.items():
        (tmp_path / "own" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "own" / name).write_text(text.replace(f"repository={address}", f"repository={upstream.repository}"))
    (tmp_path / "own/rosml").chmod(0o755)
    assert call(tmp_path / "own", "list")[-2:] == ["one", "list"]
    (tmp_path / "own" / own_set.WORKFLOW).unlink()
    done = subprocess.run([tmp_path / "own/rosml"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "images.yml names no commit of rosml" in done.stderr


def test_a_new_set_is_what_it_says(tmp_path: Path, real: ImageSet, upstream: Upstream) -> None:
    folder = written(tmp_path / "own", real, upstream)
    image_set = load.load(folder / "set.yaml", ROOT)
    assert {image.distribution for image in image_set.images} == {"jazzy", "humble"}
    assert {image.component for image in image_set.images} == {"core", "base", "core-run", "base-run"}
    assert {image.framework for image in image_set.images} == {"none", "torch"}
    assert {image.stack for image in image_set.images} == {None, "cu130", "cpu"}
    assert image_set.matrix.default.targets == ("jazzy-base-torch-cu130",)
    assert image_set.matrix.source == "https://github.com/robots/images"
    assert not (folder / own_set.WORKFLOW).exists() and (folder / own_set.NIGHT).exists(), "rosml is not on GitHub"


def test_each_command_of_a_night_reads_the_set(tmp_path: Path, real: ImageSet, upstream: Upstream) -> None:
    """With this rosml and a registry that lets nobody in: that is all that its commands lack, beside services."""
    folder = written(tmp_path / "own", real, upstream)
    skipped = 'case "$*" in setup*|"publish rosdep"*) exit ;; esac; echo "called $@" >&2'
    (folder / "rosml").write_text(f'#!/bin/sh\n{skipped}\nexec "{sys.executable}" "{ROOT}/src" "$@"\n')
    environment = {**os.environ, "ROSML_MATRIX": str(folder / "set.yaml")}
    with local_registry() as server:
        server.users = {"somebody": "secret"}
        text = (folder / "set.yaml").read_text().replace("registry.example.com", server.address)
        (folder / "set.yaml").write_text(text)
        called = ["bash", str(folder / own_set.NIGHT)]
        done = subprocess.run(called, env=environment, capture_output=True, text=True, check=False)
    lines = done.stderr.splitlines()
    errors = [line for line in lines if line.startswith("error: ")]
    assert done.returncode == 1 and len(errors) == sum(line.startswith("called ") for line in lines) > 3, done.stderr
    lacks = [f"error: {server.address}: "]
    if not (ROOT / ".state/services.json").exists():
        lacks.append("error: the local registry and the builder are not up")
    assert all(line.startswith(tuple(lacks)) for line in errors), errors


def test_gitlabs_job_fails_with_the_night_and_keeps_its_log(tmp_path: Path) -> None:
    [text] = [block.text for block in blocks(walk.SET_PAGE) if block.title == ".gitlab-ci.yml of a set"]
    job = yaml.safe_load(text)["night"]
    (tmp_path / own_set.NIGHT).write_text("echo built >&2; exit 3\n")
    done = subprocess.run(["bash", "-ec", "\n".join(job["script"])], cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 3
    assert [(tmp_path / name).read_text() for name in job["artifacts"]["paths"]] == ["built\n"]
    assert job["artifacts"]["when"] == "always" and job["variables"]["GIT_CLEAN_FLAGS"].endswith("-e .rosml")


def test_every_distribution_and_framework_can_begin_a_set(tmp_path: Path, real: ImageSet) -> None:
    for distribution in real.matrix.distributions:
        for framework in real.matrix.frameworks:
            if not [it for it in real.images if (it.distribution, it.framework) == (distribution, framework)]:
                continue
            choice = own_set.chosen(real, [distribution], [framework], "ghcr.io/robots/images", "")
            text = own_set.files(real, choice, Upstream("https://github.com/rosml/rosml", "0" * 40))["set.yaml"]
            image_set = loaded(tmp_path, text)
            assert {image.distribution for image in image_set.images} == {distribution}
            assert image_set.image(choice.image.target).framework == framework
            assert [image.target for image in image_set.images if not image.locked] == []


def test_a_set_begins_with_stacks_that_have_their_locks(tmp_path: Path, real: ImageSet) -> None:
    usual, *_ = real.image("jazzy-base-torch-cu130").locks
    lacking = locked.with_locks(real, real.locks - {usual})
    choice = own_set.chosen(lacking, ["jazzy"], [], "ghcr.io/robots/images", "")
    assert choice.stacks == ("cu128", "cpu") and choice.image.target == "jazzy-base-torch-cu128"
    choice = own_set.chosen(real, ["lyrical"], [], "ghcr.io/robots/images", "")
    assert (choice.stacks, choice.without_locks) == (("cu130",), ("cpu",)), "nobody asked for the CPU"
    text = own_set.files(real, choice, Upstream("https://github.com/rosml/rosml", "0" * 40))["set.yaml"]
    assert "\n  # cpu: # its locks are missing: uncomment this, call ./rosml locks --stack cpu, " in text
    uncommented = re.sub(r"^  # cpu:", "  cpu:", text, flags=re.MULTILINE)
    assert "lyrical-base-torch-cpu" in loaded(tmp_path, uncommented).by_target


def test_a_set_in_a_folder_that_is_not_there_yet_says_which_locks_to_make(tmp_path: Path) -> None:
    words = [
        "init",
        "--images",
        str(tmp_path / "a/b"),
        "--registry",
        "ghcr.io/me/x",
        "--rosml",
        str(ROOT),
        "--cpu",
        "--json",
    ]
    done = CliRunner().invoke(main.cli, [*words, "--distribution", "humble,lyrical"])
    assert done.exit_code == 0, done.stderr
    assert (tmp_path / "a/b/set.yaml").is_file() and os.access(tmp_path / "a/b/rosml", os.X_OK)
    assert json.loads(done.stdout)["next"][1:3] == ["./rosml locks --stack cpu", "./rosml setup"]
    done = CliRunner().invoke(main.cli, [*words, "--distribution", "humble"])
    assert json.loads(done.stdout)["next"][1] == "./rosml setup"


# ---- In CI -----------------------------------------------------------------------------------------------------------


COMPLETE = ROOT / ".github/actions/checkout/complete.sh"


def complete(folder: Path, rosml: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([COMPLETE, rosml], cwd=folder, capture_output=True, text=True, check=False)


def test_a_job_has_rosml_with_the_sets_files_over_it(tmp_path: Path, real: ImageSet, upstream: Upstream) -> None:
    folder = written(tmp_path / "own", real, upstream)
    (folder / "components").mkdir()
    (folder / "components/key").write_text("ours\n")
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "a set"]):
        walk.git(folder, *arguments)
    assert complete(folder, Path(upstream.repository)).returncode == 0
    out = subprocess.run(["./rosml", "plan"], cwd=folder, capture_output=True, text=True, check=True).stdout
    assert out.splitlines()[0].startswith("# The images of this set") and out.endswith("ours\none\nplan\n")
    assert walk.git(folder, "status", "--porcelain", "--", "set.yaml", "components", "version") == ""
    assert walk.git(folder, "log", "--format=%s") == "a set\n"


def test_a_job_of_rosml_itself_is_left_alone_and_no_set_is_told(tmp_path: Path) -> None:
    done = complete(tmp_path, ROOT)
    assert done.returncode == 1 and "this repository has no set.yaml" in done.stderr
    (tmp_path / "scripts").mkdir()
    (tmp_path / "scripts/bootstrap.py").touch()
    assert complete(tmp_path, ROOT).returncode == 0
    assert [file.name for file in tmp_path.iterdir()] == ["scripts"]


# ---- In a fork -------------------------------------------------------------------------------------------------------


def test_a_fork_takes_what_rosml_changed(tmp_path: Path) -> None:
    """By the commands of the page."""
    ours, fork = tmp_path / "rosml", tmp_path / "fork"
    ours.mkdir()
    walk.clone(ours)
    walk.git(ours, "branch", "--move", "main")
    walk.git(tmp_path, "clone", "--quiet", "--origin", "upstream", str(ours), str(fork))
    page = ROOT / "docs/own-set.md"
    [text] = [block.text for block in blocks(page) if block.title == "set.yaml"]
    called = [command for block in blocks(page) if block.section == "In a fork" for command in commands(block)]
    assert [command.split()[0] for command in called] == ["./rosml", "git", "git", "git", "./rosml", "git"]
    for name in ("user.name", "user.email"):
        walk.git(fork, "config", name, "a")
    (fork / "set.yaml").write_text(text)
    for command in called[:2]:
        walk.run(fork, command)
    assert "noetic" not in (fork / "docs/tags.md").read_text().partition("<!-- images:")[2]
    matrix = ours / "matrix.yaml"
    matrix.write_text(matrix.read_text().replace("eol: 2029-05-31", "eol: 2029-06-30", 1))
    walk.run(ours, "./rosml generate")
    walk.git(ours, "commit", "--quiet", "--all", "--message", "jazzy lives on")
    for command in called[2:]:
        walk.run(fork, command)
    assert load.load(fork / "set.yaml", fork).matrix.distributions["jazzy"].eol == date(2029, 6, 30)
    assert walk.git(fork, "status", "--porcelain") == ""
    walk.run(fork, "./rosml generate --check")
