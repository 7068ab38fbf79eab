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

mkdir -p "${WORKSPACE:=/docker-ros/ws}"
# Which ROS it is, 1 or 2: conditions in manifests ask for that.
# shellcheck source=components/containerize/setup.sh
source "$here/setup.sh"

if ! python3 -c 'import catkin_pkg, rosdep2' 2>/dev/null; then
  echo "error: the base image has no rosdep; take one of ours, or install python3-rosdep in yours" >&2
  exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work" "$APT_CONFIG" "$APT_CONFIG.sources"' EXIT
left_out=/run/requests/blacklist
if [[ ${MANIFESTS:-} == changed ]]; then left_out=/dev/null; fi
"$here/identify.py" /run/manifests "$left_out" /run/rosdep "$work" "$1"
