"""What is in an app's images: read from their files, and written as an SBOM beside them."""

from __future__ import annotations

import gzip
import hashlib
import json
import os
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from conftest import ROOT
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from fakes.http_registry import LocalRegistry
from fakes.stubs import script_of_a_build
from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.containerize.build import attachments
from rosml.containerize.sources.fetch import Repository
from rosml.images.builds.contents import FILES
from rosml.images.builds.contents import PACKAGES as PACKAGES_FILE
from rosml.images.join import facts, file_lists
from rosml.images.scan import deployed, spdx
from rosml.images.scan.sbom import MEDIA_TYPE, Sbom
from rosml.registry import oci
from rosml.registry.client import Registry

ROBOT = "me/robot"
CONTENTS = ROOT / "components/containerize/contents.py"
SITE = "usr/local/lib/python3.11/dist-packages"
LIBC = "Package: libc6\nSource: glibc (2.36-9)\nArchitecture: amd64\nVersion: 2.36-9+b1\nProvides: libc, libc-virtual (= 2)\n"
TREE = (
    "Package: tree\nArchitecture: all\nVersion: 1:2.1\nMaintainer: Ada <ada@example.org>\n"
    "Pre-Depends: libc-virtual\nDepends: gone | libc6 (>= 2.3), tree:any\n"
)
COPYRIGHT = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Files: *
License: GPL-2+

Files: x
License: Expat
 You may
