"""The words of `rosml run`: its own options, the engine's, the image, and the command, which stays unchanged."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from rosml.base.errors import RosmlError

_WHERE = "it is an option of docker itself: set DOCKER_CONTEXT or DOCKER_HOST, or call `docker context use NAME`"
_SPOKEN = "it is an option of the engine itself: `rosml run --dry-run` prints a command, into which you can write it"
_PODMAN = "it is an option of podman itself: set CONTAINER_HOST, or call `podman system connection default NAME`"

NOT_OF_RUN = {
    **dict.fromkeys(("context", "host", "H", "tls", "tlscacert", "tlscert", "tlskey", "tlsverify"), _WHERE),
    **dict.fromkeys(("debug", "D", "log-level"), _SPOKEN),
    **dict.fromkeys(("connection", "identity", "remote", "url"), _PODMAN),
    "config": "it is an option of docker itself: set DOCKER_CONFIG",
    "version": "rosml --version, or docker --version, or podman --version",
    # Options of rocker, which people come from: https://github.com/osrf/rocker
    "x11": "leave it out: rosml run hands in your display; --no-x11 switches that off",
    **dict.fromkeys(("nvidia", "gpu"), "leave it out: rosml run hands in your GPUs; --no-gpu switches that off"),
    "devices": "write --device for each",
    "home": "write -v $HOME:$HOME",
    "git": "write -v ~/.gitconfig:$HOME/.gitconfig:ro",
    "pulse": "write --sound",
    "ssh": "write --ssh-agent",
    "cuda": "take an image that has CUDA: rosml list cuda",
    "nocleanup": "write --no-rm",
    "nocache": "leave it out: rosml run builds nothing",
    "noexecute": "write --dry-run",
    "port": "write -p",
    "oyr-run-arg": "write what stands in it: all options of docker run go to docker",
    "image-name": "build an image of that name: rosml containerize --image-name, or docker build --tag",
    "persist-image": "build an image: rosml containerize, or docker build",
    "mode": "leave it out: --dry-run prints the command, and without it the command runs",
    # docker-run's
    "image": "write the image alone, after the options: rosml run IMAGE",
    "cmd": "write the command after the image: rosml run IMAGE COMMAND",
    "no-loc": "leave it out: no locale is passed without --loc",
}
"""Remedies for options that the engines, rosml or a similar tool have at another place."""

MOST_OPTIONS = 10_000
HERE = "."
"""The word for the image that a file names, and for the container of this folder."""

LETTERS = ("-it", "-ti", "-v", "-e", "-p")
"""Options of the engines with one letter that people write most. Others, such as -l, are often those of a program."""


@dataclass(frozen=True)
class TypedOption:
    """Options of the engine as typed: `--rm`, `-e A=b` (two words), or `-it` (two options in a word)."""

    words: tuple[str, ...]
    names: tuple[str, ...]  # long ones, such as `env`
    value: str | None = None  # of the last option, at the end of the last word; None if it is a switch

    def with_value(self, value: str) -> TypedOption:
        """The same with another value, written in the same way."""
        *words, last = self.words
        return TypedOption((*words, last.removesuffix(self.value or "") + value), self.names, value)


@dataclass(frozen=True)
class Line:
    """A command line."""

    rosml: tuple[str, ...]  # words for rosml itself
    engine: tuple[TypedOption, ...]
    image: str  # empty if there is none
    command: tuple[str, ...]  # all words after the image

    @property
    def engine_words(self) -> list[str]:
        return [word for option in self.engine for word in option.words]

    def asks(self, name: str) -> bool:
        """Whether the user typed a switch of rosml's own, such as `no-rm`."""
        return f"--{name}" in self.rosml

    def has(self, *names: str) -> bool:
        """Whether the user typed one of these options of the engine, by their long names."""
        return any(name in option.names for option in self.engine for name in names)

    def value(self, name: str) -> str:
        """The last value of an option of the engine; empty if there is none."""
        return (self.values(name) or [""])[-1]

    def values(self, *names: str) -> list[str]:
        """The values of options of the engine, in their order."""
        return [option.value or "" for option in self.engine if option.names[-1] in names]

    def late(self, rosml_options: Collection[str]) -> bool:
        """Whether an option of the engines, or one of rosml's own, stands after the image, and is the command therefore."""
        first = next(iter(self.command), "")
        name = first.partition("=")[0]
        return name in rosml_options or first in LETTERS or (first.startswith("--") and name[2:] in table().names)

    @property
    def taken_word(self) -> str:
        """The option that took the last word as its value, if no image follows; empty if none did."""
        last = self.engine[-1] if self.engine and not self.image else TypedOption((), ())
        return f"{last.value!r} is the value of {last.words[0]}" if len(last.words) > 1 else ""

    def sets(self, *variables: str) -> bool:
        """Whether the user sets one of these environment variables of the container."""
        return any(value.partition("=")[0] in variables for value in self.values("env"))


@dataclass(frozen=True)
class Table:
    """The engines' options: long names of those with a value and of the others, and the long name for each letter."""

    values: frozenset[str]
    switches: frozenset[str]
    letters: Mapping[str, str]
    names: frozenset[str]


