"""A machine on which somebody calls `rosml run`: its files are in a folder."""

from __future__ import annotations

from pathlib import Path

from fakes.exports import ROSML_OPTIONS
from rosml.run.context import Address, Context, Engine, Host, Image, Person
from rosml.run.words import split


class Machine:
    """A machine with the files of a folder.

    Attributes:
        listens: addresses at which something listens.
        environment: the caller's variables.
        addresses: its own ones.
        echoes: whether multicast comes back.
        ports: the ports to which multicast was sent.
    """

    def __init__(self, root: Path, me: Person) -> None:
        self.root, self.me = root, me
        self.listens: set[Address] = set()
        self.environment: dict[str, str] = {}
        self.addresses: set[str] = set()
        self.echoes = True
        self.ports: list[int] = []

    def file(self, place: str, content: bytes = b"") -> Path:
        """Makes a file."""
        path = self.root / place.lstrip("/")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        return path

    def socket(self, place: str) -> None:
        """Lets something listen at a path."""
        self.listens.add(str(self.file(place)))

    def _echoes(self, port: int) -> bool:
        self.ports.append(port)
        return self.echoes

    def context(
        self, *words: str, engine: Engine | None = None, image: Image | None = None, me: Person | None = None
    ) -> Context:
        listens, owns = self.listens.__contains__, self.addresses.__contains__
        host = Host(self.root, self.environment, "robot", listens, owns, self._echoes, "amd64")
        return Context(
            split([*words, "ros:jazzy"], ROSML_OPTIONS), engine or Engine(), me or self.me, image or Image(), host
        )
