"""Makes Debian base images with mmdebstrap.

They are pushed to the local registry under the official name (``library/debian:bookworm``). The builder takes that
registry as the mirror of docker.io, so ``FROM debian:bookworm`` means the same everywhere.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import os
import shlex
import shutil
import sys
import tarfile
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from offline import debian_suite, missing
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.builds.base_images import native_architecture
from rosml.machine.services import Services
from rosml.machine.setup.process import Call, run
from rosml.registry import oci
from rosml.registry.client import Registry

EPOCH = 1767225600
LAYER = "application/vnd.oci.image.layer.v1.tar+gzip"
REPOSITORY = "library/debian"
BINFMT = Path("/proc/sys/fs/binfmt_misc")
RECIPE = "io.rosml.recipe"
"""The annotation with the digest of the recipe: if the recipe changes, the image is made again."""

FILES = {
    "usr/sbin/policy-rc.d": (0o755, "#!/bin/sh\n# Services do not start in an image.\nexit 101\n"),
    "etc/dpkg/dpkg.cfg.d/docker-apt-speedup": (0o644, "force-unsafe-io\n"),
    "etc/apt/apt.conf.d/docker-clean": (
        0o644,
        'APT::Keep-Downloaded-Packages "false";\n'
        'DPkg::Post-Invoke { "rm -f /var/cache/apt/archives/*.deb /var/cache/apt/*.bin || true"; };\n'
        'Dir::Cache::pkgcache "";\nDir::Cache::srcpkgcache "";\n',
    ),
    "etc/apt/apt.conf.d/docker-no-languages": (0o644, 'Acquire::Languages "none";\n'),
    "etc/apt/apt.conf.d/docker-gzip-indexes": (0o644, 'Acquire::GzipIndexes "true";\n'),
    "etc/apt/apt.conf.d/docker-autoremove-suggests": (0o644, 'APT::AutoRemove::SuggestsImportant "false";\n'),
}
"""Files added to a made image: path to mode and text. The official image has them, too."""

MOVING = ("sid", "unstable", "testing")
"""Suites whose list of packages is valid for a week. A mirror may be some weeks old."""

LENIENT = 'Acquire::Check-Valid-Until "false"'

REMOVE = (
    "etc/apt/apt.conf.d/99mmdebstrap",
    "etc/hostname",
    "etc/resolv.conf",
    "var/cache/apt/*.bin",
    "var/cache/debconf/*-old",
    "var/cache/ldconfig/aux-cache",
    "var/lib/dpkg/*-old",
    "var/log/*.log",
    "var/log/apt/*",
)
"""Files of a made image that depend on this machine or on the day."""

# mmdebstrap gives them to apt's user only if that user can enter the folder in which the image is made.
APT_FOLDERS = ("var/cache/apt/archives/partial", "var/lib/apt/lists/partial")

FOLDER = "dev"
"""What mmdebstrap leaves out. A builder would make it, with the present time."""


def ensure(services: Services, image: str, architecture: str = "") -> dict[str, str]:
    """The reference of a Debian image, in the local registry, by its digest and official name.

    Args:
        image: such as ``docker.io/library/debian:bookworm``.
        architecture: ``amd64`` or ``arm64``, the machine's own if empty. The image has that one besides: parts are built on it.
    """
    if reason := missing(image):
        remedy = "use a machine that reaches Docker Hub (or set ROSML_DOCKER_HUB=1 if it does), or a target on Debian"
        raise RosmlError(f"{reason}, and only Debian images can be made here", remedy)
    suite, native = debian_suite(image), native_architecture()
    if architecture in ("", native):
        return {"reference": f"{image}@{debian(services, suite, native)}"}
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(architecture, architecture)
    if not (BINFMT / f"qemu-{machine}").exists():  # of `rosml setup emulate`
        text = f"a Debian base image for {architecture} cannot be made on {native}: its programs do not run here"
        remedy = f"run 'rosml setup emulate', or use an {architecture} machine, or one that reaches Docker Hub"
        raise RosmlError(text, remedy)
    digests = {name: debian(services, suite, name) for name in (native, architecture)}
    members = []
    with Registry(services.registry) as registry:
        for name, digest in digests.items():
            manifest = registry.manifest(REPOSITORY, digest)
            assert manifest, "it was just pushed"
            members.append({**manifest.descriptor, "platform": {"os": "linux", "architecture": name}})
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": members}
        index = registry.put_manifest(REPOSITORY, "", content, oci.INDEX)
    return {"reference": f"{image}@{index}"}


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def debian(services: Services, suite: str, architecture: str) -> str:
    """The digest of a Debian image for one architecture, which is made if it is missing."""
    tag = suite if architecture == native_architecture() else f"{suite}-{architecture}"
    folder = services.state / "base"
    folder.mkdir(parents=True, exist_ok=True)
    waiting = f"base image debian:{tag}: waiting for another call that makes it"
    with turn(folder / f"{tag}.lock", lambda: say(waiting)) as lock:
        return find(services, tag, architecture) or make(services, suite, architecture, folder / tag, tag, lock)


def added_files(suite: str) -> dict[str, tuple[int, str]]:
    lenient = {"etc/apt/apt.conf.d/lenient": (0o644, f"{LENIENT};\n")} if suite in MOVING else {}
    return {**FILES, **lenient}


def recipe(tag: str, architecture: str) -> str:
    """The digest of everything that decides how an image is made, apart from the suite's packages."""
    suite = tag.removesuffix(f"-{architecture}")
    call = command(suite if suite in MOVING else "SUITE", architecture, Path("F"), Path("O"))
    text = json.dumps([added_files(suite), [FOLDER], REMOVE, EPOCH, architecture, call])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def find(services: Services, tag: str, architecture: str) -> str:
    """The digest of the image that an earlier call made by the same recipe, if the registry still has all of it."""
    services.require_registry()
    with suppress(RosmlError), Registry(services.registry) as registry:
        manifest = registry.manifest(REPOSITORY, tag)
        if manifest and (manifest.content.get("annotations") or {}).get(RECIPE) == recipe(tag, architecture):
            blobs = (manifest.content["config"], *manifest.content["layers"])
            if all(registry.has_blob(REPOSITORY, blob["digest"]) for blob in blobs):
                return manifest.digest
    return ""


