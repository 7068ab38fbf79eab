"""docker-bake.hcl: what it says, that it is up to date, and that the real tool reads it as it is meant."""

from __future__ import annotations

import errno
import itertools
import json
import os
import re
import subprocess
import sys
from collections import Counter
from functools import partial
from pathlib import Path

import pytest
from conftest import ROOT, SMALL, changed, parse

from fakes.bakes import printed, whole
from fakes.counting import calls
from fakes.projects import copy_for_generator
from fakes.stubs import HOSTILE
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.cli import command, main
from rosml.cli.images import generate as generating
from rosml.images.bake import bake_file, hcl, targets
from rosml.images.image_set import apt_repository, expand, load
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import model, source
from tests import synthetic


def run(*words: str | Path, cwd: Path = ROOT, **env: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, *map(str, words)]
    environment = {**os.environ, **env}
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False, timeout=60)


generate = partial(run, ROOT / "scripts/generate_bake.py")


@pytest.fixture
def small_file(tmp_path: Path) -> Path:
    file = tmp_path / "matrix.yaml"
    file.write_text(SMALL)
    return file


# ---- HCL -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", HOSTILE)
def test_texts_that_mean_something_elsewhere_are_only_texts(text: str) -> None:
    code = hcl.literal(text)
    assert not re.search(r"(?<!\$)(\$\$)*\$\{|(?<!%)(%%)*%\{", code)
    assert json.loads(re.sub(r"([$%])\1\{", r"\1{", code)) == text


def test_plain_data() -> None:
    data = {"a": None, "b.c": [True, "d"], "_e": {}, "f": (), "g": hcl.Code("H"), "i": {"j": "k"}}
    assert hcl.literal(data) == '{ a = null, "b.c" = [true, "d"], "_e" = {}, f = [], g = H, i = { j = "k" } }'


# ---- The committed file ----------------------------------------------------------------------------------------------


def test_people_can_read_it(real: ImageSet) -> None:
    """A target is found by its name and fits on a screen; a new distribution adds lines and changes none."""
    text = (ROOT / bake_file.NAME).read_text()
    blocks = re.findall(r'^target "(.+)" {\n((?:.*\n)*?)}', text, re.MULTILINE)
    lines = Counter({name: block.count("\n") + 2 for name, block in blocks})
    assert len(lines) == len(blocks)
    assert all(0 < lines[image.target] <= 24 for image in real.images)
    eight, nine = (set(whole(parse(synthetic.matrix(count * synthetic.IMAGES))).split("\n\n")) for count in (8, 9))
    changed = [block for block in eight - nine if ':latest"' not in block]  # the newest distribution has it
    assert all(block.startswith("group ") for block in changed)
    lines_of_nine = {line for block in nine for line in block.splitlines()}
    assert all({*block.splitlines()} <= lines_of_nine for block in changed)


def test_same_input_same_bytes() -> None:
    outputs = {
        generate("--output", "/dev/stdout", PYTHONHASHSEED=seed, TZ=zone, LC_ALL=locale).stdout
        for seed, zone, locale in (("1", "UTC", "C"), ("2", "Asia/Tokyo", "C.UTF-8"))
    }
    assert len(outputs) == 1


def test_no_day_but_those_of_the_matrix(real: ImageSet) -> None:
    assert re.findall(r"\b20\d\d-\d\d-\d\d\b", whole(real)) == []


# ---- Agreement with the Dockerfile -----------------------------------------------------------------------------------

BUILTIN = {"TARGETARCH", "BUILDARCH", "BUILDPLATFORM", "SOURCE_DATE_EPOCH", "HTTP_PROXY", "HTTPS_PROXY", "NO_PROXY"}


def dockerfile() -> str:
    return (ROOT / "Dockerfile").read_text()


def test_every_argument_is_declared(real: ImageSet) -> None:
    texts = [dockerfile(), *{target.join.dockerfile() for target in targets.of(real).values() if target.join}]
    lines = [line for text in texts for line in re.findall(r"^ARG (.+)$", text, re.M)]
    declared = {name.split("=")[0] for line in lines for name in line.split()}
    passed = {name for target in targets.of(real).values() for name in target.arguments}
    assert passed - declared - BUILTIN == set()


# ---- The command -----------------------------------------------------------------------------------------------------


def test_writes_once(small_file: Path) -> None:
    output = small_file.with_name("out.hcl")
    first, second = (generate("--matrix", small_file, "--output", output) for _ in range(2))
    assert (first.returncode, second.returncode) == (0, 0)
    assert "out.hcl: written" in first.stderr
    assert "out.hcl: is up to date" in second.stderr
    assert not list(small_file.parent.glob(".out.hcl*"))


def test_pipes_are_written_to_and_links_followed(small_file: Path) -> None:
    link, target = small_file.with_name("link.hcl"), small_file.with_name("target.hcl")
    link.symlink_to(target)
    piped = generate("--matrix", small_file, "--output", "/dev/stdout")
    generate("--matrix", small_file, "--output", link)
    assert link.is_symlink()
    assert piped.stdout == target.read_text()
    assert Path("/dev/stdout").is_symlink()


