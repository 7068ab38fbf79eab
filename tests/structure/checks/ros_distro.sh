#!/usr/bin/env bash
# The ROS distribution is the one that the tag promises.
set -euo pipefail
[[ $ROS_DISTRO == "${EXPECT_ROS_DISTRO:?}" && $ROS_VERSION == "${EXPECT_ROS:?}" ]] ||
  { echo "ROS_DISTRO=$ROS_DISTRO ROS_VERSION=$ROS_VERSION, expected $EXPECT_ROS_DISTRO and $EXPECT_ROS" >&2; exit 1; }
