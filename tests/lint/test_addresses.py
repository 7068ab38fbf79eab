"""An address of a package archive stands in one place: matrix.yaml. Elsewhere, code asks the matrix or the base image's own
apt sources, and the documentation says "Debian's archive" and "the Python package index"."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

HOSTS = {
    ".".join(domain): hosts
    for domain, hosts in {
        ("debian", "org"): "deb|security|snapshot|ftp|archive",
        ("ubuntu", "com"): "archive|security|ports|old-releases",
        ("ros", "org"): "packages|snapshots|repo",
        ("pytorch", "org"): "download",
        ("golang", "org"): "proxy|sum",
        ("npmjs", "org"): "registry",
        ("pypi", "org"): "",
        ("pythonhosted", "org"): "",
    }.items()
}
"""Domains, and the hosts in them that give packages; every host where none is named. Others are web sites."""

ONE_PLACE = "matrix.yaml"
WRITTEN_FROM_IT = "docker-bake.hcl"
IN_THE_MATRIX = tuple(HOSTS)[:3]
"""What the product has to ask by an address of its own. uv knows the Python package index without one."""


def pattern(domain: str, hosts: str) -> str:
    """What finds a domain's hosts, also in a regular expression that joins some of them: `(a|b)\\.example\\.org`."""
    return rf"(?<![\w-])(?:(?:{hosts})|[\w.|()-]*\))\.{re.escape(domain)}\b" if hosts else rf"\b{re.escape(domain)}\b"


def found(text: str) -> set[str]:
    """The domains of package archives that a text names."""
    text = text.replace("\\", "")
    return {domain for domain, hosts in HOSTS.items() if domain in text and re.search(pattern(domain, hosts), text)}


def tracked() -> list[str]:
    """Every committed file, and those that are about to be."""
    argv = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    return [name for name in names if (ROOT / name).is_file()]


def test_no_other_file_names_a_package_archive() -> None:
    wrong = {name: found((ROOT / name).read_text(encoding="utf-8", errors="replace")) for name in tracked()}
    for name in (ONE_PLACE, WRITTEN_FROM_IT):
        wrong[name] -= set(IN_THE_MATRIX)
    assert {name: domains for name, domains in wrong.items() if domains} == {}, f"these belong in {ONE_PLACE}"


def test_the_matrix_names_each_once() -> None:
    text = (ROOT / ONE_PLACE).read_text()
    for domain in IN_THE_MATRIX:
        hosts = re.findall(pattern(domain, HOSTS[domain]), text)
        assert len(hosts) == len(set(hosts)), hosts


@pytest.mark.parametrize("domain", HOSTS)
def test_an_address_is_found(domain: str) -> None:
    host = f"{HOSTS[domain].split('|')[0]}.{domain}".lstrip(".")
    for text in (f"http://{host}/x", f"# as {host} has it", host.replace(".", r"\.")):
        assert found(text) == {domain}
    if HOSTS[domain]:
        assert found(rf"https?://(({HOSTS[domain]})\.{domain})/".replace(".", r"\.")) == {domain}
        assert found(f"https://wiki.{domain}/page, https://{domain}/reps, my{host}") == set()
