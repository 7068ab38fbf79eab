"""Describes what is published, from the matrix, the registry and the records."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from rosml.base import clock
from rosml.images.catalogue.indexes import History, Reader, Thing
from rosml.images.catalogue.layers import LayerTable
from rosml.images.catalogue.model import (
    FORMAT,
    WORDS,
    AddOn,
    Build,
    Distribution,
    Image,
    Layer,
    Part,
    Published,
    Sharing,
    Tag,
    Taken,
    status,
)
from rosml.images.image_set import addons, search
from rosml.images.image_set import model as sets
from rosml.images.image_set.model import tags_of
from rosml.images.image_set.selection import select
from rosml.images.matrix import combinations, names, support
from rosml.images.matrix.names import our_words
from rosml.images.matrix.tags import DATED
from rosml.registry.place import Place

HISTORY = 10
"""The most builds without a tag that are described for an image: the newest. All builds with a tag are described."""

Kind = Literal["main", "versions", "floating", "dated"]
_ORDER: tuple[Kind, ...] = ("main", "versions", "floating", "dated")


@dataclass
class Gatherer:
    """Reads and describes a registry. After `gather`, `remarks` has what was left out, and why."""

    image_set: sets.ImageSet
    place: Place
    history: int = HISTORY
    remarks: list[str] = field(default_factory=list)

    def gather(self, created: str, only: Sequence[str] = ()) -> Published:
        """Everything that is published of the selected images, their ROS images, and parts. `created` is the time for
        the catalogue; `only` has patterns of targets, or groups; all if empty."""
        selected = {image.target for image in select(self.image_set, only)}
        images = self._with_parents(selected)
        names = {name for image in images for name in image.parts}
        parts = tuple(part for part in self.image_set.parts if part.name in names)
        histories = Reader(self.place, self.history, self.remarks).read([*images, *parts])
        table = LayerTable(self.image_set, {target: history.indexes for target, history in histories.items()})
        # All of them, so that the table has the layers of the ROS images below.
        described = [self._image(image, histories[image.target], table) for image in images]
        requested = tuple(image for image in described if image.target in selected)
        matrix = self.image_set.matrix
        return Published(
            format=FORMAT,
            created=created,
            registry=str(self.place),
            source=matrix.source,
            addons={name: self._addon(name) for name in matrix.addons},
            distributions={
                name: self._distribution(name, created) for name in dict.fromkeys(i.distribution for i in images)
            },
            words=WORDS,
            images=requested,
            parts=tuple(_part(part, histories[part.target], table) for part in parts),
            layers=tuple(table.layers),
            sboms=tuple(table.sboms),
            sharing=_sharing(requested, table.layers),
        )

    def _with_parents(self, targets: Iterable[str]) -> tuple[sets.Image, ...]:
        """Images and the ROS images below them, which tell the owners of layers; in the matrix's order."""
        names: set[str] = set()
        for target in targets:
            link = self.image_set.by_target.get(target)
            while link and link.target not in names:
                names.add(link.target)
                link = self.image_set.by_target.get(link.parent)
        return tuple(image for image in self.image_set.images if image.target in names and image.tags)

    def _addon(self, name: str) -> AddOn:
        matrix = self.image_set.matrix
        entries = [matrix.part[part] for part in matrix.addons[name].parts]
        called = [name, *(word for word, ours in our_words(matrix).items() if ours == name)]
        stacks = {part.stack for part in self.image_set.parts if part.kind == entries[-1].name}
        return AddOn(
            title=entries[-1].title or name,
            words=tuple(dict.fromkeys(called)),
            stacks=tuple(stack for stack in matrix.stacks if stack in stacks),
            restricted=any(entry.restricted for entry in entries),
        )

    def _distribution(self, name: str, created: str) -> Distribution:
        matrix, day = self.image_set.matrix, clock.day_of(created)
        facts = matrix.distributions[name]
        return Distribution(
            ros=facts.ros,
            os=facts.os,
            python=matrix.operating_systems[facts.os].python,
            eol=str(facts.eol) if facts.eol else None,
            instead=support.instead(matrix, name, day) if support.has_ended(matrix, name, day) else (),
            lts=facts.lts,
            experimental=facts.experimental,
        )

    def _image(self, image: sets.Image, history: History, table: LayerTable) -> Image:
        main = history.tags.get(tags_of(image)[0], "")
        state, reason = status(image, main in {index.digest for index in history.indexes})
        if main and state != "built":
            reason = f"its tag points at {main}, which cannot be read"
        matrix = self.image_set.matrix
        return Image(
            **_tagged(image, history, table),
            target=image.target,
            distribution=image.distribution,
            component=image.component,
            framework=image.combination,
            stack=image.stack,
            addons=image.addons,
            takes={
                item.called: Taken(addon=item.addon, parts=item.parts, platforms=item.platforms)
                for item in addons.fitting(matrix, image)
            },
            only_runs=combinations.only_runs(matrix, image.component),
            platforms=image.platforms,
            promised=image.versions,
            promised_tags=tuple(tags_of(image)),
            gpu=image.gpu,
            search=search.words(self.image_set, image),
            status=state,
            reason=reason,
        )


def _part(part: sets.Part, history: History, table: LayerTable) -> Part:
    return Part(
        **_tagged(part, history, table),
        name=part.name,
        kind=part.kind,
        stack=part.stack,
        python=part.python,
        platforms=part.platforms,
    )


def _tagged(thing: Thing, history: History, table: LayerTable) -> dict[str, Any]:
    """The common fields of images and parts."""
    tags = [Tag(name=name, kind=_kind(thing, name), digest=digest) for name, digest in history.tags.items()]
    tags.sort(key=lambda tag: (_ORDER.index(tag.kind), tag.name))
    builds = [
        Build(
            digest=index.digest,
            created=index.created,
            tags=tuple(tag.name for tag in tags if tag.digest == index.digest),
            platforms=tuple(table.platform(thing, member) for member in index.members),
            signed=index.signed,
        )
        for index in history.indexes
    ]
    return {
        "repository": thing.repository,
        "tags": tuple(tags),
        "builds": tuple(builds),
        "moves": tuple(history.moves),
    }


def _kind(thing: Thing, tag: str) -> Kind:
    main = tags_of(thing)[0]
    if tag == main:
        return "main"
    if DATED.sub("", tag) == main:
        return "dated"
    end = names.environments_end([thing.environment]) if isinstance(thing, sets.Image) else ""
    return "versions" if tag.startswith(f"{main.removesuffix(end)}-") else "floating"


def _sharing(images: Iterable[Image], layers: Sequence[Layer]) -> Sharing:
    """The bytes that present builds save by sharing layers."""
    platforms = [platform for image in images if image.status == "built" for platform in image.builds[0].platforms]
    used = [position for platform in platforms for position in dict.fromkeys(platform.layers)]
    return Sharing(
        images=len(platforms),
        apart=sum(layers[position].compressed for position in used),
        stored=sum(layers[position].compressed for position in set(used)),
    )
