"""A small network that says from distances whether something stands in the way."""

import keras
import numpy as np

RAYS = 64
"""How many distances the network gets, of the middle third of a scan."""


def network() -> keras.Model:
    """Takes N x RAYS distances between 0 (here) and 1 (as far as the laser sees), gives N x 1 between 0 and 1 (in the way)."""
    layers = keras.layers
    return keras.Sequential(
        [
            keras.Input((RAYS,)),
            layers.Reshape((RAYS, 1)),
            layers.Conv1D(8, 5, activation="relu"),
            layers.GlobalMaxPooling1D(),
            layers.Dense(1, activation="sigmoid"),
        ]
    )


def distances(ranges: np.ndarray, furthest: float) -> np.ndarray:
    """What the network gets of a scan in m; where the laser saw nothing, it is free."""
    seen = np.nan_to_num(ranges, nan=furthest, posinf=furthest).clip(0, furthest) / furthest
    middle = seen[len(seen) // 3 : 2 * len(seen) // 3]
    return np.interp(np.linspace(0, 1, RAYS), np.linspace(0, 1, len(middle)), middle).astype(np.float32)


def blocked(model: keras.Model, ranges: np.ndarray, furthest: float) -> bool:
    """Whether something stands in the way of one scan."""
    return bool(model(distances(ranges, furthest)[None])[0, 0] > 0.5)
