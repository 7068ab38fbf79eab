"""Computes the image of an app on another base image, without a network.

An app is one layer on its base image, with variables, a command and labels of its own. All else is the base image's. BuildKit joins them
in the same way, so the result has the digest that a build of the app on that base image would have.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import SHOWN, listed
from rosml.containerize.build.bake_file import BASE_DIGEST, BASE_NAME, LOCK, REPLACED
from rosml.containerize.lock import Lock
from rosml.images.image_set.labels import APP, PREFIX, REVISION, TITLE
from rosml.images.join.layers import Joined, Source
from rosml.registry import bases, oci

VARIANTS = f"{PREFIX}variants"
"""The label of an app that is there for several accelerators: each stack, with the oldest driver that it needs: `cpu cu130:580`."""

OWN = (TITLE, BASE_NAME, BASE_DIGEST, REVISION, APP, LOCK, VARIANTS)
"""The labels of an app. Its other labels are those of its base image."""

AGAIN = "build it again with rosml containerize, on the new base image"
"""The remedy for an image that cannot be put on another base image."""

_SETTINGS = (
    *("User", "ExposedPorts", "Env", "Entrypoint", "Cmd", "Volumes", "WorkingDir", "Labels", "StopSignal"),
    *("ArgsEscaped", "Healthcheck", "Shell"),
)
"""The settings of a config in BuildKit's order: those of OCI, then those of Docker. See `ImageConfig` in
github.com/opencontainers/image-spec and `DockerOCIImageConfigExt` in github.com/moby/docker-image-spec."""

_HISTORY = ("created", "created_by", "author", "comment", "empty_layer")
"""The fields of an entry of the history, in the same order."""

_VARIABLE = re.compile(r"ENV ([A-Za-z_][A-Za-z0-9_]*)=")
_ARGUMENT = re.compile(r"ARG APP_([A-Za-z_][A-Za-z0-9_]*)=")

_LAYER = re.compile(r"application/vnd\.oci\.image\.layer\.v1\.tar(\+gzip|\+zstd)?")
"""Layers that another image can have as they are: neither encrypted, nor to be had elsewhere."""

ONLY_OURS = "name the image that rosml containerize built, and do the same again on its new one"


def moved(app: Source, base: Source, labels: Mapping[str, str]) -> Joined:
    """An app on another base image, both for one platform.

    Args:
        labels: the app's labels about its new base image. An empty `VARIANTS` takes that label away.

    Raises:
        RosmlError: it is no app, or it cannot be put on another base image (exit code 2).
    """
    own = _own_history(app)
    _require_whole(base)
    if app.platform.split("/")[:2] != base.platform.split("/")[:2]:
        both = f"{app.name} is for {app.platform}, {base.name} for {base.platform}"
        raise RosmlError(f"an index names another platform than its image: {both}", "push the index again", exit_code=2)
    for source in (base, app):
        if strange := [layer["mediaType"] for layer in source.layers if not _LAYER.fullmatch(layer["mediaType"])]:
            problem = f"{source.name} has a layer of the type {strange[0][:100]}, which no other image can have"
            raise RosmlError(problem, AGAIN, exit_code=2)
    said = {name: text for name, text in {**_own_labels(app), **labels}.items() if text or name != VARIANTS}
    config = _config(app, base, own, said)
    encoded = as_buildkit(config)
    manifest = {
        "schemaVersion": 2,
        "mediaType": oci.IMAGE,
        "config": oci.descriptor(oci.CONFIG, encoded),
        "layers": [*base.layers, app.layers[-1]],
        **_kept(app.manifest.annotations),
    }
    layers = (*((layer, base) for layer in base.layers), (app.layers[-1], app))
    return Joined(app.platform, encoded, as_buildkit(manifest, indent=2), config["config"]["Labels"], layers)


def require_unaltered(app: Source, base: Source) -> None:
    """Checks that an app has only settings of rosml's and of its base image: others would be lost.

    Args:
        base: the app's present base image. One on which rosml put ROS first says nothing.

    Raises:
        RosmlError: somebody set others since it was built (exit code 2).
    """
    if app.diff_ids[:-1] != base.diff_ids:
        return
    given = app.config.content.get("config") or {}
    expected = _config(app, base, _own_history(app), _own_labels(app))["config"]
    mine = _ordered(given, _SETTINGS)
    differing = [name for name in _SETTINGS if mine.get(name) != expected.get(name) and name not in ("Env", "Labels")]
    has, should = (
        dict(it.partition("=")[::2] for it in found) for found in (app.config.environment, expected.get("Env", ()))
    )
    differing += sorted({f"variable {name[:100]}" for name, _ in has.items() ^ should.items()})
    labels = {*app.labels.items()} ^ {*expected.get("Labels", {}).items()}
    differing += sorted({f"label {name[:100]}" for name, _ in labels})
    if differing:
        more = [f"{len(differing) - SHOWN} more"] if len(differing) > SHOWN else []
        text = f"{app.name} was changed after rosml containerize had built it: {listed([*differing[:SHOWN], *more])}"
        raise RosmlError(text, ONLY_OURS, exit_code=2)


def require_kept(app: Source, base: Source) -> None:
    """Checks that an app keeps its settings on another base image, if its present one is gone: nobody knows whose they are.

    Args:
        base: the new base image.

    Raises:
        RosmlError: the app has some that the new image would not have (exit code 2).
    """
    given = _ordered(app.config.content.get("config") or {}, _SETTINGS)
    expected = _config(app, base, _own_history(app), _own_labels(app))["config"]
    lost = [
        name
        for name in _SETTINGS
        if name not in ("Env", "Labels") and given.get(name) not in (None, "", expected.get(name))
    ]
    names = [
        {entry.partition("=")[0] for entry in found} for found in (app.config.environment, expected.get("Env", ()))
    ]
    lost += [f"variable {name[:100]}" for name in sorted(names[0] - names[1])]
    labels = sorted(app.labels.keys() - expected.get("Labels", {}).keys())
    lost += [f"label {name[:100]}" for name in labels if not name.startswith((PREFIX, "org.opencontainers."))]
    if lost:
        more = [f"{len(lost) - SHOWN} more"] if len(lost) > SHOWN else []
        text = f"the base image of {app.name} is gone, so nobody knows who set {listed([*lost[:SHOWN], *more])}; the new one has others"
        raise RosmlError(text, AGAIN, exit_code=2)


def index(app: Mapping[str, Any], members: Mapping[str, Joined]) -> bytes:
    """The index of an app on another base image.

    Args:
        app: its present index.
        members: the new image for each entry, by the digest of the present one.
    """
    entries = []
    for entry in app["manifests"]:
        if image := members.get(entry["digest"]):
            annotations = _kept(entry.get("annotations", {}))
            entries.append({**oci.descriptor(oci.IMAGE, image.manifest), **annotations, "platform": entry["platform"]})
    annotations = _kept(app.get("annotations", {}))
    return as_buildkit({"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries, **annotations}, indent=2)


def _kept(annotations: Mapping[str, str]) -> dict[str, dict[str, str]]:
    """The field `annotations` with those that say something of the app; no field if there are none.

    What rosml wrote, and what is said of the base image, is of the old image.
    """
    old = (PREFIX, "org.opencontainers.image.base.")
    kept = {name: text for name, text in annotations.items() if not name.startswith(old)}
    return {"annotations": kept} if kept else {}


def as_buildkit(content: Mapping[str, Any], indent: int | None = None) -> bytes:
    """JSON as Go writes it: the keys have their order, and some characters are escaped."""
    separators = (",", ":") if indent is None else (",", ": ")
    text = json.dumps(content, ensure_ascii=False, separators=separators, indent=indent)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text.encode()


def lock_of(app: Source) -> Lock | None:
    """The lock in an app's label; None if it has no such label.

    Raises:
        RosmlError: the label is damaged (exit code 2).
    """
    if LOCK not in app.labels:
        return None
    try:
        return Lock.model_validate(untrusted.json_value(app.labels[LOCK].encode()))
    except ValueError:
        raise RosmlError(f"{app.name}: its label {LOCK} is damaged", AGAIN, exit_code=2) from None


def require_app(image: Source) -> None:
    """Checks that an image is an app that can move, as far as its labels tell.

    Raises:
        RosmlError: it is none (exit code 2).
    """
    target = image.labels.get(APP)
    if not target:
        text = f"{image.name} is no app that rosml containerize built: it has no label {APP}"
        raise RosmlError(text, "name an app's run or slim image", exit_code=2)
    if target == "dev":
        text = f"{image.name} is an image to work on, with compilers of its base image"
        raise RosmlError(text, "name the app's run image; build the other one again", exit_code=2)


def _own_history(app: Source) -> list[dict[str, Any]]:
    """The entries of an app's own layer and of its settings.

    Raises:
        RosmlError: the image is no app with one layer of its own (exit code 2).
    """
    require_app(app)
    if replaced := app.labels.get(REPLACED):
        text = f"{app.name} replaces what its base image has: {replaced[:200]}"
        raise RosmlError(text, AGAIN, exit_code=2)
    entries: list[dict[str, Any]] = app.config.content.get("history") or []
    first = max((number for number, entry in enumerate(entries) if not entry.get("empty_layer")), default=-1)
    own = entries[first:] if first >= 0 else []
    if own and own[0].get("comment") == "joined in the registry":
        text = f"{app.name} is an app with parts that rosml join added"
        raise RosmlError(text, "name the app without them, and as its base an image that has them", exit_code=2)
    if not own or len(app.layers) < 2:
        raise RosmlError(f"{app.name}: its config does not say what its layers are", AGAIN, exit_code=2)
    _require_whole(app)
    if not str(own[0].get("created_by", "")).startswith("COPY / / "):
        text = f"{app.name}: its last layer is not the app, but {str(own[0].get('created_by', ''))[:60]!r}"
        raise RosmlError(text, "name the image that rosml containerize built; a build on top of it must run again", 2)
    known = [match[1] for entry in own if (match := _ARGUMENT.match(_line(entry)))]
    for line in map(_line, own[1:]):
        variable = _VARIABLE.match(line)
        if not line.startswith(("ARG APP_", "CMD ")) and not (variable and variable[1] in known):
            text = f"{app.name} was changed after rosml containerize had built it: {line[:60]!r}"
            raise RosmlError(text, ONLY_OURS, exit_code=2)
    return own


def _line(entry: Mapping[str, Any]) -> str:
    return str(entry.get("created_by", ""))


def _own_labels(app: Source) -> dict[str, str]:
    return {name: app.labels[name] for name in OWN if name in app.labels}


def _require_whole(source: Source) -> None:
    said = sum(not entry.get("empty_layer") for entry in source.config.content.get("history") or ())
    if not source.layers or not len(source.layers) == len(source.diff_ids) == said:
        raise RosmlError(f"{source.name}: its config does not say what its layers are", AGAIN, exit_code=2)
    bases.require_no_triggers(source.config.facts.config, source.name)


def _config(app: Source, base: Source, own: Iterable[Mapping[str, Any]], labels: Mapping[str, str]) -> dict[str, Any]:
    known, settings = base.config.content, base.config.content.get("config") or {}
    mine = app.config.content.get("config") or {}
    new = {**settings, "Env": _environment(app, base, own), "Labels": dict(sorted({**base.labels, **labels}.items()))}
    new |= {name: mine[name] for name in ("Cmd", "ArgsEscaped") if name in mine}
    facts = app.config.content
    content = {name: known[name] for name in ("author",) if known.get(name)}
    content |= {name: facts[name] for name in ("architecture", "os", "variant", "created") if facts.get(name)}
    content["config"] = _ordered(new, _SETTINGS)
    content["history"] = [_ordered(entry, _HISTORY) for entry in (*(known.get("history") or ()), *own)]
    content["rootfs"] = {"type": "layers", "diff_ids": [*base.diff_ids, app.diff_ids[-1]]}
    return dict(sorted(content.items()))


def _environment(app: Source, base: Source, own: Iterable[Mapping[str, Any]]) -> list[str]:
    """The base image's variables with the app's: those that its history names."""
    found = dict.fromkeys(match[1] for entry in own if (match := _VARIABLE.match(str(entry.get("created_by", "")))))
    values = {name: value for name, _, value in (entry.partition("=") for entry in app.config.environment)}
    merged = {name: value for name, _, value in (entry.partition("=") for entry in base.config.environment)}
    merged |= {name: values[name] for name in found if name in values}
    return [f"{name}={value}" for name, value in merged.items()]


def _ordered(found: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The known fields, in their order, without empty ones."""
    return {name: found[name] for name in names if found.get(name) not in (None, "", [], {}, False)}
