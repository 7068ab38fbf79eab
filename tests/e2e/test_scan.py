"""Scans of real images by the real trivy, with a small database in the place of the real one.

The database is written by trivy's own library from advisories that are made up here, and fetched from the local
registry as the real one is from its own. What is not verified so: the real database's content.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.images.builds import contents
from rosml.images.builds import part as building
from rosml.images.image_set.model import ImageSet
from rosml.images.scan import judge, locked, policy, sbom
from rosml.images.scan.judge import Outcome, Part
from rosml.images.scan.trivy import Database, Result, ScannerFailed, Trivy
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests.e2e.calls import LOG, NAMESPACE
from tests.e2e.images import NATIVE, Publish
from tests.e2e.vulnerabilities import UPDATED, installed, put, put_database, rules_with, write_database

pytestmark = pytest.mark.full(proof="scanner")


@pytest.fixture(scope="module")
def trivy(tmp_path_factory: pytest.TempPathFactory, services: Services) -> Trivy:
    return installed(tmp_path_factory.mktemp("trivy"), services.environment())


@pytest.fixture(scope="module")
def registry(services: Services) -> Any:
    return Registry(services.registry)


@pytest.fixture(scope="module")
def rules(services: Services, registry: Any, tmp_path_factory: pytest.TempPathFactory) -> policy.Rules:
    """The project's policy, with a repository of the local registry that has the database as trivy publishes it."""
    repository = f"{NAMESPACE}/trivy-db"
    put_database(registry, repository, tmp_path_factory.mktemp("db"))
    return rules_with(f"{services.registry}/{NAMESPACE}/none:2", f"{services.registry}/{repository}")


@pytest.fixture(scope="module")
def database(trivy: Trivy, rules: policy.Rules) -> Database:
    return trivy.fetch(rules.policy.database, say=LOG.info)


@dataclass(frozen=True)
class Joined:
    """A ROS image and a part, and an image that is the sum of them."""

    parts: tuple[Part, ...]
    repository: str
    digest: str
    shelf: sbom.Shelf


@pytest.fixture(scope="module")
def joined(services: Services, image_set: ImageSet, registry: Any, published: Publish) -> Joined:
    ros = published("ros1-bookworm-core")
    item = building.by_name(image_set, "common-cu128-py311")
    builder = building.PartBuilder(services, image_set, f"{services.registry}/{NAMESPACE}", LOG.info)
    assembled = builder.publish(item)
    index = registry.manifest(f"{NAMESPACE}/part", assembled.digest).content
    wheels = next(
        (it["digest"] for it in index.get("manifests", []) if it["platform"]["architecture"] == NATIVE),
        assembled.digest,
    )
    path, _, digest = ros.reference.removeprefix(services.registry).partition("@")
    parts = (
        Part("ros1-bookworm-core", services.registry, path.removeprefix("/"), digest, True),
        Part(item.name, services.registry, f"{NAMESPACE}/part", wheels, False),
    )
    repository = f"{NAMESPACE}/joined"
    manifests = [registry.manifest(part.repository, part.digest).content for part in parts]
    configs = [
        json.loads(registry.blob(part.repository, it["config"]["digest"]))
        for part, it in zip(parts, manifests, strict=True)
    ]
    for part, manifest in zip(parts, manifests, strict=True):
        for layer in manifest["layers"]:
            assert registry.mount(repository, layer["digest"], part.repository)
    configs[0]["rootfs"]["diff_ids"] += configs[1]["rootfs"]["diff_ids"]
    configs[0]["history"] = []
    config = json.dumps(configs[0]).encode()
    content = {**manifests[0], "layers": manifests[0]["layers"] + manifests[1]["layers"]}
    content["config"] = {**content["config"], "digest": registry.put_blob(repository, config), "size": len(config)}
    described = [(part.repository, part.digest) for part in parts]
    artifacts = contents.attach(services, image_set, registry, described, LOG.info)
    return Joined(parts, repository, put(registry, repository, "latest", content), sbom.Shelf(registry, artifacts))


JARS = "**/*.[jwep]ar"
"""Archives of Java: to name them, trivy would fetch a second database."""


def packages_of(results: Iterable[Result]) -> set[tuple[str, ...]]:
    """Kind, name, version and source of all packages that trivy looked at, without those of another system: trivy takes what
    a wheel says of the libraries in it for packages of the image."""
    return {
        (result.Type, it["Name"], version(it), it.get("SrcName", ""), version(it, "Src"))
        for result in results
        for it in result.Packages or []
        if it.get("Identifier", {}).get("PURL", "").startswith(("pkg:deb/debian/", "pkg:pypi/"))
    }


