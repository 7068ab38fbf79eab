"""The keys of ROS's apt repositories: the pinned ones, and with time enough left to act before they expire."""

from __future__ import annotations

import datetime
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

KEYS = ROOT / "components" / "ros" / "keys"
OTHERS = ROOT / "components" / "archive-keys"
"""Of archives that rows name."""

FINGERPRINTS = {
    # Also in ros2-apt-source 1.2.0; https://raw.githubusercontent.com/ros/rosdistro/master/ros.asc
    "live.asc": "C1CF6E31E6BADE8868B172B4F42ED6FBAB17C654",
    # https://docs.ros.org/en/rolling/Get-Started/Installation/Snapshot-Repository.html
    "snapshots.asc": "4B63CF8FDE49746E98FA01DDAD19BAB3CBF125EA",
}

LEAST_DAYS = 90
"""A prolonged key comes with a release of ros-apt-source or a new file here, and images have to be built anew."""

pytestmark = pytest.mark.skipif(shutil.which("gpg") is None, reason="no gpg on this machine, which reads the keys")


def gpg(home: Path, *arguments: str) -> str:
    """What gpg prints."""
    home.mkdir(mode=0o700, exist_ok=True)
    argv = ["gpg", "--homedir", str(home), "--batch", "--quiet", *arguments]
    return subprocess.run(argv, check=True, capture_output=True, text=True).stdout


def keys_in(file: Path, home: Path) -> dict[str, datetime.datetime | None]:
    """The primary keys in a file by fingerprint, with the time when they expire."""
    keys: dict[str, datetime.datetime | None] = {}
    primary: list[str] | None = None
    for fields in (line.split(":") for line in gpg(home, "--show-keys", "--with-colons", str(file)).splitlines()):
        if fields[0] in ("pub", "sub"):
            primary = fields if fields[0] == "pub" else None
        elif fields[0] == "fpr" and primary:
            end = primary[6] and datetime.datetime.fromtimestamp(int(primary[6]), datetime.UTC)
            keys[fields[9]] = end or None
    return keys


def complaints(folder: Path, home: Path) -> list[str]:
    """One sentence about each key that has too little time."""
    now = datetime.datetime.now(datetime.UTC)
    remedy = (
        "put the prolonged key there; if it is ROS's own, pin a release of ros-apt-source that has it in matrix.yaml"
    )
    return [
        f"{file.name}: key {fingerprint} has {(expires - now).days} days left; {remedy}"
        for file in sorted(folder.glob("*.asc"))
        if file.name != "none.asc"
        for fingerprint, expires in keys_in(file, home).items()
        if expires and (expires - now).days < LEAST_DAYS
    ]


def test_the_keys_are_the_pinned_ones(tmp_path: Path) -> None:
    keys = {file.name: list(keys_in(file, tmp_path / "gnupg")) for file in KEYS.iterdir()}
    assert keys == {name: [fingerprint] for name, fingerprint in FINGERPRINTS.items()}


def test_no_key_expires_soon(tmp_path: Path) -> None:
    for folder in (KEYS, OTHERS):
        assert complaints(folder, tmp_path / "gnupg") == []


@pytest.mark.parametrize(("days", "complains"), [(90, True), (92, False), (0, False)])
def test_a_key_that_expires_soon_is_found(days: int, complains: bool, tmp_path: Path) -> None:
    """A key that is made here; 0 is gpg's word for never."""
    home, file = tmp_path / "gnupg", tmp_path / "soon.asc"
    arguments = ["--passphrase", "", "--quick-generate-key", "Soon <soon@example.org>", "ed25519", "sign"]
    try:
        gpg(home, *arguments, f"{days}d" if days else "0")
    finally:
        subprocess.run(["gpgconf", "--homedir", str(home), "--kill", "all"], check=False)
    file.write_text(gpg(home, "--armor", "--export"))
    assert [sentence[:14] for sentence in complaints(tmp_path, home)] == ["soon.asc: key "] * complains
