"""What jobs in CI are told, and which images a pull request builds."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import SMALL, SMALLER, parse

from fakes.memory_registry import DAY, HOST, NEXT, PREFIX, Publisher, publisher, steps
from fakes.projects import copy
from fakes.stubs import services
from rosml.base import github, units
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, some
from rosml.cli import command
from rosml.cli.images import plan, publish, report
from rosml.cli.images.call import Call
from rosml.images.bake import diff as differences
from rosml.images.bake import pull_request
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import disk
from rosml.images.image_set import locked, missing_locks
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix.sizes import Size
from rosml.images.publish import revision, status
from rosml.images.publish.plan import Plan, make_plan, read_plan
from rosml.images.records.store import Entry


@pytest.fixture
def ci(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the files that CI reads: summary and output."""
    for name in (github.SUMMARY, github.OUTPUT):
        monkeypatch.setenv(name, str(tmp_path / name))
    return tmp_path


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_outputs_and_summaries_add_up(ci: Path) -> None:
    with pytest.raises(ValueError, match="several lines"):
        github.output("one", "1\ntwo=2")
    github.output("one", "1")
    github.output("two", "[]")
    github.summary(github.table(("a", "b"), [("x|y", "1\n2")]))
    assert (ci / github.OUTPUT).read_text() == "one=1\ntwo=[]\n"
    assert (ci / github.SUMMARY).read_text() == "| a | b |\n| --- | --- |\n| x\\|y | 1<br>2 |\n"


# ---- Plan ------------------------------------------------------------------------------------------------------------


def content(registry: Publisher, image_set: ImageSet, **options: Any) -> tuple[dict[str, Any], Plan]:
    plan = make_plan(registry.run(image_set, **options).state, 4)
    return json.loads(plan.text()), plan


def test_a_plan_is_the_matrix_of_the_jobs_that_build(registry: Publisher, image_set: ImageSet, ci: Path) -> None:
    plan, made_plan = content(registry, image_set)
    report.plan_to_ci(made_plan, image_set, "it costs a minute")
    name, _, value = (ci / github.OUTPUT).read_text().partition("=")
    assert name == "shards"
    shards = json.loads(value)
    assert shards == [{"name": item["name"], "runner": item["runner"]} for item in plan["shards"]]
    assert {(item["name"].split("-")[0], item["runner"]) for item in shards} == {("amd64", "amd"), ("arm64", "arm")}
    summary = (ci / github.SUMMARY).read_text()
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
    inputs = {
        task["target"]: task.get("inputs") for task in json.loads(make_plan(run.state, 4, why=True).text())["tasks"]
    }
    assert inputs["part-torch-cu1-py312"] == ["components/torch/files.sh"]
    assert inputs["alpha-core-torch-cu1"], "what it reaches is inputs as well"
    assert not any("inputs" in task for task in json.loads(make_plan(run.state, 4).text())["tasks"])
    for why in (True, False):
        report.print_plan(run.state, why)
        printed = capsys.readouterr().out
        assert ("changed: components/torch/files.sh" in printed) == why
        parts = sum(name.startswith("part-") for name in inputs)
        kinds = f"{len(inputs) - parts} images and {parts} parts, each counted by architecture"
        counts = f"{len(inputs)} to do ({kinds}), {len(run.state.items) - len(inputs)} up to date\n"
        assert printed.endswith(counts) and "its inputs changed" in printed


