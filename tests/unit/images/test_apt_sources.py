"""The apt sources of base images: what their files say, and how they are read from a registry."""

from __future__ import annotations

import gzip
import io
import json
import os
import tarfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import pytest
from conftest import SMALL, changed, smaller
from conftest import parse as image_set_of

from fakes.http_registry import StandIn, standing_in
from fakes.memory_registry import DAY, PREFIX, MemoryRegistry
from fakes.release_files import FACTS, RELEASE, Mirror, release_server
from rosml.base.archives import zstd
from rosml.base.errors import RosmlError
from rosml.images.builds import apt_sources, base_images, package_state, sync
from rosml.images.builds.apt_sources import Source
from rosml.images.matrix.model import OperatingSystem
from rosml.images.publish.state import Request
from rosml.images.publish.survey import survey
from rosml.machine.services import Services
from rosml.registry import failures, oci
from rosml.registry.client import Registry
from rosml.registry.place import Place

T = TypeVar("T")

LIST, PARTS = "etc/apt/sources.list", "etc/apt/sources.list.d"
GZIP = "application/vnd.oci.image.layer.v1.tar+gzip"
NAME = "system-1.0"
VARIABLE = "OS_SYSTEM_1_0"
MAIN = "deb http://archive.test/system one main\n"
ONE = (Source("http://archive.test/system", "one", ("main",)),)

UBUNTU = ("main", "restricted", "universe", "multiverse")
FOCAL = """\
# See http://help.ubuntu.com/community/UpgradeNotes for how to upgrade to
# newer versions of the distribution.
deb http://archive.ubuntu.com/ubuntu/ focal main restricted
# deb-src http://archive.ubuntu.com/ubuntu/ focal main restricted

## Major bug fix updates produced after the final release of the
## distribution.
deb http://archive.ubuntu.com/ubuntu/ focal-updates main restricted
# deb-src http://archive.ubuntu.com/ubuntu/ focal-updates main restricted

## N.B. software from this repository is ENTIRELY UNSUPPORTED by the Ubuntu
## team.
deb http://archive.ubuntu.com/ubuntu/ focal universe
# deb-src http://archive.ubuntu.com/ubuntu/ focal universe
deb http://archive.ubuntu.com/ubuntu/ focal-updates universe
deb http://archive.ubuntu.com/ubuntu/ focal multiverse
deb http://archive.ubuntu.com/ubuntu/ focal-updates multiverse
deb http://archive.ubuntu.com/ubuntu/ focal-backports main restricted universe multiverse
# deb http://archive.canonical.com/ubuntu focal partner
deb http://security.ubuntu.com/ubuntu/ focal-security main restricted
# deb-src http://security.ubuntu.com/ubuntu/ focal-security main restricted
deb http://security.ubuntu.com/ubuntu/ focal-security universe
deb http://security.ubuntu.com/ubuntu/ focal-security multiverse
"""
NOBLE = """\
# See https://help.ubuntu.com/community/UpgradeNotes for how to upgrade to
# newer versions of the distribution.

## Ubuntu distribution repository
##
## Types: Append deb-src to include the fetching of source package.
Types: deb
URIs: http://archive.ubuntu.com/ubuntu/
Suites: noble noble-updates noble-backports
Components: main universe restricted multiverse
Signed-By: /usr/share/keyrings/ubuntu-archive-keyring.gpg

## Ubuntu security updates. Aside from URIs and Suites,
## this should mirror your choices in the previous section.
Types: deb
URIs: http://security.ubuntu.com/ubuntu/
Suites: noble-security
Components: main universe restricted multiverse
Signed-By: /usr/share/keyrings/ubuntu-archive-keyring.gpg
"""
BOOKWORM = """\
Types: deb
# http://snapshot.example/debian/20261117T000000Z
URIs: http://debian.example/debian
Suites: bookworm bookworm-updates
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg

Types: deb
# http://snapshot.example/debian-security/20261117T000000Z
URIs: http://debian.example/debian-security
Suites: bookworm-security
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
"""


