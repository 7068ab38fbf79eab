"""Reads what is published, from the matrix, the registry and the records.

It pulls only manifests and configs, each once. If an image cannot be read, it is left out with a remark, and people still find the
others.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

from pydantic import ConfigDict, ValidationError

from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.base.side_by_side import side_by_side
from rosml.images.catalogue.model import (
    FORMAT,
    SIGNER,
    WORDS,
    AddOn,
    Build,
    Distribution,
    Image,
    Layer,
    Move,
    Part,
    Platform,
    Published,
    Sbom,
    Scan,
    Sharing,
    Size,
    Tag,
    Taken,
    Tests,
    Vulnerability,
    status,
)
from rosml.images.catalogue.words import words
from rosml.images.image_set import addons
from rosml.images.image_set import model as sets
from rosml.images.image_set.labels import COVERED, PREFIX
from rosml.images.image_set.model import repository_of, tags_of
from rosml.images.image_set.selection import select
from rosml.images.matrix import rules
from rosml.images.matrix.names import DATED, our_words
from rosml.images.records import tag_moves
from rosml.images.records.store import INDEX, Entry, Records, date_of
from rosml.images.scan.judge import NAMED
from rosml.registry import documents
from rosml.registry.place import Place

HISTORY = 10
"""The most builds without a tag that are described for an image: the newest. All builds with a tag are described."""

_SYNC = f"{PREFIX}ros.sync"

Thing = sets.Image | sets.Part
Key = TypeVar("Key")
Value = TypeVar("Value")


@dataclass(frozen=True)
class _Member:
    """An image manifest, its platform and labels, and its entry in the records: the present one, or that of its index."""

    digest: str
    platform: str
    layers: tuple[tuple[str, int], ...]
    labels: Mapping[str, str]
    entry: Entry | None = None
    sboms: tuple[Sbom, ...] = ()

    @property
    def architecture(self) -> str:
        return self.platform.partition("/")[2].partition("/")[0]


@dataclass(frozen=True)
class _Index:
    """An index and its images."""

    digest: str
    created: str
    members: tuple[_Member, ...]
    signed: tuple[str, ...] = ()


@dataclass
class _Found:
    """An image or part in the registry: its tags, and all their present and former indexes."""

    tags: dict[str, str] = field(default_factory=dict)
    moves: list[Move] = field(default_factory=list)
    indexes: list[_Index] = field(default_factory=list)


@dataclass
class Gatherer:
    """Reads a registry.

    Attributes:
        image_set: the image set of the matrix.
        place: the registry and the path of its repositories.
        history: the number of builds without a tag to describe for each image.
        remarks: what was left out, and why.
    """

    image_set: sets.ImageSet
    place: Place
    history: int = HISTORY
    remarks: list[str] = field(default_factory=list)
    _current: dict[str, Entry] = field(default_factory=dict)

    def gather(self, created: str, only: Sequence[str] = ()) -> Published:
        """Everything that is published of the wanted images, their ROS images, and parts.

        Args:
            created: the time for the catalogue.
            only: patterns of targets, or groups; all if empty.

        Raises:
            RosmlError: the registry does not answer, or there is no such image.
        """
        images = self._with_parents(select(self.image_set, only))
        wanted = {name for image in images for name in image.parts}
        parts = tuple(part for part in self.image_set.parts if part.name in wanted)
        things: list[Thing] = [*images, *parts]
        keys = [(thing.target, name) for thing in things for name in (*thing.architectures, INDEX)]
        known = Records(self.place).read_all(keys)
        self._current = {entry.digest: entry for entry in known.values() if entry.digest}
        found = self._find(things, known)
        table = _Table(self.image_set, {thing.target: found[thing.target].indexes for thing in things})
        described = tuple(self._image(image, found[image.target], table) for image in images)
        asked = {image.target for image in select(self.image_set, only)}
        return Published(
            format=FORMAT,
            created=created,
            registry=str(self.place),
            source=self.image_set.matrix.source,
            addons={name: self._addon(name) for name in self.image_set.matrix.addons},
            distributions={name: self._distribution(name) for name in dict.fromkeys(i.distribution for i in images)},
            words=WORDS,
            images=tuple(image for image in described if image.target in asked),
            parts=tuple(self._part(part, found[part.target], table) for part in parts),
            layers=tuple(table.layers),
            sboms=tuple(table.sboms),
            sharing=_sharing([image for image in described if image.target in asked], table.layers),
        )

    def _with_parents(self, images: Iterable[sets.Image]) -> tuple[sets.Image, ...]:
        """Images and the ROS images below them, which tell the owners of layers; in the matrix's order."""
        names: set[str] = set()
        for image in images:
            link: sets.Image | None = image
            while link and link.target not in names:
                names.add(link.target)
                link = self.image_set.by_target.get(link.parent)
        return tuple(image for image in self.image_set.images if image.target in names and image.tags)

    def _addon(self, name: str) -> AddOn:
        matrix = self.image_set.matrix
        entries = [matrix.part[part] for part in matrix.addons[name].parts]
        called = [name, *(word for word, ours in our_words(matrix).items() if ours == name)]
        there = {part.stack for part in self.image_set.parts if part.kind == entries[-1].name}
        return AddOn(
            title=entries[-1].title or name,
            words=tuple(dict.fromkeys(called)),
            stacks=tuple(stack for stack in matrix.stacks if stack in there),
            restricted=any(entry.restricted for entry in entries),
        )

    def _distribution(self, name: str) -> Distribution:
        facts = self.image_set.matrix.distributions[name]
        return Distribution(
            ros=facts.ros,
            os=facts.os,
            python=self.image_set.matrix.operating_systems[facts.os].python,
            eol=str(facts.eol) if facts.eol else None,
            lts=facts.lts,
            experimental=facts.experimental,
        )

    # ---- The registry ------------------------------------------------------------------------------------------------

    def _find(self, things: Sequence[Thing], known: Mapping[tuple[str, str], Entry]) -> dict[str, _Found]:
        """The images and parts in the registry, by target."""
        repositories = dict.fromkeys(repository_of(thing) for thing in things)
        names = _each(repositories, lambda name: _by_base(self.place.client.tags(self.place.path(name))), "tags")
        found = {thing.target: _Found() for thing in things}
        wanted = [(repository_of(t), tag) for t in things for tag in _tags_there(t, names[repository_of(t)])]
        heads = _each(wanted, lambda key: self.place.client.head(self.place.path(key[0]), key[1]), "digests")
        moves = self._moves()
        asked: dict[str, list[str]] = {}
        for thing in things:
            here, repository = found[thing.target], repository_of(thing)
            tags = _tags_there(thing, names[repository])
            here.tags = {tag: heads[repository, tag] for tag in tags if heads[repository, tag]}
            here.moves = moves.get((repository, tags_of(thing)[0]), [])
            entry = known.get((thing.target, INDEX))
            before = [*here.tags.values(), *(digest for move in here.moves for digest in (move.new, move.old))]
            asked[thing.target] = list(dict.fromkeys(filter(None, [*before, *(entry.superseded if entry else ())])))
        digests = {(repository_of(t), digest): None for t in things for digest in asked[t.target]}
        indexes = _each(digests, lambda key: self._index(*key), "images")
        for thing in things:
            read = [indexes[repository_of(thing), digest] for digest in asked[thing.target]]
            found[thing.target].indexes = self._described(tags_of(thing)[0], found[thing.target].tags, read)
        return found

    def _described(self, main: str, tags: Mapping[str, str], indexes: Iterable[_Index | None]) -> list[_Index]:
        """The present index, then others, newest first: all with a tag, and some without one."""
        there = [index for index in indexes if index]
        there.sort(key=lambda index: (index.digest == tags.get(main), index.created), reverse=True)
        tagged = set(tags.values())
        others = [index.digest for index in there if index.digest not in tagged]
        kept = tagged.union(others[: self.history])
        return [index for index in there if index.digest in kept]

    def _moves(self) -> dict[tuple[str, str], list[Move]]:
        """The moves of tags in the records of runs, by repository and tag, newest first."""
        book = Records(self.place)
        found: dict[tuple[str, str], list[Move]] = {}
        names = sorted(
            (n for n in self.place.client.tags(book.repository) if n.startswith(tag_moves.UNDO)), reverse=True
        )
        for name, moves in _each(names, lambda name: self._record(book, name), "records").items():
            for move in moves:
                if move.old != move.new:
                    run = _spelled(name.removeprefix(tag_moves.UNDO))
                    found.setdefault((move.repository, move.tag), []).append(Move(run=run, old=move.old, new=move.new))
        return found

    def _record(self, book: Records, name: str) -> list[tag_moves.Move]:
        try:
            return tag_moves.read_moves(book, name)
        except RosmlError as error:
            self.remarks.append(error.message)
            return []

    def _index(self, repository: str, digest: str) -> _Index | None:
        """An index and its images; None if it is gone or damaged.

        Raises:
            RosmlError: the registry does not answer.
        """
        path = self.place.path(repository)
        try:
            found = self.place.client.manifest(path, digest)
            if found is None:  # the build was removed
                return None
            if not found.is_index:
                raise ValueError("it is no index")
            listed = [(item.digest, _platform(item.platform), _sboms(item.annotations)) for item in found.members]
            members = [self._member(path, *item) for item in listed if not item[1].startswith("unknown")]
            entry = self._current.get(digest)
            signed = sorted(name for name in (entry.signed if entry else ()) if re.fullmatch(SIGNER, name))
            return _Index(digest, date_of(found), tuple(members), tuple(signed))
        except (ArithmeticError, LookupError, TypeError, ValueError, RosmlError) as error:
            self.place.client.head(path, digest)  # raises if the registry does not answer any more
            self.remarks.append(f"{repository}@{digest} is left out: it cannot be read ({error})")
            return None

    def _member(self, path: str, digest: str, platform: str, sboms: tuple[Sbom, ...]) -> _Member:
        found = self.place.client.manifest(path, digest)
        if found is None:
            raise ValueError(f"{digest} is not there")
        config = self.place.client.config(path, found)
        layers = tuple((layer.digest, layer.size) for layer in found.layers)
        entry = self._current.get(digest)
        if entry is None:  # another image has replaced it in the records
            entry = Records(self.place).attached(path.removeprefix(self.place.path("")), digest)
        return _Member(digest, platform, layers, config.labels, entry, sboms)

    # ---- Facts -------------------------------------------------------------------------------------------------------

    def _image(self, image: sets.Image, found: _Found, table: _Table) -> Image:
        main = found.tags.get(tags_of(image)[0], "")
        state, reason = status(image, main in {index.digest for index in found.indexes})
        if main and state != "built":
            reason = f"its tag points at {main}, which cannot be read"
        return Image(
            **self._tagged(image, found, table),
            target=image.target,
            distribution=image.distribution,
            component=image.component,
            framework=image.combination,
            stack=image.stack,
            addons=image.addons,
            takes={
                item.called: Taken(addon=item.addon, parts=item.parts, platforms=item.platforms)
                for item in addons.fitting(self.image_set.matrix, image)
            },
            only_runs=rules.only_runs(self.image_set.matrix, image.component),
            platforms=image.platforms,
            promised=image.versions,
            promised_tags=tuple(tags_of(image)),
            gpu=image.gpu,
            search=words(self.image_set, image),
            status=state,
            reason=reason,
        )

    def _part(self, part: sets.Part, found: _Found, table: _Table) -> Part:
        return Part(
            **self._tagged(part, found, table),
            name=part.name,
            kind=part.kind,
            stack=part.stack,
            python=part.python,
            platforms=part.platforms,
        )

    def _tagged(self, thing: Thing, found: _Found, table: _Table) -> dict[str, Any]:
        tags = tuple(
            Tag(name=name, kind=_kind(thing, name), digest=digest)
            for name, digest in sorted(found.tags.items(), key=lambda item: (_ORDER[_kind(thing, item[0])], item[0]))
        )
        by_digest: dict[str, list[str]] = {}
        for tag in tags:
            by_digest.setdefault(tag.digest, []).append(tag.name)
        builds = (
            Build(
                digest=index.digest,
                created=index.created,
                tags=tuple(by_digest.get(index.digest, ())),
                platforms=tuple(table.platform(thing, member) for member in index.members),
                signed=index.signed,
            )
            for index in found.indexes
        )
        return {
            "repository": repository_of(thing),
            "tags": tags,
            "builds": tuple(builds),
            "moves": tuple(found.moves),
        }


