#!/usr/bin/env bash
# A workspace of a message and an action, Python nodes that use them and the image's frameworks, a C++ node and a component, built
# as users do: with colcon build --symlink-install. Its nodes run, under the entrypoint, alone and by a launch file.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/alone2.sh
source "$here/../alone2.sh"
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

# Whatever a node ends with, `ros2 launch` says that it ended well: what nodes say is looked at.
code=0
timeout --signal=INT --kill-after=20 240 /entrypoint.sh ros2 launch example_cpp count.launch.py >"$work/said" 2>&1 || code=$?
if ((code)) || ! grep -F 'counted: 2 4 6' "$work/said" || grep -E 'process has died|\[ERROR\]' "$work/said" >&2; then
  echo "the launch file ended with $code (124: not within 240 s), and said:" >&2
  cat "$work/said" >&2
  exit 1
fi
