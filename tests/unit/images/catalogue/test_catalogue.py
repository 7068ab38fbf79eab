"""The catalogue says what the registry has: no more, no less, and in a form that does not change under its readers."""

from __future__ import annotations

import dataclasses
import json
import resource
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import SMALL, parse, write_locks

from fakes.memory_registry import DAY, NEXT, PREFIX, MemoryRegistry, Publisher, publisher
from fakes.projects import copy
from fakes.shelf import FIRST, SECOND, THIRD, Shelf, shown
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.cli.images import catalogue as command
from rosml.images.catalogue import packages, site
from rosml.images.catalogue.model import Image, Published
from rosml.images.catalogue.model import Tests as Ran
from rosml.images.catalogue.read import Gatherer
from rosml.images.image_set import locked
from rosml.images.image_set.labels import COVERED
from rosml.images.image_set.model import ImageSet
from rosml.images.records import store, tag_moves
from rosml.registry.place import Place

NOW = "2026-11-22T06:00:00Z"
TORCH = "ros1-bookworm-base-torch-cu128"


def gather(registry: MemoryRegistry, image_set: ImageSet, *only: str, history: int = 10) -> Published:
    return Gatherer(image_set, Place(registry, PREFIX), history).gather(NOW, only)


def image(catalogue: Published, target: str) -> Image:
    return next(item for item in catalogue.images if item.target == target)


@pytest.fixture(scope="module")
def shelf(real: ImageSet) -> Shelf:
    return shown(real)


@pytest.fixture(scope="module")
def catalogue(shelf: Shelf) -> Published:
    return gather(shelf.registry, shelf.image_set)


@pytest.fixture
def one_night(real: ImageSet) -> Shelf:
    """A registry after one run, which a test may change."""
    shelf = Shelf(real)
    shelf.night(FIRST, ["ros1-bookworm"])
    return shelf


# ---- What a publishing run left --------------------------------------------------------------------------------------


@pytest.fixture
def published(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Publisher, ImageSet]:
    """A small matrix that was published by the real steps, but for builds."""
    project = copy(tmp_path / "project")
    image_set = parse(SMALL.replace("components: [core, base, desktop]", "components: [core, base]"))
    write_locks(project, image_set)
    image_set = locked.with_locks(image_set, locked.current_locks(image_set, project))
    where = publisher(project, services(project), monkeypatch)
    where.publish(image_set)
    return where, image_set


def test_what_a_run_published(published: tuple[Publisher, ImageSet]) -> None:
    where, image_set = published
    item = image(gather(where.registry, image_set), "alpha-base-torch-cu1")
    assert (item.status, item.reason) == ("built", "")
    tags = {tag.name: (tag.kind, tag.digest) for tag in item.tags}
    published_tags = where.tagged("ros-torch")
    assert tags == {
        "alpha-base-cu1": ("main", published_tags["alpha-base-cu1"]),
        "alpha-base-cu1-torch2.10.0": ("versions", published_tags["alpha-base-cu1"]),
        "alpha": ("floating", published_tags["alpha"]),
        "latest": ("floating", published_tags["latest"]),
        "alpha-base-cu1-20261122": ("dated", published_tags["alpha-base-cu1"]),
    }
    (build,) = item.builds
    assert (build.digest, build.created) == (published_tags["alpha-base-cu1"], DAY)
    entries = {a: store.Records(where.place).read(item.target, a) for a in ("amd64", "arm64")}
    for platform in build.platforms:
        entry = entries[platform.platform.removeprefix("linux/")]
        assert entry is not None
        assert (platform.digest, platform.inputs) == (entry.digest, entry.inputs)
        assert platform.size.compressed == entry.size == sum(part.compressed for part in platform.parts.values())
        assert platform.tests and platform.tests.passed == 5
        assert (platform.versions, platform.found_inside) == ({"torch": "2.10.0"}, True)
    assert [(move.run, move.previous) for move in item.moves] == [(DAY, "")]


def test_signatures_are_those_of_the_records(published: tuple[Publisher, ImageSet]) -> None:
    where, image_set = published
    records, workflow = store.Records(where.place), "https://github.com/me/x/.github/workflows/n.yml@refs/heads/main"
    entry = records.read("alpha-base", store.INDEX)
    assert entry
    records.write(dataclasses.replace(entry, signed={workflow: DAY, "https://x/;rm -rf $HOME": DAY}))
    assert image(gather(where.registry, image_set), "alpha-base").builds[0].signed == (workflow,)
    records.write(dataclasses.replace(entry, digest=f"sha256:{'0' * 64}", signed={workflow: DAY}))
    assert image(gather(where.registry, image_set), "alpha-base").builds[0].signed == ()


