"""A dossier of an image in a registry: what it has, what it says is missing, and what it writes."""

from __future__ import annotations

import gzip
import io
import json
import tarfile
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.dossiers import HOSTILE, NOW, Shop, components, contents, shop, vex
from fakes.memory_registry import MemoryRegistry, put_image
from rosml.base.errors import RosmlError
from rosml.images.dossier import page, rebuild, scan, texts, write
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME, ENVIRONMENT, ENVIRONMENTS, REVISION, TITLE, VEX
from rosml.images.join.layers import Source
from rosml.images.publish import cosign
from rosml.images.records.store import CREATED
from rosml.images.scan.sbom import FORMAT, LARGEST, MEDIA_TYPE
from rosml.images.scan.trivy import Database, Report, ScannerFailed, Trivy
from rosml.images.scan.vex import MEDIA_TYPE as VEX_TYPE
from rosml.registry import retries
from tests.e2e.parts import Tiny


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Shop]:
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    with shop(tmp_path) as opened:
        yield opened


@pytest.fixture(params=[True, False], ids=["referrers", "tags"])
def any_registry(place: Shop, request: pytest.FixtureRequest) -> Shop:
    place.server.referrers = request.param
    return place


def test_a_published_image(any_registry: Shop) -> None:
    dossier = any_registry.dossier(any_registry.base())
    assert dossier.bill and len(dossier.bill.components) == 7
    assert {*dossier.files} == {"sbom.cdx.json", "provenance.json", "licences.txt"}
    assert dossier.origins[0].inputs == {"target": "ros1-bookworm-core"} and dossier.ends[0].title == "CUDA"
    assert dossier.signature.state == "none"
    missing = "\n".join(dossier.missing)
    assert "VEX: none is attached" in missing and "scan: the scanner is not installed" in missing
    assert "SBOM" not in missing and "provenance" not in missing
    assert dossier.rebuild and dossier.rebuild.commands == (
        "git clone https://example.com/me/rosml .",
        f"git checkout {'0' * 39}1",
        "./rosml image ros1-bookworm-core",
    )


def test_the_commit_is_that_of_the_provenance_if_no_label_says(place: Shop) -> None:
    dossier = place.dossier(place.base(labels={REVISION: ""}))
    assert dossier.rebuild and dossier.rebuild.commands[1] == f"git checkout {'0' * 40}"


def test_read_access_is_enough(place: Shop) -> None:
    reference = place.base()
    before = len(place.server.requests)
    dossier = place.dossier(reference)
    requests = place.server.requests[before:]
    layers = [layer.digest for layer in dossier.image.manifest.layers]
    assert {line.split()[0] for line in requests} <= {"GET", "HEAD"}
    assert not [line for line in requests if any(digest in line for digest in layers)]
    assert len(requests) <= 30


def test_an_app(place: Shop, tmp_path: Path) -> None:
    dossier = place.dossier(place.app(place.base()))
    assert "robot 1.0.0" in [it.title for it in dossier.bill.components] if dossier.bill else False
    assert json.loads(dossier.files[rebuild.LOCK_FILE])["base_image"]["name"].endswith("/rosml/ros:core")
    command = dossier.rebuild.commands[-1] if dossier.rebuild else ""
    assert command.startswith(f"rosml containerize --base-image {place.server.address}/rosml/ros:core@sha256:")
    assert command.endswith(" --lock-file containerize.lock")
    written = write.write(dossier, tmp_path / "out")
    assert written[-1].name == "index.html" and "robot 1.0.0" in written[-1].read_text()


def test_spdx_instead(place: Shop) -> None:
    dossier = place.dossier(place.base(), form="spdx")
    assert json.loads(dossier.files["sbom.spdx.json"])["spdxVersion"] == "SPDX-2.3"
    assert "sbom.cdx.json" not in dossier.files


# ---- What is not there -----------------------------------------------------------------------------------------------


