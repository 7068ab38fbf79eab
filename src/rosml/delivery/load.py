"""Loads an archive of `save`: finds the layers that it lacks, and gives all to an engine or writes them into a file."""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, BinaryIO

from rosml.base import files, progress_bar
from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.delivery import engine, pulled_layers
from rosml.delivery.archive import BLOCK, Archive
from rosml.delivery.complete import choose, complete
from rosml.delivery.image import Image, Layer, read
from rosml.delivery.sources import InArchive, InRegistry, Source
from rosml.images.builds.base_images import native_architecture
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries
from rosml.run import engine as engines

STANDARD_INPUT = "-"


@dataclass(frozen=True)
class Loaded:
    """What came of a load. Sizes are in bytes.

    Attributes:
        image: its complete reference; empty if the archive names none. digest: of its manifest, as it was pushed.
        id: by which engines know it: the digest of its config.
        into: the file that was written, with an image of the digest `written`; both are empty if an engine loaded it.
        layers: how many layers the archive had. patches: how many were made of older ones.
        taken: how many layers came from elsewhere. held: how many the engine found by itself.
    """

    image: str
    digest: str
    id: str
    into: str
    written: str
    layers: int
    bytes: int
    patches: int
    patch_bytes: int
    taken: int
    held: int


@dataclass(frozen=True)
class Loader:
    """Loads archives. `say` gets lines for people, `warn` a warning and its remedy."""

    services: Services
    registries: Registries
    environment: Mapping[str, str]
    say: Callable[[str], None] = lambda _: None
    warn: Callable[[str, str], None] = lambda *_: None

    def load(self, file: str, origins: Sequence[str], into: str) -> Loaded:
        """Loads an archive into the engine, or writes the whole archive into a file.

        Args:
            file: the archive, or STANDARD_INPUT.
            origins: who gives missing layers: archives, images of the engine, or references. If there are none, the engine's images.
            into: the file to write; empty for the engine.

        Raises:
            RosmlError: the archive is damaged, does not fit this machine (exit code 2), or is not loaded.
        """
        with contextlib.ExitStack() as stack:
            image = read(_archive(file, stack))
            command = self._engine(into)
            held: set[str] = set()
            if not into:
                self._require_platform(image)
                store = engines.answering(command)
                held = engine.held(command, image, store)
                complete_in_podman = store.podman and image.missing and not image.patches and not origins
                if complete_in_podman and engine.takes_as_it_is(command, image):
                    return _loaded(image, [], held=len(image.missing))
            sources: list[Source] = []
            if origins:
                sources = [source for name in origins for source in self._sources(name, image, command, stack)]
            elif command and any(layer.digest not in held for layer in image.missing):
                sources = [*engine.sources(command, image)]
            choice = choose(image, sources, held)
            for source, layers in choice:
                self.say(f"{counted(len(layers), 'layer')} from {source.name}")
            total = sum(layer.size for layer in image.layers.values() if layer.digest not in held)
            # The bar ends before the engine is waited for.
            out = stack.enter_context(files.whole(Path(into)) if into else engine.loading(command))
            with progress_bar.of_bytes("layers", total) as advance:
                digest = complete(image, choice, out, advance, held)
        taken = [layer for _, layers in choice for layer in layers]
        return _loaded(image, taken, into, digest if into else "", len(held))

    def _engine(self, into: str) -> str:
        """The engine's command; empty if there is none and a file is written."""
        try:
            return engines.choose(self.environment, self.say)
        except RosmlError:
            if into:
                return ""
            raise

    def _require_platform(self, image: Image) -> None:
        here = f"linux/{native_architecture()}"
        if image.platform != here:
            self.warn(
                f"the image is for {image.platform}, and this machine is {here}", f"save it with --platform {here}"
            )

    def _sources(self, name: str, image: Image, command: str, stack: contextlib.ExitStack) -> Sequence[Source]:
        """Who gives missing layers, by the name that a user gave: a file, an image of the engine, or one in a registry."""
        if os.path.exists(name) or name.startswith(("/", "./", "../")):
            return [InArchive(_archive(name, stack))]
        if command and (local_image := engines.image(command, name)):
            return engine.sources(command, image, local_image.id)
        place = references.parse(pulled_layers.complete(name, self.services, self.registries))
        return [InRegistry(self.registries(place.host), place.repository)]


def _loaded(image: Image, taken: Sequence[Layer], into: str = "", written: str = "", held: int = 0) -> Loaded:
    sizes = [layer.size for layer in image.layers.values() if layer not in image.missing]
    patches = [patch.size for patch in image.patches.values() if patch.older in taken]
    counts = len(sizes), sum(sizes), len(patches), sum(patches), len(taken), held
    return Loaded(image.name, image.digest, image.identity, into, written, *counts)


def _archive(file: str, stack: contextlib.ExitStack) -> Archive:
    """The archive of a name that a user gave."""
    if file == STANDARD_INPUT:
        if sys.stdin.isatty():
            raise RosmlError("standard input is a terminal", "name the file, or send it: … | rosml load -", exit_code=2)
        return Archive(stack.enter_context(_in_file(sys.stdin.buffer)), "standard input")
    try:
        stream = stack.enter_context(Path(file).open("rb"))  # noqa: SIM115 # the stack closes it
    except OSError as error:
        raise RosmlError(f"{file} cannot be read: {error.strerror}", "name a file that rosml save wrote", 2) from None
    if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
        raise RosmlError(f"{file} is no file", f"send it to standard input: rosml load - < {file}", exit_code=2)
    return Archive(stream, file)


@contextlib.contextmanager
def _in_file(stream: BinaryIO) -> Iterator[IO[bytes]]:
    with files.temporary() as file:
        shutil.copyfileobj(stream, file, BLOCK)
        yield file
