"""Licences as SPDX identifies them, from the words of Debian, wheels and ROS."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache

from cyclonedx.spdx import fixup_id, is_expression

LONGEST = 120
"""The most characters of a name. Wheels have whole texts there."""

_GNU = re.compile(r"(AGPL|LGPL|GPL|GFDL)(-NIV)?-?v?(\d)(?:\.(\d))?(?:\.0)?(\+|-or-later|-only)?", re.IGNORECASE)

_EXCEPTION = re.compile(r"[\w.+-]+-exception(-[\d.]+)?|Linux-syscall-note")

WORDS = {
    "expat": "MIT",
    "mit/x11": "MIT",
    "artistic": "Artistic-1.0-Perl",
    "apache-2": "Apache-2.0",
    "apache2": "Apache-2.0",
    "apache 2.0": "Apache-2.0",
    "apache license 2.0": "Apache-2.0",
    "apache license, version 2.0": "Apache-2.0",
    "bsd-3": "BSD-3-Clause",
    "3-clause bsd": "BSD-3-Clause",
    "bsd 3-clause": "BSD-3-Clause",
    "bsd-2": "BSD-2-Clause",
    "bsl-1": "BSL-1.0",
    "boost": "BSL-1.0",
    "cc0": "CC0-1.0",
    "mpl-2": "MPL-2.0",
    "python": "Python-2.0",
    "psf": "PSF-2.0",
    "psf-2": "PSF-2.0",
    "unicode": "Unicode-DFS-2016",
    "autoconf exception": "Autoconf-exception-2.0",
    "bison exception": "Bison-exception-2.2",
    "classpath exception": "Classpath-exception-2.0",
    "font exception": "Font-exception-2.0",
    "libtool exception": "Libtool-exception",
    "linux-syscall-note exception": "Linux-syscall-note",
}
"""Names that people use, in small letters, with what SPDX calls them: https://spdx.org/licenses/"""

CLASSIFIERS = {
    "Apache Software License": "Apache-2.0",
    "GNU General Public License v2 (GPLv2)": "GPL-2.0-only",
    "GNU General Public License v2 or later (GPLv2+)": "GPL-2.0-or-later",
    "GNU General Public License v3 (GPLv3)": "GPL-3.0-only",
    "GNU General Public License v3 or later (GPLv3+)": "GPL-3.0-or-later",
    "GNU Lesser General Public License v2 (LGPLv2)": "LGPL-2.0-only",
    "GNU Lesser General Public License v2 or later (LGPLv2+)": "LGPL-2.0-or-later",
    "GNU Lesser General Public License v3 (LGPLv3)": "LGPL-3.0-only",
    "GNU Lesser General Public License v3 or later (LGPLv3+)": "LGPL-3.0-or-later",
    "Historical Permission Notice and Disclaimer (HPND)": "HPND",
    "ISC License (ISCL)": "ISC",
    "MIT License": "MIT",
    "MIT No Attribution License (MIT-0)": "MIT-0",
    "Mozilla Public License 2.0 (MPL 2.0)": "MPL-2.0",
    "Python Software Foundation License": "PSF-2.0",
    "The Unlicense (Unlicense)": "Unlicense",
    "zlib/libpng License": "Zlib",
}
"""Classifiers of wheels that mean one licence, as PyPI lists them."""


@dataclass(frozen=True)
class License:
    """A licence: an expression of SPDX, or a name if SPDX has none."""

    text: str
    is_spdx: bool

    @property
    def is_compound(self) -> bool:
        return self.is_spdx and " " in self.text


def of_debian(names: Iterable[str]) -> list[License]:
    """The licences that a copyright file names, each once. All of them count: they are of different files."""
    return _unique(_read(name) for name in names if _name(name))


def of_wheel(texts: Iterable[str]) -> list[License]:
    """The licence of a wheel, by the most telling of its fields and classifiers; else what these say."""
    names = [name for text in texts if (name := _name(text.rpartition(" :: ")[2]))]
    licenses = [License(CLASSIFIERS[name], True) if name in CLASSIFIERS else _read(name) for name in names]
    by_spdx = [license for license in licenses if license.is_spdx]
    return by_spdx[:1] or _unique(licenses)[:1]


@cache
def _read(text: str) -> License:
    """An expression of SPDX, as far as the words of Debian and of people are ones."""
    name = _name(text)
    words = re.split(r"\s+(and|or|with)\s+", name.replace(",", " "), flags=re.IGNORECASE)
    operators = [word.upper() if number % 2 else _identifier(word.strip()) for number, word in enumerate(words)]
    expression = " ".join(operators)
    is_spdx = all(operators) and (fixup_id(expression) == expression or is_expression(expression))
    return License(expression, True) if is_spdx else License(name, False)


def _identifier(word: str) -> str:
    """What SPDX calls a licence or an exception; empty if it does not know it."""
    if gnu := _GNU.fullmatch(word):
        name, invariants, major, minor, later = gnu.groups()
        no_invariants = "-no-invariants" if invariants else ""
        kind = "or-later" if later in ("+", "-or-later") else "only"
        word = f"{name.upper()}-{major}.{minor or 0}{no_invariants}-{kind}"
    identifier = WORDS.get(word.lower(), word)
    return fixup_id(identifier) or (identifier if _EXCEPTION.fullmatch(identifier) else "")


def _name(text: str) -> str:
    """A name on one line, which nobody takes for markup."""
    line = next(iter(text.strip().splitlines()), "")
    return re.sub(r"[^\w .,:;()/+&'-]|\s+", " ", line).strip()[:LONGEST]


def _unique(licenses: Iterable[License]) -> list[License]:
    return sorted({*licenses}, key=lambda license: license.text)


def _grouped(licenses: Iterable[License]) -> Iterator[str]:
    return (f"({license.text})" if license.is_compound else license.text for license in licenses)


def together(licenses: list[License]) -> License | None:
    """One expression of all of them; None if SPDX lacks one, or there is none."""
    if not licenses or not all(license.is_spdx for license in licenses):
        return None
    return License(licenses[0].text if len(licenses) == 1 else " AND ".join(_grouped(licenses)), True)
