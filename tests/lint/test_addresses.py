"""An address of a package archive stands in one place: those of ROS and of wheels in matrix.yaml, those of operating systems in
the base image's own apt sources."""

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
        ("pypi", "org"): "",
        ("pythonhosted", "org"): "",
    }.items()
}
"""Domains, and the hosts in them that give packages; every host where none is named. Others are web sites."""


def domains_in(text: str) -> set[str]:
    """The domains of package archives that a text names."""
    text = text.replace("\\", "")
    return {
        domain
        for domain, hosts in HOSTS.items()
        if re.search(rf"(?<![\w-])(?:{hosts})\.{domain}\b" if hosts else rf"\b{domain}\b", text)
    }


def test_no_file_of_the_product_names_a_package_archive() -> None:
    argv = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "src", "components", "Dockerfile"]
    names = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    texts = {name: (ROOT / name).read_text(errors="replace") for name in names if (ROOT / name).is_file()}
    assert len(texts) > 100
    assert {name: domains for name, text in texts.items() if (domains := domains_in(text))} == {}


@pytest.mark.parametrize("domain", HOSTS)
def test_an_address_is_found(domain: str) -> None:
    host = f"{HOSTS[domain].split('|')[0]}.{domain}".lstrip(".")
    assert domains_in(f"http://{host}/x") == domains_in(host.replace(".", r"\.")) == {domain}
