"""What the commands of a publishing run share: their options, and how a run is made from these."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import MATRIX, ROOT
from rosml.base import file_lock, terminal
from rosml.cli import options
from rosml.cli.command import say
from rosml.cli.options import Function

if TYPE_CHECKING:
    from rosml.images.image_set.model import ImageSet
    from rosml.images.publish.plan import Plan
    from rosml.images.publish.run import Run
    from rosml.images.publish.state import State
    from rosml.machine.services import Services
    from rosml.registry.place import Place

KEPT = "interrupted: no tag points at what is not finished; what was finished is kept, the next call carries on"
"""The message after Ctrl-C."""


def _wait_for_turn() -> None:
    """Waits until no other publishing run of this checkout is under way. The turn ends with the command."""
    file = ROOT / ".state/publish.lock"
    waiting = "waiting for another publishing run of this checkout ({})"
    turn = file_lock.turn(file, lambda: say(waiting.format(file_lock.holder(file))))
    click.get_current_context().with_resource(turn)


def _namespace(_context: click.Context, _parameter: click.Parameter, value: str) -> str:
    """Checks the first part of repositories' names."""
    if not re.fullmatch(r"[a-z0-9]+([._-]+[a-z0-9]+)*(/[a-z0-9]+([._-]+[a-z0-9]+)*)*", value):
        raise click.BadParameter(f"{value!r} is no part of a repository's name, such as rosml or my-team/rosml")
    return value


def sharing(*names: str) -> Callable[[Function], Function]:
    """Adds options that several commands share, by name."""

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
        help="work for this one; repeatable; this machine's own if left out",
    ),
    "serve": click.option(
        "--serve",
        multiple=True,
        metavar="NAME",
        callback=options.words,
        help="architectures that this registry serves; repeatable; all of the matrix if left out",
    ),
    "force": click.option(
        "--force", is_flag=True, envvar="ROSML_FORCE", help="rebuild everything, without the builder's cache"
    ),
    "plan": click.option(
        "--plan",
        "plan_file",
        type=click.Path(path_type=Path, exists=True),
        help="a file that 'plan' wrote; take the date and the images from it",
    ),
    "shard": click.option("--shard", default="", metavar="NAME", help="with --plan: only the images of this shard"),
    "date": click.option(
        "--date", default="", metavar="TIME", help="the run's date, such as 2026-11-22T03:00:00Z; now if left out"
    ),
    "since": click.option(
        "--since", default="", metavar="REV", help="only images that differ from this git revision, for pull requests"
    ),
    "at-most": click.option(
        "--at-most",
        type=click.IntRange(min=1),
        default=4,
        show_default=True,
        help="with --since: build at most this many; together they cover the changes",
    ),
    "require-scan": click.option(
        "--require-scan", is_flag=True, help="move tags only to images that a scan by the policy found clean"
    ),
    "sign": click.option(
        "--sign",
        is_flag=True,
        envvar="ROSML_SIGN",
        help="sign indexes, with the key that COSIGN_KEY names or as the workflow; move tags only to signed ones",
    ),
    "policy": click.option(
        "--policy",
        type=click.Path(path_type=Path),
        default=ROOT / "scan.yaml",
        help="the file that decides which vulnerabilities keep an image from its tags; scan.yaml if left out",
    ),
    "json": options.JSON,
}


