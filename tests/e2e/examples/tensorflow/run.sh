#!/usr/bin/env bash
# Builds TensorFlow's usual C++ examples side by side and runs them.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
export TF_CPP_MIN_LOG_LEVEL=2
trap 'rm -rf "$work"' EXIT

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_CXX_FLAGS=-O0
cmake --build "$work/build"
for name in train label_image; do
  timeout 120 env -u LD_LIBRARY_PATH "$work/build/$name" "$work"
done
