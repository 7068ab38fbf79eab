"""Makes Debian base images with mmdebstrap.

They are pushed to the local registry under the official name (``library/debian:bookworm``). The builder takes that
registry as the mirror of docker.io, so ``FROM debian:bookworm`` means the same everywhere.
"""

from __future__ import annotations

import gzip
import hashlib
import json
import os
import shlex
import shutil
import subprocess
import sys
import tarfile
import time
from pathlib import Path
from typing import Any

from offline.official import debian_suite, missing
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.builds.base_images import native_architecture
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.oci import INDEX

EPOCH = 1767225600
"""Timestamp of files and image (2026-01-01), as everywhere in this project."""
MANIFEST = "application/vnd.oci.image.manifest.v1+json"
CONFIG = "application/vnd.oci.image.config.v1+json"
LAYER = "application/vnd.oci.image.layer.v1.tar+gzip"
REPOSITORY = "library/debian"
RECIPE = "io.rosml.recipe"
"""Annotation that says how an image was made: a change of the recipe makes it anew."""
TAIL_LINES = 20

FILES = {
    # What the official image has as well: no service starts in a build, and apt leaves nothing behind.
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
"""Files added to a made image: path to mode and text."""

MOVING = ("sid", "unstable", "testing")
"""Suites whose list of packages is valid for a week. A mirror may be some weeks old."""

LENIENT = 'Acquire::Check-Valid-Until "false"'
"""How apt takes such a list all the same."""

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
"""Removed from a made image: what tells of this machine or of the day."""

APTS = ("var/cache/apt/archives/partial", "var/lib/apt/lists/partial")
"""Folders of apt's own user, as in the official image. mmdebstrap gives them to it only where that user can enter the folder
in which the image is made: elsewhere the image would have another digest."""

FOLDERS = ("dev",)
"""Folders that mmdebstrap leaves out. A builder would make them, and leave the time of day on them."""


def ensure(services: Services, image: str, architecture: str = "") -> dict[str, str]:
    """The reference of a Debian image by its digest and official name, by which the local registry serves it.

    Args:
        services: this machine's.
        image: such as ``docker.io/library/debian:bookworm``.
        architecture: ``amd64`` or ``arm64``, the machine's own if empty. The image has that one besides: parts are built on it.

    Raises:
        RosmlError: it is not Debian's, cannot be made for that architecture, or making it fails.
    """
    if reason := missing(image):
        raise RosmlError(
            f"{reason}, and only Debian images can be made here",
            "use a machine that reaches Docker Hub (or set ROSML_DOCKER_HUB=1 if it does), or a target on Debian",
        )
    suite, native = debian_suite(image), native_architecture()
    if architecture in ("", native):
        return {"reference": f"{image}@{debian(services, suite, native)}"}
    if not emulated(architecture):
        raise RosmlError(
            f"a Debian base image for {architecture} cannot be made on {native}: its programs do not run here",
            f"run 'rosml setup emulate', or use an {architecture} machine, or one that reaches Docker Hub",
        )
    digests = [debian(services, suite, name) for name in (native, architecture)]
    members = []
    with Registry(services.registry) as registry:
        for name, digest in zip((native, architecture), digests, strict=True):
            found = registry.manifest(REPOSITORY, digest)
            assert found, "it was just pushed"
            members.append({**found.descriptor, "platform": {"os": "linux", "architecture": name}})
        content = {"schemaVersion": 2, "mediaType": INDEX, "manifests": members}
        index = registry.put_manifest(REPOSITORY, "", content, INDEX)
    return {"reference": f"{image}@{index}"}


def say(line: str) -> None:
    """Tells people what is going on: standard output is for whoever called."""
    print(line, file=sys.stderr, flush=True)


def emulated(architecture: str) -> bool:
    """Whether the kernel runs programs of another architecture (``rosml setup emulate``)."""
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(architecture, architecture)
    return (BINFMT / f"qemu-{machine}").exists()


BINFMT = Path("/proc/sys/fs/binfmt_misc")
"""The kernel's table of interpreters."""


def debian(services: Services, suite: str, architecture: str) -> str:
    """Digest of a Debian image for one architecture; made if it is not there."""
    tag = suite if architecture == native_architecture() else f"{suite}-{architecture}"
    folder = services.state / "base"
    folder.mkdir(parents=True, exist_ok=True)
    with turn(
        folder / f"{tag}.lock", lambda: say(f"base image debian:{tag}: waiting for another call that makes it")
    ) as lock:
        digest = find(services, tag, architecture)
        return digest or make(services, suite, architecture, folder / tag, lock, tag)


def added_files(suite: str) -> dict[str, tuple[int, str]]:
    """The files added to an image of a suite: path to mode and text."""
    lenient = {"etc/apt/apt.conf.d/lenient": (0o644, f"{LENIENT};\n")} if suite in MOVING else {}
    return {**FILES, **lenient}


def recipe(tag: str, architecture: str) -> str:
    """Stands for all that decides how an image is made, apart from the suite's packages."""
    suite = tag.removesuffix(f"-{architecture}")
    call = command(suite if suite in MOVING else "SUITE", architecture, Path("F"), Path("O"))
    text = json.dumps([added_files(suite), FOLDERS, REMOVE, EPOCH, architecture, call])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def find(services: Services, tag: str, architecture: str) -> str:
    """Digest of the image that an earlier call made by the same recipe and that is still whole; empty otherwise."""
    services.require_registry()
    try:
        headers, body = services.get(f"/v2/library/debian/manifests/{tag}", MANIFEST)
        manifest = json.loads(body)
        if manifest.get("annotations", {}).get(RECIPE) != recipe(tag, architecture):
            return ""
        for part in (manifest["config"], *manifest["layers"]):
            services.get(f"/v2/library/debian/blobs/{part['digest']}", method="HEAD")
        return headers["docker-content-digest"]
    except (RosmlError, ValueError, KeyError, TypeError, AttributeError):
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
        f'--customize-hook=chroot "$1" chown _apt:root {" ".join(f"/{folder}" for folder in APTS)}',
        suite,
        str(output),
    ]


