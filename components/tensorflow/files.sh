#!/usr/bin/env bash
# TensorFlow for C++: libraries in a default library path, so that `-ltensorflow_cc -ltensorflow_framework` links and
# programs run without LD_LIBRARY_PATH, CMake packages, and pkg-config files. The headers stay inside the Python package:
# in a default include path they would shadow the system's protobuf, abseil and Eigen. Links lead to them from where people
# look for them: to all of them from /usr/local/include/tensorflow, and to those of the C API from the default path.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")

tensorflow=${OUT:?}${SITE:?}/tensorflow
libraries=$OUT/usr/lib/${TRIPLET:?}
for name in tensorflow_cc tensorflow_framework; do
  versioned=$(basename "$tensorflow/lib$name".so.*)
  ln -s "$SITE/tensorflow/$versioned" "$libraries/$versioned"
  ln -s "$versioned" "$libraries/lib$name.so"
done
soversion=${versioned##*.so.}
# What wheels for arm64 bring beside it (OpenMP's runtime, under a name of its own): it is looked for next to the folder of
# the link that a program finds, which is not next to the package.
for library in "$OUT$SITE"/tensorflow*.libs/*.so*; do
  if [[ -e $library ]]; then ln -s "${library#"$OUT"}" "$libraries/"; fi
done

# What Python's extensions need. A program that takes one of these by a link of its own (tensorflow_ros_cpp) would look for it
# beside that link.
for library in "$tensorflow"/python/lib_pywrap_*.so; do
  if [[ -e $library ]]; then ln -s "${library#"$OUT"}" "$libraries/"; fi
done

# <name>-<version>.dist-info: tensorflow, tensorflow_cpu or tensorflow_cpu_aws, whichever has the library.
wheel=$(basename "$(dirname "$(grep -l '^tensorflow/libtensorflow_cc\.so' "$OUT$SITE"/*.dist-info/RECORD)")")
version=${wheel%.dist-info}
version=${version##*-}

# Whether libtensorflow_cc exports a symbol whose name begins so; nm of the target's architecture reads it. grep counts,
# so that it reads to the end: nm would fail where nobody listens.
exports() { "$TRIPLET-nm" --dynamic --defined-only "$tensorflow/libtensorflow_cc.so.$soversion" | grep -c " $1" >/dev/null; }

# What tf.sysconfig.get_compile_flags() says, without running it: the target may be another architecture. TensorFlow
# compiles Eigen with this alignment on all architectures:
# https://github.com/tensorflow/tensorflow/blob/v2.13.1/third_party/eigen3/eigen_archive.BUILD
abi=0
if exports _ZNK10tensorflow5Scope10WithDeviceERKNSt7__cxx11; then abi=1; fi
flags=(-D_GLIBCXX_USE_CXX11_ABI="$abi" -DEIGEN_MAX_ALIGN_BYTES=64)

# Wheels from about 2.20 on have the header of ClientSession, the documented way to run a graph, but not the class.
# It is linked by whoever names libtensorflow_cc and uses it, by way of a linker script, as libc.so is one.
needed=("libtensorflow_framework.so.$soversion")
if ! exports _ZN10tensorflow13ClientSessionC1E; then
  needed+=("libtensorflow_client_session.so.$soversion")
  "$here/client_session/build.sh" "$libraries/${needed[1]}" "${flags[@]}"
fi

# A linker script in the place of a library: it names libraries that are taken whole, and those of which a program takes
# what it uses. ldconfig complains about a file that is no library, unless these words are in it.
#   script FILE LIBRARY... -- LIBRARY...
script() {
  local file=$1 word text='' folder=/usr/lib/$TRIPLET
  for word in "${@:2}"; do
    if [[ $word == -- ]]; then text+='AS_NEEDED( '; else text+="$folder/$word "; fi
  done
  rm -f "$file"
  printf '/* GNU ld script */\nINPUT(%s))\n' "$text" >"$file"
}
cc=libtensorflow_cc.so.$soversion
script "$libraries/libtensorflow_cc.so" "$cc" -- "${needed[@]}"
# TensorFlow's archives for C have the C API as a library of its own; it is the same code.
ln -s libtensorflow_cc.so "$libraries/libtensorflow.so"
ln -s "$cc" "$libraries/libtensorflow.so.$soversion"
# Programs that use TensorFlow's own protobuf were told to link `-lprotobuf`. Here the linker looks last: it finds the
# distribution's, where that is installed, and CMake never sees this one.
mkdir -p "$OUT/usr/$TRIPLET/lib"
script "$OUT/usr/$TRIPLET/lib/libprotobuf.so" -- "${needed[0]}"

