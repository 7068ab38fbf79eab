"""ROS in a container: what `rosml run` passes of this machine's ROS, the network that reaches others, and what
`rosml run --check` says of what keeps nodes apart."""

from __future__ import annotations

import json
import socket
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
import pytest
import yaml

from fakes.desks import OURS, Desk
from rosml.base.errors import RosmlError
from rosml.cli.run import run
from rosml.run import check, host
from rosml.run.context import Address, Container, Context, Engine, Host, Image, Person
from rosml.run.plan import make_plan
from rosml.run.plugins import places, ros
from rosml.run.words import split

OWN = [name for option in run.main.get_params(click.Context(run.main)) for name in option.opts if name.startswith("--")]
ME = Person(1000, 1000, "me", "/home/me")
JAZZY, NOETIC = {"ROS_DISTRO": "jazzy"}, {"ROS_DISTRO": "noetic"}
CONTRACT = {**JAZZY, "ROS_VERSION": "2", "DOCKER_UID": ""}
SHARED = ["--network", "host", "--ipc", "host"]


class Robot:
    """A machine with ROS. Attributes: root: the folder with its files. listens: where something listens. environment: the
    caller's. echoes: whether multicast comes back. asked: to which ports it was sent. addresses: its own."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.listens: set[Address] = set()
        self.environment: dict[str, str] = {}
        self.addresses = {"10.0.0.5"}
        self.echoes = True
        self.asked: list[int] = []
        self.file("/sys/class/net/lo/flags", "0x9\n")
        self.file("/sys/class/net/eth0/flags", "0x1003\n")
        self.file("/sys/class/net/docker0/flags", "0x1003\n")
        for name, value in ((check.RECEIVED, 2**31 - 1), (check.FRAGMENTS, 2**27), (check.SECONDS, 3)):
            self.file(name, f"{value}\n")
        self.file("/opt/ros/jazzy/setup.bash", "")

    def file(self, place: str, content: str) -> None:
        """Makes a file."""
        path = self.root / place.lstrip("/")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)

    def heard(self, port: int) -> bool:
        """Whether multicast to a port comes back."""
        self.asked.append(port)
        return self.echoes

    def context(
        self,
        *words: str,
        image: Mapping[str, str] = CONTRACT,
        engine: Engine | None = None,
        me: Person = ME,
        labels: Mapping[str, str] | None = None,
    ) -> Context:
        """What is known."""
        there = Host(
            self.root,
            self.environment,
            "robot",
            self.listens.__contains__,
            self.addresses.__contains__,
            self.heard,
        )
        return Context(
            split([*words, "ros:jazzy"], OWN),
            engine or Engine(),
            me,
            Image(environment=image, labels=labels or {}),
            there,
        )

    def found(self, *words: str, others: tuple[Container, ...] = (), **known: Any) -> dict[str, check.Finding]:
        """What --check says, by what it is about."""
        installed = known.pop("installed", ())
        context = self.context(*words, **known)
        place = places.planned(context, make_plan(context).argv)
        them = [places.running(other, context.engine.rootless) for other in others]
        return {it.subject: it for it in check.findings(context, place, them, installed)}


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    """A machine with ROS on which all is well."""
    return Robot(tmp_path / "root")


def test_an_image_says_what_its_ros_takes_by_default(robot: Robot) -> None:
    """Of an archive without Fast DDS."""
    cyclone = {"io.rosml.rmw": "rmw_cyclonedds_cpp"}
    context = robot.context(image={**CONTRACT, "ROS_DISTRO": "jazzy"}, labels=cyclone)
    planned = places.planned(context, make_plan(context).argv)
    running = places.running(
        Container("c", "running", environment={"ROS_DISTRO": "jazzy"}, labels=cyclone), rootless=False
    )
    assert (planned.middleware, running.middleware) == ("cyclonedds", "cyclonedds")
    named = places.running(
        Container("c", "running", environment={"RMW_IMPLEMENTATION": "rmw_zenoh_cpp"}, labels=cyclone), rootless=False
    )
    assert named.rmw == "rmw_zenoh_cpp"


# ---- What a container gets -------------------------------------------------------------------------------------------

SET = {
    "ROS_DOMAIN_ID": "7",
    "ROS_STATIC_PEERS": "10.0.0.6",
    "ROS_LOCALHOST_ONLY": "1",
    "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
    "ROS_MASTER_URI": "http://base:11311",
    "ROS_IP": "10.0.0.5",
    "ROS_HOSTNAME": "",
    "ROS_DISTRO": "humble",
}


@pytest.mark.parametrize(
    ("hosts", "image", "words", "added"),
    [
        ("127.0.0.1 localhost\n", NOETIC, ["--ros-network"], True),
        ("127.0.0.1 localhost\n", NOETIC, ["--network=host"], True),
        ("127.0.0.1 localhost\n127.0.1.1\trobot\n", NOETIC, ["--ros-network"], False),
        ("", NOETIC, ["--ros-network"], False),
        ("127.0.0.1 localhost\n", NOETIC, [], False),
        ("127.0.0.1 localhost\n", NOETIC, ["--ros-network", "--no-ros"], False),
        ("127.0.0.1 localhost\n", NOETIC, ["--ros-network", "--add-host=robot:10.0.0.1"], False),
        ("127.0.0.1 localhost\n", JAZZY, ["--ros-network"], False),
    ],
)
def test_a_name_that_only_systemd_knows(
    robot: Robot, hosts: str, image: Mapping[str, str], words: list[str], added: bool
) -> None:
    """roscore of ROS 1 contacts itself by the machine's name, and ends where that has no address."""
    robot.file("/etc/hosts", hosts)
    found = ros.ros(robot.context(*words, image=image)).words
    assert ("--add-host" in found and found[found.index("--add-host") + 1] == "robot:127.0.0.1") == added
    assert "--add-host" not in ros.ros(robot.context(*words, image=image, engine=Engine("podman", podman=True))).words


