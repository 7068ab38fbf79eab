#!/usr/bin/env bash
# Asks for other releases of what a part holds: pip and uv refuse them, and install them with the word.
#   unpinned.sh PACKAGE VERSION_FOR_PIP VERSION_FOR_UV
set -euo pipefail
pip install --quiet --no-cache-dir --target /tmp/everyday uv
pip=(pip install --no-cache-dir --progress-bar off)
uv=(/tmp/everyday/bin/uv pip install --no-cache)
version() { python3 -c 'import importlib.metadata, sys; print(importlib.metadata.version(sys.argv[1]))' "$1"; }

before=$(version "$1")
for command in "${pip[*]}" "${uv[*]}"; do
  if said=$($command "$1==$2" 2>&1); then echo "$command $1==$2 was not refused" >&2 && exit 1; fi
  echo "$said"
  grep -q -E 'conflict|unsatisfiable' <<<"$said"
  [[ $(version "$1") == "$before" ]]
done
unpinned "${pip[@]}" "$1==$2"
[[ $(version "$1") == "$2" ]]
unpinned "${uv[@]}" "$1==$3"
[[ $(version "$1") == "$3" ]]
rm -r /tmp/everyday
echo "unpinned: $1 $3, before $before"
