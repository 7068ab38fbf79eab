"""A message with scores that frameworks computed."""

from __future__ import annotations

from collections.abc import Iterable

from example_msgs.msg import Score


def score(frameworks: Iterable[str]) -> Score:
    message = Score(label="python", scores=[0.5])
    for name in frameworks:
        message.label += f" {name}"
        if name == "torch":
            import torch

            message.scores += torch.softmax(torch.zeros(2), 0).tolist()
        else:
            import tensorflow as tf

            message.scores += tf.nn.softmax(tf.zeros(2)).numpy().tolist()
    return message
