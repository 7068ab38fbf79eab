#!/usr/bin/env python3
"""Adds a part, and those that it needs, to a root file system.

    add_part.py REGISTRY/REPOSITORY:NAME ROOT

The labels of a part say what it needs: its framework's parts that are joined before it. Nothing but the registry is asked, and
what it sends is compared with its digests. It may ask for a token, as public registries do of everybody; a password it cannot be
given.
"""

from __future__ import annotations

import hashlib
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
from typing import Any, BinaryIO, NoReturn

PREFIX = "io.rosml."
INDEX = "application/vnd.oci.image.index.v1+json"
MANIFEST = "application/vnd.oci.image.manifest.v1+json"
ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}
TIMEOUT = 60.0
"""Seconds without an answer."""


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

    def json(self, path: str) -> Any:
        """A manifest or configuration."""
        with self.open(path, f"{INDEX}, {MANIFEST}") as answer:
            return json.load(answer)

    def _new_token(self, asks: str) -> str:
        """A token, of whoever gives it to everybody."""
        facts = dict(re.findall(r'(\w+)="([^"]*)"', asks))
        query = urllib.parse.urlencode({name: facts[name] for name in ("service", "scope") if name in facts})
        try:
            with urllib.request.urlopen(f"{facts['realm']}?{query}", timeout=TIMEOUT) as answer:
                content = json.load(answer)
            return content.get("token") or content["access_token"]
        except (OSError, KeyError, ValueError) as error:
            fail(f"{self.name} gives no token: {error}", "check that everybody may pull it")


class Part:
    """A part for this machine.

    Attributes:
        name: such as `torch-cu130-py312`. labels: what it says of itself.
    """

    def __init__(self, repository: Repository, name: str) -> None:
        self._repository, self.name = repository, name
        manifest = repository.json(f"manifests/{name}")
        if "manifests" in manifest:
            wanted = ARCHITECTURES.get(platform.machine(), platform.machine())
            found = {
                item["platform"]["architecture"]: item["digest"] for item in manifest["manifests"] if "platform" in item
            }
            if wanted not in found:
                fail(f"{name} is not for {wanted}", f"there are: {', '.join(sorted(found))}")
            manifest = repository.json(f"manifests/{found[wanted]}")
        self._layers = manifest["layers"]
        config = repository.json(f"blobs/{manifest['config']['digest']}")
        self.labels: dict[str, str] = config.get("config", {}).get("Labels") or {}

    def needed(self) -> list[str]:
        """The names of this part and of those before it, of the smallest framework that has it."""
        labels = self.labels
        kind, stack, python = (labels.get(PREFIX + name, "") for name in ("part", "stack", "python"))
        frameworks = [item.partition("=")[2].split(",") for item in labels.get(f"{PREFIX}frameworks", "").split()]
        parts = next((parts for parts in frameworks if kind in [part.rstrip("*") for part in parts]), None)
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
            with tempfile.NamedTemporaryFile() as file, self._repository.open(f"blobs/{digest}") as answer:
                seen = hashlib.sha256()
                try:
                    while block := answer.read(1 << 20):
                        seen.update(block)
                        file.write(block)
                except OSError as error:
                    fail(f"{self.name} did not arrive: {error}", "try again")
                file.flush()
                if f"sha256:{seen.hexdigest()}" != digest:
                    fail(f"{self.name} did not arrive whole", "try again")
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
