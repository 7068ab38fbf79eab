"""The licences of an image's components, and where in the image the texts are that have to go with it. The lists of files that are attached
to images say what is there, so no layer is read."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.images.dossier.bill import Bill, Component, shortened
from rosml.images.join import facts, file_lists
from rosml.images.join.layers import Source
from rosml.registry.client import Registry

SHOWN = 5
"""As many texts of a component are named. Some wheels have one for each library that they bring."""

_OF_WHEEL = re.compile(
    r"(?P<wheel>[^/]+)-(?P<version>[^/-]+)\.dist-info/(?:licenses/.*|[^/]*(?:LICEN[CS]E|COPYING|NOTICE|AUTHORS)[^/]*)",
    re.IGNORECASE,
)

_OF_DEBIAN = re.compile(r"usr/share/doc/(?P<package>[^/]+)(?:/copyright)?")
"""A package's folder may be a link to that of another package from the same sources. Then a list of files names the link."""

COMMON = "usr/share/common-licenses/"
"""The folder with the licences that are not repeated in each package: https://www.debian.org/doc/debian-policy/ch-docs.html#s-copyrightfile"""

_OF_ROS = re.compile(r".*/share/(?P<package>[^/]+)/(?:LICEN[CS]E|COPYING|NOTICE|package\.xml)[^/]*")

NONE = "no licence is named"


@dataclass(frozen=True)
class Texts:
    """The texts of a component's licences. `places` are paths in the image; `more` are further ones."""

    component: str
    licences: str
    places: tuple[str, ...]
    more: int = 0


def paths(registry: Registry, image: Source) -> frozenset[str] | None:
    """The files of an image, by the lists that are attached to it, or to what it was joined from; None if some are missing."""
    lists = file_lists.Lists()
    if files := lists.of(registry, image.repository, image.digest):
        return files.entries
    parts = facts.components(registry, image.repository, image.digest, image.annotations)
    every = [lists.of(registry, repository, digest) for repository, digest in parts]
    present = [files for files in every if files]
    return file_lists.together(present).entries if present and len(present) == len(every) else None


def of(bill: Bill, files: Iterable[str] | None) -> list[Texts]:
    """For each component its licences and their texts. Without a list of files, these are where the SBOM says."""
    places = _by_component(files or ())
    every = (it for it in bill.components if it.type != "operating-system")
    return [_texts(it, places, files is not None) for it in every]


def _texts(component: Component, places: Mapping[tuple[str, str], list[str]], listed: bool) -> Texts:
    licences = " AND ".join(dict.fromkeys(it.text for it in component.licences)) or NONE
    every = sorted({path for key in _keys(component) for path in places.get(key, ())})
    if not listed:
        every = sorted({it.place.removeprefix("file:///") for it in component.licences if it.place})
    shown = tuple(map(shortened, every[:SHOWN]))
    return Texts(component.title, shortened(licences), shown, len(every) - len(shown))


def all_places(bill: Bill, files: Collection[str]) -> set[str]:
    """The paths of the texts of all components, and of those that texts of Debian's packages name: the GPL and others."""
    places = _by_component(files)
    common = (path for path in files if path.startswith(COMMON))
    return {*common, *(path for it in bill.components for key in _keys(it) for path in places.get(key, ()))}


def _keys(component: Component) -> Iterator[tuple[str, str]]:
    purl = component.purl
    if purl is None:
        return
    if purl.type == "pypi":
        yield "pypi", _wheel(component.name, component.version)
    elif purl.type == "deb":
        yield "deb", component.name
    elif purl.namespace == "ros":
        yield "ros", component.name


def _by_component(files: Iterable[str]) -> dict[tuple[str, str], list[str]]:
    """Texts of licences among files, by the kind and the name of the package that they are of."""
    places = dict[tuple[str, str], list[str]]()
    for path in files:
        if match := _OF_DEBIAN.fullmatch(path):
            places.setdefault(("deb", match["package"]), []).append(path)
        elif ".dist-info/" in path:
            folder, _, rest = path.partition(".dist-info/")
            if match := _OF_WHEEL.fullmatch(f"{folder.rpartition('/')[2]}.dist-info/{rest}"):
                places.setdefault(("pypi", _wheel(match["wheel"], match["version"])), []).append(path)
        elif "/share/" in path and (match := _OF_ROS.fullmatch(path)):
            places.setdefault(("ros", match["package"]), []).append(path)
    return places


def _wheel(name: str, version: str) -> str:
    return f"{re.sub('[-_.]+', '-', name).lower()} {version}"


def without_text(texts: Iterable[Texts]) -> list[str]:
    return [it.component for it in texts if not it.places]


def listing(texts: Iterable[Texts], listed: bool) -> str:
    """A file for people: each licence with its components, and the paths of their texts in the image."""
    by_licence = dict[str, list[Texts]]()
    for it in texts:
        by_licence.setdefault(it.licences, []).append(it)
    lines = [
        "The licences of the image's components, and the paths of the texts in the image.",
        "" if listed else "The image has no list of its files: the paths are those that the SBOM names.",
        "Each text goes with the image as long as nobody removes it there.",
    ]
    for licence in sorted(by_licence):
        lines += ["", licence, ""]
        for it in sorted(by_licence[licence], key=lambda it: it.component):
            more = [f"and {it.more} more"] if it.more else []
            lines.append(f"  {it.component}: {', '.join([*it.places, *more]) or 'no text'}")
    return "\n".join(lines) + "\n"


def read(registry: Registry, image: Source) -> tuple[frozenset[str] | None, str]:
    """The files of an image; and why there is no list of them."""
    try:
        files = paths(registry, image)
    except RosmlError as error:
        return None, error.message
    return files, "" if files is not None else "no list of its files is attached"
