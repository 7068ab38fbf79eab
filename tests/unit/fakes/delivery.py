"""A registry with images of a few bytes, a robot whose engine is a local replacement, and archives, sound and damaged."""

from __future__ import annotations

import gzip
import io
import json
import sys
import tarfile
from pathlib import Path
from random import Random
from typing import Any

from fakes.http_registry import LocalRegistry
from rosml.base import archives
from rosml.base.archives import zstd
from rosml.cli import command, main
from rosml.delivery import archive
from rosml.images.builds.base_images import native_architecture
from rosml.images.join.layers import Source
from rosml.registry import documents, oci
from rosml.registry.client import Registry

Files = dict[str, bytes]
"""The files of an archive by their names."""

LAYER = "application/vnd.oci.image.layer.v1.tar+gzip"


def layer(name: str) -> bytes:
    """An uncompressed layer with one file of some kB."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as opened:
        entry = tarfile.TarInfo(name)
        entry.size = 5000
        opened.addfile(entry, io.BytesIO(name.encode() * 5000))
    return out.getvalue()


def nightly(changed: bytes, size: int = 400_000) -> bytes:
    """A larger layer, of which one file changes."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as opened:
        for name, data in {"usr/lib/x": Random(size).randbytes(size), "usr/y": changed}.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            opened.addfile(entry, io.BytesIO(data))
    return out.getvalue()


PLAIN = {name: layer(name) for name in "abcxy"} | {
    "p": nightly(b"one" * 100),
    "q": nightly(b"two" * 900),
    "r": nightly(b"three", 399_999),
    "n": Random(0).randbytes(300_000),
}
PACKED = {name: gzip.compress(data, mtime=0) for name, data in PLAIN.items()} | {"p": zstd.compress(PLAIN["p"])}
IMAGES = {"base": "ab", "night": "ac", "app": "abx", "moved": "acx", "more": "abxy", "low": "ax", "twice": "axa"}
IMAGES |= {"monday": "abpx", "tuesday": "acqx", "other": "acrx", "odd": "abnx", "early": "p", "late": "q", "both": "pq"}


def media_type(name: str) -> str:
    """Of a layer."""
    return LAYER if PACKED[name].startswith(b"\x1f\x8b") else LAYER.replace("gzip", "zstd")


def config(tag: str, architecture: str) -> bytes:
    """The config of an image."""
    diff_ids = [oci.digest_of(PLAIN[name]) for name in IMAGES[tag]]
    return oci.encoded(
        {"os": "linux", "architecture": architecture, "rootfs": {"type": "layers", "diff_ids": diff_ids}}
    )


class Shop:
    """A registry with images, and a robot with an engine that is a local replacement."""

    def __init__(self, server: LocalRegistry, folder: Path) -> None:
        self.server, self.folder, self.place = server, folder, f"{server.address}/t"
        self.here = native_architecture()
        registry = Registry(server.address)
        for data in PACKED.values():
            registry.put_blob("t", data)
        for tag, names in IMAGES.items():
            entries = []
            for architecture in (self.here, "riscv64"):
                image_config = config(tag, architecture)
                registry.put_blob("t", image_config)
                layers = [oci.descriptor(media_type(name), PACKED[name]) for name in names]
                content = {
                    "schemaVersion": 2,
                    "mediaType": oci.IMAGE,
                    "config": oci.descriptor(oci.CONFIG, image_config),
                }
                data = json.dumps({**content, "layers": layers}, indent=3).encode()
                registry.put_manifest("t", "", data, oci.IMAGE)
                platform = {"os": "linux", "architecture": architecture}
                entries.append({**oci.descriptor(oci.IMAGE, data), "platform": platform})
            registry.put_manifest("t", tag, {"schemaVersion": 2, "manifests": entries}, oci.INDEX)
        registry.close()

    def name(self, tag: str) -> str:
        """The complete reference of an image."""
        return f"{self.place}:{tag}"

    def call(self, *words: object) -> int:
        """Calls rosml; gives the exit code."""
        return command.run(main.cli, arguments=[str(word) for word in words])

    def save(self, tag: str, *have: str, file: str = "saved.tar") -> Path:
        """Saves an image."""
        options = [word for name in have for word in ("--have", self.name(name))]
        assert self.call("save", self.name(tag), *options, "-o", self.folder / file) == 0
        return self.folder / file

    def engine(self, kind: str, *tags: str) -> None:
        """Gives the robot an engine that has these images."""
        images = {oci.digest_of(config(tag, self.here)): [oci.digest_of(PLAIN[n]) for n in IMAGES[tag]] for tag in tags}
        saved = self.folder / "saves"
        saved.mkdir(exist_ok=True)
        for tag in tags:
            as_saved(kind, tag, self.here, saved / oci.digest_of(config(tag, self.here)).removeprefix("sha256:"))
        (self.folder / "images.json").write_text(json.dumps(images))
        info: dict[str, Any] = {"ServerVersion": "28.2.2", "DriverStatus": [["Backing Filesystem", "extfs"]]}
        if kind == "containerd":
            info["DriverStatus"] = [["driver-type", "io.containerd.snapshotter.v1"]]
        if kind == "podman":
            info = {"host": {"security": {"rootless": True}}}
        (self.folder / "info.json").write_text(json.dumps(info))
        program = self.folder / "bin" / ("podman" if kind == "podman" else "docker")
        program.parent.mkdir(exist_ok=True)
        program.write_text(ENGINE.format(python=sys.executable, folder=self.folder))
        program.chmod(0o755)

    @property
    def loaded(self) -> Path:
        """What the engine got."""
        return self.folder / "loaded"


