"""The plan of a call: the engine's command, which the plugins make, and what must exist before it runs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.run import paths
from rosml.run.context import Context
from rosml.run.plugin import Added, Plugin
from rosml.run.plugins import basic_options
from rosml.run.plugins.discovery import BUILT_IN, omission


@dataclass(frozen=True)
class Plan:
    """The plan of a call. `files` and `notes` are those of `Added`."""

    argv: tuple[str, ...]
    folders: tuple[str, ...]  # of this machine, that -v mounts
    files: Mapping[str, bytes]
    notes: tuple[tuple[str, str], ...]


def make_plan(context: Context, plugins: Iterable[Plugin] = BUILT_IN) -> Plan:
    """The engine's command has the plugins' options, the user's own, the image, and the unchanged command."""
    line, options, files, notes = context.line, list[str](), dict[str, bytes](), list[tuple[str, str]]()
    for plugin in plugins:
        try:
            added = _added(plugin, context)
        except RosmlError:
            raise
        except Exception as error:
            if not plugin.package:
                raise
            notes.append(omission(plugin.name, plugin.package, error))
            continue
        options += added.words
        files |= added.files
        notes += added.notes
    options += basic_options.labels(context, options)
    typed = [paths.resolved(option, context.person.folder) for option in line.engine]
    folders = tuple(folder for option in typed for folder in paths.mounted(option)) if context.is_here else ()
    words = [word for option in typed for word in option.words]
    argv = (context.engine.program, "run", *options, *words, line.image, *line.command)
    return Plan(argv, folders, files, tuple(notes))


def _added(plugin: Plugin, context: Context) -> Added:
    added = plugin.plan(context)
    if not isinstance(added, Added):
        added = Added(added)
    if isinstance(added.words, str) or not all(isinstance(word, str) for word in added.words):
        raise TypeError("it adds something else than words")
    if not all(isinstance(content, bytes) and file.startswith("/") for file, content in added.files.items()):
        raise TypeError("it adds something else than bytes for absolute paths")
    return added
