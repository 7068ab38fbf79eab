"""Paths of this machine in the options of the engine: what is mounted, and files that the engine reads and writes."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.run.words import Given

SOURCES = ("source", "src")
"""How a mount names what is mounted."""

READ = ("authfile", "cert-dir", "env-file", "hosts-file", "label-file", "pod-id-file", "signature-policy")
"""Options whose value is a file of this machine that the engine reads, or a folder of such files."""

FILES = (*READ, "cidfile", "conmon-pidfile", "init-path", "pidfile")
"""Options whose value is a path of this machine."""

NO_HOSTS = ("image", "none")
"""What --hosts-file takes in the place of a path."""

NAMESPACES = ("cgroupns", "ipc", "net", "network", "pid", "userns", "uts")
"""Options of podman that may have a path, after `ns:`."""

LAYERS = ("upperdir", "workdir")
"""What podman's `-v /a:/b:O` may have as paths after `/b`."""

Change = Callable[[str], str]
"""What becomes of a path."""


def anchored(given: Given, folder: str) -> Given:
    """The same option of a file, whose folder the engine does not know: also files that the engine itself would find from the
    current folder.

    Args:
        given: options of the engine. folder: that of the file.

    Raises:
        RosmlError: as in `changed`.
    """
    return changed(given, lambda path: _absolute(path, folder))


def resolved(given: Given, folder: str) -> Given:
    """The same option; where it mounts a relative folder, with its absolute path. The engine finds other files itself.

    Args:
        given: options of the engine.
        folder: the current one.

    Raises:
        RosmlError: as in `changed`.
    """
    return anchored(given, folder) if given.names[-1] in ("volume", "mount") else given


def mounted(given: Given) -> list[str]:
    """What `-v` mounts of this machine. `--mount` refuses a folder that is missing; of `-v`, docker makes it, for root.

    Args:
        given: an option whose paths are absolute.
    """
    source, colon, _ = (given.value or "").partition(":")
    return [source] if given.names[-1] == "volume" and colon and source.startswith("/") else []


def bind(source: str, target: str) -> str:
    """The value of `--mount` for a folder. `-v` could not have a colon in a path."""
    return joined(["type=bind", f"source={source}", f"target={target}"])


def joined(fields: Sequence[str]) -> str:
    """A value of fields with commas between them; one that has a comma, a quote or a line's end in it is quoted."""
    return ",".join(f'"{x.replace(chr(34), chr(34) * 2)}"' if set(x) & set(',"\n\r') else x for x in fields)


def _absolute(path: str, folder: str) -> str:
    """As docker does it, by the words of the path alone; an absolute path stays as it is written."""
    if path == "~" or path.startswith("~/"):  # --volume=~/a: no shell has read that
        return os.path.expanduser(path)
    return path if path.startswith("/") else os.path.normpath(f"{folder}/{path}")


# ---- Where paths are in an option ------------------------------------------------------------------------------------


def changed(given: Given, change: Change) -> Given:
    """The same option, with another path for each path of this machine that it names.

    Args:
        given: options of the engine. Only the last one in a word has a value.

    Raises:
        RosmlError: the engine would read the new path as two.
    """
    value, name = given.value, given.names[-1]
    if not value or (name == "hosts-file" and value in NO_HOSTS):
        return given
    if name in FILES or (name == "runtime" and "/" in value):
        new = change(value)
    elif name in WRITTEN:
        new = WRITTEN[name](value, change)
    elif name in NAMESPACES and value.startswith("ns:"):
        new = f"ns:{change(value[3:])}"
    else:
        return given
    return given.with_value(new) if new != value else given


def _volume(value: str, change: Change) -> str:
    """`./a:/b`, `.a:/b`, `a/b:/c`, `.:/b:ro` and `~/a:/b`; not `/a`, which is a place in the container, or the volume `name:/b`."""
    source, colon, rest = value.partition(":")
    if not colon or not (source.startswith(".") or "/" in source):
        return value
    path = change(source)
    if ":" in path:
        target, _, options = rest.partition(":")
        mount = bind(path, target) + (",readonly" if "ro" in options.split(",") else "")
        remedy = shlex.join(["--mount", mount])
        raise RosmlError(f"-v cannot mount {path}: the path has a colon", remedy, exit_code=2)
    if any(f"{name}=" in rest for name in LAYERS):
        target, colon, options = rest.partition(":")
        rest = target + colon + ",".join(_field(option, LAYERS, change) for option in options.split(","))
    return f"{path}:{rest}"


