// tensorflow::ClientSession, for wheels whose libtensorflow_cc does not export it although its header is there.
//
// Written from the documentation in tensorflow/cc/client/client_session.h and tensorflow/core/public/session.h: a graph
// that grows while it is used, over a Session, which knows tensors by name.
#include "tensorflow/cc/client/client_session.h"

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "tensorflow/core/graph/graph.h"
#include "tensorflow/core/public/session.h"

namespace tensorflow {

namespace {

using Feeds = std::vector<std::pair<std::string, Tensor>>;
using Names = std::vector<std::string>;

// A graph may grow between runs. By default sessions optimise for one that does not, and refuse to extend it; whoever
// gives options of their own decides.
SessionOptions OptionsFor(const string& target) {
  SessionOptions options;
  options.target = target;
  options.config.mutable_experimental()->set_disable_optimize_for_static_graph(true);
  return options;
}

}  // namespace

class __attribute__((visibility("hidden"))) ClientSession::Impl {
 public:
  Impl(const Scope& scope, const SessionOptions& options) : scope_(scope) {
    Session* session = nullptr;
    created_ = NewSession(options, &session);
    session_.reset(session);
    if (created_.ok() && !session_) created_ = absl::InternalError("NewSession made no session");
  }

  ~Impl() {
    if (session_) session_->Close().IgnoreError();
  }

  // The session, with all operations in it that the scope has got by now. A constructor cannot return a status:
  // whatever kept the session from being made is what every call returns.
  absl::Status Ready(Session** session) const {
    if (!created_.ok()) return created_;
    const std::lock_guard<std::mutex> lock(mutex_);
    const Graph& graph = *scope_.graph();
    const int nodes = graph.num_node_ids();
    if (nodes > sent_) {
      GraphDef added;
      graph.ToGraphDefSubRange(&added, sent_);
      if (absl::Status status = session_->Extend(std::move(added)); !status.ok()) return status;
      sent_ = nodes;
    }
    *session = session_.get();
    return absl::OkStatus();
  }

  // Names instead of objects, and the session that knows them.
  struct Step {
    Session* session = nullptr;
    Feeds feeds;
    Names fetches;
    Names targets;
  };

  absl::Status Prepare(const FeedType& inputs, const std::vector<Output>& fetch_outputs,
                       const std::vector<Operation>& run_outputs, const std::vector<Tensor>* outputs,
                       Step* step) const {
    if (!fetch_outputs.empty() && outputs == nullptr) {
      return absl::InvalidArgumentError("ClientSession::Run: there are outputs to fetch, but `outputs` is null");
    }
    for (const auto& [output, value] : inputs) {
      if (output.node() == nullptr) return Missing("feed");
      if (!value.status.ok()) return value.status;
      step->feeds.emplace_back(output.name(), value.tensor);
    }
    for (const Output& output : fetch_outputs) {
      if (output.node() == nullptr) return Missing("fetch");
      step->fetches.push_back(output.name());
    }
    for (const Operation& operation : run_outputs) {
      if (operation.node() == nullptr) return Missing("run");
      step->targets.push_back(operation.node()->name());
    }
    return Ready(&step->session);
  }

 private:
  // An operation that could not be constructed leaves no node; its scope knows why.
  absl::Status Missing(const char* purpose) const {
    const absl::Status status = scope_.status();
    if (!status.ok()) return status;
    return absl::InvalidArgumentError(std::string("ClientSession: an operation to ") + purpose + " is not in a graph");
  }

  const Scope scope_;  // keeps the graph
  absl::Status created_;
  std::unique_ptr<Session> session_;
  mutable std::mutex mutex_;
  mutable int sent_ = 0;  // nodes with smaller ids are in the session; guarded by mutex_
};

ClientSession::ClientSession(const Scope& scope, const SessionOptions& session_options)
    : impl_(std::make_unique<Impl>(scope, session_options)) {}

ClientSession::ClientSession(const Scope& scope, const string& target) : ClientSession(scope, OptionsFor(target)) {}

ClientSession::ClientSession(const Scope& scope) : ClientSession(scope, string()) {}

ClientSession::~ClientSession() = default;

absl::Status ClientSession::Run(const std::vector<Output>& fetch_outputs, std::vector<Tensor>* outputs) const {
  return Run(FeedType(), fetch_outputs, {}, outputs);
}

absl::Status ClientSession::Run(const FeedType& inputs, const std::vector<Output>& fetch_outputs,
                                std::vector<Tensor>* outputs) const {
  return Run(inputs, fetch_outputs, {}, outputs);
}

absl::Status ClientSession::Run(const FeedType& inputs, const std::vector<Output>& fetch_outputs,
                                const std::vector<Operation>& run_outputs, std::vector<Tensor>* outputs) const {
  Impl::Step step;
  const absl::Status status = impl()->Prepare(inputs, fetch_outputs, run_outputs, outputs, &step);
  return status.ok() ? step.session->Run(step.feeds, step.fetches, step.targets, outputs) : status;
}

absl::Status ClientSession::Run(const RunOptions& run_options, const FeedType& inputs,
                                const std::vector<Output>& fetch_outputs, const std::vector<Operation>& run_outputs,
                                std::vector<Tensor>* outputs, RunMetadata* run_metadata) const {
  Impl::Step step;
  const absl::Status status = impl()->Prepare(inputs, fetch_outputs, run_outputs, outputs, &step);
  if (!status.ok()) return status;
  return step.session->Run(run_options, step.feeds, step.fetches, step.targets, outputs, run_metadata);
}

absl::Status ClientSession::Run(const RunOptions& run_options, const FeedType& inputs,
                                const std::vector<Output>& fetch_outputs, const std::vector<Operation>& run_outputs,
                                std::vector<Tensor>* outputs, RunMetadata* run_metadata,
                                const thread::ThreadPoolOptions& threadpool_options) const {
  Impl::Step step;
  const absl::Status status = impl()->Prepare(inputs, fetch_outputs, run_outputs, outputs, &step);
  if (!status.ok()) return status;
  return step.session->Run(run_options, step.feeds, step.fetches, step.targets, outputs, run_metadata,
                           threadpool_options);
}

absl::Status ClientSession::MakeCallable(const CallableOptions& callable_options, CallableHandle* out_handle) {
  Session* session = nullptr;
  const absl::Status status = impl()->Ready(&session);
  return status.ok() ? session->MakeCallable(callable_options, out_handle) : status;
}

absl::Status ClientSession::RunCallable(CallableHandle handle, const std::vector<Tensor>& feed_tensors,
                                        std::vector<Tensor>* fetch_tensors, RunMetadata* run_metadata) {
  Session* session = nullptr;
  const absl::Status status = impl()->Ready(&session);
  return status.ok() ? session->RunCallable(handle, feed_tensors, fetch_tensors, run_metadata) : status;
}

absl::Status ClientSession::RunCallable(CallableHandle handle, const std::vector<Tensor>& feed_tensors,
                                        std::vector<Tensor>* fetch_tensors, RunMetadata* run_metadata,
                                        const thread::ThreadPoolOptions& options) {
  Session* session = nullptr;
  const absl::Status status = impl()->Ready(&session);
  return status.ok() ? session->RunCallable(handle, feed_tensors, fetch_tensors, run_metadata, options) : status;
}

absl::Status ClientSession::ReleaseCallable(CallableHandle handle) {
  Session* session = nullptr;
  const absl::Status status = impl()->Ready(&session);
  return status.ok() ? session->ReleaseCallable(handle) : status;
}

}  // namespace tensorflow
