#!/usr/bin/env python3
"""The client talks to a server over gRPC: is it there, what does the model take, and an answer of the model.

The server is this program's own. It speaks the KServe protocol, version 2, as Triton does, by the classes that the client brings. Its model
doubles numbers and gives words back in capitals.
"""

from __future__ import annotations

import os
import sys
from concurrent import futures
from importlib import metadata
from typing import Any

import grpc
import numpy as np
import tritonclient.grpc as client
from tritonclient.grpc import service_pb2, service_pb2_grpc
from tritonclient.utils import InferenceServerException, deserialize_bytes_tensor, serialize_byte_tensor

MODEL = "double"


class Server(service_pb2_grpc.GRPCInferenceServiceServicer):
    """A server of one model."""

    def ServerLive(self, request: Any, context: Any) -> Any:
        return service_pb2.ServerLiveResponse(live=True)

    def ModelMetadata(self, request: Any, context: Any) -> Any:
        if request.name != MODEL:
            context.abort(grpc.StatusCode.NOT_FOUND, f"no model {request.name}")
        tensor = service_pb2.ModelMetadataResponse.TensorMetadata
        inputs = [tensor(name="x", datatype="FP32", shape=[-1, 2]), tensor(name="words", datatype="BYTES", shape=[-1])]
        return service_pb2.ModelMetadataResponse(name=MODEL, versions=["1"], platform="test", inputs=inputs)

    def ModelInfer(self, request: Any, context: Any) -> Any:
        contents = {tensor.name: raw for tensor, raw in zip(request.inputs, request.raw_input_contents)}
        shapes = {tensor.name: tensor.shape for tensor in request.inputs}
        answer = service_pb2.ModelInferResponse(model_name=request.model_name, model_version="1", id=request.id)
        words = np.array([word.upper() for word in deserialize_bytes_tensor(contents["words"])], dtype=np.object_)
        for name, kind, raw in (
            ("x", "FP32", (np.frombuffer(contents["x"], np.float32) * 2).tobytes()),
            ("words", "BYTES", serialize_byte_tensor(words).item()),
        ):
            answer.outputs.add(name=name, datatype=kind, shape=shapes[name])
            answer.raw_output_contents.append(raw)
        return answer


def main() -> None:
    server = grpc.server(futures.ThreadPoolExecutor(2))
    service_pb2_grpc.add_GRPCInferenceServiceServicer_to_server(Server(), server)
    port = server.add_insecure_port("127.0.0.1:0")
    server.start()
    # A proxy of the machine could not reach this server.
    triton = client.InferenceServerClient(f"127.0.0.1:{port}", channel_args=[("grpc.enable_http_proxy", 0)])
    assert triton.is_server_live(client_timeout=20)
    model_facts = triton.get_model_metadata(MODEL, client_timeout=20)
    assert [tensor.name for tensor in model_facts.inputs] == ["x", "words"], model_facts
    x = np.arange(6, dtype=np.float32).reshape(3, 2)
    words = np.array(["left", "right"], dtype=np.object_)
    inputs = [client.InferInput("x", x.shape, "FP32"), client.InferInput("words", words.shape, "BYTES")]
    inputs[0].set_data_from_numpy(x)
    inputs[1].set_data_from_numpy(words)
    outputs = [client.InferRequestedOutput(name) for name in ("x", "words")]
    answer = triton.infer(MODEL, inputs, outputs=outputs, request_id="7", client_timeout=20)
    assert answer.get_response().id == "7"
    assert answer.as_numpy("x").tolist() == (x * 2).tolist()
    assert answer.as_numpy("words").tolist() == [b"LEFT", b"RIGHT"]
    try:
        triton.get_model_metadata("other", client_timeout=20)
    except InferenceServerException as error:
        assert "no model other" in str(error), error
    else:
        sys.exit("a model that is not there was found")
    triton.close()
    server.stop(None)
    version = metadata.version("tritonclient")
    assert version == os.environ["EXPECT_TRITONCLIENT"], version
    print(f"tritonclient {version}: {answer.as_numpy('x').sum():g}")


if __name__ == "__main__":
    main()