def test_generated_files_stay_in_the_checkout(
    small: ImageSet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A clone of somebody else's may have a link in the place of one."""
    checkout, other = tmp_path / "checkout", tmp_path / "other"
    copy_for_generator(checkout)
    (checkout / "docker-bake.hcl").unlink()
    other.write_text("mine")
    (checkout / "docker-bake.hcl").symlink_to(other)
    monkeypatch.setattr(generating, "ROOT", checkout)
    monkeypatch.setattr(load, "load", lambda *_: small)
    assert command.run(generating.main, arguments=[]) == 1
    assert f"docker-bake.hcl is a link, to {other}" in capsys.readouterr().err
    assert other.read_text() == "mine"


def test_a_full_disk_is_told_with_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(**_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("tempfile.mkstemp", full)
    with pytest.raises(RosmlError, match="x: cannot be written: No space left on device") as caught:
        files.write(tmp_path / "x", "y")
    assert caught.value.remedy == "free some disk space, then run it again"


def test_works_from_any_folder(tmp_path: Path) -> None:
    done = generate("--check", cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_check_fails_when_stale(small_file: Path) -> None:
    output = small_file.with_name("out.hcl")
    generate("--matrix", small_file, "--output", output)
    output.write_text(output.read_text().replace('"ros-alpha-desktop"', '"ros-alpha-desktop-full"'))
    done = generate("--check", "--matrix", small_file, "--output", output)
    assert done.returncode == 1
    assert re.search(r'^-  args +=.* "ros-alpha-desktop-full" }$', done.stdout, re.M)
    assert re.search(r'^\+  args +=.* "ros-alpha-desktop" }$', done.stdout, re.M)
    assert "out.hcl: outdated" in done.stderr
    assert "desktop-full" in output.read_text(), "--check must not write"
    output.unlink()
    assert generate("--check", "--matrix", small_file, "--output", output).returncode == 1


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["explain", "alpha-core"], 0, "alpha-core exists:"),
        (["explain", "alpha-robot"], 0, "has no robot"),
        (["explain", "alfa-core"], 2, "did you mean 'alpha-core'"),
        (["explain", ""], 2, "no image is named"),
        (["explain", "alpha-core", "--json"], 0, '"exists": true'),
        (["explain", "alpha-robot", "--json"], 0, '"exists": false'),
        (["explain", "alfa-core", "--json"], 2, "did you mean 'alpha-core'"),
        (["diff", "{matrix}"], 0, "0 changed, "),
        (["generate", "--output", "{matrix}"], 2, "would overwrite the matrix"),
        (["list", "--matrix", "/nowhere/matrix.yaml"], 2, "no such file"),
    ],
)
def test_exit_codes(
    words: list[str], code: int, text: str, small_file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    word, *others = (word.replace("{matrix}", str(small_file)) for word in words)
    assert command.run(main.cli, arguments=[word, "--matrix", str(small_file), *others]) == code
    done = capsys.readouterr()
    assert text in (done.err if code else done.out)
    if "--json" in words and code:
        assert text in json.loads(done.out)["error"]
    else:
        assert (done.out if code else done.err) == ""


def test_work_for_an_image_is_bounded() -> None:
    small = load.image_set(source.parse(SMALL.encode())).matrix
    rows = {f"d{n}": small.distributions["alpha"] for n in range(112)}
    big = model.Matrix.model_construct(**{**dict(small), "distributions": rows})
    assert len(expand.expand(big).images) == 2_016
    assert calls(lambda: bake_file.render(expand.expand(big))) < 1_200 * 2_016


# ---- buildx ----------------------------------------------------------------------------------------------------------


@pytest.fixture
def small_bake(small: ImageSet, tmp_path: Path) -> Path:
    file = tmp_path / "small.hcl"
    file.write_text(whole(small))
    return file


def test_a_part_says_what_it_is_and_what_takes_it(small_bake: Path) -> None:
    """Who has the registry alone can put it together with others."""
    bake = printed("part-cuda-cu1", "part-torch-cu1-py312", file=small_bake)
    part_labels = {name: target["labels"] for name, target in bake.items()}
    both = "torch=cuda*,common,torch ml=cuda*,common,torch,tensorflow-cc*,tensorflow"
    assert part_labels["part-torch-cu1-py312"] == {
        "org.opencontainers.image.title": "torch-cu1-py312",
        "org.opencontainers.image.description": "part torch of stack cu1, for Python 3.12",
        "io.rosml.part": "torch",
        "io.rosml.stack": "cu1",
        "io.rosml.python": "3.12",
        "io.rosml.torch": "2.10.0",
        "io.rosml.brings": "torch:torch:PyTorch",
        "io.rosml.release": "torch",
        "io.rosml.frameworks": both,
    }
    cuda = part_labels["part-cuda-cu1"]
    assert (cuda["io.rosml.python"], cuda["io.rosml.cuda"]) == ("any", "12.8.90")
    assert cuda["io.rosml.frameworks"] == f"cuda=cuda* {both}"
    assert cuda["io.rosml.brings"] == "cuda:cuda:CUDA cudnn::" and "io.rosml.release" not in cuda


def test_frameworks_that_do_not_go_together_are_not_named(real: ImageSet) -> None:
    all_targets = targets.of(real)
    assert "ml=" in str(all_targets["part-common-cpu-py311"].labels["io.rosml.frameworks"])
    apart = all_targets["part-common-cpu38-py38"].labels["io.rosml.frameworks"]
    assert apart == "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow"


def test_dependencies_are_taken_from_the_registry(small_bake: Path) -> None:
    digests = json.dumps({"cuda-cu1": "sha256:aa", "alpha-core": "sha256:bb"})
    bake = printed("alpha-core-torch-cu1", file=small_bake, REGISTRY="registry:1/x", DIGESTS=digests)
    target = bake["alpha-core-torch-cu1"]
    assert target["contexts"]["part-cuda"] == "docker-image://registry:1/x/part@sha256:aa"
    assert target["contexts"]["ros"] == "docker-image://registry:1/x/ros@sha256:bb"
    assert target["contexts"]["part-torch"] == "target:_files-torch-cu1-py312"
    assert target["args"]["CUDA_ROOT"] == "/"
    assert target["args"]["TORCH_ROOT"] == "/out/"
    assert set(bake) == {"alpha-core-torch-cu1", "_files-common-cu1-py312", "_files-torch-cu1-py312"}


def test_an_excerpt_prints_as_the_whole(real: ImageSet, tmp_path: Path) -> None:
    images = [real.image(name) for name in ("ros1-bookworm-core-torch-cu130", "ros1-bookworm-base-run-torch-cu130")]
    roots = [(image.target, image.test_target, real.part_by_name[image.parts[0]].target) for image in images]
    whole = printed(*itertools.chain(*roots), targets.CONTENTS)
    seen = set[str]()
    for names in roots:
        file = tmp_path / "excerpt.hcl"
        file.write_text(bake_file.excerpt(real, names))
        excerpt = printed(*names, targets.CONTENTS, file=file)
        assert {*names} <= excerpt.keys() and excerpt.items() <= whole.items()
        seen |= excerpt.keys()
    assert seen == whole.keys(), "nothing is lacking"


def test_an_excerpt_holds_little_else() -> None:
    text = bake_file.excerpt(parse(synthetic.matrix(400)), ("d1-base-torch-cu128",))
    target_names = re.findall(r'^target "([^_].*)" {', text, re.MULTILINE)
    assert sorted(target_names) == ["contents", "d1-base", "d1-base-torch-cu128", "d1-core"]
    assert "group" not in text


def test_more_rmw_implementations() -> None:
    """One of them by default."""
    apt, more = "    apt: {channel: live}", "usual_rmw: rmw_cyclonedds_cpp\n    rmw: [rmw_cyclonedds_cpp]"
    all_targets = targets.of(parse(changed(apt, f"{apt}\n    {more}")))
    assert all_targets["alpha-core"].labels["io.rosml.rmw"] == "rmw_cyclonedds_cpp"
    assert str(all_targets["alpha-core"].arguments["ROS_TOOLS"]).endswith(" ros-alpha-rmw-cyclonedds-cpp")
    assert "ROS_TOOLS" not in all_targets["alpha-base"].arguments
    assert " rmw=rmw_cyclonedds_cpp " in str(all_targets["alpha-base-test"].arguments["EXPECT"])


def test_a_mirror_is_a_secret(small_bake: Path) -> None:
    mirrors = {name: f"http://mirror/{name}" for name in ("ROS_APT_MIRROR", "OS_APT_MIRROR")}
    target = printed("alpha-core", file=small_bake, **mirrors)["alpha-core"]
    assert target["secret"] == [{"id": name.lower().replace("_", "-"), "env": name} for name in mirrors]
    assert "http://mirror" not in str(target)


def test_where_packages_come_from(real: ImageSet) -> None:
    """Every row with an apt source names its suite; the live ones the pinned package."""
    all_targets = targets.of(real)
    for name, distribution in real.matrix.distributions.items():
        args = all_targets[f"{name}-core"].arguments
        if distribution.apt is None:
            assert "ROS_CHANNEL" not in args
            continue
        assert args["ROS_CHANNEL"] == targets.Overridable("ROS_CHANNEL", distribution.apt.channel)
        assert args["ROS_CODENAME"] == real.matrix.operating_systems[distribution.os].codename
        live = apt_repository.of(real.matrix, name, {"ROS_CHANNEL": "live"})
        day = apt_repository.of(real.matrix, name, {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2026-08-07"})
        assert live and args["ROS_LIVE_ADDRESS"] == live.address
        assert day and str(args["ROS_SNAPSHOT_ADDRESS"]).replace("{day}", "2026-08-07") == day.address
        pinned = re.fullmatch(r"https://[^@{}]+\.deb@sha256:[0-9a-f]{64}", str(args.get("ROS_APT_SOURCE", "")))
        assert pinned or distribution.apt.channel != "live"