ENGINE = """\
#!{python} -IS
import json, os, shutil, sys, tarfile
here, words = "{folder}", sys.argv[1:]
images = json.load(open(here + "/images.json"))
if words[0] == "info":
    print(open(here + "/info.json").read())
elif words[:2] == ["image", "ls"]:
    print(*images, sep="\\n")
elif words[:2] == ["image", "inspect"]:
    found = [dict(Id=name, Config={{}}, RootFS=dict(Type="layers", Layers=images[name])) for name in words[2:] if name in images]
    if "--format" in words:
        sys.exit("Error: No such image") if not found else print(json.dumps(found[0]))
    else:
        print(json.dumps(found))
elif words[0] == "save":
    shutil.copyfileobj(open(here + "/saves/" + words[1].split("sha256:")[1], "rb"), sys.stdout.buffer)
elif words[0] == "load":
    with open(here + "/loaded", "wb") as out:
        shutil.copyfileobj(sys.stdin.buffer, out)
    if "host" in json.load(open(here + "/info.json")) and not os.path.exists(here + "/pulled"):
        with tarfile.open(here + "/loaded") as found:
            read = lambda name: json.loads(found.extractfile(name).read())
            manifest = read("blobs/" + read("index.json")["manifests"][0]["digest"].replace(":", "/"))
            there = found.getnames()
        if any("blobs/" + item["digest"].replace(":", "/") not in there for item in manifest["layers"]):
            sys.exit("no such blob")
    if os.path.exists(here + "/full"):
        open(here + "/tmpdir", "w").write(shutil.copy(here + "/loaded", os.environ.get("TMPDIR", here + "/left")))
        sys.exit("no space left on device")
"""


def as_saved(kind: str, tag: str, architecture: str, file: Path) -> None:
    """What `docker save` or `podman save` gives."""
    with tarfile.open(file, "w") as out:

        def add(name: str, data: bytes) -> None:
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            out.addfile(entry, io.BytesIO(data))

        add(f"{'0' * 64}.json", b"{}")
        for number, name in enumerate(IMAGES[tag]):
            if kind == "old":
                add(f"{number:064}/layer.tar", PLAIN[name])
                continue
            data = PACKED[name] if kind == "containerd" else PLAIN[name]
            bare = oci.digest_of(data).removeprefix("sha256:")
            add(f"{bare}.tar" if kind == "podman" else f"blobs/sha256/{bare}", data)
            link = tarfile.TarInfo(f"{number:064}/layer.tar")
            link.type, link.linkname = tarfile.SYMTYPE, f"../{bare}.tar"
            out.addfile(link)
        add("manifest.json", b"[]")


def names_in(file: Path) -> list[str]:
    """The names in an archive."""
    with tarfile.open(file) as opened:
        return opened.getnames()


def blobs_in(file: Path) -> dict[str, bytes]:
    """The blobs of an archive by their digests, each of which has that digest."""
    blobs = {}
    with tarfile.open(file) as opened:
        for entry in opened:
            if entry.name.startswith("blobs/"):
                stream = opened.extractfile(entry)
                assert stream
                data = stream.read()
                assert oci.digest_of(data) == entry.name.removeprefix("blobs/").replace("/", ":")
                blobs[oci.digest_of(data)] = data
    return blobs


def text_in(file: Path, name: str) -> Any:
    """A JSON text of an archive."""
    with tarfile.open(file) as opened:
        stream = opened.extractfile(name)
        assert stream
        return json.loads(stream.read())


