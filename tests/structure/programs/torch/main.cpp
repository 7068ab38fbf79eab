// A small libtorch program: tensors, autograd, linear algebra.
// It names the headers it uses: all of them, <torch/torch.h>, take twice as long to compile, in every image's test.
#include <torch/types.h>
#include <torch/version.h>

#include <iostream>

int main() {
  const auto a = torch::arange(4.0, torch::requires_grad());
  const auto square = torch::dot(a, a);
  square.backward();
  if (!torch::equal(a.grad(), 2 * a.detach())) return 1;
  std::cout << "libtorch " << TORCH_VERSION << ": " << square.item<double>() << std::endl;
}
