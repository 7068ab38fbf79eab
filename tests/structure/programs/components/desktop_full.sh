# shellcheck shell=bash
# desktop-full: what desktop has, and the simulators' packages. Debian's have no distribution in their names.
simulators=ros-${ROS_DISTRO,,}-simulators
dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "${simulators/-debian/}" | grep '^installed '
