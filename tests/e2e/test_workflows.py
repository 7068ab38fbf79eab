"""The nightly workflow with its real commands, run by act against the local registry, each job in a folder of its own. The
scanner is a local replacement."""

from __future__ import annotations

import copy
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import pytest
import yaml

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version
from rosml.images.records.store import Records
from rosml.machine.services import Services
from tests.act import ENDS, Played, play, workflow
from tests.e2e import mini as minis
from tests.e2e.calls import LOG, rosml
from tests.e2e.images import NATIVE
from tests.e2e.mini import Mini
from tests.e2e.moody import Mood, moody

SCANNER = """\
#!{python} -IS
# A trivy that finds nothing wrong with what SBOMs name.
import json, pathlib, sys, time
argv = sys.argv[1:]
after = lambda option: pathlib.Path(argv[argv.index(option) + 1])
if "--version" in argv:
    print("Version: {version}")
elif "--download-db-only" in argv:
    (after("--cache-dir") / "db").mkdir(parents=True, exist_ok=True)
    (after("--cache-dir") / "db/trivy.db").write_text("debian 12, pip::")
    now = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())
    facts = {{"Version": 2, "UpdatedAt": now, "DownloadedAt": now}}
    (after("--cache-dir") / "db/metadata.json").write_text(json.dumps(facts))
else:
    components = json.loads(pathlib.Path(argv[-1]).read_text())["components"]
    packages = [{{"Name": it["name"]}} for it in components if it["type"] == "library"]
    results = [{{"Target": "t", "Class": "os-pkgs", "Type": "debian", "Packages": packages, "Vulnerabilities": []}}]
    system = {{"OS": {{"Family": "debian", "Name": "12.12"}}}}
    after("--output").write_text(json.dumps({{"SchemaVersion": 2, "Metadata": system, "Results": results}}))
"""


@pytest.fixture(scope="module")
def project(project: Mini) -> Mini:
    """The small project with a scanner and a policy, as a repository of git has it."""
    policy = (ROOT / "scan.yaml").read_text().partition("\nignore:")[0]  # its entries are for images of the real matrix
    (project.folder / "scan.yaml").write_text(policy + "\n")
    program = project.folder / "trivy-local replacement"
    program.write_text(SCANNER.format(python=sys.executable, version=pinned_version(ROOT, "trivy", RosmlError)))
    program.chmod(0o755)
    (project.folder / ".state/scanner.json").write_text(json.dumps({"trivy": str(program)}))
    (project.folder / ".gitignore").write_text("/.state/\n__pycache__/\n")
    return project


ROSML = f"""\
if [ "$1" = setup ]; then exit; fi
code=0
{shlex.quote(sys.executable)} src "$@" || code=$?
cat "$GITHUB_STEP_SUMMARY" >>"$ARTIFACTS/../summary.md"
exit $code
"""
"""What takes the place of ./rosml: the machine is set up; the same command by the Python of the tests; what people see on the
run's page is kept."""


OWN = """\
if [ "$1 ${{2:-}}" = "setup scanner" ]; then echo '{{"trivy": "{scanner}"}}' >.state/scanner.json; exit; fi
if [ "$GITHUB_JOB" = images ]; then
  if [ "$1 ${{2:-}}" = "setup " ]; then mkdir -p .state/bin; cp -a {bin}/. .state/bin/; fi
  code=0
  ./rosml-real "$@" || code=$?
  if [ "$1 ${{2:-}}" = "publish images" ]; then ./rosml-real setup down; fi
  exit $code
fi
chown -R {user}:{user} .
chmod -R a+rwX "$(dirname "$GITHUB_OUTPUT")" "$(dirname "$GITHUB_PATH")"
export HOME="$PWD" PATH=/usr/bin:/bin
exec setpriv --reuid={user} --regid={user} --clear-groups ./rosml-real "$@"
"""
"""What takes the place of ./rosml where jobs set themselves up: the real one, with nothing of this machine's checkout. Only a
job that builds has what the cache of programs has; the others run as a user who is not root. The scanner is not built."""

GIT = """\
case " $* " in *" clone "*) ;; *) exec /usr/bin/git "$@" ;; esac
for folder; do :; done
mkdir -p "$folder/rosdep" "$folder/noetic"
echo 'boost: {debian: [libboost-dev]}' >"$folder/rosdep/base.yaml"
echo 'repositories: {}' >"$folder/noetic/distribution.yaml"
echo 'distributions: {noetic: {distribution: [noetic/distribution.yaml]}}' >"$folder/index-v4.yaml"
"""
"""What takes the place of git: a small checkout of ros/rosdistro, which is on GitHub."""

