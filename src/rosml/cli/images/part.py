"""`rosml part`: parts, which you add to your own images."""

from __future__ import annotations

import json
from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import completion
from rosml.cli.checkout import Command
from rosml.cli.command import say
from rosml.cli.images.call import KEPT, sharing


@click.command("part", short_help="Builds parts, which COPY --link adds to your image.", cls=Command, kept=KEPT)
@click.argument("parts", nargs=-1, metavar="[NAME]...", type=completion.Name("parts"))
@sharing("matrix", "namespace", "json")
@click.option("--markdown", is_flag=True, help="print a table in Markdown, for docs/digests.md")
@click.option(
    "--platform", default="", metavar="PLATFORM", help="build only for this one, such as linux/arm64; no tag moves"
)
@click.option("--again", is_flag=True, help="build without the builder's cache")
def main(
    parts: tuple[str, ...], matrix: Path, namespace: str, as_json: bool, markdown: bool, platform: str, again: bool
) -> None:
    """Builds parts and pushes them into the local registry. COPY --link adds them to your image.

    Builds for all architectures of a part, without emulation. Without NAME, lists all parts.

    \b
    Examples:
      rosml part cuda-cu128 common-cu128-py311 torch-cu128-py311
    """
    from rosml.images.builds import contents
    from rosml.images.builds import part as found
    from rosml.images.image_set import load as loading
    from rosml.images.image_set import selection
    from rosml.machine.services import Services
    from rosml.registry.client import Registry

    if as_json and markdown:
        raise click.UsageError("--json and --markdown exclude each other; use one of them")
    image_set = loading.load(matrix, ROOT)
    wanted = [found.find(image_set, name) for name in dict.fromkeys(parts)]
    if platform:
        platform = image_set.matrix.architectures[selection.architecture_of(image_set, platform)].platform
    if not wanted:
        known = {item.name: [*item.platforms] for item in image_set.parts}
        listed = [{"name": name, "platforms": platforms} for name, platforms in known.items()]
        lines = (f"{name}  {', '.join(platforms)}" for name, platforms in known.items())
        terminal.echo(json.dumps(listed, indent=2) if as_json else "\n".join(lines))
        return
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    results = []
    for item in wanted:
        results.append(found.publish(services, image_set, item, say, namespace, again, platform))
        with Registry(services.registry) as client:  # attaches the list of files that 'rosml join' compares
            contents.attach(services, image_set, client, [(f"{namespace}/part", results[-1].digest)], say)
        if not (as_json or markdown):
            done = results[-1]
            terminal.echo(f"{done.reference}  bytecode: {done.bytecode or 'none'}  {done.seconds:.0f} s")
            for name, (digest, size) in done.layers.items():
                terminal.echo(f"  {name}  {digest}  {size / 1e6:.1f} MB")
    if as_json:
        terminal.echo(json.dumps([done.to_json() for done in results], indent=2))
    elif markdown:
        terminal.echo(found.markdown(results), nl=False)
