#!/usr/bin/env bash
# Assembles one part under /out from a hash-pinned lock, for TARGETARCH, on whatever architecture this runs.
#   PART       its name in matrix.yaml
#   PYTHON     3.11, ...; "any" for a part that does not depend on the Python version
#   WHEEL_PYTHON  the Python whose wheels it is taken from
#   TARGETARCH amd64 | arm64 (set by BuildKit)
#   LOCK       the requirements file with hashes
#   SHOWS      a part for any Python whose packages this one shows to its Python: their lock is /shown/<name>.txt
#   GLIBC      the glibc that its wheels ask for, such as 2.34, if that is newer than the usual one
#   INDEX      an index of Python packages that is asked first; none for the usual one
#   SLOT       of the constraints that pip and uv keep to (01 to 16); none for a part that no Python knows of
# What a part leaves out is in components/<part>/prune.txt, or, where it takes little of its wheels, what it keeps is in
# keep.txt. Its own steps are in files.sh; they get OUT (/out), SITE
# (where packages go) and TRIPLET.
# The result depends on the lock and on these scripts alone: not on the day, the machine or the build folder.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=components/build/network.sh
source "$here/../build/network.sh"

case ${TARGETARCH:?} in
  amd64) platform=x86_64-manylinux_2_28 TRIPLET=x86_64-linux-gnu ;;
  arm64) platform=aarch64-manylinux_2_28 TRIPLET=aarch64-linux-gnu ;;
  *) echo "assemble: no wheels are known for architecture '$TARGETARCH' (known: amd64, arm64)" >&2 && exit 64 ;;
esac
if [[ -n ${GLIBC:-} ]]; then platform=${platform%_*}_${GLIBC#2.}; fi

if [[ ${PYTHON:?} == any ]]; then
  SITE=/usr/local/lib/rosml/${PART:?}
else
  SITE=/usr/local/lib/python$PYTHON/dist-packages
fi
export OUT=/out SITE TRIPLET PYTHON PART

# PyTorch's wheels for the CPU of amd64 are on its own index alone; uv knows where that is.
if grep -q '^[^ ]*==[^ ]*+cpu' "${LOCK:?}"; then export UV_TORCH_BACKEND=cpu; fi

if [[ -n ${INDEX:-} ]]; then export UV_INDEX=$INDEX; fi

# uv unpacks while it downloads and checks every hash. Its cache is on the same file system, so files are linked,
# not copied: one copy on disk instead of two.
mkdir -p "$OUT$SITE" "$OUT/usr/lib/$TRIPLET"
uv pip install --no-deps --require-hashes --only-binary :all: --link-mode hardlink --cache-dir /out/.cache \
  --target "$OUT$SITE" --python-platform "$platform" --python-version "${WHEEL_PYTHON:?}" --requirement "$LOCK"
rm -rf /out/.cache "$OUT$SITE/.lock"

"$here/records.py" prune
"$here/relocate_scripts.py"

# What the part holds, for the login banner and for whoever asks: no import, no package manager needed.
mkdir -p "$OUT/usr/local/share/rosml/versions.d"
sed -n 's/^\([A-Za-z0-9._-]*\)==\([^ ]*\).*/\1 \2/p' "$LOCK" >"$OUT/usr/local/share/rosml/versions.d/$PART"

"$here/abseil_for_gcc.py"
"$here/adapt_metadata.py"
"$here/complete_tensorflow.py"
if [[ -x $here/../$PART/files.sh ]]; then "$here/../$PART/files.sh"; fi
# A part replaces nothing of an image that it goes onto, and each image may have the runtimes of compilers there. Not every architecture's
# wheels bring them.
if runtimes=$(find "$OUT/usr/lib/$TRIPLET" | grep -E '/lib(atomic|gcc_s|gfortran|gomp|quadmath|stdc\+\+)\.so'); then
  echo "assemble: $PART brings a compiler's runtime where the distribution has its own: $runtimes; link it elsewhere in files.sh" >&2 && exit 1
fi
# Python's headers are those of one Python, and whoever includes the part would get them instead of the distribution's.
if headers=$(find "$OUT" -name Python.h | grep .); then
  echo "assemble: $PART brings headers of Python itself: $headers; name their folder in components/$PART/prune.txt" >&2 && exit 1
fi
"$here/records.py" verify
if [[ -n ${SLOT:-} ]]; then "$here/packages.py" "$SLOT" /shown/*.txt; fi
[[ $PYTHON == any ]] || "$here/bytecode.sh"
"$here/normalise.sh"
