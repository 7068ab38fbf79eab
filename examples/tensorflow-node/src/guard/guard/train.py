"""Teaches the network with scans that are made here, and writes it: python3 -m guard.train FILE"""

import sys

import keras
import numpy as np

from guard.model import distances, network

FURTHEST = 10.0
"""m"""


def scan(blocked: bool, random: np.random.Generator, rays: int = 180) -> np.ndarray:
    """Distances of a room in m; if the way is blocked, something stands within 1 m in the middle third."""
    ranges = random.uniform(3, FURTHEST) + random.normal(0, 0.05, rays)
    if blocked:
        start = random.integers(rays // 3, 2 * rays // 3 - 20)
        ranges[start : start + 20] = random.uniform(0.2, 1.0)
    return ranges


def train() -> keras.Model:
    """The network after it has seen some scans."""
    keras.utils.set_random_seed(1)
    random = np.random.default_rng(1)
    wanted = np.arange(512) % 2
    scans = np.stack([distances(scan(bool(one), random), FURTHEST) for one in wanted])
    model = network()
    model.compile(optimizer=keras.optimizers.Adam(0.03), loss="binary_crossentropy")
    model.fit(scans, wanted, epochs=15, verbose=0)
    return model


if __name__ == "__main__":
    train().save(sys.argv[1])
