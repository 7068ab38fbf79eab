"""Computes the manifest and config of an image from a ROS image and parts, without a network.

The same inputs give the same bytes, on any machine and in any order: those of a build of the same target.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NoReturn

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.image_set import labels, restricted
from rosml.images.join import label_claims
from rosml.images.matrix import names
from rosml.images.matrix.combinations import Brought
from rosml.images.matrix.model import ANY_PYTHON
from rosml.images.matrix.tags import main_tag, spelled_tag
from rosml.registry import bases, documents, oci
from rosml.registry.oci import Config, Manifest

_LAYER = "application/vnd.oci.image.layer.v1.tar"
_OCI_LAYERS = {
    "application/vnd.docker.image.rootfs.diff.tar": _LAYER,
    "application/vnd.docker.image.rootfs.diff.tar.gzip": f"{_LAYER}+gzip",
    "application/vnd.docker.image.rootfs.diff.tar.zstd": f"{_LAYER}+zstd",
}
_DISTRIBUTION, _COMPONENT, _PYTHON, _ROS = (
    labels.PREFIX + name for name in ("distribution", "component", "python", "ros")
)
_PART, _STACK, _FRAMEWORK = (labels.PREFIX + name for name in ("part", "stack", "framework"))
_FRAMEWORKS = labels.PREFIX + "frameworks"


@dataclass(frozen=True)
class Source:
    """An image for one platform, as its registry holds it."""

    name: str  # the user's name of the image, for messages
    host: str
    repository: str
    digest: str
    manifest: Manifest
    config: Config
    annotations: Mapping[str, str] = field(default_factory=dict)  # of its entry in its index

    @property
    def platform(self) -> str:
        return platform(self.config.facts)

    @property
    def labels(self) -> Mapping[str, str]:
        return self.config.labels

    @property
    def layers(self) -> list[dict[str, Any]]:
        """Its layers, lowest first, with OCI's media types."""
        return [
            {"mediaType": _OCI_LAYERS.get(layer.mediaType, layer.mediaType), "digest": layer.digest, "size": layer.size}
            for layer in self.manifest.layers
        ]

    @property
    def diff_ids(self) -> list[str]:
        """Digests of its layers before they were compressed."""
        return self.config.diff_ids


@dataclass(frozen=True)
class Joined:
    """A joined image that is not in a registry yet."""

    platform: str  # such as `linux/arm64`
    config: bytes
    manifest: bytes
    labels: Mapping[str, str]
    layers: tuple[tuple[dict[str, Any], Source], ...]  # descriptors, with the image that each layer comes from
    environment: tuple[str, ...] = ()  # variables in the config, such as `PATH=/usr/bin`

    @property
    def digest(self) -> str:
        return oci.digest_of(self.manifest)


def as_source(image: Joined, ros: Source) -> Source:
    """A joined image that nobody pushed, as a source of another one. To `ros`, parts were joined."""
    content, config = untrusted.json_value(image.manifest), untrusted.json_value(image.config)
    manifest = Manifest(content, image.digest, oci.IMAGE, len(image.manifest))
    facts = documents.Config.model_validate(config)
    return Source(ros.name, ros.host, ros.repository, image.digest, manifest, Config(config, facts))


def platform(facts: Mapping[str, Any] | documents.Config | documents.Platform | None) -> str:
    """The platform of a config, or of an entry in an index; on arm64 without the variant."""
    fields = facts if isinstance(facts, Mapping) else vars(facts) if facts else {}
    variant = fields.get("variant")
    plain = f"{fields.get('os') or 'unknown'}/{fields.get('architecture') or 'unknown'}"
    return plain if not variant or plain == "linux/arm64" else f"{plain}/{variant}"


def join(ros: Source, parts: Sequence[Source]) -> Joined:
    """Joins a ROS image and parts, all for one platform. Onto an image that has parts go add-ons alone."""
    _require_ros(ros)
    for part in parts:
        _require_part(part)
    parts = sorted(parts, key=lambda item: (item.labels[_PART], item.name))
    for part in parts:
        _require_fit(ros, part)
    content = _content(ros, parts)
    parts = sorted(parts, key=lambda item: content.order.index(item.labels[_PART]))
    brought = _brought(parts)
    gpus = {name: text for part in parts for name, text in part.labels.items() if name.startswith(labels.GPU)}
    merged = _labels(ros, content, parts[0].labels[_STACK], brought) | gpus | _licensed((ros, *parts))
    facts = _config(ros, parts, brought, merged)
    config = oci.encoded(facts)
    layers = tuple((layer, source) for source in (ros, *parts) for layer in source.layers)
    manifest = {
        "schemaVersion": 2,
        "mediaType": oci.IMAGE,
        "config": oci.descriptor(oci.CONFIG, config),
        "layers": [layer for layer, _ in layers],
    }
    return Joined(ros.platform, config, oci.encoded(manifest), merged, layers, tuple(facts["config"]["Env"]))