def test_a_tag_that_was_moved_back_is_told_as_it_is(published: tuple[Publisher, ImageSet]) -> None:
    """The records know the newer image; the catalogue describes what the tag points at, with what was known of it."""
    where, image_set = published
    before = where.tagged("ros")["alpha-base"]
    where.publish(image_set, date=NEXT, packages="2", force=True)
    newer = where.tagged("ros")["alpha-base"]
    assert newer != before
    where.undo(date="2026-11-25T03:00:00Z")
    item = image(gather(where.registry, image_set), "alpha-base")
    assert [build.digest for build in item.builds] == [before, newer]
    assert item.builds[0].created == DAY
    tests = item.builds[0].platforms[0].tests
    assert tests and tests.passed == 5, "from what is attached to the image"


# ---- History, parts and layers ---------------------------------------------------------------------------------------


def test_every_image_of_the_matrix_is_there(catalogue: Published, real: ImageSet) -> None:
    assert [item.target for item in catalogue.images] == [item.target for item in real.images if item.tags]
    published = {item.target for item in catalogue.images if item.status == "built"}
    assert published == {
        i.target for i in real.images if i.distribution in ("ros1-bookworm", "ros1-trixie") and i.locked and i.tags
    }
    assert all(bool(item.builds) == (item.status == "built") for item in catalogue.images)


def test_history(catalogue: Published) -> None:
    item = image(catalogue, TORCH)
    assert [build.created for build in item.builds] == [THIRD, SECOND, FIRST]
    assert [build.tags[-1] for build in item.builds] == [
        f"ros1-bookworm-base-cu128-{day}" for day in (20261122, 20261121, 20261120)
    ]
    assert [move.run for move in item.moves] == [THIRD, SECOND, FIRST]
    assert (item.moves[0].previous, item.moves[0].new) == (item.builds[1].digest, item.builds[0].digest)
    numpy = [build.platforms[0].versions["numpy"] for build in item.builds]
    assert numpy == ["1.26.5", "1.26.4", "1.26.4"], "each as it was catalogue then"
    assert [build.platforms[0].ros_sync for build in item.builds] == ["lists-2", "lists-2", "lists-1"]


def test_a_distribution_names_what_to_take_after_its_end_of_life(shelf: Shelf) -> None:
    gatherer = Gatherer(shelf.image_set, Place(shelf.registry, PREFIX))
    for day, others in (("2028-06-30", ()), ("2028-07-01", ("ros1-trixie",))):
        assert gatherer.gather(f"{day}T06:00:00Z", [TORCH]).distributions["ros1-bookworm"].instead == others


def test_whatever_a_tag_points_at_is_described(real: ImageSet) -> None:
    """Twelve nights leave twelve dated tags, more than the limit for what has none; of parts as well."""
    shelf = Shelf(real)
    for night in range(12):
        shelf.torch = str(night)
        shelf.night(f"2026-11-{11 + night}T03:00:00Z", ["ros1-bookworm"])
    catalogue = gather(shelf.registry, shelf.image_set, TORCH)
    torch = next(part for part in catalogue.parts if part.name == "torch-cu128-py311")
    names = shelf.registry.names[f"{PREFIX}/ros-torch"]
    for day in range(20261111, 20261122):
        del names[f"ros1-bookworm-base-cu128-{day}"]
    short = image(gather(shelf.registry, shelf.image_set, TORCH, history=1), TORCH)
    assert [bool(build.tags) for build in short.builds] == [True, False], "history without a tag ends somewhere"
    for item in (image(catalogue, TORCH), torch):
        assert len([tag for tag in item.tags if tag.kind == "dated"]) == 12
        assert {tag.digest for tag in item.tags} == {build.digest for build in item.builds}
        assert [build.created[8:10] for build in item.builds] == [str(day) for day in range(22, 10, -1)]


