"""Folders of this machine that are mounted: relative ones are meant from the current folder."""

from __future__ import annotations

import os
import shlex
from collections.abc import Sequence

from rosml.base.errors import RosmlError
from rosml.run.words import Given

SOURCES = ("source=", "src=")
"""How a mount names what is mounted."""


READ = ("authfile", "cert-dir", "cidfile", "env-file", "hosts-file", "label-file", "pidfile", "pod-id-file")
"""Options whose value is a file of this machine, which the engine reads or writes."""


def anchored(given: Given, folder: str) -> Given:
    """The same option of a file, whose folder the engine does not know: also files that the engine itself would find from the
    current folder.

    Args:
        given: options of the engine. folder: that of the file.

    Raises:
        RosmlError: as in `resolved`.
    """
    if given.value and given.names[-1] in READ:
        return given.with_value(_absolute(given.value, folder))
    return resolved(given, folder)


def resolved(given: Given, folder: str) -> Given:
    """The same option; where it mounts a relative folder, with its absolute path. A name without `/` is a volume's.

    Args:
        given: options of the engine.
        folder: the current one.

    Raises:
        RosmlError: the engine would read the path as two.
    """
    if given.value is None or given.names[-1] not in ("volume", "mount"):
        return given
    return given.with_value((_volume if given.names[-1] == "volume" else _mount)(given.value, folder))


def bind(source: str, target: str) -> str:
    """The value of `--mount` for a folder. `-v` could not have a colon in a path."""
    return joined(["type=bind", f"source={source}", f"target={target}"])


def _volume(value: str, folder: str) -> str:
    """`./a:/b`, `a/b:/c`, `.:/b:ro` and `~/a:/b`; not `/a`, which is a place in the container, or `name:/b`."""
    source, colon, rest = value.partition(":")
    is_path = source in (".", "..") or "/" in source
    if not colon or not is_path:
        return value
    path = _absolute(source, folder)
    if ":" in path:
        target, _, options = rest.partition(":")
        mount = bind(path, target) + (",readonly" if "ro" in options.split(",") else "")
        remedy = shlex.join(["--mount", mount])
        raise RosmlError(f"-v cannot mount {path}: the path has a colon", remedy, exit_code=2)
    return f"{path}:{rest}"


def _mount(value: str, folder: str) -> str:
    """`type=bind,source=a,target=/b`; only where the type is bind."""
    import csv  # few write mounts so

    try:
        (fields,) = csv.reader([value], strict=True)
    except (csv.Error, ValueError):  # the engine says what is wrong with it
        return value
    if "type=bind" not in fields:
        return value
    found = [_source(field, folder) for field in fields]
    return value if found == fields else joined(found)


def _source(field: str, folder: str) -> str:
    key, equals, path = field.partition("=")
    return f"{key}={_absolute(path, folder)}" if key + equals in SOURCES and path else field


def _absolute(path: str, folder: str) -> str:
    """As docker does it, by the words of the path alone; an absolute path stays as it is written."""
    if path == "~" or path.startswith("~/"):  # --volume=~/a: no shell has read that
        return os.path.expanduser(path)
    return path if path.startswith("/") else os.path.normpath(f"{folder}/{path}")


def joined(fields: Sequence[str]) -> str:
    """A value of fields with commas between them; one that has a comma, a quote or a line's end in it is quoted."""
    return ",".join(f'"{x.replace(chr(34), chr(34) * 2)}"' if set(x) & set(',"\n\r') else x for x in fields)
