// label_image FOLDER: a picture's way to a label, as TensorFlow's example of that name goes it: a file that is read and
// decoded, brought to a model's size and range by a graph made here, a frozen graph from a file, and the best labels.
#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/ops/standard_ops.h>
#include <tensorflow/core/framework/graph.pb.h>
#include <tensorflow/core/platform/env.h>
#include <tensorflow/core/public/session.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tf = tensorflow;
using namespace tensorflow::ops; // as TensorFlow's own example

constexpr int height = 8, width = 6;

// A picture that is all of one colour, as a file.
void write_picture(const std::string& file, tf::uint8 red, tf::uint8 green, tf::uint8 blue) {
  tf::Tensor pixels(tf::DT_UINT8, {20, 30, 3});
  auto flat = pixels.flat<tf::uint8>();
  for (int64_t i = 0; i < flat.size(); ++i) flat(i) = i % 3 == 0 ? red : i % 3 == 1 ? green : blue;
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto png = EncodePng(root, pixels);
  std::vector<tf::Tensor> outputs;
  TF_CHECK_OK(tf::ClientSession(root).Run({png}, &outputs));
  TF_CHECK_OK(tf::WriteStringToFile(tf::Env::Default(), file, outputs.at(0).scalar<tf::tstring>()()));
}

// A frozen graph that looks at the mean of each colour.
void write_model(const std::string& file) {
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto picture = Placeholder(root.WithOpName("picture"), tf::DT_FLOAT);
  Sigmoid(root.WithOpName("scores"), Mean(root, picture, {1, 2}));
  tf::GraphDef graph;
  TF_CHECK_OK(root.ToGraphDef(&graph));
  TF_CHECK_OK(tf::WriteBinaryProto(tf::Env::Default(), file, graph));
}

tf::Tensor read_picture(const std::string& file, float mean, float deviation) {
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto content = ReadFile(root.WithOpName("content"), file);
  const auto decoded = DecodePng(root.WithOpName("decoded"), content, DecodePng::Channels(3));
  const auto batch = ExpandDims(root, Cast(root, decoded, tf::DT_FLOAT), 0);
  const auto resized = ResizeBilinear(root, batch, Const(root.WithOpName("size"), {height, width}));
  const auto normalized = Div(root.WithOpName("normalized"), Sub(root, resized, {mean}), {deviation});
  std::vector<tf::Tensor> outputs;
  TF_CHECK_OK(tf::ClientSession(root).Run({normalized}, &outputs));
  return outputs.at(0);
}

int main(int, char** arguments) {
  const std::string folder = arguments[1];
  write_picture(folder + "/picture.png", 28, 228, 128);
  write_model(folder + "/frozen.pb");

  const tf::Tensor picture = read_picture(folder + "/picture.png", 128, 50);
  if (picture.shape() != tf::TensorShape({1, height, width, 3})) return 1;
  tf::GraphDef graph;
  TF_CHECK_OK(tf::ReadBinaryProto(tf::Env::Default(), folder + "/frozen.pb", &graph));
  const std::unique_ptr<tf::Session> session(tf::NewSession(tf::SessionOptions()));
  TF_CHECK_OK(session->Create(graph));
  std::vector<tf::Tensor> scores;
  TF_CHECK_OK(session->Run({{"picture", picture}}, {"scores"}, {}, &scores));

  const tf::Scope root = tf::Scope::NewRootScope();
  const TopK best(root.WithOpName("best"), scores.at(0), 2);
  std::vector<tf::Tensor> outputs;
  TF_CHECK_OK(tf::ClientSession(root).Run({best.values, best.indices}, &outputs));
  const char* labels[] = {"red", "green", "blue"};
  const auto values = outputs.at(0).flat<float>();
  const auto indices = outputs.at(1).flat<int>();
  for (int i = 0; i < 2; ++i)
    std::cout << "label_image: " << labels[indices(i)] << " " << values(i) << std::endl;
  // (28, 228, 128) becomes (-2, 2, 0).
  const float wanted = 1 / (1 + std::exp(-2.f));
  return indices(0) == 1 && indices(1) == 2 && std::abs(values(0) - wanted) < 1e-4f ? 0 : 1;
}
