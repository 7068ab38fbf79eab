#!/usr/bin/env bash
# libtorch for C++: libraries in a default library path, a CMake package that needs no CUDA toolkit, a pkg-config file.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
for library in "$OUT${SITE:?}"/torch/lib/*.so*; do
  # OpenMP's runtime is the distribution's there: a part replaces nothing. PyTorch in Python takes its own.
  case ${library##*/} in libgomp.so*) continue ;; esac
  # Wheels for arm64 bring Fortran's runtime. An image with numpy has the distribution's, which the loader finds first: this is for
  # images without it, in the folder that is searched last.
  case ${library##*/} in libgfortran.so*) ln -s "${library#"$OUT"}" "$OUT/usr/lib/" && continue ;; esac
  ln -s "${library#"$OUT"}" "$libraries/$(basename "$library")"
done

# Triton brings further copies of CUPTI and its companions: the CUDA part's serve it as well.
if [[ ${ACCELERATOR:?} == cuda ]]; then
  for library in "$OUT$SITE"/triton/backends/nvidia/lib/cupti*/*.so*; do
    [[ -e $library ]] || continue
    name=$(basename "$library")
    # by the name that has no version: it leads to the stack's own, whatever release Triton was built with
    case $name in libcupti.so*) name=libcupti.so ;; esac
    ln -sf "/usr/lib/$TRIPLET/$name" "$library"
  done
fi

# torchvision brings a second copy of the CUDA runtime, under a name of its own. As a link it is the same file, which the
# loader loads once. By the name that has no version: it leads to the stack's own.
for library in "$OUT$SITE"/torchvision.libs/libcudart*.so*; do
  [[ -e $library ]] || continue
  ln -sf "/usr/lib/$TRIPLET/libcudart.so" "$library"
done

# The string ABI as the wheel's own package says: 0 in old wheels for amd64.
own=$OUT$SITE/torch/share/cmake/Torch
abi=$(sed -n 's/.*_GLIBCXX_USE_CXX11_ABI=\([01]\).*/\1/p' "$own/TorchConfig.cmake" | head -n 1)
# What else the wheel's own package tells the compiler: which of its distributed backends the headers declare.
targets=$own/../Caffe2/Caffe2Targets.cmake
definitions=$(sed -n 's/^ *INTERFACE_COMPILE_DEFINITIONS "\(USE_[A-Z0-9_;]*\)"$/\1/p' "$targets" | tr ';' '\n' | sort --unique | paste -sd ';')
# The C++ that the headers want. Compilers take C++17 by themselves; a newer one has to be asked for.
standard=$(sed -n 's/.*__cplusplus < 20\([0-9][0-9]\)[0-9][0-9]L.*/\1/p' "$OUT$SITE/torch/include/torch/csrc/api/include/torch/all.h" | head -n 1)
standard=${standard:-17} standard_flag=''
if ((standard > 17)); then standard_flag="-std=c++$standard "; fi
cuda_home=/usr/local/lib/rosml/cuda-home # of the part that has CUDA's libraries
cuda_flags='' cuda_libraries=''
if [[ $ACCELERATOR == cuda ]]; then
  cuda_flags=" -isystem $cuda_home/include"
  cuda_libraries=' -Wl,--push-state,--as-needed -ltorch_cuda -lc10_cuda -lcudart -Wl,--pop-state'
fi
version=$(sed -n "s/^__version__ = '\([0-9.]*\).*'/\1/p" "$OUT$SITE/torch/version.py")
wheel=$(basename "$(echo "$OUT$SITE"/torch-*.dist-info)")
cmake=$OUT/usr/local/lib/cmake/Torch
mkdir -p "$cmake" "$OUT/usr/local/lib/pkgconfig"
fill() {
  sed -e "s|@SITE@|$SITE|g" -e "s|@WHEEL@|$wheel|g" -e "s|@TORCH_VERSION@|$version|g" -e "s|@TRIPLET@|$TRIPLET|g" \
    -e "s|@CXX11_ABI@|${abi:-1}|g" -e "s|@DEFINITIONS@|$definitions|g" -e "s|@FLAGS@|${definitions:+-D${definitions//;/ -D}}|g" \
    -e "s|@STANDARD@|$standard|g" -e "s|@STANDARD_FLAG@|$standard_flag|g" \
    -e "s|@CUDA_HOME@|$cuda_home|g" -e "s|@CUDA_FLAGS@|$cuda_flags|g" -e "s|@CUDA_LIBRARIES@|$cuda_libraries|g" "$here/$1.in"
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
