"""`rosml rebase` as people call it, also wrongly."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click import Command
from click.testing import CliRunner

from fakes.rebasing import (
    BASE_FACTS,
    BOTH,
    FILES,
    OTHER_BUILD,
    App,
    Place,
    addon,
    app_with_addon,
    changed,
    on_stack,
    place,
)
from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.containerize import rebase
from rosml.cli.images import publish
from rosml.containerize.rebase.trial import Trial
from rosml.images.image_set.labels import TITLE
from rosml.machine.services import Services

__all__ = ["place"]


@pytest.fixture(autouse=True)
def services(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Services, "load", lambda *_, **__: place.services)


def called(*arguments: str, program: Command = rebase.main) -> tuple[int, str, str]:
    """The exit code, the output, and messages. The program's own end turns errors into messages."""
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
        (["me/other:x"], "there is no app me/other:x"),
        (["DIGEST"], "names the app by its digest"),
        (["APP", "--tag", "DIGEST"], "is a digest"),
        (["APP", "--base", "NONE"], "there is no image"),
        (["APP", "--variants", "cpu,cu130"], "has no framework"),
        (["--all", "FOLDER"], "FOLDER"),
        (["a B"], "is no reference"),
        (["APP", "--tag", "candidate"], "is no reference"),
        (["APP", "--platform", "arm64"], "is for linux/amd64, not for arm64"),
    ],
)
def test_wrong_use(place: Place, tmp_path: Path, arguments: list[str], says: str) -> None:
    (tmp_path / "FOLDER").mkdir()
    (tmp_path / "FILE").write_text("apps: [{app: 'a/b:c'}]")
    base = place.base()
    words = {name: str(tmp_path / name) for name in ("FILE", "FOLDER")} | {"BASE": base, "NONE": f"{base}-none"}
    if not {"APP", "DIGEST"}.isdisjoint(arguments):
        words["APP"] = app = place.app(base)
        words["DIGEST"] = f"{app.rpartition(':')[0]}@{place.digest(app)}"
    code, out, message = called(*(words.get(item, item) for item in arguments))
    assert (code, out) == (2, "") and says in message


def test_a_dry_run_in_json(place: Place) -> None:
    app, new = place.app(place.base()), place.base("newer")
    before = place.digest(app)
    code, out, _ = called(app, "--base", new, "--dry-run", "--json")
    planned = json.loads(out)
    assert code == 0 and place.digest(app) == before
    assert planned["verdict"] == "safe" and planned["moved"] is False and planned["base_digest"] == place.digest(new)
    assert called(app, "--base", new, "--json")[0] == 0
    assert place.digest(app) == planned["digest"] != before
    assert "already; nothing would change" in called(app, "--base", new, "--dry-run")[2]


@pytest.mark.parametrize(
    ("options", "tries"),
    [
        ([], ["link"]),
        (["--check", "metadata"], []),
        (["--check", "run", "--command", "gone"], ["link", "gone"]),
    ],
)
def test_an_app_is_tried_before_its_tag_moves(
    place: Place, monkeypatch: pytest.MonkeyPatch, options: list[str], tries: list[str]
) -> None:
    """Here the facts do not decide. A command that fails keeps the tag where it is."""
    calls = list[str]()

    def start(_: Trial, __: object, command: str) -> None:
        calls.append(command)
        raise RosmlError("the command failed", "correct it")

    monkeypatch.setattr(rebase, "_builder", lambda: place.services)
    monkeypatch.setattr(Trial, "link", lambda *_: calls.append("link"))
    monkeypatch.setattr(Trial, "run", start)
    libraries = [*BASE_FACTS["libraries"][::2], OTHER_BUILD]
    app, new = place.app(place.base()), place.base("newer", changed(BASE_FACTS, libraries=libraries))
    before = place.digest(app)
    code, _, _ = called(app, "--base", new, *options)
    assert calls == tries
    assert (code, place.digest(app) == before) == ((1, True) if "gone" in tries else (0, False))


