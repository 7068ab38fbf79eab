#!/usr/bin/env bash
# Configures, builds, installs and runs the program; the installed one has no RPATH and runs without LD_LIBRARY_PATH.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DCMAKE_INSTALL_PREFIX="$work/installed" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
# The path of torch.utils.cmake_prefix_path leads there as well. The same folder again: the compiler is known there.
site=$(python3 -c 'import importlib.util as u; print(u.find_spec("torch").submodule_search_locations[0])')
cmake -S "$here" -B "$work/build" -DTorch_DIR="$site/share/cmake/Torch" >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --install "$work/build" >/dev/null
env -u LD_LIBRARY_PATH "$work/installed/bin/torch_program"
