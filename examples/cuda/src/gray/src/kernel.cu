#include "kernel.h"

namespace {

__global__ void gray(const std::uint8_t* pixels, float* brightness, std::int64_t count) {
  const std::int64_t at = blockIdx.x * static_cast<std::int64_t>(blockDim.x) + threadIdx.x;
  if (at < count) {
    const std::uint8_t* pixel = pixels + 3 * at;
    brightness[at] = 0.299f * pixel[0] + 0.587f * pixel[1] + 0.114f * pixel[2];
  }
}

}  // namespace

cudaError_t gray_on_gpu(const std::uint8_t* pixels, float* brightness, std::int64_t count, cudaStream_t stream) {
  if (count > 0) gray<<<static_cast<unsigned>((count + 255) / 256), 256, 0, stream>>>(pixels, brightness, count);
  return cudaGetLastError();
}
