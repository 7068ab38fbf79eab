#!/usr/bin/env python3
"""Python runs a model as infer.cpp does, and prints the same: `infer.py MODEL`. Without a model: those of model.py, whose results
are known, and the versions that the tag promises."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

import model
import numpy as np
import onnxruntime as ort


def infer(path: Path) -> np.ndarray:
    """The result of a model whose input is 0, 0.1, 0.2 …"""
    options = ort.SessionOptions()
    options.intra_op_num_threads = 1
    session = ort.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
    (model_input,) = session.get_inputs()
    numbers = np.arange(np.prod(model_input.shape), dtype=np.float32) * np.float32(0.1)
    (result,) = session.run(None, {model_input.name: numbers.reshape(model_input.shape)})
    return np.asarray(result)


def main() -> None:
    promised = os.environ["EXPECT_ONNXRUNTIME"]
    assert ort.__version__ == promised == os.environ["ONNXRUNTIME_VERSION"], ort.__version__
    with tempfile.TemporaryDirectory() as folder:
        model.main(Path(folder))
        result = infer(Path(folder, "tanh.onnx"))
        inputs = np.arange(8, dtype=np.float32).reshape(2, 4) / 10
        expected = np.tanh(inputs @ np.asarray(model.WEIGHTS, np.float32) + np.asarray(model.BIAS, np.float32))
        assert np.abs(result - expected).max() < 1e-5, (result, expected)
        assert abs(infer(Path(folder, "mean.onnx")).item() - 0.15) < 1e-6
    print(f"onnxruntime {ort.__version__}: right")


if __name__ == "__main__":
    if sys.argv[1:]:
        print(f"onnxruntime {ort.__version__}:", *(f"{value:.6g}" for value in infer(Path(sys.argv[1])).ravel()))
    else:
        main()
