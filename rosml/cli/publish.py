"""Builds, tests and publishes images: the commands of a publishing run, and of what it published."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import file_lock
from rosml.base.words import in_words
from rosml.cli import completion, options
from rosml.cli.options import Function, place_of

if TYPE_CHECKING:
    from rosml.images.image_set import ImageSet
    from rosml.machine.services import Services
    from rosml.publish.pipeline import Pipeline
    from rosml.scan.judge import Run
    from rosml.scan.results import Results


KEPT = "interrupted: no tag points at what is not finished; what was finished is kept, the next call carries on"
"""What is said after Ctrl-C."""


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
def cli() -> None:
    """Builds, tests and publishes images of matrix.yaml: the steps of a publishing run, and what is done with published tags.

    \b
    Examples:
      rosml publish all --registry ghcr.io/me/rosml --only 'bookworm-*' --serve amd64
      rosml publish undo --registry ghcr.io/me/rosml
    """


def say(line: str) -> None:
    """Tells people what begins now."""
    click.echo(click.style(f"==> {in_words(line)}", bold=True), err=True)


def wait_for_turn() -> None:
    """Waits until no other publishing run of this checkout is under way; the turn ends with the command."""
    turn = file_lock.turn(
        ROOT / ".state/publish.lock", lambda: say("waiting for another publishing run of this checkout")
    )
    click.get_current_context().with_resource(turn)


def _namespace(_context: click.Context, _parameter: click.Parameter, value: str) -> str:
    """A part of a repository's name, checked before it becomes one."""
    if not re.fullmatch(r"[a-z0-9]+([._-]+[a-z0-9]+)*(/[a-z0-9]+([._-]+[a-z0-9]+)*)*", value):
        raise click.BadParameter(f"{value!r} is no part of a repository's name, such as rosml or my-team/rosml")
    return value


def _options(*names: str) -> Callable[[Function], Function]:
    """Options that several commands share, by name."""

    def decorate(function: Function) -> Function:
        for name in reversed(names):
            function = _OPTIONS[name](function)
        return function

    return decorate


_OPTIONS: dict[str, Callable[[Function], Function]] = {
    "registry": options.registry("where images go"),
    "matrix": options.MATRIX,
    "namespace": click.option(
        "--namespace",
        default="rosml",
        show_default=True,
        callback=_namespace,
        help="first part of the repositories' names",
    ),
    "only": options.ONLY,
    "architecture": click.option(
        "--architecture",
        "architectures",
        multiple=True,
        metavar="NAME",
        callback=options.words,
        help="work for it; repeatable; this machine's own if left out",
    ),
    "serve": click.option(
        "--serve",
        multiple=True,
        metavar="NAME",
        callback=options.words,
        help="architectures that this registry serves; repeatable; all of the matrix if left out",
    ),
    "force": click.option(
        "--force", is_flag=True, envvar="ROSML_FORCE", help="make everything anew, without the builder's cache"
    ),
    "plan": click.option(
        "--plan",
        "plan_file",
        type=click.Path(path_type=Path, exists=True),
        help="what 'plan' wrote: its date and images",
    ),
    "shard": click.option("--shard", default="", metavar="NAME", help="of --plan: only what it builds"),
    "date": click.option(
        "--date", default="", metavar="TIME", help="the run's date, such as 2026-11-22T03:00:00Z; now"
    ),
    "since": click.option(
        "--since", default="", metavar="REV", help="only images that differ from a git revision: for pull requests"
    ),
    "at-most": click.option(
        "--at-most",
        type=click.IntRange(min=1),
        default=4,
        show_default=True,
        help="with --since: so many of them, chosen to have one for all that changed",
    ),
    "require-scan": click.option(
        "--require-scan", is_flag=True, help="images get tags only after a scan by the policy that found them clean"
    ),
    "sign": click.option(
        "--sign",
        is_flag=True,
        envvar="ROSML_SIGN",
        help="sign indexes, with the key that COSIGN_KEY names or as the workflow; without a signature none gets a tag",
    ),
    "policy": click.option(
        "--policy",
        type=click.Path(path_type=Path),
        default=ROOT / "scan.yaml",
        help="the file that says which vulnerabilities keep an image from its tags; scan.yaml if left out",
    ),
    "json": options.JSON,
}


