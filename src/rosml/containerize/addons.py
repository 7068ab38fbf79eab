"""Add-ons on the base image of an app: `containerize --addons onnx` joins their parts to it in the build."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache

from rosml import MATRIX
from rosml.base.errors import RosmlError
from rosml.base.problems import unknown
from rosml.containerize.app_base import AddOns, Base
from rosml.images.builds.base_images import native_architecture
from rosml.images.image_set import labels
from rosml.images.image_set.model import PARTS
from rosml.images.join.joiner import Joiner
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.matrix import extends, names
from rosml.images.matrix.model import ANY_PYTHON, NAME, Matrix
from rosml.images.matrix.validate import validate
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries

_ROW = f"{labels.PREFIX}distribution"
_STACK, _PYTHON = f"{labels.PREFIX}stack", f"{labels.PREFIX}python"


def onto(
    base: Base,
    named: str,
    services: Services,
    platforms: Sequence[str],
    locked: Mapping[str, str] | None = None,
) -> Base:
    """A base image with add-ons.

    Args:
        named: names of add-ons, separated by commas or blanks; with a stack if the base image has none: `onnx-cpu`.
        locked: digests of parts, by their names with a tag; None for the present ones.

    Raises:
        RosmlError: the base image is none of rosml's, there is no such add-on, or it does not fit (exit code 2); a registry does not
            answer or refuses.
    """
    wanted = list(dict.fromkeys(re.findall(r"[^,\s]+", named)))
    if not wanted:
        return base
    if wrong := next((name for name in wanted if not re.fullmatch(NAME, name)), ""):
        raise RosmlError(f"addons: {wrong!r} is no name", "name add-ons such as onnx", exit_code=2)
    if base.local or base.adopted or not base.labels.get(_PYTHON):
        what = "is in Docker alone" if base.local else "is none of rosml's images"
        raise RosmlError(f"{base.name} {what}, so no add-on fits it", "name another base image, in a registry", 2)
    with Registries(services.ca_bundle) as registries, Joiner(registries) as joiner, Transfer(registries) as transfer:
        parts = _parts(transfer, base, wanted, locked)
        if not parts:  # the base image has them
            return base
        every = dict.fromkeys([*platforms, f"linux/{native_architecture()}"])  # some steps run on the builder's own
        joined = joiner.check(base.reference, list(parts.values()), [*every])
    first = next(iter(joined.values()))
    order = [source.name for _, source in first.layers if source.name in parts.values()]
    by_reference = {reference: name for name, reference in parts.items()}
    known = dict(item.partition("=")[::2] for item in first.environment)
    return replace(
        base,
        addons=AddOns(
            parts={by_reference[reference]: reference for reference in dict.fromkeys(order)},
            environment=_changed(base.environment, known),
            labels=_changed(base.labels, first.labels),
        ),
    )


def kept(transfer: Transfer, app: Mapping[str, str], base: Base, stack: str = "") -> dict[str, str]:
    """The parts that an app's add-ons need on another base image, as `AddOns.parts`; none if that has all of them.

    Args:
        app: the labels of the app's image.
        stack: the stack of the add-ons, if the base image has none; the app's own if empty.

    Raises:
        RosmlError: an add-on is not there for the base image (exit code 2), or a registry does not answer or refuses.
    """
    there = base.labels.get(labels.ADDONS, "").split()
    end = "" if base.labels.get(_STACK) else f"-{stack or app.get(_STACK, '')}"
    own = [name for name in app.get(labels.ADDONS, "").split() if name not in there]
    if wrong := next((name for name in own if not re.fullmatch(NAME, name)), ""):
        raise RosmlError(
            f"the label {labels.ADDONS} of the app is damaged: {wrong[:60]!r}", "build it again", exit_code=2
        )
    return _parts(transfer, base, [f"{name}{end}" for name in own], None)


def _changed(old: Mapping[str, str], new: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in new.items() if old.get(name) != value}


def _parts(transfer: Transfer, base: Base, wanted: Iterable[str], locked: Mapping[str, str] | None) -> dict[str, str]:
    """References of all parts that a base image lacks for add-ons, by digest."""
    there = base.labels.get(labels.PARTS, "").split()
    found: dict[str, str] = {}
    for name in wanted:
        main = _main(transfer, base, name)
        stack, told = main.labels.get(_STACK, ""), main.labels.get(labels.ADDONS, "")
        try:
            [kinds] = labels.combinations(told).values()
        except ValueError:
            text = f"{main.name} is no add-on: its label {labels.ADDONS} does not name it"
            raise RosmlError(text, "name an add-on, such as onnx", exit_code=2) from None
        for kind in kinds:
            if kind not in there:
                python = ANY_PYTHON if labels.any_python(told, kind) else base.labels[_PYTHON]
                tag = f"{_repository(base)}:{names.part_name(kind, stack, python)}"
                found[tag] = _pinned(transfer, tag, locked)
    return found


def _repository(base: Base) -> str:
    """The repository of parts beside a base image: for an app, beside its own base image."""
    name = base.labels.get(f"{labels.OCI}base.name", "") if base.labels.get(labels.APP) else base.repository
    where = references.parse(name or base.repository)
    return f"{where.host}/{where.repository.rpartition('/')[0]}/{PARTS}".replace("//", "/")


def _main(transfer: Transfer, base: Base, name: str) -> Source:
    """The main part of an add-on: the last of its own parts, or one of its name if rosml does not have it."""
    stack, python = base.labels.get(_STACK, ""), f"py{base.labels[_PYTHON].replace('.', '')}"
    matrix = _matrix()
    known = {addon: facts.parts[-1] for addon, facts in matrix.addons.items()}
    addon = next((addon for addon in known if name == addon or name.startswith(f"{addon}-")), name)
    called = f"{known.get(addon, addon)}{name.removeprefix(addon)}"
    called = f"{called}-{stack}" if stack and not name.endswith(f"-{stack}") else called
    tags = [f"{_repository(base)}:{tag}" for tag in (f"{called}-{python}", called)]
    for tag in tags:
        where = references.parse(tag)
        if manifest := transfer.manifest(where):
            return next(iter(transfer.members(tag, where, manifest).values()))
    with_stack = any(called.endswith(f"-{item}") for item in matrix.stacks)
    if addon not in known:
        remedy = f"{unknown('add-on', name, known)}; or publish its parts there"
    elif not with_stack:
        remedy = f"{base.name} has no stack: name one, such as {name}-cpu"
    else:
        remedy = f"'rosml explain {base.labels.get(_ROW, '')}-core-{name}' says whether the stack has it; 'rosml part {called}-{python}' builds it"
    raise RosmlError(f"there is no add-on {called}: neither {tags[0]} nor {tags[1]}", remedy, exit_code=2)


@cache
def _matrix() -> Matrix:
    """The matrix of this rosml, or of its set. It is read once: a fleet asks for every app."""
    return validate(extends.read(MATRIX))


def _pinned(transfer: Transfer, tag: str, locked: Mapping[str, str] | None) -> str:
    where = references.parse(tag)
    digest = locked.get(tag, "") if locked else ""
    if not digest:
        found = transfer.manifest(where)
        if found is None:
            raise RosmlError(f"{tag} is not there", "publish it, or build it with 'rosml part'", exit_code=2)
        digest = found.digest
    return f"{tag.rpartition(':')[0]}@{digest}"
