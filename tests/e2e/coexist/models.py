"""models.py FOLDER: the mean of some numbers, as a TorchScript file and as a SavedModel."""

import sys
from pathlib import Path

import tensorflow as tf
import torch


class Mean(torch.nn.Module):
    def forward(self, x: torch.Tensor) -> torch.Tensor:
        return x.mean()


folder = Path(sys.argv[1])
torch.jit.script(Mean()).save(str(folder / "mean.pt"))
module = tf.Module()
module.f = tf.function(lambda x: {"y": tf.reduce_mean(x)[None]}, input_signature=[tf.TensorSpec([None], tf.float32)])
tf.saved_model.save(module, str(folder / "mean"), signatures=module.f)
