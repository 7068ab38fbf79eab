#!/usr/bin/env bash
# Python's way to the libraries, which are a part of their own; and the module's usual name. Its package on the index is no wheel but
# fetches one when it is installed: a package of that name is here for pip, so that whatever asks for it finds it.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

ln -s /usr/local/lib/rosml/tensorrt-rtx-cc/tensorrt_rtx_libs "${OUT:?}${SITE:?}/tensorrt_rtx_libs"
cat >"$OUT$SITE/tensorrt_rtx.py" <<'MODULE'
"""TensorRT for RTX, under the name that its documentation has."""

from tensorrt_rtx_bindings import *  # noqa: F403
from tensorrt_rtx_bindings import __version__  # noqa: F401
MODULE
"$here/../part/records.py" alias tensorrt_rtx "$(basename "$OUT$SITE"/tensorrt_rtx_*_bindings-*.dist-info)"
