"""Environments on the base image of an app: which, and what the builder gets. A real one: tests/e2e/test_environments.py."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from fakes.rebasing import BOTH, Place, environment, place
from rosml.base.errors import RosmlError
from rosml.cli.containerize import containerize
from rosml.containerize import inputs, lock
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import AddOns, Base
from rosml.containerize.build import bases
from rosml.images.image_set.labels import ENVIRONMENTS
from rosml.images.join.joiner import Joiner
from tests.e2e.parts import part

__all__ = ["place"]


def plain(place: Place) -> Base:
    return app_base.find(place.base(), place.services, BOTH)


def with_policy(place: Place, base: Base, locked: dict[str, str] | None = None, text: str = "") -> AddOns:
    joined = addons.onto(base, text, place.services, BOTH, locked, "policy").addons
    assert joined
    return joined


def test_it_is_joined_after_the_parts_by_digest(place: Place) -> None:
    policy = environment(place)
    for tag, kind in {"common-cpu-py311": "common", "graph-cc-cpu": "graph-cc", "graph-cpu-py311": "graph"}.items():
        part(kind, "cpu").put(place.registry, "rosml/part", tag, BOTH)
    joined = with_policy(place, plain(place), text="graph-cpu")
    assert len(joined.parts) == 4 and [*joined.parts][-1] == policy
    assert joined.parts[policy] == f"{policy.rpartition(':')[0]}@{place.digest(policy)}"
    assert joined.labels[ENVIRONMENTS] == "policy" and joined.labels["io.rosml.addons"] == "graph"
    assert joined.dockerfile("without").count("COPY --link --from=part-") == 4


def test_a_lock_decides_which_one(place: Place) -> None:
    base, policy = plain(place), environment(place)
    first = with_policy(place, base)
    digests = {name: reference.rpartition("@")[2] for name, reference in first.parts.items()}
    environment(place, "tonight")
    assert with_policy(place, base, digests) == first != with_policy(place, base)
    with pytest.raises(RosmlError, match="of the lock file") as caught:
        with_policy(place, base, {policy: f"sha256:{'0' * 64}"})
    assert caught.value.remedy == lock.RENEW


def test_one_of_the_local_registry_and_one_that_the_base_image_has(place: Place) -> None:
    elsewhere = app_base.find(place.base(repository="team/ros"), place.services, BOTH)
    policy = environment(place)
    assert [*with_policy(place, elsewhere).parts] == [policy]
    with Joiner(lambda _: place.registry) as joiner:
        image = joiner.join(elsewhere.name, [policy], f"{place.server.address}/team/ros:with").reference
    base = app_base.find(image, place.services, BOTH)
    assert addons.onto(base, "", place.services, BOTH, None, "policy") is base


def test_a_slim_image_gets_those_of_the_other(place: Place) -> None:
    """The same ones: if another build of one is there now, or none, there is no slim image, unless the user named its base."""
    slim, messages = plain(place), list[str]()

    def joined(main: Base, slim_base_image: str = "") -> Base | None:
        names = SimpleNamespace(platforms=BOTH)
        call: Any = SimpleNamespace(
            values=inputs.Values(slim_base_image=slim_base_image),
            services=place.services,
            names=names,
            say=messages.append,
        )
        return bases.slim_with_addons(call, slim, main, None)

    policy = environment(place)
    with Joiner(lambda _: place.registry) as joiner:
        image = joiner.join(slim.name, [policy], f"{place.server.address}/rosml/ros:with").reference
    main = app_base.find(image, place.services, BOTH)
    with_policy = joined(main)
    assert with_policy and with_policy.addons and [*with_policy.addons.parts] == [policy]
    assert joined(slim) is slim
    environment(place, "tonight")
    assert (
        joined(main) is None
        and "no slim image: " in messages[-1]
        and "has another environment policy than" in messages[-1]
    )
    assert joined(main, slim_base_image="named") is slim
    assert joined(replace(main, labels={**main.labels, ENVIRONMENTS: "nope"})) is None
    assert "no slim image: there is no environment nope" in messages[-1]
    with pytest.raises(RosmlError, match=r"io\.rosml\.environments is damaged"):
        joined(replace(main, labels={**main.labels, ENVIRONMENTS: "../../etc"}))


def test_a_lock_that_names_something_else(place: Place) -> None:
    base, policy = plain(place), environment(place)
    part("common", "cpu").put(place.registry, "rosml/env", "other", BOTH)
    with pytest.raises(RosmlError, match="is no environment, and not policy"):
        with_policy(place, base, {policy: place.digest(f"{policy.rpartition(':')[0]}:other")})


@pytest.mark.parametrize(
    ("facts", "environments", "problem"),
    [
        ({}, "nosuch", "there is no environment nosuch for Python 3.11"),
        ({"takes": "torch=2.10.0"}, "policy", "takes torch 2.10.0 of its image, and .* has no torch"),
        ({"python": "3.12"}, "policy", "there is policy-py312"),
        ({}, "policy, ../x", "'../x' is no name of an environment"),
    ],
)
def test_one_that_is_refused(facts: dict[str, str], environments: str, problem: str, place: Place) -> None:
    environment(place, **facts)
    with pytest.raises(RosmlError, match=problem) as caught:
        addons.onto(plain(place), "", place.services, BOTH, None, environments)
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("words", "environments"),
    [
        (["--env", "policy", "--env", "vision"], "policy,vision"),
        (["--env", "policy", "--environments", "vision"], "policy,vision"),
        ([], "of-the-file"),
        (["--env", ""], ""),
    ],
)
def test_the_option_is_repeatable(
    words: list[str], environments: str, tmp_path: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "package.xml").write_text("<package><name>robot</name></package>")
    (tmp_path / ".env").write_text("ENVIRONMENTS=of-the-file\n")
    seen = list[dict[str, str]]()

    def values(typed: dict[str, str], *_: object) -> inputs.Values:
        seen.append(typed)
        raise RosmlError("enough")

    real = inputs.values
    monkeypatch.setattr(inputs, "values", values)
    CliRunner().invoke(containerize.main, [str(tmp_path), *words])
    assert real(seen[0], tmp_path, {}).environments == environments
