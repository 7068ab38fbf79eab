"""Asks the registry and the package repositories for the state of images."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import base_images, package_state
from rosml.images.image_set.model import Image
from rosml.images.image_set.selection import require_architectures, select
from rosml.images.publish.state import Request, State
from rosml.images.records.store import INDEX, Entry
from rosml.registry.place import Place

ARCHIVES = 8
"""How many package repositories are asked at a time."""


def survey(request: Request) -> State:
    """Finds the state of the requested images.

    Raises:
        RosmlError: the registry does not answer, or there is no such image or architecture.
    """
    image_set = request.image_set
    require_architectures(image_set, request.architectures)
    require_architectures(image_set, request.serve)  # with a typo, no image would ever get a tag
    state = State(
        request,
        request.inputs or Inputs(request.services.root, image_set),
        select(image_set, request.only),
        request.architectures or (base_images.native_architecture(),),
        package_state=dict(request.package_state),
    )
    state.inputs.check([item.thing for item in state.items] if request.only else None)
    keys = [item.key for item in state.items] + [(thing.target, INDEX) for thing in state.things()]
    keys += [
        (target, item.architecture)
        for item in state.items
        if isinstance(item.thing, Image)
        for target in item.thing.proven_by
    ]
    keys += [(other, name) for image in state.images for other in state.provers(image) for name in image.architectures]
    state.known = state.records.read_all(list(dict.fromkeys(keys)))
    state.present = present(request.place, state.known.values())
    rows = _ask(state)
    state.lacking = _lacking(state, rows)
    return state


def present(place: Place, entries: Iterable[Entry]) -> set[tuple[str, str]]:
    """The entries whose manifest is in the registry, as target and architecture."""

    def there(entry: Entry) -> tuple[str, str] | None:
        found = entry.digest and place.client.head(place.path(entry.repository), entry.digest)
        return (entry.target, entry.architecture) if found else None

    return {key for key in side_by_side(there, entries) if key}


def _ask(state: State) -> Mapping[str, Image]:
    """Asks the package repositories of the distributions that can be built here. If one does not answer, a remark says
    so.

    If nothing will be made, it asks only those of images that are there: to read the apt sources of a base image, this machine
    may have to make it.

    Returns:
        An image of each distribution that was asked.

    Raises:
        RosmlError: an address or channel that the user set is wrong (exit code 2).
    """
    rows: Mapping[str, Image] = {
        item.thing.distribution: item.thing
        for item in state.items
        if item.kind == "ros"
        and isinstance(item.thing, Image)
        and not state.hindrance(item)
        and item.thing.distribution not in state.package_state
        and (not state.request.whole or item.key in state.present)
    }

    def asked(name: str) -> str | RosmlError:
        try:
            return package_state.state(state.request.services, state.image_set.matrix, name)
        except RosmlError as error:
            return error

    for name, answer in zip(rows, side_by_side(asked, rows, ARCHIVES), strict=True):
        if isinstance(answer, str):
            state.package_state[name] = answer
        elif answer.exit_code == 2:  # the user's setting is wrong, not the network
            raise answer
        else:
            remark = f"{name}: {answer.message}; its packages are taken for unchanged; {answer.remedy}"
            state.remarks.append(remark)
    return rows


def _lacking(state: State, rows: Mapping[str, Image]) -> dict[tuple[str, str], frozenset[str]]:
    """Packages that images to build need and their repository lacks, by distribution and architecture."""
    wanted: dict[tuple[str, str], list[str]] = {}
    for item in state.items:
        if not isinstance(item.thing, Image) or item.kind != "ros" or item.architecture not in state.architectures:
            continue
        row = item.thing.distribution
        if row in rows and row in state.package_state and state.reasons(item):
            wanted.setdefault((row, item.architecture), []).extend(item.thing.packages.split())

    def absent(key: tuple[str, str]) -> frozenset[str]:
        try:
            return frozenset(package_state.lacking(state.request.services, state.image_set.matrix, *key, wanted[key]))
        except RosmlError as error:
            state.remarks.append(f"{key[0]}: {error.message}; {error.remedy}")
            return frozenset()  # the build will say what is missing

    found = zip(wanted, side_by_side(absent, wanted, ARCHIVES), strict=True)
    return {key: names for key, names in found if names}
