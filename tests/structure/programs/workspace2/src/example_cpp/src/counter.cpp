// A component that is a lifecycle node: while it is active, it counts as an action asks it to, in steps of a parameter.
#include <example_msgs/action/count.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>

#include <memory>

namespace example_cpp {

using example_msgs::action::Count;
using Goal = rclcpp_action::ServerGoalHandle<Count>;
using Callback = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Counter : public rclcpp_lifecycle::LifecycleNode {
 public:
  explicit Counter(const rclcpp::NodeOptions& options) : LifecycleNode("counter", options) {
    declare_parameter("step", 1);
  }

  Callback on_configure(const rclcpp_lifecycle::State&) override {
    server_ = rclcpp_action::create_server<Count>(
        this, "count",
        [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Count::Goal>) {
          return active_ ? rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE : rclcpp_action::GoalResponse::REJECT;
        },
        [](std::shared_ptr<Goal>) { return rclcpp_action::CancelResponse::REJECT; },
        [this](std::shared_ptr<Goal> goal) { count(*goal); });
    return Callback::SUCCESS;
  }
  Callback on_activate(const rclcpp_lifecycle::State&) override {
    active_ = true;
    return Callback::SUCCESS;
  }
  Callback on_deactivate(const rclcpp_lifecycle::State&) override {
    active_ = false;
    return Callback::SUCCESS;
  }

 private:
  void count(Goal& goal) {
    const auto step = static_cast<int>(get_parameter("step").as_int());
    const auto result = std::make_shared<Count::Result>();
    const auto feedback = std::make_shared<Count::Feedback>();
    for (int number = step; number <= goal.get_goal()->to; number += step) {
      feedback->number = number;
      goal.publish_feedback(feedback);
      result->numbers.push_back(number);
    }
    goal.succeed(result);
  }

  bool active_ = false;
  rclcpp_action::Server<Count>::SharedPtr server_;
};

}  // namespace example_cpp

RCLCPP_COMPONENTS_REGISTER_NODE(example_cpp::Counter)
