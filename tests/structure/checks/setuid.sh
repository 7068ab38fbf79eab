#!/usr/bin/env bash
# Every program that runs with another user's or group's rights is one that we know of, by its path.
set -euo pipefail
known=$(dirname "$(readlink -f "$0")")/setuid.txt
# A merged /usr has them once; where it is not merged, /bin is another folder.
found=$(find "${CHECK_ROOT:-}/" -xdev -type f -perm /6000 -printf '%m /%P\n' | sed -E 's# /(s?bin)/# /usr/\1/#' | sort --unique)
surprises=$(while read -r mode path; do
  grep -q -x -E "$mode ${path//./\\.}( +#.*)?" "$known" || echo "$mode $path"
done <<<"$found")
[[ -z $surprises ]] || { printf 'not in setuid.txt:\n%s\n' "$surprises" >&2; exit 1; }
