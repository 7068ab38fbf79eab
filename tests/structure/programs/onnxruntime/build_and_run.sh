#!/usr/bin/env bash
# Builds a C++ program with find_package(onnxruntime) and installs it, by plain names and with pkg-config; a C program by the path
# of the header in ONNX Runtime's sources. Runs them as a user without rights, without LD_LIBRARY_PATH: each says what Python says
# of the same models. One of them is exported from PyTorch, where that is in the image.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"

"$here/model.py" "$work"
if [[ -v EXPECT_TORCH ]]; then python3 "$here/export.py" "$work/torch.onnx" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }; fi

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_INSTALL_PREFIX="$work/installed" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" --target install >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
g++ -std=c++17 -o "$work/plain" "$here/infer.cpp" -lonnxruntime
# shellcheck disable=SC2046  # pkg-config prints words
g++ -std=c++17 -o "$work/by_pkg_config" "$here/infer.cpp" $(pkg-config --cflags --libs libonnxruntime)
gcc -o "$work/c_api" "$here/c_api.c" -lonnxruntime

programs=("$work/installed/bin/infer" "$work/installed/bin/variables" "$work/plain" "$work/by_pkg_config")
if readelf --dynamic "${programs[@]}" "$work/c_api" | grep -E 'RPATH|RUNPATH'; then exit 1; fi
run() { env -u LD_LIBRARY_PATH HOME=/ setpriv --reuid=65534 --regid=65534 --clear-groups --no-new-privs "$@"; }
run "$work/c_api"
for model in "$work"/*.onnx; do
  wanted=$(python3 "$here/infer.py" "$model")
  echo "$(basename "$model"): $wanted"
  for program in "${programs[@]}"; do
    found=$(run "$program" "$model")
    [[ $found == "$wanted" ]] || { echo "$(basename "$program") says '$found', Python '$wanted'" >&2 && exit 1; }
  done
done
echo "C++ says what Python says"
