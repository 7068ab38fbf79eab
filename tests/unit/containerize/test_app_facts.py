"""Facts of images that say whether an app can move to another base: read from real programs, and from damaged ones."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import time
from collections.abc import Mapping
from pathlib import Path
from random import Random
from types import ModuleType

import pytest

from fakes.stubs import script_of_a_build
from rosml.images.join import facts

COMPILER = pytest.mark.skipif(not shutil.which("gcc"), reason="there is no compiler")

SOURCES = {
    "a": 'int plain(void){return 1;} __attribute__((visibility("hidden"))) int inner(void){return 1;}'
    ' __attribute__((visibility("protected"))) int kept(void){return 1;} __attribute__((weak)) int soft(void){return 1;}'
    " int old(void){return 1;} int new(void){return 2;}"
    ' __asm__(".symver old,versioned@A_1"); __asm__(".symver new,versioned@@A_2");',
    "b": "#include <stdlib.h>\nint plain(void); int versioned(void); __attribute__((weak)) int optional(void);"
    ' int b(void){return plain() + versioned() + (optional ? optional() : 0) + atoi("1");}',
    "program": "int b(void); int main(void){return b();}",
    "silent": "int b(void); static __attribute__((constructor)) void f(void){b();}",
}
"""Of four files: `program` uses b, and b uses a. `silent` exports nothing, so its table of hashes does not count its symbols."""


@pytest.fixture(scope="module")
def elf() -> ModuleType:
    return script_of_a_build("containerize/elf.py")


@pytest.fixture(scope="module")
def script() -> ModuleType:
    return script_of_a_build("containerize/facts.py")


def build(folder: Path, style: str = "gnu") -> Path:
    """Makes `liba.so.1`, `libb.so`, `program` and `silent.so`, with tables of hashes in a style."""
    for name, text in SOURCES.items():
        (folder / f"{name}.c").write_text(text)
    (folder / "versions").write_text("A_1 { global: *; }; A_2 { } A_1;")
    hashes = f"-Wl,--hash-style={style}"
    versions = "-Wl,-soname,liba.so.1,--version-script=versions"
    run(folder, "-shared", "-fPIC", "-o", "liba.so.1", "a.c", versions, hashes)
    run(folder, "-shared", "-fPIC", "-o", "libb.so", "b.c", "liba.so.1", hashes)
    run(folder, "-o", "program", "program.c", "libb.so", "-Wl,--allow-shlib-undefined", hashes)
    run(folder, "-nostdlib", "-shared", "-fPIC", "-o", "silent.so", "silent.c", "libb.so", hashes)
    return folder


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp("built"))


def run(folder: Path, *arguments: str) -> None:
    subprocess.run(["gcc", *arguments], cwd=folder, check=True)


# ---- ELF -------------------------------------------------------------------------------------------------------------


@COMPILER
@pytest.mark.parametrize("style", ["gnu", "sysv", "both"])
@pytest.mark.parametrize("sections", [True, False])
def test_symbols_of_real_files(style: str, sections: bool, elf: ModuleType, tmp_path: Path) -> None:
    """With either table of hashes, and without sections, which the loader does not read."""
    build(tmp_path, style)
    if not sections:
        for name in ("liba.so.1", "libb.so", "program", "silent.so"):
            data = bytearray((tmp_path / name).read_bytes())
            data[0x28:0x30], data[0x3A:0x40] = bytes(8), bytes(6)
            (tmp_path / name).write_bytes(data)
    exports = elf.symbols(tmp_path / "liba.so.1").exports
    names = {b"plain", b"kept", b"soft", b"versioned"}
    versions = {b"plain@A_1", b"kept@A_1", b"soft@A_1", b"versioned@A_1", b"versioned@A_2"}
    assert {name for name in exports if not name.startswith((b"old", b"new"))} == names | versions
    assert elf.elf(tmp_path / "liba.so.1").soname == "liba.so.1"
    used = elf.symbols(tmp_path / "libb.so")
    assert {b"plain@A_1", b"versioned@A_2"} <= used.uses and b"b" in used.exports
    assert [name for name in used.uses if name.startswith(b"atoi@GLIBC")]
    assert not [name for name in used.uses if name.startswith((b"optional", b"__cxa_finalize"))]
    assert b"b" in elf.symbols(tmp_path / "program").uses
    assert elf.symbols(tmp_path / "silent.so") == (set(), {b"b"})


@COMPILER
def test_damaged_files_are_none_and_take_no_time(elf: ModuleType, built: Path, tmp_path: Path) -> None:
    random, whole = Random(1), (built / "liba.so.1").read_bytes()
    started = time.process_time()
    for number in range(600):
        data = bytearray(whole)
        for _ in range(random.choice((1, 4, 40))):
            # Most of it in headers and tables, which come first.
            place = random.randrange(random.choice((64, 1024, len(data))))
            data[place] = random.choice((0, 1, 0x7F, 0x80, 0xFF, random.randrange(256)))
        (tmp_path / "x").write_bytes(data[: random.choice((len(data), random.randrange(len(data))))])
        for facts_of_file in (elf.elf(tmp_path / "x"), elf.symbols(tmp_path / "x")):
            assert facts_of_file is None or len(facts_of_file) in (2, 4), number
    assert time.process_time() - started < 30


def hostile(tags: dict[int, int], content: bytes) -> bytes:
    """A library of one segment, which is loaded at 0, and whose tables `tags` names."""
    start = 64 + 2 * 56
    dynamic = b"".join(struct.pack("<qQ", *tag) for tag in [*tags.items(), (0, 0)])
    length = start + len(dynamic) + len(content)
    head = b"\x7fELF\x02\x01\x01" + bytes(9) + struct.pack("<HHIQQQIHHHHHH", 3, 62, 1, 0, 64, 0, 0, 64, 56, 2, 0, 0, 0)
    head += struct.pack("<IIQQQQQQ", 1, 0, 0, 0, 0, length, length, 1)
    head += struct.pack("<IIQQQQQQ", 2, 0, start, start, 0, len(dynamic), len(dynamic), 1)
    return head + dynamic + content


SYMTAB, STRTAB, STRSZ, HASH, GNU_HASH = 6, 5, 10, 4, 0x6FFFFEF5
VERSYM, VERDEF, VERDEFNUM, VERNEED, VERNEEDNUM = 0x6FFFFFF0, 0x6FFFFFFC, 0x6FFFFFFD, 0x6FFFFFFE, 0x6FFFFFFF


def tables(tags: dict[int, int], **at: bytes) -> bytes:
    """A library with contents at places; `x2048=…` stands at 2048."""
    base = hostile(tags, b"")
    end = max(int(name[1:]) + len(data) for name, data in at.items())
    whole = bytearray(hostile(tags, bytes(end - len(base))))
    for name, data in at.items():
        place = int(name[1:])
        whole[place : place + len(data)] = data
    return bytes(whole)


LONG = 1 << 20
PLAIN = {SYMTAB: 1024, STRTAB: 2048, STRSZ: 8}
SYMBOL = struct.pack("<IBBHQQ", 1, 0x10, 0, 1, 0, 0)
HOSTILE = {
    "as many symbols as a number holds": tables({**PLAIN, HASH: 4096}, x1024=SYMBOL, x4096=struct.pack("<II", 1, 0xFFFFFFFF)),
    "names that are long and shared": tables(
        {SYMTAB: 1 << 20, STRTAB: 2048, STRSZ: 60_000, HASH: 1024},
        x1024=struct.pack("<II", 1, 80_000),
        x2048=b"\0" + b"x" * 59_998 + b"\0",
        x1048576=SYMBOL * 80_000,
    ),
    "a name without an end": tables(
        {SYMTAB: 1024, STRTAB: 2048, STRSZ: LONG, HASH: 1536},
        x1536=struct.pack("<II", 1, 1),
        x1024=SYMBOL,
        x2048=b"x" * 9,
    ),
    "a hash table without an end": tables({**PLAIN, GNU_HASH: 4096}, x1024=SYMBOL, x4096=struct.pack("<IIIIQI", 1, 1, 1, 0, 0, 1) + bytes(LONG)),
    "a hash table of all memory": tables({**PLAIN, GNU_HASH: 4096}, x1024=SYMBOL, x4096=struct.pack("<IIII", 0xFFFFFFFF, 1, 0xFFFFFFFF, 0)),
    "versions that stand in each other": tables(
        {SYMTAB: 1024, STRTAB: 2048, STRSZ: 32, HASH: 1536, VERSYM: 1600, VERNEED: 4096, VERNEEDNUM: 1 << 40},
        x1024=SYMBOL * 2,
        x1536=struct.pack("<II", 1, 2),
        # Each of these is a library that expects 28,672 versions, and one of the versions that those before it expect.
        x4096=struct.pack("<HHIII", 1, 0x7000, 2 << 16, 16, 16) * (1 << 16),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_a_file_that_was_made_to_take_long(name: str, elf: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "x.so").write_bytes(HOSTILE[name])
    started = time.process_time()
    symbols = elf.symbols(tmp_path / "x.so")
    assert time.process_time() - started < 2
    assert elf.elf(tmp_path / "x.so") and (symbols is None or not symbols.exports)


def test_what_is_no_program(elf: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("/bin/sh")
    (tmp_path / "text").write_text("#!/bin/sh\n")
    (tmp_path / "head").write_bytes(b"\x7fELF\x02\x01")
    for path in (tmp_path / "link", tmp_path / "text", tmp_path / "head", tmp_path, tmp_path / "none"):
        assert elf.elf(path) is None and elf.symbols(path) is None


# ---- What is written -------------------------------------------------------------------------------------------------

STATUS = """\
Package: liba1
Status: install ok installed
Architecture: amd64
Version: 1.0
Provides: a-virtual (= 1)
Pre-Depends: dpkg (>= 1.15)
Depends: libc6 (>= 2.34),
 python3:any | other