class _Table:
    """Layers, their owners, and the unpacked sizes of parts: facts about one image from others."""

    def __init__(
        self,
        image_set: sets.ImageSet,
        indexes: Mapping[str, Sequence[_Index]],
    ) -> None:
        self.layers: list[Layer] = []
        self.sboms: dict[Sbom, int] = {}
        self._position: dict[str, int] = {}
        self._counted = ["python", *dict.fromkeys(name for part in image_set.matrix.parts for name in part.brings)]
        # Parts first, then ROS images from the lowest up: a layer belongs to the lowest image that has it.
        whole: list[Thing] = [
            *image_set.parts,
            *sorted((i for i in image_set.images if not i.stack), key=_height(image_set)),
        ]
        for thing in whole:
            name = thing.name if isinstance(thing, sets.Part) else thing.target
            for index in indexes.get(thing.target, ()):
                for member in index.members:
                    self._add(member.layers, name)
        self._unpacked = dict(self._measure(image_set, indexes))

    def _add(self, layers: Iterable[tuple[str, int]], part: str) -> None:
        for digest, size in layers:
            if digest not in self._position:
                self._position[digest] = len(self.layers)
                self.layers.append(Layer(digest=digest, compressed=size, part=part))

    def _measure(
        self, image_set: sets.ImageSet, indexes: Mapping[str, Sequence[_Index]]
    ) -> Iterator[tuple[tuple[int, ...], int]]:
        """The unpacked sizes of parts, by their layers: the size of an image without all its other parts.

        It gives only measured sizes: a ROS image without the one below it, and a part if all others in the image are known.
        """
        sizes: dict[tuple[int, ...], int] = {}
        totals = []
        for image in image_set.images:
            for member in indexes[image.target][0].members if indexes.get(image.target) else ():
                self._add(member.layers, "")
                if member.entry and member.entry.unpacked:
                    totals.append((list(self._grouped(member).values()), member.entry.unpacked))
        more = True
        while more:
            more = False
            for parts, unpacked in totals:
                unknown = [part for part in parts if part not in sizes]
                if len(unknown) == 1:
                    sizes[unknown[0]] = max(0, unpacked - sum(sizes[part] for part in parts if part in sizes))
                    more = True
        yield from sizes.items()

    def _grouped(self, member: _Member) -> dict[str, tuple[int, ...]]:
        """The layers of an image by their part, in their order."""
        parts: dict[str, tuple[int, ...]] = {}
        for digest, _ in member.layers:
            position = self._position[digest]
            part = self.layers[position].part
            parts[part] = (*parts.get(part, ()), position)
        return parts

    def platform(self, thing: Thing, member: _Member) -> Platform:
        """The facts of an image for one platform."""
        self._add(member.layers, thing.name if isinstance(thing, sets.Part) else "")
        entry = member.entry
        versions = dict(entry.versions) if entry else {}
        promised = {name: member.labels[PREFIX + name] for name in self._counted if PREFIX + name in member.labels}
        positions = tuple(self._position[digest] for digest, _ in member.layers)
        total = sum(size for _, size in member.layers)
        tested = isinstance(thing, sets.Image) and entry and (entry.passed or entry.failures)
        return Platform(
            platform=member.platform,
            digest=member.digest,
            inputs=entry.inputs if entry else "",
            ros_sync=member.labels.get(_SYNC, "") or (entry.package_state if entry else ""),
            size=Size(compressed=total, unpacked=(entry.unpacked if entry else 0) or None),
            parts=self._sizes(member),
            layers=positions,
            sboms=tuple(self.sboms.setdefault(item, len(self.sboms)) for item in member.sboms),
            versions=versions or promised,
            found_inside=bool(versions),
            tests=Tests(passed=entry.passed, failures=entry.failures) if entry and tested else None,
            scan=scan_of(entry) if entry and entry.scanned else None,
        )

    def _sizes(self, member: _Member) -> dict[str, Size]:
        """The sizes of its parts."""
        return {
            part: Size(
                compressed=sum(self.layers[position].compressed for position in positions),
                unpacked=self._unpacked.get(positions),
            )
            for part, positions in self._grouped(member).items()
        }


