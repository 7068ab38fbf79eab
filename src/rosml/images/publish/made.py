"""What is recorded of an image, or part, that was just built or joined: its entry, and a provenance statement."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.images.builds import contents, package_state
from rosml.images.builds.maker import Made
from rosml.images.image_set import apt_repository
from rosml.images.image_set.model import Image, Part
from rosml.images.publish import provenance
from rosml.images.publish.run import Run
from rosml.images.publish.state import Item
from rosml.images.records.store import Entry


def after(run: Run, item: Item, before: Entry, made: Made, started: str) -> Entry:
    """Attaches a provenance statement to an item that was just made, and gives its new entry.

    Args:
        run: the run that made the item.
        item: an image or part.
        before: the item's entry until now.
        made: the result of the build or join.
        started: when the build or join began.

    Raises:
        RosmlError: the item is not in the registry; the registry does not answer or refuses.
    """
    state = run.state
    manifest = state.place.client.manifest(state.place.path(item.repository), made.digest)
    if manifest is None:
        raise RosmlError(f"{item.target} is not in the registry after it was pushed", "run it again")
    statements = _attach(run, item, before, made, started)
    state.forced.add(item.key)
    return before.made(
        made.digest,
        inputs=state.inputs.digest(*item.key),
        repository=item.repository,
        parts=dict(made.parts),
        size=sum(layer.size for layer in manifest.layers),
        date=state.date,
        provenance=statements,
        package_state=made.package_state,
        sbom=made.sbom,
        described=contents.FORMAT if made.sbom else "",
    )


def _attach(run: Run, item: Item, before: Entry, made: Made, started: str) -> dict[str, str]:
    """Attaches a provenance statement to an item; gives the digests of all its statements, by builder. If the records
    name a statement about the same digest, it is kept."""
    state, place = run.state, run.state.place
    known = dict(before.provenance) if before.digest == made.digest else {}
    inputs = state.inputs.digest(*item.key)
    definition = provenance.definition(_asked(run, item), inputs, _dependencies(run, item, made))
    builder = run.machine.builder
    facts = definition, run.machine, started, now(), known.get(builder, "")
    return known | {builder: provenance.attach(place.client, place.path(item.repository), made.digest, *facts)}


def _asked(run: Run, item: Item) -> dict[str, str]:
    """The parameters of the statement: what was to be built."""
    matrix = run.state.image_set.matrix
    asked = {"target": item.target, "platform": matrix.architectures[item.architecture].platform}
    if isinstance(item.thing, Part):
        return asked
    image = item.thing
    found = {"distribution": image.distribution, "component": image.component, "framework": image.framework}
    repository = apt_repository.of(matrix, image.distribution)
    channel = {"channel": repository.channel, "snapshot": repository.day} if repository else {}
    return asked | found | {"stack": image.stack or ""} | channel


def _dependencies(run: Run, item: Item, made: Made) -> Iterator[dict[str, Any]]:
    """Descriptors of what the item was made from: base image or parts, locks, packages, the checkout."""
    state, services = run.state, run.state.request.services
    if made.base:
        yield provenance.base(made.base, state.image_set.matrix.operating_systems[item.thing.os].digest)
    for target, digest in made.parts.items():
        part = state.by_key[target, item.architecture]
        yield provenance.image(target, state.place.reference(part.repository), digest)
    if item.kind != "joined":  # the locks of a joined image belong to its parts
        used = state.inputs.of(*item.key)
        yield from provenance.locks(services.root, [name for name in item.thing.locks if name in used])
    if isinstance(item.thing, Image) and item.kind == "ros":
        matrix, distribution = state.image_set.matrix, item.thing.distribution
        for address, date in package_state.repositories(services, matrix, distribution, made.package_state):
            yield provenance.packages(address, date)
    yield from run.source
