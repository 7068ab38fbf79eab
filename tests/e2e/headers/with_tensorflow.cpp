#include "parts.h"

#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/ops/array_ops.h>
#include <tensorflow/cc/ops/math_ops.h>
#include <tensorflow/core/framework/graph.pb.h>

#include <google/protobuf/text_format.h>
#include <unsupported/Eigen/CXX11/Tensor>

#include <absl/strings/str_cat.h>

#include <cstdio>

namespace tf = tensorflow;

int with_tensorflow() {
  std::printf("tensorflow: protobuf %d eigen %d.%d.%d absl %d\n", GOOGLE_PROTOBUF_VERSION, EIGEN_WORLD_VERSION,
              EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, ABSL_LTS_RELEASE_VERSION);
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto sum = tf::ops::Sum(root.WithOpName(absl::StrCat("su", "m")), {1.f, 2.f, 3.f}, 0);
  std::vector<tf::Tensor> outputs;
  if (!tf::ClientSession(root).Run({sum}, &outputs).ok() || outputs.at(0).scalar<float>()() != 6.f) return 1;

  tf::GraphDef graph, again;
  if (!root.ToGraphDef(&graph).ok()) return 2;
  std::string text, same;
  if (!google::protobuf::TextFormat::PrintToString(graph, &text)) return 3;
  if (!again.ParseFromString(graph.SerializeAsString())) return 4;
  if (!google::protobuf::TextFormat::PrintToString(again, &same)) return 5;
  return same == text ? 0 : 6;
}
