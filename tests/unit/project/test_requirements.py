"""The Python packages of the commands, of the tests and of the page's tests: each file has all of them, by hash, and nothing
else is installed."""

from __future__ import annotations

import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable
from tests.bare import Bootstrap

FILES = ("app", "build", "dev", "page")


def requirements(name: str) -> str:
    return (ROOT / f"tools/requirements-{name}.txt").read_text()


def check(root: Path) -> subprocess.CompletedProcess[str]:
    argv = [sys.executable, str(root / "scripts/requirements.py"), "--check"]
    return subprocess.run(argv, capture_output=True, text=True, check=False)


def test_they_are_current() -> None:
    done = check(ROOT)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    ("text", "replacement", "stale"),
    [
        ('"click==', '"clock==', {"app", "build", "dev", "page"}),
        ('"pytest==', '"pytest>=', {"dev", "page"}),
        ('"zensical==', '"zensicol==', {"dev", "page"}),
        ('"playwright==', '"playwrong==', {"page"}),
        ("line-length = 120", "line-length = 121", set()),
    ],
)
def test_a_change_of_pyproject_is_seen(tmp_path: Path, text: str, replacement: str, stale: set[str]) -> None:
    for folder in ("scripts", "tools", "src"):
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("__pycache__", "go"))
    project = (ROOT / "pyproject.toml").read_text()
    assert project.count(text) == 1
    (tmp_path / "pyproject.toml").write_text(project.replace(text, replacement))
    done = check(tmp_path)
    assert set(re.findall(r"tools/requirements-(\w+)\.txt", done.stdout + done.stderr)) == stale
    assert done.returncode == (1 if stale else 0)
    if stale:
        assert "remedy: uv run scripts/requirements.py" in done.stderr


@pytest.mark.parametrize("name", FILES)
def test_each_package_has_one_version_and_hashes(name: str) -> None:
    text = requirements(name)
    assert "://" not in text, "the address of an index"
    blocks = re.split(r"\n(?=\S)", re.sub(r"^#.*\n", "", text, flags=re.MULTILINE).strip())
    assert len(blocks) > 10
    for block in blocks:
        assert re.match(r"[\w.-]+==[\w.!+]+( ; [^\\\n]+)? \\\n", block), block
        assert re.search(r"--hash=sha256:[0-9a-f]{64}", block), block


def test_they_agree_with_one_another() -> None:
    """So that a machine that has one of them changes no version for the next."""
    app, build, dev, page = (set(re.findall(r"^[\w.-]+==\S+", requirements(name), re.MULTILINE)) for name in FILES)
    assert app < build < dev < page


# ---- Installed --------------------------------------------------------------------------------------------------------


