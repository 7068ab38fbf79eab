#!/usr/bin/env bash
# A workspace of a Python node, built as users do, with colcon build --symlink-install; it runs under the entrypoint.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work WORKSPACE=$work PYTHONDONTWRITEBYTECODE=1

cp -r "$here/src" "$work"
(cd "$work" && colcon build --symlink-install) >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }

# A setup file of the workspace that looked in vain for one of ROS's would say so.
/entrypoint.sh "$work/install/chatter/lib/chatter/talk" 2>"$work/said" || { cat "$work/said" >&2; exit 1; }
if [[ -s $work/said ]]; then cat "$work/said" >&2; exit 1; fi