def test_layers_are_those_of_the_part_that_brought_them(catalogue: Published) -> None:
    item = image(catalogue, TORCH)
    (platform,) = item.builds[0].platforms
    parts = [catalogue.layers[position].part for position in platform.layers]
    below = ["ros1-bookworm-core", "ros1-bookworm-base"]
    assert list(dict.fromkeys(parts)) == [*below, "cuda-cu128", "common-cu128-py311", "torch-cu128-py311"]
    assert list(platform.parts) == list(dict.fromkeys(parts))
    first = item.builds[2].platforms[0]
    assert [catalogue.layers[position].part for position in first.layers] == parts, "of builds before as well"


def test_unpacked_sizes_are_measured_or_not_told(catalogue: Published, real: ImageSet) -> None:
    parts = image(catalogue, TORCH).builds[0].platforms[0].parts
    disk = {part.name: part.disk.unpacked * 1_000_000 for part in real.parts}
    assert parts["cuda-cu128"].unpacked == disk["cuda-cu128"], "what the image with CUDA alone has more than ROS"
    assert parts["ros1-bookworm-base"].unpacked == real.matrix.disk.components["base"].unpacked * 1_000_000
    assert parts["torch-cu128-py311"].unpacked is None, "never without the common part, which nobody measured alone"


def test_packages_are_read_from_the_sboms_that_an_index_names(shelf: Shelf, catalogue: Published) -> None:
    (platform,) = image(catalogue, TORCH).builds[0].platforms
    sboms = [catalogue.sboms[position] for position in platform.sboms]
    parts = ["part-common-cu128-py311", "part-cuda-cu128", "part-torch-cu128-py311", "ros1-bookworm-base"]
    assert [item.part for item in sboms] == parts
    assert [item.repository for item in sboms] == ["part", "part", "part", "ros"]
    read, unread = packages.read(Place(shelf.registry, PREFIX), catalogue)
    assert (unread, read[sboms[2].digest]) == ([], [("pillow", "11.0", "pypi"), ("torch", "2.2", "pypi")])
    alone = gather(shelf.registry, shelf.image_set, TORCH)
    bases = [alone.sboms[build.platforms[0].sboms[3]].digest for build in alone.images[0].builds]
    assert bases[0] == bases[1] != bases[2]
    read, _ = packages.read(Place(shelf.registry, PREFIX), alone)
    assert bases[1] in read and bases[2] not in read, "of the newest two builds alone"


def test_vulnerabilities_have_names_and_what_is_none_is_left_out(one_night: Shelf) -> None:
    """Whoever may write records may write anything: what is no advisory counts, and has no name."""
    records = store.Records(Place(one_night.registry, PREFIX))
    entry = records.read("ros1-bookworm-core", "amd64")
    assert entry
    (good, *_) = entry.scan["named"]
    assert (good["id"], good["until"]) == ("CVE-2026-1000", "2027-03-31")
    odd = {
        "id": "<script>",
        "severity": "mild",
        "package": "a\u202eb",
        "installed": "1" * 129,
        "until": "tomorrow",
        "x": 1,
    }
    bad = [*(good | {name: value} for name, value in odd.items()), {}, "CVE-2026-1"]
    for entries, expected in (([*bad, good], 1), ([good] * 30, 20), (bad, 0)):
        records.write(dataclasses.replace(entry, scan={**entry.scan, "named": entries}))
        item = image(gather(one_night.registry, one_night.image_set, "ros1-bookworm-core"), "ros1-bookworm-core")
        scan = next(p.scan for p in item.builds[0].platforms if p.platform == "linux/amd64")
        assert scan and scan.findings == {"medium": 3}
        assert [catalogue.id for catalogue in scan.vulnerabilities] == ["CVE-2026-1000"] * expected


def test_an_sbom_that_is_none_is_left_out(one_night: Shelf) -> None:
    """Anybody who may push can write any annotation, and attach anything."""
    catalogue = gather(one_night.registry, one_night.image_set, "ros1-bookworm-core")
    amd64, arm64 = (platform.sboms[0] for platform in catalogue.images[0].builds[0].platforms)
    del one_night.registry.manifests[f"{PREFIX}/ros"][catalogue.sboms[amd64].digest]
    read, unread = packages.read(Place(one_night.registry, PREFIX), catalogue)
    assert list(read) == [catalogue.sboms[arm64].digest]
    assert unread == ["the SBOM of ros1-bookworm-core is left out: its SBOM is not there"]
    index = one_night.registry.manifest(f"{PREFIX}/ros", "ros1-bookworm-core")
    assert index
    for item in index.content["manifests"]:
        item["annotations"] = {
            f"{COVERED}ros1-bookworm-core": f"../ros@{catalogue.sboms[amd64].digest}",
            f"{COVERED}x": "y",
        }
    digest = one_night.registry.put_manifest(f"{PREFIX}/ros", "", index.content, index.media_type)
    one_night.registry.names[f"{PREFIX}/ros"]["ros1-bookworm-core"] = digest
    (item,) = gather(one_night.registry, one_night.image_set, "ros1-bookworm-core").images
    assert [platform.sboms for platform in item.builds[0].platforms] == [(), ()]


