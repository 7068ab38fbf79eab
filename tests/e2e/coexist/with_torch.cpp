#include "models.h"

#include <torch/script.h>

float torch_mean(const std::string& script, const std::vector<float>& numbers) {
  static torch::jit::Module module = torch::jit::load(script);
  auto input = torch::from_blob(const_cast<float*>(numbers.data()), {static_cast<int64_t>(numbers.size())});
  return module.forward({input}).toTensor().item<float>();
}
