"""Locks: what is resolved, and what becomes of earlier locks, with a local replacement for uv."""

from __future__ import annotations

import re
import sys
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import ROOT, changed, parse

from fakes.locks import PARTS, dealt, pin, request
from fakes.stubs import calls, executable
from fakes.uv import FILTER, RESOLVED, RESOLVES, UV, fake_uv
from rosml.base.errors import RosmlError
from rosml.images.bake import targets
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import ImageSet
from rosml.images.locks import lock, requests, resolve
from rosml.images.locks.requests import Elsewhere, Request
from rosml.images.locks.resolve import Pin
from rosml.images.locks.uv import Uv
from rosml.images.matrix import names


def of_cu1(image_set: ImageSet) -> Request:
    return next(item for item in requests.requests(image_set) if (item.stack, item.python) == ("cu1", "3.12"))


# ---- What is resolved ------------------------------------------------------------------------------------------------


def test_one_request_for_each_stack_python_and_architecture(real: ImageSet) -> None:
    keys = [
        (item.stack, item.architecture, item.python)
        for item in requests.requests(real)
        if item.ros or not real.matrix.stacks[item.stack].apart or "tensorflow" in item.roots
    ]
    parts = [part for part in real.parts_of_stacks if part.python != "any"]
    needed = {(part.stack, architecture, part.python) for part in parts for architecture in part.architectures}
    needed |= {
        (item.distribution, architecture, item.python) for item in real.wheels for architecture in item.architectures
    }
    assert len(keys) == len(set(keys)) and set(keys) == needed


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
    requirements = (tmp_path / "seen-in.txt").read_text()
    assert requirements.startswith("torch==2.10.0\ntensorflow==2.20.0\ntorchvision==0.25.0\nnumpy")
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


ADDS = changed("takes: [nvidia-*]", 'takes: [nvidia-*], adds: {"12": [nvidia-a, "nvidia-b>=12.3"], "13": [nvidia-c]}')
ADAPTED = "# adapted: torch setuptools>=66\n"


@pytest.mark.parametrize(
    ("matrix", "name", "lines", "pins", "current"),
    [
        (WITH_COMPANY, "torch-cu1-py312", ADAPTED, "torch==2.10.0 torchvision==0.25.0", True),
        (WITH_COMPANY, "torch-cu1-py312", "", "torch==2.10.0 torchvision==0.25.0", False),
        (WITH_COMPANY, "torch-cu1-py312", ADAPTED.replace("66", "59"), "torch==2.10.0 torchvision==0.25.0", False),
        (WITH_COMPANY, "torch-cu1-py312", ADAPTED + ADAPTED, "torch==2.10.0 torchvision==0.25.0", False),
        (WITH_COMPANY, "torch-cu1-py312", ADAPTED, "torch==2.10.0 torchvision==0.24.0", False),
        (WITH_COMPANY, "torch-cu1-py312", ADAPTED, "torch==2.10.0", False),
        (TAKEN, "torch-cu1-py312", ADAPTED, "torch==2.10.0", True),
        (TAKEN, "vision-cu1", "", "torchvision==0.25.0", True),
        (TAKEN, "vision-cu1", "", "torchvision==0.24.0", False),
        (TAKEN, "vision-cu1", "", "numpy==1.26.4", False),
        (ADDS, "cuda-cu1", "", "nvidia-a==12.8.9 nvidia-b==12.9.1", True),
        (ADDS, "cuda-cu1", "", "nvidia-a==12.9.1 nvidia-b==12.9.1", False),
        (ADDS, "cuda-cu1", "", "nvidia-b==12.9.1", False),
        (ADDS, "cuda-cu1", "", "nvidia-a==12.8.9", False),
    ],
)
def test_a_lock_has_what_goes_with_a_release_and_what_its_part_adds(
    matrix: str, name: str, lines: str, pins: str, current: bool
) -> None:
    image_set = parse(matrix)
    part = image_set.part_by_name[name]
    head = names.lock_head(part.stack, "amd64", part.python, part.kind)
    hashed = "".join(f"{pin} \\\n    --hash=sha256:{'0' * 64}\n" for pin in pins.split())
    assert lock_file.current(f"{head}\n{lines}{hashed}", part, image_set.matrix, "amd64") == current


def test_what_no_release_asks_for(tmp_path: Path) -> None:
    added = {item.stack: item.added for item in requests.requests(parse(ADDS))}
    assert added == {"cu1": ("nvidia-a==12.8.*", "nvidia-b>=12.3"), "cpu": ()}
    resolve.resolve(request(added=added["cu1"]), Uv(fake_uv(tmp_path)))
    assert "nvidia-a==12.8.*\nnvidia-b>=12.3\n" in (tmp_path / "seen-in.txt").read_text()


def test_only_what_has_a_wheel_is_asked_for(small: ImageSet) -> None:
    roots = {(item.stack, item.architecture, item.python): item.roots for item in requests.requests(small)}
    assert roots["cu1", "amd64", "3.14"] == {"torch": "torch==2.10.0"}
    assert roots["cpu", "arm64", "3.14"] == {"torch": "torch==2.10.0"}


def test_committed_locks_are_what_the_matrix_asks_for(real: ImageSet) -> None:
    for part in real.parts_of_stacks:
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
        " --constraint constraints.txt in.txt ",
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


def test_settings_of_uv_that_change_what_it_resolves_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UV_RESOLUTION", "lowest")
    monkeypatch.setenv("UV_INDEX_MARK", "kept")
    uv = fake_uv(tmp_path, 'env >"$(dirname "$0")/env"; ' + RESOLVES)
    resolve.resolve(request(), Uv(uv))
    env = (tmp_path / "env").read_text()
    assert "UV_RESOLUTION" not in env
    assert "UV_INDEX_MARK=kept" in env


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
    with pytest.raises(RosmlError, match=complaint) if complaint else nullcontext():
        resolve.require_one_cuda(request(cuda=cuda), pins)


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


def put_locks(root: Path, **packages: str) -> None:
    """Writes earlier locks of the stack without CUDA, each with a package of version 1."""
    folder = root / "locks/cpu/amd64/3.12"
    folder.mkdir(parents=True)
    for name, package in packages.items():
        (folder / f"{name}.txt").write_text(f"{package}==1\n")


def test_locks_stay_that_were_made_where_that_index_answers(tmp_path: Path) -> None:
    put_locks(tmp_path, common="common", torch="torch", tensorflow="tensorflow")
    locks = lock.lock(parse(ELSEWHERE_MATRIX), tmp_path, fake_uv(tmp_path, UNREACHABLE, CPU_RESOLVED))
    kept = {Path(path).stem: text for path, text in locks.texts.items() if "cpu/amd64/3.12" in path}
    assert kept == {name: f"{name}==1\n" for name in ("common", "torch", "tensorflow")}


@pytest.mark.parametrize("upgrade", [False, True])
def test_a_lock_that_is_missing_beside_one_that_stays(tmp_path: Path, upgrade: bool) -> None:
    put_locks(tmp_path, common="numpy", torch="torch")
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
