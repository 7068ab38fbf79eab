"""The nightly workflow's steps, read from its file and run one after the other against the local registry, each job with
nothing but the artifacts that it downloads. What GitHub does is played here in a few lines; the scanner is a stand-in."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
import yaml

from rosml import ROOT, ci
from rosml.errors import RosmlError
from rosml.ledger import Ledger
from rosml.programs import pinned_version
from rosml.services import Services
from tests.e2e import mini as minis
from tests.e2e.conftest import LOG
from tests.e2e.mini import NATIVE, Mini

SCANNER = """\
#!{python} -IS
# A trivy that finds one package in every image, and nothing wrong with it.
import json, os, pathlib, sys, time, uuid
argv = sys.argv[1:]
after = lambda option: pathlib.Path(argv[argv.index(option) + 1])
if "--version" in argv:
    print("Version: {version}")
elif "--download-db-only" in argv:
    (after("--cache-dir") / "db").mkdir(parents=True, exist_ok=True)
    (after("--cache-dir") / "db/trivy.db").write_text("debian 12")
    now = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())
    facts = {{"Version": 2, "UpdatedAt": now, "DownloadedAt": now}}
    (after("--cache-dir") / "db/metadata.json").write_text(json.dumps(facts))
elif "cyclonedx" in argv:
    kinds = [("library", "bash", "pkg:deb/debian/bash@5"), ("operating-system", "debian", "")]
    found = [
        {{"bom-ref": purl or str(uuid.uuid4()), "type": kind, "name": name, "version": "12.12", "purl": purl, "properties": []}}
        for kind, name, purl in kinds
    ]
    top = {{"bom-ref": str(uuid.uuid4()), "type": "container", "name": argv[-1], "properties": []}}
    tools = {{"components": [{{"type": "application", "name": "trivy", "version": "{version}"}}]}}
    metadata = {{"component": top, "tools": tools}}
    content = {{"bomFormat": "CycloneDX", "specVersion": "1.6", "metadata": metadata, "components": found, "dependencies": []}}
    after("--output").write_text(json.dumps(content))
else:
    results = [{{"Target": "t", "Class": "os-pkgs", "Type": "debian", "Packages": [{{"Name": "bash"}}], "Vulnerabilities": []}}]
    system = {{"OS": {{"Family": "debian", "Name": "12.12"}}}}
    after("--output").write_text(json.dumps({{"SchemaVersion": 2, "Metadata": system, "Results": results}}))
