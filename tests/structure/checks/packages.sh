#!/usr/bin/env bash
# Every package that the matrix promises for a component is installed.
#   packages.sh COMPONENT
set -euo pipefail
promised=EXPECT_PACKAGES_${1^^}
promised=${promised//-/_}
IFS=, read -ra packages <<<"${!promised:?}"
for package in "${packages[@]}"; do
  state=$(dpkg-query --show --showformat '${db:Status-Status}' "$package" 2>&1) || true
  [[ $state == installed ]] || { echo "$package: $state" >&2; exit 1; }
done
