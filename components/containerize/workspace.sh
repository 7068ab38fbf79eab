#!/usr/bin/env bash
# Builds the packages below /run/sources into $WORKSPACE/install, on what is there already.
#   CMAKE_ARGS  arguments of CMake, as a shell reads them
#   workspace.sh FOLDER   of $WORKSPACE/src: upstream, target, downstream
set -euo pipefail

export WORKSPACE=${WORKSPACE:-/docker-ros/ws} COLCON_LOG_PATH=/tmp/log
# At the place where the dev image has them: paths in the install space and in debug information are the same.
mkdir -p "$WORKSPACE/src/$1"
cp -R --preserve=mode,links /run/sources/. "$WORKSPACE/src/$1"
# shellcheck source=components/containerize/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
listed=$(colcon list --names-only --base-paths "src/$1")
if [[ -z $listed ]]; then exit; fi
arguments=()
eval "arguments=(${CMAKE_ARGS:-})"
colcon build --base-paths "src/$1" --event-handlers console_cohesion+ --cmake-args "${arguments[@]}"
