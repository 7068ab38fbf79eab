"""`rosml locks`: what it writes, prints and refuses, with a local replacement for uv."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL

from fakes.uv import RESOLVED, UV, fake_uv
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import locks as script
from rosml.images.image_set import lock_file
from rosml.images.locks import base_digests, shared_files
from rosml.images.locks.shared_files import Difference


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a matrix of one stack for one Python, and a uv on the PATH."""
    monkeypatch.setattr(script, "ROOT", tmp_path)
    monkeypatch.setattr(signal, "signal", lambda *_: None)  # a test run keeps its own
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    monkeypatch.setenv("ROSML_DOCKER_HUB", "0")  # nobody is asked for base images: test_base_digests.py
    fake_uv(tmp_path)
    (tmp_path / "matrix.yaml").write_text(SMALL)
    return tmp_path


def run(checkout: Path, *arguments: str) -> int:
    return command.run(script.main, arguments=["--matrix", str(checkout / "matrix.yaml"), *arguments])


def test_writes_and_then_has_nothing_to_write(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(checkout) == 0
    done = capsys.readouterr()
    assert "locks/cu1/amd64/3.12/torch.txt: written\n" in done.out
    assert "[4 of 4] stack " in done.err, "long work shows progress"
    text = (checkout / "locks/cu1/amd64/3.12/torch.txt").read_text()
    assert lock_file.versions(text) == {"torch": "2.10.0+cu128"}
    assert run(checkout, "--check") == 0
    assert re.fullmatch(r"\d+ locks, 0 outdated\n", capsys.readouterr().out)


def test_check_says_what_would_change(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(checkout)
    fake_uv(checkout, resolved=RESOLVED.replace("numpy==1.26.4", "numpy==1.26.5"))
    before = {file: file.read_text() for file in checkout.glob("locks/**/*.txt")}
    capsys.readouterr()
    assert run(checkout, "--check") == 1
    done = capsys.readouterr()
    assert "locks/cu1/amd64/3.12/common.txt: would change\n" in done.out
    table = [line.split() for line in done.out.splitlines() if line.startswith("c")]
    assert table == [["cpu", "numpy", "1.26.4", "1.26.5", "2"], ["cu1", "numpy", "1.26.4", "1.26.5", "2"]]
    assert {file: file.read_text() for file in checkout.glob("locks/**/*.txt")} == before


@pytest.mark.parametrize(
    ("words", "moved", "numpy", "message"),
    [
        ("--upgrade", 2, "1.26.5", "2 base images and 4 locks are outdated: 'rosml locks --upgrade', then"),
        ("--bases", 1, "1.26.4", "1 base image is outdated: 'rosml locks --bases', then 'rosml generate'"),
        ("--upgrade --stack cpu", 0, "1.26.5", "2 locks are outdated: 'rosml locks --upgrade --stack cpu' and"),
    ],
)
def test_check_names_what_is_stale_and_the_command_that_writes_it(
    words: str, moved: int, numpy: str, message: str, checkout: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run(checkout)
    fake_uv(checkout, resolved=RESOLVED.replace("numpy==1.26.4", f"numpy=={numpy}"))
    pins = [base_digests.Pin(f"system-{number}", "image:tag", "old", "new") for number in range(moved)]
    monkeypatch.setattr(base_digests, "look", lambda *_: base_digests.Pins(pins))
    arguments = ["--matrix", str(checkout / "matrix.yaml"), *words.split(), "--check"]
    with pytest.raises(RosmlError) as caught:
        script.main.main(arguments, standalone_mode=False)
    assert f"{caught.value.message}: {caught.value.remedy}".replace(": run ", ": ").startswith(message)


@pytest.mark.parametrize(
    "words",
    ["--bases --upgrade", "--bases --stack cpu", "--upstream --upgrade", "--upstream --check", "--installs --check"],
)
def test_options_that_exclude_each_other(checkout: Path, words: str) -> None:
    assert run(checkout, *words.split()) == 2
    assert not (checkout / "locks").exists()


def test_check_of_locks_that_are_not_there(checkout: Path) -> None:
    assert run(checkout, "--check") == 1
    assert not (checkout / "locks").exists()


def test_one_stack(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(checkout)
    fake_uv(checkout, resolved=RESOLVED.replace("sha256:ee", "sha256:ff"))
    capsys.readouterr()
    assert run(checkout, "--stack", "cpu") == 0
    done = capsys.readouterr().out
    assert "locks/cpu/arm64/3.12/torch.txt: written" in done
    assert "locks/cu1/" not in done, "neither written nor called superfluous"
    assert run(checkout, "--stack", "cp") == 2
    assert "no stack named 'cp'; did you mean 'cpu'" in capsys.readouterr().err


def test_what_moved_for_machines(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def printed(*arguments: str, code: int = 0) -> dict[str, Any]:
        capsys.readouterr()
        assert run(checkout, "--json", *arguments) == code
        data: dict[str, Any] = json.loads(capsys.readouterr().out)
        return data

    first = printed()
    assert first["moved"] == [] and first["new"] == first["changed"]
    assert "locks/cu1/amd64/3.12/torch.txt" in first["new"]
    fake_uv(checkout, resolved=RESOLVED.replace("numpy==1.26.4", "numpy==1.26.5"))
    stale = printed("--check", code=1)
    common = sorted(path for path in first["new"] if path.endswith("/common.txt"))
    assert stale["changed"] == common and stale["new"] == []
    counts = Counter(path.split("/")[1] for path in common)
    assert stale["moved"] == [
        {"stack": stack, "package": "numpy", "old": "1.26.4", "new": "1.26.5", "locks": counts[stack]}
        for stack in sorted(counts)
    ]
    assert printed() == stale
    assert printed() == {**stale, "moved": [], "changed": []}
    fake_uv(checkout, UV + "exit 1")
    assert "does not resolve" in printed(code=1)["error"]


def test_false_hashes_do_not_stay(checkout: Path) -> None:
    run(checkout)
    torch = checkout / "locks/cu1/amd64/3.12/torch.txt"
    torch.write_text(torch.read_text().replace("sha256:ee", "sha256:00"))
    assert run(checkout, "--check") == 1
    assert "--hash" not in (checkout / "seen-out.txt").read_text()
    assert run(checkout) == 0
    assert "sha256:ee" in torch.read_text()


def test_locks_that_nothing_needs(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(checkout)
    (checkout / "locks/old.txt").write_text("")
    assert run(checkout) == 0
    assert "locks/old.txt: belongs to nothing in matrix.yaml; delete it\n" in capsys.readouterr().out
    assert (checkout / "locks/old.txt").exists()


def test_locks_of_environments_are_others(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`rosml env add` makes them."""
    run(checkout)
    environment = checkout / "environments/grasp/3.12/amd64.txt"
    environment.parent.mkdir(parents=True)
    environment.write_text("")
    run(checkout)
    captured = capsys.readouterr()
    assert "environments" not in captured.out + captured.err


def test_a_set_keeps_its_own_locks(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(checkout) == 0
    rosml, kept = checkout / ".rosml", "locks/cpu/arm64/3.12/common.txt"
    (checkout / "matrix.yaml").rename(checkout / "set.yaml")
    rosml.mkdir()
    (checkout / "locks").rename(rosml / "locks")
    (rosml / "locks/old.txt").write_text("")
    (rosml / "set.yaml").symlink_to("../set.yaml")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(script, "ROOT", rosml)
        arguments = ["--matrix", str(checkout / "set.yaml")]
        assert command.run(script.main, arguments=arguments) == 0
        assert not (checkout / "locks").exists()
        before = (rosml / kept).read_text()
        fake_uv(checkout, resolved=RESOLVED.replace("numpy==1.26.4", "numpy==1.26.5"))
        capsys.readouterr()
        assert command.run(script.main, arguments=[*arguments, "--stack", "cpu"]) == 0
    out = capsys.readouterr().out
    assert f"{kept}: written\n" in out and "old.txt" not in out, "rosml's, and no business of the set"
    assert "numpy==1.26.5" in (checkout / kept).read_text() and (rosml / kept).read_text() == before
    assert not (checkout / "locks/cu1").exists()


def test_upgrade_forgets_earlier_versions(checkout: Path) -> None:
    run(checkout)
    assert run(checkout) == 0
    assert (checkout / "seen-out.txt").exists()
    (checkout / "seen-out.txt").unlink()
    assert run(checkout, "--upgrade") == 0
    assert not (checkout / "seen-out.txt").exists()


def test_command_without_uv(
    checkout: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(checkout / "locks"))
    assert run(checkout) == 1
    assert "'uv' is not installed" in capsys.readouterr().err


def test_command_when_uv_fails(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    fake_uv(checkout, UV + "echo 'no answer from the index' >&2; exit 2")
    assert run(checkout) == 1
    assert "does not resolve:\nno answer from the index\n" in capsys.readouterr().err
    assert not (checkout / "locks").exists()


def test_a_signal_ends_every_resolution_at_once(checkout: Path) -> None:
    """A signal to the command alone, as `kill` and CI send it: uv would wait for its index for minutes."""
    fake_uv(checkout, 'touch "$(dirname "$0")/began-$$"; exec sleep 60')
    argv = [sys.executable, str(ROOT / "src"), "locks", "--matrix", str(checkout / "matrix.yaml"), "--check"]
    with subprocess.Popen(argv, stderr=subprocess.PIPE, text=True) as process:
        try:
            deadline = time.monotonic() + 20
            while len(list(checkout.glob("began-*"))) < 4 and time.monotonic() < deadline:
                time.sleep(0.05)
            process.send_signal(signal.SIGTERM)
            _, errors = process.communicate(timeout=20)  # long before uv ends by itself
        finally:
            process.kill()
    assert process.returncode == command.INTERRUPTED
    assert errors.endswith("interrupted\n")
    running = [file.name for file in checkout.glob("began-*") if Path(f"/proc/{file.name.partition('-')[2]}").exists()]
    assert not running, "no uv is left behind"


def test_wheels_that_differ_from_a_shared_part_are_named(
    checkout: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    files = ("tensorflow/include/a.h",)
    difference = Difference("tensorflow-cc", "cpu", "arm64", "tensorflow==2.20.0", "3.11", "3.12", files)
    monkeypatch.setattr(shared_files, "differences", lambda *_: [difference])
    assert run(checkout, "--report", str(checkout / "report.md")) == 0
    assert str(difference) in capsys.readouterr().err
    assert f"- {difference}\n" in (checkout / "report.md").read_text()
    run(checkout, "--json")
    (item,) = json.loads(capsys.readouterr().out)["differing"]
    assert (item["package"], item["python"], item["files"]) == ("tensorflow==2.20.0", "3.12", list(files))
