#!/usr/bin/env bash
# A talker and a listener over DDS, for each order in which the listener can import rclpy and the frameworks. Fails if
# an answer is wrong, or if one of them does not end, and end well.
#   run.sh PYTHON   the interpreter of the virtual environment that has rclpy
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
python=$1
work=$(mktemp -d)
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST ROS_LOG_DIR=$work/ros TF_CPP_MIN_LOG_LEVEL=2
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT

for order in rclpy,torch,tensorflow rclpy,tensorflow,torch torch,rclpy,tensorflow \
  tensorflow,rclpy,torch torch,tensorflow,rclpy tensorflow,torch,rclpy; do
  timeout --kill-after 5 150 "$python" "$here/listener.py" $order >"$work/listener" 2>&1 & listener=$!
  timeout --kill-after 5 150 "$python" "$here/talker.py" >"$work/talker" 2>&1 & talker=$!
  heard=0 talked=0
  wait "$talker" || talked=$?
  wait "$listener" || heard=$?
  echo "$order: $(grep answers "$work/talker" || true); exit codes $talked and $heard"
  if [[ $talked != 0 || $heard != 0 ]] || grep -E 'double free|corruption|terminate called' "$work"/{talker,listener}; then
    cat "$work"/{talker,listener} >&2
    exit 1
  fi
done
