#!/usr/bin/env python3
"""`pip install` does what users expect, on a system whose Python is externally managed as well.

Nothing is downloaded: the packages are made here, newer than anything that exists.

- `pip install -U numpy` stays within the range that ROS's packages were compiled for, and so does what asks for numpy;
  nor does anything bring an empy or setuptools that ROS's tools do not work with;
- a package that needs torch or tensorflow takes the one that is there, and `-U` leaves frameworks, CUDA and what they were
  compiled with as they are; other packages of the parts move as far as the parts ask for them, and `pip check` stays content;
- what contradicts that, or what the index lacks, is refused with pip's reason, and nothing is half-installed;
- a user, an environment of one's own and `--target` keep to the same; `unpinned` lets them have another release;
- a new version of a Debian package goes beside it, into /usr/local, and uninstalling it brings Debian's back; a newer
  pip refuses that and says who installed it, unless it is told to ignore what is there;
- pip asks the index for metadata, and downloads no wheel to see whether it fits: from 23.2 on it does;
- everything is gone afterwards: nothing of it is part of the image.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.version import Version

FOLDER = Path(tempfile.mkdtemp())
FOLDER.chmod(0o755)
FAR = "9999.0"
"""Newer than packages whose versions begin with a year."""
CONSTRAINTS = Path("/usr/local/share/rosml/constraints.txt")


def wheel(name: str, version: str, requires: Sequence[str] = ()) -> None:
    """Makes a wheel of one module that knows its version."""
    info = f"{name}-{version}.dist-info"
    metadata = "".join(f"Requires-Dist: {requirement}\n" for requirement in requires)
    files = {
        f"{name}.py": f"__version__ = {version!r}\n",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n{metadata}",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    record = "".join(f"{path},,\n" for path in [*files, f"{info}/RECORD"])
    with zipfile.ZipFile(FOLDER / f"{name}-{version}-py3-none-any.whl", "w") as archive:
        for path, content in {**files, f"{info}/RECORD": record}.items():
            archive.writestr(path, content)


def pip(*arguments: str, expect: int = 0, by: Sequence[str] = (sys.executable,)) -> str:
    """Runs the pip of a Python, which must end with an exit code; returns what it said."""
    command = [*by, "-m", "pip", *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd="/")
    if done.returncode != expect:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


OFFLINE = ("install", "--no-index", "--find-links", str(FOLDER), "--no-cache-dir")
INSTALL = (sys.executable, "-m", "pip", *OFFLINE)


def install(*arguments: str, expect: int = 0, by: Sequence[str] = (sys.executable,)) -> str:
    return pip(*OFFLINE, *arguments, expect=expect, by=by)


def versions(by: Sequence[str] = (sys.executable,)) -> dict[str, str]:
    """All packages that a Python finds, the ones that shadow others, with their versions."""
    code = (
        "import importlib.metadata as m, json\n"
        "versions_by_name = {}\n"
        "for d in m.distributions(): versions_by_name.setdefault((d.metadata['Name'] or '').lower(), d.version)\n"
        "print(json.dumps(versions_by_name))"
    )
    return dict(json.loads(subprocess.run([*by, "-c", code], stdout=subprocess.PIPE, check=True).stdout))


LINES = [line for slot in CONSTRAINTS.parent.glob("constraints.d/[0-9]*.txt") for line in slot.read_text().splitlines()]


def pinned() -> dict[str, str]:
    """What keeps its version, by the slots of the image's parts."""
    matches = (re.fullmatch(r"([a-z0-9-]+)==([^;]+)", line) for line in LINES)
    return {match[1]: match[2] for match in matches if match}


def movable() -> dict[str, bool]:
    """All else that the parts hold, and whether it may go as far as there is anything."""
    held = {
        line.split()[0] for file in CONSTRAINTS.parent.glob("versions.d/*") for line in file.read_text().splitlines()
    }
    names = (held & {re.sub(r"[-_.]+", "-", name) for name in versions()}) - pins.keys()
    bounds_by_name = {name: SpecifierSet() for name in names}
    for requirement in map(Requirement, filter(lambda line: line[:1] not in ("", "#"), LINES)):
        if requirement.name in bounds_by_name and (requirement.marker is None or requirement.marker.evaluate()):
            bounds_by_name[requirement.name] &= requirement.specifier
    return {name: FAR in bounds for name, bounds in bounds_by_name.items()}


def checked(by: Sequence[str]) -> str:
    """What `pip check` says of a Python's packages."""
    return subprocess.run([*by, "-m", "pip", "check"], stdout=subprocess.PIPE, text=True).stdout


pip_version = pip("--version").split()[1]
assert Version(pip_version) >= Version("23.2"), pip_version
before = versions()
pins = pinned()
leaves = movable()
for name in {"numpy", "cffi", "torch", "tensorflow", "empy", "setuptools", *pins, *leaves}:
    wheel(name.replace("-", "_"), FAR)
# The newest numpy that could be within the range, where there is none yet.
if "numpy" not in before:
    *start, last = re.findall("numpy.*<([0-9.]+)", CONSTRAINTS.read_text())[0].split(".")
    wheel("numpy", ".".join([*start, str(int(last) - 1), "999"]))