"""


@pytest.fixture(scope="module")
def project(beside: Services, tmp_path_factory: pytest.TempPathFactory) -> Mini:
    """The small project with a scanner and a policy, in a git repository."""
    mini = minis.make(tmp_path_factory.mktemp("mini"), beside)
    shutil.copy(ROOT / "scan.yaml", mini.folder)
    program = mini.folder / "trivy-stand-in"
    program.write_text(SCANNER.format(python=sys.executable, version=pinned_version(ROOT, "trivy", RosmlError)))
    program.chmod(0o755)
    (mini.folder / ".state/scanner.json").write_text(json.dumps({"trivy": str(program)}))
    (mini.folder / ".gitignore").write_text("/.state/\n__pycache__/\n")
    return mini


JOBS = {
    "",
    "${{ needs.plan.outputs.shards != '[]' }}",
    "${{ !cancelled() && needs.plan.result == 'success' }}",
    "${{ !cancelled() && needs.promote.result != 'skipped' }}",
    "${{ !cancelled() && needs.catalogue.result == 'success' && vars.ROSML_PAGES == 'true' }}",
}
STEPS = {
    "",
    "${{ !cancelled() }}",
    "${{ !cancelled() && steps.signer.outcome != 'failure' }}",
    "${{ steps.scan.outcome == 'success' }}",
    "${{ vars.ROSML_SIGN == 'true' }}",
}
"""Conditions that are played here; tests/unit/test_night.py has act evaluate them."""


@dataclass
class Night:
    """A run of the workflow.

    Attributes:
        mini: the checkout and its place. folder: for artifacts and what CI reads.
        artifacts: files by the artifact's name. results: of jobs. shards: what `plan` gave.
        steps: those that ran, by job.
        only: the workflow's input. lost: artifacts that nobody gets.
    """

    mini: Mini
    folder: Path
    only: str = ""
    lost: tuple[str, ...] = ()
    artifacts: dict[str, dict[str, bytes]] = field(default_factory=dict)
    results: dict[str, str] = field(default_factory=dict)
    shards: str = ""
    steps: dict[str, list[str]] = field(default_factory=dict)

    @property
    def environment(self) -> dict[str, str]:
        """What stands for GitHub's expressions, and the files that it reads."""
        found = {
            "REGISTRY": self.mini.registry,
            "SERVE": NATIVE,
            "SHARDS": "2",
            "ONLY": self.only,
            "ROSML_FORCE": "",
            "ROSML_SIGN": "",
        }
        files = {name: str(self.folder / name) for name in (ci.SUMMARY, ci.OUTPUT)}
        return {**os.environ, **found, **files}

    @property
    def summary(self) -> str:
        """What people see."""
        return (self.folder / ci.SUMMARY).read_text()

    def run(self, last: str = "") -> Night:
        """All jobs in their order, or those up to one."""
        self.folder.mkdir(exist_ok=True)
        workflow = yaml.safe_load((ROOT / ".github/workflows/nightly.yml").read_text())
        for name, job in workflow["jobs"].items():
            needs = [job["needs"]] if isinstance(job.get("needs"), str) else job.get("needs", [])
            assert set(needs) <= self.results.keys(), "jobs stand in the order in which they run"
            self.results[name] = self.job(name, job, needs)
            if name == last:
                break
        return self

    def job(self, name: str, job: dict[str, Any], needs: list[str]) -> str:
        """A job, for each member of its matrix; its result."""
        condition = job.get("if", "")
        assert condition in JOBS, "a condition that is not played here"
        wanted = re.findall(r"needs\.(\w+)\.result == 'success'", condition) if "!cancelled()" in condition else needs
        if any(self.results[need] != "success" for need in wanted):
            return "skipped"
        if any(self.results[need] == "skipped" for need in re.findall(r"needs\.(\w+)\.result != 'skipped'", condition)):
            return "skipped"
        if "needs.plan.outputs.shards != '[]'" in condition and self.shards == "[]":
            return "skipped"
        if "vars.ROSML_PAGES == 'true'" in condition:  # which nobody set
            return "skipped"
        if "strategy" not in job:
            return self.steps_of(name, job, {})
        shards = [shard["name"] for shard in json.loads(self.shards)]
        results = [self.steps_of(name, job, {"SHARD": shard}) for shard in shards]
        return "failure" if "failure" in results else "success"

    def steps_of(self, name: str, job: dict[str, Any], extra: dict[str, str]) -> str:
        """The steps of a job on a machine of its own: files of other jobs are not there."""
        for left in ("plan.json", "scan.json"):
            (self.mini.folder / left).unlink(missing_ok=True)
        for left in ("reports", "public"):
            shutil.rmtree(self.mini.folder / left, ignore_errors=True)
        failed, there = False, set()
        for step in job["steps"]:
            condition = step.get("if", "")
            assert condition in STEPS, "a condition that is not played here"
            wanted = re.search(r"steps\.(\w+)\.outcome == 'success'", condition)
            if "vars.ROSML_SIGN" in condition:  # the variable is not set
                continue
            if (failed and "!cancelled()" not in condition) or (wanted and wanted[1] not in there):
                continue
            done = self.action(step) if "uses" in step else self.command(name, step["run"], extra)
            if done:
                there.add(step.get("id", ""))
            failed = failed or not (done or step.get("continue-on-error"))
        return "failure" if failed else "success"

    def action(self, step: dict[str, Any]) -> bool:
        """An action; whether it succeeds."""
        action, options = step["uses"].split("@")[0], step.get("with", {})
        if action == "actions/upload-artifact":
            files = [self.mini.folder / path for path in options["path"].split()]
            found = [
                path for file in files for path in ([file] if file.is_file() else file.rglob("*")) if path.is_file()
            ]
            self.artifacts[options["name"]] = {
                str(path.relative_to(self.mini.folder)): path.read_bytes() for path in found
            }
        elif action == "actions/download-artifact":
            if options["name"] not in self.artifacts or options["name"] in self.lost:
                return False
            for path, content in self.artifacts[options["name"]].items():
                (self.mini.folder / path).parent.mkdir(exist_ok=True)
                (self.mini.folder / path).write_bytes(content)
        else:
            assert action in ("actions/cache", "actions/checkout", "docker/login-action")
        return True

    def command(self, job: str, text: str, extra: dict[str, str]) -> bool:
        """A step's command, as a shell reads it; those that set a machine up are left out."""
        if text.startswith("make "):
            assert text.split()[1] in ("up", "client", "room", "scanner", "test-scanner")
            return True
        LOG.info("%s: %s", job, text)
        script, step = text.split()[2:4]
        self.steps.setdefault(job, []).append("catalogue" if script.endswith("catalogue.py") else step)
        command = text.replace("uv run scripts/", f"{sys.executable} scripts/")
        env = {**self.environment, **extra}
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", command],
            cwd=self.mini.folder,
            env=env,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        LOG.info("%s", done.stdout + (done.stderr if done.returncode else ""))
        output = self.folder / ci.OUTPUT
        if job == "plan" and output.exists():
            (line,) = output.read_text().splitlines()
            self.shards = line.removeprefix("shards=")
            output.unlink()
        return done.returncode == 0


