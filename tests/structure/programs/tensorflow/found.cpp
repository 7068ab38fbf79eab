// What programs take for granted that wheels lack: TensorFlow's release in version.h, SavedModel's constants, and templates
// that the libraries have under names of another compiler. It is compiled with no macro and no optimisation, and linked with
// a library of protobuf, as people's own commands do.
#include <absl/strings/cord.h>
#include <tensorflow/cc/saved_model/signature_constants.h>
#include <tensorflow/cc/saved_model/tag_constants.h>
#include <tensorflow/core/framework/graph.pb.h>
#include <tensorflow/core/platform/logging.h>
#include <tensorflow/core/public/version.h>
#include <third_party/eigen3/unsupported/Eigen/CXX11/Tensor>

#include <iostream>
#include <string>

namespace tf = tensorflow;

static_assert(EIGEN_MAX_ALIGN_BYTES == 64, "memory would be allocated in another way than the library frees it");

// The names that Python has for them.
#define PRINT(python, constant) std::cout << python << "=" << tf::constant << std::endl

int main() {
  tf::GraphDef graph;
  graph.add_node()->set_name("node");
  tf::GraphDef again;
  if (!again.ParseFromString(graph.SerializeAsString()) || again.node(0).name() != "node") return 1;
  absl::Cord cord(std::string(1000, 'x'));
  cord.Append(std::string(1000, 'y'));
  cord.Prepend(std::string(1000, 'z'));
  CHECK_EQ(cord.size(), size_t{3000}) << "a cord of " << cord.size() << ' ' << 1.5 << true;
  PRINT("SERVING", kSavedModelTagServe);
  PRINT("TRAINING", kSavedModelTagTrain);
  PRINT("GPU", kSavedModelTagGpu);
  PRINT("TPU", kSavedModelTagTpu);
  PRINT("DEFAULT_SERVING_SIGNATURE_DEF_KEY", kDefaultServingSignatureDefKey);
  PRINT("CLASSIFY_INPUTS", kClassifyInputs);
  PRINT("CLASSIFY_METHOD_NAME", kClassifyMethodName);
  PRINT("CLASSIFY_OUTPUT_CLASSES", kClassifyOutputClasses);
  PRINT("CLASSIFY_OUTPUT_SCORES", kClassifyOutputScores);
  PRINT("PREDICT_INPUTS", kPredictInputs);
  PRINT("PREDICT_METHOD_NAME", kPredictMethodName);
  PRINT("PREDICT_OUTPUTS", kPredictOutputs);
  PRINT("REGRESS_INPUTS", kRegressInputs);
  PRINT("REGRESS_METHOD_NAME", kRegressMethodName);
  PRINT("REGRESS_OUTPUTS", kRegressOutputs);
  std::cout << "tensorflow " << TF_VERSION_STRING << std::endl;
}
