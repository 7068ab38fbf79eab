#!/usr/bin/env python3
"""Every file that a package of the payload has on record is in the image, with its size.

Contents were compared when the payload was assembled (components/payload/records.py).
"""

from __future__ import annotations

import csv
import os
import sys
from pathlib import Path

sites = [*Path("/usr/local/lib").glob("python3*/dist-packages"), *Path("/usr/local/lib/rosml").glob("*")]
wrong: list[str] = []
checked = 0
for record in (record for site in sites for record in site.glob("*.dist-info/RECORD")):
    with record.open(newline="") as stream:
        for path, digest, size in csv.reader(stream):
            if not digest:
                continue
            checked += 1
            try:
                found = os.stat(os.path.join(record.parent.parent, path)).st_size
            except OSError:
                wrong.append(f"{path} is missing")
                continue
            if found != int(size):
                wrong.append(f"{path} has {found} bytes, {size} are on record")
print(f"{checked} files")
if wrong or checked < 100:
    sys.exit("\n".join(wrong[:50]) or "no payload is here")
