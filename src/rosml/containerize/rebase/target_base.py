"""The base image onto which an app moves, and how the app's labels name it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from rosml.base.errors import RosmlError
from rosml.containerize import lock
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import Base
from rosml.containerize.names import SLIM
from rosml.containerize.rebase import image
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME, LOCK
from rosml.images.join.layers import Source
from rosml.images.matrix.tags import DATED
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry


@dataclass(frozen=True)
class TargetBase:
    """A new base image. `with_compilers` is the image that the user named, in the user's `spelling`; a slim app goes onto `image`."""

    image: Base
    with_compilers: Base
    spelling: str


@dataclass
class TargetBases:
    """Finds base images, each once. Safe to share among threads."""

    services: Services
    registries: Callable[[str], Registry]
    say: Callable[[str], None]
    _bases: dict[tuple[str, tuple[str, ...], bool, bool], TargetBase] = field(default_factory=dict)
    _digests: dict[str, str] = field(default_factory=dict)

    def find(self, text: str, platforms: tuple[str, ...], app: Source) -> TargetBase:
        """Finds a base image by a name that `rosml containerize` takes; without one the app's own, where its tag is now."""
        base_name = text or app.labels.get(BASE_NAME, "")
        if not base_name:
            raise RosmlError(f"{app.name} does not say which base image it is on", "name one with --base", 2)
        key = base_name, platforms, app.labels.get(APP) == SLIM, bool(text)
        if key not in self._bases:
            self._bases[key] = self._find(*key)
        return self._bases[key]

    def _find(self, base_name: str, platforms: tuple[str, ...], slim: bool, is_new: bool) -> TargetBase:
        name, digest = split_pin(base_name)
        base = with_compilers = self._read(name, digest, platforms)
        if slim and (runtime := app_base.runtime(with_compilers)):
            if digest:
                text = f"{base_name} has compilers, and its digest does not say which image without them the slim image was on"
                raise RosmlError(text, f"name that one, with its digest: {runtime}@sha256:…", exit_code=2)
            self.say(f"{base_name} has compilers: the slim image goes onto {runtime}")
            base = app_base.find(runtime, self.services, platforms)
        if base.local:
            raise RosmlError(f"{base_name} is in your Docker, and in no registry", "push it, and name it there", 2)
        if not is_new and (DATED.search(name) or "@" in name):
            self.say(
                f"{base_name} never moves, and apps that name it as their base image stay; give them another as base"
            )
        elif "@" in name:
            self.say(
                f"{base_name} has no tag, so the app stays there; to follow one, name it as well: NAME:TAG@sha256:…"
            )
        return TargetBase(base, with_compilers, name if is_new else "")

    def _read(self, name: str, digest: str, platforms: tuple[str, ...]) -> Base:
        try:
            return app_base.find(name, self.services, platforms, digest)
        except RosmlError as error:
            if digest and error.remedy == lock.RENEW:  # no lock file is read here
                raise app_base.without_digest(f"{name}@{digest}", self.services) from None
            raise

    def labels(self, app: Source, target: TargetBase, parts: Mapping[str, str]) -> dict[str, str]:
        """The labels of an app about its new base image and the parts of its add-ons, as a build would write them."""
        labels = {BASE_NAME: target.image.name, BASE_DIGEST: target.image.digest}
        app_lock = image.lock_of(app)
        if app_lock is None:
            return labels
        main, slim = app_lock.base_image, app_lock.slim_base_image
        if app.labels.get(APP) != SLIM:
            main = lock.Image(name=self._spelled(main.name, target), digest=target.image.digest)
            slim = slim and self._renewed(slim, slim.name or app_base.runtime(target.image))
        elif target.with_compilers is not target.image:
            main = lock.Image(name=self._spelled(main.name, target), digest=target.with_compilers.digest)
            slim = slim and slim.model_copy(update={"digest": target.image.digest})
        else:
            main = self._renewed(main, main.name)
            slim = slim and lock.Image(name=slim.name and self._spelled(slim.name, target), digest=target.image.digest)
        pinned_parts = {name: reference.rpartition("@")[2] for name, reference in parts.items()} or None
        pins = {"base_image": main, "slim_base_image": slim, "addons": pinned_parts}
        return labels | {LOCK: app_lock.model_copy(update=pins).line()}

    def _spelled(self, locked_name: str, target: TargetBase) -> str:
        """A base image's name for a lock: as the app's lock spells the same tag, or else as the user wrote it."""
        has_tag = ":" in locked_name.rpartition("/")[2] and "@" not in locked_name
        same = has_tag and target.with_compilers.name in app_base.candidates(locked_name, self.services)
        return locked_name if same or not target.spelling else target.spelling

    def _renewed(self, pin: lock.Image, name: str) -> lock.Image:
        """The pin of another base image, as a build would find it now; as it was if there is none."""
        if name not in self._digests:
            self._digests[name] = self._present_digest(name)
        return pin.model_copy(update={"digest": self._digests[name] or pin.digest})

    def _present_digest(self, name: str) -> str:
        for reference in app_base.candidates(name, self.services) if name else ():
            where = references.parse(reference)
            with contextlib.suppress(RosmlError):
                if digest := self.registries(where.host).head(where.repository, where.reference):
                    return digest
        return ""


def split_pin(text: str) -> tuple[str, str]:
    """The name and the digest of `NAME:TAG@DIGEST`. A name with a digest and no tag stays whole, and the digest is empty."""
    name, _, digest = text.partition("@")
    return (name, digest) if references.is_digest(digest) and ":" in name.rpartition("/")[2] else (text, "")
