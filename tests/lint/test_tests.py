"""Tests hold what the project does, and not how: no test imports from another one, and none reaches for private names or
overrides private methods. So code can move without any change of what is asserted. And the product stands on neither tests
nor measurements."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PRODUCT = ("rosml", "scripts", "tools", "components/part")
TESTS = sorted(file.relative_to(ROOT).as_posix() for file in (ROOT / "tests").rglob("*.py"))

PUBLIC = {"_replace", "_asdict", "_fields", "_make"}
"""What Python's named tuples have under such names for everybody."""


def private(name: str) -> bool:
    """Whether a name is its owner's alone."""
    return name.startswith("_") and not name.endswith("__") and name != "_" and name not in PUBLIC


def last(node: ast.expr) -> str:
    """`Base` of `Base`, `module.Base` and `Base[int]`; empty for anything else."""
    if isinstance(node, ast.Subscript):
        return last(node.value)
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def classes(trees: Iterable[ast.AST]) -> dict[str, list[ast.ClassDef]]:
    """Classes by their names, which more than one may have."""
    found: dict[str, list[ast.ClassDef]] = defaultdict(list)
    for tree in trees:
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                found[node.name].append(node)
    return found


def own(node: ast.ClassDef) -> set[str]:
    """Private names that a class gives to itself or to its objects."""
    names = {item.name for item in ast.walk(node) if isinstance(item, ast.FunctionDef | ast.AsyncFunctionDef)}
    names |= {
        item.target.id for item in node.body if isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name)
    }
    for item in ast.walk(node):
        if isinstance(item, ast.Attribute) and isinstance(item.ctx, ast.Store) and last(item.value) == "self":
            names.add(item.attr)
    return {name for name in names if private(name)}


def inherited(
    node: ast.ClassDef,
    product: Mapping[str, list[ast.ClassDef]],
    helpers: Mapping[str, list[ast.ClassDef]],
    seen: frozenset[str] = frozenset(),
) -> set[str]:
    """Private names that a class has from classes of the product, be it through those of helpers."""
    names: set[str] = set()
    for base in {last(base) for base in node.bases} - seen:
        for found in product.get(base, []):
            names |= own(found)
        for found in [*product.get(base, []), *helpers.get(base, [])]:
            names |= inherited(found, product, helpers, seen | {base})
    return names


def violations(
    file: str, tree: ast.AST, product: Mapping[str, list[ast.ClassDef]], helpers: Mapping[str, list[ast.ClassDef]]
) -> Iterator[str]:
    """What a test or helper does that it should not do, a line each: `file: what`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            module = getattr(node, "module", None) or ""
            names = [module, *(f"{module}.{alias.name}".lstrip(".") for alias in node.names)]
            yield from (f"{file}: imports from {name}" for name in names if is_test(name))
            yield from (f"{file}: imports {module}.{alias.name}" for alias in node.names if private(alias.name))
        elif isinstance(node, ast.Attribute) and private(node.attr) and last(node.value) not in ("self", "cls"):
            yield f"{file}: uses {ast.unparse(node)}"
        elif isinstance(node, ast.Call) and last(node.func) in ("getattr", "setattr", "delattr"):
            names = [
                word.value for word in node.args[:2] if isinstance(word, ast.Constant) and isinstance(word.value, str)
            ]
            yield from (f"{file}: replaces {name}" for name in names if private(name.rpartition(".")[2]))
        elif isinstance(node, ast.ClassDef):
            theirs = inherited(node, product, helpers)
            touched = own(node) | {
                item.attr for item in ast.walk(node) if isinstance(item, ast.Attribute) and last(item.value) == "self"
            }
            yield from (f"{file}: class {node.name} takes {name} from its base" for name in sorted(touched & theirs))


def is_test(module: str) -> bool:
    """Whether a module is a file of tests."""
    path = Path(*module.split("."))
    there = any((ROOT / folder / path).with_suffix(".py").is_file() for folder in (".", "tests/unit"))
    return path.name.startswith("test_") and there


@pytest.fixture(scope="module")
def product() -> dict[str, list[ast.ClassDef]]:
    """The product's classes."""
    files = (file for folder in PRODUCT for file in (ROOT / folder).rglob("*.py"))
    return classes(ast.parse(file.read_text(encoding="utf-8")) for file in files)


def test_the_product_does_not_stand_on_what_serves_it() -> None:
    """Neither on what measures it nor on its tests."""
    wrong = []
    for file in (file for folder in PRODUCT for file in sorted((ROOT / folder).rglob("*.py"))):
        nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
        names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
        names |= {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}
        wrong += [f"{file.name}: {name}" for name in sorted(names) if name.partition(".")[0] in ("bench", "tests")]
    assert wrong == []


def test_tests_stand_on_public_names_and_on_no_other_test(product: dict[str, list[ast.ClassDef]]) -> None:
    trees = {file: ast.parse((ROOT / file).read_text(encoding="utf-8")) for file in TESTS}
    helpers = classes(trees.values())
    found = [line for file, tree in trees.items() for line in violations(file, tree, product, helpers)]
    assert sorted(set(found)) == []


@pytest.mark.parametrize(
    ("code", "what"),
    [
        ("from test_services import load", "imports from test_services"),
        ("from tests.lint.test_lint import check", "imports from tests.lint.test_lint"),
        ("import test_services", "imports from test_services"),
        ("from rosml.build.publisher import _blobs", "imports rosml.build.publisher._blobs"),
        ("lock._one_cuda(request)", "uses lock._one_cuda"),
        ("monkeypatch.setattr(builder, '_SECONDS', 1)", "replaces _SECONDS"),
        ("monkeypatch.setattr('rosml.machine.buildx._SECONDS', 1)", "replaces rosml.machine.buildx._SECONDS"),
        ("class Mine(Run):\n def _build(self): pass", "class Mine takes _build from its base"),
        ("class Mine(Run):\n def go(self): self._build()", "class Mine takes _build from its base"),
        ("class Mine(pipeline.Run):\n def go(self): return self._pushed", "class Mine takes _pushed from its base"),
    ],
)
def test_what_a_test_should_not_do_is_found(code: str, what: str) -> None:
    product = classes([ast.parse("class Base:\n def _build(self): self._pushed = 1\nclass Run(Base): pass")])
    assert f"x.py: {what}" in list(violations("x.py", ast.parse(code), product, {}))


@pytest.mark.parametrize(
    "code",
    [
        "from stubs import load",
        "from tests import map as test_map",
        "usage._replace(free=1)",
        "class Mine(Run):\n def _own(self): return self._own",
        "class Mine(Maker):\n def build_part(self): self._own = 1",
    ],
)
def test_what_a_test_may_do(code: str) -> None:
    product = classes([ast.parse("class Run:\n def _build(self): pass\nclass Maker: pass")])
    assert list(violations("x.py", ast.parse(code), product, {})) == []
