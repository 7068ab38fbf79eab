"""Runs the suite, and says where its time went.

`make test` is what every change must pass. `make test-all` is that and every proof of tests/proofs.py; `SHARD=i/n` deals them out
to n machines, `PROOF=name` runs one of them.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path

import click

from rosml.cli import command
from tests.proofs import PROOFS

ROOT = Path(__file__).resolve().parent.parent
LOGS = ROOT / ".state" / "log"
LANES = ("--numprocesses=2", "--dist=loadfile", "--no-loadscope-reorder", "--verbose")
QUIET = ("--quiet", "--override-ini=log_cli=false")
"""For thousands of tests that take no time: a point for each of them."""
MEMORY_BYTES = 2 << 30
"""More than the files of unit tests at any time."""
CLEANING_SECONDS = 60.0
"""How long pytest may take to clean up after Ctrl-C."""
QUICK_MINUTES = 30.0
"""About how long `make test` takes on two cores."""


@dataclass(frozen=True)
class Phase:
    """One call of pytest, or of something else."""

    name: str
    command: Sequence[str]
    environment: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """How a phase ended: seconds, exit code, and what its tests came to."""

    name: str
    seconds: float
    code: int
    passed: int = 0
    failed: int = 0
    skipped: int = 0


def in_memory() -> dict[str, str]:
    """Has thousands of small files written to memory instead of a disk, which is waited for at each; where there is room."""
    memory = Path("/dev/shm")
    roomy = memory.is_dir() and os.access(memory, os.W_OK) and shutil.disk_usage(memory).free > MEMORY_BYTES
    return {"TMPDIR": str(memory)} if roomy else {}


def pytest(*arguments: str) -> list[str]:
    """A call of pytest in this environment."""
    return [sys.executable, "-m", "pytest", *arguments]


BESIDE = (
    *QUIET,
    f"--numprocesses={(os.cpu_count() or 1) + 1}",
    "--dist=worksteal",
    "--override-ini=tmp_path_retention_policy=failed",
)
"""One more at a time than there are processors, since some wait, which take tests from one another in the end."""
BROWSERS = (*QUIET, "--numprocesses=2", "--dist=worksteal")
"""A browser for each of two processors."""

QUICK = {
    "unit": Phase("linters and unit tests", pytest(*BESIDE, "-m", "not full", "tests/lint", "tests/unit"), in_memory()),
    "page": Phase("the catalogue's page", pytest(*BROWSERS, "tests/page")),
    "images": Phase("real images", pytest(*LANES, "-m", "not full", "tests/e2e")),
}
"""What `make test` runs after the set-up, by the name of each for --phase."""


def proof_phase(name: str) -> Phase:
    """The call that proves something."""
    proof = PROOFS[name]
    tests = proof.tests or ("-m", f'full(proof="{name}")', "tests/e2e")
    return Phase(f"proof: {name}", pytest(*LANES, *tests), proof.environment)


def environment() -> dict[str, str]:
    """This process' own, without what would have pytest run other tests or other plugins, or Python compile the same modules
    in each of hundreds of processes."""
    dropped = ("PYTEST_ADDOPTS", "PYTEST_PLUGINS", "PYTHONDONTWRITEBYTECODE")
    return {name: value for name, value in os.environ.items() if name not in dropped}


def run(phase: Phase) -> Outcome:
    """Runs a phase. Its output is on the terminal and in a log."""
    click.secho(f"==> {phase.name}", bold=True, err=True)
    LOGS.mkdir(parents=True, exist_ok=True)
    name = re.sub(r"[^a-z0-9]+", "-", phase.name)
    log, counts = LOGS / f"test-{name}.log", LOGS / f"test-{name}.xml"
    counts.unlink(missing_ok=True)
    started = time.monotonic()
    with log.open("wb") as stream:
        argv, env = [*phase.command, f"--junitxml={counts}"], {**environment(), **phase.environment}
        null, pipe, together = subprocess.DEVNULL, subprocess.PIPE, subprocess.STDOUT
        process = subprocess.Popen(argv, cwd=ROOT, env=env, stdin=null, stdout=pipe, stderr=together)
        assert process.stdout
        try:
            while data := os.read(process.stdout.fileno(), 1 << 16):
                stream.write(data)
                sys.stdout.buffer.write(data)
                sys.stdout.flush()
        except BaseException:
            with suppress(subprocess.TimeoutExpired):  # Ctrl-C reached pytest as well, which stops what it has started
                process.wait(timeout=CLEANING_SECONDS)
            process.terminate()
            process.wait()
            raise
        code = process.wait()
    return Outcome(phase.name, time.monotonic() - started, code, *_counts(counts))


def _counts(file: Path) -> tuple[int, int, int]:
    """Tests that passed, failed and were skipped, by a report in JUnit's form; none where there is no report."""
    if not file.is_file():
        return 0, 0, 0
    try:
        suites = list(ElementTree.parse(file).getroot().iter("testsuite"))
    except ElementTree.ParseError:
        return 0, 0, 0
    total, failed, errors, skipped = (
        sum(int(suite.get(name, "0")) for suite in suites) for name in ("tests", "failures", "errors", "skipped")
    )
    return total - failed - errors - skipped, failed + errors, skipped


