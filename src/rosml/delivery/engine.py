"""What docker or podman of this machine has of an image, and how it gets the rest."""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import subprocess
import tarfile
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import IO, BinaryIO, cast

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.delivery import archive
from rosml.delivery.complete import complete
from rosml.delivery.image import Image, Layer
from rosml.delivery.sources import LayerBlob
from rosml.run import engine
from rosml.run.context import NEW_DOCKER, OLD_DOCKER, Engine

_DIGEST_NAME = re.compile(r"(?:\./)?(?:blobs/sha256/)?([0-9a-f]{64})(?:\.tar)?")
"""A file of `docker save` or `podman save` whose name is the digest of its content."""

_CLASSIC_NAME = re.compile(r"[0-9a-f]{64}/layer\.tar")
"""A layer of `docker save` before Docker 25. Its name does not say its digest."""


@dataclass(frozen=True)
class InEngine:
    """Layers of an image that an engine has: Docker's classic store and podman have them uncompressed."""

    command: str
    identity: str
    diff_ids: frozenset[str]

    @property
    def name(self) -> str:
        return f"{self.command} save {self.identity[:12]}"

    def has(self, layer: Layer) -> bool:
        return layer.diff_id in self.diff_ids

    def take(self, layers: Sequence[Layer]) -> Iterator[LayerBlob]:
        """Layers, while the engine writes them. What nobody asked for is dropped as it comes."""
        pending = {**{layer.diff_id: layer for layer in layers}, **{layer.digest: layer for layer in layers}}
        # Docker's containerd store takes 64 digits alone for a name.
        with _reading(self.command, "save", f"sha256:{self.identity}") as stream:
            for entry in archive.entries(stream, "r|", self.name):
                if not archive.is_plain(entry):
                    continue
                content = partial(_blocks, entry, self.name)
                if match := _DIGEST_NAME.fullmatch(entry.name):
                    digest = f"sha256:{match[1]}"
                    if layer := pending.get(digest):
                        yield LayerBlob(layer, digest, entry.size, partial(_send, content))
                        _drop(pending, layer)
                elif _CLASSIC_NAME.fullmatch(entry.name):
                    with _temporary_file(content()) as (digest, file):
                        if layer := pending.get(digest):
                            yield LayerBlob(layer, digest, entry.size, partial(archive.send_file, file))
                            _drop(pending, layer)
                if not pending:
                    return


def _drop(pending: dict[str, Layer], layer: Layer) -> None:
    for digest in (layer.diff_id, layer.digest):
        pending.pop(digest, None)


def _send(content: Callable[[], Iterator[bytes]], write: archive.Write) -> None:
    write(content())


def _blocks(entry: tarfile.TarInfo, name: str) -> Iterator[bytes]:
    stream = cast(tarfile.TarFile, entry.content).extractfile(entry)  # type: ignore[attr-defined]
    assert stream
    try:
        while block := stream.read(archive.BLOCK):
            yield block
    except (tarfile.TarError, ValueError) as error:
        raise RosmlError(f"{name} is no tar file, or is damaged: {error}", f"try `{name} | wc -c`") from None


@contextlib.contextmanager
def _temporary_file(blocks: Iterable[bytes]) -> Iterator[tuple[str, IO[bytes]]]:
    """The digest of a content, and a temporary file of it."""
    state = hashlib.sha256()
    with files.temporary() as file:
        for block in blocks:
            state.update(block)
            file.write(block)
        yield f"sha256:{state.hexdigest()}", file


def sources(command: str, image: Image, only: str = "") -> list[InEngine]:
    """The images of an engine, or the one with the id `only`, that have layers which an archive lacks, or layers that these replace."""
    missing = {layer.diff_id for layer in (*image.missing, *image.replaced)}
    candidates = {name: diff_ids for name, diff_ids in engine.layers(command).items() if only in ("", name)}
    smallest_first = sorted(
        candidates.items(), key=lambda pair: len(pair[1])
    )  # `docker save` reads all layers of an image
    return [InEngine(command, name, frozenset(diff_ids)) for name, diff_ids in smallest_first if missing & {*diff_ids}]


