#!/usr/bin/env bash
# Configures, builds and installs a C++ program with find_package(TensorFlow), links it by plain library names too, builds
# another one by the folders and names that people's own commands have, and a C program by plain names and with pkg-config;
# runs them as a user without rights, without LD_LIBRARY_PATH.
# Compiling and linking take seconds each, so they run side by side where they can.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"

# A job in the background; its output matters when it fails.
side() { "$@" >"$work/side.$1.log" 2>&1 || { cat "$work/side.$1.log" >&2; return 1; }; }
save_model() { python3 "$here/save_model.py" "$work/model"; }
# shellcheck disable=SC2046  # pkg-config prints words
c_api() { gcc -Wl,--as-needed -o "$work/c_api" "$here/c_api.c" $(pkg-config --cflags --libs tensorflow); }
plain_c() { gcc -o "$work/plain_c" "$here/c_api.c" -ltensorflow; }
found() {
  g++ -std=c++17 -I /usr/local/include/tensorflow -o "$work/found" "$here/found.cpp" -ltensorflow_cc -ltensorflow_framework -lprotobuf
}
# By a link to a library of Python's, as tensorflow_ros_cpp has it.
# shellcheck disable=SC2046  # python3-config prints words
by_link() {
  ln -s /usr/local/lib/python3*/dist-packages/tensorflow/python/_pywrap_tensorflow_internal.so "$work/libby_link.so"
  gcc -o "$work/by_link" "$here/c_api.c" -Wl,--no-as-needed "$work/libby_link.so" -ltensorflow $(python3-config --ldflags --embed)
}
side save_model & jobs=($!)
side by_link & jobs+=($!)
side plain_c & jobs+=($!)
side found & jobs+=($!)
side c_api & jobs+=($!)

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DCMAKE_INSTALL_PREFIX="$work/installed" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --install "$work/build" >/dev/null
g++ -o "$work/plain" "$work/build/CMakeFiles/tensorflow_graph.dir/graph.cpp.o" -ltensorflow_cc -ltensorflow_framework
for job in "${jobs[@]}"; do wait "$job"; done

# TensorFlow's own headers of protobuf and Eigen are for who asks for them.
for header in google/protobuf/message.h absl/strings/cord.h Eigen/Core; do
  of=$(g++ -M -x c++ - <<<"#include <$header>" 2>/dev/null | grep -o '/usr/local/[^ ]*' | head -n 1) || continue
  echo "$header of the default path is TensorFlow's: $of" >&2 && exit 1
done
# The constants of the program are Python's.
if "$work/found" | grep '=' | grep -vxFf "$work/side.save_model.log" >&2; then echo 'which Python has not' >&2 && exit 1; fi
programs=("$work/installed/bin/tensorflow_graph" "$work/plain" "$work/c_api" "$work/plain_c" "$work/found" "$work/by_link")
if readelf --dynamic "${programs[@]}" | grep -E 'RPATH|RUNPATH'; then exit 1; fi
for program in "${programs[@]}"; do
  env -u LD_LIBRARY_PATH TF_CPP_MIN_LOG_LEVEL=3 HOME=/ \
    setpriv --reuid=65534 --regid=65534 --clear-groups --no-new-privs "$program" "$work/model" |
    sed "s|^|$(basename "$program"): |"
done
