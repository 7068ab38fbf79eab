"""The action, the workflow and the component for GitLab of `rosml containerize`: they know all inputs, and pass them on as
they are. act runs the first two, with local replacements for docker and rosml."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest
import yaml
from conftest import ROOT

from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_image
from rosml.containerize.ci import files as ci_files
from rosml.containerize.ci import inputs as ci_inputs
from tests import act
from tests.pages import blocks

ONLY_GITHUB = {"enable-checkout", "enable-checkout-lfs", "enable-checkout-submodules", "enable-singlearch-push"}


def load(name: str) -> dict[str, Any]:
    content: dict[str, Any] = yaml.safe_load((ROOT / name).read_text())
    return content


def gitlab_documents() -> tuple[dict[str, Any], dict[str, Any]]:
    """The inputs of the component, and its jobs."""
    header, jobs = yaml.safe_load_all((ROOT / ci_files.GITLAB).read_text())
    return header["spec"]["inputs"], jobs


def test_every_input_reaches_the_command() -> None:
    """Those of docker-ros among them: test_app_inputs.py."""
    names = {setting.input.name for setting in ci_inputs.SETTINGS}
    assert load(ci_files.ACTION)["inputs"].keys() == names
    inputs, jobs = gitlab_documents()
    used = set(re.findall(r"\$\[\[ inputs\.([\w-]+) \]\]", (ROOT / ci_files.GITLAB).read_text()))
    assert used == inputs.keys() and names - ONLY_GITHUB <= used
    passed = jobs[".containerize"]["variables"]
    variables = {setting.input.name: setting.input.variable for setting in ci_inputs.SETTINGS}
    assert {f"INPUT_{variables[name]}" for name in used & variables.keys()} <= passed.keys()
    assert {name.removeprefix("DEFAULT_") for name in passed if name.startswith("DEFAULT_")} <= {*variables.values()}
    assert all(isinstance(value, str | dict) for value in passed.values()), "GitLab takes texts"


def test_no_input_becomes_part_of_a_command_of_gitlab() -> None:
    _, jobs = gitlab_documents()
    lines = [line for job in jobs.values() for line in (*job.get("before_script", ()), *job.get("script", ()))]
    assert lines and not [line for line in lines if "$[[" in line]


def test_inputs_that_the_page_shows_are_there() -> None:
    inputs = {*load(ci_files.ACTION)["inputs"], *gitlab_documents()[0]}
    for block in blocks(ROOT / "docs/containerize/ci.md"):
        if block.language == "yaml":
            texts = re.findall(r"^ +(?:with|inputs):\n((?: +[\w-]+: .*\n)+)", block.text, re.MULTILINE)
            assert texts and {name for text in texts for name in yaml.safe_load(text)} <= inputs


def test_a_file_without_its_markers_is_not_guessed_at() -> None:
    text = (ROOT / ci_files.ACTION).read_text().replace("# environment:", "# variables:")
    with pytest.raises(RosmlError, match="the marker '# environment: written by rosml generate' is missing"):
        ci_files.render(ci_files.ACTION, text)


# ---- Runs ------------------------------------------------------------------------------------------------------------

KEY = "-----BEGIN OPENSSH PRIVATE KEY-----\nb3BlbnNz\n\n-----END OPENSSH PRIVATE KEY-----\n"
VALUES = {
    "base-image": "ros:jazzy",
    "command": """ros2 run robot "it's $HOME" `id` $(id) '%' \\n; exit 1""",
    "cmake-args": "-DA=1  -DB='x y'",
    "git-ssh-private-key": KEY,
    "git-ssh-known-host-keys": "example.org ssh-ed25519 AAAA\nexample.org ssh-rsa BBBB",
    "image-name": "ghcr.io/me/Robot",
}

PYTHON = """\
[ "$1" = -m ] || exit 0
mkdir -p "$3/bin"
printf '#!/bin/sh\\necho "pip $*" >>"%s"\\n' "$CALLS" >"$3/bin/pip"
cp "$PROGRAMS/rosml" "$3/bin/rosml"
chmod +x "$3"/bin/*
"""
"""What takes the place of `python3 -m venv FOLDER`."""

COMMAND = """\
env -0 >"$CALLS.$1.$2.${PLATFORM:-}"
echo "rosml $*" >>"$CALLS"
[ "$2" = build ] || { find made -name images.json | wc -l >>"$CALLS"; exit 0; }
mkdir -p "$4" && echo '[]' >"$4/images.json"
{ echo "artifact=containerize-$PLATFORM"; echo "folder=$4"; echo "image=me:1"; } >>"$GITHUB_OUTPUT"
[ "$PLATFORM" != "$FAILS" ]
"""
"""What takes the place of rosml."""

UPLOAD = '[ ! -d "$PATHS" ] || cp -a "$PATHS" "$ARTIFACTS/$NAME"'
DOWNLOAD = 'mkdir -p "$PATHS" && for place in "$ARTIFACTS"/$PATTERN; do cp -a "$place" "$PATHS/"; done'

IMAGES = "tools/images.txt"
OURS = ("containerize", "src", "scripts", ".github")
OWN = "rosml/rosml"
COMMIT = "f" * 40


def programs(folder: Path, **scripts: str) -> None:
    folder.mkdir()
    for name, script in scripts.items():
        (folder / name).write_text(f"#!/usr/bin/env bash\nset -eu\n{script}\n")
        (folder / name).chmod(0o755)


RECORD = 'echo "$(basename "$0") $*" >>"$CALLS"; [ "${2:-}" != inspect ]'


class Run:
    """A run of a workflow by act, with its log and the calls of docker, sudo, pip and rosml."""

    def __init__(self, workflows: dict[str, str], folder: Path, fails: str = "-", **secrets: str) -> None:
        self.folder = folder
        for name in ("repository/.github/workflows", "artifacts", "home", "empty"):
            (folder / name).mkdir(parents=True)
        for name, text in workflows.items():
            (folder / "repository/.github/workflows" / name).write_text(text)
        self._git("init", "--quiet", "--initial-branch=main")
        self._git("remote", "add", "origin", "https://github.com/me/Robot.git")
        self._git("add", "--all")
        self._git("commit", "--quiet", "--message=A workflow")
        programs(folder / "programs", docker=RECORD, sudo=RECORD, python3=PYTHON, rosml=COMMAND)
        self.log = self._act(fails, secrets)
        calls = folder / "calls"
        self.calls = calls.read_text().splitlines() if calls.exists() else []

    def _git(self, *arguments: str) -> None:
        author = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
        subprocess.run(["git", "-C", str(self.folder / "repository"), *author, *arguments], check=True)

    def _act(self, fails: str, secrets: dict[str, str]) -> str:
        checkout, actions = self.folder / "own", ""
        for name in (ci_files.ACTION, ci_files.INDEX, "containerize/install.sh", "containerize/builder.sh", IMAGES):
            (checkout / name).parent.mkdir(parents=True, exist_ok=True)
            (checkout / name).write_text((ROOT / name).read_text())
            (checkout / name).chmod(0o755)
            actions += (ROOT / name).read_text() if name.endswith(".yml") else ""
        folders = {
            "CALLS": "calls",
            "PROGRAMS": "programs",
            "ARTIFACTS": "artifacts",
            "CHECKOUT": "empty",
            "FRONT": "empty",
        }
        variables = {name: str(self.folder / place) for name, place in folders.items()}
        variables |= {"FAILS": fails, "RIGHT": act.TOKEN, "LOST": ""}
        argv = [act.program(), "push", "--json", "--verbose", "--no-skip-checkout", "--no-cache-server", "--pull=false"]
        argv += [f"--secret=GITHUB_TOKEN={act.TOKEN}", f"--local-repository={OWN}@{COMMIT}={checkout}"]
        argv += [f"--platform={machine}=-self-hosted" for machine in ("ubuntu-24.04", "ubuntu-24.04-arm")]
        argv += act.actions(actions, self.folder / "actions")
        argv += [f"--env={name}={value}" for name, value in variables.items()]
        argv += [f"--secret={name}" for name in secrets]
        home = str(self.folder / "home")
        environment = {**os.environ, **secrets, "ACT_DISABLE_VERSION_CHECK": "1", "HOME": home, "XDG_CACHE_HOME": home}
        environment["PATH"] = f"{self.folder / 'programs'}{os.pathsep}{os.environ['PATH']}"
        options: dict[str, Any] = {"cwd": self.folder / "repository", "env": environment, "stdin": subprocess.DEVNULL}
        end = subprocess.run(argv, **options, capture_output=True, text=True, check=False)
        return f"{end.stdout}{end.stderr}"

    def environment(self, call: str) -> dict[str, str]:
        """Variables of a call of rosml."""
        text = (self.folder / f"calls.{call}").read_bytes().decode()
        return dict(item.partition("=")[::2] for item in text.split("\0") if item)

    @property
    def results(self) -> set[str]:
        lines = [json.loads(line) for line in self.log.splitlines() if line.startswith("{")]
        return {line["jobResult"] for line in lines if "jobResult" in line}


def run_action(folder: Path, *steps: dict[str, Any], **values: Any) -> Run:
    """A run of a repository's workflow that uses our action."""
    step = {"id": "made", "uses": f"{OWN}/containerize@{COMMIT}", "with": {**VALUES, **values}}
    workflow = {"on": "push", "jobs": {"build": {"runs-on": "ubuntu-24.04", "steps": [step, *steps]}}}
    run = Run({"workflow.yml": yaml.safe_dump(workflow)}, folder)
    assert run.results == {"success"}, run.log
    return run


def variables_of(environment: dict[str, str]) -> dict[str, str]:
    return {name: environment[name.upper().replace("-", "_")] for name in VALUES}


@pytest.fixture(autouse=True)
def replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(act.ACTIONS, "actions/upload-artifact", UPLOAD)
    monkeypatch.setitem(act.ACTIONS, "actions/download-artifact", DOWNLOAD)
    monkeypatch.setitem(act.INPUTS, "PATTERN", "pattern")


def test_the_action_passes_every_value_as_it_is(tmp_path: Path) -> None:
    output = {"run": 'test "$IMAGE" = me:1', "env": {"IMAGE": "${{ steps.made.outputs.image }}"}}
    run = run_action(tmp_path, output)
    environment = run.environment("ci.build.")
    assert variables_of(environment) == VALUES
    assert environment["GIT_HTTPS_PASSWORD"] == act.TOKEN and "REGISTRY_PASSWORD" not in environment
    assert [environment[name] for name in ("TARGET", "PUSH", "IMAGE_TAG")] == ["run", "true", ""]
    [create] = [call for call in run.calls if "buildx create" in call]
    image = pinned_image(ROOT, "moby/buildkit")
    driver = f"--driver docker-container --driver-opt image={image}"
    assert create.endswith(f"--name {environment['BUILDX_BUILDER']} {driver}")


def test_the_jobs_token_is_sent_to_no_other_server(tmp_path: Path) -> None:
    """Without a password, the action does not log in."""
    servers = {"git-https-server": "git.example.org", "registry": "registry.example.org"}
    environment = run_action(tmp_path, **servers, push=False).environment("ci.build.")
    assert (environment["GIT_HTTPS_PASSWORD"], environment["PUSH"]) == ("", "false")


def workflows(**values: str) -> dict[str, str]:
    """A repository's workflow that calls ours, and ours."""
    ours = (ROOT / ci_files.WORKFLOW).read_text().replace("uses: $/", f"uses: {OWN}/")
    ours = re.sub(r"(uses: rosml/rosml/\S+)", rf"\1@{COMMIT}", ours)
    inputs = {name: value for name, value in {**VALUES, **values}.items() if name not in ci_inputs.SECRET}
    call = {"uses": "./.github/workflows/containerize.yml", "with": inputs}
    call["secrets"] = {"git-ssh-private-key": "${{ secrets.KEY }}"}
    return {"workflow.yml": yaml.safe_dump({"on": "push", "jobs": {"images": call}}), "containerize.yml": ours}


def test_the_workflow_makes_an_index_of_a_job_for_each_platform(tmp_path: Path) -> None:
    run = Run(workflows(), tmp_path, KEY=KEY)
    assert run.results == {"success"}, run.log
    for platform in ("amd64", "arm64"):
        environment = run.environment(f"ci.build.{platform}")
        assert variables_of(environment) == VALUES and environment["ENABLE_SINGLEARCH_PUSH"] == "true"
    assert run.calls[-2:] == ["rosml ci index made", "2"]
    assert run.environment("ci.index.amd64,arm64")["IMAGE_NAME"] == VALUES["image-name"]


def test_there_is_no_index_if_a_job_failed(tmp_path: Path) -> None:
    run = Run(workflows(platform="arm64,amd64"), tmp_path, fails="arm64", KEY=KEY)
    assert "rosml ci index made" not in run.calls
    assert sum("rosml ci build" in call for call in run.calls) == 2
    assert (tmp_path / "artifacts/containerize-arm64").is_dir(), "the reports of the failed job"


def gitlab(folder: Path, job: str, **variables: str) -> tuple[str, list[str]]:
    """Runs the commands of a job of GitLab, with local replacements of programs. Returns its errors and calls."""
    _, jobs = gitlab_documents()
    script = "\n".join([*jobs[".containerize"]["before_script"], *jobs[job]["script"]])
    script = script.replace("/tmp/", f"{folder}/").replace("/opt/", f"{folder}/opt/").replace("cd /tmp", "cd .")
    copy = f'mkdir -p "{folder}/rosml/tools" && cp -r {ROOT}/containerize "{folder}/rosml/"'
    copy += f' && cp {ROOT}/{IMAGES} "{folder}/rosml/tools/"'
    record = 'echo "$(basename "$0") $*" >>"$CALLS"'
    programs(folder / "programs", apk=record, git=f"{record}\n{copy}", python3=PYTHON, rosml=record, docker=RECORD)
    environment = {"PATH": f"{folder / 'programs'}:{os.environ['PATH']}", "CALLS": str(folder / "calls")}
    environment |= {"PROGRAMS": str(folder / "programs"), "CI_PROJECT_DIR": "/builds/me/a b", "BUILDX_BUILDER": "rosml"}
    command = ["sh", "-euc", script]
    end = subprocess.run(command, env=environment | variables, capture_output=True, text=True, check=False)
    assert (end.returncode == 0) == (not end.stderr), end.stderr
    calls = folder / "calls"
    return end.stderr, calls.read_text().splitlines() if calls.exists() else []


URL = "https://a.example/rosml.git"


def test_jobs_of_gitlab_install_rosml_log_in_and_build(tmp_path: Path) -> None:
    for name in ("build", "index"):
        (tmp_path / name).mkdir()
    _, calls = gitlab(tmp_path / "build", ".containerize-build", INPUT_ROSML_URL="", ROSML_URL=URL)
    [clone] = [call for call in calls if call.startswith("git ")]
    assert clone == f"git clone --quiet --depth=1 --branch main {URL} {tmp_path}/build/rosml"
    commands = [call for call in calls if call.startswith("rosml ")]
    assert commands == ["rosml ci login", "rosml ci build --out /builds/me/a b/containerize-out"]
    assert any(call.startswith("docker buildx create") and call.endswith(" rosml-context") for call in calls)
    _, calls = gitlab(tmp_path / "index", "containerize", INPUT_ROSML_URL=URL, INPUT_ROSML_REF="v1")
    assert calls[-1] == "rosml ci index /builds/me/a b/containerize-out"
    assert any(call.startswith("git clone --quiet --depth=1 --branch v1 ") for call in calls)


def test_gitlab_has_to_say_where_rosml_is(tmp_path: Path) -> None:
    errors, _ = gitlab(tmp_path, "containerize")
    assert "the input rosml-url is missing" in errors


@pytest.mark.parametrize("name", [ci_files.ACTION, ci_files.INDEX])
def test_nothing_is_fetched_after_the_action_logs_in(name: str) -> None:
    """Only what pushes runs beside the registry's password."""
    steps = load(name)["runs"]["steps"]
    [place] = [number for number, step in enumerate(steps) if "login-action" in step.get("uses", "")]
    later = [step for step in steps[place + 1 :] if "upload-artifact" not in step.get("uses", "")]
    assert [step["run"].split()[:2] for step in later] == [['"$RUNNER_TEMP/rosml/bin/rosml"', "ci"]]


@pytest.mark.parametrize("name", [".containerize-build", "containerize"])
def test_nothing_is_fetched_after_a_job_of_gitlab_logs_in(name: str) -> None:
    _, jobs = gitlab_documents()
    lines = [*jobs[".containerize"]["before_script"], *jobs[name]["script"]]
    [command] = lines[lines.index("/opt/rosml/bin/rosml ci login") + 1 :]
    assert "/opt/rosml/bin/rosml ci" in command


def test_every_image_that_is_started_has_a_digest() -> None:
    """All of them stand in one file; the file for GitLab repeats what it needs."""
    lines = [line for line in (ROOT / IMAGES).read_text().splitlines() if not line.startswith("#")]
    assert all(re.fullmatch(r"[a-z/]+:[\w.-]+@sha256:[0-9a-f]{64}", line) for line in lines)
    names = "|".join(sorted({re.escape(line.partition(":")[0]) for line in lines}))
    paths = [ROOT / "Makefile", ROOT / "Dockerfile"]
    for folder in (*OURS, "components", "tools", "docs", "examples", "devcontainer"):
        paths += [file for file in (ROOT / folder).rglob("*") if file.suffix in {".py", ".sh", ".yml", ".md", ".txt"}]
    pattern = re.compile(rf"(?<![\w./-])(?:{names}):[\w.-]*[\d][^\s\"'`]*")
    assert {image for path in paths for image in pattern.findall(path.read_text(errors="replace"))} == set(lines)
    job = gitlab_documents()[1][".containerize"]
    images = {job["image"], *(service["name"] for service in job["services"])}
    assert images == {line for line in lines if line.startswith("docker:")}
