"""The apt sources of base images: what their files say, and how they are read from a registry."""

from __future__ import annotations

import gzip
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import pytest
from conftest import smaller

from fakes import archives
from fakes.http_registry import LocalRegistry
from fakes.memory_registry import DAY, PREFIX, MemoryRegistry
from rosml.base.archives import zstd
from rosml.base.errors import RosmlError
from rosml.images.builds import apt_sources, base_images, sync
from rosml.images.builds.apt_sources import Source
from rosml.images.matrix.model import OperatingSystem
from rosml.images.publish.state import Request
from rosml.images.publish.survey import survey
from rosml.machine.services import Services
from rosml.registry import oci, retries
from rosml.registry.client import Registry
from rosml.registry.place import Place

T = TypeVar("T")
Entry = str | tuple[str, archives.Content]

LIST, PARTS = "etc/apt/sources.list", "etc/apt/sources.list.d"
TAR = "application/vnd.oci.image.layer.v1.tar"
GZIP = f"{TAR}+gzip"
NAME, VARIABLE = "system-1.0", "OS_SYSTEM_1_0"
MAIN = "deb http://archive.test/system one main\n"
ONE = (Source("http://archive.test/system", "one", ("main",)),)
NOBLE = """\
## Types: Append deb-src to include the fetching of source package.
Types: deb
URIs: http://archive.ubuntu.com/ubuntu/
Suites: noble noble-updates
Components: main universe
Signed-By: /usr/share/keyrings/ubuntu-archive-keyring.gpg
"""


# ---- What the files say ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("file", "text", "sources"),
    [
        ("a.list", "deb [ arch=amd64 signed-by=/k.gpg ] https://a.test/x/ one main # why\n", ["https://a.test/x one main"]),
        ("a.list", "  deb\thttp://a.test  one/updates   main\tother\n", ["http://a.test one/updates main other"]),
        ("a.list", "deb http://a.test ./\n", ["http://a.test ./"]),
        ("a.list", "deb-src http://a.test one main\n#deb http://b.test one main\n", []),
        ("a.list", "deb cdrom:[Debian 12 _amd64_]/ one main\ndeb file:/x one main\ndeb mirror+http://a.test/m one main\n", []),
        ("a.list", "deb http://a.test one main\ndeb http://a.test one main extra\n", ["http://a.test one main extra"]),
        ("a.sources", "TYPES: deb-src deb\nuris: http://a.test\nSuites: one\nComponents: main\n", ["http://a.test one main"]),
        (
            "a.sources",
            "Types: deb\nURIs: http://a.test\n mirror+http://b.test\n\thttps://c.test/\nSuites: one\n# two\n three\n"
            "Components:\n main\nSigned-By:\n -----BEGIN\n .\n Types: deb-src\n",
            ["http://a.test one main", "http://a.test three main", "https://c.test one main", "https://c.test three main"],
        ),
        ("a.sources", "Enabled: no\nTypes: deb\nURIs: http://a.test\nSuites: one\nComponents: main\n", []),
        ("a.sources", "Types: deb-src\nURIs: http://a.test\nSuites: one\nComponents: main\n", []),
        (
            "a.sources",
            "Enabled: False\nTypes: deb\n \t\n\nEnabled: yes\nTypes: deb\nURIs: http://a.test\nSuites: x/\n\n\n",
            ["http://a.test x/"],
        ),
    ],
)  # fmt: skip
def test_sources_as_apt_reads_them(file: str, text: str, sources: list[str]) -> None:
    parsed = apt_sources.parse({f"{PARTS}/{file}": text}, "image")
    assert [" ".join((source.address, source.suite, *source.components)) for source in parsed] == sources


