"""A part for every Python has the files that parts of each Python expect: wheels are compared before anything is built."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Mapping
from pathlib import Path

import httpx
import pytest
from conftest import ROOT

from fakes.stubs import executable
from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.images.locks import shared_files
from rosml.images.locks.index import Index, Wheel
from rosml.images.locks.shared_files import Difference
from rosml.images.locks.uv import Uv

LOCK = {"locks/cpu/amd64/any/tensorflow-cc.txt": "tensorflow-cpu==2.21.0 \\\n    --hash=sha256:aa\n"}

# A local replacement for uv: for each version of Python it names another wheel.
RESOLVER = """\
while [ $# -gt 0 ]; do case $1 in --python-version) python=$2 ;; --output-file) output=$2 ;; esac; shift; done
size=$(cat "$(dirname "$0")/$python")
printf '[[packages]]\\nname = "tensorflow-cpu"\\nversion = "2.21.0"\\n' >"$output"
printf 'wheels = [{ url = "http://index/%s.whl", size = %s }]\\n' "$python" "$size" >>"$output"
"""


def wheel(record: str) -> bytes:
    """A wheel with a RECORD, behind a megabyte of other content."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("tensorflow/libtensorflow_cc.so.2", bytes(1 << 20))
        archive.writestr("tensorflow_cpu-2.21.0.dist-info/RECORD", record)
    return file.getvalue()


def client(
    wheels: Mapping[str, bytes], sent: list[int], ranges: bool = True, failing: list[Exception] | None = None
) -> httpx.Client:
    """An index with a wheel for each Python, which notes how many bytes it sends, once nothing fails any more."""

    def answer(request: httpx.Request) -> httpx.Response:
        if failing:
            raise failing.pop()
        content = wheels[request.url.path.removeprefix("/").removesuffix(".whl")]
        first, last = map(int, re.findall(r"\d+", request.headers["Range"]))
        piece = content[first : last + 1]
        sent.append(len(piece))
        return httpx.Response(206 if ranges else 200, stream=httpx.ByteStream(piece if ranges else content))

    return httpx.Client(transport=httpx.MockTransport(answer))


def differences(tmp_path: Path, records: Mapping[str, str], sent: list[int] | None = None) -> list[Difference]:
    wheels = {python: wheel(records.get(python, records["3.11"])) for python in ("3.10", "3.11", "3.12", "3.13")}
    for python, content in wheels.items():
        (tmp_path / python).write_text(str(len(content)))
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    with client(wheels, [] if sent is None else sent) as index:
        uv = Uv(executable(tmp_path / "uv", RESOLVER))
        return shared_files.differences(image_set, tmp_path, Index(uv, index), LOCK, ["cpu"])


@pytest.fixture
def components(tmp_path: Path) -> Path:
    folder = tmp_path / "components/tensorflow-cc"
    folder.mkdir(parents=True)
    (folder / "keep.txt").write_text("# Why.\ntensorflow/include/*\n*.dist-info/*\n")
    (folder / "prune.txt").write_text("tensorflow/include/external/*python*/*\n")
    return folder


def test_files_of_another_python_are_named(tmp_path: Path, components: Path) -> None:
    """Headers that differ, are missing, or come besides."""
    records = {
        "3.11": "tensorflow/include/a.h,sha256=1,1\ntensorflow/include/b.h,sha256=1,1\n",
        "3.12": "tensorflow/include/a.h,sha256=2,1\ntensorflow/include/c.h,sha256=1,1\n",
    }
    (difference,) = differences(tmp_path, records)
    facts = (difference.part, difference.package, difference.built_from, difference.python)
    assert facts == ("tensorflow-cc", "tensorflow-cpu==2.21.0", "3.11", "3.12")
    assert difference.files == tuple(f"tensorflow/include/{name}.h" for name in "abc")
    assert "other files for Python 3.12 than for Python 3.11" in str(difference)


def test_what_the_part_does_not_have_may_differ(tmp_path: Path, components: Path) -> None:
    (components / "differs.txt").write_text("tensorflow/include/any.h\n")
    same = "tensorflow/include/a.h,sha256=1,1\n"
    other = [
        "tensorflow/python/a.so,sha256={},1",
        "tensorflow/include/external/python_3_{}/Python.h,sha256=1,1",
        "tensorflow_cpu-2.21.0.dist-info/WHEEL,sha256={},1",
        "tensorflow/include/any.h,sha256={},1",
    ]
    records = {f"3.{minor}": same + "\n".join(other).format(*[minor] * 4) for minor in (11, 12)}
    sent: list[int] = []
    assert differences(tmp_path, records, sent) == []
    assert sum(sent) < 4 * (1 << 19), "the library in the wheel is not downloaded"


@pytest.mark.parametrize(
    ("content", "ranges", "message"),
    [
        (b"no archive", True, r"wheel 3\.11\.whl cannot be read for its METADATA: File is not a zip file"),
        (wheel("a,b,c\n"), True, "it lacks the file"),
        (wheel("a,b,c\n"), False, "sends no pieces of wheels"),
    ],
)
def test_an_index_that_answers_something_else(content: bytes, ranges: bool, message: str) -> None:
    with client({"3.11": content}, [], ranges) as index, pytest.raises(RosmlError, match=message):
        Index(Uv("uv"), index).metadata(Wheel("http://index/3.11.whl", len(content)))


def test_an_index_that_does_not_answer_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """A name that is not resolved for a moment must not end hundreds of requests."""
    content, failing = wheel("a,b,c\n"), list[Exception]([httpx.ConnectError("no name resolution for a moment")])
    monkeypatch.setattr(web, "WAIT", 0.0)
    with client({"3.11": content}, [], failing=failing) as index:
        assert Index(Uv("uv"), index).record(Wheel("http://index/3.11.whl", len(content))) == {"a": "b"}
