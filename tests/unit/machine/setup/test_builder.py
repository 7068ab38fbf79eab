"""The builder: which one setup chooses, how it starts and stops, and the network of its steps."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import sys
import tomllib
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import ROOT

from fakes.setups import new_state, program, services_of
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version
from rosml.machine import buildx as buildx_of
from rosml.machine import docker as docker_module
from rosml.machine.docker import Docker
from rosml.machine.services import Services
from rosml.machine.setup import builder, fitness, services, step_network, tools
from rosml.machine.setup.builder_cache import CacheLimits
from rosml.machine.setup.daemon import Daemon
from rosml.machine.setup.installer import Installer
from rosml.machine.setup.state import State
from rosml.registry import oci
from rosml.registry.client import Registry

IMAGE = "moby/buildkit:v0.29.0"


@pytest.fixture
def state(tmp_path: Path) -> State:
    return new_state(tmp_path)


DENIED = Docker("Docker does not let you in: permission denied", "sudo usermod")
LOCAL = fitness.Unreached("connection refused")


@pytest.mark.parametrize(
    ("has", "kind"),
    [
        ({"docker", "store"}, "engine"),
        ({"docker", "store", "hub", "container"}, "docker"),  # its cache counts
        ({"docker", "store", "hub", "unfit"}, "docker"),
        ({"docker", "store", "hub", "BUILDX_BUILDER"}, "docker"),
        ({"docker", "hub"}, "docker"),
        ({"docker", "image"}, "docker"),
        ({"docker", "root"}, "buildkitd"),  # Docker could not pull BuildKit
        ({"docker", "store", "hub", "root", "elsewhere"}, "buildkitd"),
        ({"docker", "store", "hub", "root", "unreached"}, "buildkitd"),
        ({"hub", "root"}, "buildkitd"),
        ({"hub"}, "needs root: Docker is not installed; install it; or call this as root"),
        ({"hub", "denied"}, "needs root: Docker does not let you in: permission denied; sudo usermod; or call"),
        (
            {"docker", "store", "hub", "elsewhere"},
            "needs root: Docker is on another machine, robot, .*unset DOCKER_HOST",
        ),
        (
            {"docker", "store", "hub", "unreached"},
            "needs root: Docker does not reach the local registry.*; take a Docker",
        ),
        (
            {"docker", "store", "hub", "unreached", "rootless"},
            "does not reach the local registry.*update it to Docker 29",
        ),
        ({"docker", "store", "hub", "both unfit"}, "needs root: it crashes; call this as root"),
        ({"docker"}, "and Docker has no moby/buildkit:v1.*; or do without that image: .*containerd-snapshotter"),
        ({"docker", "store", "unfit"}, "docker pull moby/buildkit:v1$"),
    ],
)
def test_choice_of_the_builder(state: State, monkeypatch: pytest.MonkeyPatch, has: set[str], kind: str) -> None:
    monkeypatch.setenv("BUILDX_BUILDER", "rosml" if "BUILDX_BUILDER" in has else "")
    answers = {"context show": "desktop\n"}
    monkeypatch.setattr(tools, "_docker", lambda installer, *words: answers.get(" ".join(words), ""))
    if "container" in has:
        (state.run / "buildkitd-docker.toml").write_text("")
    monkeypatch.setattr(tools, "docker_has_buildkit", lambda installer: "image" in has)
    monkeypatch.setattr(tools, "buildkit_image", lambda state: "moby/buildkit:v1")
    monkeypatch.setattr(os, "geteuid", lambda: 0 if "root" in has else 1000)
    installer = Installer(state)
    machine = "robot" if "elsewhere" in has else os.uname().nodename
    installer.docker = DENIED if "denied" in has else docker_module.ask("")
    if "docker" in has:
        installer.docker = Docker(machine=machine, containerd_store="store" in has, rootless="rootless" in has)
    unfit = {"engine": fitness.Unfit("it is too old")} if {"unfit", "both unfit"} & has else {}
    unfit |= {"engine": LOCAL} if "unreached" in has else {}
    unfit |= {"docker": fitness.Unfit("it crashes")} if "both unfit" in has else {}
    if " " not in kind:
        choice = tools.choose_builder(installer, "hub" in has, unfit)
        assert choice[:2] == (kind, "desktop" if kind == "engine" else "rosml")
        assert bool(choice.no_engine) == (kind != "engine") and ("unfit" in has) == ("too old" in choice.no_engine)
    else:
        with pytest.raises(RosmlError) as caught:
            tools.choose_builder(installer, "hub" in has, unfit)
        assert re.search(kind, f"{caught.value.message}; {caught.value.remedy}")
    monkeypatch.setenv("BUILDX_BUILDER", "mine")
    assert tools.choose_builder(installer, "hub" in has) == ("user", "mine", "")
    answers["context inspect mine"] = "[{}]"  # Docker's client alone may say so: it may have no buildx
    assert tools.choose_builder(installer, "hub" in has) == ("engine", "mine", "")


def test_buildkit_in_docker_is_of_the_pinned_release() -> None:
    version = re.escape(pinned_version(ROOT, "buildkitd", RosmlError))
    assert re.fullmatch(rf"moby/buildkit:v{version}@sha256:[0-9a-f]{{64}}", tools.buildkit_image(State(ROOT)))


# ---- Configuration ---------------------------------------------------------------------------------------------------

PATHS = {"root": '/r "x"', "socket": "/s", "otel": "/o", "runc": "/usr/sbin/runc"}


def test_config_of_our_own_buildkitd(tmp_path: Path) -> None:
    toml = tomllib.loads(builder.config("127.0.0.1:5001", True, PATHS))
    assert toml["root"] == '/r "x"'
    assert toml["grpc"]["address"] == ["unix:///s"]
    assert toml["registry"]["docker.io"]["mirrors"] == ["127.0.0.1:5001"]
    assert toml["registry"]["127.0.0.1:5001"] == {"http": True, "insecure": True}
    assert toml["worker"]["oci"]["gcpolicy"] == [{"all": True, "maxUsedSpace": "40GB", "minFreeSpace": "12GB"}]
    assert toml["worker"]["oci"]["networkMode"] == "host"
    bridge = step_network.Bridge("rosml1", "172.20.3.0/24", Path("/plugins"))
    (tmp_path / "buildkitd.toml").write_text(builder.config("127.0.0.1:5001", False, PATHS, bridge=bridge))
    assert step_network.Bridge.read(tmp_path / "buildkitd.toml") == bridge


def test_config_of_a_builder_in_docker(tmp_path: Path) -> None:
    certificate = tmp_path / "ca.crt"
    certificate.write_text("one")
    trusted = {"reg.example:5000": [certificate], "127.0.0.1:5001": [Path("ours")], "docker.io": [Path("mirror")]}
    text = builder.config("127.0.0.1:5001", False, None, trusted)
    assert tomllib.loads(text)["registry"] == {
        "127.0.0.1:5001": {"http": True, "insecure": True},
        "reg.example:5000": {"http": False, "ca": [str(certificate)]},
    }
    assert "root" not in tomllib.loads(text)
    certificate.write_text("another")
    assert builder.config("127.0.0.1:5001", False, None, trusted) != text, "a builder in Docker has copies"


@pytest.mark.parametrize(
    ("free", "available", "limits"),
    [
        (500, 500, (40, 12)),
        (60, 60, (30, 12)),
        (15, 15, (20, 12)),
        (110, 60, (30, 62)),  # 50 GB that only root may use: BuildKit counts them as free
    ],
)
def test_the_cache_leaves_half_of_the_disk_to_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, free: int, available: int, limits: tuple[int, int]
) -> None:
    """Once: what others take later starts no builder again."""
    size = {"f_frsize": 1_000_000_000, "f_bfree": free, "f_bavail": available}
    monkeypatch.setattr(os, "statvfs", lambda _: SimpleNamespace(**size))
    file = tmp_path / "buildkitd.toml"
    first = CacheLimits.kept(file, tmp_path)
    assert (first.used, first.free) == limits
    file.write_text(builder.config("127.0.0.1:5001", False, limits=first))
    size |= {"f_bfree": 10, "f_bavail": 10}
    assert CacheLimits.kept(file, tmp_path) == first


# ---- The network of steps --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("texts", "servers"),
    [
        (["nameserver 10.0.0.1\nsearch x\nnameserver 127.0.0.1\n", "nameserver 10.0.0.2"], ["10.0.0.1"]),
        (["nameserver 127.0.0.53\noptions edns0\n", "nameserver 10.0.0.2"], ["10.0.0.2"]),
        (["nameserver 127.0.0.53\n"], []),
        (["nameserver 127.0.0.1\nnameserver ::1", "nameserver 10.0.0.2"], []),
    ],
)
def test_name_servers_of_steps(tmp_path: Path, texts: list[str], servers: list[str]) -> None:
    """As BuildKit has them; without any, steps would ask Google's."""
    for number, text in enumerate(texts):
        (tmp_path / str(number)).write_text(text)
    assert step_network.nameservers(files=[str(tmp_path / str(number)) for number in range(2)]) == servers


