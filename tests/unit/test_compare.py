"""Two images, layer by layer: what is the same, and which file differs first; with a regctl that hands out files."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import tarfile
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest
import zstandard
from stubs import answering_registry, executable, services

from rosml.base.errors import RosmlError
from rosml.build.compare import compare
from rosml.machine.services import Services

REGCTL = r"""
case "$1 $2" in
  manifest\ head) test -f "{folder}/$(basename "$3" | tr ':@' '--')" || {{ echo "no $3: not found: {{}}" >&2; exit 1; }}; echo sha256:0 ;;
  manifest\ get) cat "{folder}/$(basename "$5" | tr ':@' '--')" ;;
  blob\ get) cat "{folder}/blobs/$4" ;;
esac
"""


def layer(**changes: dict[str, object]) -> bytes:
    """A tar file of two files and a link; changes by name."""
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w") as archive:
        for name, text in (("a", "one"), ("b", "two"), ("c", "")):
            facts: dict[str, object] = {"mtime": 7, "mode": 0o644, "text": text, **changes.get(name, {})}
            if facts.pop("gone", False):
                continue
            data = str(facts.pop("text")).encode()
            member = tarfile.TarInfo(f"usr/{name}")
            member.size = len(data)
            if name == "c":
                member.type, member.linkname = tarfile.SYMTYPE, "a"
            for key, value in facts.items():
                setattr(member, key, value)
            archive.addfile(member, io.BytesIO(data))
    return content.getvalue()


@dataclass
class Registry:
    """Images as files."""

    folder: Path
    services: Services = field(init=False)

    def __post_init__(self) -> None:
        (self.folder / "blobs").mkdir()
        regctl = executable(self.folder / "regctl", REGCTL.format(folder=self.folder))
        self.services = services(self.folder, "localhost:1", regctl=regctl)

    def image(self, name: str, *blobs: bytes) -> str:
        """Puts an image; returns its reference."""
        layers = []
        for blob in blobs:
            digest = f"sha256:{hashlib.sha256(blob).hexdigest()}"
            (self.folder / "blobs" / digest).write_bytes(blob)
            layers.append({"digest": digest, "size": len(blob)})
        (self.folder / f"x-{name}").write_text(json.dumps({"layers": layers}))
        return f"localhost:5000/rosml/x:{name}"


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    return Registry(tmp_path)


PACKED: dict[str, Callable[[bytes], bytes]] = {
    "zstd": zstandard.ZstdCompressor().compress,
    "gzip": gzip.compress,
    "plain": bytes,
}


@pytest.mark.parametrize("packed", PACKED)
@pytest.mark.parametrize(
    ("change", "difference"),
    [
        ({"b": {"text": "TWO"}}, "usr/b: content "),
        ({"b": {"text": "three"}}, "usr/b: size 3, and 5; content "),
        ({"a": {"mtime": 8}}, "usr/a: mtime 7.0, and 8.0"),
        ({"a": {"mode": 0o755}}, "usr/a: mode 420, and 493"),
        ({"a": {"uid": 5}}, "usr/a: owner 0, and 5"),
        ({"c": {"linkname": "b"}}, "usr/c: link a, and b"),
        ({"c": {"gone": True}}, "usr/c and what follows is only in the first"),
        ({"b": {"gone": True}}, "usr/b in the first, usr/c in the second"),
    ],
)
def test_the_first_difference(
    packed: str, change: dict[str, dict[str, object]], difference: str, registry: Registry
) -> None:
    pack = PACKED[packed]
    one = registry.image("one", pack(layer()), pack(layer()))
    other = registry.image("other", pack(layer()), pack(layer(**change)))
    found = compare(registry.services, one, other)
    assert [left == right for left, right in found.layers] == [True, False]
    assert found.difference.startswith(f"layer 2: {difference}")
    assert not found.same
    assert found.to_json()["same"] is False


def test_the_same(registry: Registry) -> None:
    found = compare(registry.services, registry.image("one", layer()), registry.image("other", layer()))
    assert (found.same, found.difference) == (True, "")


def test_the_same_files_compressed_another_way(registry: Registry) -> None:
    one = registry.image("one", zstandard.ZstdCompressor(3).compress(layer()))
    other = registry.image("other", gzip.compress(layer()))
    found = compare(registry.services, one, other)
    assert found.difference == "layer 1: the files are the same, compressed another way"


def test_one_layer_more(registry: Registry) -> None:
    one, other = registry.image("one", layer()), registry.image("other", layer(), layer(a={"text": "x"}))
    assert compare(registry.services, one, other).difference == "layer 2 is only in the second image"


def test_an_index_of_one_platform(registry: Registry) -> None:
    one = registry.image("one", layer())
    registry.image("sha256-1", layer())
    (registry.folder / "x-index").write_text('{"manifests": [{"digest": "sha256:1"}]}')
    assert compare(registry.services, one, one.replace(":one", ":index")).same
    (registry.folder / "x-index").write_text('{"manifests": [{"digest": "sha256:1"}, {"digest": "sha256:2"}]}')
    with pytest.raises(RosmlError, match="has several platforms"):
        compare(registry.services, one, one.replace(":one", ":index"))


@pytest.mark.parametrize("damage", [b"", b"\x28\xb5\x2f\xfdgarbage", b"\x1f\x8bgarbage", layer()[:700]])
def test_a_layer_that_cannot_be_read(damage: bytes, registry: Registry) -> None:
    one, other = registry.image("one", layer()), registry.image("other", damage)
    with pytest.raises(RosmlError, match=r"layer sha256:\w+ cannot be read"):
        compare(registry.services, one, other)


@pytest.mark.parametrize("missing", ["localhost:5000/rosml/x:nothing", "localhost:5000/rosml/x@sha256:" + "1" * 64])
def test_an_image_that_is_not_there(missing: str, registry: Registry) -> None:
    """A sentence with a remedy, and not what the registry answers."""
    one = registry.image("one", layer())
    with answering_registry() as address, pytest.raises(RosmlError) as caught:
        compare(replace(registry.services, registry=address), one, missing)
    assert caught.value.message == f"there is no {missing}"
    assert caught.value.remedy == "name a tag or digest that is there; tags are listed by: make catalogue"
    assert caught.value.exit_code == 2


def test_what_is_no_reference(registry: Registry) -> None:
    with pytest.raises(RosmlError, match="'x y' is no reference") as caught:
        compare(registry.services, registry.image("one", layer()), "x y")
    assert caught.value.exit_code == 2
