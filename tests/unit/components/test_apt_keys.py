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
    found: dict[str, datetime.datetime | None] = {}
    expires: datetime.datetime | None = None
    primary = False
    for line in gpg(home, "--show-keys", "--with-colons", str(file)).splitlines():
        fields = line.split(":")
        if fields[0] in ("pub", "sub"):
            primary = fields[0] == "pub"
            expires = datetime.datetime.fromtimestamp(int(fields[6]), datetime.UTC) if fields[6] else None
        elif fields[0] == "fpr" and primary:
            found[fields[9]] = expires
    return found


def complaints(folder: Path, home: Path, now: datetime.datetime) -> list[str]:
    """One sentence about each key that has too little time left."""
    found = []
    for file in sorted(folder.glob("*.asc")):
        if file.name == "none.asc":
            continue
        for fingerprint, expires in keys_in(file, home).items():
            days = (expires - now).days if expires else LEAST_DAYS
            if days < LEAST_DAYS:
                found.append(
                    f"{file.name}: key {fingerprint} has {days} days left; put the prolonged key there; if it is "
                    "ROS's own, pin a release of ros-apt-source that has it in matrix.yaml"
                )
    return found


def test_the_keys_are_the_pinned_ones(tmp_path: Path) -> None:
    found = {file.name: list(keys_in(file, tmp_path / "gnupg")) for file in KEYS.iterdir()}
    assert found == {name: [fingerprint] for name, fingerprint in FINGERPRINTS.items()}


def test_no_key_expires_soon(tmp_path: Path) -> None:
    for folder in (KEYS, OTHERS):
        assert complaints(folder, tmp_path / "gnupg", datetime.datetime.now(datetime.UTC)) == []


@pytest.mark.parametrize(("days", "left"), [(1, 0), (90, 89), (92, None), (0, None)])
def test_a_key_that_expires_soon_is_found(days: int, left: int | None, tmp_path: Path) -> None:
    """Made here: a key that expires tomorrow, and some that have longer; 0 is gpg's word for never."""
    home, file = tmp_path / "gnupg", tmp_path / "soon.asc"
    arguments = ["--passphrase", "", "--quick-generate-key", "Soon <soon@example.org>", "ed25519", "sign"]
    try:
        gpg(home, *arguments, f"{days}d" if days else "0")
    finally:
        subprocess.run(["gpgconf", "--homedir", str(home), "--kill", "all"], check=False)
    file.write_text(gpg(home, "--armor", "--export"))
    found = complaints(tmp_path, home, datetime.datetime.now(datetime.UTC))
    if left is None:
        assert found == []
    else:
        assert len(found) == 1
        assert found[0].startswith("soon.asc: key ")
        assert f"has {left} days left" in found[0]
