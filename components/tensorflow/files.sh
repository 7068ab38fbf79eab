#!/usr/bin/env bash
# TensorFlow for C++: libraries in a default library path, so that `-ltensorflow_cc -ltensorflow_framework` links and
# programs run without LD_LIBRARY_PATH, a CMake package, and a pkg-config file. The headers stay inside the Python
# package: in a default include path they would shadow the system's protobuf, abseil and Eigen.
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

# <name>-<version>.dist-info: tensorflow, tensorflow_cpu or tensorflow_cpu_aws, whichever has the library.
wheel=$(basename "$(dirname "$(grep -l '^tensorflow/libtensorflow_cc\.so' "$OUT$SITE"/*.dist-info/RECORD)")")
version=${wheel%.dist-info}
version=${version##*-}

# Whether libtensorflow_cc exports a symbol whose name begins so; nm of the target's architecture reads it. grep counts,
# so that it reads to the end: nm would fail where nobody listens.
exports() { "$TRIPLET-nm" --dynamic --defined-only "$tensorflow/libtensorflow_cc.so.$soversion" | grep -c " $1" >/dev/null; }

# `pip install` of what depends on "tensorflow" must find it, also where the wheel that carries it is called otherwise
# (tensorflow-cpu): a package without files that says so. Some releases for arm64 bring one themselves.
alias=$OUT$SITE/tensorflow-$version.dist-info
if [[ ! -d $alias ]]; then
  mkdir "$alias"
  printf '%s\n' 'Metadata-Version: 2.1' 'Name: tensorflow' "Version: $version" \
    "Summary: Stands for ${wheel%%-*}, which is the same package under another name" \
    "Requires-Dist: ${wheel%%-*}==$version" >"$alias/METADATA"
  printf '%s\n' 'Wheel-Version: 1.0' 'Generator: rosml' 'Root-Is-Purelib: true' 'Tag: py3-none-any' >"$alias/WHEEL"
  echo rosml >"$alias/INSTALLER"
  for file in INSTALLER METADATA RECORD WHEEL; do echo "${alias##*/}/$file,,"; done >"$alias/RECORD"
fi

# What tf.sysconfig.get_compile_flags() says, without running it: the target may be another architecture. TensorFlow
# compiles Eigen with this alignment on all architectures:
# https://github.com/tensorflow/tensorflow/blob/v2.13.1/third_party/eigen3/eigen_archive.BUILD
abi=0
if exports _ZNK10tensorflow5Scope10WithDeviceERKNSt7__cxx11; then abi=1; fi
flags=(-D_GLIBCXX_USE_CXX11_ABI="$abi" -DEIGEN_MAX_ALIGN_BYTES=64)
# Newer headers want TensorFlow's version from the command line.
if [[ -e $tensorflow/include/tensorflow/core/public/release_version.h ]]; then
  IFS=. read -r major minor patch _ <<<"$version"
  flags+=(-DTF_MAJOR_VERSION="$major" -DTF_MINOR_VERSION="$minor" -DTF_PATCH_VERSION="${patch%%[!0-9]*}" -DTF_VERSION_SUFFIX=)
fi

# Wheels from about 2.20 on have the header of ClientSession, the documented way to run a graph, but not the class.
# It is linked by whoever names libtensorflow_cc and uses it, by way of a linker script, as libc.so is one. ldconfig
# complains about a file that is no library, unless these words are in it.
if ! exports _ZN10tensorflow13ClientSessionC1E; then
  session=libtensorflow_client_session.so.$soversion
  "$here/client_session/build.sh" "$libraries/$session" "${flags[@]}"
  rm "$libraries/libtensorflow_cc.so"
  printf '/* GNU ld script */\nINPUT(/usr/lib/%s/%s AS_NEEDED(/usr/lib/%s/%s))\n' \
    "$TRIPLET" "libtensorflow_cc.so.$soversion" "$TRIPLET" "$session" >"$libraries/libtensorflow_cc.so"
fi

fill() {
  sed -e "s|@SITE@|$SITE|g" -e "s|@TRIPLET@|$TRIPLET|g" -e "s|@VERSION@|$version|g" -e "s|@WHEEL@|$wheel|g" \
    -e "s|@SOVERSION@|$soversion|g" -e "s|@FLAGS@|${flags[*]}|g" "$here/$1.in" >"$2/$(basename "$1")"
}
mkdir -p "$OUT/usr/local/lib/cmake/TensorFlow" "$OUT/usr/local/lib/pkgconfig"
fill cmake/TensorFlowConfig.cmake "$OUT/usr/local/lib/cmake/TensorFlow"
fill cmake/TensorFlowConfigVersion.cmake "$OUT/usr/local/lib/cmake/TensorFlow"
fill pkgconfig/tensorflow_cc.pc "$OUT/usr/local/lib/pkgconfig"

# The library and its headers are the same for all Pythons: a part of their own has them.
"$here/../part/records.py" link /usr/local/lib/rosml/tensorflow-cc \
  "tensorflow/libtensorflow_cc.so.$soversion" tensorflow/include
