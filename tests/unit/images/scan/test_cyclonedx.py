"""SBOMs that are put together, as images are."""

from __future__ import annotations

import json
from typing import Any

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from rosml.images.scan import cyclonedx
from rosml.images.scan.packages import Apt, Packages, Python, System
from rosml.images.scan.sbom import Sbom

TIME = 1_700_000_000.0


def of_ros() -> Sbom:
    packages = [("bash", "libc6"), ("libc6", "")]
    apt = [
        Apt(name=name, version="1", architecture="amd64", source=name, source_version="1", depends=depends)
        for name, depends in packages
    ]
    contents = Packages(system=System(name="debian", version="12"), apt=apt, python=[], ros=[])
    return Sbom(cyclonedx.document(contents, "x/ros@sha256:0", TIME))


def of_torch() -> Sbom:
    wheels = [Python(name="torch", version="2", requires=["numpy"]), Python(name="numpy", version="1")]
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
    assert parts == {"debian": ["ros"], "bash": ["ros"], "libc6": ["ros"], "torch": ["torch"], "numpy": ["torch"]}
    assert document["metadata"]["component"]["name"] == "x/ros@sha256:2"
    needs = {entry["ref"]: entry["dependsOn"] for entry in document["dependencies"]}
    assert needs["pypi:torch@2"] == ["pypi:numpy@1"]
    assert len(needs["x/ros@sha256:2"]) == 5 and not {"x/ros@sha256:0", "x/part@sha256:1"} & needs.keys()


def test_what_is_no_component_of_the_image_is_nobodys_need() -> None:
    """As after a rebase, which leaves out what the old base image had."""
    part = Sbom(of_ros().content, lambda component: component["name"] != "libc6")
    document = json.loads(cyclonedx.joined("x/app@sha256:3", TIME, [("", part), ("torch", of_torch())]))
    assert "libc6" not in {item["name"] for item in document["components"]}
    refs = {item["bom-ref"] for item in document["components"]}
    assert all({*entry["dependsOn"]} <= refs for entry in document["dependencies"])


def test_a_part_of_a_part_keeps_its_name() -> None:
    both = Sbom(json.dumps(of_both()).encode())
    document = json.loads(cyclonedx.joined("x/app@sha256:3", TIME, [("base", both)]))
    (torch,) = (item for item in document["components"] if item["name"] == "torch")
    assert torch["properties"] == [{"name": cyclonedx.PART, "value": "torch"}]
