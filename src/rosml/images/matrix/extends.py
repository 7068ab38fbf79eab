"""A set of images of your own: a file that says what differs from rosml's matrix.yaml, and extends it.

A file whose `extends:` is `rosml` has the keys of a matrix, each of them optional. What it does not name is as in the matrix of
the rosml that reads it, so a newer rosml brings newer releases, digests and locks.

- `distributions`, `frameworks`, `stacks` and `architectures` choose: if the file has such a section, only the entries in it exist. An entry
  without anything after its colon is as in rosml; the keys of an entry replace those in rosml.
- `addons` chooses as well. Without it, the set has no add-ons, as each is built and tested for every stack and Python.
- `environments` chooses likewise: the images that they go onto may not be in the set.
- Everything else adds and replaces, key by key; `parts` by their names. A key without a value is left out.
- What only belongs to stacks and frameworks that were not chosen (wheels, forecasts, budgets) goes with them. rosml's budgets of add-ons
  do not count the parts that its frameworks have, so they go as well if the set lacks one of those parts.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.base.problems import InputError, KeyPath, unknown
from rosml.images.matrix import source
from rosml.images.matrix.source import Document, Place

KEY = "extends"
"""The key that makes a file such a set."""

BASE = "rosml"
"""Its only value."""

CHOSEN = {
    "distributions": "distribution",
    "frameworks": "framework",
    "stacks": "stack",
    "architectures": "architecture",
    "addons": "add-on",
    "environments": "environment",
}
"""Sections in which a set names all that it wants, and what one entry is called."""


def read(file: Path, base: Path = ROOT / "matrix.yaml") -> Document:
    """A matrix, or a set as the whole matrix that it stands for. `base` is rosml's own matrix."""
    document = source.read(file)
    if not isinstance(document.data, Mapping) or KEY not in document.data:
        return document
    if document.data[KEY] != BASE:
        text = f"expected {BASE}: a set extends the matrix of the rosml that reads it"
        raise InputError(document.name, [*document.problems, document.problem((KEY,), text)])
    return extended(document, source.read(base))


def extended(document: Document, base: Document) -> Document:
    """The whole matrix of a set. Its problems have places in the set's file."""
    choice = {key: value for key, value in document.data.items() if key != KEY}
    data = dict(base.data)
    for key, value in choice.items():
        data[key] = (_chosen if key in CHOSEN else _parts if key == "parts" else _merged)(data.get(key), value)
    if missing := [
        document.problem((section, name), unknown(f"{noun} in rosml", name, _mapping(base.data.get(section))))
        for section, noun in CHOSEN.items()
        for name, entry in _mapping(choice.get(section)).items()
        if not entry and name not in _mapping(base.data.get(section))
    ]:
        raise InputError(document.name, [*document.problems, *missing])
    if lists := [
        document.problem((section,), "it is a list; write each name on its own line with a colon after it")
        for section in CHOSEN
        if isinstance(choice.get(section), tuple)
    ]:
        raise InputError(document.name, [*document.problems, *lists])
    plain = {name for name, facts in base.data["frameworks"].items() if not _names(facts)}
    chosen = _mapping(choice.get("frameworks"))
    if chosen and not plain & chosen.keys():
        text = f"add '{min(plain)}:', since images with a framework stand on those without one"
        raise InputError(document.name, [*document.problems, document.problem(("frameworks",), text)])
    data["addons"] = _addons(_mapping(data.get("addons")) if "addons" in choice else {}, data)
    data["environments"] = data.get("environments") if "environments" in choice else {}
    _forget(data, base.data, choice)
    if torn := [
        document.problem((section, name), f"none of the stacks of this set has its part {part}; add one that has it")
        for section in ("frameworks", "addons")
        for name, facts in _mapping(data[section]).items()
        for part in set(_lost(data, base.data)).intersection(_names(facts))
    ]:
        raise InputError(document.name, [*document.problems, *torn])
    items = data["parts"] if isinstance(data["parts"], tuple) else ()
    numbers = _numbers(document, items)
    places_by_number = {number: place for place, number in numbers.items()}
    called: dict[KeyPath, str] = {
        ("parts", number): f"parts[{_name(part) or places_by_number.get(number, number)}]"
        for number, part in enumerate(items)
    }
    return replace(document, data=data, places=_places(document, numbers), called=called, base=base)


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, Mapping) else {}


