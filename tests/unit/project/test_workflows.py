"""The workflows contain no logic: every step is a command that there is, with options that it has, on a machine that may
do no more than it must."""

from __future__ import annotations

import itertools
import os
import re
import shlex
import subprocess
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import click
import pytest
import yaml
from conftest import ROOT
from workflows import FOLDER, accepted, load, text

from rosml.cli import main
from rosml.cli.images import publish
from rosml.containerize import ci_files

NAMES = ("ci", "locks", "nightly", "proofs")

OFFERED = "containerize"
"""The workflow that other repositories call; test_app_ci_files.py is about it."""

READ = {"contents": "read"}
PULL = {**READ, "packages": "read"}
PUSH = {**READ, "packages": "write"}
PERMISSIONS = {
    ("ci", "check"): READ,
    ("ci", "unit"): READ,
    ("ci", "test"): READ,
    ("ci", "images"): READ,
    ("locks", "time"): READ,
    ("locks", "try"): READ,
    ("locks", "upgrade"): READ,
    ("locks", "propose"): {"contents": "write", "pull-requests": "write"},
    ("nightly", "plan"): PUSH,
    ("nightly", "images"): PUSH,
    ("nightly", "rosdep"): PUSH,
    ("nightly", "scan"): PULL,
    ("nightly", "promote"): {**PUSH, "id-token": "write"},
    ("nightly", "issue"): {**READ, "issues": "write"},
    ("nightly", "prune"): PULL,
    ("nightly", "catalogue"): PULL,
    ("nightly", "pages"): {"pages": "write", "id-token": "write"},
    ("proofs", "all"): READ,
}
"""What each job may do: written down once more, so that nobody gives a job more by the way."""

ACTIONS = {
    "actions/checkout",
    "actions/cache/restore",
    "actions/cache/save",
    "actions/upload-artifact",
    "actions/download-artifact",
    "actions/upload-pages-artifact",
    "actions/deploy-pages",
    "docker/login-action",
    "peter-evans/create-pull-request",
}
"""All that is not ours. The workflows say which version and commit of it, and nothing else does."""

LOGIN = {
    "registry": "${{ env.HOST }}",
    "username": "${{ !vars.ROSML_REGISTRY && github.actor || secrets.ROSML_USER }}",
    "password": "${{ !vars.ROSML_REGISTRY && github.token || secrets.ROSML_PASSWORD }}",
}
"""How every job logs in that asks a registry. Where a fork names its own registry, the job's token stays at home."""

WRITERS = {"repositories", "images", "record", "index", "promote", "rosdep"}
"""Steps that write into the registry."""


@dataclass(frozen=True)
class Step:
    """A step, and where it is."""

    workflow: str
    job: str
    number: int
    content: dict[str, Any]

    @property
    def environment(self) -> dict[str, str]:
        """Variables that it sees, of which each must be one that somebody sets."""
        found = load(self.workflow)
        parts = (found, found["jobs"][self.job], self.content)
        return {name: str(value) for part in parts for name, value in (part.get("env") or {}).items()}

    def __str__(self) -> str:
        return f"{self.workflow}-{self.job}-{self.number}"


def steps() -> Iterator[Step]:
    for workflow in NAMES:
        for job, content in load(workflow)["jobs"].items():
            for number, step in enumerate(content["steps"]):
                yield Step(workflow, job, number, step)


RUNS = [step for step in steps() if "run" in step.content]


def test_these_are_all() -> None:
    assert sorted(path.name for path in FOLDER.iterdir()) == sorted(f"{name}.yml" for name in (*NAMES, OFFERED))


# ---- Commands --------------------------------------------------------------------------------------------------------


def words(step: Step) -> list[str]:
    """The words of a step's command; variables stay as they are written."""
    command = step.content["run"].strip()
    assert "\n" not in command, "one command"
    assert "${{" not in command, "a value that becomes part of a command can become another command"
    lexer = shlex.shlex(command, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    found = list(lexer)
    assert not [word for word in found if re.fullmatch(r"[();<>|&]+", word)], "no shell beside the command"
    assert "`" not in command and "$(" not in command
    for variable in re.findall(r"\$\{?(\w+)", command):
        assert f'"${variable}"' in command, "quoted, and nothing but the variable"
        assert variable in step.environment, f"nobody sets {variable}"
    return found


@pytest.mark.parametrize("step", RUNS, ids=str)
def test_every_command_is_one_that_there_is(step: Step) -> None:
    argv = words(step)
    if argv[0] == "make":
        # Dry: a target that is not there, or a variable that it does not know, is not silently nothing.
        done = subprocess.run(
            ["make", "--dry-run", *argv[1:]], cwd=ROOT, capture_output=True, text=True, check=False, env=os.environ
        )
        assert done.returncode == 0, done.stderr
        for word in argv[1:]:
            name, _, value = word.partition("=")
            assert not value or f"$({name})" in (ROOT / "Makefile").read_text()
        listed = subprocess.run(["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
        assert f"  make {argv[1]} " in listed, "one that people are told of"
        return
    assert argv[0] == "./rosml", "make or rosml"
    accepted(main.cli, argv[1:])


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["fly"], "no command"),
        (["plan", "--fly"], "No such option"),
        (["plan", "--output"], "requires an argument"),
        (["plan", "extra"], "unexpected words: extra"),
    ],
)
def test_what_there_is_not_is_told(arguments: list[str], reason: str) -> None:
    with pytest.raises((AssertionError, click.UsageError)) as caught:
        accepted(main.cli, arguments)
    assert reason in str(caught.value)


