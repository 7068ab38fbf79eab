"""The package index that uv is configured for: what it resolves, and single files of its wheels, of which nothing else is downloaded."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import httpx

from rosml.base import archives, web
from rosml.base.errors import RosmlError
from rosml.images.locks import pylock
from rosml.images.locks.uv import Uv, compile_command

LARGEST = 32 << 20
"""The most bytes of a file in a wheel. TensorFlow's RECORD, the largest, has 2 MB."""

_PIECE = 1 << 18
"""Bytes of a wheel that one request asks for. A wheel's list of files is at its end and has up to 2 MB."""


@dataclass(frozen=True)
class Wheel:
    """A wheel on the index; its size in bytes."""

    url: str
    size: int


class WheelTarget(NamedTuple):
    """For what packages are resolved: a version of Python, and uv's name of the platform, e.g. ``x86_64-manylinux_2_28``."""

    python: str
    platform: str


class Index:
    def __init__(self, uv: Uv, client: httpx.Client) -> None:
        self.uv = uv
        self._client = client

    def resolve(
        self, target: WheelTarget, requirements: Iterable[str], constraints: Iterable[str] = (), *options: str
    ) -> tuple[str, str]:
        """The requirements from `uv pip compile`, empty if nothing fits; and its messages."""
        files = {"in.txt": "\n".join(requirements) + "\n", "constraints.txt": "\n".join(constraints) + "\n"}
        command = [*compile_command(*target), "--no-header", "--no-annotate", "--constraint", "constraints.txt"]
        command.remove("--quiet")  # with --quiet, uv does not warn about lost extras
        output = "pylock.toml" if options else "out.txt"
        status, text, messages = self.uv.compile([*command, *options, "in.txt"], files, output)
        if status == 0:
            return text, messages
        if "No solution found" not in messages:
            raise RosmlError(f"the index does not say what people get:\n{messages.strip()}", "check that it answers")
        return "", messages

    def wheels(self, target: WheelTarget, pins: Mapping[str, str], index: str = "") -> dict[str, Wheel]:
        """The wheels of packages in their versions. `index` is the address of another index, which is asked first."""
        requirements = [f"{name}=={version}" for name, version in pins.items()]
        other = ["--index", index] if index else []
        text, messages = self.resolve(target, requirements, (), "--no-deps", "--format", "pylock.toml", *other)
        if not text:
            raise RosmlError(f"the index lacks what is locked:\n{messages.strip()}", "run 'rosml locks'")
        wheels_by_name = dict[str, Wheel]()
        for package in pylock.read(text):
            for wheel in package.wheels[:1]:
                if not wheel.url or wheel.size is None:
                    what = f"the index does not say where the wheel of {package.name} is, or how large"
                    raise RosmlError(what, "run it with an index that has the sizes of wheels, such as PyPI")
                wheels_by_name[package.name] = Wheel(wheel.url, wheel.size)
        return wheels_by_name

    @cache  # noqa: B019 - lives as long as a command
    def metadata(self, wheel: Wheel) -> str:
        return self._file(wheel, "METADATA")

    @cache  # noqa: B019 - lives as long as a command
    def record(self, wheel: Wheel) -> Mapping[str, str]:
        """The files of a wheel by its RECORD: their hashes, by path."""
        try:
            return {row[0]: row[1] for row in csv.reader(self._file(wheel, "RECORD").splitlines()) if len(row) == 3}
        except csv.Error as error:
            raise _unread(wheel, "RECORD", error) from None

    def _file(self, wheel: Wheel, name: str) -> str:
        """A file of the wheel's `.dist-info`."""
        stream = io.BufferedReader(_Remote(self._client, wheel), _PIECE)
        try:
            return archives.file_of_zip(stream, rf"[^/]+\.dist-info/{name}", LARGEST).decode()
        except (ValueError, httpx.HTTPError, httpx.InvalidURL) as error:
            raise _unread(wheel, name, error) from None


def _unread(wheel: Wheel, name: str, error: Exception) -> RosmlError:
    text = f"the index's wheel {wheel.url.rpartition('/')[2]} cannot be read for its {name}: {error}"
    return RosmlError(text, "run it again; if it fails again, that wheel is damaged on the index")


class _Remote(io.RawIOBase):
    """A file on a server, read in pieces."""

    def __init__(self, client: httpx.Client, wheel: Wheel) -> None:
        self._client, self._wheel, self._at = client, wheel, 0

    def seekable(self) -> bool:
        return True

    def readable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._at

    def seek(self, offset: int, whence: int = 0) -> int:
        place = (0, self._at, self._wheel.size)[whence] + offset
        if place < 0:  # zipfile looks for the end of an archive so, and expects what a file says
            raise OSError("there is nothing before the beginning")
        self._at = place
        return self._at

    def readinto(self, buffer: memoryview) -> int:  # type: ignore[override]
        last = min(self._at + len(buffer), self._wheel.size) - 1
        if last < self._at:
            return 0
        content = self._piece(last)
        buffer[: len(content)] = content
        self._at += len(content)
        return len(content)

    def _piece(self, last: int) -> bytes:
        """The bytes up to `last`. If the index does not answer, asks again: a whole run has hundreds of such requests."""
        attempt = 0
        while True:
            attempt += 1
            request = self._client.build_request("GET", self._wheel.url, headers={"Range": f"bytes={self._at}-{last}"})
            try:
                answer = web.followed(self._client, request, elsewhere=True)
                if answer.status_code == httpx.codes.PARTIAL_CONTENT:
                    return web.read(answer, last + 1 - self._at)
            except httpx.TransportError:
                if not web.waited(attempt):
                    raise
                continue
            answer.close()
            raise RosmlError("the index sends no pieces of wheels", "run it with an index that does")
