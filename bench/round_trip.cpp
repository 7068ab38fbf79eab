// round_trip COUNT BYTES…: two nodes in two processes. One asks with a message of so many bytes, the other sends it back. Prints a line
// of JSON: for each size the median round trip and the processor time of both nodes for one; then the median
// time of a product of two matrices.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

constexpr int WARM_UP = 20;  // rounds that do not count
constexpr int SIZE = 256, TIMES = 200;  // of the matrices, and how often they are multiplied
const auto HINTS = ros::TransportHints().tcpNoDelay();

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return now.tv_sec + now.tv_nsec * 1e-9;
}

void answer() {
  ros::NodeHandle node;
  auto publisher = node.advertise<std_msgs::String>("answers", 1);
  auto subscriber = node.subscribe<std_msgs::String>(
      "questions", 1, [&](const std_msgs::String::ConstPtr& message) { publisher.publish(message); }, {}, HINTS);
  ros::spin();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

double computation() {
  std::vector<float> a(SIZE * SIZE, 1.5F), b(SIZE * SIZE, 0.5F), product(SIZE * SIZE);
  std::vector<double> times;
  for (int time = 0; time < TIMES; ++time) {
    const double begun = seconds(CLOCK_MONOTONIC);
    for (int i = 0; i < SIZE; ++i)
      for (int k = 0; k < SIZE; ++k)
        for (int j = 0; j < SIZE; ++j) product[i * SIZE + j] += a[i * SIZE + k] * b[k * SIZE + j];
    times.push_back(seconds(CLOCK_MONOTONIC) - begun);
  }
  if (product[0] != TIMES * SIZE * 0.75F) std::abort();  // and the compiler leaves nothing out
  return median(times);
}

int main(int argc, char** argv) {
  const pid_t other = fork();
  if (other == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    ros::init(argc, argv, "answers");
    answer();
    return 0;
  }
  clockid_t other_clock{};
  clock_getcpuclockid(other, &other_clock);
  ros::init(argc, argv, "asks");
  ros::NodeHandle node;
  size_t answered = 0;
  auto publisher = node.advertise<std_msgs::String>("questions", 1);
  auto subscriber = node.subscribe<std_msgs::String>(
      "answers", 1, [&](const std_msgs::String::ConstPtr& message) { answered = message->data.size(); }, {}, HINTS);
  const double until = seconds(CLOCK_MONOTONIC) + 60;
  while (publisher.getNumSubscribers() == 0 || subscriber.getNumPublishers() == 0) {
    if (seconds(CLOCK_MONOTONIC) > until) return 1;
    usleep(10'000);
  }
  auto* queue = ros::getGlobalCallbackQueue();
  std::printf("{");
  for (int argument = 2; argument < argc; ++argument) {
    std_msgs::String question;
    question.data.assign(std::atol(argv[argument]), 'x');
    std::vector<double> trips;
    double processor = 0;
    const int count = std::atoi(argv[1]);
    for (int round = -WARM_UP; round < count; ++round) {
      if (round == 0) processor = seconds(CLOCK_PROCESS_CPUTIME_ID) + seconds(other_clock);
      const double begun = seconds(CLOCK_MONOTONIC);
      answered = 0;
      publisher.publish(question);
      while (answered != question.data.size()) {
        queue->callAvailable(ros::WallDuration(1));
        if (seconds(CLOCK_MONOTONIC) > begun + 30) return 1;
      }
      if (round >= 0) trips.push_back(seconds(CLOCK_MONOTONIC) - begun);
    }
    processor = seconds(CLOCK_PROCESS_CPUTIME_ID) + seconds(other_clock) - processor;
    std::printf("\"trip %s\": %.9f, \"processor %s\": %.9f, ", argv[argument], median(trips), argv[argument],
                processor / count);
  }
  std::printf("\"computation\": %.9f}\n", computation());
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
}
