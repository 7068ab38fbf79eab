"""Locks of environments: what is the image's, what is installed, and what does not go together. uv is a table here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from rosml import MATRIX
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.environments import add, build, lock
from rosml.images.environments.declaration import FILE, Declaration
from rosml.images.environments.lock import NoSolution, Provider
from rosml.images.image_set import load
from rosml.images.locks.uv import Uv

WHEELS = "x86_64-manylinux_2_36"
ARCHITECTURES = ("amd64", "arm64")
IMAGE = Provider(
    "robot",
    "amd64",
    "3.11",
    36,
    WHEELS,
    {"torch": "2.10.0+cu128", "numpy": "1.24.2", "nvidia-nccl-cu12": "2.27.5"},
    {"torch"},
)
WISH = Declaration(requirements=["lerobot==0.4.4"], without=["evdev"])
HASH = f"    --hash=sha256:{'a' * 64}"
NO = "error: No solution found when resolving dependencies\n  cause: nothing fits"


class Table(Uv):
    """Answers if all constraints are among those that it takes."""

    def __init__(self, versions: Mapping[str, str], takes: Sequence[str]) -> None:
        super().__init__()
        self.versions, self.takes, self.calls = versions, takes, list[Mapping[str, str]]()

    def compile(
        self, arguments: Sequence[str], inputs: Mapping[str, str], output: str = "out.txt"
    ) -> tuple[int, str, str]:
        self.calls.append(inputs)
        if {*inputs["constraints.txt"].split()} - {*self.takes}:
            return 1, "", NO
        lines = []
        for name, wanted_by in {
            "lerobot": "-r in.txt",
            "numpy": "lerobot",
            "torch": "lerobot",
            "triton": "torch",
        }.items():
            lines += [f"{name}=={self.versions[name]} \\", HASH, f"    # via {wanted_by}"]
        return 0, "\n".join(lines), ""


VERSIONS = {"lerobot": "0.4.4", "numpy": "2.2.6", "torch": "2.10.0", "triton": "3.6.0"}


def test_what_fits_is_the_images() -> None:
    uv = Table(VERSIONS, ["torch==2.10.0"])
    result = lock.resolved("lerobot", WISH, IMAGE, uv)
    assert result.takes == result.releases == {"torch": "2.10.0"}
    assert [(pin.name, pin.version) for pin in result.pins] == [("lerobot", "0.4.4"), ("numpy", "2.2.6")]
    assert [it["constraints.txt"].split() for it in uv.calls] == [
        ["numpy==1.24.2", "nvidia-nccl-cu12==2.27.5", "torch==2.10.0"],  # all of it, and then what it cannot do without
        ["torch==2.10.0"],
    ]
    assert uv.calls[0]["overrides.txt"] == "evdev; python_version < '3'\n"


def test_it_takes_all_that_it_can() -> None:
    uv = Table({**VERSIONS, "numpy": "1.24.2"}, ["torch==2.10.0", "numpy==1.24.2", "nvidia-nccl-cu12==2.27.5"])
    result = lock.resolved("lerobot", WISH, IMAGE, uv)
    assert result.takes == {"torch": "2.10.0", "numpy": "1.24.2"} and result.releases == {"torch": "2.10.0"}
    assert [pin.name for pin in result.pins] == ["lerobot"]


def test_another_release_of_the_image() -> None:
    with pytest.raises(NoSolution, match="lerobot does not go with robot") as caught:
        lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, []))
    assert caught.value.exit_code == 2 and "nothing fits" in caught.value.reason


def test_an_index_that_does_not_answer() -> None:
    class Silent(Table):
        def compile(
            self, arguments: Sequence[str], inputs: Mapping[str, str], output: str = "out.txt"
        ) -> tuple[int, str, str]:
            return 2, "", "error: Request failed after 3 retries"

    with pytest.raises(RosmlError, match="Request failed") as caught:
        lock.resolved("lerobot", WISH, IMAGE, Silent({}, []))
    assert "index" in caught.value.remedy and not isinstance(caught.value, NoSolution)


def test_a_lock_is_read_as_it_was_written(tmp_path: Path) -> None:
    result = lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"]))
    newer = replace(result, python="3.13")
    add.write(tmp_path, [result, newer], WISH)
    ((read,), other) = build.read(tmp_path, "lerobot", ARCHITECTURES)
    assert [*map(str, other)] == [str(newer)] and build.read(tmp_path, "lerobot", ARCHITECTURES, "3.13") == [other]
    assert str(read) == str(result) and read.takes == result.takes and read.glibc == 36


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("sha256:", "md5:"),
        ("numpy==2.2.6 \\\n", "numpy @ https://example.com/numpy.whl \\\n"),
        ("lerobot==0.4.4", "--index-url https://example.com\nlerobot==0.4.4"),
        (HASH, ""),
        ("'lerobot'", "'../lerobot'"),
        ("3.11", "3.11; rm"),
        ("glibc 2.36.\n", ""),
        ("2.36", f"2.{'9' * 5000}"),
        ("amd64", "arm64"),
        ("releases: torch==2.10.0", "releases: torch==2.9.0"),
        ("numpy==2.2.6", "LeRobot==0.4.5"),
        ("numpy==2.2.6", "Torch==2.9.0"),
    ],
)
def test_a_lock_that_somebody_edited(text: str, other: str, tmp_path: Path) -> None:
    whole = str(lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"])))
    assert text in whole
    file = lock.file_of(tmp_path, "3.11", "amd64")
    file.parent.mkdir()
    file.write_text(whole.replace(text, other))
    with pytest.raises(RosmlError, match="was cut or edited"):
        build.read(tmp_path, "lerobot", ARCHITECTURES)


def test_a_resolution_starts_from_a_whole_lock_alone(tmp_path: Path) -> None:
    """uv would follow `-r` in another text, and stop at the marks that git leaves."""
    file, request = lock.file_of(tmp_path, "3.11", "amd64"), add.Request("lerobot", WISH, tmp_path)
    file.parent.mkdir()
    whole = str(lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"])))
    for text, previous in {
        whole: whole,
        f"-r https://example.com/x\n{whole}": "",
        f"{whole}<<<<<<< HEAD\n": "",
    }.items():
        file.write_text(text)
        assert request.previous("3.11", "amd64") == previous
    assert replace(request, preferences="numpy==2.2.6\n").previous("3.11", "amd64") == "numpy==2.2.6\n"


def test_locks_that_cannot_be_written_leave_the_declaration_as_it_was(tmp_path: Path) -> None:
    lock.file_of(tmp_path, "3.11", "arm64").mkdir(parents=True)
    first = lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"]))
    every = [replace(first, architecture=name) for name in ARCHITECTURES]
    with pytest.raises(RosmlError, match=r"arm64\.txt: cannot be"):
        add.write(tmp_path, every, WISH)
    assert not (tmp_path / FILE).exists()


def test_a_folder_that_takes_no_files(tmp_path: Path) -> None:
    files.require_writable(tmp_path / "environments/lerobot")
    (tmp_path / "environments").write_text("")
    with pytest.raises(RosmlError, match=r"lerobot: cannot be written: .*environments is no folder"):
        files.require_writable(tmp_path / "environments/lerobot")


def test_locks_of_two_environments(tmp_path: Path) -> None:
    result = lock.resolved("other", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"]))
    add.write(tmp_path, [result])
    with pytest.raises(RosmlError, match="not of one environment lerobot"):
        build.read(tmp_path, "lerobot", ARCHITECTURES)


def test_a_new_lock_removes_those_of_other_images(tmp_path: Path) -> None:
    first = lock.resolved("lerobot", WISH, IMAGE, Table(VERSIONS, ["torch==2.10.0"]))
    add.write(tmp_path, [first, replace(first, architecture="arm64"), replace(first, python="3.13")])
    (notes := tmp_path / "3.11/notes.txt").write_text("somebody's")
    add.write(tmp_path, [first])
    assert {*tmp_path.glob("*/*")} == {lock.file_of(tmp_path, "3.11", "amd64"), notes}


def test_one_image_for_each_python() -> None:
    image_set, wish = load.load(MATRIX), WISH.model_copy(update={"images": ["ros1-bookworm-core"]})
    two = ("ros1-bookworm-core-torch-cu130", "ros1-bookworm-core-torch-cu128")
    with pytest.raises(RosmlError, match=r"cu130 and ros1-bookworm-core-torch-cu128 both have Python 3\.11") as caught:
        add.with_images(wish, two, image_set)
    assert caught.value.exit_code == 2
    assert add.with_images(wish, two[:1] * 2, image_set).images == [two[0]], "a later call replaces an earlier one"


def test_it_names_images_that_fit_and_can_be_built(tmp_path: Path) -> None:
    target, other = (f"ros1-bookworm-core-torch-{stack}" for stack in ("cu130", "cu128"))
    image_set = load.load(MATRIX)
    unlocked = [replace(it, unlocked=("a lock",)) if it.target == other else it for it in image_set.images]
    remedies = []
    for images in (image_set.images, tuple(unlocked)):
        with pytest.raises(RosmlError, match=f"lerobot does not go with {target}") as caught:
            request, uv = add.Request("lerobot", WISH, tmp_path), Table(VERSIONS, ["torch==2.10.0"])
            add.resolved(request, replace(image_set, images=images), target, lambda _: None, uv)
        assert caught.value.exit_code == 2 and not [*tmp_path.iterdir()]
        remedies.append(caught.value.remedy)
    assert f"{other} has torch 2.10.0" in remedies[0] and "cu132" not in remedies[0]
    assert other not in remedies[1] and "or give it its own beside the image's: --apart" in remedies[1]


def test_one_that_is_apart_takes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is resolved as beside an image without a framework, and has all that PyTorch needs."""
    monkeypatch.setattr(add, "_size", lambda *_: 4_000_000_000)
    target = "ros1-bookworm-core-torch-cu130"
    wish = WISH.model_copy(update={"apart": True})
    table = Table(VERSIONS, [])
    [sized, *_] = add.resolved(
        add.Request("lerobot", wish, tmp_path), load.load_one(MATRIX, target), target, lambda _: None, table
    )
    assert not sized.lock.takes and not sized.lock.releases
    assert {pin.name for pin in sized.lock.pins} == {*VERSIONS}
    request = add.Request("lerobot", WISH, tmp_path)
    with pytest.raises(RosmlError) as caught:
        add.resolved(request, load.load_one(MATRIX, target), target, lambda _: None, table)
    assert caught.value.remedy.endswith("or give it its own beside the image's: --apart (4.00 GB to download)")


def test_what_no_wheels_give(tmp_path: Path) -> None:
    target = "ros1-bookworm-core-torch-cu130"

    class Nothing(Table):
        def compile(
            self, arguments: Sequence[str], inputs: Mapping[str, str], output: str = "out.txt"
        ) -> tuple[int, str, str]:
            return (0, "", "") if any(it.endswith("3.12") for it in arguments) else (1, "", NO)

    with pytest.raises(RosmlError, match=r"no set of wheels for Python 3\.11 on amd64") as caught:
        add.resolved(add.Request("x", WISH, tmp_path), load.load(MATRIX), target, lambda _: None, Nothing({}, []))
    assert "--without" in caught.value.remedy and "name another image: jazzy-core, or" in caught.value.remedy
