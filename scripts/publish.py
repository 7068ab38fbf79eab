#!/usr/bin/env python3
"""Builds, tests and publishes images: a thin command over rosml/publish.py."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT, command


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
def cli() -> None:
    """Builds, tests and publishes images of matrix.yaml.

    Needs the services that 'make up' starts.
    """


def say(line: str) -> None:
    """Tells people what begins now."""
    click.echo(click.style(f"==> {line}", bold=True), err=True)


def _namespace(_context: click.Context, _parameter: click.Parameter, value: str) -> str:
    """A part of a repository's name, checked before it becomes one."""
    if not re.fullmatch(r"[a-z0-9]+([._-]+[a-z0-9]+)*(/[a-z0-9]+([._-]+[a-z0-9]+)*)*", value):
        raise click.BadParameter(f"{value!r} is no part of a repository's name, such as rosml or my-team/rosml")
    return value


@cli.command()
@click.argument("target", default="")
@click.option("--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="another matrix.yaml")
@click.option(
    "--namespace", default="rosml", show_default=True, callback=_namespace, help="first part of the repositories' names"
)
@click.option(
    "--platform",
    default="",
    metavar="PLATFORM",
    help="build and test for it, such as linux/arm64; no tag moves where it is not the machine's own",
)
@click.option("--check", is_flag=True, help="only say whether there is such an image; needs no services")
@click.option("--json", "as_json", is_flag=True, help="print the result as JSON on standard output")
def image(target: str, matrix: Path, namespace: str, platform: str, check: bool, as_json: bool) -> None:
    """Builds TARGET, runs its structure tests, and moves its tags in the local registry.

    Without TARGET: the one that matrix.yaml names as its default.

    \b
    Examples:
      uv run scripts/publish.py image bookworm-core-torch-cu128
      uv run scripts/publish.py image bookworm-base --json
    """
    from rosml import bake, expand, files
    from rosml.base_images import native_architecture
    from rosml.publish import Publisher, architecture_of, require_buildable
    from rosml.services import Services
    from rosml.summary import text

    catalogue = expand.load(matrix, ROOT)
    target = target or catalogue.matrix.default.target
    # A typo is told before anything else happens.
    architecture = architecture_of(catalogue, platform) if platform else native_architecture()
    require_buildable(catalogue.image(target), "" if architecture == native_architecture() else architecture)
    if check:
        return
    services = Services.load(ROOT)
    bake_file = ROOT / "docker-bake.hcl"
    if matrix.resolve() == ROOT / "matrix.yaml" and files.write(bake_file, bake.render(catalogue)):
        say(f"{bake_file.name} was not up to date with {matrix.name}: written anew")
    result = Publisher(services, catalogue, say, namespace, architecture).publish(target)
    click.echo(json.dumps(result.to_json(), indent=2) if as_json else text(result))


@cli.command()
@click.argument("payloads", nargs=-1, metavar="[NAME]...")
@click.option("--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="another matrix.yaml")
@click.option(
    "--namespace", default="rosml", show_default=True, callback=_namespace, help="first part of the repositories' names"
)
@click.option("--json", "as_json", is_flag=True, help="print the results as JSON on standard output")
@click.option("--markdown", is_flag=True, help="print them as a table in Markdown, for docs/digests.md")
@click.option(
    "--platform", default="", metavar="PLATFORM", help="for this one only, such as linux/arm64; then no tag moves"
)
@click.option("--again", is_flag=True, help="assemble them without the builder's cache")
def payload(
    payloads: tuple[str, ...],
    matrix: Path,
    namespace: str,
    as_json: bool,
    markdown: bool,
    platform: str,
    again: bool,
) -> None:
    """Assembles payloads and publishes them in the local registry: what COPY --link adds to an image of one's own.

    For all of their architectures, without emulation. Without NAME: lists them.

    \b
    Examples:
      uv run scripts/publish.py payload cuda-cu128 common-cu128-py311 torch-cu128-py311
    """
    from rosml import expand
    from rosml import payloads as found
    from rosml.services import Services

    if as_json and markdown:
        raise click.UsageError("--json and --markdown are two forms of the same; use one of them")
    catalogue = expand.load(matrix, ROOT)
    wanted = [found.find(catalogue, name) for name in dict.fromkeys(payloads)]
    if not wanted:
        for item in catalogue.payloads:
            click.echo(f"{item.name}  {', '.join(item.platforms)}")
        return
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    results = []
    for item in wanted:
        results.append(found.publish(services, catalogue, item, say, namespace, again, platform))
        if not (as_json or markdown):
            done = results[-1]
            click.echo(f"{done.reference}  bytecode: {done.bytecode or 'none'}  {done.seconds:.0f} s")
            for name, (digest, size) in done.layers.items():
                click.echo(f"  {name}  {digest}  {size / 1e6:.1f} MB")
    if as_json:
        click.echo(json.dumps([done.to_json() for done in results], indent=2))
    elif markdown:
        click.echo(found.markdown(results), nl=False)


@cli.command()
@click.option("--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="another matrix.yaml")
@click.option(
    "--namespace", default="rosml", show_default=True, callback=_namespace, help="first part of the repositories' names"
)
@click.option("--json", "as_json", is_flag=True, help="print the records as JSON on standard output")
@click.option("--markdown", is_flag=True, help="print the table as Markdown, for docs/built.md")
def results(matrix: Path, namespace: str, as_json: bool, markdown: bool) -> None:
    """Lists what was published from this checkout: sizes, tests, times.

    \b
    Examples:
      uv run scripts/publish.py results
      uv run scripts/publish.py results --json
    """
    from rosml import expand
    from rosml import results as found

    if as_json and markdown:
        raise click.UsageError("--json and --markdown are two forms of the same; use one of them")
    records = found.read(ROOT / ".state", namespace, expand.load(matrix, ROOT))
    if as_json:
        click.echo(json.dumps(records, indent=2))
    elif markdown:
        click.echo(found.markdown(records), nl=False)
    else:
        found.print_table(records)


@cli.command()
@click.argument("one")
@click.argument("other")
@click.option("--json", "as_json", is_flag=True, help="print the result as JSON on standard output")
def compare(one: str, other: str, as_json: bool) -> None:
    """Compares the layers of two published images, and shows the first file in which they differ.

    Exits with 1 if they differ. References are complete: the registry, and a tag or digest.

    \b
    Examples:
      uv run scripts/publish.py compare localhost:5000/rosml/payload:torch-cu128-py311 ghcr.io/me/payload:torch-cu128-py311
    """
    from rosml.compare import compare as compared
    from rosml.services import Services

    found = compared(Services.load(ROOT), one, other)
    if as_json:
        click.echo(json.dumps(found.to_json(), indent=2))
    else:
        for number, (left, right) in enumerate(found.layers, 1):
            click.echo(f"layer {number}: {'same' if left == right else 'differs'}  {left or '-'}  {right or '-'}")
        click.echo(found.difference or "all layers are the same")
    if not found.same:
        raise SystemExit(1)


if __name__ == "__main__":
    kept = "interrupted: no tag points at what is not finished; what was finished is kept, the next call carries on"
    sys.exit(command.run(cli, kept, reader_gone=command.BROKEN_PIPE))
