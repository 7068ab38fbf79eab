"""Findings about ROS between a container and others: what works, and remedies for the rest. This module starts nothing."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

from rosml.run.context import Context
from rosml.run.plugins import places
from rosml.run.plugins.places import ALONE, HOST, Place

GOOD, ADVICE, PROBLEM = "good", "advice", "problem"
"""The states of a finding. Advice: something may fail, such as large messages. Problem: something will not work."""

WHOLE = f"--{places.ROS_NETWORK}"
LARGEST_DOMAIN = 232
RANGES = ("SUBNET", "LOCALHOST", "OFF", "SYSTEM_DEFAULT")

MIB = 1024 * 1024
SMALL_MEMORY = 64 * MIB
RECEIVED = "/proc/sys/net/core/rmem_max"
FRAGMENTS, SECONDS = "/proc/sys/net/ipv4/ipfrag_high_thresh", "/proc/sys/net/ipv4/ipfrag_time"
"""The kernel's limits for receive buffers and for fragments of packets (docs.ros.org, DDS tuning information)."""

UP, LOOPBACK, MULTICAST = 0x1, 0x8, 0x1000
"""Flags of a network interface, as the kernel has them."""

OF_ENGINES = ("docker", "br-", "veth", "podman", "cni", "virbr")
MASTER = re.compile(r"https?://(?P<machine>[^:/\s]+):(?P<port>[0-9]{1,5})/?")
ROUTER = 7447


@dataclass(frozen=True)
class Finding:
    """A finding: a fact about a subject, and a remedy unless it is good."""

    subject: str
    state: str
    fact: str
    remedy: str = ""


def findings(context: Context, place: Place, others: Sequence[Place], installed: Sequence[str]) -> list[Finding]:
    """All findings about the container that would start. `installed` are the RMW implementations of its image; empty if unknown."""
    here = places.machine(context)
    if here and here.version != place.version:
        here = None
    of_ros = ros_1(context, place) if place.version == "1" else ros_2(context, place, here, installed)
    return [network(context, place), *of_ros, *(other(place, container) for container in others)]


def network(context: Context, place: Place) -> Finding:
    """Which nodes the container's nodes reach."""
    engine, name, subject = context.engine, place.network, "network"
    if name == HOST:
        if engine.machine == "docker-desktop":
            return Finding(subject, PROBLEM, "that of Docker Desktop's virtual machine", "Docker Engine, on Linux")
        if not context.is_here:
            remedy = f"rosml run --check on {engine.machine} says more"
            return Finding(subject, ADVICE, f"that of {engine.machine}", remedy)
        if engine.rootless and not engine.podman:
            text = "that of docker without root, and not this machine's"
            return Finding(subject, PROBLEM, text, "docker with root, or podman: ROSML_ENGINE=podman")
        return Finding(subject, GOOD, "this machine's")
    if name == "none":
        return Finding(subject, PROBLEM, "none", f"leave out --network none, or {WHOLE}")
    if name.startswith("container:"):
        return Finding(subject, GOOD, f"that of the container {name.partition(':')[2]}")
    if place.middleware == "zenoh" and place.version == "2":
        return Finding(subject, GOOD, f"{name}; nodes reach each other by a router")
    if name == ALONE:
        return Finding(subject, PROBLEM, "its own alone: no others see its nodes", WHOLE)
    if place.version == "2" and place.environment.get("ROS_STATIC_PEERS"):
        text = "containers on it see its nodes, and peers on this machine that have its address in ROS_STATIC_PEERS"
        return Finding(subject, ADVICE, f"{name}: {text}", WHOLE)
    text = "containers on it see its nodes; this machine and others do not"
    return Finding(subject, PROBLEM if name == "bridge" else ADVICE, f"{name}: {text}", WHOLE)


def ros_2(context: Context, place: Place, here: Place | None, installed: Sequence[str]) -> Iterator[Finding]:
    yield domain(place, here)
    yield middleware(place, here, installed)
    if place.middleware == "zenoh":
        yield router(context, place)
        return
    yield discovery_range(context, place)
    if place.shares_memory:
        yield from memory(context, place, here)
    if place.network == HOST and context.is_here and not (context.engine.rootless and not context.engine.podman):
        if place.discovery_range in ("SUBNET", "SYSTEM_DEFAULT") and not place.environment.get("ROS_DISCOVERY_SERVER"):
            yield multicast(context, place)
        yield from buffers(context)


