"""Joins environments to an image, without a network. An environment is a layer below /opt/env that no other part knows of."""

from __future__ import annotations

import copy
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import listed, some
from rosml.images.image_set import labels
from rosml.images.image_set.lock_file import package_name
from rosml.images.join import label_claims, layers
from rosml.images.join.layers import Joined, Source
from rosml.registry import oci

_PYTHON = f"{labels.PREFIX}python"


def join(ros: Source, parts: Sequence[Source]) -> Joined:
    """Joins a ROS image, parts and environments, all for one platform. Environments come last, by name.

    Raises:
        RosmlError: something does not go together.
    """
    environments = [part for part in parts if part.labels.get(labels.ENVIRONMENT)]
    if not environments:
        return layers.join(ros, parts)
    others = [part for part in parts if part not in environments]
    below = layers.join(ros, others) if others else None
    image = layers.as_source(below, ros) if below else ros
    _require_ros(image)
    present = image.labels.get(labels.ENVIRONMENTS, "").split()
    for environment in environments:
        _require_fit(image, environment)
    names = [environment.labels[labels.ENVIRONMENT] for environment in environments]
    if twice := [name for number, name in enumerate(names) if name in (*present, *names[:number])]:
        text = f"{image.name} would have the environment {listed([*dict.fromkeys(twice)])} twice"
        raise RosmlError(text, "leave one of them out", exit_code=2)
    if (number := len(present) + len(names)) > label_claims.MOST:
        text = f"{image.name} would have {number} environments, and an image has at most {label_claims.MOST}"
        raise RosmlError(text, "leave some of them out", exit_code=2)
    environments.sort(key=lambda environment: environment.labels[labels.ENVIRONMENT])
    merged = {**image.labels, **labels.with_environments(image.labels, present, names)}
    config = oci.encoded(_config(image, environments, merged))
    lower = below.layers if below else tuple((layer, ros) for layer in ros.layers)
    whole = (*lower, *((layer, source) for source in environments for layer in source.layers))
    manifest = {
        "schemaVersion": 2,
        "mediaType": oci.IMAGE,
        "config": oci.descriptor(oci.CONFIG, config),
        "layers": [layer for layer, _ in whole],
    }
    variables = tuple(untrusted.json_value(config)["config"].get("Env") or ())
    return Joined(image.platform, config, oci.encoded(manifest), merged, whole, variables)


def _require_ros(image: Source) -> None:
    if image.labels.get(f"{labels.PREFIX}part") or image.labels.get(labels.ENVIRONMENT):
        text = f"{image.name} is a part, but the first image must be a ROS image"
        raise RosmlError(text, "name the ROS image first, then the parts", exit_code=2)
    require_python(image)
    layers.require_whole(image)


def require_python(image: Source) -> str:
    """The version of the Python of a ROS image. Raises a RosmlError if its labels do not say it."""
    if not image.labels.get(_PYTHON):
        text = f"{image.name} is no ROS image of this project: it has no label {_PYTHON}"
        raise RosmlError(text, "use an image from the repository ros, or one that was built on it", exit_code=2)
    label_claims.require(image.labels, image.name)
    return image.labels[_PYTHON]


def _require_fit(image: Source, environment: Source) -> None:
    """Checks that an environment has the Python of an image, which has the releases that it takes."""
    label_claims.require(environment.labels, environment.name)
    layers.require_whole(environment)
    name = environment.labels[labels.ENVIRONMENT]
    if environment.platform != image.platform:
        text = f"{environment.name} is for {environment.platform}, and {image.name} for {image.platform}"
        raise RosmlError(text, "use images for one platform", exit_code=2)
    if reason := misfit(environment.labels, image.labels, image.name):
        raise RosmlError(reason, AGAIN.format(name, "IMAGE"), exit_code=2)


AGAIN = "make its lock for this image: rosml env add {} --image {}; then build it"
"""The remedy for an environment that does not go with an image, with the names of both."""


