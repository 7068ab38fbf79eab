"""ROS in a container: settings and network of this machine's ROS, and the findings of `rosml run --check`."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import OURS, Desk
from fakes.run_machines import Machine
from rosml.base.errors import RosmlError
from rosml.run import check
from rosml.run.context import Container, Context, Engine, Image, Person
from rosml.run.plan import make_plan
from rosml.run.plugins import places, ros

JAZZY, NOETIC = {"ROS_DISTRO": "jazzy"}, {"ROS_DISTRO": "noetic"}
CONTRACT = {**JAZZY, "ROS_VERSION": "2", "DOCKER_UID": ""}
SHARED = ["--network", "host", "--ipc", "host"]
PODMAN = Engine("podman", podman=True, rootless=True)
LOCAL_HOSTS = b"127.0.0.1 localhost\n"


class Robot(Machine):
    """A machine with ROS on which all is well."""

    def __init__(self, root: Path) -> None:
        super().__init__(root, Person(1000, 1000, "me", "/home/me"))
        self.addresses = {"10.0.0.5"}
        for name, flags in (("lo", b"0x9\n"), ("eth0", b"0x1003\n"), ("docker0", b"0x1003\n")):
            self.file(f"/sys/class/net/{name}/flags", flags)
        self.limits(2**31 - 1, 2**27, 3)
        self.file("/opt/ros/jazzy/setup.bash")

    def limits(self, *values: int) -> None:
        for name, value in zip((check.RECEIVED, check.FRAGMENTS, check.SECONDS), values, strict=True):
            self.file(name, f"{value}\n".encode())

    def call(self, *words: str, environment: Mapping[str, str] = CONTRACT, engine: Engine | None = None) -> Context:
        return self.context(*words, image=Image(environment=environment), engine=engine)

    def check(
        self, *words: str, others: tuple[Container, ...] = (), installed: tuple[str, ...] = (), **facts: Any
    ) -> dict[str, check.Finding]:
        """The findings of --check, by their subject."""
        context = self.call(*words, **facts)
        place = places.planned(context, make_plan(context).argv)
        running = [places.running(other, context.engine.rootless) for other in others]
        return {finding.subject: finding for finding in check.findings(context, place, running, installed)}


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    return Robot(tmp_path / "root")


def test_the_default_rmw_of_an_image(robot: Robot) -> None:
    """An image of an archive without Fast DDS has a label."""
    label = {"io.rosml.rmw": "rmw_cyclonedds_cpp"}
    context = robot.context(image=Image(environment=CONTRACT, labels=label))
    running = places.running(Container("c", "running", environment=JAZZY, labels=label), rootless=False)
    assert places.planned(context, make_plan(context).argv).middleware == running.middleware == "cyclonedds"
    zenoh = {"RMW_IMPLEMENTATION": "rmw_zenoh_cpp"}
    assert places.running(Container("c", "running", environment=zenoh, labels=label), False).rmw == "rmw_zenoh_cpp"


@pytest.mark.parametrize(
    ("hosts", "environment", "words", "added"),
    [
        (LOCAL_HOSTS, NOETIC, ["--ros-network"], True),
        (LOCAL_HOSTS + b"127.0.1.1\trobot\n", NOETIC, ["--ros-network"], False),
        (LOCAL_HOSTS, NOETIC, [], False),
        (LOCAL_HOSTS, NOETIC, ["--ros-network", "--no-ros"], False),
        (LOCAL_HOSTS, NOETIC, ["--ros-network", "--add-host=robot:10.0.0.1"], False),
        (LOCAL_HOSTS, JAZZY, ["--ros-network"], False),
    ],
)
def test_a_name_that_systemd_alone_resolves(
    robot: Robot, hosts: bytes, environment: Mapping[str, str], words: list[str], added: bool
) -> None:
    """roscore of ROS 1 contacts itself by the machine's name."""
    robot.file("/etc/hosts", hosts)
    options = ros.ros(robot.call(*words, environment=environment)).words
    assert ("robot:127.0.0.1" in options) == added
    podman = Engine("podman", podman=True)
    assert "--add-host" not in ros.ros(robot.call(*words, environment=environment, engine=podman)).words


