"""The entry and the provenance statement of an image, or part, that was just built or joined."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.images.builds import contents, package_state
from rosml.images.builds.maker import NewImage
from rosml.images.image_set import apt_repository
from rosml.images.image_set.model import Image, Part
from rosml.images.publish import provenance
from rosml.images.publish.items import Item
from rosml.images.publish.provenance import Statement
from rosml.images.publish.run import Run
from rosml.images.records.store import Entry


def new_entry(run: Run, item: Item, before: Entry, output: NewImage, started: str) -> Entry:
    """Attaches a provenance statement to an item that was just made, and returns its new entry."""
    state = run.state
    manifest = state.place.client.manifest(state.place.path(item.repository), output.digest)
    if manifest is None:
        raise RosmlError(f"{item.target} is not in the registry after it was pushed", "run it again")
    statements = _attach(run, item, before, output, started)
    state.forced.add(item.key)
    return before.with_digest(
        output.digest,
        inputs=state.inputs.digest(*item.key),
        repository=item.repository,
        parts=dict(output.parts),
        size=sum(layer.size for layer in manifest.layers),
        date=state.date,
        provenance=statements,
        package_state=output.package_state,
        sbom=output.sbom,
        described=contents.FORMAT if output.sbom else "",
    )


def _attach(run: Run, item: Item, before: Entry, output: NewImage, started: str) -> dict[str, str]:
    """The digests of an item's statements, by builder. A statement about the same digest that the records name is kept."""
    place, builder = run.state.place, run.machine.builder
    earlier = dict(before.provenance) if before.digest == output.digest else {}
    inputs = run.state.inputs.digest(*item.key)
    definition = provenance.definition(_parameters(run, item), inputs, _dependencies(run, item, output))
    statement = Statement(place.path(item.repository), output.digest, definition, run.machine, started, now())
    return earlier | {builder: provenance.attach(place.client, statement, earlier.get(builder, ""))}


def _parameters(run: Run, item: Item) -> dict[str, str]:
    matrix = run.state.image_set.matrix
    parameters = {"target": item.target, "platform": matrix.architectures[item.architecture].platform}
    if isinstance(item.thing, Part):
        return parameters
    image = item.thing
    parameters |= {"distribution": image.distribution, "component": image.component, "framework": image.framework}
    repository = apt_repository.of(matrix, image.distribution)
    channel = {"channel": repository.channel, "snapshot": repository.day} if repository else {}
    return parameters | {"stack": image.stack or ""} | channel


def _dependencies(run: Run, item: Item, output: NewImage) -> Iterator[dict[str, Any]]:
    """Descriptors of what the item was made from: base image or parts, locks, packages, the checkout."""
    state, services = run.state, run.state.request.services
    if output.base:
        yield provenance.base(output.base, state.image_set.matrix.operating_systems[item.thing.os].digest)
    for target, digest in output.parts.items():
        part = state.by_key[target, item.architecture]
        yield provenance.image(target, state.place.reference(part.repository), digest)
    if item.kind != "joined":  # the locks of a joined image belong to its parts
        used = state.inputs.of(*item.key)
        yield from provenance.locks(services.root, [name for name in item.thing.locks if name in used])
    if isinstance(item.thing, Image) and item.kind == "ros":
        matrix, distribution = state.image_set.matrix, item.thing.distribution
        for address, date in package_state.repositories(services, matrix, distribution, output.package_state):
            yield provenance.packages(address, date)
    yield from run.source
