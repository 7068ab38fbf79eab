#!/usr/bin/env bash
# Leaves in a folder what packages are built from: files about the repository go, if no package has them in its folder, and
# none of what describes a build names them. So a change of a README builds nothing again.
#   packages.sh FOLDER
set -euo pipefail
cd "$1"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
find . \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.cmake.in' -o -name setup.py -o -name setup.cfg -o -name '*.toml' \
  -o -name '*.in' -o -name package.xml \) -type f -exec cat {} + >"$scratch/builds"
find . -mindepth 2 \( -iname 'README*' -o -iname 'CHANGELOG*' -o -iname 'CONTRIBUTING*' -o -iname 'CODE_OF_CONDUCT*' -o -name '.*' \) \
  -print0 >"$scratch/about"

# in_package PATH: one of the folders above it is a package of any kind that colcon knows.
in_package() {
  local folder=$1 file
  while [[ $folder == */*/* ]]; do
    folder=${folder%/*}
    for file in package.xml CMakeLists.txt setup.py pyproject.toml colcon.pkg; do
      if [[ -e $folder/$file ]]; then return; fi
    done
  done
  return 1
}

while IFS= read -r -d '' path; do
  if ! in_package "$path" && ! grep -q -F -e "${path##*/}" "$scratch/builds"; then rm -rf "$path"; fi
done <"$scratch/about"