# ---- What fits together ----------------------------------------------------------------------------------------------


def _require_ros(ros: Source) -> None:
    if ros.labels.get(_PART):
        text = f"{ros.name} is a part, but the first image must be a ROS image"
        raise RosmlError(text, "name the ROS image first, then the parts", exit_code=2)
    for label in (_DISTRIBUTION, _COMPONENT, _PYTHON, _ROS):
        if not ros.labels.get(label):
            text = f"{ros.name} is no ROS image of this project: it has no label {label}"
            raise RosmlError(text, "use an image from the repository ros, or one that was built on it", exit_code=2)
    if carried := ros.labels.get(labels.OWN):
        text = f"{ros.name} has CUDA or a framework from its base image: {carried}"
        raise RosmlError(text, "use it as it is; parts need a base image without these", exit_code=2)
    label_claims.require(ros.labels, ros.name)
    require_whole(ros)


def _require_part(part: Source) -> None:
    for label in (_PART, _STACK, _PYTHON):
        if not part.labels.get(label):
            kind = "a ROS image" if _DISTRIBUTION in part.labels else "no part"
            text = f"{part.name} is {kind}: it has no label {label}"
            remedy = "use a part from the repository part, made by this version or a later one"
            raise RosmlError(text, remedy, exit_code=2)
    label_claims.require(part.labels, part.name)
    require_whole(part)


def require_whole(source: Source) -> None:
    """Checks that an image has its layers, and that nothing runs in a build that starts from it."""
    if not source.layers or len(source.layers) != len(source.diff_ids):
        raise RosmlError(f"{source.name} is incomplete: its config does not list its layers", "push it again")
    bases.require_no_triggers(source.config.facts.config, source.name)


@dataclass(frozen=True)
class _Content:
    """What parts make together with the image to which they are joined."""

    framework: str
    addons: tuple[str, ...]  # of the joined image, sorted
    order: tuple[str, ...]  # the parts that are joined, in their order
    present: tuple[str, ...] = ()  # the parts that the image has already, in their order


def _content(ros: Source, parts: Sequence[Source]) -> _Content:
    by_kind = _by_kind(ros, parts)
    adding = _addons(parts)
    explained = dict.fromkeys(kind for kinds in adding.values() for kind in kinds)
    if ros.labels.get(_STACK):
        return _onto(ros, by_kind, adding, explained)
    shared = _shared(parts)
    exact = next(((name, kinds) for name, kinds in shared.items() if set(kinds) == set(by_kind)), None)
    if exact or not adding:
        framework, order = exact or _lacking(ros, parts, by_kind, shared)
        return _Content(framework, (), order)
    framework, order = ros.labels.get(_FRAMEWORK, names.NONE), tuple[str, ...]()
    if rest := [item for item in parts if item.labels[_PART] not in explained]:
        shared = _shared(rest)
        kinds_at_hand = {*by_kind, *explained}
        fits = ((name, kinds) for name, kinds in shared.items() if set(kinds) <= kinds_at_hand)
        framework, order = next(fits, None) or _lacking(ros, rest, by_kind, shared)
    order = tuple(dict.fromkeys([*order, *explained]))
    if missing := [kind for kind in order if kind not in by_kind]:
        raise _incomplete(ros, parts, missing, f"add-on {listed([*adding])}")
    return _Content(framework, tuple(adding), order)