@pytest.mark.parametrize(
    ("image", "words", "expected"),
    [
        (JAZZY, [], ["ROS_DOMAIN_ID=7", "ROS_STATIC_PEERS=10.0.0.6"]),
        (JAZZY, ["--net=host", "--ipc=host"], ["ROS_DOMAIN_ID=7", "ROS_STATIC_PEERS=10.0.0.6", "ROS_LOCALHOST_ONLY=1"]),
        (
            JAZZY,
            ["--ros-network"],
            [
                "ROS_DOMAIN_ID=7",
                "ROS_STATIC_PEERS=10.0.0.6",
                "ROS_LOCALHOST_ONLY=1",
                "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp",
            ],
        ),
        (NOETIC, [], ["ROS_MASTER_URI=http://base:11311"]),
        (NOETIC, ["--ros-network"], ["ROS_MASTER_URI=http://base:11311", "ROS_IP=10.0.0.5"]),
        ({"ROS_DISTRO": "x", "ROS_VERSION": "1"}, [], ["ROS_MASTER_URI=http://base:11311"]),
        (JAZZY, ["--no-ros"], []),
        ({}, ["--ros-network"], []),
    ],
)
def test_settings_of_this_machines_ros(
    robot: Robot, image: Mapping[str, str], words: list[str], expected: list[str]
) -> None:
    """An RMW implementation that an image lacks would keep every node from starting; this machine's addresses are nobody's in
    another network."""
    robot.environment = SET
    added = [*ros.ros(robot.context(*words, image=image)).words]
    assert added[len(SHARED) if "--ros-network" in words else 0 :] == [x for y in expected for x in ("-e", y)]


