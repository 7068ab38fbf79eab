#!/usr/bin/env python3
"""The operator on the CPU, and on the GPU if there is one: test_gray.py LIBRARY"""

import sys

import torch

torch.ops.load_library(sys.argv[1])
pixels = torch.randint(0, 256, (48, 64, 3), dtype=torch.uint8)
red, green, blue = pixels.float().unbind(2)
wanted = 0.299 * red + 0.587 * green + 0.114 * blue
for device in ["cpu", *(["cuda"] if torch.cuda.is_available() else [])]:
    found = torch.ops.gray.gray(pixels.to(device)).cpu()
    torch.testing.assert_close(found, wanted, rtol=1e-4, atol=1e-3)
    print(f"gray on {device}: right")
