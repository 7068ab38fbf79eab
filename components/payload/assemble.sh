#!/usr/bin/env bash
# Assembles one payload part under /out from a hash-pinned lock, for TARGETARCH, on whatever architecture this runs.
#   PART       cuda | common | torch | tensorflow
#   PYTHON     3.11, ...; "any" for a part that does not depend on the Python version
#   TARGETARCH amd64 | arm64 (set by BuildKit)
#   LOCK       the requirements file with hashes
# The result depends on the lock and on these scripts alone: not on the day, the machine or the build folder.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

case ${TARGETARCH:?} in
  amd64) platform=x86_64-manylinux_2_28 triplet=x86_64-linux-gnu ;;
  arm64) platform=aarch64-manylinux_2_28 triplet=aarch64-linux-gnu ;;
  *) echo "assemble: no wheels are known for architecture '$TARGETARCH' (known: amd64, arm64)" >&2 && exit 64 ;;
esac

if [[ ${PYTHON:?} == any ]]; then
  site=/usr/local/lib/rosml/${PART:?}
  python_version=3.11 # wheels of such parts are tagged py3-none: the version only has to be a valid one
else
  site=/usr/local/lib/python$PYTHON/dist-packages
  python_version=$PYTHON
fi
export out=/out site triplet PYTHON

# uv unpacks while it downloads and checks every hash. Its cache is on the same file system, so files are linked,
# not copied: one copy on disk instead of two.
mkdir -p "$out$site" "$out/usr/lib/$triplet"
uv pip install --no-deps --require-hashes --only-binary :all: --link-mode hardlink --cache-dir /out/.cache \
  --target "$out$site" --python-platform "$platform" --python-version "$python_version" --requirement "${LOCK:?}"
rm -rf /out/.cache "$out$site/.lock"

"$here/relocate_scripts.py"
if [[ -x $here/../part/files.sh ]]; then "$here/../part/files.sh"; fi
[[ $PYTHON == any ]] || "$here/bytecode.sh"
"$here/normalise.sh"
