#!/usr/bin/env bash
# A roscore, a talker and a listener in each language, and one line for each pair that exchanged a message.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
# Build steps may share the machine's network: tests of two images at a time must not meet.
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_HOME=$work/ros HOME=$work
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT

roscore -p "$port" >"$work/roscore.log" 2>&1 &
# shellcheck disable=SC2046  # pkg-config prints words
g++ -O0 -o "$work/node" "$here/node.cpp" $(pkg-config --cflags --libs roscpp std_msgs)

for _ in $(seq 100); do
  if rostopic list >/dev/null 2>&1; then break; fi
  sleep 0.1
done
rostopic list >/dev/null || { cat "$work/roscore.log" >&2; exit 1; }

python3 "$here/node.py" talk /from_rospy "hello from rospy" &
"$work/node" talk /from_roscpp "hello from roscpp" &
timeout 30 python3 "$here/node.py" listen /from_rospy | sed 's/^/rospy -> rospy: /'
timeout 30 python3 "$here/node.py" listen /from_roscpp | sed 's/^/roscpp -> rospy: /'
timeout 30 "$work/node" listen /from_rospy | sed 's/^/rospy -> roscpp: /'
