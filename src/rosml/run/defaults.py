"""The files with defaults for `rosml run`: the user's, the project's, and a command line on top of them."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.run import paths
from rosml.run.words import HERE, Line, TypedOption, split

PERSON = "rosml/run.toml"
PROJECT = ".rosml.toml"
KEYS = {
    "image": '"ghcr.io/me/rosml/ros:jazzy-base"',
    "options": '["--mws", "-e", "ROS_DOMAIN_ID=7"]',
    "command": '["ros2", "topic", "list"]',
}

LIMIT = 64 * 1024
"""The most bytes of a file: users see all of it when we ask them about it."""


@dataclass(frozen=True)
class File:
    """A file with defaults. `line` has the targets of links, so that a link that changes later leads the engine nowhere else."""

    path: str
    content: bytes
    owner: int
    line: Line  # its settings, with absolute paths
    leads: tuple[paths.Lead, ...] = ()  # the paths in a project's file


@dataclass(frozen=True)
class Files:
    """The files that exist."""

    person: File | None = None
    project: File | None = None

    def under(self, typed: Line) -> Line:
        """A command line with the defaults below it: of two options that set the same thing, the engines take the later one.
        If the user types an image, there is no default for the command, which belongs to another image. If they ask for
        another container, there is none for its name, which may be taken."""
        lines = [line for _, line in self.counting(typed)]
        image, command = typed.image, typed.command
        if image in ("", HERE):
            image = next((line.image for line in lines if line.image), "")
            command = command or next((line.command for line in lines if line.command), ())
        own_words = tuple(word for line in (*lines, typed) for word in line.rosml)
        return Line(own_words, (*(option for line in lines for option in line.engine), *typed.engine), image, command)

    def counting(self, typed: Line) -> list[tuple[str, Line]]:
        """The files, each with the part that counts: one image, with the command of its own file or of one above that names no
        image, and the options that nothing above replaces."""
        files = [file for file in (self.project, self.person) if file]
        if not files:
            return []
        parts: list[tuple[str, Line]] = []
        above, needs_image, needs_command = typed.engine, typed.image in ("", HERE), not typed.command
        for file in files:
            line = file.line
            options = [option for option in line.engine if not (typed.asks("new") and "name" in option.names)]
            engine = tuple(rest for option in options if (rest := without(option, above)))
            image = line.image if needs_image else ""
            command = line.command if needs_image and needs_command else ()
            needs_image, needs_command = needs_image and not image, needs_command and not command
            parts.insert(0, (file.path, Line(line.rosml, engine, image, command)))
            above = (*engine, *above)
        return parts

    def summary(self, typed: Line) -> list[str]:
        """The part of each file that counts, in words."""
        return [
            f"from {shown(path)}: {' '.join(words)}"
            for path, line in self.counting(typed)
            if (words := [shown(word) for word in (*line.rosml, *line.engine_words, line.image, *line.command) if word])
        ]


def without(option: TypedOption, later: Iterable[TypedOption]) -> TypedOption | None:
    """An option without the thing that later ones set, as the engines refuse two mounts at a path. None if nothing is left."""
    thing = _thing(option)
    if not thing[0] or thing not in map(_thing, later):
        return option
    *others, _ = option.names  # `-it` of `-itv a:/b`
    return TypedOption((option.words[0][: len(option.names)],), tuple(others)) if others else None


def _thing(option: TypedOption) -> tuple[str, str]:
    """The kind and the name of the thing that the last option of a word sets; empty if a container may have several."""
    name, value, path = option.names[-1], option.value or "", ""
    if name == "name":
        return name, ""
    if name == "env":
        return name, value.partition("=")[0]
    if name == "volume":
        path = value.split(":")[1] if ":" in value else value
    elif name == "tmpfs":
        path = value.partition(":")[0]
    elif name == "mount":
        fields = dict(field.partition("=")[::2] for field in paths.fields(value) or ())
        path = next((fields[key] for key in ("target", "dst", "destination") if key in fields), "")
    return ("place", path.rstrip("/") or "/") if path else ("", "")


def base(environment: Mapping[str, str], variable: str, usual: str) -> str:
    """A folder of the user's, by the XDG Base Directory Specification: that of the variable, unless it is relative, or else the usual
    path in their home."""
    folder = environment.get(variable, "")
    return folder if folder.startswith("/") else os.path.join(home(), usual)


def home() -> str:
    """The user's home folder; / if they have none, or a relative one, which would be a place in somebody's project."""
    folder = os.path.expanduser("~")
    return folder if folder.startswith("/") else "/"


def files(environment: Mapping[str, str], folder: str, options: Collection[str], refused: Collection[str]) -> Files:
    """The files that exist for a folder. `options` are rosml's own that a file can have, `refused` those for the command line alone."""
    path = f"{base(environment, 'XDG_CONFIG_HOME', '.config')}/{PERSON}"
    project = project_file(folder, home())
    person_file = _file(path, options, refused) if os.path.lexists(path) else None
    if person_file and not is_own(person_file.owner, environment):
        raise _wrong(path, 0, f"it belongs to another user ({person_file.owner})", "make it yours, or move it away")
    return Files(person_file, _file(project, options, refused, is_project=True) if project else None)


