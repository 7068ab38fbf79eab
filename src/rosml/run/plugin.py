"""What a plugin of `rosml run` is: one concern, such as GPUs. From what is known, it says what the engine gets."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.run.context import Context

GROUP = "rosml.run"
"""The entry points by which an installed package registers its plugins."""


@dataclass(frozen=True)
class Added:
    """What a plugin adds.

    Attributes:
        words: options of the engine. The person's own follow them.
        files: what is in private files, by their absolute paths; they are written before the container starts.
        notes: what the person should know, and what to do about it.
    """

    words: Sequence[str] = ()
    files: Mapping[str, bytes] = field(default_factory=dict)
    notes: Sequence[tuple[str, str]] = ()


NOTHING = Added()


@dataclass(frozen=True)
class Plugin:
    """A concern.

    Attributes:
        plan: from all that is known to what is added, or to words alone. It changes nothing, and starts no process. A
            RosmlError from it ends the call.
        options: its switches, without `--`, and what each does. `context.line.asks` says whether somebody wrote one.
        before, after: names of other plugins, for the order of the words. Those that are missing do not count.
        package: where it comes from; empty where it is rosml's own. rosml fills it in.
    """

    name: str
    plan: Callable[[Context], Added | Sequence[str]]
    options: Mapping[str, str] = field(default_factory=dict)
    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    package: str = ""


def in_order(plugins: Sequence[Plugin]) -> tuple[list[Plugin], list[Plugin]]:
    """Plugins by what they declare, otherwise in the order in which they are given; and those for which there is no order."""
    left, ordered, refused = [*plugins], list[Plugin](), list[Plugin]()
    while left:
        ready = next((plugin for plugin in left if not any(_precedes(other, plugin) for other in left)), None)
        (ordered if ready else refused).append(ready := ready or left[-1])
        left.remove(ready)
    return ordered, refused


def _precedes(first: Plugin, second: Plugin) -> bool:
    return first is not second and (first.name in second.after or second.name in first.before)
