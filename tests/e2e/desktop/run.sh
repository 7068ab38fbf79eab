#!/usr/bin/env bash
# Opens the windows of component desktop on a virtual display (packages xvfb and x11-utils), with the image's own OpenGL
# in software, and prints `window: TITLE` for each.
set -euo pipefail
work=$(mktemp -d)
trap 'jobs -p | xargs --no-run-if-empty kill -KILL 2>/dev/null || true; rm -rf "$work"' EXIT
export HOME=$work QT_X11_NO_MITSHM=1 LIBGL_ALWAYS_SOFTWARE=1 # build steps have little shared memory
unset QT_QPA_PLATFORM

# within SECONDS COMMAND…: waits for a command to succeed.
within() {
  local _
  for _ in $(seq $((10 * $1))); do
    if "${@:2}" >/dev/null 2>&1; then return; fi
    sleep 0.1
  done
  "${@:2}"
}

Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp 3>"$work/display" >"$work/Xvfb.log" 2>&1 &
within 20 grep -q '[0-9]' "$work/display" || { cat "$work/Xvfb.log" >&2; exit 1; }
DISPLAY=:$(cat "$work/display")
export DISPLAY

titled() { xwininfo -root -tree | grep -E "\"[^\"]*$1[^\"]*\":"; }

# opens TITLE COMMAND…: a program opens a window with that in its title, and does not end.
opens() {
  local program
  timeout --kill-after=5 100 "${@:2}" >"$work/log" 2>&1 &
  program=$!
  if ! { within 60 titled "$1" && sleep 2 && kill -0 "$program"; }; then
    echo "no window titled $1:" >&2
    tail -n 50 "$work/log" >&2
    xwininfo -root -tree >&2
    return 1
  fi
  titled "$1" | sed 's/^ *[^ ]* /window: /'
  kill -KILL -- "-$program" 2>/dev/null || kill -KILL "$program"
  wait "$program" 2>/dev/null || true
}

if [[ $ROS_VERSION == 1 ]]; then
  roscore >"$work/roscore.log" 2>&1 &
  within 30 rostopic list
  # A joint that does not move: the program passes a fraction to Qt's sliders, which Python 3.10 and newer refuse.
  rosparam set robot_description '<robot name="arm"><link name="base"/><link name="hand"/><joint name="wrist"
    type="fixed"><parent link="base"/><child link="hand"/></joint></robot>'
  opens RViz rosrun rviz rviz
  opens 'Joint State Publisher' rosrun joint_state_publisher_gui joint_state_publisher_gui
else
  opens RViz ros2 run rviz2 rviz2
  opens rqt rqt
fi