BUILDERS = {("ci", "images"), ("ci", "test"), ("locks", "try"), ("nightly", "images"), ("proofs", "all")}
"""Jobs that build images: the others need no builder and no local registry, whose programs take minutes to build."""

FROM_SOURCE = {
    "./rosml setup",
    *(f"./rosml setup {name}" for name in ("linters", "scanner", "signer", "suite")),
    *(f"make {name}" for name in ("test", "test-all", "test-scanner", "test-signer", "lint", "unit")),
}
"""Commands that build programs from their Go modules."""


def command(step: Mapping[str, Any]) -> str:
    """The command of a step without its options: `./rosml publish build`; empty where it runs none."""
    found = itertools.takewhile(lambda word: re.fullmatch(r"[a-z./-]+", word), str(step.get("run", "")).split())
    return " ".join(found)


@pytest.mark.parametrize(("name", "job"), PERMISSIONS)
def test_a_job_installs_what_it_uses(name: str, job: str) -> None:
    """No job that only reads and writes a registry has a builder and a registry of its own."""
    told = [command(step.content) for step in RUNS if (step.workflow, step.job) == (name, job)]
    if (name, job) not in BUILDERS:
        assert not {"./rosml setup", "./rosml publish all", "make test", "make test-all"} & set(told)
    if any(call.startswith(("./rosml publish", "./rosml plan", "./rosml catalogue")) for call in told):
        wanted = "./rosml setup" if (name, job) in BUILDERS else "./rosml setup client"
        assert [call for call in told if call in ("./rosml setup", "./rosml setup client")] == [wanted]


@pytest.mark.parametrize(("name", "job"), PERMISSIONS)
def test_programs_are_cached(name: str, job: str) -> None:
    """Before they are built; by what pins them, for each job apart, since a cache is never written a second time. They are kept as
    soon as they are built: a job that fails later, as first ones do, has them the next time. Trivy takes 10 minutes."""
    content = load(name)["jobs"][job]["steps"]
    builds = [it for it, step in enumerate(content) if command(step) in FROM_SOURCE]
    assert not [step for step in content if str(step.get("uses")).startswith("actions/cache@")], (
        "green jobs alone keep it"
    )
    read, written = (
        [it for it, step in enumerate(content) if str(step.get("uses")).startswith(f"actions/cache/{way}@")]
        for way in ("restore", "save")
    )
    assert len(read) == len(written) == bool(builds)
    for it in (*read, *written):
        condition = content[written[0]]["if"]
        assert read[0] < builds[0] == written[0] - 1
        assert "steps.programs.outputs.cache-hit != 'true'" in condition
        tests = command(content[builds[0]]).startswith("make ")  # and not only what installs programs
        assert ("!cancelled()" in condition) is tests
        assert content[it]["with"]["path"] == ".state/bin"
        assert re.fullmatch(
            r"\$\{\{ github.workflow \}\}-\$\{\{ github.job \}\}-(\$\{\{ strategy.job-index \}\}-)?"
            r"\$\{\{ runner.os \}\}-\$\{\{ runner.arch \}\}-\$\{\{ hashFiles\('tools/go/\*\*'\) \}\}",
            content[it]["with"]["key"],
        )


def test_a_job_that_is_run_again_leaves_what_it_made_by_then() -> None:
    """An artifact is of the whole run: without that, its second upload fails, and others take what the first one left. One of which
    each attempt has its own is taken by the same attempt."""
    named = {
        name: [
            step for step in content if "artifact" in str(step.get("uses")) or "deploy-pages" in str(step.get("uses"))
        ]
        for name, content in artifact_steps()
    }
    assert {name for name, found in named.items() if found} == {"locks", "nightly", ci_files.ACTION, ci_files.INDEX}
    for found in named.values():
        for step in found:
            given, attempt = step.get("with", {}), "${{ github.run_attempt }}"
            if "/upload-artifact@" in step["uses"]:
                assert given.get("overwrite") is True or attempt in given["name"], step
            if "/upload-pages-artifact@" in step["uses"]:  # which cannot overwrite
                assert attempt in given["name"]
            if "/deploy-pages@" in step["uses"]:
                assert {"name": given["artifact_name"]}.items() <= found[found.index(step) - 1]["with"].items()


