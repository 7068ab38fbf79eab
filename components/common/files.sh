#!/usr/bin/env bash
# Python's way to the CUDA part, which stands apart because it is the same for every Python version.
set -euo pipefail
[[ ${ACCELERATOR:?} == cuda ]] || exit 0

cuda=/usr/local/lib/rosml/cuda
# The frameworks' libraries look for ../../nvidia/*/lib beside them (their RPATH), TensorFlow for ptxas as well.
ln -s "$cuda/nvidia" "${OUT:?}${SITE:?}/nvidia"
