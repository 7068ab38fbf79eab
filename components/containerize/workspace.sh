#!/usr/bin/env bash
# Builds the workspace: the packages below /run/sources, into $WORKSPACE/install.
#   CMAKE_ARGS  arguments of CMake, as a shell reads them
set -euo pipefail

export WORKSPACE=${WORKSPACE:-/docker-ros/ws} COLCON_LOG_PATH=/tmp/log
mkdir -p "$WORKSPACE/src"
# At the place where the dev image has them: paths in the install space and in debug information are the same.
cp -R --preserve=mode,links /run/sources/. "$WORKSPACE/src"
# shellcheck source=components/containerize/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
arguments=()
eval "arguments=(${CMAKE_ARGS:-})"
colcon build --base-paths src --event-handlers console_cohesion+ --cmake-args "${arguments[@]}"
