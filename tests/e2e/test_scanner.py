"""The real trivy finds what it must in the SBOM of a small image, with a database in a registry with TLS and a password, or one that issues tokens; where
it may not read, it fails. Needs no builder: the nightly's scan job runs it before it relies on trivy."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.scan import cyclonedx, judge, packages, policy, sbom
from rosml.images.scan.judge import Outcome, Part
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from tests.e2e import secure
from tests.e2e.calls import LOG
from tests.e2e.images import NATIVE
from tests.e2e.secure import NAME, PASSWORD, Secure, encoded
from tests.e2e.vulnerabilities import installed, put, put_database, rules_with

pytestmark = pytest.mark.full(proof="scanner")

SCRIPT = ROOT / "components/containerize/contents.py"

PACKAGE = """\
Package: {name}
Status: install ok installed
Maintainer: A test <a@example.org>
Architecture: all
Source: {source}
Version: {version}
Description: made up

"""
FILES = {
    "etc/debian_version": "12.12\n",
    "usr/lib/os-release": 'ID=debian\nVERSION_ID="12"\nPRETTY_NAME="Debian GNU/Linux 12 (bookworm)"\n',
    "var/lib/dpkg/status": PACKAGE.format(name="gpg", source="gnupg2", version="2.2.40-1.1")
    + PACKAGE.format(name="libc6", source="glibc", version="2.36-9")
    + PACKAGE.format(name="bash", source="bash", version="5.2.15-2"),
    "usr/lib/python3/dist-packages/numpy-2.1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: numpy\nVersion: 2.1.0\n",
}
"""An image with three packages of Debian and a wheel, of which the database knows something."""


@dataclass(frozen=True)
class Place:
    """A registry that is not everybody's, and what it takes to use it.

    Attributes:
        secure: the registry. services: a machine without a builder. docker: Docker's configuration folder.
    """

    secure: Secure
    services: Services
    docker: Path

    def client(self) -> Registry:
        return Registry(self.secure.host)

    def trivy(self, folder: Path) -> Trivy:
        return installed(folder, self.services.trusting())

    def put_database(self, folder: Path) -> policy.Rules:
        """Uploads the database; gives a policy that takes it from there."""
        put_database(self.client(), "security/trivy-db", folder)
        return rules_with(f"{self.secure.host}/security/trivy-db:2")

    def described(self, folder: Path) -> tuple[Part, sbom.Shelf]:
        """Uploads an image with what a build says of it."""
        for name, text in FILES.items():
            (folder / "root" / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / "root" / name).write_text(text)
        (folder / "out").mkdir()
        subprocess.run([sys.executable, SCRIPT, folder / "root", folder / "out"], check=True)
        client = self.client()
        config = oci.encoded({"architecture": NATIVE, "os": "linux", "rootfs": {"type": "layers", "diff_ids": []}})
        client.put_blob("images/small", config)
        content = {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, config),
            "layers": [],
        }
        digest = put(client, "images/small", "latest", content)
        part = Part("small", self.secure.host, "images/small", digest, True)
        listed = packages.read((folder / "out/packages.json").read_bytes())
        document = cyclonedx.document(listed, part.reference)
        subject = oci.descriptor(oci.IMAGE, oci.encoded(content))
        artifact = client.attach(part.repository, subject, sbom.MEDIA_TYPE, document, sbom.MEDIA_TYPE, sbom.FORMAT)
        return part, sbom.Shelf(client, {digest: artifact})


@pytest.fixture(params=["password", "tokens"])
def place(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with secure.used(tmp_path, request.param == "tokens", monkeypatch) as (secured, services, docker):
        yield Place(secured, services, docker)


def test_it_finds_what_it_must(place: Place, tmp_path: Path) -> None:
    """A package with a newer version and a wheel fail the policy, one without a newer version is listed, one that is mended is
    not found; and trivy itself reads the database with the user's password and certificates."""
    rules = place.put_database(tmp_path / "db")
    trivy = place.trivy(tmp_path / "trivy")
    part, shelf = place.described(tmp_path)
    trivy.fetch(rules.policy.database, say=LOG.info)
    image = judge.Image("small", NATIVE, (part,))
    (scanned,) = judge.scan_images([image], rules, judge.Scanner(trivy, shelf, LOG.info), datetime.now(UTC))
    assert scanned.outcome is Outcome.POLICY_FAILED, scanned.reason
    assert {it.id for it in scanned.failing} == {"CVE-2026-90001", "CVE-2026-90004"}
    assert {it.id for it in scanned.findings} == {"CVE-2026-90001", "CVE-2026-90002", "CVE-2026-90004"}
    assert scanned.packages == 4


@pytest.mark.parametrize("config", [{}, {"auth": encoded(NAME, "wrong")}])
def test_where_it_may_not_read_it_fails(place: Place, tmp_path: Path, config: dict[str, str]) -> None:
    rules = place.put_database(tmp_path / "db")
    trivy = place.trivy(tmp_path / "trivy")
    place.secure.docker_config(tmp_path / "other", {"auths": {place.secure.host: config}} if config else {})
    environment = {**trivy.environment, "DOCKER_CONFIG": str(tmp_path / "other")}
    stranger = replace(trivy, environment=environment, pause=0.0)
    with pytest.raises(ScannerFailed, match=r"(?i)unauthorized|denied|authentication required") as caught:
        stranger.fetch(rules.policy.database)
    assert encoded(NAME, PASSWORD) not in str(caught.value) and PASSWORD not in str(caught.value)


def test_a_certificate_that_nobody_trusts(place: Place, tmp_path: Path) -> None:
    rules = place.put_database(tmp_path / "db")
    trivy = place.trivy(tmp_path / "trivy")
    environment = {name: value for name, value in trivy.environment.items() if name != "SSL_CERT_FILE"}
    stranger = replace(trivy, environment=environment, pause=0.0)
    with pytest.raises(ScannerFailed, match=r"x509|certificate"):
        stranger.fetch(rules.policy.database)
