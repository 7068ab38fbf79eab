#!/usr/bin/env bash
# run.sh PROGRAM: runs a Python program beside this script. The program says what it waited for in vain; this ends it where even
# that does not come.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/alone2.sh
source "$here/../alone2.sh"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME=$home PYTHONDONTWRITEBYTECODE=1
code=0
timeout --kill-after=10 240 python3 "$here/$1" || code=$?
if ((code == 124 || code == 137)); then echo "$1 had not ended after 240 s" >&2; fi
exit "$code"