def test_each_line_of_the_way_back_gives_the_digest_of_before(place: Place) -> None:
    """Also of an app whose add-on took the new base image's accelerator, and of each tag of `--variants`."""
    cpu, gpu = (on_stack(place, stack) for stack in ("cpu", "cu128"))
    without = place.base()
    addon(place, "cu128", "cu128")
    apps = {"plain": place.app(without, "plain"), "addon": app_with_addon(place, without, addon(place, "tonight"))}
    apps["gpu"] = App(gpu, name="gpu").put(place.registry, "latest")
    App(gpu, name="gpu").put(place.registry, "latest-cpu")
    moves = {"plain": ("--base", cpu), "addon": ("--variants", "cu128,cpu"), "gpu": ("--variants", "cpu,cu128")}
    before = {name: place.digest(name) for name in (*apps.values(), f"{apps['gpu']}-cpu")}
    for kind, app in apps.items():
        code, out, _ = called(app, *moves[kind])
        ways = [line.partition(f"; back: {command.call()} rebase ")[2].split() for line in out.splitlines()]
        ways = [way for way in ways if way]
        assert (code, len(ways)) == (0, 2 if kind == "gpu" else 1), "a tag that was not there has no way back"
        for way in ways:
            assert place.digest(way[0]) != before[way[0]]
            assert "would point at" in called(*way, "--dry-run")[1] and place.digest(way[0]) != before[way[0]]
            code, out, _ = called(*way)
            assert (code, place.digest(way[0])) == (0, before[way[0]]) and "back: " in out
            assert "it was there already" in called(*way)[1]


def test_the_way_back_is_refused(place: Place) -> None:
    """To an image that the registry removed, to one for fewer platforms, and to another app or the image for development."""
    base = place.base()
    app = place.app(base, platforms=BOTH)
    small, other = place.app(base, "small"), place.app(base, "dev", labels={TITLE: "robot (dev)"})
    before = place.digest(app)
    for name, digest, says in (
        (app, place.digest(base), "has no image sha256:"),
        (app, place.digest(small), "would lose linux/arm64"),
        (small, place.digest(other), "is an image of robot (dev), and"),
    ):
        code, _, message = called(name, "--back", digest)
        assert code == 2 and says in message and place.digest(app) == before


def test_many_apps_with_the_way_back(place: Place, tmp_path: Path) -> None:
    base = place.base()
    names = [App(base, name=name).put(place.registry, "latest") for name in ("arm", "deep/camera")]
    before = [place.digest(name) for name in names]
    place.base(files=FILES)
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
    for name, digest, new in zip(names, before, after, strict=True):
        assert f"moved      {name}  {digest[7:19]} -> {new[7:19]}  {base}\n" in out
    lines = [line for line in out.splitlines() if line.startswith(f"back: {command.call()} publish undo 20")]
    folders = [line.partition(" --registry ")[2] for line in lines]
    assert folders == [f"{place.server.address}/me", f"{place.server.address}/me/deep"], "an undo for each folder"


def test_an_undo_says_first_what_it_undoes(place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A last run of an earlier day has to be named: last night's may have moved no tag, and so have no record."""
    app = place.app(place.base())
    before = place.digest(app)
    place.base(files=FILES)
    (tmp_path / "apps.yaml").write_text(json.dumps({"apps": [{"app": app}]}))
    monkeypatch.setattr(clock, "now", lambda: "2026-11-27T03:00:00Z")
    assert called("--all", str(tmp_path / "apps.yaml"))[0] == 0
    after, where = place.digest(app), ("undo", "--registry", f"{place.server.address}/me")
    code, _, message = called(*where, "--dry-run", program=publish.main)
    assert code == 0 and " s ago: 2 tags in " in message, "of the same day, it need not be named"

    monkeypatch.setattr(clock, "now", lambda: "2026-11-28T05:00:00Z")
    code, out, message = called(*where, "--dry-run", program=publish.main)
    assert code == 0 and f"run of 2026-11-27T03:00:00Z, 1 day ago: 2 tags in {place.server.address}/me" in message
    assert f"robot:latest  would move back to {before}\n" in out and "robot:latest-20261127  would be removed" in out
    tags = json.loads(called(*where, "--dry-run", "--json", program=publish.main)[1])["tags"]
    assert [item["now"] for item in tags] == [after, after] and place.digest(app) == after
    code, out, message = called(*where, program=publish.main)
    assert code == 2 and "and no run was named" in message and place.digest(app) == after
    assert called(*where, "2026-11-27T03:00:00Z", program=publish.main)[0] == 0
    assert place.digest(app) == before
