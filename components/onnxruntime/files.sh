#!/usr/bin/env bash
# Python takes ONNX Runtime's libraries from the part onnxruntime-cc, which has them for every Python and for C++.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

cc=/usr/local/lib/rosml/onnxruntime-cc
shared=(onnxruntime/LICENSE onnxruntime/ThirdPartyNotices.txt)
for library in "${OUT:?}${SITE:?}"/onnxruntime/capi/libonnxruntime*; do
  path=${library#"$OUT$SITE/"}
  case $path in
    # It differs from wheel to wheel (onnxruntime-cc/files.sh).
    */libonnxruntime_providers_cuda.so) ln -sf "$cc/$path" "$library" ;;
    *) shared+=("$path") ;;
  esac
done
"$here/../part/records.py" link "$cc" "${shared[@]}"

# Releases from 1.29.0 on send what a program does to their maker, unless a variable says no. Images have it (matrix.yaml). Python sets
# it, too: a program may have lost the image's variables, as behind sudo, or got the files alone. ORT_DISABLE_TELEMETRY=0 says yes.
if grep -q ORT_DISABLE_TELEMETRY "$OUT$SITE"/onnxruntime/capi/onnxruntime_pybind11_state*; then
  sed -i '/^import contextlib$/a import os\n\nos.environ.setdefault("ORT_DISABLE_TELEMETRY", "1")' "$OUT$SITE/onnxruntime/__init__.py"
  grep -q '^os.environ' "$OUT$SITE/onnxruntime/__init__.py" || {
    echo "onnxruntime: it begins otherwise than files.sh knows, so nothing turns its telemetry off" >&2 && exit 1
  }
fi

# Wheels with CUDA are called onnxruntime-gpu, and what depends on ONNX Runtime asks for onnxruntime.
"$here/../part/records.py" alias onnxruntime "$(basename "$OUT$SITE"/onnxruntime*.dist-info)"