def test_steps_get_a_subnet_that_the_machine_has_no_route_to(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(step_network, "missing_packages", dict)
    monkeypatch.setattr(step_network, "plugins", lambda: Path("/plugins"))
    monkeypatch.setattr(step_network, "nameservers", lambda: ["10.0.0.1"])
    routes = "Iface Destination Gateway Flags RefCnt Use Metric Mask\neth0 00000000 0 0 0 0 0 00000000\n"
    monkeypatch.setattr(Path, "read_text", lambda self, errors="": routes)
    first = step_network.bridge(Path("/checkout"))
    assert isinstance(first, step_network.Bridge) and first != step_network.bridge(Path("/other"))
    assert len(first.name) < 16 and step_network.bridge(Path("/checkout")) == first
    route = bytes(map(int, first.subnet.split("/")[0].split(".")))[::-1].hex()
    routes += f"{first.name} {route} 0 0 0 0 0 00FFFFFF\n"
    assert step_network.bridge(Path("/checkout")) == first, "it has its own already"
    routes += f"tun0 {route} 0 0 0 0 0 00FFFFFF\n"
    other = step_network.bridge(Path("/checkout"))
    assert isinstance(other, step_network.Bridge) and other.subnet != first.subnet


@pytest.mark.parametrize(
    "why", ["without iptables", "as buildkitd does not start with a bridge", "as it reaches nothing"]
)
def test_a_builder_whose_steps_get_no_network_of_their_own_says_so(
    state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], why: str
) -> None:
    """What was tried is not tried again while the builder runs: a set-up ends no build."""
    bridge = step_network.Bridge("rosml-none", "192.0.2.0/24", state.root)
    monkeypatch.setattr(step_network, "bridge", lambda root: why if "without" in why else bridge)
    monkeypatch.setattr(step_network, "tidy", lambda bridge: None)
    monkeypatch.setattr(step_network, "enclose", lambda *_: why)
    monkeypatch.setattr(builder, "START_SECONDS", 1)
    ends = "'mode = \"bridge\"' in open(sys.argv[2]).read().lower()" if "start" in why else "False"
    file = state.run / "buildkitd.toml"
    command = (sys.executable, "-c", f"import sys, time; {ends} or time.sleep(60)", "--config", str(file))
    daemon = Daemon(state, "buildkitd", command, file, os.environ)
    monkeypatch.setattr(builder, "daemon", lambda state: daemon)
    for event in ("started buildkitd", "buildkitd runs"):
        builder.up(state, services_of(state, "buildkitd", str(buildx)), "")
        output = capsys.readouterr().out
        assert event in output and f"{builder.SHARED}, {why}" in output
    assert builder.stop(state) and not (state.run / "shared-network").exists()


