"""What people see of a build, what the summary counts, and that nothing BuildKit says can stop it."""

from __future__ import annotations

import base64
import json
import time
from collections.abc import Iterator
from io import StringIO
from typing import Any

import pytest

from rosml.machine import progress
from rosml.machine.progress import BuildProgress, Step

DAY = "2026-11-21T11:03:"
ROS = (
    "[ros1-bookworm-core ros 1/2] RUN --mount=type=bind,source=components/base,target=/run/components/base     "
    "--mount=type=secret,id=ca-bundle     /run/components/ros/install.sh ros-core"
)
TORCH = (
    "[_files-torch part-files 2/2] RUN --mount=type=bind,source=components/torch,target=/run/components/torch "
    "/run/components/part/assemble.sh"
)
JOIN = "[ros1-bookworm-core-torch-cu128 torch 1/1] COPY --link --from=part-torch /out/ /"


class Clock:
    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


class Build:
    def __init__(self, summary: str = "", hidden: tuple[str, ...] = ()) -> None:
        self.out, self.log, self.clock = StringIO(), StringIO(), Clock()
        self.progress = BuildProgress(self.out, self.log, self.clock, summary, hidden)

    def vertex(self, name: str, **facts: Any) -> None:
        self.progress.feed(json.dumps({"vertexes": [{"digest": f"sha256:{name}", "name": name, **facts}]}) + "\n")

    def prints(self, name: str, data: bytes) -> None:
        log = {"vertex": f"sha256:{name}", "stream": 1, "data": base64.b64encode(data).decode()}
        self.progress.feed(json.dumps({"logs": [log]}))

    def step(self, name: str) -> Step:
        return self.progress.steps[f"sha256:{name}"]

    @property
    def shown(self) -> str:
        return self.out.getvalue()


@pytest.fixture
def build() -> Build:
    return Build()


# ---- Steps -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "label"),
    [
        (ROS, "[ros1-bookworm-core ros 1/2] /run/components/ros/install.sh ros-core"),
        (TORCH, "build part torch from its lock"),
        (JOIN, "[ros1-bookworm-core-torch-cu128 torch 1/1] COPY --link --from=part-torch /out/ /"),
        (
            '[robot app-files 1/2] RUN --mount=type=bind,target=/x ["/run/scripts/containerize/step.sh", "/run/app.py", "/base"]',
            "[robot app-files 1/2] /run/app.py /base",
        ),
        ("pushing layers", "pushing layers"),
    ],
)
def test_words_for_a_step(name: str, label: str) -> None:
    assert Step(name).label == label
    assert not Step(name).internal


@pytest.mark.parametrize("fraction", [".1", ".12", ".123456", ".123456789", ".10000000", ""])
def test_times_of_go_have_up_to_nine_digits(build: Build, fraction: str) -> None:
    build.vertex(ROS, started=f"{DAY}10{fraction}Z", completed=f"{DAY}12.5{'0' * 8}Z")
    expected = 2.5 - float(fraction or 0)
    assert build.step(ROS).seconds == pytest.approx(expected, abs=2e-6)


def test_zero_time_is_no_time(build: Build) -> None:
    build.vertex(ROS, started="0001-01-01T00:00:00Z", completed="0001-01-01T00:00:00Z")
    assert (build.step(ROS).started, build.step(ROS).completed) == (0.0, 0.0)
    build.vertex(ROS, started=f"{DAY}10Z", completed="0001-01-01T00:00:00Z")
    assert (build.step(ROS).seconds, build.shown) == (0.0, "")
    build.vertex(ROS, started=f"{DAY}10Z", completed=f"{DAY}13Z")
    assert build.step(ROS).seconds == 3.0
    build.vertex(TORCH, started=f"{DAY}10Z", completed=f"{DAY}05Z")
    assert build.step(TORCH).seconds == 0.0, "a clock went back"


# ---- What people see -------------------------------------------------------------------------------------------------


