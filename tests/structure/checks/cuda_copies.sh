#!/usr/bin/env bash
# Exactly one copy of every CUDA library in the image: not in two places, not in two versions (libcudart.so.12 and .so.13),
# and none that a wheel brought under a name of its own (libcudart-9335f6a2.so.12, libcudart.3eda8113.so.13).
set -euo pipefail
names=('libcu*.so*' 'libnv*.so*' 'libnccl*.so*' 'libcheckpoint.so*' 'libpcsamplingutil.so*') # the last two are CUPTI's
wanted=()
for name in "${names[@]}"; do wanted+=(-o -name "$name"); done
libraries=$(find "${CHECK_ROOT:-}/" -xdev -type f \( "${wanted[@]:1}" \) ! -name 'libcurl*' ! -name 'libcups*' -printf '%f %p\n')
[[ -n $libraries ]] || { echo "no CUDA library at all" >&2; exit 1; }
stems=$(cut -d ' ' -f 1 <<<"$libraries" | sed -E 's/\.so.*//; s/[-.][0-9a-f]{8,}$//' | sort | uniq --repeated)
[[ -z $stems ]] || {
  for stem in $stems; do
    echo "more than one copy of $stem:" "$(sed -n -E "s/^$stem([-.][0-9a-f]{8,})?\.so[^ ]* //p" <<<"$libraries" | sort | xargs)" >&2
  done
  exit 1
}
