#!/usr/bin/env bash
# Installs one ROS component on top of the one below it.
#   ROS_PACKAGES  Debian packages of the component, separated by spaces
#   ROS_TOOLS     packages of the developers' tools (colcon, rosdep, vcs), installed with the first component
#   RUNTIME       not empty: of all these only what programs need that are built already (runtime_packages.py)
#   ROS_CHANNEL   live, testing, snapshot or final, where packages come from ROS's own apt source; see source.sh
#   ROS_ARCHIVE   address of another apt archive that they come from; see source.sh
#   ROS_CODENAME, ROS_SYNC_DATE  suite of that source, and of when it has to be
#   ROS_DISTRO, ROS_VERSION  the distribution, and 1 or 2
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/apt.sh"

# The first component brings the apt source; later ones find it in the image that they stand on.
if [[ ! -e /usr/local/share/rosml/versions.d/ros ]]; then
  first=true
  mkdir -p /usr/local/share/rosml/versions.d
  printf 'ros-%s %s\n' distro "${ROS_DISTRO:?}" version "${ROS_VERSION:?}" >/usr/local/share/rosml/versions.d/ros
  if [[ -n ${ROS_CHANNEL:-}${ROS_ARCHIVE:-} ]]; then "$here/source.sh"; fi
fi
# With the first component, and for all that is installed later.
if [[ -n ${first:-} && $ROS_VERSION == 1 && -z ${RUNTIME:-} ]]; then
  program=/usr/local/lib/rosml/message-headers
  install -D --mode=755 "$here/message-headers.sh" $program
  echo "DPkg::Post-Invoke { \"if [ -x $program ]; then $program; fi\"; };" >/etc/apt/apt.conf.d/90message-headers
fi
source=$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros)
use_mirror "$source"

read -ra packages <<<"${ROS_TOOLS:-} ${ROS_PACKAGES:?}"
apt_update
if [[ -n $source ]]; then require_sync "$source"; fi
if [[ -n ${RUNTIME:-} ]]; then
  needed=$("$here/runtime_packages.py" "${packages[@]}")
  mapfile -t packages <<<"$needed"
fi
apt_install "${packages[@]}"

# Debian's rosdep is initialised as it comes.
rosdep=/etc/ros/rosdep/sources.list.d/20-default.list
if [[ ! -e $rosdep && -z ${RUNTIME:-} ]]; then install -D --mode=644 "$here/rosdep.list" $rosdep; fi

"$here/../build/clean.sh"