PLAIN_USER = 12345

TAGS = {"ros:ros1-bookworm-core", "ros:ros1-bookworm-base", "ros-tf:ros1-bookworm-base-cpu"}

QUIET = {"pages": "skipped", "issue": "skipped"}
"""Jobs that nobody asked for, in a night by hand."""


def own_checkout(mini: Mini, folder: Path) -> Path:
    """What a job of the small project checks out: nothing that a set-up has made."""
    shutil.copytree(mini.folder, folder, ignore=shutil.ignore_patterns(".state", ".venv", "__pycache__", ".git"))
    shutil.copy(ROOT / "rosml", folder / "rosml-real")
    return folder


def night(mini: Mini, folder: Path, text: str = "", host: str = "", serve: str = NATIVE, **options: Any) -> Played:
    """A run of the workflow, its commands for real.

    Args:
        mini: the small project, which jobs check out, and where its images go. folder: for all that is made.
        text: of the workflow; ours if empty. host: stands before the registry; nothing does if empty.
        serve: architectures. options: of `play`; and `rosml`, which takes the place of ./rosml.
    """
    registry, _, place = mini.registry.partition("/")
    played = play(
        text or workflow("nightly"),
        folder,
        {"make": '[ "$1" = test-scanner ]', "git": GIT, "rosml": options.pop("rosml", ROSML)},
        variables={
            **{"ROSML_REGISTRY": host or registry, "ROSML_NAMESPACE": place},
            **{"ROSML_SERVE": serve, "ROSML_SHARDS": "3"},
        },
        secrets={"ROSML_USER": "somebody", "ROSML_PASSWORD": "their password"},
        inputs={"only": "", "force": "false"},
        **{"checkout": mini.folder, **options},
    )
    LOG.info("%s", played.log)
    return played


def steps(played: Played, job: str) -> list[str]:
    """The steps of the publisher that a job called, in their order."""
    words = [call.split() for call in played.commands.get(job, []) if not call.startswith("git ")]
    return [call[2] if call[1] == "publish" else call[1] for call in words if call[1] not in ("setup", "test-scanner")]


def test_two_nights(mini: Mini, tmp_path: Path) -> None:
    """What the scanner found in the first one never arrives: nothing gets a tag. The second one builds nothing again."""
    first = night(mini, tmp_path / "first", lost="scan")
    assert first.results == {**dict.fromkeys(first.results, "success"), **QUIET}
    assert steps(first, "images") == ["images"]
    assert steps(first, "promote") == ["index", "promote", "status"]
    assert mini.tags() == {}
    scanned = first.artifacts / "scan"
    assert {path.name for path in scanned.iterdir()} == {"scan.json", "reports"}
    book = Records(mini.place())
    before = book.read("ros1-bookworm-base-tensorflow-cpu", NATIVE)
    assert before and before.digest and not before.scanned, "the scan wrote nothing"

    time.sleep(1.1)  # another date
    second = night(mini, tmp_path / "second")
    expected = {**dict.fromkeys(second.results, "success"), **QUIET, "images": "skipped"}
    assert second.results == expected
    assert steps(second, "promote") == ["record", "index", "promote", "status"]
    assert mini.tags().keys() >= TAGS
    mini.check()
    date = json.loads((second.artifacts / "plan/plan.json").read_text())["date"]
    index = mini.client().manifest(f"{mini.prefix}/ros-tf", "ros1-bookworm-base-cpu")
    assert index and index.content["annotations"]["io.rosml.date"] == date
    after = book.read("ros1-bookworm-base-tensorflow-cpu", NATIVE)
    assert after and (after.digest, after.scanned) == (before.digest, "clean")
    summary = (tmp_path / "second/summary.md").read_text()
    assert f"## Plan of {date}" in summary
    assert "| promote | `ros1-bookworm-base-tensorflow-cpu` |" in summary
    assert "rosml catalogue" in " ".join(second.commands["catalogue"])
    assert mini.client().head(f"{mini.prefix}/rosdep", "latest")
    public = second.artifacts / "catalogue/public"
    assert (public / "index.html").is_file()
    images = json.loads((public / "catalogue.json").read_text())["images"]
    shown = {image["target"]: image["builds"][0]["digest"] for image in images if image["status"] == "built"}
    assert shown["ros1-bookworm-base-tensorflow-cpu"] == index.digest
    (platform,) = next(i for i in images if i["target"] == "ros1-bookworm-base-tensorflow-cpu")["builds"][0][
        "platforms"
    ]
    assert (platform["digest"], platform["scan"]["outcome"]) == (after.digest, "clean")
    assert platform["size"]["compressed"] == after.size


