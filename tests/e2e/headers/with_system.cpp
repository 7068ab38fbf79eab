#include "parts.h"
#include "picture.pb.h"

#include <google/protobuf/text_format.h>

#include <Eigen/Dense>

#include <absl/strings/str_cat.h>

#include <cstdio>

int with_system() {
  std::printf("system: protobuf %d eigen %d.%d.%d absl %d\n", GOOGLE_PROTOBUF_VERSION, EIGEN_WORLD_VERSION,
              EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, ABSL_LTS_RELEASE_VERSION);
  GOOGLE_PROTOBUF_VERIFY_VERSION;
  if (Eigen::Vector3f(1, 2, 3).sum() != 6.f) return 1;

  example::Picture picture, again;
  picture.set_name(absl::StrCat("pic", "ture"));
  for (int i = 0; i < 100; ++i) picture.add_pixels(i);
  (*picture.mutable_scores())["cat"] = 0.5f;
  std::string text, same;
  if (!google::protobuf::TextFormat::PrintToString(picture, &text)) return 2;
  if (!again.ParseFromString(picture.SerializeAsString())) return 3;
  if (!google::protobuf::TextFormat::PrintToString(again, &same)) return 4;
  if (google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName("example.Picture") == nullptr) return 5;
  return same == text && again.scores().at("cat") == 0.5f ? 0 : 6;
}