def isolated(argv: list[str]) -> list[str]:
    """The command in namespaces of its own (for root): whatever ends it, its mounts and its children end with it."""
    if os.geteuid() != 0 or shutil.which("unshare") is None:
        return argv
    return ["unshare", "--mount", "--pid", "--fork", "--kill-child", *argv]


def make(
    services: Services,
    suite: str,
    architecture: str,
    folder: Path,
    lock: int | None = None,
    tag: str = "",
) -> str:
    """Makes a Debian image and pushes it; gives its digest. The tag appears last: an interrupted call leaves none.

    Args:
        folder: for its files; removed at the end.
        lock: file descriptor of a lock that holds while mmdebstrap runs, even if this process is killed.
        tag: the image's tag in the local registry; the suite if empty.

    Raises:
        RosmlError: mmdebstrap is missing or fails, or the push does.
    """
    if shutil.which("mmdebstrap") is None:
        raise RosmlError(
            "mmdebstrap is not installed; it makes base images where Docker Hub does not answer", "run 'rosml setup'"
        )
    tag = tag or suite
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
        run_logged(isolated(command(suite, architecture, folder / "files", tar)), env, log, lock)
        add_folders(tar)
        digest = write_layout(folder / "layout", tar, tag, architecture)
        push(services, folder / "layout", tag)
    except (OSError, tarfile.TarError) as error:
        raise RosmlError(f"base image debian:{tag}: {error}", "check the disk (df), then run it again") from None
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    say(f"base image debian:{tag}: made in {time.monotonic() - started:.0f} s, served as the mirror of Docker Hub")
    return digest


def run_logged(argv: list[str], env: dict[str, str], log: Path, lock: int | None = None) -> None:
    """Runs a command with its output in a log.

    Raises:
        RosmlError: it fails; with the end of the log.
    """
    with log.open("wb") as stream:
        done = subprocess.run(
            argv,
            stdin=subprocess.DEVNULL,
            stdout=stream,
            stderr=subprocess.STDOUT,
            env=env,
            pass_fds=() if lock is None else (lock,),
            check=False,
        )
    if done.returncode != 0:
        end = "\n".join(log.read_text(errors="replace").splitlines()[-TAIL_LINES:])
        raise RosmlError(
            f"mmdebstrap failed (exit code {done.returncode}):\n{end}", f"see {log}; check that Debian's mirrors answer"
        )