Conflicts: old
Breaks: older (<< 2)
Description: x
 Depends: nothing

Package: half
Status: deinstall ok config-files
Architecture: amd64
Version: 1
"""


def put(root: Path, files: Mapping[str, str | Path]) -> Path:
    """Writes texts below a root, and copies files there."""
    for name, content in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, Path):
            shutil.copy(content, root / name)
        else:
            (root / name).write_text(content)
    return root


@COMPILER
def test_facts_of_a_base(script: ModuleType, built: Path, tmp_path: Path) -> None:
    """Its packages and libraries. No programs, no extensions of Python; the same bytes each time."""
    folder = "usr/lib/x86_64-linux-gnu"
    (tmp_path / "m.c").write_text("int PyInit_m(void){return 1;}")
    run(tmp_path, "-shared", "-fPIC", "-o", "m.so", "m.c")
    (tmp_path / "torn.so").write_bytes((built / "libb.so").read_bytes()[:2000])
    root = put(
        tmp_path / "root",
        {
            "var/lib/dpkg/status": STATUS,
            "usr/bin/program": built / "program",
            "usr/bin/python3.11": built / "libb.so",  # as much of Python as exports something
            f"{folder}/liba.so.1.0": built / "liba.so.1",
            f"{folder}/m.so": tmp_path / "m.so",
            f"{folder}/torn.so": tmp_path / "torn.so",
        },
    )
    (root / "lib").symlink_to("usr/lib")
    links = {"liba.so.1": "liba.so.1.0", "liba.so": "/lib/x86_64-linux-gnu/liba.so.1", "loop.so": "loop.so"}
    for name, target in links.items():
        (root / folder / name).symlink_to(target)
    script.write_base(root, tmp_path)
    first = (tmp_path / "facts.gz").read_bytes()
    script.write_base(root, tmp_path)
    assert (tmp_path / "facts.gz").read_bytes() == first
    base = facts.parse(first)
    [package] = base.packages
    assert (package.name, package.architecture, package.version) == ("liba1", "amd64", "1.0")
    assert package.provides == "a-virtual (= 1)" and package.conflicts == "old, older (<< 2)"
    assert package.depends == "dpkg (>= 1.15), libc6 (>= 2.34), python3:any | other"
    libraries = {"usr/bin/python3.11": [], "usr/lib/x86_64-linux-gnu/liba.so.1.0": ["liba.so"]}
    assert {item.path: item.names for item in base.libraries} == libraries
    library = base.libraries[1]
    assert library.soname == "liba.so.1" and library.machine[:2] == [2, 1] and not library.uses
    assert facts.exports(library, "plain") and facts.exports(library, "versioned@A_1")
    assert not facts.exports(library, "inner") and not facts.exports(library, "plain@A_2")
    assert facts.lacking(["plain", "inner", "b", "versioned@A_2"], base.libraries) == ["inner"]
    assert facts.lacking(["plain", "b"], base.libraries[:1]) == ["plain"]


@COMPILER
def test_facts_of_an_app(script: ModuleType, built: Path, tmp_path: Path) -> None:
    """What it has itself it does not ask of a base. Each file belongs to one package, or to none."""
    install = "docker-ros/ws/install"
    layer = put(
        tmp_path / "layer",
        {
            f"{install}/program": built / "program",
            f"{install}/libb.so": built / "libb.so",
            os.fsdecode(install.encode() + b"/M\xfcller"): "x",
            "etc/motd": "x",
            "usr/lib/data": "x",
            "usr/share/doc/liba1/copyright": "x",
            "var/lib/dpkg/status.d/liba1": STATUS.partition("\n\n")[0] + "\n",
        },
    )
    (layer / install / "link").symlink_to("program")
    lines = "/.\n/lib\n/lib/data\n/usr/share/doc/liba1/copyright\n/usr/share/not/there\n"
    runtime = put(tmp_path / "runtime", {"var/lib/dpkg/info/liba1:amd64.list": lines})
    script.write_app(layer, runtime, tmp_path, {"torch": "lib/a/b.py"}, ["python3-tabulate"], ["numpy"])
    app = facts.parse((tmp_path / "facts.gz").read_bytes())
    [package] = app.packages
    assert package.files == ["usr/lib/data", "usr/share/doc/liba1/copyright", "var/lib/dpkg/status.d/liba1"]
    assert app.imports == [facts.Import(module="torch", file="lib/a/b.py")] and app.asks == ["python3-tabulate"]
    assert app.asks_pip == ["numpy"]
    names = (r"M\udcfcller", "libb.so", "link", "program")
    assert app.files == [*(f"{install}/{name}" for name in names), "etc/motd"]
    by_name = {item.path.rpartition("/")[2]: item for item in app.libraries}
    assert {*by_name} == {"program", "libb.so"}
    assert {"plain@A_1", "versioned@A_2"} <= {*by_name["libb.so"].uses}
    assert "b" not in by_name["program"].uses, "the app has it"
    assert by_name["libb.so"].needed[0] == "liba.so.1"


@pytest.mark.parametrize("version", ["1.0", "1.1"])
def test_an_app_that_replaces_packages_of_its_base_has_no_facts(
    version: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is no layer on its base, and no layer for another one. Else, what it asked pip for and its base has is a fact."""
    script, status = script_of_a_build("containerize/app_files.py"), "var/lib/dpkg/status"
    sites = "usr/lib/python3/dist-packages"
    python = {
        **{f"{sites}/{name}.dist-info/METADATA": "" for name in ("NumPy-1.26.4", "click-8", "colorama-1", "six-1")},
        f"{sites}/typing_extensions.egg-info": "",
        f"{sites}/x": "",
        "docker-ros/more.txt": "-r less.txt\n",
        "docker-ros/less.txt": "click\n",
    }
    lists = {
        "requests/pip": "--no-deps\nnumpy[all] < 2 # why\ntyping-extensions\nx\nmissing==1\n-r /docker-ros/more.txt\n"
    }
    brought = {
        "usr/local/lib/python3.11/dist-packages/own-1.dist-info/METADATA": (
            "Name: own\nRequires-Dist: Colorama (>=1)\nRequires-Dist: six; extra == 'all'\n\nRequires-Dist: numpy\n"
        )
    }
    monkeypatch.setattr(script, "ASKED", put(tmp_path / "lists", lists))
    base = put(tmp_path / "base", {status: STATUS, **python})
    new = STATUS.replace("1.0", version) + STATUS.replace("liba1", "libnew")
    runtime = put(
        tmp_path / "runtime",
        {status: new, "usr/lib/new": "x", "var/lib/dpkg/info/libnew.list": "/usr/lib/new\n", **python, **brought},
    )
    built = put(tmp_path / "built", {status: new, "docker-ros/ws/install/setup.sh": "x"})
    script.main(base, runtime, runtime, built, tmp_path / "nothing", tmp_path / "out")
    if version != "1.0":
        assert not (tmp_path / "out/facts.gz").exists()
        return
    app = facts.parse((tmp_path / "out/facts.gz").read_bytes())
    assert [item.files for item in app.packages] == [["usr/lib/new", "var/lib/dpkg/status.d/libnew"]]
    assert app.files == ["docker-ros/ws/install/setup.sh", *brought]
    assert app.asks_pip == ["click", "colorama", "numpy", "typing-extensions"]


def test_what_packages_install_outside_of_the_workspace_is_named(tmp_path: Path) -> None:
    names = ("opt/a", "usr/lib/x", "var/cache/x")
    before = put(tmp_path / "before", dict.fromkeys(names, ""))
    of_builds = ("docker-ros/ws/build/x", "usr/lib/__pycache__/x.pyc", "var/cache/y")
    after = put(tmp_path / "after", dict.fromkeys((*names, *of_builds, "opt/b"), ""))
    assert script_of_a_build("containerize/app_files.py").outside(before, after) == ["opt/b"]
