#!/usr/bin/env python3
"""`pip check` has nothing to say about a package of the part.

Debian's own Python packages are left out: some declare to pip what Debian builds differently (trixie's python3-nacl
"is not supported on this platform"), in an image without any part as well.
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


part = {normal(line.split()[0]) for file in VERSIONS.iterdir() for line in file.read_text().splitlines()}
assert len(part) > 1, part
complaints = subprocess.run(["pip", "check"], capture_output=True, text=True, check=False).stdout.splitlines()
ours = [line for line in complaints if part & {normal(word) for word in re.findall(r"[\w.-]*\w", line)}]
print("\n".join(complaints))
sys.exit(f"{len(ours)} complaints about part packages:\n" + "\n".join(ours) if ours else 0)
