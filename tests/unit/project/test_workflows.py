"""What neither act, actionlint nor zizmor sees of the workflows: every step is a command that there is, with options that it
has; what was once lost when a job failed, or was run again; who may write into the registry."""

from __future__ import annotations

import re
import shlex
import subprocess
from collections.abc import Iterator
from typing import Any

import click
import pytest
import yaml
from conftest import ROOT

from fakes.workflows import accepted, load, text
from rosml.cli import main
from rosml.cli.images import publish
from rosml.containerize.ci import files as ci_files

NAMES = ("ci", "locks", "nightly", "proofs", "release")

JOBS = {(name, job): content for name in NAMES for job, content in load(name)["jobs"].items()}
RUNS = [(key, step) for key, job in JOBS.items() for step in job["steps"] if "run" in step]

WRITERS = {"repositories", "images", "record", "index", "promote", "rosdep"}

FROM_SOURCE = {
    "./rosml setup",
    *(f"./rosml setup {name}" for name in ("linters", "scanner", "signer", "suite")),
    *(f"make {name}" for name in ("test", "test-all", "test-scanner", "test-signer", "lint", "unit")),
}


# ---- Commands --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", sorted({step["run"].strip() for _, step in RUNS}))
def test_every_command_is_one_that_there_is(command: str) -> None:
    assert not re.search(r"[\n();<>|&`]|\$[{(]", command), (
        "one command, no shell beside it, and no value becomes part of it"
    )
    assert all(f'"${name}"' in command for name in re.findall(r"\$(\w+)", command))
    argv = shlex.split(command)
    if argv[0] == "make":
        done = subprocess.run(["make", "--dry-run", *argv[1:]], cwd=ROOT, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return
    assert argv[0] == "./rosml", "make or rosml"
    accepted(main.cli, argv[1:])


def test_every_variable_of_a_command_is_set() -> None:
    for (name, job), step in RUNS:
        variables = {**load(name).get("env", {}), **JOBS[name, job].get("env", {}), **step.get("env", {})}
        assert {*re.findall(r"\$(\w+)", step["run"])} <= variables.keys(), step


@pytest.mark.parametrize(("value", "signs"), [("", False), ("false", False), ("true", True)])
@pytest.mark.parametrize("name", ["index", "promote"])
def test_a_variable_says_whether_to_sign(name: str, value: str, signs: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSML_SIGN", value)
    command = publish.main.commands[name]
    (option,) = [item for item in command.params if item.name == "sign"]
    assert option.handle_parse_result(click.Context(command), {}, [])[0] is signs


# ---- What a run leaves -----------------------------------------------------------------------------------------------


def built(step: dict[str, Any]) -> str:
    words = re.match(r"(?:[a-z./-]+(?: |$))*", str(step.get("run", "")))
    return words[0].strip() if words and words[0].strip() in FROM_SOURCE else ""


@pytest.mark.parametrize("key", JOBS, ids="-".join)
def test_programs_are_kept_as_soon_as_they_are_built(key: tuple[str, str]) -> None:
    """By what pins them, for each job apart, since a cache is never written a second time. A job that fails later, as first ones
    do, has them the next time. Trivy takes 10 minutes."""
    steps = JOBS[key]["steps"]
    builds = [number for number, step in enumerate(steps) if built(step)]
    caches = [number for number, step in enumerate(steps) if str(step.get("uses")).startswith("actions/cache")]
    if not builds:
        assert not caches
        return
    read, written = (steps[number] for number in caches)
    assert caches[0] < builds[0] == caches[1] - 1
    assert tuple(step["uses"].partition("@")[0] + "@" for step in (read, written)) == (
        "actions/cache/restore@",
        "actions/cache/save@",
    )
    assert "steps.programs.outputs.cache-hit != 'true'" in written["if"]
    assert ("!cancelled()" in written["if"]) is built(steps[builds[0]]).startswith("make "), "tests may fail"
    assert read["with"] == written["with"]
    assert {"github.workflow", "github.job", "hashFiles('tools/go/**')"} <= {
        *re.findall(r"\{\{ (.*?) \}\}", read["with"]["key"])
    }


def artifact_steps() -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    actions = [yaml.safe_load((ROOT / name).read_text())["runs"]["steps"] for name in (ci_files.ACTION, ci_files.INDEX)]
    for steps in (*(job["steps"] for job in JOBS.values()), *actions):
        for before, step in zip([{}, *steps], steps, strict=False):
            if re.search("artifact|deploy-pages", str(step.get("uses"))):
                yield before, step


def test_a_job_that_is_run_again_leaves_what_it_made_by_then() -> None:
    """An artifact is of the whole run: without that, its second upload fails, and others take what the first one left. One of which
    each attempt has its own is taken by the same attempt."""
    steps = list(artifact_steps())
    assert len(steps) > 5
    for before, step in steps:
        options, attempt = step.get("with", {}), "${{ github.run_attempt }}"
        if "/upload-artifact@" in step["uses"]:
            assert options.get("overwrite") is True or attempt in options["name"], step
        if "/upload-pages-artifact@" in step["uses"]:  # which cannot overwrite
            assert attempt in options["name"]
        if "/deploy-pages@" in step["uses"]:
            assert before["with"]["name"] == options["artifact_name"]


# ---- Actions ---------------------------------------------------------------------------------------------------------

USING = {
    "actions/cache@9255dc7a253b0ccc959486e2bca901246202afeb # v5.0.1": "node24",
    "actions/checkout@de0fac2e4500dabe0009e67214ff5f5447ce83dd # v6.0.2": "node24",
    "actions/deploy-pages@cd2ce8fcbc39b97be8ca5fce6e763baed58fa128 # v5.0.0": "node24",
    "actions/download-artifact@37930b1c2abaa49bbe596cd826c3c89aef350131 # v7.0.0": "node24",
    "actions/upload-artifact@b7c566a772e6b6bfb58ed0dc250532a479d7789f # v6.0.0": "node24",
    "actions/upload-pages-artifact@fc324d3547104276b827a68afc52ff2a11cc49c9 # v5.0.0": "node24",  # by upload-artifact v7.0.0
    "docker/login-action@4907a6ddec9925e35a0a9e82d7399ccc52663121 # v4.1.0": "node24",
    "peter-evans/create-pull-request@98357b18bf14b5342f975ff684046ec3b2a07725 # v8.0.0": "node24",
}
"""What runs each action, by `runs.using` of its action.yml. Read on 2026-11-29 in clones of the actions' repositories, where each
commit has the tag beside it: `git tag --points-at COMMIT`, `git show COMMIT:action.yml`. Read both before you add one."""


def test_every_action_is_pinned_once_and_runs_on_a_node_that_github_has() -> None:
    """GitHub takes node20 off its machines in 2026."""
    command = ["git", "grep", "-hoE", r"uses: [A-Za-z-]+/[^@ ]+@[0-9a-f]{40} # v[0-9.]+", "--", ":!tests"]
    lines = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    pins = {re.sub(r"^uses: ([\w-]+/[\w-]+)[^@]*", r"\1", line) for line in lines}
    assert pins == USING.keys()
    assert {*USING.values()} == {"node24"}


# ---- Rights ----------------------------------------------------------------------------------------------------------


def test_the_scanner_may_not_publish() -> None:
    for (name, job), step in RUNS:
        words, rights = step["run"].split(), JOBS[name, job].get("permissions", {})
        if {"scanner", "test-scanner", "scan"} & {*words}:
            assert "write" not in rights.values()
        if words[:2] == ["./rosml", "publish"] and name == "nightly":
            assert (words[2] in WRITERS) == (rights.get("packages") == "write")
            assert words[2] != "scan" or "--output" in words, "or it would write into the registry"


def test_the_jobs_token_is_sent_to_no_other_registry() -> None:
    """Also where somebody names a registry and forgets the password. One job writes an issue with it, and logs in nowhere."""
    logins = [
        step["with"]
        for job in JOBS.values()
        for step in job["steps"]
        if str(step.get("uses")).startswith("docker/login-action@")
    ]
    assert logins
    for login in logins:
        assert (
            login["password"]
            == "${{ !inputs.registry && !vars.ROSML_REGISTRY && github.token || secrets.ROSML_PASSWORD }}"
        )
        assert login["registry"] == "${{ env.HOST }}"
    assert text("nightly").count("github.token") == len(logins) + 1


def test_what_a_fork_can_set_is_what_workflows_read() -> None:
    section = (ROOT / "docs/nightly.md").read_text().partition("\n## In a fork\n")[2].partition("\n## ")[0]
    names = set(re.findall(r"`(ROSML_[A-Z]+)`", section))
    assert names == {name for file in NAMES for name in re.findall(r"\b(?:vars|secrets)\.(\w+)", text(file))}
