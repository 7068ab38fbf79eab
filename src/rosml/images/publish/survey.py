"""Asks the registry and the package repositories for the state of images."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import base_images, package_state
from rosml.images.image_set.model import Image
from rosml.images.image_set.selection import require_architectures, select
from rosml.images.matrix import support
from rosml.images.publish.items import Key
from rosml.images.publish.state import Request, State
from rosml.images.records.store import INDEX, Entry
from rosml.registry.place import Place

ARCHIVES = 8
"""How many package repositories are asked at a time."""


def survey(request: Request) -> State:
    """The state of the requested images."""
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
    _close_ended(state)
    state.inputs.check([item.thing for item in state.items] if request.only else None)
    state.entries.update(state.records.read_all(_keys(state)))
    state.present |= present(request.place, state.entries.values())
    states = _package_states(state)
    state.package_state |= {name: answer for name, answer in states.items() if isinstance(answer, str)}
    unpublished = _unpublished(state, states.keys() & state.package_state.keys())
    state.unpublished |= {key: answer for key, answer in unpublished.items() if isinstance(answer, frozenset)}
    remark = "{0}: {1.message}; its packages are taken for unchanged; {1.remedy}"
    state.remarks += [remark.format(name, error) for name, error in states.items() if isinstance(error, RosmlError)]
    silent = [(key[0], error) for key, error in unpublished.items() if isinstance(error, RosmlError)]
    state.remarks += [f"{name}: {error.message}; {error.remedy}" for name, error in silent]
    return state


def _close_ended(state: State) -> None:
    """Closes the distributions that are past their end of life on the day of the run."""
    if state.request.even_ended or not state.date:
        return
    matrix, day = state.image_set.matrix, clock.day_of(state.date)
    names = dict.fromkeys(image.distribution for image in state.images)
    closed = [name for name in names if support.is_closed(matrix, name, day)]
    state.closed = frozenset(closed)
    state.remarks += [
        f"{support.end(matrix, name, day)}. Its tags stay where they are; {support.how_to_open(matrix, name)}"
        for name in closed
    ]


def present(place: Place, entries: Iterable[Entry]) -> set[Key]:
    """The entries whose manifest is in the registry, as target and architecture."""

    def key_if_present(entry: Entry) -> Key | None:
        digest = entry.digest and place.client.head(place.path(entry.repository), entry.digest)
        return (entry.target, entry.architecture) if digest else None

    return {key for key in side_by_side(key_if_present, entries) if key}


def _keys(state: State) -> list[Key]:
    """Entries to read: of items and indexes, and of images in which shared tests may have run."""
    keys = [item.key for item in state.items] + [(thing.target, INDEX) for thing in state.things()]
    for item in state.items:
        if isinstance(item.thing, Image):
            keys += [(target, item.architecture) for target in item.thing.proven_by]
    for image in state.images:
        keys += [(prover, name) for prover in state.tests.provers(image) for name in image.architectures]
    return list(dict.fromkeys(keys))


def _package_states(state: State) -> dict[str, str | RosmlError]:
    """The package states of the distributions that can be built here, or why their repositories do not answer.

    If nothing will be made, it asks only for images in the registry: this machine may have to make a base image to read its apt sources.
    """
    distributions = dict.fromkeys(
        item.thing.distribution
        for item in state.items
        if item.kind == "ros"
        and isinstance(item.thing, Image)
        and item.thing.distribution not in state.package_state
        and (not state.request.whole or item.key in state.present)
        and not state.hindrance(item)
    )

    def ask(name: str) -> str | RosmlError:
        try:
            return package_state.state(state.request.services, state.image_set.matrix, name)
        except RosmlError as error:
            if error.exit_code == 2:  # the user's setting is wrong, not the network
                raise
            return error

    return dict(zip(distributions, side_by_side(ask, distributions, ARCHIVES), strict=True))


def _unpublished(state: State, answered: Collection[str]) -> dict[Key, frozenset[str] | RosmlError]:
    """Packages that images to build need and their repository lacks, by distribution and architecture, or why that is not known."""
    packages: dict[Key, list[str]] = {}
    for item in state.items:
        if not isinstance(item.thing, Image) or item.kind != "ros" or item.architecture not in state.architectures:
            continue
        if item.thing.distribution in answered and state.reasons(item):
            packages.setdefault((item.thing.distribution, item.architecture), []).extend(item.thing.packages.split())

    def ask(key: Key) -> frozenset[str] | RosmlError:
        try:
            return frozenset(package_state.lacking(state.request.services, state.image_set.matrix, *key, packages[key]))
        except RosmlError as error:
            return error  # the build will say what is missing

    return dict(zip(packages, side_by_side(ask, packages, ARCHIVES), strict=True))
