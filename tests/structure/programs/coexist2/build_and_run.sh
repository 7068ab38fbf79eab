#!/usr/bin/env bash
# A package of rclcpp with libtorch, tensorflow_cc or both, whichever the image promises, built with colcon and with the address
# sanitizer: its node computes with each in a callback, and ends cleanly.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/alone2.sh
source "$here/../alone2.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work WORKSPACE=$work TF_CPP_MIN_LOG_LEVEL=3

frameworks=()
for name in torch tensorflow; do
  promise=EXPECT_${name^^}
  if [[ -v $promise ]]; then frameworks+=("-DWITH_${name^^}=ON"); fi
done
if ((${#frameworks[@]} == 0)); then echo "no framework"; exit; fi

mkdir "$work/src"
cp -r "$here/src" "$work/src/coexist2"
(cd "$work" && colcon build --cmake-args -G Ninja "${frameworks[@]}") >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }

# Leaks are not looked for: the frameworks keep what they have until the process ends. Nor is the size that memory is freed with:
# rclcpp's own allocator for rcl (rclcpp/allocator/allocator_common.hpp) says one byte, whatever it took.
code=0
ASAN_OPTIONS=detect_leaks=0:new_delete_type_mismatch=0 timeout --kill-after=10 240 /entrypoint.sh ros2 run coexist2 coexist2 >"$work/said" 2>&1 || code=$?
if ((code)) || ! grep -x 'means: right' "$work/said" || grep -E 'double free|corruption|terminate called|AddressSanitizer' "$work/said" >&2; then
  echo "the program ended with $code (124: not within 240 s), and said:" >&2
  cat "$work/said" >&2
  exit 1
fi
