"""One process with ROS, numpy, OpenCV, cv_bridge, and the frameworks that the image promises: whichever is imported
first, each does its work, and the process ends cleanly.

Without arguments: runs itself once for each order. `process.py NAME…`: one process with that order.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path


def work(names: list[str]) -> None:
    """Imports everything in an order, then works with each on the same picture."""
    import importlib

    modules = {name: importlib.import_module(name) for name in names}
    cv2, cv_bridge = modules["cv2"], modules["cv_bridge"]
    import numpy as np
    import rospy
    from sensor_msgs.msg import Image

    picture = np.arange(4 * 6 * 3, dtype=np.uint8).reshape(4, 6, 3)
    bridge = cv_bridge.CvBridge()
    message = bridge.cv2_to_imgmsg(picture, "bgr8")
    assert isinstance(message, Image) and (message.height, message.width) == (4, 6)
    seen = bridge.imgmsg_to_cv2(message, "rgb8")
    assert (seen == picture[:, :, ::-1]).all()
    assert (seen == cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)).all()
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
    # Two runtimes of OpenMP in one process would each start a thread for every processor.
    mapped = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines()}
    runtimes = [path for path in mapped if re.search(r"/lib(gomp|iomp5|omp)[-.]", path)]
    assert len(runtimes) <= 1, runtimes
    assert rospy.Time.from_sec(1.5).nsecs == 500_000_000
    print("worked:", " ".join(names))


def main() -> None:
    """Every name is the first one once."""
    promised = [name for name in ("torch", "tensorflow") if f"EXPECT_{name.upper()}" in os.environ]
    names = ["cv_bridge", "cv2", *promised]
    orders = [names[start:] + names[:start] for start in range(len(names))]
    env = {**os.environ, "TF_CPP_MIN_LOG_LEVEL": "2"}
    running = [
        (order, subprocess.Popen([sys.executable, __file__, *order], env=env, stderr=subprocess.PIPE, text=True))
        for order in orders
    ]
    for order, process in running:
        _, said = process.communicate()
        if process.returncode != 0 or "double free" in said:
            sys.exit(f"{' '.join(order)}: exit code {process.returncode}\n{said[-3000:]}")


if __name__ == "__main__":
    work(sys.argv[1:]) if len(sys.argv) > 1 else main()
