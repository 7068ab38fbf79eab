"""A framework computes, in the release that is expected: computes.py FRAMEWORK [VERSION]."""

import sys

if sys.argv[1] == "torch":
    import torch

    version = torch.__version__.split("+")[0]
    assert (torch.eye(3) @ torch.ones(3, 2)).sum().item() == 6.0
    assert torch.version.cuda is None or torch.backends.cudnn.version()
else:
    import tensorflow as tf

    version = tf.__version__
    assert float(tf.reduce_sum(tf.linalg.matmul(tf.eye(3), tf.ones((3, 2))))) == 6.0
    assert tf.keras.layers.Dense(2)(tf.ones((1, 3))).shape == (1, 2)
assert version in sys.argv[2:] or not sys.argv[2:], version
print("computes:", sys.argv[1], version)
