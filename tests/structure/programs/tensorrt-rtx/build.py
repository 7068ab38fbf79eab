#!/usr/bin/env python3
"""Builds an engine from a model of ONNX, without a GPU: of any size, it has the model's ports."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import tensorrt_rtx as trt

folder = Path(tempfile.mkdtemp())
subprocess.run(["/run/tests/programs/onnxruntime/model.py", folder], check=True)
logger = trt.Logger(trt.Logger.WARNING)
builder = trt.Builder(logger)
network = builder.create_network(0)
parser = trt.OnnxParser(network, logger)
assert parser.parse_from_file(str(folder / "tanh.onnx")), parser.get_error(0).desc()
ports = [network.get_input(0), network.get_output(0)]
assert [(port.name, tuple(port.shape)) for port in ports] == [("x", (2, 4)), ("y", (2, 3))]
engine = builder.build_serialized_network(network, builder.create_builder_config())
assert engine is not None and engine.nbytes > 10_000, engine
