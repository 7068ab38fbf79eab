#!/usr/bin/env python3
"""Adds a part, and those that it needs, to a root file system.

    add_part.py REGISTRY/REPOSITORY:NAME ROOT

The labels of a part say what it needs: the parts of its add-on or framework that are joined before it. Nothing but the registry is asked. What
it sends for a digest is compared with that digest: manifests, configs and layers. What a name stands for is the registry's word.
It may ask for a token, as public registries do of everybody; a password it cannot be given.
"""

from __future__ import annotations

import hashlib
import io
import json
import platform
import re
import subprocess
import sys
import tempfile
import urllib.error
import urllib.parse
import urllib.request
from pathlib import Path
from typing import IO, Any, BinaryIO, NoReturn

PREFIX = "io.rosml."
INDEX = "application/vnd.oci.image.index.v1+json"
MANIFEST = "application/vnd.oci.image.manifest.v1+json"
ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}
TIMEOUT = 60.0
"""Seconds without an answer."""
LARGEST = 4 << 20
"""Bytes of a manifest, a config or an answer with a token."""


def fail(message: str, remedy: str) -> NoReturn:
    sys.exit(f"error: {message}; {remedy}")


class Repository:
    """A repository of a registry, as everybody may read it."""

    def __init__(self, host: str, name: str) -> None:
        local = re.fullmatch(r"(localhost|127\.[\d.]+)(:\d+)?", host)
        server = "registry-1.docker.io" if host == "docker.io" else host
        self._base = f"{'http' if local else 'https'}://{server}/v2/{name}"
        self.name, self._token = f"{host}/{name}", ""

    def open(self, path: str, accept: str = "*/*") -> BinaryIO:
        """What the registry has at a path; ends the program where it has nothing."""
        for attempt in range(2):
            request = urllib.request.Request(f"{self._base}/{path}", headers={"Accept": accept})
            if self._token:  # for the registry alone, and not for the storage that it sends us to
                request.add_unredirected_header("Authorization", f"Bearer {self._token}")
            try:
                return urllib.request.urlopen(request, timeout=TIMEOUT)
            except urllib.error.HTTPError as error:
                asks = error.headers.get("WWW-Authenticate", "")
                if error.code == 401 and attempt == 0 and asks.lower().startswith("bearer "):
                    self._token = self._new_token(asks)
                    continue
                why = {401: "it wants a password", 403: "it wants a password", 404: "there is none"}
                reason = why.get(error.code, f"HTTP {error.code}")
                fail(
                    f"{self.name}, {path}: {reason}",
                    "check the name of the part; it has to be one that everybody may pull",
                )
            except OSError as error:
                fail(f"{self.name} does not answer: {error}", "check the registry, the network and HTTPS_PROXY")
        fail(f"{self.name} takes no token", "check that everybody may pull it")

    def named(self, name: str) -> Any:
        """The manifest or index that a name stands for."""
        with self.open(f"manifests/{name}", f"{INDEX}, {MANIFEST}") as answer:
            return self._parsed(answer.read(LARGEST), name)

    def json(self, kind: str, digest: str) -> Any:
        """A manifest or config, by its digest."""
        content = io.BytesIO()
        self.copy(kind, digest, content, digest, LARGEST)
        return self._parsed(content.getvalue(), digest)

    def copy(self, kind: str, digest: str, to: IO[bytes], what: str, largest: int = 1 << 50) -> None:
        """Writes what the registry has for a digest into a file; ends the program if it has another digest."""
        if not re.fullmatch(r"sha256:[0-9a-f]{64}", digest):
            fail(f"{self.name}: {digest!r} is no digest", "check the name of the part")
        seen = hashlib.sha256()
        with self.open(f"{kind}/{digest}", f"{INDEX}, {MANIFEST}" if kind == "manifests" else "*/*") as answer:
            try:
                while largest > 0 and (block := answer.read(min(largest, 1 << 20))):
                    largest -= len(block)
                    seen.update(block)
                    to.write(block)
            except OSError as error:
                fail(f"{what} did not arrive: {error}", "try again")
        if f"sha256:{seen.hexdigest()}" != digest:
            fail(f"{what} did not arrive whole", "try again")

    def _parsed(self, content: bytes, what: str) -> Any:
        try:
            return json.loads(content)
        except (ValueError, RecursionError):
            fail(f"{self.name}: {what} is no JSON", "check the registry, and the name of the part")

    def _new_token(self, asks: str) -> str:
        """A token, of whoever gives it to everybody."""
        facts = dict(re.findall(r'(\w+)="([^"]*)"', asks))
        query = urllib.parse.urlencode({name: facts[name] for name in ("service", "scope") if name in facts})
        realm = facts.get("realm", "")
        if not re.match(r"https://|http://(localhost|127\.[\d.]+)[:/]", realm):
            fail(f"{self.name} names no server for tokens that anybody may ask: {realm[:200]!r}", "check the registry")
        try:
            with urllib.request.urlopen(f"{realm}?{query}", timeout=TIMEOUT) as answer:
                content = self._parsed(answer.read(LARGEST), "its token")
            return content.get("token") or content["access_token"]
        except (AttributeError, OSError, KeyError, TypeError, ValueError) as error:
            fail(f"{self.name} gives no token: {error}", "check that everybody may pull it")


