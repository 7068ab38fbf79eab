"""Measures what it costs to ask a policy: a 1080p picture goes there and one comes back, 30 times a second.

measure.py [WAY...]   the ways are process, memory, zenoh, zenoh-memory, and ros if rclpy is there; all if none is named
"""

import importlib.util
import json
import os
import statistics
import subprocess
import sys
import time
from multiprocessing import resource_tracker, shared_memory

import numpy as np

SHAPE, HZ, SECONDS = (1080, 1920, 3), 30, 10
SIZE = SHAPE[0] * SHAPE[1] * SHAPE[2]


def act(picture: np.ndarray) -> np.ndarray:
    """Reads all of the picture, and makes another one."""
    return 255 - picture


class InOneProcess:
    """The policy is a function of the node."""

    ask = staticmethod(act)

    def close(self) -> None: ...


class Served:
    """The policy is a process of its own, which says when it is ready."""

    def __init__(self, way: str, *words: str) -> None:
        self.server = subprocess.Popen(
            [sys.executable, __file__, "serve", way, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
        )
        self.server.stdout.readline()

    def close(self) -> None:
        self.server.kill()
        self.server.wait()


class ByMemory(Served):
    """Python's own shared memory, and a pipe that says when something is there: the least that two processes need."""

    def __init__(self) -> None:
        self._blocks = [shared_memory.SharedMemory(create=True, size=SIZE) for _ in range(2)]
        super().__init__("memory", *(block.name for block in self._blocks))
        self._there, self._back = map(picture_in, self._blocks)

    def ask(self, picture: np.ndarray) -> np.ndarray:
        self._there[:] = picture
        self.server.stdin.write(b"\n")
        self.server.stdout.readline()
        return self._back.copy()

    def close(self) -> None:
        super().close()
        del self._there, self._back
        for block in self._blocks:
            block.close()
            block.unlink()


def picture_in(block: shared_memory.SharedMemory) -> np.ndarray:
    return np.ndarray(SHAPE, np.uint8, block.buf)


def serve_memory(there: str, back: str) -> None:
    blocks = [shared_memory.SharedMemory(name) for name in (there, back)]
    for block in blocks:  # the other process removes them
        resource_tracker.unregister(f"/{block.name}", "shared_memory")
    pictures = [*map(picture_in, blocks)]
    print(flush=True)
    for _ in sys.stdin:
        pictures[1][:] = act(pictures[0])
        print(flush=True)


class ByZenoh(Served):
    """A query and its reply, over TCP on this machine, or with pictures in shared memory."""

    def __init__(self, memory: bool = False) -> None:
        self._session = zenoh_session("listen", memory)
        super().__init__("zenoh-memory" if memory else "zenoh")
        while not [*self._session.get("measure", payload=bytes(SIZE), timeout=5)]:
            time.sleep(0.1)

    def ask(self, picture: np.ndarray) -> np.ndarray:
        [reply] = self._session.get("measure", payload=picture.tobytes(), timeout=5)
        return np.frombuffer(reply.ok.payload.to_bytes(), np.uint8).reshape(SHAPE)

    def close(self) -> None:
        super().close()
        self._session.close()


def zenoh_session(role: str, memory: bool):
    import zenoh

    config = zenoh.Config()
    config.insert_json5(f"{role}/endpoints", '["tcp/127.0.0.1:7449"]')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("transport/shared_memory/enabled", json.dumps(memory))
    return zenoh.open(config)


def serve_zenoh(memory: bool) -> None:
    def answer(query) -> None:
        picture = np.frombuffer(query.payload.to_bytes(), np.uint8).reshape(SHAPE)
        query.reply(query.key_expr, act(picture).tobytes())

    with zenoh_session("connect", memory) as session, session.declare_queryable("measure", answer):
        print(flush=True)
        sys.stdin.read()


class ByRos(Served):
    """Two nodes and two topics."""

    def __init__(self) -> None:
        self._node, self._publisher, self._answers = ros_node("there", "back")
        super().__init__("ros")
        time.sleep(2)  # until they know each other

    def ask(self, picture: np.ndarray) -> np.ndarray:
        import rclpy

        self._publisher.publish(ros_image(picture))
        end = time.monotonic() + 5
        while not self._answers and time.monotonic() < end:
            rclpy.spin_once(self._node, timeout_sec=0.1)
        return np.frombuffer(self._answers.pop().data, np.uint8).reshape(SHAPE)


def ros_node(publishes: str, hears: str):
    import rclpy
    from sensor_msgs.msg import Image

    if not rclpy.ok():
        rclpy.init()
    answers: list = []
    node = rclpy.create_node(publishes)
    node.create_subscription(Image, hears, answers.append, 1)
    return node, node.create_publisher(Image, publishes, 1), answers


def ros_image(picture: np.ndarray):
    import array

    from sensor_msgs.msg import Image

    data = array.array("B", picture.tobytes())  # from anything else, rclpy checks each number
    return Image(height=SHAPE[0], width=SHAPE[1], encoding="rgb8", step=3 * SHAPE[1], data=data)


def serve_ros() -> None:
    import rclpy

    node, publisher, pictures = ros_node("back", "there")
    print(flush=True)
    while True:
        rclpy.spin_once(node)
        while pictures:
            publisher.publish(ros_image(act(np.frombuffer(pictures.pop().data, np.uint8).reshape(SHAPE))))


WAYS = {
    "process": InOneProcess,
    "memory": ByMemory,
    "zenoh-memory": lambda: ByZenoh(memory=True),
    "zenoh": ByZenoh,
    "ros": ByRos,
}
SERVERS = {
    "memory": serve_memory,
    "zenoh": lambda: serve_zenoh(False),
    "zenoh-memory": lambda: serve_zenoh(True),
    "ros": serve_ros,
}


def processor_seconds(pid: int) -> float:
    """User's and system's time of a process: https://man7.org/linux/man-pages/man5/proc_pid_stat.5.html"""
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(name: str) -> None:
    way = WAYS[name]()
    pids = [os.getpid(), *([way.server.pid] if isinstance(way, Served) else [])]
    noise = np.random.default_rng(1)
    pictures = [noise.integers(0, 256, SHAPE, np.uint8) for _ in range(4)]
    for picture in pictures:
        if not (way.ask(picture) == act(picture)).all():
            sys.exit(f"{name}: another picture came back")
    used, begin, took = sum(map(processor_seconds, pids)), time.monotonic(), []
    for number in range(HZ * SECONDS):
        time.sleep(max(0, begin + number / HZ - time.monotonic()))
        asked = time.monotonic()
        way.ask(pictures[number % 4])
        took.append(1000 * (time.monotonic() - asked))
    seconds = time.monotonic() - begin
    used = sum(map(processor_seconds, pids)) - used
    way.close()
    late = statistics.quantiles(took, n=20)[-1]
    print(
        f"{name:13} {statistics.median(took):6.1f} ms, 95 % in {late:6.1f} ms, {len(took) / seconds:4.1f} Hz,"
        f" {100 * used / seconds:4.0f} % of a processor",
        flush=True,
    )


if __name__ == "__main__":
    if sys.argv[1:2] == ["serve"]:
        SERVERS[sys.argv[2]](*sys.argv[3:])
    else:
        everywhere = [name for name in WAYS if name != "ros" or importlib.util.find_spec("rclpy")]
        for name in sys.argv[1:] or everywhere:
            measure(name)