@pytest.mark.parametrize(
    ("file", "text", "line"),
    [
        ("a.list", "# x\ndeb http://a.test\n", 2),
        ("a.list", "deb http://a.test one\n", 1),
        ("a.list", "deb http://a.test one/ main\n", 1),
        ("a.sources", "# x\n\nTypes: deb\nSuites: one\nComponents: main\n", 3),
        ("a.sources", "Types: deb\nURIs: http://a.test\nComponents: main\n", 1),
    ],
)
def test_what_is_no_source(file: str, text: str, line: int) -> None:
    with pytest.raises(RosmlError, match=rf"/{PARTS}/{file}:{line} of the-image is no apt source"):
        apt_sources.parse({f"{PARTS}/{file}": text}, "the-image")


# ---- From the registry -----------------------------------------------------------------------------------------------


@pytest.fixture(autouse=True)
def native(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(retries, "WAIT", 0.01)


@pytest.fixture
def services(tmp_path: Path) -> Services:
    return Services.load(tmp_path, required=False)


@pytest.fixture
def received(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many bytes of each layer were read."""
    counts: list[int] = []
    read_blob = Registry.read_blob

    def counting(self: Registry, repository: str, digest: str, read: Callable[[Iterator[bytes]], T], size: int) -> T:
        counts.append(0)

        def counted(blocks: Iterator[bytes]) -> Iterator[bytes]:
            for block in blocks:
                counts[-1] += len(block)
                yield block

        return read_blob(self, repository, digest, lambda blocks: read(counted(blocks)), size)

    monkeypatch.setattr(Registry, "read_blob", counting)
    return counts


def tar(*entries: Entry) -> bytes:
    """A layer of files with a text, in that order; without one it is a folder."""
    return archives.packed(dict((entry, archives.FOLDER) if isinstance(entry, str) else entry for entry in entries))


def packed(*entries: Entry) -> bytes:
    return gzip.compress(tar(*entries), mtime=0)


def image(hub: LocalRegistry, *layers: bytes, media_type: str = GZIP) -> str:
    """Puts an image of some layers into a registry. Returns its digest."""
    with Registry(hub.address) as registry:
        config = registry.put_blob("system", b"{}")
        content = {
            "schemaVersion": 2,
            "config": {"mediaType": oci.CONFIG, "digest": config, "size": 2},
            "layers": [oci.descriptor(media_type, data) for data in layers],
        }
        for data in layers:
            registry.put_blob("system", data)
        return registry.put_manifest("system", "", content)


def sources(services: Services, address: str, digest: str) -> tuple[Source, ...]:
    facts: dict[str, Any] = {"python": "3.12", "numpy": "<2", "architectures": ("amd64",), "tools": "git"}
    system = OperatingSystem(image=f"{address}/system:1", digest=digest, **facts)
    return apt_sources.sources(services, {NAME: system}, NAME)


def read(services: Services, hub: LocalRegistry, *layers: bytes, media_type: str = GZIP) -> tuple[Source, ...]:
    """The sources of an image of some layers."""
    return sources(services, hub.address, image(hub, *layers, media_type=media_type))


def test_an_official_image_is_left_past_its_sources(
    services: Services, server: LocalRegistry, received: list[int]
) -> None:
    files = (f"./{LIST}", "# moved to …/ubuntu.sources\n"), (f"./{PARTS}/ubuntu.sources", NOBLE)
    layer = packed("./", ("./bin", ""), "./etc/", "./etc/apt/", *files, ("./usr/x", os.urandom(8 << 20)))
    parsed = [(source.suite, source.components) for source in read(services, server, layer)]
    assert parsed == [("noble", ("main", "universe")), ("noble-updates", ("main", "universe"))]
    assert len(received) == 1 and received[0] < len(layer) / 8


@pytest.mark.parametrize("entries", [[("usr/x", ""), (LIST, MAIN)], ["etc/"]], ids=["unsorted", "without sources"])
def test_another_layer_is_read_to_its_end(
    services: Services, server: LocalRegistry, received: list[int], entries: list[Entry]
) -> None:
    layer = packed(*entries, ("var/x", os.urandom(1 << 20)), (f"{PARTS}/z.list", "deb http://z.test z z\n"))
    assert read(services, server, layer)[-1] == Source("http://z.test", "z", ("z",))
    assert received == [len(layer)]


@pytest.mark.parametrize("kind", ["oci.image.layer.v1.tar", "docker.image.rootfs.diff.tar"])
@pytest.mark.parametrize("packing", ["", "gzip", "zstd"])
def test_kinds_of_layers(services: Services, server: LocalRegistry, kind: str, packing: str) -> None:
    plain = tar((LIST, MAIN), ("usr/x", os.urandom(1 << 20)))
    halves = plain[:3000], plain[3000:]  # in two members, as some programs write them
    kinds: dict[str, Callable[[bytes], bytes]] = {"": bytes, "gzip": gzip.compress, "zstd": zstd.compress}
    content = b"".join(kinds[packing](half) for half in halves)
    joint = "+" if kind.startswith("oci") else "."
    media_type = f"application/vnd.{kind}{joint}{packing}".rstrip("+.")
    assert read(services, server, content, media_type=media_type) == ONE


BELOW = packed(
    (LIST, MAIN), (f"{PARTS}/a.list", "deb http://a.test a a\n"), (f"{PARTS}/b.list", "deb http://b.test b b\n")
)


@pytest.mark.parametrize(
    ("layer", "suites"),
    [
        ([(f"{PARTS}/c.list", "deb http://c.test c c\n")], "one a b c"),
        ([(f"{PARTS}/.wh.a.list", "")], "one b"),
        ([("etc/apt/.wh.sources.list", "")], "a b"),
        ([("etc/apt/.wh.sources.list.d", "")], "one"),
        ([("etc/.wh.apt", "")], ""),
        ([(".wh.etc", "")], ""),
        ([("etc/apt/.wh..wh..opq", ""), (LIST, "deb http://new.test new new\n")], "new"),
        ([(f"{PARTS}/.wh..wh..opq", ""), (f"{PARTS}/c.list", "deb http://c.test c c\n")], "one c"),
        ([(LIST, "# none\n"), (f"{PARTS}/a.list", "deb http://new.test new new\n")], "new b"),
        ([(f"{PARTS}/a.list.save", "deb http://c.test c c\n"), (f"{PARTS}/.b.list", "x"), ("x/etc/apt/sources.list", "x")], "one a b"),
    ],
)  # fmt: skip
def test_a_layer_changes_what_is_below(
    services: Services, server: LocalRegistry, layer: list[Entry], suites: str
) -> None:
    top = packed(("bin/x", ""), *layer, ("usr/x", ""))
    assert " ".join(source.suite for source in read(services, server, BELOW, top)) == suites


REST = tar("usr/", ("usr/x", "x" * 4096), (LIST, MAIN))
THREE = tar("usr/", "usr/a", "usr/b")


@pytest.mark.parametrize(
    ("layer", "media_type", "words"),
    [
        (b"no tar" * 1000, TAR, "cannot be read: invalid header"),
        (THREE[:1024] + b"x" * 512 + THREE[1536:], TAR, "cannot be read"),
        (REST[:3000], TAR, "unexpected end of data"),
        (b"no gzip", GZIP, "truncated header"),
        (packed("usr/", ("usr/x", os.urandom(4096)))[:2000], GZIP, "it ends too early"),
        (tar((LIST, b"#" * (apt_sources.SOURCE_BYTES + 1))), TAR, "its apt sources have more than 1 MiB"),
        (tar((LIST, (archives.LINK, "/elsewhere"))), TAR, "sources.list is no file"),
        (REST, "application/vnd.oci.image.layer.v1.tar+gzip+encrypted", "is no known type of layer"),
    ],
)
def test_a_layer_that_cannot_be_read(
    services: Services, server: LocalRegistry, layer: bytes, media_type: str, words: str
) -> None:
    """The error names the image and the layer, and nothing is kept."""
    with pytest.raises(RosmlError, match=words) as caught:
        read(services, server, layer, media_type=media_type)
    message = caught.value.message
    assert f"{server.address}/system@sha256:" in message and oci.digest_of(layer) in message
    assert not list(services.state.glob("apt-sources/*"))


def test_a_layer_with_another_digest(services: Services, server: LocalRegistry) -> None:
    """It is read past the end of the tar, after which there may be zeros."""
    digest = image(server, layer := tar("usr/", (LIST, MAIN)) + bytes(1 << 20), media_type=TAR)
    server.blobs["system", oci.digest_of(layer)] = layer.replace(b"archive", b"another")
    with pytest.raises(RosmlError, match="has another digest"):
        sources(services, server.address, digest)


def test_an_index_is_read_for_the_machines_own_architecture(
    services: Services, server: LocalRegistry, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours, other = image(server, packed((LIST, MAIN))), image(server, packed((LIST, MAIN.replace("one", "two"))))
    members = (("windows", "other", ours), ("linux", "arm64", other), ("linux", "amd64", ours))
    entries = [
        {"mediaType": oci.IMAGE, "digest": digest, "size": 2, "platform": {"os": system, "architecture": name}}
        for system, name, digest in members
    ]
    with Registry(server.address) as registry:
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        digest = registry.put_manifest("system", "", content, oci.INDEX)
    for architecture, suite in (("amd64", "one"), ("arm64", "two")):
        monkeypatch.setattr(base_images, "native_architecture", lambda name=architecture: name)
        assert [source.suite for source in sources(services, server.address, digest)] == [suite]
    monkeypatch.setattr(base_images, "native_architecture", lambda: "other")
    with pytest.raises(RosmlError, match="is not there for linux/other"):
        sources(services, server.address, digest)


def test_a_missing_image(services: Services, server: LocalRegistry) -> None:
    with pytest.raises(RosmlError, match=rf"system:1@sha256:{'1' * 64} is not there"):
        sources(services, server.address, f"sha256:{'1' * 64}")


@pytest.mark.parametrize("damage", ["[]", '{"etc/apt/sources.list": 1}', "{"])
def test_sources_are_kept_by_digest(services: Services, server: LocalRegistry, damage: str) -> None:
    digest = image(server, packed((LIST, MAIN)))
    assert sources(services, server.address, digest) == ONE
    server.requests.clear()
    assert sources(services, server.address, digest) == ONE
    assert not server.requests
    [file] = services.state.glob("apt-sources/*")
    file.write_text(damage)
    assert sources(services, server.address, digest) == ONE
    assert json.loads(file.read_text()) == {LIST: MAIN}


@pytest.mark.parametrize("name", ["docker.io/system", "system"])
def test_the_local_registry_is_the_mirror_of_docker_hub(
    services: Services, server: LocalRegistry, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    digest = image(server, packed((LIST, MAIN)))
    if name == "system":
        server.blobs |= {(f"library/{path}", key): data for (path, key), data in server.blobs.items()}
        server.manifests |= {(f"library/{path}", key): data for (path, key), data in server.manifests.items()}
    monkeypatch.setenv(VARIABLE, f"{name}:1@{digest}")
    local = replace(services, registry=server.address, bases=("offline",))
    assert apt_sources.sources(local, {}, NAME) == ONE


def test_a_base_image_that_cannot_be_read_fails_no_plan(
    project: Path, services: Services, server: LocalRegistry, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sync, "lacking", lambda *_: [])
    monkeypatch.setattr(sync, "published", lambda *_: "2026-11-20T21:14:09Z")
    monkeypatch.setenv("OS_UBUNTU_24_04", f"{server.address}/system:1@sha256:{'1' * 64}")
    monkeypatch.setenv("OS_UBUNTU_26_04", f"{server.address}/system:1@{image(server, packed((LIST, '# none')))}")
    place = Place(MemoryRegistry(), PREFIX)
    plan = survey(Request(replace(services, root=project), smaller(project), place, DAY, architectures=("amd64",)))
    assert plan.package_state == {"omega": "2026-11-20T21:14:09Z"}
    [remark] = plan.remarks
    assert remark.startswith(f"alpha: {server.address}/system:1@sha256:1")