def test_settings_go_to_another_machine_without_addresses(robot: Robot) -> None:
    robot.environment = SET
    away = robot.context("--network=host", "--ipc=host", image=NOETIC, engine=Engine(machine="server"))
    assert ros.ros(away).words == ["-e", "ROS_MASTER_URI=http://base:11311"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ([], SHARED),
        (["--network", "host"], ["--ipc", "host"]),
        (["--net=host", "--ipc=host"], []),
        (["--ipc", "container:x"], ["--network", "host"]),
    ],
)
def test_a_network_for_ros(robot: Robot, words: list[str], expected: list[str]) -> None:
    """docker refuses a network that is named twice; ssh's windows ask for the same one."""
    robot.environment = {"DISPLAY": "localhost:10.0"}
    robot.listens = {("localhost", 6010)}
    argv = [*make_plan(robot.context("--ros-network", *words, image={})).argv]
    given = [word for word in argv if word.startswith(("--net", "--ipc"))]
    wanted = [word for word in [*expected, *words] if word.startswith("--")]
    assert sorted(given) == sorted(wanted)
    assert [*ros.ros(robot.context("--ros-network", *words, image={})).words] == expected


@pytest.mark.parametrize(
    ("words", "engine", "says", "remedy"),
    [
        (["-p", "80:80"], Engine(), "which does not go with -p", "leave out one of them"),
        (["--network=robots"], Engine(), "which does not go with --network=robots", "leave out one of them"),
        ([], Engine(rootless=True), "docker without root does not reach", "--network host --ipc host reaches"),
    ],
)
def test_a_network_that_a_container_cannot_have(
    robot: Robot, words: list[str], engine: Engine, says: str, remedy: str
) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        ros.ros(robot.context("--ros-network", *words, engine=engine))
    assert caught.value.exit_code == 2 and caught.value.remedy.startswith(remedy)


