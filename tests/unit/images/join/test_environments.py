"""Environments that are joined to images, and those that do not fit."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.joins import AMD64, BOTH, TORCH, Place, joining
from rosml.images.image_set import labels
from rosml.images.join import short_names
from tests.e2e import parts


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with joining(tmp_path, monkeypatch) as place:
        yield place


def environment(
    place: Place,
    name: str = "policy",
    takes: str = "",
    python: str = "3.11",
    platforms: Sequence[str] = BOTH[:1],
    files: Sequence[str] = (),
    place_of: str = "me",
    more: Mapping[str, str] | None = None,
) -> str:
    image = parts.environment(name, takes, python, **({"files": files} if files else {}))
    image = replace(image, labels={**image.labels, **(more or {})})
    return image.put(place.registry, f"{place_of}/env", f"{name}-py{python.replace('.', '')}", platforms)


def test_it_comes_last_and_the_rest_stays(place: Place) -> None:
    base, stack, policy = place.ros(), place.stack(), environment(place, takes="torch=2.10.0")
    without = place.image(place.join(base, *stack, tag="without"))[1]
    uploaded = place.registry.uploaded
    manifest, config = place.image(place.join(base, policy, *stack))
    assert [layer["digest"] for layer in manifest["layers"]] == place.layers(base, *stack, policy)
    assert len(config["rootfs"]["diff_ids"]) == len(config["history"]) == 5
    before = without["config"]["Labels"]
    assert config["config"]["Labels"] == before | labels.with_environments(before, (), ["policy"])
    assert config["config"]["Env"] == without["config"]["Env"]
    assert place.registry.uploaded - uploaded < 10_000  # only manifests: all layers are there


def test_a_second_one_and_parts_onto_an_image_with_one(place: Place) -> None:
    first = place.join(place.ros(), environment(place, "b"), repository="me/first").reference
    manifest, config = place.image(place.join(first, environment(place, "a"), *place.stack()))
    assert config["config"]["Labels"][labels.ENVIRONMENTS] == "a b"
    assert config["config"]["Labels"]["io.rosml.framework"] == "torch"
    assert config["config"]["Labels"][labels.TITLE] == "ros1-bookworm-core-torch-cu128-env-a_b"
    assert config["config"]["Labels"][labels.VERSION] == "ros1-bookworm-core-cu128-torch2.10.0-env-a_b"
    assert config["config"]["Labels"][labels.DESCRIPTION].endswith(", environment b, environment a")
    assert config["config"]["Labels"][labels.DESCRIPTION].count("environment") == 2
    assert len(manifest["layers"]) == 6


@pytest.mark.parametrize(
    ("facts", "message"),
    [
        ({"python": "3.12"}, "environment policy is for Python 3.12, and "),
        ({"takes": "torch=2.9.0"}, "takes torch 2.9.0 of its image, and .* has torch 2.10.0"),
        ({"takes": "tensorflow=2.20.0"}, "takes tensorflow 2.20.0 of its image, and .* has no tensorflow"),
        ({"platforms": BOTH[1:]}, "no platform in common"),
        ({"files": ["etc/passwd"]}, "both carry /etc/passwd"),
        ({"takes": "torch"}, "io.rosml.takes is damaged"),
        ({"takes": "torch=2.10.0 torch=2.10.0"}, "io.rosml.takes is damaged"),
        ({"name": "Policy..etc"}, "io.rosml.environment is damaged"),
        ({"name": "a" * 65}, "io.rosml.environment is damaged"),
    ],
)
def test_what_does_not_fit(facts: dict[str, str], message: str, place: Place) -> None:
    values: dict[str, object] = {"name": "policy", "takes": "", **facts}
    policy = environment(place, **values)  # type: ignore[arg-type]
    image = place.ros(files=["etc/passwd"])
    error = place.refused(image, *place.stack(), policy)
    assert re.search(message, error.message) and error.exit_code == 2


@pytest.mark.parametrize(
    "module", ["rospy/__init__.py", "rospy.py", "rospy.pyc", "rospy.cpython-311-x86_64-linux-gnu.so"]
)
def test_a_module_of_ros(module: str, place: Place) -> None:
    image = place.ros(files=["usr/share/rospy/package.xml", "usr/lib/python3/dist-packages/numpy/__init__.py"])
    site = "opt/env/policy/lib/python3.11/site-packages"
    error = place.refused(image, environment(place, files=[f"{site}/{module}"]))
    assert "would hide the module rospy of ROS" in error.message and error.exit_code == 2
    place.join(image, environment(place, files=[f"{site}/numpy/__init__.py"]))


def test_a_package_that_its_image_does_not_have(place: Place) -> None:
    """The label is a stranger's word: names in it are looked for, by the metadata of packages, not in other environments."""
    site, other = "usr/local/lib/python3.11/dist-packages", "opt/env/other/lib/python3.11/site-packages"
    policy = environment(place, more={labels.NEEDS: "typing-extensions torchvision"})
    name = "typing_extensions-4.16.0.dist-info/METADATA"
    image = place.ros(files=[f"{site}/{name}", f"{other}/torchvision-0.25.0.dist-info/METADATA"])
    error = place.refused(image, policy)
    assert "env:policy-py311 takes torchvision of its image, and " in error.message and error.exit_code == 2
    place.join(place.ros(files=[f"{site}/{name}", f"{site}/torchvision-0.25.0.dist-info/METADATA"]), policy)


