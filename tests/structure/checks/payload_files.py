#!/usr/bin/env python3
"""Every file that a package of the payload has on record is in the image, with its size; small ones byte for byte.

The whole comparison was made when the payload was assembled (components/payload/records.py).
"""

from __future__ import annotations

import base64
import csv
import hashlib
import sys
from pathlib import Path

SMALL = 100_000
"""Bytes up to which a file is read."""

sites = [*Path("/usr/local/lib").glob("python3*/dist-packages"), *Path("/usr/local/lib/rosml").glob("*")]
wrong: list[str] = []
checked = 0
for record in (record for site in sites for record in site.glob("*.dist-info/RECORD")):
    with record.open(newline="") as stream:
        for path, digest, size in csv.reader(stream):
            file = record.parent.parent / path
            if not digest:
                continue
            checked += 1
            if not file.is_file():
                wrong.append(f"{path} is missing")
            elif file.stat().st_size != int(size):
                wrong.append(f"{path} has {file.stat().st_size} bytes, {size} are on record")
            elif int(size) <= SMALL:
                found = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
                if digest != f"sha256={found}":
                    wrong.append(f"{path} is not what is on record")
print(f"{checked} files")
if wrong or checked < 100:
    sys.exit("\n".join(wrong[:50]) or "no payload is here")
