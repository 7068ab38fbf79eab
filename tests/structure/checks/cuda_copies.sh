#!/usr/bin/env bash
# Exactly one copy of every CUDA library in the image.
set -euo pipefail
libraries=$(find / -xdev -type f \( -name 'libcu*.so*' -o -name 'libnv*.so*' -o -name 'libnccl*.so*' \) -printf '%f\n' |
  grep -v -E '^lib(curl|cups)' | sort)
[[ -n $libraries ]] || { echo "no CUDA library at all" >&2; exit 1; }
doubles=$(uniq -d <<<"$libraries")
[[ -z $doubles ]] || { echo "more than one copy of: $doubles" >&2; exit 1; }