def _onto(
    ros: Source, by_kind: Mapping[str, Source], adding: Mapping[str, Sequence[str]], explained: Iterable[str]
) -> _Content:
    """The content if add-ons are joined to an image that has parts."""
    present = tuple(ros.labels.get(labels.PARTS, "").split())
    if twice := [kind for kind in by_kind if kind in present]:
        text = f"{ros.name} has the {'part' if len(twice) == 1 else 'parts'} {listed(twice)} already"
        raise RosmlError(text, "leave them out" if twice[1:] else "leave it out", exit_code=2)
    order = [kind for kind in explained if kind not in present]
    if not present or [kind for kind in by_kind if kind not in order]:
        carried = f"framework {ros.labels.get(_FRAMEWORK)} of stack {ros.labels[_STACK]}"
        plain = f"the ROS image below it, ros:{main_tag(ros.labels[_DISTRIBUTION], ros.labels[_COMPONENT])}"
        if ros.labels.get(labels.APP):
            plain = "an image of the app without a framework"
        raise RosmlError(f"{ros.name} has {carried} already", f"take {plain}", exit_code=2)
    if missing := [kind for kind in order if kind not in by_kind]:
        raise _incomplete(ros, [*by_kind.values()], missing, f"add-on {listed([*adding])}")
    addons = ros.labels.get(labels.ADDONS, "").split()
    return _Content(ros.labels.get(_FRAMEWORK, names.NONE), tuple(sorted({*addons, *adding})), tuple(order), present)


def _by_kind(ros: Source, parts: Sequence[Source]) -> dict[str, Source]:
    """Parts by their names. They are of one stack, which is that of the image."""
    if not parts:
        raise RosmlError(f"there are no parts to join to {ros.name}", "name the parts after it", exit_code=2)
    stacks = {item.labels[_STACK]: item.name for item in (*parts, ros) if item.labels.get(_STACK)}
    if len(stacks) > 1:
        stack_names = listed([f"{name} is of stack {stack}" for stack, name in stacks.items()])
        raise RosmlError(f"an image carries one stack: {stack_names}", "use parts of one stack", exit_code=2)
    by_kind: dict[str, Source] = {}
    for item in parts:
        kind = item.labels[_PART]
        if kind in by_kind:
            text = f"part {kind} is there twice: {by_kind[kind].name} and {item.name}"
            raise RosmlError(text, "leave out one of them", exit_code=2)
        by_kind[kind] = item
    return by_kind


def _shared(parts: Sequence[Source]) -> dict[str, tuple[str, ...]]:
    """The frameworks that take all of some parts, the smallest first, with their parts."""
    combinations = [labels.combinations(item.labels.get(_FRAMEWORKS, "")) for item in parts]
    shared = {name: kinds for name, kinds in combinations[0].items() if all(name in other for other in combinations)}
    for name, kinds in shared.items():
        if any(other[name] != kinds for other in combinations):
            raise _apart(f"the parts are of different releases: they name different parts of framework {name}")
    return shared


def _addons(parts: Sequence[Source]) -> dict[str, tuple[str, ...]]:
    """The add-ons whose own parts are among some parts, by name, with their parts and those that these need."""
    addons: dict[str, tuple[str, ...]] = {}
    for item in parts:
        for name, kinds in labels.combinations(item.labels.get(labels.ADDONS, "")).items():
            if addons.setdefault(name, kinds) != kinds:
                raise _apart(f"the parts are of different releases: they name different parts of add-on {name}")
    return dict(sorted(addons.items()))


def _apart(text: str) -> RosmlError:
    return RosmlError(text, "use parts that were published together", exit_code=2)


def _lacking(
    ros: Source, parts: Sequence[Source], by_kind: Mapping[str, Source], shared: Mapping[str, tuple[str, ...]]
) -> NoReturn:
    """The error about parts that make no framework."""
    stack = parts[0].labels[_STACK]
    if not shared:
        text = f"no framework of stack {stack} takes {listed(sorted(by_kind))} together"
        raise RosmlError(text, "make an image for each of them", exit_code=2)
    name, kinds = min(shared.items(), key=lambda item: len(item[1]))
    missing = [kind for kind in kinds if kind not in by_kind]
    raise _incomplete(ros, parts, missing, f"framework {name} consists of {listed(kinds)}")


def _incomplete(ros: Source, parts: Sequence[Source], missing: Sequence[str], why: str) -> RosmlError:
    stack = parts[0].labels[_STACK]
    text = f"{listed([item.name for item in parts])} cannot do without {listed(missing)} of stack {stack}"
    claims = " ".join(item.labels.get(label, "") for item in parts for label in (_FRAMEWORKS, labels.ADDONS))
    pythons = {kind: ANY_PYTHON if labels.any_python(claims, kind) else ros.labels[_PYTHON] for kind in missing}
    lacking = listed([names.part_name(kind, stack, python) for kind, python in pythons.items()])
    return RosmlError(text, f"add {lacking}: {why}", exit_code=2)


