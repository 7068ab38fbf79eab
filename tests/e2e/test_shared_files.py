"""Parts that serve every Python hold what those on top of them expect, in the wheels of every Python and architecture that is locked.

An image of each pair of stack and Python would show it; tests build a few of them (proof `systems`).
"""

from __future__ import annotations

import os

import pytest

from rosml import ROOT
from rosml.base import web
from rosml.images.image_set import load, locked
from rosml.images.locks import shared_files
from rosml.images.locks.index import Index
from rosml.images.locks.uv import Uv
from rosml.machine.services import Services


def test_wheels_of_all_pythons_agree(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in services.environment().items():
        monkeypatch.setitem(os.environ, name, value)
    texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in locked.locks(ROOT)}
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    with web.client(timeout=60) as client:
        differences = shared_files.differences(image_set, ROOT, Index(Uv(services.uv), client), texts)
    assert [str(difference) for difference in differences] == []
