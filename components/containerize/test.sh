#!/usr/bin/env bash
# Runs the tests of the packages in src/$TESTED (src/target if it is not set), in the workspace that workspace.sh built. Their JUnit files and those of CTest
# go into a folder for each package, with `failed`, a list of what failed, if something did: whoever reads it says so, after
# the reports are out.
#   test.sh OUT [built]   built: their programs are there, and no compiler
set -euo pipefail

out=$1
folder=src/${TESTED:-target}
mkdir -p "$out"
scratch=$(mktemp -d)
export WORKSPACE=${WORKSPACE:-/docker-ros/ws} COLCON_LOG_PATH=$scratch/log ROS_HOME=/tmp/ros HOME=/tmp
# shellcheck source=components/containerize/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

listed=$(colcon list --names-only --base-paths "$folder")
if [[ -z $listed ]]; then exit; fi
mapfile -t packages <<<"$listed"
if [[ ${ROS_VERSION:-} == 1 && -z ${2:-} ]]; then # catkin builds tests by a target of their own
  limit_jobs "${#packages[@]}"
  colcon build --base-paths "$folder" "${workers[@]}" --packages-select "${packages[@]}" --event-handlers console_cohesion+ \
    --cmake-target tests --cmake-target-skip-unavailable || {
    why=$(killed)
    echo "tests do not build${why:+: a program was killed ($why); memory may have run out: --parallel-jobs 1}" >>"$out/failed"
  }
fi
touch "$scratch/begun"
colcon test --base-paths "$folder" --packages-select "${packages[@]}" --event-handlers console_cohesion+ ||
  echo "colcon test ended with an error" >>"$out/failed"
sed -n -E 's/^\[[0-9.]+\] \((.+)\) TestFailure: .*/\1: its tests failed and left no report/p' \
  "$COLCON_LOG_PATH/latest_test/events.log" >>"$out/failed" || true # without a log, the line above says why
for package in "${packages[@]}"; do
  # What the build wrote is no result. JUnit files are XML with a test suite; CTest's own file has a list of tests.
  find "build/$package" -name '*.xml' -xtype f -newer "$scratch/begun" -print0 >"$scratch/reports"
  while IFS= read -r -d '' file; do
    if grep -q -e '<testsuite' -e '<TestList>' "$file"; then
      install -D --mode=644 "$file" "$out/$package/${file#"build/$package/"}"
    fi
  done <"$scratch/reports"
done