def test_words_for_a_search_come_from_the_matrix(catalogue: Published, real: ImageSet) -> None:
    item = image(catalogue, "jazzy-base-torch-cu130")
    words = {"noble", "ubuntu 24.04", "py312", "ros2", "lts", "gpu", "jetson", "driver 580", "pytorch", "aarch64"}
    assert words <= set(item.search)
    assert item.promised_tags == tuple(tag.partition(":")[2] for tag in real.by_target[item.target].tags)
    assert "jazzy" in item.promised_tags and not item.tags, "though none of them is published"
    bare = set(image(catalogue, "ros1-bookworm-core").search)
    assert {"debian 12", "bookworm", "debian:bookworm"} <= bare and not {"gpu", "cuda", "jetson", "lts"} & bare
    onnx = set(image(catalogue, "jazzy-base-onnx-cu130").search)
    assert {"onnxruntime", "aarch64"} <= onnx and "jetson" not in onnx, "it was built for other GPUs"


def test_addons_are_in_it(catalogue: Published, real: ImageSet) -> None:
    assert catalogue.addons["devel"].restricted and not catalogue.addons["onnx"].restricted
    assert (catalogue.addons["devel"].title, catalogue.addons["devel"].stacks) == ("nvcc", ("cu130", "cu132"))
    assert {"onnx", "onnxruntime"} <= {*catalogue.addons["onnx"].words}
    item = image(catalogue, "jazzy-base-torch-cu130")
    assert item.addons == () and item.takes["devel"].parts == ("devel-cu130",)
    assert image(catalogue, "jazzy-base-onnx-cu130").addons == ("onnx",)
    assert image(catalogue, "jazzy-base").takes["onnx-cpu"].addon == "onnx"
    assert all({*taken.parts} <= {*real.part_by_name} for each in catalogue.images for taken in each.takes.values())


def test_only_some(shelf: Shelf) -> None:
    some = gather(shelf.registry, shelf.image_set, TORCH)
    assert [item.target for item in some.images] == [TORCH]
    assert {part.name for part in some.parts} == {"cuda-cu128", "common-cu128-py311", "torch-cu128-py311"}
    assert "ros1-bookworm-core" in some.images[0].builds[0].platforms[0].parts, "though it was not asked for"
    with pytest.raises(RosmlError, match="no image"):
        gather(shelf.registry, shelf.image_set, "ros1-bookworm-cor")


# ---- What is not as it should be -------------------------------------------------------------------------------------


def test_sharing_is_counted(catalogue: Published) -> None:
    built = [item.builds[0] for item in catalogue.images if item.builds]
    layers = [catalogue.layers[position] for build in built for p in build.platforms for position in p.layers]
    stored = {layer.digest: layer.compressed for layer in layers}
    assert catalogue.sharing.apart == sum(layer.compressed for layer in layers)
    assert catalogue.sharing.stored == sum(stored.values()) < catalogue.sharing.apart / 10


def test_an_empty_registry(real: ImageSet) -> None:
    catalogue = gather(MemoryRegistry(), real)
    assert all((item.status, item.builds, item.tags) == ("not built", (), ()) for item in catalogue.images)
    reasons = {item.target: item.reason for item in catalogue.images}
    assert reasons["jazzy-base"] == "no publishing run has built it yet"
    assert reasons["ros1-bookworm-base-torch-cpu"] == "locks/cpu/amd64/3.11/torch.txt is missing"
    assert (catalogue.sharing.images, catalogue.sharing.apart, catalogue.layers) == (0, 0, ())


