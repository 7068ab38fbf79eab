"""What people get of packages that they install, by the package index of today."""

from __future__ import annotations

import os

import pytest

from rosml import ROOT
from rosml.images.image_set import load
from rosml.images.locks import installs
from rosml.machine.services import Services


@pytest.mark.full(proof="installs")
def test_no_constraint_takes_an_older_release_than_it_must(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in services.environment().items():
        monkeypatch.setitem(os.environ, name, value)
    packages = installs.look(load.load(ROOT / "matrix.yaml", ROOT), ROOT, services.uv, say=print)
    assert installs.too_old(packages) == []
