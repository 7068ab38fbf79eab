#!/usr/bin/env bash
# `rosbag record` behind a pipe is stopped as an engine stops a container: the bag is closed.
set -euo pipefail
untold=$(/run/tests/checks/stop.py --untold)
if [[ -n $untold ]]; then echo "$untold" && exit; fi
# shellcheck source=tests/structure/programs/roscore.sh
source "$(dirname "$0")/roscore.sh"
until_it_answers rostopic list
/tini -s -- /entrypoint.sh bash -c "rosbag record -a -O $work/bag | cat" >"$work/recorder.log" 2>&1 &
recorder=$!
until_it_answers test -e "$work/bag.bag.active"
sleep 1 # until it has connected
kill -TERM "$recorder"
wait "$recorder" || true
echo "kept: $(ls "$work"/*.bag)"
rosbag info "$work/bag.bag" >/dev/null