def ubuntu(codename: str, components: tuple[str, ...] = UBUNTU) -> tuple[Source, ...]:
    """The sources of an Ubuntu image."""
    hosts = {"": "archive", "-updates": "archive", "-backports": "archive", "-security": "security"}
    return tuple(
        Source(f"http://{host}.ubuntu.com/ubuntu", f"{codename}{pocket}", components) for pocket, host in hosts.items()
    )


OFFICIAL = {
    "ubuntu-20.04": ({LIST: FOCAL}, ubuntu("focal")),
    "ubuntu-22.04": ({LIST: FOCAL.replace("focal", "jammy")}, ubuntu("jammy")),
    "ubuntu-24.04": (
        {LIST: "# Ubuntu sources have moved to …/ubuntu.sources\n", f"{PARTS}/ubuntu.sources": NOBLE},
        ubuntu("noble", ("main", "universe", "restricted", "multiverse")),
    ),
    "debian-12": (
        {f"{PARTS}/debian.sources": BOOKWORM},
        (
            Source("http://debian.example/debian", "bookworm", ("main",)),
            Source("http://debian.example/debian", "bookworm-updates", ("main",)),
            Source("http://debian.example/debian-security", "bookworm-security", ("main",)),
        ),
    ),
}


# ---- What the files say ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("image", OFFICIAL)
def test_the_sources_of_official_images(image: str) -> None:
    texts, wanted = OFFICIAL[image]
    assert apt_sources.parse(texts, image) == wanted