def is_own(owner: int, environment: Mapping[str, str]) -> bool:
    """Whether a file's owner is the user or root; for root by sudo, also the user who called sudo."""
    uid, caller = os.geteuid(), environment.get("SUDO_UID", "")
    return owner in (uid, 0) or (uid == 0 and caller == str(owner))


def project_file(folder: str, end: str) -> str:
    """The file of a project: in a folder or the nearest one above it; empty if there is none. The search ends below the home
    folder, for which the user's own file counts, and at the end of a file system."""
    here, end, device = folder, os.path.realpath(end), _device(folder)
    while here != end and _device(here) == device:
        if os.path.lexists(path := os.path.join(here, PROJECT)):
            return path
        if here == os.path.dirname(here):
            break
        here = os.path.dirname(here)
    return ""


def _device(folder: str) -> int:
    """The file system of a folder; -1 if we may not look."""
    try:
        return os.stat(folder).st_dev
    except OSError:
        return -1


def shown(text: str) -> str:
    """Text for a terminal, with escapes for characters that move the cursor or change the order of letters."""
    return "".join(x if x.isprintable() else x.encode("unicode_escape").decode() for x in text)


def _file(path: str, options: Collection[str], refused: Collection[str], is_project: bool = False) -> File:
    """Reads a file that exists. A project's file may be no link, and we follow the links of its paths now."""
    try:
        # O_NONBLOCK: a pipe in its place would wait for a writer.
        flags = os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC | (os.O_NOFOLLOW if is_project else 0)
        with open(os.open(path, flags), "rb") as stream:
            status = os.fstat(stream.fileno())
            if not stat.S_ISREG(status.st_mode):
                raise _wrong(path, 0, "it is no file", "move it away")
            content = stream.read(LIMIT + 1)
    except OSError as error:
        if is_project and os.path.islink(path):
            raise _wrong(path, 0, "it is a link", "put the file itself there") from None
        raise _wrong(path, 0, f"cannot be read: {error.strerror}", "make it readable, or move it away") from None
    if len(content) > LIMIT:
        raise _wrong(path, 0, f"it has more than {LIMIT // 1024} KiB", "shorten it, or move it away")
    line, leads = _line(path, _text(path, content), options, refused, is_project)
    return File(path, content, status.st_uid, line, leads)


def _wrong(path: str, line: int, text: str, remedy: str) -> RosmlError:
    """The error at a line of a file; 0 stands for the whole file."""
    place = f"{path}:{line}" if line else path
    return RosmlError(shown(f"{place}: {text}"), f"{shown(remedy)}; --no-defaults leaves it out", exit_code=2)


