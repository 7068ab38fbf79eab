"""`make test-all`: proofs are dealt out, run and recorded, and a list says how old each is. None of them fails for its age."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from rosml.base.errors import RosmlError
from tests import proof, suite
from tests.proof import Proof, Run
from tests.suite import Outcome
from tests.walk import git

PROOF = """\
# A comment stays.
proves: Something.
minutes: 3
files: [lock.txt, scripts]
"""


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A git repository with a proof."""
    for name, text in {"proofs/thing.yaml": PROOF, "lock.txt": "torch==1\n", "README.md": "Words.\n"}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "begin"]):
        git(tmp_path, *arguments)
    return tmp_path


def ran(checkout: Path, **counts: int) -> Proof:
    """Records a run of the proof; as it is read again."""
    run = Run("2026-11-23", proof.head(checkout), **{"passed": 7, **counts})
    Proof.load("thing", checkout / "proofs").record(run, checkout / "proofs")
    return Proof.load("thing", checkout / "proofs")


def test_the_list_says_what_changed_since(checkout: Path) -> None:
    found = ran(checkout)
    for name in ("README.md", "lock.txt", "lock.txt"):
        with (checkout / name).open("a") as file:
            file.write("more\n")
        git(checkout, "commit", "--quiet", "--all", "--message", name)
    assert re.search(r"thing +2026-11-23 +2 +7 passed", proof.table([found], checkout))


def test_the_list_says_what_it_does_not_know(checkout: Path) -> None:
    never = Proof.load("thing", checkout / "proofs")
    assert re.search(r"thing +never +run: make test-all PROOF=thing", proof.table([never], checkout))
    lost = Proof("lost", "", 1, ["lock.txt"], last=Run("2026-11-23", "0" * 40, 6, 1))
    assert re.search(r"lost +2026-11-23 +unknown +6 passed, 1 failed", proof.table([lost], checkout))


def test_the_rest_of_its_file_stays(checkout: Path) -> None:
    for passed in (7, 8):
        ran(checkout, passed=passed)
        text = (checkout / "proofs/thing.yaml").read_text()
        assert text.startswith(PROOF) and text.count("last:") == 1 and f"passed: {passed}" in text


@pytest.mark.parametrize(
    ("outcome", "wrong"),
    [
        (Outcome("thing", 1, 0, passed=7), ""),
        (Outcome("thing", 1, 1, passed=6, failed=1), "thing: 6 passed, 1 failed"),
        (Outcome("thing", 1, 0, passed=6, skipped=1), ""),  # tests/skips.yaml lists it
        (Outcome("thing", 1, 0, skipped=1), "thing: 0 passed, 1 skipped"),
        (Outcome("thing", 1, 5), "thing: 0 passed"),
    ],
)
def test_every_run_is_recorded(checkout: Path, monkeypatch: pytest.MonkeyPatch, outcome: Outcome, wrong: str) -> None:
    recorded: list[Run] = []
    monkeypatch.setattr(Proof, "record", lambda _, run: recorded.append(run))
    assert suite.record(Proof.load("thing", checkout / "proofs"), outcome) == wrong
    assert [(run.passed, run.failed, run.skipped) for run in recorded] == [
        (outcome.passed, outcome.failed, outcome.skipped)
    ]


@pytest.mark.parametrize(
    "text", ["", "proves: [", "proves: a\nminutes: 1\n", "proves: a\nminutes: 1\nfile: [LICENSE]\n"]
)
def test_a_damaged_proof_is_told_in_a_sentence(tmp_path: Path, text: str) -> None:
    (tmp_path / "thing.yaml").write_text(text)
    with pytest.raises(RosmlError, match=r"tests/proofs/thing\.yaml is damaged"):
        Proof.load("thing", tmp_path)


def test_a_proof_whose_set_up_fails_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """The others are; the run fails and names it."""
    ran: list[str] = []

    def run(phase: suite.Phase) -> Outcome:
        ran.append(phase.name)
        return Outcome(phase.name, 1, 1, failed=1)

    monkeypatch.setattr(suite, "set_up", lambda need: Outcome(f"set-up: {need}", 1, 1))
    monkeypatch.setattr(suite, "run", run)
    monkeypatch.setattr(Proof, "record", lambda *_: None)
    done = CliRunner().invoke(suite.main, ["--proof", "signer", "--proof", "apt"])
    assert done.exit_code == 1
    assert ran == ["proof: apt"]
    assert "signer failed, which these need: not run: signer" in done.output


def test_a_run_without_tests_fails(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(suite, "run", lambda phase: Outcome(phase.name, 1, 0, log=tmp_path / "log"))
    done = CliRunner().invoke(suite.main, ["--phase", "page"])
    assert done.exit_code == 1 and "the catalogue's page: no test ran" in done.output


def test_every_proof_is_dealt_to_one_machine() -> None:
    proofs = [Proof.load(name) for name in proof.names()]
    for shards in (1, 2, 3, 5):
        dealt = [suite.deal(proofs, number + 1, shards) for number in range(shards)]
        assert [quick for quick, _ in dealt].count(True) == 1
        assert sorted(found.name for _, part in dealt for found in part) == sorted(proof.names())


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_a_shard_that_is_none(shard: str) -> None:
    done = CliRunner().invoke(suite.main, ["--all", "--shard", shard])
    assert done.exit_code == 2
    assert "write it as i/n, such as 1/3" in done.output
