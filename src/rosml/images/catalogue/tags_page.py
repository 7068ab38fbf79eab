"""Writes the tables of images into docs/tags.md, and that of licences into docs/licences.md, between two markers each."""

from __future__ import annotations

from collections.abc import Iterator

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.image_set import addons, missing_locks
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import combinations
from rosml.images.matrix.tags import main_tag

BEGIN = "<!-- images: written by rosml generate -->"
END = "<!-- /images -->"
BEGIN_LICENCES = "<!-- licences: written by rosml generate -->"
END_LICENCES = "<!-- /licences -->"


def render(page: str, image_set: ImageSet) -> str:
    """The page with the tables of this image set."""
    return _between("docs/tags.md", page, BEGIN, END, tables(image_set))


def render_licences(page: str, image_set: ImageSet) -> str:
    """The page with the licences of the parts of this image set."""
    lines = []
    for part in image_set.matrix.parts:
        spdx, allows = (part.licence.spdx, part.licence.allows) if part.licence else ("not said", "")
        link = f"[{spdx}]({part.licence.page})" if part.licence and part.licence.page else spdx
        lines.append(_row(f"`{part.name}`", link, allows, "private registries" if part.restricted else "any registry"))
    table = "\n".join([*_head("part", "licence", "it allows", "goes to"), *lines]) + "\n"
    return _between("docs/licences.md", page, BEGIN_LICENCES, END_LICENCES, table)


def _between(name: str, page: str, begin: str, end: str, table: str) -> str:
    head, before, rest = page.partition(begin)
    _, after, tail = rest.partition(end)
    if not before or not after:
        raise RosmlError(f"{name}: the markers {begin} and {end} are missing", "put them back around the table")
    return f"{head}{begin}\n{table}{end}{tail}"


def _head(*columns: str) -> tuple[str, str]:
    return _row(*columns), "| --- " * len(columns) + "|"


def _row(*cells: str) -> str:
    return f"| {' | '.join(cells)} |"


def tables(image_set: ImageSet) -> str:
    """Images without a lock; distributions with their components; frameworks with their versions and distributions; add-ons."""
    lines = [
        *_unlocked(image_set),
        *_head("distribution", "ROS", "system, Python", "components", "end of life", "images"),
        *_distributions(image_set),
        "",
        *_head("image", "content", "distributions", "platforms"),
        *_contents(image_set),
    ]
    if image_set.matrix.addons:
        text = "[Add-ons](addons.md) go onto any image of their stacks, also onto one that has no tag with them:"
        head = _head("add-on", "brings", "stacks", "Python", "platforms", "goes to")
        lines += ["", text, "", *head, *_addons(image_set)]
    if image_set.matrix.environments:
        text = "[Environments](environments.md) are Python packages beside ROS. These images have one; `rosml join` and `rosml containerize` add one to others:"
        head = _head("environment", "image", "platforms")
        lines += ["", text, "", *head, *_environments(image_set)]
    return "\n".join(lines) + "\n"


def _unlocked(image_set: ImageSet) -> Iterator[str]:
    rows: dict[str, dict[str, None]] = {}
    lacking = [image for image in image_set.images if image.tags and not image.locked]
    for image in lacking:
        rows.setdefault(f"{image.repository}:<d>-<c>-{image.stack}", {})[image.distribution] = None
    if lacking:
        remedies = listed(list(dict.fromkeys(missing_locks.remedy(image) for image in lacking)))
        remedies = remedies.replace("'rosml locks'", "`rosml locks`")
        yield from ("", f"These have no lock yet, and cannot be built before you {remedies}:", "")
        yield from (f"- `{tag}`: {listed(list(distributions))}" for tag, distributions in rows.items())
        yield ""


def _distributions(image_set: ImageSet) -> Iterator[str]:
    matrix = image_set.matrix
    for name, distribution in matrix.distributions.items():
        python = matrix.operating_systems[distribution.os].python
        eol = f"{distribution.eol}{' (LTS)' if distribution.lts else ''}" if distribution.eol else "rolling"
        components = ", ".join(distribution.components)
        only = ", ".join(distribution.architectures)
        notes = [*(["experimental"] if distribution.experimental else []), *([f"{only} only"] if only else [])]
        note = f" ({', '.join(notes)})" if notes else ""
        number = sum(image.distribution == name and bool(image.tags) for image in image_set.images)
        system = f"{distribution.os}, {python}"
        yield _row(f"`{name}`{note}", str(distribution.ros), system, components, eol, str(number))


def _contents(image_set: ImageSet) -> Iterator[str]:
    rows: dict[tuple[str, str | None], list[Image]] = {}
    for image in image_set.images:
        if image.tags and not image.environment:
            rows.setdefault((image.repository, image.stack), []).append(image)
    for images in rows.values():
        first = images[0]
        components = {image.component for image in images}
        tag = main_tag("<distribution>", components.pop() if len(components) == 1 else "<component>", first.stack)
        locked = dict.fromkeys(image.distribution for image in images if image.locked)
        others = dict.fromkeys(image.distribution for image in images if not image.locked)
        where = ", ".join(locked) if len(locked) < len(image_set.matrix.distributions) else "all"
        if others:
            where = f"{where}; " * bool(locked) + f"without a lock yet: {', '.join(others)}"
        platforms = ", ".join(dict.fromkeys(platform for image in images for platform in image.platforms))
        yield _row(f"`{first.repository}:{tag}`", _content(image_set, first), where, platforms)


def _addons(image_set: ImageSet) -> Iterator[str]:
    matrix = image_set.matrix
    for addon, entry in matrix.addons.items():
        where = "private registries" if any(matrix.part[name].restricted for name in entry.parts) else "any registry"
        rows: dict[tuple[str, str, str], list[str]] = {}
        for it in addons.on_stacks(image_set, addon):
            key = ", ".join(it.brings), ", ".join(it.pythons), ", ".join(it.platforms)
            rows.setdefault(key, []).append(f"`{it.stack}`")
        for (brings, python, on), stacks in rows.items():
            yield _row(f"`{addon}`", brings, ", ".join(stacks), python, on, where)


def _environments(image_set: ImageSet) -> Iterator[str]:
    for image in image_set.images:
        if image.environment:
            note = "" if image.locked else " (no lock yet)"
            yield _row(f"`{image.environment}`", f"`{image.tags[0]}`{note}", ", ".join(image.platforms))


def _content(image_set: ImageSet, image: Image) -> str:
    versions = listed([f"{name} {version}" for name, version in image.versions.items() if name != "nccl"])
    titles = [item.title for item in image.brought if item.title]
    released = [item.title for item in image.brought if item.title and item.released]
    return ", ".join(["ROS", *(released or titles)]) + _abi(image_set, image) + (f": {versions}" if versions else "")


def _abi(image_set: ImageSet, image: Image) -> str:
    matrix = image_set.matrix
    for family in combinations.families(matrix, matrix.carrying(image.framework, *image.addons)):
        if not matrix.releases[family][image.versions[family]].cxx11_abi:
            return " (old C++ ABI on amd64: not in one program with ROS's libraries)"
    return ""
