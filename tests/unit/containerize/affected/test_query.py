"""What people ask for, and which versions count."""

from __future__ import annotations

import pytest

from rosml.base.errors import RosmlError
from rosml.containerize.affected import query
from rosml.containerize.affected.query import Component, Query


def deb(name: str, version: str, source: str = "", source_version: str = "") -> Component:
    return Component("deb", name, version, source, source_version, f"pkg:deb/debian/{name}@{version}", "", "debian 12")


def wheel(name: str, version: str) -> Component:
    return Component("pypi", name, version, "", "", f"pkg:pypi/{name}@{version}", "", "")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("CVE-2026-12345", Query("CVE-2026-12345")),
        (" GHSA-abcd-efgh-ijkl ", Query("GHSA-abcd-efgh-ijkl")),
        ("openssl", Query("openssl", "", "openssl")),
        ("openssl<3.0.15-1~deb12u1", Query("openssl<3.0.15-1~deb12u1", "", "openssl", "<", "3.0.15-1~deb12u1")),
        ("pypi:PyYAML == 6.0", Query("pypi:PyYAML == 6.0", "pypi", "PyYAML", "=", "6.0")),
        ("libstdc++6>=1:2", Query("libstdc++6>=1:2", "", "libstdc++6", ">=", "1:2")),
    ],
)
def test_a_query(text: str, expected: Query) -> None:
    assert query.parse(text) == expected


@pytest.mark.parametrize("text", ["", "-x", "a b", "a<", "<3", "npm:left-pad", "a<b<c", "$(id)", "a\x1b[31m"])
def test_no_query(text: str) -> None:
    with pytest.raises(RosmlError, match="neither an advisory nor a package") as caught:
        query.parse(text)
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("text", "component", "meets"),
    [
        ("libssl3<3.0.15", deb("libssl3", "3.0.15~rc1"), True),  # Debian's tilde comes before the end
        ("libssl3<3.0.15", deb("libssl3", "1:3.0.1"), False),  # an epoch counts most
        ("openssl<3.0.15", deb("libssl3", "1:9", "openssl", "3.0.1"), True),  # by its source package
        ("pypi:openssl", deb("libssl3", "3", "openssl", "3"), False),
        ("libssl3", deb("libssl3", ""), True),
        ("libssl3<3", deb("libssl3", ""), None),
        ("libssl3<3", deb("libssl3", "1" * 300), None),
        ("torch<2.6", wheel("torch", "2.6.0rc1"), True),  # as PEP 440 has it
        ("torch<2.6", wheel("torch", "2.10.0+cu130"), False),
        ("torch<2.6", wheel("torch", "unknown"), None),
        ("ruamel.yaml>=0.18", wheel("ruamel-yaml", "0.18"), True),
        ("deb:torch", wheel("torch", "2.6"), False),
        ("torch", wheel("torchvision", "2.6"), False),
    ],
)
def test_which_components_count(text: str, component: Component, meets: bool | None) -> None:
    assert query.parse(text).meets(component) is meets
