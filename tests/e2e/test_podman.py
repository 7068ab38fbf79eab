"""`rosml run` and `rosml attach` with podman, with root and without it; what docker does is in test_contract.py."""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from tests.e2e.images import Publish
from tests.e2e.person import UID, Person, enters, starts

TARGET = "ros1-bookworm-core"
LIMITS = {"nofile": resource.RLIMIT_NOFILE, "nproc": resource.RLIMIT_NPROC}

CDI = Path("/run/cdi")
DEVICE = """\
cdiVersion: 0.5.0
kind: nvidia.com/gpu
devices: [{name: all, containerEdits: {env: [GPU=made-up]}}]
"""
BECOME = f"""\
for file in passwd group subuid subgid; do mount --bind "$0/$file" "/etc/$file" || exit; done
exec setpriv --reuid={UID} --regid={UID} --clear-groups "$@"
"""
"""Makes root a user with uids of their own, for this command alone."""


ROOT = [pytest.param("root", marks=pytest.mark.full(proof="engines"))]


@pytest.fixture(params=["without root", *(ROOT if os.geteuid() == 0 else [])])
def person(request: pytest.FixtureRequest) -> Iterator[Person]:
    """Who has podman, with storage that ends with the test."""
    if not shutil.which("podman") or not shutil.which("newuidmap"):
        pytest.skip("no podman is here that needs no root: 'make test-packages' installs it")
    folder = Path(tempfile.mkdtemp(prefix="podman-"))  # short: sockets are in it
    folder.chmod(0o755)
    home, runtime = folder / "home", folder / "runtime"
    home.mkdir()
    runtime.mkdir(mode=0o700)
    limits = {name: min(resource.getrlimit(kind)[1], 4096) for name, kind in LIMITS.items()}
    ulimits = [f"{name}={limit}:{limit}" for name, limit in limits.items()]
    (folder / "containers.conf").write_text(
        f'[containers]\ndefault_ulimits = {json.dumps(ulimits)}\n[engine]\nruntime = "runc"\ncgroup_manager = "cgroupfs"\n'
    )
    (folder / "storage.conf").write_text(
        f'[storage]\ndriver = "overlay"\ngraphroot = "{home}/storage"\nrunroot = "{runtime}/storage"\n'
    )
    person = Person(home, os.geteuid())
    person.environment = {
        "ROSML_ENGINE": "podman",
        "CONTAINERS_CONF": str(folder / "containers.conf"),
        "CONTAINERS_STORAGE_CONF": str(folder / "storage.conf"),
        "XDG_RUNTIME_DIR": str(runtime),
        "TMPDIR": str(home),
    }
    if request.param != "root" and os.geteuid() == 0:
        for path in (home, runtime):
            os.chown(path, UID, UID)
        for name in ("passwd", "group"):
            shutil.copy(f"/etc/{name}", folder)
            with (folder / name).open("a") as file:
                file.write(f"somebody:x:{UID}:{UID}::{home}:/bin/sh\n" if name == "passwd" else f"somebody:x:{UID}:\n")
        for name in ("subuid", "subgid"):
            (folder / name).write_text("somebody:1000000:65536\n")
        person.uid = UID
        person.become = ["unshare", "--mount", "sh", "-c", BECOME, str(folder)]
    yield person
    person.other("podman", "rm", "--all", "--force")
    for pause in runtime.rglob("pause.pid"):
        with suppress(ProcessLookupError):
            os.kill(int(pause.read_text()), 9)
    for line in reversed(Path("/proc/self/mounts").read_text().splitlines()):
        if (place := line.split()[1]).startswith(f"{folder}/"):
            subprocess.run(["umount", place], check=False)
    shutil.rmtree(folder)


def test_an_image_starts_and_is_entered_and_moves(person: Person, published: Publish) -> None:
    """The image is pulled from the registry as it is there, and so with layers by zstd."""
    image = published(TARGET).reference
    pulled = person.other("podman", "pull", "--quiet", "--tls-verify=false", image)
    assert pulled.code == 0, pulled.err
    starts(person, image, "podman")
    enters(person, image, "podman")
    has_gpu(person, image)
    moves(person, image)


def has_gpu(person: Person, image: str) -> None:
    """Asserts that podman hands in a GPU, of which a file of CDI says how."""
    if os.geteuid() or CDI.exists():
        return  # the folder is root's, or has the devices of this machine
    CDI.mkdir()
    try:
        (CDI / "nvidia.yaml").write_text(DEVICE)
        assert person.run("--device", "nvidia.com/gpu=all", image, "printenv", "GPU").out == "made-up\n"
    finally:
        shutil.rmtree(CDI)


def moves(person: Person, image: str) -> None:
    """Asserts that a file brings an image to a podman that lacks it."""
    saved = person.rosml("save", image, "--output", "image.tar")
    assert saved.code == 0, saved.err
    assert person.other("podman", "rmi", "--all", "--force").code == 0
    loaded = person.rosml("load", "image.tar")
    assert loaded.code == 0, loaded.err
    assert person.run("--pull=never", image, "printenv", "ROS_DISTRO").out == "Debian\n"
