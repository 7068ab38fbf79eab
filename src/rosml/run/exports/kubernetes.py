"""Writes a call as a Deployment of Kubernetes: https://kubernetes.io/docs/reference/kubernetes-api/workload-resources/.

The cluster's machines are others than this one: its GPUs, devices and displays do not count, and a cluster runs containers as root
does. Kubernetes reads `$(…)` in variables and commands, so that `$` is written twice.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import reduce
from typing import Any

from rosml.base.errors import RosmlError
from rosml.run import trust
from rosml.run.context import Context, Engine
from rosml.run.exports import yaml_text
from rosml.run.exports.description import COUNT, Call, Option, fields, gpus, preceded, sessionless
from rosml.run.exports.yaml_text import merged
from rosml.run.plugins.basic_options import FOLDER_LABEL
from rosml.run.plugins.gpu import DRIVER, is_theirs, numbers

KIND = "kubernetes"

NAME_LABEL = "app.kubernetes.io/name"
GPU_RESOURCE = "nvidia.com/gpu"
DROPPED = ("interactive", "name", "tty")
ELSEWHERE = (
    *(*DROPPED, "entrypoint", "no-healthcheck"),
    *("health-cmd", "health-interval", "health-retries", "health-start-period", "health-timeout"),
)
"""Options that have no meaning, or that `content` reads."""

LABEL_NAME = re.compile(
    r"(?=.{1,317}\Z)([a-z0-9]([a-z0-9.-]*[a-z0-9])?/)?[A-Za-z0-9]([A-Za-z0-9_.-]{0,61}[A-Za-z0-9])?"
)
LABEL_VALUE = re.compile("([A-Za-z0-9]([A-Za-z0-9_.-]{0,61}[A-Za-z0-9])?)?")
SIZE = re.compile(r"([0-9]{1,15}(?:\.[0-9]{1,3})?)([bkmgt]?)b?", re.IGNORECASE)
"""A size of memory, as the engines read it: `512m`, `1.5g`."""

PORT = re.compile(
    r"(?:(?P<ip>[0-9.]+|\[[0-9A-Fa-f:]+\]):)?(?P<host>[0-9]{1,5}):(?P<inside>[0-9]{1,5})(?:/(?P<kind>tcp|udp|sctp))?"
)

CLUSTER_DEFAULTS = {"ipc": ("private",), "network": ("bridge", "default"), "restart": ("always", "unless-stopped")}
Fields = dict[str, Any]

HOST_FIELDS = {"ipc": "hostIPC", "network": "hostNetwork", "pid": "hostPID"}


def cluster(context: Context) -> Context:
    """The context of a machine of a cluster."""
    engine, line = Engine("docker", machine=f"a cluster, not {context.host.name}"), context.line
    if numbers(context.image.labels.get(DRIVER, "")) and not line.asks("no-gpu") and not is_theirs(line):
        line = preceded(line, "--gpus", "1")  # the image was made for one
    return sessionless(replace(context, engine=engine, line=line), KIND)


def text(call: Call) -> str:
    document = content(call)
    comments = [f"{call.name} in a cluster. Written by rosml run --export kubernetes; kubectl apply -f FILE"]
    limits = document["spec"]["template"]["spec"]["containers"][0].get("resources", {}).get("limits", {})
    if numbers(call.about.labels.get(DRIVER, "")):
        remedy = "--no-gpu leaves it out" if GPU_RESOURCE in limits else "--gpus 1 asks for it"
        comments.append(f"The image was made for a GPU of NVIDIA's: {remedy}")
    if not _digests(call):
        comments.append("The image has no digest of a registry here, so its tag decides what runs")
    return "".join(f"# {line}.\n" for line in comments) + yaml_text.text(document)


def content(call: Call) -> Fields:
    """The content of the file. An option without a counterpart is an error."""
    name = re.sub("[^a-z0-9]+", "-", call.name.lower()).strip("-")[:63].strip("-") or "container"
    pod: Any = reduce(merged, (_part(option) for option in call.options), {"container": {}})
    container = {"name": name, "image": _image(call), **pod.pop("container")}
    annotations, labels = pod.pop("annotations", {}), {NAME_LABEL: name, **pod.pop("labels", {})}
    entrypoint = call.values("entrypoint")[-1:]
    command = [*filter(None, entrypoint), *call.command]
    if entrypoint and not command:
        text = "--entrypoint '' leaves a cluster nothing to start"
        raise RosmlError(text, "write the command after the image", exit_code=2)
    if command:
        container["command" if entrypoint else "args"] = [*map(_escaped, command)]
    if "env" in container:
        container["env"] = [{"name": key, "value": _escaped(value)} for key, value in container["env"].items()]
    container |= _probe(call)
    mounts = container.pop("mounts", [])
    if mounts:
        container["volumeMounts"] = [{"name": f"volume-{n}", **mount} for n, (mount, _) in enumerate(mounts)]
        pod["volumes"] = [{"name": f"volume-{n}", **source} for n, (_, source) in enumerate(mounts)]
    _check(container, pod)
    metadata = {"labels": labels, **({"annotations": annotations} if annotations else {})}
    return {
        "apiVersion": "apps/v1",
        "kind": "Deployment",
        "metadata": {"name": name, "labels": {NAME_LABEL: name}},
        "spec": {
            "strategy": {"type": "Recreate"},  # two at a time would want the same GPU, ports and names of nodes
            "selector": {"matchLabels": {NAME_LABEL: name}},
            "template": {"metadata": metadata, "spec": {"containers": [container], **pod}},
        },
    }


def _digests(call: Call) -> list[str]:
    """The image's digests in the repository from which it came; the one over all architectures comes first."""
    repository = trust.repository(call.image, call.about.id, podman=False)
    names = [name.partition("@") for name in call.about.digests]
    matching = [digest for name, _, digest in names if trust.repository(name, "", podman=False) == repository]
    return sorted(matching, key=lambda digest: digest == call.about.digest)


