"""Puts apps on other base images in a registry: pushes new manifests and configs for layers that are there, and pulls no layer.

The tag moves last. If a call is interrupted, the old tag stands, and the next call finds by digest what was pushed.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import SHOWN, listed, some
from rosml.containerize import lock
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import Base
from rosml.containerize.build.bake_file import BASE_DIGEST, BASE_NAME, LOCK
from rosml.containerize.names import SLIM
from rosml.containerize.rebase import attached as contents
from rosml.containerize.rebase import checks, image
from rosml.containerize.rebase.attached import Contents, Known
from rosml.containerize.rebase.checks import Judgement, Verdict
from rosml.containerize.rebase.trial import Pair
from rosml.images.image_set.labels import ADDONS, APP, GPU, PREFIX, TITLE
from rosml.images.join.layers import Joined, Source, as_source, join, platform
from rosml.images.join.transfer import Transfer, Transferred
from rosml.images.matrix.names import DATED
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference

OTHER_TAG = "name all its platforms, or none; or give this image a tag of its own with --tag"
"""The remedy if a tag would lose a platform."""


SIGNED = ("sigstore", "cosign", "notary")
"""Words in the types of artifacts that are signatures."""


@dataclass
class Rebased(Transferred):
    """An app on another base image.

    Attributes:
        app: the app's complete reference, as it was named.
        reference: the tag that points at the new image.
        digest: of the new image or index.
        before: the digest of the app's image until now.
        base: the new base image, with its registry and tag.
        base_digest: its digest.
        old_base: the base image until now, as the app names it.
        old_base_digest: its digest.
        back: the digest at which the tag was before, for `--back`; empty if there was no such tag.
        moved: whether the tag points elsewhere than before.
        verdict: what the facts of both base images say: `safe` or `check by link`; empty after `--back`.
        reasons: why.
        linked: whether it was linked in the builder.
    """

    app: str = ""
    reference: str = ""
    digest: str = ""
    before: str = ""
    base: str = ""
    base_digest: str = ""
    old_base: str = ""
    old_base_digest: str = ""
    back: str = ""
    moved: bool = False
    verdict: str = ""
    reasons: list[str] = field(default_factory=list)
    linked: bool = False

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


@dataclass(frozen=True)
class Plan:
    """A new image of an app that is in no registry yet.

    Attributes:
        app: the place of the app, by the digest that was read.
        named: the app's complete reference, as it was named.
        target: the tag to move.
        there: the digest of that tag when this was planned; empty if there was none.
        base: the new base image.
        images: the new image for each platform.
        old: the app's image for each platform.
        known: what is known of the new base image, for each platform.
        judgement: what the facts of both base images say.
        document: the manifest or the index to which the tag will point.
        is_index: whether it is an index.
    """

    app: Reference
    named: str
    target: Reference
    there: str
    base: Base
    images: Mapping[str, Joined]
    old: Mapping[str, Source]
    known: Mapping[str, Known]
    judgement: Judgement
    document: bytes
    is_index: bool

    @property
    def digest(self) -> str:
        """The digest of the new image."""
        return oci.digest_of(self.document)

    @property
    def result(self) -> Rebased:
        """What is known of the result before anything is pushed."""
        first = next(iter(self.old.values()))
        return Rebased(
            app=self.named,
            reference=str(self.target),
            digest=self.digest,
            before=self.app.reference,
            base=self.base.name,
            base_digest=self.base.digest,
            old_base=first.labels.get(BASE_NAME, ""),
            old_base_digest=first.labels.get(BASE_DIGEST, ""),
            back=self.there,
            verdict=self.judgement.words,
            reasons=[*self.judgement.reasons],
        )


@dataclass(frozen=True)
class _Onto:
    """A new base image.

    Attributes:
        base: the image itself.
        whole: the image with compilers that the user named, if `base` is the one without that belongs to it; else the same.
        text: as the user wrote it, without a digest that follows a tag; empty for the app's own.
    """

    base: Base
    whole: Base
    text: str


@dataclass
class Rebaser:
    """Puts apps on other base images. It reads each base image once. Safe to share among threads; use it in a `with`.

    Attributes:
        services: name the local registry, for names without a registry.
        registries: gives the client of a host.
        say: prints a line for people.
    """

    services: Services
    registries: Callable[[str], Registry]
    say: Callable[[str], None] = lambda _: None
    _bases: dict[tuple[str, tuple[str, ...], bool], _Onto] = field(default_factory=dict)
    _digests: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._transfer = Transfer(self.registries, self.say)
        self._contents = Contents(self._transfer)

    def __enter__(self) -> Rebaser:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self._transfer.close(failed)

    def plan(
        self,
        app: str,
        base: str,
        tag: str = "",
        platforms: Sequence[str] = (),
        extra: Mapping[str, str] | None = None,
        stack: str = "",
    ) -> Plan:
        """Computes the new image, and checks what speaks against it. It changes nothing.

        Args:
            app: the app, by any name that `rosml run` takes.
            base: the new base image, by any name that `rosml containerize` takes; empty for the app's own, where its tag is now.
            tag: the complete reference of the tag to move; empty for the app's own.
            platforms: only these; all of the app's if empty.
            extra: further labels.
            stack: the stack of the app's add-ons, if the base image has none; the app's own if empty.

        Raises:
            RosmlError: the app cannot be put on this base image (exit code 2), or a registry does not answer or refuses.
        """
        where, manifest = self._find(app)
        known = self._transfer.members(str(where), where, manifest)
        old = _chosen(known, platforms, str(where))
        for source in old.values():
            image.require_app(source)
        self._tell_left(str(where), manifest, known)
        target = references.parse(tag) if tag else where
        if references.is_digest(target.reference):
            what = "names the app by its digest" if not tag else "is a digest"
            raise RosmlError(f"{tag or app} {what}, and a tag has to move", "name one: --tag REGISTRY/NAME:TAG", 2)
        there = manifest.digest if target == where else self.registries(target.host).head(*target[1:])
        if there and (platforms or target != where):
            app_base.require_kept(self.registries, [str(target)], tuple(old), OTHER_TAG)
        _require_one_base(old, str(where))
        onto = self._base(base, tuple(old), next(iter(old.values())))
        found = onto.base
        if found.digest == manifest.digest:
            raise RosmlError(f"{where} is the app itself, and no base image for it", "name another one with --base", 2)
        place = references.parse(f"{found.repository}@{found.digest}")
        new = self._transfer.platforms(str(place))
        parts = addons.kept(self._transfer, next(iter(old.values())).labels, found, self.services, stack)
        added = [self._transfer.platforms(reference) for reference in parts.values()]
        images, bases, judgement = {}, {}, Judgement()
        more = extra or ({} if target == where else {image.VARIANTS: ""})  # the label names tags beside the app's own
        for name, source in old.items():
            checks.require_fit(source, new[name])
            joined = join(new[name], [_for(platforms, name, parts) for platforms in added]) if added else None
            below = as_source(joined, new[name]) if joined else new[name]
            images[name] = image.moved(source, below, self._labels(source, onto, parts) | dict(more))
            if joined:
                images[name] = replace(images[name], layers=(*joined.layers, images[name].layers[-1]))
            self._transfer.require_allowed(images[name].labels, str(target), target)
            bases[name] = self._judge(source, below, (str(place), *parts.values()), name, judgement)
        _require_no_build(judgement, str(where), found)
        if manifest.is_index:
            by_digest = {source.digest: images[name] for name, source in old.items()}
            document = image.index(manifest.content, by_digest)
        else:
            document = next(iter(images.values())).manifest
        own = where._replace(reference=manifest.digest)
        return Plan(own, str(where), target, there, found, images, old, bases, judgement, document, manifest.is_index)

    def _tell_left(self, name: str, manifest: oci.Manifest, known: Mapping[str, Source]) -> None:
        """Tells what of an app's index is not in the new one, such as attestations by buildx.

        Raises:
            RosmlError: it is an image of a platform that another one has as well (exit code 2).
        """
        left = {entry.digest: platform(entry.platform) for entry in manifest.members}
        for source in known.values():
            left.pop(source.digest, None)
        if twice := sorted(known.keys() & left.values()):
            text = f"{name} has two images for {twice[0]}, and nobody knows which one counts"
            raise RosmlError(text, "push its index again with one for each platform", exit_code=2)
        if left:
            self.say(f"{name}: attestations in its index are of the old image, and stay there ({len(left)})")

    def _judge(self, app: Source, base: Source, places: Sequence[str], platform: str, judgement: Judgement) -> Known:
        """Adds what the facts of both base images say for one platform. Gives what is known of the new one.

        Args:
            places: the references of the new base image, and of the parts that are joined to it.
        """
        below, submit = contents.base_of(app), self._transfer.pool.submit
        reading = [submit(self._contents.base, place, platform) for place in places]
        mine = submit(self._contents.own, app)
        before = submit(self._contents.facts, below, platform) if below else None
        own, known = mine.result(), contents.together([item.result() for item in reading])
        labels = app.labels, base.labels
        had = None
        try:
            had = before.result() if before else None
            whole = self._contents.member(below, platform)[0] if below else None  # read already
        except RosmlError as error:
            whole = None
            self.say(f"the base image until now cannot be read, so nobody compares with it: {error.message}")
        if whole:
            image.require_unaltered(app, whole)
        else:
            image.require_kept(app, base)
        found = checks.judge(own, had, known.facts, (known.files, known.folders), labels)
        for reason, verdict in found.reasons.items():
            judgement.add(verdict, reason)
        return known

    def driver(self, app: Source, base: str, platforms: tuple[str, ...], stack: str) -> str:
        """The oldest driver on which a base image with an app's add-ons runs, as its labels say; empty if it needs none.

        Raises:
            RosmlError: there is no such base image or add-on (exit code 2), or a registry does not answer or refuses.
        """
        found = app_base.find(base, self.services, platforms)
        parts = addons.kept(self._transfer, app.labels, found, self.services, stack)
        added = [self._transfer.one(name).labels for name in parts.values()]
        return next((text for labels in (found.labels, *added) if (text := labels.get(f"{GPU}driver", ""))), "")

    def push(self, plan: Plan, with_sbom: bool = True) -> Rebased:
        """Pushes the new image by its digest, with what is attached to it. No tag moves.

        Raises:
            RosmlError: a registry does not answer or refuses.
        """
        started = time.monotonic()
        found = plan.result
        host, repository, _ = plan.target
        for name, joined in plan.images.items():
            found.manifests[name] = self._transfer.push(joined, host, repository, found)
            app, base = plan.old[name], plan.known[name]
            found.uploaded += self._contents.attach(app, base, host, repository, joined.manifest, with_sbom)
        if self._is_signed(plan.app):
            self.say(f"{plan.named} is signed, and the new image is not: sign {host}/{repository}@{plan.digest}")
        found.seconds = time.monotonic() - started
        return found

    def _is_signed(self, app: Reference) -> bool:
        """Whether cosign or notation has signed an app."""
        registry = self.registries(app.host)
        kinds = [str(item.get("artifactType")) for item in registry.referrers(*app[1:])]
        known = any(word in kind for kind in kinds for word in SIGNED)
        return known or bool(registry.head(app.repository, f"{app.reference.replace(':', '-')}.sig"))

    def sbom(self, app: Source) -> bytes:
        """The SBOM that is attached to an app.

        Raises:
            RosmlError: there is none (exit code 2), or the registry does not answer or refuses.
        """
        return self._contents.sbom_of(app)

    def new_sbom(self, plan: Plan, platform: str) -> bytes:
        """The SBOM that the new image will have.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        return self._contents.sbom(plan.old[platform], plan.known[platform], f"{plan.target}@{plan.digest}")

    def pairs(self, plan: Plan) -> dict[str, Pair]:
        """The new and the old image for each platform, for a trial of what `push` has pushed."""
        new, old = (f"{where.host}/{where.repository}" for where in (plan.target, plan.app))
        return {
            name: Pair(f"{new}@{joined.digest}", f"{old}@{plan.old[name].digest}")
            for name, joined in plan.images.items()
        }

    def move(self, plan: Plan, found: Rebased, before: Iterable[str] = ()) -> None:
        """Moves the tag, if it is still where it was. Registries cannot compare and write at once: in between is one request.

        Args:
            before: further tags of the same repository, which move first.

        Raises:
            RosmlError: the tag has moved since the plan, and stays; a registry does not answer or refuses.
        """
        if plan.there == plan.digest:
            return
        started, registry = time.monotonic(), self.registries(plan.target.host)
        now = registry.head(*plan.target[1:])
        if now == plan.digest:
            return
        if now != plan.there:
            text = f"{plan.target} has moved since it was read, and stays: from {plan.there or 'nothing'} to {now or 'nothing'}"
            raise RosmlError(text, "somebody else moved it; if your app has to go there as well, run it again")
        kind = oci.INDEX if plan.is_index else oci.IMAGE
        for tag in (*before, plan.target.reference):
            registry.put_manifest(plan.target.repository, tag, plan.document, kind)
            found.uploaded += len(plan.document)
        found.moved = True
        found.seconds += time.monotonic() - started

    def back(self, app: str, digest: str, dry_run: bool = False) -> Rebased:
        """Points an app's tag at an earlier image of its repository again, whatever moved it.

        Args:
            app: the app by its tag, by any name that `rosml run` takes.
            digest: of the earlier image or index.
            dry_run: change nothing.

        Raises:
            RosmlError: the app is named by a digest, there is no such image, it is of another app, or the tag would lose a platform (exit
                code 2); a registry does not answer or refuses.
        """
        where, now = self._find(app)
        if references.is_digest(where.reference):
            raise RosmlError(f"{app} names the app by its digest, and a tag has to move", "name its tag", 2)
        if not references.is_digest(digest):
            raise RosmlError(f"--back {digest} is no digest", "copy it from the output: sha256:…", exit_code=2)
        registry, earlier = self.registries(where.host), where._replace(reference=digest)
        manifest = registry.manifest(*earlier[1:])
        if manifest is None:
            text = f"{where.host}/{where.repository} has no image {digest}"
            remedy = "check it; if the registry removed it, put the app on its earlier base image with --base"
            raise RosmlError(text, remedy, exit_code=2)
        present, images = (
            self._images(str(place), place, found) for place, found in ((where, now), (earlier, manifest))
        )
        if lost := sorted(present.keys() - images.keys()):
            raise RosmlError(
                f"{where} would lose {listed(lost)}: {digest} has not {some(lost)}", "name an index that has", 2
            )
        old, new = (next(iter(found.values())) for found in (present, images))
        if old.labels.get(TITLE) != new.labels.get(TITLE):
            text = f"{digest} is an image of {new.labels.get(TITLE) or 'no app'}, and {where} is one of {old.labels.get(TITLE) or 'no app'}"
            raise RosmlError(text, "name an earlier image of the same app", exit_code=2)
        if moves := now.digest != digest and not dry_run:
            registry.tag(where.repository, digest, where.reference)
        return Rebased(
            app=str(where),
            reference=str(where),
            digest=digest,
            before=now.digest,
            base=new.labels.get(BASE_NAME, ""),
            base_digest=new.labels.get(BASE_DIGEST, ""),
            old_base=old.labels.get(BASE_NAME, ""),
            old_base_digest=old.labels.get(BASE_DIGEST, ""),
            back=now.digest,
            moved=moves,
        )

    def _images(self, name: str, where: Reference, manifest: oci.Manifest) -> dict[str, Source]:
        """An app's image for each of its platforms.

        Raises:
            RosmlError: one is no app (exit code 2), or the registry does not answer or refuses.
        """
        found = _chosen(self._transfer.members(name, where, manifest), (), name)
        for source in found.values():
            image.require_app(source)
        return found

    # ---- Reading -----------------------------------------------------------------------------------------------------

    def where(self, text: str) -> Reference:
        """The place of an app, by any name that `rosml run` takes: of one without a registry, in the local registry if there is one.

        Raises:
            RosmlError: it is no name of an image (exit code 2).
        """
        if self.services.registry and not references.has_registry(text):
            return references.parse(f"{self.services.registry}/{text}")
        return references.parse(references.complete(text))

    def read(self, app: str) -> Mapping[str, Source]:
        """An app's image for each platform.

        Raises:
            RosmlError: there is no such image (exit code 2), or the registry does not answer or refuses.
        """
        return self._transfer.members(app, *self._find(app))

    def _find(self, text: str) -> tuple[Reference, oci.Manifest]:
        """An app's place and manifest.

        Raises:
            RosmlError: there is no such image (exit code 2), or the registry does not answer or refuses.
        """
        where = self.where(text)
        if manifest := self.registries(where.host).manifest(where.repository, where.reference):
            return where, manifest
        raise RosmlError(
            f"there is no app {text} in a registry{'' if text == str(where) else f' (looked for {where})'}",
            references.GONE
            if references.is_digest(where.reference)
            else "name it with its registry; an app in your Docker has to be pushed first",
            exit_code=2,
        )

    def _base(self, text: str, platforms: tuple[str, ...], app: Source) -> _Onto:
        """The new base image; for a slim app, the image without compilers that belongs to it."""
        slim = app.labels.get(APP) == SLIM
        named = text or app.labels.get(BASE_NAME, "")
        if not named:
            raise RosmlError(f"{app.name} does not say which base image it is on", "name one with --base", 2)
        key = named, platforms, slim
        if key not in self._bases:
            name, digest = pinned(named)
            whole = found = self._read_base(name, digest, platforms)
            if slim and (other := app_base.runtime(whole)):
                if digest:
                    text = f"{named} has compilers, and its digest does not say which image without them the slim image was on"
                    raise RosmlError(text, f"name that one, with its digest: {other}@sha256:…", exit_code=2)
                self.say(f"{named} has compilers: the slim image goes onto {other}")
                found = app_base.find(other, self.services, platforms)
            if found.local:
                raise RosmlError(f"{named} is in your Docker, and in no registry", "push it, and name it there", 2)
            if not text and (DATED.search(name) or "@" in name):
                self.say(
                    f"{named} never moves, and apps that name it as their base image stay; give them another as base"
                )
            elif "@" in name:
                self.say(
                    f"{text} has no tag, so the app stays there; to follow one, name it as well: NAME:TAG@sha256:…"
                )
            self._bases[key] = _Onto(found, whole, text and name)
        return self._bases[key]

    def _read_base(self, name: str, digest: str, platforms: tuple[str, ...]) -> Base:
        """A base image.

        Args:
            digest: its digest, wherever its tag is now; empty for where it is.

        Raises:
            RosmlError: there is no such image (exit code 2), or the registry does not answer or refuses.
        """
        try:
            return app_base.find(name, self.services, platforms, digest)
        except RosmlError as error:
            if digest and error.remedy == lock.RENEW:  # no lock file is read here
                raise app_base.without_digest(f"{name}@{digest}", self.services) from None
            raise

    def _spelled(self, known: str, onto: _Onto) -> str:
        """A base image's name for a lock: as the app's lock spells the same tag, or else as the user wrote it."""
        return known if not onto.text or self._same(known, onto.whole.name) else onto.text

    def _same(self, text: str, name: str) -> bool:
        """Whether a user's words for an image name this tag."""
        tagged = ":" in text.rpartition("/")[2] and "@" not in text
        return tagged and name in app_base.candidates(text, self.services)

    def _labels(self, app: Source, onto: _Onto, parts: Mapping[str, str]) -> dict[str, str]:
        """The labels of an app about its new base image, as a build on it would write them."""
        found = {BASE_NAME: onto.base.name, BASE_DIGEST: onto.base.digest}
        known = image.lock_of(app)
        if known is None:
            return found
        main, slim = known.base_image, known.slim_base_image
        if app.labels.get(APP) != SLIM:
            main = lock.Image(name=self._spelled(main.name, onto), digest=onto.base.digest)
            slim = slim and self._now(slim, slim.name or app_base.runtime(onto.base))
        elif onto.whole is not onto.base:
            main = lock.Image(name=self._spelled(main.name, onto), digest=onto.whole.digest)
            slim = slim and slim.model_copy(update={"digest": onto.base.digest})
        else:
            main = self._now(main, main.name)
            slim = slim and lock.Image(name=slim.name and self._spelled(slim.name, onto), digest=onto.base.digest)
        added = {name: reference.rpartition("@")[2] for name, reference in parts.items()} or None
        now = {"base_image": main, "slim_base_image": slim, "addons": added}
        return found | {LOCK: known.model_copy(update=now).line()}

    def _now(self, pin: lock.Image, name: str) -> lock.Image:
        """The pin of another base image, as a build would find it now; as it was if there is none."""
        if name not in self._digests:
            self._digests[name] = ""
            for reference in app_base.candidates(name, self.services) if name else ():
                where = references.parse(reference)
                with contextlib.suppress(RosmlError):
                    self._digests[name] = self.registries(where.host).head(where.repository, where.reference)
                if self._digests[name]:
                    break
        return pin.model_copy(update={"digest": self._digests[name] or pin.digest})