def test_a_line_when_a_step_ends(build: Build) -> None:
    build.vertex(ROS)
    build.vertex(ROS, started=f"{DAY}10.25Z")
    assert build.shown == ""
    build.clock.now += 75
    for _ in range(2):  # BuildKit repeats itself, once for each target that shares the step
        build.vertex(ROS, started=f"{DAY}10.25Z", completed=f"{DAY}42Z")
    assert build.shown == "    1:15    31.8 s  [ros1-bookworm-core ros 1/2] /run/components/ros/install.sh ros-core\n"


INTERNAL = (
    "[internal] load local bake definitions",
    "[_os-bookworm internal] load build context",
    "[_os-bookworm context os] docker.io/library/debian:bookworm",
    "[ros1-bookworm-core-torch-cu128 torch 1/1] LINK COPY --link --from=part-torch /out/ /",
)


def test_no_line_for_bookkeeping_and_what_took_no_time(build: Build) -> None:
    build.vertex(ROS, started=f"{DAY}10Z", completed=f"{DAY}10.4Z")
    for name in INTERNAL:
        build.vertex(name, started=f"{DAY}10Z", completed=f"{DAY}30Z")
    build.vertex(TORCH, started=f"{DAY}10Z", cached=True)
    build.vertex(TORCH, started=f"{DAY}10Z", completed=f"{DAY}30Z")
    assert build.shown == "" and build.step(TORCH).seconds == 0.0
    assert f"CACHED {TORCH}\n" in build.log.getvalue()


@pytest.mark.parametrize(("columns", "length"), [("80", 80), ("200", 150), ("", 150)])
def test_long_lines_are_cut(build: Build, monkeypatch: pytest.MonkeyPatch, columns: str, length: int) -> None:
    monkeypatch.setattr(build.out, "isatty", lambda: bool(columns))
    monkeypatch.setenv("COLUMNS", columns)
    build.vertex("[a ros 1/1] RUN " + "x" * 500, started=f"{DAY}10Z", completed=f"{DAY}12Z")
    assert len(build.shown) == length + 1
    assert build.shown.endswith("x…\n") and "x" * 500 in build.log.getvalue()


# ---- Heartbeat -------------------------------------------------------------------------------------------------------


def test_heartbeat_names_what_runs_longest(build: Build) -> None:
    build.vertex(ROS, started=f"{DAY}10Z")
    build.vertex(TORCH, started=f"{DAY}05Z")
    build.vertex("[x context os] pull", started=f"{DAY}01Z")
    build.vertex(JOIN)
    build.clock.now += progress.HEARTBEAT_SECONDS - 1
    build.prints(TORCH, b"Unpacking numpy\n\n")
    assert build.shown == ""
    build.clock.now += 1
    build.prints(TORCH, b"  Unpacking torch  \n")
    assert build.shown == "    0:20     …      build part torch from its lock: Unpacking torch\n"
    build.clock.now += progress.HEARTBEAT_SECONDS - 1
    build.vertex(TORCH, started=f"{DAY}05Z")
    assert build.shown.count("\n") == 1, "it waits as long for the next one"


def test_heartbeat_of_a_build_with_a_summary() -> None:
    build = Build(summary="looking into vendor:1")
    build.vertex("[x context os] pull", started=f"{DAY}01Z")
    build.clock.now += progress.HEARTBEAT_SECONDS
    build.vertex(ROS, started=f"{DAY}01Z", completed=f"{DAY}21Z")
    assert build.shown == "    0:20     …      looking into vendor:1\n"


def test_heartbeat_of_a_build_that_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """BuildKit says nothing while a step says nothing: the heartbeat must not wait for it."""
    monkeypatch.setattr(progress, "HEARTBEAT_SECONDS", 0.02)

    def lines() -> Iterator[str]:
        yield json.dumps({"vertexes": [{"digest": "a", "name": ROS, "started": f"{DAY}10Z"}]})
        time.sleep(0.1)

    out = StringIO()
    BuildProgress(out).follow(lines())
    assert "…      [ros1-bookworm-core ros 1/2]" in out.getvalue()


