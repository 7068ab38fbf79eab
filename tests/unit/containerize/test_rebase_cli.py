"""`rosml rebase` as people call it, also wrongly."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from click import Command
from click.testing import CliRunner

from fakes.rebasing import BASE_FACTS, BOTH, App, Place, addon, app_with_addon, moving, on_stack
from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.cli import checkout
from rosml.cli.containerize import rebase
from rosml.cli.images import publish
from rosml.images.image_set.labels import TITLE
from rosml.machine.services import Services


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as found:
        monkeypatch.setattr(Services, "load", lambda *_, **__: found.services)
        yield found


def called(*arguments: str, program: Command = rebase.main) -> tuple[int, str, str]:
    """The exit code, the output and what was said. The program's own end turns errors into messages."""
    done = CliRunner().invoke(program, [*arguments])
    if isinstance(done.exception, RosmlError):
        return done.exception.exit_code, done.stdout, done.exception.message
    return done.exit_code, done.stdout, done.stderr


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ([], "no app is named"),
        (["--all", "FILE", "--variants", "cpu,cu130"], "--all and --variants exclude each other"),
        (["--all", "FILE", "--check", "metadata"], "--all and --check exclude each other"),
        (["--all", "FILE", "a/b"], "--all and APP exclude each other"),
        (["a/b", "--fixes", "CVE-2026-1"], "--fixes looks at the apps of a file"),
        (["a/b", "--check", "run"], "belong together"),
        (["a/b", "--command", "x"], "belong together"),
        (["a/b", "--variants", "cpu", "--base", "x"], "--variants chooses base images"),
        (["a/b", "--back", "sha256:0", "--base", "x"], "--back and --base exclude each other"),
        (["APP", "--back", "sha256:0"], "--back sha256:0 is no digest"),
        (["APP", "--back", ""], "--back  is no digest"),
        (["APP", "--back", "", "--base", "x"], "--back and --base exclude each other"),
        (["APP", "--base", ""], "--base is an empty word"),
        (["APP", "--tag", ""], "--tag is an empty word"),
        (["APP", "--variants", ""], "0 variants are named"),
        (["BASE"], "is no app that rosml containerize built"),
        (["--all", "FOLDER"], "FOLDER"),
        (["--all", "EMPTY"], "EMPTY"),
        (["a B"], "is no reference"),
        (["-x"], "No such option"),
        (["", "--base", "x"], "no app is named"),
        (["localhost:1/a:b@sha256:123"], "is no reference"),
        (["APP", "--tag", "candidate"], "is no reference"),
        (["APP", "--platform", "arm64"], "is for linux/amd64, not for arm64"),
        (["APP", "--base", "BASE", "--check", "auto", "--platform", "linux/arm64"], "not for linux/arm64"),
    ],
)
def test_wrong_use(place: Place, tmp_path: Path, arguments: list[str], says: str) -> None:
    (tmp_path / "FOLDER").mkdir()
    (tmp_path / "EMPTY").write_text("")
    (tmp_path / "FILE").write_text("apps: [{app: 'a/b:c'}]")
    base = place.base()
    known = {name: str(tmp_path / name) for name in ("FILE", "FOLDER", "EMPTY")} | {"BASE": base}
    known["APP"] = place.app(base) if "APP" in arguments else ""
    code, out, said = called(*(known.get(item, item) for item in arguments))
    assert (code, out) == (2, "") and says in said


def test_a_dry_run_in_json(place: Place) -> None:
    app, new = place.app(place.base()), place.base("newer")
    before = place.digest(app)
    code, out, _ = called(app, "--base", new, "--dry-run", "--json")
    [found] = [json.loads(out)]
    assert code == 0 and place.digest(app) == before
    assert found["verdict"] == "safe" and found["moved"] is False and found["base_digest"] == place.digest(new)
    assert called(app, "--base", new, "--json")[0] == 0
    assert place.digest(app) == found["digest"] != before
    assert "already; nothing would change" in called(app, "--base", new, "--dry-run")[2]


def test_each_line_of_the_way_back_gives_the_digest_of_before(place: Place) -> None:
    """Also of an app whose add-on took the new base image's accelerator, and of each tag of `--variants`."""
    cpu, gpu = (on_stack(place, stack, BASE_FACTS) for stack in ("cpu", "cu128"))
    without = place.base()
    addon(place, "cu128", "cu128")
    apps = {"plain": place.app(without, "plain"), "addon": app_with_addon(place, without, addon(place, "tonight"))}
    apps["gpu"] = App(gpu, name="gpu").put(place.registry, "latest")
    App(gpu, name="gpu").put(place.registry, "latest-cpu")
    moves = {"plain": ("--base", cpu), "addon": ("--variants", "cu128,cpu"), "gpu": ("--variants", "cpu,cu128")}
    before = {name: place.digest(name) for name in (*apps.values(), f"{apps['gpu']}-cpu")}
    for kind, app in apps.items():
        code, out, _ = called(app, *moves[kind])
        lines = [
            line.partition(f"; back: {checkout.call()} rebase ")[2] for line in out.splitlines() if "; back: " in line
        ]
        assert (code, len(lines)) == (0, 2 if kind == "gpu" else 1), "a tag that was not there has no way back"
        for line in lines:
            name = line.split()[0]
            assert place.digest(name) != before[name]
            assert "would point at" in called(*line.split(), "--dry-run")[1] and place.digest(name) != before[name]
            code, out, _ = called(*line.split())
            assert (code, place.digest(name)) == (0, before[name]) and "back: " in out
            assert "it was there already" in called(*line.split())[1]


