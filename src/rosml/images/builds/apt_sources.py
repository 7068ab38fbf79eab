"""The apt sources of a base image, which apt asks in a build; read from the image's registry without a builder.

A layer is read while it arrives. If its files are sorted by name, as in Debian's and Ubuntu's images, the reading stops
after /etc/apt: that is some hundred kB of 30 MB. Other layers are read to the end. The result is kept, since the
content of a digest never changes.
"""

from __future__ import annotations

import io
import json
import re
import tarfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from rosml.base import archives, files
from rosml.base.errors import RosmlError
from rosml.base.shapes import adapter
from rosml.images.builds import base_images
from rosml.images.matrix.model import OperatingSystem
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries, Registry
from rosml.registry.credentials import DOCKER_HUB
from rosml.registry.documents import Descriptor
from rosml.registry.oci import Manifest

SOURCE_BYTES = 1 << 20
"""More than all apt sources of an image have."""

LAYER_BYTES = 16 << 30
"""More than any layer of a base image has, unpacked."""

FOLDER = ("etc", "apt")
_FILE = re.compile(r"etc/apt/sources\.list(?:\.d/[A-Za-z0-9_-][A-Za-z0-9_.-]*\.(?:list|sources))?")
_FOLDERS = ("", "etc", "etc/apt", "etc/apt/sources.list.d")
"""Folders that hold sources. If a layer deletes one, it deletes the sources of the layers below."""

_WHITEOUT, _OPAQUE = ".wh.", ".wh..wh..opq"
_NO = ("no", "false", "without", "off", "disable", "0")
"""apt's words for no."""

Texts = dict[str, str]
"""The text of files of apt sources, by path without a slash at the beginning."""


@dataclass(frozen=True)
class Source:
    """A source that apt asks for lists of packages."""

    address: str  # of the archive, without a slash at the end. It may contain a user and a password
    suite: str  # such as bookworm-updates; for a flat repository its path, which ends in a slash
    components: tuple[str, ...]  # such as main; none for a flat repository

    @property
    def flat(self) -> bool:
        """Whether its lists of packages are beside the Release file."""
        return self.suite.endswith("/")

    def release(self, address: str) -> str:
        """The address of the Release file below that of the archive or of its copy on a mirror."""
        return f"{address}/{self.suite.lstrip('/')}Release" if self.flat else f"{address}/dists/{self.suite}/Release"


def sources(services: Services, systems: Mapping[str, OperatingSystem], name: str) -> tuple[Source, ...]:
    """The HTTP apt sources of an operating system's base image, for this machine's architecture."""
    reference = base_images.reference(services, systems, name)
    architecture = base_images.native_architecture()
    digest = reference.rpartition(":")[2]
    file = services.state / "apt-sources" / f"{digest}-{architecture}.json"
    try:
        texts = _TEXTS.validate_json(file.read_bytes())
    except (OSError, ValidationError):
        texts = _read(services, reference, architecture)
        _keep(file, texts)
    return parse(texts, reference)


_TEXTS = adapter(Texts)


def _keep(file: Path, texts: Texts) -> None:
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RosmlError(f"{file.parent}: cannot be made: {error.strerror}", files.WRITABLE) from None
    files.write(file, json.dumps(texts, indent=2) + "\n")


# ---- What the files say ----------------------------------------------------------------------------------------------


def parse(texts: Mapping[str, str], image: str) -> tuple[Source, ...]:
    """The binary sources over HTTP in files by path, in apt's order, with each suite of an archive once."""
    names: dict[tuple[str, str], dict[str, None]] = {}
    for path in sorted(texts):
        entries = _stanzas if path.endswith(".sources") else _lines
        for line, uris, suites, components in entries(texts[path]):
            if not uris or not suites or any(suite.endswith("/") == bool(components) for suite in suites):
                text = f"/{path}:{line} of {image} is no apt source"
                raise RosmlError(text, "correct it in the base image, or name another image")
            for uri in uris:
                for suite in suites if re.match("https?://", uri) else ():
                    names.setdefault((uri.rstrip("/"), suite), {}).update(dict.fromkeys(components))
    return tuple(Source(address, suite, tuple(components)) for (address, suite), components in names.items())


_Entry = tuple[int, list[str], list[str], list[str]]
"""A source: its line, URIs, suites and components."""


def _lines(text: str) -> Iterator[_Entry]:
    """The binary sources of a file in the one-line format: `deb [options] URI suite components…`."""
    for number, line in enumerate(text.split("\n"), 1):
        if source := re.match(r"\s*deb\s+(?:\[[^]]*\]\s*)?([^#]*)", line):
            # The name of a CD is in brackets, and may contain spaces.
            words = re.sub(r"^(\w+:)\[[^]]*\]", r"\1", source[1]).split()
            yield number, words[:1], words[1:2], words[2:]


