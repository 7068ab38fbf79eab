"""The build plan: estimates worked out by hand from the small matrix, and properties that hold for every plan."""

from __future__ import annotations

import json
import re
from itertools import permutations
from pathlib import Path

import pytest
from conftest import ROOT, SMALL, changed, parse, write_locks
from counting import calls

from bench import synthetic
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli import generate as generate_bake
from rosml.images.image_set import Image, ImageSet
from rosml.machine import disk
from rosml.publish import shards as dealing


@pytest.fixture(scope="module")
def big() -> ImageSet:
    """Ten distributions on eight operating systems, five stacks, two architectures."""
    return parse(synthetic.matrix(10 * synthetic.IMAGES))


def everything(image: Image) -> bool:
    return True


# ---- Estimates -------------------------------------------------------------------------------------------------------


def test_a_shard(small: ImageSet) -> None:
    shards = dealing.deal(small, 4).shards
    assert [shard.name for shard in shards] == ["amd64-1", "amd64-2", "arm64-1", "arm64-2"]
    first = shards[0]
    assert (first.architecture, first.platform, first.runner) == ("amd64", "linux/amd64", "amd")
    assert first.distributions == ("alpha",)
    assert first.targets[:4] == ("alpha-core", "alpha-base", "alpha-desktop", "alpha-core-cuda-cu1")
    assert len(first.targets) == 12
    assert first.parts == (
        "cuda-cu1",
        "common-cu1-py312",
        "torch-cu1-py312",
        "tensorflow-cc-cu1",
        "tensorflow-cu1-py312",
    )
    # The operating system, three components, and the parts cuda, common, torch and tensorflow.
    assert first.download_mb == 10 + 3 * 2 + 100 + 30 + 200 + 150
    parts = (1000 + 100) + (300 + 30) + (2000 + 200) + (1500 + 150)
    assert first.disk_mb == (100 + 2 * 10) + 3 * (20 + 2 * 2) + 2 * parts + disk.RESERVE_MB
    assert first.seconds == (100 + 3 * 20) // 10 + (1000 + 300 + 2000 + 1500) // 100 + 12 * 5 == 124
    assert [shard.seconds for shard in shards] == [124, 77, 74, 42]


def test_what_a_shard_has_already_costs_nothing(small: ImageSet) -> None:
    """Both distributions need CUDA, which is assembled once: 10 s, and 2 * 1100 MB; their Pythons differ."""
    apart, together = dealing.deal(small, 4).shards, dealing.deal(small, 2).shards
    assert [shard.seconds for shard in together] == [124 + 77 - 10, 74 + 42]
    assert together[0].parts.count("cuda-cu1") == 1
    saved = apart[0].disk_mb + apart[1].disk_mb - together[0].disk_mb
    assert saved == 2 * 1000 + 2 * 100 + disk.RESERVE_MB
    assert apart[0].download_mb + apart[1].download_mb - together[0].download_mb == 100


def test_a_further_shard_goes_where_it_takes_longest(small: ImageSet) -> None:
    assert [shard.name for shard in dealing.deal(small, 3).shards] == ["amd64-1", "amd64-2", "arm64-1"]


def test_only_what_is_included(small: ImageSet) -> None:
    found = dealing.deal(small, 4, lambda image: image.target == "alpha-desktop-torch-cpu").shards
    assert [(shard.name, shard.targets) for shard in found] == [
        ("arm64-1", ("alpha-core", "alpha-base", "alpha-desktop", "alpha-desktop-torch-cpu"))
    ]
    assert found[0].parts == ("common-cpu-py312", "torch-cpu-py312")


def test_distributions_that_share_come_together() -> None:
    """Two on each of eight operating systems, all equally long; the second ones where the first ones are."""
    image_set = parse(synthetic.matrix(16 * synthetic.IMAGES))
    system = {name: row.os for name, row in image_set.matrix.distributions.items()}
    for shard in dealing.deal(image_set, 16).shards:
        assert len(shard.distributions) == 2
        assert len({system[name] for name in shard.distributions}) == 1


