"""SBOMs that are put together, as images are."""

from __future__ import annotations

import json
import time
from typing import Any

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from rosml.images.scan import cyclonedx
from rosml.images.scan import needs as needs_of
from rosml.images.scan.packages import Apt, Packages, Python, Ros, System
from rosml.images.scan.sbom import Sbom
from rosml.registry.documents import Config

TIME = 1_700_000_000.0


def of_ros() -> Sbom:
    packages = [("bash", "libc6"), ("libc6", ""), ("python3-yaml", "libc6 (>= 2)")]
    apt = [
        Apt(name=name, version="1", architecture="amd64", source=name, source_version="1", depends=depends)
        for name, depends in packages
    ]
    contents = Packages(system=System(name="debian", version="12"), apt=apt, python=[], ros=[])
    return Sbom(cyclonedx.document(contents, "x/ros@sha256:0", TIME))


REQUIRES = [
    "numpy",
    "PyYAML (>=6)",
    'nvidia-cublas ; platform_machine == "x86_64"',
    'colorama; os_name == "nt"',
    "gone",
]


def of_torch() -> Sbom:
    wheels = [Python(name="torch", version="2", requires=REQUIRES), Python(name="numpy", version="1")]
    contents = Packages(system=System(name="", version=""), apt=[], python=wheels, ros=[])
    return Sbom(cyclonedx.document(contents, "x/part@sha256:1", TIME))


def of_both() -> dict[str, Any]:
    content = cyclonedx.joined("x/ros@sha256:2", TIME, [("ros", of_ros()), ("torch", of_torch())])
    document: dict[str, Any] = json.loads(content)
    return document


def test_an_image_has_the_components_of_its_parts() -> None:
    document = of_both()
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(json.dumps(document)) is None
    parts = {
        item["name"]: [it["value"] for it in item["properties"] if it["name"] == cyclonedx.PART]
        for item in document["components"]
    }
    assert parts == {
        "debian": ["ros"],
        "bash": ["ros"],
        "libc6": ["ros"],
        "python3-yaml": ["ros"],
        "torch": ["torch"],
        "numpy": ["torch"],
    }
    assert document["metadata"]["component"]["name"] == "x/ros@sha256:2"
    needs = {entry["ref"]: entry["dependsOn"] for entry in document["dependencies"]}
    assert len(needs["x/ros@sha256:2"]) == 6 and not {"x/ros@sha256:0", "x/part@sha256:1"} & needs.keys()


def test_what_is_no_component_of_the_image_is_nobodys_need() -> None:
    """As after a rebase, which leaves out what the old base image had."""
    part = Sbom(of_ros().content, lambda component: component["name"] != "libc6")
    document = json.loads(cyclonedx.joined("x/app@sha256:3", TIME, [("", part), ("torch", of_torch())]))
    assert "libc6" not in {item["name"] for item in document["components"]}
    refs = {item["bom-ref"] for item in document["components"]}
    assert all({*entry["dependsOn"]} <= refs for entry in document["dependencies"])


def state(content: bytes, ref: str) -> tuple[list[str], str, str]:
    """What a component needs, how complete that is, and the names that nothing in the document has."""
    document = json.loads(content)
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(content.decode()) is None
    (needs,) = (entry["dependsOn"] for entry in document["dependencies"] if entry["ref"] == ref)
    (state,) = (it["aggregate"] for it in document["compositions"] if ref in it.get("dependencies", ()))
    (component,) = (item for item in document["components"] if item["bom-ref"] == ref)
    names = [it["value"] for it in component["properties"] if it["name"] == needs_of.NEEDS]
    return needs, state, "".join(names)


def test_a_wheel_needs_what_other_parts_have() -> None:
    """By name, also if the system has it as a package of its own. In an image, what is needed elsewhere is not needed."""
    numpy, cublas = "pypi:numpy@1", "pypi:nvidia-cublas@12"
    unmet = "pypi:colorama? pypi:gone pypi:nvidia-cublas? pypi:pyyaml"
    assert state(of_torch().content, "pypi:torch@2") == ([numpy], "incomplete", unmet)
    wheel = Python(name="nvidia_cublas", version="12")
    packages = Packages(system=System(name="", version=""), apt=[], python=[wheel], ros=[])
    cuda = Sbom(cyclonedx.document(packages, "x/part@sha256:2", TIME))
    assert state(cuda.content, cublas) == ([], "complete", "")
    parts = [("ros", of_ros()), ("torch", of_torch()), ("cuda", cuda)]
    whole = cyclonedx.joined("x/ros@sha256:3", TIME, parts)
    yaml = "apt:python3-yaml:amd64@1"
    assert state(whole, "pypi:torch@2") == ([yaml, numpy, cublas], "incomplete", "pypi:gone")
    assert state(whole, yaml) == (["apt:libc6:amd64@1"], "complete", "")
    assert whole == cyclonedx.joined("x/ros@sha256:3", TIME, parts), "the same at any time"