"""
METADATA = """Name: Some_Thing
Version: 1.0+cpu
Author-email: Ada <ada@example.org>
License: MIT
Classifier: License :: OSI Approved :: MIT License
Classifier: Topic :: Software Development
Requires-Dist: small (>=1)
Requires-Dist: other; extra == "x"
"""
RECORD = "some_thing/__init__.py,sha256=abc,3\n"
FILTERS = {
    "docker-ros/ws/install/filters/lib/filters/filter": "#!/bin/sh\n",
    "docker-ros/ws/install/filters/share/filters/package.xml": "<package format='2'><name>filters</name>"
    "<version>1.9.1</version><license>BSD</license><license file='x'> MIT </license></package>",
}
WHEELS: list[dict[str, Any]] = [
    {
        "name": "Some_Thing",
        "version": "1.0+cpu",
        "author": "Ada <ada@example.org>",
        "licenses": ["MIT", "License :: OSI Approved :: MIT License"],
        "requires": ["small (>=1)", 'other; extra == "x"'],
        "file": "some_thing-1.0-cp311-cp311-manylinux_2_28_x86_64.whl",
        "record": f"{SITE}/some_thing-1.0.dist-info/RECORD",
        "digest": hashlib.sha512(RECORD.encode()).hexdigest(),
    }
]
LISTING = "".join(f"{hashlib.sha512(text.encode()).hexdigest()}  {path}\n" for path, text in sorted(FILTERS.items()))
TIME = 1_700_000_000.0
NONE = attachments.Origins({})
PACKAGES: dict[str, Any] = {
    "system": {"name": "debian", "version": "12", "vendor": "Debian GNU/Linux", "home": "https://www.debian.org/"},
    "apt": [
        {
            "name": "libc6",
            "version": "2.36-9+b1",
            "architecture": "amd64",
            "source": "glibc",
            "source_version": "2.36-9",
            "maintainer": "",
            "depends": "",
            "provides": "libc, libc-virtual (= 2)",
            "licenses": [],
            "digest": "a" * 64,
        },
        {
            "name": "tree",
            "version": "1:2.1",
            "architecture": "all",
            "source": "tree",
            "source_version": "1:2.1",
            "maintainer": "Ada <ada@example.org>",
            "depends": "libc-virtual, gone | libc6 (>= 2.3), tree:any",
            "provides": "",
            "licenses": ["Expat", "GPL-2+"],
            "digest": "b" * 128,
        },
    ],
    "python": WHEELS,
    "ros": [
        {
            **{"name": "filters", "version": "1.9.1", "maintainer": "", "licenses": ["BSD", "MIT"], "depends": []},
            **{"folder": "docker-ros/ws/install/filters", "executable": True},
            "digest": hashlib.sha512(LISTING.encode()).hexdigest(),
        },
        {
            **{
                "name": "robot",
                "version": "0.1.0",
                "maintainer": "Ada <ada@example.org>",
                "licenses": [],
                "depends": ["filters", "roscpp"],
            },
            **{"folder": "", "executable": False, "digest": ""},
        },
    ],
}


@pytest.fixture(scope="module")
def script() -> ModuleType:
    return script_of_a_build("containerize/contents.py")


def write(root: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return root


def test_the_packages_and_files_of_an_image(script: ModuleType, tmp_path: Path) -> None:
    """The upper layer counts where both have a file; what others hold for their own is not counted twice."""
    share = "docker-ros/ws/install/share"
    lower = write(
        tmp_path / "lower",
        {
            "usr/lib/os-release": 'ID=debian\nNAME="Debian GNU/Linux"\nVERSION_ID="12"\nHOME_URL="https://www.debian.org/"\n',
            "usr/local/share/rosml/debs.txt": f"libc6 amd64 2.36-9+b1 {'a' * 64}\ntree all 1:2.1 nothing\n",
            "opt/ros/jazzy/lib/python3.12/site-packages/rclpy-7.egg-info/PKG-INFO": "Name: rclpy\nVersion: 7\n",
            "usr/lib/python3/dist-packages/.keep": "",
            "var/lib/dpkg/status.d/tree": TREE.replace("2.1", "1.9"),
            "usr/local/share/rosml/constraints.d/01.txt": "",
            "usr/share/doc/libtree/copyright": COPYRIGHT,
            f"{share}/robot/package.xml": "<package><name>robot</name><version>0.0.9</version></package>",
            f"{share}/damaged/package.xml": "<package>",
        },
    )
    upper = write(
        tmp_path / "upper",
        {
            f"{SITE}/some_thing-1.0.dist-info/METADATA": f"{METADATA}\nVersion: of a text\n",
            f"{SITE}/some_thing-1.0.dist-info/RECORD": RECORD,
            f"{SITE}/some_thing-1.0.dist-info/WHEEL": "Root-Is-Purelib: false\nTag: cp311-cp311-manylinux_2_28_x86_64\n",
            f"{SITE}/nameless.dist-info/METADATA": "Name: \nVersion: 3\n",
            f"{SITE}/small.dist-info/METADATA": "\ufeffname: small\r\nversion: 3\r\n\r\nName: x\r\n",
            f"{share}/odd/package.xml": "<?xml version='1.0' encoding='x-odd'?><package/>",
            "var/lib/dpkg/status.d/tree": f"{TREE}SHA512: {'b' * 128}\n\n{LIBC}",
            "var/lib/dpkg/status.d/tree.md5sums": "0123  usr/bin/tree\n",
            f"{share}/robot/package.xml": "<package xmlns='https://ros.org'><name> robot </name><version>0.1.0</version>"
            "<maintainer email='ada@example.org'>Ada</maintainer><depend>roscpp</depend><exec_depend>filters</exec_depend>"
            "<build_depend>gcc</build_depend><export><name>other</name></export></package>",
            **FILTERS,
            f"{share}/greedy/package.xml": "<!DOCTYPE x [<!ENTITY a 'b'>]><package><name>greedy</name></package>",
            "docker-ros/ws/install/lib/python3/site-packages/robot-0.1.0.egg-info/PKG-INFO": "Name: robot\nVersion: 0.1.0\n",
        },
    )
    (upper / "docker-ros/ws/install/filters/lib/filters/filter").chmod(0o755)
    (upper / "usr/share/doc").mkdir(parents=True)
    (upper / "usr/share/doc/tree").symlink_to("libtree")
    (upper / "usr/share/doc/libc6").symlink_to("/etc")
    (upper / "etc").mkdir()
    (upper / "etc/os-release").symlink_to("../usr/lib/os-release")
    (upper / "etc/nowhere.egg-info").symlink_to("/nothing")
    out = tmp_path / "out"
    out.mkdir()
    dpkg = write(
        tmp_path / "dpkg",
        {"var/lib/dpkg/info/rclpy.list": "/.\n/opt/ros/jazzy/lib/python3.12/site-packages/rclpy-7.egg-info/PKG-INFO\n"},
    )
    script.write(script.files([lower, upper]), [LIBC, "Package: half\n"], script.owned(dpkg), out)
    small = {"name": "small", "version": "3", "author": "", "licenses": [], "requires": []}
    small |= {"file": "small.dist-info", "record": "", "digest": ""}
    assert json.loads((out / "packages.json").read_text()) == PACKAGES | {"python": [*WHEELS, small]}
    listed = gzip.decompress((out / "files.gz").read_bytes()).decode().splitlines()
    assert listed == sorted(
        str(path.relative_to(root))
        for root in (lower, upper)
        for path in root.rglob("*")
        if (path.is_symlink() or path.is_file())
        and path.name != "01.txt"
        and (root == upper or (path.name != "tree" and path.parent.name != "robot"))
    )


def test_what_dpkg_says_in_other_words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bytes that are no UTF-8 are replaced. What lacks an architecture, or has a place for its name, is no package."""
    monkeypatch.syspath_prepend(str(ROOT / "components/containerize"))  # where scripts find each other
    files = script_of_a_build("containerize/app_files.py")
    installed = "Status: install ok installed\n"
    entries = (
        f"Package: tree\n{installed}Architecture: all\nVersion: 1\nMaintainer: M\xfcller\n",
        f"Package: half\n{installed}Version: 1\n",
        f"Package: ../../../root/x\n{installed}Architecture: all\nVersion: 1\n",
        "Package: gone\nStatus: deinstall ok config-files\nArchitecture: all\nVersion: 1\n",
    )
    (tmp_path / "var/lib/dpkg").mkdir(parents=True)
    (tmp_path / "var/lib/dpkg/status").write_bytes("\n".join(entries).encode("latin-1"))
    assert {*files.status(tmp_path)} == {"tree:all"} and "M\ufffdller" in files.status(tmp_path)["tree:all"]
    assert files.versions(tmp_path / "none", [tmp_path])["apt"] == {"tree": "1"}


