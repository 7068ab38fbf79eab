#!/usr/bin/env bash
# TensorFlow's libraries in a default library path: `-ltensorflow_cc -ltensorflow_framework` links, and programs run
# without LD_LIBRARY_PATH. The headers stay inside the Python package: in a default include path they would shadow the
# system's protobuf, abseil and Eigen.
set -euo pipefail

libraries=${OUT:?}/usr/lib/${TRIPLET:?}
for name in tensorflow_cc tensorflow_framework; do
  versioned=$(basename "$OUT${SITE:?}"/tensorflow/lib$name.so.*)
  ln -s "$SITE/tensorflow/$versioned" "$libraries/$versioned"
  ln -s "$versioned" "$libraries/lib$name.so"
done