def _image(call: Call) -> str:
    """The image, with its digest if that is known."""
    if trust.repository(call.image, call.about.id, podman=False).startswith("sha256:"):
        text = f"{call.image!a} is no name of an image that a cluster can pull"
        raise RosmlError(text, trust.PUSHED, exit_code=2)
    digests = _digests(call)
    return call.image if "@" in call.image or not digests else f"{call.image}@{digests[0]}"


def _escaped(text: str) -> str:
    """A text of which Kubernetes reads `$$` as one `$`. It leaves a `$` alone that begins nothing; podman 4 leaves every one."""
    return re.sub(r"\$(?=[$(])", "$$", text)


def _check(container: Mapping[str, Any], pod: Mapping[str, Any]) -> None:
    """Refuses what a cluster does not take, although an engine does."""
    safety = container.get("securityContext", {})
    strong = safety.get("privileged") or "SYS_ADMIN" in safety.get("capabilities", {}).get("add", [])
    if strong and safety.get("allowPrivilegeEscalation") is False:
        text = "a cluster refuses no-new-privileges together with --privileged or SYS_ADMIN"
        remedy = "--security-opt no-new-privileges=false, or --trust if the image makes users"
        raise RosmlError(text, remedy, exit_code=2)
    if pod.get("hostNetwork") and "hostname" in pod:
        text = "--hostname does not go with this machine's network in a cluster: the name is the machine's"
        raise RosmlError(text, "leave out --hostname", exit_code=2)


