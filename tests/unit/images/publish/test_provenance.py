"""Where images came from: what is said of base images, of the checkout and of who builds; nothing that tells of a machine.
What a publishing run attaches: test_attached.py."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from fakes.memory_registry import NEXT, publisher
from fakes.projects import git
from fakes.stubs import services
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import provenance
from rosml.images.publish.provenance import Machine

DATE = "2026-11-22T03:00:00Z"
DIGEST = "sha256:" + "1" * 64
GITHUB = {
    "GITHUB_ACTIONS": "true",
    "GITHUB_SERVER_URL": "https://github.com",
    "GITHUB_REPOSITORY": "me/rosml",
    "GITHUB_WORKFLOW_REF": "me/rosml/.github/workflows/nightly.yml@refs/heads/main",
    "GITHUB_RUN_ID": "7",
    "GITHUB_RUN_ATTEMPT": "2",
}


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    folder = tmp_path / "checkout"
    (folder / "locks").mkdir(parents=True)
    (folder / "locks/a.txt").write_text("torch==1\n")
    git(folder.parent, "init", "-q", str(folder))
    git(folder, "add", ".")
    git(folder, "commit", "-qm", "first")
    return folder


def test_who_builds() -> None:
    assert Machine.here(DATE, {}) == Machine(provenance.OWN_MACHINE, DATE)
    machine = Machine.here(DATE, GITHUB)
    assert machine.builder == "https://github.com/me/rosml/.github/workflows/nightly.yml@refs/heads/main"
    assert machine.invocation == "https://github.com/me/rosml/actions/runs/7/attempts/2"
    # Variables that are left over on somebody's machine make it no workflow.
    assert Machine.here(DATE, GITHUB | {"GITHUB_ACTIONS": ""}).builder == provenance.OWN_MACHINE


@pytest.mark.parametrize(
    ("reference", "repository"),
    [
        (f"debian:bookworm@{DIGEST}", "docker.io/library/debian"),
        (f"docker.io/library/debian:bookworm@{DIGEST}", "docker.io/library/debian"),
        (f"docker-image://ubuntu:24.04@{DIGEST}", "docker.io/library/ubuntu"),
        (f"me/debian:1@{DIGEST}", "docker.io/me/debian"),
        (f"ghcr.io/me/debian@{DIGEST}", "ghcr.io/me/debian"),
        (f"127.0.0.1:5000/library/assembler@{DIGEST}", "127.0.0.1:5000/library/assembler"),
    ],
)
def test_base_images(reference: str, repository: str) -> None:
    descriptor = provenance.base(reference, DIGEST)
    assert descriptor["uri"].endswith(f"?repository_url={repository}")
    assert descriptor["digest"] == {"sha256": "1" * 64}
    assert "annotations" not in descriptor
    another = provenance.base(reference, f"sha256:{'2' * 64}")
    assert another == {**descriptor, "annotations": {"differs": "matrix.yaml names another base image"}}


def test_the_checkout(checkout: Path, tmp_path: Path) -> None:
    head = git(checkout, "rev-parse", "HEAD")
    assert provenance.source(checkout) == [{"name": "source", "digest": {"gitCommit": head}}]
    git(checkout, "remote", "add", "origin", "https://me:s3cret@github.com/me/rosml.git?x=s3cret")
    (descriptor,) = provenance.source(checkout)
    assert descriptor["uri"] == "git+https://github.com/me/rosml.git"
    (checkout / "plan.json").write_text("{}")
    assert provenance.source(checkout) == [descriptor], "what a job leaves beside it decides no image"
    (checkout / "locks/a.txt").write_text("torch==2\n")
    (dirty,) = provenance.source(checkout)
    assert "differ" in dirty["annotations"]["differs"] and dirty["digest"] == {"gitCommit": head}
    git(checkout, "remote", "set-url", "origin", "/home/me/rosml")
    assert "uri" not in provenance.source(checkout)[0], "a path of this machine"
    assert provenance.source(tmp_path) == [], "no checkout"
    assert provenance.source(checkout / "locks") == [], "a checkout of something else around it"


def test_locks(checkout: Path) -> None:
    digest = {"sha256": hashlib.sha256(b"torch==1\n").hexdigest()}
    assert provenance.locks(checkout, ["locks/a.txt"]) == [{"name": "locks/a.txt", "digest": digest}]


def test_the_statements_of_other_builders_stay(
    project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    registry = publisher(project, services(project), monkeypatch)
    registry.publish(image_set, only=["alpha-core"])
    for name, text in GITHUB.items():
        monkeypatch.setenv(name, text)
    run = registry.publish(image_set, only=["alpha-core"], date=NEXT, force=True)
    builders = run.state.entries["alpha-core", "amd64"].provenance.keys()
    assert builders == {provenance.OWN_MACHINE, Machine.here(NEXT, GITHUB).builder}
