"""rosdep's lists of one day as an artifact in a registry: files of ros/rosdistro, for builds that ask no other server."""

from __future__ import annotations

import contextlib
import gzip
import io
import re
import shutil
import tarfile
import tempfile
import zlib
from collections.abc import Callable, Iterable, Iterator
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
"""For messages. `rosml dev` takes only the variable."""

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
    model_config = ConfigDict(strict=True)

    distributions: dict[str, _Distribution]


@contextlib.contextmanager
def checkout(folder: Path | None) -> Iterator[Path]:
    """A checkout of ros/rosdistro: this folder, or a new clone."""
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
    """The files of a checkout that rosdep reads."""
    lists = sorted(path.name for path in checkout.glob("rosdep/*.yaml"))
    try:
        index = _Index.model_validate(untrusted.yaml_of((checkout / INDEX).read_bytes(), INDEX))
        distributions = {name for facts in index.distributions.values() for name in facts.distribution}
    except (OSError, RosmlError, ValidationError):
        distributions = set()
    if not lists or not distributions:
        raise RosmlError(f"{checkout} is no checkout of ros/rosdistro", "clone it, and name its folder", exit_code=2)
    for name in [INDEX, *(f"rosdep/{name}" for name in lists), *sorted(distributions)]:
        if not _PATH.fullmatch(name) or not within.exists(checkout / name, checkout):
            raise RosmlError(f"{checkout} has no {name} that can be published", "clone it whole", exit_code=2)
        yield name


def copied(folder: Path, out: Path) -> Path:
    """Copies the files of a checkout that rosdep may read, without git's folder, which differs between clones."""
    shutil.rmtree(out, ignore_errors=True)
    paths = [path for pattern in ("*.yaml", "*/*.yaml") for path in folder.glob(pattern) if within.exists(path, folder)]
    if not any(path.parent.name == NAME for path in paths):
        text = f"{TYPED} names {folder}, which has no rosdep/*.yaml"
        raise RosmlError(text, "name a checkout of ros/rosdistro", exit_code=2)
    for path in paths:
        target = out / path.relative_to(folder)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)
    return out


def packed(checkout: Path) -> bytes:
    """The lists of a checkout in one file. The same lists give the same bytes."""
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
    """Pushes the lists of a checkout with some tags. Returns their digest."""
    content = packed(checkout)
    digests = [registry.put_artifact(repository, tag, TYPE, content, LAYER) for tag in tags]
    return digests[0]


class Finder:
    """Finds the lists for a build of a folder."""

    def __init__(self, services: Services, folder: Path, say: Callable[[str], object]) -> None:
        self._services, self._folder, self._say = services, folder, say

    def find(self, name: str, base: app_base.Base, pin: str, locked: bool) -> tuple[Path, str] | None:
        """A folder with the lists, and their digest if they are from a registry.

        Args:
            name: of a checkout, or of lists in a registry; if empty, the newest beside one of our base images.
            pin: the digest in the lock file, if any.
            locked: whether there is a lock file.
        """
        folder = Path.home() / name[2:] if name.startswith("~/") else self._folder / name
        if name and folder.is_dir():
            return folder, ""
        if name and not re.search("[:@]", name):
            text = f"{TYPED} names {name}: there is no folder {folder}"
            raise RosmlError(text, "name a checkout of ros/rosdistro, or what a registry has, with its tag", 2)
        if locked and not pin:
            if name:
                raise RosmlError("the lock file has no lists of rosdep", lock.RENEW, exit_code=2)
            return None
        if pin and (cached := self._cached(pin)).is_dir():
            return cached, pin
        places = self._references(name, base)
        try:
            if lists := self._first(places, pin):
                return lists
        except RosmlError as error:
            if name or pin:
                raise
            self._say(f"no lists of rosdep beside the base image: {error.message}")
            return None
        if not (name or pin):
            return None
        before, looked = (
            "" if pin else f"{TYPED} names {name}: ",
            f" (looked for {', '.join(places)})" if places else "",
        )
        text = f"{before}there are no lists of rosdep {pin or name}{looked}"
        raise RosmlError(text, "check the name; 'rosml publish rosdep' publishes them", exit_code=2)

    def _references(self, name: str, base: app_base.Base) -> tuple[str, ...]:
        """Where the lists may be, the likeliest first."""
        if name:
            return app_base.candidates(name, self._services)
        if base.local or not base.labels.get(f"{PREFIX}distribution"):
            return ()
        return (f"{base.repository.rpartition('/')[0]}/{NAME}:latest",)

    def _first(self, names: Iterable[str], pin: str) -> tuple[Path, str] | None:
        """The first lists that a registry has, with the pinned digest if there is one."""
        with Registries(self._services.ca_bundle) as registries:
            for place in map(references.parse, names):
                pinned = place._replace(reference=pin or place.reference)
                if lists := self._fetched(registries(place.host), pinned):
                    self._say(f"rosdep's lists {place}")
                    return lists
        return None

    def _cached(self, digest: str) -> Path:
        return self._services.state / "cache" / NAME / digest.replace(":", "-")

    def _fetched(self, registry: Registry, place: references.Reference) -> tuple[Path, str] | None:
        """The lists at a place in a registry, unpacked, unless an earlier call has done that."""
        manifest = registry.manifest(place.repository, place.reference)
        if manifest is None:
            return None
        layers = manifest.layers
        if manifest.artifact_type != TYPE or len(layers) != 1:
            text = f"{place} has no lists of rosdep"
            raise RosmlError(text, "name what 'rosml publish rosdep' published", exit_code=2)
        out = self._cached(manifest.digest)
        if not out.is_dir():
            out.parent.mkdir(parents=True, exist_ok=True)
            oldest = sorted(out.parent.iterdir(), key=lambda path: path.stat().st_mtime)[: 1 - KEPT]
            new = Path(tempfile.mkdtemp(dir=out.parent))
            try:
                unpack(registry.part(place.repository, layers[0]), new, str(place))
                new.chmod(0o755)
                new.rename(out)
            except OSError:
                if not out.is_dir():  # otherwise another call was faster
                    raise
            finally:
                shutil.rmtree(new, ignore_errors=True)
            for path in oldest:
                shutil.rmtree(path, ignore_errors=True)
        return out, manifest.digest


def unpack(content: bytes, folder: Path, what: str) -> None:
    """Unpacks the lists into a folder. A link, or a name that leads out of it, is left out."""
    room, count = LARGEST, FILES
    try:
        with tarfile.open(fileobj=io.BytesIO(content), mode="r:gz", tarinfo=archives.Entry) as tar:
            while member := tar.next():
                tar.members.clear()  # type: ignore[attr-defined] # tarfile would keep them all
                count -= 1
                if count < 0:
                    raise ValueError(f"it has more than {FILES:,} files")
                takes = member.isreg() and _PATH.fullmatch(member.name) is not None
                room -= member.size if takes else 0
                if tar.offset > LARGEST or member.size > LARGEST or room < 0:
                    raise ValueError(f"it has more than {LARGEST >> 20} MiB")
                if takes and (stream := tar.extractfile(member)):
                    (folder / member.name).parent.mkdir(parents=True, exist_ok=True)
                    (folder / member.name).write_bytes(stream.read())
    except (tarfile.TarError, zlib.error, EOFError, OSError, ValueError, OverflowError) as error:
        remedy = "free some disk space, or publish it again"
        raise RosmlError(f"{what} cannot be unpacked: {error}", remedy) from None
