#!/usr/bin/env bash
# Compiles, links and runs a program with nothing but the plain library names, and without LD_LIBRARY_PATH.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$(mktemp)
trap 'rm -f "$program"' EXIT

include=$(python3 -c 'import importlib.util as u; print(u.find_spec("tensorflow").submodule_search_locations[0])')/include
gcc -o "$program" "$here/main.c" -I"$include" -ltensorflow_cc -ltensorflow_framework
[[ $(env -u LD_LIBRARY_PATH "$program") == "libtensorflow ${EXPECT_TENSORFLOW:?}" ]]