def domain(place: Place, here: Place | None) -> Finding:
    """The domain: both sides need the same."""
    if not _is_domain(place.domain):
        text = f"{_short(place.domain)}: no node starts"
        return Finding("domain", PROBLEM, text, f"ROS_DOMAIN_ID is a number from 0 to {LARGEST_DOMAIN}")
    if here and here.domain != place.domain:
        remedy = f"-e ROS_DOMAIN_ID={here.domain}, or export ROS_DOMAIN_ID={place.domain}"
        return Finding("domain", PROBLEM, f"{place.domain}, and {here.domain} in this shell", remedy)
    return Finding("domain", GOOD, place.domain)


def _is_domain(text: str) -> bool:
    return bool(re.fullmatch("0*[0-9]{1,3}", text)) and int(text[-3:]) <= LARGEST_DOMAIN


def middleware(place: Place, here: Place | None, installed: Sequence[str]) -> Finding:
    """The RMW implementation: the image needs it, and both sides the same."""
    rmw = place.rmw
    if installed and rmw not in installed:
        names = ", ".join(installed)
        text = f"{rmw}, which the image lacks: no node starts"
        return Finding("RMW", PROBLEM, text, f"-e RMW_IMPLEMENTATION=… with one that it has: {names}")
    if here and here.middleware != place.middleware:
        ours = f"export RMW_IMPLEMENTATION={rmw}"
        theirs = "" if installed and here.rmw not in installed else f"-e RMW_IMPLEMENTATION={here.rmw}, or "
        return Finding("RMW", PROBLEM, f"{rmw}, and {here.rmw} in this shell", theirs + ours)
    return Finding("RMW", GOOD, rmw)


def router(context: Context, place: Place) -> Finding:
    """Zenoh's router, through which nodes find each other."""
    override = "ZENOH_CONFIG_OVERRIDE='connect/endpoints=[\"tcp/ROBOT:7447\"]'"
    if any(map(place.environment.get, ("ZENOH_CONFIG_OVERRIDE", "ZENOH_SESSION_CONFIG_URI"))):
        return Finding("router", GOOD, "as Zenoh's settings say")
    if place.network != HOST:
        text = "nodes look for it on localhost, which is the container itself"
        return Finding("router", PROBLEM, text, f"{WHOLE}, or -e {override}")
    if context.is_here and not context.host.connects(("localhost", ROUTER)):
        remedy = f"ros2 run rmw_zenoh_cpp rmw_zenohd, or -e {override}"
        return Finding("router", PROBLEM, f"none answers on port {ROUTER}: no node finds another", remedy)
    return Finding("router", GOOD, f"port {ROUTER}")


def discovery_range(context: Context, place: Place) -> Finding:
    """How far nodes look for others."""
    subject, range_ = "discovery range", place.discovery_range
    local_only = place.environment.get("ROS_LOCALHOST_ONLY") == "1"
    change = "-e ROS_LOCALHOST_ONLY=0" if local_only else "-e ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET"
    if range_ not in RANGES:
        remedy = f"ROS_AUTOMATIC_DISCOVERY_RANGE is one of {', '.join(RANGES)}"
        return Finding(subject, PROBLEM, f"{range_!r} is none", remedy)
    if range_ == "OFF":
        return Finding(subject, PROBLEM, "OFF: no node finds another", change)
    if range_ != "LOCALHOST":
        return Finding(subject, GOOD, range_)
    if not place.joins_another:
        return Finding(subject, PROBLEM, "LOCALHOST, which is the container itself", f"{WHOLE}, or {change}")
    if local_only and place.middleware == "cyclonedds" and not _flags(context, "lo") & MULTICAST:
        text = "ROS_LOCALHOST_ONLY, and Cyclone DDS of older releases needs multicast on lo"
        return Finding(subject, ADVICE, text, "sudo ip link set lo multicast on")
    return Finding(subject, GOOD, "LOCALHOST: this machine alone")


def memory(context: Context, place: Place, here: Place | None) -> Iterator[Finding]:
    """Shared memory, through which Fast DDS hands data to nodes that seem to be on the same machine: whose it is, who may open it, its
    size."""
    if place.joins_another and not place.has_their_memory:
        text = f"its own, with --network {place.network}: nodes find each other, and no data arrives"
        yield Finding("shared memory", PROBLEM, text, places.share(place.network))
    else:
        text = f"--ipc {place.ipc}" if place.joins_another else "its own, as its network is"
        yield Finding("shared memory", GOOD, text)
    is_shared = place.ipc == place.network == HOST and place.uid
    if is_shared and here and here.uid != place.uid:
        remedy = f"--user {here.uid}, or leave out --no-user; or without shared memory: {places.WITHOUT_SHARED_MEMORY}"
        text = f"{place.uid}, and {here.uid} here: not both can open each other's memory"
        yield Finding("user", PROBLEM, text, remedy)
    elif is_shared:
        yield Finding("user", GOOD, place.uid)
    yield size(context, place)


