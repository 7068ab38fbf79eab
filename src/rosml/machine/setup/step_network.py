"""The network of build steps: namespaces of their own behind a bridge, from which their code reaches no service of the machine.

buildkitd makes the namespaces, with plugins and iptables of the system. What it leaves open is closed here: the machine's
own addresses, such as the bridge's.
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

from rosml.machine.setup.daemon import wait_until
from rosml.machine.setup.installer import which_system
from rosml.machine.setup.process import output_of

PLUGINS = ("bridge", "firewall", "host-local", "loopback")
"""What BuildKit's bridge mode calls."""
FOLDERS = ("/usr/lib/cni", "/opt/cni/bin", "/usr/libexec/cni")
"""Where systems have them."""
POOL = 4
"""Namespaces that are kept ready: a step that takes one starts as fast as on the machine's network."""
ADDRESSES = Path("/var/lib/cni/networks/buildkit")
"""Has a file for each address that is in use."""
RULES = (
    ("filter", "INPUT", "-j REJECT"),
    ("mangle", "FORWARD", "-p tcp --tcp-flags SYN,RST SYN -j TCPMSS --clamp-mss-to-pmtu"),
)
"""Table, chain and rule for what comes from a bridge: no way to the machine itself; and packets no larger than its own network
takes, whose limit may be below a bridge's 1500 bytes."""
RESOLVED = "127.0.0.53"
"""systemd-resolved: BuildKit takes the servers that it asks."""
RESOLV = ("/etc/resolv.conf", "/run/systemd/resolve/resolv.conf")

ASK = """
import socket, sys
for server in sys.argv[1:] * 2:
    family = socket.AF_INET6 if ":" in server else socket.AF_INET
    with socket.socket(family, socket.SOCK_DGRAM) as asking:
        asking.settimeout(1)
        try:
            asking.connect((server, 53))
            asking.send(b"\\0\\7\\1\\0\\0\\1\\0\\0\\0\\0\\0\\0\\0\\0\\2\\0\\1")
            asking.recv(512)
        except OSError:
            continue
    sys.exit(0)
sys.exit(1)
"""
"""Asks servers for the root's name servers; ends with 0 if one answers, whatever it says."""


@dataclass(frozen=True)
class Bridge:
    """A bridge of one checkout. ``plugins``: the folder that has them."""

    name: str
    subnet: str
    plugins: Path

    @classmethod
    def read(cls, config: Path) -> Bridge | None:
        """The one that a buildkitd.toml names."""
        try:
            facts = tomllib.loads(config.read_text())["worker"]["oci"]
            return cls(facts["bridgeName"], facts["bridgeSubnet"], Path(facts["cniBinaryPath"]))
        except (OSError, KeyError, ValueError):
            return None

    def lines(self) -> list[str]:
        """What buildkitd.toml says of it, in the table of its worker."""
        return [
            '  networkMode = "bridge"',
            f'  bridgeName = "{self.name}"',
            f'  bridgeSubnet = "{self.subnet}"',
            f'  cniBinaryPath = "{self.plugins}"',
            f"  cniPoolSize = {POOL}",
        ]


def plugins() -> Path | None:
    """The folder with the plugins, if there is one."""
    return next((Path(name) for name in FOLDERS if all(os.path.exists(f"{name}/{x}") for x in PLUGINS)), None)


def missing_packages() -> dict[str, str]:
    """Debian packages that it needs, and what each is for."""
    packages = {}
    if not plugins():
        packages["containernetworking-plugins"] = "gives build steps a network of their own"
    if not which_system("iptables"):
        packages["iptables"] = "keeps build steps from what listens on this machine"
    return packages


def bridge(root: Path) -> Bridge | str:
    """The bridge of a checkout, or why there can be none."""
    if lacking := missing_packages():
        return f"without {' and '.join(lacking)}"
    if not nameservers():
        return "as its name server answers on loopback alone"
    folder = plugins()
    assert folder
    name = f"rosml{hashlib.sha256(os.fsencode(root)).hexdigest()[:8]}"  # Linux takes 15 bytes
    return Bridge(name, _subnet(name, _routes(name)), folder)


