"""Writes a call as a file for `docker compose`: https://github.com/compose-spec/compose-spec."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import reduce
from typing import Any

from rosml.base.errors import RosmlError
from rosml.run.context import Context
from rosml.run.exports import yaml_text
from rosml.run.exports.description import COUNT, Call, Option, fields, file, gpus, lasting, placed, volume
from rosml.run.exports.yaml_text import merged, nested

SAME_NAMES = (
    *("cpus", "domainname", "entrypoint", "expose", "hostname", "ipc", "isolation", "pid", "platform"),
    *("restart", "runtime", "tmpfs", "user", "uts", "cap-add", "cap-drop", "cgroup-parent", "cpu-count", "cpu-percent"),
    *("cpu-period", "cpu-quota", "cpu-rt-period", "cpu-rt-runtime", "cpu-shares", "dns", "dns-opt", "dns-search"),
    *("group-add", "init", "mac-address", "oom-kill-disable", "oom-score-adj", "pids-limit", "privileged", "read-only"),
    *("security-opt", "shm-size", "stop-signal", "storage-opt", "tty", "use-api-socket"),
)

HEALTH = ("interval", "retries", "start_interval", "start_period", "timeout")

NAMES = {
    **{name: name.replace("-", "_") for name in SAME_NAMES},
    "add-host": "extra_hosts",
    "annotation": "annotations",
    "cgroupns": "cgroup",
    "cpuset-cpus": "cpuset",
    "device": "devices",
    "device-cgroup-rule": "device_cgroup_rules",
    "env": "environment",
    **{f"health-{name.replace('_', '-')}": f"healthcheck.{name}" for name in HEALTH},
    "health-cmd": "healthcheck.test",
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

REPEATABLE = (
    *("add-host", "cap-add", "cap-drop", "device", "device-cgroup-rule", "dns", "dns-opt", "dns-search", "expose"),
    *("group-add", "link", "publish", "security-opt", "tmpfs"),
)

NAME_AND_VALUE = ("annotation", "env", "label", "log-opt", "storage-opt", "sysctl")
SWITCHES = (
    *("init", "interactive", "no-healthcheck", "oom-kill-disable", "privileged", "read-only", "tty", "use-api-socket"),
)

ACCEPTED_VALUES = {"cgroupns": ("host", "private"), "pull": ("always", "missing", "never")}
MOUNT_FIELDS = {
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


def portable(context: Context) -> Context:
    """The context of a file of compose, which has no word for podman's entry in /etc/passwd."""
    context = lasting(context)
    return replace(context, engine=replace(context.engine, passwd=False))


def text(call: Call) -> str:
    return _about_gpus(call) + yaml_text.text(escaped(content(call)))


def _about_gpus(call: Call) -> str:
    """What to do with the file on a machine without a GPU: compose's own error names a driver that it could not select."""
    devices = [f"- {value} from devices" for value in call.values("device") if value.startswith("nvidia.com/")]
    fields = ["deploy and what is below it"] if call.values("gpus") else devices
    fields = fields or ["runtime"] * (call.value("runtime") == "nvidia")
    remedy = f"remove {fields[0]}, and take an image for the CPU (rosml list cpu)." if fields else ""
    return f"# For a machine with an NVIDIA GPU. Without one, {remedy}\n" if fields else ""


def content(call: Call) -> dict[str, Any]:
    """The content of the file, in which compose still reads `$` as the beginning of a variable."""
    service: Any = reduce(merged, (_part(option, call) for option in call.options), {"image": call.image})
    if "entrypoint" in service:
        service["entrypoint"] = [service["entrypoint"]]  # the engines take one word
    if call.command:
        service["command"] = [*call.command]
    networks = {name: {"name": name, "external": True} for name in service.get("networks", ())}
    volumes = {name: {"name": name} for name in map(_volume_of, service.get("volumes", ())) if name}
    document = {"services": {call.name: service}, "networks": networks, "volumes": volumes}
    return {key: part for key, part in document.items() if part}