def command(suite: str, architecture: str, files: Path, output: Path) -> list[str]:
    """The call of mmdebstrap. It names no mirror: mmdebstrap's own choice, with updates and security, is Debian's."""
    remove = " ".join(f'"$1"/{pattern}' for pattern in REMOVE)
    return [
        "mmdebstrap",
        "--variant=minbase",
        "--format=tar",
        f"--architectures={architecture}",
        "--skip=output/dev",  # device nodes are the container runtime's business
        '--aptopt=Acquire::Retries "5"',
        *([f"--aptopt={LENIENT}"] if suite in MOVING else []),
        f"--customize-hook=sync-in {shlex.quote(str(files))} /",
        f"--customize-hook=rm -f {remove}",
        f'--customize-hook=chroot "$1" chown _apt:root {" ".join(f"/{folder}" for folder in APT_FOLDERS)}',
        suite,
        str(output),
    ]


def isolated(argv: list[str]) -> list[str]:
    """The command in namespaces of its own (for root): whatever ends it, its mounts and its children end with it."""
    if os.geteuid() != 0 or shutil.which("unshare") is None:
        return argv
    return ["unshare", "--mount", "--pid", "--fork", "--kill-child", *argv]


def make(services: Services, suite: str, architecture: str, folder: Path, tag: str, lock: int = 0) -> str:
    """Makes a Debian image and pushes it. Returns its digest. The tag comes last: an interrupted call leaves none.

    Args:
        folder: for its files; removed at the end.
        lock: the file descriptor of a lock that holds while mmdebstrap runs, even if this process is killed; 0 for none.
    """
    if shutil.which("mmdebstrap") is None:
        text = "mmdebstrap is not installed; it makes base images where Docker Hub does not answer"
        raise RosmlError(text, "run 'rosml setup'")
    say(f"base image debian:{tag}: making it with mmdebstrap, since Docker Hub does not answer")
    started = time.monotonic()
    shutil.rmtree(folder, ignore_errors=True)
    log = services.state / "log" / f"base-{tag}.log"
    try:
        log.parent.mkdir(parents=True, exist_ok=True)
        write_files(folder / "files", added_files(suite))
        tar = folder / "root.tar"
        (folder / "tmp").mkdir()
        env = {**os.environ, "SOURCE_DATE_EPOCH": str(EPOCH), "TMPDIR": str(folder / "tmp"), "LC_ALL": "C.UTF-8"}
        argv = isolated(command(suite, architecture, folder / "files", tar))
        run(say, Call("mmdebstrap", argv, log, env, pass_fds=(lock,) if lock else ()))
        add_folder(tar)
        manifest, blobs = build_image(tar, tag, architecture)
        digest = push(services, manifest, blobs, tag)
    except RosmlError as error:
        remedy = error.remedy or "check that Debian's mirrors answer, then run it again"
        raise RosmlError(error.message, remedy) from None
    except (OSError, tarfile.TarError) as error:
        raise RosmlError(f"base image debian:{tag}: {error}", "check the disk (df), then run it again") from None
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    say(f"base image debian:{tag}: made in {time.monotonic() - started:.0f} s, served as the mirror of Docker Hub")
    return digest