def test_an_image_of_somebody_else(place: Shop, tmp_path: Path) -> None:
    reference = Tiny({}, unlisted=True).put(place.registry, "their/image", "latest")
    dossier = place.dossier(reference)
    assert dossier.missing[0].startswith("rosml did not make this image")
    assert any(line.startswith("SBOM: none of rosml is attached") for line in dossier.missing)
    text = write.write(dossier, tmp_path / "out")[-1].read_text()
    assert "There is no SBOM." in text and "Its labels do not say." in text


def test_an_sbom_by_somebody_else(place: Shop) -> None:
    reference = place.base(with_sbom=False)
    theirs = place.attach(*place.only(reference), MEDIA_TYPE, json.dumps(components()).encode())
    dossier = place.dossier(reference)
    assert dossier.bill is None
    assert f"the SBOM {theirs} does not count: somebody else attached it" in dossier.missing


def test_the_index_says_which_sbom_counts(place: Shop) -> None:
    reference = place.base()
    for number in range(5):
        about = {"component": {"name": f"x@{place.only(reference)[1]}"}}
        place.attach(
            *place.only(reference), MEDIA_TYPE, json.dumps(components(metadata=about, n=number)).encode(), FORMAT
        )
    dossier = place.dossier(reference)
    assert dossier.bill and len(dossier.bill.components) == 7 and not any("SBOM" in it for it in dossier.missing)


def test_an_sbom_that_is_too_large(place: Shop) -> None:
    place.server.referrers = True
    reference = place.base(with_sbom=False)
    repository, digest = place.only(reference)
    name = place.attach(repository, digest, MEDIA_TYPE, b"{}", FORMAT)
    _, data = place.server.manifests[repository, name]
    content = json.loads(data)
    content["layers"][0]["size"] = LARGEST + 1
    place.registry.put_manifest(repository, "", content)
    dossier = place.dossier(reference)
    assert any(line.endswith("it has 200.0 MB, and at most 200.0 MB are read") for line in dossier.missing)


def test_an_image_that_is_gone(place: Shop) -> None:
    reference = place.base()
    for name in (f"{reference}x", f"{place.server.address}/rosml/ros@sha256:{'0' * 64}", "core"):
        with pytest.raises(RosmlError) as caught:
            place.dossier(name)
        assert caught.value.exit_code == 2 and caught.value.remedy


def test_a_platform_that_it_lacks(place: Shop) -> None:
    with pytest.raises(RosmlError, match=r"core is not for linux/riscv64") as caught:
        place.dossier(place.base(), platform="linux/riscv64")
    assert (caught.value.exit_code, caught.value.remedy) == (2, "name one of its platforms: linux/amd64")


def test_provenance_that_the_index_does_not_name(place: Shop) -> None:
    reference = place.base(annotations={})
    place.statement(*place.only(reference))
    dossier = place.dossier(reference)
    assert dossier.origins == [] and "provenance.json" not in dossier.files
    assert "1 statement of provenance that the index does not name are left out" in dossier.missing


def test_what_cannot_be_read_leaves_the_rest(place: Shop) -> None:
    reference = place.base()
    place.server.fault("GET", "referrers", 500, 100)
    place.server.fault("GET", "sha256-", 500, 100)
    dossier = place.dossier(reference)
    assert dossier.bill is None and any(line.startswith("SBOM: ") for line in dossier.missing)
    assert [it.title for it in dossier.ends] == ["ROS"]


# ---- VEX, scan, licences, signature ----------------------------------------------------------------------------------

NOT_AFFECTED = {
    "vulnerability": {"name": "CVE-2026-1"},
    "status": "not_affected",
    "justification": "vulnerable_code_not_in_execute_path",
    "impact_statement": HOSTILE,
    "products": [{"subcomponents": [{"@id": "pkg:deb/debian/bash@5.2.15-2"}, {"@id": "none"}]}],
}