def _for(part: Mapping[str, Source], platform: str, named: Mapping[str, str]) -> Source:
    if platform in part:
        return part[platform]
    text = f"one of {listed([*named])} is not for {platform}"
    raise RosmlError(text, "name only the platforms that all of them have, with --platform", exit_code=2)


def pinned(text: str) -> tuple[str, str]:
    """The name and the digest of `NAME:TAG@DIGEST`. A name with a digest and no tag stays whole, and the digest is empty."""
    name, _, digest = text.partition("@")
    return (name, digest) if references.is_digest(digest) and ":" in name.rpartition("/")[2] else (text, "")


def _chosen(known: Mapping[str, Source], platforms: Sequence[str], name: str) -> dict[str, Source]:
    """An app's images for the wanted platforms.

    Raises:
        RosmlError: it is not for one of them (exit code 2).
    """
    if missing := [item for item in platforms if item not in known]:
        text = f"{name} is for {listed(sorted(known)) or 'no platform'}, not for {listed(missing)}"
        raise RosmlError(text, "name a platform that it has", exit_code=2)
    if not known:
        raise RosmlError(f"{name} is for no platform", "check its name", exit_code=2)
    return {item: known[item] for item in (platforms or known)}


def _require_one_base(old: Mapping[str, Source], name: str) -> None:
    """Checks that all platforms of an app are on the same image, of any day.

    Raises:
        RosmlError: they are not (exit code 2).
    """
    named = {key: DATED.sub("", source.labels.get(BASE_NAME, "")) for key, source in old.items()}
    content = {tuple(source.labels.get(label, "") for label in (f"{PREFIX}stack", ADDONS)) for source in old.values()}
    if len({*named.values()}) > 1 or len(content) > 1:
        where = listed([f"{key} on {base or 'an unknown one'}" for key, base in named.items()])
        text = f"{name}: its platforms are on different images: {where}"
        raise RosmlError(text, "name one platform with --platform, and a tag for it with --tag", exit_code=2)


def _require_no_build(judgement: Judgement, app: str, base: Base) -> None:
    """Checks that nothing speaks against the new base image.

    Raises:
        RosmlError: something does (exit code 2).
    """
    wrong = judgement.of(Verdict.BUILD)
    same = [line.removeprefix(checks.BOTH) for line in wrong if line.startswith(checks.BOTH)]
    if same and base.labels.get(APP):
        text = f"{base.name} is an app itself, and has files of {app}: /{some(same)}"
        below = base.labels.get(BASE_NAME, "")
        raise RosmlError(
            text, f"name the image below it: --base {below}" if below else "name another image", exit_code=2
        )
    if wrong:
        more = [f"and {len(wrong) - SHOWN} more reasons"] if len(wrong) > SHOWN else []
        lines = "".join(f"\n    {line}" for line in [*wrong[:SHOWN], *more])
        raise RosmlError(f"{app} does not go onto {base.name} without a build:{lines}", image.AGAIN, exit_code=2)
