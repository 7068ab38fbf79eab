#!/usr/bin/env bash
# Builds PyTorch's example as its documentation says (-DCMAKE_PREFIX_PATH from torch.utils), and trains on made-up data.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 "$here/write_mnist.py" "$work" & data=$!
cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_CXX_FLAGS=-O0 \
  -DCMAKE_PREFIX_PATH="$(python3 -c 'import torch; print(torch.utils.cmake_prefix_path)')"
cmake --build "$work/build"
wait "$data"
time timeout 300 env -u LD_LIBRARY_PATH "$work/build/mnist" "$work"
