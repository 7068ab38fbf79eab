"""Add-ons and environments on the base image of an app: `containerize --addons onnx --env lerobot` joins them to it in the build."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from rosml import MATRIX
from rosml.base.errors import RosmlError
from rosml.containerize import lock
from rosml.containerize.base_image.base import AddOns, Base
from rosml.images.builds.base_images import native_architecture
from rosml.images.image_set import addons as image_addons
from rosml.images.image_set import labels
from rosml.images.image_set.load import without_locks
from rosml.images.image_set.model import ENVIRONMENTS, PARTS
from rosml.images.join import label_claims, short_names
from rosml.images.join.environments import misfit
from rosml.images.join.joiner import Joiner
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.matrix import combinations, extends, names
from rosml.images.matrix.model import ANY_PYTHON, Matrix
from rosml.images.matrix.patterns import NAME
from rosml.images.matrix.validate import validate
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import references
from rosml.registry.client import Registries
from rosml.registry.failures import Busy

_STACK, _PYTHON, _FRAMEWORK = (labels.PREFIX + name for name in ("stack", "python", "framework"))
_DISTRIBUTION, _COMPONENT = (labels.PREFIX + name for name in ("distribution", "component"))

OTHER_BASE = "name another base image"
"""The remedy for a base image with damaged labels."""

PAGE = "docs/addons.md"


def names_in(text: str) -> list[str]:
    """The names of add-ons in a text, separated by commas or blanks."""
    addons = list(dict.fromkeys(re.findall(r"[^,\s]+", text)))
    if wrong := next((name for name in addons if len(name) > label_claims.LONGEST or not re.fullmatch(NAME, name)), ""):
        raise RosmlError(f"addons: {wrong[:60]!r} is no name", "name add-ons such as onnx", exit_code=2)
    return addons


def onto(
    base: Base,
    text: str,
    services: Services,
    platforms: Sequence[str],
    locked: Mapping[str, str] | None = None,
    environments: str = "",
) -> Base:
    """A base image with the add-ons of a text, and with environments.

    Args:
        locked: digests of parts and environments, by their names with a tag; None for the present ones.
        environments: their names, separated by commas or blanks.
    """
    addons, environment_names = (
        names_in(text),
        [*dict.fromkeys(map(short_names.require, re.findall(r"[^,\s]+", environments)))],
    )
    if not addons and not environment_names:
        return base
    _require_ours(base)
    with Registries(services.ca_bundle) as registries, Transfer(registries) as transfer:
        search = _Search(transfer, services, base, locked)
        parts = search.parts(addons) | search.environments(environment_names)
        if not parts:  # the base image has them
            return base
        every = dict.fromkeys([*platforms, f"linux/{native_architecture()}"])  # some steps run on the builder's own
        with Joiner(registries, unlisted=_by_join(base, parts)) as joiner:
            joined = joiner.check(_in_full(base), list(parts.values()), [*every])
    first = next(iter(joined.values()))
    order = dict.fromkeys(source.name for _, source in first.layers if source.name in parts.values())
    by_reference = {reference: name for name, reference in parts.items()}
    environment = dict(item.partition("=")[::2] for item in first.environment)
    return replace(
        base,
        addons=AddOns(
            parts={by_reference[reference]: reference for reference in order},
            environment=_changed(base.environment, environment),
            labels=_changed(base.labels, first.labels),
        ),
    )


def differing(base: Base, main: Base, environments: Iterable[str], services: Services) -> str:
    """Why environments that a base image got are not those that another one has, by their layers; empty if they are."""
    parts = base.addons.parts if base.addons else {}
    with Registries(services.ca_bundle) as registries, Transfer(registries) as transfer:
        layers = {digest for image in transfer.platforms(_in_full(main)).values() for digest in image.diff_ids}
        for name in environments:
            end = f"/{ENVIRONMENTS}:{names.environment_name(name, main.labels.get(_PYTHON, ''))}"
            reference = next((reference for tag, reference in parts.items() if tag.endswith(end)), "")
            if not reference or not layers.intersection(transfer.one(reference).diff_ids):
                return f"{main.name} has another environment {name} than {reference or 'its slim base image'}"
    return ""


def kept(
    transfer: Transfer,
    app: Mapping[str, str],
    base: Base,
    services: Services,
    stack: str = "",
    locked: Mapping[str, str] | None = None,
) -> dict[str, str]:
    """The parts that an app's add-ons need on another base image, and its environments, as `AddOns.parts`. They are those that are beside the
    base image now. An environment stays as it is if there is none that goes with the base image.

    Args:
        app: the labels of the app's image.
        stack: of the add-ons if the base image has none; empty for the app's.
        locked: the digests in the app's lock.
    """
    label_claims.require(app, "the app", "build it again")
    present = base.labels.get(labels.ADDONS, "").split()
    end = "" if base.labels.get(_STACK) else f"-{stack or app.get(_STACK, '')}"
    missing = [f"{name}{end}" for name in app.get(labels.ADDONS, "").split() if name not in present]
    environments = app.get(labels.ENVIRONMENTS, "").split()
    if missing or environments:
        _require_ours(base)
    search = _Search(transfer, services, base, None, "name another --base; or build the app again: ")
    return search.parts(missing) | search.kept_environments(environments, app.get(_PYTHON, ""), locked or {})


def _require_ours(base: Base) -> None:
    """Checks that a base image is one of rosml's in a registry, or was built on one."""
    if base.local:
        text = f"{base.name} is in Docker alone, and add-ons and environments go onto images in a registry"
        raise RosmlError(text, "push it, and name it with its registry", exit_code=2)
    if base.adopted or not base.labels.get(_PYTHON):
        ours = base.adopted.image.tags[0] if base.adopted else "an image of rosml, or one that was built on it"
        text = f"{base.name} is none of rosml's images, so it can have no add-on and no environment"
        raise RosmlError(text, f"take {ours}", exit_code=2)
    label_claims.require(base.labels, base.name, OTHER_BASE)


