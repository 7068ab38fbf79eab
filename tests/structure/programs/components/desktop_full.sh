# shellcheck shell=bash
# desktop-full: what desktop has, and the simulators' packages.
dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' ros-simulators | grep '^installed '