def _probe(call: Call) -> Fields:
    """The probe that starts the container again, from --health-cmd or the image's HEALTHCHECK, with the engines' defaults."""
    typed, image = call.value("health-cmd"), call.about.health
    if call.values("no-healthcheck") or typed == "none" or not (typed or image.command):
        return {}
    command = ("/bin/sh", "-c", typed) if typed else image.command

    def seconds(name: str, from_image: float, default: int) -> int:
        option = call.value(f"health-{name}")
        exact = _seconds(name, option) if option else from_image
        return max(1, math.ceil(exact)) if option or from_image else default

    retries = (call.values("health-retries") or ["0"])[-1]
    if not COUNT.fullmatch(retries):
        raise _without(f"--health-retries={retries}", "write --health-retries=NUMBER")
    probe = {
        "exec": {"command": [*command]},
        "periodSeconds": seconds("interval", image.interval, 30),
        "timeoutSeconds": seconds("timeout", image.timeout, 30),
        "failureThreshold": int(retries) or image.retries or 3,
    }
    if start := seconds("start-period", image.start_period, 0):
        probe["initialDelaySeconds"] = start
    return {"livenessProbe": probe}


def _seconds(name: str, duration: str) -> float:
    """A duration such as `1m30s`."""
    parts = re.findall(r"([0-9]{1,9}(?:\.[0-9]{1,9})?)(ms|s|m|h)", duration)
    if not parts or "".join(map("".join, parts)) != duration:
        raise RosmlError(f"--health-{name}={duration} is no duration", "write it such as 1m30s", exit_code=2)
    return sum(float(number) * {"ms": 0.001, "s": 1, "m": 60, "h": 3600}[unit] for number, unit in parts)


def _without(option_text: str, remedy: str) -> RosmlError:
    return RosmlError(f"{option_text} has no counterpart in a file of Kubernetes", remedy, exit_code=2)


def _part(option: Option) -> Fields:
    """The fields that an option adds to a pod, and below `container` those of its container."""
    name, value = option.name, option.value or ""
    if name in ELSEWHERE or value in CLUSTER_DEFAULTS.get(name, ()):
        return {}
    if name in HOST_FIELDS and value == "host":
        return {HOST_FIELDS[name]: True, **({"dnsPolicy": "ClusterFirstWithHostNet"} if name == "network" else {})}
    if name in WRITERS:
        return WRITERS[name](option)
    option_text = f"--{name}={value}" if name in (*HOST_FIELDS, *CLUSTER_DEFAULTS, "device") else f"--{name}"
    raise _without(option_text, REMEDIES.get(name, f"leave out --{name}"))


def _label(option: Option) -> Fields:
    key, _, value = (option.value or "").partition("=")
    if key == FOLDER_LABEL:
        return {}  # of this machine
    fits = option.name == "annotation" or LABEL_VALUE.fullmatch(value)
    if not (fits and LABEL_NAME.fullmatch(key)) or key == NAME_LABEL:
        raise _without(f"--{option.name} {option.value!a}", f"leave out --{option.name}; --annotation takes any value")
    return {f"{option.name}s": {key: value}}


def _container(**values: object) -> Fields:
    return {"container": values}


def _safety(**settings: object) -> Fields:
    return _container(securityContext=settings)


def _pod_safety(**settings: object) -> Fields:
    return {"securityContext": settings}


def _security(option: Option) -> Fields:
    key, _, value = (option.value or "").replace(":", "=", 1).partition("=")
    if key == "no-new-privileges" and value in ("", "true", "false"):
        return _safety(allowPrivilegeEscalation=False) if value != "false" else {}
    profiles = {"seccomp": "seccompProfile", "apparmor": "appArmorProfile"}
    if key in profiles and value == "unconfined":
        return _safety(**{profiles[key]: {"type": "Unconfined"}})
    raise _without(f"--security-opt {option.value}", "leave out --security-opt, and write securityContext by hand")


def _capability(option: Option) -> Fields:
    name = (option.value or "").upper().removeprefix("CAP_")
    if not re.fullmatch("[A-Z][A-Z_]*", name):
        raise _without(f"--{option.name} {option.value!a}", "write a name such as SYS_NICE")
    return _safety(capabilities={option.name.removeprefix("cap-"): [name]})


def _size(option: Option, size: str) -> str:
    """A size of memory in Kubernetes' words."""
    match = SIZE.fullmatch(size)
    if not match or not float(match[1]):
        raise _without(f"--{option.name}={size}", "write a size such as 512m")
    unit = match[2].upper()
    return match[1] + (f"{unit}i" if unit not in ("", "B") else "")


