"""Runs a workflow of .github/workflows as GitHub would: act evaluates its conditions, its matrix, needs, outputs and
variables. Jobs run on this machine, each in an empty folder; actions and programs are replaced by what a test gives."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from rosml import ROOT

TOKEN = "ghs_0123456789abcdef0123456789abcdef"
"""The job's own token; act writes *** where it is printed."""

UPLOAD = """\
for path in $PATHS; do
  if [ -e "$path" ]; then mkdir -p "$ARTIFACTS/$NAME"; cp -a --parents "$path" "$ARTIFACTS/$NAME/"; fi
done"""
DOWNLOAD = '[ -d "$ARTIFACTS/$NAME" ]; case " $LOST " in *" $NAME "*) exit 1 ;; esac; mkdir -p "${PATHS:-.}"; cp -a "$ARTIFACTS/$NAME/." "${PATHS:-.}"'

REPOSITORY, COMMIT = "rosml/rosml", "0" * 40
"""What stands for this repository and its commit in `uses:`. act does not know $/."""

CHECKOUT_ACTION = f"{REPOSITORY}/.github/actions/checkout"

ACTIONS = {
    "actions/checkout": 'cp -a "$CHECKOUT/." . && cp -a "$FRONT/." .',
    CHECKOUT_ACTION: 'cp -a "$CHECKOUT/." . && cp -a "$FRONT/." .',
    "actions/upload-artifact": UPLOAD,
    "actions/download-artifact": DOWNLOAD,
    "actions/cache/restore": 'echo "$KEY $PATHS" >>"$CACHES"',
    "actions/cache/save": 'echo "$KEY $PATHS" >>"$CACHES"',
    "docker/login-action": '[ "$PASSED" = "$RIGHT" ]; [ -n "$USER_NAME" ]',
    "actions/upload-pages-artifact": '[ -d "$PATHS" ]',
    "actions/deploy-pages": ":",
}
"""What takes the place of each action: commands of a shell."""

INPUTS = {"NAME": "name", "PATHS": "path", "KEY": "key", "PASSED": "password", "USER_NAME": "username"}
"""Variables of those commands, and the inputs that they are."""

FATAL = '"level":"fatal"'
"""In a line of act that gave up."""

ENDS = ("success", "failure")
"""Results of a step that ran."""


@dataclass
class Played:
    """A run that ended; by job, unless a comment says otherwise."""

    results: dict[str, str] = field(
        default_factory=dict
    )  # success, failure or skipped; failure where one of a matrix failed
    matrix: dict[str, list[Any]] = field(
        default_factory=dict
    )  # its members that ran, in no order; one None without a matrix
    steps: dict[str, dict[str, str]] = field(default_factory=dict)  # results of those that ran, by name
    commands: dict[str, list[str]] = field(default_factory=dict)  # calls of make and ./rosml, in their order
    artifacts: Path = Path()  # a folder with a folder for each
    caches: tuple[str, ...] = ()  # keys and paths of the whole run
    log: str = ""


def program() -> str:
    path = Path(sys.executable).parent / "act"
    assert path.exists(), "act is not installed: make lint installs it"
    return str(path)


def actions(text: str, folder: Path) -> list[str]:
    """Writes the replacement of each action that a workflow names; gives act's options for them."""
    options = []
    for name, commit in sorted(set(re.findall(r"uses: ([\w./-]+)@(\w+)", text))):
        repository = "/".join(name.split("/")[:2])
        place = folder / repository.replace("/", "-")
        home = place / name.removeprefix(repository).strip(
            "/"
        )  # an action below its repository's root: actions/cache/save
        home.mkdir(parents=True, exist_ok=True)
        environment = {variable: f"${{{{ inputs.{name} }}}}" for variable, name in INPUTS.items()}
        step = {"shell": "bash", "run": ACTIONS[name], "env": environment}
        inputs = {name: {"default": ""} for name in (*INPUTS.values(), "registry")}
        content = {"name": name, "inputs": inputs, "runs": {"using": "composite", "steps": [step]}}
        (home / "action.yml").write_text(yaml.safe_dump(content))
        options.append(f"--local-repository={repository}@{commit}={place}")
    return sorted(set(options))


