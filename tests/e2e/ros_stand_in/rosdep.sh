#!/usr/bin/env bash
# Stands in for rosdep: knows the keys of the index in a folder that $ROSDEP_SOURCE_PATH names.
set -euo pipefail
index=$(sed -n 's#^yaml file://##p' "${ROSDEP_SOURCE_PATH:?}/20-default.list")
case $1 in
  update) test -s "$index" ;;
  resolve) grep --quiet "^$2:" "$index" && sed -n 's/^  debian: \[\(.*\)\]/#apt\n\1/p' "$index" ;;
  *) exit 2 ;;
esac
