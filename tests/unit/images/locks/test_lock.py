"""Locks: what is resolved, how a resolution is read and split, and the command; with a uv that says what tests want."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL, changed, parse

from fakes.stubs import calls, executable
from fakes.uv import FILTER, RESOLVED, RESOLVES, UV, fake_uv
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import locks as script
from rosml.images.bake import targets
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import ImageSet
from rosml.images.locks import base_digests, lock, requests, resolve, shared_files
from rosml.images.locks.requests import Elsewhere, Request
from rosml.images.locks.resolve import Pin
from rosml.images.locks.shared_files import Difference
from rosml.images.locks.uv import Uv
from rosml.images.matrix import names
from rosml.images.matrix.model import PartEntry

PARTS = parse(SMALL).matrix.parts
ROOTS = {"torch": "torch==2.10.0", "tensorflow": "tensorflow[and-cuda]==2.20.0"}


def pin(name: str, *wanted_by: str, version: str = "1") -> Pin:
    return Pin(name, version, (f"sha256:{name}",), frozenset(wanted_by))


def request(**changes: object) -> Request:
    facts: dict[str, object] = {
        "stack": "cu1",
        "architecture": "amd64",
        "python": "3.12",
        "wheels": "x86_64-manylinux_2_28",
        "roots": ROOTS,
        "parts": PARTS,
        "numpy": "<2",
    }
    return Request(**{**facts, **changes})  # type: ignore[arg-type]


def dealt(
    pins: list[Pin],
    roots: Mapping[str, str] = ROOTS,
    parts: Sequence[PartEntry] = PARTS,
    beside: Mapping[str, Sequence[str]] | None = None,
) -> dict[str, list[str]]:
    return {part: [pin.name for pin in content] for part, content in lock.split(pins, roots, parts, beside).items()}


def of_cu1(image_set: ImageSet) -> Request:
    return next(item for item in requests.requests(image_set) if (item.stack, item.python) == ("cu1", "3.12"))


def locked(*pins: str) -> str:
    return "".join(f"{item} \\\n    --hash=sha256:{'0' * 64}\n" for item in pins)


# ---- Reading ---------------------------------------------------------------------------------------------------------


def test_parse() -> None:
    assert resolve.parse(RESOLVED)[:3] == [
        Pin("numpy", "1.26.4", ("sha256:aa", "sha256:bb"), frozenset({"tensorflow", "torch"})),
        Pin("nvidia-cublas-cu12", "12.8.4.1", ("sha256:cc",), frozenset({"torch"})),
        Pin("tensorflow", "2.20.0", ("sha256:dd",), frozenset()),
    ]
    assert [(pin.name, pin.version) for pin in resolve.parse(RESOLVED)][3:] == [("torch", "2.10.0+cu128")]
    assert resolve.parse("# nothing\n\n") == []


def test_names_that_begin_like_uvs_own_words() -> None:
    text = "a==1\n    # via viam-sdk\nb==1\n    # via\n    #   viam-sdk\n"
    assert [pin.wanted_by for pin in resolve.parse(text)] == [{"viam-sdk"}, {"viam-sdk"}]


def test_a_lock_reads_as_what_it_was_rendered_from() -> None:
    pins = [Pin("a", "1", ("sha256:x", "sha256:y"), frozenset()), Pin("b", "2", (), frozenset())]
    assert resolve.parse(lock.render(request(), "common", pins)) == pins


@pytest.mark.parametrize(
    ("requirement", "name"),
    [
        ("tensorflow[and-cuda]==2.20.0", "tensorflow"),
        ("Torch ; python_version > '3'", "torch"),
        ("tensorflow_cpu==2.20.0", "tensorflow-cpu"),
    ],
)
def test_package_name(requirement: str, name: str) -> None:
    assert lock_file.package_name(requirement) == name


# ---- Splitting -------------------------------------------------------------------------------------------------------


def test_every_package_is_in_its_part() -> None:
    pins = [pin("torch"), pin("tensorflow"), pin("numpy", "torch", "tensorflow"), pin("sympy", "torch")]
    pins += [pin("mpmath", "sympy"), pin("keras", "tensorflow"), pin("typing-extensions", "torch", "keras")]
    pins += [pin("nvidia-cublas-cu12", "torch"), pin("nvidia-cuda-nvcc-cu12", "tensorflow")]
    assert dealt(pins) == {
        "cuda": ["nvidia-cublas-cu12", "nvidia-cuda-nvcc-cu12"],
        "common": ["numpy", "typing-extensions"],
        "torch": ["mpmath", "sympy", "torch"],
        "tensorflow": ["keras", "tensorflow"],
        "tensorflow-cc": ["tensorflow"],
    }


@pytest.mark.parametrize(
    ("pins", "roots", "by_part"),
    [
        # On some architectures `tensorflow` only stands for another package. Its library is in two parts.
        (
            [pin("tensorflow"), pin("tensorflow-cpu-aws", "tensorflow"), pin("keras", "tensorflow")],
            {"tensorflow": "tensorflow==2"},
            {
                "tensorflow": ["keras", "tensorflow", "tensorflow-cpu-aws"],
                "tensorflow-cc": ["tensorflow", "tensorflow-cpu-aws"],
            },
        ),
        (
            [pin("tensorflow-cpu"), pin("keras", "tensorflow-cpu")],
            {"tensorflow": "tensorflow_cpu[x]==2"},
            {"tensorflow": ["keras", "tensorflow-cpu"], "tensorflow-cc": ["tensorflow-cpu"]},
        ),
        (
            [pin("torch"), pin("left", "torch"), pin("right", "torch"), pin("bottom", "left", "right")],
            ROOTS,
            {"torch": ["bottom", "left", "right", "torch"]},
        ),
        (
            [pin("torch"), pin("left", "torch"), pin("bottom", "left", "tensorflow"), pin("deep", "bottom")],
            ROOTS,
            {"torch": ["left", "torch"], "common": ["bottom", "deep"]},
        ),
        ([pin("torch", "b"), pin("a", "torch"), pin("b", "a")], ROOTS, {"torch": ["a", "b", "torch"]}),
        (
            [pin("torch"), pin("numpy", "torch"), pin("below-numpy", "numpy")],
            {"torch": "torch==2"},
            {"common": ["below-numpy", "numpy"], "torch": ["torch"]},
        ),
    ],
    ids=["stands for another", "extra and spelling", "diamond", "diamond of two", "cycle", "numpy"],
)
def test_which_part_has_a_package(pins: list[Pin], roots: dict[str, str], by_part: dict[str, list[str]]) -> None:
    assert dealt(pins, roots) == by_part


def test_a_name_goes_before_a_pattern_and_any_package_may_be_repeated() -> None:
    facts = {"name": "devel", "takes": ("nvidia-nvcc",), "repeats": ("nvidia-runtime",)}
    pins = [pin("torch"), pin("nvidia-runtime", "torch"), pin("nvidia-nvcc")]
    assert dealt(pins, {"torch": "torch==2"}, (*PARTS, PARTS[0].model_copy(update=facts))) == {
        "cuda": ["nvidia-runtime"],
        "devel": ["nvidia-nvcc", "nvidia-runtime"],
        "torch": ["torch"],
    }


def test_render() -> None:
    assert lock.render(request(), "torch", []).startswith("# Part 'torch' of stack cu1, Python 3.12, amd64.\n")
    assert lock.render(request(), "cuda", [pin("nvidia-x", "torch")]) == (
        "# Part 'cuda' of stack cu1, Python any, amd64.\n"
        "# Made by 'rosml locks' from matrix.yaml; do not edit.\n"
        "nvidia-x==1 \\\n    --hash=sha256:nvidia-x\n"
    )


# ---- What is resolved ------------------------------------------------------------------------------------------------


def test_one_request_for_each_stack_python_and_architecture(real: ImageSet) -> None:
    keys = [
        (item.stack, item.architecture, item.python)
        for item in requests.requests(real)
        if item.ros or not real.matrix.stacks[item.stack].apart or "tensorflow" in item.roots
    ]
    assert len(keys) == len(set(keys))
    needed = {
        (part.stack, architecture, part.python)
        for part in real.parts
        for architecture in part.architectures
        if part.python != "any"
    }
    needed |= {
        (item.distribution, architecture, item.python) for item in real.wheels for architecture in item.architectures
    }
    assert set(keys) == needed


def test_request() -> None:
    item = of_cu1(parse(changed('numpy: "<2"', 'numpy: "<2"\n    provides: {setuptools: 78.1.1}')))
    assert (item.architecture, item.wheels, item.numpy) == ("amd64", "x86_64-manylinux_2_28", "<2")
    assert item.roots == {"torch": "torch==2.10.0", "tensorflow": "tensorflow==2.20.0"}
    assert item.provided == {"setuptools": "78.1.1"}


WITH_COMPANY = changed(
    '["3.12", "3.14"], wheels: {cu1: [amd64], cpu: [arm64]}',
    '["3.12", "3.14"], wheels: {cu1: [amd64], cpu: [arm64]}, beside: {torchvision: 0.25.0}, adapted: {setuptools: ">=66"}',
)


def test_what_goes_with_a_release_is_resolved_and_dealt_out_with_it(tmp_path: Path) -> None:
    item = of_cu1(parse(WITH_COMPANY))
    assert item.beside == {"torch": ("torchvision==0.25.0",), "tensorflow": ()}
    assert item.overrides == ("setuptools>=66",)
    resolve.resolve(replace(item, provided={"setuptools": "68.1.2"}), Uv(fake_uv(tmp_path)))
    asked_for = (tmp_path / "seen-in.txt").read_text()
    assert asked_for.startswith("torch==2.10.0\ntensorflow==2.20.0\ntorchvision==0.25.0\nnumpy")
    assert " --override overrides.txt " in calls(tmp_path)[0]
    pins = [pin("torch"), pin("torchvision"), pin("pillow", "torchvision"), pin("numpy", "torchvision")]
    pins.append(pin("tensorflow"))
    assert dealt(pins, item.roots, PARTS, item.beside) == {
        "common": ["numpy"],
        "torch": ["pillow", "torch", "torchvision"],
        "tensorflow-cc": ["tensorflow"],
        "tensorflow": ["tensorflow"],
    }
    assert lock.render(item, "torch", pins).splitlines()[2] == "# adapted: torch setuptools>=66"
    assert "# adapted" not in lock.render(item, "tensorflow", pins)


TAKEN = changed(
    "  - {name: tensorflow, title",
    '  - {name: vision, any_python: true, takes: ["torchv*"], tested: false}\n  - {name: tensorflow, title',
    changed(
        "beside: {torchvision: 0.25.0}",
        "index: https://pypi.example.com/simple, beside: {torchvision: 0.25.0}",
        WITH_COMPANY.replace("[cuda, common, torch]", "[cuda, common, torch, vision]").replace(
            "      torch: {", "      vision: {unpacked: 1, compressed: 1}\n      torch: {"
        ),
    ),
)
"""What goes with torch is in a part of its own, and all of it comes from another index."""


@pytest.mark.parametrize(
    ("name", "version", "current"),
    [
        ("torch-cu1-py312", "torch==2.10.0", True),
        ("vision-cu1", "torchvision==0.25.0", True),
        ("vision-cu1", "torchvision==0.24.0", False),
        ("vision-cu1", "numpy==1.26.4", False),
    ],
)
def test_what_goes_with_a_release_may_be_in_another_part(name: str, version: str, current: bool) -> None:
    image_set = parse(TAKEN)
    part = image_set.part_by_name[name]
    head = names.lock_head(part.stack, "amd64", part.python, part.kind)
    adapted = "# adapted: torch setuptools>=66\n" if part.kind == "torch" else ""
    assert lock_file.current(f"{head}\n{adapted}{locked(version)}", part, image_set.matrix, "amd64") == current


def test_a_release_of_another_index(tmp_path: Path) -> None:
    """Locks ask it, and so do the builds of those parts whose packages it has. tests/unit/images/locks/test_pytorch_index.py calls uv."""
    image_set = parse(TAKEN)
    items = [item for item in requests.requests(image_set) if "torch" in item.roots]
    address = "https://pypi.example.com/simple"
    assert items and all(item.indexes == {"torch": address, "torchvision": address} for item in items)
    resolve.resolve(items[0], Uv(fake_uv(tmp_path)))
    assert " pyproject.toml in.txt " in calls(tmp_path)[0]
    assert "torch" not in (tmp_path / "seen-in.txt").read_text()
    all_targets = targets.of(image_set)
    parts = {part.kind for part in image_set.parts if all_targets[part.target].arguments.get("INDEX")}
    assert parts == {"torch", "vision"}


def test_nothing_goes_with_wheels_that_only_pytorchs_own_index_has() -> None:
    elsewhere = changed("beside:", "elsewhere: {cpu: {amd64: {}}}, requires: [filelock], beside:", WITH_COMPANY)
    beside = {item.stack: item.beside["torch"] for item in requests.requests(parse(elsewhere))}
    assert beside == {"cu1": ("torchvision==0.25.0",), "cpu": ()}


HEAD = "# Part 'torch' of stack cu1, Python 3.12, amd64.\n"
ADAPTED = "# adapted: torch setuptools>=66\n"


@pytest.mark.parametrize(
    ("lines", "versions", "current"),
    [
        (ADAPTED, "2.10.0 0.25.0", True),
        ("", "2.10.0 0.25.0", False),
        (ADAPTED.replace("66", "59"), "2.10.0 0.25.0", False),
        (ADAPTED + ADAPTED, "2.10.0 0.25.0", False),
        (ADAPTED, "2.10.0 0.24.0", False),
        (ADAPTED, "2.10.0", False),
    ],
)
def test_a_lock_without_what_goes_with_the_release_is_none(lines: str, versions: str, current: bool) -> None:
    image_set = parse(WITH_COMPANY)
    pins = [f"{name}=={version}" for name, version in zip(("torch", "torchvision"), versions.split(), strict=False)]
    part = image_set.part_by_name["torch-cu1-py312"]
    assert lock_file.current(HEAD + lines + locked(*pins), part, image_set.matrix, "amd64") == current


ADDS = ("takes: [nvidia-*]", 'takes: [nvidia-*], adds: {"12": [nvidia-a, "nvidia-b>=12.3"], "13": [nvidia-c]}')


def test_what_no_release_asks_for(tmp_path: Path) -> None:
    added = {item.stack: item.added for item in requests.requests(parse(changed(*ADDS)))}
    assert added == {"cu1": ("nvidia-a==12.8.*", "nvidia-b>=12.3"), "cpu": ()}
    resolve.resolve(request(added=added["cu1"]), Uv(fake_uv(tmp_path)))
    assert "nvidia-a==12.8.*\nnvidia-b>=12.3\n" in (tmp_path / "seen-in.txt").read_text()


@pytest.mark.parametrize(
    ("pins", "current"),
    [("a==12.8.9 b==12.9.1", True), ("a==12.9.1 b==12.9.1", False), ("b==12.9.1", False), ("a==12.8.9", False)],
)
def test_a_lock_without_what_the_part_adds_is_not_current(pins: str, current: bool) -> None:
    image_set = parse(changed(*ADDS))
    part = next(part for part in image_set.parts if part.kind == "cuda")
    lines = locked(*(f"nvidia-{item}" for item in pins.split()))
    text = f"# Part 'cuda' of stack cu1, Python any, amd64.\n{lines}"
    assert lock_file.current(text, part, image_set.matrix, "amd64") == current


def test_only_what_has_a_wheel_is_asked_for(small: ImageSet) -> None:
    roots = {(item.stack, item.architecture, item.python): item.roots for item in requests.requests(small)}
    assert roots["cu1", "amd64", "3.14"] == {"torch": "torch==2.10.0"}
    assert roots["cpu", "arm64", "3.14"] == {"torch": "torch==2.10.0"}


def test_committed_locks_are_what_the_matrix_asks_for(real: ImageSet) -> None:
    for part in real.parts:
        for architecture, path in zip(part.architectures, part.locks, strict=True):
            if not (ROOT / path).is_file():
                continue  # test_design.py knows which
            text = (ROOT / path).read_text()
            head = f"# Part '{part.kind}' of stack {part.stack}, Python {part.python}, {architecture}.\n"
            assert text.startswith(head)
            assert len(resolve.parse(text)) == text.count("==") <= text.count("--hash=sha256:")
            assert not re.search(r"https?://|--(extra-)?index-url", text)


# ---- uv --------------------------------------------------------------------------------------------------------------

# A package, and what is asked for by version, each with a hash.
PINNED = "(echo {}; grep == in.txt) | sed 's/$/ --hash=sha256:aa/; s/ /\\n    /' >out.txt"


def test_resolve(tmp_path: Path) -> None:
    item = request(constraints=("keras<4",), provided={"setuptools": "78.1.1", "packaging": "25.0"})
    assert resolve.resolve(item, Uv(fake_uv(tmp_path))) == resolve.parse(RESOLVED)
    (call,) = calls(tmp_path)
    for words in (
        f"uv pip compile --quiet --no-config --python {sys.executable} --only-binary :all: ",
        " --generate-hashes ",
        " --no-emit-index-url ",
        " --python-version 3.12 --python-platform x86_64-manylinux_2_28 ",
        " --constraint constraints.txt in.txt --output-file out.txt",
        " --no-emit-package packaging --no-emit-package setuptools",
    ):
        assert words in call
    seen = {name: (tmp_path / f"seen-{name}.txt").read_text() for name in ("in", "constraints")}
    assert seen == {
        "in": "torch==2.10.0\ntensorflow[and-cuda]==2.20.0\nnumpy<2\n",
        "constraints": "keras<4\npackaging==25.0\nsetuptools==78.1.1\n",
    }
    assert not (tmp_path / "seen-out.txt").exists()


def test_uv_is_killed(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match="uv was ended by signal 9 while it resolved stack cu1"):
        resolve.resolve(request(), Uv(executable(tmp_path / "uv", "kill -9 $$")))


def test_uv_is_not_started_any_more_after_ctrl_c(tmp_path: Path) -> None:
    uv = Uv(executable(tmp_path / "uv", f"touch {tmp_path}/started"))
    uv.end()
    with pytest.raises(RosmlError, match="interrupted"):
        uv(["pip"], tmp_path)
    assert not (tmp_path / "started").exists()


def test_earlier_locks_are_read(tmp_path: Path, small: ImageSet) -> None:
    for path, name in (("any/cuda", "nvidia-x"), ("3.12/common", "numpy"), ("3.12/torch", "torch"), ("3.9/x", "old")):
        file = tmp_path / f"locks/cu1/amd64/{path}.txt"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"{name}==1\n")
    uv = fake_uv(tmp_path, UV + 'cat out.txt >>"$here/earlier"; ' + FILTER + ' <"$here/resolved.txt" >out.txt')
    lock.lock(small, tmp_path, uv)
    earlier = (tmp_path / "earlier").read_text().split()  # of all requests, in any order
    assert {"nvidia-x==1", "numpy==1", "torch==1"} <= set(earlier)
    assert "old==1" not in earlier


def test_one_cuda_for_all_pythons(tmp_path: Path, small: ImageSet) -> None:
    locks = lock.lock(small, tmp_path, fake_uv(tmp_path)).texts
    assert "locks/cu1/amd64/any/cuda.txt" in locks
    assert {"locks/cu1/amd64/3.12/torch.txt", "locks/cu1/amd64/3.14/torch.txt"} <= locks.keys()
    assert not list(tmp_path.glob("locks/**/*.txt")), "it writes nothing"
    differing = UV + 'sed "s/12.8.4.1/$python/" "$here/resolved.txt" | {{ ' + FILTER + ";}} >out.txt"
    with pytest.raises(RosmlError, match=r"any/cuda\.txt: nvidia-\S+ would be 3\.1. and 3\.1.") as caught:
        lock.lock(small, tmp_path, fake_uv(tmp_path, differing))
    assert "constraints in matrix.yaml" in caught.value.remedy


@pytest.mark.parametrize(
    ("cuda", "package", "version", "complaint"),
    [
        ({"cuda": "12.8.90"}, "nvidia-cublas-cu12", "12.8.4.1", ""),
        ({"cuda": "12.8.90"}, "nvidia-cublas-cu13", "13.0", "nvidia-cublas-cu13 13.0"),
        ({"cuda": "13.0.96"}, "nvidia-cublas", "13.1", ""),
        ({"cuda": "13.0.96"}, "nvidia-cuda-runtime", "13.2.1", r"13.2.1 \(the stack says 13.0.96\)"),
        ({"cuda": "12.8.90", "nccl": "2.27.5"}, "nvidia-nccl-cu12", "2.28", r"\(the stack says 2.27.5\)"),
        ({}, "nvidia-cublas-cu12", "12.8.4.1", "nvidia-cublas-cu12"),
    ],
)
def test_another_cuda_than_promised(cuda: dict[str, str], package: str, version: str, complaint: str) -> None:
    pins = [pin("torch"), pin(package, "torch", version=version)]
    if not complaint:
        resolve.require_one_cuda(request(cuda=cuda), pins)
        return
    with pytest.raises(RosmlError, match=complaint) as caught:
        resolve.require_one_cuda(request(cuda=cuda), pins)
    assert "stack of its own" in caught.value.remedy


# ---- More than one index, and frameworks that contradict each other --------------------------------------------------

ELSEWHERE = {"torch": Elsewhere("torch==2.10.0+cpu", f"sha256:{'a' * 64}", ("jinja2", "Typing_Extensions>=4.10"))}
UNKNOWN = {"torch": Elsewhere("torch==2.10.0+cpu", "", ("jinja2",))}


def test_a_wheel_that_is_known_by_its_digest(tmp_path: Path) -> None:
    """Only what it requires is resolved, on the usual index; the wheel is added with its digest, above that."""
    resolved = "jinja2==3.1 \\\n    --hash=sha256:1\n    # via -r in.txt\nnumpy==1.26.4 \\\n    --hash=sha256:2\n"
    item = request(roots={"torch": "torch==2.10.0"}, elsewhere=ELSEWHERE)
    pins = resolve.resolve(item, Uv(fake_uv(tmp_path, resolved=resolved)))
    assert (tmp_path / "seen-in.txt").read_text() == "jinja2\nTyping_Extensions>=4.10\nnumpy<2\n"
    assert "--torch-backend" not in calls(tmp_path)[0]
    assert pins[-1] == Pin("torch", "2.10.0+cpu", (f"sha256:{'a' * 64}",), frozenset())
    assert dealt(pins, {"torch": "torch==2.10.0"}) == {"common": ["numpy"], "torch": ["jinja2", "torch"]}


def test_a_wheel_that_pytorchs_own_index_has_to_be_asked_for(tmp_path: Path) -> None:
    resolve.resolve(request(roots={"torch": "torch==2.10.0"}, elsewhere=UNKNOWN), Uv(fake_uv(tmp_path)))
    assert (tmp_path / "seen-in.txt").read_text() == "torch==2.10.0+cpu\nnumpy<2\n"
    assert " --torch-backend cpu" in calls(tmp_path)[0]


CPU_RESOLVED = """\
numpy==1.26.4 \\
    --hash=sha256:aa
    # via tensorflow
