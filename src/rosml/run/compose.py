"""Writes a call as a file for `docker compose`: https://github.com/compose-spec/compose-spec."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import yaml

from rosml.base.errors import RosmlError
from rosml.run.export import Call, Option, fields, file, placed, volume

SAME = (
    *("annotation", "cpus", "domainname", "expose", "hostname", "ipc", "isolation", "pid", "platform"),
    *("restart", "runtime", "tmpfs", "user", "uts", "cap-add", "cap-drop", "cgroup-parent", "cpu-count", "cpu-percent"),
    *("cpu-period", "cpu-quota", "cpu-rt-period", "cpu-rt-runtime", "cpu-shares", "dns", "dns-opt", "dns-search"),
    *("group-add", "init", "mac-address", "oom-kill-disable", "oom-score-adj", "pids-limit", "privileged", "read-only"),
    *("security-opt", "shm-size", "stop-signal", "storage-opt", "tty", "use-api-socket"),
)
"""Options with the same name in compose, with `_` for `-`."""

NAMES = {
    **{name: name.replace("-", "_") for name in SAME},
    "add-host": "extra_hosts",
    "annotation": "annotations",
    "cgroupns": "cgroup",
    "cpuset-cpus": "cpuset",
    "device": "devices",
    "device-cgroup-rule": "device_cgroup_rules",
    "entrypoint": "entrypoint",
    "env": "environment",
    "health-cmd": "healthcheck.test",
    "health-interval": "healthcheck.interval",
    "health-retries": "healthcheck.retries",
    "health-start-interval": "healthcheck.start_interval",
    "health-start-period": "healthcheck.start_period",
    "health-timeout": "healthcheck.timeout",
    "interactive": "stdin_open",
    "label": "labels",
    "link": "external_links",
    "log-driver": "logging.driver",
    "log-opt": "logging.options",
    "memory": "mem_limit",
    "memory-reservation": "deploy.resources.reservations.memory",
    "memory-swap": "memswap_limit",
    "memory-swappiness": "mem_swappiness",
    "name": "container_name",
    "no-healthcheck": "healthcheck.disable",
    "publish": "ports",
    "pull": "pull_policy",
    "sysctl": "sysctls",
    "userns": "userns_mode",
    "workdir": "working_dir",
}
"""Compose's names of options; a point leads into a nested field."""

LISTS = (
    *("add-host", "cap-add", "cap-drop", "device", "device-cgroup-rule", "dns", "dns-opt", "dns-search", "expose"),
    *("group-add", "link", "publish", "security-opt", "tmpfs"),
)
"""Options that compose takes several times."""

PAIRS = ("annotation", "env", "label", "log-opt", "storage-opt", "sysctl")
"""Options with a name and a value."""

SWITCHES = (
    *("init", "interactive", "no-healthcheck", "oom-kill-disable", "privileged", "read-only", "tty", "use-api-socket"),
)

TAKEN = {"cgroupns": ("host", "private"), "pull": ("always", "missing", "never")}
"""The values that compose takes; podman has others."""

MOUNT = {
    "type": "type",
    "source": "source",
    "target": "target",
    "readonly": "read_only",
    "bind-propagation": "bind.propagation",
    "volume-nocopy": "volume.nocopy",
    "volume-subpath": "volume.subpath",
    "tmpfs-size": "tmpfs.size",
    "tmpfs-mode": "tmpfs.mode",
}
"""Compose's names of the fields of `--mount`."""


def text(call: Call) -> str:
    """The file.

    Raises:
        RosmlError: an option has no counterpart.
    """
    return yaml.dump(_escaped(content(call)), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1_000_000)


def content(call: Call) -> dict[str, Any]:
    """The content of the file, in which compose still reads `$` as the beginning of a variable.

    Raises:
        RosmlError: an option has no counterpart.
    """
    service: Any = reduce(_merged, (_part(option, call.folder) for option in call.options), {"image": call.image})
    if "entrypoint" in service:
        service["entrypoint"] = [service["entrypoint"]]  # the engines take one word
    if call.command:
        service["command"] = [*call.command]
    networks = {name: {"name": name, "external": True} for name in service.get("networks", ())}
    volumes = {name: {"name": name} for name in map(_volume_of, service.get("volumes", ())) if name}
    others = {"networks": networks, "volumes": volumes}
    return {"services": {call.name: service}, **{key: found for key, found in others.items() if found}}


# ---- An option -------------------------------------------------------------------------------------------------------


def _part(option: Option, folder: str) -> dict[str, Any]:
    """The fields that an option adds to a service.

    Raises:
        RosmlError: the option has no counterpart.
    """
    name, value = option.name, option.value or ""
    if name in MADE:
        return MADE[name](option, folder)
    if name not in NAMES or value not in TAKEN.get(name, (value,)):
        raise _without(option, f"--{name}" if name not in NAMES else f"--{name}={value}")
    found: Any = value
    if name in SWITCHES:
        found = option.is_on
    elif name in LISTS:
        found = [value]
    elif name in PAIRS:
        key, equals, said = value.partition("=")
        found = {
            key: None if name == "env" and not equals else said
        }  # None: from the environment of the user who starts it
    return _nested(NAMES[name], found)


def _without(option: Option, what: str) -> RosmlError:
    return RosmlError(f"{what} has no counterpart in a file of compose", f"leave out --{option.name}", exit_code=2)


