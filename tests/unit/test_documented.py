"""Every command that the documentation shows is one that there is, with options that it has; and each is run by a
test, or says why it cannot be."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
import yaml
from conftest import ROOT
from workflows import COMMANDS, accepted

from bench import cli as bench
from rosml.base.errors import RosmlError
from rosml.base.words import CALLED, in_words
from rosml.cli import join, main, publish
from rosml.images.explain import explained
from rosml.images.image_set import ImageSet
from rosml.images.selection import members
from tests.calls import lacking
from tests.documented import blocks, commands, documented, pages
from tests.proof import Proof

PROOFS: dict[str, dict[str, str]] = yaml.safe_load((ROOT / "tests/documented.yaml").read_text())
SCRIPTS = {**COMMANDS, "bench": bench.main, "scripts/join.py": join.main}
MAKEFILE = (ROOT / "Makefile").read_text()
EXTEND = "docs/extend.md"
"""The page whose examples are not in our own matrix; test_extend.py follows it."""


PROGRAMS = r"make|uv\ run|docker|regctl|python3|source|git|rm|apt-get|pip|(scripts/)?publish\.py"
COMMAND = re.compile(rf"""([A-Z_]+=("[^"]*"|'[^']*'|\S+)\ )*({PROGRAMS})\ \S""", re.VERBOSE)
STEP = re.compile(rf"({'|'.join(publish.cli.commands)}) (--\w|\S*[\d.])")
"""A subcommand of publish.py, where a page has named that: with an option, or a file or date. `build on it` is none."""
MENTIONED = re.compile(r"(docker|regctl)( [a-z]+)+( …)?|(apt-get|pip) install")
"""What a sentence says of a program by the name of its subcommand, without anything to be done."""


def called(text: str) -> str:
    """The command that a sentence sets as code, with its program; empty where that is none to be called."""
    if STEP.match(text):
        return f"publish.py {text}"
    return text if COMMAND.match(text) and not MENTIONED.fullmatch(text) else ""


