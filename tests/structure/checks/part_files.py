#!/usr/bin/env python3
"""Every file that a package of the part has on record is in the image, with its size.

Contents were compared when the part was assembled (components/part/records.py).
"""

from __future__ import annotations

import csv
import hashlib
import os
import sys
from pathlib import Path

LOCAL = Path(os.environ.get("CHECK_ROOT", "/"), "usr/local")

sites = [*LOCAL.glob("lib/python3*/dist-packages"), *LOCAL.glob("lib/rosml/*")]
wrong: list[str] = []
checked = 0
records = (record for site in sites for record in site.glob("*.dist-info/RECORD"))
for record in (record for record in records if not record.is_symlink()):  # a link: of a part that is among the sites
    with record.open(newline="") as stream:
        for path, digest, size in csv.reader(stream):
            if not digest:
                continue
            checked += 1
            try:
                present_size = os.stat(os.path.join(record.parent.parent, path)).st_size
            except OSError:
                wrong.append(f"{path} is missing")
                continue
            if present_size != int(size):
                wrong.append(f"{path} has {present_size} bytes, {size} are on record")
# What one part takes another's files to be, when the two were assembled apart (records.py link): the library and headers
# of the wheel for this Python are byte for byte those of the wheel that the other part was taken from.
for expected in LOCAL.glob("share/rosml/expected.d/*"):
    rows = [
        row
        for record in LOCAL.glob(f"lib/rosml/{expected.name}/*.dist-info/RECORD")
        for row in csv.reader(record.open(newline=""))
        if ".dist-info/" not in row[0]
    ]
    summary = hashlib.sha256("\n".join(sorted(",".join(row) for row in rows)).encode()).hexdigest()
    if not rows or summary != expected.read_text().strip():
        wrong.append(f"/usr/local/lib/rosml/{expected.name} is not what the parts on top of it were assembled for")
print(f"{checked} files")
if wrong or checked < 100:
    sys.exit("\n".join(wrong[:50]) or "no part is here")