def size(context: Context, place: Place) -> Finding:
    """The size of the shared memory."""
    subject, remedy = places.SHM, "--shm-size 1g"
    if (place.ipc == HOST and not context.is_here) or place.ipc.startswith("container:"):
        return Finding(subject, GOOD, f"that of {context.engine.machine if place.ipc == HOST else place.ipc}")
    if place.ipc == HOST:
        remedy, bytes_ = f"sudo mount -o remount,size=1g {places.SHM}", 0
        with suppress(OSError):
            status = os.statvfs(context.host.path(places.SHM))
            bytes_ = status.f_frsize * status.f_blocks
    elif (bytes_ := _bytes(typed := context.line.value("shm-size"))) < 0:
        return Finding(subject, PROBLEM, f"{_short(typed)} is no size: no container starts", remedy)
    if not bytes_:
        return Finding(subject, GOOD, "of unknown size")
    text = f"{bytes_ // MIB} MiB"
    if bytes_ > SMALL_MEMORY:
        return Finding(subject, GOOD, text)
    return Finding(subject, ADVICE, f"{text}: images and point clouds fill it, and so do PyTorch's workers", remedy)


def _short(text: str) -> str:
    return f"{text[:20]!r}{'…' * (len(text) > 20)}"


def _bytes(text: str) -> int:
    """The bytes of `--shm-size`, such as 512m; 0 for no limit, -1 if the text is no size."""
    if not text:
        return SMALL_MEMORY
    match = re.fullmatch(r"([0-9]{1,15}(?:\.[0-9]{1,15})?) ?([kmgtp]?)i?b?", text.lower())
    return int(float(match[1]) * 1024 ** " kmgtp".index(match[2] or " ")) if match else -1


def multicast(context: Context, place: Place) -> Finding:
    """Whether nodes can announce themselves to the network and to this machine."""
    bad = ADVICE if place.environment.get("ROS_STATIC_PEERS") else PROBLEM
    peers = "name the other machines: -e 'ROS_STATIC_PEERS=ADDRESS;ADDRESS'"
    names = [name.rpartition("/")[2] for name in context.host.files("/sys/class/net")]
    able = [x for x in names if _flags(context, x) & (UP | LOOPBACK | MULTICAST) == UP | MULTICAST]
    leading = [x for x in able if not x.startswith(OF_ENGINES)]
    if not leading:
        text = "no network interface that leads out is up and has it"
        return Finding("multicast", bad, text, f"sudo ip link set NAME up multicast on; or {peers}")
    port = 7400 + 250 * (int(place.domain) if _is_domain(place.domain) else 0)
    if not context.host.echoes(port):
        text = f"a packet to 239.255.0.1, port {port}, does not come back"
        route = f"sudo ip route add 239.0.0.0/8 dev {leading[0]}"
        return Finding("multicast", bad, text, f"let the firewall pass UDP, or set a route: {route}; or {peers}")
    return Finding("multicast", GOOD, f"on {', '.join(leading)}; this machine hears its own")


def _flags(context: Context, interface: str) -> int:
    flags = context.host.text(f"/sys/class/net/{interface}/flags").strip()
    return int(flags, 16) if re.fullmatch("0x[0-9a-f]+", flags) else 0


def buffers(context: Context) -> Iterator[Finding]:
    """The kernel's limits for large messages."""
    limits = [context.host.text(place).strip() for place in (RECEIVED, FRAGMENTS, SECONDS)]
    if not all(re.fullmatch("[0-9]{1,20}", limit) for limit in limits):
        return
    received, fragments, seconds = map(int, limits)
    text = f"net.core.rmem_max={received}"
    if received < 4 * MIB:
        remedy = "sudo sysctl -w net.core.rmem_max=2147483647"
        yield Finding("receive buffer", ADVICE, f"{text}: parts of large messages are lost", remedy)
    else:
        yield Finding("receive buffer", GOOD, text)
    text = f"net.ipv4.ipfrag_time={seconds} net.ipv4.ipfrag_high_thresh={fragments}"
    if seconds > 3 and fragments < 128 * MIB:
        late = "large messages stop for seconds if the network loses packets, as Wi-Fi does"
        remedy = "sudo sysctl -w net.ipv4.ipfrag_time=3 net.ipv4.ipfrag_high_thresh=134217728"
        yield Finding("fragments", ADVICE, f"{text}: {late}", remedy)
    else:
        yield Finding("fragments", GOOD, text)


