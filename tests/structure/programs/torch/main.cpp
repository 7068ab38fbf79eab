// A small libtorch program: tensors, autograd, linear algebra.
// It names the headers of just those operators: <torch/torch.h> takes ten times as long to compile, in every image's
// test. A program with all of it is built where images are used (tests/e2e).
#include <ATen/core/Tensor.h>
#include <ATen/ops/arange.h>
#include <ATen/ops/dot.h>
#include <ATen/ops/equal.h>
#include <torch/version.h>

#include <iostream>

int main() {
  auto a = at::arange(4.0);
  a.requires_grad_();
  const auto square = at::dot(a, a);
  square.backward();
  if (!at::equal(a.grad(), a.detach().mul(2))) return 1;
  std::cout << "libtorch " << TORCH_VERSION << ": " << square.item<double>() << std::endl;
}