def test_names_that_are_no_unicode_are_json_for_all_readers(script: ModuleType) -> None:
    text = script.as_json({"changed": [os.fsdecode(b"etc/M\xfcller"), "etc/é"]}, indent=2)
    assert untrusted.json_of(text, "it") == {"changed": ["etc/M?ller", "etc/é"]}


# ---- The SBOM --------------------------------------------------------------------------------------------------------


def components(url: str = "https://example.org/filters", **packages: object) -> dict[str, dict[str, Any]]:
    """The components of the SBOM of an image with other packages, by name."""
    return {item["name"]: item for item in sbom_of(packages, url)["components"]}


def sbom_of(packages: dict[str, object], url: str = "https://example.org/filters") -> dict[str, Any]:
    sources = {"filters": Repository("filters", url, "noetic", "c0ffee", ".repos", True)}
    data = json.dumps(PACKAGES | packages).encode()
    document: dict[str, Any] = json.loads(
        attachments.sbom(data, "example.org/robot@x", TIME, attachments.Origins(sources))
    )
    assert document["metadata"]["component"]["name"] == "example.org/robot@x"
    return document


def test_an_sbom() -> None:
    items = components()
    assert items["debian"]["type"] == "operating-system"
    assert [items[name]["purl"] for name in ("libc6", "tree", "Some_Thing", "filters")] == [
        "pkg:deb/debian/libc6@2.36-9%2Bb1?arch=amd64&distro=debian-12",
        "pkg:deb/debian/tree@1:2.1?arch=all&distro=debian-12",
        "pkg:pypi/some-thing@1.0%2Bcpu",
        "pkg:generic/ros/filters@1.9.1",
    ]
    assert {item["name"]: item["value"] for item in items["libc6"]["properties"]} == {
        "aquasecurity:trivy:PkgType": "debian",
        "aquasecurity:trivy:SrcName": "glibc",
        "aquasecurity:trivy:SrcVersion": "2.36-9",
        "bsi:component:filename": "libc6_2.36-9+b1_amd64.deb",
        "bsi:component:executable": "non-executable",
        "bsi:component:archive": "archive",
        "bsi:component:structured": "structured",
    }
    filters = items["filters"]
    assert filters["licenses"] == [{"license": {"id": "MIT"}}, {"license": {"name": "BSD"}}]
    vcs, distribution = sorted(filters["externalReferences"], key=lambda it: str(it["type"]), reverse=True)
    assert vcs == {"type": "vcs", "url": "https://example.org/filters", "comment": "noetic"}
    assert distribution["url"] == "file:///docker-ros/ws/install/filters"
    assert {"name": "io.rosml.commit", "value": "c0ffee"} in filters["properties"]
    assert "externalReferences" not in items["robot"]


