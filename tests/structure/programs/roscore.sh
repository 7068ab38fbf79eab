# shellcheck shell=bash
# Sourced by tests of ROS 1: a roscore of their own, at $ROS_MASTER_URI, and a folder $work; both end with the script.
work=$(mktemp -d)
# Build steps may share the machine's network: tests of two images at a time must not meet.
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_HOME=$work/ros HOME=$work
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT
start_core() {
  roscore -p "$port" >>"$work/roscore.log" 2>&1 &
  core=$!
}
start_core

# until_it_answers COMMAND…: waits for a command to succeed, two minutes at most: a machine may be busy, or emulated.
# roslaunch itself gives its master ten seconds, and ends; the next one finds the files in memory.
until_it_answers() {
  local end=$((SECONDS + 120))
  while ((SECONDS < end)); do
    if "$@" >/dev/null 2>&1; then return; fi
    kill -0 "$core" 2>/dev/null || start_core
    sleep 0.1
  done
  "$@" || { cat "$work/roscore.log" >&2; return 1; }
}