def test_one_damaged_image_hides_no_other(one_night: Shelf) -> None:
    path = f"{PREFIX}/ros"
    index = one_night.registry.manifest(path, "ros1-bookworm-core")
    assert index
    del one_night.registry.manifests[path][index.content["manifests"][0]["digest"]]
    gatherer = Gatherer(one_night.image_set, Place(one_night.registry, PREFIX))
    catalogue = gatherer.gather(NOW)
    assert [remark.partition(" is left out")[0] for remark in gatherer.remarks] == [f"ros@{index.digest}"]
    core = image(catalogue, "ros1-bookworm-core")
    assert (core.status, core.builds) == ("not built", ())
    assert index.digest in core.reason
    assert image(catalogue, "ros1-bookworm-base").status == "built"


def test_a_registry_that_goes_away_is_no_damaged_image(one_night: Shelf, monkeypatch: pytest.MonkeyPatch) -> None:
    """A page that lacks half of the images, and nobody is told, would be worse than none."""
    kept, blob = one_night.registry.head, one_night.registry.blob
    gone: list[str] = []

    def read(repository: str, name: str, limit: int) -> bytes:
        if repository.endswith("records") or not repository.endswith("ros"):
            return blob(repository, name)
        gone.append(name)
        raise RosmlError("registry.example does not answer", "check the network")

    def head(repository: str, reference: str) -> str:
        if gone:
            raise RosmlError("registry.example does not answer", "check the network")
        return kept(repository, reference)

    monkeypatch.setattr(one_night.registry, "blob", read)
    monkeypatch.setattr(one_night.registry, "head", head)
    with pytest.raises(RosmlError, match="does not answer"):
        gather(one_night.registry, one_night.image_set)


@pytest.mark.parametrize("text", ["{", '{"moves": [{"fly": 1}]}'])
def test_a_damaged_record_is_told(one_night: Shelf, text: str) -> None:
    place = Place(one_night.registry, PREFIX)
    store.Records(place).artifact(tag_moves.record_name(SECOND), text.encode(), {})
    gatherer = Gatherer(one_night.image_set, place)
    assert [move.run for move in image(gatherer.gather(NOW), TORCH).moves] == [FIRST]
    assert gatherer.remarks == [f"the record {tag_moves.record_name(SECOND)} cannot be read"]


def without_what_is_attached(registry: MemoryRegistry) -> MemoryRegistry:
    """The images of a registry, with no tags and nothing attached to them."""
    images = {
        path: {digest: manifest for digest, manifest in manifests.items() if not manifest.content.get("subject")}
        for path, manifests in registry.manifests.items()
    }
    return MemoryRegistry(manifests=images, blobs=registry.blobs)


def test_what_the_records_do_not_know_is_described_without_them(one_night: Shelf) -> None:
    """Such as an image that `rosml join` tagged, or that a run published into another registry."""
    ros = f"{PREFIX}/ros"
    index = one_night.registry.manifest(ros, "ros1-bookworm-core")
    assert index
    member = index.content["manifests"][0]["digest"]
    bare = without_what_is_attached(one_night.registry)

    def described(digest: str) -> Image:
        bare.names[ros] = {"ros1-bookworm-core": digest}
        return image(gather(bare, one_night.image_set), "ros1-bookworm-core")

    item = described(member)
    assert (item.status, item.builds) == ("not built", ())
    assert item.reason == f"its tag points at {member}, which cannot be read"
    content = {name: value for name, value in index.content.items() if name != "annotations"}
    item = described(bare.put_manifest(ros, "", content, index.media_type))
    platform = item.builds[0].platforms[0]
    assert (item.status, item.builds[0].created, platform.platform) == ("built", "", "linux/amd64")
    assert (platform.tests, platform.scan, platform.size.unpacked, platform.inputs) == (None, None, None, "")
    assert (platform.versions, platform.found_inside) == ({"python": "3.11"}, False)
    versions = {"ros-distro": "x"}
    facts: dict[str, Any] = {"repository": "ros", "passed": 21, "versions": versions, "date": FIRST}
    entry = store.Entry("ros1-bookworm-core", "amd64", digest=member, **facts)
    store.Records(Place(bare, PREFIX)).attach(entry, {})
    platform = described(index.digest).builds[0].platforms[0]
    assert (platform.tests, platform.versions) == (Ran(passed=21, failures=()), versions), "from the attached entry"


def test_the_same_facts_give_the_same_text(shelf: Shelf, catalogue: Published) -> None:
    text = site.text(catalogue)
    assert text == site.text(gather(shelf.registry, shelf.image_set))
    assert Published.model_validate_json(text) == catalogue


