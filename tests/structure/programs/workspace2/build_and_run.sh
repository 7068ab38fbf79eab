#!/usr/bin/env bash
# A workspace of a message, a Python node that uses it and the image's frameworks, and a C++ node, built as users do:
# with colcon build --symlink-install. Its nodes run, under the entrypoint.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work WORKSPACE=$work TF_CPP_MIN_LOG_LEVEL=3 PYTHONDONTWRITEBYTECODE=1

cp -r "$here/src" "$work"
(cd "$work" && colcon build --symlink-install --cmake-args -G Ninja -DBUILD_TESTING=OFF) >"$work/log.txt" 2>&1 ||
  { cat "$work/log.txt" >&2; exit 1; }

frameworks=()
for name in torch tensorflow; do
  promise=EXPECT_${name^^}
  if [[ -v $promise ]]; then frameworks+=("$name"); fi
done
/entrypoint.sh ros2 run example_py score "${frameworks[@]}"
/entrypoint.sh ros2 run example_cpp score