@dataclass
class Call:
    """The options of a command of a publishing run."""

    registry: str = ""
    matrix: Path = MATRIX
    only: tuple[str, ...] = ()
    architectures: tuple[str, ...] = ()
    serve: tuple[str, ...] = ()
    force: bool = False
    all_tests: bool = False
    even_ended: bool = False  # also images of distributions past their end of life
    plan_file: Path | None = None
    shard: str = ""
    date: str = ""
    as_json: bool = False
    since: str = ""
    at_most: int = 4
    require_scan: bool = False
    sign: bool = False
    policy: Path = ROOT / "scan.yaml"

    @cached_property
    def image_set(self) -> ImageSet:
        """All that the matrix describes, with the locks of this checkout."""
        from rosml.images.image_set import load

        return load.load(self.matrix, ROOT)

    def survey(self, reading: bool = False, turn: bool = False) -> State:
        """Asks the registry and the package repositories for the state of the requested images. `reading`: nothing will be built, so what
        is below is judged on all of its architectures, and a named registry needs no service of this machine. `turn`: waits until no other
        run of this checkout is under way, after errors in the options."""
        from rosml.base import clock
        from rosml.images.image_set import selection
        from rosml.images.publish.state import Request
        from rosml.images.publish.survey import survey
        from rosml.registry.place import Place

        plan = self._take_plan()
        self.registry = self.registry or options.registry_of_set(self.matrix)
        selection.require_architectures(self.image_set, self.serve)  # a typo ends the command before anything is asked
        if self.since:
            if self.only:
                raise click.UsageError("--since chooses the images; leave --only out")
            self.only = self._changed_images()
        selection.select(self.image_set, self.only)
        if self.date:
            clock.checked_date(self.date)
        services = self.services(reading)
        if not self.registry:
            services.require_registry()
        place = Place.at(self.registry or services.place, services.ca_bundle)
        self.only = self._allowed_images(place, reading)
        if turn:
            _wait_for_turn()
        date = self.date or clock.now()
        if not self.force:
            clock.require_not_ahead(date, clock.now())
        request = Request(
            services,
            self.image_set,
            place,
            date,
            self.only,
            self.architectures,
            self.serve,
            self.force,
            self._policy_digest(date) if self.require_scan else "",
            plan.package_state if plan else {},
            whole=reading,
            all_tests=self.all_tests,
            even_ended=self.even_ended,
            elsewhere=self._of_other_shards(plan),
        )
        state = survey(request)
        for remark in state.remarks:
            say(remark)
        return state

    def _take_plan(self) -> Plan | None:
        """Completes the options by the plan, if there is one."""
        from rosml.images.publish.plan import read_plan

        if not self.plan_file:
            if self.shard:
                raise click.UsageError("--shard needs a plan: add --plan FILE")
            return None
        plan = read_plan(self.plan_file, self.shard)
        self.date, self.registry = self.date or plan.date, self.registry or plan.registry
        self.only = self.only or plan.targets
        self.architectures = self.architectures or plan.architectures
        self.serve, self.force = self.serve or plan.serve, self.force or plan.force
        return plan

    def _of_other_shards(self, plan: Plan | None) -> frozenset[str] | None:
        shards = plan.shards if plan else ()
        return next((frozenset((*it.elsewhere, *it.ros_elsewhere)) for it in shards if it.name == self.shard), None)

    def _policy_digest(self, date: str) -> str:
        from rosml.images.publish.steps.scan import policy_digest
        from rosml.images.scan import policy

        return policy_digest(policy.load(self.policy), date)

    def _changed_images(self) -> tuple[str, ...]:
        """The images to build, of those that differ from the revision. If there are none, the command ends."""
        from rosml.base import github
        from rosml.images.bake import pull_request
        from rosml.images.bake.inputs import Inputs
        from rosml.images.builds.base_images import native_architecture
        from rosml.images.publish import revision

        difference = revision.since(self.since, Inputs(ROOT, self.image_set))
        architectures = self.architectures or (native_architecture(),)
        choice = pull_request.choose(self.image_set, difference, architectures, self.at_most)
        say(str(choice))
        github.summary(f"\n## Images that differ from {self.since}\n\n{choice}\n")
        if not choice.built:
            if self.as_json:
                terminal.echo(json.dumps({"counts": {}, "outcomes": []}))
            raise click.exceptions.Exit(0)
        return choice.built

    def _allowed_images(self, place: Place, reading: bool) -> tuple[str, ...]:
        """The images to work on: without those whose restricted parts may not go to the registry. It is an error
        (exit code 2) if the user named one of these."""
        from rosml.base.problems import counted
        from rosml.images.image_set import restricted, selection

        selected = selection.select(self.image_set, self.only)
        refused, warning = restricted.refused(self.image_set, selected, place.client.host, place.prefix)
        if refused and not reading and (self.only or len(refused) == len(selected)):
            raise next(iter(refused.values()))
        if warning:
            say(warning)
        if not refused or self.only:
            return self.only
        many = counted(len(refused), "image")
        say(f"left out, because their restricted parts may not go to {place}: {many}; {restricted.PAGE}")
        return tuple(image.target for image in selected if image.target not in refused)

    def run(self) -> Run:
        """The requested run. It has done nothing yet."""
        from rosml.images.builds.maker import BuildKitMaker
        from rosml.images.publish.cosign import Signer
        from rosml.images.publish.run import Run

        started = time.monotonic()
        # If the signer is missing, the command ends before anything is asked.
        signer = Signer.find(ROOT, self.services(reading=False).trusting()) if self.sign else None
        state = self.survey(turn=True)
        services = state.request.services
        maker = BuildKitMaker(services, self.image_set, state.place, say, self.force, state.forecast)
        return Run(state, maker, say, signer, started)

    def services(self, reading: bool) -> Services:
        """The services of this machine. None are needed if nothing will be built and a registry is named."""
        from rosml.base.errors import RosmlError
        from rosml.machine.services import Services

        try:
            return Services.load(ROOT, required=not (reading and self.registry))
        except RosmlError as error:
            raise (options.unnamed(error) if reading else error) from None

    def report(self, run: Run) -> None:
        """Prints what was done. Exits with 1 if something failed."""
        from rosml.cli.images import report

        report.show(run, self.as_json)
        if run.failed:
            raise SystemExit(1)