def artifact_steps() -> Iterator[tuple[str, list[dict[str, Any]]]]:
    """Steps of each workflow, and of the actions for other repositories."""
    for name in NAMES:
        yield name, [step for job in load(name)["jobs"].values() for step in job["steps"]]
    for name in (ci_files.ACTION, ci_files.INDEX):
        yield name, yaml.safe_load((ROOT / name).read_text())["runs"]["steps"]


# ---- Rights ----------------------------------------------------------------------------------------------------------


def test_permissions_are_the_least() -> None:
    found = {(name, job): content.get("permissions") for name in NAMES for job, content in load(name)["jobs"].items()}
    assert found == PERMISSIONS
    assert [load(name)["permissions"] for name in NAMES] == [{} for _ in NAMES]


def test_no_secret_but_of_those_who_log_in() -> None:
    """The job's own token, or what a fork keeps as secrets for a registry of its own. One job writes an issue with it, and logs in
    nowhere."""
    token = "${{ github.token }}"
    assert [step.job for step in steps() if token in (step.content.get("env") or {}).values()] == ["issue"]
    for name in NAMES:
        code = re.sub(r"#.*", "", text(name))
        found = re.findall(r"\$\{\{[^}]*(?:token|secrets)[^}]*\}\}", code)
        assert set(found) <= ({LOGIN["username"], LOGIN["password"], token} if name == "nightly" else set())
        assert code.count("secrets") == sum(expression.count("secrets") for expression in found)
        assert "pull_request_target" not in text(name)


def test_the_registry_is_named_in_one_place() -> None:
    """Repository variables and secrets say which, and who publishes: a fork edits no workflow."""
    environment = load("nightly")["env"]
    assert environment["HOST"] == "${{ vars.ROSML_REGISTRY || 'ghcr.io' }}"
    assert environment["REGISTRY"] == (
        "${{ vars.ROSML_REGISTRY || 'ghcr.io' }}/${{ vars.ROSML_NAMESPACE || github.repository }}"
    )
    assert text("nightly").count("ghcr.io") == 2
    logins = [step for step in steps() if str(step.content.get("uses")).startswith("docker/login-action@")]
    assert [step.content["with"] for step in logins] == [LOGIN] * len(logins)
    assert {step.job for step in logins} == {job for name, job in PERMISSIONS if "packages" in PERMISSIONS[name, job]}


def test_the_jobs_token_is_sent_to_no_other_registry() -> None:
    """Also where somebody names a registry and forgets the password."""
    assert LOGIN["password"].startswith("${{ !vars.ROSML_REGISTRY && github.token || ")


def test_what_a_fork_can_set_is_what_workflows_read() -> None:
    """The variables and secrets that docs/nightly.md names, and no others."""
    section = (ROOT / "docs/nightly.md").read_text().partition("\n## In a fork\n")[2].partition("\n## ")[0]
    told = set(re.findall(r"`(ROSML_[A-Z]+)`", section))
    assert told == {name for file in NAMES for name in re.findall(r"\b(?:vars|secrets)\.(\w+)", text(file))}


def test_a_checkout_leaves_no_credentials() -> None:
    for step in steps():
        if str(step.content.get("uses")).startswith("actions/checkout@"):
            assert step.content["with"]["persist-credentials"] is False


def test_the_scanner_may_not_publish() -> None:
    """No job that runs it has the right, and none that has the right runs anything of the scanner's."""
    for step in RUNS:
        argv = words(step)
        permissions = PERMISSIONS[step.workflow, step.job]
        if {"scanner", "test-scanner", "scan"} & set(argv):
            assert "write" not in permissions.values()
        if argv[:2] == ["./rosml", "publish"] and step.workflow == "nightly":
            assert (argv[2] in WRITERS) == (permissions.get("packages") == "write")
            if argv[2] == "scan":
                assert "--output" in argv, "or it would write into the registry"


def test_scanner_and_signer_are_tested_before_a_night_relies_on_them() -> None:
    for job, name, use in (("scan", "scanner", "scan"), ("promote", "signer", "index")):
        told = [words(step) for step in RUNS if (step.workflow, step.job) == ("nightly", job)]
        (proof,) = [number for number, argv in enumerate(told) if argv == ["make", f"test-{name}"]]
        (first,) = [number for number, argv in enumerate(told) if argv[2:3] == [use]]
        assert proof < first


