// infer MODEL: runs a model of one input and one output on 0, 0.1, 0.2 … and prints the result, as infer.py does.
#include <onnxruntime_cxx_api.h>

#include <cstdio>
#include <numeric>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  Ort::Env env(ORT_LOGGING_LEVEL_WARNING, "infer");
  Ort::SessionOptions options;
  options.SetIntraOpNumThreads(1);
  Ort::Session session(env, argv[1], options);
  Ort::AllocatorWithDefaultOptions allocator;
  const auto input = session.GetInputNameAllocated(0, allocator), output = session.GetOutputNameAllocated(0, allocator);
  // In a variable: in older headers the description is gone with what it is taken from.
  const auto type = session.GetInputTypeInfo(0);
  const auto shape = type.GetTensorTypeAndShapeInfo().GetShape();
  std::vector<float> numbers(std::accumulate(shape.begin(), shape.end(), int64_t{1}, std::multiplies<>()));
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i) * 0.1f;
  const auto memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
  const auto tensor = Ort::Value::CreateTensor<float>(memory, numbers.data(), numbers.size(), shape.data(), shape.size());
  const char *const inputs[] = {input.get()}, *const outputs[] = {output.get()};
  const auto found = session.Run(Ort::RunOptions{}, inputs, &tensor, 1, outputs, 1);
  const float* values = found.front().GetTensorData<float>();
  std::printf("onnxruntime %s:", Ort::GetVersionString().c_str());
  for (size_t i = 0; i < found.front().GetTensorTypeAndShapeInfo().GetElementCount(); ++i) std::printf(" %.6g", values[i]);
  std::printf("\n");
}
