"""What only `make test-all` proves is proved for this very state: each proof names committed files, and its digest is theirs.
A proof that failed, or whose tests were skipped, is none; and every test belongs to `make test` or to a proof."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from rosml.base.errors import RosmlError
from tests import proof, suite
from tests.proof import FOLDER, ROOT, Proof, Proved
from tests.suite import Outcome

PROOF = """\
# A comment stays.
proves: Something.
minutes: 3
depends:
  files: [lock.txt, scripts]
"""


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A git repository with a proof."""
    (tmp_path / "proofs").mkdir()
    (tmp_path / "proofs/thing.yaml").write_text(PROOF)
    (tmp_path / "scripts").mkdir()
    (tmp_path / "lock.txt").write_text("torch==1\n")
    (tmp_path / "scripts/one.sh").write_text("one\n")
    (tmp_path / "README.md").write_text("Words.\n")
    (tmp_path / ".gitignore").write_text("__pycache__\n")
    subprocess.run(["git", "init", "--quiet", str(tmp_path)], check=True)
    return tmp_path


def prove(checkout: Path) -> Proof:
    """Records the proof; as it is read again."""
    found = Proof.load("thing", checkout / "proofs")
    found.record(Proved("2026-11-23", found.digest(checkout), 7, "sha256:0"), checkout / "proofs")
    return Proof.load("thing", checkout / "proofs")


@pytest.mark.parametrize("name", proof.names())
def test_it_is_proved_as_it_is_committed(name: str) -> None:
    if stale := Proof.load(name).stale():
        pytest.fail(stale, pytrace=False)


def test_a_change_of_what_it_depends_on_needs_a_new_proof(checkout: Path) -> None:
    found = prove(checkout)
    assert found.stale(checkout) == ""
    (checkout / "README.md").write_text("Other words.\n")
    (checkout / "scripts/__pycache__").mkdir()
    (checkout / "scripts/__pycache__/one.pyc").write_text("")
    assert found.stale(checkout) == "", "it depends on neither"
    for name, text in {"lock.txt": "torch==2\n", "scripts/two.sh": "two\n"}.items():
        (checkout / name).write_text(text)
        assert found.stale(checkout) == (
            "what thing depends on has changed since 2026-11-23; run: make test-all PROOF=thing"
        )
        found = prove(checkout)


def test_what_was_never_proved_is_not_proved(checkout: Path) -> None:
    assert Proof.load("thing", checkout / "proofs").stale(checkout) == (
        "thing was never proved; run: make test-all PROOF=thing"
    )


