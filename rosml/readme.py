"""The table of images in README.md, rendered from the catalogue between two markers."""

from __future__ import annotations

from rosml.errors import RosmlError
from rosml.expand import Catalogue, Image

BEGIN = "<!-- images: written by scripts/generate_bake.py -->"
END = "<!-- /images -->"

_CONTENT = {
    "none": "ROS",
    "cuda": "ROS, CUDA",
    "torch": "ROS, PyTorch, libtorch",
    "tensorflow": "ROS, TensorFlow",
    "ml": "ROS, PyTorch, libtorch, TensorFlow",
}


def render(readme: str, catalogue: Catalogue) -> str:
    """The README with the table of this catalogue.

    Raises:
        RosmlError: the markers are missing.
    """
    head, begin, rest = readme.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise RosmlError(
            f"README.md: the markers {BEGIN} and {END} are missing", "put them back where the table belongs"
        )
    return f"{head}{BEGIN}\n{table(catalogue)}{END}{tail}"


def table(catalogue: Catalogue) -> str:
    """One row for each distribution, framework and stack; its components in one cell."""
    lines = ["| image | content | components | platforms |", "| --- | --- | --- | --- |"]
    rows: dict[tuple[str, str, str | None], list[Image]] = {}
    for image in catalogue.images:
        rows.setdefault((image.distribution, image.framework, image.stack), []).append(image)
    for images in rows.values():
        first = images[0]
        tag = "-".join(filter(None, [first.distribution, "<component>", first.stack]))
        versions = ", ".join(f"{name} {version}" for name, version in first.versions.items() if name != "nccl")
        content = _CONTENT.get(first.framework, first.framework) + (f" ({versions})" if versions else "")
        components = ", ".join(image.component for image in images)
        platforms = ", ".join(sorted({platform for image in images for platform in image.platforms}))
        content += "" if first.locked else "; not built yet: no lock"
        lines.append(f"| `{first.repository}:{tag}` | {content} | {components} | {platforms} |")
    return "\n".join(lines) + "\n"