def _text(path: str, content: bytes) -> str:
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise _wrong(path, line, f"not UTF-8 (byte 0x{content[error.start]:02x})", "save it as UTF-8") from None


def _line(
    path: str, text: str, options: Collection[str], refused: Collection[str], follows: bool
) -> tuple[Line, tuple[paths.Lead, ...]]:
    """The settings of a file, and the targets of its paths if we follow them."""
    from rosml.base import untrusted  # most folders have no file

    if long := untrusted.DOTTED.search(text):
        line = text.count("\n", 0, long.start()) + 1
        raise _wrong(path, line, "a key has too many parts", f"the keys are {', '.join(KEYS)}")
    try:
        settings = untrusted.toml_value(text)
    except ValueError as error:
        reason, _, place = str(error).partition(" (at ")
        position = re.match(r"line (\d+)", place)
        line = int(position[1]) if position else text.count("\n") + 1 if place else 0
        raise _wrong(path, line, f"no TOML: {reason[:1].lower()}{reason[1:]}", "correct that line") from None
    for key, value in settings.items():
        try:
            _check(key, value)
        except RosmlError as error:
            raise _wrong(path, _place(text, key), error.message, error.remedy) from None
    try:
        options_line = _options(settings.get("options", []), options, refused)
        engine = [paths.anchored(option, os.path.dirname(path)) for option in options_line.engine]
        followed = [paths.followed(option) if follows else (option, ()) for option in engine]
    except RosmlError as error:
        raise _wrong(path, _place(text, "options"), error.message, error.remedy) from None
    engine_options = tuple(option for option, _ in followed)
    command = tuple(settings.get("command", ()))
    line_settings = Line(options_line.rosml, engine_options, settings.get("image", ""), command)
    return line_settings, tuple(lead for _, leads in followed for lead in leads)


def _place(text: str, key: str) -> int:
    """The line of a key; 0 if it is written in some other way."""
    match = re.search(rf"^[ \t]*(\[+[ \t]*)?([\"']?){re.escape(key)}\2[ \t]*[=.\]]", text, re.MULTILINE)
    return text.count("\n", 0, match.start()) + 1 if match else 0


def _check(key: str, value: object) -> None:
    if key not in KEYS:
        from rosml.base.problems import near  # only needed when something is wrong

        raise RosmlError(f"unknown key {key!r}", near(key, KEYS))
    words = [value] if key == "image" else value
    if not isinstance(words, list) or not all(isinstance(word, str) for word in words):
        kind = "a text" if key == "image" else "a list of texts"
        raise RosmlError(f"{key} must be {kind}", f"write {key} = {KEYS[key]}")
    if odd := next((letter for word in words for letter in word if not letter.isprintable()), ""):
        raise RosmlError(f"{key} has a character that cannot be shown: {odd!r}", "remove it")
    if key == "image" and (value in ("", HERE) or words[0].startswith("-")):
        raise RosmlError(f"{value!r} is no name of an image", f"write image = {KEYS['image']}")


def _options(words: Sequence[str], options: Collection[str], refused: Collection[str]) -> Line:
    """Options of rosml and of the engine, without a hidden image or command."""
    if two_words := next((word for word in words if re.match(r"--?[A-Za-z][\w-]* ", word)), ""):
        first, _, second = two_words.partition(" ")
        raise RosmlError(f"options has two words in one: {two_words!r}", f'write "{first}", "{second.strip()}"')
    line = split(words, [*options, *refused])
    if command_line_only := next((name for word in line.rosml if (name := word.partition("=")[0]) in refused), ""):
        raise RosmlError(f"{command_line_only} is for the command line alone", "remove it")
    count = len(line.rosml) + sum(len(option.words) for option in line.engine)
    if count < len(words):
        raise RosmlError(f"options has {words[count]!r}, which is no option", 'an image goes into image = "…"')
    if with_value := next((word.partition("=")[0] for word in line.rosml if word not in options), ""):
        raise RosmlError(f"{with_value} takes no value", f"write {with_value}")
    return line
