"""`rosml publish`: the steps of a publishing run, and commands for published tags."""

from __future__ import annotations

import json
import math
import os
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import files, terminal
from rosml.cli.checkout import Group
from rosml.cli.command import as_called, say
from rosml.cli.images.call import KEPT, Call, sharing
from rosml.cli.options import place_of

if TYPE_CHECKING:
    from rosml.images.publish.run import Run
    from rosml.images.publish.scan_results import Results
    from rosml.images.publish.undo import RecordedRun
    from rosml.images.records.store import Records
    from rosml.images.scan import judge


FILE = click.Path(path_type=Path, exists=True, dir_okay=False)
ELSEWHERE = {name: f"rosml {name}" for name in ("image", "part", "plan", "status")} | {
    "join": "rosml publish join-images"
}


@click.group(
    "publish",
    short_help="Builds, tests and publishes images, or undoes that.",
    cls=Group,
    kept=KEPT,
    elsewhere=ELSEWHERE,
)
def main() -> None:
    """Builds, tests and publishes images of matrix.yaml.

    'all' does a whole publishing run. Other commands do one step of it, or move and remove published tags.

    \b
    Examples:
      rosml publish all --registry ghcr.io/me/rosml --only 'ros1-bookworm-*' --serve amd64
      rosml publish undo --registry ghcr.io/me/rosml
    """


_STEP = ("registry", "matrix", "only", "architecture", "serve", "force", "plan", "shard", "date", "json")
_GATED = (*_STEP, "require-scan", "policy", "sign")


def _step(name: str, help_text: str, options: tuple[str, ...] = _STEP) -> None:
    """Adds the command for a step of a publishing run."""

    @main.command(name, help=f"{help_text}\n\n\b\nExample:\n  rosml publish {name} --plan plan.json --shard amd64-1")
    @sharing(*options)
    def command_of_step(**options: Any) -> None:
        from rosml.images.publish.steps import STEPS

        call = Call(**options)
        run = call.run()
        STEPS[name.removesuffix("-images")](run)
        call.report(run)


@main.command(short_help="Creates the repositories that a plan writes into.")
@sharing("matrix", "json")
@click.option("--plan", "plan_file", type=FILE, required=True, help="what 'plan' wrote")
def repositories(plan_file: Path, matrix: Path, as_json: bool) -> None:
    """Creates the repositories that a plan writes into, one after the other, before several machines push at once.

    Registries such as ghcr.io create a repository at its first push, and refuse other pushes into it meanwhile.
    Existing repositories stay as they are.

    \b
    Example:
      rosml publish repositories --plan plan.json
    """
    from rosml.base.errors import RosmlError
    from rosml.containerize.base_image import rosdep_index
    from rosml.images.image_set import load as loading
    from rosml.images.publish.plan import read_plan

    plan = read_plan(plan_file)
    place = place_of(plan.registry, ROOT)
    names = plan.repositories(loading.without_locks(matrix))
    created, failed = list[str](), dict[str, str]()
    with place.client:
        for name in [*names, rosdep_index.NAME] if names else []:  # a nightly job also writes rosdep's lists
            try:
                if place.make(name):
                    created.append(name)
                    say(f"made {place.reference(name)}")
            except RosmlError as error:
                failed[name] = error.message
                say(f"failed: {error.message}; {error.remedy}")
    if as_json:
        terminal.echo(json.dumps({"made": created, "failed": failed}))
    raise SystemExit(bool(failed))


_step("build", "Builds ROS images and parts that are out of date or missing. It pushes them by digest.")
_step("join-images", "Joins ROS images and parts in the registry. It pulls no layer.")
_step("test", "Runs the structure tests that images have not passed yet. They run on the image's architecture.")


@main.command(name="images", short_help="Builds, joins and tests images, each as soon as possible.")
@sharing(*_STEP)
@click.option("--minutes", type=click.FloatRange(min=0), help="start no further image after this many minutes")
def images(minutes: float | None, **options: Any) -> None:
    """Builds, joins and tests images, each as soon as possible: 'build', 'join-images' and 'test' in one command.

    If a run ends early, the images tested so far can get their tags, and the next run continues.

    \b
    Example:
      rosml publish images --plan plan.json --shard amd64-1 --minutes 310
    """
    from rosml.images.publish import steps

    call = Call(**options)
    run = call.run()
    steps.images(run, math.inf if minutes is None else minutes)
    call.report(run)


