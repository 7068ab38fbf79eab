#!/usr/bin/env bash
# A workspace of a message, and a package with a Python module that uses it and the image's frameworks and a C++ node,
# built as users do: with colcon build --symlink-install, and where there is no framework with catkin_make as well. Its
# nodes run.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work TF_CPP_MIN_LOG_LEVEL=3 PYTHONDONTWRITEBYTECODE=1
export ROS_LANG_DISABLE=geneus:genlisp:gennodejs # messages for C++ and Python are enough here
flags=(-DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCATKIN_ENABLE_TESTING=OFF)

# workspace NAME COMMAND...: builds a workspace of its own.
workspace() {
  local name=$1
  mkdir "$work/$name" && cp -r "$here/src" "$work/$name"
  (cd "$work/$name" && "${@:2}") >"$work/log.$name" 2>&1 || { cat "$work/log.$name" >&2; return 1; }
}

# node NAME COMMAND...: runs a node; the entrypoint sources the workspace.
node() { WORKSPACE=$work/$1 /entrypoint.sh rosrun "${@:2}" | sed "s|^|$1: |"; }

frameworks=()
for name in torch tensorflow; do
  promise=EXPECT_${name^^}
  if [[ -v $promise ]]; then frameworks+=("$name"); fi
done
workspace colcon colcon build --symlink-install --cmake-args -G Ninja "${flags[@]}" & colcon=$!
# With frameworks it is colcon alone, which configures and builds the same packages by the same CMake code.
if [[ ${#frameworks[@]} -eq 0 ]]; then
  workspace catkin_make catkin_make --use-ninja "${flags[@]}" || { wait; exit 1; }
  node catkin_make example score.py
  node catkin_make example score_cpp
fi
wait "$colcon"
node colcon example score.py "${frameworks[@]}"
node colcon example score_cpp
