"""All plugins: rosml's own and those of installed packages; and the command line that they make."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module

from rosml.base.errors import RosmlError
from rosml.run import paths, words
from rosml.run.context import Context
from rosml.run.plugin import GROUP, Added, Plugin, in_order
from rosml.run.plugins import concerns, devices, gpu, ros, sockets
from rosml.run.plugins.user import user

OWN: tuple[Plugin, ...] = (
    Plugin("removal", concerns.removal, {"no-rm": "keep the container when it ends"}),
    Plugin("terminal", concerns.terminal, {"no-it": "neither a terminal nor standard input"}),
    Plugin("name", concerns.name, {"no-name": "do not name the container after the current folder"}),
    Plugin("label", concerns.label),
    Plugin("grace", concerns.grace),
    Plugin("user", user, {"no-user": "the image's own user, and not you"}),
    Plugin("timezone", concerns.timezone, {"no-tz": "not your time zone"}),
    Plugin("locale", concerns.locale, {"loc": "your locale, which the image must have"}),
    Plugin(
        "mounts",
        concerns.mounts,
        {
            "mwd": "mount the current folder at its own path, and begin there",
            "mws": "mount the current folder as $WORKSPACE/src/target",
        },
    ),
    devices.PLUGIN,
    gpu.PLUGIN,
    *sockets.PLUGINS,
    ros.PLUGIN,
)
"""rosml's own plugins, in the order of their words. They are registered here, because a search for entry points takes time."""

OPTION = re.compile("[a-z0-9]+(-[a-z0-9]+)*")
"""The name of an option of a plugin."""


@dataclass(frozen=True)
class Found:
    """All plugins.

    Attributes:
        plugins: in their order.
        notes: left out plugins of other packages, each with a remedy.
    """

    plugins: tuple[Plugin, ...]
    notes: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Plan:
    """The plan of a call.

    Attributes:
        argv: the engine's command.
        folders: folders of this machine that -v mounts.
        files, notes: as in `Added`.
    """

    argv: tuple[str, ...]
    folders: tuple[str, ...] = ()
    files: Mapping[str, bytes] = field(default_factory=dict)
    notes: tuple[tuple[str, str], ...] = ()


# ---- Which there are -------------------------------------------------------------------------------------------------


def found(reserved: Iterable[str], folders: Sequence[str] | None = None) -> Found:
    """All plugins. If one of another package cannot be loaded, or takes an option that is taken, it is left out.

    Args:
        reserved: options that no plugin may have, without `--`.
        folders: the folders of packages; by default, those of Python.
    """
    plugins, notes = [*OWN], list[tuple[str, str]]()
    taken = {*reserved, *words.table().names, *(option for plugin in OWN for option in plugin.options)}
    for package, entry, place in registered(sys.path if folders is None else folders):
        try:
            plugin = _loaded(place)
            if odd := [option for option in plugin.options if not OPTION.fullmatch(option)]:
                raise ValueError(f"{odd[0]!r} is no name of an option")
            if clash := sorted(taken & {*plugin.options}):
                raise ValueError(f"its option --{clash[0]} is taken")
            if plugin.name in {other.name for other in plugins}:
                raise ValueError(f"another plugin is called {plugin.name}")
        except Exception as error:  # the container starts, whatever another package does wrong
            notes.append(_left_out(entry, package, error))
            continue
        plugins.append(replace(plugin, package=package))
        taken |= {*plugin.options}
    ordered, refused = in_order(plugins)
    notes += [_left_out(x.name, x.package, ValueError("its before and after contradict others")) for x in refused]
    return Found(tuple(ordered), tuple(notes))


def registered(folders: Iterable[str]) -> Iterator[tuple[str, str, str]]:
    """The entry points of the group: package, name, place. importlib.metadata is several times slower: it reads the metadata
    of all packages.

    Args:
        folders: the folders of packages.
    """
    for folder in dict.fromkeys(folders):
        try:
            names = sorted(name for name in os.listdir(folder or ".") if name.endswith((".dist-info", ".egg-info")))
        except OSError:
            continue
        for name in names:
            try:
                with open(f"{folder or '.'}/{name}/entry_points.txt", encoding="utf-8") as file:
                    text = file.read()
            except (OSError, UnicodeDecodeError):
                continue
            if f"[{GROUP}]" in text:
                yield from ((name.partition("-")[0], *entry) for entry in _entries(text))


def _entries(text: str) -> Iterator[tuple[str, str]]:
    """The names and places of the group in a file of entry points."""
    section = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("["):
            section = line
        elif section == f"[{GROUP}]" and "=" in line:
            name, _, place = line.partition("=")
            yield name.strip(), place.partition("[")[0].strip()


def _loaded(place: str) -> Plugin:
    """The plugin at `module:name`.

    Raises:
        Exception: any error of its module, or there is none.
    """
    module, _, name = place.partition(":")
    plugin = getattr(import_module(module), name)
    if not isinstance(plugin, Plugin):
        raise TypeError(f"{place} is no rosml.run.plugin.Plugin")
    return plugin


def _left_out(name: str, package: str, error: Exception) -> tuple[str, str]:
    text = f"the plugin {name} of {package} is left out: {type(error).__name__}: {error}"
    return text, f"update {package}, or remove it"


# ---- What they add ---------------------------------------------------------------------------------------------------


def plan(context: Context, plugins: Iterable[Plugin] = OWN) -> Plan:
    """The engine's command: the plugins' options, the user's own, the image, and the unchanged command.

    Raises:
        RosmlError: a plugin cannot do what the user asks for.
    """
    line, more, files, notes = context.line, list[str](), dict[str, bytes](), list[tuple[str, str]]()
    for plugin in plugins:
        try:
            added = _added(plugin, context)
        except RosmlError:
            raise
        except Exception as error:
            if not plugin.package:
                raise
            notes.append(_left_out(plugin.name, plugin.package, error))
            continue
        more += added.words
        files |= added.files
        notes += added.notes
    more += concerns.labels(context, more)
    resolved = [paths.resolved(given, context.person.folder) for given in line.engine]
    written = [word for given in resolved for word in given.words]
    folders = tuple(place for given in resolved for place in paths.mounted(given)) if context.is_here else ()
    argv = (context.engine.program, "run", *more, *written, line.image, *line.command)
    return Plan(argv, folders, files, tuple(notes))


def _added(plugin: Plugin, context: Context) -> Added:
    """Calls a plugin.

    Raises:
        TypeError: its result has another type.
    """
    added = plugin.plan(context)
    if not isinstance(added, Added):
        added = Added(added)
    if isinstance(added.words, str) or not all(isinstance(word, str) for word in added.words):
        raise TypeError("it adds something else than words")
    if not all(isinstance(content, bytes) and file.startswith("/") for file, content in added.files.items()):
        raise TypeError("it adds something else than bytes for absolute paths")
    return added
