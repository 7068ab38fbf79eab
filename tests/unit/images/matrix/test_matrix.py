"""The model: properties that hold for any input, and its agreement with the schema that editors use."""

from __future__ import annotations

import copy
import datetime
import json
import re
import resource
import sys
import tempfile
import tracemalloc
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from conftest import ROOT, SMALL, changed, parse
from hypothesis import given, settings
from hypothesis import strategies as st

from fakes.mutations import LOADER
from fakes.profiles import PROFILE, PROFILE_NAME
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.images.bake import bake_file
from rosml.images.image_set import load
from rosml.images.image_set import model as sets
from rosml.images.matrix import model, schema, source
from tests import synthetic

Strategy = st.SearchStrategy[Any]

REAL = (ROOT / "matrix.yaml").read_text(encoding="utf-8")
DATA = {text: yaml.load(text, Loader=LOADER) for text in (SMALL, REAL)}
"""Both matrices as data, which nobody changes."""

pytestmark = [pytest.mark.timeout(3600)] if PROFILE_NAME == "thorough" else list[pytest.MarkDecorator]()

MEGABYTES, MEGABYTES_FOR_IMAGE = 100, 0.02
"""What it may add to the most memory that this process ever had."""


def outcome(content: bytes) -> sets.ImageSet | None:
    """The image set, read as the command reads it, from a file; None if the matrix is refused. In bounded memory. Any other exception
    is a bug."""
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    image_set = None
    try:
        with tempfile.NamedTemporaryFile() as file:
            file.write(content)
            file.flush()
            image_set = load.load(Path(file.name))
    except RosmlError as error:
        assert error.exit_code == 2 and error.message and "Traceback" not in error.message
        if isinstance(error, InputError):
            lines = content.count(b"\n") + content.count(b"\r") + 2
            assert all(1 <= problem.line <= lines and problem.column >= 1 for problem in error.problems)
    if image_set:
        bake_file.render(image_set)
    megabytes = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory) / 1024
    assert megabytes < MEGABYTES + MEGABYTES_FOR_IMAGE * (len(image_set.images) if image_set else 0)
    return image_set


def on_a_matrix(places: Callable[[str], Strategy]) -> Strategy:
    """A matrix's text, the real one in one of five examples, with what a strategy draws for it."""
    return st.sampled_from([SMALL] * 4 + [REAL]).flatmap(lambda text: st.tuples(st.just(text), places(text)))


@PROFILE
@given(on_a_matrix(lambda text: st.integers(0, len(text) - 1)), st.integers(0, 40), st.text(max_size=12))
def test_any_edit_of_the_text(place: tuple[str, int], length: int, new: str) -> None:
    text, start = place
    text = text[:start] + new + text[start + length :]
    outcome(text.encode("utf-8", errors="surrogatepass"))


@PROFILE
@given(st.binary(max_size=200))
def test_any_bytes(content: bytes) -> None:
    outcome(content)


WORDS = st.sampled_from(
    ["core", "cu128", "torch", "amd64", "3.11", "", "x" * 300, "${REGISTRY}", "%{x}", '"', "\n", "ü"]
)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | WORDS | st.dates(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(WORDS, inner, max_size=3),
    max_leaves=6,
)


