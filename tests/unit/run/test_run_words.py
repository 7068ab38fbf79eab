"""The words of `rosml run`: options, values, the image and the command; thousands of generated command lines."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from fakes.desks import BARE
from fakes.profiles import PROFILE
from rosml.base.errors import RosmlError
from rosml.cli.run import run
from rosml.cli.run.container import LINE
from rosml.run.context import Context, Engine, Image, Person
from rosml.run.plan import make_plan
from rosml.run.words import Line, TypedOption, split, table

ROSML_OPTIONS = ("--no-rm", "--dry-run", "--help")
NOBODY = Person(1000, 1000, "me", "/home/me")


@pytest.mark.parametrize(
    ("words", "names", "value"),
    [
        (["--rm"], ["rm"], None),
        (["--rm=false"], ["rm"], "false"),
        (["--env", "A=b c"], ["env"], "A=b c"),
        (["--env", "--rm"], ["env"], "--rm"),
        (["-e", ""], ["env"], ""),
        (["-eA=b"], ["env"], "A=b"),
        (["-e=A=b"], ["env"], "A=b"),
        (["-it"], ["interactive", "tty"], None),
        (["-itv", "/a:/b"], ["interactive", "tty", "volume"], "/a:/b"),
        (["-t=false"], ["tty"], "false"),
        (["-h", "robot"], ["hostname"], "robot"),
        (["--brand-new=x y"], ["brand-new"], "x y"),
    ],
)
def test_an_option_and_its_value(words: list[str], names: list[str], value: str | None) -> None:
    line = split([*words, "image", "command", "--rm"], ROSML_OPTIONS)
    assert line == Line((), (TypedOption(tuple(words), tuple(names), value),), "image", ("command", "--rm"))


@pytest.mark.parametrize(
    ("words", "image", "command"),
    [
        (["i", "--", "x", "-"], "i", ["--", "x", "-"]),
        (["--", "i", "--rm"], "i", ["--rm"]),
        (["--rm", "--", "i", "--", "--rm"], "i", ["--", "--rm"]),
        (["--rm"], "", []),
    ],
)
def test_where_the_command_begins(words: list[str], image: str, command: list[str]) -> None:
    line = split(words, ROSML_OPTIONS)
    assert (line.image, list(line.command)) == (image, command)


def test_its_own_options_are_its_own_before_the_image_alone() -> None:
    line = split(["--dry-run", "-e", "--no-rm", "--no-rm=1", "image", "--no-rm"], ROSML_OPTIONS)
    assert (line.rosml, line.command) == (("--dry-run", "--no-rm=1"), ("--no-rm",))
    assert line.value("env") == "--no-rm"


@pytest.mark.parametrize(
    ("words", "says", "remedy"),
    [
        (["--volum", "./a:/a", "image"], "unknown option --volum", "did you mean --volume?"),
        (["--brand-new", "x", "image"], "unknown option --brand-new", "--brand-new=VALUE gives it to docker or podman"),
        (["--dry-rum", "image"], "unknown option --dry-rum", "did you mean --dry-run?"),
        (["-iZ", "image"], "unknown option -Z in '-iZ'", "--option=VALUE"),
        (["-e"], "the option -e lacks its value", "after it"),
        (["-", "x"], "'-' is no name of an image", "rosml run IMAGE"),
        (["--context", "x", "image"], "unknown option --context", "DOCKER_CONTEXT"),
        (["-D", "x", "image"], "unknown option -D", "--dry-run"),
        (["-P8080:80", "image"], "unknown option -8 in '-P8080:80'", "did you mean -p 8080:80?"),
        (["--=x", "image"], "unknown option --=x", "a name before ="),
        (["-it"] * 10_001 + ["image"], "10,001 options are more than", "--env-file"),
        (["", "bash"], "the image is an empty word", "the variable that should hold the image"),
        (["image", ""], "the command is an empty word", "the variable that should hold the command"),
        (["--", "--privileged"], "'--privileged' is no name of an image", "write an image"),
    ],
)
def test_what_cannot_be_read_has_a_remedy(words: list[str], says: str, remedy: str) -> None:
    with pytest.raises(RosmlError) as caught:
        split(words, ROSML_OPTIONS)
    assert caught.value.exit_code == 2
    assert says in caught.value.message and remedy in caught.value.remedy


HELP = re.compile(r"^\s+(?:-(\w), )?--([a-z0-9-]+)(?: (\S+))?(?: {2,}|$)", re.MULTILINE)
"""An option in the help of `docker run`: its letter, its name, and the name of its value."""


@pytest.mark.parametrize("engine", ["docker", "podman"])
def test_the_table_is_that_of_the_engine_on_this_machine(engine: str) -> None:
    assert {"volume", "mount", "env", "name"} <= table().values and {"rm", "tty", "interactive"} <= table().switches
    if shutil.which(engine):
        help_text = subprocess.run([engine, "run", "--help"], capture_output=True, text=True, check=True).stdout
        options = [(letter, name, value) for letter, name, value in HELP.findall(help_text) if name != "help"]
        assert len(options) > 50
        for letter, name, value in options:
            assert name in (table().values if value and "[=" not in value else table().switches)
            assert not letter or table().letters.get(letter) == name


WORD = st.text(st.characters(exclude_characters="\0", exclude_categories=()), max_size=12)
"""Any word that a process can get; lone surrogates are how Python has bytes that are no UTF-8."""
TRICKY = st.sampled_from(
    [
        *("", " ", "--", "-", "-it", "--rm", "--name", "--help", "--json", "--dry-run", "-e", "A=b c", "a  b", "--=x"),
        *("*", "$HOME", '"', "'", "\\", "\n", "`id`", "--no-user", "--verbose", ";", "&&", "\udcff", "./a:/a", "="),
    ]
)
WORDS = st.one_of(TRICKY, WORD)
IMAGE = st.builds(str.__add__, st.characters(exclude_characters="\0-", exclude_categories=()), WORD)
VALUES = sorted(table().values - {"volume", "mount"})
LETTERS = sorted(letter for letter, name in table().letters.items() if name in VALUES)
SWITCHES = "itdqP"


@st.composite
def option(draw: st.DrawFn) -> list[str]:
    """An option of the engine, in one of its spellings."""
    long, letter, value = draw(st.sampled_from(VALUES)), draw(st.sampled_from(LETTERS)), draw(WORDS)
    some = draw(st.text(SWITCHES, max_size=3))
    ways = [[f"--{long}", value], [f"--{long}={value}"], [f"-{letter}", value], [f"-{some}{letter}", value]]
    ways += [[f"--{draw(st.sampled_from(sorted(table().switches)))}"], [f"-{some or 'i'}"], [f"--unheard-of={value}"]]
    ways += [[f"-{some}{letter}{value}"]] if value and not value.startswith("=") else [[f"-{letter}=A={value}"]]
    return draw(st.sampled_from(ways))


ROSML_FLAGS = {"--no-rm", "--no-it", "--no-tz", "--no-user", "--no-name", "--mwd", "--no-gpu", "--verbose"}
FLAGS = st.sampled_from(sorted(ROSML_FLAGS))


@settings(PROFILE, max_examples=PROFILE.max_examples * 10)
@given(st.lists(st.one_of(option(), FLAGS.map(lambda flag: [flag])), max_size=6), IMAGE, st.lists(WORDS, max_size=8))
def test_a_command_is_not_changed(options: list[list[str]], image: str, command: list[str]) -> None:
    """The engine gets its options, the image and the command word for word."""
    words = [word for option in options for word in option]
    assume(command[:1] != [""])
    context = run.main.make_context("rosml run", [*words, image, *command])
    line: Line = context.meta[LINE]
    argv = make_plan(Context(line, Engine(), NOBODY, Image(environment={"DOCKER_UID": ""}), BARE, trusted=True)).argv
    theirs = [word for option in options if option[0] not in ROSML_FLAGS for word in option]
    tail = [*theirs, image, *command]
    assert [*argv[len(argv) - len(tail) :]] == tail
    added = argv[: len(argv) - len(tail)]
    assert added[:2] == ("docker", "run") and not ROSML_FLAGS & set(added)
    makes_user = not line.asks("no-user") and not line.has("user", "entrypoint")
    assert ("DOCKER_UID=1000" in added) == makes_user
