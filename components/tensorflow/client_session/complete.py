#!/usr/bin/env python3
"""complete.py HEADER <SYMBOLS: whether a library has every public function of ClientSession that the wheel's header declares.

A newer TensorFlow may declare one more. No compiler and no linker would say so: only programs that call it would not link.
SYMBOLS is what `nm --dynamic --defined-only --demangle` says of the library.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from pathlib import Path


def declared(header: str) -> Counter[str]:
    """How often each public function is declared, with its overloads."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", header, flags=re.DOTALL)
    match = re.search(r"\bclass\s+(?:\w+\s+)?ClientSession\s*\{(.*?)\n\};", text, flags=re.DOTALL)
    if not match:
        raise ValueError("no class ClientSession is there")
    sections = re.split(r"\b(public|protected|private)\s*:", match[1])
    public = "".join(sections[index + 1] for index in range(1, len(sections), 2) if sections[index] == "public")
    # A function with a body is defined in the header.
    public = re.sub(r"\)((?:\s|const|noexcept)*)\{[^{}]*\}", r")\1{};", public)
    names = (
        re.search(r"(~?\w+)\s*\(", statement)
        for statement in public.split(";")
        if not re.match(r"\s*(typedef|using|friend|class|struct|enum)\b", statement)
        and not re.search(r"(\{\}|=\s*(default|delete))\s*$", statement)
    )
    return Counter(name[1] for name in names if name)


def defined(symbols: str) -> Counter[str]:
    """The same of a library: a constructor is in it twice, under one name that people read."""
    return Counter(
        name for name, _ in set(re.findall(r" [TW] tensorflow::ClientSession::(~?\w+)(\(.*)$", symbols, re.MULTILINE))
    )


def main() -> None:
    header = Path(sys.argv[1])
    declarations, definitions = declared(header.read_text()), defined(sys.stdin.read())
    if missing := declarations - definitions:
        sys.exit(
            f"{header}: declares functions of ClientSession that client_session.cc does not define: "
            + ", ".join(
                f"{name} ({declarations[name]} declared, {definitions[name]} defined)" for name in sorted(missing)
            )
        )
    if not declarations:
        sys.exit(f"{header}: no public function of ClientSession could be read from it")


if __name__ == "__main__":
    main()