@cli.command()
@click.argument("target", default="", type=completion.Name("targets"))
@_options("matrix", "namespace")
@click.option(
    "--platform",
    default="",
    metavar="PLATFORM",
    help="build and test for it, such as linux/arm64; no tag moves where it is not the machine's own",
)
@click.option("--check", is_flag=True, help="only say whether there is such an image; needs no services")
@_options("force", "json")
def image(target: str, matrix: Path, namespace: str, platform: str, check: bool, force: bool, as_json: bool) -> None:
    """Builds TARGET and what it stands on, runs its structure tests, and moves its tags in the local registry.

    It is a publishing run for one image: what is as it should be is not made again, and 'status' and the catalogue know
    it afterwards.

    Without TARGET: the one that matrix.yaml names as its default.

    \b
    Examples:
      rosml image bookworm-core-torch-cu128
      rosml image bookworm-base --json
    """
    from rosml.build.maker import require_buildable
    from rosml.cli import summary
    from rosml.images import apt_source, explain, selection
    from rosml.machine import disk
    from rosml.machine.base_images import native_architecture
    from rosml.machine.services import Services
    from rosml.publish import promote

    call = Call(matrix=matrix, force=force)
    image_set = call.image_set
    # A typo is told before anything else happens.
    native = native_architecture()
    architecture = selection.architecture_of(image_set, platform) if platform else native
    wanted = explain.image(image_set, target or image_set.matrix.default.target)
    require_buildable(wanted, architecture)
    apt_source.source(image_set.matrix, wanted.distribution)
    if check:
        return
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder("" if architecture == native else image_set.matrix.architectures[architecture].platform)
    call.registry, call.only = f"{services.registry}/{namespace}", (wanted.target,)
    call.architectures = call.serve = (architecture,)
    wait_for_turn()
    run = call.pipeline()
    there = {target.removeprefix("part-") for target, name in run.plan.by_key if run.plan.made((target, name))}
    disk.require(services.state, disk.needed_mb(image_set, wanted, there), wanted.target)
    run.build()
    run.join()
    run.test([wanted.target])
    moves = None
    if architecture == native and not run.failed:
        run.index()
        moves = promote.Promotion(run).run()
    found = summary.of_image(run, wanted, architecture, moves)
    click.echo(json.dumps(found.to_json(), indent=2) if as_json else found.text())


@cli.command()
@click.argument("parts", nargs=-1, metavar="[NAME]...", type=completion.Name("parts"))
@_options("matrix", "namespace", "json")
@click.option("--markdown", is_flag=True, help="print them as a table in Markdown, for docs/digests.md")
@click.option(
    "--platform", default="", metavar="PLATFORM", help="for this one only, such as linux/arm64; then no tag moves"
)
@click.option("--again", is_flag=True, help="assemble them without the builder's cache")
def part(
    parts: tuple[str, ...], matrix: Path, namespace: str, as_json: bool, markdown: bool, platform: str, again: bool
) -> None:
    """Assembles parts and publishes them in the local registry: what COPY --link adds to an image of one's own.

    For all of their architectures, without emulation. Without NAME: lists them.

    \b
    Examples:
      rosml part cuda-cu128 common-cu128-py311 torch-cu128-py311
    """
    from rosml.build import file_list
    from rosml.build import part as found
    from rosml.images import load as loading
    from rosml.machine.services import Services
    from rosml.registry import oci

    if as_json and markdown:
        raise click.UsageError("--json and --markdown are two forms of the same; use one of them")
    image_set = loading.load(matrix, ROOT)
    wanted = [found.find(image_set, name) for name in dict.fromkeys(parts)]
    if not wanted:
        known = {item.name: [*item.platforms] for item in image_set.parts}
        listed = [{"name": name, "platforms": platforms} for name, platforms in known.items()]
        lines = (f"{name}  {', '.join(platforms)}" for name, platforms in known.items())
        click.echo(json.dumps(listed, indent=2) if as_json else "\n".join(lines))
        return
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    results = []
    for item in wanted:
        results.append(found.publish(services, image_set, item, say, namespace, again, platform))
        with oci.Registry(services.registry) as client:  # what 'join' compares
            file_list.attach_files(services, image_set, client, f"{namespace}/part", results[-1].digest, say)
        if not (as_json or markdown):
            done = results[-1]
            click.echo(f"{done.reference}  bytecode: {done.bytecode or 'none'}  {done.seconds:.0f} s")
            for name, (digest, size) in done.layers.items():
                click.echo(f"  {name}  {digest}  {size / 1e6:.1f} MB")
    if as_json:
        click.echo(json.dumps([done.to_json() for done in results], indent=2))
    elif markdown:
        click.echo(found.markdown(results), nl=False)