DDS = ["ROS_DOMAIN_ID=7", "ROS_STATIC_PEERS=10.0.0.6"]
MASTER = "ROS_MASTER_URI=http://base:11311"


@pytest.mark.parametrize(
    ("environment", "words", "engine", "expected"),
    [
        (JAZZY, [], None, DDS),
        (JAZZY, ["--net=host", "--ipc=host"], None, [*DDS, "ROS_LOCALHOST_ONLY=1"]),
        (JAZZY, ["--ros-network"], None, [*DDS, "ROS_LOCALHOST_ONLY=1", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"]),
        (NOETIC, [], None, [MASTER]),
        (NOETIC, ["--ros-network"], None, [MASTER, "ROS_IP=10.0.0.5"]),
        (NOETIC, ["--network=host", "--ipc=host"], Engine(machine="server"), [MASTER]),
        (JAZZY, ["--no-ros"], None, []),
        ({}, ["--ros-network"], None, []),
    ],
)
def test_settings_of_this_machines_ros(
    robot: Robot, environment: Mapping[str, str], words: list[str], engine: Engine | None, expected: list[str]
) -> None:
    """An RMW implementation that an image lacks would keep every node from starting; this machine's addresses are nobody's in
    another network."""
    settings = [*DDS, MASTER, "ROS_LOCALHOST_ONLY=1", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp", "ROS_IP=10.0.0.5"]
    robot.environment = dict(entry.split("=", 1) for entry in [*settings, "ROS_HOSTNAME=", "ROS_DISTRO=humble"])
    options = [*ros.ros(robot.call(*words, environment=environment, engine=engine)).words]
    assert options[len(SHARED) if "--ros-network" in words else 0 :] == [x for y in expected for x in ("-e", y)]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ([], SHARED),
        (["--network", "host"], ["--ipc", "host"]),
        (["--ipc", "container:x"], ["--network", "host"]),
    ],
)
def test_a_network_for_ros(robot: Robot, words: list[str], expected: list[str]) -> None:
    """docker refuses a network that is named twice; ssh's windows ask for the same one."""
    robot.environment, robot.listens = {"DISPLAY": "localhost:10.0"}, {("localhost", 6010)}
    context = robot.call("--ros-network", *words, environment={})
    options = [word for word in make_plan(context).argv if word.startswith(("--net", "--ipc"))]
    assert sorted(options) == sorted(word for word in [*expected, *words] if word.startswith("--"))
    assert [*ros.ros(context).words] == expected


@pytest.mark.parametrize(
    ("words", "engine", "says", "remedy"),
    [
        (["-p", "80:80"], Engine(), "which does not go with -p", "leave out one of them"),
        ([], Engine(rootless=True), "docker without root does not reach", "--network host --ipc host reaches"),
    ],
)
def test_a_network_that_a_container_cannot_have(
    robot: Robot, words: list[str], engine: Engine, says: str, remedy: str
) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        ros.ros(robot.call("--ros-network", *words, engine=engine))
    assert caught.value.exit_code == 2 and caught.value.remedy.startswith(remedy)


@pytest.mark.parametrize(
    ("words", "environment", "remedy"),
    [
        (["--network", "host"], JAZZY, "--ipc host; or"),
        (["--net=container:x"], JAZZY, "--ipc container:x; or"),
        *((["--network", "host", option, value], JAZZY, "") for option, value in [
            ("--ipc", "host"), ("-v", "/dev/shm:/dev/shm"), ("-e", "FASTDDS_BUILTIN_TRANSPORTS=UDPv4"),
            ("-e", "FASTRTPS_DEFAULT_PROFILES_FILE=/x.xml"),
        ]),
        *((["--network", "host"], environment, "") for environment in [
            {**JAZZY, "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}, {"ROS_DISTRO": "galactic"}, NOETIC, {},
        ]),
        (["--network", "robots"], JAZZY, ""),
    ],
)  # fmt: skip
def test_a_network_without_its_memory(
    robot: Robot, words: list[str], environment: Mapping[str, str], remedy: str
) -> None:
    """Fast DDS takes nodes on the same network for those of one machine, and hands them data in a memory that they lack."""
    notes = ros.ros(robot.call(*words, environment=environment)).notes
    assert [text[: len(remedy)] for _, text in notes] == ([remedy] if remedy else [])


def unwell(findings: Mapping[str, check.Finding], *passed: str) -> dict[str, str]:
    """The findings that are not good, without the passed subjects."""
    bad = {subject: finding for subject, finding in findings.items() if finding.state != check.GOOD}
    return {subject: f"{x.state}: {x.fact}" for subject, x in bad.items() if subject not in passed}


def test_all_is_well(robot: Robot) -> None:
    findings = robot.check("--ros-network", installed=("rmw_fastrtps_cpp",))
    assert not unwell(findings, "/dev/shm")  # however large it is here
    subjects = ["network", "domain", "RMW", "discovery range", "shared memory", "user", "/dev/shm", "multicast"]
    assert [*findings] == [*subjects, "receive buffer", "fragments"]
    assert findings["multicast"].fact.startswith("on eth0;"), "the engine's own interface leads nowhere"


ZENOH, CYCLONE = ["-e", "RMW_IMPLEMENTATION=rmw_zenoh_cpp"], ["-e", "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"]
NINES = "9" * 400


@pytest.mark.parametrize(
    ("words", "subject", "fact", "remedy"),
    [
        ([], "network", "problem: bridge: containers on it", "--ros-network"),
        (["--network", "robots"], "network", "advice: robots: containers on it", "--ros-network"),
        (["--network=none"], "network", "problem: none", "leave out --network none"),
        (["--network", "host"], "shared memory", "problem: its own, with --network host", "--ipc host"),
        *((["-e", f"ROS_DOMAIN_ID={n}"], "domain", f"problem: {n}, and 3 in this shell", "-e ROS_DOMAIN_ID=3, or export") for n in (7, 232)),
        *((["-e", f"ROS_DOMAIN_ID={x}"], "domain", f"problem: '{x}': no node starts", "ROS_DOMAIN_ID is a number") for x in (233, "٣", "x")),
        (["-e", f"ROS_DOMAIN_ID={NINES}"], "domain", f"problem: '{'9' * 20}'…: no node starts", "ROS_DOMAIN_ID is a number"),
        (["--env-file", "vars"], "domain", "problem: 9, and 3 in this shell", "-e ROS_DOMAIN_ID=3"),
        (ZENOH, "RMW", "problem: rmw_zenoh_cpp, which the image lacks", "-e RMW_IMPLEMENTATION=… with one that it has: rmw_fastrtps_cpp"),
        (CYCLONE, "RMW", "problem: rmw_cyclonedds_cpp, and rmw_fastrtps_cpp in this shell", "-e RMW_IMPLEMENTATION=rmw_fastrtps_cpp, or"),
        (["-e", "ROS_LOCALHOST_ONLY=1"], "discovery range", "problem: LOCALHOST, which is", "--ros-network, or -e ROS_LOC"),
        (["--ros-network", "-e", "ROS_AUTOMATIC_DISCOVERY_RANGE=OFF"], "discovery range", "problem: OFF", "-e ROS_AUTOMATIC"),
        (["--ros-network", "-e", "ROS_LOCALHOST_ONLY=1", *CYCLONE], "discovery range", "advice: ROS_LOCALHOST_ONLY, and Cyclone", "sudo ip link"),
        ([], "/dev/shm", "advice: 64 MiB", "--shm-size 1g"),
        (["--shm-size=1t"], "/dev/shm", f"good: {1 << 20} MiB", ""),
        ([f"--shm-size={NINES}"], "/dev/shm", f"problem: '{'9' * 20}'… is no size", "--shm-size 1g"),
        (["--ros-network", "--no-user"], "user", "problem: 0, and 1000 here", "--user 1000"),
        (["--ros-network", *ZENOH], "router", "problem: none answers on port 7447", "ros2 run rmw_zenoh_cpp rmw_zenohd"),
        (ZENOH, "router", "problem: nodes look for it on localhost", "--ros-network"),
    ],
)  # fmt: skip
def test_what_keeps_nodes_apart(robot: Robot, words: list[str], subject: str, fact: str, remedy: str) -> None:
    robot.environment = {"ROS_DOMAIN_ID": "3"}
    robot.file("/home/me/vars", b"# mine\nROS_DOMAIN_ID=9\n")
    if "--env-file" in words:  # rosml's own -e would win over the file
        words = [*words, "--no-ros"]
    finding = robot.check(*words, installed=("rmw_fastrtps_cpp", "rmw_cyclonedds_cpp"))[subject]
    assert f"{finding.state}: {finding.fact}".startswith(fact) and finding.remedy.startswith(remedy), finding


@pytest.mark.parametrize(
    ("words", "engine", "subject"),
    [
        (["--no-ros", "-e", "ROS_DOMAIN_ID"], Engine(), "domain"),
        (["-e", "ROS_DOMAIN_ID=7"], Engine(machine="server"), "domain"),
        (["--ros-network", *ZENOH], Engine(machine="server"), "router"),
        ([*ZENOH, "-e", "ZENOH_CONFIG_OVERRIDE=x"], Engine(), "router"),
        (ZENOH, Engine(), "network"),
    ],
)
def test_what_is_not_in_the_way(robot: Robot, words: list[str], engine: Engine, subject: str) -> None:
    """A shell's value, and values of this machine if containers run elsewhere."""
    robot.environment = {"ROS_DOMAIN_ID": "3"}
    assert robot.check(*words, engine=engine)[subject].state == "good"


def test_multicast(robot: Robot) -> None:
    for domain in ("3", "233", "x"):
        assert robot.check("--ros-network", "-e", f"ROS_DOMAIN_ID={domain}")["multicast"].state == "good"
    assert robot.ports == [8150, 7400, 7400], "a domain that is none has no port"
    robot.echoes = False
    lost = robot.check("--ros-network")["multicast"]
    assert lost.state == "problem" and "port 7400, does not come back" in lost.fact and "dev eth0" in lost.remedy
    assert robot.check("--ros-network", "-e", "ROS_STATIC_PEERS=10.0.0.6")["multicast"].state == "advice"
    assert "multicast" not in robot.check("--ros-network", "-e", "ROS_DISCOVERY_SERVER=10.0.0.6:11811")
    robot.file("/sys/class/net/eth0/flags", b"0x1002\n")
    down = robot.check("--ros-network")["multicast"]
    assert down.state == "problem" and "no network interface" in down.fact and "ROS_STATIC_PEERS" in down.remedy


def test_a_range_that_an_image_lacks(robot: Robot) -> None:
    robot.environment = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}
    for distribution, state in (("humble", "good"), ("jazzy", "problem")):
        findings = robot.check("--ros-network", environment={"ROS_DISTRO": distribution})
        assert findings["discovery range"].state == state


def test_small_limits_of_the_kernel(robot: Robot) -> None:
    robot.limits(4 * 2**20 - 1, 2**22, 30)
    findings = unwell(robot.check("--ros-network"), "/dev/shm")
    assert [*findings] == ["receive buffer", "fragments"]
    assert all(finding.startswith("advice: net.") for finding in findings.values())
    robot.limits(4 * 2**20, 2**27, 30)
    assert not unwell(robot.check("--ros-network"), "/dev/shm")


@pytest.mark.parametrize(
    ("words", "engine", "fact"),
    [
        (SHARED, Engine(rootless=True), "problem: that of docker without root"),
        (SHARED, PODMAN, "good: this machine's"),
        (SHARED, Engine(machine="docker-desktop"), "problem: that of Docker Desktop's virtual machine"),
        (SHARED, Engine(machine="server"), "advice: that of server"),
        ([], PODMAN, "problem: its own alone"),
    ],
)
def test_whose_network_it_is(robot: Robot, words: list[str], engine: Engine, fact: str) -> None:
    findings = robot.check(*words, engine=engine)
    assert f"{findings['network'].state}: {findings['network'].fact}".startswith(fact)
    assert ("multicast" in findings) == fact.startswith("good"), "on another network it says nothing"


@pytest.mark.parametrize(
    ("words", "environment", "expected"),
    [
        ([], {}, {"network": "problem: bridge", "master": "problem: http://localhost:11311, which is the container"}),
        (["--ros-network"], {}, {"master": "advice: http://localhost:11311: nothing answers there yet"}),
        (["--network=container:x"], {}, {}),
        (["--ros-network"], {"ROS_MASTER_URI": "base"}, {"master": "problem: 'base' is no address"}),
        (["--ros-network"], {"ROS_MASTER_URI": "http://away:11311", "ROS_IP": "10.0.0.5"}, {"master": "problem: http://away:11311: nothing"}),
        (["--ros-network"], {"ROS_MASTER_URI": "http://base:11311/", "ROS_IP": "10.0.0.5"}, {}),
        *((["--ros-network"], {"ROS_MASTER_URI": "http://base:11311", **more}, {"address": fact}) for more, fact in [
            ({}, "advice: robot, by which others"),
            ({"ROS_IP": "127.0.0.1"}, "problem: ROS_IP=127.0.0.1, which other machines take for themselves"),
            ({"ROS_HOSTNAME": "10.0.0.9"}, "problem: ROS_HOSTNAME=10.0.0.9, which is not this machine"),
        ]),
    ],
)  # fmt: skip
def test_ros_1(robot: Robot, words: list[str], environment: dict[str, str], expected: dict[str, str]) -> None:
    robot.environment, robot.listens = environment, {("base", 11311)}
    findings = unwell(robot.check(*words, environment=NOETIC))
    assert {subject: fact[: len(expected.get(subject, ""))] for subject, fact in findings.items()} == expected


def arm(user: str = "1000:1000", network: str = "host", ipc: str = "host", **variables: str) -> Container:
    """A container that runs, started with --ros-network."""
    return Container("arm", "running", user=user, environment={**JAZZY, **variables}, network=network, ipc=ipc)


WHOLE = ["--ros-network"]
MOUNTED = Container("arm", "running", "", "", "1", JAZZY, network="host", ipc="private", mounts=frozenset(["/dev/shm"]))


@pytest.mark.parametrize(
    ("words", "other", "fact", "remedy"),
    [
        (WHOLE, arm(), "", ""),
        ([], arm(), "its network is host", "--ros-network for both"),
        (WHOLE, arm(ROS_DOMAIN_ID="7"), "its domain is 7", "-e ROS_DOMAIN_ID=7"),
        (WHOLE, arm(RMW_IMPLEMENTATION="rmw_x"), "its RMW is rmw_x", "-e RMW_IMPLEMENTATION=rmw_x, if"),
        (WHOLE, arm(user=""), "its user is 0", "--user 0"),
        (["--network=host"], arm(), "it does not have the same shared memory", "--ros-network; or"),
        (WHOLE, arm(ipc="private"), "it does not have the same shared memory", "start it with --ros-network; or"),
        (["--network=container:arm", "--ipc=container:arm"], arm(), "", ""),
        ([], arm(network="default", ipc="private"), "", ""),
        ([], arm(network="robots", ipc="private"), "its network is robots", "--network robots, or --ros-network"),
        (["--ros-network", "--user=1"], MOUNTED, "", ""),
        ([*ZENOH, "-e", "ZENOH_CONFIG_OVERRIDE=x"], arm(RMW_IMPLEMENTATION="rmw_zenoh_cpp"), "", ""),
        (WHOLE, arm(ROS_DISTRO="noetic"), "it has ROS 1", "only a bridge"),
    ],
)
def test_another_container(robot: Robot, words: list[str], other: Container, fact: str, remedy: str) -> None:
    finding = robot.check(*words, others=(other,))["container arm"]
    if not fact:
        assert finding == check.Finding("container arm", "good", "nothing is in the way")
        return
    assert finding.state == ("advice" if "ROS 1" in fact else "problem")
    assert finding.fact == fact and finding.remedy.startswith(remedy), finding


def test_containers_of_podman_without_root(robot: Robot) -> None:
    """Each has a network that it shares with no other; numbers of users are others outside."""
    apart = robot.check(others=(arm(network="pasta", ipc="shareable"),), engine=PODMAN)["container arm"]
    assert (apart.state, apart.fact) == ("problem", "its network is private")
    assert robot.check("--ros-network", others=(arm(user="0"),), engine=PODMAN)["container arm"].state == "good"
    assert "user" not in robot.check("--ros-network", "--no-user", engine=PODMAN)


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk whose docker has an image with ROS, and a container with ROS among others that run."""
    desk = Desk(tmp_path)
    image = [*OURS, "ROS_DISTRO=jazzy", "ROS_VERSION=2"]
    config = {"Env": ["ROS_DISTRO=jazzy", "ROS_DOMAIN_ID=7"]}
    running = ["running", "/arm", "sha256:y", config, [], {"NetworkMode": "bridge", "IpcMode": "private"}]
    containers = {"arm": running, "db": ["running", "/db"]}
    answers = {"run": "rmw_cyclonedds_cpp\nrmw_fastrtps_cpp\nrmw_implementation"}
    desk.engine(images={"ros": image, "ubuntu": []}, containers=containers, answers=answers)
    desk.trust(ros=True)
    return desk


def test_the_command_checks_and_starts_nothing(desk: Desk) -> None:
    """Also if a container has the name."""
    done = desk.call("--check", "--name=arm", "ros", "echo", "x")
    lines = done.stdout.splitlines()
    assert (done.returncode, done.stderr) == (1, "") and lines[0].startswith("problem  network")
    assert lines[1].split() == ["remedy:", "--ros-network"] and " db" not in done.stdout
    assert lines[-2].startswith("problem  container arm") and lines[-2].endswith("its domain is 7")
    (listing,) = [call for call in desk.calls if call[1] not in ("info", "image", "container", "ps")]
    folder = "/opt/ros/jazzy/share/ament_index/resource_index/rmw_typesupport"
    assert listing == ["docker", "run", "--rm", "--network", "none", "--entrypoint", "ls", "ros", folder]


def test_the_command_as_json(desk: Desk) -> None:
    done = desk.call("--check", "--json", "--network=robots", "-e", "RMW_IMPLEMENTATION=x", "ros")
    findings = {finding["what"]: finding for finding in json.loads(done.stdout)}
    assert findings["RMW"]["remedy"].endswith("rmw_cyclonedds_cpp, rmw_fastrtps_cpp") and done.returncode == 1
    assert {*findings["network"]} == {"what", "state", "found", "remedy"} and findings["network"]["state"] == "advice"
    desk.engine(images={"ros": ["ROS_DISTRO=noetic"]})
    assert desk.call("--check", "--ros-network", "ros").returncode == 0, "advice is no failure"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["ubuntu"], "--check is about ROS, and ubuntu has none: ROS_DISTRO"),
        ([], "--check needs an image, and none is named"),
    ],
)
def test_what_cannot_be_checked(desk: Desk, words: list[str], says: str) -> None:
    done = desk.call("--check", *words)
    assert (done.returncode, done.stdout) == (125, "") and f"error: {says}" in done.stderr
    assert not desk.called("run") and not desk.called("pull")
