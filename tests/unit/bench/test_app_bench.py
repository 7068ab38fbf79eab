"""`python -m bench app`: all sides start from the same base image, are compressed and pushed alike, and see the same change; with local
replacements for buildx and rosml, and a registry in this process."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from bench import app
from bench.app import CHANGED, COLD, GOALS, ONE, SAME, SEVERAL, SIDES, Pushed
from fakes.stubs import buildx, calls, executable, services
from rosml.containerize.build import bake_file as app_bake_file
from rosml.images.builds.push import COMPRESSION

BAKE = """
case $1 in prune) exit 0 ;; du) cat "$here/du" 2>/dev/null; exit 0 ;; esac
file=$(echo "$*" | sed 's/.*--file \\([^ ]*\\).*/\\1/')
cat "$file" >>"$here/baked" && echo >>"$here/baked"
sources="$here"/.state/bench/bench-*/"$target"/src/compass/src/compass.cpp
if ls $sources >/dev/null 2>&1; then cat $sources | grep -c 'const char. round()' >>"$here/$target.changes"; fi
printf '{"%s": {"containerimage.digest": "sha256:%064d"}}' "$target" "$(grep -c . "$here/baked")" >"$metadata"
"""

ROSML = """
echo "rosml $*" >>'{folder}/calls'
grep -c 'const char. round()' "$2/src/compass/src/compass.cpp" >>'{folder}/containerize.changes' || true
"""


NAMES = [side.replace(" ", "-") for side in SIDES]


class Stage:
    """A checkout with local replacements."""

    def __init__(self, folder: Path, registry: str) -> None:
        self.folder = folder
        self.bench = app.Bench(services(folder, registry, buildx=buildx(folder, BAKE)), lambda line: None)

    @property
    def baked(self) -> Iterator[tuple[str, dict[str, Any]]]:
        """All targets that buildx got, in order."""
        for line in (self.folder / "baked").read_text().splitlines():
            yield from json.loads(line)["target"].items()


@pytest.fixture
def stage(tmp_path: Path, registry: str, monkeypatch: pytest.MonkeyPatch) -> Stage:
    new = Stage(tmp_path, registry)
    rosml = executable(tmp_path / "rosml", ROSML.format(folder=tmp_path))
    monkeypatch.setattr(app, "ROSML", (rosml,))
    monkeypatch.setattr(app, "ROUNDS", 1)
    monkeypatch.setattr(app.Bench, "_stored", lambda bench, side, seconds: Pushed(seconds, {"m": 1}, {"l": 1}))
    new.bench.measure()
    return new


def test_all_sides_start_alike_and_are_pushed_alike(stage: Stage) -> None:
    """Each from an image that was made for it alone, on the same base image: no step of one side is in the cache of another."""
    marks = [fields for _, fields in stage.baked if "rosml-bench" in fields["dockerfile-inline"]]
    assert len({fields["dockerfile-inline"].partition("RUN")[2] for fields in marks}) == len(SIDES)
    assert len({fields["contexts"]["base"] for fields in marks}) == 1
    bases = [f"{stage.bench.services.registry}/bench-app/base@sha256:{number:064d}" for number in (1, 2, 3)]
    for side, base in zip((ONE, SEVERAL), bases, strict=False):
        built = [fields for name, fields in stage.baked if name == side.replace(" ", "-")]
        assert len(built) == len(GOALS) and {fields["contexts"]["base"] for fields in built} == {
            f"docker-image://{base}"
        }
        assert all(fields["output"][0].endswith(f",push=true,{COMPRESSION}") for fields in built)
        steps = app_bake_file.steps(stage.bench.services, {}, ["linux/amd64"])
        assert all(fields["secret"] == steps["secret"] for fields in built)
    ours = [call for call in calls(stage.folder) if call.startswith("rosml containerize ")]
    assert len(ours) == len(GOALS) and all(f"--base-image {bases[-1]} " in call for call in ours)
    assert all("--target run " in call and call.endswith(" --no-tests") for call in ours)


def test_all_sides_see_the_same_change(stage: Stage) -> None:
    """One function more after the builds that are cold, and nothing more after that."""
    folder = stage.folder / ".state/bench" / stage.bench.run
    assert len({(folder / name / app.SOURCE).read_text() for name in NAMES}) == 1
    for name in NAMES:
        assert (stage.folder / f"{name}.changes").read_text().split() == ["0", "1", "1"], name


def builds(seconds: Mapping[str, tuple[float, float, float]]) -> dict[tuple[str, str], list[Pushed]]:
    """Builds in three rounds, of which the median has these seconds. A change makes a layer of 5 bytes, and a manifest of one byte."""
    builds_by_side = {}
    for situation, times in seconds.items():
        for side, time in zip(SIDES, times, strict=True):
            layers = {"base": 100, ("new" if situation != COLD else "old"): 5}
            stored = {**layers, f"manifest {situation}": 1}
            builds_by_side[situation, side] = [Pushed(time * factor, stored, layers) for factor in (9, 1, 0.5)]
    return builds_by_side


def test_what_counts() -> None:
    """The median of rounds, and beside the faster Dockerfile."""
    rows = app.rows(builds({COLD: (10, 20, 7), CHANGED: (20, 10, 5.1), SAME: (1, 1, 0.1)}))
    assert [row.values for row in rows[:3]] == [[10, 20, 7], [20, 10, 5.1], [1, 1, 0.1]]
    assert [row.met for row in rows] == [True, False, True, None, None, None]
    pushed, pulled, whole = rows[3:]
    assert (pushed.values, pulled.values, whole.values) == ([6] * 3, [5] * 3, [105] * 3)


def test_what_is_removed_from_the_builder() -> None:
    """What has the marker, and all that was made from it, the last first; nothing else."""
    listed = (
        "ID: a\nDescription: mount / from exec echo bench-1-0 >x\n\nID: b\nParents:\n - a\nDescription: bench-2\n\n"
    )
    listed += (
        "ID: c\nParents:\n - b\n - z\nDescription: merge\n\nID: z\nDescription: pulled from x\n\nReclaimable: 1MB\n"
    )
    assert app.descendants(listed, "bench-1") == ["c", "b", "a"]
    assert app.descendants(listed, "bench-3") == []
