#include "means.h"

#include <ATen/ATen.h>

float torch_mean(const std::vector<float>& numbers) { return at::tensor(numbers).mean().item<float>(); }
