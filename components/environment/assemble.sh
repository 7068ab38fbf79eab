#!/usr/bin/env bash
# Assembles an environment of Python packages below /out/opt/env from a hash-pinned lock, for TARGETARCH, on whatever architecture
# this runs. It sees the packages of the image that it goes onto, and ROS's.
#   ENVIRONMENT  its name
#   PYTHON       3.11, ...: the system's own Python of that image
#   GLIBC        the N of that image's glibc 2.N
#   TARGETARCH   amd64 | arm64 (set by BuildKit)
#   LOCK         the requirements file with hashes
# The result depends on the lock and on these scripts alone: not on the day, the machine or the build folder.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

case ${TARGETARCH:?} in
  amd64) platform=x86_64-manylinux_2_${GLIBC:?} ;;
  arm64) platform=aarch64-manylinux_2_${GLIBC:?} ;;
  *) echo "assemble: no wheels are known for architecture '$TARGETARCH' (known: amd64, arm64)" >&2 && exit 64 ;;
esac
if ! command -v "python${PYTHON:?}" >/dev/null; then
  echo "assemble: the assembler has no python$PYTHON; build the environment on a machine that has a base image with it" >&2
  exit 69
fi

prefix=/opt/env/${ENVIRONMENT:?}
export OUT=/out SITE=$prefix/lib/python$PYTHON/site-packages PYTHON

# Relocatable: its scripts find the interpreter beside them, and not in this build's folder.
mkdir -p "$OUT"
uv venv --quiet --relocatable --system-site-packages --python "/usr/bin/python$PYTHON" "$OUT$prefix"
if grep -q '^[^# ]' "${LOCK:?}"; then
  uv pip install --no-deps --require-hashes --only-binary :all: --link-mode hardlink --cache-dir /out/.cache \
    --python "$OUT$prefix/bin/python" --python-platform "$platform" --requirement "$LOCK"
fi
rm -rf /out/.cache
# What is of uv's own, and of other systems. Programs for backups leave folders with a CACHEDIR.TAG out.
find "$OUT$prefix" -name .lock -delete
rm -f "$OUT$prefix"/{.gitignore,CACHEDIR.TAG} "$OUT$prefix"/bin/*.{bat,ps1}

# The interpreter is the image's, whatever the assembler's links say.
ln -sfn "/usr/bin/python$PYTHON" "$OUT$prefix/bin/python"

# The functions of a cv_bridge for another numpy or OpenCV are replaced.
cp "$here"/_rosml_*.py "$OUT$SITE/"
echo "import _rosml_cv_guard" >"$OUT$SITE/_rosml_cv_guard.pth"

"$here/../part/bytecode.sh"
"$here/../part/normalise.sh"
