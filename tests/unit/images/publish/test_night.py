"""What the nightly workflow does when something fails, when there is nothing to do and when variables are set: act evaluates
its conditions, and programs say how it goes."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosml.images.image_set import own_set
from rosml.images.image_set.model import ImageSet
from tests.act import Played, play, workflow

SHARDS = '[{"name":"amd64-1","runner":"ubuntu-24.04"},{"name":"arm64-1","runner":"ubuntu-24.04-arm"}]'
MACHINES = ["ubuntu-24.04", "ubuntu-24.04-arm"]

ROSML = """\
step=$1
if [ "$step" = publish ]; then step=$2; fi
case "$step" in
  setup) exit ;;
  catalogue) mkdir public; echo page >public/index.html ;;
  status) echo summary >night.md; echo "open=3" >>"$GITHUB_OUTPUT" ;;
  issue) [ -f night.md ] ;;
  plan) echo '{}' >plan.json ;;
  repositories | images | index | promote) [ -f plan.json ] ;;
  scan) [ -f plan.json ]; echo '{}' >scan.json; mkdir reports; echo '{}' >reports/a.sarif ;;
  record) [ -f plan.json ] && [ -f scan.json ] ;;
esac
case " $FAILING " in *" $step "*) exit 1 ;; esac
if [ "$step" = plan ]; then echo "shards=$SHARDS_PLANNED" >>"$GITHUB_OUTPUT"; fi
"""


def night(
    folder: Path,
    failing: str = "",
    shards: str = SHARDS,
    lost: str = "",
    event: str = "workflow_dispatch",
    **variables: str,
) -> Played:
    """A night in which some steps fail."""
    rosml = f"FAILING='{failing}' SHARDS_PLANNED='{shards}'\n{ROSML}"
    return play(workflow("nightly"), folder, {"make": ":", "rosml": rosml}, variables=variables, lost=lost, event=event)


def steps(played: Played, job: str) -> list[str]:
    """What a job called: the targets of make, the commands of rosml, and those of its groups."""
    called = [call.split()[1:] for call in played.commands.get(job, [])]
    return [words[1] if words[0] in ("publish", "setup") and words[1:] else words[0] for words in called]


ALL = ("plan", "images", "rosdep", "scan", "promote", "prune", "catalogue")


def test_a_night_in_which_nothing_fails(tmp_path: Path) -> None:
    played = night(tmp_path)
    assert played.results == {**dict.fromkeys(ALL, "success"), "pages": "skipped", "issue": "skipped"}
    assert sorted(member["shard"]["runner"] for member in played.matrix["images"]) == MACHINES
    assert sorted(steps(played, "images")) == sorted(["room", "setup", "images"] * 2)
    for shard in ("amd64-1", "arm64-1"):
        assert f"rosml publish images --plan plan.json --shard {shard} --minutes 300" in played.commands["images"]
    assert steps(played, "promote")[-4:] == ["record", "index", "promote", "status"]
    assert "signer" not in steps(played, "promote")
    assert not any("promote" in key for key in played.caches)
    assert steps(played, "scan") == ["client", "scanner", "test-scanner", "scan"]
    place = "--registry ghcr.io/somebody/images"
    plan, repositories = played.commands["plan"][-2:]
    assert place in plan and place in played.commands["prune"][-1]
    assert "--serve  --only  " in plan and "--shards 24 " in plan
    assert repositories == "rosml publish repositories --plan plan.json"


def test_one_failure_blocks_only_itself(tmp_path: Path) -> None:
    """The steps after it go on with what is there, and so do the other jobs; the run is red. A scan ends with a code of its own
    where the policy stops an image, and its results are there all the same."""
    played = night(tmp_path, "repositories images scan record index")
    red = dict.fromkeys(("images", "scan", "promote"), "failure")
    assert played.results == {**dict.fromkeys(ALL, "success"), **red, "pages": "skipped", "issue": "skipped"}
    assert steps(played, "images").count("images") == 2
    assert steps(played, "promote")[-4:] == ["record", "index", "promote", "status"]


@pytest.mark.parametrize(("setting", "result"), [("", "success"), ("false", "skipped")])
def test_a_scheduled_night_keeps_an_issue(setting: str, result: str, tmp_path: Path) -> None:
    played = night(tmp_path, "images promote", event="schedule", ROSML_ISSUE=setting)
    assert played.results["promote"] == "failure" and played.results["issue"] == result
    assert played.commands.get("issue", [])[1:] == ["rosml publish issue night.md --open 3"] * (result == "success")


def test_a_lost_scan_and_no_build_leave_the_rest_of_the_night(tmp_path: Path) -> None:
    played = night(tmp_path, lost="scan", shards="[]")
    skipped = dict.fromkeys(("images", "pages", "issue"), "skipped")
    assert played.results == {**dict.fromkeys(ALL, "success"), **skipped}
    assert steps(played, "promote")[-3:] == ["index", "promote", "status"]
    assert "record" not in steps(played, "promote")


def test_no_plan_no_night(tmp_path: Path) -> None:
    played = night(tmp_path, "plan", ROSML_PAGES="true")
    assert played.results == {"plan": "failure", **dict.fromkeys((*ALL[1:], "pages", "issue"), "skipped")}
    assert played.commands.keys() == {"plan"}


@pytest.mark.parametrize(
    ("program", "job", "skipped"),
    [("scanner", "scan", {("scan", "scan"), ("promote", "record")}),
     ("signer", "promote", {("promote", "index"), ("promote", "promote")})],
)  # fmt: skip
def test_a_program_that_does_not_do_what_it_must(
    tmp_path: Path, program: str, job: str, skipped: set[tuple[str, str]]
) -> None:
    programs = {"make": f'[ "$1" != test-{program} ]', "rosml": f"FAILING='' SHARDS_PLANNED='[]'\n{ROSML}"}
    played = play(workflow("nightly"), tmp_path, programs, variables={"ROSML_SIGN": "true"})
    assert played.results[job] == "failure"
    assert not [step for job_of_step, step in skipped if step in steps(played, job_of_step)]


@pytest.mark.parametrize(
    ("visibility", "variable", "signs"),
    [("public", "", True), ("private", "", False), ("public", "false", False), ("private", "true", True)],
)
def test_a_public_repository_signs_unless_a_variable_says_otherwise(
    tmp_path: Path, visibility: str, variable: str, signs: bool
) -> None:
    print_setting = 'echo "${ROSML_SIGN:-}" >"$CALLS.$GITHUB_JOB"'
    programs = {"make": ":", "rosml": f"FAILING='' SHARDS_PLANNED='[]'\n{print_setting}\n{ROSML}"}
    variables = {"ROSML_SIGN": variable} if variable else {}
    played = play(workflow("nightly"), tmp_path, programs, variables=variables, visibility=visibility)
    assert played.results["promote"] == "success"
    assert ({"signer", "test-signer"} <= set(steps(played, "promote"))) is signs
    assert (tmp_path / "calls.promote").read_text() == f"{str(signs).lower()}\n"


def test_what_a_repository_and_a_person_choose(tmp_path: Path) -> None:
    print_settings = '[ "$1" != plan ] || echo "$ROSML_FORCE|$ONLY" >"$CALLS.plan"\n[ "${2:-}" != promote ] || [ "$ROSML_SIGN" = true ]'
    played = play(
        workflow("nightly"),
        tmp_path,
        {"make": ":", "rosml": f"FAILING='' SHARDS_PLANNED='[]'\n{print_settings}\n{ROSML}"},
        variables={"ROSML_SIGN": "true", "ROSML_PAGES": "true", "ROSML_SERVE": "amd64", "ROSML_SHARDS": "3"},
        inputs={"only": "ros1-bookworm-* jazzy-core", "force": "true"},
    )
    skipped = dict.fromkeys(("images", "issue"), "skipped")
    assert played.results == {**dict.fromkeys(ALL, "success"), **skipped, "pages": "success"}
    assert {"signer", "test-signer"} <= set(steps(played, "promote"))
    assert len(played.caches) == 4, "of the scan, and of the signer: asked for, and kept"
    assert all(line.endswith(" .state/bin") for line in played.caches)
    plan = played.commands["plan"][-2]
    assert "--serve amd64 --only ros1-bookworm-* jazzy-core " in plan and "--shards 3 " in plan
    assert (tmp_path / "calls.plan").read_text() == "true|ros1-bookworm-* jazzy-core\n"


@pytest.mark.parametrize(
    ("registry", "secrets"),
    [("ghcr.io/somebody/images", {}), ("registry.example.com/robots", {"ROSML_USER": "me", "ROSML_PASSWORD": "word"})],
)
def test_a_repository_with_a_set_of_its_own_calls_it(
    registry: str, secrets: dict[str, str], tmp_path: Path, real: ImageSet
) -> None:
    choices = own_set.chosen(real, [], [], registry, "")
    text = own_set.files(real, choices, own_set.Upstream("https://github.com/rosml/rosml", "0" * 40))[own_set.WORKFLOW]
    caller = text.replace("rosml/rosml/.github/workflows/nightly.yml@" + "0" * 40, "./.github/workflows/nightly.yml")
    assert caller != text
    rosml = f"FAILING='' SHARDS_PLANNED='{SHARDS}'\n{ROSML}"
    played = play(
        caller,
        tmp_path,
        {"make": ":", "rosml": rosml},
        secrets=secrets,
        inputs={"only": "jazzy-core"},
        called={"nightly.yml": workflow("nightly")},
    )
    assert played.results["plan"] == played.results["promote"] == "success", played.log
    [plan] = [call for call in played.commands["plan"] if "rosml plan" in call]
    assert f"--registry {registry} " in plan and "--only jazzy-core " in plan
    assert f"--registry {registry}" in played.commands["prune"][-1]
