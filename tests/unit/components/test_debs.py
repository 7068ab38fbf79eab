"""Archives of apt that one build leaves for the next: only what signed lists name counts."""

from __future__ import annotations

import hashlib
import os
import subprocess
import time
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

SCRIPT = ROOT / "components/containerize/install_packages.sh"
DEB, OTHER = b"a package", b"a parcel "
SHA256 = hashlib.sha256(DEB).hexdigest()


def run(tmp_path: Path, calls: str) -> str:
    """Calls functions of install_packages.sh; apt wants one package, `liba_1%3a2_amd64.deb`. Gives what apt's settings are."""
    text = SCRIPT.read_text()
    functions = text[text.index("kept=/run/debs") : text.index("listed apt")].replace("/run/debs", f"{tmp_path}/kept")
    answer = f"Reading package lists...\n'http://x/liba.deb' liba_1%3a2_amd64.deb {len(DEB)} SHA256:{SHA256}"
    executable(
        tmp_path / "apt-get",
        f'[ "$*" = "install --yes --print-uris -o Acquire::ForceHash=SHA256 liba" ] && echo "{answer}"',
    )
    (tmp_path / "scratch").mkdir(exist_ok=True)
    env = {
        "PATH": f"{tmp_path}:{os.environ['PATH']}",
        "scratch": f"{tmp_path}/scratch",
        "APT_CONFIG": f"{tmp_path}/apt.conf",
    }
    subprocess.run(["bash", "-euo", "pipefail", "-c", f"{functions}\n{calls}"], env=env, check=True)
    return (tmp_path / "apt.conf").read_text() if (tmp_path / "apt.conf").exists() else ""


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    (tmp_path / "kept").mkdir()
    return tmp_path / "kept"


@pytest.mark.parametrize(("content", "taken"), [(DEB, True), (OTHER, False)], ids=["as it was", "of the same size"])
def test_an_archive_counts_if_it_has_the_hash_of_the_lists(
    tmp_path: Path, kept: Path, content: bytes, taken: bool
) -> None:
    """apt itself looks at the size of what it finds."""
    (kept / SHA256).write_bytes(content)
    settings = run(tmp_path, "take_kept liba")
    assert settings.startswith(f'Dir::Cache::Archives "{tmp_path}/scratch/archives";\n')
    assert (tmp_path / "scratch/archives/liba_1%3a2_amd64.deb").exists() == taken == (kept / SHA256).exists()


def test_a_link_is_no_archive(tmp_path: Path, kept: Path) -> None:
    (tmp_path / "deb").write_bytes(DEB)
    (kept / SHA256).symlink_to(tmp_path / "deb")
    run(tmp_path, "take_kept liba")
    assert [path.name for path in (tmp_path / "scratch/archives").iterdir()] == ["partial"]


def test_what_was_downloaded_is_kept_by_its_hash_and_what_nobody_used_is_not(tmp_path: Path, kept: Path) -> None:
    for name, days in (("old", 40), ("new", 10)):
        (kept / name).touch()
        os.utime(kept / name, (time.time() - days * 86400,) * 2)
    run(tmp_path, f"printf '{DEB.decode()}' >\"$archives/liba_1_amd64.deb\"; keep; keep")
    assert sorted(path.name for path in kept.iterdir()) == sorted([SHA256, "new"])
    assert (kept / SHA256).read_bytes() == DEB


@pytest.mark.parametrize("fault", ["cp() { return 1; }", 'mv() { rm "$1"; return 1; }', "mktemp() { return 1; }"])
def test_an_archive_that_cannot_be_kept_fails_no_build(tmp_path: Path, kept: Path, fault: str) -> None:
    run(tmp_path, f'printf x >"$archives/liba_1_amd64.deb"; {fault}; keep')
    assert list(kept.iterdir()) == []


def test_what_apt_cannot_resolve_is_left_to_it(tmp_path: Path, kept: Path) -> None:
    run(tmp_path, "take_kept libb; keep")
    assert list(kept.iterdir()) == []


def test_a_builder_without_the_folder_downloads(tmp_path: Path) -> None:
    assert run(tmp_path, "take_kept liba; keep") == ""


# ---- Hashes of installed packages, for SBOMs -------------------------------------------------------------------------

HASHES = ROOT / "components/build/deb_hashes.sh"
LISTS = f"""Package: bash
Version: 5
Architecture: amd64
SHA256: {"a" * 64}
Description: a shell
 SHA256: of nothing

Package: bash
Version: 6
Architecture: amd64
SHA256: {"b" * 64}

Package: tzdata
Version: 1
Architecture: all
SHA512: {"c" * 128}
SHA256: {"d" * 64}

Package: odd
Version: 1
Architecture: all

"""


def note_hashes(tmp_path: Path, installed: str, lists: str) -> list[str]:
    """The lines that the script leaves. `lists` are those of apt in this step; empty if it has none."""
    (tmp_path / "lists").mkdir(exist_ok=True)
    for file in (tmp_path / "lists").iterdir():
        file.unlink()
    if lists:
        (tmp_path / "lists/x_main_Packages.lz4").write_text(lists)
    executable(tmp_path / "apt-helper", 'shift && cat "$@"')
    executable(tmp_path / "dpkg-query", f"cat <<'.'\n{installed}.")
    text = HASHES.read_text().replace("/var/lib/apt/lists", f"{tmp_path}/lists")
    script = tmp_path / "deb_hashes.sh"
    script.write_text(text.replace("/usr/lib/apt/apt-helper", f"{tmp_path}/apt-helper"))
    file = tmp_path / "share/debs.txt"
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}"}
    subprocess.run(["bash", script, file], env=env, check=True)
    return file.read_text().splitlines() if file.exists() else []


def test_the_hashes_of_installed_packages(tmp_path: Path) -> None:
    """The best one that lists have; kept when they name another release, gone with the package."""
    installed = "installed bash amd64 5\nconfig-files gone all 1\ninstalled tzdata all 1\ninstalled odd all 1\n"
    lines = [f"bash amd64 5 {'a' * 64}", f"tzdata all 1 {'c' * 128}"]
    assert note_hashes(tmp_path, installed, "") == []
    assert note_hashes(tmp_path, installed, LISTS) == lines
    assert note_hashes(tmp_path, installed, LISTS.partition("\n\n")[2]) == lines
    assert note_hashes(tmp_path, "installed tzdata all 1\n", "") == lines, "a step without lists changes nothing"
    assert note_hashes(tmp_path, "installed tzdata all 1\n", LISTS) == lines[1:]