@pytest.fixture
def trivy(monkeypatch: pytest.MonkeyPatch) -> Trivy:
    """A scanner that finds one thing in bash, with a database of three days ago."""

    class Scanner(Trivy):
        updated = "2026-11-26T06:00:00Z"

        def database(self) -> Database:
            return Database(self.updated, "sha256:0")

        def lacks(self, sources: object) -> list[str]:
            return []

        def scan(self, sbom: bytes, what: str) -> Report:
            finding = {"VulnerabilityID": "CVE-2026-1", "PkgName": "bash", "InstalledVersion": "5.2.15-2"}
            finding |= {"Severity": "HIGH", "Title": HOSTILE}
            packages: list[object] = [{}] * (len(json.loads(sbom)["components"]) - 1)
            results = [{"Type": "debian", "Packages": packages, "Vulnerabilities": [finding]}]
            return Report.model_validate({"SchemaVersion": 2, "Results": results})

    scanner = Scanner("trivy", "1", Path("nowhere"))
    monkeypatch.setattr(Trivy, "find", lambda root: scanner)
    return scanner


def test_a_scan_with_vex(place: Shop, trivy: Trivy, tmp_path: Path) -> None:
    reference = place.base()
    place.attach(*place.only(reference), VEX_TYPE, vex(NOT_AFFECTED))
    dossier = place.dossier(reference)
    assert dossier.scan and dossier.scan.counts == [("high", 1)] and dossier.scan.remarks == ()
    [finding] = json.loads(dossier.files["scan.json"])["findings"]
    assert (finding["id"], finding["vex"]) == ("CVE-2026-1", "not_affected")
    assert "no signature covers the VEX: anyone who may push there may have made it" in dossier.missing
    assert json.loads(dossier.files["vex.openvex.json"])["author"] == "us"
    text = write.write(dossier, tmp_path / "out")[-1].read_text()
    assert "not_affected" in text and HOSTILE not in text


def test_the_newest_vex_that_somebody_vouches_for(place: Shop, monkeypatch: pytest.MonkeyPatch) -> None:
    repository, digest = place.only(place.base())
    names = [
        place.attach(repository, digest, VEX_TYPE, vex({**NOT_AFFECTED, "status": status}), {CREATED: created})
        for status, created in (("affected", "2026-11-01"), ("fixed", "2026-11-02"), ("not_affected", "2026-11-03"))
    ]
    manifest = place.registry.manifest(repository, digest)
    assert manifest
    place.index(repository, "core", digest, manifest.size, {VEX: f"ros@{names[0]}"})
    reference = f"{place.server.address}/{repository}:core"

    def status_of(**more: str) -> tuple[str, bool]:
        newest = place.dossier(reference, **more).vex
        assert newest
        return newest.content["statements"][0]["status"], newest.vouched

    assert status_of() == ("affected", True), "the index names it"
    monkeypatch.setattr(cosign, "_program", lambda *_: "cosign")
    monkeypatch.setattr(cosign.Signer, "signed", lambda _, name: name.endswith(names[1]))
    assert status_of(signer="key.pub") == ("fixed", True), "it has a signature of its own"


@pytest.mark.parametrize(("updated", "age"), [("2026-11-22T12:00:00Z", 7), ("2026-11-20T06:00:00Z", 9)])
def test_a_scan_older_than_a_week_is_said(
    place: Shop, trivy: Trivy, monkeypatch: pytest.MonkeyPatch, updated: str, age: int
) -> None:
    """As a warning, in JSON, and on the page also beside the vulnerabilities."""
    monkeypatch.setattr(type(trivy), "updated", updated)
    dossier = place.dossier(place.base())
    text = f"the database of {updated} is {age} days old, and lacks newer vulnerabilities; {scan.FETCH}"
    remarks = [text] if age > 7 else []
    assert [line for line in dossier.missing if line.startswith("scan: ")] == [f"scan: {it}" for it in remarks]
    assert dossier.to_json()["database_age_in_days"] == age
    assert json.loads(dossier.files["scan.json"])["remarks"] == remarks
    vulnerabilities = page.render(dossier, []).partition("<h2>Vulnerabilities</h2>")[2].partition("</section>")[0]
    assert (f"<li>{text}</li>" in vulnerabilities) == (age > 7)


