#include "models.h"

#include <tensorflow/cc/saved_model/loader.h>

#include <algorithm>
#include <stdexcept>

namespace tf = tensorflow;

float tensorflow_mean(const std::string& saved_model, const std::vector<float>& numbers) {
  static tf::SavedModelBundle bundle;
  if (!bundle.session) {
    const auto status = tf::LoadSavedModel({}, {}, saved_model, {"serve"}, &bundle);
    if (!status.ok()) throw std::runtime_error(status.ToString());
  }
  const auto& signature = bundle.GetSignatures().at("serving_default");
  tf::Tensor input(tf::DT_FLOAT, {static_cast<int64_t>(numbers.size())});
  std::copy(numbers.begin(), numbers.end(), input.flat<float>().data());
  std::vector<tf::Tensor> outputs;
  const auto status = bundle.GetSession()->Run({{signature.inputs().begin()->second.name(), input}},
                                               {signature.outputs().begin()->second.name()}, {}, &outputs);
  if (!status.ok()) throw std::runtime_error(status.ToString());
  return outputs.at(0).flat<float>()(0);
}
