// A program as the documentation of libtorch shows it: tensors, autograd, a module.
// It names the headers it uses: all of them, <torch/torch.h>, take twice as long to compile, in every image.
#include <torch/nn/modules/linear.h>
#include <torch/types.h>
#include <torch/version.h>

#include <iostream>

int main() {
  const auto a = torch::arange(4.0, torch::requires_grad());
  (a * a).sum().backward();
  if (!torch::equal(a.grad(), 2 * a.detach())) return 1;

  torch::nn::Linear layer(4, 2);
  if (layer->forward(a).sizes() != torch::IntArrayRef{2}) return 1;
  std::cout << "libtorch " << TORCH_VERSION << ": " << (a * a).sum().item<double>() << std::endl;
}