def _merged(base: Any, ours: Any) -> Any:
    """The base's value with the set's over it, key by key."""
    if not isinstance(base, Mapping) or not isinstance(ours, Mapping):
        return ours
    both = {**base, **{key: _merged(base.get(key), value) for key, value in ours.items()}}
    return {key: value for key, value in both.items() if value is not None}


def _chosen(base: Any, ours: Any) -> Any:
    """The entries that the set names, in the set's order."""
    if not isinstance(ours, Mapping):
        return ours
    defaults = _mapping(base)
    return {
        name: defaults.get(name) if entry is None else _merged(defaults.get(name), entry)
        for name, entry in ours.items()
    }


def _parts(base: Any, ours: Any) -> Any:
    """The base's parts, changed by name, and the set's own after them: in this order they are joined."""
    if not isinstance(ours, tuple) or not all(isinstance(part, Mapping) for part in ours):
        return ours
    base_names = {part["name"] for part in base}
    changes = {_name(part): part for part in ours}
    return (
        *(_merged(part, changes.get(part["name"], {})) for part in base),
        *(part for part in ours if _name(part) not in base_names),
    )


def _addons(addons: Mapping[str, Any], data: Mapping[str, Any]) -> dict[str, Any]:
    """Add-ons with the tags of images that the set has."""
    addons_of_set: dict[str, Any] = {}
    for name, facts in addons.items():
        tags = {
            key: tuple(item for item in value if item in _mapping(data.get(key))) if isinstance(value, tuple) else value
            for key, value in _mapping(_mapping(facts).get("tags")).items()
        }
        beside = tuple(item for item in _mapping(facts).get("beside", ()) if item in _mapping(data.get("frameworks")))
        addons_of_set[name] = _without(facts, ("tags", "beside"))
        if isinstance(facts, Mapping):
            addons_of_set[name] |= ({"tags": tags} if tags and all(tags.values()) else {}) | (
                {"beside": beside} if beside else {}
            )
    return addons_of_set


def _name(part: Any) -> str:
    name = _mapping(part).get("name")
    return name if isinstance(name, str) else ""


def _numbers(document: Document, parts: Sequence[Any]) -> dict[int, int]:
    """The indexes of the set's own parts, and those that they have in the whole matrix."""
    by_name = {_name(part): number for number, part in enumerate(parts)}
    by_identity = {id(part): number for number, part in enumerate(parts)}
    listed = document.data.get("parts")
    indexes = {
        place: by_identity.get(id(part), by_name.get(_name(part)))
        for place, part in enumerate(listed if isinstance(listed, tuple) else ())
    }
    return {place: number for place, number in indexes.items() if number is not None}


def _places(document: Document, numbers: Mapping[int, int]) -> dict[KeyPath, Place]:
    """The places of the set's values in the whole matrix."""
    places: dict[KeyPath, Place] = {}
    for path, place in document.places.items():
        if path[:1] == ("parts",) and len(path) > 1 and isinstance(path[1], int):
            if path[1] in numbers:
                places["parts", numbers[path[1]], *path[2:]] = place
        else:
            places[path] = place
    return places


