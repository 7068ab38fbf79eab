#!/usr/bin/env bash
# Runs the programs of each component that the tag promises ($EXPECT_PACKAGES_…).
set -euo pipefail
export HOME; HOME=$(mktemp -d)
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$HOME"' EXIT
has() { [[ -v EXPECT_PACKAGES_${1^^} ]]; }

ran=(core)
ros2 topic list | grep -x /rosout
ros2 doctor --report | grep -i 'middleware name' # what it says of the distribution, it asks the network for
ros2 interface show std_msgs/msg/String | grep 'string data'
if has base; then
  ros2 bag --help >/dev/null
  # Options have had names since humble.
  if [[ $ROS_DISTRO == foxy ]]; then frames=(1 0 0 0 0 0 base camera); else frames=(--frame-id base --child-frame-id camera --x 1); fi
  ros2 run tf2_ros static_transform_publisher "${frames[@]}" >/dev/null 2>&1 &
  { timeout 60 ros2 run tf2_ros tf2_echo base camera 2>&1 || true; } | grep --max-count=1 -F 'Translation: [1.000'
  ran+=(base)
fi
if has perception; then
  ros2 run image_transport list_transports | grep image_transport/raw
  python3 -c 'import cv_bridge, image_geometry'
  ros2 pkg prefix pcl_conversions
  ran+=(perception)
fi
if has desktop; then
  # Their windows are opened in tests/e2e/test_ros.py. Whatever code they end with after their help:
  { QT_QPA_PLATFORM=offscreen timeout 60 rviz2 --help 2>&1 || true; } | grep display-config
  { QT_QPA_PLATFORM=offscreen timeout 60 rqt --help 2>&1 || true; } | grep perspective
  ran+=(desktop)
fi
if has desktop_full; then
  dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "ros-$ROS_DISTRO-simulation" | grep '^installed '
  ran+=(desktop_full)
fi
echo "components: ${ran[*]}"
