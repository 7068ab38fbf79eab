#!/usr/bin/env bash
# libtorch for C++: libraries in a default library path, a CMake package that needs no CUDA toolkit, a pkg-config file.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
for library in "$OUT${SITE:?}"/torch/lib/*.so*; do
  # OpenMP's runtime is the distribution's there: a part replaces nothing. PyTorch in Python takes its own.
  case ${library##*/} in libgomp.so*) continue ;; esac
  ln -s "${library#"$OUT"}" "$libraries/$(basename "$library")"
done

# Triton brings a second copy of CUPTI and its companions: the CUDA part's serve it as well.
bundled=$OUT$SITE/triton/backends/nvidia/lib/cupti
if [[ ${ACCELERATOR:?} == cuda && -d $bundled ]]; then
  for library in "$bundled"/*.so*; do
    name=$(basename "$library")
    # by the name that has no version: it leads to the stack's own, whatever release Triton was built with
    case $name in libcupti.so*) name=libcupti.so ;; esac
    ln -sf "/usr/lib/$TRIPLET/$name" "$library"
  done
fi

# The string ABI as the wheel's own package says: 0 in old wheels for amd64.
own=$OUT$SITE/torch/share/cmake/Torch
abi=$(sed -n 's/.*_GLIBCXX_USE_CXX11_ABI=\([01]\).*/\1/p' "$own/TorchConfig.cmake" | head -n 1)
version=$(sed -n "s/^__version__ = '\([0-9.]*\).*'/\1/p" "$OUT$SITE/torch/version.py")
wheel=$(basename "$(echo "$OUT$SITE"/torch-*.dist-info)")
cmake=$OUT/usr/local/lib/cmake/Torch
mkdir -p "$cmake" "$OUT/usr/local/lib/pkgconfig"
fill() {
  sed -e "s|@SITE@|$SITE|g" -e "s|@WHEEL@|$wheel|g" -e "s|@TORCH_VERSION@|$version|g" -e "s|@TRIPLET@|$TRIPLET|g" \
    -e "s|@CXX11_ABI@|${abi:-1}|g" "$here/$1.in"
}
fill pkgconfig/torch.pc >"$OUT/usr/local/lib/pkgconfig/torch.pc"
# -DCMAKE_PREFIX_PATH=$(python3 -c 'import torch; print(torch.utils.cmake_prefix_path)'), as PyTorch's documentation has
# it, leads to the wheel's own package: it leads on to this one. Relative, for root folders that are not /.
ours=$(realpath --relative-to="$own" "$cmake")
for name in TorchConfig.cmake TorchConfigVersion.cmake; do
  fill "cmake/$name" >"$cmake/$name"
  rm -f "$own/$name" # a link to uv's copy, perhaps
  echo "include(\"\${CMAKE_CURRENT_LIST_DIR}/$ours/$name\")" >"$own/$name"
done
