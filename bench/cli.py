"""Measures what people wait for, both sides in one run.

\b
Examples:
  uv run python -m bench image             our second image beside one with RUN pip install (make bench)
  uv run python -m bench commands --before 624ef8e9
                                           what the commands take, here and at another commit
  uv run python -m bench scale             a night of 2,000 images, simulated
  uv run python -m bench app               rosml containerize beside Dockerfiles that people write by hand
  uv run python -m bench affected          which of a thousand apps have a package
  uv run python -m bench container         a container beside a bare process: its start, and what nodes take in it
  uv run python -m bench page              write docs/performance.md and docs/scale.md from the results that were saved
"""

from __future__ import annotations

from pathlib import Path

import click

from bench import addons, affected, app, commands, container, fleet, pull, results, scale, second_image, start
from bench.scale_night import Load
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.images.scan.trivy import Trivy
from rosml.machine.services import Services

TARGET = "ros1-bookworm-base-tensorflow-cpu"
"""The smallest image with a framework. One with CUDA takes several times as long."""

HELP = {"help_option_names": ["-h", "--help"]}


@click.group(help=__doc__, context_settings=HELP)
def main() -> None: ...


@main.command(context_settings=HELP)
@click.option("--target", default="", help=f"The image that is built in both ways; {TARGET} if it is empty.")
def image(target: str) -> None:
    """Our second image beside one whose Dockerfile has a `RUN pip install`.

    \b
    Examples:
      uv run python -m bench image         a small image
      uv run python -m bench image --target ros1-bookworm-base-torch-cu128
                                           one that has CUDA: 35 GB of free disk
    """
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    built = image_set.image(target or TARGET)
    second_image.require_comparable(built, ROOT, image_set)
    second_image.print_table(built, second_image.compare(Services.load(ROOT), image_set, built, _say))


@main.command("start", context_settings=HELP)
def start_() -> None:
    """What `rosml run` takes longer than `docker run`.

    \b
    Examples:
      uv run python -m bench start
    """
    click.echo(f"rosml run takes {start.seconds():.3f} s longer than docker run (median of {start.ROUNDS})")


@main.command("fleet", context_settings=HELP)
@click.option("--apps", default=fleet.APPS, help="How many apps are moved.")
def fleet_(apps: int) -> None:
    """A thousand apps that move to tonight's base images.

    \b
    Examples:
      uv run python -m bench fleet --apps 40
    """
    moved, again = fleet.measure(Services.load(ROOT), apps, _say)
    fleet.print_table(moved, again)
    if moved.beyond:
        raise RosmlError(f"one app took {'; '.join(moved.beyond)}")


@main.command("affected", context_settings=HELP)
@click.option("--apps", default=affected.APPS, help="How many apps are read.")
@click.option("--scan", is_flag=True, help="Also ask for an advisory, with the database that the scanner has.")
def affected_(apps: int, scan: bool) -> None:
    """`rosml affected` over a thousand apps.

    \b
    Examples:
      uv run python -m bench affected --apps 40
    """
    trivy = Trivy.find(ROOT) if scan else None
    results = affected.measure(Services.load(ROOT), apps, trivy, _say)
    affected.print_table(results, apps)
    if slow := [it for it in results if it.seconds > affected.SECONDS]:
        raise RosmlError(f"{slow[0].query} took {slow[0].seconds:.1f} s, and at most {affected.SECONDS:.0f}")


@main.command("addons", context_settings=HELP)
def addons_() -> None:
    """An add-on that is joined to an image, and to an app.

    \b
    Examples:
      uv run python -m bench addons
    """
    rows = addons.measure(Services.load(ROOT), load.load(ROOT / "matrix.yaml", ROOT), _say)
    addons.print_table(rows)
    if beyond := [line for row in rows for line in row.beyond]:
        raise RosmlError("; ".join(beyond))


@main.command("commands", context_settings=HELP)
@click.option("--before", default="624ef8e9", show_default=True, help="The commit that is compared with this checkout.")
def commands_(before: str) -> None:
    """What short commands take, here and at another commit.

    \b
    Examples:
      uv run python -m bench commands
    """
    _keep(commands.measure(before, _say))


@main.command("pull", context_settings=HELP)
@click.argument("images", nargs=-1, required=True, metavar="SIDE=REPOSITORY@DIGEST...")
@click.option(
    "--programs", type=click.Path(exists=True, path_type=Path), required=True, help="Has dockerd, containerd, runc."
)
@click.option("--storage", type=click.Path(exists=True, path_type=Path), default="/var/tmp", show_default=True)
@click.option("--engine", "names", multiple=True, default=["docker"], type=click.Choice([*pull.ENGINES]))
@click.option("--rate", "rates", multiple=True, default=["no limit"], type=click.Choice([*pull.RATES]))
@click.option("--rounds", default=3, show_default=True)
def pull_(
    images: tuple[str, ...], programs: Path, storage: Path, names: tuple[str, ...], rates: tuple[str, ...], rounds: int
) -> None:
    """How long an empty engine takes to pull images that the local registry has; the usual one first.

    \b
    Examples:
      uv run python -m bench pull --programs ~/engine usual=bench/usual@sha256:… ours=rosml/ros-torch@sha256:…
    """
    setting = pull.Setting(Services.load(ROOT), programs, storage, rounds, _say)
    sides = {side: reference for side, _, reference in (image.partition("=") for image in images)}
    _keep(pull.measure(setting, sides, names, rates))


@main.command("scale", context_settings=HELP)
@click.option("--machines", default=Load.machines, show_default=True, help="How many machines there are for shards.")
@click.option("--disk", default=Load.disk_mb // 1000, show_default=True, help="GB of disk of each machine.")
@click.option("--held", default=Load.held, show_default=True, help="Share of pulls by clients with yesterday's image.")
@click.option("--seed", default=Load.seed, show_default=True, help="Of all that is random.")
def scale_(machines: int, disk: int, held: float, seed: int) -> None:
    """Simulates a night of 2,000 images, 50,000 pulls and 10,000 apps.

    \b
    Examples:
      uv run python -m bench scale
      uv run python -m bench scale --machines 12 --disk 36
    """
    load = Load(machines=machines, disk_mb=1000 * disk, held=held, seed=seed)
    command = f"python -m bench scale --machines {machines} --disk {disk} --held {held} --seed {seed}"
    for result in scale.measure(load, command, _say):
        _keep(result)


@main.command("app", context_settings=HELP)
def app_() -> None:
    """`rosml containerize` beside Dockerfiles that people write by hand.

    \b
    Examples:
      uv run python -m bench app
    """
    _keep(app.measure(Services.load(ROOT), _say))


@main.command("container", context_settings=HELP)
def container_() -> None:
    """A container of ROS 1 beside a bare process, with this machine's Docker.

    \b
    Examples:
      uv run python -m bench container
    """
    _keep(container.measure(Services.load(ROOT), load.load(ROOT / "matrix.yaml", ROOT).matrix, _say))


@main.command(context_settings=HELP)
def page() -> None:
    """Writes docs/performance.md, docs/scale.md and their plots from bench/results.

    \b
    Examples:
      uv run python -m bench page
    """
    results.write_pages()


def _keep(result: results.Result) -> None:
    """Prints a result and saves it."""
    result.print()
    result.save()


def _say(line: str) -> None:
    click.echo(click.style(f"==> {line}", bold=True), err=True)
