#!/usr/bin/env bash
# A talker and a listener exchange a message over every RMW implementation that the matrix promises.
set -euo pipefail
IFS=, read -ra names <<<"${EXPECT_RMW:-}"
for name in '' "${names[@]}"; do
  RMW_IMPLEMENTATION=$name python3 /run/tests/programs/rclpy/talk.py "$name"
done
