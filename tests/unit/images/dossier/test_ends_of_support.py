"""Until when somebody corrects what an image has."""

from __future__ import annotations

import datetime

import pytest

from fakes.dossiers import contents, matrix
from rosml.images.dossier import support
from rosml.images.dossier.bill import Bill, Component
from rosml.images.scan import cyclonedx


def component(name: str, version: str, kind: str = "deb") -> Component:
    purl = {"deb": f"pkg:deb/debian/{name}@{version}", "pypi": f"pkg:pypi/{name}@{version}"}.get(kind, "")
    return Component({"name": name, "version": version, "type": "library" if purl else kind, "purl": purl})


def test_the_earliest_comes_first_and_what_has_no_day_last() -> None:
    bill = Bill.of(cyclonedx.document(contents(), "x/ros@sha256:0", 0.0))
    ends = support.ends(bill.components, "ros1-bookworm", matrix())
    assert [(it.title, it.version, it.day) for it in ends] == [
        ("CUDA", "12.8.90", "2026-02-28"),
        ("Python", "3.11.2-1+b1", "2027-10-31"),
        ("Debian", "12", "2028-06-30"),
        ("ROS", "ros1-bookworm", "2028-06-30"),
        ("PyTorch", "2.10.0", ""),
    ]
    assert ends[0].has_ended(datetime.date(2026, 3, 1)) and not ends[0].has_ended(datetime.date(2026, 2, 28))
    assert not ends[-1].has_ended(datetime.date(2099, 1, 1))


@pytest.mark.parametrize(
    ("name", "version", "kind", "day"),
    [
        ("ubuntu", "24.04", "operating-system", "2029-04-30"),
        ("debian", "13.1", "operating-system", "2030-06-30"),
        ("debian", "99", "operating-system", ""),
        ("debian", "1", "operating-system", ""),
        ("python3", "1:3.10.6-1", "deb", "2026-10-31"),
        ("python3", "3.1", "deb", ""),
        ("cuda-cudart-13-0", "13.0.96-1", "deb", "2028-06-30"),
        ("nvidia-cuda-runtime", "13.2.86", "pypi", "2027-03-31"),
        ("tensorflow-cpu", "2.21.0", "pypi", ""),
    ],
)
def test_a_version_is_its_longest_beginning(name: str, version: str, kind: str, day: str) -> None:
    [end] = support.ends([component(name, version, kind)], "", matrix())
    assert end.day == day and end.note and end.page.startswith("https://")


def test_what_ends_with_something_else_has_no_line() -> None:
    others = [component("bash", "5"), component("debian", "12"), component("python3-dev", "3.11"), component("", "")]
    assert support.ends(others, "", matrix()) == []


def test_ros_of_somebody_else() -> None:
    [end] = support.ends([], "of-my-own", matrix())
    assert (end.day, end.note) == ("", support.UNKNOWN)


def test_each_system_python_and_stack_of_the_matrix_has_a_line() -> None:
    """A new one in matrix.yaml needs an entry in support.yaml."""
    for name, system in matrix().operating_systems.items():
        title, _, version = name.partition("-")
        python = component("python3", f"{system.python}.0")
        os = component(title, version, "operating-system") if version else None
        for it in filter(None, (python, os)):
            assert all(end.day for end in support.ends([it], "", matrix())), f"{name}: {it.title}"
    for stack in matrix().stacks.values():
        if stack.cuda and not stack.cuda.startswith("12.1."):  # nobody named a day for that branch
            [end] = support.ends([component("nvidia-cuda-runtime", stack.cuda, "pypi")], "", matrix())
            assert end.day, stack.cuda