tensorflow==2.20.0 \\
    --hash=sha256:dd
    # via -r in.txt
tensorflow-cpu==2.20.0 \\
    --hash=sha256:dc
    # via -r in.txt
torch==2.10.0 \\
    --hash=sha256:ee
    # via -r in.txt
"""
ELSEWHERE_MATRIX = changed("cpu: [arm64]}}", "cpu: [arm64]}, elsewhere: {cpu: {amd64: {}}}, requires: [jinja2]}")
NO_ANSWER = (
    "error: Request failed after 3 retries in 10.5s\n  cause: Failed to fetch\n  cause: Name or service not known"
)
UNREACHABLE = f'{UV}case $(cat in.txt) in *+cpu*) echo "{NO_ANSWER}" >&2; exit 1 ;; esac; {FILTER}'
UNREACHABLE += ' <"$here/resolved.txt" >out.txt'


def test_the_rest_of_a_stack_is_locked_where_that_index_does_not_answer(tmp_path: Path) -> None:
    locks = lock.lock(parse(ELSEWHERE_MATRIX), tmp_path, fake_uv(tmp_path, UNREACHABLE, CPU_RESOLVED))
    assert "locks/cpu/arm64/3.12/torch.txt" in locks.texts
    assert "locks/cpu/amd64/3.12/tensorflow.txt" in locks.texts
    assert "locks/cpu/amd64/3.12/torch.txt" not in locks.texts
    reason = "PyTorch's own index does not answer (Name or service not known)"
    assert locks.left_out == {f"stack cpu, Python {python}, amd64 (torch)": reason for python in ("3.12", "3.14")}


def test_locks_stay_that_were_made_where_that_index_answers(tmp_path: Path) -> None:
    folder = tmp_path / "locks/cpu/amd64/3.12"
    folder.mkdir(parents=True)
    for name in ("common", "torch", "tensorflow"):
        (folder / f"{name}.txt").write_text(f"{name}==1\n")
    locks = lock.lock(parse(ELSEWHERE_MATRIX), tmp_path, fake_uv(tmp_path, UNREACHABLE, CPU_RESOLVED))
    kept = {Path(path).stem: text for path, text in locks.texts.items() if "cpu/amd64/3.12" in path}
    assert kept == {name: f"{name}==1\n" for name in ("common", "torch", "tensorflow")}


@pytest.mark.parametrize("upgrade", [False, True])
def test_a_lock_that_is_missing_beside_one_that_stays(tmp_path: Path, upgrade: bool) -> None:
    folder = tmp_path / "locks/cpu/amd64/3.12"
    folder.mkdir(parents=True)
    for name, package in {"common": "numpy", "torch": "torch"}.items():
        (folder / f"{name}.txt").write_text(f"{package}==1\n")
    uv = fake_uv(
        tmp_path, UNREACHABLE.replace("case", 'cp out.txt "$here/seen-out.txt" 2>/dev/null; case', 1), CPU_RESOLVED
    )
    locks = lock.lock(parse(ELSEWHERE_MATRIX), tmp_path, uv, upgrade, stacks=["cpu"])
    assert locks.texts["locks/cpu/amd64/3.12/torch.txt"] == "torch==1\n"
    assert "tensorflow-cpu==2.20.0" in locks.texts["locks/cpu/amd64/3.12/tensorflow.txt"]
    assert "stack cpu, Python 3.12, amd64 (torch)" in locks.left_out
    assert (tmp_path / "seen-out.txt").read_text() == "numpy==1\ntorch==1\n"


APART = changed(
    "  ml: {",
    "  tf: {repository: ros-tf, parts: [common, tensorflow-cc, tensorflow], accelerators: [cpu]}\n  ml: {",
    changed(
        "    packages: {tensorflow: {amd64", "    apart: they contradict each other\n    packages: {tensorflow: {amd64"
    ),
)


def test_frameworks_that_contradict_each_other_are_resolved_apart(tmp_path: Path) -> None:
    image_set = parse(APART)
    roots = [list(item.roots) for item in requests.requests(image_set) if (item.stack, item.python) == ("cpu", "3.12")]
    assert roots == [["tensorflow"], ["torch"], ["tensorflow"]]  # amd64 has no wheel of torch
    assert "alpha-core-ml-cpu" not in image_set.by_target
    texts = lock.lock(image_set, tmp_path, fake_uv(tmp_path, UV + PINNED.format("numpy==1.26.4"))).texts
    assert {f"locks/cpu/arm64/3.12/{part}.txt" for part in ("common", "torch", "tensorflow")} <= texts.keys()
    assert list(lock_file.versions(texts["locks/cpu/arm64/3.12/common.txt"])) == ["numpy"]


@pytest.mark.parametrize(
    ("pinned", "complaint"),
    [
        (PINNED.format("numpy==1.2$n"), r"1\.2. and 1\.2."),
        (PINNED.format("numpy==1.26").replace("sha256:aa", "sha256:a'$n'"), r"1\.26 and 1\.26"),
    ],
    ids=["version", "files of the same version"],
)
def test_what_they_share_must_agree(pinned: str, complaint: str, tmp_path: Path) -> None:
    uv = UV + "case $(cat in.txt) in *torch*) n=1 ;; *) n=2 ;; esac; " + pinned
    message = rf"common\.txt: numpy would be {complaint}, depending on the package that asks"
    with pytest.raises(RosmlError, match=message):
        lock.lock(parse(APART), tmp_path, fake_uv(tmp_path, uv))


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a matrix of one stack for one Python, and a uv on the PATH."""
    monkeypatch.setattr(script, "ROOT", tmp_path)
    monkeypatch.setattr(signal, "signal", lambda *_: None)  # a test run keeps its own
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    monkeypatch.setenv("ROSML_DOCKER_HUB", "0")  # nobody is asked for base images: tests/unit/images/locks/test_pins.py
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
    assert re.search(r"error: \d+ locks are outdated\nremedy: run 'rosml locks' and commit the result\n", done.err)
    assert {file: file.read_text() for file in checkout.glob("locks/**/*.txt")} == before


