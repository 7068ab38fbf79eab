#!/usr/bin/env python3
"""Adapts abseil in TensorFlow's headers to its libraries, which were compiled with Clang, for all compilers. The records follow.

* On arm64 Clang defines __ARM_ACLE, and its hash reverses bits where GCC's reverses bytes: a program that GCC compiled would not find the
  keys of a map that the library filled.
* Clang 18 and GCC give some templates different names. The headers say that the library has them, so that programs with `LOG(INFO) << 1`
  did not link. Here, GCC makes its own.
"""

from __future__ import annotations

import os
import re
import sys

import records  # beside this script

INCLUDE = "tensorflow/include/absl"
HASH = f"{INCLUDE}/hash/internal/hash.h"
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
LOG = f"{INCLUDE}/log/internal/log_message.h"
CORD = f"{INCLUDE}/strings/cord.h"
PROMISES = {
    LOG: re.compile(
        r"(?<!#ifdef __clang__\n)(?:extern template LogMessage& LogMessage::operator<<\([^;]*\);\n)+(?!#endif)"
    ),
    CORD: re.compile(r"(?<!#ifdef __clang__\n)extern template (?:void )?Cord::(\w+)\(std::string&& src\);\n"),
}
"""Templates that the headers promise, and whose names depend on the compiler."""


def hashed_alike(text: str) -> str:
    """The header of the hash for arm64, of any release."""
    if "__ARM_ACLE" not in text.partition("namespace absl")[2]:
        return text  # releases before 2025 hash alike
    if text.count(OLD) != 1:
        sys.exit(f"abseil_for_gcc: {HASH} hashes in a way that is not known; compare it with the library's")
    return text.replace(OLD, NEW)


def for_others(promise: re.Match[str]) -> str:
    """What other compilers than Clang read in place of a promise; nothing if the header has the template's body."""
    instead = ""
    if promise.re is PROMISES[CORD]:
        name = promise[1]
        call = f"{name}(absl::string_view(src))"
        body = f"Cord::Cord(T&& src) : {call} {{}}" if name == "Cord" else f"void Cord::{name}(T&& src) {{ {call}; }}"
        instead = f"\n#else\ntemplate <typename T, Cord::EnableIfString<T>>\n{body}"
    return f"#ifdef __clang__\n{promise[0].rstrip()}{instead}\n#endif\n"


def main() -> None:
    changed = {}
    for path in (HASH, LOG, CORD):
        header = records.SITE / path
        if not header.exists():
            continue
        text = header.read_text()
        if path in PROMISES:
            adapted = PROMISES[path].sub(for_others, text)
        else:
            adapted = hashed_alike(text) if os.environ["TARGETARCH"] == "arm64" else text
        if adapted != text:
            header.unlink()  # a link to uv's copy, perhaps
            header.write_text(adapted)
            changed[path] = [path, *map(str, records.digest(header))]
            print(f"abseil_for_gcc: {path} adapted")
    records.replace(changed)


if __name__ == "__main__":
    main()