# ---- Publishing the matrix -------------------------------------------------------------------------------------------


@dataclass
class Call:
    """What the commands of a publishing run are called with."""

    registry: str = ""
    matrix: Path = ROOT / "matrix.yaml"
    only: tuple[str, ...] = ()
    architectures: tuple[str, ...] = ()
    serve: tuple[str, ...] = ()
    force: bool = False
    plan_file: Path | None = None
    shard: str = ""
    date: str = ""
    as_json: bool = False
    since: str = ""
    at_most: int = 4
    require_scan: bool = False
    sign: bool = False
    policy: Path = ROOT / "scan.yaml"

    def changed(self, image_set: ImageSet) -> tuple[str, ...]:
        """The images to build of those that differ from the revision; ends the command where there are none."""
        from rosml.bake import pull_request
        from rosml.bake.inputs import Inputs
        from rosml.base import ci
        from rosml.machine import revision
        from rosml.machine.base_images import native_architecture

        found = revision.since(self.since, Inputs(ROOT, image_set))
        choice = pull_request.choose(image_set, found, self.architectures or (native_architecture(),), self.at_most)
        say(str(choice))
        ci.summary(f"\n## Images that differ from {self.since}\n\n{choice}\n")
        if not choice.built:
            if self.as_json:
                click.echo(json.dumps({"counts": {}, "outcomes": []}))
            raise click.exceptions.Exit(0)
        return choice.built

    @cached_property
    def image_set(self) -> ImageSet:
        """All that the matrix describes, with the locks of this checkout."""
        from rosml.images import load

        return load.load(self.matrix, ROOT)

    def pipeline(self, reading: bool = False) -> Pipeline:
        """The run, after the registry and the repositories of packages were asked how things are.

        Args:
            reading: nothing will be made. What images stand on is judged for all of its architectures, and with a
                registry named, no service of this machine is needed.
        """
        from rosml.base import clock
        from rosml.images import selection
        from rosml.machine import trust
        from rosml.publish import pipeline as running
        from rosml.publish import plan as planning
        from rosml.publish import plan_file
        from rosml.publish.sign import Signer
        from rosml.registry import oci, repositories
        from rosml.scan import policy

        started = time.monotonic()
        image_set = self.image_set
        upstream: Mapping[str, str] = {}
        if self.plan_file:
            plan = plan_file.read_plan(self.plan_file, self.shard)
            self.date, self.registry = self.date or plan.date, self.registry or plan.registry
            self.only = self.only or plan.targets
            self.architectures = self.architectures or plan.architectures
            self.serve, self.force = self.serve or plan.serve, self.force or plan.force
            upstream = plan.upstream
        elif self.shard:
            raise click.UsageError("--shard is one of a plan: add --plan FILE")
        selection.require_architectures(image_set, self.serve)  # with a typo nothing would ever get a tag
        if self.since:
            if self.only:
                raise click.UsageError("--since says which images; leave --only out")
            self.only = self.changed(image_set)
        selection.select(image_set, self.only)
        if self.date:
            clock.checked_date(self.date)
        services = self.services(reading)
        if not self.registry:
            services.require_registry()
        place = repositories.destination(self.registry or services.place)
        signer = Signer.find(ROOT, trust.trusting(services)) if self.sign else None  # told before anything is built
        client = oci.Registry(place.host, ca_bundle=services.ca_bundle)
        date = self.date or clock.now()
        if not self.force:
            clock.require_not_ahead(date, clock.now())
        scanning = running.policy_digest(policy.load(self.policy)) if self.require_scan else ""
        found = planning.survey(
            services,
            image_set,
            client,
            place.prefix,
            self.only,
            self.architectures,
            self.force,
            scanning,
            date,
            upstream=upstream,
            whole=reading,
        )
        for remark in found.remarks:
            say(remark)
        return running.Pipeline(
            found, client, place.host, place.prefix, say, self.serve, signer=signer, started=started
        )

    def services(self, reading: bool) -> Services:
        """Those of this machine; none are needed where nothing will be made and a registry is named."""
        from rosml.base.errors import RosmlError
        from rosml.machine.services import Services

        try:
            return Services.load(ROOT, required=not (reading and self.registry))
        except RosmlError as error:
            raise (options.unnamed(error) if reading else error) from None

    def report(self, pipeline: Pipeline) -> None:
        """Prints what was done; ends with 1 where something failed."""
        from rosml.cli import report

        report.show(pipeline, self.as_json)
        if pipeline.failed:
            raise SystemExit(1)