def _forget(data: dict[str, Any], base: Mapping[str, Any], choice: Mapping[str, Any]) -> None:
    """Leaves out what only belongs to stacks and frameworks of the base that the set did not choose."""
    stacks = set(base["stacks"]) - set(data["stacks"]) if isinstance(data["stacks"], Mapping) else set[str]()
    data["releases"] = _releases(data["releases"], stacks)
    if isinstance(choice.get("architectures"), Mapping):
        gone = set(base["architectures"]) - set(data["architectures"])
        data["distributions"] = {
            name: facts
            for name, facts in _mapping(data["distributions"]).items()
            if name in _mapping(choice.get("distributions"))
            or not gone.issuperset(_mapping(facts).get("architectures") or data["architectures"])
        }
        _forget_architectures(data, gone)
        _forget_releases(data, base)
    if lost := set(_lost(data, base)):
        if "frameworks" not in choice:
            data["frameworks"] = {
                name: facts for name, facts in data["frameworks"].items() if not lost & {*_names(facts)}
            }
        kept = (*_mapping(data["frameworks"]).values(), *_mapping(data["addons"]).values())
        used = {name for facts in kept for name in _names(facts)}
        data["parts"] = tuple(part for part in data["parts"] if part.get("name") not in lost - used)
    gone = (
        {part["name"] for part in base["parts"]} - {_name(part) for part in data["parts"]}
        if isinstance(data["parts"], tuple)
        else set()
    )
    if isinstance(disk := data["disk"], Mapping):
        budgets = _budgets(_without(disk.get("budgets"), stacks), data, base, choice)
        parts = _without(disk.get("parts"), stacks)
        if isinstance(parts, Mapping):
            parts = {stack: _without(sizes, gone) for stack, sizes in parts.items()}
        data["disk"] = {**disk, "parts": parts, "budgets": budgets}
    if isinstance(data["distributions"], Mapping):
        chosen = _mapping(choice.get("distributions"))
        data["distributions"] = {
            name: facts
            if "default_stack" in _mapping(chosen.get(name))
            else _with_stacks(facts, _usable_stacks(data, _mapping(facts)))
            for name, facts in data["distributions"].items()
        }


def _budgets(budgets: Any, data: Mapping[str, Any], base: Mapping[str, Any], choice: Mapping[str, Any]) -> Any:
    """Budgets of the set's frameworks and add-ons, without those of rosml that are too small in it."""
    if not isinstance(budgets, Mapping):
        return budgets
    frameworks, addons = _mapping(data["frameworks"]), _mapping(data["addons"])
    base_addons = _mapping(base.get("addons"))
    remaining_parts = {part for facts in frameworks.values() for part in _names(facts)}
    lacks_part = any(set(_names(facts)) - remaining_parts for facts in base["frameworks"].values())
    gone = {*base["frameworks"], *base_addons} - {*frameworks, *addons}
    too_small = {*base_addons} if lacks_part else set[str]()
    budgets_of_set = _mapping(_mapping(choice.get("disk")).get("budgets"))
    return {
        stack: _without(budget, gone | too_small - {*_mapping(budgets_of_set.get(stack))})
        for stack, budget in budgets.items()
    }


def _without(value: Any, names: Collection[str]) -> Any:
    return {key: item for key, item in value.items() if key not in names} if isinstance(value, Mapping) else value


def _releases(value: Any, stacks: Collection[str]) -> Any:
    """Releases with the wheels of the stacks that are left; without those that have none."""
    if not isinstance(value, Mapping):
        return value
    releases: dict[str, Any] = {}
    for family, versions in value.items():
        kept = {version: _release(facts, stacks) for version, facts in _mapping(versions).items()}
        if kept := {version: facts for version, facts in kept.items() if _has_wheels(facts)}:
            releases[family] = kept
    return releases


def _release(facts: Any, stacks: Collection[str]) -> Any:
    if not isinstance(facts, Mapping):
        return facts
    release = {key: _without(it, stacks) if key in ("wheels", "elsewhere") else it for key, it in facts.items()}
    return release if release.get("elsewhere") else _without(release, ("elsewhere", "requires"))


def _lost(data: Mapping[str, Any], base: Mapping[str, Any]) -> Iterator[str]:
    """Parts of releases that none of the chosen stacks has."""
    kept = _mapping(data["releases"])
    for part in data["parts"] if isinstance(data["parts"], tuple) else ():
        release = part.get("release") if isinstance(part, Mapping) else None
        if isinstance(release, str) and release in base["releases"] and release not in kept:
            yield part["name"]


def _names(facts: Any) -> tuple[str, ...]:
    parts = _mapping(facts).get("parts")
    return tuple(name for name in parts if isinstance(name, str)) if isinstance(parts, tuple) else ()