def _subnet(name: str, taken: Sequence[ipaddress.IPv4Network]) -> str:
    """A subnet that overlaps with no other: of 172.20.0.0/14, where a name decides which is tried first."""
    candidates = [*ipaddress.IPv4Network("172.20.0.0/14").subnets(new_prefix=24)]
    first = int(hashlib.sha256(name.encode()).hexdigest(), 16) % len(candidates)
    free = (net for net in candidates[first:] + candidates[:first] if not any(net.overlaps(x) for x in taken))
    return str(next(free, candidates[first]))


def _routes(but: str) -> list[ipaddress.IPv4Network]:
    """Networks that the machine has routes to, but by one device; without the default route."""
    found = []
    for line in Path("/proc/net/route").read_text().splitlines()[1:]:
        device, destination, *_others = fields = line.split()
        if device != but and int(destination, 16):
            address, mask = (ipaddress.IPv4Address(bytes.fromhex(fields[n])[::-1]) for n in (1, 7))
            found.append(ipaddress.IPv4Network(f"{address}/{mask}"))
    return found


def nameservers(files: Sequence[str] = RESOLV) -> list[str]:
    """The servers that steps with a network of their own ask: those of the machine, without loopback."""
    found: list[str] = []
    for file in files:
        with suppress(OSError):
            words = [line.split() for line in Path(file).read_text(errors="replace").splitlines()]
            found = [word[1] for word in words if len(word) > 1 and word[0] == "nameserver"]
        if found != [RESOLVED]:
            break
    return [name for name in found if not name.startswith("127.") and name != "::1"]


def enclose(found: Bridge, buildkitd: int, namespaces: Path) -> str:
    """Closes the machine's own addresses to steps, and tries whether they reach the others. Safe to call again.

    Args:
        buildkitd: its process, in whose mounts the namespaces are. namespaces: their folder.

    Returns:
        Why steps cannot have such a network; empty if they can.
    """
    for table, chain, rule in RULES:
        words = [chain, "-i", found.name, *rule.split()]
        if not _iptables("-t", table, "-C", *words) and not _iptables("-t", table, "-I", *words):
            return "as iptables refuses a rule"
    try:  # the subnet is of IPv4; by a link's own address they would reach the machine all the same
        Path(f"/proc/sys/net/ipv6/conf/{found.name}/disable_ipv6").write_text("1")
    except FileNotFoundError:
        pass  # a machine without IPv6
    except OSError:
        return "as IPv6 cannot be turned off for it"
    inside = Path(f"/proc/{buildkitd}/root{namespaces}")
    wait_until(lambda: any(True for _ in inside.glob("*")), 5.0)
    asking = [sys.executable, "-I", "-c", ASK, *nameservers()]
    try:
        if _succeeds(*asking) and not any(_succeeds("nsenter", f"--net={file}", *asking) for file in inside.iterdir()):
            return "as they reach no name server from one of their own"
    except OSError:
        return "as buildkitd has no namespace for them"
    return ""


def tidy(left: Bridge) -> None:
    """Removes what a buildkitd that has ended left: rules and addresses if it was killed, and the bridge itself."""
    subnet = ipaddress.IPv4Network(left.subnet)
    for table in ("filter", "mangle", "nat"):
        for line in output_of([which_system("iptables") or "iptables", "-w", "5", "-t", table, "-S"]).splitlines():
            words = shlex.split(line)
            if words[0] == "-A" and (left.name in words or any(_within(word, subnet) for word in words)):
                _iptables("-t", table, "-D", *words[1:])
                if words[1] == "POSTROUTING":  # it leads to a chain of the namespace
                    _iptables("-t", table, "-F", words[-1])
                    _iptables("-t", table, "-X", words[-1])
    for file in ADDRESSES.glob("*"):
        if _within(file.name, subnet):
            file.unlink(missing_ok=True)
    if Path(f"/sys/class/net/{left.name}").exists():
        output_of([which_system("ip") or "ip", "link", "delete", left.name])


def _within(text: str, subnet: ipaddress.IPv4Network) -> bool:
    """Whether a text is an address, or a subnet, of this one."""
    try:
        return ipaddress.IPv4Network(text).subnet_of(subnet)
    except ValueError:
        return False


def _iptables(*arguments: str) -> bool:
    return _succeeds(which_system("iptables") or "iptables", "-w", "5", *arguments)


def _succeeds(*argv: str) -> bool:
    """Whether a short command ends well."""
    try:
        done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, timeout=20, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0
