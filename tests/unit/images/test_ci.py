"""What jobs in CI are told, and which images a pull request builds."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import SMALL, SMALLER, changed, parse

from fakes.memory_registry import DAY, HOST, NEXT, PREFIX, Publisher, publisher, steps
from fakes.projects import copy, diff
from fakes.stubs import NO_FORMAT_1, services
from rosml.base import github, units
from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.cli.images import locks as lock
from rosml.cli.images import plan, publish, report
from rosml.cli.images.call import Call
from rosml.images.bake import diff as differences
from rosml.images.bake import pull_request
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import disk
from rosml.images.image_set import locked, missing
from rosml.images.image_set.model import ImageSet
from rosml.images.locks.resolve import Move
from rosml.images.matrix.sizes import Size
from rosml.images.publish import revision
from rosml.images.publish.plan import Plan, make_plan, read_plan
from rosml.images.publish.steps import STEPS
from rosml.images.records.store import Entry


@pytest.fixture
def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the files that CI reads: summary and output."""
    for name in (github.SUMMARY, github.OUTPUT):
        monkeypatch.setenv(name, str(tmp_path / name))
    return tmp_path


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_nobody_is_told_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in (github.SUMMARY, github.OUTPUT):
        monkeypatch.delenv(name, raising=False)
    github.summary("text")
    github.output("name", "value")
    assert [*tmp_path.iterdir()] == [] and capsys.readouterr() == ("", "")


def test_outputs_and_summaries_add_up(told: Path) -> None:
    github.output("one", "1")
    github.output("two", "[]")
    github.summary(github.table(("a", "b"), [("x|y", "1\n2")]))
    assert (told / github.OUTPUT).read_text() == "one=1\ntwo=[]\n"
    assert (told / github.SUMMARY).read_text() == "| a | b |\n| --- | --- |\n| x\\|y | 1<br>2 |\n"


def test_an_output_sets_no_other_one(told: Path) -> None:
    with pytest.raises(ValueError, match="several lines"):
        github.output("one", "1\ntwo=2")


# ---- Plan ------------------------------------------------------------------------------------------------------------


def content(registry: Publisher, image_set: ImageSet, **options: Any) -> tuple[dict[str, Any], Plan]:
    plan = make_plan(registry.run(image_set, **options).state, 4)
    return json.loads(plan.text()), plan


def test_a_plan_is_the_matrix_of_the_jobs_that_build(registry: Publisher, image_set: ImageSet, told: Path) -> None:
    plan, told_of = content(registry, image_set)
    report.plan_to_ci(told_of, "it costs a minute")
    name, _, value = (told / github.OUTPUT).read_text().partition("=")
    assert name == "shards"
    shards = json.loads(value)
    assert shards == [{"name": item["name"], "runner": item["runner"]} for item in plan["shards"]]
    assert {(item["name"].split("-")[0], item["runner"]) for item in shards} == {("amd64", "amd"), ("arm64", "arm")}
    summary = (told / github.SUMMARY).read_text()
    assert f"## Plan of {DAY} for {HOST}/{PREFIX}" in summary and "\n- it costs a minute\n" in summary
    assert "| amd64-1 | amd |" in summary
    assert "- up to date: 0" in summary


