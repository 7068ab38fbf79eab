#!/usr/bin/env bash
# ONNX Runtime for C and C++, which needs no Python: libraries in a default library path, headers, a CMake package, a pkg-config
# file. The headers are older than the library, which keeps their interface (install-assembler.sh).
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
# The library looks for its providers in the folder where the process found itself: they are beside it there, too.
for library in "$OUT${SITE:?}"/onnxruntime/capi/*.so*; do ln -s "${library#"$OUT"}" "$libraries/"; done
library=$(basename "$libraries"/libonnxruntime.so.*)
version=${library#*.so.}
ln -s "$library" "$libraries/libonnxruntime.so.1" # its SONAME
ln -s libonnxruntime.so.1 "$libraries/libonnxruntime.so"

# The provider for CUDA is compiled once more for each Python's wheel, in another order, although it is not for any Python. This one
# serves them all, so it is on no record that others are compared with.
sed -i '/^onnxruntime\/capi\/libonnxruntime_providers_cuda\.so,/d' "$OUT$SITE"/*.dist-info/RECORD

headers=/opt/onnxruntime-headers # install-assembler.sh has put them there
(cd $headers/include && sha256sum --check --strict --quiet "$(realpath "$here")/headers.sha256") || {
  echo "onnxruntime-cc: Debian has other headers than headers.sha256 says; look at what changed, and pin them" >&2 && exit 1
}
include=$OUT/usr/local/include
mkdir -p "$include/onnxruntime/core/session" "$OUT/usr/local/share/doc/onnxruntime"
cp -r $headers/include/. "$include/onnxruntime/"
cp $headers/copyright "$OUT/usr/local/share/doc/onnxruntime/copyright"
# Where people's programs look for them besides: as in ONNX Runtime's archives, and as in its sources.
for header in "$include"/onnxruntime/*.h; do
  name=$(basename "$header")
  ln -s "onnxruntime/$name" "$include/$name"
  ln -s "../../$name" "$include/onnxruntime/core/session/$name"
done
# A library that is older than the headers has the first of their functions: a program asks it for those.
api=${version#*.} api=${api%%.*}
newest=$(sed -n 's/^#define ORT_API_VERSION \([0-9]*\)$/\1/p' "$include/onnxruntime/onnxruntime_c_api.h")
if ((api < newest)); then
  sed -i "s/^#define ORT_API_VERSION $newest$/#define ORT_API_VERSION $api/" "$include/onnxruntime/onnxruntime_c_api.h"
fi

# Where a program may have lost the image's variables, as in a login by ssh (components/onnxruntime/files.sh).
if grep -q ORT_DISABLE_TELEMETRY "$libraries/$library"; then
  mkdir -p "$OUT/etc/profile.d"
  echo "export ORT_DISABLE_TELEMETRY=\${ORT_DISABLE_TELEMETRY-1}" >"$OUT/etc/profile.d/rosml-onnxruntime.sh"
fi

cmake=$OUT/usr/local/lib/cmake/onnxruntime pkgconfig=$OUT/usr/local/lib/pkgconfig
mkdir -p "$cmake" "$pkgconfig"
fill() { sed -e "s|@TRIPLET@|$TRIPLET|g" -e "s|@VERSION@|$version|g" "$here/$1.in" >"$2/$(basename "$1")"; }
fill cmake/onnxruntime-config.cmake "$cmake"
fill cmake/onnxruntime-config-version.cmake "$cmake"
fill pkgconfig/libonnxruntime.pc "$pkgconfig"
