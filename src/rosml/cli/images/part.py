"""`rosml part`: parts, which you add to your own images."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import completion
from rosml.cli.checkout import Command
from rosml.cli.command import say
from rosml.cli.images.call import KEPT, sharing

if TYPE_CHECKING:
    from rosml.images.builds.part import BuiltPart
    from rosml.images.image_set.model import ImageSet


@dataclass(frozen=True)
class _Request:
    parts: tuple[str, ...]
    matrix: Path
    namespace: str
    as_json: bool
    markdown: bool
    platform: str
    again: bool


@click.command("part", short_help="Builds parts, which COPY --link adds to your image.", cls=Command, kept=KEPT)
@click.argument("parts", nargs=-1, metavar="[NAME]...", type=completion.Name("parts"))
@sharing("matrix", "namespace", "json")
@click.option("--markdown", is_flag=True, help="print a table in Markdown, for docs/digests.md")
@click.option(
    "--platform", default="", metavar="PLATFORM", help="build only for this one, such as linux/arm64; no tag moves"
)
@click.option("--again", is_flag=True, help="build without the builder's cache")
def main(**options: Any) -> None:
    """Builds parts and pushes them into the local registry. COPY --link adds them to your image.

    Builds for all architectures of a part, without emulation. Without NAME, lists all parts.

    \b
    Examples:
      rosml part cuda-cu128 common-cu128-py311 torch-cu128-py311
    """
    from rosml.images.builds import part
    from rosml.images.image_set import load, selection

    request = _Request(**options)
    if request.as_json and request.markdown:
        raise click.UsageError("--json and --markdown exclude each other; use one of them")
    image_set = load.load(request.matrix, ROOT)
    platform = request.platform
    if platform:
        platform = image_set.matrix.architectures[selection.architecture_of(image_set, platform)].platform
    if not request.parts:
        _list(image_set, request.as_json)
        return
    results = _build(request, image_set, platform)
    if request.as_json:
        terminal.echo(json.dumps([result.to_json() for result in results], indent=2))
    elif request.markdown:
        terminal.echo(part.markdown(results), nl=False)


def _list(image_set: ImageSet, as_json: bool) -> None:
    parts = [{"name": part.name, "platforms": [*part.platforms]} for part in image_set.parts]
    lines = (f"{part.name}  {', '.join(part.platforms)}" for part in image_set.parts)
    terminal.echo(json.dumps(parts, indent=2) if as_json else "\n".join(lines))


def _build(request: _Request, image_set: ImageSet, platform: str) -> list[BuiltPart]:
    from rosml.images.builds import contents, part
    from rosml.machine.services import Services
    from rosml.registry.client import Registry

    parts = [part.by_name(image_set, name) for name in dict.fromkeys(request.parts)]
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    builder = part.PartBuilder(services, image_set, f"{services.registry}/{request.namespace}", say, request.again)
    results = []
    for item in parts:
        result = builder.publish(item, platform)
        results.append(result)
        with Registry(services.registry) as client:  # attaches the list of files that 'rosml join' compares
            contents.attach(services, image_set, client, [(f"{request.namespace}/part", result.digest)], say)
        if not (request.as_json or request.markdown):
            terminal.echo(f"{result.reference}  bytecode: {result.bytecode or 'none'}  {result.seconds:.0f} s")
            for name, (digest, size) in result.layers.items():
                terminal.echo(f"  {name}  {digest}  {size / 1e6:.1f} MB")
    return results
