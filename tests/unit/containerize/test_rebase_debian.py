"""Versions and relations of packages, compared with dpkg itself."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosml.containerize.rebase import debian
from rosml.images.join import facts

VERSIONS = [
    "1.0",
    "1.0-1",
    "1.0~rc1-1",
    "1:0.9-1",
    "1.0+dfsg-1",
    "1.0-1+b2",
    "1.0-1ubuntu1",
    "1.0.1",
    "1.0a",
    "1.10-1",
    "1.9-1",
    "28.1.5-1noble.20260101.1",
    "28.1.10-1noble.20260101.1",
    "0",
    "0~",
    "00",
    "1.0-0",
    "1-a-1",
    "1.0~~",
    "1.0~",
    "1.",
    "1.0.",
    "1a",
    "1a0",
    "1a0~",
]


@pytest.mark.skipif(not shutil.which("dpkg"), reason="there is no dpkg")
def test_versions_have_the_order_of_dpkg() -> None:
    for one in VERSIONS:
        for other in VERSIONS:
            called = [subprocess.run(["dpkg", "--compare-versions", one, word, other], capture_output=True, check=False)
                      for word in ("lt", "gt")]  # fmt: skip
            if any(done.stderr for done in called):  # dpkg takes one of them for no version
                continue
            said = (called[1].returncode == 0) - (called[0].returncode == 0)
            assert debian.compare(one, other) == said, f"{one} and {other}"


# An epoch is a number without a sign: https://www.debian.org/doc/debian-policy/ch-controlfields.html#version
VERSION = st.text("019az.+~-:", min_size=1, max_size=8).filter(
    lambda text: ":" not in text or text.partition(":")[0].isdecimal()
)


@settings(max_examples=60, deadline=None)
@given(VERSION, VERSION)
@pytest.mark.skipif(not shutil.which("dpkg"), reason="there is no dpkg")
def test_any_versions_have_the_order_of_dpkg(one: str, other: str) -> None:
    done = subprocess.run(["dpkg", "--compare-versions", one, "lt", other], capture_output=True, check=False)
    if not done.stderr:
        assert (debian.compare(one, other) < 0) == (done.returncode == 0)
    debian.compare(one, other)  # and anything ends without an error


def package(name: str, version: str = "1.0", provides: str = "", conflicts: str = "") -> facts.Package:
    return facts.Package(name=name, architecture="all", version=version, provides=provides, conflicts=conflicts)


KNOWN = debian.PackageSet(
    [
        package("libboost1.74", "1.74.0-1", "libboost (= 1.74), boost-abi"),
        package("python3", "3.11.2-1"),
    ]
)


@pytest.mark.parametrize(
    ("field", "met"),
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
def test_a_field_is_met(field: str, met: bool) -> None:
    assert all(KNOWN.meets(entry) for entry in debian.relations(field)) is met


def test_packages_that_cannot_stand_together() -> None:
    found = list(KNOWN.conflicts(package("libboost1.80", conflicts="libboost, python3 (<< 3)")))
    assert [(owner, str(named)) for owner, named in found] == [("libboost1.74", "libboost")]
    own = package("libboost1.74", conflicts="libboost")
    assert not list(KNOWN.conflicts(own)), "a package that provides a virtual one may say that no other one does"


@pytest.mark.parametrize("field", ["Python", "a (1.0)", "a b", "(>= 1)", "a [amd64]", "a (>= 1))"])
def test_what_is_no_relation_is_refused(field: str) -> None:
    with pytest.raises(ValueError, match="names no package"):
        debian.relations(field)


def test_packages_that_were_made_to_take_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """360 kB of facts kept a process busy for minutes."""
    monkeypatch.setattr(debian, "COMPARISONS", debian.COMPARISONS // 20)
    versions = [f"v (= {number})" for number in range(6000)]
    base = [
        facts.Package(name=f"b{number}", architecture="all", version="1", provides=", ".join(versions))
        for number in range(2)
    ]
    known = debian.PackageSet(base)
    with pytest.raises(ValueError, match="more often than any real ones"):
        known.meets(debian.relations(" | ".join(versions).replace("= ", "= x"))[0])
    app = facts.Package(name="a", architecture="all", version="1", conflicts=", ".join("v (<< 0)" for _ in versions))
    with pytest.raises(ValueError, match="more often than any real ones"):
        list(debian.PackageSet(base).conflicts(app))