def _gpus(option: Option) -> Fields:
    requested = gpus(option)
    if requested.ids or requested.driver not in ("", "nvidia") or requested.capabilities:
        raise _without(f"--gpus {option.value}", "write --gpus NUMBER: the cluster chooses which")
    if not COUNT.fullmatch(requested.count) or int(requested.count) == 0:
        raise _without(f"--gpus {option.value}", "write --gpus NUMBER: a cluster counts GPUs")
    return _limit(GPU_RESOURCE, str(int(requested.count)))


def _limit(name: str, value: str, kind: str = "limits") -> Fields:
    return _container(resources={kind: {name: value}})


def _port(option: Option) -> Fields:
    match = PORT.fullmatch(option.value or "")
    if not match or not all(0 < int(match[side]) < 2**16 for side in ("host", "inside")):
        raise _without(f"-p {option.value}", "write -p PORT:PORT, the machine's and the container's")
    port: Fields = {"containerPort": int(match["inside"]), "hostPort": int(match["host"])}
    port["protocol"] = (match["kind"] or "tcp").upper()
    if match["ip"]:
        port["hostIP"] = match["ip"].strip("[]")
    return _container(ports=[port])


def _volume(option: Option) -> Fields:
    source, colon, rest = (option.value or "").partition(":")
    target, _, mode = rest.partition(":")
    if not colon or not source.startswith("/"):
        raise _without(f"-v {option.value}", "mount a folder of the machine: -v /FOLDER:/WHERE")
    if not {*filter(None, mode.split(","))} <= {"ro", "rw"}:
        raise _without(f"{mode} of -v {option.value}", "write ro, or leave it out")
    return _mounted(target, {"hostPath": {"path": source}}, "ro" in mode.split(","))


def _mounted(target: str, source: Fields, read_only: bool = False) -> Fields:
    """A mount of a source. A cluster refuses a colon in its path, and a way up in that of the machine."""
    path = source.get("hostPath", {}).get("path", "/")
    if not target.startswith("/") or ":" in target or ".." in path.split("/") or not path.startswith("/"):
        raise _without(f"the mount of {path} at {target!a}", "write whole paths, without a colon and ..")
    return _container(mounts=[({"mountPath": target, **({"readOnly": True} if read_only else {})}, source)])


def _memory(option: Option, target: str, size: str) -> Fields:
    return _mounted(target, {"emptyDir": {"medium": "Memory", **({"sizeLimit": _size(option, size)} if size else {})}})


def _mount(option: Option) -> Fields:
    mount = dict(fields(option))
    kind, target, source = mount.pop("type", "volume"), mount.pop("target", ""), mount.pop("source", "")
    switch = mount.pop("readonly", "false")
    size = mount.pop("tmpfs-size", "") if kind == "tmpfs" else ""
    if kind not in ("bind", "tmpfs") or mount or (kind == "tmpfs" and source):
        raise _without(f"--mount {option.value}", "mount a folder of the machine: -v /FOLDER:/WHERE")
    if kind == "tmpfs":
        return _memory(option, target, size)
    return _mounted(target, {"hostPath": {"path": source}}, Option("", switch or None).is_on)


def _tmpfs(option: Option) -> Fields:
    target, _, options = (option.value or "").partition(":")
    sizes = [part for part in options.split(",") if part not in ("", "rw")]
    if any(not part.startswith("size=") for part in sizes):
        raise _without(f"{options} of --tmpfs", "write size=, or leave it out")
    return _memory(option, target, sizes[-1].removeprefix("size=") if sizes else "")


def _env(option: Option) -> Fields:
    name, equals, value = (option.value or "").partition("=")
    if not equals:
        raise _without(f"-e {name} without a value", f"write -e {name}=VALUE: a cluster has no variables of yours")
    if not re.fullmatch("[A-Za-z_.-][A-Za-z0-9_.-]*", name):  # all releases take these
        raise _without(f"the variable {name!a}", "name it with letters, digits and _")
    return _container(env={name: value})