@pytest.mark.parametrize(
    ("file", "text", "wanted"),
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
def test_sources_as_apt_reads_them(file: str, text: str, wanted: list[str]) -> None:
    found = apt_sources.parse({f"{PARTS}/{file}": text}, "image")
    assert [" ".join((source.address, source.suite, *source.components)) for source in found] == wanted


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
    with pytest.raises(RosmlError, match=rf"/{PARTS}/{file}:{line} of the-image is no apt source") as caught:
        apt_sources.parse({f"{PARTS}/{file}": text}, "the-image")
    assert caught.value.remedy


# ---- From the registry -----------------------------------------------------------------------------------------------


@pytest.fixture
def mirror(monkeypatch: pytest.MonkeyPatch) -> Iterator[Mirror]:
    with release_server(monkeypatch) as server:
        yield server


@pytest.fixture(autouse=True)
def native(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(failures, "WAIT", 0.01)


@pytest.fixture
def hub() -> Iterator[StandIn]:
    with standing_in() as found:
        yield found


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


def tar(*entries: str | tuple[str, str | bytes]) -> bytes:
    """A layer of files with a text, in that order; without one it is a folder."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as archive:
        for entry in entries:
            name, text = entry if isinstance(entry, tuple) else (entry, None)
            info = tarfile.TarInfo(name)
            if text is None:
                info.type = tarfile.DIRTYPE
            content = text.encode() if isinstance(text, str) else text or b""
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    return packed.getvalue()


def image(hub: StandIn, *layers: bytes, media_type: str = GZIP) -> str:
    """Puts an image of some layers into a registry; gives its digest."""
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


def index(hub: StandIn, **members: str) -> str:
    """Puts an index over images by architecture; gives its digest."""
    entries = [
        {"mediaType": oci.IMAGE, "digest": digest, "size": 2, "platform": {"os": system, "architecture": name}}
        for name, digest in members.items()
        for system in ("windows" if name == "other" else "linux",)
    ]
    with Registry(hub.address) as registry:
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        return registry.put_manifest("system", "", content, oci.INDEX)


def systems(address: str, digest: str) -> dict[str, OperatingSystem]:
    facts = {"python": "3.12", "numpy": "<2", "architectures": ("amd64",), "tools": "git"}
    return {NAME: OperatingSystem(image=f"{address}/system:1", digest=digest, **facts)}  # type: ignore[arg-type]


def read(services: Services, hub: StandIn, *layers: bytes, **more: Any) -> tuple[Source, ...]:
    """The sources of an image of some layers."""
    return apt_sources.sources(services, systems(hub.address, image(hub, *layers, **more)), NAME)


def packed(*entries: str | tuple[str, str | bytes]) -> bytes:
    return gzip.compress(tar(*entries), mtime=0)


@pytest.mark.parametrize("name", OFFICIAL)
def test_an_official_image_is_left_past_its_sources(
    services: Services, hub: StandIn, received: list[int], name: str
) -> None:
    texts, wanted = OFFICIAL[name]
    rest = os.urandom(8 << 20)
    layer = packed(
        "./", ("./bin", ""), "./etc/", "./etc/apt/", *((f"./{p}", t) for p, t in texts.items()), ("./usr/x", rest)
    )
    assert read(services, hub, layer) == wanted
    assert len(received) == 1 and received[0] < len(layer) / 8


def test_a_layer_in_another_order_is_read_to_its_end(services: Services, hub: StandIn, received: list[int]) -> None:
    rest = ("var/x", os.urandom(1 << 20))
    layer = packed(("usr/x", ""), (LIST, MAIN), rest, (f"{PARTS}/z.list", "deb http://z.test z z\n"))
    assert read(services, hub, layer) == (*ONE, Source("http://z.test", "z", ("z",)))
    assert received == [len(layer)]


def test_a_layer_without_sources_is_read_to_its_end(services: Services, hub: StandIn, received: list[int]) -> None:
    """In order or not: nobody knows whether another name follows."""
    layer = packed("etc/", ("usr/x", os.urandom(1 << 20)))
    assert read(services, hub, layer) == ()
    assert received == [len(layer)]


@pytest.mark.parametrize("kind", ["oci.image.layer.v1.tar", "docker.image.rootfs.diff.tar"])
@pytest.mark.parametrize("packing", ["", "gzip", "zstd"])
def test_kinds_of_layers(services: Services, hub: StandIn, kind: str, packing: str) -> None:
    layer = packed((LIST, MAIN), ("usr/x", os.urandom(1 << 20)))
    plain = gzip.decompress(layer)
    halves = plain[:3000], plain[3000:]  # in two members, as some programs write them
    kinds: dict[str, Callable[[bytes], bytes]] = {"": bytes, "gzip": gzip.compress, "zstd": zstd.compress}
    content = b"".join(kinds[packing](half) for half in halves)
    joint = "+" if kind.startswith("oci") else "."
    media_type = f"application/vnd.{kind}{joint}{packing}".rstrip("+.")
    assert read(services, hub, content, media_type=media_type) == ONE


BELOW = packed(
    (LIST, MAIN), (f"{PARTS}/a.list", "deb http://a.test a a\n"), (f"{PARTS}/b.list", "deb http://b.test b b\n")
)


@pytest.mark.parametrize(
    ("layer", "wanted"),
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
    services: Services, hub: StandIn, layer: list[str | tuple[str, str | bytes]], wanted: str
) -> None:
    top = packed(("bin/x", ""), *layer, ("usr/x", ""))
    assert " ".join(source.suite for source in read(services, hub, BELOW, top)) == wanted


def damaged(layer: bytes) -> bytes:
    """A tar with something else in the place of its third header."""
    return layer[:1024] + b"x" * 512 + layer[1536:]


def link() -> bytes:
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w") as archive:
        info = tarfile.TarInfo(LIST)
        info.type, info.linkname = tarfile.SYMTYPE, "/elsewhere"
        archive.addfile(info)
    return packed.getvalue()


TAR = "application/vnd.oci.image.layer.v1.tar"
REST = tar("usr/", ("usr/x", "x" * 4096), (LIST, MAIN))


@pytest.mark.parametrize(
    ("layer", "media_type", "words"),
    [
        (b"no tar" * 1000, TAR, "cannot be read: invalid header"),
        (b"", TAR, "cannot be read: empty file"),
        (damaged(tar("usr/", "usr/a", "usr/b")), TAR, "cannot be read"),
        (REST[:3000], TAR, "unexpected end of data"),
        (REST[:700], TAR, "cannot be read: truncated header"),
        (b"no gzip", GZIP, "truncated header"),
        (packed("usr/", ("usr/x", os.urandom(4096)))[:2000], GZIP, "it ends too early"),
        (tar((LIST, b"#" * (apt_sources.SOURCE_BYTES + 1))), TAR, "its apt sources have more than 1 MiB"),
        (link(), TAR, "sources.list is no file"),
        (REST, "application/vnd.oci.image.layer.v1.tar+gzip+encrypted", "is no known type of layer"),
    ],
)
def test_a_layer_that_cannot_be_read(
    services: Services, hub: StandIn, layer: bytes, media_type: str, words: str
) -> None:
    """As it was pushed; the error names the image and the layer."""
    with pytest.raises(RosmlError, match=words) as caught:
        read(services, hub, layer, media_type=media_type)
    assert f"{hub.address}/system@sha256:" in caught.value.message and oci.digest_of(layer) in caught.value.message
    assert caught.value.remedy
    assert not list(services.state.glob("apt-sources/*"))


def test_a_layer_with_another_digest(services: Services, hub: StandIn) -> None:
    """It is read past the end of the tar, after which there may be zeros."""
    digest = image(hub, layer := tar("usr/", (LIST, MAIN)) + bytes(1 << 20), media_type=TAR)
    hub.blobs["system", oci.digest_of(layer)] = layer.replace(b"archive", b"another")
    with pytest.raises(RosmlError, match="has another digest"):
        apt_sources.sources(services, systems(hub.address, digest), NAME)


def test_a_connection_that_breaks_is_tried_again(services: Services, hub: StandIn) -> None:
    hub.fault("GET", "/blobs/", "drop", times=2)
    assert read(services, hub, packed((LIST, MAIN))) == ONE
    assert hub.count("^GET .*/blobs/") == 3


def test_an_index(services: Services, hub: StandIn, monkeypatch: pytest.MonkeyPatch) -> None:
    """The machine's own architecture counts, and is told where it is missing."""
    ours, other = image(hub, packed((LIST, MAIN))), image(hub, packed((LIST, MAIN.replace("one", "two"))))
    found = systems(hub.address, index(hub, other=ours, arm64=other, amd64=ours))
    assert apt_sources.sources(services, found, NAME) == ONE
    monkeypatch.setattr(base_images, "native_architecture", lambda: "arm64")
    assert [source.suite for source in apt_sources.sources(services, found, NAME)] == ["two"]
    monkeypatch.setattr(base_images, "native_architecture", lambda: "other")
    with pytest.raises(RosmlError, match="is not there for linux/other") as caught:
        apt_sources.sources(services, found, NAME)
    assert caught.value.remedy


def test_an_image_that_is_not_there(services: Services, hub: StandIn) -> None:
    with pytest.raises(RosmlError, match=rf"system:1@sha256:{'1' * 64} is not there") as caught:
        apt_sources.sources(services, systems(hub.address, f"sha256:{'1' * 64}"), NAME)
    assert caught.value.remedy


@pytest.mark.parametrize("left", ["", "[]", '{"etc/apt/sources.list": 1}', "{"])
def test_what_was_read_is_kept_by_digest(services: Services, hub: StandIn, left: str) -> None:
    """And read again where the file is damaged."""
    digest = image(hub, packed((LIST, MAIN)))
    assert apt_sources.sources(services, systems(hub.address, digest), NAME) == ONE
    hub.requests.clear()
    assert apt_sources.sources(services, systems(hub.address, digest), NAME) == ONE
    assert not hub.requests
    [file] = services.state.glob("apt-sources/*")
    file.write_text(left)
    assert apt_sources.sources(services, systems(hub.address, digest), NAME) == ONE
    assert json.loads(file.read_text()) == {LIST: MAIN}
    other = image(hub, packed((LIST, MAIN.replace("one", "two"))))
    assert [s.suite for s in apt_sources.sources(services, systems(hub.address, other), NAME)] == ["two"]


@pytest.mark.parametrize("name", ["docker.io/system", "system"])
def test_the_local_registry_is_the_mirror_of_docker_hub(
    services: Services, hub: StandIn, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """Where base images are made on this machine, as the builder has it; Docker Hub itself is asked for what is not there."""
    digest = image(hub, packed((LIST, MAIN)))
    if name == "system":
        hub.blobs |= {(f"library/{where}", key): data for (where, key), data in hub.blobs.items()}
        hub.manifests |= {(f"library/{where}", key): data for (where, key), data in hub.manifests.items()}
    monkeypatch.setenv(VARIABLE, f"{name}:1@{digest}")
    local = replace(services, registry=hub.address, bases=("offline",))
    assert apt_sources.sources(local, {}, NAME) == ONE


OWN = changed(
    "packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n    default_stack: cpu\n"
    "    apt: {channel: snapshot, date: 2026-11-01}\n",
    "packages: ros-{metapackage}\n    components: [core, base]\n    default_stack: cpu\n",
    changed("    codename: resolute\n", "", SMALL),
)
MATRIX = OWN.replace("ubuntu-26.04", NAME).replace("docker.io/library/ubuntu:26.04", "docker.io/library/system:1")
"""A matrix with a row whose ROS is the system's own, on a system that a variable names."""


# ---- Who is asked ----------------------------------------------------------------------------------------------------


def test_the_archive_of_the_base_image_is_asked_and_no_other(
    services: Services,
    hub: StandIn,
    mirror: Mirror,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever operating system it is called."""
    text = (
        f"Types: deb\nURIs: {mirror.address}/own\nSuites: stable stable-backports\nComponents: main\n\n"
        "Types: deb\nEnabled: no\nURIs: http://official.test\nSuites: stable\nComponents: main\n"
    )
    digest = image(hub, packed((f"{PARTS}/company.sources", text)))
    monkeypatch.setenv(VARIABLE, f"{hub.address}/system:1@{digest}")
    matrix = image_set_of(MATRIX).matrix
    lists = RELEASE.format(**FACTS)
    mirror.files = {
        "/own/dists/stable/Release": lists.encode(),
        "/own/dists/stable-backports/Release": f"NotAutomatic: yes\n{lists}".encode(),
    }
    before = package_state.state(services, matrix, "omega", {})
    assert before.startswith("debian stable ")
    assert mirror.requests == list(mirror.files)
    mirror.files["/own/dists/stable/Release"] = RELEASE.format(**FACTS | {"amd64": "d" * 64}).encode()
    assert package_state.state(services, matrix, "omega", {}) != before
    assert package_state.repositories(services, matrix, "omega", before) == [(f"{mirror.address}/own", before)]


def test_a_base_image_that_cannot_be_read_fails_no_plan(
    project: Path, services: Services, hub: StandIn, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is told, and packages are taken for unchanged."""
    monkeypatch.setattr(sync, "lacking", lambda *_: [])
    monkeypatch.setattr(sync, "published", lambda *_: "2026-11-20T21:14:09Z")
    monkeypatch.setenv("OS_UBUNTU_24_04", f"{hub.address}/system:1@sha256:{'1' * 64}")
    monkeypatch.setenv("OS_UBUNTU_26_04", f"{hub.address}/system:1@{image(hub, packed((LIST, '# none')))}")
    place = Place(MemoryRegistry(), PREFIX)
    found = survey(Request(replace(services, root=project), smaller(project), place, DAY, architectures=("amd64",)))
    assert found.package_state == {"omega": "2026-11-20T21:14:09Z"}
    [remark] = found.remarks
    assert (
        remark.startswith(f"alpha: {hub.address}/system:1@sha256:1")
        and "its packages are taken for unchanged" in remark
    )
