// The mean of some numbers, as a model of each framework has it.
#pragma once
#include <string>
#include <vector>

float torch_mean(const std::string& script, const std::vector<float>& numbers);
float tensorflow_mean(const std::string& saved_model, const std::vector<float>& numbers);
