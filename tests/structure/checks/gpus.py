#!/usr/bin/env python3
"""The GPU architectures that a framework's libraries were built for are those that the labels promise; and the variable by
which NVIDIA's runtime refuses an old driver is there where CUDA is, and nowhere else.

gpus.py torch | tensorflow | driver
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path


def of_torch() -> list[str]:
    """What PyTorch was built for, as its library has it: torch.cuda.get_arch_list() of older releases says nothing without
    a GPU."""
    spec = find_spec("torch")
    assert spec and spec.submodule_search_locations, "torch is not there"
    library = Path(spec.submodule_search_locations[0], "lib/libtorch_python.so").read_bytes()
    found = {match[1].decode() for match in re.finditer(rb"\0((?:sm_[0-9]+[af]?)(?: sm_[0-9]+[af]?)*) ?\0", library)}
    assert len(found) < 2, found
    return " ".join(found).split()


def of_tensorflow() -> list[str]:
    """What TensorFlow was built for."""
    return list(import_module("tensorflow").sysconfig.get_build_info().get("cuda_compute_capabilities", []))


def wrong(what: str, found: object, promised: object) -> None:
    """Ends with an error unless the two are the same."""
    if found != promised:
        sys.exit(f"{what}: {found}, expected {promised}")


if __name__ == "__main__":
    (what,) = sys.argv[1:]
    if what == "driver":
        cuda = os.environ.get("EXPECT_CUDA")
        wrong("NVIDIA_REQUIRE_CUDA", os.environ.get("NVIDIA_REQUIRE_CUDA"), cuda and f"cuda>={cuda.split('.')[0]}.0")
    else:
        asked = ["dpkg", "--print-architecture"]
        architecture = subprocess.run(asked, stdout=subprocess.PIPE, text=True, check=True).stdout.strip().upper()
        promised = os.environ.get(f"EXPECT_GPU_{what.upper()}_{architecture}", "")
        wrong(what, {"torch": of_torch, "tensorflow": of_tensorflow}[what](), promised.split(",") if promised else [])
        print(promised or "for the CPU")
