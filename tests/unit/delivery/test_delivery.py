"""Images in files without layers that the reader has: what is saved, and how docker, podman, a registry or a file completes it."""

from __future__ import annotations

import gzip
import io
import json
import os
import re
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.delivery import (
    CONFIG,
    LAYER,
    PACKED,
    PLAIN,
    Shop,
    blobs_in,
    changed,
    config,
    entry_of,
    image,
    indexed,
    names_in,
    packed,
    padded,
    pax,
    require_whole,
    sound,
    sparse,
    text_in,
)
from fakes.http_registry import DROP, local_registry
from rosml.cli import command, main
from rosml.delivery import apply_patch, archive, pulled_layers
from rosml.images.join.layers import Source
from rosml.registry import oci, retries


@pytest.fixture
def shop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Shop]:
    (tmp_path / "bin").mkdir()
    monkeypatch.setenv("PATH", f"{tmp_path}/bin")
    monkeypatch.delenv("ROSML_ENGINE", raising=False)
    monkeypatch.setattr(retries, "WAIT", 0.001)
    with local_registry() as server:
        yield Shop(server, tmp_path)


# ---- Saving ----------------------------------------------------------------------------------------------------------


def test_what_others_have_stays_out_and_is_not_pulled(shop: Shop) -> None:
    file = shop.save("more", "base")
    assert {PACKED["x"], PACKED["y"]} < {*blobs_in(file).values()}
    assert not {PACKED["a"], PACKED["b"]} & {*blobs_in(file).values()}
    digests = [oci.digest_of(PACKED[name]) for name in "ab"]
    assert not any(shop.server.count(f"GET .*{digest}") for digest in digests)
    noted = json.loads(text_in(file, archive.INDEX)["annotations"][archive.LEFT_OUT])
    assert [*noted.values()] == [digests]
    assert re.fullmatch(rf"{shop.name('base')}@sha256:[0-9a-f]{{64}}", *noted)
    assert shop.save("more", "base", file="again").read_bytes() == file.read_bytes()


def test_a_whole_image_has_the_manifest_as_it_was_pushed(shop: Shop) -> None:
    file = shop.save("twice")
    require_whole(file, "twice")
    (entry,) = text_in(file, archive.INDEX)["manifests"]
    assert ("t", entry["digest"]) in shop.server.manifests


