#!/usr/bin/env bash
# Compiles bytecode with the target's Python version: without it, `import torch` takes 1.7 times as long in every
# fresh container. Hash-based, so that it does not depend on file times; "checked", so that an edited file still
# takes effect.
#   BYTECODE   checked-hash, or none: without, where the target's Python cannot be had
set -euo pipefail

if [[ ${BYTECODE:?} == none ]]; then
  echo "bytecode: none, as BYTECODE says"
  exit 0
fi
if ! command -v "python$PYTHON" >/dev/null; then
  echo "bytecode: the assembler has no python$PYTHON; assemble on a base image that has it, or with BYTECODE=none" >&2
  exit 69
fi

compile() { "python$PYTHON" -m compileall -q "$@"; }

# Some packages ship templates and code for other Pythons that do not compile; they are never imported here.
# -d: the path in the image, for tracebacks; Python 3.8 has no other way to say so.
compile --invalidation-mode "$BYTECODE" -j 0 -d "${SITE:?}" "${OUT:?}$SITE" >/tmp/compileall.log 2>&1 ||
  { echo "bytecode: left without bytecode:"; grep -o "File \"[^\"]*\"" /tmp/compileall.log | sort -u; } ||
  { cat /tmp/compileall.log; exit 1; }
