"""The network of build steps: their own namespaces behind a bridge, from which their code reaches no service of the machine.

buildkitd makes the namespaces, with plugins and iptables of the system, or of its own image in Docker. It leaves the machine's own
addresses open, such as the bridge's; this module closes them.
"""

from __future__ import annotations

import hashlib
import ipaddress
import os
import shlex
import subprocess
import sys
import tomllib
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from rosml.base import untrusted
from rosml.machine.setup.daemon import wait_until
from rosml.machine.setup.installer import which_system
from rosml.machine.setup.process import output_of

PLUGINS = ("bridge", "firewall", "host-local", "loopback")
FOLDERS = ("/usr/lib/cni", "/opt/cni/bin", "/usr/libexec/cni")
POOL = 4
"""How many namespaces are kept ready, so that steps start as fast as on the machine's network."""
ADDRESSES = Path("/var/lib/cni/networks/buildkit")
RULES = (
    ("filter", "INPUT", "-j REJECT"),
    ("filter", "FORWARD", "-d 169.254.0.0/16 -p tcp ! --dport 53 -j REJECT"),
    ("filter", "FORWARD", "-d 169.254.0.0/16 -p udp ! --dport 53 -j REJECT"),
    ("mangle", "FORWARD", "-p tcp --tcp-flags SYN,RST SYN -j TCPMSS --clamp-mss-to-pmtu"),
)
"""Table, chain and rule for packets from a bridge.

They do not reach the machine itself, nor a service that a cloud gives to this machine alone, apart from its name server. They are no
larger than the machine's own network allows, whose limit may be below a bridge's 1500 bytes.
"""
RESOLVED = "127.0.0.53"
"""The address of systemd-resolved. BuildKit asks that one's servers instead."""
RESOLV = ("/etc/resolv.conf", "/run/systemd/resolve/resolv.conf")

DNS_PROBE = """
import socket, sys
for server in sys.argv[1:] * 2:
    family = socket.AF_INET6 if ":" in server else socket.AF_INET
    with socket.socket(family, socket.SOCK_DGRAM) as probe:
        probe.settimeout(1)
        try:
            probe.connect((server, 53))
            probe.send(b"\\0\\7\\1\\0\\0\\1\\0\\0\\0\\0\\0\\0\\0\\0\\2\\0\\1")
            probe.recv(512)
        except OSError:
            continue
    sys.exit(0)
sys.exit(1)
"""
"""Asks servers for the root's name servers. Ends with 0 if one answers, whatever the answer is."""

SHELL_DNS_PROBE = """
for server in "$@"; do
    answer=$(nslookup -retry=2 -timeout=1 -type=ns . "$server" 2>/dev/null) && exit 0
    case $answer in *"server can't find"*) exit 0 ;; esac
done
exit 1
"""
"""The same with busybox, as BuildKit's image has no Python. "can't find" is an answer."""

IMAGE_PROGRAMS = (*(f"buildkit-cni-{x}" for x in PLUGINS), "ip", "iptables", "iptables-save", "nsenter", "nslookup")
LIST_MISSING = """
for program; do command -v "$program" >/dev/null || echo "$program"; done
echo .
"""
IMAGE_CONFIG = "/etc/buildkit/buildkitd.toml"
IMAGE_NAMESPACES = "/var/lib/buildkit/net/cni"


@dataclass(frozen=True)
class Bridge:
    """The bridge of a checkout. `plugins`: their folder; None for those of BuildKit's image."""

    name: str
    subnet: str
    plugins: Path | None = None

    @classmethod
    def read(cls, config: Path) -> Bridge | None:
        try:
            return cls.parse(config.read_text())
        except OSError:
            return None

    @classmethod
    def parse(cls, text: str) -> Bridge | None:
        try:
            facts = tomllib.loads(text)["worker"]["oci"]
            folder = facts.get("cniBinaryPath")
            return cls(facts["bridgeName"], facts["bridgeSubnet"], Path(folder) if folder else None)
        except (KeyError, ValueError):
            return None

    def lines(self) -> list[str]:
        return [
            '  networkMode = "bridge"',
            f'  bridgeName = "{self.name}"',
            f'  bridgeSubnet = "{self.subnet}"',
            *([f'  cniBinaryPath = "{self.plugins}"'] if self.plugins else []),
            f"  cniPoolSize = {POOL}",
        ]


@dataclass(frozen=True)
class Place:
    """The place of a buildkitd."""

    prefix: tuple[str, ...]  # before a command that runs there, in the machine's network; empty on this machine
    namespaces: str  # their folder, as such a command sees it
    dns_probe: tuple[str, ...]  # takes name servers, and ends with 0 if one of them answers

    @classmethod
    def here(cls, buildkitd: int, namespaces: Path) -> Place:
        """This machine. The mounts of the process `buildkitd` have the namespaces."""
        return cls((), f"/proc/{buildkitd}/root{namespaces}", (sys.executable, "-I", "-c", DNS_PROBE))


