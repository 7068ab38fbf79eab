#!/usr/bin/env bash
# NVIDIA's libraries, in a place that no Python version owns, linked into a default library path: the loader and the
# linker find them without ldconfig, so nothing has to run after the part is joined to an image.
# Their headers and libraries once more as links in one folder, as a toolkit has them: our packages for CMake and pkg-config
# name it. Nothing leads there from /usr/local/cuda: whoever finds that, such as PyTorch, takes it for a toolkit and builds for
# the GPU, and no compiler for GPU code is there. NVIDIA's own packages make /usr/local/cuda.
set -euo pipefail

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
home=/usr/local/lib/rosml/cuda-home
mkdir -p "$OUT$home/include" "$OUT$home/lib64"

# Links a file or folder of a package into a folder, once.
only() {
  if [[ -L $2/${1##*/} ]]; then echo "cuda: two packages bring ${1##*/}" >&2 && exit 1; fi
  ln -s "${1#"$OUT"}" "$2/${1##*/}"
}

found=$(find "$OUT${SITE:?}/nvidia" -path '*/lib/*.so*' -type f | sort)
while IFS= read -r library; do
  only "$library" "$libraries"
  name=$(basename "$library")
  # the name that `-lcudart` asks for
  plain=${name%%.so*}.so
  [[ -L $libraries/$plain ]] || ln -s "$name" "$libraries/$plain"
  for link in "$name" "$plain"; do ln -sf "/usr/lib/$TRIPLET/$link" "$OUT$home/lib64/$link"; done
done <<<"$found"

for header in "$OUT$SITE"/nvidia/*/include/*; do
  # The folders are packages of Python as well.
  case ${header##*/} in __init__.py | __pycache__) continue ;; esac
  only "$header" "$OUT$home/include"
done
# From CUDA 13 on, cub, thrust and libcu++ are in a folder of their own, which nvcc knows.
for header in "$OUT$SITE"/nvidia/cu*/include/cccl/*; do
  if [[ -e $header && ! -L $OUT$home/include/${header##*/} ]]; then only "$header" "$OUT$home/include"; fi
done

# Python has a link to this folder. Whoever replaces all of its packages must not find it empty in between: uv would remove
# it, and fail at the link.
echo 'Packages of the part cuda, which Python finds by a link' >"$OUT$SITE/nvidia/README"