def test_an_image_of_which_it_depends(tmp_path: Path) -> None:
    """Its lock, its component's scripts, the tests inside: not another image's."""
    target = "bookworm-core-tensorflow-cpu-test"
    found = Proof("thing", "", 1, targets=[target])
    for name in ("Dockerfile", ".dockerignore", "matrix.yaml", "components", "locks", "tests/structure", "tools"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cp", "-a", str(ROOT / name), str(tmp_path / name)], check=True)
    before = found.digest(tmp_path)
    assert before == found.digest(ROOT)
    for name, counts in {
        "components/torch/files.sh": False,
        "locks/cu128/amd64/3.11/torch.txt": False,
        "components/tensorflow/files.sh": True,
        "tests/structure/tensorflow.yaml": True,
    }.items():
        file = tmp_path / name
        text = file.read_text()
        file.write_text(text + "\n# changed\n")
        assert (found.digest(tmp_path) != before) == counts, name
        file.write_text(text)


def test_the_rest_of_its_file_stays(checkout: Path) -> None:
    prove(checkout)
    text = (checkout / "proofs/thing.yaml").read_text()
    assert text.startswith(PROOF) and text.count("proved:") == 1
    prove(checkout)
    assert (checkout / "proofs/thing.yaml").read_text() == text


def test_a_pattern_that_matches_nothing_is_an_error(checkout: Path) -> None:
    (checkout / "lock.txt").unlink()
    with pytest.raises(RosmlError, match=r"thing\.yaml: no committed file matches 'lock\.txt'"):
        Proof.load("thing", checkout / "proofs").digest(checkout)


TEST = """\
from rosml import old
from rosml.here import Failure


def test_it() -> None:
    if old.call("one", old=2):
        raise Failure("no")
"""


@pytest.mark.parametrize(
    ("changed", "counts"),
    [
        (TEST.replace('("one", old=2)', '(\n        "one",  # a comment\n        old=2\n    )'), False),
        (
            TEST.replace("from rosml import old", "from rosml.place import new").replace("old.", "new."),
            False,
        ),
        (TEST.replace("rosml.here", "rosml.there"), False),
        (TEST.replace("one", "two"), True),
        (TEST.replace("old=", "number="), True),
        (TEST.replace("Failure", "ValueError"), True),
        (TEST.replace("        raise", "    raise"), True),
        (TEST.replace(" None:", " None"), True),
    ],
    ids=["layout", "module", "place", "text", "name", "class", "block", "broken"],
)
def test_of_a_test_counts_what_it_says(checkout: Path, changed: str, counts: bool) -> None:
    """Neither its layout nor where the product keeps what it calls."""
    for name in ("old", "place/new"):
        (checkout / f"rosml/{name}.py").parent.mkdir(parents=True, exist_ok=True)
        (checkout / f"rosml/{name}.py").touch()
    (checkout / "scripts/test_it.py").write_text(TEST)
    found = prove(checkout)
    (checkout / "scripts/test_it.py").write_text(changed)
    assert bool(found.stale(checkout)) is counts


@pytest.mark.parametrize(
    ("outcome", "wrong"),
    [
        (Outcome("thing", 1, 1, passed=6, failed=1), "thing: 1 failed, 0 skipped, 6 passed"),
        (Outcome("thing", 1, 0, passed=6, skipped=1), "thing: 0 failed, 1 skipped, 6 passed"),
        (Outcome("thing", 1, 5), "thing: 0 failed, 0 skipped, 0 passed"),
    ],
)
def test_what_failed_or_was_skipped_is_no_proof(checkout: Path, outcome: Outcome, wrong: str) -> None:
    assert suite.settle(prove(checkout), outcome, "") == wrong


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "is damaged"),
        ("proves: [", "is damaged"),
        ("proves: a\nminutes: 1\n", "is damaged: KeyError: 'depends'"),
        ("proves: a\nminutes: 1\ndepends: {}\n", "depends on nothing"),
        ("proves: a\nminutes: 1\ndepends: {files: LICENSE}\n", "depends on nothing"),
        ("proves: a\nminutes: 1\ndepends: {file: [LICENSE]}\n", "is damaged"),
        ("proves: a\nminutes: 1\nproved: yes\ndepends: {files: [LICENSE]}\n", "is damaged"),
    ],
)
def test_a_damaged_proof_is_told_in_a_sentence(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "thing.yaml").write_text(text)
    with pytest.raises(RosmlError, match=rf"tests/proofs/thing\.yaml {re.escape(said)}"):
        Proof.load("thing", tmp_path)


def test_an_outcome_that_stands_first_is_replaced_alone(checkout: Path) -> None:
    (checkout / "proofs/thing.yaml").write_text("proved: null\n" + PROOF)
    prove(checkout)
    text = (checkout / "proofs/thing.yaml").read_text()
    assert text.startswith(PROOF) and text.count("proved:") == 1


def test_without_git_it_says_so(tmp_path: Path) -> None:
    (tmp_path / "LICENSE").write_text("")
    with pytest.raises(RosmlError, match="git does not list the checkout"):
        Proof("thing", "", 1, files=["LICENSE"]).digest(tmp_path)


def test_what_changes_while_it_runs_is_not_proved() -> None:
    found = Proof("thing", "", 1, files=["LICENSE"])
    said = suite.settle(found, Outcome("thing", 1, 0, passed=7), "sha256:before")
    assert said == "what thing depends on has changed while it ran; run it again: make test-all PROOF=thing"


def test_with_packages_from_elsewhere_it_is_not_recorded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_CHANNEL", "final")
    found = Proof("thing", "", 1, files=["LICENSE"])
    said = suite.settle(found, Outcome("thing", 1, 0, passed=7), found.digest())
    assert said == "thing is not recorded: it was given with ROS_CHANNEL"