def held(command: str, image: Image, store: Engine) -> set[str]:
    """The digests of layers that docker takes from its own store: another image has them, on the same layers."""
    if not store.zstd and any(str(entry["mediaType"]).endswith("zstd") for entry in image.content["layers"]):
        raise RosmlError(f"{command} cannot load {image.name or 'the image'}: {OLD_DOCKER}", NEW_DOCKER, exit_code=2)
    if not store.chains:
        return set()
    diff_ids_of_image = [image.layers[digest].diff_id for digest in image.order]
    most = max((_common(diff_ids_of_image, diff_ids) for diff_ids in engine.layers(command).values()), default=0)
    return {*image.order[:most]}.difference(image.order[most:])


def _common(one: Sequence[str], other: Sequence[str]) -> int:
    """How many layers two images have in common from the lowest on."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((number for number, (first, second) in pairs if first != second), min(len(one), len(other)))


def takes_as_it_is(command: str, image: Image) -> bool:
    """Whether podman loaded the image without the layers that the archive lacks, since it has pulled them as they are in the registry. Then the
    image keeps its digest."""
    lacking = {layer.digest for layer in image.missing}
    try:
        with loading(command) as out:
            complete(image, [], out, held=lacking)
    except NotLoaded:
        return False
    return True


PATIENCE = 10.0
"""Seconds that an engine may take to give up what it got half of. podman removes its copy then."""

FULL = "free some space where it keeps images, and in TMPDIR or /var/tmp; docker system df and podman system df say what takes it"


class NotLoaded(RosmlError):
    """The engine cannot load what it got."""


@contextlib.contextmanager
def loading(command: str) -> Iterator[BinaryIO]:
    """A pipe into `docker load` or `podman load`. If something goes wrong, the engine gets half of an archive, which names no image."""
    with (
        tempfile.TemporaryFile() as output,
        # podman keeps what it reads in TMPDIR, and leaves it there if the disk gets full.
        tempfile.TemporaryDirectory(
            prefix="rosml-load-", dir=files.large_folder(), ignore_cleanup_errors=True
        ) as folder,
    ):
        streams = {"stdin": subprocess.PIPE, "stdout": output, "stderr": subprocess.STDOUT}
        process = _start(command, "load", env={**os.environ, "TMPDIR": folder}, **streams)
        assert process.stdin
        broken = False
        try:
            yield cast(BinaryIO, process.stdin)
            process.stdin.close()
        except BrokenPipeError:
            broken = True
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()
        except BaseException:
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(PATIENCE)
            process.kill()
            process.wait()
            raise
        if process.wait() or broken:
            last = _last_line(output)
            if "no space left on device" in last.lower():
                raise NotLoaded(f"{command} has no space left for the image: {last}", FULL)
            raise NotLoaded(
                f"{command} cannot load the image: {last}",
                "its own message says why; docker info has its version and disk",
            )


@contextlib.contextmanager
def _reading(command: str, *words: str) -> Iterator[IO[bytes]]:
    """The output of an engine, until the caller has enough."""
    with tempfile.TemporaryFile() as errors:
        process = _start(command, *words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors)
        assert process.stdout
        try:
            yield process.stdout
        except RosmlError:
            if process.poll() not in (None, 0):
                raise RosmlError(
                    f"{command} {words[0]} failed: {_last_line(errors)}", f"try `{command} {' '.join(words)} | wc -c`"
                ) from None
            raise
        finally:
            process.kill()
            process.stdout.close()
            process.wait()


def _start(command: str, *words: str, **streams: object) -> subprocess.Popen[bytes]:
    try:
        return subprocess.Popen([command, *words], **streams)  # type: ignore[call-overload,no-any-return]
    except OSError as error:
        remedy = f"install it again, or name another one with {engine.ENGINE}"
        raise RosmlError(f"{command} cannot be run: {error.strerror}", remedy) from None


def _last_line(errors: IO[bytes]) -> str:
    errors.seek(max(0, errors.seek(0, 2) - 2000))
    lines = errors.read().decode(errors="replace").strip().splitlines()
    return lines[-1][:500] if lines else "it says nothing"
