#!/usr/bin/env python3
"""Exports a model from PyTorch, and compares what both say: `export.py FILE`."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import infer
import torch

torch.manual_seed(1)
network = torch.nn.Sequential(
    torch.nn.Conv2d(3, 4, 3), torch.nn.ReLU(), torch.nn.Flatten(), torch.nn.Linear(4 * 6 * 6, 5), torch.nn.Softmax(1)
).eval()
picture = torch.arange(3 * 8 * 8, dtype=torch.float32).reshape(1, 3, 8, 8) * 0.1
# The older of PyTorch's two ways. It looks through the model for functions of others, of which there are none, with the package onnx,
# which is not in the image.
lacking = ModuleType("onnx")
lacking.load_model_from_string = lambda _: SimpleNamespace(graph=SimpleNamespace(node=()))  # type: ignore[attr-defined]
sys.modules["onnx"] = lacking
torch.onnx.export(network, (picture,), sys.argv[1], dynamo=False)
result = torch.from_numpy(infer.infer(Path(sys.argv[1])))
assert torch.allclose(result, network(picture), atol=1e-5), (result, network(picture))