def test_a_plan_for_this_machine_needs_no_machines_in_ci(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(Call, "survey", lambda _: registry.run(image_set).state)
    output = CliRunner().invoke(plan.main, ["--everywhere", "--shards", "3"]).output
    rows = [line.split()[:3] for line in output.splitlines() if line.startswith(("amd64-", "arm64-"))]
    assert rows == [["amd64-1", "amd", "alpha"], ["amd64-2", "amd", "omega"], ["arm64-1", "arm", "alpha,"]]
    alone = parse(SMALLER.replace(", runner: amd", "").replace(", runner: arm", ""))
    monkeypatch.setattr(Call, "survey", lambda _: registry.run(alone).state)
    assert CliRunner().invoke(plan.main, []).exit_code == 0
    done = CliRunner().invoke(plan.main, ["--output", str(tmp_path / "plan.json")])
    assert isinstance(done.exception, RosmlError) and "'runner' is missing" in done.exception.message


def test_no_machine_is_planned_where_nothing_is_built_or_tested(
    registry: Publisher, image_set: ImageSet, ci: Path
) -> None:
    registry.publish(image_set)
    report.plan_to_ci(content(registry, image_set, date=NEXT)[1], image_set, "")
    assert (ci / github.OUTPUT).read_text() == "shards=[]\n"
    assert "- nothing to do" in (ci / github.SUMMARY).read_text()
    scan, _ = content(registry, image_set, date=NEXT, scanning="sha256:1")
    assert ({step for task in scan["tasks"] for step in task["steps"]}, scan["shards"]) == ({"scan"}, [])


def test_what_lacks_a_lock_is_named_with_the_lock_and_the_command_that_makes_it(
    registry: Publisher, image_set: ImageSet, project: Path, ci: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    torch_locks = {name for name in image_set.locks if name.endswith("amd64/3.12/torch.txt")}
    for name in torch_locks:
        (project / name).unlink()
    lacking = locked.with_locks(image_set, image_set.locks - torch_locks)
    images = counted(sum(not image.locked for image in lacking.images), "image")
    run = registry.run(lacking)
    report.print_plan(run.state, why=False)
    *_, counts, line = capsys.readouterr().out.splitlines()
    assert counts.endswith(" up to date")
    text = f"{images} without a lock, which cannot be built yet: {missing_locks.RESTORE}"
    assert line == command.as_called(text) != text
    report.plan_to_ci(make_plan(run.state, 4), lacking, "")
    summary = (ci / github.SUMMARY).read_text()
    assert f"\n- {text}\n" in summary
    head, _, names = summary.partition("left out: `lock missing: locks/cu1/amd64/3.12/torch.txt`\n")
    unlocked = [image.target for image in lacking.images if not image.locked]
    assert len(unlocked) > 1 and all(f"`{target}`" in names for target in unlocked) and "left out" not in head + names
    (ci / github.SUMMARY).unlink()
    report.show(registry.publish(lacking, broken={"omega-core"}), as_json=False)
    for text, mark in ((capsys.readouterr().out, ""), ((ci / github.SUMMARY).read_text(), "- ")):
        assert "building omega-core failed" in text and "locks/" not in text
        waits = [line for line in text.splitlines() if line.startswith(f"{mark}waits: ") and "lock" in line]
        parts = sum(bool(part.unlocked) for part in lacking.parts)
        assert waits == [f"{mark}waits: {int(images.split()[0]) + parts} without a lock"]


def test_a_run_says_first_what_waits_and_for_what(
    registry: Publisher, image_set: ImageSet, project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lock = "locks/cu1/amd64/3.12/torch.txt"
    (project / lock).unlink()
    lacking = locked.with_locks(image_set, image_set.locks - {lock})

    def first_lines(serving: tuple[str, ...]) -> list[str]:
        monkeypatch.setattr(Call, "run", lambda _: registry.run(lacking, serving=serving, architectures=("amd64",)))
        lines = CliRunner().invoke(publish.main, ["all"]).stderr.splitlines()
        return [line.removeprefix("==> ") for line in lines if line.startswith("==> ")]

    unlocked, remedy, elsewhere = first_lines(())
    images = [image.target for image in lacking.images if not image.locked]
    part = next(part.target for part in lacking.parts if part.unlocked)
    assert unlocked == f"{some([part, *images])} wait: lock missing: {lock}"
    assert remedy == command.as_called(
        f"{len(images)} images without a lock, which cannot be built yet: {missing_locks.RESTORE}"
    )
    assert elsewhere == (
        "arm64 waits for a machine: tags move when a machine for arm64 has published its images, too; for amd64 alone, add"
        " --serve amd64"
    )
    assert first_lines(("amd64",)) == [unlocked, remedy], "nothing waits for a machine"


@pytest.mark.parametrize("is_damaged", [False, True])
def test_a_night_fails_for_a_damaged_lock_and_not_for_a_missing_one(
    is_damaged: bool, registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    lock = "locks/cu1/amd64/3.12/torch.txt"
    (project / lock).unlink()
    lacking = locked.with_locks(image_set, image_set.locks - {lock}, {lock} if is_damaged else ())
    run = registry.publish(lacking)
    assert run.failed is is_damaged
    unlocked = {image.target for image in lacking.images if not image.locked}
    assert {outcome.target for outcome in run.outcomes if outcome.state == "failed"} == (
        unlocked if is_damaged else set()
    )
    states = {image.target: image.state for image in status.read(run.state, DAY)}
    assert {states[target] for target in unlocked} == {"failed" if is_damaged else "lock missing"}
    assert states["omega-core-torch-cu1"] == "published"


def test_what_is_only_to_be_tested_has_a_machine(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    test = project / "tests/structure/torch.yaml"
    test.write_text(test.read_text() + "# another\n")
    plan, _ = content(registry, image_set, date=NEXT)
    assert {step for task in plan["tasks"] for step in task["steps"]} == {"test"}
    assert {shard["architecture"] for shard in plan["shards"]} == {"amd64", "arm64"}
    tested = {task["target"] for task in plan["tasks"]}
    assert tested <= {target for shard in plan["shards"] for target in shard["targets"]}


def test_estimates_take_the_sizes_and_times_that_earlier_runs_measured(
    registry: Publisher, image_set: ImageSet
) -> None:
    run = registry.run(image_set)
    before, planned = run.state.forecast, make_plan(run.state, 4)
    assert before == image_set
    for architecture, unpacked in (("amd64", 4_000), ("arm64", 4_500)):
        facts: dict[str, Any] = {"unpacked": unpacked * 1_000_000, "size": 1_000_000_000, "seconds": {"test": 1_000.0}}
        entry = Entry("alpha-core", architecture, **facts)
        run.state.entries["alpha-core", architecture] = entry
    del run.state.__dict__["forecast"]
    core, base = (image_set.image(name).disk for name in ("alpha-core", "alpha-base"))
    forecast = run.state.forecast
    assert forecast.image("alpha-core").disk == Size(unpacked=4_500, compressed=1_000)
    assert forecast.image("alpha-base").disk == Size.total(forecast.image("alpha-core").disk, base - core)
    assert forecast.image("omega-core").disk == image_set.image("omega-core").disk
    shards = {shard.name: shard for shard in make_plan(run.state, 4).shards}
    assert max(shard.estimates.seconds for shard in planned.shards) < 1_000
    assert sum(shard.estimates.seconds >= 1_000 for shard in shards.values()) == 2, "one of each architecture"
    for shard in planned.shards:
        more = shards[shard.name].estimates.disk_mb - shard.estimates.disk_mb
        grown = 4_500 - core.unpacked + 2 * (1_000 - core.compressed)
        assert more == (grown if "alpha" in shard.distributions else 0)
    needed = [disk.needed_mb(images, image_set.image("alpha-base"), set()) for images in (image_set, forecast)]
    assert needed[1] - needed[0] == grown


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
        {"date": "today"},
        {"targets": []},
        {"architectures": []},
        {"force": "no"},
        {"shards": [{"name": []}]},
    ],
)
def test_a_plan_of_another_format_is_refused(
    registry: Publisher, image_set: ImageSet, tmp_path: Path, change: dict[str, object]
) -> None:
    """Above all one that names nothing, which would stand for everything."""
    plan, _ = content(registry, image_set)
    for text in (json.dumps(plan | change), "[" * 100_000):
        (tmp_path / "plan.json").write_text(text)
        with pytest.raises(RosmlError) as caught:
            read_plan(tmp_path / "plan.json")
        assert caught.value.exit_code == 2 and "\n" not in caught.value.message


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
    calls: list[Call] = []

    class Stop(Exception):
        pass

    def stop(call: Call) -> None:
        calls.append(call)
        raise Stop

    monkeypatch.setattr(Call, "survey", stop)
    CliRunner().invoke(plan.main, ["--everywhere", *arguments])
    (call,) = calls
    assert (call.only, call.serve, call.registry) == (only, serve, place)
    assert call.architectures == (serve or ("amd64", "arm64"))


# ---- Pull requests ---------------------------------------------------------------------------------------------------


def reached(project: Path, file: str) -> tuple[ImageSet, differences.Difference]:
    before = Inputs(copy(project.parent / "old"), parse(SMALL))
    path = project / file
    path.write_text(path.read_text() + "# a change\n")
    new = parse(SMALL)
    write = locked.with_locks(new, frozenset(lock for image in new.images for lock in image.locks))
    return write, differences.between(before, Inputs(project, new))


def test_few_images_have_all_that_changed(project: Path) -> None:
    image_set, difference = reached(project, "components/torch/files.sh")
    choice = pull_request.choose(image_set, difference, ("amd64",), 3)
    assert len(choice.built) == 3
    assert all("torch" in image_set.by_target[target].versions for target in choice.built)
    assert not set(choice.built) & set(choice.left_out)
    images = [image_set.by_target[target] for target in choice.built]
    assert len({image.distribution for image in images}) > 1
    one = pull_request.choose(image_set, difference, ("amd64",), 1)
    assert one.built == choice.built[:1]
    assert f"; left out, {len(one.left_out)} of {len(one.left_out) + 1}: " in str(one)


def test_what_cannot_be_built_here_is_counted(project: Path) -> None:
    image_set, difference = reached(project, "components/ros/install.sh")
    nowhere = pull_request.choose(image_set, difference, ("riscv64",), 3)
    assert (nowhere.built, nowhere.left_out) == ((), ())
    assert str(nowhere) == f"0 images changed; {len(difference.changed)} more for other architectures"
    unlocked = pull_request.choose(locked.with_locks(image_set, frozenset()), difference, ("amd64",), 99)
    assert {image_set.by_target[target].stack for target in unlocked.built} == {None}
    assert unlocked.unlocked


def test_no_image_changed(monkeypatch: pytest.MonkeyPatch, ci: Path) -> None:
    same = differences.Difference((), (), {}, same=1)
    monkeypatch.setattr(revision, "since", lambda *_: same)
    monkeypatch.setattr(publish, "ROOT", ci)  # its lock is not this checkout's, which a publishing run may have
    from rosml.machine.services import Services

    monkeypatch.setattr(Services, "load", lambda root, required: None)
    done = CliRunner().invoke(publish.main, ["all", "--since", "HEAD", "--json"])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout) == {"counts": {}, "outcomes": []}
    assert "0 images changed" in (ci / github.SUMMARY).read_text()
    both = CliRunner().invoke(publish.main, ["all", "--since", "HEAD", "--only", "ros1-bookworm-core"])
    assert both.exit_code == 2
    assert "leave --only out" in both.output


# ---- What a run did --------------------------------------------------------------------------------------------------


def test_a_run_says_what_it_uploaded(
    registry: Publisher, image_set: ImageSet, capsys: pytest.CaptureFixture[str], ci: Path
) -> None:
    run = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",))
    report.show(run, as_json=True)
    printed = json.loads(capsys.readouterr().out)
    built = {item["target"]: item["uploaded"] for item in printed["outcomes"] if item["step"] == "build"}
    layer = len("alpha-base 1 amd64")
    assert run.pushed == layer + len("alpha-core 1 amd64"), "a layer of the image below was counted twice"
    assert built["alpha-base"] > layer and sum(built.values()) < printed["uploaded"]
    assert printed["seconds"] >= 0
    report.show(run, as_json=False)
    text = f"{units.size(printed['uploaded'])} uploaded, "
    assert text in capsys.readouterr().out and f"- {text}" in (ci / github.SUMMARY).read_text()
    registry.registry.uploaded = 0
    nothing = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",), date=NEXT)
    report.show(nothing, as_json=False)
    assert "everything is up to date\n0 B uploaded, " in capsys.readouterr().out
    registry.packages["alpha"] = "tuesday"
    same = registry.publish(image_set, only=["alpha-base"], architectures=("amd64",), serving=("amd64",), date=NEXT)
    assert steps(same, "build") and same.pushed == 0, "the same layers were counted again"


def test_the_summary_of_a_job_has_a_row_for_all_that_was_done(
    registry: Publisher, image_set: ImageSet, ci: Path
) -> None:
    registry.publish(image_set, only=["omega-core"])
    run = registry.publish(image_set, only=["*-core", "alpha-base"], date=NEXT, broken={"alpha-base"})
    report.show(run, as_json=False)
    text = (ci / github.SUMMARY).read_text()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("| ")]
    head, _, *rest = rows
    assert head == ["step", "image", "architecture", "state", "time", "size", "digest", "what"]
    cells = {tuple(row[:3]): row[3:] for row in rest}
    entry = run.state.entries["alpha-core", "amd64"]
    state, _, size, digest, _ = cells["build", "`alpha-core`", "amd64"]
    assert (state, size, digest) == ("done", units.size(entry.size), f"`{entry.digest[:19]}`")
    assert entry.size and entry.digest.startswith("sha256:")
    state, _, size, digest, what = cells["build", "`alpha-base`", "amd64"]
    assert (state, size, digest, what) == ("failed", "", "", "building alpha-base failed")
    assert cells["promote", "`alpha-core`", ""][0] == "done"
    assert not [key for key in cells if "omega" in key[1]]
    unchanged = sum(item.thing.target == "omega-core" for item in run.state.items)
    assert unchanged == 2 and f"- {unchanged} up to date, left alone\n" in text
    assert "- build: 2 done\n" in text and "- build: 2 failed\n" in text
