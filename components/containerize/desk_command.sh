#!/bin/bash
# Runs the program by whose name it is called, then joins what compilers were called with, for editors. colcon gets what CI gives it:
# the arguments of the repository, and for ROS 1 the tests, which catkin builds by a target of their own.
here=$(dirname "$(readlink -f "$0")")
workspace=${WORKSPACE:-/docker-ros/ws}
name=${0##*/}
PATH=:$PATH:
PATH=${PATH//":$here:"/:}
PATH=${PATH#:} PATH=${PATH%:}
trap : INT TERM HUP # the program gets them as well, and decides

metas=()
for folder in upstream target; do
  if [[ -e $workspace/src/$folder/colcon.meta ]]; then metas+=("$workspace/src/$folder/colcon.meta"); fi
done
if [[ ${#metas[@]} -gt 0 ]]; then metas=(--metas "${metas[@]}"); fi

# build_tests ARGUMENT…: of the packages that these arguments of colcon test select.
build_tests() {
  local word selects="" selected=()
  for word in "$@"; do
    case $word in
      --packages-* | --base-paths | --build-base | --install-base | --merge-install) selects=1 ;;
      -*) selects= ;;
    esac
    if [[ -n $selects ]]; then selected+=("$word"); fi
  done
  # Without arguments for CMake, which would configure again what somebody built with others.
  colcon build --base-paths "$workspace/src/target" "${metas[@]}" "${selected[@]}" --cmake-args --cmake-target tests \
    --cmake-target-skip-unavailable
}

# Packages of the base image are in the install space, as in CI: their files name that path.
below=/opt/ws_base_image/install
if [[ $name == colcon && ${1:-} == build && $(cat $below/.colcon_install_layout 2>/dev/null) == isolated ]]; then
  mkdir -p "$workspace/install"
  for package in "$below"/*/; do
    package=${package%/}
    if [[ -d $package/share && ! -e $workspace/install/${package##*/} ]]; then ln -sfn "$package" "$workspace/install/"; fi
  done
fi

own=()
if [[ $name == colcon && ${1:-} == build ]]; then
  eval "own=($(<"$here/colcon_args"))"
  set -- build "${metas[@]}" "${own[@]}" "${@:2}"
elif [[ $name == colcon && ${1:-} == test ]]; then
  set -- test "${metas[@]}" "${@:2}"
  if [[ ${ROS_VERSION:-} == 1 && " $* " != *" --help "* ]]; then build_tests "${@:2}" || exit; fi
fi
"$name" "$@"
status=$?
/usr/bin/python3 -I -S "$here/compile_commands.py" "$workspace" "${ROSML_DEV_FOLDER:-}"
exit $status
