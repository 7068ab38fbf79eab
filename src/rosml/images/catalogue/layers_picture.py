"""Draws docs/images/layers.svg: what images are made of, and what the next one adds to those before it."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from rosml.images.builds import disk
from rosml.images.image_set.model import Image, ImageSet

WIDTH, LEFT, RIGHT, ROW, BAR = 860, 250, 130, 46, 26
"""Pixels: the picture, the column of tags, the column of sums, the height of a row and of its bar."""

STYLE = """\
    .ink { fill: #1f2328; } .soft { fill: #59636e; }
    .ros { fill: #ddf4ff; stroke: #0969da; } .part { fill: #dafbe1; stroke: #1a7f37; }
    .there { fill: none; stroke: #8c959f; stroke-dasharray: 3 3; }
    @media (prefers-color-scheme: dark) {
      .ink { fill: #e6edf3; } .soft { fill: #9198a1; }
      .ros { fill: #0c2d4e; stroke: #4493f8; } .part { fill: #0f3320; stroke: #3fb950; } .there { stroke: #656c76; }
    }
"""


def shown(image_set: ImageSet) -> tuple[Image, ...]:
    """The default image; then its relatives in the order in which somebody may want them: without a framework, with more of ROS,
    of another distribution on the same system."""
    default = image_set.image(image_set.matrix.default.targets[0])
    relatives = [image for image in image_set.images if image.stack == default.stack and image.os == default.os]
    like = [image for image in relatives if image.framework == default.framework]
    larger = [
        image
        for image in like
        if image.distribution == default.distribution and default.component in _below(image_set, image.component)
    ]
    others = [
        image for image in like if image.distribution != default.distribution and image.component == default.component
    ]
    plain = image_set.by_target.get(default.parent)
    found = [default, plain, max(larger, key=lambda image: image.disk.compressed, default=None), *others[:1]]
    return tuple(image for image in found if image)


def _below(image_set: ImageSet, component: str) -> Iterator[str]:
    """The components below one."""
    below = image_set.matrix.components[component].builds_on
    while below:
        yield below
        below = image_set.matrix.components[below].builds_on


def new_mb(image_set: ImageSet, images: tuple[Image, ...]) -> list[int]:
    """Compressed megabytes that each image adds to those before it."""
    known: set[str] = set()
    found = []
    for image in images:
        made = disk.layers(image_set, image)
        found.append(sum(size for name, size in made.items() if name not in known))
        known |= made.keys()
    return found


def render(image_set: ImageSet) -> str:
    """The picture."""
    images = shown(image_set)
    widest = max(sum(disk.layers(image_set, image).values()) for image in images)
    scale = (WIDTH - LEFT - RIGHT) / widest
    height = 34 + ROW * len(images)
    rows = "".join(
        _row(image_set, image, 30 + ROW * number, scale, known, added)
        for number, (image, known, added) in enumerate(
            zip(images, _known(image_set, images), new_mb(image_set, images), strict=True)
        )
    )
    return f"""\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" aria-labelledby="t d" font-family="system-ui, sans-serif" font-size="13">
  <!-- Written by rosml generate, from the sizes in matrix.yaml. -->
  <title id="t">Images share layers</title>
  <desc id="d">{escape(_spoken(image_set, images))}</desc>
  <style>
{STYLE}  </style>
  <text class="soft" x="{LEFT}" y="16" font-size="12">compressed size; dashed: pulled with an image above</text>
{rows}</svg>
"""


def _known(image_set: ImageSet, images: tuple[Image, ...]) -> Iterator[frozenset[str]]:
    """For each image, the layers of those before it."""
    known: frozenset[str] = frozenset()
    for image in images:
        yield known
        known |= disk.layers(image_set, image).keys()


def _row(image_set: ImageSet, image: Image, top: int, scale: float, known: frozenset[str], added: int) -> str:
    text = f'  <text class="ink" x="0" y="{top + 17}">{escape(image.tags[0])}</text>\n'
    x = float(LEFT)
    for name, size in disk.layers(image_set, image).items():
        width = size * scale
        label = image_set.part_by_name[name].kind if name in image.parts else name.removeprefix("_os-")
        kind = "there" if name in known else "part" if name in image.parts else "ros"
        text += (
            f'  <rect class="{kind}" x="{x:.1f}" y="{top}" width="{max(width - 1, 1):.1f}" height="{BAR}" rx="2">'
            f"<title>{escape(label)}: {size} MB</title></rect>\n"
        )
        if width > 9 * len(label):
            text += f'  <text class="soft" x="{x + width / 2:.1f}" y="{top + 17}" text-anchor="middle" font-size="12">{escape(label)}</text>\n'
        x += width
    return text + f'  <text class="ink" x="{x + 8:.1f}" y="{top + 17}">{_gigabytes(added)} new</text>\n'


def _gigabytes(megabytes: int) -> str:
    return f"{megabytes / 1000:.1f} GB" if megabytes >= 1000 else f"{megabytes} MB"


def _spoken(image_set: ImageSet, images: tuple[Image, ...]) -> str:
    return "; ".join(
        f"{image.tags[0]}: {_gigabytes(added)} new"
        for image, added in zip(images, new_mb(image_set, images), strict=True)
    )