def play(
    text: str,
    folder: Path,
    programs: Mapping[str, str],
    *,
    event: str = "workflow_dispatch",
    checkout: Path | None = None,
    repository: str = "somebody/images",
    variables: Mapping[str, str] | None = None,
    secrets: Mapping[str, str] | None = None,
    inputs: Mapping[str, str] | None = None,
    lost: str = "",
    visibility: str = "",
    called: Mapping[str, str] | None = None,
) -> Played:
    """Runs a workflow in an empty folder. Raises ValueError with act's reasons if it does not understand the workflow.

    Args:
        programs: shell scripts that take the place of `make` and `./rosml`, by name; each call is recorded before it.
        checkout: what jobs check out besides `./rosml`. called: workflows that it calls, by the names of their files.
        secrets: of the repository. With ROSML_PASSWORD, that is what logs in; without, the job's own token.
        lost: artifacts that nobody can download. visibility: of the repository, `public` or `private`.
    """
    texts = {
        name: re.sub(r"uses: \$/(\S+)", rf"uses: {REPOSITORY}/\1@{COMMIT}", content)
        for name, content in {"workflow.yml": text, **(called or {})}.items()
    }
    for name in ("repository/.github/workflows", "programs", "front", "artifacts", "home", "empty"):
        (folder / name).mkdir(parents=True)
    for name, content in texts.items():
        (folder / "repository/.github/workflows" / name).write_text(content)
    git = ["git", "-C", str(folder / "repository"), "-c", "user.name=a", "-c", "user.email=a@example.org"]
    for arguments in (
        ["init", "--quiet", "--initial-branch=main"],
        ["remote", "add", "origin", f"https://github.com/{repository}.git"],
        ["add", "--all"],
        ["commit", "--quiet", "--message=A workflow"],
    ):
        subprocess.run([*git, *arguments], check=True, stdin=subprocess.DEVNULL)
    calls, caches = folder / "calls", folder / "caches"
    for name, script in programs.items():
        file = folder / {"rosml": "front"}.get(name, "programs") / name
        file.write_text(f'#!/usr/bin/env bash\nset -eu\necho "$GITHUB_JOB\t{name} $*" >>"$CALLS"\n{script}\n')
        file.chmod(0o755)
    node = folder / "programs/node"  # of which act asks the path at each step; no action here is JavaScript
    node.write_text(f"#!/bin/sh\necho {node}\n")
    node.chmod(0o755)
    variables_of_jobs = {
        "ARTIFACTS": folder / "artifacts",
        "CALLS": calls,
        "CACHES": caches,
        "CHECKOUT": checkout or folder / "empty",
        "FRONT": folder / "front",
        "LOST": lost,
        "GITHUB_TOKEN": TOKEN,
        "RIGHT": (secrets or {}).get("ROSML_PASSWORD", TOKEN),
        # Or act would look into the repository for each expression that it evaluates, which is half of its time.
        "GITHUB_REPOSITORY": repository,
        "GITHUB_REF": "refs/heads/main",
        "SHA_REF": COMMIT,
    }
    argv = [program(), event, "--json", "--verbose", "--no-skip-checkout", "--no-cache-server", "--pull=false"]
    argv += ["--workflows", ".github/workflows/workflow.yml", f"--secret=GITHUB_TOKEN={TOKEN}"]
    argv += [f"--secret={name}={value}" for name, value in (secrets or {}).items()]
    argv += [f"--platform={machine}=-self-hosted" for machine in ("ubuntu-24.04", "ubuntu-24.04-arm")]
    argv += actions("\n".join(texts.values()), folder / "actions")
    argv += [f"--env={name}={value}" for name, value in variables_of_jobs.items()]
    argv += [f"--var={name}={value}" for name, value in (variables or {}).items()]
    argv += [f"--input={name}={value}" for name, value in (inputs or {}).items()]
    if visibility:
        (folder / "event.json").write_text(json.dumps({"repository": {"visibility": visibility}}))
        argv += ["--eventpath", str(folder / "event.json")]
    path = f"{folder / 'programs'}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "HOME": str(folder / "home"), "XDG_CACHE_HOME": str(folder / "home")}
    environment["ACT_DISABLE_VERSION_CHECK"] = "1"  # asks a host outside
    streams: dict[str, Any] = {"stdin": subprocess.DEVNULL, "capture_output": True, "text": True}
    done = subprocess.run(argv, cwd=folder / "repository", env=environment, check=False, **streams)
    shutil.rmtree(folder / "home", ignore_errors=True)
    log = done.stdout + done.stderr
    wrong = [line for line in log.splitlines() if line.startswith("Error: workflow is not valid") or FATAL in line]
    if wrong:
        raise ValueError("\n".join(wrong))
    return read(log, calls, caches, folder / "artifacts")


def read(log: str, calls: Path, caches: Path, artifacts: Path) -> Played:
    """What act and the programs said."""
    played = Played(log=log, artifacts=artifacts)
    for line in log.splitlines():
        if not line.startswith("{"):
            continue
        event = json.loads(line)
        job = event.get("jobID", "")
        if result := event.get("jobResult"):
            if played.results.get(job) != "failure":
                played.results[job] = result
            played.matrix.setdefault(job, []).append(event.get("matrix"))
        if event.get("stage") == "Main" and len(event.get("stepID", ())) == 1 and event.get("stepResult") in ENDS:
            played.steps.setdefault(job, {})[event["step"]] = event["stepResult"]
    for line in calls.read_text().splitlines() if calls.exists() else ():
        job, _, call = line.partition("\t")
        played.commands.setdefault(job, []).append(call)
    if caches.exists():
        played.caches = tuple(caches.read_text().splitlines())
    return played


def workflow(name: str) -> str:
    """The text of one of ours."""
    return (ROOT / f".github/workflows/{name}.yml").read_text()
