#!/usr/bin/env bash
# Nothing is there that programs are only built with, and no package brings it later. What parts bring is the same in all
# images, and does not count.
set -euo pipefail
root=${CHECK_ROOT:-}
fail() {
  echo "$1" >&2
  exit 1
}

for tool in gcc g++ cc c++ cpp clang make ninja cmake ctest git gdb colcon; do
  for path in "$root"/{usr/bin,usr/local/bin,opt/ros/*/bin}/"$tool"; do
    [[ ! -e $path ]] || fail "a compiler, or a tool to build with: $path"
  done
done
for folder in "$root"/{usr/include,opt/ros/*/include,usr/lib/gcc,usr/libexec/gcc}; do
  if [[ -d $folder ]]; then
    left=$(find "$folder" -type f -print -quit)
    [[ -z $left ]] || fail "a header, or a compiler's file: $left"
  fi
done
left=$(find "$root/usr/lib" -name '*.a' -not -path '*/dist-packages/*' -print -quit)
[[ -z $left ]] || fail "a static library: $left"
settings=$root/etc/dpkg/dpkg.cfg.d/rosml-runtime
grep -q -x 'path-exclude=/usr/include/\*' "$settings" || fail "$settings leaves no headers out"
