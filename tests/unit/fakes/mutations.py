"""Valid documents made wrong: the same ones for the same name, on every machine."""

from __future__ import annotations

import contextlib
import gzip
import io
import json
import re
import struct
import tarfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import Any

import yaml

LARGEST = 2 << 20
"""Bytes of a mutated document."""

ODD = (
    *("null", "true", "0", "-1", "1.5", '""', '"x"', '" "', "[]", "{}", "[[]]", "[null]", "[1]", '[""]', '{"": null}'),
    *("1e300", "1e999", "NaN", "-Infinity", "9" * 19, "9" * 400, "9" * 5000, f'"{"9" * 400}"', f'"{"9" * 5000}"'),
    *('"\\ud800"', '"\\u0000"', '"a\\nb"', '"\\u2028"', '"\\u00b2"', '"../../x"', '"/"', '"sha256:"', '"é"', '"%s"'),
    *(f'"{"x" * 100_000}"', "[" * 60 + "]" * 60, "[" * 200 + "]" * 200, '{"a":' * 200 + "1" + "}" * 200),
    *('"9999-12-31T23:59:59-14:00"', '"0001-01-01T00:00:00+14:00"', '"Fri, 31 Dec 9999 23:59:59 -1400"', '"a:b:c:d"'),
)

ODD_OF_YAML = (
    *("0x_", "0b_", "0o8", "!!bool x", "!!timestamp x", '!!int ""', "!!float x", "!!null x", "!!binary é", "!!set {a}"),
    *("&a [*a]", "*nowhere", "1:60:60", "2026-99-99", ".inf", "~", "=", "{<<: [1]}", "{? [a] : b}", "!!omap [a]"),
    *("!!python/object:os.system x", "[1]: 2", "? a", "- a", "2026-11-22", "1.10", "yes", "0x" + "f" * 5000),
)

LETTERS = (
    *(b"\x00", b"\r", b"\r\n", b"\x0b", b"\x0c", b"\x1c", b"\x1b]52;c;\x07", b"\x85", b"\xff", b"\xed\xa0\x80"),
    *("\u2028".encode(), "\ufeff".encode(), "\x85".encode(), "²".encode(), "٣".encode(), "\U0001f916".encode()),
    *(b"\\", b"\\\n", b'"', b"'", b"=", b":", b"::", b"#", b" ", b"\t", b"\n", b"\n\n", b"[", b"]]>", b"${X}", b"`"),
)
"""What is put into the middle of a text."""

Mutation = Callable[[Random, bytes], bytes]


def mutated(documents: Sequence[bytes], kind: str, name: str) -> Iterator[bytes]:
    """Documents with something wrong, without an end. The first of them have broken parsers before.

    Args:
        documents: valid ones. kind: json, yaml, xml, tar or text. name: what decides about the mutations.
    """
    yield from _special(documents[0])
    yield from SPECIAL[kind](documents[0])
    random = Random(name)
    while True:
        document = random.choice(documents)
        for _ in range(random.choice((1, 1, 2, 3))):
            document = random.choice(KINDS[kind])(random, document)[:LARGEST]
        yield document


# ---- Of any document -------------------------------------------------------------------------------------------------


def _special(document: bytes) -> Iterator[bytes]:
    yield from (b"", b"\x00", b"\n", b"\xff\xfe", b"\xef\xbb\xbf" + document, document + b"\xe4", b"\xe4" + document)
    yield document.replace(b"\n", b"\r\n")
    yield document.decode(errors="replace").encode("utf-16")
    yield document.replace(b"\n", b"\x0c")
    yield document.replace(b"\n", "\u2028".encode())
    yield (document * 1000)[:LARGEST]
    yield re.sub(rb"\d+", b"9" * 400, document)
    yield re.sub(rb"\d+", b"9" * 5000, document)[:LARGEST]
    yield re.sub(rb"[A-Za-z]+", "é".encode("latin-1"), document, count=3)


def flip(random: Random, document: bytes) -> bytes:
    changed_bytes = bytearray(document or b"\0")
    for _ in range(random.choice((1, 1, 2, 8))):
        changed_bytes[random.randrange(len(changed_bytes))] ^= 1 << random.randrange(8)
    return bytes(changed_bytes)


