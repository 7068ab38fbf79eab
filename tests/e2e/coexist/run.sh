#!/usr/bin/env bash
# Builds the package as a user's workspace, installs it, and runs the installed program beside a roscore, with the
# address sanitizer.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_HOME=$work/ros TF_CPP_MIN_LOG_LEVEL=2
trap 'jobs -p | xargs --no-run-if-empty kill 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT

mkdir -p "$work/ws/src"
cp -r "$here" "$work/ws/src/coexist"
python3 "$here/models.py" "$work" & models=$!
(cd "$work/ws" && catkin_make install --use-ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0) >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
wait "$models"

roscore -p "$port" >"$work/roscore.log" 2>&1 &
for _ in $(seq 100); do if rostopic list >/dev/null 2>&1; then break; fi; sleep 0.1; done
# shellcheck disable=SC1091  # made by catkin
source "$work/ws/install/setup.bash"
status=0
# Leaks are not looked for: the frameworks keep what they have until the process ends.
timeout 300 env -u LD_LIBRARY_PATH ASAN_OPTIONS=detect_leaks=0 "$work/ws/install/lib/coexist/coexist" "$work/mean.pt" "$work/mean" 2>&1 |
  tee "$work/said" || status=$?
if grep -E 'double free|corruption|terminate called|AddressSanitizer' "$work/said"; then exit 1; fi
exit "$status"
