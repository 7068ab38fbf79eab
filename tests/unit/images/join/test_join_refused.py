"""Images and parts that do not go together: joins are refused before anything is pushed."""

from __future__ import annotations

import gzip
import itertools
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.joins import AMD64, BOTH, GRAPH, TENSORFLOW, TORCH, Place, joining
from rosml.base.errors import RosmlError
from rosml.images.join import file_lists
from rosml.images.join.file_lists import Files
from rosml.images.join.joiner import Joiner
from rosml.registry import oci, references
from tests.e2e import parts
from tests.e2e.parts import PARTS, Tiny, part, ros


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with joining(tmp_path, monkeypatch) as place:
        yield place


# ---- What does not go together ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("present", "kinds", "stack", "message", "remedy"),
    [
        ((), ("torch",), "cpu", "cannot do without", "add common-cpu-py311: framework "),
        ((), ("torch",), "cu128", "cannot do without", "add cuda-cu128 and common-cu128-py311: framework "),
        ((), ("common", "tensorflow"), "cpu", "cannot do without", "add tensorflow-cc-cpu: framework "),
        ((), ("common", "tensorflow-cc"), "cpu", "cannot do without", "add tensorflow-cpu-py311: framework "),
        ((), ("graph",), "cu128", "cannot do without", "add cuda-cu128, common-cu128-py311 and graph-cc-cu128: add-on graph"),
        (("cuda",), GRAPH, "cu128", "cannot do without common of stack cu128", "add common-cu128-py311"),
        (TORCH, ("graph",), "cu128", "cannot do without graph-cc of stack cu128", "add graph-cc-cu128"),
        (TORCH, ("common", *GRAPH), "cu128", "has the part common already", "leave it out"),
        (TORCH, TENSORFLOW[1:], "cu128", "has framework torch of stack cu128 already", "take the ROS image below it"),
        (("cuda",), ("tensorflow", *GRAPH, "common"), "cu128", "has framework cuda of stack cu128 already", "take"),
        (TORCH, GRAPH, "cpu", "an image carries one stack", "use parts of one stack"),
        ((), (), "cpu", "there are no parts to join", "name the parts after it"),
    ],
)  # fmt: skip
def test_parts_that_do_not_fit(
    present: tuple[str, ...], kinds: tuple[str, ...], stack: str, message: str, remedy: str, place: Place
) -> None:
    base = place.ros()
    if present:
        base = place.join(base, *place.stack(present), repository="me/below").reference
    error = place.refused(base, *place.stack(kinds, stack))
    assert message in error.message and remedy in error.remedy and error.exit_code == 2


def test_another_python(place: Place) -> None:
    error = place.refused(place.ros(python="3.13"), *place.stack())
    assert "common-cu128 is for Python 3.11, and" in error.message
    assert (error.remedy, error.exit_code) == ("use the part common-cu128-py313", 2)
    (cuda,) = place.stack(("cuda",))
    assert place.join(place.ros(python="3.13"), cuda).layers == 2, "what is for any Python fits all"


def test_another_platform(place: Place) -> None:
    images = [place.put(part(kind), kind, ["linux/arm64"]) for kind in TORCH]
    assert "no platform in common" in place.refused(place.ros(), *images).message
    error = place.refused(place.ros(platforms=BOTH), *images, platforms=[AMD64])
    assert "for linux/arm64, not for linux/amd64" in error.message


def test_a_part_twice(place: Place) -> None:
    error = place.refused(place.ros(), *place.stack(), place.put(part("torch", salt="2"), "another"))
    assert "part torch is there twice" in error.message and "another" in error.message


@pytest.mark.parametrize("changes", [{"own": "CUDA_VERSION"}, {"framework": "torch", "stack": "cu128"}])
def test_an_image_that_has_a_framework_already(place: Place, changes: dict[str, str]) -> None:
    error = place.refused(place.labelled_ros(**changes), *place.stack())
    assert changes.get("own", "has framework torch of stack cu128 already") in error.message


