"""A network with random weights as a model of ONNX."""

import numpy
import onnxruntime
from common import send
from onnx import TensorProto, helper, numpy_helper

weights = numpy.random.default_rng(0).normal(size=(12, 6)).astype("float32")
graph = helper.make_graph(
    [helper.make_node("MatMul", ["observation", "weights"], ["sums"]), helper.make_node("Tanh", ["sums"], ["action"])],
    "policy",
    [helper.make_tensor_value_info("observation", TensorProto.FLOAT, [1, 12])],
    [helper.make_tensor_value_info("action", TensorProto.FLOAT, [1, 6])],
    [numpy_helper.from_array(weights, "weights")],
)
model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 20)], ir_version=10)
session = onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])
[action] = session.run(None, {"observation": numpy.ones((1, 12), "float32")})
send(f"onnxruntime {onnxruntime.__version__}", action)
