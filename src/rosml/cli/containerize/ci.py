"""`rosml ci`: what the action, the workflow and the component for GitLab call; people call `rosml containerize`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import IN_CHECKOUT, ROOT, STATE
from rosml.base import github, terminal
from rosml.base.errors import RosmlError
from rosml.cli.checkout import Group
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.containerize.ci.job import Image, Job

KEPT = "interrupted: the builder keeps finished steps; run the job again"


@click.group("ci", short_help="Builds images of a commit, for the CI files in containerize/.", cls=Group, kept=KEPT)
def main() -> None:
    """Runs 'rosml containerize' in CI. The files in containerize/ call it, and pass inputs as variables.

    \b
    Example:
      rosml ci build --out made
    """


def _job() -> tuple[Job, dict[str, str], Path]:
    from rosml.containerize import inputs as app_inputs
    from rosml.containerize.ci import inputs as ci_inputs
    from rosml.containerize.ci import job as ci_job

    commit, inputs = ci_job.commit(os.environ), ci_inputs.inputs_of(os.environ)
    folder = (commit.folder / inputs.get("build-context", ".")).resolve()
    if not folder.is_dir():
        raise RosmlError(f"build-context: there is no folder {folder}", "check its name", exit_code=2)
    for sentence in app_inputs.answers(folder, {name.upper().replace("-", "_"): text for name, text in inputs.items()}):
        say(sentence)
    return ci_job.Job(app_inputs.values(inputs, folder, {}), os.environ, commit, say), inputs, folder


@main.command(alone=True)
def login() -> None:
    """Logs in to the registry, with docker."""
    import subprocess  # only needed here

    from rosml.containerize.ci import inputs as ci_inputs

    inputs = ci_inputs.inputs_of(os.environ)
    registry, user = inputs.get("registry", ""), inputs.get("registry-user", "")
    try:
        done = subprocess.run(
            ["docker", "login", "--username", user, "--password-stdin", registry],
            input=inputs.get("registry-password", ""),
            text=True,
            check=False,
        )
    except OSError as error:
        raise RosmlError(f"cannot run docker: {error.strerror}", "install Docker on this runner") from None
    if done.returncode != 0:
        text = f"{registry or 'the registry'} refuses {user or 'a user without a name'}"
        raise RosmlError(text, "check the inputs registry, registry-user and registry-password")


@main.command(alone=True)
@click.option("--out", required=True, type=click.Path(path_type=Path), help="folder for reports and images.json")
def build(out: Path) -> None:
    """Builds the images of a commit, tests them and pushes them."""
    from rosml.containerize.ci import inputs as ci_inputs
    from rosml.containerize.ci import job as ci_job
    from rosml.machine.services import NO_BUILDX, Services

    job, inputs, folder = _job()
    apart = ci_inputs.flag("enable-singlearch-push", inputs)
    out = out / job.name
    github.output("artifact", job.name)
    github.output("folder", str(out))
    images: list[Image] = []
    try:
        services = Services.of_docker(ROOT if IN_CHECKOUT else STATE, NO_BUILDX)
        services.require_builder()
        images = job.build(folder, services, out, apart)
    except RosmlError as error:
        if os.environ.get(github.SUMMARY):
            click.echo("\n".join(ci_job.errors(out, error)))  # commands of rosml's own
        raise
    finally:
        github.summary(ci_job.summary(images, out))
    if (sentence := job.missing_slim(images)) and os.environ.get(github.SUMMARY):
        click.echo(ci_job.command("warning", "rosml containerize", sentence))
    _report(images)


@main.command(alone=True, short_help="Makes one index of the images for several platforms.")
@click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path))
def index(folder: Path) -> None:
    """Makes an index of the images that the jobs for one platform each left in FOLDER, and moves the tags to it."""
    from rosml.containerize.ci import job as ci_job
    from rosml.registry.client import Registries

    job, _, _ = _job()
    with Registries(os.environ.get("SSL_CERT_FILE", "")) as registries:
        images = job.index(folder, registries)
    github.summary(ci_job.summary(images))
    _report(images)


def _report(images: list[Image]) -> None:
    from rosml.containerize.ci import job as ci_job

    for name, value in ci_job.outputs(images).items():
        github.output(name, value)
    for image in images:
        terminal.echo(f"{image.target:<5}  {image.reference}@{image.digest}")