def test_a_proof_whose_set_up_fails_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """The others are; the run fails and names it."""
    ran: list[str] = []

    def run(phase: suite.Phase) -> Outcome:
        ran.append(phase.name)
        return Outcome(phase.name, 1, 1, failed=1)

    monkeypatch.setattr(suite, "set_up", lambda need: Outcome(f"set-up: {need}", 1, 1))
    monkeypatch.setattr(suite, "run", run)
    done = CliRunner().invoke(suite.main, ["--proof", "signer", "--proof", "apt"])
    assert done.exit_code == 1
    assert ran == ["proof: apt"]
    assert "signer failed, which these need: not run: signer" in done.output


def test_nothing_of_the_environment_chooses_tests(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PYTEST_ADDOPTS", "--collect-only")
    monkeypatch.setattr(suite, "LOGS", tmp_path)
    (tmp_path / "test_one.py").write_text("def test_one() -> None:\n    pass\n")
    outcome = suite.run(suite.Phase("one", suite.pytest("--rootdir", str(tmp_path), "-c", "/dev/null", str(tmp_path))))
    assert (outcome.code, outcome.passed) == (0, 1)


def test_a_run_without_tests_fails(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(suite, "run", lambda phase: Outcome(phase.name, 1, 0, log=tmp_path / "log"))
    done = CliRunner().invoke(suite.main, ["--phase", "page"])
    assert done.exit_code == 1 and "the catalogue's page: no test ran" in done.output


def test_in_ci_the_committed_proof_must_agree(checkout: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("CI", "true")
    known = Proof("thing", "", 1, files=["LICENSE"])
    known = Proof("thing", "", 1, files=["LICENSE"], proved=Proved("2026-11-23", known.digest(), 7, ""))
    now = known.digest()
    assert suite.settle(known, Outcome("thing", 1, 0, passed=7), now) == ""
    said = suite.settle(known, Outcome("thing", 1, 0, passed=8), now)
    assert "8 tests passed, and tests/proofs/thing.yaml says 7" in said
    other = Proof("thing", "", 1, files=["README.md"], proved=known.proved)
    assert "has changed since 2026-11-23" in suite.settle(other, Outcome("thing", 1, 0, passed=7), other.digest())


def test_every_proof_is_dealt_to_one_machine() -> None:
    proofs = [Proof.load(name) for name in proof.names()]
    for shards in (1, 2, 3, 5):
        dealt = [suite.deal(proofs, number + 1, shards) for number in range(shards)]
        assert [quick for quick, _ in dealt].count(True) == 1
        assert sorted(found.name for _, part in dealt for found in part) == sorted(proof.names())


def test_three_machines_are_enough() -> None:
    """By the minutes that the proofs state, none of them works for longer than 90."""
    proofs = [Proof.load(name) for name in proof.names()]
    for number in (1, 2, 3):
        quick, part = suite.deal(proofs, number, 3)
        assert sum(found.minutes for found in part) + (suite.QUICK_MINUTES if quick else 0) <= 90


def test_every_proof_has_tests() -> None:
    """And a test cannot name a proof that there is not: tests/conftest.py refuses it."""
    sources = "".join(file.read_text() for file in (ROOT / "tests").glob("*/test_*.py") if file != Path(__file__))
    marked = set(re.findall(r'full\(proof="([\w-]+)"\)', sources))
    assert marked == {name for name in proof.names() if not Proof.load(name).tests}
    assert all((ROOT / test).is_file() for name in proof.names() for test in Proof.load(name).tests)


def test_every_proof_depends_on_its_tests() -> None:
    for file in (ROOT / "tests").glob("*/test_*.py"):
        if file != Path(__file__):
            for name in set(re.findall(r'full\(proof="([\w-]+)"\)', file.read_text())):
                assert str(file.relative_to(ROOT)) in Proof.load(name).files, f"{name}.yaml does not list {file.name}"


def test_all_tests_lie_where_a_run_looks_for_them() -> None:
    phases = ("lint", "unit", "page", "e2e")
    elsewhere = [file for file in (ROOT / "tests").rglob("*test*.py") if file.parent.name not in (*phases, "tests")]
    assert [file for file in elsewhere if re.match(r"tests?_|.*_tests?\.py", file.name)] == []
    assert not list((ROOT / "tests").glob("test_*.py"))
    assert FOLDER.is_dir()


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_a_shard_that_is_none(shard: str) -> None:
    done = CliRunner().invoke(suite.main, ["--all", "--shard", shard])
    assert done.exit_code == 2
    assert "write it as i/n, such as 1/3" in done.output
