#!/usr/bin/env bash
# ROS's apt source is there, once, and is the official one: further packages come from where these came from.
set -euo pipefail
source=$(sed -n 's/^ros-source //p' /usr/local/share/rosml/versions.d/ros)
named=$(find /etc/apt/sources.list.d/ -name '*ros*')
naming=$(grep --files-with-matches -R -F "${source#*//}" /etc/apt/sources.list*)
found=$(printf '%s\n' "$named" "$naming" | sort -u)
mapfile -t files <<<"$found"
[[ ${#files[@]} == 1 && ${files[0]} == /etc/apt/sources.list.d/*ros2* ]] ||
  { echo "apt sources of ROS 2: ${files[*]:-none}" >&2; exit 1; }
grep -q -x -F "URIs: $source" "${files[0]}" || { echo "${files[0]} does not name $source" >&2; exit 1; }
[[ $ROS_SYNC_DATE =~ ^(20[0-9-]{8}T[0-9:]{8}Z)?$ ]] || { echo "ROS_SYNC_DATE=$ROS_SYNC_DATE" >&2; exit 1; }
