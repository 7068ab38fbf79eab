"""What an environment shall have: the file environment.toml in its folder, which people edit."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, ConfigDict, Field, ValidationError
from pydantic_core import PydanticCustomError

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.images.environments import uv_lock

FILE = "environment.toml"

_PACKAGE = r"[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?"

REQUIREMENT = rf"{_PACKAGE}( *\[[A-Za-z0-9._, -]+\])?( *[<>=!~(;][A-Za-z0-9 <>=!~().,;*+_'\"-]*)?"
"""A package of an index: name, extras, versions, marker. uv reads the rest. No address: that has no versions and may be a source. No
character that ends a line for uv: an option could follow, by which it builds a source on this machine."""

_MOST = 256


def _is_requirement(text: str) -> str:
    if not re.fullmatch(REQUIREMENT, text):
        raise PydanticCustomError("requirement", "{text} is no package of an index with versions", {"text": repr(text)})
    return text


_Requirement = Annotated[str, Field(max_length=400), AfterValidator(_is_requirement)]
_Package = Annotated[str, Field(pattern=rf"^{_PACKAGE}$", max_length=200)]
_Target = Annotated[str, Field(pattern=r"^[a-z0-9][a-z0-9.-]*$", max_length=200)]


class Declaration(Shape):
    """`requirements` as pip writes them; packages of `without` stay out, whoever needs them. `images`: the bake targets that it has locks for,
    one of each Python. With `apart`, it takes nothing of them, and has its own PyTorch."""

    model_config = ConfigDict(strict=True, frozen=True, extra="forbid")

    requirements: Annotated[list[_Requirement], Field(min_length=1, max_length=_MOST)]
    without: Annotated[list[_Package], Field(max_length=_MOST)] = []
    images: Annotated[list[_Target], Field(max_length=_MOST)] = []
    apart: bool = False


def read(folder: Path) -> Declaration:
    """The declaration in a folder. Raises a RosmlError if there is none, or it is wrong."""
    file = folder / FILE
    if not file.is_file():
        remedy = "make it: rosml env add NAME REQUIREMENT... --image IMAGE"
        raise RosmlError(f"there is no {file}", remedy, exit_code=2)
    try:
        return Declaration.model_validate(untrusted.toml_value(files.text(file)))
    except ValidationError as error:
        raise RosmlError(f"{file}: {first_of(error)}", "correct it", exit_code=2) from None
    except ValueError as error:
        raise RosmlError(f"{file} is no TOML: {error}", "correct it", exit_code=2) from None


def content(declaration: Declaration) -> str:
    """The text of the file. A comment of the file before does not stay."""
    facts = {"requirements": declaration.requirements, "without": declaration.without, "images": declaration.images}
    lists = "".join(_lines({name: texts for name, texts in facts.items() if texts}))
    return f"{lists}apart = true\n" if declaration.apart else lists


def _lines(facts: dict[str, list[str]]) -> Iterator[str]:
    for name, texts in facts.items():
        yield f"{name} = [\n"
        yield from (f"  {json.dumps(text)},\n" for text in texts)
        yield "]\n"


def changed(
    earlier: Declaration | None, words: Sequence[str], without: Iterable[str], apart: bool = False
) -> Declaration:
    """What a command line asks for: requirements, and files that have some (requirements.txt, pyproject.toml, uv.lock), for the images of before.

    Without words, it is what was before, without more packages.
    """
    requirements = [item for word in words for item in _of_word(word)]
    stay_out = [*without]
    if earlier and not words:
        requirements, stay_out = earlier.requirements, [*earlier.without, *stay_out]
    try:
        return Declaration(
            requirements=[*dict.fromkeys(requirements)],
            without=[*dict.fromkeys(stay_out)],
            images=earlier.images if earlier else [],
            apart=apart or bool(earlier and earlier.apart),
        )
    except ValidationError as error:
        remedy = "write each as lerobot==0.4.4, without hashes and addresses"
        raise RosmlError(f"requirements of an environment: {first_of(error)}", remedy, exit_code=2) from None


def _of_word(word: str) -> Iterable[str]:
    if not word.endswith((".toml", ".txt", uv_lock.SUFFIX)):
        return (word,)
    if not (file := Path(word)).is_file():  # a pipe would never end
        raise RosmlError(f"there is no file {files.shown(file)}", "write its path, or a requirement", exit_code=2)
    if word.endswith(uv_lock.SUFFIX):
        return uv_lock.requirements(file)
    return _of_project(file) if word.endswith(".toml") else _of_list(file)


def _of_project(file: Path) -> list[str]:
    """The dependencies of a project. Nothing of it runs, so a program must not decide them."""
    try:
        facts: Any = untrusted.toml_value(files.text(file)).get("project")
    except ValueError as error:
        raise RosmlError(f"{file} is no TOML: {error}", "correct it", exit_code=2) from None
    dependencies = facts.get("dependencies") if isinstance(facts, dict) else None
    if not isinstance(dependencies, list) or not all(isinstance(item, str) for item in dependencies):
        text = f"{file} has no list of dependencies of the project"
        raise RosmlError(text, "write its requirements into the command, or into a requirements.txt", exit_code=2)
    return dependencies


def _of_list(file: Path) -> Iterator[str]:
    """The requirements in a file for pip. Its options would name indexes and files, which an environment has from elsewhere."""
    for number, line in enumerate(files.text(file).splitlines(), 1):
        text = re.sub(r"(^|\s)#.*", "", line).strip()
        if text.startswith("-"):
            remedy = "leave it out; an index is set by UV_INDEX, or in uv's own configuration"
            raise RosmlError(f"{file}:{number} has an option of pip: {text[:80]}", remedy, exit_code=2)
        if text:
            yield text
