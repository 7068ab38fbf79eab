"""The user's apt mirrors. Steps of a build get their addresses as secrets, and none with a password if they run foreign code."""

from __future__ import annotations

from collections.abc import Container, Mapping

from rosml.base.errors import RosmlError

VARIABLES = ("OS_APT_MIRROR", "ROS_APT_MIRROR")


def secrets(environment: Container[str]) -> list[str]:
    """The secrets of steps, in buildx's words. A Dockerfile mounts `os-apt-mirror` and `ros-apt-mirror`."""
    return [f"type=env,id={name.lower().replace('_', '-')},env={name}" for name in VARIABLES if name in environment]


def require_no_password(environment: Mapping[str, str]) -> None:
    """Refuses addresses with a user or a password, since steps that have them run code of the repository."""
    names = [name for name in VARIABLES if "@" in environment.get(name, "").partition("?")[0]]
    if names:
        text = f"{' and '.join(names)} has a password, and steps that ask the mirror run code of the repository"
        remedy = "name a mirror without a password; if you trust all of that code, add --allow-mirror-password"
        raise RosmlError(text, remedy, exit_code=2)