@dataclass(frozen=True)
class Container:
    """The container of a builder in Docker, on the network of Docker's machine. `docker` is the client's command for that daemon."""

    docker: tuple[str, ...]
    name: str
    image: str

    @classmethod
    def of(cls, record: Path, image: str) -> Container | None:
        try:
            node = (untrusted.json_object(record.read_bytes()) or {})["Nodes"][0]
            endpoint, name = str(node["Endpoint"]), str(node["Name"])
        except (OSError, ValueError, LookupError, TypeError):
            return None
        where = "--host" if "://" in endpoint else "--context"
        return cls(("docker", where, endpoint), f"buildx_buildkit_{name}", image)

    def inside(self) -> tuple[str, ...]:
        return (*self.docker, "exec", self.name)

    def beside(self, *options: str) -> tuple[str, ...]:
        """The words before a command that runs in another container with the same rights, for as long as the command."""
        rights = ("--rm", "--privileged", "--userns=host", "--network=host", "--pull=never", "--entrypoint=env")
        return (*self.docker, "run", *rights, *options, self.image)

    def place(self) -> Place:
        """The place of its buildkitd, which may have mounts that the container itself does not see."""
        pids = [int(word) for word in output_of([*self.inside(), "pidof", "buildkitd"]).split()]
        namespaces = f"/proc/{min(pids, default=1)}/root{IMAGE_NAMESPACES}"
        return Place(self.inside(), namespaces, ("sh", "-c", SHELL_DNS_PROBE, "sh"))

    def running(self) -> Bridge | None:
        return Bridge.parse(output_of([*self.inside(), "cat", IMAGE_CONFIG]))

    def bridge(self, root: Path) -> Bridge | str:
        """The bridge that it has or can get, or the reason why not."""
        *lacking, end = output_of([*self.inside(), "sh", "-c", LIST_MISSING, "sh", *IMAGE_PROGRAMS]).split() or [""]
        if not end:
            return "as docker cannot enter its container"
        if lacking:
            return f"as its image is without {', '.join(lacking)}"
        self._show_name_servers()
        if not nameservers(self.inside()):
            return "as its name server answers on loopback alone"
        current = self.running() or Bridge(_bridge_name(root), "")
        routes = _routes(current.name, self.inside())
        if current.subnet and not any(ipaddress.IPv4Network(current.subnet).overlaps(route) for route in routes):
            return current
        return Bridge(current.name, _subnet(current.name, routes))

    def _show_name_servers(self) -> None:
        """Writes the servers of systemd-resolved to the file that BuildKit reads: a container does not have it."""
        if nameservers(self.inside(), RESOLV[:1], loopback=True) == [RESOLVED]:
            file = RESOLV[1]
            text = output_of([*self.beside("--mount", f"type=bind,src={file},dst={file},readonly"), "cat", file])
            if text:
                _succeeds(*self.inside(), "sh", "-c", 'mkdir -p "${0%/*}" && printf %s "$1" >"$0"', file, text)


def plugins() -> Path | None:
    return next((Path(name) for name in FOLDERS if all(os.path.exists(f"{name}/{x}") for x in PLUGINS)), None)


def missing_packages() -> dict[str, str]:
    packages = {}
    if not plugins():
        packages["containernetworking-plugins"] = "gives build steps a network of their own"
    if not which_system("iptables"):
        packages["iptables"] = "keeps build steps from what listens on this machine"
    return packages


def bridge(root: Path) -> Bridge | str:
    if lacking := missing_packages():
        return f"without {' and '.join(lacking)}"
    if not nameservers():
        return "as its name server answers on loopback alone"
    folder = plugins()
    assert folder
    name = _bridge_name(root)
    return Bridge(name, _subnet(name, _routes(name)), folder)


def _bridge_name(root: Path) -> str:
    """Linux takes 15 bytes."""
    return f"rosml{hashlib.sha256(os.fsencode(root)).hexdigest()[:8]}"


def _subnet(name: str, routes: Sequence[ipaddress.IPv4Network]) -> str:
    """A subnet of 172.20.0.0/14 that overlaps with no other. A name decides which is tried first."""
    candidates = [*ipaddress.IPv4Network("172.20.0.0/14").subnets(new_prefix=24)]
    first = int(hashlib.sha256(name.encode()).hexdigest(), 16) % len(candidates)
    free = (net for net in candidates[first:] + candidates[:first] if not any(net.overlaps(x) for x in routes))
    return str(next(free, candidates[first]))


