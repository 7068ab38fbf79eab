#!/usr/bin/env bash
# A roscore, and the two nodes of round_trip.cpp: round_trip.sh COUNT BYTES…
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/roscore.sh
source "$here/roscore.sh"
until_it_answers rostopic list
"$here/round_trip" "$@"
