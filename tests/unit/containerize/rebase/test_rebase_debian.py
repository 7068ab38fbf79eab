"""Versions and relations of packages, compared with dpkg itself."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosml.containerize.rebase import debian
from rosml.containerize.rebase.debian import PackageSet, relations
from rosml.images.join.facts import Package

VERSIONS = [
    "1.0", "1.0-1", "1.0~rc1-1", "1:0.9-1", "1.0+dfsg-1", "1.0-1+b2", "1.0-1ubuntu1", "1.0.1", "1.0a", "1.10-1", "1.9-1",
    "28.1.5-1noble.20260101.1", "28.1.10-1noble.20260101.1", "0", "0~", "00", "1.0-0", "1-a-1", "1.0~~", "1.0~", "1.",
    "1.0.", "1a", "1a0", "1a0~",
]  # fmt: skip


def dpkg(version: str, word: str, other: str) -> bool | None:
    """Whether dpkg says so; None if it takes one of them for no version."""
    done = subprocess.run(["dpkg", "--compare-versions", version, word, other], capture_output=True, check=False)
    return None if done.stderr else done.returncode == 0


# An epoch is a number without a sign: https://www.debian.org/doc/debian-policy/ch-controlfields.html#version
ANY = st.text("019az.+~-:", min_size=1, max_size=8).filter(
    lambda text: ":" not in text or text.partition(":")[0].isdecimal()
)
VERSION = st.sampled_from(VERSIONS) | ANY


@settings(max_examples=300, deadline=None)
@given(VERSION, VERSION)
@pytest.mark.skipif(not shutil.which("dpkg"), reason="there is no dpkg")
def test_versions_have_the_order_of_dpkg(version: str, other: str) -> None:
    order = debian.compare(version, other)  # anything ends without an error
    assert dpkg(version, "lt", other) in (None, order < 0) and dpkg(version, "gt", other) in (None, order > 0)


def package(name: str, version: str = "1.0", provides: str = "", conflicts: str = "") -> Package:
    return Package(name=name, architecture="all", version=version, provides=provides, conflicts=conflicts)


BOOST = package("libboost1.74", "1.74.0-1", "libboost (= 1.74), boost-abi")
PACKAGES = PackageSet([BOOST, package("python3", "3.11.2-1")])


@pytest.mark.parametrize(
    ("field", "is_met"),
    [
        ("python3", True),
        ("python3:any (>= 3.11~)", True),
        ("python3 (>= 3.12)", False),
        ("python3 (<< 3.12), python3 (>> 3.10)", True),
        ("nothing | python3", True),
        ("nothing (>= 1) | other", False),
        ("libboost (>= 1.70)", True),
        ("libboost (>= 1.80)", False),
        ("boost-abi", True),
        ("boost-abi (>= 1)", False),
        ("", True),
    ],
)
def test_a_field_is_met(field: str, is_met: bool) -> None:
    assert all(PACKAGES.meets(entry) for entry in relations(field)) is is_met


def test_packages_that_cannot_stand_together() -> None:
    other = package("libboost1.80", conflicts="libboost, python3 (<< 3)")
    assert [(name, str(relation)) for name, relation in PACKAGES.conflicts(other)] == [("libboost1.74", "libboost")]
    itself = package("libboost1.74", conflicts="libboost")
    assert not list(PACKAGES.conflicts(itself)), "the package of a virtual one may say that no other one is that"


@pytest.mark.parametrize("field", ["Python", "a (1.0)", "a b", "(>= 1)", "a [amd64]", "a (>= 1))"])
def test_what_is_no_relation_is_refused(field: str) -> None:
    with pytest.raises(ValueError, match="names no package"):
        relations(field)


def test_packages_that_were_made_to_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """360 kB of facts kept a process busy for minutes."""
    monkeypatch.setattr(debian, "COMPARISONS", debian.COMPARISONS // 20)
    versions = [f"v (= {number})" for number in range(6000)]
    base = [package(f"b{number}", "1", provides=", ".join(versions)) for number in range(2)]
    app = package("a", "1", conflicts=", ".join("v (<< 0)" for _ in versions))
    with pytest.raises(ValueError, match="more often than any real ones"):
        PackageSet(base).meets(relations(" | ".join(versions).replace("= ", "= x"))[0])
    with pytest.raises(ValueError, match="more often than any real ones"):
        list(PackageSet(base).conflicts(app))
