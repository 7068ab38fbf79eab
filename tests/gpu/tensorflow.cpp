// tensorflow_cc on the GPU, from a program that was built without a CUDA toolkit: a product and a convolution.
#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/ops/array_ops.h>
#include <tensorflow/cc/ops/math_ops.h>
#include <tensorflow/cc/ops/nn_ops.h>
#include <tensorflow/cc/ops/random_ops.h>
#include <tensorflow/core/public/version.h>
#if __has_include(<tensorflow/core/public/release_version.h>)  // where newer releases have their version
#include <tensorflow/core/public/release_version.h>
#endif

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace tf = tensorflow;

// The product and the convolution, on one device.
std::vector<tf::Output> work(const tf::Scope& scope, const tf::Input& a, const tf::Input& picture, const tf::Input& filter) {
  return {tf::ops::MatMul(scope, a, a), tf::ops::Conv2D(scope, picture, filter, {1, 1, 1, 1}, "SAME")};
}

int main() {
  const tf::Scope root = tf::Scope::NewRootScope(), cpu = root.WithDevice("/cpu:0"), gpu = root.WithDevice("/gpu:0");
  const auto random = [&](const std::vector<int>& shape) -> tf::Output {
    tf::Tensor sizes(tf::DT_INT32, {static_cast<int>(shape.size())});
    std::copy(shape.begin(), shape.end(), sizes.flat<int>().data());
    return tf::ops::RandomNormal(cpu, sizes, tf::DT_FLOAT);
  };
  const auto a = random({256, 256}), picture = random({1, 16, 16, 3}), filter = random({3, 3, 3, 8});
  auto fetches = work(cpu, a, picture, filter);
  for (const auto& output : work(gpu, a, picture, filter)) fetches.push_back(output);

  tf::ClientSession session(root);  // without soft placement: an operation that the GPU cannot have is an error
  std::vector<tf::Tensor> outputs;
  tf::RunOptions options;
  options.set_trace_level(tf::RunOptions::FULL_TRACE);
  tf::RunMetadata metadata;
  if (const auto status = session.Run(options, {}, fetches, {}, &outputs, &metadata); !status.ok()) {
    std::cerr << "FAILED tensorflow_cc: " << status.ToString() << std::endl;
    return 1;
  }
  float difference = 0;
  for (int index : {0, 1}) {
    const auto wanted = outputs[index].flat<float>(), found = outputs[index + 2].flat<float>();
    for (int place = 0; place < wanted.size(); ++place)
      difference = std::max(difference, std::abs(wanted(place) - found(place)));
  }
  std::string devices;
  for (const auto& device : metadata.step_stats().dev_stats())
    if (device.device().find("GPU:0") != std::string::npos && devices.empty()) devices = device.device();
  const bool right = !devices.empty() && difference < 0.1f;
  std::cout << (right ? "ok" : "FAILED") << "     tensorflow_cc " << TF_VERSION_STRING << ", "
            << (devices.empty() ? "nothing ran on a GPU" : devices) << ": within " << difference << " of the CPU" << std::endl;
  return right ? 0 : 1;
}
