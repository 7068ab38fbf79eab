#!/usr/bin/env bash
# A program that includes the headers of all CUDA libraries, and those that they include in turn, is built by the folder that
# docs/cpp.md names, and by plain names of libraries, and runs. There is no toolkit. cuRAND is there as far as PyTorch wants it (before 2.15).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/program.cpp" <<'END'
#include <cublas_v2.h>
#include <cuda_bf16.h>
#include <cuda_fp16.h>
#include <cuda_profiler_api.h>
#include <cuda_runtime_api.h>
#include <cudnn.h>
#include <cufft.h>
#include <cupti.h>
#ifdef CURAND
#include <curand.h>
#endif
#include <cusolverDn.h>
#include <cusparse.h>
#include <nccl.h>
#include <nvml.h>
#include <nvrtc.h>
#include <nvtx3/nvToolsExt.h>
#include <thrust/complex.h>

#include <cstdio>

int main() {
  int version = 0;
  if (cudaRuntimeGetVersion(&version) != cudaSuccess || version / 10 != CUDART_VERSION / 10) return 1;
  std::printf("CUDA runtime %d\n", version);
}
END
curand=()
home=/usr/local/lib/rosml/cuda-home
if [[ -e $home/lib64/libcurand.so ]]; then curand=(-DCURAND -lcurand); fi
for folder in '' "-L$home/lib64"; do
  # shellcheck disable=SC2086  # no folder is no word
  g++ -std=c++17 -I $home/include -o "$work/program" "$work/program.cpp" "${curand[@]}" $folder -lcudart
done
"$work/program"