def wheel(folder: Path, name: str, needs: str = "", code: str = "") -> str:
    folder.mkdir(exist_ok=True)
    info = f"{name}-1.0.dist-info"
    metadata = f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n" + (f"Requires-Dist: {needs}\n" if needs else "")
    content = {
        f"{name}.py": code,
        f"{info}/METADATA": metadata,
        f"{info}/WHEEL": "Wheel-Version: 1.0\nGenerator: a test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    digest = {path: base64.urlsafe_b64encode(hashlib.sha256(text.encode()).digest()) for path, text in content.items()}
    record = "".join(f"{path},sha256={digest[path].decode().rstrip('=')},{len(content[path])}\n" for path in content)
    file = folder / f"{name}-1.0-py3-none-any.whl"
    with zipfile.ZipFile(file, "w") as archive:
        for path, text in {**content, f"{info}/RECORD": f"{record}{info}/RECORD,,\n"}.items():
            archive.writestr(path, text)
    return hashlib.sha256(file.read_bytes()).hexdigest()


@pytest.fixture
def bare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bootstrap:
    """The set-up of an empty checkout, on a machine whose only packages are those in a folder."""
    for name in [name for name in os.environ if name.startswith("UV_") or name == "VIRTUAL_ENV"]:
        monkeypatch.delenv(name)
    variables = {"UV_NO_INDEX": "1", "UV_FIND_LINKS": str(tmp_path / "wheels"), "UV_CACHE_DIR": str(tmp_path / "cache")}
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    bootstrap = Bootstrap(tmp_path / "checkout")
    (bootstrap.root / "tools").mkdir()
    (bootstrap.root / "pyproject.toml").write_text((ROOT / "pyproject.toml").read_text())
    return bootstrap


def install(bare: Bootstrap, group: str) -> None:
    uv = os.environ.get("UV") or shutil.which("uv") or str(ROOT / ".state/bin/uv")
    assert Path(uv).exists(), "rosml setup installs uv"
    with bare.module.lock():
        bare.module.packages(uv, group)


def installed(bare: Bootstrap) -> set[str]:
    return {path.name for path in (bare.root / ".venv").rglob("*-1.0.dist-info")}


def ask(bare: Bootstrap, group: str, digests: Mapping[str, str]) -> set[str]:
    text = "".join(f"{name}==1.0 --hash=sha256:{digest}\n" for name, digest in digests.items())
    (bare.root / f"tools/requirements-{group}.txt").write_text(text)
    install(bare, group)
    return installed(bare)


def test_what_is_installed_is_what_is_asked_for_by_hash(bare: Bootstrap, tmp_path: Path) -> None:
    one, two = {"one": wheel(tmp_path / "wheels", "one", needs="three")}, {"two": wheel(tmp_path / "wheels", "two")}
    wheel(tmp_path / "wheels", "three")
    assert ask(bare, "dev", one | two) == {"one-1.0.dist-info", "two-1.0.dist-info"}
    assert ask(bare, "dev", one) == {"one-1.0.dist-info"}
    (bare.root / "tools/requirements-dev.txt").write_text("two==1.0\n")
    with pytest.raises(bare.module.Failure, match=r"(?i)hash"):
        install(bare, "dev")


def test_a_smaller_group_takes_nothing_away(bare: Bootstrap, tmp_path: Path) -> None:
    """A test calls a command of make, which asks for less than the tests beside it import."""
    one, two = ({name: wheel(tmp_path / "wheels", name)} for name in ("one", "two"))
    both = ask(bare, "page", one | two)
    assert ask(bare, "app", one) == both == {"one-1.0.dist-info", "two-1.0.dist-info"}


def test_uv_resolves_nothing_by_itself() -> None:
    """`uv run` would otherwise install versions that nobody pinned, and write uv.lock."""
    assert tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["uv"]["managed"] is False


# ---- In CI -----------------------------------------------------------------------------------------------------------

BACKEND = """\
import os, pathlib, zipfile
def build_wheel(folder, settings=None, metadata=None):
    pathlib.Path({seen!r}).write_text("{what}\\n" + repr(dict(os.environ)))
    with zipfile.ZipFile(os.path.join(folder, "rosml-1.0-py3-none-any.whl"), "w") as wheel:
        wheel.writestr("rosml.py", "def run(): print('it runs')\\n")
        wheel.writestr("rosml-1.0.dist-info/METADATA", "Metadata-Version: 2.1\\nName: rosml\\nVersion: 1.0\\n")
        wheel.writestr("rosml-1.0.dist-info/WHEEL", "Wheel-Version: 1.0\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n")
        wheel.writestr("rosml-1.0.dist-info/entry_points.txt", "[console_scripts]\\nrosml = rosml:run\\n")
        wheel.writestr("rosml-1.0.dist-info/RECORD", "")
    return "rosml-1.0-py3-none-any.whl"
"""


@dataclass(frozen=True)
class Pristine:
    """A virtual environment as `python3 -m venv` makes it, which takes longer than all else here.

    Attributes:
        folder: where it has to be, and is not yet.
        programs: a folder with a `python3` that makes it there, as a copy, and is the usual one otherwise.
    """

    folder: Path
    programs: Path


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Pristine:
    place = tmp_path_factory.mktemp("environment")
    pristine = Pristine(place / "installed", place / "programs")
    subprocess.run(["python3", "-m", "venv", pristine.folder], check=True)
    pristine.folder.rename(place / "pristine")
    pristine.programs.mkdir()
    copy = f'[ "$*" != "-m venv {pristine.folder}" ] || exec cp -a {place}/pristine {pristine.folder}'
    executable(pristine.programs / "python3", f'{copy}\nexec {shutil.which("python3")} "$@"')
    return pristine


@pytest.fixture
def install_in_ci(tmp_path: Path, environment: Pristine) -> Iterator[Callable[[], subprocess.CompletedProcess[str]]]:
    root = tmp_path / "checkout"
    (root / "tools").mkdir(parents=True)
    (root / "containerize").mkdir()
    shutil.copy(ROOT / "containerize/install.sh", root / "containerize")
    system = '[build-system]\nrequires = ["backend==1.0"]\nbuild-backend = "backend"\n'
    (root / "pyproject.toml").write_text(f'{system}[project]\nname = "rosml"\nversion = "1.0"\n')

    def install() -> subprocess.CompletedProcess[str]:
        variables = {name: value for name, value in os.environ.items() if not name.startswith(("PIP_", "UV_"))}
        variables |= {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": str(tmp_path / "wheels"), "CI_JOB_TOKEN": "s3cret"}
        variables["PATH"] = f"{environment.programs}:{os.environ['PATH']}"
        argv = ["sh", str(root / "containerize/install.sh"), str(environment.folder)]
        return subprocess.run(argv, env=variables, capture_output=True, text=True, check=False)

    yield install
    shutil.rmtree(environment.folder)


def test_ci_installs_with_a_backend_of_the_right_hash_and_without_secrets(
    install_in_ci: Callable[[], subprocess.CompletedProcess[str]], environment: Pristine, tmp_path: Path
) -> None:
    seen = tmp_path / "seen"
    digest = wheel(tmp_path / "wheels", "backend", code=BACKEND.format(seen=str(seen), what="right"))
    (tmp_path / "checkout/tools/requirements-build.txt").write_text(f"backend==1.0 --hash=sha256:{digest}\n")
    done = install_in_ci()
    assert done.returncode == 0, done.stderr
    assert subprocess.check_output([environment.folder / "bin/rosml"], text=True) == "it runs\n"
    assert seen.read_text().startswith("right\n") and "s3cret" not in seen.read_text()


@pytest.mark.parametrize("tampered", ["the backend", "what the backend needs", "a package without a wheel"])
def test_ci_runs_nothing_that_has_another_hash(
    install_in_ci: Callable[[], subprocess.CompletedProcess[str]], environment: Pristine, tmp_path: Path, tampered: str
) -> None:
    """An index that was taken over gives another backend for the same version, or one for a package of ours."""
    seen, wheels, needs = tmp_path / "seen", tmp_path / "wheels", "helper" if "needs" in tampered else ""
    code = BACKEND.format(seen=str(seen), what="right")
    digests = {"backend": wheel(wheels, "backend", needs, code), "helper": wheel(wheels, "helper")}
    if tampered == "the backend":
        wheel(wheels, "backend", needs, BACKEND.format(seen=str(seen), what="tampered"))
    elif tampered == "what the backend needs":
        del digests["helper"]
    else:
        (wheels / "helper-1.0-py3-none-any.whl").unlink()
        system = '[build-system]\nrequires = ["backend==1.0"]\nbuild-backend = "backend"\n'
        with tarfile.open(wheels / "helper-1.0.tar.gz", "w:gz") as archive:
            (tmp_path / "pyproject.toml").write_text(f'{system}[project]\nname = "helper"\nversion = "1.0"\n')
            archive.add(tmp_path / "pyproject.toml", "helper-1.0/pyproject.toml")
        digests["helper"] = hashlib.sha256((wheels / "helper-1.0.tar.gz").read_bytes()).hexdigest()
    lines = "".join(f"{name}==1.0 --hash=sha256:{digest}\n" for name, digest in digests.items())
    (tmp_path / "checkout/tools/requirements-build.txt").write_text(lines)
    (tmp_path / "checkout/tools/requirements-app.txt").touch()
    done = install_in_ci()
    assert done.returncode != 0
    assert not seen.exists() and (environment.folder / "bin/pip").exists()
    assert not (environment.folder / "bin/rosml").exists()
