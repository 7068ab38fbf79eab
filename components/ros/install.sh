#!/usr/bin/env bash
# Installs one ROS component on top of the one below it.
#   ROS_PACKAGES  Debian packages of the component, separated by spaces
#   ROS_TOOLS     packages of the developers' tools (colcon, rosdep, vcs), installed with the first component
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

read -ra packages <<<"${ROS_TOOLS:-} ${ROS_PACKAGES:?}"
apt-get update
apt-get install --yes "${packages[@]}"

"$here/../build/clean.sh"