def require_whole(file: Path, tag: str, held: str = "") -> None:
    """Checks that an archive has an image with all its layers, compressed or not, but those that its reader has."""
    blobs = blobs_in(file)
    (entry,) = text_in(file, archive.INDEX)["manifests"]
    manifest = json.loads(blobs[entry["digest"]])
    (listed,) = text_in(file, archive.DOCKER)
    assert [archive.path(entry_of_layer["digest"]) for entry_of_layer in manifest["layers"]] == listed["Layers"]
    assert listed["Config"] == archive.path(manifest["config"]["digest"])
    assert manifest["config"]["digest"] in blobs
    for entry_of_layer, name in zip(manifest["layers"], IMAGES[tag], strict=True):
        if name in held:
            assert entry_of_layer["digest"] not in blobs
            continue
        data = blobs[entry_of_layer["digest"]]
        assert entry_of_layer["size"] == len(data)
        assert b"".join(archives.unpacked([data])) == PLAIN[name]
        assert entry_of_layer["mediaType"].endswith("tar") == (data == PLAIN[name])


def image(steps: str, *layers: str) -> Source:
    """An image, whose layers the steps made. Of steps and layers, letters are names; `.` is a step without a layer."""
    entries = [{"digest": oci.digest_of(name.encode()), "mediaType": LAYER, "size": 1 << 20} for name in layers]
    content = {"schemaVersion": 2, "config": None, "layers": entries}
    history = [{"created_by": f"RUN {name}"} if name != "." else {"empty_layer": True} for name in steps]
    diff_ids = [oci.digest_of(name.encode()) for name in layers]
    facts: dict[str, Any] = {"history": history, "rootfs": {"diff_ids": diff_ids}}
    image_config = oci.Config(facts, documents.Config.model_validate(facts))
    return Source(steps, "h", "r", oci.digest_of(steps.encode()), oci.Manifest(content, "", oci.IMAGE, 1), image_config)


CONFIG = config("app", "amd64")


def sound(**changes: Any) -> Files:
    """The files of a whole archive.

    Args:
        changes: of its manifest.
    """
    layers = [oci.descriptor(LAYER, PACKED[name]) for name in IMAGES["app"]]
    content = {"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, CONFIG), "layers": layers, **changes}
    manifest = oci.encoded(content)
    blobs = {archive.path(oci.digest_of(data)): data for data in (manifest, CONFIG, *(PACKED[n] for n in "abx"))}
    index = archive.index(oci.descriptor(oci.IMAGE, manifest), "registry.test/robot:1", {})
    return {archive.LAYOUT: b"{}", archive.INDEX: index, **blobs}


def indexed(**changes: Any) -> Files:
    """The same, with changes of the index."""
    files = sound()
    return files | {archive.INDEX: json.dumps(json.loads(files[archive.INDEX]) | changes).encode()}


def entry_of(name: str, size: int = 0, kind: bytes = tarfile.REGTYPE, **facts: Any) -> bytes:
    """The header of an entry."""
    entry = tarfile.TarInfo(name)
    entry.size, entry.type = size, kind
    for fact, value in facts.items():
        setattr(entry, fact, value)
    return entry.tobuf(tarfile.GNU_FORMAT)


def packed(files: Files, *more: bytes) -> bytes:
    """The bytes of an archive, and what comes before its end."""
    parts = [part for name, data in files.items() for part in (entry_of(name, len(data)), padded(data))]
    return b"".join((*parts, *more, bytes(1024)))


def padded(data: bytes) -> bytes:
    """Content of an entry."""
    return data + bytes(-len(data) % 512)


def pax(body: bytes) -> bytes:
    """An extended header."""
    return entry_of("x", len(body), tarfile.XHDTYPE) + padded(body)


def sparse(body: bytes) -> bytes:
    """An entry whose extended header says that it has holes."""
    return pax(body) + entry_of("blobs/sha256/x", 512) + padded(b"9999999\n" * 64)


def changed(file: Path, annotations: dict[str, str], more: Files = {}) -> Path:  # noqa: B006
    """An archive with other annotations and files. One that is empty goes."""
    files: Files = {}
    with tarfile.open(file) as opened:
        for entry in opened:
            stream = opened.extractfile(entry)
            assert stream
            files[entry.name] = stream.read()
    content = json.loads(files[archive.INDEX])
    noted = {key: value for key, value in {**content["annotations"], **annotations}.items() if value}
    files[archive.INDEX] = json.dumps(content | {"annotations": noted}).encode()
    file.write_bytes(packed({name: data for name, data in {**files, **more}.items() if data}))
    return file
