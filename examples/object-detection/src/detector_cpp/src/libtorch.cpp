#include <torch/cuda.h>
#include <torch/script.h>
#include <torch/version.h>

#include <stdexcept>

#include "backend.h"

namespace detector {
namespace {

class LibTorch : public Backend {
 public:
  LibTorch(const std::string& model, Device device) {
    if (device != Device::cpu && torch::cuda::is_available()) device_ = torch::kCUDA;
    if (device == Device::cuda && device_ != torch::kCUDA) throw std::runtime_error("PyTorch finds no GPU");
    module_ = torch::jit::load(model, device_);
    module_.eval();
  }

  std::vector<Box> run(std::vector<float>& picture, int width, int height) override {
    const c10::InferenceMode guard;
    const auto tensor = torch::from_blob(picture.data(), {1, 3, height, width}).to(device_);
    const auto found = module_.forward({tensor}).toTensor().to(torch::kCPU, torch::kFloat).reshape({-1, 6}).contiguous();
    return boxes(found.data_ptr<float>(), static_cast<std::size_t>(found.size(0)));
  }

  std::string about() const override { return "PyTorch " TORCH_VERSION " on " + device_.str(); }

 private:
  torch::Device device_{torch::kCPU};
  torch::jit::Module module_;
};

}  // namespace

std::unique_ptr<Backend> libtorch(const std::string& model, Device device) { return std::make_unique<LibTorch>(model, device); }

}  // namespace detector
