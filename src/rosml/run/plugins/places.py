"""Places of ROS nodes: a container that would start, a running one, and this machine. From their settings follows whether
their nodes find each other, and whether data arrives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rosml.run import words
from rosml.run.context import Container, Context

HOST = "host"
ALONE = "private"
SHM = "/dev/shm"
ROS_1_DISTRIBUTIONS = ("indigo", "jade", "kinetic", "lunar", "melodic", "noetic")
WITHOUT_RANGE = ("dashing", "eloquent", "foxy", "galactic", "humble")
"""Distributions of ROS 2 that know only ROS_LOCALHOST_ONLY."""

DEFAULT_RMW = "rmw_fastrtps_cpp"
RMW_LABEL = "io.rosml.rmw"

WITHOUT_SHARED_MEMORY = "-e FASTDDS_BUILTIN_TRANSPORTS=UDPv4"


def share(network: str) -> str:
    """The remedy if nodes on a network would hand over data in a memory that others on it do not have."""
    return f"--ipc {network}; or without shared memory: {WITHOUT_SHARED_MEMORY}"


ROS_NETWORK = "ros-network"
"""rosml's option for this machine's network. The engines take one network."""

OWN_NETWORK = (
    *("network", "net", "publish", "publish-all", "link", "ip", "ip6", "mac-address", "network-alias", "net-alias"),
)


def no_network(context: Context) -> str:
    """Why a container cannot have this machine's network; empty if it can."""
    line, engine = context.line, context.engine
    if engine.rootless and not engine.podman:
        return "docker without root does not reach this machine's network"
    typed = next((option.words[0] for option in line.engine if set(option.names) & {*OWN_NETWORK}), "")
    if typed and (line.values("network", "net") or [""])[-1] != HOST:
        return f"it needs --network host, which does not go with {typed}"
    return ""


@dataclass(frozen=True)
class Place:
    """A place where nodes run."""

    name: str
    environment: Mapping[str, str]
    network: str = HOST  # or `container:…`, a name, or `private`
    ipc: str = HOST
    uid: str = ""  # the owner of its files in shared memory, seen from outside; empty if unknown
    default: str = ""  # the default RMW implementation; empty if unknown

    @property
    def version(self) -> str:
        """1 or 2; empty if there is no ROS."""
        distribution = self.environment.get("ROS_DISTRO", "")
        return self.environment.get("ROS_VERSION") or (
            distribution and ("1" if distribution in ROS_1_DISTRIBUTIONS else "2")
        )

    @property
    def rmw(self) -> str:
        default = "rmw_cyclonedds_cpp" if self.environment.get("ROS_DISTRO") == "galactic" else DEFAULT_RMW
        return self.environment.get("RMW_IMPLEMENTATION") or self.default or default

    @property
    def middleware(self) -> str:
        """The protocol of the RMW implementation, such as `fastrtps`: rmw_fastrtps_cpp and rmw_fastrtps_dynamic_cpp
        understand each other."""
        return self.rmw.removeprefix("rmw_").partition("_")[0]

    @property
    def domain(self) -> str:
        return self.environment.get("ROS_DOMAIN_ID") or "0"

    @property
    def discovery_range(self) -> str:
        """How far nodes of ROS 2 look for others."""
        if self.environment.get("ROS_LOCALHOST_ONLY") == "1":
            return "LOCALHOST"
        if self.environment.get("ROS_DISTRO") in WITHOUT_RANGE:
            return "SUBNET"
        return self.environment.get("ROS_AUTOMATIC_DISCOVERY_RANGE") or "SUBNET"

    @property
    def shares_memory(self) -> bool:
        """Whether nodes hand data to others on the same network through shared memory. Fast DDS does, unless variables turn it
        off; we do not read its settings files."""
        profiles = ("FASTDDS_DEFAULT_PROFILES_FILE", "FASTRTPS_DEFAULT_PROFILES_FILE")
        if any(map(self.environment.get, profiles)) or self.version != "2" or self.middleware != "fastrtps":
            return False
        return not self.environment.get("FASTDDS_BUILTIN_TRANSPORTS", "DEFAULT").startswith("UDP")

    @property
    def joins_another(self) -> bool:
        """Whether its network is the machine's or another container's: to Fast DDS, all nodes on it are on one machine."""
        return self.network == HOST or self.network.startswith("container:")

    @property
    def has_their_memory(self) -> bool:
        """Whether it shares the memory of those whose network it shares."""
        return self.ipc == self.network


def planned(context: Context, argv: Sequence[str]) -> Place:
    """The container that an engine's command `docker run …` would start."""
    line, engine, labels = words.split(argv[2:], ()), context.engine, context.image.labels
    default_network = ALONE if engine.podman and engine.rootless else "bridge"
    network = _network_name((line.values("network", "net") or [default_network])[-1])
    environment = {**context.image.environment, **_variables(context, line)}
    user = environment.get("DOCKER_UID") or line.value("user").partition(":")[0]
    uid = _uid(user or ("0" if "DOCKER_UID" in environment else ""), engine.rootless)
    mounts_memory = any(SHM in mount for mount in line.values("volume", "mount"))
    ipc = HOST if mounts_memory else line.value("ipc") or ALONE
    return Place("the container", environment, network, ipc, uid, labels.get(RMW_LABEL, ""))


def running(container: Container, rootless: bool) -> Place:
    ipc = HOST if SHM in container.mounts else container.ipc
    user = container.environment.get("DOCKER_UID") or container.user.partition(":")[0] or "0"
    network, default = _network_name(container.network), container.labels.get(RMW_LABEL, "")
    return Place(container.name, container.environment, network, ipc, _uid(user, rootless), default)


def _uid(user: str, rootless: bool) -> str:
    """A user's id; empty for a name or without root's rights, which mean another user outside."""
    return user if user.isdecimal() and not rootless else ""


def machine(context: Context) -> Place | None:
    """This machine; None if it has no ROS, or if containers run on another one."""
    host = context.host
    installed = [place.rpartition("/")[2] for place in host.files("/opt/ros")]
    if not context.is_here or not (installed or host.environment.get("ROS_DISTRO")):
        return None
    distribution = {"ROS_DISTRO": installed[-1]} if installed else {}
    return Place("this machine", {**distribution, **host.environment}, uid=str(context.person.uid))


def _network_name(network: str) -> str:
    """The name of a network; docker has two names for the usual one."""
    network = network.removeprefix("name=").partition(",")[0]
    if network.startswith(("pasta", "slirp4netns")) or network == ALONE:
        return ALONE
    return "bridge" if network in ("default", "") or network.startswith("bridge:") else network


def _variables(context: Context, line: words.Line) -> dict[str, str]:
    """The variables that a command sets; those of a file count less. A variable without a value has the caller's."""
    outer, variables = context.host.environment, dict[str, str]()
    files = [context.host.text(f"{context.person.folder}/{x}" if x[:1] != "/" else x) for x in line.values("env-file")]
    entries = [entry for text in files for entry in text.replace("\r\n", "\n").split("\n") if not entry.startswith("#")]
    for entry in [*entries, *line.values("env")]:
        name, equals, value = entry.partition("=")
        if equals or name in outer:
            variables[name] = value if equals else outer[name]
    return variables
