#!/usr/bin/env python3
"""save_model.py FOLDER: saves a model that computes y = factor * x, with a variable for the factor, and prints the constants
of the format."""

import sys

import tensorflow as tf
from tensorflow.python.saved_model import signature_constants, tag_constants


class Scale(tf.Module):
    def __init__(self) -> None:
        super().__init__()
        self.factor = tf.Variable(3.0)

    @tf.function(input_signature=[tf.TensorSpec([None], tf.float32, name="x")])
    def __call__(self, x: tf.Tensor) -> dict:
        return {"y": self.factor * x}


model = Scale()
tf.saved_model.save(model, sys.argv[1], signatures=model.__call__)

for constants in (tag_constants, signature_constants):
    for name, value in vars(constants).items():
        if isinstance(value, str) and name.isupper():
            print(f"{name}={value}")