def test_one_variable_says_whether_indexes_are_signed() -> None:
    """It installs the signer, and has the commands sign; nobody else shows who they are."""
    job = load("nightly")["jobs"]["promote"]
    (install,) = [step for step in job["steps"] if step.get("run") == "./rosml setup signer"]
    assert install["if"] == "${{ env.ROSML_SIGN == 'true' }}"
    (proof,) = [step for step in job["steps"] if step.get("run") == "make test-signer"]
    assert proof["if"] == install["if"]
    assert job["env"] == {"ROSML_SIGN": "${{ vars.ROSML_SIGN || github.event.repository.visibility == 'public' }}"}
    for name in ("index", "promote"):
        (option,) = [item for item in publish.main.commands[name].params if item.name == "sign"]
        assert isinstance(option, click.Option) and option.envvar == "ROSML_SIGN" and option.is_flag
    for value, expected in (("", False), ("false", False), ("true", True)):
        context = click.Context(publish.main.commands["promote"])
        os.environ["ROSML_SIGN"] = value
        try:
            assert option.handle_parse_result(context, {}, [])[0] is expected
        finally:
            del os.environ["ROSML_SIGN"]
    tokens = [key for key, rights in PERMISSIONS.items() if "id-token" in rights]
    assert tokens == [("nightly", "promote"), ("nightly", "pages")]


def test_what_may_publish_a_site_runs_nothing() -> None:
    """Neither a checkout nor a command: nothing but the page that another job left."""
    for step in steps():
        if PERMISSIONS[step.workflow, step.job].get("pages") == "write":
            assert "run" not in step.content and "checkout" not in step.content["uses"]
    assert "vars.ROSML_PAGES == 'true'" in load("nightly")["jobs"]["pages"]["if"], "only where somebody wants it"


def test_nobody_logs_in_for_a_pull_request() -> None:
    for step in steps():
        if str(step.content.get("uses")).startswith("docker/login-action@"):
            assert step.workflow == "nightly" and "pull_request" not in text("nightly")


def test_actions_are_pinned() -> None:
    """By commit, beside the version; all uses of an action are of the same one."""
    pins: dict[str, set[tuple[str, str]]] = {}
    files = [*FOLDER.iterdir(), ROOT / ci_files.ACTION, ROOT / ci_files.INDEX]
    for file in files:
        for line in file.read_text().splitlines():
            if "uses:" in line and "uses: $/" not in line:
                found = re.search(r"uses: ([\w./-]+)@([0-9a-f]{40}) # (v\d+\.\d+\.\d+)( # zizmor: ignore.*)?$", line)
                assert found, line
                pins.setdefault(found[1], set()).add((found[2], found[3]))
    assert pins.keys() == ACTIONS
    assert all(len(commits) == 1 for commits in pins.values())


# ---- Runs ------------------------------------------------------------------------------------------------------------


def test_no_job_hangs_for_ever() -> None:
    for name in NAMES:
        for job in load(name)["jobs"].values():
            assert 0 < job["timeout-minutes"] < 360, "GitHub ends a job after six hours"


def test_a_run_that_publishes_is_not_cancelled() -> None:
    assert load("nightly")["concurrency"] == {"group": "publish", "cancel-in-progress": False}
    assert load("locks")["concurrency"]["cancel-in-progress"] is False
    assert "github.ref" in load("ci")["concurrency"]["group"]


def test_one_image_blocks_only_itself() -> None:
    """Other shards go on, and so do the next steps and jobs, which leave alone what is not there."""
    jobs = load("nightly")["jobs"]
    assert jobs["images"]["strategy"]["fail-fast"] is False
    (first,) = [step for step in jobs["plan"]["steps"] if "publish repositories" in step.get("run", "")]
    assert first["continue-on-error"] is True
    for name in ("scan", "promote"):
        assert jobs[name]["if"] == "${{ !cancelled() && needs.plan.result == 'success' }}"
    for step in RUNS:
        argv = words(step)
        if argv[:2] == ["./rosml", "publish"] and argv[2] in WRITERS - {"repositories", "images", "record", "rosdep"}:
            unsigned = " && steps.signer.outcome != 'failure'" if argv[2] in ("index", "promote") else ""
            assert step.content["if"] == f"${{{{ !cancelled(){unsigned} }}}}"


def test_the_date_is_chosen_once() -> None:
    """By the plan, which all other steps are given."""
    for step in RUNS:
        argv = words(step)
        if argv[:2] == ["./rosml", "publish"] and argv[2] in (WRITERS | {"scan"}) - {"rosdep"}:
            assert argv[3:5] == ["--plan", "plan.json"]
            assert "--date" not in argv


def test_machines_have_a_release() -> None:
    """What is called latest is another one tomorrow."""
    for name in NAMES:
        assert "latest" not in text(name)
        for job in load(name)["jobs"].values():
            assert job["runs-on"] in ("ubuntu-24.04", "${{ matrix.shard.runner }}")