class Part:
    """A part for this machine.

    Attributes:
        name: such as `torch-cu130-py312`. labels: what it says of itself.
    """

    def __init__(self, repository: Repository, name: str) -> None:
        self._repository, self.name = repository, name
        manifest = repository.named(name)
        if "manifests" in manifest:
            wanted = ARCHITECTURES.get(platform.machine(), platform.machine())
            found = {
                item["platform"]["architecture"]: item["digest"] for item in manifest["manifests"] if "platform" in item
            }
            if wanted not in found:
                fail(f"{name} is not for {wanted}", f"there are: {', '.join(sorted(found))}")
            manifest = repository.json("manifests", found[wanted])
        self._layers = manifest["layers"]
        config = repository.json("blobs", manifest["config"]["digest"])
        self.labels: dict[str, str] = config.get("config", {}).get("Labels") or {}

    def needed(self) -> list[str]:
        """The names of this part and of those before it, of its add-on or else of the smallest framework that has it."""
        labels = self.labels
        kind, stack, python = (labels.get(PREFIX + name, "") for name in ("part", "stack", "python"))
        told = f"{labels.get(f'{PREFIX}addons', '')} {labels.get(f'{PREFIX}frameworks', '')}"
        combinations = [item.partition("=")[2].split(",") for item in told.split()]
        parts = next((parts for parts in combinations if kind in [part.rstrip("*") for part in parts]), None)
        if not parts:
            fail(f"{self._repository.name}:{self.name} is no part", "name one, such as part:torch-cu130-py312")
        names = []
        for part in parts:
            name = part.rstrip("*")
            any_python = part.endswith("*") or python == "any"
            names.append(f"{name}-{stack}" if any_python else f"{name}-{stack}-py{python.replace('.', '')}")
            if name == kind:
                break
        return names

    def add(self, root: Path) -> None:
        """Unpacks its layers."""
        for layer in self._layers:
            digest, kind = layer["digest"], layer["mediaType"].rpartition("+")[2]
            print(f"{self.name}: {layer['size'] / 1e6:.1f} MB", flush=True)
            with tempfile.NamedTemporaryFile() as file:
                self._repository.copy("blobs", digest, file, self.name)
                file.flush()
                unpack = ["--zstd"] if kind == "zstd" else ["--gzip"] if kind == "gzip" else []
                command = [
                    "tar",
                    "--extract",
                    *unpack,
                    "--no-overwrite-dir",
                    "--keep-directory-symlink",
                    "--file",
                    file.name,
                    "--directory",
                    str(root),
                ]
                if subprocess.run(command).returncode:
                    fail(f"{self.name} cannot be unpacked", "the line above says why")


def main(reference: str, root: Path) -> None:
    found = re.fullmatch(r"([^/]+[.:][^/]*|localhost)/([^:@]+):([\w.-]+)", reference)
    if not found:
        fail(f"{reference!r} is no part with its registry", "name one, such as ghcr.io/me/rosml/part:torch-cu130-py312")
    repository = Repository(found[1], found[2])
    part = Part(repository, found[3])
    python, own = part.labels.get(f"{PREFIX}python", "any"), ".".join(platform.python_version_tuple()[:2])
    if python not in ("any", own):
        fail(f"{part.name} is for Python {python}, and the image has {own}", "name the part for that Python")
    for name in part.needed():
        (part if name == part.name else Part(repository, name)).add(root)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