@pytest.mark.parametrize("file", ["etc/ld.so.preload", "opt/env/other/bin/x", "opt/env/policy", "opt/env/policy2/x"])
def test_files_outside_its_folder(file: str, place: Place) -> None:
    error = place.refused(place.ros(), environment(place, files=["opt/env/policy/pyvenv.cfg", file]))
    assert f"has /{file}, and an environment has files below /opt/env/policy/ alone" in error.message


def test_two_of_one_name(place: Place) -> None:
    error = place.refused(place.ros(), environment(place), environment(place))
    assert "the environment policy twice" in error.message and error.exit_code == 2
    image = place.join(place.ros(), environment(place), repository="me/first").reference
    error = place.refused(image, environment(place))
    assert "the environment policy twice" in error.message


def test_too_many(place: Place) -> None:
    image = place.labelled_ros(environments=" ".join(f"e{number}" for number in range(64)))
    assert "would have 65 environments" in place.refused(image, environment(place)).message


def test_a_short_name_is_beside_the_image_or_in_the_local_registry(place: Place) -> None:
    base, host = place.ros(), place.server.address
    environment(place, place_of="local")
    assert place.layers(f"{host}/local/env:policy-py311")[0] in joined_layers(place, base, "env:policy")
    beside = environment(place, files=["opt/env/policy/newer"])
    assert joined_layers(place, base, "env:policy") == joined_layers(place, base, beside)


def joined_layers(place: Place, *images: str) -> list[str]:
    return [layer["digest"] for layer in place.image(place.join(*images))[0]["layers"]]


def test_a_registry_that_is_too_busy_to_say(place: Place) -> None:
    """The environment in the local registry may be another."""
    environment(place, place_of="local")
    place.server.fault("GET", "/v2/me/env/manifests/policy-py311", 503, times=1 << 30)
    assert "503" in place.refused(place.ros(), "env:policy").message


def test_a_short_name_of_none(place: Place) -> None:
    environment(place, python="3.12")
    error, host = place.refused(place.ros(), "env:policy"), place.server.address
    assert f"for Python 3.11: no {host}/me/env:policy-py311 or {host}/local/env:policy-py311" in error.message
    assert "there is policy-py312" in error.message and "rosml env build policy" in error.remedy
    assert error.exit_code == 2
    assert "is no name of an environment" in place.refused(place.ros(), "env:Policy").message


def test_a_tag_that_is_another_environment(place: Place) -> None:
    environment(place, more={labels.ENVIRONMENT: "other"})
    assert "is environment other, and not policy" in place.refused(place.ros(), "env:policy").message
    error = place.refused(place.labelled_ros(python=""), "env:policy")
    assert "has no label io.rosml.python" in error.message


def test_a_tag_that_moves_meanwhile(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """The image gets what was looked at."""
    base, policy = place.ros(), environment(place)
    layers, find = place.layers(base, policy), short_names.find

    def find_and_move(*arguments: Any) -> str:
        reference = find(*arguments)
        environment(place, more={labels.ENVIRONMENT: "other"}, files=["opt/env/other/x"])
        return reference

    monkeypatch.setattr(short_names, "find", find_and_move)
    assert joined_layers(place, base, "env:policy") == layers


def test_one_in_the_place_of_a_ros_image(place: Place) -> None:
    error = place.refused(environment(place), environment(place, "other"))
    assert "is a part, but the first image must be a ROS image" in error.message
    error = place.refused(*place.stack(TORCH[:1]), environment(place, platforms=[AMD64]))
    assert "is a part, but the first image must be a ROS image" in error.message