class _Scanned(Shape):
    """The scan in an entry of the records."""

    model_config = ConfigDict(strict=True)

    updated: str = ""
    packages: int = 0
    findings: dict[str, int] = {}
    failing: list[str] = []
    named: list[Any] = []


def scan_of(entry: Entry) -> Scan | None:
    """The result of an image's scan; None if it was not scanned, or if the entry is damaged."""
    try:
        found = _Scanned.model_validate(dict(entry.scan))
        return Scan(
            outcome=entry.scanned,
            database=found.updated,
            packages=found.packages,
            findings=found.findings,
            failing=tuple(found.failing),
            named=tuple(filter(None, map(_vulnerability, found.named[:NAMED]))),
        )
    except ValidationError:
        return None


def _vulnerability(content: Any) -> Vulnerability | None:
    """A vulnerability of the records; None if it is damaged: then it counts, and has no name."""
    try:
        return Vulnerability.model_validate(content)
    except ValidationError:
        return None


def _sharing(images: Iterable[Image], layers: Sequence[Layer]) -> Sharing:
    """The bytes that present builds save by sharing layers."""
    platforms = [platform for image in images if image.status == "built" for platform in image.builds[0].platforms]
    used = [position for platform in platforms for position in dict.fromkeys(platform.layers)]
    return Sharing(
        images=len(platforms),
        apart=sum(layers[position].compressed for position in used),
        stored=sum(layers[position].compressed for position in set(used)),
    )