def paths(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Every path in nested data."""
    all_paths = [path]
    for key, value in data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ():
        all_paths += paths(value, (*path, key))
    return all_paths


PATHS = {text: st.sampled_from(paths(data)[1:]) for text, data in DATA.items()}
KINDS_OF_EDIT = st.sampled_from(["replace", "remove", "rename"])


def edit(data: Any, path: tuple[Any, ...], kind: str, value: Any) -> None:
    """Changes data at a path. An earlier edit may have taken it away."""
    try:
        for step in path[:-1]:
            data = data[step]
        before = data[path[-1]]
    except (KeyError, IndexError, TypeError):
        return
    if kind == "replace":
        data[path[-1]] = value
    elif kind == "add" and isinstance(before, dict):
        before["surplus"] = value
    elif isinstance(data, dict):
        del data[path[-1]]
        if kind == "rename":
            data[str(value)] = before


@PROFILE
@given(on_a_matrix(lambda text: st.lists(st.tuples(PATHS[text], KINDS_OF_EDIT, VALUES), max_size=3)))
def test_any_edit_of_the_data(edits: tuple[str, list[tuple[tuple[Any, ...], str, Any]]]) -> None:
    data = copy.deepcopy(DATA[edits[0]])
    for path, kind, value in edits[1]:
        edit(data, path, kind, value)
    outcome(yaml.safe_dump(data, allow_unicode=True).encode("utf-8", errors="surrogatepass"))


# ---- YAML at its worst, within a matrix ------------------------------------------------------------------------------


def spans(node: yaml.Node | None) -> Iterator[tuple[int, int]]:
    """Where each key and each value stands in the text."""
    assert node
    yield node.start_mark.index, node.end_mark.index
    for inner in node.value if isinstance(node, yaml.CollectionNode) else ():
        for item in inner if isinstance(inner, tuple) else (inner,):
            yield from spans(item)


SPANS = {text: sorted(set(spans(yaml.compose(text)))) for text in (SMALL, REAL)}
MANY = st.sampled_from([1, 2, 17, 100])
NAMES = st.sampled_from([REAL[start:end] for start, end in SPANS[REAL] if end - start < 40])


HOSTILE = st.one_of(
    NAMES,
    st.builds("{}".format, st.integers()),
    st.builds(
        lambda n, text: text * n, MANY, st.sampled_from(["9", "1:", "0x", ".", "a", "a-", "ros ", "{", "'", "- "])
    ),
    st.builds(lambda n, item: f"[{','.join([item] * n)}]", MANY, NAMES | st.sampled_from(["1", "a", "[]", "{}"])),
    st.builds(lambda n: f"[{','.join(f'x{i}' for i in range(n))}]", MANY),
    st.builds(lambda n, item: "{" + ",".join(f"x{i}: {item}" for i in range(n)) + "}", MANY, NAMES),
    st.builds(lambda n, item: "{" + ",".join([f"x: {item}"] * n) + "}", MANY, NAMES),
    st.builds(lambda n: "[" * n + "]" * n, MANY),
    st.builds(lambda n: "{a: " * n + "}" * n, MANY),
    st.sampled_from(["[&a0 lol, &a1 [*a0, *a0], &a2 [*a1, *a1]]"]),
    st.sampled_from(
        [
            *("&a [*a]", "*a", "&a x", "{<<: *a}", "{<<: {a: 1}}", "{<<: [*a, *b]}", "{? [a]: b}", "{? {a: b}: c}"),
            *("!!python/object/apply:os.system [x]", "!!binary x", "!!set {a}", "!!omap [a: 1]", "! x", "!<x> y"),
            *("1e999", "-.inf", ".nan", "0o17", "1_000", "2028-02-30", "0001-01-01", "2028-06-30T25:61:00Z", "~", "="),
            *("|\n  x", ">-\n  x", "\n---\n", "\n...\n", "%YAML 9.9\n", "\t", "\u2028", "\ufeff", "#", "@", "`", "?"),
        ]
    ),
)


@PROFILE
@given(
    on_a_matrix(
        lambda text: st.lists(
            st.tuples(st.sampled_from(SPANS[text]), HOSTILE, st.sampled_from(["replace", "before"])), max_size=3
        )
    )
)
def test_any_hostile_yaml(edits: tuple[str, list[tuple[tuple[int, int], str, str]]]) -> None:
    text = edits[0]
    for (start, end), new, kind in sorted(edits[1], reverse=True):  # from the end, so that places stay
        text = text[:start] + new + text[end if kind == "replace" else start :]
    outcome(text.encode())


@PROFILE
@given(
    on_a_matrix(
        lambda text: st.lists(
            st.tuples(*[st.integers(0, text.count("\n") - 1)] * 2, st.integers(1, 5)), min_size=1, max_size=3
        )
    )
)
def test_any_lines_twice(copies: tuple[str, list[tuple[int, int, int]]]) -> None:
    lines = copies[0].splitlines(keepends=True)
    for start, to, count in copies[1]:
        lines[to:to] = lines[start : start + count]
    outcome("".join(lines).encode())


SECTIONS = ("architectures", "operating_systems", "components", "frameworks", "stacks", "distributions")
FORECASTS = {
    "components": ("  components:\n", "{unpacked: 1, compressed: 1}"),
    "stacks": ("  parts:\n", json.dumps(next(iter(DATA[REAL]["disk"]["parts"].values())))),
}
ROWS = st.lists(st.tuples(st.sampled_from(SECTIONS), st.integers(0, 9), MANY, st.booleans()), max_size=2)


@PROFILE
@given(on_a_matrix(lambda text: ROWS))
def test_any_number_of_rows(edits: tuple[str, list[tuple[str, int, int, bool]]]) -> None:
    """Rows like those that are there, under new names or all under the same."""
    text = edits[0]
    data = DATA[text]
    for section, which, count, same in edits[1]:
        row = list(data[section].values())[which % len(data[section])]
        shown = yaml.safe_dump(row, default_flow_style=True, width=sys.maxsize).strip().removesuffix("\n...")
        added = [f"{section[0]}{0 if same else n}" for n in range(count)]
        head = re.findall(rf"^{section}:.*\n", text, re.MULTILINE)[0]
        text = text.replace(head, head + "".join(f"  {name}: {shown}\n" for name in added))
        if section in FORECASTS:
            head, forecast = FORECASTS[section]
            text = text.replace(head, head + "".join(f"    {name}: {forecast}\n" for name in dict.fromkeys(added)))
    outcome(text.encode())


@PROFILE
@given(st.lists(st.integers(-1, 40), min_size=1, max_size=40), st.booleans())
def test_any_components_on_one_another(below: list[int], orderly: bool) -> None:
    """-1 builds on nothing, a number without a component is unknown; chains, trees, cycles. In an orderly file each
    builds on one of the three before it.
    """
    if orderly:
        below = [max(-1, n - 1 - link % 3) if link >= 0 else -1 for n, link in enumerate(below)]
    text = SMALL.replace("components: [core", f"components: [{', '.join(f'c{n}' for n in range(len(below)))}, core")
    rows = "".join(f"  c{n}: {{{f'builds_on: c{link}' if link >= 0 else ''}}}\n" for n, link in enumerate(below))
    text = changed("\ncomponents:\n", f"\ncomponents:\n{rows}", text)
    sizes = "".join(f"    c{n}: {{unpacked: 1, compressed: 1}}\n" for n in range(len(below)))
    lengths = [len(list(links(below, start))) for start in range(len(below))]
    possible = max(lengths) < 100 and max(below) < len(below)
    image_set = outcome(changed("  components:\n    core", f"  components:\n{sizes}    core", text).encode())
    assert (image_set is not None) == possible
    for start, length in enumerate(lengths) if image_set else ():
        assert image_set
        image = image_set.by_target[f"alpha-c{start}"]
        assert len(image.tests) + len(image.shared) == 7 + length


def links(below: list[int], start: int) -> Iterator[int]:
    """What stands on one another below a component; far too long where there is a cycle."""
    for _ in range(100):
        yield start
        if not 0 <= (start := below[start]) < len(below):
            return


def test_memory() -> None:
    """What Python itself allocates, whatever this process needed before; libyaml's nodes are Python's as well."""
    content = synthetic.matrix(2_000).encode()
    tracemalloc.start()
    try:
        outcome(content)
        peak = tracemalloc.get_traced_memory()[1] / 1_000_000
    finally:
        tracemalloc.stop()
    assert peak < 100


# ---- Schema and model ------------------------------------------------------------------------------------------------


SCHEMA = json.loads(schema.render())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def accepts(data: Any) -> bool:
    return bool(VALIDATOR.is_valid(as_editors_see_it(data)))


def as_editors_see_it(data: Any) -> Any:
    """Dates are text in JSON; tuples are lists."""
    if isinstance(data, dict):
        return {key: as_editors_see_it(value) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [as_editors_see_it(value) for value in data]
    return data.isoformat() if isinstance(data, datetime.date) else data


def model_accepts(data: Any) -> bool:
    try:
        model.Matrix.model_validate(data)
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("text", [REAL, SMALL])
def test_schema_accepts_what_the_model_accepts(text: str) -> None:
    assert accepts(source.parse(text.encode()).data)


def tupled(data: Any) -> Any:
    """Lists as the reader gives them to the model."""
    if isinstance(data, dict):
        return {key: tupled(value) for key, value in data.items()}
    return tuple(tupled(value) for value in data) if isinstance(data, list) else data


SIMPLE = st.none() | st.booleans() | st.integers(-2, 2) | st.sampled_from(["core", "3.11", "a b", "x" * 200, ""])


@settings(PROFILE, max_examples=PROFILE.max_examples * 3 // 2)
@given(on_a_matrix(PATHS.__getitem__), st.sampled_from(["replace", "remove", "rename", "add"]), SIMPLE)
def test_schema_and_model_judge_alike(place: tuple[str, tuple[Any, ...]], kind: str, value: Any) -> None:
    data = copy.deepcopy(DATA[place[0]])
    value_before = data
    for step in place[1]:
        value_before = value_before[step]
    if not isinstance(value_before, datetime.date):  # text in the schema, a day in the model
        edit(data, place[1], kind, value)
        assert model_accepts(tupled(data)) == accepts(data)


def test_every_key_is_described() -> None:
    described = [SCHEMA, *SCHEMA["$defs"].values()]
    sections = set(SCHEMA["properties"])
    bare = [
        key
        for node in described
        for key, value in node.get("properties", {}).items()
        if "description" not in value and key not in sections
    ]
    assert bare == []


# ---- Facts -----------------------------------------------------------------------------------------------------------


def test_requirement(small: sets.ImageSet) -> None:
    stack = small.matrix.stacks["cpu"]
    assert stack.requirement("tensorflow", "amd64") == "tensorflow-cpu==2.20.0"
    assert stack.requirement("tensorflow", "arm64") == "tensorflow==2.20.0"
    assert stack.requirement("torch", "amd64") == "torch==2.10.0"


def test_a_new_distribution_fits_in_ten_lines() -> None:
    row = """\
  made-up:
    os: ubuntu-24.04
    ros: 2
    ros_distro: madeup
    packages: ros-{ros_distro}-{metapackage}
    components: [core, base, desktop]
    default_stack: cu1
    eol: 2031-05-31
    lts: true
    apt: {channel: live}
"""
    assert row.count("\n") <= 10
    image_set = parse(changed("distributions:\n", f"distributions:\n{row}"))
    assert image_set.image("made-up-base").packages == "ros-madeup-ros-base"
    assert "ros-torch:latest" in image_set.image("made-up-base-torch-cu1").tags