def test_an_image_by_its_digest_has_no_name(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    (entry,) = text_in(shop.save("app"), archive.INDEX)["manifests"]
    capsys.readouterr()
    assert shop.call("save", f"{shop.place}@{entry['digest']}", "-o", shop.folder / "out") == 0
    assert capsys.readouterr().out.splitlines()[0] == f"{shop.place}@{entry['digest']}"
    assert text_in(shop.folder / "out", archive.DOCKER)[0]["RepoTags"] is None
    assert "annotations" not in text_in(shop.folder / "out", archive.INDEX)["manifests"][0]


def test_a_connection_that_breaks_costs_nothing(shop: Shop) -> None:
    shop.server.fault("GET", "/blobs/" + oci.digest_of(PACKED["x"]), DROP, 2)
    require_whole(shop.save("more"), "more")


@pytest.mark.parametrize(
    ("layer", "damage", "words"),
    [("x", b"", ("app",)), ("x", b"more", ("app",)), ("p", b"!", ("tuesday", "monday"))],
    ids=["shorter", "longer", "an older layer"],
)
def test_a_damaged_layer_leaves_no_file(
    shop: Shop, layer: str, damage: bytes, words: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    digest = oci.digest_of(PACKED[layer])
    shop.server.blobs["t", digest] = PACKED[layer][:-1] + damage
    tag, *have = map(shop.name, words)
    assert shop.call("save", tag, *(f"--have={name}" for name in have), "-o", shop.folder / "out") == 1
    assert digest in capsys.readouterr().err
    assert [path.name for path in shop.folder.iterdir()] == ["bin"]


def test_a_pipe_gets_the_same_bytes(shop: Shop) -> None:
    argv = [sys.executable, "-m", "rosml", "save", shop.name("more"), "--have", shop.name("base"), "-o"]
    done = subprocess.run([*argv, "-"], capture_output=True, check=True, cwd=ROOT)
    assert done.stdout == shop.save("more", "base").read_bytes()
    assert b"left out: 2 layers" in done.stderr
    shop.engine("docker", "base")
    argv[3:] = ["load", "-"]
    subprocess.run(argv, input=done.stdout, check=True, env={**os.environ, "PATH": f"{shop.folder}/bin"}, cwd=ROOT)
    require_whole(shop.loaded, "more", held="ab")


@pytest.mark.parametrize("out", ["bin", "none/out", "/dev/full"])
def test_a_file_that_cannot_be_written_is_said(shop: Shop, out: str, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(shop.folder / out)
    assert shop.call("save", shop.name("app"), "-o", out) == 1
    assert "cannot be written" in capsys.readouterr().err


def test_a_platform_that_an_image_lacks_is_wrong(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    assert shop.call("save", shop.name("app"), "--platform", "linux/s390x", "-o", shop.folder / "out") == 2
    assert "linux/riscv64, not for linux/s390x" in capsys.readouterr().err


def test_a_delta_counts_each_layer_once(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    assert shop.call("delta", shop.name("app"), shop.name("twice"), "--json", "--platform", "linux/riscv64") == 0
    (platform,) = json.loads(capsys.readouterr().out)["platforms"]
    assert (platform["pulled"], platform["kept"], platform["kept_bytes"]) == (0, 2, len(PACKED["a"]) + len(PACKED["x"]))
    assert shop.call("delta", shop.name("base"), shop.name("moved")) == 0
    pulled = len(PACKED["c"]) + len(PACKED["x"])
    assert f"linux/riscv64: pulls 2 layers, {pulled} B; keeps 1 layer, {len(PACKED['a'])} B" in capsys.readouterr().out


# ---- Loading ---------------------------------------------------------------------------------------------------------


def test_docker_that_cannot_read_zstd_is_said(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    layers = [{**oci.descriptor(LAYER, PACKED[name]), "mediaType": LAYER.replace("gzip", "zstd")} for name in "abx"]
    (shop.folder / "saved.tar").write_bytes(packed(sound(layers=layers)))
    shop.engine("docker")
    assert shop.call("load", shop.folder / "saved.tar") == 0
    (shop.folder / "info.json").write_text('{"ServerVersion": "20.10.24"}')
    assert shop.call("load", shop.folder / "saved.tar") == 2
    assert "before version 23" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["old", "docker", "containerd", "podman"])
def test_an_engine_gets_what_it_lacks(shop: Shop, kind: str) -> None:
    """The app's layer stands on other layers in the new image: docker's classic store does not find it by itself."""
    file = shop.save("moved", "app")
    shop.engine(kind, "base", "app")
    assert shop.call("load", file) == 0
    require_whole(shop.loaded, "moved", held="a" if kind in ("old", "docker") else "")
    assert names_in(shop.loaded)[-1] == archive.DOCKER


def test_podman_that_pulled_what_is_missing_gets_the_image_as_it_was_pushed(shop: Shop) -> None:
    file = shop.save("moved", "app")
    shop.engine("podman", "app")
    (shop.folder / "pulled").write_text("")
    (shop.folder / "saves").rename(shop.folder / "nothing is saved")
    assert shop.call("load", file) == 0
    require_whole(shop.loaded, "moved", held="ax")
    assert text_in(shop.loaded, archive.INDEX)["manifests"] == text_in(file, archive.INDEX)["manifests"]


@pytest.mark.parametrize(
    ("tag", "have", "kind", "held"),
    [
        ("more", "app", "old", "abx"),
        ("twice", "low", "docker", "x"),  # the layer that is there twice is sent, as docker finds it once alone
        ("late", "early", "containerd", ""),  # an image that shares no layer gives the older one
    ],
)
def test_docker_is_not_asked_for_layers_that_it_finds(shop: Shop, tag: str, have: str, kind: str, held: str) -> None:
    file = shop.save(tag, have)
    shop.engine(kind, have)
    for saved in (shop.folder / "saves").iterdir() if kind == "old" else ():
        saved.unlink()
    assert shop.call("load", file) == 0
    require_whole(shop.loaded, tag, held)


def test_what_does_not_fit_is_refused_in_a_sentence(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    file = shop.save("more", "app")
    shop.engine("docker", "base")
    capsys.readouterr()
    assert shop.call("load", file) == 2
    errors = capsys.readouterr().err
    assert re.search(rf"needs 1 layer of {shop.name('app')}@sha256:[0-9a-f]+, which this machine lacks", errors)
    assert not shop.loaded.exists()


@pytest.mark.parametrize("origin", ["registry", "file", "image"])
def test_somebody_named_gives_the_layers(shop: Shop, origin: str, capsys: pytest.CaptureFixture[str]) -> None:
    """What is named alone is asked: the engine's other image would give all."""
    file, other = shop.save("more", "app"), shop.save("app", file="other.tar")
    shop.engine("podman", "base", "app", "twice")
    where = {"registry": shop.name("app"), "file": other, "image": oci.digest_of(config("app", shop.here))}[origin]
    assert shop.call("load", file, "--from", where, "--into", shop.folder / "whole.tar") == 0
    require_whole(shop.folder / "whole.tar", "more")
    assert re.search(rf"\n[0-9]+ layers? of {re.escape(str(where))}\n", capsys.readouterr().out), "not of this machine"
    assert shop.call("load", file, "--from", oci.digest_of(config("base", shop.here))) == 2
    assert not shop.loaded.exists()


def test_a_layer_that_arrives_in_two_attempts_is_whole() -> None:
    data = bytes(range(256)) * 10
    out = io.BytesIO()
    sink = archive.Sink(out, oci.digest_of(data), len(data), lambda _: None)
    sink.write([data[:100], data[100:700]])
    sink.write([data[:650], data[650:690], data[690:701]])
    sink.write(data[at : at + 333] for at in range(0, len(data), 333))
    sink.end()
    assert out.getvalue()[: len(data)] == data


def test_an_engine_that_gives_other_bytes_loads_nothing(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    file = shop.save("more", "app")
    shop.engine("podman", "app")
    (saved,) = (shop.folder / "saves").iterdir()
    data = saved.read_bytes()
    saved.write_bytes(data.replace(b"a" * 5000, b"A" + b"a" * 4999, 1))
    assert shop.call("load", file) == 1
    assert "another digest" in capsys.readouterr().err
    assert archive.DOCKER.encode() not in (shop.loaded.read_bytes() if shop.loaded.exists() else b"")


def test_an_engine_whose_disk_is_full_says_so(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    file = shop.save("app")
    shop.engine("docker")
    (shop.folder / "full").write_text("")
    assert shop.call("load", file) == 1
    errors = capsys.readouterr().err
    assert "docker has no space left for the image" in errors and "podman system df" in errors


def test_an_engine_that_leaves_files_of_its_own(
    shop: Shop, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """podman copies what it reads into TMPDIR, and leaves the copy there if it is killed or its disk gets full."""
    file, folder = shop.save("app"), tmp_path_factory.mktemp("large")
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", None)  # which has the folder of before
    shop.engine("podman")
    (shop.folder / "full").write_text("")
    assert shop.call("load", file) == 1
    assert (shop.folder / "tmpdir").read_text().startswith(f"{folder}/")
    assert list(folder.iterdir()) == []


def test_the_robot_of_another_kind_is_warned(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    out = shop.folder / "saved"
    assert shop.call("save", shop.name("app"), "--platform", "linux/riscv64", "-o", out) == 0
    shop.engine("docker")
    assert shop.call("load", out) == 0
    assert "the image is for linux/riscv64" in capsys.readouterr().err


# ---- Differences -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["old", "docker", "containerd", "podman"])
def test_a_layer_that_replaces_one_arrives_as_what_differs(
    shop: Shop, kind: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = shop.save("tuesday", "monday")
    assert re.search(r"\ndifferences of 1 layer: [0-9.]+ k?B instead of 400\.[0-9] kB\n", capsys.readouterr().out)
    assert file.stat().st_size < 20_000
    assert shop.save("tuesday", "monday", file="again").read_bytes() == file.read_bytes()
    shop.engine(kind, "monday")
    assert shop.call("load", file) == 0
    require_whole(shop.loaded, "tuesday", held="a" if kind in ("old", "docker") else "")
    (entry,) = text_in(shop.loaded, archive.DOCKER)
    assert entry["Config"] == archive.path(oci.digest_of(config("tuesday", shop.here)))
    assert names_in(shop.loaded)[-1] == archive.DOCKER
    assert "differences of 1 layer, " in capsys.readouterr().out


def test_an_older_layer_that_is_not_what_the_file_says_makes_nothing(
    shop: Shop, capsys: pytest.CaptureFixture[str]
) -> None:
    file, early = shop.save("late", "early"), shop.save("early", file="early")
    noted = text_in(file, archive.INDEX)["annotations"][archive.PATCHES]
    wrong = noted.replace(oci.digest_of(PLAIN["p"]), oci.digest_of(PLAIN["a"]))
    words = "--from", early, "--into", shop.folder / "whole.tar"
    assert shop.call("load", changed(file, {archive.PATCHES: wrong}), *words) == 1
    assert f"unpacked, it is not {oci.digest_of(PLAIN['a'])}" in capsys.readouterr().err
    assert not (shop.folder / "whole.tar").exists()


def test_somebody_who_has_the_layer_itself_gives_it(shop: Shop) -> None:
    """So the image keeps its digest."""
    file = shop.save("tuesday", "monday")
    words = "--from", shop.name("tuesday"), "--into", shop.folder / "whole.tar"
    assert shop.call("load", file, *words) == 0
    require_whole(shop.folder / "whole.tar", "tuesday")
    (entry,) = text_in(shop.folder / "whole.tar", archive.INDEX)["manifests"]
    assert text_in(file, archive.INDEX)["manifests"] == [entry]


def test_an_older_layer_that_stays_is_sent_as_well(shop: Shop) -> None:
    """rosml saves no such file, but it is sound."""
    patch, file = shop.save("tuesday", "monday", file="made"), shop.save("both", "monday")
    noted = text_in(patch, archive.INDEX)["annotations"][archive.PATCHES]
    (entry,) = json.loads(noted).values()
    digests = [oci.digest_of(PACKED[name]) for name in "pq"]
    more = {archive.path(entry["digest"]): blobs_in(patch)[entry["digest"]], archive.path(digests[1]): b""}
    changed(file, {archive.PATCHES: noted, archive.LEFT_OUT: json.dumps({"a": digests})}, more)
    shop.engine("containerd", "monday")
    assert shop.call("load", file) == 0
    require_whole(shop.loaded, "both")


def test_an_older_rosml_says_that_it_is_too_old(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    """It knows no annotation about patches."""
    file = changed(shop.save("tuesday", "monday"), {archive.PATCHES: ""})
    shop.engine("containerd", "monday", "night")
    assert shop.call("load", file) == 2
    needed = rf"needs 1 layer of {shop.name('tuesday')}@sha256:[0-9a-f]+ or a newer rosml, which this machine lacks"
    assert re.search(needed, capsys.readouterr().err)


def test_differences_of_a_later_kind_are_refused(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    file = shop.save("tuesday", "monday")
    noted = text_in(file, archive.INDEX)["annotations"][archive.PATCHES].replace(".v1+", ".v2+").replace('"old"', '"x"')
    shop.engine("containerd", "monday")
    assert shop.call("load", changed(file, {archive.PATCHES: noted})) == 2
    errors = capsys.readouterr().err
    assert "differences that this rosml does not know: application/vnd.rosml.layer-patch.v2+zstd" in errors
    assert "update rosml" in errors


def test_a_layer_that_differs_in_all_is_sent_whole(shop: Shop) -> None:
    file = shop.save("other", "monday")
    assert PACKED["r"] in blobs_in(file).values()
    assert archive.PATCHES not in text_in(file, archive.INDEX)["annotations"]
    assert shop.server.count(f"GET .*{oci.digest_of(PACKED['r'])}") == 1


def test_a_layer_that_replaces_no_tar_file_is_sent_whole(shop: Shop) -> None:
    assert PACKED["q"] in blobs_in(shop.save("tuesday", "odd")).values()


@pytest.mark.parametrize("what", ["patch", "older layer"])
def test_damage_loads_nothing(shop: Shop, what: str, capsys: pytest.CaptureFixture[str]) -> None:
    file = shop.save("tuesday", "monday")
    shop.engine("podman", "monday")
    if what == "patch":
        (entry,) = json.loads(text_in(file, archive.INDEX)["annotations"][archive.PATCHES]).values()
        patch_bytes = blobs_in(file)[entry["digest"]]
        file.write_bytes(file.read_bytes().replace(patch_bytes, patch_bytes[:-1] + bytes([patch_bytes[-1] ^ 1])))
    else:
        (saved,) = (shop.folder / "saves").iterdir()
        saved.write_bytes(saved.read_bytes().replace(b"one" * 100, b"One" * 100))
    assert shop.call("load", file) == 1
    assert re.search("is damaged|another digest", capsys.readouterr().err)
    assert archive.DOCKER.encode() not in (shop.loaded.read_bytes() if shop.loaded.exists() else b"")


@pytest.mark.parametrize(
    ("new", "older", "pairs"),
    [
        (image("abc", "A2", "B", "C2"), image("abc", "A1", "B", "C1"), "A2-A1 C2-C1"),  # the same steps
        (image("a.zb", "A2", "Z", "B2"), image("ab.", "A1", "B1"), "A2-A1 B2-B1"),  # one more
        (image("xy", "A2", "B2"), image("ab", "A1", "B1"), "A2-A1 B2-B1"),  # the same place
        (image("xyz", "A2", "B2", "C2"), image("ab", "A1", "B1"), ""),
        (image("a", "A2", "B2"), image("ab", "A1", "B1"), "A2-A1 B2-B1"),  # one whose steps do not fit
        (image("aa", "A3", "A4"), image("aa", "A1", "A2"), "A3-A1 A4-A2"),  # a step twice
        (image("ab", "A", "B"), image("ba", "B", "A"), ""),
    ],
)
def test_what_a_layer_replaces(new: Source, older: Source, pairs: str) -> None:
    replaced_pairs = {(digest, item.digest) for digest, item in pulled_layers.replaced(new, [older]).items()}
    digest_pairs = [pair.split("-") for pair in pairs.split()]
    assert replaced_pairs == {
        (oci.digest_of(one.encode()), oci.digest_of(other.encode())) for one, other in digest_pairs
    }


@pytest.mark.parametrize(("name", "value"), [("LEAST", (1 << 20) + 1), ("MOST", 0)])
def test_small_layers_and_much_larger_ones_do_not_count(monkeypatch: pytest.MonkeyPatch, name: str, value: int) -> None:
    new, older = image("a", "A2"), image("a", "A1")
    assert pulled_layers.replaced(new, [older])
    monkeypatch.setattr(pulled_layers, name, value)
    assert not pulled_layers.replaced(new, [older])


# ---- A stranger's archive --------------------------------------------------------------------------------------------

X = archive.path(oci.digest_of(PACKED["x"]))
TWO = [oci.descriptor(LAYER, PACKED["a"]), oci.descriptor(LAYER, PACKED["b"])]
WRONG = {"digest": "sha256:../../../../etc/passwd", "size": 3, "mediaType": oci.IMAGE}

_X = oci.digest_of(b"x")
ABSENT_PATCH = {
    _X: {"digest": _X, "size": 1, "old": {"digest": _X, "diff_id": _X, "size": 1}, "image": "a"}
    | {"mediaType": apply_patch.MEDIA_TYPE}
}

HOSTILE: dict[str, tuple[bytes, str]] = {
    "a patch that is not there": (
        packed(indexed(annotations={archive.PATCHES: json.dumps(ABSENT_PATCH)})),
        "or has another size of it",
    ),
    "nothing": (b"", "is empty"),
    "gzip": (gzip.compress(packed(sound())), "no tar file"),
    "another tar": (packed({"a": b"b"}), "no OCI archive"),
    "cut in a layer": (packed(sound())[:-4000], "ends within|damaged"),
    "cut in a header": (packed(sound())[: 512 * 3 + 100], "damaged|no OCI archive"),
    "link for the index": (
        packed(sound() | {}, entry_of("blobs/l", kind=tarfile.SYMTYPE, linkname="/etc/passwd")),
        "no plain",
    ),
    "device": (packed(sound(), entry_of("blobs/l", kind=tarfile.CHRTYPE, devmajor=1, devminor=5)), "no plain"),
    "twice, with a dot": (packed(sound(), entry_of(f"./{X}", 3), padded(b"abc")), "twice"),
    "more than there is": (packed(sound(), entry_of("blobs/sha256/f", 1 << 62)), "ends within|damaged"),
    "less than nothing": (packed(sound(), entry_of("blobs/sha256/f", -512)), "below 0|invalid offset"),
    "holes": (packed(sound(), entry_of("blobs/sha256/f", 512, tarfile.GNUTYPE_SPARSE), bytes(512)), "holes"),
    "holes, 1.0": (packed(sound(), sparse(b"22 GNU.sparse.major=1\n22 GNU.sparse.minor=0\n")), "holes"),
    "a number without end": (packed(sound(), pax(b"1" * 1_000_000), entry_of("y")), "damaged"),
    "a number in a record": (packed(sound(), pax(b"900007 a=" + b"1" * 899_997 + b"\n"), entry_of("y")), "digits"),
    "records without end": (packed(sound(), pax(b"2 " * 400_000 + b"="), entry_of("y")), "damaged"),
    "a header of gigabytes": (packed(sound(), entry_of("x", 1 << 40, tarfile.GNUTYPE_LONGNAME)), "a header has"),
    "many entries": (packed(sound(), *(entry_of(f"e{n}") for n in range(5000))), "more than 4,096 entries"),
    "index too large": (packed(sound() | {archive.INDEX: b" " * (5 << 20)}), "at most"),
    "index is a list": (packed(sound() | {archive.INDEX: b"[]"}), "no JSON object"),
    "index without images": (packed(indexed(manifests=[])), "0 images, not one"),
    "index with a path": (packed(indexed(manifests=[WRONG])), "digest"),
    "index of indexes": (packed(indexed(manifests=[oci.descriptor(oci.INDEX, b"{}")])), "no image for one platform"),
    "manifest of another size": (
        packed(indexed(manifests=[{**oci.descriptor(oci.IMAGE, CONFIG), "size": 7}])),
        "instead of 7",
    ),
    "artifact": (packed(sound(config=oci.descriptor("a/b", CONFIG))), "artifact of another kind"),
    "config is no JSON": (packed(sound(config=oci.descriptor(oci.CONFIG, PACKED["a"]))), "its config is no JSON"),
    "fewer layers than the config says": (packed(sound(layers=TWO)), "2 layers, and its config 3"),
    "two sizes": (packed(sound(layers=[*TWO, {**oci.descriptor(LAYER, PACKED["x"]), "size": 5}])), "instead of 5"),
    "one layer for two": (packed(sound(layers=[TWO[0], TWO[0], TWO[1]])), "two things"),
    "a layer nobody left out": (packed({k: v for k, v in sound().items() if k != X}), "does not name as left out"),
    "another layer": (packed(sound() | {X: PACKED["x"][:-1] + b"!"}), "another digest"),
    "another config": (packed(sound() | {archive.path(oci.digest_of(CONFIG)): CONFIG[:-1] + b" "}), "another digest"),
    "odd left out": (packed(indexed(annotations={archive.LEFT_OUT: '{"a": [1]}'})), archive.LEFT_OUT),
}


@pytest.mark.parametrize("case", HOSTILE)
def test_a_strangers_archive_is_refused_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], case: str
) -> None:
    data, message = HOSTILE[case]
    (tmp_path / "in.tar").write_bytes(data)
    monkeypatch.setenv("PATH", str(tmp_path))
    started = time.monotonic()
    code = command.run(main.cli, arguments=["load", str(tmp_path / "in.tar"), "--into", str(tmp_path / "out.tar")])
    errors = capsys.readouterr().err
    assert re.search(message, errors)
    assert code in (1, 2)
    assert "Traceback" not in errors
    assert time.monotonic() - started < 3
    assert [path.name for path in tmp_path.iterdir()] == ["in.tar"]


def test_an_archive_of_a_sound_image_is_read_whoever_wrote_it(tmp_path: Path) -> None:
    """Other programs have other entries as well, and names that lead elsewhere are not looked at."""
    more = [entry_of("../../evil", 3), padded(b"abc"), entry_of("/etc/evil", 3), padded(b"abc")]
    more += [entry_of("blobs", kind=tarfile.DIRTYPE), entry_of("other", kind=tarfile.SYMTYPE, linkname="/")]
    (tmp_path / "in.tar").write_bytes(packed(sound(), *more))
    assert command.run(main.cli, arguments=["load", str(tmp_path / "in.tar"), "--into", str(tmp_path / "out.tar")]) == 0
    require_whole(tmp_path / "out.tar", "app")
    assert len(names_in(tmp_path / "out.tar")) == 8


def test_an_index_of_a_gigabyte_is_not_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with (tmp_path / "in.tar").open("wb") as file:
        file.write(packed({archive.LAYOUT: b"{}"})[:-1024] + entry_of(archive.INDEX, 1 << 30))
        file.truncate(2048 + (1 << 30))
    assert command.run(main.cli, arguments=["load", str(tmp_path / "in.tar"), "--into", str(tmp_path / "out.tar")]) == 1
    assert "index.json has 1,073,741,824 bytes" in capsys.readouterr().err
