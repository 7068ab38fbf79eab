#!/usr/bin/env bash
# nvcc by itself, and by CMake with CUDA as a language: kernels, thrust, CUDA's libraries, and libtorch where the image has it. Any
# user may call it. Programs run as far as they do without a GPU.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chown 65534:65534 "$work"
cd "$work"
nobody() { env HOME="$work" setpriv --reuid=65534 --regid=65534 --clear-groups --no-new-privs "$@"; }
quietly() { "$@" >log 2>&1 || { cat log >&2; exit 1; }; }

echo 'int main() { int version = 0; return cudaRuntimeGetVersion(&version) != cudaSuccess || version / 10 != CUDART_VERSION / 10; }' >plain.cu
quietly nobody nvcc -arch=sm_90 -o alone plain.cu
quietly nobody nvcc -arch=all-major -cudart shared -o shared plain.cu
if readelf --dynamic alone | grep libcudart; then exit 1; fi
readelf --dynamic shared | grep --only-matching 'libcudart[.0-9so]*'
nobody ./alone
nobody ./shared

torch=${EXPECT_TORCH:+ON}
quietly nobody cmake -S "$here" -B build -G Ninja -DCMAKE_CUDA_ARCHITECTURES=90 "-DCUDA=${EXPECT_CUDA:?}" "-DTORCH=${torch:-OFF}"
quietly nobody cmake --build build
if grep --ignore-case warning log; then exit 1; fi
nobody build/vectors
if [[ -n $torch ]]; then
  readelf --dynamic build/operator | grep --quiet libcudart
  nobody build/operator
fi
