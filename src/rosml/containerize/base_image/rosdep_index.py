"""rosdep's lists of one day as an artifact in a registry, for builds that ask no other server: the keys and the distributions of a
checkout of ros/rosdistro."""

from __future__ import annotations

import contextlib
import gzip
import io
import re
import shutil
import tarfile
import tempfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path

from pydantic import ConfigDict, ValidationError

from rosml.base import archives, untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.containerize import lock, within
from rosml.containerize.base_image import base as app_base
from rosml.containerize.sources import git
from rosml.images.image_set.labels import PREFIX
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries, Registry

NAME = "rosdep"
"""The repository, beside those of images."""

TYPE = "application/vnd.rosml.rosdep.v1"
LAYER = f"{TYPE}.tar+gzip"

TYPED = "--rosdep-index, or its variable ROSDEP_INDEX,"
"""How a user names lists, for messages. `rosml dev` takes only the variable."""

ADDRESS = "https://github.com/ros/rosdistro"

INDEX = "index-v4.yaml"

KEPT = 5
"""How many versions of the lists a machine keeps."""

_PATH = re.compile(r"[A-Za-z0-9_-][A-Za-z0-9_.-]*(/[A-Za-z0-9_-][A-Za-z0-9_.-]*){0,9}")


LARGEST, FILES = 64 << 20, 1000
"""The most bytes of all lists together, unpacked, and the most files. ros/rosdistro has less than 10 MB and 100 files."""


class _Distribution(Shape):
    model_config = ConfigDict(strict=True)

    distribution: list[str]


class _Index(Shape):
    """The files of distributions in their index."""

    model_config = ConfigDict(strict=True)

    distributions: dict[str, _Distribution]


@contextlib.contextmanager
def checkout(folder: Path | None) -> Iterator[Path]:
    """A checkout of ros/rosdistro: the named one, or a new one.

    Raises:
        RosmlError: GitHub does not answer, or git is not installed.
    """
    if folder:
        yield folder
        return
    with tempfile.TemporaryDirectory() as place:
        new = Path(place) / "rosdistro"
        try:
            with git.opened(git.Access(), Path(place)) as call:
                call("clone", "--quiet", "--depth", "1", ADDRESS, str(new))
        except git.Failed as error:
            raise RosmlError(
                f"{ADDRESS} cannot be cloned: {error.reason}", "name a checkout of it that you have"
            ) from None
        yield new


def _files(checkout: Path) -> Iterator[str]:
    """The files of a checkout that rosdep reads.

    Raises:
        RosmlError: it is no checkout of ros/rosdistro, or an incomplete one (exit code 2).
    """
    lists = sorted(path.name for path in checkout.glob("rosdep/*.yaml"))
    try:
        index = _Index.model_validate(untrusted.yaml_of((checkout / INDEX).read_bytes(), INDEX))
        named = [name for facts in index.distributions.values() for name in facts.distribution]
    except (OSError, RosmlError, ValidationError):
        named = []
    if not lists or not named:
        raise RosmlError(f"{checkout} is no checkout of ros/rosdistro", "clone it, and name its folder", exit_code=2)
    for name in [INDEX, *(f"rosdep/{name}" for name in lists), *sorted(set(named))]:
        if not _PATH.fullmatch(name) or not within.there(checkout / name, checkout):
            raise RosmlError(f"{checkout} has no {name} that can be published", "clone it whole", exit_code=2)
        yield name


def copied(folder: Path, out: Path) -> Path:
    """Copies the files of a checkout that rosdep may read, without git's folder, which differs between clones.

    Raises:
        RosmlError: it has no lists, or a link leads out of the checkout (exit code 2).
    """
    shutil.rmtree(out, ignore_errors=True)
    found = [path for pattern in ("*.yaml", "*/*.yaml") for path in folder.glob(pattern) if within.there(path, folder)]
    if not any(path.parent.name == NAME for path in found):
        text = f"{TYPED} names {folder}, which has no rosdep/*.yaml"
        raise RosmlError(text, "name a checkout of ros/rosdistro", exit_code=2)
    for path in found:
        target = out / path.relative_to(folder)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)
    return out


def packed(checkout: Path) -> bytes:
    """The lists of a checkout in one file. The same lists give the same bytes.

    Raises:
        RosmlError: it is no checkout of ros/rosdistro (exit code 2).
    """
    buffer = io.BytesIO()
    with gzip.GzipFile(fileobj=buffer, mode="wb", mtime=0) as stream, tarfile.open(fileobj=stream, mode="w") as tar:
        for name in _files(checkout):
            content = (checkout / name).read_bytes()
            # Invalid YAML would break all builds.
            untrusted.yaml_of(content, name, LARGEST, "correct it, or take another commit", exit_code=2)
            member = tarfile.TarInfo(name)
            member.size = len(content)
            tar.addfile(member, io.BytesIO(content))
    return buffer.getvalue()


def publish(checkout: Path, registry: Registry, repository: str, tags: tuple[str, ...]) -> str:
    """Pushes the lists of a checkout with some tags. Returns their digest.

    Raises:
        RosmlError: it is no checkout of ros/rosdistro (exit code 2), or the registry refuses.
    """
    content = packed(checkout)
    digests = [registry.put_artifact(repository, tag, TYPE, content, LAYER) for tag in tags]
    return digests[0]


