"""Puts an app on another base image in a registry: pushes new manifests and configs for layers that are there, and pulls no layer. The
tag moves last. If a call is interrupted, the old tag stands, and the next call finds by digest what was pushed."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from rosml.base.errors import RosmlError
from rosml.base.problems import SHOWN, listed, some
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import Base
from rosml.containerize.rebase import attachments, compatibility, image
from rosml.containerize.rebase.attachments import Attachments, BaseContents
from rosml.containerize.rebase.compatibility import Judgement, Verdict
from rosml.containerize.rebase.plan import Member, Plan, Rebased
from rosml.containerize.rebase.target_base import TargetBase, TargetBases
from rosml.images.image_set.labels import (
    ADDONS,
    APP,
    BASE_DIGEST,
    BASE_NAME,
    ENVIRONMENT,
    ENVIRONMENTS,
    GPU,
    PREFIX,
    TITLE,
)
from rosml.images.join.environments import join, require_apart, require_packages
from rosml.images.join.layers import Joined, Source, as_source, platform
from rosml.images.join.transfer import Transfer
from rosml.images.matrix.tags import DATED
from rosml.images.records.store import CREATED
from rosml.images.scan import vex
from rosml.images.scan.vex import Statement
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest
from rosml.registry.references import Reference

OTHER_TAG = "name all its platforms, or none; or give this image a tag of its own with --tag"

SIGNED = ("sigstore", "cosign", "notary")
"""Words in the types of artifacts that are signatures."""


@dataclass(frozen=True)
class _Onto:
    """A new base image, by digest, and the parts of the app's add-ons and its environments, which are joined to it."""

    target: TargetBase
    place: str
    images: Mapping[str, Source]
    parts: Mapping[str, str]
    part_images: Sequence[Mapping[str, Source]]

    def joined(self, platform: str) -> Joined | None:
        if any(platform not in images for images in self.part_images):
            text = f"one of {listed([*self.parts])} is not for {platform}"
            raise RosmlError(text, "name only the platforms that all of them have, with --platform", exit_code=2)
        parts = [images[platform] for images in self.part_images]
        return join(self.images[platform], parts) if parts else None


