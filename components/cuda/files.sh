#!/usr/bin/env bash
# NVIDIA's libraries, in a place that no Python version owns, linked into a default library path: the loader and the
# linker find them without ldconfig, so nothing has to run after the part is joined to an image.
set -euo pipefail

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
while IFS= read -r library; do
  name=$(basename "$library")
  if [[ -L $libraries/$name ]]; then echo "cuda: two packages bring $name" >&2 && exit 1; fi
  ln -s "${library#"$OUT"}" "$libraries/$name"
  # the name that `-lcudart` asks for
  plain=${name%%.so*}.so
  [[ -L $libraries/$plain ]] || ln -s "$name" "$libraries/$plain"
done < <(find "$OUT${SITE:?}/nvidia" -path '*/lib/*.so*' -type f | sort)