class Finder:
    """Finds the lists for a build.

    Args:
        services: the services, with the local registry.
        folder: the repository.
        say: tells the user which lists it found.
    """

    def __init__(self, services: Services, folder: Path, say: Callable[[str], object]) -> None:
        self._services, self._folder, self._say = services, folder, say

    def find(self, named: str, base: app_base.Base, pin: str, locked: bool) -> tuple[Path, str] | None:
        """A folder with the lists, and their digest if they are from a registry: those that the user names, or else the newest
        published beside one of our base images. None if there are none.

        Args:
            pin: the digest in the lock file; empty if it has none.
            locked: there is a lock file.

        Raises:
            RosmlError: the lists that the user or the lock file names are missing, or are something else (exit code 2).
        """
        folder = self._folder / named
        if named.startswith("~/"):
            folder = Path.home() / named[2:]
        if named and folder.is_dir():
            return folder, ""
        if named and not re.search("[:@]", named):
            text = f"{TYPED} names {named}: there is no folder {folder}"
            raise RosmlError(
                text, "name a checkout of ros/rosdistro, or what a registry has, with its tag", exit_code=2
            )
        if locked and not pin:
            if named:
                raise RosmlError("the lock file has no lists of rosdep", lock.RENEW, exit_code=2)
            return None
        names: tuple[str, ...] = ()
        if named:
            names = app_base.candidates(named, self._services)
        elif base.labels.get(f"{PREFIX}distribution") and not base.local:
            names = (f"{base.repository.rpartition('/')[0]}/{NAME}:latest",)
        if pin and (known := self._cached(pin)).is_dir():
            return known, pin
        with Registries(self._services.ca_bundle) as registries:
            for place in map(references.parse, names):
                wanted = place._replace(reference=pin or place.reference)
                try:
                    found = self._fetched(registries(place.host), wanted)
                except RosmlError as error:
                    if named or pin:
                        raise
                    self._say(f"no lists of rosdep beside the base image: {error.message}")
                    return None
                if found:
                    self._say(f"rosdep's lists {place}")
                    return found
        if named or pin:
            text = f"there are no lists of rosdep {pin or named}" + (
                f" (looked for {', '.join(names)})" if names else ""
            )
            text = text if pin else f"{TYPED} names {named}: {text}"
            raise RosmlError(text, "check the name; 'rosml publish rosdep' publishes them", exit_code=2)
        return None

    def _cached(self, digest: str) -> Path:
        return self._services.state / "cache" / NAME / digest.replace(":", "-")

    def _fetched(self, registry: Registry, place: references.Reference) -> tuple[Path, str] | None:
        """The lists at a place in a registry, unpacked; None if there are none. Lists of an earlier call are not fetched again."""
        manifest = registry.manifest(place.repository, place.reference)
        if manifest is None:
            return None
        layers = manifest.layers
        if manifest.artifact_type != TYPE or len(layers) != 1:
            text = f"{place} has no lists of rosdep"
            raise RosmlError(text, "name what 'rosml publish rosdep' published", exit_code=2)
        out = self._cached(manifest.digest)
        folder = out.parent
        if not out.is_dir():
            folder.mkdir(parents=True, exist_ok=True)
            old = sorted(folder.iterdir(), key=lambda path: path.stat().st_mtime)[: 1 - KEPT]
            new = Path(tempfile.mkdtemp(dir=folder))
            try:
                unpack(registry.part(place.repository, layers[0]), new, str(place))
                new.chmod(0o755)
                _move(new, out)
                for path in old:
                    shutil.rmtree(path, ignore_errors=True)
            finally:
                shutil.rmtree(new, ignore_errors=True)
        return out, manifest.digest


def _move(new: Path, out: Path) -> None:
    """Renames a folder, unless another call was faster."""
    try:
        new.rename(out)
    except OSError:
        if not out.is_dir():
            raise


def unpack(content: bytes, folder: Path, what: str) -> None:
    """Unpacks the lists into a folder.

    Args:
        what: the archive's name in messages.

    Raises:
        RosmlError: the archive is damaged or too large, or the disk is full.
    """
    room, files = LARGEST, FILES
    try:
        with tarfile.open(fileobj=io.BytesIO(content), mode="r:gz", tarinfo=archives.Entry) as tar:
            while member := tar.next():
                tar.members.clear()  # type: ignore[attr-defined] # tarfile would keep them all
                files -= 1
                if files < 0:
                    raise ValueError(f"it has more than {FILES:,} files")
                if tar.offset > LARGEST or member.size > LARGEST:
                    raise ValueError(f"it has more than {LARGEST >> 20} MiB")
                stream = tar.extractfile(member) if member.isreg() and _PATH.fullmatch(member.name) else None
                if stream:
                    room -= member.size
                    if room < 0:
                        raise ValueError(f"it has more than {LARGEST >> 20} MiB")
                    (folder / member.name).parent.mkdir(parents=True, exist_ok=True)
                    (folder / member.name).write_bytes(stream.read())
    except (tarfile.TarError, zlib.error, EOFError, OSError, ValueError, OverflowError) as error:
        remedy = "free some disk space, or publish it again"
        raise RosmlError(f"{what} cannot be unpacked: {error}", remedy) from None