class Rebaser:
    """Puts apps on other base images. It reads each base image once. Safe to share among threads; use it in a `with`."""

    def __init__(
        self, services: Services, registries: Callable[[str], Registry], say: Callable[[str], None] = lambda _: None
    ) -> None:
        self.services, self.registries, self.say = services, registries, say
        self._transfer = Transfer(registries, say)
        self.attachments = Attachments(self._transfer)
        self._bases = TargetBases(services, registries, say)
        self.require_apart = cache(self._require_apart)

    def __enter__(self) -> Rebaser:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self._transfer.close(failed)

    # ---- Planning ----------------------------------------------------------------------------------------------------

    def plan(
        self,
        app: str,
        base: str,
        tag: str = "",
        platforms: Sequence[str] = (),
        extra: Mapping[str, str] | None = None,
        stack: str = "",
    ) -> Plan:
        """Computes the new image, and checks what speaks against it. It changes nothing. Empty are: a `base` for the app's own, where its
        tag is now; a `tag`, `platforms` and `stack` (of add-ons, if the base image has none) for the app's own. `extra` are labels."""
        where, manifest = self._find(app)
        app_images = self._app_images(where, manifest, platforms)
        self._tell_left_behind(where, manifest)
        target = _target(app, tag, where)
        tag_digest = manifest.digest if target == where else self.registries(target.host).head(*target[1:])
        if tag_digest and (platforms or target != where):
            app_base.require_kept(self.registries, [str(target)], tuple(app_images), OTHER_TAG)
        _require_one_base(app_images, str(where))
        onto = self._onto(base, app_images, where, manifest, stack)
        labels = extra or ({} if target == where else {image.VARIANTS: ""})  # the label names tags beside the app's own
        moved = {name: self._moved(source, name, onto, labels, target) for name, source in app_images.items()}
        judgement = Judgement.of(reason for _, its in moved.values() for reason in its.reasons.items())
        _require_no_build(judgement, str(where), onto.target.image)
        members = {name: member for name, (member, _) in moved.items()}
        if manifest.is_index:
            document = image.index(manifest.content, {it.app.digest: it.image for it in members.values()})
        else:
            document = next(iter(members.values())).image.manifest
        return Plan(
            app=where._replace(reference=manifest.digest),
            app_name=str(where),
            target=target,
            tag_digest=tag_digest,
            base=onto.target.image,
            members=members,
            judgement=judgement,
            document=document,
            is_index=manifest.is_index,
        )

    def _tell_left_behind(self, where: Reference, manifest: Manifest) -> None:
        """Tells what of an app's index is not in the new one, and refuses two images of one platform."""
        by_platform = self._transfer.members(str(where), where, manifest)
        members = {entry.digest: platform(entry.platform) for entry in manifest.members}
        for source in by_platform.values():
            members.pop(source.digest, None)
        if twice := sorted(by_platform.keys() & members.values()):
            text = f"{where} has two images for {twice[0]}, and nobody knows which one counts"
            raise RosmlError(text, "push its index again with one for each platform", exit_code=2)
        if members:
            self.say(f"{where}: attestations in its index are of the old image, and stay there ({len(members)})")

    def _onto(
        self, base: str, app_images: Mapping[str, Source], where: Reference, manifest: Manifest, stack: str
    ) -> _Onto:
        app = next(iter(app_images.values()))
        target = self._bases.find(base, tuple(app_images), app)
        if target.image.digest == manifest.digest:
            raise RosmlError(f"{where} is the app itself, and no base image for it", "name another one with --base", 2)
        place = str(references.parse(f"{target.image.repository}@{target.image.digest}"))
        images = self._transfer.platforms(place)
        app_lock = image.lock_of(app)
        app_digests = (app_lock and app_lock.addons) or {}
        parts = addons.kept(self._transfer, app.labels, target.image, self.services, stack, app_digests)
        return _Onto(target, place, images, parts, [self._transfer.platforms(name) for name in parts.values()])

    def _moved(
        self, app: Source, platform: str, onto: _Onto, labels: Mapping[str, str], target: Reference
    ) -> tuple[Member, Judgement]:
        base = onto.images[platform]
        compatibility.require_fit(app, base)
        joined = onto.joined(platform)
        below = as_source(joined, base) if joined else base
        for name in onto.parts.values():
            others = (other for other in onto.parts.values() if other != name)
            self.require_apart(name, (onto.place, *others), platform)
        new = image.moved(app, below, self._bases.labels(app, onto.target, onto.parts) | dict(labels))
        if joined:
            new = replace(new, layers=(*joined.layers, new.layers[-1]))
        self._transfer.require_allowed(new.labels, str(target), target)
        contents, judgement = self._judge(app, below, (onto.place, *onto.parts.values()), platform)
        return Member(app, new, contents), judgement

    def _require_apart(self, part: str, places: tuple[str, ...], platform: str) -> None:
        """Checks the files of a part that is an environment beside a base image and other parts. For the same it is done once: many apps have
        them."""
        source, _ = self.attachments.member(part, platform)
        if source and source.labels.get(ENVIRONMENT):
            files, *others = (self.attachments.base(name, platform).files for name in (part, *places))
            require_apart(source, files, {places[0]: others[0]})
            require_packages(source, dict(zip(places, others, strict=True)))

    def _judge(self, app: Source, base: Source, places: Sequence[str], platform: str) -> tuple[BaseContents, Judgement]:
        old_base, submit = attachments.base_of(app), self._transfer.pool.submit
        reading = [submit(self.attachments.base, place, platform) for place in places]
        reading_app = submit(self.attachments.app_facts, app)
        reading_old = submit(self.attachments.base_facts, old_base, platform) if old_base else None
        app_facts, contents = reading_app.result(), attachments.together([item.result() for item in reading])
        old_facts = old_image = None
        try:
            if reading_old:
                old_facts = reading_old.result()
                old_image, _ = self.attachments.member(old_base, platform)  # read already
        except RosmlError as error:
            self.say(f"the base image until now cannot be read, so nobody compares with it: {error.message}")
        if old_image:
            image.require_unaltered(app, old_image)
        else:
            image.require_kept(app, base)
        return contents, compatibility.judge(app_facts, old_facts, contents, app.labels, base.labels)

    def driver(self, app: Source, base: str, platforms: tuple[str, ...], stack: str) -> str:
        """The oldest driver that a base image with an app's add-ons needs, as its labels say; empty if any does."""
        new_base = app_base.find(base, self.services, platforms)
        parts = addons.kept(self._transfer, app.labels, new_base, self.services, stack)
        labels = (new_base.labels, *(self._transfer.one(name).labels for name in parts.values()))
        return next((driver for item in labels if (driver := item.get(f"{GPU}driver", ""))), "")

    def new_sbom(self, plan: Plan, platform: str) -> bytes:
        member = plan.members[platform]
        return self.attachments.new_sbom(member.app, member.base, f"{plan.target}@{plan.digest}")

    # ---- Moving ------------------------------------------------------------------------------------------------------

    def push(self, plan: Plan, with_sbom: bool = True) -> Rebased:
        """Pushes the new image by its digest, with what is attached to it. No tag moves."""
        started = time.monotonic()
        rebased = plan.rebased
        host, repository, _ = plan.target
        for name, it in plan.members.items():
            rebased.manifests[name] = self._transfer.push(it.image, host, repository, rebased)
            rebased.uploaded += self.attachments.attach(it.app, it.base, host, repository, it.image.manifest, with_sbom)
        if self._is_signed(plan.app):
            self.say(f"{plan.app_name} is signed, and the new image is not: sign {host}/{repository}@{plan.digest}")
        return replace(rebased, seconds=time.monotonic() - started)

    def attach_vex(self, plan: Plan, statement: Statement, date: str) -> None:
        """Attaches what is said of a vulnerability to the images of a plan that were pushed."""
        host, repository, _ = plan.target
        for it in plan.members.values():
            subject = oci.descriptor(oci.IMAGE, it.image.manifest)
            data = vex.openvex(f"{host}/{repository}@{it.image.digest}", [statement], date)
            kind = vex.MEDIA_TYPE, data, vex.MEDIA_TYPE, {CREATED: date}
            self.registries(host).attach(repository, subject, *kind)

    def _is_signed(self, app: Reference) -> bool:
        registry = self.registries(app.host)
        kinds = [str(item.get("artifactType")) for item in registry.referrers(*app[1:])]
        is_attached = any(word in kind for kind in kinds for word in SIGNED)
        return is_attached or bool(registry.head(app.repository, f"{app.reference.replace(':', '-')}.sig"))

    def move(self, plan: Plan, rebased: Rebased, first_tags: Iterable[str] = ()) -> Rebased:
        """Moves the tag if it is still where it was. Registries cannot compare and write at once: in between is one request."""
        if plan.changes_nothing:
            return rebased
        started, registry = time.monotonic(), self.registries(plan.target.host)
        now = registry.head(*plan.target[1:])
        if now == plan.digest:
            return rebased
        if now != plan.tag_digest:
            text = f"{plan.target} has moved since it was read, and stays: from {plan.tag_digest or 'nothing'} to {now or 'nothing'}"
            raise RosmlError(text, "somebody else moved it; if your app has to go there as well, run it again")
        kind, tags = oci.INDEX if plan.is_index else oci.IMAGE, (*first_tags, plan.target.reference)
        for tag in tags:
            registry.put_manifest(plan.target.repository, tag, plan.document, kind)
        uploaded = rebased.uploaded + len(tags) * len(plan.document)
        return replace(rebased, moved=True, uploaded=uploaded, seconds=rebased.seconds + time.monotonic() - started)

    def back(self, app: str, digest: str, dry_run: bool = False) -> Rebased:
        """Points an app's tag at an earlier image or index of its repository again, whatever moved it."""
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
        images_now, images_then = self._app_images(where, now), self._app_images(earlier, manifest)
        if lost := sorted(images_now.keys() - images_then.keys()):
            text = f"{where} would lose {listed(lost)}: {digest} has not {some(lost)}"
            raise RosmlError(text, "name an index that has", exit_code=2)
        labels_now, labels_then = (next(iter(images.values())).labels for images in (images_now, images_then))
        title_now, title_then = labels_now.get(TITLE), labels_then.get(TITLE)
        if title_now != title_then:
            text = f"{digest} is an image of {title_then or 'no app'}, and {where} is one of {title_now or 'no app'}"
            raise RosmlError(text, "name an earlier image of the same app", exit_code=2)
        if moves := now.digest != digest and not dry_run:
            registry.tag(where.repository, digest, where.reference)
        return Rebased(
            app=str(where),
            reference=str(where),
            digest=digest,
            before=now.digest,
            base=labels_then.get(BASE_NAME, ""),
            base_digest=labels_then.get(BASE_DIGEST, ""),
            old_base=labels_now.get(BASE_NAME, ""),
            old_base_digest=labels_now.get(BASE_DIGEST, ""),
            back=now.digest,
            moved=moves,
        )

    # ---- Reading -----------------------------------------------------------------------------------------------------

    def where(self, text: str) -> Reference:
        """The place of an app, by any name that `rosml run` takes: of one without a registry, in the local registry if there is one."""
        if self.services.registry and not references.has_registry(text):
            return references.parse(f"{self.services.registry}/{text}")
        return references.parse(references.complete(text))

    def read(self, app: str) -> Mapping[str, Source]:
        return self._transfer.members(app, *self._find(app))

    def _find(self, text: str) -> tuple[Reference, Manifest]:
        where = self.where(text)
        if manifest := self.registries(where.host).manifest(where.repository, where.reference):
            return where, manifest
        searched = "" if text == str(where) else f" (looked for {where})"
        by_tag = "name it with its registry; an app in your Docker has to be pushed first"
        remedy = references.GONE if references.is_digest(where.reference) else by_tag
        raise RosmlError(f"there is no app {text} in a registry{searched}", remedy, exit_code=2)

    def _app_images(self, where: Reference, manifest: Manifest, platforms: Sequence[str] = ()) -> dict[str, Source]:
        images = self._transfer.members(str(where), where, manifest)
        if missing := [name for name in platforms if name not in images]:
            text = f"{where} is for {listed(sorted(images)) or 'no platform'}, not for {listed(missing)}"
            raise RosmlError(text, "name a platform that it has", exit_code=2)
        if not images:
            raise RosmlError(f"{where} is for no platform", "check its name", exit_code=2)
        chosen = {name: images[name] for name in (platforms or images)}
        for source in chosen.values():
            image.require_app(source)
        return chosen


