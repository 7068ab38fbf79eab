#!/usr/bin/env bash
# Runs the programs of each component that the tag promises ($EXPECT_PACKAGES_…), with one roscore for all of them.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=tests/structure/programs/roscore.sh
source "$here/../roscore.sh"
until_it_answers rostopic list

ran=()
for component in core base robot perception desktop desktop_full; do
  promise=EXPECT_PACKAGES_${component^^}
  if [[ -v $promise ]]; then
    # shellcheck disable=SC1090  # one of the files beside this one
    source "$here/$component.sh"
    ran+=("$component")
  fi
done
echo "components: ${ran[*]}"