_step(
    "index",
    "Makes indexes over the architectures of images. All must be built, tested and alike. No tag moves.",
    _GATED,
)
_step(
    "promote",
    "Moves tags to the indexes of images that passed everything. It records the earlier digests, for 'undo'.",
    _GATED,
)


@main.command(name="all", short_help="Does all steps, for images that are out of date or missing.")
@sharing("registry", "matrix", "only", "since", "at-most", "architecture", "serve", "force", "date")
@sharing("require-scan", "policy", "sign", "json")
def everything(**options: Any) -> None:
    """Builds, joins, tests and publishes all images that are out of date or missing: every step, one after the other.

    --require-scan scans, with the database that 'scan --fetch' left. --sign signs, with cosign ('rosml setup signer').

    If a run is interrupted, the next one completes it.

    \b
    Examples:
      rosml publish all --only 'ros1-bookworm-core*' --serve amd64
      rosml publish all --since origin/main --at-most 2 --serve amd64
    """
    from rosml.cli.images import report
    from rosml.images.publish.steps import STEPS

    call = Call(**options)
    run = call.run()
    for line in report.waiting(run.state):
        say(as_called(line))
    for name, step in STEPS.items():
        if name == "index" and call.require_scan:
            _scan(call, run)
        step(run)
    call.report(run)


def _scan(
    call: Call,
    run: Run,
    fetch: bool = False,
    database: str = "",
    reports: Path | None = None,
    results: Results | None = None,
) -> judge.Run:
    """Scans by a call's policy, with the database on this machine or a fetched one."""
    from rosml.images.publish.steps.scan import scan as scan_images
    from rosml.images.scan import policy
    from rosml.images.scan.trivy import ScannerFailed, Trivy

    rules = policy.load(call.policy)
    try:
        trivy: Trivy | ScannerFailed = Trivy.find(ROOT, environment=run.state.request.services.trusting())
        if fetch and isinstance(trivy, Trivy):
            trivy.fetch(rules.policy.database, database, say)
    except ScannerFailed as error:  # the outcome of every image says so
        trivy = error
    return scan_images(run, rules, trivy, reports, results)


@main.command(short_help="Scans images for known vulnerabilities.")
@sharing("registry", "matrix", "only", "plan", "shard", "date", "policy", "json")
@click.option("--fetch", is_flag=True, help="fetch the database of vulnerabilities first; once per run")
@click.option(
    "--database", default="", metavar="REFERENCE", help="the database that all machines of a run use, by digest"
)
@click.option(
    "--reports", type=click.Path(path_type=Path, file_okay=False), help="a folder for SARIF, with one file per image"
)
@click.option(
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="write the results into this file, for 'record', and nothing into the registry: read access is enough",
)
def scan(fetch: bool, database: str, reports: Path | None, output: Path | None, **options: Any) -> None:
    """Scans images for known vulnerabilities, by the policy in scan.yaml. Needs 'rosml setup scanner'.

    Exits with 3 if the policy stops an image, and with 4 if the scanner failed and nothing is known.

    \b
    Examples:
      rosml publish scan --fetch --only 'ros1-bookworm-core*' --reports sarif
      rosml publish scan --plan plan.json --fetch --output scan.json
    """
    from rosml.cli.images import report
    from rosml.cli.images.tables import print_scan
    from rosml.images.publish.scan_results import Results

    call = Call(**options)
    run = call.run()
    results = Results(output, run.state.date) if output else None
    verdict = _scan(call, run, fetch, database, reports, results)
    if results:
        results.write()
    if not call.as_json:
        print_scan(verdict)
    report.show(run, call.as_json)
    raise SystemExit(verdict.outcome.exit_code)


