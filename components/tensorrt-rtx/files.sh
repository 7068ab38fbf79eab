#!/usr/bin/env bash
# Python's way to the libraries, which are a part of their own; and the module's usual name, whose package is no wheel.
set -euo pipefail

ln -s /usr/local/lib/rosml/tensorrt-rtx-cc/tensorrt_rtx_libs "${OUT:?}${SITE:?}/tensorrt_rtx_libs"
cat >"$OUT$SITE/tensorrt_rtx.py" <<'MODULE'
"""TensorRT for RTX, under the name that its documentation has."""

from tensorrt_rtx_bindings import *  # noqa: F403
from tensorrt_rtx_bindings import __version__  # noqa: F401
MODULE
