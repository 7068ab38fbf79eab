"""Scans of real images by the real trivy, with a small database in the place of the real one.

The database is written by trivy's own library from advisories that are made up here, and fetched from the local
registry as the real one is from its own. What is not verified so: the real database's content.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.build import part as building
from rosml.images.image_set import ImageSet
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.scan import judge, locked, policy, sbom
from rosml.scan.judge import Outcome, Part
from rosml.scan.trivy import Database, ScannerFailed, Trivy
from tests.e2e.conftest import LOG, NAMESPACE, Published
from tests.e2e.mini import NATIVE
from tests.e2e.vulnerabilities import UPDATED, installed, put, put_database, rules_with, write_database

pytestmark = pytest.mark.full(proof="scanner")


@pytest.fixture(scope="module")
def trivy(tmp_path_factory: pytest.TempPathFactory, services: Services) -> Trivy:
    return installed(tmp_path_factory.mktemp("trivy"), services.environment())


@pytest.fixture(scope="module")
def registry(services: Services) -> Any:
    return oci.Registry(services.registry)


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


@pytest.fixture(scope="module")
def joined(services: Services, image_set: ImageSet, registry: Any, published: Callable[[str], Published]) -> Joined:
    ros = published("ros1-bookworm-core")
    item = building.find(image_set, "common-cu128-py311")
    made = building.publish(services, image_set, item, LOG.info, NAMESPACE)
    index = registry.manifest(f"{NAMESPACE}/part", made.digest).content
    wheels = next(
        (it["digest"] for it in index.get("manifests", []) if it["platform"]["architecture"] == NATIVE), made.digest
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
    return Joined(parts, repository, put(registry, repository, "latest", content))


def found(report: dict[str, Any]) -> set[tuple[str, str, str]]:
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
    records: dict[str, str] = {}
    shelf = sbom.Shelf(registry, f"trivy {trivy.version}", records, records.__setitem__)
    facts: dict[str, Any] = {"now": datetime.now(UTC), "whole": True, "say": LOG.info}
    run = judge.scan_images([image], rules, trivy, shelf, **facts)
    (scanned,) = run.images
    assert scanned.outcome is Outcome.POLICY_FAILED, scanned.reason
    assert {(it.id, it.part) for it in scanned.failing} == {
        ("CVE-2026-90001", "ros1-bookworm-core"),
        ("CVE-2026-90004", "common-cu128-py311"),
    }
    assert "libc6" in {it.package for it in scanned.findings if it.id == "CVE-2026-90002"}
    assert "CVE-2026-90003" not in {it.id for it in scanned.findings}
    assert scanned.packages > 400

    said: list[str] = []
    next_night = sbom.Shelf(registry, f"trivy {trivy.version}", records)
    again = judge.scan_images([image], rules, trivy, next_night, **{**facts, "say": said.append})
    assert again.images == run.images
    assert said == ["scan ros1-bookworm-core", "scan common-cu128-py311"]  # no layer was read again


def test_by_sbom_and_by_digest_the_same_is_found(
    trivy: Trivy, rules: policy.Rules, database: Database, registry: Any, joined: Joined, services: Services
) -> None:
    """The sum of the parts' findings is what trivy finds in the joined image itself."""
    scanner = judge.Scanner(trivy, sbom.Shelf(registry, f"trivy {trivy.version}"), database, LOG.info)
    parts = {(it.id, it.package, it.installed) for part in joined.parts for it in scanner.report(part).findings}
    file = trivy.folder / "report.json"
    reference = f"{services.registry}/{joined.repository}@{joined.digest}"
    arguments = ("--output", str(file), "--format", "json", "--scanners", "vuln", "--skip-db-update", reference)
    trivy.run("image", "--image-src", "remote", *arguments, seconds=600)
    assert found(json.loads(file.read_text())) == parts
    assert len(parts) > 2


def test_a_database_that_is_too_old(
    trivy: Trivy, rules: policy.Rules, registry: Any, joined: Joined, tmp_path: Path
) -> None:
    old = Trivy(trivy.program, trivy.version, tmp_path, trivy.environment)
    write_database(tmp_path / "db", UPDATED - timedelta(days=9))
    image = judge.Image("joined", NATIVE, joined.parts)
    shelf = sbom.Shelf(registry, f"trivy {trivy.version}")
    run = judge.scan_images([image], rules, old, shelf, now=datetime.now(UTC), whole=True)
    assert run.outcome is Outcome.SCANNER_FAILED
    assert "was made 9 days ago" in run.images[0].reason


def test_a_damaged_database(trivy: Trivy, joined: Joined, database: Database, tmp_path: Path) -> None:
    """Cut short, as by a full disk: the real trivy fails, and does not find nothing."""
    damaged = Trivy(trivy.program, trivy.version, tmp_path, trivy.environment)
    write_database(tmp_path / "db")
    file = tmp_path / "db" / "trivy.db"
    file.write_bytes(file.read_bytes()[:5000])
    content = trivy.sbom(joined.parts[0].reference)
    with pytest.raises(ScannerFailed):
        damaged.scan(json.dumps(content).encode(), "ros1-bookworm-core")


def test_an_image_that_is_not_there(trivy: Trivy, joined: Joined) -> None:
    part = joined.parts[0]
    with pytest.raises(ScannerFailed, match=r"MANIFEST_UNKNOWN|manifest unknown|NAME_UNKNOWN"):
        trivy.sbom(f"{part.registry}/{part.repository}@sha256:{'0' * 64}")


def test_a_lock_is_scanned_as_the_part_that_is_made_of_it(
    image_set: ImageSet, trivy: Trivy, rules: policy.Rules, database: Database
) -> None:
    """numpy, of which the database knows something, is found in each lock that pins it, and in no other."""
    texts = {path: (ROOT / path).read_text() for path in image_set.part_by_name["common-cu128-py311"].locks}
    (found,) = locked.refused(image_set, texts, rules, trivy, datetime.now(UTC), LOG.info)
    assert (found.package, found.id, found.fixed) == ("numpy", "CVE-2026-90004", "99.0")
    assert set(found.locks) == texts.keys() and found.images
