// A kernel behind a function of PyTorch's tensors. CMake makes a program of it, setup.py a module of Python.
#ifdef TORCH_EXTENSION_NAME
#include <Python.h>
#endif
#include <ATen/core/Tensor.h>
#include <ATen/ops/empty_like.h>
#include <ATen/ops/ones.h>
#include <c10/cuda/CUDAException.h>
#include <c10/cuda/CUDAFunctions.h>
#include <c10/cuda/CUDAStream.h>

#include <cstdio>

__global__ void twice(const float* from, float* to, std::int64_t count) {
  const auto at = static_cast<std::int64_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (at < count) to[at] = 2 * from[at];
}

at::Tensor twice(const at::Tensor& given) {
  if (!given.is_cuda()) return given.mul(2);
  auto to = at::empty_like(given);
  const auto count = given.numel();
  twice<<<static_cast<unsigned>((count + 255) / 256), 256, 0, c10::cuda::getCurrentCUDAStream()>>>(
      given.const_data_ptr<float>(), to.mutable_data_ptr<float>(), count);
  C10_CUDA_KERNEL_LAUNCH_CHECK();
  return to;
}

int answer() {
  const auto kind = c10::cuda::device_count() > 0 ? at::kCUDA : at::kCPU;
  return static_cast<int>(twice(at::ones({21}, at::device(kind).dtype(at::kFloat))).sum().item<float>());
}

#ifdef TORCH_EXTENSION_NAME
static PyModuleDef module = {PyModuleDef_HEAD_INIT, "answer", nullptr, -1, nullptr};
PyMODINIT_FUNC PyInit_answer() {
  PyObject* made = PyModule_Create(&module);
  PyModule_AddIntConstant(made, "answer", answer());
  return made;
}
#else
int main() { std::printf("the answer is %d\n", answer()); }
#endif
