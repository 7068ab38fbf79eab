"""The project's public addresses stand in pyproject.toml, and what cannot read them there says the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT

from rosml.base import project_addresses
from rosml.cli.images import own_set
from tests import fork

ADDRESS = "https://forge.example/us/rosml"


def test_every_place_has_the_address_of_the_project() -> None:
    matrix, readme = ((ROOT / name).read_text(encoding="utf-8") for name in ("matrix.yaml", "README.md"))
    assert f"git clone {fork.HOME or '<address of this repository>'} rosml" in readme
    assert fork.source(matrix) or not fork.HOME
    urls = project_addresses.addresses()
    assert not urls or urls.keys() >= {"Repository", "Documentation", "Issues"}
    assert [address for address in urls.values() if not address.startswith("https://")] == []


@pytest.mark.parametrize(("urls", "address"), [("", ""), (f'[project.urls]\nRepository = "{ADDRESS}.git"\n', ADDRESS)])
def test_rosml_init_names_the_project_where_no_clone_does(
    urls: str, address: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pyproject.toml").write_text(f"[project]\n{urls}")
    monkeypatch.setattr(project_addresses, "ROOT", tmp_path)
    monkeypatch.setattr(own_set, "_address", lambda _: "")
    assert own_set.address_of_rosml("") == address
    monkeypatch.setattr(own_set, "_address", lambda _: "https://forge.example/mine/rosml")
    assert own_set.address_of_rosml("") == "https://forge.example/mine/rosml", "a fork is its own"
