"""A database of vulnerabilities in trivy's own format, with a few that are made up here, as a registry has it."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import os
import subprocess
import tarfile
from collections.abc import Mapping
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.matrix import source
from rosml.images.scan import policy
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.machine.setup.installer import Installer
from rosml.machine.setup.state import State
from rosml.registry.client import Registry

UPDATED = datetime.now(UTC).replace(microsecond=0) - timedelta(hours=1)

ADVISORIES: list[dict[str, Any]] = [
    {"Source": "debian 12", "Package": "gnupg2", "ID": "CVE-2026-90001", "Severity": "HIGH", "Fixed": "999-1"},
    {"Source": "debian 12", "Package": "glibc", "ID": "CVE-2026-90002", "Severity": "CRITICAL", "Fixed": ""},
    {"Source": "debian 12", "Package": "bash", "ID": "CVE-2026-90003", "Severity": "CRITICAL", "Fixed": "1.0-1"},
    {"Source": "debian 12", "Package": "linux", "ID": "CVE-2026-90005", "Severity": "HIGH", "Fixed": "999-1"},
    {
        "Source": "pip::GitHub Security Advisory Pip",
        "Package": "numpy",
        "ID": "CVE-2026-90004",
        "Severity": "CRITICAL",
        "Vulnerable": ["<99.0"],
        "Patched": ["99.0"],
    },
]
"""Of a Debian package with a newer version, of one without, of one that is mended here already, of the kernel, and of a wheel."""


def installed(folder: Path, environment: Mapping[str, str]) -> Trivy:
    """The real scanner, with a folder for its database; the test fails where there is none."""
    try:
        return Trivy.find(ROOT, folder, environment)
    except ScannerFailed as error:
        pytest.fail(f"{error.message}: {error.remedy}", pytrace=False)


def write_database(folder: Path) -> None:
    """Writes a database with the program of `trivy_db`, which is built where it is not there yet."""
    module = ROOT / "tests" / "e2e" / "trivy_db"
    content = hashlib.sha256(b"".join((module / name).read_bytes() for name in ("main.go", "go.mod", "go.sum")))
    program = ROOT / ".state" / "cache" / f"trivy_db-{content.hexdigest()[:16]}"
    if not program.exists():
        state = State(ROOT, ca_bundle=os.environ.get("SSL_CERT_FILE", ""))
        installer = Installer(state)
        try:
            go = installer.go()
        except RosmlError as error:
            pytest.fail(
                f"the program that writes trivy's database is built: {error.message}; {error.remedy}", pytrace=False
            )
        with turn(state.run / "lock", lambda: None):
            env = installer.go_environment()
            subprocess.run([go, "build", "-trimpath", "-o", str(program), "."], cwd=module, env=env, check=True)
            installer.drop_go_caches()
    request = {"Updated": UPDATED.isoformat(), "Advisories": [{**it, "PublishedBy": "test"} for it in ADVISORIES]}
    subprocess.run([str(program), str(folder)], input=json.dumps(request), text=True, check=True)


def put(registry: Registry, repository: str, reference: str, content: dict[str, Any]) -> str:
    """Uploads a manifest; gives its digest."""
    digest: str = registry.put_manifest(repository, reference, content, content["mediaType"])
    return digest


def put_database(registry: Registry, repository: str, folder: Path) -> None:
    """Uploads a database as trivy publishes its own, into an empty folder first."""
    write_database(folder)
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as archive:
        for name in ("trivy.db", "metadata.json"):
            archive.add(folder / name, name)
    layer = gzip.compress(packed.getvalue())
    config, image = "application/vnd.aquasec.trivy.config.v1+json", "application/vnd.oci.image.manifest.v1+json"
    content = {
        "schemaVersion": 2,
        "mediaType": image,
        "config": {"mediaType": config, "digest": registry.put_blob(repository, b"{}"), "size": 2},
        "layers": [
            {
                "mediaType": "application/vnd.aquasec.trivy.db.layer.v1.tar+gzip",
                "digest": registry.put_blob(repository, layer),
                "size": len(layer),
                "annotations": {"org.opencontainers.image.title": "db.tar.gz"},
            }
        ],
    }
    put(registry, repository, "2", content)


def rules_with(*repositories: str, ignore: str = "") -> policy.Rules:
    """The project's policy, with a database from other places, and perhaps with other entries of `ignore`."""
    text = (ROOT / "scan.yaml").read_text()
    if ignore:
        text = f"{text.partition('ignore:')[0]}ignore:\n{ignore}"
    line_before = next(line for line in text.splitlines() if line.startswith("  repositories:"))
    text = text.replace(line_before, f"  repositories: [{', '.join(repositories)}]")
    return policy.parsed(source.parse(text.encode(), "scan.yaml"))
