"""What the package index has that a stack has not, since when, and what holds it; with a uv that says what tests want."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import SMALL, changed, parse

from fakes.stubs import calls, executable
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import locks as script
from rosml.images.locks import upstream
from rosml.images.locks.upstream import Newer

PYLOCK = """\
[[packages]]
name = "torch"
version = "{torch}"
wheels = [{{ url = "x", upload-time = 2026-10-28T15:16:55Z }}, {{ url = "y", upload-time = 2026-10-29T01:00:00Z }}]
[[packages]]
name = "tensorflow"
version = "2.20.0"
[[packages]]
name = "tensorflow-cpu"
version = "2.20.0"
[[packages]]
name = "torchvision"
version = "0.25.0"
"""
UV = """\
echo "uv $*" >>'{folder}/calls'
cat in.txt >>'{folder}/asked'
[ ! -e overrides.txt ] || cat overrides.txt >>'{folder}/overrides'
case "$*" in *pylock.toml*) cp '{folder}/newest.toml' pylock.toml; exit ;; esac
{resolve}
"""
RESOLVES = (
    "(grep == in.txt; echo nvidia-cuda-runtime-cu12==12.8.90) | sed 's/$/ --hash=sha256:aa/; s/ /\\n    /' >out.txt"
)
CUDA_13 = RESOLVES.replace("-cu12==12.8.90", "==13.2.86")
REFUSES = """cat >&2 <<'END'
error: No solution found when resolving dependencies
  cause: Because tensorflow==2.21.0 depends on nccl{platform_machine == 'x86_64'}>=2.27.7 and torch==2.10.0 depends on
         nccl==2.27.5, they are incompatible.
         And because you require both, your requirements are unsatisfiable.
END
exit 1"""


def uv(folder: Path, resolve: str = RESOLVES, torch: str = "2.15.0") -> str:
    (folder / "newest.toml").write_text(PYLOCK.format(torch=torch))
    return executable(folder / "uv", UV.format(folder=folder, resolve=resolve))


def test_nothing_is_newer(tmp_path: Path) -> None:
    assert upstream.look(parse(SMALL), uv(tmp_path, torch="2.10.0+cu128")) == []
    assert all("--no-deps" in call for call in calls(tmp_path)), "nothing is resolved for what is there"


def test_a_release_that_nothing_holds(tmp_path: Path) -> None:
    newer = upstream.look(parse(SMALL), uv(tmp_path), ["cu1"])
    assert newer == [Newer("cu1", "torch", "2.10.0", "2.15.0", "2026-10-28", "", (), ("3.12", "3.14"))]
    platforms = {call.partition("--python-platform ")[2].split()[0] for call in calls(tmp_path)}
    assert platforms == {"x86_64-manylinux_2_28"}


def test_what_holds_a_release(tmp_path: Path) -> None:
    """In one line; another CUDA: test_a_table_for_people_and_for_pull_requests_and_json."""
    reason = (
        "tensorflow==2.21.0 depends on nccl>=2.27.7 and torch==2.10.0 depends on nccl==2.27.5, they are incompatible."
    )
    assert {item.held_by for item in upstream.look(parse(SMALL), uv(tmp_path, REFUSES), ["cu1"])} == {reason}


def test_a_release_of_another_stack(tmp_path: Path) -> None:
    text = SMALL
    for place, more in {
        "  cpu:\n    accelerator": "  cu2: {accelerator: cuda, cuda: 13.2.86, cudnn: 9.26.0.51, releases: {torch: 2.15.0}}\n",
        "  tensorflow:\n    2.20.0": (
            '    2.15.0: {python: ["3.12"], wheels: {cu2: [amd64]}, adapted: {setuptools: ">=66"}, beside: {torchvision: 0.25.0}}\n'
        ),
        "    cpu:\n      common": "    cu2: {cuda: *, common: *, torch: *}\n".replace(
            "*", "{unpacked: 1, compressed: 1}"
        ),
    }.items():
        text = changed(place, more + place, text)
    (cu1,) = upstream.look(parse(text), uv(tmp_path), ["cu1"])
    assert cu1.elsewhere == ("cu2",)
    assert "setuptools>=66" in (tmp_path / "overrides").read_text()
    assert upstream.look(parse(text), uv(tmp_path), ["cu2"]) == []
    assert "torchvision\n" in (tmp_path / "asked").read_text()


@pytest.mark.parametrize("text", ["", "packages = 1", "[[packages]]\nname = 'torch'"])
def test_an_answer_that_is_none(tmp_path: Path, text: str) -> None:
    program = uv(tmp_path)
    (tmp_path / "newest.toml").write_text(text)
    with pytest.raises(RosmlError, match="cannot be read"):
        upstream.look(parse(SMALL), program)
    failing = executable(tmp_path / "uv", "echo 'dns error' >&2; exit 2")
    with pytest.raises(RosmlError, match="the newest releases are unknown:\ndns error"):
        upstream.look(parse(SMALL), failing)


def test_a_table_for_people_and_for_pull_requests_and_json(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", str(Path(uv(tmp_path, CUDA_13)).parent), prepend=":")
    (tmp_path / "matrix.yaml").write_text(SMALL)
    words, report = ["--matrix", str(tmp_path / "matrix.yaml"), "--upstream", "--stack", "cu1"], tmp_path / "report.md"
    assert command.run(script.main, arguments=[*words, "--report", str(report)]) == 0
    done = capsys.readouterr()
    assert "cu1, Python 3.12, 3.14" in done.out and "1 newer release" in done.out
    assert "[2 of 2] stack cu1, Python " in done.err, "long work shows progress"
    assert "| torch | 2.10.0 | 2.15.0 | 2026-10-28 | another CUDA: " in report.read_text()
    assert command.run(script.main, arguments=[*words, "--json"]) == 0
    (release,) = json.loads(capsys.readouterr().out)
    assert release == {
        "stack": "cu1",
        "package": "torch",
        "ours": "2.10.0",
        "newest": "2.15.0",
        "since": "2026-10-28",
        "held_by": "another CUDA: nvidia-cuda-runtime 13.2.86 (the stack says 12.8.90)",
        "elsewhere": [],
        "pythons": ["3.12", "3.14"],
    }
