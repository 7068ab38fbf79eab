#!/usr/bin/env bash
# The Python is the one that the tag promises.
set -euo pipefail
found=$(python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
[[ $found == "${EXPECT_PYTHON:?}" ]] || { echo "Python $found, expected $EXPECT_PYTHON" >&2; exit 1; }
