"""`make test-all`: proofs are dealt out and run, and neither a set-up that fails, nor a run without tests, nor a skip passes
unseen."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import ROOT

from tests import suite
from tests.proofs import PROOFS
from tests.suite import Outcome


def test_a_proof_whose_set_up_fails_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    ran: list[str] = []

    def run(phase: suite.Phase) -> Outcome:
        ran.append(phase.name)
        return Outcome(phase.name, 1, 0, passed=1)

    monkeypatch.setattr(suite, "set_up", lambda need: Outcome(f"set-up: {need}", 1, 1))
    monkeypatch.setattr(suite, "run", run)
    done = CliRunner().invoke(suite.main, ["--proof", "signer", "--proof", "apt"])
    assert (done.exit_code, ran) == (1, ["proof: apt"])
    assert "signer failed, which these need: not run: signer" in done.output


@pytest.mark.parametrize(
    ("code", "counts", "wrong"),
    [
        (0, {"passed": 7, "skipped": 1}, ""),
        (1, {"passed": 6, "failed": 1}, "proof: apt: failed"),
        (5, {}, "proof: apt: failed"),
        (0, {"skipped": 1}, "proof: apt: no test ran"),
    ],
)
def test_a_proof_has_passed_if_a_test_did(
    monkeypatch: pytest.MonkeyPatch, code: int, counts: dict[str, int], wrong: str
) -> None:
    monkeypatch.setattr(suite, "run", lambda phase: Outcome(phase.name, 1, code, **counts))
    done = CliRunner().invoke(suite.main, ["--proof", "apt"])
    assert done.exit_code == bool(wrong) and wrong in done.output


def test_every_proof_is_dealt_to_one_machine() -> None:
    for shards in (1, 2, 3, 5):
        dealt = [suite.deal(number + 1, shards) for number in range(shards)]
        assert [quick for quick, _ in dealt].count(True) == 1
        assert sorted(name for _, part in dealt for name in part) == sorted(PROOFS)


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_a_shard_that_is_none(shard: str) -> None:
    done = CliRunner().invoke(suite.main, ["--all", "--shard", shard])
    assert done.exit_code == 2
    assert "write it as i/n, such as 1/3" in done.output


SKIPPED = """\
import pytest

@pytest.mark.skip("no gpg on this machine")
def test_marked(): pass

def test_called(): pytest.skip("Docker Hub answers: its base images are used")

@pytest.mark.xfail
def test_expected(): assert False
"""


def test_a_skip_for_another_reason_fails_the_run(tmp_path: Path) -> None:
    (tmp_path / "test_one.py").write_text(SKIPPED)
    (tmp_path / "test_whole.py").write_text("import pytest; pytest.importorskip('nothing_of_that_name')")
    argv = [sys.executable, "-m", "pytest", "-ra", "-p", "tests.skips", "--rootdir", str(tmp_path), "-c", "/dev/null"]
    argv += ["--continue-on-collection-errors", str(tmp_path)]
    done = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "test_one.py::test_marked was skipped: no gpg on this machine" in done.stdout
    assert "test_whole.py was skipped: could not import 'nothing_of_that_name'" in done.stdout
    assert "its base images are used" in done.stdout, "what is allowed is printed"
    assert "1 failed, 1 skipped, 2 errors" in done.stdout
