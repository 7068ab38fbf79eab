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

# -d: the path in the image, for tracebacks; Python 3.8 has no other way to say so. The seed is the order of sets, which Pythons up
# to 3.10 write as it comes.
PYTHONHASHSEED=0 "python$PYTHON" -m compileall -q --invalidation-mode "$BYTECODE" -j 0 -d "${SITE:?}" "${OUT:?}$SITE" \
  >/tmp/compileall.log 2>&1 || true

# Some packages ship templates and code for other Pythons that do not compile; they are never imported here. Every other
# file has its bytecode: a full disk or a killed worker would leave some out.
"python$PYTHON" - "$OUT$SITE" <<'END' || { cat /tmp/compileall.log; exit 1; }
import importlib.util, pathlib, sys

for file in sorted(pathlib.Path(sys.argv[1]).rglob("*.py")):
    if pathlib.Path(importlib.util.cache_from_source(str(file))).exists():
        continue
    try:
        compile(file.read_bytes(), str(file), "exec")
    except (SyntaxError, ValueError):
        print("bytecode: none of", file, "which does not compile")
    else:
        sys.exit("bytecode: {} has none, although it compiles".format(file))
END
