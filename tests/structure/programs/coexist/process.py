"""One process with ROS, the frameworks that the image promises with numpy, and OpenCV and cv_bridge if it has perception: whichever
is imported first, each does its work, and the process ends cleanly.

Without arguments: runs itself for both orders; with `--six`, for six. `process.py NAME…`: one process with that order.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any


def runtimes_too_many(maps: str, machine: str) -> list[str]:
    """The runtimes of OpenMP that a process has mapped, where it has more than it must: each starts a thread for every
    processor.

    TensorFlow's wheel for arm64 is linked with LLVM's runtime, under a name that nothing else asks for
    (tensorflow.libs/libomp-f1025659.so.5 in 2.20.0), and everything else with GNU's: there it may be beside that one.

    Args:
        maps: what /proc/PID/maps says. machine: what `uname -m` says.
    """
    mapped = sorted({line.split()[-1] for line in maps.splitlines()})
    runtimes = [path for path in mapped if re.search(r"/lib(gomp|iomp5|omp)[-.]", path)]
    tensorflows = [path for path in runtimes if re.search(r"/tensorflow[^/]*\.libs/libomp-", path)]
    allowed = 2 if machine == "aarch64" and len(tensorflows) == 1 else 1
    return runtimes if len(runtimes) > allowed else []


def work(names: list[str]) -> None:
    """Imports everything in an order, then works with each on the same picture."""
    import importlib

    modules = {name: importlib.import_module(name) for name in names}
    if "numpy" in modules:
        look(modules)
    if "rospy" in modules:
        assert modules["rospy"].Time.from_sec(1.5).nsecs == 500_000_000
    else:
        from rclpy.time import Time

        assert Time(seconds=1, nanoseconds=5).nanoseconds == 1_000_000_005
    print("worked:", " ".join(names))


def look(modules: dict[str, Any]) -> None:
    """Has all that knows pictures work on the same one."""
    np = modules["numpy"]
    picture = np.arange(4 * 6 * 3, dtype=np.uint8).reshape(4, 6, 3)
    if "cv_bridge" in modules:
        from sensor_msgs.msg import Image

        bridge = modules["cv_bridge"].CvBridge()
        message = bridge.cv2_to_imgmsg(picture, "bgr8")
        assert isinstance(message, Image) and (message.height, message.width) == (4, 6)
        seen = bridge.imgmsg_to_cv2(message, "rgb8")
        assert (seen == picture[:, :, ::-1]).all()
        assert (seen == modules["cv2"].cvtColor(picture, modules["cv2"].COLOR_BGR2RGB)).all()
    mean = picture.mean()
    if "torch" in modules:
        torch = modules["torch"]
        tensor = torch.from_numpy(picture.astype(np.float32))
        convolved = torch.nn.functional.avg_pool2d(tensor.permute(2, 0, 1)[None], (4, 6))
        assert abs(convolved.mean().item() - mean) < 1e-3
    if "tensorflow" in modules:
        tf = modules["tensorflow"]
        pooled = tf.nn.avg_pool2d(tf.constant(picture[None], tf.float32), (4, 6), 1, "VALID")
        assert abs(float(tf.reduce_mean(pooled)) - mean) < 1e-3
    if "onnxruntime" in modules:
        from onnxruntime import datasets  # its own: three times two numbers, multiplied by 1, 2, 3 …

        session = modules["onnxruntime"].InferenceSession(
            datasets.get_example("mul_1.onnx"), providers=["CPUExecutionProvider"]
        )
        (product,) = session.run(None, {session.get_inputs()[0].name: np.full((3, 2), mean, np.float32)})
        assert np.abs(product.ravel() - mean * np.arange(1, 7)).max() < 1e-3
    runtimes = runtimes_too_many(Path("/proc/self/maps").read_text(), os.uname().machine)
    assert not runtimes, runtimes


def orders(names: list[str], turns: int = 1) -> list[list[str]]:
    """Orders in which each two of the names stand either way: turns of a ring of them, and the same backwards."""
    starts = [turn * len(names) // turns for turn in range(turns)]
    return [ring[::step] for ring in (names[start:] + names[:start] for start in starts) for step in (1, -1)]


def run(order: list[str]) -> str:
    """What went wrong with an order; empty if nothing did."""
    env = {**os.environ, "TF_CPP_MIN_LOG_LEVEL": "2"}
    done = subprocess.run([sys.executable, __file__, *order], env=env, capture_output=True, text=True)
    print(done.stdout, end="", flush=True)
    if done.returncode != 0 or "double free" in done.stderr or not done.stdout.endswith(f"worked: {' '.join(order)}\n"):
        return f"{' '.join(order)}: exit code {done.returncode}\n{done.stderr[-3000:]}"
    return ""


def main(turns: int = 1) -> None:
    promised = [name for name in ("torch", "tensorflow", "onnxruntime") if f"EXPECT_{name.upper()}" in os.environ]
    seeing = ["cv_bridge", "cv2"] if "EXPECT_PACKAGES_PERCEPTION" in os.environ else []
    names = [*seeing, *promised, *(["numpy"] if seeing or promised else [])]
    names.append("rospy" if os.environ["ROS_VERSION"] == "1" else "rclpy")
    all_orders = orders(names, turns)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        if failed := list(filter(None, pool.map(run, all_orders))):
            sys.exit("\n".join(failed))
    print("both" if turns == 1 else len(all_orders), "orders: each works and ends cleanly")


if __name__ == "__main__":
    if sys.argv[1:] in ([], ["--six"]):
        main(3 if sys.argv[1:] else 1)
    else:
        work(sys.argv[1:])