def _network(option: Option, folder: str) -> dict[str, Any]:
    value = option.value or ""
    if "=" in value:
        raise _without(option, f"--network {value}")
    if value in ("bridge", "default", "host", "none") or ":" in value:
        return {"network_mode": value}
    return {"networks": {value: {}}}


def _volume(option: Option, folder: str) -> dict[str, Any]:
    return {"volumes": [volume(option, folder, ".")]}


def _mount(option: Option, folder: str) -> dict[str, Any]:
    """A mount. The engines refuse a missing folder; compose would make it."""
    mount: dict[str, Any] = {"type": "volume"}
    for key, value in fields(option):
        if key not in MOUNT:
            raise _without(option, f"{key} of --mount")
        found: Any = value
        if key in ("readonly", "volume-nocopy"):
            found = Option(key, value or None).is_on
        elif key == "tmpfs-mode":
            found = _octal(value)
        mount = _merged(mount, _nested(MOUNT[key], found))
    if mount["type"] == "bind":
        mount = _merged(mount, {"bind": {"create_host_path": False}})
        mount["source"] = placed(mount.get("source", ""), folder, ".")
    return {"volumes": [mount]}


def _octal(mode: str) -> int | str:
    """A mode. The engines read it with the base 8, compose with the base 10."""
    return int(mode, 8) if re.fullmatch("[0-7]{1,9}", mode) else mode


def _gpus(option: Option, folder: str) -> dict[str, Any]:
    """GPUs: `all`, `2`, `device=0`, `"device=0,1"`, or other fields."""
    device: dict[str, Any] = {"driver": "nvidia", "capabilities": ["gpu"]}
    for key, value in fields(option):
        if key in ("all", "count") or COUNT.fullmatch(key):
            count = value or key
            device["count"] = int(count) if COUNT.fullmatch(count) else count
        elif key == "device":
            device["device_ids"] = value.split(",")
        elif key == "driver":
            device["driver"] = value
        elif key == "capabilities":
            device = _merged(device, {"capabilities": value.split(",")})
        else:
            raise _without(option, f"{key} of --gpus")
    if "count" not in device and "device_ids" not in device:
        device["count"] = 1
    return _nested("deploy.resources.reservations.devices", [device])


def _ulimit(option: Option, folder: str) -> dict[str, Any]:
    name, _, limits = (option.value or "").partition("=")
    soft, colon, hard = limits.partition(":")
    return {"ulimits": {name: {"soft": _number(soft), "hard": _number(hard)} if colon else _number(soft)}}


def _number(found: str) -> int | str:
    return int(found) if NUMBER.fullmatch(found) else found


COUNT, NUMBER = re.compile("[0-9]{1,18}"), re.compile("-?[0-9]{1,18}")
"""Values that become numbers. All others stay text."""


MADE: Mapping[str, Callable[[Option, str], dict[str, Any]]] = {
    "env-file": lambda option, folder: {"env_file": [{"path": file(option, folder, "."), "format": "raw"}]},
    "gpus": _gpus,
    "label-file": lambda option, folder: {"label_file": [file(option, folder, ".")]},
    "mount": _mount,
    "network": _network,
    "stop-timeout": lambda option, folder: {"stop_grace_period": f"{option.value}s"},
    "ulimit": _ulimit,
    "volume": _volume,
    "volumes-from": lambda option, folder: {"volumes_from": [f"container:{option.value}"]},
}
"""Options with a form of their own in compose."""

# ---- The file --------------------------------------------------------------------------------------------------------


def _volume_of(mount: str | Mapping[str, Any]) -> str:
    """The name of a mounted volume; empty if it is a folder, or has no name."""
    if not isinstance(mount, str):
        return str(mount.get("source", "")) if mount["type"] == "volume" else ""
    source, colon, _ = mount.partition(":")
    return source if colon and "/" not in source and source != "." else ""


def _nested(path: str, found: Any) -> dict[str, Any]:
    """`a.b` and what is in it, as `{a: {b: …}}`."""
    first, _, rest = path.partition(".")
    return {first: _nested(rest, found) if rest else found}


def _merged(first: Any, second: Any) -> Any:
    """Both; of two texts, numbers or switches the second one."""
    if isinstance(first, dict) and isinstance(second, dict):
        both = {key: _merged(first[key], second[key]) for key in first if key in second}
        return {**first, **second, **both}
    if isinstance(first, list) and isinstance(second, list):
        return [*first, *(item for item in second if item not in first)]
    return second


def _escaped(found: Any) -> Any:
    """The same with each `$` twice: compose takes one for a variable."""
    if isinstance(found, dict):
        return {key: _escaped(value) for key, value in found.items()}
    if isinstance(found, list):
        return [*map(_escaped, found)]
    return found.replace("$", "$$") if isinstance(found, str) else found


class _Dumper(yaml.SafeDumper):
    """Quotes each text that a reader may take for something else, such as `1e3`, which is a number in YAML 1.2."""


def _quoted(dumper: yaml.SafeDumper, found: str) -> yaml.Node:
    plain = re.fullmatch(r"([A-Za-z_/]|\./)[ -~]*|\.", found)
    return dumper.represent_scalar("tag:yaml.org,2002:str", found, style=None if plain else '"')


_Dumper.add_representer(str, _quoted)