def _has_wheels(facts: Any) -> bool:
    return not isinstance(facts, Mapping) or bool(facts.get("wheels") or facts.get("elsewhere"))


def _with_stacks(facts: Any, chosen: tuple[str, ...]) -> Any:
    """A distribution whose default stacks are those of rosml that are left, or else all of the set that are usable."""
    stacks = _mapping(facts).get("default_stack")
    stacks = (stacks,) if isinstance(stacks, str) else stacks
    if not isinstance(stacks, tuple) or all(stack in chosen for stack in stacks):
        return facts
    return {**facts, "default_stack": tuple(stack for stack in stacks if stack in chosen) or chosen or stacks}


def _usable_stacks(data: Mapping[str, Any], facts: Mapping[str, Any]) -> tuple[str, ...]:
    """The stacks of the set on which a distribution has a framework; all of them if it has none, since add-ons have a stack as well."""
    stacks = tuple(_mapping(data["stacks"]))
    return tuple(stack for stack in stacks if _fits(data, facts, stack)) or stacks


def _forget_architectures(data: dict[str, Any], gone: set[str]) -> None:
    def remaining(value: Any) -> Any:
        if isinstance(value, tuple):
            return tuple(item for item in value if item not in gone)
        if not isinstance(value, Mapping):
            return value
        kept = {key: remaining(item) for key, item in value.items() if key not in gone}
        return {key: item for key, item in kept.items() if item or not value[key] or key in ("wheels", "elsewhere")}

    for section in ("operating_systems", "distributions", "stacks", "releases"):
        data[section] = remaining(data[section])
    environments = _mapping(data["environments"])
    if environments:  # one with no architecture that is left keeps its own, which the message names
        data["environments"] = {
            name: remaining(facts) if "architectures" in _mapping(remaining(facts)) else facts
            for name, facts in environments.items()
        }
    data["releases"] = _releases(data["releases"], ())


def _forget_releases(data: dict[str, Any], base: Mapping[str, Any]) -> None:
    """Leaves out of stacks the releases that no chosen architecture has wheels of."""
    kept = _mapping(data["releases"])

    def gone(family: str, version: Any) -> bool:
        is_of_base = isinstance(version, str) and version in base["releases"].get(family, ())
        return is_of_base and version not in _mapping(kept.get(family))

    for name, facts in _mapping(data["stacks"]).items():
        releases = _mapping(_mapping(facts).get("releases"))
        lost = {family for family, version in releases.items() if gone(family, version)}
        if lost:
            remaining = {
                **facts,
                "releases": _without(releases, lost),
                "packages": _without(facts.get("packages", {}), lost),
            }
            data["stacks"] = {**data["stacks"], name: _without(remaining, ("apart",))}


def _fits(data: Mapping[str, Any], facts: Mapping[str, Any], stack: str) -> bool:
    """Whether a framework of the set exists for a distribution on a stack: one of its releases has wheels for that Python."""
    parts_of_data = data["parts"] if isinstance(data["parts"], tuple) else ()
    parts = {part.get("name"): part for part in parts_of_data if isinstance(part, Mapping)}
    python = _mapping(_mapping(data["operating_systems"]).get(str(facts.get("os")))).get("python")
    of_stack = _mapping(_mapping(data["stacks"]).get(stack))
    releases = _mapping(of_stack.get("releases"))
    for framework in map(_mapping, _mapping(data["frameworks"]).values()):
        carried = [parts[name] for name in _names(framework) if name in parts]
        families = {str(part["release"]) for part in carried if part.get("release")}
        releases_of_stack = [
            _mapping(_mapping(_mapping(data["releases"]).get(family)).get(str(releases.get(family))))
            for family in families or releases
        ]
        if (
            carried
            and releases_of_stack
            and of_stack.get("accelerator") in (framework.get("accelerators") or [of_stack.get("accelerator")])
            and (all if families else any)(
                python in (release.get("python") or ())
                and any(_mapping(release.get(key)).get(stack) for key in ("wheels", "elsewhere"))
                for release in releases_of_stack
            )
        ):
            return True
    return False
