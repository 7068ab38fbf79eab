"""ROS in a container: the settings of this machine's ROS, and a network in which nodes reach others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rosml.base.errors import RosmlError
from rosml.run.context import Context
from rosml.run.plugin import Added, Plugin
from rosml.run.plugins import places
from rosml.run.plugins.places import OWN_NETWORK, ROS_NETWORK, no_network
from rosml.run.words import variables

ANYWHERE = {"1": ("ROS_MASTER_URI",), "2": ("ROS_DOMAIN_ID", "ROS_STATIC_PEERS")}
ON_THE_NETWORK = {
    "1": ("ROS_IP", "ROS_HOSTNAME"),
    "2": ("ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_LOCALHOST_ONLY", "ROS_DISCOVERY_SERVER"),
}
"""Variables that name this machine or its addresses. On another network they would mean the container itself."""

ON_REQUEST = ("RMW_IMPLEMENTATION",)
"""Variables for calls with --ros-network only: if the image lacks that implementation, no node starts."""


def ros(context: Context) -> Added:
    """The words that connect ROS in the container with that of this machine."""
    line = context.line
    words = _network(context) if line.asks(ROS_NETWORK) else []
    planned = places.planned(context, [context.engine.program, "run", *words, *line.engine_words, line.image])
    if not line.asks("no-ros"):
        words += _own_name(context, planned)
        words += variables(_settings(context, planned))
    if planned.shares_memory and planned.joins_another and not planned.has_their_memory:
        text = f"--network {planned.network} without its shared memory: nodes find each other, and no data arrives"
        return Added(words, notes=[(text, places.share(planned.network))])
    return Added(words)


def _network(context: Context) -> list[str]:
    """This machine's network and shared memory; the user may have typed one of them."""
    line = context.line
    if reason := no_network(context):
        remedy = "--network host --ipc host reaches containers of the same docker"
        if not context.engine.rootless or context.engine.podman:
            remedy = "leave out one of them; on this machine's network, no port needs -p"
        raise RosmlError(f"--{ROS_NETWORK}: {reason}", remedy, exit_code=2)
    network = [] if line.has(*OWN_NETWORK) else ["--network", "host"]
    return [*network, *([] if line.has("ipc") else ["--ipc", "host"])]


def _own_name(context: Context, planned: places.Place) -> list[str]:
    """The machine's name as an address, if its /etc/hosts, which docker copies, lacks it: systemd resolves it there, but in no
    image. Nodes of ROS 1 announce themselves by that name. podman writes it by itself."""
    name, hosts = context.host.name, context.host.text("/etc/hosts")
    needs_name = (
        planned.version == "1" and planned.network == places.HOST and context.is_here and not context.engine.podman
    )
    has_name = not hosts or name in hosts.split() or context.line.has("add-host", "hostname", "uts")
    return ["--add-host", f"{name}:127.0.0.1"] if needs_name and name and not has_name else []


def _settings(context: Context, planned: places.Place) -> Mapping[str, str]:
    """The variables to pass: those for the image's version of ROS that are set here."""
    version, here = planned.version, context.is_here and planned.network == places.HOST
    names: Sequence[str] = (*ANYWHERE.get(version, ()), *(ON_THE_NETWORK.get(version, ()) if here else ()))
    if version == "2" and context.line.asks(ROS_NETWORK):
        names = (*names, *ON_REQUEST)
    return {name: value for name in names if (value := context.host.environment.get(name))}


PLUGIN = Plugin(
    "ros",
    ros,
    {
        "no-ros": "not your settings of ROS, such as ROS_DOMAIN_ID",
        ROS_NETWORK: "this machine's network and shared memory: nodes reach those of other containers and machines",
    },
)
