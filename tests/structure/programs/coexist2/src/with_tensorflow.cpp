#include "means.h"

#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/ops/array_ops.h>
#include <tensorflow/cc/ops/math_ops.h>

#include <algorithm>
#include <stdexcept>

namespace tf = tensorflow;

float tensorflow_mean(const std::vector<float>& numbers) {
  tf::Tensor input(tf::DT_FLOAT, {static_cast<int64_t>(numbers.size())});
  std::copy(numbers.begin(), numbers.end(), input.flat<float>().data());
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto mean = tf::ops::Mean(root, input, {0});
  tf::ClientSession session(root);
  std::vector<tf::Tensor> outputs;
  const auto status = session.Run({mean}, &outputs);
  if (!status.ok()) throw std::runtime_error(status.ToString());
  return outputs.at(0).scalar<float>()();
}