def add_folders(tar: Path) -> None:
    """Adds FOLDERS, empty, to an archive."""
    with tarfile.open(tar, "a") as archive:
        for name in FOLDERS:
            entry = tarfile.TarInfo(f"./{name}")
            entry.type, entry.mode, entry.mtime = tarfile.DIRTYPE, 0o755, EPOCH
            archive.addfile(entry)


def write_files(folder: Path, files: dict[str, tuple[int, str]]) -> None:
    """Writes files below a folder, for mmdebstrap to copy in."""
    for name, (mode, text) in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(mode)
    for path in [folder, *folder.rglob("*")]:
        if path.is_dir():
            path.chmod(0o755)


def write_layout(layout: Path, tar: Path, tag: str, architecture: str) -> str:
    """Writes an OCI image layout with one gzip layer; gives the manifest's digest."""
    blobs = layout / "blobs" / "sha256"
    blobs.mkdir(parents=True)
    diff_id, layer = compress(tar, blobs)
    created = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(EPOCH))
    config = put(
        blobs,
        CONFIG,
        {
            "architecture": architecture,
            "os": "linux",
            "created": created,
            "config": {
                "Env": ["PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"],
                "Cmd": ["bash"],
            },
            "rootfs": {"type": "layers", "diff_ids": [diff_id]},
            "history": [{"created": created, "created_by": f"mmdebstrap --variant=minbase {tag}"}],
        },
    )
    manifest = put(
        blobs,
        MANIFEST,
        {
            "schemaVersion": 2,
            "mediaType": MANIFEST,
            "config": config,
            "layers": [layer],
            "annotations": {RECIPE: recipe(tag, architecture)},
        },
    )
    (layout / "oci-layout").write_text('{"imageLayoutVersion": "1.0.0"}')
    entry = {**manifest, "annotations": {"org.opencontainers.image.ref.name": tag}}
    (layout / "index.json").write_text(json.dumps({"schemaVersion": 2, "manifests": [entry]}))
    return str(manifest["digest"])


def compress(tar: Path, blobs: Path) -> tuple[str, dict[str, Any]]:
    """Compresses a layer into the blobs: digest of its content, and its descriptor. No file name, no date in it."""
    content = hashlib.sha256()
    partial = blobs / "partial"
    with (
        tar.open("rb") as source,
        partial.open("wb") as target,
        gzip.GzipFile(filename="", mode="wb", compresslevel=6, fileobj=target, mtime=0) as packed,
    ):
        while chunk := source.read(1 << 20):
            content.update(chunk)
            packed.write(chunk)
    with partial.open("rb") as packed_file:
        digest = hashlib.file_digest(packed_file, "sha256").hexdigest()
    size = partial.stat().st_size
    partial.rename(blobs / digest)
    return f"sha256:{content.hexdigest()}", {"mediaType": LAYER, "digest": f"sha256:{digest}", "size": size}


def put(blobs: Path, media_type: str, content: dict[str, Any]) -> dict[str, Any]:
    """Writes a JSON blob; gives its descriptor."""
    data = json.dumps(content, sort_keys=True, separators=(",", ":")).encode()
    digest = hashlib.sha256(data).hexdigest()
    (blobs / digest).write_bytes(data)
    return {"mediaType": media_type, "digest": f"sha256:{digest}", "size": len(data)}


def push(services: Services, layout: Path, tag: str) -> None:
    """Copies a layout into the local registry.

    Raises:
        RosmlError: the registry does not answer or refuses.
    """
    [entry] = json.loads((layout / "index.json").read_text())["manifests"]
    blobs = layout / "blobs/sha256"
    manifest = (blobs / entry["digest"].removeprefix("sha256:")).read_bytes()
    with Registry(services.registry) as registry:
        content = json.loads(manifest)
        for blob in (content["config"], *content["layers"]):
            registry.put_blob(REPOSITORY, (blobs / blob["digest"].removeprefix("sha256:")).read_bytes())
        registry.put_manifest(REPOSITORY, tag, manifest, entry["mediaType"])