def _require_fit(ros: Source, part: Source) -> None:
    if part.platform != ros.platform:
        text = f"{part.name} is for {part.platform}, and {ros.name} for {ros.platform}"
        raise RosmlError(text, "use images for one platform", exit_code=2)
    python, ros_python = part.labels[_PYTHON], ros.labels[_PYTHON]
    if python not in (ANY_PYTHON, ros_python):
        name = names.part_name(part.labels[_PART], part.labels[_STACK], ros_python)
        text = f"{part.name} is for Python {python}, and {ros.name} has Python {ros_python}"
        raise RosmlError(text, f"use the part {name}", exit_code=2)


def _brought(parts: Sequence[Source]) -> tuple[Brought, ...]:
    """What parts bring, without duplicates: releases first, then facts of the stack."""
    software: dict[str, tuple[Brought, str]] = {}
    for part in parts:
        for item in labels.brought_by(part.labels):
            first, first_part = software.setdefault(item.name, (item, part.name))
            if first.version != item.version:
                raise _apart(f"{first_part} has {item.name} {first.version}, and {part.name} has {item.version}")
            if item.title:
                software[item.name] = (item, part.name)
    return tuple(sorted((item for item, _ in software.values()), key=lambda item: not item.released))


# ---- The result ------------------------------------------------------------------------------------------------------


def _labels(ros: Source, content: _Content, stack: str, brought: Sequence[Brought]) -> dict[str, str]:
    place = ros.labels[_DISTRIBUTION], ros.labels[_COMPONENT], ros.labels[_ROS]
    titles = labels.about_image(labels.ImageKind(*place, content.framework, stack, content.addons), brought)
    if content.present:
        before = labels.without_environments(ros.labels)
        titles[labels.VERSION] = spelled_tag(before.get(labels.VERSION, ""), labels.spelled(brought))
        software = [f"{item.title} {item.version}" for item in brought if item.title]
        titles[labels.DESCRIPTION] = ", ".join([before.get(labels.DESCRIPTION, ""), *software])
    if environments := ros.labels.get(labels.ENVIRONMENTS, "").split():
        titles |= labels.with_environments(titles, (), environments)
    if ros.labels.get(labels.APP):
        titles[labels.TITLE] = ros.labels.get(labels.TITLE, "")
    versions = {labels.PREFIX + item.name: item.version for item in brought}
    parts = {labels.PARTS: " ".join([*content.present, *content.order])}
    addons = {labels.ADDONS: " ".join(content.addons)} if content.addons else {}
    return {**ros.labels, **titles, _FRAMEWORK: content.framework, _STACK: stack, **versions, **parts, **addons}


def _licensed(sources: Sequence[Source]) -> dict[str, str]:
    """The labels about licences of an image of these sources."""
    licences = [source.labels.get(labels.LICENSES, "") for source in sources]
    return labels.together(licences, [name for source in sources for name in restricted.parts_of(source.labels)])


def _config(
    ros: Source, parts: Sequence[Source], brought: Sequence[Brought], merged: Mapping[str, str]
) -> dict[str, Any]:
    config = copy.deepcopy(ros.config.content)
    inner = config["config"] = config.get("config") or {}
    environment = labels.environment(brought)
    kept = [entry for entry in ros.config.environment if entry.partition("=")[0] not in environment]
    inner["Env"] = [*kept, *(f"{name}={value}" for name, value in environment.items())]
    inner["Labels"] = dict(merged)
    config["rootfs"] = (config.get("rootfs") or {"type": "layers"}) | {
        "diff_ids": [digest for source in (ros, *parts) for digest in source.diff_ids]
    }
    if config.get("history"):  # either every layer has an entry, or there is no history
        steps = [entry for entry in config["history"] if not _is_argument(entry)]
        config["history"] = [*steps, *(entry for part in parts for entry in _history(config, part))]
    return config


def _is_argument(entry: Mapping[str, Any]) -> bool:
    """Whether an entry of the history is a build's argument. The steps after it repeat it, and each image would again."""
    return bool(entry.get("empty_layer")) and str(entry.get("created_by")).startswith("ARG ")


def _history(config: Mapping[str, Any], part: Source) -> list[dict[str, Any]]:
    kind, stack, python = (part.labels[name] for name in (_PART, _STACK, _PYTHON))
    entry = {
        "created_by": f"COPY --link --from=part:{names.part_name(kind, stack, python)} / /",
        "comment": "joined in the registry",
        **({"created": config["created"]} if "created" in config else {}),
    }
    return [entry] * len(part.diff_ids)
