#!/usr/bin/env bash
# libtorch for C++: libraries in a default library path, and a CMake package that needs no CUDA toolkit.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
for library in "$OUT${SITE:?}"/torch/lib/*.so*; do
  ln -s "${library#"$OUT"}" "$libraries/$(basename "$library")"
done

# Triton brings a second copy of CUPTI and its companions: the CUDA payload's serve it as well.
bundled=$OUT$SITE/triton/backends/nvidia/lib/cupti
if [[ ${ACCELERATOR:?} == cuda && -d $bundled ]]; then
  rm -f "$bundled"/*.a
  for library in "$bundled"/*.so*; do
    name=$(basename "$library")
    # by the name that has no version: it leads to the stack's own, whatever release Triton was built with
    case $name in libcupti.so*) name=libcupti.so ;; esac
    ln -sf "/usr/lib/$TRIPLET/$name" "$library"
  done
fi

# The string ABI as the wheel's own package says: 0 in old wheels for amd64.
abi=$(sed -n 's/.*_GLIBCXX_USE_CXX11_ABI=\([01]\).*/\1/p' "$OUT$SITE/torch/share/cmake/Torch/TorchConfig.cmake" | head -n 1)
version=$(sed -n "s/^__version__ = '\([0-9.]*\).*'/\1/p" "$OUT$SITE/torch/version.py")
cmake=$OUT/usr/local/lib/cmake/Torch
mkdir -p "$cmake"
for template in "$here"/cmake/*.in; do
  sed -e "s|@TORCH_ROOT@|$SITE/torch|g" -e "s|@TORCH_VERSION@|$version|g" -e "s|@TRIPLET@|$TRIPLET|g" \
    -e "s|@CXX11_ABI@|${abi:-1}|g" \
    "$template" >"$cmake/$(basename "$template" .in)"
done
