#!/usr/bin/env bash
# A C++ program with ROS, ONNX Runtime, and libtorch and tensorflow_cc if the image promises them, with the address sanitizer.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work ROS_HOME=$work/ros TF_CPP_MIN_LOG_LEVEL=3

options=("-DMEANS=/run/tests/programs/coexist2/src")
for name in torch tensorflow; do
  promise=EXPECT_${name^^}
  if [[ -v $promise ]]; then options+=("-DWITH_${name^^}=ON"); fi
done
# ROS 2 from Python's wheels has no rclcpp.
if python3 -c 'import ros_wheels_bootstrapper' 2>/dev/null; then options+=(-DWITH_ROS=OFF); fi
/run/tests/programs/onnxruntime/model.py "$work"
cmake -S "$here" -B "$work/build" -G Ninja "${options[@]}" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }

# Leaks are not looked for: the frameworks keep what they have until the process ends. Nor is the size that memory is freed with, of
# which rclcpp's own allocator for rcl says one byte.
code=0
ASAN_OPTIONS=detect_leaks=0:new_delete_type_mismatch=0 timeout --kill-after=10 120 "$work/build/beside" "$work/mean.onnx" >"$work/said" 2>&1 ||
  code=$?
cat "$work/said"
if ((code)) || grep -E 'double free|corruption|terminate called|AddressSanitizer' "$work/said" >&2; then
  echo "the program ended with $code (124: not within 120 s)" >&2 && exit 1
fi
