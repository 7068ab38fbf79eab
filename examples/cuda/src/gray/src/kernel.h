#pragma once

#include <cuda_runtime_api.h>

#include <cstdint>

// Writes how bright each pixel is; `pixels` has three bytes for each: red, green, blue. Both are in the GPU's memory.
cudaError_t gray_on_gpu(const std::uint8_t* pixels, float* brightness, std::int64_t count, cudaStream_t stream);
