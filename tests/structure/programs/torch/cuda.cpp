// The headers of PyTorch's streams include those of CUDA's libraries, and programs call CUDA's runtime beside PyTorch:
// without a toolkit, and without a GPU.
#include <c10/cuda/CUDAStream.h>
#include <cuda_runtime_api.h>

#include <iostream>

int main() {
  int version = 0;
  if (cudaRuntimeGetVersion(&version) != cudaSuccess || version / 1000 != CUDART_VERSION / 1000) return 1;
  std::cout << "libtorch CUDA " << version << ", " << static_cast<int>(c10::cuda::device_count()) << " devices" << std::endl;
}