def _part(option: Option, call: Call) -> dict[str, Any]:
    """The fields that an option adds to a service."""
    name, value = option.name, option.value or ""
    if name in WRITERS:
        return WRITERS[name](option, call)
    if name not in NAMES or value not in ACCEPTED_VALUES.get(name, (value,)):
        raise _without(option, f"--{name}" if name not in NAMES else f"--{name}={value}")
    if name in SWITCHES:
        return nested(NAMES[name], option.is_on)
    if name in NAME_AND_VALUE:
        key, equals, text = value.partition("=")
        from_caller = name == "env" and not equals  # the environment of the user who starts it
        return nested(NAMES[name], {key: None if from_caller else text})
    return nested(NAMES[name], [value] if name in REPEATABLE else value)


def _without(option: Option, option_text: str) -> RosmlError:
    text = f"{option_text} has no counterpart in a file of compose"
    return RosmlError(text, f"leave out --{option.name}", exit_code=2)


def _network(option: Option, call: Call) -> dict[str, Any]:
    value = option.value or ""
    if "=" in value:
        raise _without(option, f"--network {value}")
    if value in ("bridge", "default", "host", "none") or ":" in value:
        return {"network_mode": value}
    return {"networks": {value: {}}}


def _mount(option: Option, call: Call) -> dict[str, Any]:
    """A mount. The engines refuse a missing folder; compose would make it."""
    mount: dict[str, Any] = {"type": "volume"}
    for key, value in fields(option):
        if key not in MOUNT_FIELDS:
            raise _without(option, f"{key} of --mount")
        written: Any = value
        if key in ("readonly", "volume-nocopy"):
            written = Option(key, value or None).is_on
        elif key == "tmpfs-mode" and re.fullmatch("[0-7]{1,9}", value):
            written = int(value, 8)  # compose reads it with the base 10
        mount = merged(mount, nested(MOUNT_FIELDS[key], written))
    if mount["type"] == "bind":
        mount = merged(mount, {"bind": {"create_host_path": False}})
        mount["source"] = placed(mount.get("source", ""), call, ".")
    return {"volumes": [mount]}


def _gpus(option: Option, call: Call) -> dict[str, Any]:
    requested = gpus(option)
    capabilities = [*dict.fromkeys(("gpu", *requested.capabilities))]
    device: dict[str, Any] = {"driver": requested.driver or "nvidia", "capabilities": capabilities}
    if requested.count:
        device["count"] = int(requested.count) if COUNT.fullmatch(requested.count) else requested.count
    if requested.ids:
        device["device_ids"] = [*requested.ids]
    return nested("deploy.resources.reservations.devices", [device])


def _ulimit(option: Option, call: Call) -> dict[str, Any]:
    name, _, limits = (option.value or "").partition("=")
    soft, colon, hard = limits.partition(":")
    return {"ulimits": {name: {"soft": _number(soft), "hard": _number(hard)} if colon else _number(soft)}}


def _number(text: str) -> int | str:
    return int(text) if re.fullmatch("-?[0-9]{1,18}", text) else text


WRITERS: Mapping[str, Callable[[Option, Call], dict[str, Any]]] = {
    "env-file": lambda option, call: {"env_file": [{"path": file(option, call, "."), "format": "raw"}]},
    "gpus": _gpus,
    "label-file": lambda option, call: {"label_file": [file(option, call, ".")]},
    "mount": _mount,
    "network": _network,
    "stop-timeout": lambda option, call: {"stop_grace_period": f"{option.value}s"},
    "ulimit": _ulimit,
    "volume": lambda option, call: {"volumes": [volume(option, call, ".")]},
    "volumes-from": lambda option, call: {"volumes_from": [f"container:{option.value}"]},
}


def _volume_of(mount: str | Mapping[str, Any]) -> str:
    """The name of a mounted volume; empty if it is a folder, or has no name."""
    if not isinstance(mount, str):
        return str(mount.get("source", "")) if mount["type"] == "volume" else ""
    source, colon, _ = mount.partition(":")
    return source if colon and "/" not in source and source != "." else ""


def escaped(content: Any) -> Any:
    """The same with each `$` twice: compose takes one for a variable."""
    if isinstance(content, dict):
        return {key: escaped(value) for key, value in content.items()}
    if isinstance(content, list):
        return [*map(escaped, content)]
    return content.replace("$", "$$") if isinstance(content, str) else content
