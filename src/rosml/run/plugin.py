"""The interface of plugins. A plugin of `rosml run` is one concern, such as GPUs: from the facts, it makes options of the engine."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.run.context import Context

GROUP = "rosml.run"
"""The group of entry points by which an installed package registers its plugins."""


@dataclass(frozen=True)
class Added:
    """The result of a plugin.

    Attributes:
        words: options of the engine. The user's own follow them.
        files: the content of private files, by absolute paths. rosml writes them before the container starts.
        notes: warnings, each with a remedy.
    """

    words: Sequence[str] = ()
    files: Mapping[str, bytes] = field(default_factory=dict)
    notes: Sequence[tuple[str, str]] = ()


NOTHING = Added()


@dataclass(frozen=True)
class Plugin:
    """A concern.

    Attributes:
        plan: a function from the facts to `Added`, or to words alone. It changes nothing, and starts no process. If it raises a
            RosmlError, the call ends.
        options: its switches, without `--`, and the help for each. `context.line.asks` says whether the user typed one.
        before, after: names of other plugins, for the order of the words. Missing ones do not count.
        package: its package; empty for rosml's own. rosml fills it in.
    """

    name: str
    plan: Callable[[Context], Added | Sequence[str]]
    options: Mapping[str, str] = field(default_factory=dict)
    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    package: str = ""
