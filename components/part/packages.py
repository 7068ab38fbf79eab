#!/usr/bin/env python3
"""What pip and uv know of a part's packages.

  packages.py SLOT [LOCK...]
      shows Python the packages of other parts, by their locks (<part>.txt), and writes what it has then to the slot: pip
      and uv keep to that, and install no other release over it (components/base/pip.conf)

Other parts are those for any Python, below /usr/local/lib/rosml, which are not here. uv looks at folders in the folder of
Python's packages and follows neither a link to one nor a .pth file: so each package has a folder, with links in it.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

OUT = Path(os.environ["OUT"])
SITE = OUT / os.environ["SITE"].lstrip("/")

SHOWN = ("INSTALLER", "METADATA", "RECORD", "WHEEL")
"""What every package has that uv installed. RECORD: whoever removes it removes its files, by way of the part's links."""


def show(lock: Path) -> None:
    """Gives the packages of a lock folders whose files are those of the part that the lock is of."""
    for name, version in re.findall(r"^([A-Za-z0-9._-]+)==([^ \\\n]+)", lock.read_text(), re.MULTILINE):
        folder = SITE / "{}-{}.dist-info".format(re.sub(r"[-.]+", "_", name), version)
        folder.mkdir()
        for file in SHOWN:
            (folder / file).symlink_to(f"/usr/local/lib/rosml/{lock.stem}/{folder.name}/{file}")


def pins() -> list[str]:
    """What Python finds, as constraints: torch==2.10.0+cpu."""
    found = (folder.stem.rsplit("-", 1) for folder in SITE.glob("*.dist-info"))
    return sorted("{}=={}".format(re.sub(r"[-_.]+", "-", name).lower(), version) for name, version in found)


def main(slot: str, *locks: str) -> None:
    """Shows other parts' packages and fills the slot."""
    for lock in locks:
        if Path(lock).exists():  # the shell leaves a pattern as it is that nothing matches
            show(Path(lock))
    file = OUT / "usr/local/share/rosml/constraints.d" / f"{slot}.txt"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join([f"# What the part {os.environ['PART']} holds", *pins(), ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