def test_what_was_deployed_of_each_component() -> None:
    """The best hash that there is, at the place where BSI reads it as well; or the reason why there is none."""
    items = components()
    assert [item["alg"] for name in ("libc6", "tree", "filters", "Some_Thing") for item in items[name]["hashes"]] == [
        "SHA-256",
        *["SHA-512"] * 3,
    ]
    assert items["libc6"]["externalReferences"] == [
        {"type": "distribution", "url": "libc6_2.36-9%2Bb1_amd64.deb", "hashes": items["libc6"]["hashes"]}
    ]
    assert items["Some_Thing"]["externalReferences"][0]["url"] == f"file:///{SITE}/some_thing-1.0.dist-info/RECORD"
    for name, item in items.items():
        properties = {it["name"]: it["value"] for it in item["properties"]}
        assert {deployed.FILENAME, deployed.EXECUTABLE, deployed.ARCHIVE, deployed.STRUCTURED} <= properties.keys()
        assert (deployed.NO_HASH in properties) == ("hashes" not in item) == (name in ("debian", "robot"))
    assert {"name": deployed.EXECUTABLE, "value": "executable"} in items["filters"]["properties"]
    assert items["debian"]["supplier"] == {"name": "Debian GNU/Linux", "url": ["https://www.debian.org/"]}


@pytest.mark.parametrize(
    ("text", "file"),
    [
        ("Tag: py2-none-any\nTag: py3-none-any\n", "x-1-py2.py3-none-any.whl"),
        ("Build: 7\nTag: py3-none-any\n", "x-1-7-py3-none-any.whl"),
        ("Tag: cp3-abi3-manylinux_2_17\nTag: cp3-abi3-manylinux2014\n", "x-1.dist-info"),
        (
            "Generator: maturin (1)\nTag: cp3-abi3-manylinux_2_17\nTag: cp3-abi3-manylinux2014\n",
            "x-1-cp3-abi3-manylinux_2_17.manylinux2014.whl",
        ),
        ("Tag: odd\n", "x-1.dist-info"),
        ("", "x-1.dist-info"),
    ],
)
def test_the_file_name_of_a_wheel(script: ModuleType, text: str, file: str) -> None:
    """If its tags could be in another order, nobody can tell."""
    assert script.wheel("x-1.dist-info", text) == file


@pytest.mark.parametrize(
    ("name", "address", "person"),
    [
        ("Ada", "ada@example.org", "Ada <ada@example.org>"),
        ("", "Ada <ada@example.org>, Bo <bo@example.org>", "Ada <ada@example.org>, Bo <bo@example.org>"),
        ("Ada and Bo", "ada@example.org, bo@example.org", "Ada and Bo"),
        ("Ada", "", "Ada"),
        ("", "ada@example.org", "ada@example.org"),
    ],
)
def test_a_person_by_name_and_address(script: ModuleType, name: str, address: str, person: str) -> None:
    assert script.person(name, address) == person


def test_what_is_too_long_or_has_no_name_stops_nothing(script: ModuleType, tmp_path: Path) -> None:
    metadata = {"a": "Name: a\nVersion: 1\nAuthor: " + "x" * (2 << 20), "b": "Name: /\nVersion: 1\n"}
    root = write(tmp_path / "root", {f"{SITE}/{name}.dist-info/METADATA": text for name, text in metadata.items()})
    (wheel,) = script.packages(script.files([root]), [], set())["python"]
    assert wheel["name"] == "a" and len(wheel["author"]) == script.LONGEST


