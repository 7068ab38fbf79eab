"""`rosml run`, `attach`, `dev` and what they export with podman, with root and without it; what docker does is in test_contract.py."""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path

import pytest

from fakes import units
from rosml import ROOT
from rosml.machine.services import Services
from tests.e2e import mini
from tests.e2e.calls import wait_until
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


AS_ROOT = [pytest.param("root", marks=pytest.mark.full(proof="engines"))]
GENERATOR = shutil.which("quadlet", path=f"/usr/libexec/podman:/usr/lib/podman:{os.environ['PATH']}") or ""
OF_SYSTEMD = ("--cidfile=", "--cgroups=", "--sdnotify=")


@pytest.fixture(params=["without root", *(AS_ROOT if os.geteuid() == 0 else [])])
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


def test_exports_start(person: Person, published: Publish) -> None:
    """podman starts the pod of `--export kubernetes`, and what systemd would start for `--export quadlet`."""
    image, say = published(TARGET).reference, 'id -u; echo "$ROS_DISTRO"; touch made; sleep 1000'

    def exported(kind: str, *words: str) -> str:
        done = person.rosml("run", "--export", kind, "--trust", "--name", "robot", *words, image, "sh", "-c", say)
        assert done.code == 0, done.err
        return done.out

    def says(container: str) -> None:
        expected = [str(person.uid), "Debian"]
        logs = partial(person.other, "podman", "logs", container)
        wait_until(lambda: logs().out.split() == expected, 30, logs)

    person.other("podman", "pull", "--quiet", "--tls-verify=false", image)
    started = person.other("podman", *unit_words(person, exported("quadlet", "--network", "none", "--mwd")))
    assert started.code == 0, started.err
    says("robot")
    assert (person.folder / "made").stat().st_uid == person.uid
    person.other("podman", "rm", "--force", "robot")
    (person.folder / "pod.yaml").write_text(exported("kubernetes"))
    played = person.other("podman", "kube", "play", "--network", "none", "--tls-verify=false", "pod.yaml")
    assert played.code == 0, played.err
    names = person.other("podman", "ps", "--format", "{{.Names}}").out.split()
    says(next(name for name in names if name.startswith("robot-pod") and name.endswith("robot")))
    assert person.other("podman", "kube", "down", "pod.yaml").code == 0


def unit_words(person: Person, document: str) -> list[str]:
    """The words of podman's `run` in the unit of a file, by podman's generator, or by its rules if this podman has none. Without
    those that ask for systemd."""
    if not GENERATOR:
        return ["run", "--detach", *units.argv(document)]
    (person.folder / "robot.container").write_text(document)
    folders = {"QUADLET_UNIT_DIRS": str(person.folder)}
    argv = [GENERATOR, "-user", "-no-kmsg-log", str(person.folder)]
    subprocess.run(argv, env={**os.environ, **folders}, check=True, capture_output=True)
    unit = (person.folder / "robot.service").read_text()
    line = next(line for line in unit.splitlines() if line.startswith("ExecStart="))
    words = [word for word in units.words(line.partition("=")[2])[1:] if not word.startswith(OF_SYSTEMD)]
    return units.started(words)


@pytest.mark.full(proof="engines")
def test_a_package_is_worked_on(person: Person, published: Publish, services: Services) -> None:
    """`rosml dev`: podman takes the image from the local registry, and what is built belongs to whoever calls."""
    if person.become and services.builder_kind != "buildkitd":
        pytest.skip("Docker is the builder here, and somebody else may not call it")
    folder = person.folder / "my robot"
    shutil.copytree(ROOT / "examples/ros1", folder)
    with checkout(person, services, folder):
        base = ["--network", "none", "--base-image", published(TARGET).reference]

        def dev(*command: str) -> str:
            words = [sys.executable, "-m", "rosml", "dev", *base, str(folder), "--", *command]
            done = person.other(*words, timeout=1200)
            assert done.code == 0, done.out + done.err
            return done.out + done.err

        assert "1 package finished" in dev("sh", "-c", "colcon build && colcon test")
        assert "base image" not in dev("test", "-e", "build/compass"), "the image is made once"
        assert (folder / ".rosml/dev/build/compass").stat().st_uid == person.uid


@contextmanager
def checkout(person: Person, services: Services, folder: Path) -> Iterator[None]:
    """Gives a person a folder, and a checkout of theirs on our registry and builder, which they may call for a while."""
    place = person.folder / "rosml"
    place.mkdir()
    mini.copy_checkout(place, "services.json")
    config = place / ".state/buildx"
    for name in ("auth", "buildx"):
        (place / ".state" / name).unlink(missing_ok=True)
        shutil.copytree(ROOT / ".state" / name, place / ".state" / name)
    mini.use(place, buildx_config=str(config))
    person.environment["PYTHONPATH"] = str(place / "src")
    if not person.become:
        yield
        return
    subprocess.run(["chown", "--recursive", f"{person.uid}:{person.uid}", str(place), str(folder)], check=True)
    (node,) = json.loads((config / "instances" / services.builder).read_text())["Nodes"]
    socket = Path(node["Endpoint"].removeprefix("unix://"))
    mode = socket.stat().st_mode
    socket.chmod(0o666)
    try:
        yield
    finally:
        socket.chmod(mode)


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