def test_only_an_environment_needs_its_own_packages() -> None:
    """Beside another numpy; also in an app on an image with it."""
    torch = [Python(name="torch", version="2", requires=["numpy"])]
    policy = [Python(name="policy", version="3", requires=["numpy", "torch"]), Python(name="numpy", version="2")]
    parts = {"torch": torch, "common": [Python(name="numpy", version="1")], "env:policy-py311": policy}
    packages = {
        name: Packages(system=System(name="", version=""), apt=[], python=wheels, ros=[])
        for name, wheels in parts.items()
    }
    sboms = [(name, Sbom(cyclonedx.document(it, f"x/{name}@sha256:1", TIME))) for name, it in packages.items()]
    owners = {str(component["bom-ref"]): name for name, sbom in sboms for component in sbom.components}
    whole = packages["torch"].model_copy(update={"python": [wheel for wheels in parts.values() for wheel in wheels]})
    app = cyclonedx.document(whole, "x/app@sha256:3", TIME, parts=owners)
    for content in (cyclonedx.joined("x/ros@sha256:3", TIME, sboms), app):
        assert state(content, "pypi:torch@2") == (["pypi:numpy@1"], "complete", "")
        assert state(content, "pypi:policy@3") == (["pypi:numpy@2", "pypi:torch@2"], "complete", "")


def test_a_package_needs_what_its_new_base_image_has() -> None:
    app = Sbom(of_ros().content, lambda component: component["name"] == "bash")
    apt = [Apt(name="libc6", version="2", architecture="amd64", source="libc6", source_version="2")]
    packages = Packages(system=System(name="debian", version="13"), apt=apt, python=[], ros=[])
    base = Sbom(cyclonedx.document(packages, "x/ros@sha256:4", TIME))
    moved = cyclonedx.joined("x/app@sha256:5", TIME, [("", base), ("", app)])
    assert state(moved, "apt:bash:amd64@1") == (["apt:libc6:amd64@2"], "complete", "")
    without = cyclonedx.joined("x/app@sha256:5", TIME, [("", app)])
    assert state(without, "apt:bash:amd64@1") == ([], "incomplete", "apt:libc6:amd64@1")


@pytest.mark.parametrize("package", ["ros-noetic-tf2-ros", "libtf2-ros-dev", "python3-tf2-ros", "ros-tf2-ros"])
def test_a_ros_package_needs_one_of_its_system(package: str) -> None:
    apt = [Apt(name=package, version="2", architecture="amd64", source="x", source_version="2")]
    ros = [Ros(name="robot", version="1", licenses=[], depends=["tf2_ros"])]
    packages = Packages(system=System(name="debian", version="13"), apt=apt, python=[], ros=ros)
    content = cyclonedx.document(packages, "x/app@sha256:5", TIME)
    assert state(content, "ros:robot@1") == ([f"apt:{package}:amd64@2"], "complete", "")


def test_a_ros_package_needs_a_wheel_by_the_key_of_rosdep() -> None:
    ros = [Ros(name="robot", version="1", licenses=[], depends=["python3-flask-cors-pip", "python3-yaml"])]
    wheels = [Python(name="Flask_Cors", version="6"), Python(name="pip", version="25")]
    packages = Packages(system=System(name="debian", version="13"), apt=[], python=wheels, ros=ros)
    content = cyclonedx.document(packages, "x/app@sha256:5", TIME)
    assert state(content, "ros:robot@1") == (["pypi:flask-cors@6"], "incomplete", "ros:python3-yaml")


def test_a_part_of_a_part_keeps_its_name() -> None:
    both = Sbom(json.dumps(of_both()).encode())
    document = json.loads(cyclonedx.joined("x/app@sha256:3", TIME, [("base", both)]))
    (torch,) = (item for item in document["components"] if item["name"] == "torch")
    assert [it["value"] for it in torch["properties"] if it["name"] == cyclonedx.PART] == ["torch"]


@pytest.mark.parametrize(
    ("created", "seconds"),
    [
        ("2026-01-01T00:00:00", 1767225600.0),  # wherever it is read
        ("2026-01-01T01:00:00+01:00", 1767225600.0),
        ("9999-12-31T23:59:59Z", 253402300799.0),
        ("0001-01-01T00:00:00+23:59", 0.0),
        ("9999-12-31T23:59:59-23:59", 0.0),
        ("yesterday", 0.0),
    ],
)
def test_any_time_of_an_image(created: str, seconds: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    time.tzset()
    try:
        assert cyclonedx.created(Config(created=created)) == seconds
        cyclonedx.joined("x/ros@sha256:0", seconds, [("core", of_ros())])
    finally:
        monkeypatch.undo()
        time.tzset()
