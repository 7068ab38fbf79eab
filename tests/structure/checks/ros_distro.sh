#!/usr/bin/env bash
# The ROS distribution is the one that the tag promises.
set -euo pipefail
[[ $ROS_DISTRO == "${EXPECT_ROS_DISTRO:?}" && $ROS_VERSION == "${EXPECT_ROS:?}" ]] ||
  { echo "ROS_DISTRO=$ROS_DISTRO ROS_VERSION=$ROS_VERSION, expected $EXPECT_ROS_DISTRO and $EXPECT_ROS" >&2; exit 1; }

# Debian's catkin sets ROS_DISTRO itself, and stops builds that come with another.
hook=${CHECK_ROOT:-}/etc/catkin/profile.d/1.ros_distro.sh
if [[ -r $hook ]]; then
  # shellcheck disable=SC1090  # a file of the image
  complaint=$(source "$hook")
  [[ -z $complaint ]] || { echo "$complaint" >&2; exit 1; }
fi
