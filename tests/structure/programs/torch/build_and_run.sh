#!/usr/bin/env bash
# Configures, builds and installs a C++ program with find_package(Torch), links it by plain library names too, and
# builds a small one with pkg-config; runs them as a user without rights, without LD_LIBRARY_PATH.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"

# shellcheck disable=SC2046  # pkg-config prints words
g++ -o "$work/config" "$here/config.cpp" $(pkg-config --cflags --libs torch) >"$work/side.log" 2>&1 & side=$!

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DCMAKE_INSTALL_PREFIX="$work/installed" -DHINT="$(echo /usr/local/lib/python3*/dist-packages/torch)" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --install "$work/build" >/dev/null
g++ -o "$work/plain" "$work/build/CMakeFiles/torch_program.dir/main.cpp.o" -ltorch -ltorch_cpu -lc10
wait "$side" || { cat "$work/side.log" >&2; exit 1; }

programs=("$work"/installed/bin/* "$work/plain" "$work/config")
if readelf --dynamic "${programs[@]}" | grep -E 'RPATH|RUNPATH'; then exit 1; fi
for program in "${programs[@]}"; do
  env -u LD_LIBRARY_PATH HOME=/ setpriv --reuid=65534 --regid=65534 --clear-groups --no-new-privs "$program" |
    sed "s|^|$(basename "$program"): |"
done