def version(package: dict[str, Any], of: str = "") -> str:
    """The version of a package, or of its source package, which trivy keeps in up to three pieces."""
    epoch, upstream, release = (package.get(f"{of}{name}") for name in ("Epoch", "Version", "Release"))
    return f"{epoch}:" * bool(epoch) + f"{upstream or ''}" + f"-{release}" * bool(release)


def findings(report: dict[str, Any]) -> set[tuple[str, str, str]]:
    """Advisory, package and version of all that trivy reports."""
    return {
        (it["VulnerabilityID"], it["PkgName"], it["InstalledVersion"])
        for result in report["Results"]
        for it in result.get("Vulnerabilities") or []
    }


def test_trivy_is_the_pinned_one(trivy: Trivy) -> None:
    """And the local replacement's library is the one that it is made of."""
    modules = [(ROOT / path / "go.mod").read_text().split() for path in ("tools/go/trivy", "tests/e2e/trivy_db")]
    versions = {words[words.index("github.com/aquasecurity/trivy-db") + 1] for words in modules}
    assert len(versions) == 1


def test_the_database_is_fetched_from_a_registry(database: Database, rules: policy.Rules) -> None:
    assert database.source == rules.policy.database.repositories[1]
    assert database.updated == UPDATED.strftime("%Y-%m-%dT%H:%M:%SZ")


def test_what_the_database_knows(trivy: Trivy, database: Database) -> None:
    assert trivy.lacks(["debian 12", "pip::", "debian 13", "ubuntu 24.04"]) == ["debian 13", "ubuntu 24.04"]


def test_parts_are_scanned(
    trivy: Trivy, rules: policy.Rules, database: Database, registry: Any, joined: Joined
) -> None:
    """Debian's packages and Python's wheels; what no version mends is listed, and what is mended here is not."""
    image = judge.Image("ros1-bookworm-core-common-cu128", NATIVE, joined.parts)
    scanner = judge.Scanner(trivy, joined.shelf, LOG.info)
    (scanned,) = judge.scan_images([image], rules, scanner, datetime.now(UTC))
    assert scanned.outcome is Outcome.POLICY_FAILED, scanned.reason
    assert {(it.id, it.part) for it in scanned.failing} == {
        ("CVE-2026-90001", "ros1-bookworm-core"),
        ("CVE-2026-90004", "common-cu128-py311"),
    }
    assert "libc6" in {it.package for it in scanned.findings if it.id == "CVE-2026-90002"}
    assert "CVE-2026-90003" not in {it.id for it in scanned.findings}
    assert scanned.packages > 400


def test_builds_say_of_images_what_trivy_reads_in_them(
    trivy: Trivy, database: Database, joined: Joined, services: Services
) -> None:
    """The same packages, each of the same source, and the same findings: of the parts together as of the joined image."""
    scanner = judge.Scanner(trivy, joined.shelf, LOG.info)
    parts = {(it.id, it.package, it.installed) for part in joined.parts for it in scanner.report(part).findings}
    file = trivy.folder / "report.json"
    reference = f"{services.registry}/{joined.repository}@{joined.digest}"
    arguments = ("--format", "json", "--scanners", "vuln", "--list-all-pkgs", "--skip-db-update", "--skip-files", JARS)
    trivy.run("image", "--output", str(file), "--image-src", "remote", *arguments, reference, seconds=600)
    read = json.loads(file.read_text())
    assert findings(read) == parts
    assert len(parts) > 2
    reports = [trivy.scan(joined.shelf.load(part.repository, part.digest).content, part.name) for part in joined.parts]
    assert packages_of(result for report in reports for result in report.Results or []) == packages_of(
        Result.model_validate(result) for result in read["Results"]
    )


def test_a_damaged_database(trivy: Trivy, joined: Joined, database: Database, tmp_path: Path) -> None:
    """Cut short, as by a full disk: the real trivy fails, and does not find nothing."""
    damaged = Trivy(trivy.program, trivy.version, tmp_path, trivy.environment)
    write_database(tmp_path / "db")
    file = tmp_path / "db" / "trivy.db"
    file.write_bytes(file.read_bytes()[:5000])
    ros = joined.parts[0]
    with pytest.raises(ScannerFailed):
        damaged.scan(joined.shelf.load(ros.repository, ros.digest).content, ros.name)


def test_a_lock_is_scanned_as_the_part_that_is_made_of_it(
    image_set: ImageSet, trivy: Trivy, rules: policy.Rules, database: Database
) -> None:
    """numpy, of which the database knows something, is found in each lock that pins it, and in no other."""
    texts = {path: (ROOT / path).read_text() for path in image_set.part_by_name["common-cu128-py311"].locks}
    (finding,) = locked.refused(image_set, texts, rules, trivy, datetime.now(UTC), LOG.info)
    assert (finding.package, finding.id, finding.fixed) == ("numpy", "CVE-2026-90004", "99.0")
    assert set(finding.locks) == texts.keys() and finding.images
