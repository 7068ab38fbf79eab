#!/usr/bin/env python3
"""score.py [FRAMEWORK...]: says what frameworks computed, by way of a generated message as ROS sends it."""

import io
import sys

import example
from example_msgs.msg import Score

sent = example.score(sys.argv[1:])
stream = io.BytesIO()
sent.serialize(stream)
received = Score().deserialize(stream.getvalue())
assert received == sent and len(received.scores) == 2 * len(sys.argv) - 1, received
print("score:", received.label, *received.scores)