def add_folder(tar: Path) -> None:
    entry = tarfile.TarInfo(f"./{FOLDER}")
    entry.type, entry.mode, entry.mtime = tarfile.DIRTYPE, 0o755, EPOCH
    with tarfile.open(tar, "a") as archive:
        archive.addfile(entry)


def write_files(folder: Path, files: dict[str, tuple[int, str]]) -> None:
    for name, (mode, text) in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(mode)
    for path in [folder, *folder.rglob("*")]:
        if path.is_dir():
            path.chmod(0o755)


def build_image(tar: Path, tag: str, architecture: str) -> tuple[bytes, tuple[bytes, bytes]]:
    """The manifest of an image with one gzip layer; its configuration and layer."""
    diff_id, layer = compress(tar)
    created = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(EPOCH))
    path = "PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
    config = {
        "architecture": architecture,
        "os": "linux",
        "created": created,
        "config": {"Env": [path], "Cmd": ["bash"]},
        "rootfs": {"type": "layers", "diff_ids": [diff_id]},
        "history": [{"created": created, "created_by": f"mmdebstrap --variant=minbase {tag}"}],
    }
    manifest = {
        "schemaVersion": 2,
        "mediaType": oci.IMAGE,
        "config": oci.descriptor(oci.CONFIG, oci.encoded(config)),
        "layers": [oci.descriptor(LAYER, layer)],
        "annotations": {RECIPE: recipe(tag, architecture)},
    }
    return oci.encoded(manifest), (oci.encoded(config), layer)


def compress(tar: Path) -> tuple[str, bytes]:
    """The digest of an archive, and the archive as gzip without a file name or a date."""
    content, packed = hashlib.sha256(), io.BytesIO()
    with tar.open("rb") as source, gzip.GzipFile("", "wb", compresslevel=6, fileobj=packed, mtime=0) as out:
        while chunk := source.read(1 << 20):
            content.update(chunk)
            out.write(chunk)
    return f"sha256:{content.hexdigest()}", packed.getvalue()


def push(services: Services, manifest: bytes, blobs: Sequence[bytes], tag: str) -> str:
    """Puts an image into the local registry. Returns its digest."""
    with Registry(services.registry) as registry:
        for blob in blobs:
            registry.put_blob(REPOSITORY, blob)
        return registry.put_manifest(REPOSITORY, tag, manifest)