@cli.command()
@_options("registry", "matrix", "only", "architecture", "serve", "force", "date", "json")
@click.option(
    "--everywhere",
    is_flag=True,
    help="plan for all architectures that the registry serves, each on machines of its own",
)
@click.option(
    "--shards",
    type=click.IntRange(min=1),
    default=8,
    show_default=True,
    help="among how many machines builds are dealt out, at most",
)
@click.option("--why", is_flag=True, help="name the inputs that changed")
@click.option(
    "--output", type=click.Path(path_type=Path, dir_okay=False), help="write the plan there, for the other steps"
)
def plan(everywhere: bool, shards: int, why: bool, output: Path | None, **options: Any) -> None:
    """Says what is to be done: which images are not as they should be, and why.

    Compares the inputs of every image, and the dates of the packages that it is built from, with what the registry's
    records say. No later step touches unchanged images. Also with --registry, it needs what 'rosml setup', or 'rosml setup
    client', leaves in the checkout.

    \b
    Examples:
      rosml plan --why
      rosml plan --only 'bookworm-*' --output plan.json
    """
    from rosml.base import files
    from rosml.cli import report

    call = Call(**options)
    if everywhere:
        call.architectures = call.serve or tuple(call.image_set.matrix.architectures)
    pipeline = call.pipeline()
    text = report.plan_json(pipeline, shards, why)
    if output:
        files.write(output, text)
        report.tell(text)
    if call.as_json:
        click.echo(text, nl=False)
    else:
        report.print_plan(pipeline, why)


_STEP = ("registry", "matrix", "only", "architecture", "serve", "force", "plan", "shard", "date", "json")
_GATED = (*_STEP, "require-scan", "policy", "sign")


def _step(name: str, help_text: str, options: tuple[str, ...] = _STEP) -> None:
    """A command for a step of the pipeline."""

    @cli.command(name, help=f"{help_text}\n\n\b\nExample:\n  rosml publish {name} --plan plan.json --shard amd64-1")
    @_options(*options)
    def command_of_step(**options: Any) -> None:
        from rosml.publish.steps import STEPS

        call = Call(**options)
        wait_for_turn()
        pipeline = call.pipeline()
        STEPS[name](pipeline)
        call.report(pipeline)


_step("build", "Builds ROS images and parts that are not as they should be, and pushes them by digest.")
_step("join", "Puts images with frameworks together in the registry, from ROS images and parts; pulls nothing.")
_step("test", "Runs the structure tests of images that have not passed them, on their architecture.")
_step("index", "Makes indexes of images whose architectures are all there, tested and alike. No tag moves.", _GATED)
_step("promote", "Moves tags to the indexes of images that passed everything; remembers where they were.", _GATED)