def _span(random: Random, document: bytes) -> tuple[int, int]:
    start = random.randrange(len(document) + 1)
    return start, min(len(document), start + random.choice((1, 2, 8, 64)))


def cut(random: Random, document: bytes) -> bytes:
    start, end = _span(random, document)
    return document[:start] + document[end:] if random.random() < 0.8 else document[:start]


def repeated(random: Random, document: bytes) -> bytes:
    start, end = _span(random, document)
    return document[:start] + document[start:end] * random.choice((2, 3, 1000)) + document[end:]


def inserted(random: Random, document: bytes) -> bytes:
    start, _ = _span(random, document)
    return document[:start] + random.choice(LETTERS) * random.choice((1, 1, 1, 50)) + document[start:]


# ---- Of lines --------------------------------------------------------------------------------------------------------


def _special_text(document: bytes) -> Iterator[bytes]:
    first, _, rest = document.partition(b"\n")
    key = re.split(rb"[ =:]", first)[0]
    yield first + b"\n" + b" x\n" * 200_000 + rest
    yield first + b"\\\n" * 40_000 + rest
    yield document + b'\nA="' + b"a\n" * 40_000
    yield document + b"\nA='" + b"a\n" * 40_000
    yield b"a." * 16_000 + b"b = 1\n"
    yield b"[" + b"a." * 16_000 + b"b]\n"
    yield b"a = " + b"[" * 20_000 + b"\n"
    yield b"a = " + b"{b=" * 10_000 + b"\n"
    yield (key + b"\n") * 50_000
    yield b"A=1\n" * 60_000
    for place in [*re.finditer(rb"[ =:\"'/]+", document[:400])][:6]:
        yield document[: place.end()] + b" " * 100_000 + document[place.end() :]
    yield document + b"#" * 300_000
    yield document + b" " * 300_000 + b"x"
    yield document + b"\\" * 100_000 + b"$A"


