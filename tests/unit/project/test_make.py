"""The front door: short words of make reach the commands, a typo does nothing, and ./rosml works from a bare checkout."""

from __future__ import annotations

import os
import re
import shutil
import stat
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import ROOT

CALLS = {
    "image TARGET=x": './rosml image -- "$TARGET"',
    "image TARGET=x PLATFORM=linux/arm64": './rosml image --platform "$PLATFORM" -- "$TARGET"',
    "unit COVERAGE=1": "python3 scripts/bootstrap.py linters; .venv/bin/python -m tests.suite --phase unit --coverage",
    "bench TARGET=x": '.venv/bin/python -m bench image --target="$TARGET"',
    "test-all SHARD=2/3 PROOF=cuda": '--started "$started" --all --shard "$SHARD" --proof "cuda"',
    "clean": "python3 scripts/bootstrap.py clean",
}


def make(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["make", *words], cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("call", CALLS)
def test_variables_reach_the_command(call: str) -> None:
    done = make("--dry-run", *call.split())
    assert done.returncode == 0, done.stderr
    assert CALLS[call] in " ".join(done.stdout.split())


def test_every_word_is_one_line_and_listed() -> None:
    text = (ROOT / "Makefile").read_text()
    recipes = re.findall(r"^([a-z-]+): ## .*\n((?:\t.*\n)+)", text, re.MULTILINE)
    assert len(recipes) > 5 and all(recipe.count("\n") == 1 for _, recipe in recipes)
    assert re.findall(r"^  make ([a-z-]+) ", make().stdout, re.MULTILINE) == [name for name, _ in recipes]


@pytest.mark.parametrize(
    ("words", "wrong"),
    [("imge", "imge"), ("image jazzy-base", "jazzy-base"), ("image TRAGET=x", "TRAGET"), ("image target=x", "target")],
)
@pytest.mark.parametrize("options", [[], ["--dry-run"]])
def test_a_slip_does_nothing(words: str, wrong: str, options: list[str]) -> None:
    """`make image jazzy-base` would build the default image, and then say that it knows no jazzy-base."""
    done = make(*options, *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    assert f"nothing was done: make has no command or variable {wrong}; see make's words with: make," in done.stderr


def test_what_make_test_does_not_know() -> None:
    assert "PROOF and SHARD are for make test-all" in make("--dry-run", "test", "PROOF=cuda").stderr


def test_a_value_is_no_command(tmp_path: Path) -> None:
    (tmp_path / "rosml").write_text('#!/bin/sh\nprintf "%s|" "$@"\n')
    (tmp_path / "rosml").chmod(0o755)
    argv = ["make", "-f", str(ROOT / "Makefile"), "image", f'TARGET=a b";touch {tmp_path}/made;"']
    done = subprocess.run(argv, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == f'image|--|a b";touch {tmp_path}/made;"|'
    assert not (tmp_path / "made").exists()


BOOTSTRAP = """\
import pathlib, sys
print("bootstrap", *sys.argv[1:])
root = pathlib.Path(__file__).parents[1]
(root / ".venv/bin").mkdir(parents=True, exist_ok=True)
(root / ".venv/group").touch()
python = root / ".venv/bin/python"
python.write_text('#!/bin/sh\\necho "${PYTHONPATH-none}" "$@"\\n')
python.chmod(0o755)
"""
"""In the place of scripts/bootstrap.py: installs a Python that says how it is called."""


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for folder in ("scripts", "tools", "elsewhere"):
        (tmp_path / folder).mkdir()
    shutil.copy(ROOT / "rosml", tmp_path)
    (tmp_path / "tools/requirements-app.txt").touch()
    os.utime(tmp_path / "tools/requirements-app.txt", (0, 0))
    (tmp_path / "scripts/bootstrap.py").write_text(BOOTSTRAP)
    return tmp_path


def rosml(checkout: Path, *words: str) -> tuple[str, str]:
    link = checkout / "elsewhere/link"
    if not link.is_symlink():
        link.symlink_to(checkout / "rosml")
    env = {**os.environ, "PYTHONPATH": "/opt/ros"}
    done = subprocess.run([link, *words], cwd=link.parent, env=env, capture_output=True, text=True, check=True)
    return done.stdout, done.stderr


def test_rosml_installs_what_it_needs_once(checkout: Path) -> None:
    called = f"none {checkout}/src list a b\n"
    assert rosml(checkout, "list", "a b") == (called, "bootstrap python\n")
    assert rosml(checkout, "list", "a b") == (called, "")
    os.utime(checkout / "tools/requirements-app.txt")
    os.utime(checkout / ".venv/group", (1, 1))
    assert rosml(checkout, "list", "a b") == (called, "bootstrap python\n"), "other packages are asked for now"
    (checkout / ".venv/bin/python").unlink()
    assert rosml(checkout, "list", "a b") == (called, "bootstrap python\n"), "the Python is gone"


PYTHON3 = """\
#!/bin/sh
[ "$1" != -c ] || exit 0
echo "bootstrap in $ROSML_PLACE"
mkdir -p "$ROSML_PLACE/.venv/bin"
cp "$(dirname "$0")/python" "$ROSML_PLACE/.venv/bin"
touch "$ROSML_PLACE/.venv/group"
"""
"""In the place of the system's python3: its scripts/bootstrap.py installs the Python beside it."""


@dataclass(frozen=True)
class Shared:
    checkout: Path
    cache: Path

    def installed(self) -> Path:
        """Its owner has installed the packages. Returns their mark."""
        folder = self.checkout / ".venv"
        (folder / "bin").mkdir(parents=True)
        shutil.copy(self.checkout / "mine/python", folder / "bin")
        (folder / "group").touch()
        return folder / "group"

    def call(self, *words: str, **environment: str) -> tuple[str, str]:
        become = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if os.geteuid() == 0 else []
        self.checkout.chmod(0o555)
        env = {"PATH": f"{self.checkout}/mine:{os.environ['PATH']}", "XDG_CACHE_HOME": str(self.cache), **environment}
        argv = [*become, str(self.checkout / "rosml"), *words]
        done = subprocess.run(argv, cwd="/", env=env, capture_output=True, text=True, check=False)
        self.checkout.chmod(0o755)
        return done.stdout, done.stderr


@pytest.fixture
def shared() -> Iterator[Shared]:
    with tempfile.TemporaryDirectory() as folder:
        shared_checkout = Shared(Path(folder) / "checkout", Path(folder) / "cache")
        for path in (shared_checkout.checkout / "mine", shared_checkout.checkout / "tools", shared_checkout.cache):
            path.mkdir(parents=True)
        Path(folder).chmod(0o755)
        shared_checkout.cache.chmod(0o777)
        shutil.copy(ROOT / "rosml", shared_checkout.checkout)
        requirements = shared_checkout.checkout / "tools/requirements-app.txt"
        requirements.touch()
        os.utime(requirements, (9, 9))
        for name, text in (("python3", PYTHON3), ("python", '#!/bin/sh\necho "$0" "$@"\n')):
            (shared_checkout.checkout / "mine" / name).write_text(text)
            (shared_checkout.checkout / "mine" / name).chmod(0o755)
        yield shared_checkout


def test_somebody_who_may_not_write_to_the_checkout_has_their_own_packages(shared: Shared) -> None:
    place = f"{shared.cache}/rosml/checkout{shared.checkout}"
    called = f"{place}/.venv/bin/python {shared.checkout}/src run x\n"
    assert shared.call("run", "x", _ROSML_COMPLETE="bash_complete") == ("", ""), "the Tab key installs nothing"
    assert shared.call("run", "x") == (called, f"bootstrap in {place}\n")
    assert shared.call("run", "x") == (called, "")
    os.utime(f"{place}/.venv/group", (1, 1))
    assert shared.call("run", "x") == (called, f"bootstrap in {place}\n"), "other packages are asked for now"
    assert shared.call("run", "x", XDG_CACHE_HOME="relative", HOME=f"{shared.cache}/home")[0].startswith(
        f"{shared.cache}/home/.cache/rosml/"
    )


def test_somebody_without_a_home_folder_has_a_private_one(shared: Shared) -> None:
    """A folder in /tmp, as if the home folder were gone or read-only; TMPDIR is the test's own /tmp."""
    nobody = {"XDG_CACHE_HOME": "", "HOME": "/proc/nonexistent", "TMPDIR": str(shared.cache)}
    private = shared.cache / f"rosml-{65534 if os.geteuid() == 0 else os.geteuid()}"
    called = f"{private}/checkout{shared.checkout}/.venv/bin/python {shared.checkout}/src run x\n"
    assert shared.call("run", "x", **nobody) == (called, f"bootstrap in {private}/checkout{shared.checkout}\n")
    assert shared.call("run", "x", **nobody) == (called, "")
    assert stat.S_IMODE(private.stat().st_mode) == 0o700
    refused = f"error: {private} is not a folder that only you may use\nremedy: name a folder with XDG_CACHE_HOME\n"
    private.chmod(0o755)
    assert shared.call("run", "x", **nobody) == ("", refused)
    private.chmod(0o700)
    private.rename(shared.cache / "elsewhere")
    private.symlink_to("elsewhere")
    assert shared.call("run", "x", **nobody) == ("", refused)
    private.unlink()
    if os.geteuid() == 0:
        private.mkdir(mode=0o700)
        assert shared.call("run", "x", **nobody) == ("", refused), "it belongs to somebody else"


def test_somebody_who_may_not_write_to_the_checkout_takes_its_packages(shared: Shared) -> None:
    mark = shared.installed()
    (shared.checkout / ".state").mkdir(mode=0o700 if os.geteuid() == 0 else 0)
    called = f"{shared.checkout}/.venv/bin/python {shared.checkout}/src run x\n"
    for when in (20, 1):
        os.utime(mark, (when, when))
        assert shared.call("run", "x") == (called, "")
    assert not list(shared.cache.iterdir())


@pytest.mark.parametrize(
    ("words", "arguments"), [((), "up"), (("clean",), "clean"), (("status", "--json"), "status --json")]
)
def test_set_up_installs_for_itself(checkout: Path, words: tuple[str, ...], arguments: str) -> None:
    assert rosml(checkout, "setup", *words) == (f"bootstrap {arguments}\n", "")