@cli.command(name="all")
@_options("registry", "matrix", "only", "since", "at-most", "architecture", "serve", "force", "date")
@_options("require-scan", "policy", "sign", "json")
def everything(**options: Any) -> None:
    """Builds, joins, tests and publishes all that is not as it should be: every step, one after the other.

    Scans where --require-scan is given, with the database that 'scan --fetch' left. Signs where --sign is given, with
    cosign ('rosml setup signer').

    Interrupted at any point, the next call goes on where it was.

    \b
    Examples:
      rosml publish all --only 'bookworm-core*' --serve amd64
      rosml publish all --since origin/main --at-most 2 --serve amd64
    """
    from rosml.publish.steps import STEPS

    call = Call(**options)
    wait_for_turn()
    pipeline = call.pipeline()
    for name, step in STEPS.items():
        if name == "index" and call.require_scan:
            _scan(call, pipeline)
        step(pipeline)
    call.report(pipeline)


def _scan(
    call: Call,
    pipeline: Pipeline,
    fetch: bool = False,
    database: str = "",
    reports: Path | None = None,
    results: Results | None = None,
) -> Run:
    """Scans by a call's policy, with the database that is there or is fetched."""
    from rosml.machine import trust
    from rosml.scan import policy
    from rosml.scan.trivy import ScannerFailed, Trivy

    rules = policy.load(call.policy)
    try:
        trivy: Trivy | ScannerFailed = Trivy.find(ROOT, environment=trust.trusting(pipeline.plan.services))
        if fetch and isinstance(trivy, Trivy):
            trivy.fetch(rules.policy.database, database, say)
    except ScannerFailed as error:  # every image says so
        trivy = error
    return pipeline.scan(rules, trivy, reports, results)


@cli.command()
@_options("registry", "matrix", "only", "plan", "shard", "date", "policy", "json")
@click.option("--fetch", is_flag=True, help="fetch the database of vulnerabilities first; once per run")
@click.option("--database", default="", metavar="REFERENCE", help="the one that all machines of a run take, by digest")
@click.option(
    "--reports", type=click.Path(path_type=Path, file_okay=False), help="a folder for SARIF, a file per image"
)
@click.option(
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="write what was found there, for 'record', and nothing into the registry: reading is enough",
)
def scan(fetch: bool, database: str, reports: Path | None, output: Path | None, **options: Any) -> None:
    """Scans images for known vulnerabilities, by the policy in scan.yaml. Needs 'rosml setup scanner'.

    Exits with 3 where the policy stops an image, with 4 where the scanner failed and nothing is known.

    \b
    Examples:
      rosml publish scan --fetch --only 'bookworm-core*' --reports sarif
      rosml publish scan --plan plan.json --fetch --output scan.json
    """
    from rosml.cli import report
    from rosml.cli.tables import print_scan
    from rosml.scan.results import Results

    call = Call(**options)
    wait_for_turn()
    pipeline = call.pipeline()
    results = Results() if output else None
    run = _scan(call, pipeline, fetch, database, reports, results)
    if output and results:
        results.write(output, pipeline.plan.date)
    if not call.as_json:
        print_scan(run)
    report.show(pipeline, call.as_json)
    raise SystemExit(run.outcome.exit_code)


@cli.command()
@_options("policy", "json")
def database(policy: Path, as_json: bool) -> None:
    """Prints which database of vulnerabilities is the newest, by digest: for 'scan --database' on several machines.

    \b
    Example:
      rosml publish scan --fetch --database "$(rosml publish database)"
    """
    from rosml.machine.services import Services
    from rosml.registry import oci
    from rosml.scan import trivy
    from rosml.scan.policy import load

    def head(reference: str) -> str:
        place = oci.parse(reference)
        return registries(place.host).head(place.repository, place.reference)

    with oci.Registries(Services.load(ROOT).ca_bundle) as registries:
        found = trivy.resolve(load(policy).policy.database, head)
    click.echo(json.dumps({"database": found}) if as_json else found)


