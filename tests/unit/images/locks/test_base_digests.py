"""Base images whose tags moved: found in a registry, written into the matrix with all else as it was, told in a table; and that
what is built from them counts their digests as inputs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import SMALL

from fakes.http_registry import LocalRegistry
from rosml.cli import command
from rosml.cli.images import locks as script
from rosml.images.locks import base_digests
from rosml.images.matrix import source
from rosml.registry import oci
from rosml.registry.client import Registry

OLD = "sha256:" + "1" * 64
OTHER = "sha256:" + "2" * 64
BOTH = ("amd64", "arm64")


@pytest.fixture
def hub(server: LocalRegistry) -> LocalRegistry:
    return server


def push(
    hub: LocalRegistry,
    repository: str,
    tag: str,
    architectures: tuple[str, ...] = BOTH,
    mark: str = "",
    onbuild: str = "",
) -> str:
    """Puts an index under a tag; gives its digest."""
    with Registry(hub.address) as registry:
        config = oci.encoded({"config": {"OnBuild": [onbuild] if onbuild else []}})
        registry.put_blob(repository, config)
        image = oci.encoded({"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, config)})
        registry.put_manifest(repository, "", image)
        member = oci.descriptor(oci.IMAGE, image)
        manifests = [{**member, "platform": {"os": "linux", "architecture": name}} for name in architectures]
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": manifests, "annotations": {"mark": mark}}
        return registry.put_manifest(repository, tag, content, oci.INDEX)


@pytest.fixture
def matrix(hub: LocalRegistry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A matrix whose images are in the local replacement, with comments, and an image of NVIDIA's."""
    monkeypatch.setattr(script, "ROOT", tmp_path)
    text = SMALL.replace("docker.io/library/ubuntu:24.04", f"{hub.address}/library/ubuntu:24.04")
    text = text.replace("docker.io/library/ubuntu:26.04", f"{hub.address}/nvidia/cuda:13.0.2-runtime-ubuntu26.04")
    text = text.replace(f"    digest: {OLD}\n", f"    # of a day\n    digest:  {OLD} # renewed by its makers\n")
    text = text.replace("    codename: noble\n", f"    codename: noble # {OLD} is no digest of ours\n")
    (tmp_path / "matrix.yaml").write_text(f"# {OLD} was the first one\n{text}")
    return tmp_path / "matrix.yaml"


def run(matrix: Path, *arguments: str) -> int:
    return command.run(script.main, arguments=["--matrix", str(matrix), *arguments])


def test_what_moved_is_written_and_nothing_else(
    hub: LocalRegistry, matrix: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    before = matrix.read_text()
    new = push(hub, "library/ubuntu", "24.04", mark="new")
    cuda = push(hub, "nvidia/cuda", "13.0.2-runtime-ubuntu26.04", mark="new")
    assert run(matrix, "--bases", "--check") == 1
    done = capsys.readouterr()
    assert f"ubuntu-24.04: {hub.address}/library/ubuntu:24.04: would move from {OLD[:19]} to {new[:19]}" in done.out
    assert "2 base images are outdated" in done.err and "rosml locks --bases" in done.err
    assert run(matrix, "--bases", "--check", "--json") == 1
    data = json.loads(capsys.readouterr().out)
    assert data["base_images"][0] == {
        "system": "ubuntu-24.04",
        "image": f"{hub.address}/library/ubuntu:24.04",
        "old": OLD,
        "new": new,
    }
    assert len(data["base_images"]) == 2 and data["moved"] == data["changed"] == []
    assert matrix.read_text() == before
    assert run(matrix, "--bases", "--report", str(tmp_path / "report.md")) == 0
    assert matrix.read_text() == before.replace(f"digest:  {OLD} # renewed", f"digest:  {new} # renewed").replace(
        f"    digest: {OTHER}\n", f"    digest: {cuda}\n"
    )
    report = (tmp_path / "report.md").read_text()
    assert f"| ubuntu-24.04 | {hub.address}/library/ubuntu:24.04 | {OLD[:19]} | {new[:19]} |" in report
    capsys.readouterr()
    assert run(matrix, "--bases", "--check") == 0
    assert "2 base images, 0 outdated" in capsys.readouterr().out


@pytest.mark.parametrize("body", [f" {{image: a.b/c:d, digest: {OLD}, python: x}}", f"\n    digest:\n      {OLD}"])
def test_however_it_is_written(body: str) -> None:
    text = f"operating_systems:\n  one:{body}\n"
    pin = base_digests.Pin("one", "a.b/c:d", OLD, OTHER)
    assert base_digests.rewritten(text, source.parse(text.encode()), [pin]) == text.replace(OLD, OTHER)


@pytest.mark.parametrize(
    ("fault", "says"),
    [
        ("missing", "is not there any more"),
        ("arm64", "is not there for linux/arm64 now"),
        ("no index", "its tag points at no index"),
        ("onbuild", "has ONBUILD, which a builder runs itself, outside of the network of steps: ADD http://x /"),
        ("down", "does not answer"),
    ],
)
def test_what_cannot_be_taken_stays_and_stops_no_other(
    hub: LocalRegistry,
    matrix: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    fault: str,
    says: str,
) -> None:
    cuda = push(hub, "nvidia/cuda", "13.0.2-runtime-ubuntu26.04", mark="new")
    if fault == "arm64":
        push(hub, "library/ubuntu", "24.04", ("amd64",))
    elif fault == "onbuild":
        push(hub, "library/ubuntu", "24.04", onbuild="ADD http://x /")
    elif fault == "no index":
        with Registry(hub.address) as registry:
            registry.put_manifest("library/ubuntu", "24.04", {"schemaVersion": 2, "mediaType": oci.IMAGE})
    elif fault == "down":
        monkeypatch.setenv("ROSML_DOCKER_HUB", "0")
        matrix.write_text(matrix.read_text().replace(f"{hub.address}/library/ubuntu", "docker.io/library/ubuntu"))
    assert run(matrix, "--bases") == 0
    done = capsys.readouterr()
    assert "ubuntu-24.04: its base image stays as it is" in done.err and says in done.err
    assert OLD in matrix.read_text() and cuda in matrix.read_text()
