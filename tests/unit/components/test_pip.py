"""The pip of images whose distribution has an old one: real pip installs a small wheel of its name, by the script itself."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path

import pytest
from conftest import ROOT

from offline.assembler import interpreter

CHECKED_HASH = 3
"""The flags of bytecode (PEP 552) that is good as long as its source has the same content, whatever its time."""

MISC = """\
def is_local(path):
    if not path:
        return True
        return True
    return False


def after():
    pass
"""
CODE = {
    "__init__.py": "",
    "never_imported.py": "def known(name):\n    return name in {'a', 'b', 'c', 'd', 'e', 'f', 'g'}\n",
    "_internal/__init__.py": "",
    "_internal/utils/__init__.py": "",
    "_internal/utils/misc.py": MISC,
}
INFO = {
    "METADATA": "Metadata-Version: 2.1\nName: pip\nVersion: 99\n",
    "WHEEL": "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
}

PROGRAMS = {
    "dpkg": "exit 1",  # not as new as asked for
    "dpkg-query": "echo 23.0.1",
    "dpkg-divert": "",
    "python3": """\
if [[ "$*" == "-m pip download "* ]]; then
  while [[ $1 != --dest ]]; do shift; done
  exec cp {wheel} "$2"
fi
exec {system}/usr/local/bin/python3 "$@"
""",
}


class Distribution:
    """A folder that stands for an image's root, with a pip of its own below /usr/local, and the script for it."""

    def __init__(self, folder: Path, python: str) -> None:
        self.folder, self.root = folder, folder / "root"
        self.wheel = folder / "pip-99-py3-none-any.whl"
        self.pristine = folder / "pristine"
        subprocess.run([python, "-m", "venv", str(self.root / "usr/local")], check=True)
        (self.root / "usr/share/python-wheels").mkdir(parents=True)
        self.root.rename(self.pristine)
        texts = {f"pip/{name}": text for name, text in CODE.items()}
        texts |= {f"pip-99.dist-info/{name}": text for name, text in INFO.items()}
        texts["pip-99.dist-info/RECORD"] = "".join(
            f"{name},sha256=x,1\n" for name in (*texts, "pip-99.dist-info/RECORD")
        )
        with zipfile.ZipFile(self.wheel, "w") as file:
            for name, text in texts.items():
                file.writestr(name, text)
        self.programs = folder / "programs"
        self.programs.mkdir()
        for name, text in PROGRAMS.items():
            program = self.programs / name
            text = text.replace("{wheel}", str(self.wheel)).replace("{system}", str(self.root))
            program.write_text(f"#!/bin/bash\n{text}")
            program.chmod(0o755)
        base = folder / "components/base"
        shutil.copytree(ROOT / "components/build", base.with_name("build"))
        base.mkdir()
        self.script = base / "pip.sh"
        self.script.write_text((ROOT / "components/base/pip.sh").read_text().replace("/usr/", f"{self.root}/usr/"))
        digest = hashlib.sha256(self.wheel.read_bytes()).hexdigest()
        (base / "pip.txt").write_text(f"pip==99 --hash=sha256:{digest}\n")

    def built(self, seed: str = "1") -> Mapping[str, bytes]:
        """Runs the script on a fresh root; returns the content of each file of the new pip by its name.

        Args:
            seed: of Python's hashes, which is another one in each build.
        """
        shutil.rmtree(self.root, ignore_errors=True)
        shutil.copytree(self.pristine, self.root, symlinks=True)
        path = f"{self.programs}:{os.environ['PATH']}"
        env = {"PATH": path, "HOME": str(self.folder), "PIP_CONFIG_FILE": os.devnull, "PYTHONHASHSEED": seed}
        done = subprocess.run(["bash", str(self.script)], env=env, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        (site,) = (self.root / "usr/local/lib").glob("python3*/site-packages")
        files = [file for folder in site.glob("pip*") for file in folder.rglob("*") if file.is_file()]
        return {str(file.relative_to(site)): file.read_bytes() for file in files}


@pytest.fixture(scope="module", params=["", "3.8"])
def distribution(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Distribution:
    """With the Python of these tests, and with the oldest one whose distribution gets this pip."""
    _, home = interpreter(request.param) if request.param else ("", None)
    if request.param and home is None:
        pytest.skip("no Python as old as the oldest one of the matrix is here, nor can it be downloaded")
    python = f"{home}/bin/python{request.param}" if home else sys.executable
    return Distribution(tmp_path_factory.mktemp("distribution"), python)


def test_each_build_has_the_same_pip(distribution: Distribution) -> None:
    """The folder that it was downloaded to is another one each time, and so is the time."""
    first, second = distribution.built("1"), distribution.built("2")
    assert {name for name in first.keys() | second.keys() if first.get(name) != second.get(name)} == set()
    compiled = {name: content for name, content in second.items() if name.endswith(".pyc")}
    assert len(compiled) == len(CODE), "each file has its bytecode"
    times = {name for name, content in compiled.items() if int.from_bytes(content[4:8], "little") != CHECKED_HASH}
    assert not times, "bytecode that depends on the time of its source"


def test_what_is_on_record_of_pip(distribution: Distribution) -> None:
    """Each file, and no more; the one that was changed has no digest."""
    files = distribution.built()
    record = files["pip-99.dist-info/RECORD"].decode().splitlines()
    assert {line.partition(",")[0] for line in record} == {name for name in files if not name.endswith(".pyc")}
    assert "pip/_internal/utils/misc.py,," in record
    assert b"/usr/lib/python3/" in files["pip/_internal/utils/misc.py"]