def spans() -> Iterator[tuple[str, str]]:
    """Commands within sentences, each with its page."""
    for page in pages():
        prose = re.sub(r"^ *```.*?^ *```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
        for span in re.findall(r"`([^`]+)`", prose):
            if command := called(" ".join(span.split())):
                yield command, str(page.relative_to(ROOT))


SHOWN = [(command, page) for command, where in documented().items() for page in dict.fromkeys(where)]
CALLS = list(dict.fromkeys([*SHOWN, *spans()]))


@pytest.mark.parametrize(
    ("span", "command"),
    [
        ("make", False),
        ("make list", True),
        ('A_B="c d" uv run pytest', True),
        ("A_B='c d' E=f make up", True),
        ("PLATFORM=linux/amd64 docker buildx bake bookworm-core", True),
        ("docker run", False),
        ("docker run …", False),
        ("docker run --gpus", True),
        ("regctl artifact tree", False),
        ("regctl image copy --referrers FROM TO", True),
        ("python3 -m http.server", True),
        ("source tools/completion.bash", True),
        ("git checkout locks", True),
        ("publish.py undo", True),
        ("scripts/publish.py undo", True),
        ("git-lfs", False),
        ("publish.py", False),
        ("rm /etc/sudoers.d/rosml", True),
        ("apt-get upgrade", True),
        ("apt-get install", False),
        ("apt-get install ros-jazzy-…", True),
        ("pip install", False),
        ("pip install -U torch", True),
        ("PIP_CONFIG_FILE=/dev/null pip install …", True),
        ("RUN pip install", False),
        ("rmdir x", False),
        ("test", False),
        ("build on it", False),
        ("scan.yaml:21:5: no such thing", False),
    ],
)
def test_what_is_a_command_within_a_sentence(span: str, command: bool) -> None:
    assert called(span) == (span if command else "")


@pytest.mark.parametrize("span", ["undo 2026-11-22T03:00:00Z", "scan --fetch --database …", "record scan.json"])
def test_steps_are_commands_of_the_publisher(span: str) -> None:
    assert called(span) == f"publish.py {span}"


def test_every_command_has_its_proof() -> None:
    found = {command for command, _ in CALLS}
    assert len(found) > 20
    assert sorted(found - PROOFS.keys()) == [], "commands without a line in tests/documented.yaml"
    assert sorted(PROOFS.keys() - found) == [], "lines in tests/documented.yaml for commands that no page shows"


@pytest.mark.parametrize("command", PROOFS)
def test_the_proof_is_there(command: str) -> None:
    proof = PROOFS[command]
    assert len(proof) == 1
    [(kind, value)] = proof.items()
    match kind:
        case "test":
            pages = [page for shown, page in CALLS if shown == command]
            assert lacking(command, pages, value) == "", f"{value} does not run it, as far as its source tells"
        case "suite" if value == "Makefile":
            assert re.search(rf"^test: .*\b{command.removeprefix('make ')}\b", MAKEFILE, re.MULTILINE)
        case "suite" if value == "tests/e2e":
            assert (ROOT / command.split()[3]).parent == ROOT / value
        case "suite" if command.startswith("publish.py"):  # a step of the workflow, with more options
            assert re.search(rf"scripts/{re.escape(command)}( |$)", (ROOT / value).read_text(), re.MULTILINE)
        case "suite":
            assert re.search(rf"{re.escape(command)}( [A-Z]+=\S+)?$", (ROOT / value).read_text(), re.MULTILINE)
        case "proof":
            assert Proof.load(value).command == command or not command.startswith("make test-all")
        case "needs":
            assert len(value) >= len("a GPU")
            sources = {path.stem: path.read_text() for path in (ROOT / "tests").glob("*/test_*.py")}
            for name in re.findall(r"\btest_\w+", value):
                assert name in sources or any(f"def {name}(" in text for text in sources.values()), (
                    f"there is no {name}"
                )
        case _:
            assert kind == "run" and value


@pytest.mark.parametrize(
    ("command", "test", "wants"),
    [
        (
            "make image TARGET=bookworm-base",
            "tests/e2e/test_ros.py::test_the_same_packages_give_the_same_layers",
            "base",
        ),
        ("make publish", "tests/unit/test_turn.py::test_nobody_to_wait_for", "all"),
        ("make scanner", "tests/unit/test_bench.py::test_numbers", "scanner"),
        ("make up", "tests/e2e/test_ros.py::test_a_base_image_is_the_same_wherever_it_is_made", "never skipped"),
        (
            "uv run scripts/publish.py prune --apply",
            "tests/unit/test_parts.py::test_results_for_machines",
            "prune",
        ),
        ("publish.py undo --json", "tests/e2e/test_publisher.py::test_status_says_how_things_stand", "undo"),
        ("source tools/completion.bash", "tests/unit/test_bench.py::test_numbers", "completion.bash"),
        ("gpg", "tests/unit/test_apt_keys.py::test_the_keys_are_the_pinned_ones", "never skipped"),
        (
            "regctl image export --compress x",
            "tests/e2e/test_publisher.py::test_status_says_how_things_stand",
            "--compress",
        ),
    ],
)
def test_a_proof_that_is_none_is_found(command: str, test: str, wants: str) -> None:
    assert wants in lacking(command, ["docs/nothing.md"], test)


def test_a_proof_that_is_not_there() -> None:
    with pytest.raises(KeyError):
        lacking("make image", [], "tests/unit/test_bench.py::test_nothing_like_that")


@pytest.mark.parametrize("command", [name for name, proof in PROOFS.items() if "run" in proof])
def test_it_runs_as_it_stands(command: str) -> None:
    """With the Python of this test, and nothing is set up."""
    argv = ["bash", "-c", f"{command} BOOTSTRAP=: RUN={shlex.quote(sys.executable)}"]
    done = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert PROOFS[command]["run"] in done.stdout


@pytest.mark.parametrize(
    ("failing", "code"),
    [({}, 0), ({"all": 1}, 1), ({"scan": 3, "all": 1}, 3), ({"scan": 4}, 4), ({"prune": 1}, 1), ({"scanner": 2}, 2)],
)
def test_a_night_without_github(tmp_path: Path, failing: dict[str, int], code: int) -> None:
    """The script of docs/registry.md, with local replacements for make and uv of which some fail: it ends there while it sets up, and
    goes on later; its code is the first failure's. What it calls is what the nightly workflow calls, or `all` in the
    place of steps."""
    page = ROOT / "docs/registry.md"
    (script,) = [block for block in blocks(page) if block.title == "night.sh"]
    (tmp_path / "night.sh").write_text(script.text)
    programs = tmp_path / ".state/bin"
    programs.mkdir(parents=True)
    cases = "".join(f"{step}) exit {failed} ;; " for step, failed in failing.items())
    for name, place in (("make", 1), ("uv", 3)):
        text = f'#!/bin/sh\necho {name} "$@" >>calls\ncase "${place}" in {cases}esac\n'
        (programs / name).write_text(text)
        (programs / name).chmod(0o755)
    done = subprocess.run(["bash", tmp_path / "night.sh"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (code, "")
    calls = [shlex.split(line) for line in (tmp_path / "calls").read_text().splitlines()]
    assert calls[:2] == [["make", "up"], ["make", "scanner"]]
    steps = [call[3] for call in calls[2:]]
    if "scanner" in failing:
        assert steps == []
        return
    assert steps == ["scan", "all", "status", "prune"]
    night = (ROOT / ".github/workflows/nightly.yml").read_text()
    theirs = set(re.findall(r"scripts/publish.py (\w+)", night))
    assert theirs - {*steps} == {"plan", "build", "join", "test", "record", "index", "promote"}, "what `all` does"
    options = {word for call in calls[2:] for word in call if word.startswith("--")}
    assert [option for option in sorted(options) if option not in night] == []


def test_a_second_night_leaves_the_log_of_the_first_alone(tmp_path: Path) -> None:
    (crontab,) = [block for block in blocks(ROOT / "docs/registry.md") if block.title == "crontab"]
    command = crontab.text.split(maxsplit=5)[5]
    folder = tmp_path / "rosml"
    folder.mkdir()
    (folder / "night.sh").write_text('echo begun; bash -c "$SECOND"; echo refused: $?\n')
    environment = {**os.environ, "HOME": str(tmp_path), "SECOND": command}
    for nights in (1, 2):
        done = subprocess.run(["bash", "-c", command], env=environment, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
        assert (folder / ".state/night.log").read_text() == "begun\nrefused: 1\n" * nights


def test_uv_that_make_installed(tmp_path: Path) -> None:
    """The README's line finds it, where the machine has none."""
    (line,) = [
        line for block in blocks(ROOT / "README.md") for line in commands(block) if line.startswith("export PATH")
    ]
    uv = tmp_path / ".state/bin/uv"
    uv.parent.mkdir(parents=True)
    uv.write_text("#!/bin/sh\necho found\n")
    uv.chmod(0o755)
    done = subprocess.run(["bash", "-c", f"{line}; uv"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "found\n")


# ---- What parsers say ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("command", "page"), CALLS)
def test_parsers_accept_it(command: str, page: str, real: ImageSet) -> None:
    parsed(words(command), real, examples=page == EXTEND)


def words(command: str) -> list[str]:
    """A command's words, without variables before it and without what an ellipsis stands for."""
    found = [word for word in shlex.split(command) if "…" not in word]
    while found and re.match(r"[A-Z_]+=", found[0]):
        found = found[1:]
    return found


def parsed(argv: list[str], image_set: ImageSet, examples: bool) -> None:
    """Has a command's own parser read it; commands that are not ours are left to the tests that run them."""
    if argv[0] == "make":
        made(argv[1:], image_set, examples)
    elif argv[:2] == ["uv", "run"]:
        ran(argv[2:])
    elif argv[0] in ("publish.py", "scripts/publish.py"):
        ran(["scripts/publish.py", *argv[1:]])
    elif argv[0] == "source":
        assert (ROOT / argv[1]).is_file(), argv[1]


def made(given: list[str], image_set: ImageSet, examples: bool) -> None:
    """A call of make: targets that people are told of, variables that it has, values that mean something."""
    targets = {line.split(":")[0] for line in MAKEFILE.splitlines() if re.match(r"[a-z0-9-]+:.* ## ", line)}
    for word in given:
        name, equals, value = word.partition("=")
        if not equals:
            assert word in targets, f"make has no target {word}"
            continue
        assert re.search(rf"^{name} [?:]=|\$\({name}\)", MAKEFILE, re.MULTILINE), f"make has no variable {name}"
        if value and not examples:
            known(name, value, image_set)


def known(variable: str, value: str, image_set: ImageSet) -> None:
    """Fails where a value names nothing that there is."""
    if variable == "TARGET":
        explained(image_set, value, {})
    elif variable == "GROUP":
        assert members(image_set, value.split())
    elif variable == "STACK":
        assert value in image_set.matrix.stacks
    elif variable == "ONLY":
        assert [image for image in image_set.images if Path(image.target).match(value)]


def ran(given: list[str]) -> None:
    """What `uv run` runs: a script with click's parser, a module that there is, or tests that there are."""
    if given[0] == "python":
        module = ROOT / given[2].replace(".", "/")
        assert given[1] == "-m" and (module.with_suffix(".py").is_file() or (module / "__main__.py").is_file())
        if given[2] in SCRIPTS:
            accepted(SCRIPTS[given[2]], given[3:])
    elif given[0] == "pytest":
        assert (ROOT / given[1]).is_file(), given[1]
        tests = (ROOT / given[1]).read_text()
        assert given[2:] == [] or (given[2] == "-k" and re.search(rf"def test_\w*{given[3]}", tests)), given
    else:
        assert (ROOT / given[0]).is_file(), given[0]
        if len(given) > 1:
            accepted(SCRIPTS[given[0]], given[1:])


@pytest.mark.parametrize(
    "command",
    [
        "make imge",
        "make image TRAGET=bookworm-core",
        "make image TARGET=bokworm-cor",
        "make list GROUP=jazy",
        "make locks STACK=cu999",
        "make publish ONLY=bokworm-*",
        "uv run scripts/publish.py imge",
        "uv run scripts/publish.py all --onyl x",
        "publish.py imge",
        "publish.py plan --evrywhere",
        "scripts/publish.py all --onyl x",
        "source tools/nothing.bash",
        "uv run scripts/nothing.py",
        "uv run pytest tests/e2e/test_ros.py -k nothing_like_that",
        "uv run python -m tests.nothing",
    ],
)
def test_what_there_is_not_is_found(command: str, real: ImageSet) -> None:
    with pytest.raises((AssertionError, click.UsageError, RosmlError)):
        parsed(shlex.split(command), real, examples=False)


def test_what_a_page_joins_goes_together(real: ImageSet) -> None:
    """Whoever copies the call gets an image, and no refusal for a part that is not there."""
    whole = [{*image.parts} for image in real.images]
    shown = [command for command in PROOFS if re.search(r"\brosml join |join\.py [a-z]", command)]
    assert len(shown) == 2
    for command in shown:
        [between] = re.findall(r"/part:\{(.*?)\}", command)
        assert {*between.split(",")} in whole, command


def test_the_table_of_words(monkeypatch: pytest.MonkeyPatch) -> None:
    """make's words and those of `rosml`: messages translate one into the other, as the page says."""
    rows = re.findall(r"^\| `(make [^`]+)` \| `(rosml [^`]+)` \|$", (ROOT / "docs/use.md").read_text(), re.MULTILINE)
    assert len(rows) > 15
    monkeypatch.setenv(CALLED, "rosml")
    assert [(make, in_words(make)) for make, _ in rows] == rows
    for _, word in rows:
        argv = shlex.split(word)[1:]
        if argv != ["setup"]:
            accepted(main.cli, argv)
