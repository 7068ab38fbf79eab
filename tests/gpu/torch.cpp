// libtorch on the GPU, from a program that was built without a CUDA toolkit: a product, a convolution, a gradient.
#include <torch/torch.h>

#include <iostream>

int main() {
  if (!torch::cuda::is_available()) {
    std::cerr << "libtorch sees no GPU" << std::endl;
    return 1;
  }
  const auto a = torch::randn({256, 256}), b = torch::randn({256, 256});
  const auto difference = (a.cuda().mm(b.cuda()).cpu() - a.mm(b)).abs().max().item<float>();
  auto x = torch::ones({4}, torch::TensorOptions().device(torch::kCUDA).requires_grad(true));
  x.square().sum().backward();
  torch::nn::Conv2d layer(torch::nn::Conv2dOptions(3, 8, 3));
  const auto picture = torch::randn({1, 3, 16, 16});
  const auto wanted = layer(picture).detach();
  layer->to(torch::kCUDA);
  const auto convolved = (layer(picture.cuda()).detach().cpu() - wanted).abs().max().item<float>();
  const bool right = difference < 1e-2 && convolved < 1e-2 && x.grad().eq(2).all().item<bool>();
  std::cout << (right ? "ok" : "FAILED") << "     libtorch " << TORCH_VERSION << ", "
            << static_cast<int>(torch::cuda::device_count()) << " GPU, cuDNN " << torch::cuda::cudnn_is_available() << ": within " << difference << " of the CPU" << std::endl;
  return right ? 0 : 1;
}
