#!/usr/bin/env bash
# colcon does all that `rosml containerize` calls it for. Each of it comes with an extension of its own: colcon alone has no list.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
colcon --log-base /dev/null list --names-only --base-paths .
for verb in build test; do
  said=$(colcon --log-base /dev/null "$verb" --help)
  words=(--base-paths --metas --packages-select console_cohesion)
  if [[ $verb == build ]]; then words+=(--cmake-args --cmake-target --catkin-skip-building-tests); fi
  for word in "${words[@]}"; do
    [[ $said == *"$word"* ]] || { echo "colcon $verb has no $word" >&2; exit 1; }
  done
done
python3 -c 'import colcon_bash' # a build leaves setup.bash