releases = os.environ.get("EXPECT_RELEASES", "").split(",")
modules = [name.replace("-", "_") for name in releases if name]  # as files of wheels spell names
carried = [name for name in modules if f"EXPECT_{name.upper()}" in os.environ]
wheel("wantsframeworks", "1.0", ["numpy", *carried])
too_far = {"numpy": "3", "empy": "4"}
if int(before["setuptools"].split(".")[0]) < 80:  # Ubuntu 26.04 has a newer one itself
    too_far["setuptools"] = "80"
for name, version in too_far.items():
    wheel(f"wantsfar{name}", "1.0", [f"{name}>={version}"])

# numpy stays within the range, and frameworks that are there are enough.
install("--upgrade", "numpy", "wantsframeworks")
present = versions()
numpy = present.pop("numpy")
assert numpy == before.get("numpy", numpy) != FAR, numpy
expected = {**before, "wantsframeworks": "1.0"}
expected.pop("numpy", None)
assert present == expected, set(present.items()) ^ set(expected.items())
pip("uninstall", "--yes", "wantsframeworks", *([] if "numpy" in before else ["numpy"]))

REASON = re.compile(r"conflict|No matching distribution")

for name in too_far:
    output = install(f"wantsfar{name}", expect=1)
    assert REASON.search(output), output

# Frameworks and what they were compiled with stay, whatever asks for something else; what fits neither is refused as a whole.
install("--upgrade", *pins, "wantsframeworks")
assert versions() == {**before, "wantsframeworks": "1.0", "numpy": numpy}
pip("uninstall", "--yes", "wantsframeworks", *([] if "numpy" in before else ["numpy"]))
wheel("wantslacking", "1.0", [*carried, "lacking"])
for name in carried:
    wheel(f"wantsfar{name}", "1.0", [f"{name}>={FAR}", "wantslacking"])
for name in [*(f"wantsfar{name}" for name in carried), "wantslacking"]:
    output = install(name, expect=1)
    assert REASON.search(output), output
assert versions() == before

# The index has these releases as well now: for who is not shown the image's own.
for name in carried:
    wheel(name, before[name])
if "numpy" in before:
    wheel("numpy", before["numpy"])
carried_versions = {name: before[name] for name in carried}


def of_a_user() -> None:
    """A user without rights in /usr/local."""
    home = FOLDER / "home"
    home.mkdir()
    os.chown(home, 4711, 4711)
    user = ("gosu", "4711:4711", "env", f"HOME={home}", sys.executable)
    for options in ([], ["--user"]):
        install(*options, "--upgrade", "wantsframeworks", *carried, by=user)
        present = versions(user)
        assert present == {**before, "wantsframeworks": "1.0", "numpy": numpy}, set(present.items()) ^ set(
            before.items()
        )
        shutil.rmtree(home / ".local")


def in_a_folder() -> None:
    install("--target", str(FOLDER / "target"), "wantsframeworks")
    installed = {path.name for path in (FOLDER / "target").glob("*.dist-info")}
    assert installed == {f"{name}-{carried_versions[name]}.dist-info" for name in carried} | {
        "wantsframeworks-1.0.dist-info",
        f"numpy-{numpy}.dist-info",
    }, installed


def in_an_environment(option: str) -> None:
    """One that sees the image's packages takes them, one that does not gets the same releases; either may have others."""
    environment = FOLDER / option.strip("-")
    subprocess.run([sys.executable, "-m", "venv", option, environment], check=True)
    inside = (str(environment / "bin/python"),)
    install("wantsframeworks", by=inside)
    present = versions(inside)
    assert {name: present[name] for name in (*carried, "numpy")} == {**carried_versions, "numpy": numpy}, present
    if leaves and option == "--system-site-packages":
        complaints = checked(inside)
        install("--upgrade", *leaves, by=inside)
        now: dict[str, str] = {}
        for name, version in versions(inside).items():
            now.setdefault(re.sub(r"[-_.]+", "-", name), version)
        moved = {name: now[name] == FAR for name in leaves}
        assert moved == leaves, set(moved.items()) ^ set(leaves.items())
        assert checked(inside) == complaints, checked(inside)
        pip("uninstall", "--yes", *(name for name, far in leaves.items() if far), by=inside)
    shown = [path.name for name in carried for path in environment.glob(f"lib/python3*/site-packages/{name}-*")]
    assert bool(shown) == (bool(carried) and option == "--clear"), shown
    for name in ("numpy", *carried):
        output = install(f"wantsfar{name}", expect=1, by=inside)
        assert REASON.search(output), output
    for name in carried:
        install("--upgrade", name, by=("unpinned", *inside))
        assert versions(inside)[name] == FAR


# Side by side: each has its own place, and the image's packages stay as they are meanwhile.
with ThreadPoolExecutor() as pool:
    beside = [pool.submit(of_a_user), pool.submit(in_a_folder)]
    beside += [pool.submit(in_an_environment, option) for option in ("--system-site-packages", "--clear")]
    for work in beside:
        work.result()
assert versions() == before

# Debian's cffi has no RECORD, by which pip could remove it.
refused = subprocess.run([*INSTALL, "--upgrade", "cffi"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
if refused.returncode != 0:
    assert re.search(r"installed by debian", refused.stdout), refused.stdout
    install("--ignore-installed", "cffi")
assert versions() == {**before, "cffi": FAR}
pip("uninstall", "--yes", "cffi")
assert versions() == before
leftovers = [path for path in (Path.home() / ".cache/pip", Path.home() / ".config/pip") if path.exists()]
assert not leftovers, leftovers
