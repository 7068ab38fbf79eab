"""The real trivy finds what it must in the SBOM of a small image, with a database in a registry with TLS and a password, or one that issues tokens; where
it may not read, it fails. Needs no builder: the nightly's scan job runs it before it relies on trivy."""

from __future__ import annotations

import gzip
import io
import json
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.scan import cyclonedx, judge, packages, policy, sbom, vex
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
    + PACKAGE.format(name="bash", source="bash", version="5.2.15-2")
    + PACKAGE.format(name="linux-libc-dev", source="linux", version="6.1.1-1"),
    "usr/lib/python3/dist-packages/numpy-2.1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: numpy\nVersion: 2.1.0\n",
}
"""An image with four packages of Debian and a wheel, of which the database knows something."""


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

    def put_database(self, folder: Path, ignore: str = "") -> policy.Rules:
        """Uploads the database; gives a policy that takes it from there."""
        put_database(self.client(), "security/trivy-db", folder)
        return rules_with(f"{self.secure.host}/security/trivy-db:2", ignore=ignore)

    def described(self, folder: Path) -> tuple[Part, sbom.Shelf]:
        """Uploads an image with what a build says of it."""
        for name, text in FILES.items():
            (folder / "root" / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / "root" / name).write_text(text)
        (folder / "out").mkdir()
        subprocess.run([sys.executable, SCRIPT, folder / "root", folder / "out"], check=True)
        client = self.client()
        packed = io.BytesIO()
        with tarfile.open(fileobj=packed, mode="w") as archive:
            archive.add(folder / "root", ".")
        layer = gzip.compress(packed.getvalue())
        rootfs = {"type": "layers", "diff_ids": [oci.digest_of(packed.getvalue())]}
        config = oci.encoded({"architecture": NATIVE, "os": "linux", "rootfs": rootfs})
        for blob in (config, layer):
            client.put_blob("images/small", blob)
        content = {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, config),
            "layers": [oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", layer)],
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
    assert {it.id for it in scanned.findings} == {
        "CVE-2026-90001",
        "CVE-2026-90002",
        "CVE-2026-90004",
        "CVE-2026-90005",
    }
    assert scanned.packages == 5


ENTRIES = """\
- {id: CVE-2026-90001, reason: nobody verifies signatures with it, expires: 2099-01-31}
- {id: CVE-2026-90002, status: not_affected, justification: vulnerable_code_not_in_execute_path,
   reason: nobody calls it, expires: 2099-01-31}
- {id: CVE-2026-90004, status: fixed, reason: the wheel has the fix, expires: 2099-01-31}
"""


def by_hand(trivy: Trivy, folder: Path, *arguments: str) -> list[tuple[str, str]]:
    """The advisories and packages that trivy lists, as a person calls it."""
    output = folder / "by-hand.json"
    options = ("--format", "json", "--scanners", "vuln", "--skip-db-update", "--offline-scan", "--output", str(output))
    trivy.run(arguments[0], *options, *arguments[1:], seconds=600)
    results = json.loads(output.read_text()).get("Results") or []
    return sorted(
        (it["VulnerabilityID"], it["PkgName"]) for item in results for it in item.get("Vulnerabilities") or []
    )


def test_a_scanner_with_the_vex_lists_what_the_verdict_lists(place: Place, tmp_path: Path) -> None:
    """It drops what does not matter: by the SBOM and by the image, from OpenVEX and from CycloneDX. What is accepted although it
    matters is listed by both."""
    rules = place.put_database(tmp_path / "db", ENTRIES)
    trivy = place.trivy(tmp_path / "trivy")
    part, shelf = place.described(tmp_path)
    trivy.fetch(rules.policy.database, say=LOG.info)
    image = judge.Image("small", NATIVE, (part,))
    (scanned,) = judge.scan_images([image], rules, judge.Scanner(trivy, shelf, LOG.info), datetime.now(UTC))
    assert scanned.outcome is Outcome.CLEAN, scanned.reason
    verdict = sorted((it.id, it.package) for it in scanned.findings if it.status not in vex.HARMLESS)
    assert verdict == [("CVE-2026-90001", "gpg")], "accepted, and said so"
    files = {"sbom": shelf.load(part.repository, part.digest).content}
    judged = part.reference, vex.statements(scanned.findings), "2026-11-22T03:00:00Z"
    files |= {"openvex": vex.openvex(*judged), "cyclonedx": vex.in_cyclonedx(*judged)}
    places = {name: tmp_path / f"{name}.json" for name in files}
    for name, content in files.items():
        places[name].write_bytes(content)
    sbom_file, image_name = str(places["sbom"]), ("--image-src", "remote", part.reference)
    assert len(by_hand(trivy, tmp_path, "sbom", sbom_file)) == len(scanned.findings) == 4
    assert by_hand(trivy, tmp_path, "sbom", "--vex", str(places["openvex"]), sbom_file) == verdict
    assert by_hand(trivy, tmp_path, "sbom", "--vex", str(places["cyclonedx"]), sbom_file) == verdict
    assert by_hand(trivy, tmp_path, "image", "--vex", str(places["openvex"]), *image_name) == verdict


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