def test_the_way_back_to_an_image_that_the_registry_removed(place: Place) -> None:
    base = place.base()
    code, _, said = called(place.app(base), "--back", place.digest(base))
    assert code == 2 and "has no image sha256:" in said


def test_the_way_back_loses_no_platform(place: Place) -> None:
    base = place.base()
    one = place.digest(place.app(base, "one"))
    app = place.app(base, platforms=BOTH)
    before = place.digest(app)
    code, _, said = called(app, "--back", one)
    assert code == 2 and "would lose linux/arm64" in said and place.digest(app) == before


def test_the_way_back_leads_to_no_other_app(place: Place) -> None:
    """Not to the image for development, either: the tag of a robot would be without the app."""
    base = place.base()
    app, other = (place.app(base, tag, labels={TITLE: title}) for tag, title in (("a", "robot"), ("b", "robot (dev)")))
    before = place.digest(app)
    code, _, said = called(app, "--back", place.digest(other))
    assert code == 2 and "is an image of robot (dev), and" in said and place.digest(app) == before


def test_many_apps_are_told_with_the_way_back(place: Place, tmp_path: Path) -> None:
    base = place.base()
    names = [App(base, name=name).put(place.registry, "latest") for name in ("arm", "deep/camera")]
    before = [place.digest(name) for name in names]
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    file = tmp_path / "apps.yaml"
    file.write_text(json.dumps({"apps": [{"app": name} for name in names]}))
    code, out, _ = called("--all", str(file), "--dry-run")
    assert code == 0 and "2 would move\nnothing was changed\n" in out and "back:" not in out
    assert [place.digest(name) for name in names] == before
    planned = json.loads(called("--all", str(file), "--dry-run", "--json")[1])["apps"]
    assert [(item["app"], item["state"]) for item in planned] == [(name, "planned") for name in names]
    code, out, _ = called("--all", str(file))
    after = [place.digest(name) for name in names]
    assert code == 0 and after == [item["rebased"]["digest"] for item in planned]
    for name, old, new in zip(names, before, after, strict=True):
        assert f"moved      {name}  {old[7:19]} -> {new[7:19]}  {base}\n" in out
    lines = [line for line in out.splitlines() if line.startswith(f"back: {checkout.call()} publish undo 20")]
    folders = [line.partition(" --registry ")[2] for line in lines]
    assert folders == [f"{place.server.address}/me", f"{place.server.address}/me/deep"], "an undo for each folder"


def test_an_undo_says_first_what_it_undoes(place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A last run of an earlier day has to be named: last night's may have moved no tag, and so have no record."""
    app = place.app(place.base())
    before = place.digest(app)
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    (tmp_path / "apps.yaml").write_text(json.dumps({"apps": [{"app": app}]}))
    monkeypatch.setattr(clock, "now", lambda: "2026-11-27T03:00:00Z")
    assert called("--all", str(tmp_path / "apps.yaml"))[0] == 0
    after, where = place.digest(app), ("undo", "--registry", f"{place.server.address}/me")

    monkeypatch.setattr(clock, "now", lambda: "2026-11-28T05:00:00Z")
    code, out, said = called(*where, "--dry-run", program=publish.main)
    assert code == 0 and f"run of 2026-11-27T03:00:00Z, 1 day ago: 2 tags in {place.server.address}/me" in said
    assert f"robot:latest  would move back to {before}\n" in out and "robot:latest-20261127  would be removed" in out
    tags = json.loads(called(*where, "--dry-run", "--json", program=publish.main)[1])["tags"]
    assert [item["now"] for item in tags] == [after, after] and place.digest(app) == after
    code, out, said = called(*where, program=publish.main)
    assert code == 2 and "and no run was named" in said and place.digest(app) == after
    assert called(*where, "2026-11-27T03:00:00Z", program=publish.main)[0] == 0
    assert place.digest(app) == before


def test_an_undo_of_the_last_run_of_the_day(place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    app = place.app(place.base())
    before = place.digest(app)
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    (tmp_path / "apps.yaml").write_text(json.dumps({"apps": [{"app": app}]}))
    assert called("--all", str(tmp_path / "apps.yaml"))[0] == 0 and place.digest(app) != before
    code, _, said = called("undo", "--registry", f"{place.server.address}/me", program=publish.main)
    assert code == 0 and " s ago: 2 tags in " in said and place.digest(app) == before
