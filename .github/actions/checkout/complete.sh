#!/usr/bin/env bash
# Completes a set in the current folder, a git checkout, to a whole rosml: complete.sh ROSML
# The set's own files are those below; all others are ROSML's. In rosml itself, and in a fork of it, nothing is to be done.
set -euo pipefail
own=(set.yaml scan.yaml components environments locks tests/structure)

[[ -e scripts/bootstrap.py ]] && exit
if [[ ! -e set.yaml ]]; then
  printf '%s\n' '::error::this repository has no set.yaml; write one: rosml init --images' >&2
  exit 1
fi
kept=$(mktemp -d)
trap 'rm -rf "$kept"' EXIT
for name in "${own[@]}"; do
  if [[ -e $name ]]; then
    mkdir -p "$kept/$(dirname "$name")"
    cp -R "$name" "$kept/$name"
  fi
done
find . -mindepth 1 -maxdepth 1 ! -name .git -exec rm -rf {} +
find "$1" -mindepth 1 -maxdepth 1 ! -name .git ! -name .state ! -name .venv -exec cp -R {} . \;
cp -R "$kept/." .
echo '*' >>.git/info/exclude # the revision of the checkout is the set's: rosml's files are no changes of it
