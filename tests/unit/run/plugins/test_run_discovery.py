"""Plugins of other packages, good and broken, and the order of all."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from fakes.desks import BARE, Desk, docker_desk, plain
from rosml.run.context import Context, Engine, Image, Person
from rosml.run.plan import make_plan
from rosml.run.plugin import Plugin
from rosml.run.plugins import discovery
from rosml.run.plugins.discovery import BUILT_IN, in_order
from rosml.run.words import split

THEIRS = """\
from rosml.run.plugin import Added, Plugin

def lidar(context):
    return ["--device", "/dev/lidar"] if context.line.asks("lidar") else []

good = Plugin("lidar", lidar, {"lidar": "the lidar"}, before=("user",))
late = Plugin("late", lambda context: Added(["--label", "a=b"], notes=[("mind the robot", "stop it")]))
clash = Plugin("clash", lidar, {"privileged": "as docker's"})
twice = Plugin("gpu", lidar)
raises = Plugin("raises", lambda context: 1 / 0)
numbers = Plugin("numbers", lambda context: [1])
text = Plugin("text", lambda context: "--rm")
odd = Plugin("odd", lidar, {"--odd": "with hyphens"})
files = Plugin("files", lambda context: Added(files={"x": b""}))
circle = Plugin("circle", lidar, before=("user",), after=("user",))
function = lidar
"""


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path)


def package(folder: Path, entries: str) -> str:
    """Installs a package with plugins. Returns a path on which Python finds it."""
    (folder / "theirs-1.0.dist-info").mkdir(parents=True)
    text = f"[console_scripts]\nx = theirs:x\n\n[rosml.run]\n{entries}\n[other]\ny = theirs:y\n"
    (folder / "theirs-1.0.dist-info/entry_points.txt").write_text(text)
    (folder / "theirs.py").write_text(THEIRS)
    return f"{ROOT / 'src'}:{folder}"


def test_a_plugin_of_another_package(desk: Desk, tmp_path: Path) -> None:
    path = package(tmp_path / "site", "lidar = theirs:good\nlate = theirs:late")
    assert "--lidar" in desk.call("--help", PYTHONPATH=path).stdout and "--lidar" not in desk.call("--help").stdout
    done = desk.call("--no-tz", "--lidar", "ubuntu", "ls", "--lidar", PYTHONPATH=path)
    assert (done.returncode, done.stderr) == (0, "warning: mind the robot\nremedy: stop it\n")
    before, _, after = " ".join(plain(desk)).partition(" --user")
    assert " ".join(desk.ran) == f"{before} --device /dev/lidar --user{after} --label a=b ubuntu ls --lidar"


@pytest.mark.parametrize(
    ("place", "says"),
    [
        ("theirs:clash", "ValueError: its option --privileged is taken"),
        ("theirs:twice", "ValueError: another plugin is called gpu"),
        ("theirs:raises", "ZeroDivisionError: division by zero"),
        *((f"theirs:{name}", "TypeError: it adds something else than words") for name in ("numbers", "text")),
        ("theirs:odd", "ValueError: '--odd' is no name of an option"),
        ("theirs:files", "TypeError: it adds something else than bytes for absolute paths"),
        ("theirs:circle", "ValueError: its before and after contradict others"),
        ("nowhere:x", "ModuleNotFoundError: "),
    ],
)
def test_a_broken_plugin_is_left_out(desk: Desk, tmp_path: Path, place: str, says: str) -> None:
    done = desk.call("--no-tz", "ubuntu", PYTHONPATH=package(tmp_path / "site", f"it = {place}"))
    assert done.returncode == 0 and desk.ran == [*plain(desk), "ubuntu"]
    assert done.stderr.startswith("warning: the plugin ") and f" of theirs is left out: {says}" in done.stderr
    assert "remedy: update theirs, or remove it" in done.stderr


def test_the_search_for_plugins(tmp_path: Path) -> None:
    package(tmp_path / "a", "one = theirs:good [extra]\n two=theirs:late")
    (tmp_path / "a/odd-1.dist-info").mkdir()
    (tmp_path / "a/odd-1.dist-info/entry_points.txt").write_bytes(b"\xff")
    (tmp_path / "a/none-1.dist-info").mkdir()
    places = [str(tmp_path / "a"), str(tmp_path / "a"), str(tmp_path / "missing"), ""]
    assert [*discovery.registered(places)] == [("theirs", "one", "theirs:good"), ("theirs", "two", "theirs:late")]


def test_the_order_of_plugins() -> None:
    def plugin(name: str, **order: Any) -> Plugin:
        return Plugin(name, lambda context: [], **order)

    plugins = [plugin("a", after=("c",)), plugin("b"), plugin("c", before=("b",)), plugin("d", after=("x",))]
    ordered, refused = in_order(plugins)
    assert ([plugin.name for plugin in ordered], refused) == (["c", "a", "b", "d"], [])
    ordered, refused = in_order([plugin("a"), plugin("b", before=("a",), after=("a",))])
    assert ([plugin.name for plugin in ordered], [plugin.name for plugin in refused]) == (["a"], ["b"])


CONTEXT = Context(split(["--lidar", "x"], ["--lidar"]), Engine(), Person(1, 1, "me", "/"), Image(), BARE)


def test_rosmls_own_plugins() -> None:
    plugins = discovery.discover((), [])
    assert (plugins.plugins, plugins.notes) == (BUILT_IN, ())
    with pytest.raises(IndexError):  # a fault of rosml's is not passed over
        make_plan(CONTEXT, [Plugin("broken", lambda context: [][1])])


def test_the_plugin_that_the_docs_show() -> None:
    """It works, and the names to put in `before` and `after` are all of them."""
    page = (ROOT / "docs/run/plugins.md").read_text()
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names: dict[str, Any] = {}
    exec(code, names)
    assert make_plan(CONTEXT, [names["lidar"]]).argv == ("docker", "run", "--device", "/dev/ttyUSB0", "x")
    listed = re.findall(r"`([a-z-]+)`", page.partition("order it among the others: ")[2].partition(".")[0])
    assert listed == [plugin.name for plugin in BUILT_IN]
