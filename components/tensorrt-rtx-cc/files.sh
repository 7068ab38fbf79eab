#!/usr/bin/env bash
# TensorRT for RTX in a default library path: programs find it without LD_LIBRARY_PATH.
set -euo pipefail

for library in "${OUT:?}${SITE:?}"/tensorrt_rtx_libs/*.so.*; do
  name=${library##*/}
  ln -s "${library#"$OUT"}" "$OUT/usr/lib/${TRIPLET:?}/$name"
  ln -s "$name" "$OUT/usr/lib/$TRIPLET/${name%%.so.*}.so"
done