@pytest.mark.full(proof="night")
def test_jobs_set_themselves_up(mini: Mini, services: Services) -> None:
    """Each with what its own steps install, and nothing else of this machine; those of the other architecture under emulation."""
    with tempfile.TemporaryDirectory(prefix="rosml-night-") as name:
        folder = Path(name)
        folder.chmod(0o755)  # for a user who is not root
        scanner = mini.folder / "trivy-local replacement"
        (folder / "trivy").write_text(scanner.read_text().replace(sys.executable, "/usr/bin/python3"))
        (folder / "trivy").chmod(0o755)
        rosml = OWN.format(scanner=folder / "trivy", bin=ROOT / ".state/bin", user=PLAIN_USER)
        checkout = own_checkout(mini, folder / "checkout")
        minis.for_both(checkout, services)
        played = night(mini, folder / "night", rosml=rosml, checkout=checkout, serve="")
        assert played.results == {**dict.fromkeys(played.results, "success"), **QUIET}
        assert mini.tags().keys() >= TAGS
        mini.check()
        index = mini.client().manifest(f"{mini.prefix}/ros-tf", "ros1-bookworm-base-cpu")
        assert index
        assert {member["platform"]["architecture"] for member in index.content["manifests"]} == {"amd64", "arm64"}


def rehearsed(mini: Mini, folder: Path) -> Mini:
    """The small project with two more rows and a stack without a lock. In the row `broken`, a test fails; the row `late` takes its
    time."""
    shutil.copytree(mini.folder, folder, symlinks=True)
    real, content = (yaml.safe_load((place / "matrix.yaml").read_text()) for place in (ROOT, folder))
    for name in ("broken", "late"):
        row = copy.deepcopy(content["distributions"]["ros1-bookworm"])
        content["distributions"][name] = row | {"aliases": [], "ros_distro": name}
    content["frameworks"]["torch"] = real["frameworks"]["torch"]
    content["parts"] = [
        part for part in real["parts"] if part["name"] in ("torch", *(it["name"] for it in content["parts"]))
    ]
    release = real["stacks"]["cpu"]["releases"]["torch"]
    content["stacks"]["cpu"]["releases"]["torch"] = release
    facts = real["releases"]["torch"][release]
    content["releases"]["torch"] = {release: facts | {"wheels": {"cpu": facts["wheels"]["cpu"]}}}
    content["disk"]["parts"]["cpu"]["torch"] = real["disk"]["parts"]["cpu"]["torch"]
    (folder / "matrix.yaml").write_text(yaml.safe_dump(content, sort_keys=False))
    for lock in (folder / "locks/cpu").glob("*/3.11/torch.txt"):
        lock.unlink()
    install = folder / "components/ros/install.sh"
    install.write_text(f'{install.read_text()}if [ "$ROS_DISTRO" = late ]; then sleep {60 * MINUTES:.0f}; fi\n')
    (folder / "tests/structure/ros1-base.yaml").write_text(FAILING)
    return Mini(folder, mini.services, mini.prefix)


MINUTES = 0.1
"""When the time of the late row is over. Its first image begins before that, and takes as long."""

FAILING = """\
schemaVersion: 2.0.0
commandTests:
  - name: the robot finds home
    command: bash
    args: [-c, 'if grep broken /usr/local/share/rosml/versions.d/ros; then echo "no way home" >&2; exit 1; fi']
"""


def causes(summary: str) -> dict[str, str]:
    """The blocks of a night's summary by their headings; the first one without."""
    blocks = re.split(r"^### ", summary, flags=re.MULTILINE)
    return {"": blocks[0], **dict(block.split("\n", 1) for block in blocks[1:])}


def tagged(mini: Mini) -> set[str]:
    """The images whose main tag is there."""
    tags = mini.tags()
    return {image.target for image in mini.image_set.images if image.tags[0] in tags}


def refusing(refused: list[str]) -> Mood:
    """Refuses the first push of an image, as often as it comes, up to three times; notes what it refused."""
    refusals = ["403", "403", "503"]

    def mood(_number: int, request: str) -> str:
        push = re.match(r"PUT (\S+/ros/manifests/\S+) buildkit/", request)
        if not push or not refusals or push[1] not in (refused or push[1]):
            return ""
        refused.append(push[1])
        return refusals.pop(0)

    return mood


