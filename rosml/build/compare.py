"""Whether two images are the same, layer by layer, and where they differ first: is a build reproducible?"""

from __future__ import annotations

import hashlib
import itertools
import subprocess
import tarfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from io import BufferedReader
from typing import IO, Any, cast

import zstandard

from rosml.base.errors import RosmlError
from rosml.machine import regctl
from rosml.machine.services import REMEDY, Services
from rosml.registry import oci

_GZIP, _ZSTD = b"\x1f\x8b", b"\x28\xb5\x2f\xfd"


@dataclass(frozen=True)
class Entry:
    """A file of a layer with all that a layer's digest depends on. `content` is a sha256; empty for what has none."""

    path: str
    kind: str
    mode: int
    owner: int
    group: int
    mtime: float
    size: int
    link: str
    content: str


@dataclass(frozen=True)
class Comparison:
    """What comparing two images came to.

    Attributes:
        layers: digests of the layers, lowest first; None where one image has fewer.
        difference: the first difference in words; empty if all layers are the same.
    """

    layers: tuple[tuple[str | None, str | None], ...]
    difference: str

    @property
    def same(self) -> bool:
        """Whether all layers are the same."""
        return all(one == other for one, other in self.layers)

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {"same": self.same, **asdict(self)}


def compare(services: Services, one: str, other: str) -> Comparison:
    """Compares two image manifests; of the first layer that differs, reads both and says how.

    Args:
        services: where regctl is.
        one, other: references of image manifests, or of indexes with one platform.

    Raises:
        RosmlError: there is no such image (exit code 2), a registry does not answer, or a layer cannot be read.
    """
    for reference in (one, other):
        oci.parse(reference)
        if not regctl.digest(services, reference):
            remedy = "name a tag or digest that is there; tags are listed by: make catalogue"
            raise RosmlError(f"there is no {reference}", remedy, exit_code=2)
    pairs = tuple(itertools.zip_longest(_layers(services, one), _layers(services, other)))
    different = next(((number, pair) for number, pair in enumerate(pairs, 1) if pair[0] != pair[1]), None)
    if different is None:
        return Comparison(pairs, "")
    number, (first, second) = different
    if first is None or second is None:
        return Comparison(pairs, f"layer {number} is only in the {'second' if first is None else 'first'} image")
    with _blob(services, one, first) as left, _blob(services, other, second) as right:
        found = first_difference(_entries(left), _entries(right))
    same = "the files are the same, compressed another way"
    return Comparison(pairs, f"layer {number}: {found or same}")


def first_difference(left: Iterator[Entry], right: Iterator[Entry]) -> str:
    """The first entry in which two layers differ, in words; empty if there is none. The order counts."""
    for one, other in itertools.zip_longest(left, right):
        if one is None or other is None:
            here, there = ("second", other) if one is None else ("first", one)
            return f"{there.path} and what follows is only in the {here}"
        if one.path != other.path:
            return f"{one.path} in the first, {other.path} in the second"
        if one != other:
            facts = (f"{name} {value}, and {getattr(other, name)}" for name, value in asdict(one).items()
                     if value != getattr(other, name))  # fmt: skip
            return f"{one.path}: {'; '.join(facts)}"
    return ""


def _layers(services: Services, reference: str) -> tuple[str, ...]:
    content = regctl.manifest(services, reference)
    if "manifests" in content:
        if len(content["manifests"]) != 1:
            raise RosmlError(
                f"{reference} has several platforms", "name the digest of one of its manifests", exit_code=2
            )
        content = regctl.manifest(services, f"{_repository(reference)}@{content['manifests'][0]['digest']}")
    return tuple(layer["digest"] for layer in content["layers"])


def _repository(reference: str) -> str:
    """A reference without its digest or tag; a port is none."""
    name = reference.partition("@")[0]
    head, slash, tail = name.rpartition("/")
    return f"{head}{slash}{tail.partition(':')[0]}"


@contextmanager
def _blob(services: Services, reference: str, digest: str) -> Iterator[IO[bytes]]:
    """A layer's tar file as a stream, unpacked on the way."""
    command = [services.regctl, "blob", "get", _repository(reference), digest]
    try:
        process = subprocess.Popen(command, env=services.environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    except OSError as error:
        raise RosmlError(f"cannot run {services.regctl}: {error.strerror}", REMEDY) from None
    with process:
        assert process.stdout
        assert process.stderr
        try:
            yield _unpacked(process.stdout)
        except (tarfile.TarError, EOFError, OSError, zstandard.ZstdError) as error:
            process.kill()
            said = process.stderr.read().decode(errors="replace").strip().splitlines()
            raise RosmlError(f"layer {digest} cannot be read: {said[-1] if said else error}", REMEDY) from None
        finally:
            process.kill()


def _unpacked(stream: IO[bytes]) -> IO[bytes]:
    """A stream as it was before it was compressed, if it was."""
    head = stream.peek(4)[:4]  # type: ignore[attr-defined]
    if head.startswith(_ZSTD):
        return zstandard.ZstdDecompressor().stream_reader(stream, read_across_frames=True)
    if head.startswith(_GZIP):
        import gzip

        return cast(IO[bytes], gzip.open(stream))
    return stream


def _entries(stream: IO[bytes]) -> Iterator[Entry]:
    with tarfile.open(fileobj=stream, mode="r|") as archive:
        for member in archive:
            file = archive.extractfile(member) if member.isreg() else None
            content = hashlib.file_digest(cast(BufferedReader, file), "sha256").hexdigest() if file else ""
            yield Entry(
                member.name,
                member.type.decode(),
                member.mode,
                member.uid,
                member.gid,
                float(member.mtime),
                member.size,
                member.linkname,
                content,
            )