# ---- What goes wrong -------------------------------------------------------------------------------------------------


def test_the_failed_step(build: Build) -> None:
    cancelled = "failed to solve: Canceled: context canceled"
    build.vertex(TORCH, started=f"{DAY}10Z", completed=f"{DAY}20Z", error=cancelled)
    assert build.progress.failed() is None
    build.vertex(ROS, started=f"{DAY}10Z", completed=f"{DAY}20Z", error="exit code: 100")
    assert build.progress.failed() is build.step(ROS)
    assert build.shown == "", "the error is told at the end"
    assert f"10.0 s {ROS} exit code: 100" in build.log.getvalue()


def test_tail_and_log(build: Build) -> None:
    build.vertex(ROS, started=f"{DAY}10Z")
    build.prints(ROS, b"one\r\ntwo\n\nthree \xff\n")
    assert list(build.step(ROS).tail) == ["one", "two", "three \ufffd"]
    for number in range(progress.KEPT_LINES):
        build.prints(ROS, f"line {number}\n".encode())
    assert list(build.step(ROS).tail) == [f"line {number}" for number in range(progress.KEPT_LINES)]
    assert "    one\n    two\n" in build.log.getvalue(), "the log keeps what the tail drops"
    build.prints("of a step that nobody knows", b"kept in the log\n")
    assert "    kept in the log\n" in build.log.getvalue()


def test_a_line_that_comes_in_pieces_is_one_line(build: Build) -> None:
    """As apt writes its errors through a pipe: `E`, `: `, and the rest. A letter may be cut, too."""
    build.vertex(ROS, started=f"{DAY}10Z")
    for piece in (b"E", b": ", b"Unable to locate package x\nE: ", "für".encode()[:2], "für".encode()[2:], b" x"):
        build.prints(ROS, piece)
    assert list(build.step(ROS).tail) == ["E: Unable to locate package x"]
    build.vertex(ROS, started=f"{DAY}10Z", completed=f"{DAY}12Z", error="exit code: 100")
    assert list(build.step(ROS).tail) == ["E: Unable to locate package x", "E: für x"]
    assert "    E: Unable to locate package x\n    E: für x\n" in build.log.getvalue()


def test_a_secret_that_a_step_prints_is_in_no_line() -> None:
    """Also if it comes in pieces."""
    build = Build(hidden=("", "canary-77"))
    build.vertex(ROS, started=f"{DAY}10Z")
    for piece in (b"https://me:cana", b"ry-77@x\nof can", b"aries\n"):
        build.prints(ROS, piece)
    assert list(build.step(ROS).tail) == ["https://me:***@x", "of canaries"]
    assert "canary" not in build.log.getvalue()


def test_a_line_without_an_end(build: Build) -> None:
    build.vertex(ROS, started=f"{DAY}10Z")
    build.prints(ROS, b"." * progress.LONGEST_LINE)
    assert list(build.step(ROS).tail) == []
    build.prints(ROS, b".")
    assert list(build.step(ROS).tail) == ["." * (progress.LONGEST_LINE + 1)]
    data = base64.b64encode(b"the last words").decode()
    build.progress.follow([json.dumps({"logs": [{"vertex": f"sha256:{ROS}", "data": data}]})])
    assert build.step(ROS).tail[-1] == "the last words", "buildx ended"


def test_what_is_not_json_is_kept(build: Build) -> None:
    build.progress.follow(["ERROR: cannot connect\n", "\n", "  \n", '{"vertexes":[\n', "\x00\xff\n"])
    assert list(build.progress.other) == ["ERROR: cannot connect", '{"vertexes":[', "\x00\xff"]
    assert "ERROR: cannot connect\n" in build.log.getvalue()
    assert build.shown == ""
