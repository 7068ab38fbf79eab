#!/usr/bin/env bash
# Runs the tests of the packages in src/target, in the workspace that workspace.sh built. Their JUnit files go into a folder, with
# `failed`, a list of what failed, if something did: whoever reads it says so, after the reports are out.
#   test.sh OUT
set -euo pipefail

out=$1
mkdir -p "$out"
export WORKSPACE=${WORKSPACE:-/docker-ros/ws} COLCON_LOG_PATH=/tmp/log ROS_HOME=/tmp/ros HOME=/tmp
# shellcheck source=components/containerize/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

mapfile -t packages < <(colcon list --names-only --base-paths src/target)
if [[ ${#packages[@]} -eq 0 ]]; then exit; fi
if [[ ${ROS_VERSION:-} == 1 ]]; then # catkin builds tests by a target of their own
  colcon build --base-paths src/target --packages-select "${packages[@]}" --event-handlers console_cohesion+ \
    --cmake-target tests --cmake-target-skip-unavailable || echo "tests do not build" >>"$out/failed"
fi
colcon test --base-paths src/target --packages-select "${packages[@]}" --event-handlers console_cohesion+ ||
  echo "colcon test ended with an error" >>"$out/failed"
for package in "${packages[@]}"; do
  if ! colcon test-result --test-result-base "build/$package" --verbose >/tmp/result; then
    sed "s/^/$package: /" /tmp/result >>"$out/failed"
  fi
  # JUnit files are XML with a test suite; CTest's own file is not one.
  while IFS= read -r -d '' file; do
    if grep -q '<testsuite' "$file"; then
      install -D --mode=644 "$file" "$out/$package/${file#"build/$package/"}"
    fi
  done < <(find "build/$package" -name '*.xml' -print0)
done
