#!/usr/bin/env python3
"""What PyTorch, TensorFlow and TensorRT for RTX do with the GPU that is here: each result is compared with the CPU's.

  docker run --rm --gpus all -v "$PWD/tests/gpu:/probe:ro" <image> /probe/run.sh

Prints a line for each probe and ends with exit code 1 if one failed, 2 if there is nothing to probe.
`--json` prints one JSON object instead.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import sys
import time
import traceback
from typing import Any, Callable, Iterator

Probe = Callable[[], str]


def torch_probes() -> Iterator[tuple[str, Probe]]:
    """PyTorch: matrix products, cuDNN, automatic differentiation, compiled kernels (Triton), NCCL."""
    import torch

    torch.manual_seed(0)

    def device() -> str:
        assert torch.cuda.is_available(), "torch.cuda.is_available() is False: no driver, or one too old for this CUDA"
        major, minor = torch.cuda.get_device_capability()
        return (
            f"{torch.cuda.get_device_name()}, sm_{major}{minor}, CUDA {torch.version.cuda}, torch {torch.__version__}"
        )

    def close(ours: Any, theirs: Any, tolerance: float) -> str:
        difference = (ours.float().cpu() - theirs.float()).abs().max().item()
        assert difference <= tolerance, f"differs from the CPU by {difference}"
        return f"within {tolerance:g} of the CPU"

    def product() -> str:
        a, b = torch.randn(512, 512), torch.randn(512, 512)
        return close(a.cuda() @ b.cuda(), a @ b, 1e-2)

    def convolution() -> str:
        layer, x = torch.nn.Conv2d(3, 8, 3), torch.randn(2, 3, 32, 32)
        expected = layer(x).detach()
        return f"cuDNN {torch.backends.cudnn.version()}, " + close(layer.cuda()(x.cuda()).detach(), expected, 1e-2)

    def gradient() -> str:
        x = torch.randn(64, 64, device="cuda", requires_grad=True)
        torch.linalg.norm(x).backward()
        return close(x.grad, (x / torch.linalg.norm(x)).detach().cpu(), 1e-5)

    def solver() -> str:
        a, b = torch.randn(64, 64) + 64 * torch.eye(64), torch.randn(64, 4)
        return "cuSOLVER, " + close(torch.linalg.solve(a.cuda(), b.cuda()), torch.linalg.solve(a, b), 1e-4)

    def spectrum() -> str:
        x = torch.randn(1024)
        return "cuFFT, " + close(torch.fft.rfft(x.cuda()).abs(), torch.fft.rfft(x).abs(), 1e-3)

    def sparse() -> str:
        a, b = torch.randn(64, 64).relu(), torch.randn(64, 8)
        return "cuSPARSE, " + close(a.to_sparse_csr().cuda() @ b.cuda(), a @ b, 1e-3)

    def compiled() -> str:
        def f(x: Any) -> Any:
            return torch.sin(x) ** 2 + torch.cos(x) ** 2

        return "Triton, " + close(torch.compile(f)(torch.randn(1000, device="cuda")), torch.ones(1000), 1e-5)

    def reduction() -> str:
        import torch.distributed as dist

        dist.init_process_group("nccl", init_method="tcp://127.0.0.1:29531", rank=0, world_size=1)
        x = torch.ones(8, device="cuda")
        dist.all_reduce(x)
        dist.destroy_process_group()
        version = ".".join(map(str, torch.cuda.nccl.version()))
        return f"NCCL {version}, " + close(x, torch.ones(8), 0)

    yield from {
        "device": device,
        "matrix product": product,
        "convolution": convolution,
        "gradient": gradient,
        "linear solver": solver,
        "Fourier transform": spectrum,
        "sparse product": sparse,
        "torch.compile": compiled,
        "all-reduce of one": reduction,
    }.items()


def tensorflow_probes() -> Iterator[tuple[str, Probe]]:
    """TensorFlow: matrix products, cuDNN, XLA."""
    import tensorflow as tf

    def device() -> str:
        devices = tf.config.list_physical_devices("GPU")
        assert devices, (
            "TensorFlow sees no GPU: no driver, or a library that it could not load (see its messages above)"
        )
        name = tf.config.experimental.get_device_details(devices[0]).get("device_name", "?")
        return f"{name}, CUDA {tf.sysconfig.get_build_info().get('cuda_version')}, tensorflow {tf.__version__}"

    def close(function: Callable[..., Any], *arguments: Any, tolerance: float) -> str:
        with tf.device("/CPU:0"):
            expected = function(*arguments)
        with tf.device("/GPU:0"):
            result = function(*arguments)
        assert "GPU" in result.device, result.device
        difference = float(tf.reduce_max(tf.abs(result - expected)))
        assert difference <= tolerance, f"differs from the CPU by {difference}"
        return f"within {tolerance:g} of the CPU"

    def product() -> str:
        a = tf.random.normal((512, 512), seed=1)
        return close(tf.linalg.matmul, a, a, tolerance=1e-1)

    def convolution() -> str:
        x, w = tf.random.normal((2, 32, 32, 3)), tf.random.normal((3, 3, 3, 8))
        return "cuDNN, " + close(lambda x, w: tf.nn.conv2d(x, w, 1, "SAME"), x, w, tolerance=1e-1)

    def compiled() -> str:
        function = tf.function(lambda x: tf.sin(x) ** 2 + tf.cos(x) ** 2, jit_compile=True)
        with tf.device("/GPU:0"):
            result = function(tf.random.normal((1000,)))
        assert float(tf.reduce_max(tf.abs(result - 1))) < 1e-5
        return "XLA"

    yield from {
        "device": device,
        "matrix product": product,
        "convolution": convolution,
        "jit_compile": compiled,
    }.items()


def tensorrt_rtx_probes() -> Iterator[tuple[str, Probe]]:
    """TensorRT for RTX: an engine is built, compiled for this GPU and run. Only the driver is called besides."""
    import ctypes
    import struct

    import tensorrt_rtx as trt

    values = [0.5, -1.0, 2.0, 0.25]

    def called(function: str, *arguments: Any) -> None:
        code = getattr(ctypes.CDLL("libcuda.so.1"), function)(*arguments)
        assert code == 0, f"{function}: error {code} of the driver"

    def device() -> str:
        name, chosen, context = ctypes.create_string_buffer(100), ctypes.c_int(), ctypes.c_void_p()
        called("cuInit", 0)
        called("cuDeviceGet", ctypes.byref(chosen), 0)
        called("cuDeviceGetName", name, 100, chosen)
        called("cuDevicePrimaryCtxRetain", ctypes.byref(context), chosen)
        called("cuCtxSetCurrent", context)
        return f"{name.value.decode()}, tensorrt_rtx {trt.__version__}"

    def built() -> Any:
        """tanh(x * 3), as the plan of an engine for every GPU."""
        builder = trt.Builder(logger)
        network = builder.create_network(0)
        x = network.add_input("x", trt.float32, (len(values),))
        three = network.add_constant((len(values),), trt.Weights(trt.float32, weights_at, len(values))).get_output(0)
        product = network.add_elementwise(x, three, trt.ElementWiseOperation.PROD).get_output(0)
        y = network.add_activation(product, trt.ActivationType.TANH).get_output(0)
        y.name = "y"
        network.mark_output(y)
        return builder.build_serialized_network(network, builder.create_builder_config())

    def engine() -> str:
        import math

        plan = built()
        assert plan is not None, "no engine was built: see its messages above"
        size, outputs = 4 * len(values), (ctypes.c_float * len(values))()
        places = {"x": ctypes.c_uint64(), "y": ctypes.c_uint64()}
        for place in places.values():
            called("cuMemAlloc_v2", ctypes.byref(place), ctypes.c_size_t(size))
        called("cuMemcpyHtoD_v2", places["x"], struct.pack(f"{len(values)}f", *values), ctypes.c_size_t(size))
        loaded = trt.Runtime(logger).deserialize_cuda_engine(plan)
        assert loaded is not None, "the engine does not load on this GPU: see its messages above"
        context = loaded.create_execution_context()
        for name, place in places.items():
            context.set_tensor_address(name, place.value)
        assert context.execute_async_v3(0), "the engine does not run: see its messages above"
        called("cuCtxSynchronize")
        called("cuMemcpyDtoH_v2", outputs, places["y"], ctypes.c_size_t(size))
        difference = max(abs(y - math.tanh(3 * x)) for x, y in zip(values, outputs))
        assert difference <= 1e-2, f"differs from the CPU by {difference}"
        return "within 0.01 of the CPU"

    logger = trt.Logger(trt.Logger.WARNING)
    weights = (ctypes.c_float * len(values))(*[3.0] * len(values))
    weights_at = ctypes.addressof(weights)
    yield from {"device": device, "engine": engine}.items()


PROBES = {"torch": torch_probes, "tensorflow": tensorflow_probes, "tensorrt_rtx": tensorrt_rtx_probes}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    as_json = parser.parse_args().json
    outcomes = []
    for framework, probes in PROBES.items():
        if importlib.util.find_spec(framework) is None:
            continue
        for name, probe in probes():
            began = time.perf_counter()
            try:
                passed, text = True, probe()
            except Exception as error:
                passed, text = False, str(error) or traceback.format_exc()
            seconds = round(time.perf_counter() - began, 2)
            outcomes.append({"framework": framework, "probe": name, "passed": passed, "seconds": seconds, "said": text})
            if not as_json:
                print(f"{'ok' if passed else 'FAILED':7}{framework}: {name}: {text} ({seconds} s)", flush=True)
            if not passed and name == "device":
                break  # nothing else can work
    if as_json:
        print(json.dumps({"outcomes": outcomes}, indent=1))
    if not outcomes:
        print("there is none of torch, tensorflow and tensorrt_rtx here", file=sys.stderr)
        return 2
    return 0 if all(outcome["passed"] for outcome in outcomes) else 1


if __name__ == "__main__":
    sys.exit(main())