# ---- Properties ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("number", [2, 3, 7, 12, 20, 99])
def test_every_plan(big: ImageSet, number: int) -> None:
    found = dealing.deal(big, number)
    assert len(found.shards) == min(number, 20)
    wanted = {(image.target, architecture) for image in big.images for architecture in image.architectures}
    built = [(target, shard.architecture) for shard in found.shards for target in shard.targets]
    assert len(built) == len(set(built)), "an image is built twice"
    assert set(built) == wanted
    for shard in found.shards:
        place = {target: index for index, target in enumerate(shard.targets)}
        for target in shard.targets:
            image = big.by_target[target]
            assert place.get(image.parent, -1) < place[target], "an image stands before what it stands on"
            assert set(image.parts) <= set(shard.parts)
    for architecture in ("amd64", "arm64"):
        seconds = [shard.seconds for shard in found.shards if shard.architecture == architecture]
        assert seconds == sorted(seconds, reverse=True)


@pytest.mark.parametrize("number", [4, 8, 12])
def test_balanced(big: ImageSet, number: int) -> None:
    """No shard takes longer than its fair share of all the work and the longest unit together."""
    units = dealing.deal(big, 99).shards
    longest = max(unit.seconds for unit in units)
    shards = dealing.deal(big, number).shards
    assert max(shard.seconds for shard in shards) <= sum(unit.seconds for unit in units) / number + longest


def test_more_machines_never_take_longer(big: ImageSet) -> None:
    times = [max(shard.seconds for shard in dealing.deal(big, number).shards) for number in range(2, 22)]
    assert times == sorted(times, reverse=True)
    assert times[0] > 4 * times[-1]


def test_same_input_same_bytes(big: ImageSet) -> None:
    text = dealing.as_json(dealing.deal(big, 7))
    assert text == dealing.as_json(dealing.deal(parse(synthetic.matrix(10 * synthetic.IMAGES)), 7, everything))
    assert re.findall(r"\b20\d\d-\d\d-\d\d\b", text) == []


def test_order_of_the_matrix_does_not_make_it_worse() -> None:
    head, _, rows = synthetic.matrix(5 * synthetic.IMAGES).partition("distributions:\n")
    orders = list(permutations(rows.splitlines()))[::20]
    times = set()
    for order in orders:
        image_set = parse("\n".join([f"{head}distributions:", *order, ""]))
        times.add(max(shard.seconds for shard in dealing.deal(image_set, 4).shards))
    assert len(times) == 1


def test_work_grows_with_the_images_and_not_with_their_square() -> None:
    """Ten times the images; with their square it would be 100 times the work."""
    few, many = (parse(synthetic.matrix(images)) for images in (400, 4_000))
    assert calls(lambda: dealing.deal(many, 20)) < 12 * calls(lambda: dealing.deal(few, 20))


# ---- Errors ----------------------------------------------------------------------------------------------------------

ERRORS: dict[str, tuple[str, int, str, str]] = {
    "too few": (SMALL, 1, "2 architectures (amd64, arm64) do not fit in 1 shard:", "--shards 2"),
    "no runner": (changed(", runner: arm", ""), 2, "architectures.arm64: 'runner' is missing", "runner: ubuntu-24.04"),
}


@pytest.mark.parametrize("name", ERRORS)
def test_errors(name: str) -> None:
    text, number, message, remedy = ERRORS[name]
    with pytest.raises(RosmlError) as caught:
        dealing.deal(parse(text), number)
    assert message in caught.value.message
    assert remedy in caught.value.remedy
    assert caught.value.exit_code == 2


