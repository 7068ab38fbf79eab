#!/usr/bin/env bash
# All GPU probes of an image: Python and C++. Needs a GPU.
#   docker run --rm --gpus all -v "$PWD/tests/gpu:/probe:ro" <image> /probe/run.sh
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")

status=0
TF_CPP_MIN_LOG_LEVEL=${TF_CPP_MIN_LOG_LEVEL:-2} python3 "$here/probe.py" || status=$?
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{ cmake -S "$here" -B "$work" -DCMAKE_BUILD_TYPE=Release && cmake --build "$work"; } >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
for framework in torch tensorflow; do
  if python3 -c 'import importlib.util as u, sys; sys.exit(u.find_spec(sys.argv[1]) is None)' "$framework"; then
    "$work/${framework}_gpu_probe" || status=1
  fi
done
exit "$status"
