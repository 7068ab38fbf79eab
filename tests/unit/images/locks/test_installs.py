"""What people get of packages that they install: what constraints do to it is compared with what has one version in an image."""

from __future__ import annotations

import json
from pathlib import Path

import httpx
import pytest
from conftest import ROOT

from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.images.locks import installs
from rosml.images.locks.index import Index, WheelTarget
from rosml.images.locks.installs import Environment, Resolved
from rosml.images.locks.uv import Uv

HERE = Environment("ml", "cu128", "3.12", "amd64")
WHERE = WheelTarget("3.12", "x86_64-manylinux_2_28")

RESOLVER = """\
all=$(cat in.txt constraints.txt)
case $all in
  *gradio==6*pillow==11*) echo 'No solution found: gradio==6.0 depends on pillow>=12 and you require pillow==11.0' >&2; exit 1 ;;
  *gradio*pillow==11*) echo 'gradio==3.36.1' >out.txt ;;
  *gradio*) echo 'gradio==6.0' >out.txt ;;
  *jax*numpy==1*) echo 'jax==0.6.2' >out.txt; echo 'warning: `jax==0.6.2` does not have an extra named `cuda13`' >&2 ;;
  *jax*) echo 'jax[cuda13]==0.12' >out.txt ;;
  *lost*) echo 'error: no answer' >&2; exit 2 ;;
esac
"""
"""A local replacement for uv: gradio 6 needs a newer pillow, and jax a newer numpy."""


def resolved(tmp_path: Path, package: str, *constraints: str) -> Resolved:
    uv = Uv(executable(tmp_path / "uv", RESOLVER))
    with httpx.Client() as client:
        newest = {"gradio": "6.0", "jax[cuda13]": "0.12"}
        return installs.of_package(Index(uv, client), WHERE, constraints, package, lambda *about: newest[about[2]])


def test_a_pin_that_nobody_needs_is_named(tmp_path: Path) -> None:
    """pillow has one version in the image, and is not among what has to have one: here by a line that is no pin of a part."""
    item = resolved(tmp_path, "gradio", "torch==2.10.0", "pillow==11.0; python_version > '3'")
    assert (item.version, item.beside, item.held_by) == ("3.36.1", "6.0", ("pillow==11.0; python_version > '3'",))
    assert installs.too_old({HERE: [item]}) == [
        "ml cu128, Python 3.12: gradio 3.36.1, and 6.0 would go: pillow==11.0; python_version > '3'"
    ]


def test_what_has_one_version_in_the_image_may_hold_others(tmp_path: Path) -> None:
    item = resolved(tmp_path, "gradio", "torch==2.10.0", "pillow==11.0")
    assert (item.version, item.newest, item.held_by) == ("3.36.1", "6.0", ("pillow==11.0",))
    assert installs.too_old({HERE: [item]}) == []


def test_an_extra_that_is_lost_is_told(tmp_path: Path) -> None:
    item = resolved(tmp_path, "jax[cuda13]", "numpy==1.26.4")
    assert (item.version, item.extra) == ("0.6.2", False)


def test_an_index_that_does_not_answer_is_no_refusal(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match="does not say what people get"):
        resolved(tmp_path, "lost")


def test_every_stack_and_python_is_looked_at() -> None:
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    images = [image for image in image_set.images if image.locked and image.framework in ("torch", "tensorflow")]
    locked = {(image.stack, image.python) for image in images}
    environments = [(item.stack, item.python) for item in installs.environments(image_set)]
    assert set(environments) == locked and len(environments) == len(locked)
    assert all(len(installs.PACKAGES) == len(items) for items in committed().values())
    assert set(committed()) == set(installs.environments(image_set))


def committed() -> dict[Environment, list[Resolved]]:
    return {
        Environment(**{key: row[key] for key in row if key != "packages"}): [
            Resolved(**{**item, "held_by": tuple(item["held_by"])}) for item in row["packages"]
        ]
        for row in json.loads((ROOT / installs.FILE).read_text(encoding="utf-8"))
    }


def test_no_pin_of_the_checkout_takes_an_older_release_than_it_must() -> None:
    assert installs.too_old(committed()) == []


def test_the_page_shows_the_data() -> None:
    page = (ROOT / installs.PAGE).read_text(encoding="utf-8")
    assert installs.render(page, committed()) == page
    with pytest.raises(RosmlError, match="markers"):
        installs.render("", {})
