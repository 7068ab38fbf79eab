"""Reads uv.lock, in which uv keeps the versions of a project's dependencies. Of its format, version 1, we read what its packages need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape

SUFFIX = ".lock"

_OWN = ("virtual", "editable", "directory")
"""The kinds of sources of a project itself."""

_REMEDY = "name its pyproject.toml, or the requirements themselves"

_Name = Annotated[str, Field(pattern=r"^[a-z0-9]([a-z0-9-]*[a-z0-9])?$", max_length=200)]
_Version = Annotated[str, Field(pattern=r"^[A-Za-z0-9.+!_-]+$", max_length=100)]


class _Dependency(Shape):
    name: _Name
    version: _Version | None = None  # if the lock has several
    extra: list[_Name] = []
    marker: str = ""


class _Package(Shape):
    name: _Name
    version: _Version | None = None
    source: dict[str, Any]
    dependencies: list[_Dependency] = []


class _Lock(Shape):
    version: Literal[1]
    package: list[_Package] = []


def requirements(file: Path) -> list[str]:
    """What the project needs itself, each in the lock's version, without its groups and extras.

    Raises:
        RosmlError: it is no such lock, or of several projects; the project needs something that is from no index.
    """
    lock = _read(file)
    projects = [package for package in lock.package if any(kind in package.source for kind in _OWN)]
    if len(projects) != 1:
        names = ", ".join(package.name for package in projects[:5]) or "no project"
        raise RosmlError(f"{file} is of {names}, and an environment is of one project", _REMEDY, exit_code=2)
    versions = _single(lock)
    texts = []
    for item in projects[0].dependencies:
        version = _public(item.version or versions.get(item.name, ""))
        if not version:
            text = f"{file}: {item.name} is of no index, and an environment has only wheels of one"
            raise RosmlError(text, "leave it out of the project, or publish it as a wheel", exit_code=2)
        extras = f"[{','.join(item.extra)}]" if item.extra else ""
        texts.append(f"{item.name}{extras}=={version}{f'; {item.marker}' if item.marker else ''}")
    return texts


def preferences(file: Path) -> str:
    """All packages with one version, as uv reads them from an earlier resolution: these versions stay if they fit."""
    return "".join(f"{name}=={version}\n" for name, version in _single(_read(file)).items())


def _single(lock: _Lock) -> dict[str, str]:
    """Packages of an index that are there in one version alone."""
    count = Counter(package.name for package in lock.package)
    return {name: version for name, version in _indexed(lock) if count[name] == 1}


def _indexed(lock: _Lock) -> Iterator[tuple[str, str]]:
    for package in lock.package:
        if "registry" in package.source and package.version:
            yield package.name, _public(package.version)


def _public(version: str) -> str:
    """Without what PyTorch's own index has behind a plus: an environment has PyTorch of the image, or of the index that it is resolved with."""
    return version.partition("+")[0]


def _read(file: Path) -> _Lock:
    try:
        return _Lock.model_validate(untrusted.toml_value(files.text(file)))
    except ValidationError as error:
        raise RosmlError(f"{file} is no uv.lock of version 1: {first_of(error)}", _REMEDY, exit_code=2) from None
    except ValueError as error:
        raise RosmlError(f"{file} is no TOML: {error}", _REMEDY, exit_code=2) from None
