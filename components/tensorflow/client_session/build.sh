#!/usr/bin/env bash
# Builds libtensorflow_client_session.so.2 for TRIPLET against the wheel's headers and libraries, on any architecture.
#   build.sh LIBRARY FLAG...     the flags are those that users of the headers need
# No path, no date and no compiler's name gets in: the same compiler makes the same file.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
library=$1
tensorflow=${OUT:?}${SITE:?}/tensorflow

"${TRIPLET:?}-g++" -shared -fPIC -std=c++17 -O2 -DNDEBUG -w "${@:2}" -isystem "$tensorflow/include" \
  -ffile-prefix-map="$OUT=" -ffile-prefix-map="$here=." -o "$library" "$here/client_session.cc" \
  -Wl,-soname="$(basename "$library")" -Wl,--version-script="$here/exports.map" -Wl,--build-id=none,--no-undefined \
  "$tensorflow"/libtensorflow_cc.so.* "$tensorflow"/libtensorflow_framework.so.*
"$TRIPLET-strip" --strip-all --remove-section=.comment "$library"
"$TRIPLET-nm" --dynamic --defined-only --demangle "$library" |
  "$here/complete.py" "$tensorflow/include/tensorflow/cc/client/client_session.h"