@main.command(short_help="Prints the newest database of vulnerabilities.")
@sharing("policy", "json")
def database(policy: Path, as_json: bool) -> None:
    """Prints the reference of the newest database of vulnerabilities, by digest: for 'scan --database' on several
    machines.

    \b
    Example:
      rosml publish scan --fetch --database "$(rosml publish database)"
    """
    from rosml.images.scan import trivy
    from rosml.images.scan.policy import load
    from rosml.machine.services import Services
    from rosml.registry import references
    from rosml.registry.client import Registries

    def head(reference: str) -> str:
        place = references.parse(reference)
        return registries(place.host).head(place.repository, place.reference)

    with Registries(Services.load(ROOT).ca_bundle) as registries:
        reference = trivy.resolve(load(policy).policy.database, head)
    terminal.echo(json.dumps({"database": reference}) if as_json else reference)


@main.command(short_help="Writes the results of a scan into the registry.")
@sharing("registry", "matrix", "only", "plan", "date", "json")
@click.argument("file", type=FILE)
def record(file: Path, **options: Any) -> None:
    """Writes results into the registry. 'scan --output FILE' made FILE on a machine without write access.

    \b
    Example:
      rosml publish record scan.json --plan plan.json
    """
    from rosml.images.publish import scan_results

    call = Call(**options)
    run = call.run()
    scan_results.record(run, file)
    call.report(run)


@main.command(alone=True, short_help="Keeps one issue on GitHub while images are not published.")
@click.argument("file", type=FILE)
@click.option(
    "--open", "unpublished", type=click.IntRange(min=0), required=True, help="how many images are not published"
)
def issue(file: Path, unpublished: int) -> None:
    """Keeps one issue open in the repository on GitHub, with the text of FILE, while images are not published.

    Works in a job of GitHub Actions. GITHUB_TOKEN has the job's token.

    \b
    Example:
      rosml publish issue night.md --open 3
    """
    from rosml.images.publish.issue import LONGEST, Issues

    api, repository = os.environ.get("GITHUB_API_URL", ""), os.environ.get("GITHUB_REPOSITORY", "")
    issues = Issues(api, repository, os.environ.get("GITHUB_TOKEN", ""))
    say(issues.keep(files.limited(file, 4 * LONGEST).decode(errors="replace"), unpublished))


@main.command(alone=True, short_help="Moves the tags of a run back to their earlier digests.")
@sharing("registry", "json")
@click.argument("run", required=False)
@click.option("--dry-run", is_flag=True, help="show where each tag would go, and move none")
def undo(run: str | None, dry_run: bool, **options: Any) -> None:
    """Moves the tags of RUN back to where they were before it.

    RUN is the date of a run, such as 2026-11-22T03:00:00Z. Without RUN, it is the last run that moved a tag there; if that is older than
    a day, you have to name it. The command says first which run it is, and how many tags. A tag that a later run moved stays where it is.

    Without --registry, it is that of the set in this folder, or the local one. With --registry, the command needs no other service.

    \b
    Examples:
      rosml publish undo --registry ghcr.io/me/rosml --dry-run
      rosml publish undo 2026-11-22T03:00:00Z --registry ghcr.io/me/rosml
    """
    from rosml.base.clock import now
    from rosml.base.errors import RosmlError
    from rosml.base.problems import counted
    from rosml.base.units import ago
    from rosml.cli.images import report
    from rosml.images.publish import undo as undoing
    from rosml.images.records.store import Records

    if run is not None and not run.strip():
        text = "the run is an empty word"
        raise RosmlError(text, "name its date, or leave it out for the last run", exit_code=2)
    started, call = time.monotonic(), Call(**options)
    place = place_of(call.registry, ROOT)
    with place.client as client:
        date, book = now(), Records(place)
        recorded = undoing.find(book, run or "")
        age = recorded.age(date)
        text = f"the run of {recorded.date}{f', {ago(age.total_seconds())}' if age is not None else ''}"
        say(f"{text}: {counted(len(recorded.moves), 'tag')} in {place}")
        if dry_run:
            _foresee(book, recorded, call.as_json)
            return
        if not run and (age is None or age > undoing.RECENT):
            text = f"the last run that moved a tag in {place} is {text}, and no run was named"
            raise RosmlError(text, f"name it if you mean it: rosml publish undo {recorded.date} --registry {place}", 2)
        outcomes = undoing.undo(book, date, recorded)
        report.print_outcomes(outcomes, date, client.uploaded, started, call.as_json)
    if any(outcome.state == "failed" for outcome in outcomes):
        raise SystemExit(1)