def _in_full(base: Base) -> str:
    return f"{base.name.partition('@')[0]}@{base.digest}"


def _changed(before: Mapping[str, str], after: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in after.items() if before.get(name) != value}


def repository(base: Base) -> str:
    """The repository of parts beside a base image."""
    return f"{_place(base)}/{PARTS}"


def _place(base: Base) -> str:
    """The registry and the path of a base image: for an app, those of its own base image."""
    label = f"{labels.OCI}base.name"
    name = base.labels.get(label, "") if base.labels.get(labels.APP) else ""
    try:
        where = references.parse(name or base.repository)
    except RosmlError:
        text = f"{base.name}: its label {label} is damaged: {name[:60]!r}"
        raise RosmlError(text, OTHER_BASE, exit_code=2) from None
    return short_names.beside(where.host, where.repository)


def _join_command(image: str, parts: Iterable[str], unlisted: bool) -> str:
    tag = f"{image.partition('@')[0]}-with-addons"
    return f"rosml join {image} {' '.join(parts)} --tag {tag}{' --allow-unlisted' if unlisted else ''}"


def _by_join(base: Base, parts: Iterable[str]) -> str:
    """How an image of somebody's own gets add-ons if it has no list of its files."""
    command = _join_command(base.name, parts, unlisted=True)
    is_app = bool(base.labels.get(labels.APP))
    way = "take the app's run image, built without --no-sbom" if is_app else f"add them in its Dockerfile ({PAGE})"
    return f"{way}; or join them without the list, and take the result as base image: {command}"