@pytest.mark.parametrize(
    ("words", "moved", "numpy", "message"),
    [
        ("--upgrade", 1, "1.26.4", "1 base image is outdated: 'rosml locks --upgrade', then 'rosml generate'"),
        ("--upgrade", 2, "1.26.5", "2 base images and 4 locks are outdated: 'rosml locks --upgrade', then"),
        ("--upgrade", 0, "1.26.5", "4 locks are outdated: 'rosml locks --upgrade' and commit the result"),
        ("--bases", 2, "1.26.4", "2 base images are outdated: 'rosml locks --bases', then 'rosml generate'"),
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
    assert caught.value.exit_code == 1
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


def test_all_is_written_although_nobody_reads_along(checkout: Path) -> None:
    program = "import sys; sys.path.insert(0, sys.argv[1]); from pathlib import Path; from rosml.cli import command; "
    program += "from rosml.cli.images import locks; locks.ROOT = Path(sys.argv[2]); "
    program += 'sys.exit(command.run(locks.main, arguments=["--matrix", sys.argv[2] + "/matrix.yaml"]))'
    words = ["bash", "-c", 'set -o pipefail; "$@" | true', "-", sys.executable, "-c", program]
    done = subprocess.run([*words, f"{ROOT}/src", checkout], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert run(checkout, "--check") == 0


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


def test_settings_of_uv_that_change_what_it_resolves_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UV_RESOLUTION", "lowest")
    monkeypatch.setenv("UV_INDEX_MARK", "kept")
    uv = fake_uv(tmp_path, 'env >"$(dirname "$0")/env"; ' + RESOLVES)
    resolve.resolve(request(), Uv(uv))
    env = (tmp_path / "env").read_text()
    assert "UV_RESOLUTION" not in env
    assert "UV_INDEX_MARK=kept" in env


def test_locks_that_nothing_needs(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run(checkout)
    (checkout / "locks/old.txt").write_text("")
    assert run(checkout) == 0
    assert "locks/old.txt: belongs to nothing in matrix.yaml; delete it\n" in capsys.readouterr().out
    assert (checkout / "locks/old.txt").exists()


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
    assert "error: 'uv' is not installed\nremedy: run 'rosml setup'" in capsys.readouterr().err


def test_command_when_uv_fails(checkout: Path, capsys: pytest.CaptureFixture[str]) -> None:
    fake_uv(checkout, UV + "echo 'no answer from the index' >&2; exit 2")
    assert run(checkout) == 1
    done = capsys.readouterr().err
    assert "does not resolve:\nno answer from the index\n" in done
    assert "remedy: relax the stack's versions" in done
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
