"""Draws docs/images/layers.svg: what images are made of, and what the next one adds to those before it. And docs/images/rebase.svg: an
app before and after it moves to another base image."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape

from rosml.images.builds import disk
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import combinations

WIDTH, LEFT, RIGHT, ROW, BAR = 860, 250, 130, 46, 26
"""Pixels: the picture, the column of tags, the column of sums, the height of a row and of its bar."""

APP_MB = 60
"""Megabytes of the app in the picture of a rebase, so that it can be seen. That of examples/ros1 has less than one."""

STYLE = """\
    .ink { fill: #1f2328; } .soft { fill: #59636e; }
    .ros { fill: #ddf4ff; stroke: #0969da; } .part { fill: #dafbe1; stroke: #1a7f37; } .app { fill: #fff8c5; stroke: #9a6700; }
    .there { fill: none; stroke: #8c959f; stroke-dasharray: 3 3; }
    @media (prefers-color-scheme: dark) {
      .ink { fill: #e6edf3; } .soft { fill: #9198a1; }
      .ros { fill: #0c2d4e; stroke: #4493f8; } .part { fill: #0f3320; stroke: #3fb950; } .app { fill: #3b2e00; stroke: #d29922; } .there { stroke: #656c76; }
    }
"""


def shown(image_set: ImageSet) -> tuple[Image, ...]:
    """The default image; then its relatives in the order in which somebody may want them: without a framework, with
    more of ROS, of another distribution on the same system."""
    default = image_set.image(image_set.matrix.default.targets[0])
    relatives = [
        image
        for image in image_set.images
        if (image.stack, image.os, image.combination) == (default.stack, default.os, default.combination)
    ]
    larger = [
        image
        for image in relatives
        if image.distribution == default.distribution
        and default.component in combinations.chain(image_set.matrix, image.component)[:-1]
    ]
    others = [
        image
        for image in relatives
        if image.distribution != default.distribution and image.component == default.component
    ]
    plain = image_set.by_target.get(default.parent)
    largest = max(larger, key=lambda image: image.disk.compressed, default=None)
    return tuple(image for image in (default, plain, largest, *others[:1]) if image)


def one_after_another(image_set: ImageSet, images: Sequence[Image]) -> Iterator[tuple[Image, frozenset[str], int]]:
    """Each image with the layers of those before it, and the compressed megabytes that it adds to these."""
    pulled: frozenset[str] = frozenset()
    for image in images:
        layers = disk.layers(image_set, image)
        yield image, pulled, sum(size for name, size in layers.items() if name not in pulled)
        pulled |= layers.keys()


def render(image_set: ImageSet) -> str:
    """The picture of images."""
    rows = [
        _Row(image.tags[0], _bars(image_set, image, pulled), f"{_gigabytes(added)} new")
        for image, pulled, added in one_after_another(image_set, shown(image_set))
    ]
    return _picture("Images share layers", "compressed size; dashed: pulled with an image above", rows)


def render_rebase(image_set: ImageSet) -> str:
    """The picture of an app on the default image that moves to the next night's, in which ROS has changed."""
    image = image_set.image(image_set.matrix.default.targets[0])
    layers = disk.layers(image_set, image)
    ros = {name for name in layers if name not in image.parts and not name.startswith("_os-")}
    total, app = sum(layers.values()), _Bar("your app", APP_MB, "app")
    rows = [
        _Row("robot:latest, on Monday's image", [*_bars(image_set, image, frozenset()), app], _gigabytes(total)),
        _Row(
            "rosml rebase robot:latest",
            [*_bars(image_set, image, frozenset(layers.keys() - ros)), _Bar("your app", APP_MB, "there")],
            f"{_gigabytes(sum(layers[name] for name in ros))} new",
        ),
    ]
    return _picture("An app moves to tonight's image", "compressed size; dashed: the same layers as before", rows)


@dataclass(frozen=True)
class _Bar:
    """A layer: its name, megabytes, and class of style."""

    label: str
    size: int
    kind: str


@dataclass(frozen=True)
class _Row:
    """An image: its tag, its layers, and what stands at their end."""

    tag: str
    bars: Sequence[_Bar]
    end: str


def _picture(title: str, above: str, rows: Sequence[_Row]) -> str:
    scale = (WIDTH - LEFT - RIGHT) / max(sum(bar.size for bar in row.bars) for row in rows)
    drawn = "".join(_drawn(row, 30 + ROW * number, scale) for number, row in enumerate(rows))
    spoken = "; ".join(f"{row.tag}: {row.end}" for row in rows)
    return f"""\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {34 + ROW * len(rows)}" role="img" aria-labelledby="t d" font-family="system-ui, sans-serif" font-size="13">
  <!-- Written by rosml generate, from the sizes in matrix.yaml. -->
  <title id="t">{escape(title)}</title>
  <desc id="d">{escape(spoken)}</desc>
  <style>
{STYLE}  </style>
  <text class="soft" x="{LEFT}" y="16" font-size="12">{escape(above)}</text>
{drawn}</svg>
"""


def _bars(image_set: ImageSet, image: Image, pulled: frozenset[str]) -> list[_Bar]:
    bars = []
    for name, size in disk.layers(image_set, image).items():
        label = image_set.part_by_name[name].kind if name in image.parts else name.removeprefix("_os-")
        kind = "there" if name in pulled else "part" if name in image.parts else "ros"
        bars.append(_Bar(label, size, kind))
    return bars


def _drawn(row: _Row, top: int, scale: float) -> str:
    text = f'  <text class="ink" x="0" y="{top + 17}">{escape(row.tag)}</text>\n'
    x = float(LEFT)
    for bar in row.bars:
        width = bar.size * scale
        text += (
            f'  <rect class="{bar.kind}" x="{x:.1f}" y="{top}" width="{max(width - 1, 1):.1f}" height="{BAR}" rx="2">'
            f"<title>{escape(bar.label)}: {bar.size} MB</title></rect>\n"
        )
        if width > 9 * len(bar.label):
            text += f'  <text class="soft" x="{x + width / 2:.1f}" y="{top + 17}" text-anchor="middle" font-size="12">{escape(bar.label)}</text>\n'
        x += width
    return text + f'  <text class="ink" x="{x + 8:.1f}" y="{top + 17}">{escape(row.end)}</text>\n'


def _gigabytes(megabytes: int) -> str:
    return f"{megabytes / 1000:.1f} GB" if megabytes >= 1000 else f"{megabytes} MB"
