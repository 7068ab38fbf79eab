#!/usr/bin/env python3
"""Makes abseil's hash in TensorFlow's headers the one of its libraries for arm64, whatever compiler reads it.

The libraries were compiled with Clang, which defines __ARM_ACLE: their hash reverses bits where GCC's reverses bytes. A
map of protobuf that the library filled would not find its keys in a program that GCC compiled: nothing is found, or a
check ends the program. Written here without the macro; the file's record follows.
"""

from __future__ import annotations

import os
import sys

import records  # beside this script

HEADER = "tensorflow/include/absl/hash/internal/hash.h"
OLD = """\
#ifdef __ARM_ACLE
    // gbswap_64 compiles to `rev` on ARM, but `rbit` is better because it
    // reverses bits rather than reversing bytes.
    return __rbitll(n * kMul);
#else
"""
NEW = """\
#if defined(__aarch64__)
    // As the libraries do, which were compiled with another compiler than this one, perhaps.
    uint64_t reversed;
    __asm__("rbit %0, %1" : "=r"(reversed) : "r"(n * kMul));
    return reversed;
#else
"""


def main() -> None:
    header = records.SITE / HEADER
    if os.environ["TARGETARCH"] != "arm64" or not header.exists():
        return
    text = header.read_text()
    if "__ARM_ACLE" not in text.partition("namespace absl")[2]:
        return  # releases before 2025 hash alike
    if text.count(OLD) != 1:
        sys.exit(f"abseil_for_gcc: {HEADER} hashes in a way that is not known; compare it with the library's")
    header.unlink()  # a link to uv's copy, perhaps
    header.write_text(text.replace(OLD, NEW))
    records.replace({HEADER: [HEADER, *map(str, records.digest(header))]})
    print(f"abseil_for_gcc: {HEADER} adapted")


if __name__ == "__main__":
    main()
