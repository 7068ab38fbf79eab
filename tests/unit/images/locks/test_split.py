"""How a resolution is read, and split into parts."""

from __future__ import annotations

import pytest

from fakes.locks import PARTS, ROOTS, dealt, pin, request
from fakes.uv import RESOLVED
from rosml.images.locks import lock, resolve
from rosml.images.locks.resolve import Pin

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


TF = {"tensorflow": "tensorflow==2"}


@pytest.mark.parametrize(
    ("graph", "roots", "parts"),
    [
        (
            # On some architectures `tensorflow` only stands for another package. Its library is in two parts.
            "tensorflow tensorflow-cpu-aws<tensorflow",
            TF,
            "tensorflow-cc: tensorflow tensorflow-cpu-aws, tensorflow: tensorflow tensorflow-cpu-aws",
        ),
        (
            "tensorflow-cpu keras<tensorflow-cpu",
            {"tensorflow": "tensorflow_cpu[x]==2"},
            "tensorflow: keras tensorflow-cpu, tensorflow-cc: tensorflow-cpu",
        ),
        ("torch left<torch right<torch bottom<left,right", ROOTS, "torch: bottom left right torch"),
        ("torch left<torch bottom<left,tensorflow deep<bottom", ROOTS, "torch: left torch, common: bottom deep"),
        ("torch<b a<torch b<a", ROOTS, "torch: a b torch"),
        ("torch numpy<torch below<numpy", {"torch": "torch==2"}, "common: below numpy, torch: torch"),
    ],
)
def test_which_part_has_a_package(graph: str, roots: dict[str, str], parts: str) -> None:
    """`a<b,c` is a package that b and c need."""
    edges = [word.partition("<") for word in graph.split()]
    pins = [pin(name, *filter(None, needed_by.split(","))) for name, _, needed_by in edges]
    by_part = {name: names.split() for name, _, names in (part.partition(": ") for part in parts.split(", "))}
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
    assert lock.render(request(), "cuda", [pin("nvidia-x", "torch")]) == (
        "# Part 'cuda' of stack cu1, Python any, amd64.\n"
        "# Made by 'rosml locks' from matrix.yaml; do not edit.\n"
        "nvidia-x==1 \\\n    --hash=sha256:nvidia-x\n"
    )