def test_a_scanner_that_fails(place: Shop, trivy: Trivy, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> Report:
        raise ScannerFailed("trivy sbom: broken")

    monkeypatch.setattr(type(trivy), "scan", fail)
    dossier = place.dossier(place.base())
    assert dossier.scan is None and "scan: trivy sbom: broken" in dossier.missing


def test_licences_and_their_texts(place: Shop) -> None:
    dossier = place.dossier(place.base())
    by_name = {it.component: it for it in dossier.texts}
    assert by_name["bash 5.2.15-2"].places == ("usr/share/doc/bash/copyright",)
    assert by_name["libc6 2.36-9"].places == ("usr/share/doc/libc6",), "a link to the folder of another package"
    assert (
        by_name["torch 2.10.0"].places[0].endswith("dist-info/licenses/LICENSE") and not by_name["numpy 1.26.4"].places
    )
    assert "the image has no text of the licences of 3 components" in dossier.missing
    listing = dossier.files["licences.txt"]
    assert "GPL-3.0-or-later\n\n  bash 5.2.15-2: usr/share/doc/bash/copyright\n" in listing
    assert "numpy 1.26.4: no text" in listing


def test_the_texts_of_licences_on_request(place: Shop) -> None:
    reference = place.base()
    assert "licence-texts.txt" not in place.dossier(reference).files
    whole = place.dossier(reference, with_texts=True).files["licence-texts.txt"]
    assert "\nusr/share/doc/bash/copyright\n" in whole and "dist-info/licenses/LICENSE" in whole
    assert "\nusr/share/common-licenses/GPL-3\n" in whole
    assert "METADATA" not in whole and whole.count("linux/amd64") == 1, "the same text once"
    [layer] = place.dossier(reference).image.manifest.layers
    place.server.blobs["rosml/ros", layer.digest] = b"no layer"
    broken = place.dossier(reference, with_texts=True)
    assert "licence-texts.txt" not in broken.files and broken.bill
    assert any(line.startswith("texts of licences: ") for line in broken.missing)


def test_only_what_the_list_names_comes_out_of_a_layer() -> None:
    """And no link, nothing large, and the same bytes of no two paths twice."""
    large, link = tarfile.TarInfo("usr/share/doc/a/copyright"), tarfile.TarInfo("usr/share/doc/b/copyright")
    large.size, link.type, link.linkname = texts.LARGEST + 1, tarfile.SYMTYPE, "/etc/passwd"
    small, other = tarfile.TarInfo("./usr/share/doc/c/copyright"), tarfile.TarInfo("etc/passwd")
    small.size = other.size = 2
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w") as archive:
        for entry in (large, link, small, other):
            archive.addfile(entry, io.BytesIO(b"x" * entry.size))
    layer = gzip.compress(data.getvalue())
    registry = MemoryRegistry()
    digest = put_image(registry, "me/robot", "amd64", {}, [layer])
    manifest = registry.manifest("me/robot", digest)
    assert manifest
    image = Source("robot", registry.host, "me/robot", digest, manifest, registry.config("me/robot", manifest))
    registry.read_blob = lambda repository, digest, read, size=None: read(iter([layer]))  # type: ignore[method-assign]
    places = {f"usr/share/doc/{name}/copyright" for name in "abc"}
    assert texts.read(registry, image, places, lambda line: None) == {"usr/share/doc/c/copyright": "xx"}


def test_signatures(place: Shop, monkeypatch: pytest.MonkeyPatch) -> None:
    reference = place.base()
    tag = place.registry.head("rosml/ros", "core")
    place.attach("rosml/ros", tag, "application/vnd.dev.sigstore.bundle.v0.3+json", b"{}")
    assert place.dossier(reference).signature.state == "signed, not verified"
    without = place.dossier(reference, signer="key.pub").signature
    assert without.state == "signed, not verified" and cosign.INSTALL in without.why
    answers: list[Exception | None] = [None, cosign.SignerFailed("no signature of key.pub", "sign it")]

    class Signer(cosign.Signer):
        def verify(self, reference: str) -> None:
            assert reference == f"{place.server.address}/rosml/ros@{tag}" and "key.pub" in self.verifying
            if error := answers.pop(0):
                raise error

    monkeypatch.setattr(cosign, "_program", lambda *_: "cosign")
    monkeypatch.setattr(cosign, "Signer", Signer)
    assert place.dossier(reference, signer="key.pub").signature.state == "verified"
    refused = place.dossier(reference, signer="key.pub").signature
    assert (refused.state, refused.why) == ("not verified", "no signature of key.pub")


# ---- What is written -------------------------------------------------------------------------------------------------


def test_files_of_the_dossier_before_go_away(place: Shop, tmp_path: Path) -> None:
    reference, out = place.base(), tmp_path / "out"
    write.write(place.dossier(reference, form="spdx"), out)
    (out / "notes.txt").write_text("mine")
    write.write(place.dossier(reference), out)
    assert not (out / "sbom.spdx.json").exists() and (out / "sbom.cdx.json").is_file()
    assert (out / "notes.txt").read_text() == "mine"
    assert json.loads((out / "dossier.json").read_text())["image"].endswith(place.only(reference)[1])


def test_a_zip_file(place: Shop, tmp_path: Path) -> None:
    dossier = place.dossier(place.base())
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        assert write.write(dossier, tmp_path / name / "robot.zip") == [tmp_path / name / "robot.zip"]
    assert (tmp_path / "a/robot.zip").read_bytes() == (tmp_path / "b/robot.zip").read_bytes()
    names = zipfile.ZipFile(tmp_path / "a/robot.zip").namelist()
    assert names == sorted(f"robot/{name}" for name in (*dossier.files, "index.html", "dossier.json"))


def test_folders_with_other_files_stay_as_they_are(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("x")
    for output in (tmp_path, tmp_path / "mine"):
        with pytest.raises(RosmlError) as caught:
            write.require_free(output)
        assert caught.value.exit_code == 2 and caught.value.remedy
    (tmp_path / "folder.zip").mkdir()
    with pytest.raises(RosmlError, match="is a folder"):
        write.require_free(tmp_path / "folder.zip")


def test_every_word_of_strangers_is_text(place: Shop) -> None:
    dossier = place.dossier(place.base())
    labels = {**dossier.image.config.content["config"]["Labels"], TITLE: HOSTILE}
    content = {**dossier.image.config.content, "config": {"Labels": labels}}
    facts = dossier.image.config.facts.model_validate(content)
    dossier.image = replace(dossier.image, config=replace(dossier.image.config, content=content, facts=facts))
    dossier.missing.append(HOSTILE)
    text = page.render(dossier, [HOSTILE])
    assert "<img" not in text and "\u202e" not in text and text.count("&lt;img src=x") >= 4


@pytest.mark.parametrize("word", ["x; rm -rf /", "$(reboot)", "--help", "a\nb", "-x", "x" * 400])
def test_labels_give_no_commands(word: str) -> None:
    labels = {APP: "run", REVISION: word, BASE_NAME: word, BASE_DIGEST: word, TITLE: word}
    assert rebuild.of(labels, False).commands == ("rosml containerize",)
    assert rebuild.of({**labels, APP: ""}, False).commands == ()


def test_environments_are_joined_again() -> None:
    again = rebuild.of({TITLE: "jazzy-base", ENVIRONMENTS: "lerobot ;rm vision"}, False)
    assert again.commands == ("./rosml image jazzy-base",)
    assert "rosml join IMAGE env:lerobot env:vision --tag REFERENCE" in again.notes[0]
    assert rebuild.of({ENVIRONMENT: "lerobot"}, False).commands == ("./rosml env build lerobot",)
    assert rebuild.is_ours({ENVIRONMENT: "lerobot"}) and not rebuild.is_ours({TITLE: "lerobot"})


def test_json_has_what_the_table_says(place: Shop) -> None:
    facts = place.dossier(place.base()).to_json()
    assert facts["components"] == len(contents().apt) + len(contents().python) + 1 and facts["written"] == NOW
    assert {"supplier", "version"} <= {it["name"] for it in facts["fields"]} and facts["vulnerabilities"] is None
