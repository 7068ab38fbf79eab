// train: a network of two layers that learns exclusive or, in C++ alone: variables, symbolic gradients, gradient descent.
#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/framework/gradients.h>
#include <tensorflow/cc/ops/standard_ops.h>

#include <iostream>
#include <vector>

namespace tf = tensorflow;
using namespace tensorflow::ops; // as TensorFlow's own examples

int main() {
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto x = Placeholder(root.WithOpName("x"), tf::DT_FLOAT);
  const auto y = Placeholder(root.WithOpName("y"), tf::DT_FLOAT);
  const auto w1 = Variable(root.WithOpName("w1"), {2, 4}, tf::DT_FLOAT);
  const auto b1 = Variable(root.WithOpName("b1"), {4}, tf::DT_FLOAT);
  const auto w2 = Variable(root.WithOpName("w2"), {4, 1}, tf::DT_FLOAT);
  const auto b2 = Variable(root.WithOpName("b2"), {1}, tf::DT_FLOAT);
  const std::vector<tf::Output> variables{w1, b1, w2, b2};
  const std::vector<tf::Output> starts{
      Assign(root, w1, RandomNormal(root, {2, 4}, tf::DT_FLOAT, RandomNormal::Seed(1).Seed2(2))),
      Assign(root, b1, {0.1f, -0.1f, 0.2f, -0.2f}),
      Assign(root, w2, RandomNormal(root, {4, 1}, tf::DT_FLOAT, RandomNormal::Seed(3).Seed2(4))), Assign(root, b2, {0.f})};

  const auto hidden = Tanh(root, Add(root, MatMul(root, x, w1), b1));
  const auto guess = Add(root, MatMul(root, hidden, w2), b2);
  const auto loss = Mean(root.WithOpName("loss"), Square(root, Sub(root, guess, y)), {0, 1});

  std::vector<tf::Output> gradients;
  TF_CHECK_OK(tf::AddSymbolicGradients(root, {loss}, variables, &gradients));
  std::vector<tf::Output> steps;
  for (size_t i = 0; i < variables.size(); ++i)
    steps.push_back(ApplyGradientDescent(root, variables[i], 0.2f, gradients.at(i)));
  TF_CHECK_OK(root.status());

  tf::ClientSession session(root);
  std::vector<tf::Tensor> outputs;
  TF_CHECK_OK(session.Run(starts, &outputs));
  const tf::ClientSession::FeedType feeds{{x, {{0.f, 0.f}, {0.f, 1.f}, {1.f, 0.f}, {1.f, 1.f}}},
                                          {y, {{0.f}, {1.f}, {1.f}, {0.f}}}};
  TF_CHECK_OK(session.Run(feeds, {loss}, &outputs));
  const float before = outputs.at(0).scalar<float>()();
  for (int i = 0; i < 1000; ++i) TF_CHECK_OK(session.Run(feeds, steps, &outputs));
  TF_CHECK_OK(session.Run(feeds, {loss, guess}, &outputs));
  const float after = outputs.at(0).scalar<float>()();
  std::cout << "train: loss " << before << " -> " << after << std::endl;
  const auto guesses = outputs.at(1).flat<float>();
  return guesses(0) < 0.2f && guesses(1) > 0.8f && guesses(2) > 0.8f && guesses(3) < 0.2f ? 0 : 1;
}