def deal(shard: int, shards: int) -> tuple[bool, list[str]]:
    """What one of several machines runs: whether `make test` is in it, and which proofs; the longest are dealt first, each to
    the machine that has least."""
    loads = [0.0] * shards
    loads[0] = QUICK_MINUTES
    mine = []
    for name in sorted(PROOFS, key=lambda name: (-PROOFS[name].minutes, name)):
        least = loads.index(min(loads))
        loads[least] += PROOFS[name].minutes
        if least == shard - 1:
            mine.append(name)
    return shard == 1, sorted(mine)


def set_up(need: str) -> Outcome:
    """Runs a command of scripts/bootstrap.py."""
    started = time.monotonic()
    code = subprocess.run([sys.executable, "scripts/bootstrap.py", need], cwd=ROOT, check=False).returncode
    return Outcome(f"set-up: {need}", time.monotonic() - started, code)


def table(outcomes: Sequence[Outcome]) -> str:
    """Where the time went."""
    rows = [("phase", "time", "passed", "failed", "skipped")]
    for outcome in outcomes:
        failed = f"exit {outcome.code}" if outcome.code and not outcome.failed else str(outcome.failed or "")
        counts = (str(outcome.passed or ""), failed, str(outcome.skipped or ""))
        rows.append((outcome.name, _time(outcome.seconds), *counts))
    rows.append(("all", _time(sum(outcome.seconds for outcome in outcomes)), "", "", ""))
    width = max(len(row[0]) for row in rows)
    return "\n".join(f"{row[0]:<{width}}" + "".join(f"{cell:>10}" for cell in row[1:]) for row in rows)


def _time(seconds: float) -> str:
    return f"{int(seconds // 60)}:{int(seconds % 60):02d}"


class Shard(click.ParamType[tuple[int, int]]):
    """`2/3`: the second of three machines."""

    name = "i/n"

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> tuple[int, int]:
        match = re.fullmatch(r"([1-9]\d*)/([1-9]\d*)", value)
        if not match or int(match[1]) > int(match[2]):
            self.fail(f"{value!r} is no shard; write it as i/n, such as 1/3", param, ctx)
        return int(match[1]), int(match[2])


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--all", "everything", is_flag=True, help="Run every proof as well.")
@click.option("--shard", type=Shard(), default="1/1", show_default=True, help="What one of several machines runs.")
@click.option(
    "--phase", "phases", type=click.Choice(list(QUICK)), multiple=True, help="Run this part of `make test` alone."
)
@click.option("--proof", "chosen", type=click.Choice(list(PROOFS)), multiple=True, help="Run this proof alone.")
@click.option("--check", is_flag=True, help="Only see whether this could run.")
@click.option("--coverage", is_flag=True, help="Measure what the tests run of rosml/.")
@click.option("--started", type=float, help="When the set-up began, in seconds since 1970.")
def main(
    everything: bool,
    shard: tuple[int, int],
    phases: tuple[str, ...],
    chosen: tuple[str, ...],
    check: bool,
    coverage: bool,
    started: float | None,
) -> None:
    """Runs the suite; set-up comes first: `make test`, `make test-all`."""
    quick, proofs = not chosen, list(chosen)
    if everything and not chosen:
        quick, proofs = deal(*shard)
    if check:
        return
    outcomes = [Outcome("set-up", time.time() - started, 0)] if started else []
    todo = [phase for name, phase in QUICK.items() if quick and name in (phases or QUICK)]
    if coverage:
        todo = [replace(phase, command=[*phase.command, "--cov=rosml"]) for phase in todo]
    ended = [run(phase) for phase in todo]
    wrong = []
    for need in sorted({need for name in proofs for need in PROOFS[name].needs}):
        outcomes.append(set_up(need))
        if outcomes[-1].code:
            lacking = [name for name in proofs if need in PROOFS[name].needs]
            wrong.append(f"{need} failed, which these need: not run: {', '.join(lacking)}")
            proofs = [name for name in proofs if name not in lacking]
    ended += [run(proof_phase(name)) for name in proofs]
    wrong += [f"{outcome.name}: failed" for outcome in ended if outcome.code]
    wrong += [f"{outcome.name}: no test ran" for outcome in ended if not (outcome.code or outcome.passed)]
    click.echo(f"\n{table([*outcomes, *ended])}")
    for line in wrong:
        click.secho(line, fg="red", err=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    sys.exit(command.run(main))