@pytest.mark.full(proof="night")
def test_a_night_in_which_much_goes_wrong(mini: Mini, tmp_path: Path) -> None:
    """A test fails in one row, a stack has no lock, the registry refuses a push three times, and the time of a shard is over: all
    else gets its tags, and one page says why the rest did not. The next night does what is left."""
    mini = rehearsed(mini, tmp_path / "project")
    refused: list[str] = []
    late = f"{NATIVE}-3"
    limit = f"--minutes ${{{{ matrix.shard.name == '{late}' && '{MINUTES}' || '300' }}}}"
    text = workflow("nightly").replace("--minutes 300", limit)
    with moody(mini.services.registry, refusing(refused)) as host:
        first = night(mini, tmp_path / "first", text=text, host=host)
    assert first.results == {**dict.fromkeys(first.results, "success"), **QUIET, "images": "failure"}
    shards = json.loads((first.artifacts / "plan/plan.json").read_text())["shards"]
    assert [shard["distributions"] for shard in shards] == [["ros1-bookworm"], ["broken"], ["late"]]
    assert by_shard(first) == {f"{NATIVE}-1": "success", f"{NATIVE}-2": "failure", late: "success"}
    assert len(refused) == 3 and len({*refused}) == 1
    assert all(f"Forbidden; attempt {number} in" in first.log for number in (2, 3))

    whole = {f"ros1-bookworm-{name}" for name in ("core", "base", "core-tensorflow-cpu", "base-tensorflow-cpu")}
    moved = whole | {"broken-core", "broken-core-tensorflow-cpu", "late-core"}
    assert tagged(mini) == moved
    mini.check()
    before = mini.tags()

    failure = "the robot finds home"
    unbuilt = ("late-base", "late-core-tensorflow-cpu", "late-base-tensorflow-cpu")
    summary = causes((first.artifacts / "night/night.md").read_text())
    assert [*summary][1:] == [
        f"1 image failed: `tests failed: ros1-base: {failure}`",
        "3 images missing: `it was never made`",
        f"1 image missing: `tests that it shares with broken-base failed: ros1-base: {failure}`",
        "6 images and 1 part lock missing",
    ]
    top, failed, missing, shared, unlocked = summary.values()
    assert "A further run would build 1, join 2, test 4." in top
    assert "`broken-base`" in failed and failed.count("no way home") == 1
    assert missing.split() == ", ".join(f"`{name}`" for name in unbuilt).split()
    assert "`broken-base-tensorflow-cpu`" in shared
    assert all("torch" in name for name in unlocked.split())
    page = (tmp_path / "first/summary.md").read_text()
    assert "- without a lock: 6 images, which cannot be built yet" in page
    assert " times: the time of this run is over" in page
    assert (first.artifacts / f"logs-{NATIVE}-2/.state/tests/broken-base/report/ros1-base.json").is_file()

    mini.poison(poisoned=False)
    second = night(mini, tmp_path / "second")
    assert second.results == {**dict.fromkeys(second.results, "success"), **QUIET}
    assert tagged(mini) == whole | {name.replace("ros1-bookworm", row) for name in whole for row in ("broken", "late")}
    mini.check()
    assert {tag: mini.tags()[tag] for tag in before} == before, "what was there is the same"
    summary = causes((second.artifacts / "night/night.md").read_text())
    assert [*summary][1:] == ["7 images lock missing"]
    assert "A further run has nothing to do." in summary[""]


def by_shard(played: Played) -> dict[str, str]:
    """How the step ended that builds, by shard; act gives all jobs of a matrix the result of one that failed."""
    lines = (json.loads(line) for line in played.log.splitlines() if line.startswith("{"))
    ended = [it for it in lines if it.get("step") == "Build, join and test" and it.get("stepResult") in ENDS]
    return {it["matrix"]["shard"]["name"]: it["stepResult"] for it in ended}


def test_a_pull_request_builds_what_it_changes(mini: Mini) -> None:
    """By the workflow's command, from a clone with one commit."""
    jobs = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text())["jobs"]
    (step,) = [step["run"] for step in jobs["images"]["steps"] if "publish" in step.get("run", "")]
    words = step.replace("HEAD^1", "HEAD").split()
    assert words[0] == "./rosml"

    def publish() -> dict[str, Any]:
        done = rosml(*words[1:], "--at-most", "1", "--registry", mini.registry, "--json", root=mini.folder)
        content: dict[str, Any] = json.loads(done.out)
        return content

    names = ("-c", "user.name=a", "-c", "user.email=a")
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "A version"]):
        subprocess.run(["git", *names, *arguments], cwd=mini.folder, check=True)
    assert publish() == {"counts": {}, "outcomes": []}
    assert mini.tags() == {}
    mini.mark(ros="2")
    outcomes = publish()["outcomes"]
    promoted = {item["target"] for item in outcomes if item["step"] == "promote" and item["state"] == "done"}
    assert promoted and mini.tags()
    mini.check()
