#!/usr/bin/env bash
# A toolkit at /usr/local/cuda, as NVIDIA's own packages make one: nvcc and what it calls, beside the headers and libraries that
# the CUDA part has in one folder. nvcc looks beside itself for all of them; PyTorch and CMake ask where it is.
set -euo pipefail

home=/usr/local/lib/rosml/cuda-home
packages=${SITE:?}/nvidia
tree=$(cd "${OUT:?}$packages" && echo cu*)
mkdir -p "$OUT$home/include" "$OUT$home/lib64"

# What the CUDA part lacks goes where it has its own. By relative links, packages find their files there in this build as well.
for pair in include:include lib:lib64; do
  from=$OUT$packages/$tree/${pair%%:*} to=$home/${pair##*:}
  mv "$from"/* "$OUT$to/"
  rmdir "$from"
  ln -s "$(realpath --relative-to="$OUT$packages/$tree" "$OUT$to")" "$from"
done
ln -s lib "$OUT$packages/$tree/lib64"
ln -s "$packages/$tree" "$OUT/usr/local/cuda"

# The image's PATH ends with the folder of nvcc; a login shell sets PATH by itself.
mkdir -p "$OUT/etc/profile.d"
echo "PATH=\$PATH:/usr/local/cuda/bin" >"$OUT/etc/profile.d/rosml-devel.sh"