def _foresee(book: Records, recorded: RecordedRun, as_json: bool) -> None:
    """Shows what an undo would do."""
    from rosml.images.publish.undo import whereabouts

    rows = [
        (f"{move.repository}:{move.tag}", recorded.foreseen(move, digest), digest)
        for move, digest in whereabouts(book, recorded)
    ]
    if as_json:
        tags = [{"tag": tag, "now": digest, "what": what} for tag, what, digest in rows]
        terminal.echo(json.dumps({"run": recorded.date, "tags": tags}, indent=2))
        return
    for tag, what, _ in rows:
        terminal.echo(f"{tag}  {what}")
    terminal.echo("nothing was changed")


@main.command(alone=True, short_help="Publishes rosdep's lists, for 'rosml containerize'.")
@sharing("registry", "json")
@click.argument("checkout", type=click.Path(path_type=Path, exists=True, file_okay=False), required=False)
def rosdep(checkout: Path | None, as_json: bool, **options: Any) -> None:
    """Publishes rosdep's lists for 'rosml containerize', from ros/rosdistro on GitHub or from a CHECKOUT of it.

    They get the tag latest and one with today's date. The same lists have the same digest.

    \b
    Example:
      rosml publish rosdep --registry ghcr.io/me/rosml
    """
    from rosml.containerize.base_image import rosdep_index

    place = place_of(options["registry"], ROOT)
    with place.client as client, rosdep_index.checkout(checkout) as folder:
        tags = (f"{datetime.now(UTC):%Y%m%d}", "latest")
        digest = rosdep_index.publish(folder, client, place.path(rosdep_index.NAME), tags)
        names = [f"{place.reference(rosdep_index.NAME)}:{tag}" for tag in tags]
    terminal.echo(json.dumps({"tags": names, "digest": digest}) if as_json else f"{names[0]}  {digest}")


@main.command(alone=True, short_help="Lists what the registry no longer needs, or removes it.")
@sharing("registry", "matrix", "json")
@click.option(
    "--days",
    type=click.IntRange(min=0, max=36500),
    default=30,
    show_default=True,
    help="keep dated tags younger than this",
)
@click.option(
    "--newest",
    type=click.IntRange(min=0),
    default=3,
    show_default=True,
    help="always keep this many dated tags of each image",
)
@click.option("--apply", is_flag=True, help="remove it; without this option, the command only lists what can go")
def prune(days: int, newest: int, apply: bool, **options: Any) -> None:
    """Lists what the registry no longer needs. With --apply, removes it.

    Whatever a kept tag leads to stays: its index, the images of the index, and what is attached to them. With
    --registry, the command needs no other service.

    \b
    Examples:
      rosml publish prune --days 60
      rosml publish prune --apply
    """

    from rosml.images.image_set import load as loading
    from rosml.images.publish.prune import STAYS, Pruner

    call = Call(**options)
    image_set = loading.without_locks(call.matrix)
    place = place_of(call.registry, ROOT)
    with place.client:
        pruner = Pruner(place, image_set, datetime.now(UTC).date(), days, newest)
        pruning = pruner.find()
        if not call.as_json:
            for repository, tag in pruning.tags:
                terminal.echo(f"{repository}:{tag}")
            for repository, digest in pruning.manifests:
                terminal.echo(f"{repository}@{digest}")
            counts = f"{len(pruning.tags)} tags and {len(pruning.manifests)} manifests"
            terminal.echo(f"{counts} can go; {pruning.kept} tags stay")
        if apply:
            for line in pruner.remove(pruning):
                say(line if STAYS in line else f"removed: {line}")
    if call.as_json:  # at the end: an error during the removal prints its own object
        terminal.echo(json.dumps(pruning.to_json(), indent=2))
    elif not apply and (pruning.tags or pruning.manifests):
        terminal.echo("nothing was removed; add --apply")
