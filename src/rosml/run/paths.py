"""Paths of this machine in options of the engine: mounts, and files that the engine reads and writes."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.run.words import TypedOption

SOURCES = ("source", "src")
READ = ("authfile", "cert-dir", "env-file", "hosts-file", "label-file", "pod-id-file", "signature-policy")
"""Options whose value is a file of this machine that the engine reads, or a folder of such files."""

FILES = (*READ, "cidfile", "conmon-pidfile", "init-path", "pidfile")
NO_HOSTS = ("image", "none")
NAMESPACES = ("cgroupns", "ipc", "net", "network", "pid", "userns", "uts")
"""Options of podman that may have a path, after `ns:`."""

LAYERS = ("upperdir", "workdir")
"""The paths that podman's `-v /a:/b:O` may have after `/b`."""

Change = Callable[[str], str]


def anchored(option: TypedOption, folder: str) -> TypedOption:
    """An option from a file with defaults, with absolute paths: also of files that the engine itself would look for in the current
    folder. `folder` is that of the file."""
    return changed(option, lambda path: _absolute(path, folder))


def resolved(option: TypedOption, folder: str) -> TypedOption:
    """The option with an absolute path if it mounts a relative folder. The engine finds other files itself."""
    return anchored(option, folder) if option.names[-1] in ("volume", "mount") else option


def mounted(option: TypedOption) -> list[str]:
    """The folders of this machine that `-v` mounts. If one is missing, docker makes it, for root; `--mount` refuses it."""
    source, colon, _ = (option.value or "").partition(":")
    return [source] if option.names[-1] == "volume" and colon and source.startswith("/") else []


def bind(source: str, target: str) -> str:
    """The value of `--mount` for a folder. `-v` could not have a colon in a path."""
    return joined(["type=bind", f"source={source}", f"target={target}"])


def joined(fields: Sequence[str]) -> str:
    """A value of fields, separated by commas. A field with a comma, a quote or a line's end is quoted."""
    return ",".join(f'"{x.replace(chr(34), chr(34) * 2)}"' if set(x) & set(',"\n\r') else x for x in fields)


def fields(value: str) -> list[str] | None:
    """The fields of a value, as `joined` writes them; None if they cannot be read: the engine reports the mistake."""
    import csv  # few write mounts so

    try:
        (row,) = csv.reader([value], strict=True)
    except (csv.Error, ValueError):
        return None
    return row


def _absolute(path: str, folder: str) -> str:
    """An absolute path, made from the text alone, as docker does. A path that is absolute stays unchanged."""
    if path == "~" or path.startswith("~/"):  # --volume=~/a: no shell has read that
        return os.path.expanduser(path)
    return path if path.startswith("/") else os.path.normpath(f"{folder}/{path}")


def changed(option: TypedOption, change: Change) -> TypedOption:
    """The option with a new path for each path of this machine. It is an error if the engine would read the new path as two."""
    value, name = option.value, option.names[-1]
    if not value or (name == "hosts-file" and value in NO_HOSTS):
        return option
    if name in FILES or (name == "runtime" and "/" in value):
        new_value = change(value)
    elif name in WRITTEN:
        new_value = WRITTEN[name](value, change)
    elif name in NAMESPACES and value.startswith("ns:"):
        new_value = f"ns:{change(value[3:])}"
    else:
        return option
    return option.with_value(new_value) if new_value != value else option


def _volume(value: str, change: Change) -> str:
    """`./a:/b`, `.a:/b`, `a/b:/c`, `.:/b:ro` and `~/a:/b`; not `/a`, a path in the container, or the volume `name:/b`."""
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
    if (old_fields := fields(value)) is None:
        return value
    kinds = [field.lower() for field in old_fields]
    names = SOURCES if "type=bind" in kinds else ()
    new_fields = [_option(field, change) or _field(field, names, change) for field in old_fields]
    return value if new_fields == old_fields else joined(new_fields)


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
    match = re.fullmatch("(seccomp[=:])(.+)", value, re.DOTALL)
    return match[1] + change(match[2]) if match and match[2] not in ("unconfined", "builtin") else value


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


@dataclass(frozen=True)
class Lead:
    """A path in a file with defaults."""

    path: str
    target: str  # where its links lead
    words: tuple[str, ...] = ()  # of the option, with the target
    reads: bool = False  # the engine reads the content

    def shown(self, folder: str) -> str:
        """The path for people; empty if it has no link. `folder` is the project's."""
        if self.target == os.path.normpath(self.path):
            return ""
        leaves_project = _is_in(self.path, folder) and not _is_in(self.target, folder)
        return f"{self.path}, a link to {self.target}{', outside the project' if leaves_project else ''}"


def _is_in(path: str, folder: str) -> bool:
    return f"{os.path.normpath(path)}/".startswith(f"{folder.rstrip('/')}/")


def followed(option: TypedOption) -> tuple[TypedOption, tuple[Lead, ...]]:
    """The option with the targets of its paths, so that the engine gets what the user was asked about."""
    targets: dict[str, str] = {}
    name, value = option.names[-1], option.value or ""
    if name == "mount" and "type=glob" in value.lower():
        raise RosmlError("--mount type=glob: what it finds may change", "write a mount of type=bind for each folder")
    reads = name in (*READ, "decryption-key", "runtime") or (name == "security-opt" and value.startswith("seccomp"))

    def follow(path: str) -> str:
        return targets.setdefault(path, _end(path))

    new = changed(option, follow)
    return new, tuple(Lead(path, target, new.words, reads) for path, target in targets.items())


def _end(path: str) -> str:
    """The target of a path. Links of udev, such as /dev/serial/by-id/camera, stay: they change whenever somebody plugs something
    in, and only root makes them. Other file systems below /dev, such as /dev/shm, may have anybody's links."""
    target, path = os.path.realpath(path), os.path.normpath(path)
    try:
        status, devices = os.lstat(path), os.lstat("/dev")
    except OSError:
        return target
    is_udevs = path.startswith("/dev/") and (status.st_uid, status.st_dev) == (0, devices.st_dev)
    return path if is_udevs and target.startswith("/dev/") else target