def line(random: Random, document: bytes) -> bytes:
    lines = document.split(b"\n")
    place = random.randrange(len(lines))
    chosen = lines[place]
    short = chosen[: LARGEST // 1000]
    lines[place : place + 1] = random.choice(
        (
            [],
            [chosen] * 2,
            [short] * 1000,
            [chosen, *[b" " + short] * 1000],
            [chosen[::-1]],
            [chosen.upper()],
            [b" " + chosen],
            [chosen + b" " + chosen],
            [chosen + b"x" * 100_000],
            [chosen, b""],
            [random.choice(lines)],
        )
    )
    return b"\n".join(lines)


def numbers(random: Random, document: bytes) -> bytes:
    matches = list(re.finditer(rb"\d+", document))
    if not matches:
        return document + b"9" * 400
    place = random.choice(matches)
    other = random.choice((b"0", b"-1", b"9" * 20, b"9" * 400, b"9" * 5000, b"1e9", "²".encode(), "٣".encode(), b"x"))
    return document[: place.start()] + other + document[place.end() :]


def words(random: Random, document: bytes) -> bytes:
    matches = list(re.finditer(rb"[^\s=:<>,]+", document))
    if not matches:
        return b"x"
    place, other = random.choice(matches), random.choice(matches)[0]
    new = random.choice((b"", other, b"x" * 1000, b"../..", b"-", b"0", "é".encode("latin-1"), b"null"))
    return document[: place.start()] + new + document[place.end() :]


# ---- Of data ---------------------------------------------------------------------------------------------------------

MARK = "\x00"
LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def _paths(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield path
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in items:
        yield from _paths(value, (*path, key))


def _at(data: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        data = data[key]
    return data


def structure(random: Random, data: Any, odd: tuple[str, ...]) -> str:
    """Data as JSON with one place changed: a value of another type, a key that is missing or there twice, values exchanged."""
    data = json.loads(json.dumps(data, default=str))
    paths = [*_paths(data)]
    path = random.choice(paths)
    if not path:
        return random.choice(odd)
    above, key, token = _at(data, path[:-1]), path[-1], random.choice(odd)
    how = random.choice(("value", "value", "value", "gone", "twice", "key", "other"))
    if how == "gone":
        del above[key]
    elif how == "other":
        above[key] = json.loads(json.dumps(_at(data, random.choice(paths))))
    elif isinstance(above, dict) and how == "twice":
        above[MARK] = above[key]
        token = json.dumps(key)
    elif isinstance(above, dict) and how == "key":
        above[MARK] = above.pop(key)
        token = token if token.startswith('"') else '"unknown"'
    else:
        above[key] = MARK
    return json.dumps(data, ensure_ascii=False).replace(json.dumps(MARK), token)


def of_json(random: Random, document: bytes) -> bytes:
    with contextlib.suppress(ValueError, RecursionError):
        return structure(random, json.loads(document), ODD).encode("utf-8", "surrogatepass")
    return flip(random, document)


def of_yaml(random: Random, document: bytes) -> bytes:
    if len(document) > 100_000 or document.count(b"[") > 300:  # PyYAML's own composer would end the process
        return flip(random, document)
    with contextlib.suppress(yaml.YAMLError, ValueError, TypeError, LookupError, AttributeError, RecursionError):
        return structure(random, yaml.load(document, Loader=LOADER), (*ODD, *ODD_OF_YAML)).encode(
            "utf-8", "surrogatepass"
        )
    return flip(random, document)


def _special_json(document: bytes) -> Iterator[bytes]:
    yield from (b"[" * 100_000, b'{"a":' * 100_000, b"1" * 5000, document * 2, b"[" * 90 + b"]" * 90)
    yield from (token.encode("utf-8", "surrogatepass") for token in ODD[:20])
    for key in (
        json.loads(document) if document.startswith(b"{") else ()
    ):  # each key of the top once, without and as null
        facts = json.loads(document)
        yield json.dumps({name: value for name, value in facts.items() if name != key}).encode()
        yield json.dumps({**facts, key: None}).encode()
        yield json.dumps({**facts, key: {"a": [1]} if isinstance(facts[key], list) else [[]]}).encode()
        # As many items as fit: each of them is wrong, or each has another name.
        if isinstance(facts[key], list):
            yield json.dumps({**facts, key: []}).replace(f'"{key}": []', f'"{key}": [{_MANY}]', 1).encode()
        elif isinstance(facts[key], dict):
            names = ",".join(f'"{number}":0' for number in range(150_000))
            yield json.dumps({**facts, key: {}}).replace(f'"{key}": {{}}', f'"{key}": {{{names}}}', 1).encode()
    yield f"[{_MANY}]".encode()


_MANY = ",".join(["{}"] * 600_000)


def _special_yaml(document: bytes) -> Iterator[bytes]:
    yield from (b"- " * 40_000, b"[" * 40_000, b"{" * 40_000, b"? " * 40_000, b"- [" * 20_000, b"a: &a [*a]\n")
    tens = "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 12))
    yield f"a0: &a0 x\n{tens}".encode()
    yield f"a0: &a0 x\n{tens}".encode() + document
    for token in ODD_OF_YAML:
        yield f"{token}\n".encode()


def _special_xml(document: bytes) -> Iterator[bytes]:
    name = document.decode().partition("?>")[2] or document.decode()
    yield f'<?xml version="1.0" encoding="iso-8859-1"?>{name}'.replace("é", "e").replace("M", "ü").encode("iso-8859-1")
    yield f'<?xml version="1.0" encoding="x-odd"?>{name}'.encode()
    yield f'<?xml version="1.0" encoding="utf-16"?>{name}'.encode()
    yield f'<?xml version="1.0" encoding="utf-7"?>{name}'.encode()
    yield from (
        re.sub(rb'format="\d"', b'format="' + value + b'"', document) for value in (b"4", b"x", b"", b"9" * 5000)
    )
    yield b"<a>" * 40_000
    yield b"<package><name>" + b"<a>" * 100_000
    entities = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 12))
    yield f'<!DOCTYPE p [<!ENTITY a0 "x">{entities}]><package format="2"><name>&a11;</name></package>'.encode()
    yield b'<!DOCTYPE p [<!ENTITY a SYSTEM "file:///etc/passwd">]><package><name>&a;</name></package>'


# ---- Of archives -----------------------------------------------------------------------------------------------------


def tar_of(*members: tuple[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with gzip.GzipFile(fileobj=buffer, mode="wb", mtime=0) as stream, tarfile.open(fileobj=stream, mode="w") as tar:
        for name, content in members:
            member = tarfile.TarInfo(name)
            member.size = len(content)
            tar.addfile(member, io.BytesIO(content))
    return buffer.getvalue()


def _special_tar(document: bytes) -> Iterator[bytes]:
    inner = gzip.decompress(document)
    yield inner
    yield gzip.compress(b"", mtime=0)
    yield gzip.compress(inner[:700], mtime=0)
    yield document[:-9]
    for size in (b"77777777777\0", b"\x80" + b"\xff" * 11, b"\xff" * 12, b"-0000000001\0", b"x" * 12):
        yield gzip.compress(_checked(inner[:124] + size + inner[136:]), mtime=0)
    for kind in b"12345678xgLKSDMNV":
        yield gzip.compress(_checked(inner[:156] + bytes([kind]) + inner[157:]), mtime=0)
    yield tar_of(("a/" * 20_000 + "b", b"x"))
    yield tar_of(("../x", b"x"), ("/x", b"x"), ("x/../../y", b"x"), ("rosdep/a.yaml", b"x"), ("rosdep/a.yaml/b", b"x"))
    for text in (
        "99999 size=9\n",
        "12 size=-1\n\n",
        "x size=1\n",
        f"30 GNU.sparse.size={'9' * 400}\n",
        "18 path=a\0b\n\n\n\n\n",
    ):
        yield gzip.compress(_pax(text.encode()) + inner, mtime=0)
    for text in ("1" * 500_000, "2 " * 400_000 + "="):  # tarfile would look at it for an hour
        yield gzip.compress(_pax(text.encode()) + inner, mtime=0)
    yield bomb(64)
    member = tarfile.TarInfo("rosdep/base.yaml")
    member.size = 256 << 20
    yield bomb(257, member.tobuf())


def bomb(mebibytes: int, first: bytes = b"") -> bytes:
    """A gzip file of zeros, perhaps behind something else. One block is compressed, and repeated."""
    zeros = bytes(1 << 20)
    packer, check = zlib.compressobj(wbits=-zlib.MAX_WBITS), zlib.crc32(first)
    head = packer.compress(first) + packer.flush(zlib.Z_FULL_FLUSH)
    block = packer.compress(zeros) + packer.flush(zlib.Z_FULL_FLUSH)
    for _ in range(mebibytes):
        check = zlib.crc32(zeros, check)
    end = struct.pack("<II", check, len(first) + mebibytes * len(zeros))
    return b"\x1f\x8b\x08" + bytes(6) + b"\xff" + head + block * mebibytes + packer.flush() + end


def _checked(header: bytes) -> bytes:
    """The same with the checksum of its first block."""
    total = sum(header[:148]) + 8 * 32 + sum(header[156:512])
    return header[:148] + b"%06o\0 " % total + header[156:]


def _pax(text: bytes) -> bytes:
    member = tarfile.TarInfo("pax")
    member.type, member.size = tarfile.XHDTYPE, len(text)
    return member.tobuf(tarfile.USTAR_FORMAT) + text + b"\0" * (-len(text) % 512)


def of_tar(random: Random, document: bytes) -> bytes:
    try:
        inner = gzip.decompress(document)
    except (OSError, EOFError, ValueError, zlib.error):
        return flip(random, document)
    return gzip.compress(random.choice(BYTES)(random, inner)[:LARGEST], mtime=0)


BYTES: tuple[Mutation, ...] = (flip, cut, repeated, inserted)
TEXT: tuple[Mutation, ...] = (*BYTES, line, line, numbers, words, words)
KINDS: dict[str, tuple[Mutation, ...]] = {
    "json": (*BYTES, numbers, *[of_json] * 8),
    "yaml": (*TEXT, *[of_yaml] * 8),
    "xml": TEXT,
    "text": TEXT,
    "tar": (*BYTES, *[of_tar] * 4),
}
SPECIAL: dict[str, Callable[[bytes], Iterator[bytes]]] = {
    "json": _special_json,
    "yaml": _special_yaml,
    "xml": _special_xml,
    "text": _special_text,
    "tar": _special_tar,
}
