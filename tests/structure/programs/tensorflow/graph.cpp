// graph SAVED_MODEL: TensorFlow's C++ API as its documentation shows it: a graph that is built and run here, and one
// that Python saved. One file, since the headers take most of the time.
#include <tensorflow/cc/client/client_session.h>
#include <tensorflow/cc/ops/array_ops.h>
#include <tensorflow/cc/ops/math_ops.h>
#include <tensorflow/cc/saved_model/loader.h>
#include <tensorflow/core/public/session.h>
#include <tensorflow/core/public/version.h>
#if __has_include(<tensorflow/core/public/release_version.h>)  // where newer releases have their version
#include <tensorflow/core/public/release_version.h>
#endif

#include <atomic>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace tf = tensorflow;

// Ends the program where the two differ, and says where.
template <typename A, typename B>
void same(const A& value, const B& wanted, int line) {
  if (value == wanted) return;
  std::cerr << "graph.cpp:" << line << ": " << value << ", wanted " << wanted << std::endl;
  std::exit(1);
}
#define SAME(value, wanted) same(value, wanted, __LINE__)
#define OK(call) same((call).ToString(), "OK", __LINE__)

// A thread pool of the caller's: it works at once, and counts.
class Counting : public tf::thread::ThreadPoolInterface {
 public:
  void Schedule(std::function<void()> work) override {
    ++scheduled;
    work();
  }
  int NumThreads() const override { return 1; }
  int CurrentThreadId() const override { return -1; }

  std::atomic<int> scheduled{0};
};

void client_session() {
  const tf::Scope root = tf::Scope::NewRootScope();
  const auto a = tf::ops::Placeholder(root.WithOpName("a"), tf::DT_FLOAT);
  const auto product = tf::ops::MatMul(root.WithOpName("product"), a, {{1.f}, {2.f}});
  const auto sum = tf::ops::Add(root, product, 100.f);
  const auto constant = tf::ops::Multiply(root, 6, 7);
  tf::ClientSession session(root);
  std::vector<tf::Tensor> outputs;

  OK(session.Run({{a, {{3.f, 4.f}}}}, {product}, &outputs));
  SAME(outputs.at(0).scalar<float>()(), 11.f);

  // Several fetches with an operation to run, and a fetch without feeds.
  OK(session.Run({{a, {{3.f, 4.f}}}}, {sum, product}, {sum.z.op()}, &outputs));
  SAME(outputs.at(0).scalar<float>()(), 111.f);
  SAME(outputs.at(1).scalar<float>()(), 11.f);
  OK(session.Run({constant}, &outputs));
  SAME(outputs.at(0).scalar<int>()(), 42);

  tf::RunOptions options;
  options.set_trace_level(tf::RunOptions::FULL_TRACE);
  tf::RunMetadata metadata;
  OK(session.Run(options, {{a, {{3.f, 4.f}}}}, {product}, {}, &outputs, &metadata));
  SAME(metadata.step_stats().dev_stats_size() > 0, true);

  // The same on threads of the caller's.
  Counting threads;
  tf::thread::ThreadPoolOptions pools;
  pools.inter_op_threadpool = &threads;
  OK(session.Run(tf::RunOptions(), {{a, {{5.f, 6.f}}}}, {product}, {}, &outputs, nullptr, pools));
  SAME(outputs.at(0).scalar<float>()(), 17.f);
  SAME(threads.scheduled > 0, true);

  // With options of the session's own, and with none but its target.
  tf::SessionOptions own;
  own.config.set_inter_op_parallelism_threads(1);
  for (const tf::ClientSession& another : {tf::ClientSession(root, own), tf::ClientSession(root, "")}) {
    OK(another.Run({constant}, &outputs));
    SAME(outputs.at(0).scalar<int>()(), 42);
  }

  tf::CallableOptions wanted;
  wanted.add_feed("a:0");
  wanted.add_fetch("product:0");
  tf::ClientSession::CallableHandle callable;
  OK(session.MakeCallable(wanted, &callable));
  tf::Tensor fed(tf::DT_FLOAT, {1, 2});
  fed.flat<float>().setConstant(5.f);
  OK(session.RunCallable(callable, {fed}, &outputs, nullptr));
  SAME(outputs.at(0).scalar<float>()(), 15.f);
  fed.flat<float>().setConstant(6.f);
  const int before = threads.scheduled;
  OK(session.RunCallable(callable, {fed}, &outputs, nullptr, pools));
  SAME(outputs.at(0).scalar<float>()(), 18.f);
  SAME(threads.scheduled > before, true);
  OK(session.ReleaseCallable(callable));
  SAME(session.RunCallable(callable, {fed}, &outputs, nullptr).ok(), false);

  // Faults are statuses with a reason.
  const auto fault = [](const auto& status, const std::string& reason) {
    SAME(status.ok(), false);
    if (status.ToString().find(reason) == std::string::npos) SAME(status.ToString(), reason);
  };
  const tf::Scope other = tf::Scope::NewRootScope();
  const auto stranger = tf::ops::Placeholder(other.WithOpName("stranger"), tf::DT_FLOAT);
  fault(session.Run({{stranger, 1.f}}, {constant}, &outputs), "stranger");
  fault(session.Run({product}, &outputs), "placeholder tensor 'a'");
  fault(session.Run({{a, tf::Input::Initializer({1.f, 2.f}, {1, 3})}}, {product}, &outputs), "2 elements");
#ifdef OWN_CLIENT_SESSION  // where the class of wheels that have it ends the process, or refuses
  const auto later = tf::ops::Add(root, constant, 1);  // a graph that grows after a run
  OK(session.Run({later}, &outputs));
  SAME(outputs.at(0).scalar<int>()(), 43);
  fault(session.Run({product}, nullptr), "`outputs` is null");
  fault(tf::ClientSession(root, "nowhere://").Run({constant}, &outputs), "nowhere");
  own.target = "elsewhere://";
  fault(tf::ClientSession(root, own).Run({constant}, &outputs), "elsewhere");
#endif
}

void saved_model(const char* folder) {
  tf::SavedModelBundle bundle;
  OK(tf::LoadSavedModel(tf::SessionOptions(), tf::RunOptions(), folder, {"serve"}, &bundle));
  const auto& signature = bundle.GetSignatures().at("serving_default");
  tf::Tensor x(tf::DT_FLOAT, {2});
  x.flat<float>().setConstant(7.f);
  std::vector<tf::Tensor> outputs;
  OK(bundle.GetSession()->Run({{signature.inputs().at("x").name(), x}}, {signature.outputs().at("y").name()}, {}, &outputs));
  SAME(outputs.at(0).flat<float>()(1), 21.f);
}

int main(int, char** arguments) {
  client_session();
  saved_model(arguments[1]);
  std::cout << "tensorflow " << TF_VERSION_STRING << std::endl;
}
