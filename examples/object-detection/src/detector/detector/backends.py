"""What runs a model: ONNX Runtime for files `.onnx`, PyTorch for TorchScript. Both take 1 x 3 x height x width and give N x 6."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

import numpy as np

DEVICES = ("auto", "cpu", "cuda")


class Backend(Protocol):
    """A model that is loaded; `about` says by what, and where it runs."""

    about: str

    def __call__(self, picture: np.ndarray) -> np.ndarray: ...


class OnnxRuntime:
    """A model in ONNX."""

    def __init__(self, model: str, device: str) -> None:
        import onnxruntime

        providers = ["CPUExecutionProvider"]
        if device != "cpu" and "CUDAExecutionProvider" in onnxruntime.get_available_providers():
            providers.insert(0, "CUDAExecutionProvider")
        # If the provider finds no GPU, the session falls back to the CPU, and says so.
        self._session = onnxruntime.InferenceSession(model, providers=providers)
        self._input = self._session.get_inputs()[0].name
        self.device = "cuda" if self._session.get_providers()[0].startswith("CUDA") else "cpu"
        self.about = f"ONNX Runtime {onnxruntime.__version__} on {self.device}"

    def __call__(self, picture: np.ndarray) -> np.ndarray:
        return self._session.run(None, {self._input: picture})[0].reshape(-1, 6)


class Torch:
    """A model in TorchScript."""

    def __init__(self, model: str, device: str) -> None:
        import torch

        self._torch = torch
        self.device = "cuda" if device != "cpu" and torch.cuda.is_available() else "cpu"
        self._model = torch.jit.load(model, map_location=self.device).eval()
        self.about = f"PyTorch {torch.__version__} on {self.device}"

    def __call__(self, picture: np.ndarray) -> np.ndarray:
        with self._torch.inference_mode():
            found = self._model(self._torch.from_numpy(picture).to(self.device))
            return found.cpu().numpy().reshape(-1, 6)


def load(model: str, device: str = "auto") -> Backend:
    """A model from a file, on the GPU if there is one.

    Raises:
        ValueError: there is no such device, or no such file.
        ModuleNotFoundError: the image lacks what the file needs.
    """
    if device not in DEVICES:
        raise ValueError(f"device is {device!r}, and can be {', '.join(DEVICES)}")
    if not Path(model).is_file():
        raise ValueError(f"model is {model!r}, and there is no such file")
    found = OnnxRuntime(model, device) if model.endswith(".onnx") else Torch(model, device)
    if device == "cuda" and found.device != device:
        raise ValueError(f"no GPU: {found.about}")
    return found
