// What libtorch was built with: two headers that compile in no time, one from each of its include folders.
#include <ATen/Version.h>
#include <torch/version.h>

#include <iostream>

int main() {
  if (at::show_config().find("PyTorch built with") != 0) return 1;
  std::cout << "libtorch " << TORCH_VERSION << std::endl;
}
