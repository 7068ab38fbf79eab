// The mean of some numbers, by each framework.
#pragma once
#include <vector>

float torch_mean(const std::vector<float>& numbers);
float tensorflow_mean(const std::vector<float>& numbers);