def test_a_plan_names_what_changed_when_asked(
    registry: Publisher, image_set: ImageSet, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    registry.publish(image_set)
    script = project / "components/torch/files.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.run(image_set, date=NEXT)
    named = {
        task["target"]: task.get("inputs") for task in json.loads(make_plan(run.state, 4, why=True).text())["tasks"]
    }
    assert named["part-torch-cu1-py312"] == ["components/torch/files.sh"]
    assert named["alpha-core-torch-cu1"], "what it reaches is named as well"
    assert not any("inputs" in task for task in json.loads(make_plan(run.state, 4).text())["tasks"])
    for why in (True, False):
        report.print_plan(run.state, why)
        said = capsys.readouterr().out
        assert ("changed: components/torch/files.sh" in said) == why
        parts = sum(name.startswith("part-") for name in named)
        kinds = f"{len(named) - parts} images and {parts} parts, each counted by architecture"
        counts = f"{len(named)} to do ({kinds}), {len(run.state.items) - len(named)} up to date\n"
        assert said.endswith(counts) and "its inputs changed" in said


def test_without_rates_all_the_same_machines_build(registry: Publisher, image_set: ImageSet) -> None:
    """How fast they are only balances them."""
    without = parse(changed("rates: {packages: 10, parts: 100, test: 5, carried: 1}\n", "", SMALLER))
    plan, _ = content(registry, without)
    shards = [shard["name"] for shard in plan["shards"]]
    assert shards == [shard["name"] for shard in content(registry, image_set)[0]["shards"]] != []


def test_people_see_which_machine_builds_what(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = registry.run
    monkeypatch.setattr(Call, "survey", lambda call: run(image_set, architectures=call.architectures).state)
    done = CliRunner().invoke(plan.main, ["--everywhere", "--shards", "3"])
    rows = [line.split() for line in done.output.splitlines() if line.startswith(("amd64-", "arm64-"))]
    assert [row[:3] for row in rows] == [
        ["amd64-1", "amd", "alpha"],
        ["amd64-2", "amd", "omega"],
        ["arm64-1", "arm", "alpha,"],
    ]
    images = sum(int(row[-5]) for row in rows)
    said = f"({images} images and 13 parts, each counted by architecture)"
    assert said in done.output, "two machines build one of the parts"


def test_a_plan_for_this_machine_needs_no_machines_in_ci(
    registry: Publisher, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    alone = parse(SMALLER.replace(", runner: amd", "").replace(", runner: arm", ""))
    monkeypatch.setattr(Call, "survey", lambda _: registry.run(alone).state)
    assert CliRunner().invoke(plan.main, []).exit_code == 0
    done = CliRunner().invoke(plan.main, ["--output", str(tmp_path / "plan.json")])
    assert isinstance(done.exception, RosmlError) and "'runner' is missing" in done.exception.message


def test_where_nothing_is_to_be_done_no_job_builds(registry: Publisher, image_set: ImageSet, told: Path) -> None:
    registry.publish(image_set)
    report.plan_to_ci(content(registry, image_set, date=NEXT)[1], "")
    assert (told / github.OUTPUT).read_text() == "shards=[]\n"
    assert "- nothing to do" in (told / github.SUMMARY).read_text()


def test_what_lacks_a_lock_has_a_line_of_its_own(
    registry: Publisher, image_set: ImageSet, project: Path, told: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In plans and after runs: whichever lock it is, and whatever else waits or failed."""
    gone = {name for name in image_set.locks if name.endswith("amd64/3.12/torch.txt")}
    for name in gone:
        (project / name).unlink()
    lacking = locked.with_locks(image_set, image_set.locks - gone)
    images = counted(sum(not image.locked for image in lacking.images), "image")
    run = registry.run(lacking)
    report.print_plan(run.state, why=False)
    *_, counts, line = capsys.readouterr().out.splitlines()
    assert counts.endswith(" up to date")
    assert line == f"{images} without a lock, which cannot be built yet: {missing.RESTORE}"
    report.plan_to_ci(make_plan(run.state, 4), "")
    assert f"\n- without a lock: {images}, which cannot be built yet\n" in (told / github.SUMMARY).read_text()
    (told / github.SUMMARY).unlink()
    report.show(registry.publish(lacking, broken={"omega-core"}), as_json=False)
    for said, mark in ((capsys.readouterr().out, ""), ((told / github.SUMMARY).read_text(), "- ")):
        assert "building omega-core failed" in said and "locks/" not in said
        waits = [line for line in said.splitlines() if line.startswith(f"{mark}waits: ") and "lock" in line]
        parts = sum(bool(part.unlocked) for part in lacking.parts)
        assert waits == [f"{mark}waits: {int(images.split()[0]) + parts} without a lock"]


def test_what_is_only_to_be_tested_has_a_machine(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    test = project / "tests/structure/torch.yaml"
    test.write_text(test.read_text() + "# another\n")
    plan, _ = content(registry, image_set, date=NEXT)
    assert {step for task in plan["tasks"] for step in task["steps"]} == {"test"}
    assert {shard["architecture"] for shard in plan["shards"]} == {"amd64", "arm64"}
    tested = {task["target"] for task in plan["tasks"]}
    assert tested <= {target for shard in plan["shards"] for target in shard["targets"]}


def test_all_machines_build_what_is_served(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.run(image_set, architectures=("amd64",), serving=("amd64",))
    shards = make_plan(run.state, 2).shards
    assert [shard.name for shard in shards] == ["amd64-1", "amd64-2"]


def test_estimates_count_what_is_built_and_tested(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    """One part changed: its parts, and tests of the images that have it; no ROS image, no other part."""
    registry.publish(image_set)
    script = project / "components/torch/files.sh"
    script.write_text(script.read_text() + "# a change\n")
    plan, _ = content(registry, image_set, date=NEXT)
    rates = image_set.matrix.rates
    assert plan["shards"]
    for shard in plan["shards"]:
        tasks = [task for task in plan["tasks"] if task["architecture"] == shard["architecture"]]
        tested = [task for task in tasks if "test" in task["steps"] and task["target"] in shard["targets"]]
        built = [task["target"].removeprefix("part-") for task in tasks if "build" in task["steps"]]
        sizes = [image_set.part_by_name[name].disk.unpacked for name in built if name in shard["parts"]]
        assert tested and sizes
        carriers = [task for task in tested if image_set.by_target[task["target"]].carriers[:1] == (task["target"],)]
        seconds = sum(-(-size // rates.parts) for size in sizes)
        seconds += rates.test * len(tested) + rates.carried * len(carriers)
        assert shard["estimates"]["seconds"] == seconds


def test_estimates_take_the_sizes_that_earlier_runs_measured(registry: Publisher, image_set: ImageSet) -> None:
    """The largest of all architectures; what stands on a measured image adds to it what the matrix says."""
    run = registry.run(image_set)
    before, planned = run.state.forecast, make_plan(run.state, 4)
    assert before == image_set
    for architecture, unpacked in (("amd64", 4_000), ("arm64", 4_500)):
        entry = Entry("alpha-core", architecture, unpacked=unpacked * 1_000_000, size=1_000_000_000)
        run.state.entries["alpha-core", architecture] = entry
    del run.state.__dict__["forecast"]
    core, base = (image_set.image(name).disk for name in ("alpha-core", "alpha-base"))
    found = run.state.forecast
    assert found.image("alpha-core").disk == Size(unpacked=4_500, compressed=1_000)
    assert found.image("alpha-base").disk == Size.total(found.image("alpha-core").disk, base - core)
    assert found.image("omega-core").disk == image_set.image("omega-core").disk
    shards = {shard.name: shard for shard in make_plan(run.state, 4).shards}
    for shard in planned.shards:
        more = shards[shard.name].estimates.disk_mb - shard.estimates.disk_mb
        grown = 4_500 - core.unpacked + 2 * (1_000 - core.compressed)
        assert more == (grown if "alpha" in shard.distributions else 0)
    needed = [disk.needed_mb(images, image_set.image("alpha-base"), set()) for images in (image_set, found)]
    assert needed[1] - needed[0] == grown


def test_what_is_only_to_be_scanned_needs_none(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    plan, _ = content(registry, image_set, date=NEXT, scanning="sha256:1")
    assert {step for task in plan["tasks"] for step in task["steps"]} == {"scan"}
    assert plan["shards"] == []


def test_steps_take_from_the_plan_what_it_was_called_with(
    registry: Publisher, image_set: ImageSet, tmp_path: Path
) -> None:
    _, whole = content(registry, image_set, force=True, serving=("amd64",))
    (tmp_path / "plan.json").write_text(whole.text())
    assert read_plan(tmp_path / "plan.json") == whole
    planned = read_plan(tmp_path / "plan.json", "arm64-1")
    assert (planned.date, planned.registry, planned.force) == (DAY, f"{HOST}/{PREFIX}", True)
    assert (planned.serve, planned.architectures) == (("amd64",), ("arm64",))


@pytest.mark.parametrize(
    "change",
    [
        {"version": 2},
        {"date": 5},
        {"date": "today"},
        {"registry": 5},
        {"targets": "alpha-core"},
        {"targets": []},
        {"targets": [1]},
        {"architectures": []},
        {"architectures": [1]},
        {"serve": "amd64"},
        {"force": "no"},
        {"shards": [{"name": []}]},
    ],
)
def test_a_plan_that_is_none(
    registry: Publisher, image_set: ImageSet, tmp_path: Path, change: dict[str, object]
) -> None:
    """Above all: one that names nothing does not stand for everything."""
    plan, _ = content(registry, image_set)
    (tmp_path / "plan.json").write_text(json.dumps(plan | change))
    with pytest.raises(RosmlError) as caught:
        read_plan(tmp_path / "plan.json")
    assert caught.value.exit_code == 2
    (tmp_path / "plan.json").write_text("[" * 100_000)
    with pytest.raises(RosmlError, match="is no plan"):
        read_plan(tmp_path / "plan.json")


@pytest.mark.parametrize(("text", "says"), NO_FORMAT_1)
def test_what_is_wrong_with_a_plan_is_said_in_words(tmp_path: Path, text: bytes, says: str) -> None:
    (tmp_path / "plan.json").write_bytes(text)
    with pytest.raises(RosmlError, match=f"is no plan of this version: {says}") as caught:
        read_plan(tmp_path / "plan.json")
    assert "\n" not in caught.value.message and "pydantic" not in caught.value.message
    assert caught.value.remedy == "write it again with: rosml plan --output FILE"


def test_force_makes_everything_anew_once_on_several_machines(registry: Publisher, image_set: ImageSet) -> None:
    """Each step in a process of its own, as jobs in CI run it."""
    first = registry.publish(image_set)
    made = []
    for step in STEPS:
        run = registry.run(image_set, date=NEXT, force=True)
        STEPS[step](run)
        made += run.made
        assert not [outcome for outcome in run.outcomes if outcome.state == "waits"]
    kinds = ("build", "join")
    assert sorted(item for item in made if item[0] in kinds) == sorted(item for item in first.made if item[0] in kinds)


# ---- Fields of a form ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "only", "serve", "place"),
    [
        (["--only", "", "--serve", "", "--registry", ""], (), (), ""),
        (["--only", "a-* b-*", "--only", "c", "--serve", "amd64 arm64"], ("a-*", "b-*", "c"), ("amd64", "arm64"), ""),
        (["--registry", "ghcr.io/Me/Ros-ML"], (), (), "ghcr.io/me/ros-ml"),
    ],
)
def test_fields_may_be_empty_or_hold_several(
    monkeypatch: pytest.MonkeyPatch, arguments: list[str], only: tuple[str, ...], serve: tuple[str, ...], place: str
) -> None:
    seen: list[Call] = []

    class Stop(Exception):
        pass

    def stop(call: Call) -> None:
        seen.append(call)
        raise Stop

    monkeypatch.setattr(Call, "survey", stop)
    CliRunner().invoke(plan.main, ["--everywhere", *arguments])
    (call,) = seen
    assert (call.only, call.serve, call.registry) == (only, serve, place)
    assert call.architectures == (serve or ("amd64", "arm64"))


# ---- Pull requests ---------------------------------------------------------------------------------------------------


def reached(project: Path, file: str) -> tuple[ImageSet, differences.Difference]:
    old = Inputs(copy(project.parent / "old"), parse(SMALL))
    path = project / file
    path.write_text(path.read_text() + "# a change\n")
    new = parse(SMALL)
    write = locked.with_locks(new, frozenset(lock for image in new.images for lock in image.locks))
    return write, differences.between(old, Inputs(project, new))


def test_few_images_have_all_that_changed(project: Path) -> None:
    image_set, found = reached(project, "components/torch/files.sh")
    choice = pull_request.choose(image_set, found, ("amd64",), 3)
    assert len(choice.built) == 3
    assert all("torch" in image_set.by_target[target].versions for target in choice.built)
    assert not set(choice.built) & set(choice.left_out)
    images = [image_set.by_target[target] for target in choice.built]
    assert len({image.distribution for image in images}) > 1
    one = pull_request.choose(image_set, found, ("amd64",), 1)
    assert one.built == choice.built[:1]
    assert f"; left out, {len(one.left_out)} of {len(one.left_out) + 1}: " in str(one)


def test_of_alike_ones_the_smallest(project: Path) -> None:
    image_set, found = reached(project, "components/ros/install.sh")
    best = image_set.by_target[pull_request.choose(image_set, found, ("amd64",), 1).built[0]]
    alike = [
        image
        for image in image_set.images
        if image.target in found.changed
        and set(found.changed[image.target]) == set(found.changed[best.target])
        and len(image.groups) == len(best.groups)
    ]
    assert best.disk.unpacked == min(image.disk.unpacked for image in alike)


def test_what_cannot_be_built_here_is_counted(project: Path) -> None:
    image_set, found = reached(project, "components/ros/install.sh")
    nowhere = pull_request.choose(image_set, found, ("riscv64",), 3)
    assert (nowhere.built, nowhere.left_out) == ((), ())
    assert str(nowhere) == f"0 images changed; {len(found.changed)} more for other architectures"
    unlocked = pull_request.choose(locked.with_locks(image_set, frozenset()), found, ("amd64",), 99)
    assert {image_set.by_target[target].stack for target in unlocked.built} == {None}
    assert unlocked.unlocked


def test_no_image_changed(monkeypatch: pytest.MonkeyPatch, told: Path) -> None:
    """Then nothing is built, rather than everything, which is what no pattern stands for."""
    same = differences.Difference((), (), {}, same=1)
    monkeypatch.setattr(revision, "since", lambda *_: same)
    monkeypatch.setattr(publish, "ROOT", told)  # its lock is not this checkout's, which a publishing run may have
    from rosml.machine.services import Services

    monkeypatch.setattr(Services, "load", lambda root, required: None)
    done = CliRunner().invoke(publish.main, ["all", "--since", "HEAD", "--json"])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout) == {"counts": {}, "outcomes": []}
    assert "0 images changed" in (told / github.SUMMARY).read_text()
    both = CliRunner().invoke(publish.main, ["all", "--since", "HEAD", "--only", "ros1-bookworm-core"])
    assert both.exit_code == 2
    assert "leave --only out" in both.output


def test_the_difference_is_in_the_summary(repository: Path, told: Path) -> None:
    path = repository / "components/torch/files.sh"
    path.write_text(path.read_text() + "# a change\n")
    assert diff(repository, "HEAD").returncode == 0
    text = (told / github.SUMMARY).read_text()
    assert text.startswith("\n## What differs\n\n0 added, 0 removed, ")
    assert "| changed | cannot be built yet: no lock |" in text or "| changed | file " in text


def test_versions_that_moved_are_the_text_of_a_pull_request() -> None:
    moved = {Move("cpu", "torch", "2.10.0", "2.11.0"): 6, Move("cpu", "gone", "1", ""): 1}
    text = lock.markdown(moved, ["locks/cu1/amd64/py312/torch.txt"], {"stack cu2": "no answer"})
    assert "| cpu | torch | 2.10.0 | 2.11.0 | 6 |\n" in text
    assert "| cpu | gone | 1 | - | 1 |\n" in text
    assert "- new: `locks/cu1/amd64/py312/torch.txt`\n- stack cu2: no new lock: no answer\n" in text
    assert lock.markdown({}, [], {}) == "No version moved.\n"


# ---- What a run did --------------------------------------------------------------------------------------------------


def test_a_run_says_what_it_uploaded(
    registry: Publisher, image_set: ImageSet, capsys: pytest.CaptureFixture[str], told: Path
) -> None:
    """Layers that the builder pushed, without those of the image below, and what the publisher itself wrote."""
    run = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",))
    report.show(run, as_json=True)
    said = json.loads(capsys.readouterr().out)
    built = {item["target"]: item["uploaded"] for item in said["outcomes"] if item["step"] == "build"}
    own = len("alpha-base 1 amd64")
    assert run.pushed == own + len("alpha-core 1 amd64"), "a layer of the image below was counted twice"
    assert built["alpha-base"] > own and sum(built.values()) < said["uploaded"]
    assert said["seconds"] >= 0
    report.show(run, as_json=False)
    text = f"{units.size(said['uploaded'])} uploaded, "
    assert text in capsys.readouterr().out and f"- {text}" in (told / github.SUMMARY).read_text()
    registry.registry.uploaded = 0
    nothing = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",), date=NEXT)
    report.show(nothing, as_json=False)
    assert "everything is up to date\n0 B uploaded, " in capsys.readouterr().out
    registry.packages["alpha"] = "tuesday"
    same = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",), date=NEXT)
    assert steps(same, "build") and same.pushed == 0, "the same layers were counted again"


def test_the_summary_of_a_job_has_a_row_for_all_that_was_done(
    registry: Publisher, image_set: ImageSet, told: Path
) -> None:
    """Step, image, architecture, state, time, size, digest; what failed with why, what was left alone as a count."""
    registry.publish(image_set, only=["omega-core"])
    run = registry.publish(image_set, only=["*-core", "alpha-base"], date=NEXT, broken={"alpha-base"})
    report.show(run, as_json=False)
    text = (told / github.SUMMARY).read_text()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("| ")]
    head, _, *rest = rows
    assert head == ["step", "image", "architecture", "state", "time", "size", "digest", "what"]
    found = {tuple(row[:3]): row[3:] for row in rest}
    entry = run.state.entries["alpha-core", "amd64"]
    state, _, size, digest, _ = found["build", "`alpha-core`", "amd64"]
    assert (state, size, digest) == ("done", units.size(entry.size), f"`{entry.digest[:19]}`")
    assert entry.size and entry.digest.startswith("sha256:")
    state, _, size, digest, what = found["build", "`alpha-base`", "amd64"]
    assert (state, size, digest, what) == ("failed", "", "", "building alpha-base failed")
    assert found["promote", "`alpha-core`", ""][0] == "done"
    assert not [key for key in found if "omega" in key[1]]
    unchanged = sum(item.thing.target == "omega-core" for item in run.state.items)
    assert unchanged == 2 and f"- {unchanged} up to date, left alone\n" in text
    assert "- build: 2 done\n" in text and "- build: 2 failed\n" in text
