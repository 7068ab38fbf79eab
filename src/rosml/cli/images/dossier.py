"""`rosml dossier`: writes what there is to know about an image into a folder, for people and authorities."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import MATRIX as MATRIX_FILE
from rosml import ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say, warn

if TYPE_CHECKING:
    from rosml.images.dossier.gather import Dossier


@click.command("dossier", short_help="Writes an image's SBOM, support, licences.", cls=Command, alone=True)
@click.argument("image")
@click.option("--platform", default="", metavar="PLATFORM", help="such as linux/arm64 [this machine's]")
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    help="the folder to write, or a file that ends in .zip [NAME-dossier in the current folder]",
)
@click.option(
    "--format",
    "form",
    type=click.Choice(["cyclonedx", "spdx"]),
    default="cyclonedx",
    show_default=True,
    help="the SBOM's: CycloneDX 1.6, or SPDX 2.3",
)
@click.option(
    "--signer", default="", metavar="WHO", help="whose signature counts: a public key's file, or a workflow (https://…)"
)
@click.option("--with-texts", is_flag=True, help="download the layers, and write the texts of all licences as well")
@options.JSON
def main(image: str, platform: str, output: Path | None, **values: Any) -> None:
    """Writes the dossier of IMAGE, and prints how complete its SBOM is.

    IMAGE is a complete reference in any registry. The dossier has the SBOM, VEX, vulnerabilities, licences, ends of support,
    provenance, the state of the signature, the lock and a page that you can read and print. Read access is enough: what is
    attached to the image is read, and no layer without --with-texts. What is not there is on the page, with the reason.

    Exit codes: 0 if the dossier was written, whatever it lacks; 1 if nothing could be written; 2 if the input was wrong, such as
    an image that is gone.

    \b
    Examples:
      rosml dossier ghcr.io/me/robot:latest
      rosml dossier ghcr.io/me/rosml/ros:jazzy-base --output jazzy.zip --format spdx
      rosml dossier ghcr.io/me/rosml/ros:jazzy-base \\
        --signer https://github.com/me/rosml/.github/workflows/nightly.yml@refs/heads/main
    """
    from rosml.base.clock import now
    from rosml.images.dossier import write
    from rosml.images.dossier.gather import Request, gather
    from rosml.images.image_set import load
    from rosml.images.join.transfer import Transfer
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    signer = values["signer"]
    if signer and "://" not in signer and not Path(signer).is_file():
        raise RosmlError(f"there is no public key {signer}", "name its file, or a workflow: https://…", exit_code=2)
    folder = output or Path(f"{_name(image)}-dossier")
    write.require_free(folder)
    matrix = load.without_locks(MATRIX_FILE).matrix
    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Transfer(registries, say) as transfer:
        as_json = values.pop("as_json")
        request = Request(name=image, platform=platform, root=ROOT, matrix=matrix, now=now(), say=say, **values)
        dossier = gather(request, transfer)
    written = write.write(dossier, folder)
    if as_json:
        content = {**dossier.to_json(), "files": [str(file) for file in written]}
        terminal.echo(json.dumps(content, indent=2))
        return
    _print(dossier)
    terminal.echo(str(written[-1].resolve() if output and folder.suffix == ".zip" else written[-1].resolve().as_uri()))


def _name(image: str) -> str:
    """The last words of an image's name, for a folder."""
    return re.sub(r"[^A-Za-z0-9._-]+", "-", image.rpartition("/")[2]).strip("-.")[:100] or "image"


def _print(dossier: Dossier) -> None:
    from rosml.base.clock import day_of
    from rosml.cli.images import tables
    from rosml.images.dossier import fields

    tables.show(fields.COLUMNS, fields.rows(dossier.fields), right=["have it", "share"], wrapped=["why others lack it"])
    today = day_of(dossier.now)
    ends = ((f"{it.title} {it.version}", it.day or "no day", it.note) for it in dossier.ends)
    tables.show(("end of support", "last day", ""), ends, wrapped=[""])
    for end in dossier.ends:
        if end.has_ended(today):
            warn(f"{end.title} {end.version} had its end of support on {end.day}")
    if dossier.scan:
        counts = ", ".join(f"{number} {severity}" for severity, number in dossier.scan.counts) or "none"
        database = f"{dossier.scan.database.updated}, {counted(dossier.scan.age, 'day')} old"
        terminal.echo(f"vulnerabilities, by the database of {database}: {counts}")
    signature = dossier.signature
    terminal.echo(f"signature: {signature.state}{f' ({signature.why})' if signature.why else ''}")
    for line in dossier.missing:
        warn(line)
