#!/usr/bin/env bash
# rosdep is initialised; and it works without a network, from an index in a folder.
set -euo pipefail
grep -q '^yaml https://' "${CHECK_ROOT:-}/etc/ros/rosdep/sources.list.d/20-default.list" || { echo "rosdep is not initialised" >&2; exit 1; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/sources"
echo "yaml file://$work/base.yaml" >"$work/sources/20-default.list"
printf '%s\n' 'a-key-of-ours:' '  debian: [libours-dev]' '  ubuntu: [libours-dev]' >"$work/base.yaml"
printf '%s\n' '%YAML 1.1' --- 'distributions: {}' 'type: index' 'version: 4' >"$work/index.yaml"
export ROS_HOME=$work HOME=$work ROSDEP_SOURCE_PATH=$work/sources ROSDISTRO_INDEX_URL=file://$work/index.yaml
rosdep update >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
rosdep resolve a-key-of-ours