@pytest.mark.parametrize(
    ("words", "image", "noted"),
    [
        (["--network", "host"], JAZZY, "--ipc host; or"),
        (["--net=container:x"], JAZZY, "--ipc container:x; or"),
        (["--network", "host", "-e", "RMW_IMPLEMENTATION=rmw_fastrtps_dynamic_cpp"], JAZZY, "--ipc host; or"),
        (["--network", "host", "--ipc", "host"], JAZZY, ""),
        (["--network", "host", "-v", "/dev/shm:/dev/shm"], JAZZY, ""),
        (["--network", "host", "-e", "FASTDDS_BUILTIN_TRANSPORTS=UDPv4"], JAZZY, ""),
        (["--network", "host", "-e", "FASTRTPS_DEFAULT_PROFILES_FILE=/x.xml"], JAZZY, ""),
        (["--network", "host"], {**JAZZY, "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}, ""),
        (["--network", "host"], {"ROS_DISTRO": "galactic"}, ""),
        (["--network", "host"], NOETIC, ""),
        (["--network", "host"], {}, ""),
        (["--network", "robots"], JAZZY, ""),
        ([], JAZZY, ""),
    ],
)
def test_a_network_without_its_memory(robot: Robot, words: list[str], image: Mapping[str, str], noted: str) -> None:
    """Fast DDS takes nodes on the same network for those of one machine, and hands them data in a memory that they lack."""
    notes = ros.ros(robot.context(*words, image=image)).notes
    assert [remedy[: len(noted)] for _, remedy in notes] == ([noted] if noted else [])


# ---- What --check says -----------------------------------------------------------------------------------------------


def states(found: Mapping[str, check.Finding], *passed: str) -> dict[str, str]:
    """What is not good, and what is said of it."""
    return {what: f"{it.state}: {it.fact}" for what, it in found.items() if it.state != "good" and what not in passed}


def test_all_is_well(robot: Robot) -> None:
    found = robot.found("--ros-network", installed=["rmw_fastrtps_cpp"])
    assert not states(found, "/dev/shm")  # however large it is here
    about = ["network", "domain", "RMW", "discovery range", "shared memory", "user", "/dev/shm", "multicast"]
    assert [*found] == [*about, "receive buffer", "fragments"]
    assert found["multicast"].fact.startswith("on eth0;"), "the engine's own interface leads nowhere"


@pytest.mark.parametrize(
    ("words", "what", "expected", "remedy"),
    [
        ([], "network", "problem: bridge: containers on it", "--ros-network"),
        (["--network", "robots"], "network", "advice: robots: containers on it", "--ros-network"),
        (["-e", "ROS_STATIC_PEERS=172.17.0.1"], "network", "advice: bridge: containers on it see", "--ros-network"),
        (["--network=none"], "network", "problem: none", "leave out --network none"),
        (["--network", "host"], "shared memory", "problem: its own, with --network host", "--ipc host"),
        (["-e", "ROS_DOMAIN_ID=7"], "domain", "problem: 7, and 3 in this shell", "-e ROS_DOMAIN_ID=3, or export"),
        (["-e", "ROS_DOMAIN_ID=232"], "domain", "problem: 232, and 3 in this shell", "-e ROS_DOMAIN_ID=3"),
        (["-e", "ROS_DOMAIN_ID=233"], "domain", "problem: '233': no node starts", "ROS_DOMAIN_ID is a number"),
        (
            ["-e", f"ROS_DOMAIN_ID={'9' * 5000}"],
            "domain",
            f"problem: '{'9' * 20}'…: no node starts",
            "ROS_DOMAIN_ID is a number",
        ),
        (["-e", "ROS_DOMAIN_ID=٣"], "domain", "problem: '٣': no node starts", "ROS_DOMAIN_ID is a number"),
        (["-e", "ROS_DOMAIN_ID=x"], "domain", "problem: 'x': no node starts", "ROS_DOMAIN_ID is a number"),
        (["--env-file", "vars"], "domain", "problem: 9, and 3 in this shell", "-e ROS_DOMAIN_ID=3"),
        (
            ["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"],
            "RMW",
            "problem: rmw_zenoh_cpp, which the image lacks",
            "-e RMW_IMPLEMENTATION=… with one that it has: rmw_fastrtps_cpp, rmw_cyclonedds_cpp",
        ),
        (
            ["-e", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"],
            "RMW",
            "problem: rmw_cyclonedds_cpp, and rmw_fastrtps_cpp in this shell",
            "-e RMW_IMPLEMENTATION=rmw_fastrtps_cpp, or export RMW_IMPLEMENTATION=rmw_cyclonedds_cpp",
        ),
        (
            ["-e", "ROS_LOCALHOST_ONLY=1"],
            "discovery range",
            "problem: LOCALHOST, which is",
            "--ros-network, or -e ROS_LOC",
        ),
        (
            ["--ros-network", "-e", "ROS_AUTOMATIC_DISCOVERY_RANGE=OFF"],
            "discovery range",
            "problem: OFF",
            "-e ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET",
        ),
        (["-e", "ROS_AUTOMATIC_DISCOVERY_RANGE=lan"], "discovery range", "problem: 'lan' is none", "ROS_AUTOMATIC"),
        (
            ["--ros-network", "-e", "ROS_LOCALHOST_ONLY=1", "-e", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"],
            "discovery range",
            "advice: ROS_LOCALHOST_ONLY, and Cyclone DDS",
            "sudo ip link set lo multicast on",
        ),
        ([], "/dev/shm", "advice: 64 MiB", "--shm-size 1g"),
        (["--shm-size=1t"], "/dev/shm", f"good: {1 << 20} MiB", ""),
        ([f"--shm-size={'9' * 400}"], "/dev/shm", f"problem: '{'9' * 20}'… is no size", "--shm-size 1g"),
        (["--shm-size=large"], "/dev/shm", "problem: 'large' is no size", "--shm-size 1g"),
        (["--shm-size=32m"], "/dev/shm", "advice: 32 MiB", "--shm-size 1g"),
        (["--ros-network", "--no-user"], "user", "problem: 0, and 1000 here", "--user 1000"),
        (
            ["--ros-network", "-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"],
            "router",
            "problem: none answers on port 7447",
            "ros2 run rmw_zenoh_cpp rmw_zenohd",
        ),
        (
            ["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"],
            "router",
            "problem: nodes look for it on localhost",
            "--ros-network",
        ),
    ],
)
def test_what_keeps_nodes_apart(robot: Robot, words: list[str], what: str, expected: str, remedy: str) -> None:
    robot.environment = {"ROS_DOMAIN_ID": "3"}
    robot.file("/home/me/vars", "# mine\nROS_DOMAIN_ID=9\n")
    if "--env-file" in words:  # rosml's own -e would win over the file
        words = [*words, "--no-ros"]
    found = robot.found(*words, installed=["rmw_fastrtps_cpp", "rmw_cyclonedds_cpp"])[what]
    assert f"{found.state}: {found.fact}".startswith(expected) and found.remedy.startswith(remedy), found


def test_a_machine_on_which_nodes_are_not_heard(robot: Robot) -> None:
    robot.echoes = False
    lost = robot.found("--ros-network")["multicast"]
    assert lost.state == "problem" and "port 7400, does not come back" in lost.fact and "dev eth0" in lost.remedy
    assert robot.found("--ros-network", "-e", "ROS_STATIC_PEERS=10.0.0.6")["multicast"].state == "advice"
    assert "multicast" not in robot.found("--ros-network", "-e", "ROS_DISCOVERY_SERVER=10.0.0.6:11811")
    robot.file("/sys/class/net/eth0/flags", "0x1002\n")
    down = robot.found("--ros-network")["multicast"]
    assert down.state == "problem" and "no network interface" in down.fact and "ROS_STATIC_PEERS" in down.remedy


@pytest.mark.parametrize(
    ("words", "engine", "what"),
    [
        (["--no-ros", "-e", "ROS_DOMAIN_ID"], Engine(), "domain"),
        (["--no-ros", "-e", "ROS_DOMAIN_ID=3", "--env-file", "/vars"], Engine(), "domain"),
        (["-e", "ROS_DOMAIN_ID=7"], Engine(machine="server"), "domain"),
        (["--ros-network", "-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"], Engine(machine="server"), "router"),
        (["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp", "-e", "ZENOH_CONFIG_OVERRIDE=x"], Engine(), "router"),
        (["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"], Engine(), "network"),
        (["--ros-network", "--user=robot"], Engine(), "network"),
    ],
)
def test_what_is_not_in_the_way(robot: Robot, words: list[str], engine: Engine, what: str) -> None:
    """A shell's value, a value that wins over that of a file, what this machine has where containers run elsewhere."""
    robot.environment = {"ROS_DOMAIN_ID": "3"}
    robot.file("/vars", "ROS_DOMAIN_ID=9\n")
    assert robot.found(*words, engine=engine)[what].state == "good"


def test_an_rmw_that_the_image_cannot_take(robot: Robot) -> None:
    robot.environment = {"RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}
    apart = robot.found(installed=["rmw_fastrtps_cpp"])["RMW"]
    assert apart.remedy == "export RMW_IMPLEMENTATION=rmw_fastrtps_cpp"


def test_the_port_of_a_domain(robot: Robot) -> None:
    for text in ("3", "233", "x"):
        assert robot.found("--ros-network", "-e", f"ROS_DOMAIN_ID={text}")["multicast"].state == "good"
    assert robot.asked == [8150, 7400, 7400], "a domain that is none has no port"


def test_an_older_ros_knows_no_range(robot: Robot) -> None:
    robot.environment = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}
    assert robot.found("--ros-network", image={"ROS_DISTRO": "humble"})["discovery range"].state == "good"
    assert robot.found("--ros-network", image=JAZZY)["discovery range"].state == "problem"


def test_small_limits_of_the_kernel(robot: Robot) -> None:
    for name, value in ((check.RECEIVED, 212992), (check.FRAGMENTS, 2**22), (check.SECONDS, 30)):
        robot.file(name, f"{value}\n")
    found = states(robot.found("--ros-network"), "/dev/shm")
    assert [*found] == ["receive buffer", "fragments"] and all(it.startswith("advice: net.") for it in found.values())
    for value, state in ((4 * 2**20 - 1, "advice"), (4 * 2**20, "good")):
        robot.file(check.RECEIVED, f"{value}\n")
        assert robot.found("--ros-network")["receive buffer"].state == state


@pytest.mark.parametrize(
    ("engine", "expected"),
    [
        (Engine(rootless=True), "problem: that of docker without root"),
        (Engine("podman", podman=True, rootless=True), "good: this machine's"),
        (Engine(machine="docker-desktop"), "problem: that of Docker Desktop's virtual machine"),
        (Engine(machine="server"), "advice: that of server"),
    ],
)
def test_whose_network_it_is(robot: Robot, engine: Engine, expected: str) -> None:
    found = robot.found(*SHARED, engine=engine)
    assert f"{found['network'].state}: {found['network'].fact}".startswith(expected)
    assert ("multicast" in found) == expected.startswith("good"), "what the container has no part in is left out"


def test_podman_without_root_gives_a_network_to_each(robot: Robot) -> None:
    alone = robot.found(engine=Engine("podman", podman=True, rootless=True))["network"]
    assert alone.state == "problem" and alone.fact.startswith("its own alone")


@pytest.mark.parametrize(
    ("words", "environment", "expected"),
    [
        ([], {}, {"network": "problem: bridge", "master": "problem: http://localhost:11311, which is the container"}),
        (["--ros-network"], {}, {"master": "advice: http://localhost:11311: nothing answers there yet"}),
        (["--network=container:x"], {}, {}),
        (["--ros-network"], {"ROS_MASTER_URI": "base"}, {"master": "problem: 'base' is no address"}),
        (
            ["--ros-network"],
            {"ROS_MASTER_URI": "http://away:11311", "ROS_IP": "10.0.0.5"},
            {"master": "problem: http://away:11311: nothing answers there"},
        ),
        (["--ros-network"], {"ROS_MASTER_URI": "http://base:11311/", "ROS_IP": "10.0.0.5"}, {}),
        (["--ros-network"], {"ROS_MASTER_URI": "http://base:11311"}, {"address": "advice: robot, by which others"}),
        (
            ["--ros-network"],
            {"ROS_MASTER_URI": "http://base:11311", "ROS_IP": "127.0.0.1"},
            {"address": "problem: ROS_IP=127.0.0.1, which other machines take for themselves"},
        ),
        (
            ["--ros-network"],
            {"ROS_MASTER_URI": "http://base:11311", "ROS_HOSTNAME": "10.0.0.9"},
            {"address": "problem: ROS_HOSTNAME=10.0.0.9, which is not this machine"},
        ),
    ],
)
def test_ros_1(robot: Robot, words: list[str], environment: dict[str, str], expected: dict[str, str]) -> None:
    robot.environment = environment
    robot.listens = {("base", 11311)}
    found = states(robot.found(*words, image=NOETIC))
    assert {what: said[: len(expected.get(what, ""))] for what, said in found.items()} == expected


def container(name: str = "arm", user: str = "1000:1000", **variables: str) -> Container:
    """A container of a robot that runs, started with --ros-network."""
    environment = {**JAZZY, **variables}
    return Container(name, "running", user=user, environment=environment, network="host", ipc="host")


@pytest.mark.parametrize(
    ("words", "them", "expected", "remedy"),
    [
        (["--ros-network"], container(), "", ""),
        ([], container(), "its network is host", "--ros-network for both"),
        (["--ros-network"], container(ROS_DOMAIN_ID="7"), "its domain is 7", "-e ROS_DOMAIN_ID=7"),
        (
            ["--ros-network"],
            container(RMW_IMPLEMENTATION="rmw_cyclonedds_cpp"),
            "its RMW is rmw_cyclonedds_cpp",
            "-e RMW_IMPLEMENTATION=rmw_cyclonedds_cpp, if the image has it",
        ),
        (["--ros-network"], container(user=""), "its user is 0", "--user 0"),
        (["--network=host"], container(), "it does not have the same shared memory", "--ros-network; or"),
        (
            ["--ros-network"],
            Container("arm", "running", user="1000", environment=JAZZY, network="host", ipc="private"),
            "it does not have the same shared memory",
            "start it with --ros-network; or",
        ),
        (["--network=container:arm", "--ipc=container:arm"], container(), "", ""),
        ([], Container("arm", "running", environment=JAZZY, network="default", ipc="private"), "", ""),
        (
            [],
            Container("arm", "running", environment=JAZZY, network="robots", ipc="private"),
            "its network is robots",
            "--network robots, or --ros-network for both",
        ),
        (["--ros-network"], container(user="robot"), "", ""),
        (
            ["--ros-network"],
            Container(
                "arm",
                "running",
                user="1000",
                environment=JAZZY,
                network="host",
                ipc="private",
                mounts=frozenset(["/dev/shm"]),
            ),
            "",
            "",
        ),
        (
            ["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp", "-e", "ZENOH_CONFIG_OVERRIDE=x"],
            container(RMW_IMPLEMENTATION="rmw_zenoh_cpp"),
            "",
            "",
        ),
        (["--ros-network"], container(ROS_DISTRO="noetic"), "it has ROS 1", "only a bridge"),
    ],
)
def test_another_container(robot: Robot, words: list[str], them: Container, expected: str, remedy: str) -> None:
    found = robot.found(*words, others=(them,))["container arm"]
    if not expected:
        assert found == check.Finding("container arm", "good", "nothing is in the way")
        return
    assert found.state == ("advice" if "ROS 1" in expected else "problem")
    assert found.fact == expected and found.remedy.startswith(remedy), found


def test_containers_of_podman_without_root(robot: Robot) -> None:
    """Each has a network that it shares with no other; numbers of users are others outside."""
    podman = Engine("podman", podman=True, rootless=True)
    alone = Container("arm", "running", environment=JAZZY, network="pasta", ipc="shareable")
    apart = robot.found(others=(alone,), engine=podman)["container arm"]
    assert (apart.state, apart.fact) == ("problem", "its network is private")
    assert robot.found("--ros-network", others=(container(user="0"),), engine=podman)["container arm"].state == "good"
    assert "user" not in robot.found("--ros-network", "--no-user", engine=podman)


def test_a_machine_without_ros(robot: Robot) -> None:
    """Its shell has no say in which domain is right; nor has one of another version."""
    (robot.root / "opt/ros/jazzy/setup.bash").unlink()
    (robot.root / "opt/ros/jazzy").rmdir()
    assert robot.found("--ros-network", "-e", "ROS_DOMAIN_ID=7")["domain"].state == "good"
    robot.environment = {"ROS_DISTRO": "noetic"}
    assert robot.found("--ros-network", "-e", "ROS_DOMAIN_ID=7")["domain"].state == "good"


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk whose docker has an image with ROS, and a container with ROS among others that run."""
    made = Desk(tmp_path)
    image = [*OURS, "ROS_DISTRO=jazzy", "ROS_VERSION=2"]
    config = {"Env": ["ROS_DISTRO=jazzy", "ROS_DOMAIN_ID=7"]}
    arm = ["running", "/arm", "sha256:y", config, [], {"NetworkMode": "bridge", "IpcMode": "private"}]
    answers = {"run": "rmw_cyclonedds_cpp\nrmw_fastrtps_cpp\nrmw_implementation"}
    made.engine(images={"ros": image, "ubuntu": []}, containers={"arm": arm, "db": ["running", "/db"]}, answers=answers)
    made.trust(ros=True)
    return made


def test_the_command_checks_and_starts_nothing(desk: Desk) -> None:
    done = desk.call("--check", "ros", "echo", "x")
    assert (done.returncode, done.stderr) == (1, "")
    lines = done.stdout.splitlines()
    assert lines[0].startswith("problem  network") and lines[1].split() == ["remedy:", "--ros-network"]
    assert (
        lines[-2].startswith("problem  container arm")
        and lines[-2].endswith("its domain is 7")
        and " db" not in done.stdout
    )
    (listed,) = [call for call in desk.calls if call[1] not in ("info", "image", "container", "ps")]
    folder = "/opt/ros/jazzy/share/ament_index/resource_index/rmw_typesupport"
    assert listed == ["docker", "run", "--rm", "--network", "none", "--entrypoint", "ls", "ros", folder]


def test_a_container_that_has_the_name_is_not_entered(desk: Desk) -> None:
    done = desk.call("--check", "--name=arm", "ros")
    assert done.stdout.startswith("problem  network") and not desk.called("exec")


def test_the_command_as_json(desk: Desk) -> None:
    done = desk.call(
        "--check", "--json", "--network=robots", "-e", "ROS_DOMAIN_ID=7", "-e", "RMW_IMPLEMENTATION=x", "ros"
    )
    found = {it["what"]: it for it in json.loads(done.stdout)}
    assert found["RMW"]["remedy"].endswith("rmw_cyclonedds_cpp, rmw_fastrtps_cpp") and done.returncode == 1
    assert found["network"] | {"found": "", "remedy": ""} == {
        "what": "network",
        "state": "advice",
        "found": "",
        "remedy": "",
    }
    desk.engine(images={"ros": ["ROS_DISTRO=noetic"]})
    done = desk.call("--check", "--json", "--network=robots", "-e", "ROS_MASTER_URI=http://127.0.0.1:1", "ros")
    assert done.returncode == 1 and not [it for it in json.loads(done.stdout) if it["what"] == "domain"]
    desk.engine(images={"ros": ["ROS_DISTRO=noetic"]})
    assert desk.call("--check", "--ros-network", "ros").returncode == 0, "advice is no failure"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["ubuntu"], "--check is about ROS, and ubuntu has none: ROS_DISTRO"),
        ([], "--check needs an image, and none is named"),
        (["missing"], "no image missing here"),
        (["--ros-network", "-p", "1:1", "ros"], "--ros-network: it needs --network host"),
    ],
)
def test_what_cannot_be_checked(desk: Desk, words: list[str], says: str) -> None:
    done = desk.call("--check", *words)
    assert (done.returncode, done.stdout) == (125, "")
    assert f"error: {says}" in done.stderr and "remedy: " in done.stderr
    assert not desk.called("run") and not desk.called("pull")


def test_settings_and_network_reach_the_engine(desk: Desk) -> None:
    """What somebody writes comes after what this machine has set, so that it counts."""
    desk.engine(images={"ros": ["ROS_DISTRO=jazzy"]})
    done = desk.call("--no-tz", "--ros-network", "-e", "ROS_DOMAIN_ID=9", "ros", "ls", ROS_DOMAIN_ID="7")
    assert (done.returncode, done.stderr) == (0, "")
    assert desk.ran[-10:] == [*SHARED, "-e", "ROS_DOMAIN_ID=7", "-e", "ROS_DOMAIN_ID=9", "ros", "ls"]
    done = desk.call("--network=host", "ros")
    assert done.stderr.startswith("warning: --network host without its shared memory: ") and done.returncode == 0


def test_an_export_has_the_network_and_the_settings(desk: Desk) -> None:
    def exported(kind: str) -> str:
        return desk.call(f"--export={kind}", "--ros-network", "ros", ROS_DOMAIN_ID="7").stdout

    (service,) = yaml.safe_load(exported("compose"))["services"].values()
    assert (service["network_mode"], service["ipc"], service["environment"]["ROS_DOMAIN_ID"]) == ("host", "host", "7")
    found = json.loads(exported("devcontainer"))
    words = [word for word in found["runArgs"] if word != "--group-add=0"]  # for whoever is not root
    assert words[-2:] == ["--network=host", "--ipc=host"] and found["containerEnv"]["ROS_DOMAIN_ID"] == "7"


# ---- This machine ----------------------------------------------------------------------------------------------------


def test_addresses_and_multicast_of_this_machine() -> None:
    assert host.owns("127.0.0.1") and host.owns("localhost") and not host.owns("192.0.2.1")
    assert not host.owns("a..b") and not host.connects(("a..b", 1)) and not host.connects(("127.0.0.1", 99999))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("", 0))
        port = taken.getsockname()[1]
        try:
            taken.connect((host.GROUP, port))
            routed = True
        except OSError:
            routed = False
        assert host.echoes(port) == routed, "a node has the port for itself"
    assert host.echoes(port) == routed