def _routes(except_device: str, prefix: Sequence[str] = ()) -> list[ipaddress.IPv4Network]:
    """Networks to which a machine has routes, except by one device; without the default route."""
    networks = []
    for line in _text(prefix, "/proc/net/route").splitlines()[1:]:
        fields = line.split()
        if fields[0] != except_device and int(fields[1], 16):
            address, mask = (ipaddress.IPv4Address(bytes.fromhex(fields[n])[::-1]) for n in (1, 7))
            networks.append(ipaddress.IPv4Network(f"{address}/{mask}"))
    return networks


def nameservers(prefix: Sequence[str] = (), files: Sequence[str] = RESOLV, loopback: bool = False) -> list[str]:
    """The name servers of steps with their own network: those of the machine, without loopback."""
    servers: list[str] = []
    for file in files:
        with suppress(OSError):
            lines = [line.split() for line in _text(prefix, file).splitlines()]
            servers = [words[1] for words in lines if len(words) > 1 and words[0] == "nameserver"]
        if servers != [RESOLVED]:
            break
    return [server for server in servers if loopback or not (server.startswith("127.") or server == "::1")]


def _text(prefix: Sequence[str], file: str) -> str:
    return output_of([*prefix, "cat", file]) if prefix else Path(file).read_text(errors="replace")


def enclose(bridge: Bridge, place: Place, proven: bool = True) -> str:
    """Closes the machine's own addresses to steps, and checks that they reach others. You may call it again.

    Returns why steps cannot have such a network; empty if they can. `proven`: they had it before, so that the check may be skipped if the
    machine itself reaches no name server.
    """
    for table, chain, rule in RULES:
        iptables = [*place.prefix, _program(place.prefix, "iptables"), "-w", "5", "-t", table]
        words = [chain, "-i", bridge.name, *rule.split()]
        if not _succeeds(*iptables, "-C", *words) and not _succeeds(*iptables, "-I", *words):
            return "as iptables refuses a rule"
    # The subnet is of IPv4. Through a link's own IPv6 address steps could still reach the machine. Some have no IPv6.
    switch = f"/proc/sys/net/ipv6/conf/{bridge.name}/disable_ipv6"
    if not _succeeds(*place.prefix, "sh", "-c", '[ ! -e "$0" ] || echo 1 >"$0"', switch):
        return "as IPv6 cannot be turned off for it"
    names: list[str] = []

    def listed() -> bool:
        names[:] = output_of([*place.prefix, "ls", place.namespaces]).split()
        return bool(names)

    if not wait_until(listed, 5.0):
        return "as buildkitd has no namespace for them"
    dns_probe = [*place.dns_probe, *nameservers(place.prefix)]
    if proven and not _succeeds(*place.prefix, *dns_probe):
        return ""
    entering = [(*place.prefix, "nsenter", f"--net={place.namespaces}/{name}") for name in names]
    if not any(_succeeds(*words, *dns_probe) for words in entering):
        return "as they reach no name server from one of their own"
    return ""


def tidy(bridge: Bridge, prefix: Sequence[str] = ()) -> None:
    """Removes the remains of a stopped buildkitd: the bridge, and rules and addresses if it was killed."""
    subnet = ipaddress.IPv4Network(bridge.subnet)
    commands, table = [], ""
    for line in output_of([*prefix, _program(prefix, "iptables-save")]).splitlines():
        if line.startswith("*"):
            table = line[1:]
        words = shlex.split(line) if line.startswith("-A ") else []
        if words and (bridge.name in words or any(_within(word, subnet) for word in words)):
            iptables = [_program(prefix, "iptables"), "-w", "5", "-t", table]
            commands.append([*iptables, "-D", *words[1:]])
            if words[1] == "POSTROUTING":  # it has a chain of the namespace as its target
                commands += [[*iptables, "-F", words[-1]], [*iptables, "-X", words[-1]]]
    if prefix or Path(f"/sys/class/net/{bridge.name}").exists():
        commands.append([_program(prefix, "ip"), "link", "delete", bridge.name])
    if commands:
        output_of([*prefix, "sh", "-c", "; ".join(shlex.join(command) for command in commands)], 60.0)
    for file in ADDRESSES.glob("*") if not prefix else ():
        if _within(file.name, subnet):
            file.unlink(missing_ok=True)


def _within(text: str, subnet: ipaddress.IPv4Network) -> bool:
    try:
        return ipaddress.IPv4Network(text).subnet_of(subnet)
    except ValueError:
        return False


def _program(prefix: Sequence[str], name: str) -> str:
    """The name of a system program there; its path on this machine, whose PATH may lack it."""
    return name if prefix else which_system(name) or name


def _succeeds(*argv: str) -> bool:
    try:
        done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, timeout=20, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0