def _init(option: Option) -> Fields:
    if option.is_on:
        raise _without("--init", "leave out --init; images of ours reap their processes")
    return {}


REMEDIES = {
    "device": "a device plugin of the cluster, or --privileged -v /dev:/dev; GPUs are --gpus NUMBER",
    "env-file": "write -e NAME=VALUE, or leave it out and add a ConfigMap or a Secret to the file",
}

PULLS = {"always": "Always", "missing": "IfNotPresent", "never": "Never"}
DNS_NAME = r"(?=.{1,63}\Z)([a-z0-9]+(?:-[a-z0-9]+)*)"


def _form(pattern: str, remedy: str, fields_of: Callable[[re.Match[str]], Fields]) -> Callable[[Option], Fields]:
    """A writer of an option whose value has a pattern. `remedy` is for another value."""

    def write(option: Option) -> Fields:
        if match := re.fullmatch(pattern, option.value or "", re.DOTALL):
            return fields_of(match)
        raise _without(f"--{option.name} {option.value or ''!a}", remedy)

    return write


WRITERS: Mapping[str, Callable[[Option], Fields]] = {
    "add-host": _form(
        r"([^:=]*)[:=]\[*([0-9A-Fa-f:.]+)\]*",
        "write --add-host NAME:ADDRESS",
        lambda match: {"hostAliases": [{"ip": match[2], "hostnames": [match[1]]}]},
    ),
    "annotation": _label,
    "cap-add": _capability,
    "cap-drop": _capability,
    "cpus": _form(r"(?=.*[1-9])[0-9]{1,4}(\.[0-9]{1,3})?", "write a number such as 1.5", lambda x: _limit("cpu", x[0])),
    "env": _env,
    "gpus": _gpus,
    "group-add": _form(
        "[0-9]{1,18}", "write the group's number", lambda x: _pod_safety(supplementalGroups=[int(x[0])])
    ),
    "hostname": _form(DNS_NAME, "write small letters, digits and -", lambda match: {"hostname": match[0]}),
    "init": _init,
    "label": _label,
    "memory": lambda option: _limit("memory", _size(option, option.value or "")),
    "memory-reservation": lambda option: _limit("memory", _size(option, option.value or ""), "requests"),
    "mount": _mount,
    "platform": _form(
        "linux/([^/]*)",
        "write linux/amd64 or linux/arm64",
        lambda match: {"nodeSelector": {"kubernetes.io/arch": match[1]}},
    ),
    "privileged": lambda option: _safety(privileged=option.is_on),
    "publish": _port,
    "pull": _form(
        "|".join(PULLS), f"write one of {', '.join(PULLS)}", lambda x: _container(imagePullPolicy=PULLS[x[0]])
    ),
    "read-only": lambda option: _safety(readOnlyRootFilesystem=option.is_on),
    "runtime": _form(DNS_NAME, "write the name of a RuntimeClass of the cluster", lambda x: {"runtimeClassName": x[0]}),
    "security-opt": _security,
    "shm-size": lambda option: _memory(option, "/dev/shm", option.value or ""),
    "stop-timeout": _form(
        "[0-9]{1,18}", "write --stop-timeout=NUMBER", lambda match: {"terminationGracePeriodSeconds": int(match[0])}
    ),
    "sysctl": _form(
        "([^=]*)=(.*)", "write --sysctl NAME=VALUE", lambda x: _pod_safety(sysctls=[{"name": x[1], "value": x[2]}])
    ),
    "tmpfs": _tmpfs,
    "user": _form(
        "([0-9]{1,10})(?::([0-9]{1,10}))?",
        "write numbers: --user UID:GID",
        lambda match: _safety(runAsUser=int(match[1]), **({"runAsGroup": int(match[2])} if match[2] else {})),
    ),
    "volume": _volume,
    "workdir": lambda option: _container(workingDir=option.value or ""),
}