@cli.command()
@_options("registry", "matrix", "only", "plan", "date", "json")
@click.argument("file", type=click.Path(path_type=Path, exists=True, dir_okay=False))
def record(file: Path, **options: Any) -> None:
    """Writes into the registry what 'scan --output FILE' found on a machine that may not.

    \b
    Example:
      rosml publish record scan.json --plan plan.json
    """
    from rosml.publish import scan_results

    call = Call(**options)
    wait_for_turn()
    pipeline = call.pipeline()
    scan_results.record(pipeline, file)
    call.report(pipeline)


@cli.command()
@_options("registry", "matrix", "only", "architecture", "serve", "json")
def status(**options: Any) -> None:
    """Shows how every image stands: published, outdated, failed, missing, lock missing, or waiting
    for a builder; and why.

    With --registry, it needs no service of this machine: it asks that registry, and for images of a live repository of
    packages, that repository for its date.

    \b
    Examples:
      rosml status --only 'bookworm-*'
      rosml status --registry ghcr.io/me/rosml --json
    """
    from rosml.base.clock import now
    from rosml.cli import tables
    from rosml.publish import status as states

    call = Call(**options)
    pipeline = call.pipeline(reading=True)
    found = list(states.read(pipeline.plan, pipeline.registry, pipeline.prefix, now(), pipeline.serving))
    if call.as_json:
        click.echo(states.as_json(found))
    else:
        tables.print_status(found)


@cli.command()
@_options("registry", "json")
@click.argument("run", default="")
def undo(run: str, **options: Any) -> None:
    """Moves the tags of RUN back to where they were; of the last run if left out.

    RUN is the date of a run. A tag that has moved on since stays where it is. With --registry, it needs that registry
    alone.

    \b
    Examples:
      rosml publish undo
      rosml publish undo 2026-11-22T03:00:00Z --registry ghcr.io/me/rosml
    """
    from rosml.base.clock import now
    from rosml.cli import report
    from rosml.publish import undo as undoing
    from rosml.records.store import Records

    started, call = time.monotonic(), Call(**options)
    client, prefix = place_of(call.registry, ROOT)
    with client:
        date = now()
        outcomes = undoing.undo(Records(client, prefix), date, run)
        report.tell_outcomes(outcomes, date, client.uploaded, started, call.as_json)
    if any(outcome.state == "failed" for outcome in outcomes):
        raise SystemExit(1)


@cli.command()
@_options("registry", "matrix", "json")
@click.option(
    "--days",
    type=click.IntRange(min=0, max=36500),
    default=30,
    show_default=True,
    help="dated tags younger than that stay",
)
@click.option(
    "--newest",
    type=click.IntRange(min=0),
    default=3,
    show_default=True,
    help="so many dated tags of each image stay in any case",
)
@click.option("--apply", is_flag=True, help="remove it; without that, only says what would go")
def prune(days: int, newest: int, apply: bool, **options: Any) -> None:
    """Says what the registry no longer needs, and with --apply removes it.

    What a kept tag leads to stays: an index, its images, and what is attached to them. With --registry, it needs that
    registry alone.

    \b
    Examples:
      rosml publish prune --days 60
      rosml publish prune --apply
    """

    from rosml.images import load as loading
    from rosml.matrix import source
    from rosml.publish.prune import STAYS, Pruner

    call = Call(**options)
    image_set = loading.image_set(source.read(call.matrix))  # without its locks: it names repositories
    client, prefix = place_of(call.registry, ROOT)
    with client:
        pruner = Pruner(client, prefix, image_set, datetime.now(UTC).date(), days, newest)
        found = pruner.find()
        if not call.as_json:
            for repository, tag in found.tags:
                click.echo(f"{repository}:{tag}")
            for repository, digest in found.manifests:
                click.echo(f"{repository}@{digest}")
            click.echo(f"{len(found.tags)} tags and {len(found.manifests)} manifests can go; {found.kept} tags stay")
        if apply:
            for line in pruner.remove(found):
                say(line if STAYS in line else f"removed: {line}")
    if call.as_json:  # at the end: an error while it is removed is an object of its own
        click.echo(json.dumps(found.to_json(), indent=2))
    elif not apply and (found.tags or found.manifests):
        click.echo("nothing was removed; add --apply")