def _target(app: str, tag: str, where: Reference) -> Reference:
    target = references.parse(tag) if tag else where
    if references.is_digest(target.reference):
        what = "is a digest" if tag else "names the app by its digest"
        raise RosmlError(f"{tag or app} {what}, and a tag has to move", "name one: --tag REGISTRY/NAME:TAG", 2)
    return target


def _require_one_base(app_images: Mapping[str, Source], app: str) -> None:
    """Checks that all platforms of an app are on the same image, of any day."""
    bases = {name: DATED.sub("", source.labels.get(BASE_NAME, "")) for name, source in app_images.items()}
    labels = (f"{PREFIX}stack", ADDONS, ENVIRONMENTS)
    contents = {tuple(source.labels.get(label, "") for label in labels) for source in app_images.values()}
    if len({*bases.values()}) > 1 or len(contents) > 1:
        places = listed([f"{name} on {base or 'an unknown one'}" for name, base in bases.items()])
        text = f"{app}: its platforms are on different images: {places}"
        raise RosmlError(text, "name one platform with --platform, and a tag for it with --tag", exit_code=2)


def _require_no_build(judgement: Judgement, app: str, base: Base) -> None:
    reasons = judgement.reasons_for(Verdict.BUILD)
    common_files = [line.removeprefix(compatibility.BOTH) for line in reasons if line.startswith(compatibility.BOTH)]
    if common_files and base.labels.get(APP):
        below = base.labels.get(BASE_NAME, "")
        remedy = f"name the image below it: --base {below}" if below else "name another image"
        text = f"{base.name} is an app itself, and has files of {app}: /{some(common_files)}"
        raise RosmlError(text, remedy, exit_code=2)
    if reasons:
        more = [f"and {len(reasons) - SHOWN} more reasons"] if len(reasons) > SHOWN else []
        lines = "".join(f"\n    {line}" for line in [*reasons[:SHOWN], *more])
        raise RosmlError(f"{app} does not go onto {base.name} without a build:{lines}", image.AGAIN, exit_code=2)