def ros_1(context: Context, place: Place) -> Iterator[Finding]:
    """The findings of ROS 1: nodes reach the master, and each other by the addresses that they announce."""
    uri = place.environment.get("ROS_MASTER_URI") or "http://localhost:11311"
    address = MASTER.fullmatch(uri)
    if not address:
        remedy = "-e ROS_MASTER_URI=http://ROBOT:11311"
        yield Finding("master", PROBLEM, f"{uri!r} is no address of a master", remedy)
        return
    local = _is_local(address["machine"])
    yield _master(context, place, uri, local, (address["machine"], int(address["port"])))
    if place.network == HOST and context.is_here:
        yield _address(context, place, local)


def _is_local(name: str) -> bool:
    return name == "localhost" or name.startswith("127.")


def _master(context: Context, place: Place, uri: str, local: bool, address: tuple[str, int]) -> Finding:
    if local and not place.joins_another:
        remedy = f"{WHOLE}, or -e ROS_MASTER_URI=http://ROBOT:{address[1]}"
        return Finding("master", PROBLEM, f"{uri}, which is the container itself", remedy)
    if not context.is_here or place.network.startswith("container:") or context.host.connects(address):
        return Finding("master", GOOD, uri)
    if local:
        return Finding("master", ADVICE, f"{uri}: nothing answers there yet", "roscore starts it")
    return Finding("master", PROBLEM, f"{uri}: nothing answers there", f"check the name, and roscore on {address[0]}")


def _address(context: Context, place: Place, local: bool) -> Finding:
    subject, remedy = "address", "-e ROS_IP=ADDRESS with one of this machine's that the others reach"
    variable = next((x for x in ("ROS_HOSTNAME", "ROS_IP") if place.environment.get(x)), "")
    if not variable:
        text = f"{context.host.name}, by which others must find this machine"
        return Finding(subject, GOOD, "this machine's name") if local else Finding(subject, ADVICE, text, remedy)
    text = f"{variable}={place.environment[variable]}"
    if _is_local(place.environment[variable]) and not local:
        return Finding(subject, PROBLEM, f"{text}, which other machines take for themselves", remedy)
    if not context.host.owns(place.environment[variable]):
        return Finding(subject, PROBLEM, f"{text}, which is not this machine", remedy)
    return Finding(subject, GOOD, text)


def other(place: Place, running: Place) -> Finding:
    """Whether the container and another running one reach each other."""
    subject = f"container {running.name}"
    if running.version != place.version:
        remedy = "only a bridge between ROS 1 and ROS 2 connects them"
        return Finding(subject, ADVICE, f"it has ROS {running.version}", remedy)
    apart = [*_apart(place, running)]
    if apart:
        texts, remedies = zip(*apart, strict=True)
        return Finding(subject, PROBLEM, "; ".join(texts), "; ".join(dict.fromkeys(remedies)))
    return Finding(subject, GOOD, "nothing is in the way")


def _apart(place: Place, running: Place) -> Iterator[tuple[str, str]]:
    """The reasons that keep both apart, each with a remedy."""
    if place.version == "1":
        masters = [x.environment.get("ROS_MASTER_URI") or "http://localhost:11311" for x in (place, running)]
        if masters[0] != masters[1]:
            yield f"its master is {masters[1]}", f"-e ROS_MASTER_URI={masters[1]}"
    else:
        if place.domain != running.domain:
            yield f"its domain is {running.domain}", f"-e ROS_DOMAIN_ID={running.domain}"
        if place.middleware != running.middleware:
            yield f"its RMW is {running.rmw}", f"-e RMW_IMPLEMENTATION={running.rmw}, if the image has it"
    if place.middleware == "zenoh" and place.version == "2":
        return
    within = f"container:{running.name}"
    if place.network not in (running.network, within) or place.network in (ALONE, "none"):
        join = "" if running.network in (ALONE, "none", "bridge", HOST) else f"--network {running.network}, or "
        yield f"its network is {running.network}", f"{join}{WHOLE} for both"
    elif place.joins_another and place.shares_memory and running.shares_memory:
        if place.ipc != within and not place.ipc == running.ipc == place.network:
            option = "" if place.has_their_memory else WHOLE
            remedy = f"{option or f'start it with {WHOLE}'}; or without shared memory: {places.WITHOUT_SHARED_MEMORY}"
            yield "it does not have the same shared memory", remedy
        elif place.uid and running.uid and place.uid != running.uid:
            remedy = f"--user {running.uid}; or without shared memory: {places.WITHOUT_SHARED_MEMORY}"
            yield f"its user is {running.uid}", remedy