@cache
def table() -> Table:
    """The options of docker and podman, from engine_options.txt."""
    names: dict[str, set[str]] = {"value": set(), "switch": set()}
    letters: dict[str, str] = {}
    for line in Path(__file__).with_name("engine_options.txt").read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            kind, *letter, long = line.split()
            name = long.removeprefix("--")
            names[kind].add(name)
            letters.update({short.removeprefix("-"): name for short in letter})
    values, switches = frozenset(names["value"]), frozenset(names["switch"])
    return Table(values, switches, letters, values | switches)


def split(words: Collection[str], rosml_options: Collection[str], with_value: Collection[str] = ()) -> Line:
    """Reads a command line as docker and podman read theirs: the first word that is no option is the image. Of rosml's own options, such
    as `--dry-run`, those of `with_value` take a value."""
    rosml_words: list[str] = []
    engine: list[TypedOption] = []
    rest = iter(words)
    for word in rest:
        if word == "--":
            return _line(rosml_words, engine, [*rest])
        if not word.startswith("-") or word == "-":
            return _line(rosml_words, engine, [word, *rest])
        if word.partition("=")[0] in rosml_options:
            rosml_words += [word, _value(word, rest)] if word in with_value else [word]
        elif word.startswith("--"):
            engine.append(_long(word, rest, rosml_options))
        else:
            engine.append(_letters(word, rest))
    return _line(rosml_words, engine, [])


def _line(rosml_words: list[str], engine: list[TypedOption], rest: list[str]) -> Line:
    if len(engine) > MOST_OPTIONS:
        text = f"{len(engine):,} options are more than any call of an engine needs"
        raise RosmlError(text, f"write at most {MOST_OPTIONS:,}; --env-file takes many variables", exit_code=2)
    image = rest[0] if rest else ""
    has_entrypoint = any("entrypoint" in option.names for option in engine)  # then the command may be empty
    for word, part in zip(rest, ("image",) if has_entrypoint else ("image", "command"), strict=False):
        if not word:
            remedy = f"leave it out, or look at the variable that should hold the {part}"
            raise RosmlError(f"the {part} is an empty word", remedy, exit_code=2)
    if image.startswith("-"):  # after `--`; the engine would take it for an option
        remedy = "rosml run IMAGE" if image == "-" else "write an image after --"
        raise RosmlError(f"{image!r} is no name of an image", remedy, exit_code=2)
    if "<registry>" in image:
        text = f"{image}: <registry> stands for the place that has the images"
        raise RosmlError(text, "write an image that you have, such as ghcr.io/me/rosml/ros:jazzy-base", exit_code=2)
    return Line(tuple(rosml_words), tuple(engine), image, tuple(rest[1:]))


def _long(word: str, rest: Iterator[str], rosml_options: Collection[str]) -> TypedOption:
    name, equals, value = word[2:].partition("=")
    if equals and not name:
        raise RosmlError(f"unknown option {word}", "write a name before =", exit_code=2)
    if equals:
        return TypedOption((word,), (name,), value)
    if name in table().switches:
        return TypedOption((word,), (name,))
    if name in table().values:
        value = _value(word, rest)
        return TypedOption((word, value), (name,), value)
    raise RosmlError(f"unknown option {word}", _remedy(word, rosml_options), exit_code=2)


def _remedy(word: str, rosml_options: Collection[str]) -> str:
    """A similar name, and the way to write an option of a newer engine."""
    name = word.removeprefix("--")
    if name in NOT_OF_RUN:
        return NOT_OF_RUN[name]
    from difflib import get_close_matches  # only needed when something is wrong

    names = [*(option.removeprefix("--") for option in rosml_options), *table().names]
    advice = f"{word}=VALUE gives it to docker or podman; for a switch, write {word}=true"
    meant = get_close_matches(name, names, n=1, cutoff=0.75)
    return f"did you mean --{meant[0]}? {advice}" if meant else advice


def _letters(word: str, rest: Iterator[str]) -> TypedOption:
    """Options with one letter; a word may have several: `-it`, `-eA=b`, `-itv /a:/a`."""
    names: list[str] = []
    letters = word[1:]
    while letters:
        letter, letters = letters[0], letters[1:]
        if letter not in table().letters:
            remedy = NOT_OF_RUN.get(letter, "write its long name with its value: --option=VALUE")
            if names == ["publish-all"] and letter.isdigit():
                remedy = f"did you mean -p {letter}{letters}? -P publishes all ports"
            raise RosmlError(f"unknown option -{letter} in {word!r}", remedy, exit_code=2)
        names.append(table().letters[letter])
        if letters.startswith("=") and len(letters) > 1:
            return TypedOption((word,), tuple(names), letters[1:])
        if names[-1] in table().values:
            if letters:
                return TypedOption((word,), tuple(names), letters)
            value = _value(f"-{letter}", rest)
            return TypedOption((word, value), tuple(names), value)
    return TypedOption((word,), tuple(names))


def _value(option: str, rest: Iterator[str]) -> str:
    value = next(rest, None)
    if value is None:
        raise RosmlError(f"the option {option} lacks its value", "write the value after it", exit_code=2)
    return value


def variables(values: Mapping[str, object]) -> list[str]:
    """The words for environment variables."""
    return [word for name, value in values.items() for word in ("-e", f"{name}={value}")]