def _mount(value: str, change: Change) -> str:
    """`type=bind,source=a,target=/b`. Docker takes capital letters, and mounts a folder as a volume with a `device`."""
    import csv  # few write mounts so

    try:
        (fields,) = csv.reader([value], strict=True)
    except (csv.Error, ValueError):  # the engine says what is wrong with it
        return value
    kinds = [field.lower() for field in fields]
    names = SOURCES if "type=bind" in kinds else ()
    found = [_option(field, change) or _field(field, names, change) for field in fields]
    return value if found == fields else joined(found)


def _option(field: str, change: Change) -> str:
    """`volume-opt=device=/a`; empty for another field."""
    key, _, option = field.partition("=")
    return f"{key}={_field(option, ('device',), change)}" if key.lower() == "volume-opt" else ""


def _field(field: str, names: Sequence[str], change: Change) -> str:
    """`name=path`, for these names."""
    key, equals, path = field.partition("=")
    return f"{key}={change(path)}" if equals and path and key.lower() in names else field


def _device(value: str, change: Change) -> str:
    """`/dev/a`, `/dev/a:/dev/b`, `/dev/a:rw`, `/dev/a:/dev/b:rw`; not CDI's `vendor.com/class=name`. In the container the device
    keeps its place."""
    source, _, rest = value.partition(":")
    if not source.startswith(("/", ".")) or (path := change(source)) == source:
        return value
    if not rest or re.fullmatch("[rwm]+", rest):
        rest = f"{source}:{rest}" if rest else source
    return f"{path}:{rest}"


def _security(value: str, change: Change) -> str:
    """`seccomp=profile.json`."""
    found = re.fullmatch("(seccomp[=:])(.+)", value, re.DOTALL)
    return found[1] + change(found[2]) if found and found[2] not in ("unconfined", "builtin") else value


def _key(value: str, change: Change) -> str:
    """`key.pem:passphrase`."""
    path, colon, rest = value.partition(":")
    return change(path) + colon + rest


WRITTEN: dict[str, Callable[[str, Change], str]] = {
    "decryption-key": _key,
    "device": _device,
    "log-opt": lambda value, change: _field(value, ("path",), change),
    "mount": _mount,
    "security-opt": _security,
    "volume": _volume,
}
"""Options that have a path among other things."""

# ---- What paths lead to ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Lead:
    """A path of a file with defaults, and what it leads to. Attributes: words: of the option, with the latter. reads: the engine
    reads what is in there."""

    path: str
    target: str
    words: tuple[str, ...] = ()
    reads: bool = False

    def said(self, folder: str) -> str:
        """How people are shown it; empty if no link is on the way.

        Args:
            folder: that of the project.
        """
        if self.target == os.path.normpath(self.path):
            return ""
        leaves = _is_in(self.path, folder) and not _is_in(self.target, folder)
        return f"{self.path}, a link to {self.target}{', outside the project' if leaves else ''}"


def _is_in(path: str, folder: str) -> bool:
    return f"{os.path.normpath(path)}/".startswith(f"{folder.rstrip('/')}/")


def followed(given: Given) -> tuple[Given, tuple[Lead, ...]]:
    """The same option with what its paths lead to: what somebody is asked about is what the engine gets.

    Args:
        given: an option whose paths are absolute.

    Raises:
        RosmlError: as in `changed`, or the engine would find more paths itself.
    """
    found: dict[str, str] = {}
    name, value = given.names[-1], given.value or ""
    if name == "mount" and "type=glob" in value.lower():
        raise RosmlError("--mount type=glob: what it finds may change", "write a mount of type=bind for each folder")
    reads = name in (*READ, "decryption-key", "runtime") or (name == "security-opt" and value.startswith("seccomp"))

    def follow(path: str) -> str:
        return found.setdefault(path, _end(path))

    new = changed(given, follow)
    return new, tuple(Lead(path, target, new.words, reads) for path, target in found.items())


def _end(path: str) -> str:
    """Where a path leads. The links of udev, such as /dev/serial/by-id/camera, change whenever somebody plugs something in; only
    root makes them. Other file systems below /dev, such as /dev/shm, may have links of anybody's."""
    target, path = os.path.realpath(path), os.path.normpath(path)
    try:
        found, devices = os.lstat(path), os.lstat("/dev")
    except OSError:
        return target
    is_udevs = path.startswith("/dev/") and (found.st_uid, found.st_dev) == (0, devices.st_dev)
    return path if is_udevs and target.startswith("/dev/") else target
