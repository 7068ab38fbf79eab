"""Sends an action through a message of ROS, in the process of the policy."""

import io
import sys

import numpy
from std_msgs.msg import Float64MultiArray


def send(name, action):
    values = numpy.asarray(action, "float64").ravel()
    raw = io.BytesIO()
    Float64MultiArray(data=values.tolist()).serialize(raw)
    assert values.size and numpy.allclose(Float64MultiArray().deserialize(raw.getvalue()).data, values)
    print(f"acts: {name} with numpy {numpy.__version__} in {sys.prefix}")
