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
from rosml.delivery.load import Found, Image, Layer, complete
from rosml.run import engine

_NAMED = re.compile(r"(?:\./)?(?:blobs/sha256/)?([0-9a-f]{64})(?:\.tar)?")
"""A file of `docker save` or `podman save` whose name is the digest of its content."""

_OLD = re.compile(r"[0-9a-f]{64}/layer\.tar")
"""A layer of `docker save` before Docker 25. Its name does not say its digest."""


@dataclass(frozen=True)
class InEngine:
    """Layers of an image that an engine has. Docker's classic store and podman have them uncompressed.

    Attributes:
        command: of the engine.
        identity: of the image.
        diff_ids: digests of its layers before they were compressed.
    """

    command: str
    identity: str
    diff_ids: frozenset[str]

    @property
    def name(self) -> str:
        """The command that gives them."""
        return f"{self.command} save {self.identity[:12]}"

    def has(self, layer: Layer) -> bool:
        """Whether the image has a layer."""
        return layer.diff_id in self.diff_ids

    def take(self, wanted: Sequence[Layer]) -> Iterator[Found]:
        """Gives layers while the engine writes them. What is not wanted is dropped as it comes."""
        left = {**{layer.diff_id: layer for layer in wanted}, **{layer.digest: layer for layer in wanted}}
        with _reading(self.command, "save", self.identity) as stream:
            for entry in archive.entries(stream, "r|", self.name):
                if not archive.is_plain(entry):
                    continue
                content = partial(_blocks, entry, self.name)
                if named := _NAMED.fullmatch(entry.name):
                    digest = f"sha256:{named[1]}"
                    if layer := left.get(digest):
                        yield Found(layer, digest, entry.size, partial(_sent, content))
                        _done(left, layer)
                elif _OLD.fullmatch(entry.name):
                    with _kept(content()) as (digest, kept):
                        if layer := left.get(digest):
                            yield Found(layer, digest, entry.size, partial(archive.again, kept))
                            _done(left, layer)
                if not left:
                    return


def _done(left: dict[str, Layer], layer: Layer) -> None:
    for digest in (layer.diff_id, layer.digest):
        left.pop(digest, None)


def _sent(content: Callable[[], Iterator[bytes]], write: Callable[[Iterable[bytes]], None]) -> None:
    write(content())


def _blocks(entry: tarfile.TarInfo, name: str) -> Iterator[bytes]:
    """The pieces of a file.

    Raises:
        RosmlError: the engine breaks off.
    """
    stream = cast(tarfile.TarFile, entry.content).extractfile(entry)  # type: ignore[attr-defined]
    assert stream
    try:
        while block := stream.read(archive.BLOCK):
            yield block
    except (tarfile.TarError, ValueError) as error:
        raise RosmlError(f"{name} is no tar file, or is damaged: {error}", f"try `{name} | wc -c`") from None


@contextlib.contextmanager
def _kept(blocks: Iterable[bytes]) -> Iterator[tuple[str, IO[bytes]]]:
    """The digest of a content, and a file of it for as long as this lasts."""
    state = hashlib.sha256()
    with files.temporary() as file:
        for block in blocks:
            state.update(block)
            file.write(block)
        yield f"sha256:{state.hexdigest()}", file


def sources(command: str, image: Image, only: str = "") -> list[InEngine]:
    """The images of an engine that have layers that are missing in an archive, or layers that these replace.

    Args:
        only: the id of the image that may be asked; all may if empty.

    Raises:
        RosmlError: the engine does not answer.
    """
    missing = {layer.diff_id for layer in (*image.missing, *image.replaced)}
    known = {name: diff_ids for name, diff_ids in engine.layers(command).items() if only in ("", name)}
    near = sorted(known.items(), key=lambda pair: len(pair[1]))  # `docker save` reads all layers of an image
    return [InEngine(command, name, frozenset(diff_ids)) for name, diff_ids in near if missing & {*diff_ids}]


def held(command: str, image: Image, store: engine.Store) -> set[str]:
    """The digests of the layers that docker takes from its own store: it has them in another image, on the same layers.

    docker's classic store keeps a layer with all below it under one name, and reads no file for a layer that it has. docker with containerd's
    store wants all layers in the file.

    Args:
        store: of the engine.

    Raises:
        RosmlError: the engine does not answer, or cannot read the image (exit code 2).
    """
    if not store.zstd and any(str(entry["mediaType"]).endswith("zstd") for entry in image.content["layers"]):
        text = f"{command} here is older than version 23, and cannot read layers with zstd, which {image.name or 'the image'} has"
        raise RosmlError(text, "update Docker, or take podman: ROSML_ENGINE=podman", exit_code=2)
    if not store.chains:
        return set()
    wanted = [image.layers[digest].diff_id for digest in image.order]
    most = 0
    for diff_ids in engine.layers(command).values():
        same = (one == other for one, other in zip(wanted, diff_ids, strict=False))
        most = max(
            most, next((number for number, is_same in enumerate(same) if not is_same), min(len(wanted), len(diff_ids)))
        )
    return {*image.order[:most]}.difference(image.order[most:])


def takes_as_it_is(command: str, image: Image) -> bool:
    """Lets podman load an image without the layers that the archive lacks. It takes those from its store, if it pulled them as they are in
    the registry; then the image keeps its digest, and nothing is read from `podman save`.

    Returns:
        Whether podman has the image now.
    """
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
    """Gives a pipe into `docker load` or `podman load`. If something goes wrong, the engine gets half of an archive, which names no image.

    Raises:
        NotLoaded: the engine cannot load what it got.
    """
    with (
        tempfile.TemporaryFile() as output,
        # podman keeps what it reads in TMPDIR, and leaves it there if the disk gets full.
        tempfile.TemporaryDirectory(
            prefix="rosml-load-", dir=files.large_folder(), ignore_cleanup_errors=True
        ) as folder,
    ):
        streams = {"stdin": subprocess.PIPE, "stdout": output, "stderr": subprocess.STDOUT}
        process = _begun(command, "load", env={**os.environ, "TMPDIR": folder}, **streams)
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
            last = _last(output)
            if "no space left on device" in last.lower():
                raise NotLoaded(f"{command} has no space left for the image: {last}", FULL)
            raise NotLoaded(
                f"{command} cannot load the image: {last}",
                "its own message says why; docker info has its version and disk",
            )


@contextlib.contextmanager
def _reading(command: str, *words: str) -> Iterator[IO[bytes]]:
    """The output of an engine, until the caller has enough.

    Raises:
        RosmlError: the engine failed.
    """
    with tempfile.TemporaryFile() as said:
        process = _begun(command, *words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=said)
        assert process.stdout
        try:
            yield process.stdout
        except RosmlError:
            if process.poll() not in (None, 0):
                raise RosmlError(
                    f"{command} {words[0]} failed: {_last(said)}", f"try `{command} {' '.join(words)} | wc -c`"
                ) from None
            raise
        finally:
            process.kill()
            process.stdout.close()
            process.wait()


def _begun(command: str, *words: str, **streams: object) -> subprocess.Popen[bytes]:
    try:
        return subprocess.Popen([command, *words], **streams)  # type: ignore[call-overload,no-any-return]
    except OSError as error:
        remedy = f"install it again, or name another one with {engine.ENGINE}"
        raise RosmlError(f"{command} cannot be run: {error.strerror}", remedy) from None


def _last(said: IO[bytes]) -> str:
    """The last line of what a program said."""
    said.seek(max(0, said.seek(0, 2) - 2000))
    lines = said.read().decode(errors="replace").strip().splitlines()
    return lines[-1][:500] if lines else "it says nothing"
