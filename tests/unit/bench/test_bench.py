"""The generator's work grows with the images and not with their square, and what `make bench` says when it is too slow."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from conftest import parse
from counting import calls

from bench import cli, generator, start, synthetic
from bench.generator import Measured
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.images.bake import bake_file

FINE = [Measured(1_000, 0.2), Measured(10_000, 2.0)]


@pytest.mark.parametrize("word", ["-h", "--help"])
def test_help(word: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(cli.main, arguments=[word]) == 0
    assert "--generator" in capsys.readouterr().out


@pytest.mark.parametrize("images", [1, 500])
def test_synthetic_matrices_are_valid(images: int) -> None:
    text = synthetic.matrix(images)
    assert images <= len(parse(text).images) < images + synthetic.IMAGES


def test_work_grows_with_the_images_and_not_with_their_square() -> None:
    """Eight times the images are less than eight times the work; with their square it would be 64 times."""
    few, many = (synthetic.matrix(images) for images in (500, 4_000))
    assert calls(lambda: bake_file.render(parse(many))) < 8 * calls(lambda: bake_file.render(parse(few)))


def test_within_the_limits() -> None:
    assert generator.missed(0.49, FINE) == []


@pytest.mark.parametrize(
    ("real", "sizes", "message"),
    [
        (0.5, FINE, "the real matrix takes 0.50 s; the limit of 0.5 s holds"),
        (0.1, [Measured(1_000, 0.3), Measured(10_000, 3.0)], "10000 images take 3.00 s; the limit of 3.0 s holds"),
        (
            0.1,
            [Measured(1_000, 0.1), Measured(10_000, 1.6)],
            "160 µs among 10000 and 100 µs among 1000; the limit of 1.5 times that holds",
        ),
    ],
)
def test_a_limit_is_missed(real: float, sizes: list[Measured], message: str) -> None:
    (found,) = generator.missed(real, sizes)
    assert message in found


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A bench of a moment."""
    monkeypatch.setattr(cli, "REPORT", tmp_path / "report")
    monkeypatch.setattr(generator, "SIZES", (96, 192))
    monkeypatch.setattr(generator, "ROUNDS", 1)
    monkeypatch.setattr(generator, "RUNS", 1)
    monkeypatch.setattr(start, "ROUNDS", 1)
    for limit in ("REAL_SECONDS", "LARGEST_SECONDS", "GROWTH", "PLAN_SECONDS", "DIGESTS_SECONDS"):
        monkeypatch.setattr(generator, limit, 1_000.0)


@pytest.mark.usefixtures("quick")
def test_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(cli.main, arguments=["--generator", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found.keys() == {"machine", "real_seconds", "sizes", "growth", "limits"}
    assert len(found["limits"]) == 3 and all(item["seconds"] > 0 for item in found["limits"])
    assert [size["images"] for size in found["sizes"]] == [96, 192]
    assert (tmp_path / "report/generator.svg").is_file()


@pytest.mark.usefixtures("quick")
def test_too_slow(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(generator, "LARGEST_SECONDS", 0.0)
    assert command.run(cli.main, arguments=["--generator", "--check"]) == 1
    done = capsys.readouterr()
    assert "192 images" in done.out
    assert "too slow: 192 images take" in done.err
    assert "cProfile" in done.err


def test_a_run_that_fails_is_no_measurement(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "false")
    with pytest.raises(RosmlError, match="--check failed"):
        generator.whole_run()
    with pytest.raises(RosmlError, match="run --rm ubuntu true failed"):
        start.held()


def test_the_start_of_a_container(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is measured beyond the engine's own, and reaches the engine."""
    monkeypatch.setattr(start, "ROUNDS", 1)
    assert 0 < start.held().seconds < 10