@pytest.fixture
def buildx(state: State, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(fitness, "require", lambda _: None)
    return program(
        state.root / "fake",
        "buildx",
        f"""echo "$@" >>{state.root}/calls
case $1 in
  inspect) if [ -e {state.root}/broken ]; then echo no connection >&2; exit 1; fi; printf 'Name: rosml\\nStatus: running\\n' ;;
  create) mkdir -p "$BUILDX_CONFIG/instances" && echo '{RECORD}' >"$BUILDX_CONFIG/instances/$3"
    if grep -q '"bridge"' "$9" && [ -e {state.root}/crashes ]; then touch {state.root}/broken; else rm -f {state.root}/broken; fi
    [ "$5" != docker-container ] || cp "$9" {state.root}/container.toml ;;
esac""",
    )


RECORD = '{"Nodes": [{"Name": "rosml0", "Endpoint": "unix:///docker.sock"}]}'
ROUTES = "Iface Destination Gateway Flags RefCnt Use Metric Mask\neth0 00000000 0 0 0 0 0 00000000\n"
RULES = """*filter
-A INPUT -i NAME -j REJECT --reject-with icmp-port-unreachable
-A INPUT -i another -j REJECT
-A CNI-FORWARD -s NET.2/32 -j ACCEPT
*nat
-A POSTROUTING -s NET.2/32 -m comment --comment "name: \\"buildkit\\"" -j CNI-0123
"""


@pytest.fixture
def docker(state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    root = state.root
    for name, text in {"lacking": "", "resolv": "nameserver 10.0.0.1\n", "routes": ROUTES, "rules": RULES}.items():
        (root / name).write_text(text)
    text = f"""echo "$@" >>{root}/docker-calls
[ "$1 $2" = "--host unix:///docker.sock" ] || exit 1
case "$3 $4 $*" in
  *"cat /proc/net/route") cat {root}/routes ;;
  *"cat /etc/resolv.conf") cat {root}/resolv ;;
  *"cat /etc/buildkit/buildkitd.toml") cat {root}/container.toml ;;
  "run "*"src=/run/systemd/resolve/resolv.conf"*) echo nameserver 10.0.0.9 ;;
  exec*"cat /run/systemd/resolve/resolv.conf") sed -n 's/^shown //p' {root}/shown ;;
  *"mkdir -p"*) printf 'shown %s' "$9" >{root}/shown ;;
  *command*) cat {root}/lacking; echo . ;;
  *pidof*) echo 31 7 ;;
  *" ls /proc/7/root/var/lib/buildkit/net/cni") echo abc ;;
  *iptables-save) cat {root}/rules ;;
  *"iptables "*" -C "*) exit 1 ;;
  *"iptables "*" -I "*) [ ! -e {root}/refused ] ;;
  *nsenter*) [ ! -e {root}/mute ] && [ ! -e {root}/offline ] ;;
  *nslookup*) [ ! -e {root}/offline ] ;;
esac"""
    program(root / "client", "docker", text)
    monkeypatch.setenv("PATH", f"{root}/client:{os.environ['PATH']}")
    return root / "docker-calls"


def up(state: State, buildx: Path, capsys: pytest.CaptureFixture[str]) -> str:
    builder.up(state, services_of(state, "docker", str(buildx)), IMAGE)
    return capsys.readouterr().out


def test_steps_of_a_builder_in_docker_get_a_network_of_their_own(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert builder.SHARED not in up(state, buildx, capsys)
    toml = tomllib.loads((state.root / "container.toml").read_text())
    facts = toml["worker"]["oci"]
    assert facts["networkMode"] == "bridge" and "cniBinaryPath" not in facts, "BuildKit's image has the plugins"
    assert toml["insecure-entitlements"] == ["network.host"]
    assert "restart-policy=no" in (state.root / "calls").read_text(), "nothing would set the rules then"
    name = facts["bridgeName"]
    inside = "--host unix:///docker.sock exec buildx_buildkit_rosml0"
    called = docker.read_text()
    assert f"{inside} iptables -w 5 -t filter -I INPUT -i {name} -j REJECT\n" in called
    assert f"{inside} iptables -w 5 -t mangle -I FORWARD -i {name} -p tcp" in called
    assert f"/proc/sys/net/ipv6/conf/{name}/disable_ipv6\n" in called
    assert f"{inside} nsenter --net=/proc/7/root/var/lib/buildkit/net/cni/abc sh -c" in called
    assert "sh 10.0.0.1" in called
    docker.unlink()
    (state.root / "calls").unlink()
    up(state, buildx, capsys)
    assert (state.root / "calls").read_text().splitlines() == ["inspect --bootstrap rosml", "inspect rosml"]
    assert f"-I INPUT -i {name} -j REJECT" in docker.read_text(), "rules do not outlive the machine"
    (state.root / "offline").touch()
    assert builder.SHARED not in up(state, buildx, capsys), "nothing says that it is the bridge"


def test_a_builder_in_docker_is_stopped_with_its_bridge(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    up(state, buildx, capsys)
    bridge = step_network.Bridge.read(state.root / "container.toml")
    assert bridge
    name, net = bridge.name, bridge.subnet.removesuffix(".0/24")
    (state.root / "rules").write_text(RULES.replace("NAME", name).replace("NET", net))
    docker.unlink()
    services_of(state, "docker", str(buildx)).save()
    assert services.down(state) == ["builder in Docker"]
    beside = "run --rm --privileged --userns=host --network=host --pull=never --entrypoint=env moby/buildkit:v0.29.0"
    *_, tidied = docker.read_text().splitlines()
    assert tidied == f"--host unix:///docker.sock {beside} sh -c " + "; ".join(
        [
            f"iptables -w 5 -t filter -D INPUT -i {name} -j REJECT --reject-with icmp-port-unreachable",
            f"iptables -w 5 -t filter -D CNI-FORWARD -s {net}.2/32 -j ACCEPT",
            f"iptables -w 5 -t nat -D POSTROUTING -s {net}.2/32 -m comment --comment 'name: \"buildkit\"' -j CNI-0123",
            "iptables -w 5 -t nat -F CNI-0123",
            "iptables -w 5 -t nat -X CNI-0123",
            f"ip link delete {name}",
        ]
    )


SERVERS = "as they reach no name server from one of their own"
WHY = {
    "lacking": "as its image is without iptables, nslookup",
    "resolv": "as its name server answers on loopback alone",
    "refused": "as iptables refuses a rule",
    "mute": SERVERS,
    "offline": SERVERS,
    "crashes": "as it does not start with a bridge",
    "client/docker": "as docker cannot enter its container",
}
TEXTS = {"lacking": "iptables\nnslookup\n", "resolv": "nameserver 127.0.0.1\n", "client/docker": "#!/bin/sh\nexit 1\n"}


@pytest.mark.parametrize("file", WHY)
def test_a_builder_in_docker_whose_steps_get_none_is_as_before(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str], file: str
) -> None:
    """What was tried is not tried again until it is made anew, or stopped."""
    (state.root / file).write_text(TEXTS.get(file, ""))
    why = WHY[file]
    line = f"builder: {builder.SHARED}, {why}\n"
    assert line in up(state, buildx, capsys)
    limits = CacheLimits.kept(state.root / "container.toml", state.root)
    assert (state.root / "container.toml").read_text() == "# moby/buildkit:v0.29.0\n" + builder.config(
        "127.0.0.1:5001", False, limits=limits
    )
    assert "restart-policy" not in (state.root / "calls").read_text().splitlines()[-2]
    docker.unlink(missing_ok=True)
    assert line in up(state, buildx, capsys)
    assert not docker.exists()
    services_of(state, "docker", str(buildx)).save()
    services.down(state)
    for name in ("refused", "mute", "offline", "crashes", "broken"):
        (state.root / name).unlink(missing_ok=True)
    output = up(state, buildx, capsys)
    assert (line in output) == (file not in ("refused", "mute", "offline", "crashes"))


def test_steps_in_docker_ask_the_servers_of_systemd_resolved(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its own file is not in a container."""
    (state.root / "resolv").write_text("nameserver 127.0.0.53\n")
    assert builder.SHARED not in up(state, buildx, capsys)
    assert (state.root / "shown").read_text().strip() == "shown nameserver 10.0.0.9"
    assert "nsenter" in (called := docker.read_text()) and "sh 10.0.0.9\n" in called


def test_a_bridge_in_docker_moves_if_another_network_takes_its_subnet(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    up(state, buildx, capsys)
    first = step_network.Bridge.read(state.root / "container.toml")
    assert first
    route = bytes(map(int, first.subnet.split("/")[0].split(".")))[::-1].hex()
    (state.root / "routes").write_text(f"{ROUTES}br-0 {route} 0 0 0 0 0 00FFFFFF\n")
    assert builder.SHARED not in up(state, buildx, capsys)
    second = step_network.Bridge.read(state.root / "container.toml")
    assert second and second.name == first.name and second.subnet != first.subnet


# ---- Start and stop --------------------------------------------------------------------------------------------------


def test_builder_in_docker(state: State, buildx: Path) -> None:
    docker = services_of(state, "docker", str(buildx))
    other = services_of(state, "docker", str(buildx), "127.0.0.1:5002")
    calls = state.root / "calls"
    builder.up(state, docker, IMAGE)
    assert calls.read_text().splitlines() == [
        "rm --force --keep-state rosml",
        "create --name rosml --driver docker-container --driver-opt network=host,image=moby/buildkit:v0.29.0"
        f" --buildkitd-config {state.run}/buildkitd-docker.new.toml",
        "inspect --bootstrap rosml",
    ]
    calls.unlink()
    builder.up(state, docker, IMAGE)
    assert calls.read_text().splitlines() == ["inspect --bootstrap rosml"]
    builder.up(state, other, IMAGE)
    assert "create" in calls.read_text(), "a new port of the registry needs a new configuration"
    (state.root / "broken").touch()
    with pytest.raises(RosmlError, match="no connection"):
        builder.up(state, other, IMAGE)


@pytest.mark.parametrize("fails", ["start", "trial"])
def test_a_first_builder_in_docker_that_cannot_build_is_not_kept(
    state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch, fails: str
) -> None:
    """If it were, the next setup would take it, although another builder may be better by then."""

    def unfit(_: Services) -> None:
        raise fitness.Unreached("connection refused")

    working = buildx.read_text()
    if fails == "start":
        buildx.write_text(working.replace("rm -f", "touch"))
    monkeypatch.setattr(fitness, "require", unfit)
    docker = services_of(state, "docker", str(buildx))
    with pytest.raises(RosmlError, match="no connection" if fails == "start" else "connection refused"):
        builder.up(state, docker, IMAGE)
    assert not builder.in_container(state)
    assert (state.root / "calls").read_text().splitlines()[-1] == "stop rosml"
    buildx.write_text(working)
    monkeypatch.setattr(fitness, "require", lambda _: None)
    builder.up(state, docker, IMAGE)
    assert builder.in_container(state)
    monkeypatch.setattr(fitness, "require", unfit)
    builder.up(state, docker, IMAGE)  # it has a cache by now, and no trial may take it away


def test_builder_in_docker_is_stopped(state: State, buildx: Path) -> None:
    for remove, action in ((False, "stop rosml"), (True, "rm --force rosml")):
        services_of(state, "docker", str(buildx)).save()
        assert services.down(state, remove) == ["builder in Docker"]
        assert (state.root / "calls").read_text().splitlines()[-1] == action
        assert not (state.folder / "services.json").exists()


def test_what_was_stopped_before_is_removed_too(state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`down`, and then `clean`; or `clean` after a setup that took another builder."""
    monkeypatch.setattr(fitness, "require", lambda _: None)
    monkeypatch.setattr(tools, "buildx_of", lambda _: (str(buildx),))
    docker = services_of(state, "docker", str(buildx))
    builder.up(state, docker, IMAGE)
    docker.save()
    assert services.down(state) == ["builder in Docker"] and services.down(state) == []
    assert services.down(state, remove=True) == ["builder in Docker"]
    assert (state.root / "calls").read_text().splitlines()[-1] == "rm --force rosml"


def test_builder_of_the_user(state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("BUILDX_CONFIG", raising=False)
    user = services_of(state, "user", str(buildx))
    monkeypatch.setattr(fitness, "require", lambda _: None)
    builder.up(state, user, "")
    assert (state.root / "calls").read_text() == "inspect --bootstrap rosml\n"

    def unfit(_: Services) -> None:
        raise fitness.Unfit("connection refused")

    monkeypatch.setattr(fitness, "require", unfit)
    lines: list[str] = []
    builder.up(replace(state, say=lines.append), user, "")  # a builder in a cluster pushes elsewhere
    assert any("connection refused" in line for line in lines)
    (state.root / "broken").touch()
    with pytest.raises(RosmlError, match="BUILDX_BUILDER=rosml") as caught:
        builder.up(state, user, "")
    assert "unset BUILDX_BUILDER" in caught.value.remedy


@pytest.mark.parametrize(
    ("kind", "output", "layer", "reason"),
    [
        ("engine", "name={}:building-fit,push=true,store=false", "zstd", ""),
        ("user", "name={},push=true,push-by-digest=true", "zstd", ""),
        ("engine", "name={}:building-fit,push=true,store=false", "gzip", "pushes no layers with zstd"),
        ("engine", "", "", "not implemented"),
    ],
)
def test_a_builder_is_tried(
    state: State, monkeypatch: pytest.MonkeyPatch, registry: str, kind: str, output: str, layer: str, reason: str
) -> None:
    """Another version or another driver may lack something, so a small image is pushed as parts are."""
    services = replace(services_of(state, kind), registry=registry)

    def build(_: Services, bake: buildx_of.Bake) -> tuple[None, dict[str, str]]:
        if not layer:
            raise RosmlError("push-by-digest is not implemented")
        target = json.loads(bake.file.read_text())["target"]["fit"]
        assert target["output"][0].startswith(f"type=image,{output.format(f'{registry}/{fitness.REPOSITORY}')},")
        with Registry(registry) as client:
            client.put_blob(fitness.REPOSITORY, b"{}")
            entry = oci.descriptor(f"application/vnd.oci.image.layer.v1.tar+{layer}", b"{}")
            content = {"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, b"{}"), "layers": [entry]}
            digest = client.put_manifest(fitness.REPOSITORY, "building-fit", {"mediaType": oci.IMAGE, **content})
        return None, {"containerimage.digest": digest}

    monkeypatch.setattr(buildx_of, "run", build)
    with pytest.raises(fitness.Unfit, match=reason) if reason else nullcontext():
        fitness.require(services)
    with Registry(registry) as client:
        assert client.tags(fitness.REPOSITORY) == []


@pytest.mark.parametrize(
    ("error", "kind"),
    [
        (
            buildx_of.Unanswered("x", "", "dial tcp 127.0.0.1:1: connection refused", "127.0.0.1:1/rosml/fitness"),
            "Unreached",
        ),
        (buildx_of.Unanswered("x", "", "500 Internal Server Error", "127.0.0.1:1/rosml/fitness"), "Unfit"),
        (RosmlError("x"), "Unfit"),
        (RosmlError("x", buildx_of.NO_SPACE_REMEDY), "RosmlError"),  # it has the cache: no reason to take another one
    ],
)
def test_why_a_trial_fails(
    state: State, monkeypatch: pytest.MonkeyPatch, registry: str, error: RosmlError, kind: str
) -> None:
    def build(_: Services, bake: buildx_of.Bake) -> None:
        raise error

    monkeypatch.setattr(buildx_of, "run", build)
    with pytest.raises(RosmlError) as caught:
        fitness.require(replace(services_of(state, "engine"), registry=registry))
    assert type(caught.value).__name__ == kind


def test_a_builder_that_answers_is_not_cut_off(tmp_path: Path) -> None:
    """Its record is lost, or has another folder: somebody may be building with it."""
    state = State(tmp_path / ".state")
    address = state.socket("buildkitd.sock")
    state.prepare_socket(address)
    address.unlink(missing_ok=True)  # of a killed test: its folder is named after a path that comes again
    state.run.mkdir(parents=True, exist_ok=True)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(str(address))
        server.listen()
        with pytest.raises(RosmlError, match="another buildkitd answers") as caught:
            builder.up(state, services_of(state, "buildkitd"), "")
        assert "pkill buildkitd" in caught.value.remedy
        assert address.exists()
    shutil.rmtree(state.short_run, ignore_errors=True)


def test_own_builder_in_a_path_that_overlays_cannot_have(tmp_path: Path) -> None:
    state = State(tmp_path / "a:b")
    with pytest.raises(RosmlError, match="overlay"):
        builder.up(state, services_of(state, "buildkitd"), "")


def test_build_steps_of_a_killed_builder(monkeypatch: pytest.MonkeyPatch) -> None:
    text = (
        "126 72 0:52 / / rw - overlay overlay rw,lowerdir=/a\\040b/.state/buildkit/x/3,upperdir=/y\n"
        "127 126 0:55 / /proc rw - proc proc rw\n"
    )
    monkeypatch.setattr(Path, "read_text", lambda self, errors="": text)
    assert builder.is_build_step(1, Path("/a b/.state/buildkit"))
    assert not builder.is_build_step(1, Path("/a/.state/buildkit"))
    assert not builder.is_build_step(1, Path("/a b/.state/build"))


def test_mount_points_are_read_as_the_kernel_writes_them(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "overlay /a\\040b/.state/buildkit/x overlay rw 0 0\nproc /proc proc rw 0 0\n"
    monkeypatch.setattr(Path, "read_text", lambda self: text)
    assert builder.mounted_below(Path("/a b/.state")) == ["/a b/.state/buildkit/x"]
