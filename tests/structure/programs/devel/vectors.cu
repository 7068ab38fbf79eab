// Adds vectors by a kernel and sums the result by thrust. Without a GPU it says so: that it was built is the test then.
#include <cooperative_groups.h>
#include <thrust/device_vector.h>
#include <thrust/reduce.h>

#include <cstdio>

__global__ void add(const float* one, const float* other, float* sum, int count) {
  const auto at = static_cast<int>(cooperative_groups::this_grid().thread_rank());
  if (at < count) sum[at] = one[at] + other[at];
}

int main() {
  int runtime = 0, devices = 0;
  if (cudaRuntimeGetVersion(&runtime) != cudaSuccess || runtime / 10 != CUDART_VERSION / 10) return 1;
  std::printf("CUDA runtime %d: ", runtime);
  if (const auto error = cudaGetDeviceCount(&devices); error != cudaSuccess) {
    std::printf("no GPU (%s)\n", cudaGetErrorString(error));
    return 0;
  }
  const int count = 1000;
  thrust::device_vector<float> one(count, 1.0f), other(count, 2.0f), sum(count);
  add<<<(count + 255) / 256, 256>>>(thrust::raw_pointer_cast(one.data()), thrust::raw_pointer_cast(other.data()),
                                    thrust::raw_pointer_cast(sum.data()), count);
  if (const auto error = cudaDeviceSynchronize(); error != cudaSuccess) {
    std::printf("%s\n", cudaGetErrorString(error));
    return 1;
  }
  const float total = thrust::reduce(sum.begin(), sum.end());
  cudaDeviceProp device{};
  if (cudaGetDeviceProperties(&device, 0) != cudaSuccess) return 1;
  std::printf("%s on %s, sm_%d%d\n", total == 3.0f * count ? "ok" : "wrong", device.name, device.major, device.minor);
  return total == 3.0f * count ? 0 : 1;
}
