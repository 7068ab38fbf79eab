#!/usr/bin/env bash
# Builds the project, looks where each target's headers came from, and runs the program.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
export TF_CPP_MIN_LOG_LEVEL=2
trap 'rm -rf "$work"' EXIT

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_CXX_FLAGS="-O0 -Wall"
cmake --build "$work/build"

# read_for OBJECT: the headers of the three libraries that the compiler read for it.
read_for() {
  ninja -C "$work/build" -t deps "CMakeFiles/$1.o" |
    grep -oE '/\S*/(google/protobuf|eigen3|Eigen|absl)/\S*' || { echo "none for $1" >&2; return 1; }
}
ours=$(read_for with_tensorflow.dir/with_tensorflow.cpp)
systems=$(read_for headers.dir/with_system.cpp && read_for headers.dir/picture.pb.cc)
if grep -v /tensorflow/include/ <<<"$ours" || grep -v ^/usr/include/ <<<"$systems"; then exit 1; fi

timeout 60 env -u LD_LIBRARY_PATH "$work/build/headers" "$work/build/libwith_tensorflow.so"