def test_frameworks_that_do_not_go_together(place: Place) -> None:
    alone = {name: parts.FRAMEWORKS[name] for name in ("torch", "tensorflow")}
    error = place.refused(place.ros(), *place.stack(PARTS[1:], "cpu38", frameworks=alone))
    assert "no framework of stack cpu38 takes common, tensorflow, tensorflow-cc and torch together" in error.message


def test_parts_of_different_releases(place: Place) -> None:
    images = place.stack(TENSORFLOW, "cpu")[:2]
    newer = place.put(part("tensorflow", "cpu", versions={"tensorflow": "2.21.0"}), "newer")
    assert "has tensorflow 2.20.0, and" in place.refused(place.ros(), *images, newer).message
    more = {**parts.FRAMEWORKS, "tensorflow": ("common", "jax", "tensorflow-cc", "tensorflow")}
    other = place.put(part("tensorflow", "cpu", frameworks=more), "other")
    assert "are of different releases" in place.refused(place.ros(), *images, other).message


def test_what_is_no_ros_image(place: Place) -> None:
    images = place.stack()
    strange = Tiny({"maintainer": "somebody"}).put(place.registry, "me/strange", "x")
    for message, *names in (
        ("is no ROS image of this project", strange, *images),
        ("is a part", images[0], *images),
        ("is a ROS image", place.ros(), *images, place.ros()),
        ("is no part: it has no label io.rosml.part", place.ros(), *images, strange),
        ("/me/ros:none is not there", f"{place.server.address}/me/ros:none", *images),
        ("/none:x is not there", f"{place.server.address}/none:x", *images),
    ):
        assert message in place.refused(*names).message


def test_damaged_labels(place: Place) -> None:
    """What else may be wrong with them: test_label_claims.py."""
    cuda, common, torch = place.stack()
    assert "is damaged" in place.refused(place.labelled_ros(parts="common common"), cuda, common, torch).message
    wrong = part("torch")
    wrong = replace(wrong, labels={**wrong.labels, "io.rosml.torch": '1"\nRUN x'})
    error = place.refused(place.ros(), cuda, common, place.put(wrong, "damaged"))
    assert "is damaged" in error.message and "publish it again" in error.remedy and error.exit_code == 2


def test_what_is_no_whole_image(place: Place) -> None:
    subject = place.registry.head("me/ros", references.parse(place.ros()).reference)
    digest = place.registry.attach("me/ros", {"mediaType": oci.INDEX, "digest": subject, "size": 1}, "x/y", b"z", "x/y")
    error = place.refused(f"{place.server.address}/me/ros@{digest}", *place.stack())
    assert "is an artifact of another kind" in error.message
    broken = ros(config={"rootfs": {"type": "layers", "diff_ids": []}}).put(place.registry, "me/ros", "broken")
    assert "is incomplete" in place.refused(broken, *place.stack()).message
    triggers = {"config": {"Labels": dict(ros().labels), "OnBuild": ["ADD http://127.0.0.1:8099/secret /"]}}
    base = ros(config=triggers).put(place.registry, "me/ros", "triggers")
    assert "has ONBUILD" in place.refused(base, *place.stack()).message


def test_the_order_of_the_arguments_does_not_count_for_errors(place: Place) -> None:
    images = [*place.stack(("torch", "common")), *place.stack(("torch",), "cpu"), place.put(part("common"), "again")]
    base = place.ros()
    assert len({place.refused(base, *order).message for order in itertools.permutations(images)}) == 1


@pytest.mark.parametrize("tag", ["me/mine", "ghcr.io", "127.0.0.1:1/me@sha256:" + "1" * 64])
def test_a_tag_that_is_none(place: Place, tag: str) -> None:
    with Joiner(place.clients.__getitem__) as joiner, pytest.raises(RosmlError) as caught:
        joiner.join(place.ros(), place.stack(), tag)
    assert caught.value.exit_code == 2