def test_what_an_sbom_says_of_each_component(script: ModuleType) -> None:
    items, document = components(), sbom_of({})
    metadata, tree, libc, wheel = document["metadata"], items["tree"], items["libc6"], items["Some_Thing"]
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(json.dumps(document)) is None
    assert metadata["timestamp"] == "2023-11-14T22:13:20+00:00" and metadata["authors"] and metadata["tools"]
    assert tree["supplier"] == {"name": "Ada", "contact": [{"email": "ada@example.org"}]}
    assert tree["licenses"] == [{"expression": "GPL-2.0-or-later AND MIT"}]
    assert libc["licenses"] == [
        {"license": {"name": "as its copyright file says", "url": "file:///usr/share/doc/libc6/copyright"}}
    ]
    assert (wheel["supplier"]["name"], wheel["licenses"]) == ("Ada", [{"license": {"id": "MIT"}}])
    needs = {entry["ref"]: entry.get("dependsOn", []) for entry in document["dependencies"]}
    assert needs[tree["bom-ref"]] == [libc["bom-ref"]], "by its name, and by one that it provides"
    assert needs[items["robot"]["bom-ref"]] == [items["filters"]["bom-ref"]]
    assert {*needs["example.org/robot@x"]} == {item["bom-ref"] for item in document["components"]}


@pytest.mark.parametrize(
    ("words", "expression"),
    [
        ("GPL-2+", "GPL-2.0-or-later"),
        ("LGPL-3+ or GPL-2", "LGPL-3.0-or-later OR GPL-2.0-only"),
        ("GPLv3", "GPL-3.0-only"),
        ("GFDL-NIV-1.3+", "GFDL-1.3-no-invariants-or-later"),
        ("GPL-3+ with Bison exception", "GPL-3.0-or-later WITH Bison-exception-2.2"),
        ("GPL-2 with Linux-syscall-note exception", "GPL-2.0-only WITH Linux-syscall-note"),
        ("bsd-3-clause", "BSD-3-Clause"),
        ("BSD", ""),
        ("public-domain", ""),
        ("GPL-2+ or", ""),
        ("(MIT", ""),
    ],
)
def test_licences_by_their_names_in_spdx(words: str, expression: str) -> None:
    (license,) = spdx.of_debian([words])
    assert license == spdx.License(expression or words, bool(expression))


def test_a_licence_is_a_short_name(script: ModuleType) -> None:
    """And no text: of a stranger, and perhaps markup."""
    (license,) = spdx.of_wheel(["<script>alert(1)</script>" + "x" * 10_000 + "\nCopyright"])
    assert len(license.text) <= spdx.LONGEST and not {"<", ">"} & {*license.text}
    assert spdx.of_wheel(["Copyright Ada", "License :: OSI Approved :: MIT License"]) == [spdx.License("MIT", True)]


@pytest.mark.parametrize(
    ("url", "written"),
    [
        ("https://example.org/a b", "https://example.org/a%20b"),
        ("git@example.org:me/x.git", "ssh://git@example.org/me/x.git"),
        ("ssh://git@example.org:22/x", "ssh://git@example.org:22/x"),
        ("file:///home/me/x", None),
        ("/home/me/a:x", None),
    ],
)
def test_the_place_of_a_ros_package(url: str, written: str | None) -> None:
    """As a URL, which CycloneDX wants; a folder of this machine is nobody's business."""
    references = components(url)["filters"].get("externalReferences", [])
    assert [it["url"] for it in references if it["type"] == "vcs"] == ([written] if written else [])


def test_what_nobody_knows_is_left_out_and_the_same_name_counts_once() -> None:
    pairs = (("some_thing", "1"), ("Some-Thing", "1"), ("some_thing", "2"))
    wheels = [{"name": name, "version": version} for name, version in pairs]
    ros = [{"name": "a", "version": "", "licenses": []}]
    document = sbom_of({"system": {"name": "debian", "version": ""}, "apt": [], "python": wheels, "ros": ros})
    refs = {item["bom-ref"] for item in document["components"]}
    assert refs == {"debian", "pypi:some-thing@1", "pypi:some-thing@2", "ros:a@"}


def test_a_licence_of_markup_alone_is_none() -> None:
    ros = [{"name": "a", "version": "1", "licenses": ["<>", " ***"]}]
    assert "licenses" not in components(ros=ros)["a"]