def misfit(environment: Mapping[str, str], image: Mapping[str, str], image_name: str) -> str:
    """Why an environment does not go with an image, by their labels; empty if it does."""
    name, python, has = environment.get(labels.ENVIRONMENT, ""), environment.get(_PYTHON, ""), image.get(_PYTHON, "")
    if python != has:
        return f"environment {name} is for Python {python or 'nobody knows'}, and {image_name} has {has}"
    for pair in environment.get(labels.TAKES, "").split():
        release, _, version = pair.partition("=")
        if (present := image.get(labels.PREFIX + release)) != version:
            other = f"has {release} {present}" if present else f"has no {release}"
            return f"environment {name} takes {release} {version} of its image, and {image_name} {other}"
    return ""


_MODULE = re.compile(
    rf"{labels.ENVIRONMENTS_FOLDER[1:]}/[^/]+/lib/python[0-9.]+/site-packages/([A-Za-z_][A-Za-z0-9_]*)(?:/.*|\.pyc?|\.[^/]+\.so)"
)
_METADATA = ".dist-info/METADATA"
_MOST_PACKAGES = 1000
_ROS_PACKAGE = re.compile(r"(?:usr|opt/ros/[^/]+)/share/([^/]+)/package\.xml")


def require_apart(environment: Source, files: Collection[str], others: Mapping[str, Iterable[str]]) -> None:
    """Checks that an environment has files in its folder alone, and that none hides a module of ROS. `others`: the files of the images
    that it is joined to, by their names."""
    folder = f"{labels.ENVIRONMENTS_FOLDER[1:]}/{environment.labels[labels.ENVIRONMENT]}/"
    if outside := min((path for path in files if not path.startswith(folder)), default=""):
        text = f"{environment.name} has /{outside}, and an environment has files below /{folder} alone"
        raise RosmlError(text, "build it again, or take another one", exit_code=2)
    modules = {match[1] for path in files if (match := _MODULE.fullmatch(path))}
    for name, paths in others.items():
        hidden = modules & {match[1] for path in paths if (match := _ROS_PACKAGE.fullmatch(path))}
        if hidden:
            text = f"{environment.name} would hide the module {min(hidden)} of ROS, which {name} has"
            raise RosmlError(text, "leave that package out of the environment", exit_code=2)


def require_packages(environment: Source, others: Mapping[str, Iterable[str]]) -> None:
    """Checks that the packages that an environment takes are among the files of all images that it is joined to, by their names."""
    needs = environment.labels.get(labels.NEEDS, "").split()[
        :_MOST_PACKAGES
    ]  # a stranger's word, which is only compared
    if lacking := {*needs} - {name for paths in others.values() for name in _packages(paths) if needs}:
        text = (
            f"{environment.name} takes {some(sorted(lacking))} of its image, and {listed([*others])} does not have that"
        )
        raise RosmlError(text, AGAIN.format(environment.labels[labels.ENVIRONMENT], "IMAGE"), exit_code=2)


def _packages(paths: Iterable[str]) -> Iterator[str]:
    """The names of the Python packages among some files, as an index writes them."""
    for path in paths:
        if path.endswith(_METADATA) and not path.startswith(f"{labels.ENVIRONMENTS_FOLDER[1:]}/"):
            yield package_name(path.removesuffix(_METADATA).rpartition("/")[2].rpartition("-")[0])


def _config(image: Source, environments: Sequence[Source], merged: dict[str, str]) -> dict[str, Any]:
    config = copy.deepcopy(image.config.content)
    config["config"] = (config.get("config") or {}) | {"Labels": merged}
    added = [digest for environment in environments for digest in environment.diff_ids]
    config["rootfs"] = (config.get("rootfs") or {"type": "layers"}) | {"diff_ids": [*image.diff_ids, *added]}
    if config.get("history"):  # either every layer has an entry, or there is no history
        config["history"] = [*config["history"], *(entry for it in environments for entry in _history(config, it))]
    return config


def _history(config: dict[str, Any], environment: Source) -> list[dict[str, Any]]:
    entry = {
        "created_by": f"COPY --link --from=env:{environment.labels[labels.ENVIRONMENT]} / /",
        "comment": "joined in the registry",
        **({"created": config["created"]} if "created" in config else {}),
    }
    return [entry] * len(environment.diff_ids)
