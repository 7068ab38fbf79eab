#!/usr/bin/env python3
"""Changes the bound of a requirement in the metadata of a wheel, and its record, for each line of the lock such as
`# adapted: torch setuptools>=66.1.1`. The marker stays.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import records  # beside this script

LINE = re.compile(
    r"^# adapted: (?P<package>[A-Za-z0-9._-]+) (?P<name>[A-Za-z0-9._-]+)(?P<bound>[<>=!~].*)$", re.MULTILINE
)


def adapt(package: str, name: str, bound: str) -> None:
    files = list(records.SITE.glob(f"{package}-[0-9]*.dist-info/METADATA"))
    if len(files) != 1:
        sys.exit(f"adapt_metadata: {len(files)} packages are called {package}; correct 'adapted' in matrix.yaml")
    text = files[0].read_text(encoding="utf-8")
    head, separator, description = text.partition("\n\n")
    head, count = re.subn(rf"(?m)^(Requires-Dist: {re.escape(name)}) ?(?![\w.-])[^;\n]*", rf"\g<1>{bound}", head)
    if count != 1:
        asks = f"{package} asks for {name} {count} times"
        sys.exit(f"adapt_metadata: {asks}; correct 'adapted' in matrix.yaml")
    files[0].unlink()  # a link to uv's copy, perhaps
    files[0].write_text(head + separator + description, encoding="utf-8")
    path = str(files[0].relative_to(records.SITE))
    records.replace({path: [path, *map(str, records.digest(files[0]))]})
    print(f"adapt_metadata: {package} asks for {name}{bound}")


def main() -> None:
    for match in LINE.finditer(Path(os.environ["LOCK"]).read_text(encoding="utf-8")):
        adapt(match["package"], match["name"], match["bound"].strip())


if __name__ == "__main__":
    main()
