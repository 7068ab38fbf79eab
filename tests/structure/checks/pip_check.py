#!/usr/bin/env python3
"""`pip check` has nothing to say about a package of the payload.

Debian's own Python packages are left out: some declare to pip what Debian builds differently (trixie's python3-nacl
"is not supported on this platform"), in an image without any payload as well.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

VERSIONS = Path(os.environ.get("CHECK_ROOT", "/"), "usr/local/share/rosml/versions.d")


def normal(name: str) -> str:
    """A package's name as pip compares it."""
    return re.sub(r"[-_.]+", "-", name).lower()


payload = {normal(line.split()[0]) for file in VERSIONS.iterdir() for line in file.read_text().splitlines()}
assert len(payload) > 1, payload
complaints = subprocess.run(["pip", "check"], capture_output=True, text=True, check=False).stdout.splitlines()
ours = [line for line in complaints if payload & {normal(word) for word in re.findall(r"[\w.-]*\w", line)}]
print("\n".join(complaints))
sys.exit(f"{len(ours)} complaints about payload packages:\n" + "\n".join(ours) if ours else 0)
