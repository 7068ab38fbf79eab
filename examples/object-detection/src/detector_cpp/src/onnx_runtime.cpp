#define ORT_API_MANUAL_INIT
#include <dlfcn.h>
#include <onnxruntime_cxx_api.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "backend.h"

namespace detector {
namespace {

// The library, found by its name at run time. A program that links it asks for the very release that it was linked with, so it
// would not run on a stack that has another one (rosml rebase --variants).
const OrtApiBase& library() {
  static const OrtApiBase* const found = [] {
    void* const handle = dlopen("libonnxruntime.so.1", RTLD_NOW);
    if (handle == nullptr) throw std::runtime_error(std::string("no ONNX Runtime: ") + dlerror());
    using Function = const OrtApiBase* (*)();
    const auto* const base = reinterpret_cast<Function>(dlsym(handle, "OrtGetApiBase"))();
    const auto* const api = base->GetApi(ORT_API_VERSION);
    if (api == nullptr) throw std::runtime_error("ONNX Runtime is older than the headers of the build");
    Ort::InitApi(api);
    return base;
  }();
  return *found;
}

class OnnxRuntime : public Backend {
 public:
  OnnxRuntime(const std::string& model, Device device) {
    library();
    env_ = Ort::Env(ORT_LOGGING_LEVEL_WARNING, "detector");
    const auto providers = Ort::GetAvailableProviders();
    const bool has_cuda = std::find(providers.begin(), providers.end(), "CUDAExecutionProvider") != providers.end();
    if (device == Device::cuda && !has_cuda) throw std::runtime_error("this ONNX Runtime is for the CPU");
    if (device != Device::cpu && has_cuda) {
      try {
        Ort::SessionOptions options;
        options.AppendExecutionProvider_CUDA(OrtCUDAProviderOptions{});
        session_ = Ort::Session(env_, model.c_str(), options);
        where_ = "cuda";
      } catch (const Ort::Exception&) {  // no GPU
        if (device == Device::cuda) throw;
      }
    }
    if (where_ == "cpu") session_ = Ort::Session(env_, model.c_str(), Ort::SessionOptions());
  }

  std::vector<Box> run(std::vector<float>& picture, int width, int height) override {
    const std::array<int64_t, 4> shape{1, 3, height, width};
    const auto memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
    const auto tensor = Ort::Value::CreateTensor<float>(memory, picture.data(), picture.size(), shape.data(), shape.size());
    Ort::AllocatorWithDefaultOptions allocator;
    const auto input = session_.GetInputNameAllocated(0, allocator), output = session_.GetOutputNameAllocated(0, allocator);
    const char *const inputs[] = {input.get()}, *const outputs[] = {output.get()};
    const auto found = session_.Run(Ort::RunOptions(), inputs, &tensor, 1, outputs, 1);
    const auto count = found.front().GetTensorTypeAndShapeInfo().GetElementCount();
    return boxes(found.front().GetTensorData<float>(), count / 6);
  }

  std::string about() const override { return std::string("ONNX Runtime ") + library().GetVersionString() + " on " + where_; }

 private:
  Ort::Env env_{nullptr};
  Ort::Session session_{nullptr};
  std::string where_ = "cpu";
};

}  // namespace

std::unique_ptr<Backend> onnx_runtime(const std::string& model, Device device) {
  return std::make_unique<OnnxRuntime>(model, device);
}

}  // namespace detector
