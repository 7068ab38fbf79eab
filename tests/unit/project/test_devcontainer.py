"""The dev container Feature that adds a part: it does what people's builders call, with a registry of the tests' own."""

from __future__ import annotations

import gzip
import io
import json
import platform
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from fakes.http_registry import Fault, LocalRegistry, local_registry
from rosml.registry import oci
from rosml.registry.client import Registry

FEATURE = ROOT / "devcontainer/src/part"
PYTHON = ".".join(platform.python_version_tuple()[:2])
SHORT = PYTHON.replace(".", "")
ARCHITECTURE = {"x86_64": "amd64", "aarch64": "arm64"}[platform.machine()]
FRAMEWORKS = "torch=cuda*,common,torch ml=cuda*,common,torch,tensorflow"


def layer(name: str) -> bytes:
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as archive:
        for path in (f"opt/{name}", "opt/last"):
            entry = tarfile.TarInfo(path)
            entry.size = len(name)
            archive.addfile(entry, io.BytesIO(name.encode()))
    return gzip.compress(stream.getvalue(), mtime=0)


def put(client: Registry, name: str, python: str, architecture: str = ARCHITECTURE) -> None:
    labels = {"part": name.partition("-")[0], "stack": "cu130", "python": python}
    labels |= {"addons": "onnx=cuda*,common,onnx"} if name.startswith("onnx") else {"frameworks": FRAMEWORKS}
    config = oci.encoded({"config": {"Labels": {f"io.rosml.{key}": value for key, value in labels.items()}}})
    content = layer(name)
    for blob in (config, content):
        client.put_blob("me/part", blob)
    manifest = oci.encoded(
        {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, config),
            "layers": [oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", content)],
        }
    )
    client.put_manifest("me/part", "", manifest)
    entry = {**oci.descriptor(oci.IMAGE, manifest), "platform": {"os": "linux", "architecture": architecture}}
    client.put_manifest("me/part", name, {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [entry]}, oci.INDEX)


@pytest.fixture
def registry() -> Iterator[LocalRegistry]:
    with local_registry() as server:
        with Registry(server.address) as client:
            put(client, "cuda-cu130", "any")
            for name in ("common", "torch", "tensorflow", "onnx"):
                put(client, f"{name}-cu130-py{SHORT}", PYTHON)
            put(client, "torch-cu130-py27", "2.7")
            put(client, "torch-cu130-other", PYTHON, "riscv64")
        yield server


