"""What components of an SBOM need of each other, by name, and how complete that is.

A part does not have all that its wheels need: they keep the names in a property, which is resolved when parts are joined. After a rebase,
a package needs the release that the new base image has.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

NEEDS = "io.rosml.needs"
"""The property with names that a component needs and no component has, such as `pypi:numpy`. `?` follows a name that it needs only on
some platforms or for some Pythons: it counts until there is an operating system, for which wheels were chosen by these conditions."""

CONDITION = "?"

MOST = 1000
"""The most names in the property."""

_OF_ROS = re.compile(r"ros-[a-z0-9]+-(.+)")
"""A package of ROS's apt repository, with its distribution."""

_OF_ROSDEP = re.compile(r"python3?-(.+?)(?:-pip)?")
"""A key of rosdep for a wheel: https://github.com/ros/rosdistro/blob/master/CONTRIBUTING.md"""


def completed(
    document: Mapping[str, Any],
    components: Mapping[str, Mapping[str, Any]],
    needs: Mapping[str, Iterable[str]],
    environments: Mapping[str, str],
) -> dict[str, Any]:
    """A document with components, by their references, and what these need: references, or names.

    Args:
        environments: the names of the environments of Python packages that components are of, by references. Nothing outside of an environment
            sees its packages.
    """
    image = document["metadata"]["component"]["bom-ref"]
    places = _Places(components, environments)
    has_system = any(component.get("type") == "operating-system" for component in components.values())
    written, entries = [], [{"ref": image, "dependsOn": sorted(components)}]
    complete, incomplete = list[str](), list[str]()
    for ref in sorted(components):
        resolved = {need: places.of(need.removesuffix(CONDITION), ref) for need in needs.get(ref, ())}
        unmet = [need for need, at in resolved.items() if not at and not (has_system and need.endswith(CONDITION))]
        written.append(_with_needs(components[ref], sorted(unmet)[:MOST]))
        entries.append({"ref": ref, "dependsOn": sorted({at for at in resolved.values() if at and at != ref})})
        (incomplete if unmet else complete).append(ref)
    # Files that no package has are in no component, and neither are libraries that wheels have copies of.
    compositions: list[dict[str, Any]] = [{"aggregate": "incomplete", "assemblies": [image]}]
    states = {"complete": complete, "incomplete": incomplete}
    compositions += [{"aggregate": state, "dependencies": refs} for state, refs in states.items() if refs]
    return {**document, "components": written, "dependencies": entries, "compositions": compositions}


def of(component: Mapping[str, Any]) -> list[str]:
    """The names that a component needs and its document does not have."""
    return [name for it in properties(component) if it["name"] == NEEDS for name in it["value"].split()[:MOST]]


def properties(component: Mapping[str, Any]) -> list[dict[str, str]]:
    """The properties of a component that somebody else may have written, as far as they have a name and a text."""
    listed = component.get("properties")
    return [
        it
        for it in (listed if isinstance(listed, list) else ())
        if isinstance(it, dict) and isinstance(it.get("name"), str) and isinstance(it.get("value"), str)
    ]


def _with_needs(component: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    value = " ".join(names)
    kept = [it for it in properties(component) if it["name"] != NEEDS]
    return {**component, "properties": [*kept, *([{"name": NEEDS, "value": value}] if value else ())]}


class _Places:
    """Components by their names, for each environment, and for all others."""

    def __init__(self, components: Iterable[str], environments: Mapping[str, str]) -> None:
        self._environments, self._components = environments, {*components}
        self._refs = defaultdict[str, dict[str, str]](dict)
        for ref in sorted(self._components):
            refs = self._refs[environments.get(ref, "")]
            name = ref.partition("@")[0]  # with the architecture
            refs |= {ref: ref, name: ref}
            kind, _, rest = name.partition(":")
            short = rest.partition(":")[0]
            refs.setdefault(f"{kind}:{short}", ref)
            if kind == "ros":
                refs[f"ros:{short.replace('_', '-')}"] = ref
            elif kind == "apt" and (of_ros := _OF_ROS.fullmatch(short)):
                refs.setdefault(f"ros:{of_ros[1]}", ref)

    def of(self, need: str, user: str) -> str:
        """The component that is meant by a reference or a name, for the component that needs it; empty if there is none."""
        if need in self._components:
            return need
        seen = [self._refs[name] for name in dict.fromkeys((self._environments.get(user, ""), ""))]
        return next((refs[name] for refs in seen for name in _names(need) if name in refs), "")


def _names(need: str) -> Iterator[str]:
    """The names that a need may have. The system's packages may be in the place of wheels, and of ROS's: Debian has some of both."""
    yield need
    without_version = need.partition("@")[0]
    yield without_version
    kind, _, rest = without_version.partition(":")
    short = rest.partition(":")[0].replace("_", "-")
    if kind in ("apt", "ros"):
        yield f"{kind}:{short}"
    if kind == "ros":
        yield from (f"apt:{name}" for name in (short, f"ros-{short}", f"python3-{short}", f"lib{short}-dev"))
        if wheel := _OF_ROSDEP.fullmatch(short):
            yield f"pypi:{wheel[1]}"
    if kind == "pypi":
        yield from (f"apt:python3-{short.removeprefix(prefix)}" for prefix in ("", "python-", "py"))