def test_an_architecture_that_nothing_is_built_for_needs_no_runner() -> None:
    text = changed(", runner: arm", "", changed("default_stack: cpu", "default_stack: cu1"))
    text = text.replace("architectures: [amd64, arm64]", "architectures: [amd64]")
    assert [shard.architecture for shard in dealing.deal(parse(text), 1).shards] == ["amd64"]


@pytest.mark.parametrize("shards", [0, -1])
def test_no_machines(shards: int, small: ImageSet) -> None:
    with pytest.raises(RosmlError) as caught:
        dealing.deal(small, shards)
    assert (caught.value.message, caught.value.exit_code) == (f"{shards} machines can build nothing", 2)
    assert caught.value.remedy == "say how many there are, one or more: rosml generate --shards 8"


def test_nothing_to_plan(small: ImageSet) -> None:
    with pytest.raises(RosmlError, match="nothing to plan") as caught:
        dealing.deal(small, 2, lambda image: False)
    assert "rosml locks" in caught.value.remedy


@pytest.mark.parametrize("rate", ["0", "-1", "2.5", "fast", "100000"])
def test_rates_that_are_none(rate: str) -> None:
    with pytest.raises(RosmlError, match=r"matrix.yaml:\d+:\d+: rates.packages: expected"):
        parse(changed("{packages: 10,", f"{{packages: {rate},"))


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def small_file(tmp_path: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with the small matrix and all of its locks: what has none is in no plan."""
    monkeypatch.setattr(generate_bake, "ROOT", tmp_path)
    write_locks(tmp_path, small)
    file = tmp_path / "matrix.yaml"
    file.write_text(SMALL)
    return file


def test_what_has_no_lock_is_in_no_plan(small_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (small_file.parent / "locks/cu1/amd64/3.12/torch.txt").unlink()
    assert run("--matrix", small_file, "--shards", "3", "--json") == 0
    targets = {target for shard in json.loads(capsys.readouterr().out)["shards"] for target in shard["targets"]}
    assert "alpha-core-torch-cu1" not in targets
    assert {"alpha-core", "alpha-core-torch-cpu", "omega-core-torch-cu1"} <= targets


def test_the_table_counts_what_has_no_lock(small_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (small_file.parent / "locks/cu1/amd64/3.12/torch.txt").unlink()
    assert run("--matrix", small_file, "--shards", "4") == 0
    assert capsys.readouterr().out.splitlines()[-1] == "left out: 6 images without a lock; see them with: rosml list"


def run(*arguments: str | Path) -> int:
    return command.run(generate_bake.main, arguments=[*map(str, arguments)])


def test_json(small: ImageSet, small_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("--matrix", small_file, "--shards", "3", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["version"] == 1
    assert found["shards"] == [dealing.facts(shard) for shard in dealing.deal(small, 3).shards]
    assert found["shards"][0].keys() == {
        "name", "architecture", "platform", "runner", "distributions", "targets", "parts", "estimates",
    }  # fmt: skip
    assert found["shards"][0]["estimates"].keys() == {"download_mb", "disk_mb", "seconds"}


def test_output(small: ImageSet, small_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = small_file.with_name("plan.json")
    assert run("--matrix", small_file, "--shards", "3", "--output", output) == 0
    assert output.read_text() == dealing.as_json(dealing.deal(small, 3))
    done = capsys.readouterr()
    assert (done.out, "plan.json: written" in done.err) == ("", True)


def test_table(small_file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("--matrix", small_file, "--shards", "9") == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].split() == ["amd64-1", "amd", "alpha", "12", "5", "2", "0.5", "12.8"]
    assert lines[5] == "estimates: 2 minutes until all is built, 5 minutes of machines"
    assert lines[6].startswith("4 shards instead of 9:")


def test_the_real_matrix_has_a_plan(real: ImageSet) -> None:
    units = {(image.distribution, name) for image in real.images for name in image.architectures}
    assert len(dealing.deal(real, 100).shards) == len(units)
    assert (ROOT / "matrix.yaml").read_text().count("runner:") == len(real.matrix.architectures)
