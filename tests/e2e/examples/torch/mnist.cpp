// mnist FOLDER: the C++ frontend as PyTorch's examples use it: a convolutional network of torch::nn, MNIST's files, a
// data loader with transforms, SGD; trains, tells the accuracy on the test set, and saves and loads the network.
#include <torch/torch.h>

#include <iostream>
#include <memory>
#include <string>

constexpr int64_t train_batches = 60, test_batches = 5; // enough to see it learn; the files are as long as MNIST's

struct NetImpl : torch::nn::Module {
  NetImpl() {
    register_module("first", first);
    register_module("second", second);
    register_module("drop", drop);
    register_module("hidden", hidden);
    register_module("digits", digits);
  }

  torch::Tensor forward(torch::Tensor x) {
    x = torch::relu(torch::max_pool2d(first->forward(x), 2));
    x = torch::relu(torch::max_pool2d(drop->forward(second->forward(x)), 2));
    x = torch::relu(hidden->forward(x.flatten(1)));
    x = torch::dropout(x, /*p=*/0.2, is_training());
    return torch::log_softmax(digits->forward(x), /*dim=*/1);
  }

  torch::nn::Conv2d first{torch::nn::Conv2dOptions(1, 8, /*kernel_size=*/5)};
  torch::nn::Conv2d second{torch::nn::Conv2dOptions(8, 16, /*kernel_size=*/5)};
  torch::nn::Dropout2d drop{torch::nn::Dropout2dOptions(0.1)};
  torch::nn::Linear hidden{16 * 4 * 4, 32};
  torch::nn::Linear digits{32, 10};
};
TORCH_MODULE(Net);

template <typename DataLoader>
void train(Net& model, torch::Device device, DataLoader& loader, torch::optim::Optimizer& optimizer) {
  model->train();
  int64_t batches = 0;
  for (auto& batch : loader) {
    const auto data = batch.data.to(device), target = batch.target.to(device);
    optimizer.zero_grad();
    auto loss = torch::nll_loss(model->forward(data), target);
    TORCH_CHECK(std::isfinite(loss.template item<float>()), "the loss is no number");
    loss.backward();
    optimizer.step();
    if (++batches == train_batches) break;
  }
}

template <typename DataLoader>
double accuracy(Net& model, torch::Device device, DataLoader& loader) {
  torch::NoGradGuard no_grad;
  model->eval();
  int64_t batches = 0, seen = 0, correct = 0;
  for (const auto& batch : loader) {
    const auto data = batch.data.to(device), target = batch.target.to(device);
    correct += model->forward(data).argmax(1).eq(target).sum().template item<int64_t>();
    seen += target.size(0);
    if (++batches == test_batches) break;
  }
  return static_cast<double>(correct) / static_cast<double>(seen);
}

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  torch::manual_seed(1);
  const torch::Device device(torch::cuda::is_available() ? torch::kCUDA : torch::kCPU);
  Net model;
  model->to(device);

  const auto read = [&](torch::data::datasets::MNIST::Mode mode) {
    return torch::data::datasets::MNIST(folder, mode)
        .map(torch::data::transforms::Normalize<>(0.1307, 0.3081))
        .map(torch::data::transforms::Stack<>());
  };
  auto train_loader = torch::data::make_data_loader<torch::data::samplers::RandomSampler>(
      read(torch::data::datasets::MNIST::Mode::kTrain), torch::data::DataLoaderOptions().batch_size(64).workers(1));
  auto test_loader = torch::data::make_data_loader(read(torch::data::datasets::MNIST::Mode::kTest), /*batch_size=*/200);

  torch::optim::SGD optimizer(model->parameters(), torch::optim::SGDOptions(0.05).momentum(0.5));
  const double before = accuracy(model, device, *test_loader);
  train(model, device, *train_loader, optimizer);
  const double after = accuracy(model, device, *test_loader);

  torch::save(model, folder + "/net.pt");
  Net loaded;
  torch::load(loaded, folder + "/net.pt");
  loaded->to(device);
  std::cout << "mnist: accuracy " << before << " -> " << after << ", loaded "
            << accuracy(loaded, device, *test_loader) << std::endl;
  return before < 0.5 && after > 0.95 && accuracy(loaded, device, *test_loader) == after ? 0 : 1;
}
