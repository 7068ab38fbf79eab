#!/usr/bin/env bash
# Runs the tests of the packages in src/$TESTED (src/target if it is not set), in the workspace that workspace.sh built. Their JUnit files and those of CTest
# go into a folder for each package, with `failed`, a list of what failed, if something did: whoever reads it says so, after
# the reports are out. What left no JUnit file has what it printed in output.log.
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
metas_of "$folder"
if [[ ${ROS_VERSION:-} == 1 && -z ${2:-} ]]; then # catkin builds tests by a target of their own
  limit_jobs "${#packages[@]}"
  colcon build --base-paths "$folder" "${metas[@]}" "${workers[@]}" --packages-select "${packages[@]}" --event-handlers console_cohesion+ \
    --cmake-target tests --cmake-target-skip-unavailable || {
    why=$(killed)
    echo "tests do not build${why:+: a program was killed ($why); memory may have run out: --parallel-jobs 1}" >>"$out/failed"
  }
fi
touch "$scratch/begun"
colcon test --base-paths "$folder" "${metas[@]}" --packages-select "${packages[@]}" --event-handlers console_cohesion+ || ended=$?
# A test is root here, and may have put something else in the place of the reports.
if [[ -L $out || ! -d $out ]]; then
  rm -rf "$out"
  mkdir -p "$out"
  echo 'a test put something else in the place of the reports' >>"$out/failed"
elif [[ -L $out/failed || -d $out/failed ]]; then
  rm -rf "$out/failed"
  echo 'a test put something else in the place of the list of failed tests' >>"$out/failed"
fi
# Of Python's own tests, and of programs that write no JUnit file, there is what they printed.
logs=$COLCON_LOG_PATH/latest_test
named=$(sed -n -E "s/^\[[0-9.]+\] \((.+)\) (TestFailure: |JobEnded: .*'rc': [^0]).*/\1/p" "$logs/events.log" | sort -u) ||
  ended=${ended:-1}
for package in $named; do
  # Python 3.12 and newer end like this if a package has no tests.
  log=$logs/$package/stdout_stderr.log
  if grep -q -s -x 'NO TESTS RAN' "$log"; then continue; fi
  echo "$package: its tests failed and left no report; $package/output.log has what they printed" >>"$out/failed"
  mkdir -p "$out/$package"
  tail --bytes=1M "$log" >"$out/$package/output.log" || true # it may have none
done
if [[ -n ${ended:-} && -z $named ]]; then echo "colcon test ended with $ended" >>"$out/failed"; fi
for package in "${packages[@]}"; do
  # What the build wrote is no result. JUnit files are XML with a test suite; CTest's own file has a list of tests.
  find "build/$package" -name '*.xml' -xtype f -newer "$scratch/begun" -print0 >"$scratch/reports"
  while IFS= read -r -d '' file; do
    if grep -q -e '<testsuite' -e '<TestList>' "$file"; then
      install -D --mode=644 "$file" "$out/$package/${file#"build/$package/"}"
    fi
  done <"$scratch/reports"
done