@dataclass(frozen=True)
class _Search:
    """Finds the parts of add-ons for a base image."""

    transfer: Transfer
    services: Services
    base: Base
    locked: Mapping[str, str] | None
    before: str = ""  # the beginning of a remedy with other add-ons

    def parts(self, addons: Iterable[str]) -> dict[str, str]:
        """References by digest of all parts that the base image lacks for add-ons, by their names with a tag."""
        present = self.base.labels.get(labels.ADDONS, "").split()
        end = f"-{self.base.labels.get(_STACK, '')}"
        return {
            tag: self._pinned(name, tag)
            for name in addons
            if name.removesuffix(end) not in present
            for tag in self._tags(self._main(name))
        }

    def environments(self, environments: Iterable[str]) -> dict[str, str]:
        """The same of environments that the base image lacks."""
        python, locked = self.base.labels[_PYTHON], self.locked or {}
        tags = {
            name: _locked(name, python, locked) or self._beside(name, python) for name in self._lacking(environments)
        }
        return {tag: self._environment(name, tag) for name, tag in tags.items()}

    def kept_environments(
        self, environments: Iterable[str], python: str, app_digests: Mapping[str, str]
    ) -> dict[str, str]:
        """The same of an app's environments. `app_digests` has their present digests, by their names with a tag."""
        return dict(self._kept_environment(name, python, app_digests) for name in self._lacking(environments))

    def _kept_environment(self, name: str, python: str, app_digests: Mapping[str, str]) -> tuple[str, str]:
        """The name with a tag of an environment, and its reference by digest: the one beside the base image, or else the app's present one."""
        candidates, missing = list[tuple[str, str]](), None
        try:
            tag = self._beside(name, python)
            candidates.append((tag, self._environment(name, tag)))
        except Busy:  # the one beside the base image may be another
            raise
        except RosmlError as error:
            missing = error
        if tag := _locked(name, python, app_digests):
            candidates.append((tag, f"{tag.rpartition(':')[0]}@{app_digests[tag]}"))
        fitting = next((pair for pair in candidates if self._fits(name, pair[1])), None)
        if fitting is None and missing:
            raise missing
        return fitting or candidates[0]  # a join says what it lacks

    def _lacking(self, environments: Iterable[str]) -> list[str]:
        present = self.base.labels.get(labels.ENVIRONMENTS, "").split()
        return [name for name in environments if name not in present]

    def _beside(self, name: str, python: str) -> str:
        """The name with a tag of an environment beside the base image, or in the local registry."""
        local = self.services.place if self.services.registry else ""
        return short_names.find(self.transfer, name, python, (_place(self.base), local)).partition("@")[0]

    def _environment(self, name: str, tag: str) -> str:
        """The reference by digest of an environment. A lock, or a tag that moved, may name something else."""
        reference = self._pinned(name, tag)
        short_names.require_environment(self.transfer.one(reference), name)
        return reference

    def _fits(self, name: str, environment: str) -> bool:
        """Whether an environment is still there, and takes what the base image has."""
        with contextlib.suppress(RosmlError):
            image = self.transfer.one(environment)
            short_names.require_environment(image, name)
            return not misfit(image.labels, self.base.labels, self.base.name)
        return False

    def _tags(self, main: Source) -> list[str]:
        """The parts that the base image lacks for an add-on, by its main part."""
        claim = main.labels.get(labels.ADDONS, "")
        if len(addons := labels.combinations(claim)) != 1:
            text = f"{main.name} is no add-on: its label {labels.ADDONS} does not name it"
            raise RosmlError(text, "name an add-on, such as onnx", exit_code=2)
        stack, present = main.labels.get(_STACK, ""), self.base.labels.get(labels.PARTS, "").split()
        pythons = {
            kind: ANY_PYTHON if labels.any_python(claim, kind) else self.base.labels[_PYTHON]
            for kinds in addons.values()
            for kind in kinds
            if kind not in present
        }
        return [f"{repository(self.base)}:{names.part_name(kind, stack, python)}" for kind, python in pythons.items()]

    def _main(self, name: str) -> Source:
        """The main part of an add-on: the last of its own parts, or one of its name if rosml does not have it."""
        stack, python = self.base.labels.get(_STACK, ""), f"py{self.base.labels[_PYTHON].replace('.', '')}"
        matrix = rosml_matrix()
        choice = image_addons.read(matrix, name)
        part = name
        if choice.addon:
            part = "-".join(filter(None, (matrix.addons[choice.addon].parts[-1], choice.stack)))
            self._require_system(choice)
        part = f"{part}-{stack}" if stack and not name.endswith(f"-{stack}") else part
        tags = [f"{repository(self.base)}:{tag}" for tag in (f"{part}-{python}", part)]
        for tag in tags:
            if manifest := self.transfer.manifest(references.parse(tag)):
                return _of_its_name(self.transfer.one(tag, manifest))
        raise self._missing(name, f"there is no add-on {name}: neither {tags[0]} nor {tags[1]}")

    def _pinned(self, name: str, tag: str) -> str:
        """The reference by digest of a part for an add-on."""
        place = references.parse(tag)
        digest = self.locked.get(tag, "") if self.locked else ""
        manifest = self.transfer.manifest(place._replace(reference=digest) if digest else place)
        if manifest is None and digest:
            raise RosmlError(f"there is no {tag} with the digest {digest} of the lock file", lock.RENEW, exit_code=2)
        if manifest is None:
            raise self._missing(name, f"there is no {tag}, which {name} needs")
        return f"{tag.rpartition(':')[0]}@{digest or manifest.digest}"

    def _onto(self) -> image_addons.Onto:
        texts = (self.base.labels.get(label, "") for label in (_DISTRIBUTION, _COMPONENT, _FRAMEWORK, _STACK))
        return image_addons.Onto(self.base.name, *texts)

    def _require_system(self, choice: image_addons.Wanted) -> None:
        """Checks that an add-on works on the base image's operating system: a part for any Python does not say that."""
        matrix, onto = rosml_matrix(), self._onto()
        stack = choice.stack or onto.stack
        if onto.exists_in(matrix) and (
            reason := combinations.system_reason(matrix, onto.distribution, stack, choice.addon)
        ):
            remedy = f"{self.before}{image_addons.instead(matrix, onto, choice.addon)}"
            raise RosmlError(reason, remedy, exit_code=2)

    def _missing(self, name: str, text: str) -> RosmlError:
        """The error about a part that is not there: a rule forbids it, or nobody has published it there."""
        matrix, onto = rosml_matrix(), self._onto()
        choice = image_addons.read(matrix, name)
        if refused := image_addons.refused(matrix, onto, name):
            if choice.addon:
                return RosmlError(refused.message, f"{self.before}{refused.remedy}", exit_code=2)
            return RosmlError(text, f"{refused.message}; {refused.remedy}; or publish its parts there", exit_code=2)
        if not onto.exists_in(matrix):
            return RosmlError(text, f"publish it there; '{PAGE}' has more", exit_code=2)
        present = self.base.labels.get(labels.PARTS, "").split()
        parts = image_addons.parts(matrix, onto.distribution, choice.addon, choice.stack or onto.stack, present)
        place, _, _ = repository(self.base).rpartition(f"/{PARTS}")
        host, _, namespace = place.partition("/")
        if host == self.services.registry and namespace:
            option = f" --namespace {namespace}" if namespace != NAMESPACE else ""
            return RosmlError(text, f"build it: rosml part {' '.join(parts)}{option}", exit_code=2)
        if self.transfer.registries(host).tags(f"{namespace}/{PARTS}".lstrip("/")):
            command = self._publish(place, choice.addon, parts)
            return RosmlError(text, f"publish it there, if that registry is yours: {command}", exit_code=2)
        image, unlisted = self.base.name.partition("@")[0], not self.base.labels.get(labels.APP)
        command = _join_command(image, (f"<registry>/{PARTS}:{part}" for part in parts), unlisted)
        remedy = f"join them from the registry of rosml's images: {command}; {PAGE} has more"
        return RosmlError(f"{text}; no parts are beside this image", remedy, exit_code=2)

    def _publish(self, place: str, addon: str, parts: Sequence[str]) -> str:
        """The command that publishes parts to the registry of the base image."""
        tests = (image for image in without_locks(MATRIX).images if image.addons == (addon,))
        target = next((image.target for image in tests if {*parts} <= {*image.parts}), self._onto().distribution)
        platforms = self.transfer.platforms(_in_full(self.base))
        architectures = rosml_matrix().architectures.items()
        served = [f"--serve {name}" for name, facts in architectures if facts.platform in platforms]
        return " ".join(["rosml publish all --registry", place, "--only", target, *served])


def _locked(environment: str, python: str, digests: Mapping[str, str]) -> str:
    """The name with a tag of an environment that a lock has; empty if it has none."""
    end = f"/{ENVIRONMENTS}:{names.environment_name(environment, python)}"
    return next((tag for tag in digests if tag.endswith(end)), "")


def _of_its_name(part: Source) -> Source:
    """Checks that a part is what its tag says."""
    label_claims.require(part.labels, part.name)
    claims = [part.labels.get(labels.PREFIX + name, "") for name in ("part", "stack", "python")]
    if names.part_name(*claims) != part.name.rpartition(":")[2]:
        text = f"{part.name} is no such part: its labels say {' '.join(filter(None, claims)) or 'nothing'}"
        raise RosmlError(text, "publish it again", exit_code=2)
    return part


@cache
def rosml_matrix() -> Matrix:
    """The matrix of this rosml, or of its set. It is read once: a fleet asks for every app."""
    return validate(extends.read(MATRIX))