def _sboms(annotations: Mapping[str, str]) -> tuple[Sbom, ...]:
    """The SBOMs that an index names for an image; those that are none are left out."""
    named = {name.removeprefix(COVERED): text for name, text in annotations.items() if name.startswith(COVERED)}
    found = ((name, text.partition("@")) for name, text in sorted(named.items())[:_MOST_SBOMS] if _SBOM.fullmatch(text))
    return tuple(Sbom(part=name, repository=where, digest=digest) for name, (where, _, digest) in found)


_SBOM = re.compile(r"[a-z0-9]+(?:[._/-]+[a-z0-9]+)*@sha256:[0-9a-f]{64}")
_MOST_SBOMS = 32


def _parts(image_set: sets.ImageSet, image: sets.Image) -> list[str]:
    """The owners of an image's layers: ROS images from the lowest up, then parts."""
    chain: list[str] = []
    link = image_set.by_target.get(image.parent) if image.stack else image
    while link:
        chain.append(link.target)
        link = image_set.by_target.get(link.parent)
    return [*reversed(chain), *image.parts]


def _height(image_set: sets.ImageSet) -> Callable[[sets.Image], int]:
    return lambda image: len(_parts(image_set, image))


def _by_base(tags: Iterable[str]) -> dict[str, list[str]]:
    """The tags of a repository, by their names without a day."""
    found: dict[str, list[str]] = {}
    for tag in tags:
        found.setdefault(DATED.sub("", tag), []).append(tag)
    return found


