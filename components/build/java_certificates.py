#!/usr/bin/env python3
"""Gives every certificate in Java's store one time: Debian's ca-certificates-java writes down when it added each.

    java_certificates.py FILE SECONDS

The store is a JKS file: a header, entries, and a SHA-1 over the password, a phrase and both. Whatever else is found is
left as it is.
"""

from __future__ import annotations

import hashlib
import struct
import sys
from pathlib import Path

HEADER = struct.Struct(">III")  # magic number, version, number of entries
MAGIC, CERTIFICATE = 0xFEEDFEED, 2
SALT = "changeit".encode("utf-16-be") + b"Mighty Aphrodite"
"""The password that Debian's package gives the store, and the phrase that the format asks for."""

DIGEST = 20


def normalised(store: bytes, seconds: int) -> bytes:
    """The store with that time in all entries; raises ValueError for what is no such store."""
    body = bytearray(store[:-DIGEST])
    if len(body) < HEADER.size or hashlib.sha1(SALT + body).digest() != store[-DIGEST:]:
        raise ValueError("it has another format or password")
    magic, version, entries = HEADER.unpack_from(body)
    if (magic, version) != (MAGIC, 2):
        raise ValueError("it is no JKS file of version 2")
    at = HEADER.size
    for _ in range(entries):
        kind, length = struct.unpack_from(">IH", body, at)
        if kind != CERTIFICATE:
            raise ValueError("it has more than certificates")
        at += 6 + length  # the name
        struct.pack_into(">Q", body, at, seconds * 1000)
        at += 8
        at += 2 + struct.unpack_from(">H", body, at)[0]  # the certificate's type
        at += 4 + struct.unpack_from(">I", body, at)[0]
    return bytes(body) + hashlib.sha1(SALT + body).digest()


def main() -> None:
    file, seconds = Path(sys.argv[1]), int(sys.argv[2])
    try:
        content = normalised(file.read_bytes(), seconds)
    except (ValueError, struct.error) as error:
        print(f"{file}: left as it is, so that another build gives another layer: {error}", file=sys.stderr)
    else:
        file.write_bytes(content)


if __name__ == "__main__":
    main()
