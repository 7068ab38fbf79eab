"""`rosml image` without a name: the first of the matrix's defaults that this machine can build."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import changed, parse

from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.images.builds import base_images, package_state
from rosml.images.builds.default import default


@pytest.mark.parametrize(
    ("missing", "answer"), [("", ""), ("only Debian's can be made here", ""), ("", "ros.test does not answer")]
)
def test_the_first_that_this_machine_can_build(
    missing: str, answer: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def state(*_: object) -> str:
        if answer:
            raise RosmlError(answer, "check the network")
        return "monday"

    monkeypatch.setattr(package_state, "state", state)
    monkeypatch.setattr(base_images, "missing", lambda *_: missing)
    image_set = parse(changed("targets: [alpha-core-torch-cu1]", "targets: [alpha-base, omega-core]"))
    messages: list[str] = []
    image = default(services(tmp_path), image_set, "amd64", messages.append)
    why = missing or answer
    assert image.target == ("omega-core" if why else "alpha-base")
    assert messages == [f"image: {image.target}" + f", since alpha-base cannot be built here: {why}" * bool(why)]


def test_what_the_user_said_is_wrong(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A typo is no reason to build something else."""

    def state(*_: object) -> str:
        raise RosmlError("ROS_APT_MIRROR is not an address", "set it to one", exit_code=2)

    monkeypatch.setattr(package_state, "state", state)
    image_set = parse(changed("targets: [alpha-core-torch-cu1]", "targets: [alpha-base, omega-core]"))
    with pytest.raises(RosmlError, match="ROS_APT_MIRROR"):
        default(services(tmp_path), image_set, "amd64", print)