# ---- The folder and the command --------------------------------------------------------------------------------------


def test_packages_of_builds_that_are_gone_go(tmp_path: Path, catalogue: Published) -> None:
    gone, kept = f"sha256:{'0' * 64}", f"sha256:{'1' * 64}"
    site.write(tmp_path, catalogue, {gone: [("a", "1", "deb")], kept: []})
    (tmp_path / "packages/mine.js").write_text("mine")
    site.write(tmp_path, catalogue, {kept: [("\u2028</script>", "1", "deb")]})
    assert sorted(file.name for file in (tmp_path / "packages").iterdir()) == [f"{'1' * 64}.js", "mine.js"]
    assert "\u2028" not in (tmp_path / f"packages/{'1' * 64}.js").read_text()


def test_the_page_is_written_beside_its_data(tmp_path: Path, catalogue: Published) -> None:
    names = {file.name for file in site.write(tmp_path / "a/b", catalogue)}
    assert {path.name for path in (tmp_path / "a/b").iterdir()} == names
    page = (tmp_path / "a/b/index.html").read_text()
    assert all(file.name == "index.html" or f'"{file.name}"' in page for file in site.SOURCES.iterdir())
    script, packaged = (tmp_path / "a/b/data.js").read_text().splitlines()
    inner = script.removeprefix("window.catalogue = JSON.parse(").removesuffix(");")
    assert packaged == "window.packaged = [];"
    assert json.loads(json.loads(inner)) == json.loads((tmp_path / "a/b/catalogue.json").read_text())


@contextmanager
def longest_file(size: int) -> Iterator[None]:
    """No file may get longer, as on a disk that gets full. `size` is in bytes."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_page_that_finds_no_room_changes_nothing(tmp_path: Path, catalogue: Published) -> None:
    (tmp_path / "catalogue.json").write_text("before")
    (tmp_path / "CNAME").write_text("mine")
    size = max(file.stat().st_size for file in site.SOURCES.iterdir()) - 1
    catalogue = catalogue.model_copy(
        update={"images": (), "parts": (), "layers": (), "sboms": ()}
    )  # there is room for the first files
    assert len(site.text(catalogue)) < size / 2
    with longest_file(size), pytest.raises(RosmlError, match="cannot be written"):
        site.write(tmp_path, catalogue)
    assert {file.name: file.read_text() for file in tmp_path.iterdir()} == {"catalogue.json": "before", "CNAME": "mine"}


def test_a_page_stays_in_its_folder(tmp_path: Path, catalogue: Published) -> None:
    other, folder = tmp_path / "other.html", tmp_path / "site"
    other.write_text("mine")
    folder.mkdir()
    (folder / "index.html").symlink_to(other)
    with pytest.raises(RosmlError, match=f"index.html is a link, to {other}") as caught:
        site.write(folder, catalogue)
    assert "remove the link" in caught.value.remedy and other.read_text() == "mine"
    assert [file.name for file in folder.iterdir()] == ["index.html"]


@pytest.fixture
def here(shelf: Shelf, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command's registry is the shelf."""

    def client(host: str, ca_bundle: str = "") -> MemoryRegistry:
        assert host == "ghcr.io"
        monkeypatch.setattr(shelf.registry, "host", host)
        return shelf.registry

    monkeypatch.setattr("rosml.registry.place.Registry", client)


def call(*arguments: str) -> Any:
    return CliRunner().invoke(command.main, ["--registry", f"ghcr.io/{PREFIX}", *arguments])


@pytest.mark.usefixtures("here")
def test_the_command_writes_a_page_or_prints_json(tmp_path: Path) -> None:
    done = call("--json", "--only", TORCH, "--output", str(tmp_path / "page"))
    assert json.loads(done.stdout)["images"][0]["target"] == TORCH and not (tmp_path / "page").exists()
    (tmp_path / "file").write_text("")
    done = call("--only", TORCH, "--output", str(tmp_path / "file/page"))
    assert isinstance(done.exception, RosmlError) and "choose a writable folder" in done.exception.remedy
    done = call("--output", str(tmp_path / "page"), "--only", f"{TORCH} ros1-bookworm-core")
    assert done.exit_code == 0, done.output
    assert "2 images described, 2 of them published in ghcr.io/rosml" in done.stderr
    assert done.stdout.strip() == (tmp_path / "page/index.html").as_uri()
