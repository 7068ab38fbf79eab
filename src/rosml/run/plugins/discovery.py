"""All plugins: rosml's own and those of installed packages."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import import_module

from rosml.run import words
from rosml.run.plugin import GROUP, Plugin
from rosml.run.plugins import basic_options, gpu, ros, sockets
from rosml.run.plugins.user import user

BUILT_IN: tuple[Plugin, ...] = (
    Plugin("removal", basic_options.removal, {"no-rm": "keep the container when it ends"}),
    Plugin("terminal", basic_options.terminal, {"no-it": "neither a terminal nor standard input"}),
    Plugin("name", basic_options.name, {"no-name": "do not name the container after the current folder"}),
    Plugin("label", basic_options.label),
    Plugin("grace", basic_options.grace),
    Plugin("user", user, {"no-user": "the image's own user, and not you"}),
    Plugin("timezone", basic_options.timezone, {"no-tz": "not your time zone"}),
    Plugin("locale", basic_options.locale, {"loc": "your locale, which the image must have"}),
    Plugin(
        "mounts",
        basic_options.mounts,
        {
            "mwd": "mount the current folder at its own path, and begin there",
            "mws": "mount the current folder as $WORKSPACE/src/target",
        },
    ),
    *gpu.PLUGINS,
    *sockets.PLUGINS,
    ros.PLUGIN,
)
"""rosml's own plugins, in the order of their words. They are registered here, because a search for entry points takes time."""

OPTION = re.compile("[a-z0-9]+(-[a-z0-9]+)*")


@dataclass(frozen=True)
class Discovery:
    """All plugins in their order, and a note with a remedy for each plugin of another package that is left out."""

    plugins: tuple[Plugin, ...]
    notes: tuple[tuple[str, str], ...] = ()


def discover(reserved: Iterable[str], folders: Sequence[str] | None = None) -> Discovery:
    """All plugins. One of another package that cannot be loaded, or takes an option that is taken or reserved, is left out."""
    plugins, notes = [*BUILT_IN], list[tuple[str, str]]()
    options = {*reserved, *words.table().names, *(option for plugin in BUILT_IN for option in plugin.options)}
    for package, entry, place in registered(sys.path if folders is None else folders):
        try:
            plugin = _loaded(place)
            if odd := [option for option in plugin.options if not OPTION.fullmatch(option)]:
                raise ValueError(f"{odd[0]!r} is no name of an option")
            if clash := sorted(options & {*plugin.options}):
                raise ValueError(f"its option --{clash[0]} is taken")
            if plugin.name in {other.name for other in plugins}:
                raise ValueError(f"another plugin is called {plugin.name}")
        except Exception as error:  # the container starts, whatever another package does wrong
            notes.append(omission(entry, package, error))
            continue
        plugins.append(replace(plugin, package=package))
        options |= {*plugin.options}
    ordered, refused = in_order(plugins)
    contradiction = ValueError("its before and after contradict others")
    notes += [omission(plugin.name, plugin.package, contradiction) for plugin in refused]
    return Discovery(tuple(ordered), tuple(notes))


def in_order(plugins: Sequence[Plugin]) -> tuple[list[Plugin], list[Plugin]]:
    """Plugins in the order that they declare, otherwise in the given order; and the plugins that contradict it."""
    remaining, ordered, refused = [*plugins], list[Plugin](), list[Plugin]()
    while remaining:
        ready = next((plugin for plugin in remaining if not any(_precedes(x, plugin) for x in remaining)), None)
        (ordered if ready else refused).append(ready := ready or remaining[-1])
        remaining.remove(ready)
    return ordered, refused


def _precedes(first: Plugin, second: Plugin) -> bool:
    return first is not second and (first.name in second.after or second.name in first.before)


def omission(name: str, package: str, error: Exception) -> tuple[str, str]:
    """The note, and its remedy, about a plugin that is left out."""
    text = f"the plugin {name} of {package} is left out: {type(error).__name__}: {error}"
    return text, f"update {package}, or remove it"


def registered(folders: Iterable[str]) -> Iterator[tuple[str, str, str]]:
    """The entry points of the group in folders of packages: package, name, place. importlib.metadata is several times slower: it
    reads the metadata of all packages."""
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
    """The plugin at `module:name`. Its module may raise any error."""
    module, _, name = place.partition(":")
    plugin = getattr(import_module(module), name)
    if not isinstance(plugin, Plugin):
        raise TypeError(f"{place} is no rosml.run.plugin.Plugin")
    return plugin
