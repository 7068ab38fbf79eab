"""A local replacement for uv: a shell script that records its calls, and resolves everything to the same."""

from __future__ import annotations

from pathlib import Path

from fakes.stubs import executable

RESOLVED = """\
numpy==1.26.4 \\
    --hash=sha256:bb \\
    --hash=sha256:aa
    # via
    #   -r in.txt
    #   tensorflow
    #   torch
nvidia-cublas-cu12==12.8.4.1 \\
    --hash=sha256:cc
    # via torch
tensorflow==2.20.0 ; python_version >= '3.12' \\
    --hash=sha256:dd
    # via -r in.txt
torch==2.10.0+cu128 \\
    --hash=sha256:ee
    # via -r in.txt

# The following packages were excluded from the output:
# setuptools
"""

UV = """\
here='{folder}'
echo "uv $*" >>"$here/calls"
for file in in constraints out; do [ ! -e $file.txt ] || cp $file.txt "$here/seen-$file.txt" 2>/dev/null; done
case "$*" in
  *pylock.toml*) # of a version, the same wheel for each Python; the newest ones otherwise
    sed -n 's/^\\(.*\\)==\\(.*\\)/[[packages]]\\nname = "\\1"\\nversion = "\\2"\\nwheels = [{{url = "\\1.whl", size = 1}}]/p' in.txt >pylock.toml
    [ -s pylock.toml ] || printf '[[packages]]\\nname = "torch"\\nversion = "2.10.0"\\n' >pylock.toml
    exit ;;
esac
while [ $# -gt 0 ]; do case $1 in --python-version) python=$2 ;; --python-platform) platform=$2 ;; esac; shift; done
"""
# NVIDIA's packages are for amd64 only, as in the matrix of these tests.
FILTER = 'case $platform in aarch64*) sed "/^nvidia/,/# via/d" ;; *) cat ;; esac'
RESOLVES = UV + FILTER + ' <"$here/resolved.txt" >out.txt'


def fake_uv(folder: Path, text: str = RESOLVES, resolved: str = RESOLVED) -> str:
    (folder / "resolved.txt").write_text(resolved)
    return executable(folder / "uv", text.format(folder=folder))
