#!/usr/bin/env bash
# Installs what runs the tests of an app in its slim image: what these need, without packages with headers, and the tools of
# /run/environment that call them. No image is made from here.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"
# shellcheck source=components/ros/apt.sh
source "$here/../ros/apt.sh"
export NOT_FOUND='check its name in docker/additional-debs.txt, or in the rule of rosdep that has it'

use_mirror "$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros 2>/dev/null)"
apt_update
if ! command -v python3 >/dev/null; then apt_install python3; fi
packages=()
# Many manifests name what tests are written with as what they are built with.
frameworks='(^|-)(lib)?(rostest|gtest|gmock|googletest|nose|pytest|launch-testing)'
grep -E "$frameworks" /run/needed/build.apt >"$scratch/frameworks" || [[ $? == 1 ]] # 1: there is none
sort -u /run/needed/test.apt "$scratch/frameworks" >"$scratch/tests"
mapfile -t tests <"$scratch/tests"
if [[ ${#tests[@]} -gt 0 ]]; then
  needed=$("$here/../ros/runtime_packages.py" "${tests[@]}")
  if [[ -n $needed ]]; then mapfile -t packages <<<"$needed"; fi
fi
# Without its compilers, cmake runs tests; what the slim image has of it is empty.
rm -f /etc/dpkg/dpkg.cfg.d/rosml-runtime
tools_of_environment() {
  dpkg-query --admindir=/run/environment/var/lib/dpkg --show --showformat '${db:Status-Status} ${Package}\n' \
    'cmake*' 'colcon' 'python3-colcon-*' 'python3-pytest*' 'python3-nose' 2>/dev/null || [[ $? == 1 ]] # it lacks some
}
installed=$(tools_of_environment | sed -n 's/^installed //p')
[[ -z $installed ]] || mapfile -t tools <<<"$installed"
apt_install --reinstall "${tools[@]}" "${packages[@]}"
if [[ -s /run/needed/test.pip ]]; then
  if ! python3 -m pip --version >/dev/null 2>&1; then apt_install python3-pip; fi
  mapfile -t requirements </run/needed/test.pip
  PIP_BREAK_SYSTEM_PACKAGES=1 PIP_NO_CACHE_DIR=1 PIP_ROOT_USER_ACTION=ignore python3 -m pip install "${requirements[@]}"
fi
command -v colcon >/dev/null || fail "the base image has colcon, and no package of it that the slim image could have for its tests" \
  "install colcon by apt in the base image, or leave the slim image out: --no-enable-slim"