def _stanzas(text: str) -> Iterator[_Entry]:
    """The binary sources of a file in the deb822 format, with a paragraph of fields for each."""
    fields: dict[str, list[str]] = {}
    start, name = 0, ""
    for number, line in enumerate([*text.split("\n"), ""], 1):
        if line.startswith("#"):
            continue
        if line.strip() and line[0] in " \t":
            fields.setdefault(name, []).append(line)
        elif line.strip():
            start = start or number
            name, _, value = line.partition(":")
            name = name.strip().lower()
            fields[name] = [value]
        else:
            values = {key: " ".join(lines) for key, lines in fields.items()}
            if "deb" in values.get("types", "").split() and values.get("enabled", "yes").strip().lower() not in _NO:
                uris, suites, components = (values.get(key, "").split() for key in ("uris", "suites", "components"))
                yield start, uris, suites, components
            fields, start, name = {}, 0, ""


# ---- From the registry -----------------------------------------------------------------------------------------------


def _read(services: Services, reference: str, architecture: str) -> Texts:
    with Registries(services.ca_bundle) as registries:
        for place in _places(services, reference):
            registry = registries(place.host)
            if manifest := _manifest(registry, place, architecture):
                texts: Texts = {}
                for layer in manifest.layers:
                    added, gone = read_layer(registry, place, layer)
                    kept = {path: text for path, text in texts.items() if not _hidden(path, gone)}
                    texts = kept | added
                return texts
    raise RosmlError(f"{reference} is not there", "check the base image's name and digest")


def _places(services: Services, reference: str) -> list[references.Reference]:
    """The places of a base image. If the local registry is the builder's mirror of Docker Hub, it comes first."""
    place = references.parse(references.complete(reference))
    mirrored = place.host == DOCKER_HUB and services.bases and services.registry
    return [place._replace(host=services.registry), place] if mirrored else [place]


def _manifest(registry: Registry, place: references.Reference, architecture: str) -> Manifest | None:
    manifest = registry.manifest(place.repository, place.reference)
    if manifest is None or not manifest.is_index:
        return manifest
    for entry in manifest.members:
        if entry.platform and (entry.platform.os, entry.platform.architecture) == ("linux", architecture):
            return registry.manifest(place.repository, entry.digest)
    raise RosmlError(f"{place} is not there for linux/{architecture}", "name a base image that has this architecture")


def read_layer(registry: Registry, place: references.Reference, layer: Descriptor) -> tuple[Texts, set[str]]:
    """The files of apt sources in a layer, and the paths that it deletes below. A layer that is left early is not verified."""

    def read(blocks: Iterator[bytes]) -> tuple[Texts, set[str]]:
        try:
            with (
                _unpacked(blocks, layer.mediaType) as stream,
                tarfile.open(fileobj=stream, mode="r|", tarinfo=archives.Entry) as archive,
            ):
                files, whole = _files_in(archive)
            for _ in blocks if whole else ():  # at the end, the digest is checked
                pass
            return files
        except (tarfile.TarError, EOFError, OSError, OverflowError, ValueError) as error:
            text = f"{place}: the layer {layer.digest} cannot be read: {error}"
            raise RosmlError(text, "push the base image again, or name another") from None

    return registry.read_blob(place.repository, layer.digest, read, layer.size)


def _files_in(archive: tarfile.TarFile) -> tuple[tuple[Texts, set[str]], bool]:
    """The result of `read_layer`, and whether the whole layer was read: it ends after /etc/apt, if names so far were sorted."""
    texts: Texts = {}
    gone: set[str] = set()
    last: tuple[str, ...] = ()
    in_order = True
    while entry := archive.next():
        archive.members.clear()  # type: ignore[attr-defined] # tarfile keeps all members, a hundred thousand in some layers
        *folders, name = [part for part in entry.name.split("/") if part not in ("", ".")] or [""]
        place = (*folders, name.removeprefix(_WHITEOUT))
        in_order, last = in_order and last <= place, place
        if in_order and place[:2] > FOLDER and (texts or gone):
            return (texts, gone), False
        if archive.offset > LAYER_BYTES:
            raise ValueError(f"it has more than {LAYER_BYTES >> 30} GiB")
        if name.startswith(_WHITEOUT):
            path = "/".join(folders if name == _OPAQUE else place)
            if path in _FOLDERS or _FILE.fullmatch(path):
                gone.add(path)
        elif _FILE.fullmatch(path := "/".join(place)):
            texts[path] = _text(archive, entry, SOURCE_BYTES - sum(map(len, texts.values())))
    return (texts, gone), True


def _text(archive: tarfile.TarFile, entry: tarfile.TarInfo, room: int) -> str:
    content = archive.extractfile(entry) if entry.isreg() else None
    if content is None:
        raise ValueError(f"{entry.name} is no file")
    if entry.size > room:
        raise ValueError(f"its apt sources have more than {SOURCE_BYTES >> 20} MiB")
    return content.read().decode(errors="replace")


def _hidden(path: str, gone: set[str]) -> bool:
    return any(folder in ("", path) or path.startswith(f"{folder}/") for folder in gone)


def _unpacked(blocks: Iterator[bytes], media_type: str) -> io.BufferedReader:
    """The unpacked tar of a layer, as a file-like object."""
    if not media_type.endswith(("gzip", "zstd", "tar")):
        raise ValueError(f"{media_type} is no known type of layer")
    return archives.stream(blocks)
