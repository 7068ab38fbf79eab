#include <ATen/ATen.h>
#include <c10/cuda/CUDAException.h>
#include <c10/cuda/CUDAGuard.h>
#include <c10/cuda/CUDAStream.h>
#include <torch/library.h>

#include "kernel.h"

namespace {

at::Tensor on_cpu(const at::Tensor& pixels) {
  return pixels.to(at::kFloat).matmul(at::tensor({0.299f, 0.587f, 0.114f}));
}

at::Tensor on_gpu(const at::Tensor& pixels) {
  TORCH_CHECK(pixels.dim() == 3 && pixels.size(2) == 3 && pixels.scalar_type() == at::kByte, "height x width x 3 bytes");
  const c10::cuda::CUDAGuard guard(pixels.device());
  const auto whole = pixels.contiguous();
  auto brightness = at::empty({pixels.size(0), pixels.size(1)}, pixels.options().dtype(at::kFloat));
  C10_CUDA_CHECK(gray_on_gpu(whole.const_data_ptr<std::uint8_t>(), brightness.mutable_data_ptr<float>(),
                             brightness.numel(), c10::cuda::getCurrentCUDAStream()));
  return brightness;
}

}  // namespace

TORCH_LIBRARY(gray, library) { library.def("gray(Tensor pixels) -> Tensor"); }
TORCH_LIBRARY_IMPL(gray, CPU, library) { library.impl("gray", on_cpu); }
TORCH_LIBRARY_IMPL(gray, CUDA, library) { library.impl("gray", on_gpu); }
