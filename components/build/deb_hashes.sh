#!/usr/bin/env bash
# Notes the hashes of the archives that packages were installed from, for SBOMs: only apt's lists have them, and those go with the step.
# Each line of FILE has a package's name, architecture and version, and SHA-512, or SHA-256 if the lists have no other. A package that no
# list names any more keeps its line; one that is from elsewhere has none.
#   deb_hashes.sh FILE
set -euo pipefail
shopt -s nullglob
export LC_ALL=C

lists=(/var/lib/apt/lists/*_Packages*)
program=/usr/lib/apt/apt-helper # reads lists however they are packed
if [[ ${#lists[@]} == 0 || ! -x $program ]]; then exit 0; fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
dpkg-query --show --showformat '${db:Status-Status} ${Package} ${Architecture} ${Version}\n' |
  sed -n 's/^installed //p' >"$scratch/installed"
if [[ -e $1 ]]; then cp "$1" "$scratch/before"; else touch "$scratch/before"; fi
$program cat-file "${lists[@]}" | awk '
  FILENAME == "-" && /^(Package|Architecture|Version|SHA256|SHA512): / { value[$1] = $2 }
  FILENAME == "-" && NF == 0 {
    print value["Package:"], value["Architecture:"], value["Version:"], value["SHA512:"] ? value["SHA512:"] : value["SHA256:"]
    split("", value)
  }
  FILENAME != "-"
' "$scratch/before" - | awk '
  FNR == NR { installed[$0]; next }
  NF == 4 && ($1 " " $2 " " $3) in installed
' "$scratch/installed" - | sort -u -k 1,3 >"$scratch/hashes"
mkdir -p "$(dirname "$1")"
cp "$scratch/hashes" "$1"