def _tags_there(thing: Thing, there: Mapping[str, list[str]]) -> list[str]:
    """The tags of an image in its repository: those of the matrix, and dated ones of the main tag."""
    main, *others = tags_of(thing)
    return [*there.get(main, ()), *(tag for tag in others if tag in there.get(tag, ()))]


_ORDER = {"main": 0, "versions": 1, "floating": 2, "dated": 3}


def _kind(thing: Thing, tag: str) -> Any:
    """The kind of a tag."""
    main = tags_of(thing)[0]
    if tag == main:
        return "main"
    if DATED.sub("", tag) == main:
        return "dated"
    return "versions" if tag.startswith(f"{main}-") else "floating"


def _spelled(run: str) -> str:
    """A run's date from the name of its record: `20261122T030000Z` is 2026-11-22T03:00:00Z."""
    found = re.fullmatch(r"(\d{4})(\d\d)(\d\d)T(\d\d)(\d\d)(\d\d)Z", run)
    return f"{found[1]}-{found[2]}-{found[3]}T{found[4]}:{found[5]}:{found[6]}Z" if found else run


def _platform(place: documents.Platform | None) -> str:
    """BuildKit's name of a platform: `linux/arm64`."""
    platform = "/".join(filter(None, (place.os, place.architecture, place.variant))) if place else ""
    return platform.removesuffix("/v8") if platform.startswith("linux/arm64") else platform


def _each(keys: Iterable[Key], work: Callable[[Key], Value], title: str) -> dict[Key, Value]:
    """Asks for several things at a time, with a progress bar on a terminal."""
    wanted = list(keys)
    return dict(zip(wanted, side_by_side(work, wanted, title=title), strict=True))
