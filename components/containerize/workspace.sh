#!/usr/bin/env bash
# Builds the packages below /run/sources into $WORKSPACE/install, on what is there already.
#   CMAKE_ARGS   arguments of CMake, as a shell reads them
#   COLCON_ARGS  arguments of colcon build, likewise
#   workspace.sh FOLDER   of $WORKSPACE/src: upstream, target, downstream
set -euo pipefail

# What the packages install outside of the workspace, for app_files.py.
outside=/rosml-outside
mkdir -p /docker-ros/ws "$outside"
started=$(mktemp)
export WORKSPACE=${WORKSPACE:-/docker-ros/ws} COLCON_LOG_PATH=/tmp/log
# At the place where the dev image has them: paths in the install space and in debug information are the same.
mkdir -p "$WORKSPACE/src/$1"
# Most workspaces import nothing. A script of the repository may have put packages there.
if source=$(find /run/sources/. "$WORKSPACE/src/$1" -mindepth 1 -print -quit) && [[ -z $source ]]; then exit; fi
cp -R --preserve=mode,links /run/sources/. "$WORKSPACE/src/$1"
# shellcheck source=components/containerize/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
listed=$(colcon list --paths-only --base-paths "src/$1")
if [[ -z $listed ]]; then exit; fi
# colcon knows more kinds of packages than those with a manifest, and looks for none inside of a package.
while IFS= read -r place; do
  if [[ -e $place/package.xml ]]; then continue; fi
  inside=$(find "$place" -mindepth 1 \( -name '.*' -o -exec test -e {}/COLCON_IGNORE -o -e {}/CATKIN_IGNORE -o -e {}/AMENT_IGNORE \; \) \
    -prune -o -name package.xml -print -quit)
  if [[ -n $inside ]]; then
    echo "error: colcon takes $place for a package of CMake or Python, and does not build ${inside%/package.xml} inside of it;" \
      "call rosml for a folder below, or let docker/before_dependency_identification.sh remove CMakeLists.txt, setup.py and" \
      "pyproject.toml of $place" >&2
    exit 1
  fi
done <<<"$listed"
arguments=()
eval "arguments=(${CMAKE_ARGS:-})"
# CMake writes the path of Python into nodes and tests, and a slim base image has no link of an image on which rosml installed ROS.
if [[ -e /usr/local/lib/rosml/bin/python3 ]]; then
  arguments=(--no-warn-unused-cli -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython{,3}_EXECUTABLE=/usr/bin/python3 "${arguments[@]}")
fi
own=()
if [[ ${ROS_VERSION:-} == 1 ]]; then own=(--catkin-skip-building-tests); fi # test.sh builds them, if they are to run
eval "own+=(${COLCON_ARGS:-})"
limit_jobs "$(wc -l <<<"$listed")"
metas_of "src/$1"
colcon build --base-paths "src/$1" "${metas[@]}" --event-handlers console_cohesion+ "${workers[@]}" "${own[@]}" --cmake-args "${arguments[@]}" || {
  code=$?
  why=$(killed)
  name=$(unnamed)
  if [[ -n $why ]]; then
    echo "error: a program was killed ($why); memory may have run out" >&2
  elif printed 'No space left on device' | grep -q .; then
    echo "error: a package does not build: No space left on device; free some" >&2
  elif [[ -n $name ]]; then
    echo "error: a package needs $name, and no package.xml names it; add it as rosdep calls it, such as <depend>$name</depend>" >&2
  elif asks_git; then
    echo "error: a package asks git for its version, and no build has .git; if that is why, let it take another one where git" \
      "fails, such as fallback_version of setuptools_scm" >&2
  else
    first_errors >&2
  fi
  exit "$code"
}
cd /
# What the build left running may change or remove files meanwhile: tar then ends with 1.
find . -ignore_readdir_race -xdev \( -path ./docker-ros -o -path ./tmp -o -path ./var/tmp -o -path ".$outside" -o -path ./root/.ros \
  -o -path ./root/.colcon -o -path ./root/.cache -o -path ./root/.ccache \) -prune -o ! -type d -cnewer "$started" -print0 \
  | { TAR_OPTIONS='' tar --create --null --no-recursion --ignore-failed-read --files-from=- || (($? == 1)); } \
  | TAR_OPTIONS='' tar --extract --directory="$outside"
rm "$started"