# All headers, for -I /usr/local/include/tensorflow; hand-written modules of CMake look for them below `google` as well.
include=$OUT/usr/local/include
mkdir -p "$include/tensorflow" "$include/google"
for entry in "$tensorflow"/include/*; do ln -s "${entry#"$OUT"}" "$include/tensorflow/"; done
ln -s ../tensorflow "$include/google/tensorflow"
# Those that C can read, and what they include, in the default path: they bring nothing that others have.
headers=$(cd "$tensorflow/include" && find tensorflow/c -name '*.h' ! -name '*internal*' | sort)
while IFS= read -r header; do
  found=$(cd "$tensorflow/include" && "$TRIPLET-g++" -x c -std=c11 -w -M -I . "$header" 2>/dev/null) || continue
  paths=$(grep -oE '(^| )(tensorflow|tsl|xla)/[^ ]+' <<<"$found" | tr -d ' ') # itself at least
  while IFS= read -r path; do
    mkdir -p "$include/$(dirname "$path")"
    ln -sf "$SITE/tensorflow/include/$path" "$include/$path"
  done <<<"$paths"
done <<<"$headers"
[[ -e $include/tensorflow/c/c_api.h || -L $include/tensorflow/c/c_api.h ]] || {
  echo "tensorflow: C cannot read tensorflow/c/c_api.h" >&2 && exit 1
}

fill() {
  sed -e "s|@SITE@|$SITE|g" -e "s|@TRIPLET@|$TRIPLET|g" -e "s|@VERSION@|$version|g" -e "s|@WHEEL@|$wheel|g" \
    -e "s|@SOVERSION@|$soversion|g" -e "s|@FLAGS@|${flags[*]}|g" "$here/$1.in" >"$2/$(basename "$1")"
}
cmake=$OUT/usr/local/lib/cmake
mkdir -p "$cmake/TensorFlow" "$cmake/TensorFlowCC" "$OUT/usr/local/lib/pkgconfig"
fill cmake/TensorFlowConfig.cmake "$cmake/TensorFlow"
fill cmake/TensorFlowConfigVersion.cmake "$cmake/TensorFlow"
# The same under the names that other builds of TensorFlow go by: CMake takes these file names for any spelling.
for name in tensorflow tensorflowcc; do
  folder=$cmake/TensorFlow
  if [[ $name == tensorflowcc ]]; then folder=$cmake/TensorFlowCC; fi
  cp "$here/cmake/other-name-config.cmake" "$folder/$name-config.cmake"
  cp "$here/cmake/other-name-config-version.cmake" "$folder/$name-config-version.cmake"
done
fill pkgconfig/tensorflow_cc.pc "$OUT/usr/local/lib/pkgconfig"
fill pkgconfig/tensorflow.pc "$OUT/usr/local/lib/pkgconfig"

# The library and its headers are the same for all Pythons: a part of their own has them.
"$here/../part/records.py" link /usr/local/lib/rosml/tensorflow-cc \
  "tensorflow/libtensorflow_cc.so.$soversion" tensorflow/include

# What depends on TensorFlow asks for tensorflow, also if the wheel is called otherwise, such as tensorflow-cpu. Some releases
# for arm64 bring such a package themselves.
"$here/../part/records.py" alias tensorflow "$wheel"