# ---- Files -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other", "path"),
    [
        (["usr/lib/x.so", "a"], ["usr/lib/x.so"], "usr/lib/x.so"),
        (["lib/x.so"], ["usr/lib/x.so"], "usr/lib/x.so"),
        (["usr/sbin/x"], ["sbin/x"], "usr/sbin/x"),
        (["lib"], ["lib/x.so"], "lib"),
        (["usr/share/doc"], ["usr/share/doc/x/y"], "usr/share/doc"),
        (["b", "a"], ["a", "b"], "a"),
        (["library/x"], ["usr/library/x"], ""),
        (["usr/lib/x"], ["usr/lib/y", "usr/libx"], ""),
        (["lib", "bin"], ["usr/lib/x"], ""),
        ([], [], ""),
    ],
)
def test_the_same_file(one: list[str], other: list[str], path: str) -> None:
    files, others = (Files.parse("\n".join(names).encode()) for names in (one, other))
    assert file_lists.clash(files, others) == file_lists.clash(others, files) == path


def test_two_parts_that_carry_the_same_file(place: Place) -> None:
    torch = place.put(part("torch", files=("usr/local/share/common", "x")), "torch")
    error = place.refused(place.ros(), *place.stack(("cuda", "common")), torch)
    assert "both carry /usr/local/share/common: one would hide the other's" in error.message
    error = place.refused(place.ros(), place.put(part("cuda", files=("bin/env",)), "c"))
    assert "both carry /bin" in error.message, "a folder over the link would hide all that is behind it"


def test_without_a_list(place: Place) -> None:
    cuda, common = place.stack(("cuda", "common"))
    torch = place.put(part("torch", unlisted=True), "torch")
    error = place.refused(place.ros(), cuda, common, torch)
    assert "part:torch has no list of its files" in error.message and "--allow-unlisted" in error.remedy
    assert place.join(place.ros(), cuda, common, torch, allow=True).unlisted == [torch]
    assert any("no list of its files" in line for line in place.lines)
    clashing = place.put(part("common", files=("usr/bin/env",)), "common")
    with pytest.raises(RosmlError, match="both carry /usr/bin/env"):
        place.join(place.ros(), cuda, clashing, torch, allow=True)


def test_a_list_of_somebody_else_hides_no_file(place: Place) -> None:
    images = [*place.stack(("cuda", "common")), place.put(part("torch", files=("usr/bin/env",)), "torch")]
    item = references.parse(images[-1])
    (member,) = place.manifest(item.repository, item.reference).members
    subject = {"mediaType": oci.IMAGE, "digest": member.digest, "size": member.size}

    def attach(data: bytes) -> None:
        place.registry.attach(item.repository, subject, file_lists.ARTIFACT, data, file_lists.MEDIA_TYPE)

    for number in range(30, 33):  # one of them has a lower digest than the list of the part itself
        attach(gzip.compress(f"usr/nothing/{number}".encode(), mtime=0))
    assert "both carry /usr/bin/env" in place.refused(place.ros(), *images).message
    attach(b"one more")
    assert "has 5 lists of files" in place.refused(place.ros(), *images).message


def test_lists_are_downloaded_once(place: Place) -> None:
    """However many images a run joins from the same ones."""
    base, *images = place.ros(), *place.stack()
    with Joiner(place.clients.__getitem__) as joiner:
        for tag in ("one", "two"):
            before = len(place.server.requests)
            joiner.join(base, images, f"{place.server.address}/me/mine:{tag}")
            downloads = [it for it in place.server.requests[before:] if it.startswith("GET") and "/blobs/" in it]
            assert bool(downloads) == (tag == "one")


def test_damaged_lists(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(file_lists, "LARGEST", 1000)
    assert len(file_lists.unpacked(gzip.compress(b"a" * 1000))) == 1000
    for data in (b"", b"text", gzip.compress(b"a\n" * 400)[:-9], gzip.compress(b"a" * 1001)):
        with pytest.raises(RosmlError, match="damaged"):
            file_lists.unpacked(data)
