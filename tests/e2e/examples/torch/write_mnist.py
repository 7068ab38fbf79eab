"""write_mnist.py FOLDER: made-up data in MNIST's files: a pattern of blocks for each digit, moved a little, with noise.

As many pictures as MNIST has: the C++ class of the data set accepts no other number.
"""

import sys
from pathlib import Path

import numpy as np

folder = Path(sys.argv[1])
random = np.random.default_rng(1)
patterns = np.kron(random.integers(0, 2, (10, 5, 5), dtype=np.uint8), np.full((4, 4), 160, np.uint8))
for name, count in (("train", 60_000), ("t10k", 10_000)):
    digits = random.integers(0, 10, count, dtype=np.uint8)
    pictures = random.integers(0, 95, (count, 28, 28), dtype=np.uint8)
    for place, (x, y) in enumerate(np.ndindex(3, 3)):
        here = np.arange(count) % 9 == place
        pictures[here, 3 + x : 23 + x, 3 + y : 23 + y] += patterns[digits[here]]
    for kind, array in (("images-idx3", pictures), ("labels-idx1", digits)):
        header = np.array([0x800 + array.ndim, *array.shape], dtype=">i4")
        (folder / f"{name}-{kind}-ubyte").write_bytes(header.tobytes() + array.tobytes())
