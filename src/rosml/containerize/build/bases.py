"""The base images of an app, by its lock file if it follows one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.containerize import lock
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import adopt
from rosml.containerize.build.call import Call
from rosml.containerize.lock import Lock
from rosml.containerize.names import SLIM
from rosml.images.image_set.labels import ENVIRONMENTS, PREFIX
from rosml.images.join import label_claims
from rosml.images.matrix import support
from rosml.registry.failures import Busy


def read_lock(call: Call) -> Lock | None:
    return None if call.renew else lock.read(call.lock_file, call.folder)


def find(call: Call, followed_lock: Lock | None) -> Base:
    """The base image. If it has no ROS, ROS will be installed on it."""
    name, say = call.values.base_image, call.say
    digest = followed_lock.base_image.of(name) if followed_lock else ""
    base = app_base.find(name, call.services, call.names.platforms, digest)
    say(f"base image {base.name}")
    base = adopt.with_ros(base, call.services, call.values, call.names.platforms, say)
    for line in _ends(base):
        say(line)
    if followed_lock:
        say(f"{call.lock_file} says which versions")
        if missing := followed_lock.lacks(call.names.platforms):
            say(f"it has no packages for {', '.join(missing)}: they are the newest; {lock.RENEW}")
    return base


def _ends(base: Base) -> Iterator[str]:
    """Says that the ROS of a base image is past its end of life. Its label may name a distribution that rosml does not have."""
    name = base.adopted.image.distribution if base.adopted else base.labels.get(f"{PREFIX}distribution")
    if name and name in (matrix := addons.rosml_matrix()).distributions:
        yield from support.ends(matrix, [name], clock.today())


def find_slim(call: Call, base: Base, followed_lock: Lock | None) -> Base | None:
    """The base image of the slim image. None if there is to be no slim image, or if none belongs to the base image."""
    if SLIM not in call.names.targets:
        return None
    named_by_user = call.values.slim_base_image
    name = named_by_user or app_base.runtime(base)
    reason = f"there is no {name}" if name else f"{base.name} does not say which base image has no compilers"
    slim_lock = followed_lock.slim_base_image if followed_lock else None
    digest = slim_lock.of(named_by_user) if slim_lock else ""
    if name:
        try:
            slim = app_base.find(name, call.services, call.names.platforms, digest)
        except RosmlError as error:
            if named_by_user or digest or not (error.exit_code == 2 or base.local):  # there may be one
                raise
        else:
            differing = [] if named_by_user else app_base.differing(base, slim)
            if not differing and followed_lock and not digest:
                remedy = f"{lock.RENEW} --enable-slim, or leave the image out"
                raise RosmlError("the lock file has no slim image", remedy, exit_code=2)
            if not differing:
                return slim
            reason = f"{name} is of another {', '.join(differing)}"
    call.say(f"no slim image: {reason}; name one with --slim-base-image")
    return None


def with_addons(call: Call, base: Base, followed_lock: Lock | None, environments: Sequence[str] = ()) -> Base:
    """A base image with the add-ons and environments of a call, and with further `environments`."""
    digests = followed_lock.addons or {} if followed_lock else None
    values = call.values
    every = " ".join([values.environments, *environments])
    joined = addons.onto(base, values.addons, call.services, call.names.platforms, digests, every)
    if joined.addons:
        call.say(f"{base.name} with {', '.join(name.rpartition('/')[2] for name in joined.addons.parts)}")
    return joined


def slim_with_addons(call: Call, slim: Base, main: Base, followed_lock: Lock | None) -> Base | None:
    """The base image of a slim image with the add-ons of a call, and with the environments of the main base image: the same ones. If they
    are not there, there is no slim image, unless the user named its base image."""
    label_claims.require(main.labels, main.name)
    present = slim.labels.get(ENVIRONMENTS, "").split()
    names = [name for name in main.labels.get(ENVIRONMENTS, "").split() if name not in present]
    if not names or call.values.slim_base_image:
        return with_addons(call, slim, followed_lock)
    try:
        joined = with_addons(call, slim, followed_lock, names)
        reason = addons.differing(joined, main, names, call.services)
    except Busy:
        raise
    except RosmlError as error:
        reason = error.message
    if reason:
        call.say(f"no slim image: {reason}; name one with --slim-base-image")
    return None if reason else joined


def parts(*bases: Base | None) -> dict[str, str]:
    """The parts and environments that base images get, as `AddOns.parts`."""
    return {name: where for base in bases if base and base.addons for name, where in base.addons.parts.items()}
