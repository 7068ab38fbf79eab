"""Environments of apps that move to other base images: they come along from beside the new one, or stay as they are."""

from __future__ import annotations

import pytest

from fakes.rebasing import (
    BASE_FACTS,
    BOTH,
    Place,
    app_with_environment,
    environment,
    place,
)
from rosml.containerize.rebase import image
from rosml.images.image_set.labels import ENVIRONMENTS
from rosml.images.join.joiner import Joiner

__all__ = ["place"]


def lock(place: Place, app: str) -> dict[str, str]:
    app_lock = image.lock_of(next(iter(place.rebaser().read(app).values())))
    assert app_lock
    return app_lock.addons or {}


def on_torch(place: Place, version: str, day: str = "") -> str:
    labels = {"io.rosml.stack": "cu128", "io.rosml.framework": "torch", "io.rosml.torch": version}
    return place.base(f"torch-{version}{day}", BASE_FACTS, BOTH, labels, "rosml/ros-torch")


def test_the_one_beside_the_new_base_image_comes_along(place: Place) -> None:
    """As parts of add-ons do: the newest."""
    app = app_with_environment(place, place.base(), environment(place))
    policy, new = environment(place, "newer"), place.base("tonight")
    rebased = place.rebase(app, new)
    assert place.layers(app)[:-1] == [*place.layers(new), *place.layers(policy)] and rebased.copied == 0
    assert place.labels("me/robot", "latest")[ENVIRONMENTS] == "policy"
    assert lock(place, app) == {policy: place.digest(policy)}
    assert place.rebase(app, new).digest == rebased.digest, "a second call has nothing to do"


def test_it_stays_if_none_beside_it_goes_with_the_new_base_image(place: Place) -> None:
    policy = environment(place, takes="torch=2.10.0")
    app = app_with_environment(place, on_torch(place, "2.10.0"), policy)
    layers, pins = place.layers(policy), lock(place, app)
    environment(place, "newer", takes="torch=2.11.0")
    place.rebase(app, on_torch(place, "2.10.0", "tonight"))
    assert place.layers(app)[-2:-1] == layers and lock(place, app) == pins
    place.server.tags["rosml/env"].pop("policy-py311")
    place.rebase(app, on_torch(place, "2.10.0", "tomorrow"))
    assert place.layers(app)[-2:-1] == layers and lock(place, app) == pins


def test_another_release_is_the_reason(place: Place) -> None:
    app = app_with_environment(place, on_torch(place, "2.10.0"), environment(place, takes="torch=2.10.0"))
    message = place.refused(app, on_torch(place, "2.11.0"))
    assert "environment policy takes torch 2.10.0 of its image, and " in message and "has torch 2.11.0" in message


def test_a_base_image_that_has_it(place: Place) -> None:
    policy = environment(place)
    app = app_with_environment(place, place.base(), policy)
    with Joiner(lambda _: place.registry) as joiner:
        new = joiner.join(place.base("tonight"), [policy], f"{place.server.address}/rosml/ros:with").reference
    place.rebase(app, new)
    assert place.layers(app)[:-1] == place.layers(new)
    assert place.labels("me/robot", "latest")[ENVIRONMENTS] == "policy" and not lock(place, app)


def test_another_python_is_the_reason(place: Place) -> None:
    app = app_with_environment(place, place.base(), environment(place))
    other = place.base("other", python="3.12")
    assert "was built on Python 3.11, and " in place.refused(app, other)


def test_a_registry_that_is_too_busy_to_say(place: Place) -> None:
    app = app_with_environment(place, place.base(), environment(place))
    place.server.fault("GET", "/v2/rosml/env/manifests/policy-py311", 503, times=1 << 30)
    assert "503" in place.refused(app, place.base("tonight"), code=1)


def test_one_that_is_gone(place: Place) -> None:
    app = app_with_environment(place, place.base(), environment(place))
    place.server.tags["rosml/env"].clear()
    for repository, name in [*place.server.manifests]:
        if repository == "rosml/env":
            del place.server.manifests[(repository, name)]
    assert "there is no environment policy for Python 3.11" in place.refused(app, place.base("tonight"))


@pytest.mark.parametrize(
    ("file", "message"),
    [
        ("etc/ld.so.preload", "has /etc/ld.so.preload, and an environment has files below /opt/env/policy/ alone"),
        ("opt/env/policy/lib/python3.11/site-packages/rospy/__init__.py", "would hide the module rospy of ROS"),
    ],
)
def test_one_beside_it_that_would_change_the_image(file: str, message: str, place: Place) -> None:
    app = app_with_environment(place, place.base(), environment(place))
    environment(place, "newer", files=(file,))
    assert message in place.refused(app, place.base("tonight", files=("usr/share/rospy/package.xml",)))
