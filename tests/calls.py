"""What a test runs, as far as its source tells: its own text, and that of functions, fixtures, classes and constants that it
names, in its file, in the conftest.py beside it, and in other modules of the tests."""

from __future__ import annotations

import ast
import re
import shlex
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

SCRIPTS = {
    "catalogue": "catalogue.py",
    "generate": "generate_bake.py",
    "join": "join.py",
    "locks": "lock.py",
    "main": "rosml",
    "publish": "publish.py",
}
"""Which script calls a module of commands."""


@cache
def _tree(file: Path) -> tuple[str, ast.Module]:
    text = file.read_text(encoding="utf-8")
    return text, ast.parse(text)


def _bound(node: ast.stmt) -> list[str]:
    """Names that a statement of a module binds."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [node.name]
    if isinstance(node, ast.Assign):
        return [item.id for target in node.targets for item in ast.walk(target) if isinstance(item, ast.Name)]
    if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
        return [node.target.id]
    return []


def _named(node: ast.AST) -> set[str]:
    """Names that a piece of code uses; a function's arguments are the names of its fixtures."""
    names = {item.id for item in ast.walk(node) if isinstance(item, ast.Name)}
    return names | {item.arg for item in ast.walk(node) if isinstance(item, ast.arg)}


def source(test: str) -> str:
    """The text of a test, `file::function`, with all that it names.

    Raises:
        KeyError: there is no such test.
    """
    file, _, name = test.partition("::")
    seen: dict[tuple[Path, str], str] = {}
    _collect(ROOT / file, name, seen)
    _collect(ROOT / file, "pytestmark", seen)  # marks of all tests of the file
    if (ROOT / file, name) not in seen:
        raise KeyError(test)
    return "\n".join(seen.values())


def _collect(file: Path, name: str, seen: dict[tuple[Path, str], str]) -> None:
    """Adds a module's name, and what it leads to."""
    if (file, name) in seen or not file.is_file():
        return
    text, tree = _tree(file)
    for node in tree.body:
        if name in _bound(node):
            decorators = getattr(node, "decorator_list", [])
            own = [ast.get_source_segment(text, item) or "" for item in (*decorators, node)]
            seen[file, name] = "\n".join(own)
            for other in sorted(_named(node)):
                _collect(file, other, seen)
                if (file, other) not in seen and file.name != "conftest.py":
                    _collect(file.parent / "conftest.py", other, seen)
        elif isinstance(node, ast.ImportFrom) and node.module in ("rosml.cli", "scripts", "bench"):  # itself, by click
            for alias in node.names:
                if name == (alias.asname or alias.name):
                    seen[file, name] = {"bench": "bench", "scripts": f"{alias.name}.py"}.get(
                        node.module, SCRIPTS.get(alias.name, "")
                    )
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("tests"):
            for alias in node.names:
                if name == (alias.asname or alias.name):
                    path = ROOT / (node.module or "").replace(".", "/")
                    _collect(path.with_suffix(".py"), alias.name, seen)
                    if (path / f"{alias.name}.py").is_file():  # a module: all of it
                        seen[file, name] = (path / f"{alias.name}.py").read_text(encoding="utf-8")


def lacking(command: str, pages: list[str], test: str) -> str:
    """What a test would have to have in its source to be one that runs a command; empty where it has it.

    Either it follows the page, or it names what is called: the script with its subcommand, the target of make or what
    make's recipe calls for it, the program with its options; and the image that `TARGET` names.
    """
    text = source(test)
    if re.search(r"pytest\.(importor)?skip\b|mark\.skip", text):
        return "a test that is never skipped"
    if any(page in text for page in pages) and re.search(r"\b(blocks|commands|documented|section)\(", text):
        return ""
    words = [word for word in shlex.split(command) if not re.match(r"[A-Z_]+=", word)]
    if words[0] in ("publish.py", "scripts/publish.py"):
        words = ["uv", "run", *words]
    wanted = [match[1] for match in re.finditer(r"\bTARGET=([\w-]+)", command)]
    if words[0] == "source":
        wanted += words[1:]
    elif words[:3] == ["uv", "run", "python"]:
        wanted += words[4:5]
    elif words[0] == "make":
        wanted += [] if _says(text, ["make", *words[1:2]]) else _recipe(words[1] if words[1:] else "help")
    elif words[:2] == ["uv", "run"]:
        wanted += [
            Path(words[2]).name,
            *[word for word in words[3:4] if re.fullmatch(r"[a-z]+", word)],
            *_options(words),
        ]
    else:
        wanted += [*[word for word in words[1:] if re.fullmatch(r"[a-z-]+", word)], *_options(words)]
    return ", ".join(word for word in wanted if not _says(text, [word]))


def _says(text: str, words: list[str]) -> bool:
    """Whether code has these words one after the other, each as a string or part of a command line."""
    between = r"""["']?[ ,]+(?:["']--[a-z-]+["'], )*["']?"""
    return bool(re.search(rf"""(?<![\w-]){between.join(map(re.escape, words))}(?![\w-])""", text))


def _recipe(target: str) -> list[str]:
    """The script and the subcommand that make calls for a target."""
    lines = (ROOT / "Makefile").read_text(encoding="utf-8")
    found = re.search(rf"^{re.escape(target)}:[^\n]*\n((?:\t[^\n]*\n)+)", lines, re.MULTILINE)
    assert found, f"make has no target {target}"
    call = re.search(r"(\w+\.py) ?([a-z]+)?(?![\w-])", found[1])
    if call:
        return [word for word in call.groups() if word]
    own = re.search(r"\$\(BOOTSTRAP\) ([a-z]+)", found[1])
    return [own[1]] if own else [f"make {target}"]


def _options(words: list[str]) -> list[str]:
    return [word.partition("=")[0] for word in words if word.startswith("--")]