@pytest.fixture
def mini(project: Mini) -> Iterator[Mini]:
    """The small project as it should be, with an empty place in the registry."""
    project.mark()
    project.poison(poisoned=False)
    yield project.elsewhere()


def test_two_nights(mini: Mini, tmp_path: Path) -> None:
    """What the scanner found in the first one never arrives: nothing gets a tag. The second one builds nothing again."""
    first = Night(mini, tmp_path / "first", lost=("scan",)).run(last="promote")
    assert set(first.results.values()) == {"success"}, first.results
    assert first.steps["images"] == ["build", "compose", "test"]
    assert first.steps["promote"] == ["index", "promote", "status"]
    assert mini.tags() == {}
    assert {name.partition("/")[0] for name in first.artifacts["scan"]} == {"scan.json", "reports"}
    book = Ledger(mini.client(), mini.prefix)
    before = book.read("bookworm-base-tensorflow-cpu", NATIVE)
    assert before and before.digest and not before.scanned, "the scan wrote nothing"

    time.sleep(1.1)  # another date
    second = Night(mini, tmp_path / "second").run()
    assert (second.shards, second.results.pop("images"), second.results.pop("pages")) == ("[]", "skipped", "skipped")
    assert set(second.results.values()) == {"success"}, second.results
    assert second.steps["promote"] == ["record", "index", "promote", "status"]
    assert {"ros:bookworm-core", "ros:bookworm-base", "ros-tf:bookworm-base-cpu"} <= mini.tags().keys()
    mini.check()
    date = json.loads(second.artifacts["plan"]["plan.json"])["date"]
    found = mini.client().manifest(f"{mini.prefix}/ros-tf", "bookworm-base-cpu")
    assert found and found.content["annotations"]["io.rosml.date"] == date
    after = book.read("bookworm-base-tensorflow-cpu", NATIVE)
    assert after and (after.digest, after.scanned) == (before.digest, "clean")
    assert f"## Plan of {date}" in second.summary
    assert "| promote | `bookworm-base-tensorflow-cpu` |" in second.summary
    assert second.steps["catalogue"] == ["catalogue"]
    assert "public/index.html" in second.artifacts["catalogue"]
    images = json.loads(second.artifacts["catalogue"]["public/catalogue.json"])["images"]
    shown = {image["target"]: image["builds"][0]["digest"] for image in images if image["status"] == "built"}
    assert shown["bookworm-base-tensorflow-cpu"] == found.digest
    (platform,) = next(i for i in images if i["target"] == "bookworm-base-tensorflow-cpu")["builds"][0]["platforms"]
    assert (platform["digest"], platform["scan"]["outcome"]) == (after.digest, "clean")
    assert platform["size"]["compressed"] == after.size


def test_no_plan_no_night(mini: Mini, tmp_path: Path) -> None:
    night = Night(mini, tmp_path / "night", only="bookworm-core no-*").run()
    others = ("images", "scan", "promote", "prune", "catalogue", "pages")
    assert night.results == {"plan": "failure", **dict.fromkeys(others, "skipped")}


def test_a_pull_request_builds_what_it_changes(mini: Mini) -> None:
    """By the command that `make publish` calls, with the variables of the workflow."""
    jobs = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text())["jobs"]
    own = {"REGISTRY": mini.registry, "PLACE": mini.registry, "ONLY": "", "SINCE": "HEAD"}  # PLACE: what make calls it
    env = {**os.environ, **jobs["images"]["env"], **own}
    (step,) = [step["run"] for step in jobs["images"]["steps"] if "publish" in step.get("run", "")]
    told = subprocess.run(
        [*step.split()[:1], "--dry-run", "AT_MOST=1", *step.split()[1:]],
        cwd=ROOT,
        env=env,
        capture_output=True,
        text=True,
        check=True,
    )
    command = told.stdout.splitlines()[-1].replace("uv run --quiet scripts/", f"{sys.executable} scripts/")

    def publish() -> dict[str, Any]:
        done = subprocess.run(
            ["bash", "-c", f"{command} --json"],
            cwd=mini.folder,
            env=env,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        content: dict[str, Any] = json.loads(done.stdout)
        return content

    names = [f"GIT_{who}_{what}" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")]
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "A version"]):
        subprocess.run(
            ["git", *arguments], cwd=mini.folder, check=True, env={**os.environ, **dict.fromkeys(names, "a")}
        )
    assert publish() == {"counts": {}, "outcomes": []}
    assert mini.tags() == {}
    mini.mark(ros="2")
    outcomes = publish()["outcomes"]
    promoted = {item["target"] for item in outcomes if item["step"] == "promote" and item["state"] == "done"}
    assert promoted and mini.tags()
    mini.check()
