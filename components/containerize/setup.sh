# shellcheck shell=bash
# Sourced by steps that work in the workspace: sources ROS and what the base image has built on it.
set +u # setup files of ROS read variables that nobody set
for _setup in "/opt/ros/${ROS_DISTRO:-}/setup.bash" /opt/ws_base_image/install/setup.bash \
  "${WORKSPACE:-/docker-ros/ws}/install/setup.bash"; do
  # shellcheck disable=SC1090  # only known here
  if [[ -r $_setup ]]; then source "$_setup"; fi
done
unset _setup
set -u
cd "${WORKSPACE:-/docker-ros/ws}" || exit