@pytest.mark.parametrize("data", [b"", b"[]", b'{"apt": []}'])
def test_a_damaged_list_of_packages(data: bytes) -> None:
    with pytest.raises(RosmlError, match="is damaged"):
        attachments.sbom(data, "example.org/robot@x", TIME, NONE)


# ---- In a registry ---------------------------------------------------------------------------------------------------

FACTS = gzip.compress(b'{"packages":[],"libraries":[],"files":["etc/motd"]}')
DATA = dict(zip(attachments.KINDS, (json.dumps(PACKAGES).encode(), gzip.compress(b"etc/motd\n"), FACTS), strict=True))


def image(client: Registry, architecture: str) -> dict[str, Any]:
    config = oci.encoded({"os": "linux", "architecture": architecture, "rootfs": {"type": "layers", "diff_ids": []}})
    client.put_blob(ROBOT, config)
    content = {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": []}
    client.put_manifest(ROBOT, f"latest-{architecture}", content)
    entry = oci.descriptor(oci.IMAGE, oci.encoded(content))
    return entry | {"platform": {"os": "linux", "architecture": architecture}}


def load(platform: str, kind: str) -> bytes:
    return DATA[kind].replace(b"amd64", platform.rpartition("/")[2].encode())


@pytest.mark.parametrize("referrers", [True, False])
def test_each_platform_gets_its_contents_once(referrers: bool, server: LocalRegistry) -> None:
    server.referrers = referrers
    with Registry(server.address) as client:
        entries = [image(client, architecture) for architecture in ("amd64", "arm64")]
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        digest = client.put_manifest(ROBOT, "latest", content, oci.INDEX)
        attachments.attach(client, ROBOT, digest, load, NONE)
        for entry in entries:
            [artifact] = client.referrers(ROBOT, entry["digest"], MEDIA_TYPE)
            manifest = client.manifest(ROBOT, artifact["digest"])
            assert manifest and manifest.content["subject"]["digest"] == entry["digest"]
            sbom = Sbom(client.blob(ROBOT, manifest.content["layers"][0]["digest"]))
            assert sbom.is_of(entry["digest"])
            assert f"arch={entry['platform']['architecture']}&" in sbom.content.decode()
            files, app_facts = (
                file_lists.Lists().of(client, ROBOT, entry["digest"]),
                facts.of(client, ROBOT, entry["digest"]),
            )
            assert files and files.entries == {"etc/motd"} and app_facts and app_facts.files == ["etc/motd"]
        server.requests.clear()
        attachments.attach(client, ROBOT, digest, load, NONE)
        assert not [line for line in server.requests if line.split()[0] not in ("GET", "HEAD")]


def test_an_app_that_is_no_layer_on_its_base_has_no_facts(server: LocalRegistry) -> None:
    with Registry(server.address) as client:
        digest = image(client, "amd64")["digest"]
        attachments.attach(client, ROBOT, digest, load, NONE, [PACKAGES_FILE, FILES])
        assert facts.of(client, ROBOT, digest) is None and file_lists.Lists().of(client, ROBOT, digest)


def test_an_image_to_work_on_has_an_sbom_with_the_sources_of_the_app() -> None:
    """A package that an app below it has built is there as such."""
    below = json.dumps(PACKAGES | {"ros": PACKAGES["ros"][:1]}).encode()
    contents = attachments.with_sources(below, json.dumps(PACKAGES).encode())
    document = json.loads(attachments.sbom(contents, "example.org/robot@x", TIME, NONE))
    filters, robot = (it for it in document["components"] if it["name"] in ("filters", "robot"))
    assert filters["hashes"] and "hashes" not in robot
    reasons = [it["value"] for it in robot["properties"] if it["name"] == deployed.NO_HASH]
    assert reasons == ["the image has its sources, and nothing that was built of them"]


def test_an_sbom_of_others_is_none_of_ours(server: LocalRegistry) -> None:
    with Registry(server.address) as client:
        entry = image(client, "amd64")
        client.attach(ROBOT, entry, MEDIA_TYPE, b"{}", MEDIA_TYPE)
        attachments.attach(client, ROBOT, entry["digest"], load, NONE)
        assert len(client.referrers(ROBOT, entry["digest"], MEDIA_TYPE)) == 2
