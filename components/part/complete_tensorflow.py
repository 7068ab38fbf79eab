#!/usr/bin/env python3
"""Completes TensorFlow's C++ headers by what programs take for granted and the wheels lack.

* Constants of SavedModel, whose headers are not in the wheels. A structure test compares the values with Python's.
* Eigen under the name that it has in TensorFlow's sources and had in older wheels (`third_party/eigen3`).
* The release, which newer headers want from the command line, and whose `TF_VERSION_STRING` left `version.h`.
* The alignment of Eigen in TensorFlow: with another one, a program would allocate memory in another way than the library frees it.

What the command line defines counts more. Records of the wheel follow.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import records  # beside this script

INCLUDE = "tensorflow/include"
SAVED_MODEL = f"{INCLUDE}/tensorflow/cc/saved_model"
EIGEN = f"{INCLUDE}/Eigen/src/Core/util/ConfigureVectorization.h"
VERSION = f"{INCLUDE}/tensorflow/core/public/version.h"
RELEASE_HEADER = "tensorflow/core/public/release_version.h"
RELEASE = f"{INCLUDE}/{RELEASE_HEADER}"

CONSTANTS = {
    "tag_constants": {
        "kSavedModelTagServe": "serve",
        "kSavedModelTagTrain": "train",
        "kSavedModelTagGpu": "gpu",
        "kSavedModelTagTpu": "tpu",
    },
    "signature_constants": {
        "kDefaultServingSignatureDefKey": "serving_default",
        "kClassifyInputs": "inputs",
        "kClassifyMethodName": "tensorflow/serving/classify",
        "kClassifyOutputClasses": "classes",
        "kClassifyOutputScores": "scores",
        "kPredictInputs": "inputs",
        "kPredictMethodName": "tensorflow/serving/predict",
        "kPredictOutputs": "outputs",
        "kRegressInputs": "inputs",
        "kRegressMethodName": "tensorflow/serving/regress",
        "kRegressOutputs": "outputs",
    },
}

EIGEN_NAMES = ("Eigen/Core", "unsupported/Eigen/CXX11/Tensor", "unsupported/Eigen/CXX11/ThreadPool")

ALIGNMENT = """\
// As TensorFlow's libraries were compiled.
#ifndef EIGEN_MAX_ALIGN_BYTES
#define EIGEN_MAX_ALIGN_BYTES 64
#endif
"""


def header(constants: dict[str, str]) -> str:
    lines = [f'inline constexpr char {name}[] = "{value}";' for name, value in constants.items()]
    return "\n".join(["#pragma once", "", "namespace tensorflow {", *lines, "}  // namespace tensorflow", ""])


def releases(wheel: str) -> dict[str, str]:
    """Macros and their values, from a name such as `tensorflow_cpu-2.21.0rc1.dist-info`."""
    match = re.search(r"-(\d+)\.(\d+)\.(\d+)([^-]*)\.dist-info$", wheel)
    if not match:
        sys.exit(f"complete_tensorflow: {wheel} names no release")
    major, minor, patch, suffix = match.groups()
    return {
        "TF_MAJOR_VERSION": major,
        "TF_MINOR_VERSION": minor,
        "TF_PATCH_VERSION": patch,
        "TF_VERSION_SUFFIX": f'"{suffix}"',
    }


def with_defaults(text: str, macros: dict[str, str]) -> str:
    """A header with defaults in the place of its errors about macros that are not defined."""
    for name, value in macros.items():
        text, count = re.subn(rf"(#ifndef {name}\n)#error [^\n]*\n", rf"\g<1>#define {name} {value}\n", text)
        if count != 1:
            sys.exit(f"complete_tensorflow: {RELEASE} asks for {name} in a way that is not known")
    return text


def after(text: str, line: str, added: str) -> str:
    """A text with an addition after its only line of this kind."""
    if text.count(line) != 1:
        sys.exit(f"complete_tensorflow: {line.strip()!r} is not where it is looked for")
    return text.replace(line, f"{line}{added}")


def write(path: str, text: str) -> None:
    """Writes a file below the packages, which may be a link to uv's copy."""
    file = records.SITE / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    file.write_text(text)


def main() -> None:
    site: Path = records.SITE
    if not (site / VERSION).exists():
        return
    wheel = next(record for record in site.glob("*.dist-info/RECORD") if f"\n{VERSION}," in record.read_text())
    changed = [EIGEN]
    write(EIGEN, after((site / EIGEN).read_text(), "#define EIGEN_CONFIGURE_VECTORIZATION_H\n", ALIGNMENT))
    if (site / RELEASE).exists():
        changed += [RELEASE, VERSION]
        write(RELEASE, with_defaults((site / RELEASE).read_text(), releases(wheel.parent.name)))
        guard = "#define TENSORFLOW_CORE_PUBLIC_VERSION_H_\n"
        write(VERSION, after((site / VERSION).read_text(), guard, f'\n#include "{RELEASE_HEADER}"\n'))
    records.replace({path: [path, *map(str, records.digest(site / path))] for path in changed})
    added = {f"{SAVED_MODEL}/{name}.h": header(constants) for name, constants in CONSTANTS.items()}
    added.update({f"{INCLUDE}/third_party/eigen3/{name}": f"#pragma once\n#include <{name}>\n" for name in EIGEN_NAMES})
    added = {path: text for path, text in added.items() if not (site / path).exists()}
    for path, text in added.items():
        write(path, text)
    rows = [[path, *map(str, records.digest(site / path))] for path in added]
    records.write(wheel, [*records.read(wheel), *rows])
    for path in [*changed, *added]:
        print(f"complete_tensorflow: {path}")


if __name__ == "__main__":
    main()
