#!/usr/bin/env bash
# Finds out which packages the manifests in /run/manifests need, and writes them into a folder, as identify.py says.
#   SKIP_KEYS    keys of rosdep that are left out, separated by blanks or commas
#   CONDITIONS   the ROS that conditions in manifests compare with
#   MANIFESTS    `changed` where the packages that are to be left out are gone already
#   ROSDEP_DAY   the day on which rosdep's index was asked last; with another one the step runs again
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"

mkdir -p "${WORKSPACE:=/docker-ros/ws}"
# Which ROS it is, 1 or 2: conditions in manifests ask for that.
# shellcheck source=components/containerize/setup.sh
source "$here/setup.sh"

has_rosdep() { python3 -c 'import catkin_pkg, rosdep2' 2>/dev/null; }
if ! has_rosdep; then
  apt_update
  for package in python3-rosdep2 python3-rosdep; do # Debian's, then ROS's own
    if has_rosdep; then break; fi
    there=$(apt-cache madison "$package")
    if [[ -n $there ]]; then apt_install "$package"; fi
  done
  has_rosdep || fail "the base image has no rosdep, and its apt sources have none" \
    "take one of ours, or install python3-rosdep in yours"
fi
work=$(mktemp -d)
trap 'rm -rf "$work" "$scratch" "$APT_CONFIG" "$APT_CONFIG.sources"' EXIT
left_out=/run/requests/blacklist
if [[ ${MANIFESTS:-} == changed ]]; then left_out=/dev/null; fi
"$here/identify.py" /run/manifests "$left_out" /run/rosdep "$work" "$1"