def add(reference: str, root: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(FEATURE / "add_part.py"), reference, str(root)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_an_addon_comes_with_what_it_needs(registry: LocalRegistry, tmp_path: Path) -> None:
    done = add(f"{registry.address}/me/part:onnx-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 0, done.stderr
    names = {path.name for path in (tmp_path / "opt").iterdir()}
    assert names == {"cuda-cu130", f"common-cu130-py{SHORT}", f"onnx-cu130-py{SHORT}", "last"}


def test_a_part_comes_with_what_it_needs(registry: LocalRegistry, tmp_path: Path) -> None:
    done = add(f"{registry.address}/me/part:torch-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 0, done.stderr
    assert {path.name for path in (tmp_path / "opt").iterdir()} == {
        "last",
        "cuda-cu130",
        *(f"{name}-cu130-py{SHORT}" for name in ("common", "torch")),
    }
    assert (tmp_path / "opt/last").read_text() == f"torch-cu130-py{SHORT}", "in the order of all images"


def test_the_feature_calls_it(registry: LocalRegistry, tmp_path: Path) -> None:
    options = json.loads((FEATURE / "devcontainer-feature.json").read_text())["options"]
    assert [name.upper() for name in options] == ["PART"]
    done = subprocess.run([FEATURE / "install.sh"], env={"PATH": "/bin", "PART": ""}, capture_output=True, text=True)
    assert done.returncode == 1 and "error: no part is named" in done.stderr


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("torch-cu130-py27", f"is for Python 2.7, and the image has {PYTHON}"),
        ("torch-cu130-other", f"torch-cu130-other is not for {ARCHITECTURE}; there are: riscv64"),
        ("nothing", "there is none; check the name"),
    ],
)
def test_a_part_that_does_not_fit_is_refused(name: str, says: str, registry: LocalRegistry, tmp_path: Path) -> None:
    done = add(f"{registry.address}/me/part:{name}", tmp_path)
    assert done.returncode == 1 and says in done.stderr
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("reference", ["torch-cu130", "me/part:torch", "ghcr.io/me/part"])
def test_a_part_is_named_with_its_registry(reference: str, tmp_path: Path) -> None:
    assert "is no part with its registry" in add(reference, tmp_path).stderr


def test_what_a_registry_sends_is_compared(registry: LocalRegistry, tmp_path: Path) -> None:
    key = next(key for key, blob in registry.blobs.items() if blob == layer("cuda-cu130"))
    registry.blobs[key] = layer("cuda-cu130x")
    done = add(f"{registry.address}/me/part:torch-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 1 and "cuda-cu130 did not arrive whole" in done.stderr
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("kind", ["manifest", "config"])
def test_what_a_registry_says_of_a_part_is_compared(kind: str, registry: LocalRegistry, tmp_path: Path) -> None:
    """Another manifest brings other layers, with digests that fit; another config says that the part needs none."""
    name = f"torch-cu130-py{SHORT}"
    with Registry(registry.address) as client:
        index = client.manifest("me/part", name)
        assert index
        digest = index.content["manifests"][0]["digest"]
        other = client.manifest("me/part", f"tensorflow-cu130-py{SHORT}")
        manifest = client.manifest("me/part", digest)
        assert other and manifest
        replace = other.content["manifests"][0]["digest"]
        config = manifest.content["config"]["digest"]
    if kind == "manifest":
        registry.manifests[place(registry.manifests, digest)] = registry.manifests[place(registry.manifests, replace)]
    else:
        key = place(registry.blobs, config)
        registry.blobs[key] = registry.blobs[key].replace(b"cuda*,common,", b"")
    done = add(f"{registry.address}/me/part:{name}", tmp_path)
    assert done.returncode == 1 and "did not arrive whole" in done.stderr
    assert not [*tmp_path.iterdir()]


def place(content: dict[Any, Any], digest: str) -> Any:
    return next(key for key in content if digest in key)


@pytest.mark.parametrize(("status", "says"), [(403, "it wants a password"), (500, "HTTP 500")])
def test_a_registry_that_refuses_is_named(status: int, says: str, registry: LocalRegistry, tmp_path: Path) -> None:
    registry.faults.append(Fault("GET", "manifests", status, times=9))
    done = add(f"{registry.address}/me/part:torch-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 1 and says in done.stderr


def test_a_registry_that_wants_a_token_gives_everybody_one(registry: LocalRegistry, tmp_path: Path) -> None:
    registry.bearer = True
    done = add(f"{registry.address}/me/part:torch-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 0, done.stderr
    assert registry.tokens, "it gave one"


def test_a_file_of_this_machine_is_no_server_for_tokens(registry: LocalRegistry, tmp_path: Path) -> None:
    (tmp_path / "token.json").write_text('{"token": "x"}')
    registry.bearer, registry.realm = True, f"file://{tmp_path}/token.json"
    done = add(f"{registry.address}/me/part:torch-cu130-py{SHORT}", tmp_path)
    assert done.returncode == 1 and "names no server for tokens" in done.stderr


def test_no_registry_answers(tmp_path: Path) -> None:
    assert "does not answer" in add("127.0.0.1:1/me/part:torch", tmp_path).stderr


def test_the_template_asks_for_an_image() -> None:
    folder = ROOT / "devcontainer/templates/ros"
    options = json.loads((folder / "devcontainer-template.json").read_text())["options"]
    text = (folder / ".devcontainer/devcontainer.json").read_text()
    assert [f"${{templateOption:{name}}}" in text for name in options] == [True]
    assert (folder / ".devcontainer/Dockerfile").read_text().startswith("ARG IMAGE\nFROM ${IMAGE}\n")
