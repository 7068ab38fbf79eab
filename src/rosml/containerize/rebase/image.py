"""Computes the image of an app on another base image, without a network.

An app is one layer on its base image, with variables, a command and labels of its own. All else is the base image's. BuildKit joins them
in the same way, so the image has the digest that a build of the app on that base image would have.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import SHOWN, listed
from rosml.containerize.build.bake_file import REPLACED
from rosml.containerize.lock import Lock
from rosml.containerize.names import DEV
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME, LOCK, PREFIX, REVISION, TITLE
from rosml.images.join.layers import Joined, Source
from rosml.registry import bases, oci

VARIANTS = f"{PREFIX}variants"
"""The label of an app that exists for several accelerators: each stack, with the oldest driver that it needs: `cpu cu130:580`."""

OWN = (TITLE, BASE_NAME, BASE_DIGEST, REVISION, APP, LOCK, VARIANTS)
"""The labels of an app. Its other labels are those of its base image."""

AGAIN = "build it again with rosml containerize, on the new base image"

ONLY_OURS = "name the image that rosml containerize built, and do the same again on its new one"

_SETTINGS = (
    *("User", "ExposedPorts", "Env", "Entrypoint", "Cmd", "Volumes", "WorkingDir", "Labels", "StopSignal"),
    *("ArgsEscaped", "Healthcheck", "Shell"),
)
"""The settings of a config in BuildKit's order: those of OCI, then those of Docker. See `ImageConfig` in
github.com/opencontainers/image-spec and `DockerOCIImageConfigExt` in github.com/moby/docker-image-spec."""

_HISTORY = ("created", "created_by", "author", "comment", "empty_layer")

_VARIABLE = re.compile(r"ENV ([A-Za-z_][A-Za-z0-9_]*)=")
_ARGUMENT = re.compile(r"ARG APP_([A-Za-z_][A-Za-z0-9_]*)=")

_LAYER = re.compile(r"application/vnd\.oci\.image\.layer\.v1\.tar(\+gzip|\+zstd)?")
"""Layers that another image can have as they are: neither encrypted, nor to be had elsewhere."""


def moved(app: Source, base: Source, labels: Mapping[str, str]) -> Joined:
    """An app on another base image. `labels` are the app's about that; an empty `VARIANTS` takes the label away."""
    history = _app_history(app)
    _require_whole(base)
    if app.platform.split("/")[:2] != base.platform.split("/")[:2]:
        both = f"{app.name} is for {app.platform}, {base.name} for {base.platform}"
        raise RosmlError(f"an index names another platform than its image: {both}", "push the index again", exit_code=2)
    for source in (base, app):
        if strange := [layer["mediaType"] for layer in source.layers if not _LAYER.fullmatch(layer["mediaType"])]:
            problem = f"{source.name} has a layer of the type {strange[0][:100]}, which no other image can have"
            raise RosmlError(problem, AGAIN, exit_code=2)
    new_labels = {name: text for name, text in {**_app_labels(app), **labels}.items() if text or name != VARIANTS}
    config = _config(app, base, history, new_labels)
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
    """Checks that an app has only settings of rosml's and of its present base image: others would be lost."""
    if app.diff_ids[:-1] != base.diff_ids:
        return
    settings, expected = _settings(app), _expected(app, base)
    others = [name for name in _SETTINGS if name not in ("Env", "Labels")]
    differing = [name for name in others if settings.get(name) != expected.get(name)]
    variables = _variables(app.config.environment).items() ^ _variables(expected.get("Env", ())).items()
    differing += sorted({f"variable {name[:100]}" for name, _ in variables})
    labels = {*app.labels.items()} ^ {*expected.get("Labels", {}).items()}
    differing += sorted({f"label {name[:100]}" for name, _ in labels})
    if differing:
        text = f"{app.name} was changed after rosml containerize had built it: {_first(differing)}"
        raise RosmlError(text, ONLY_OURS, exit_code=2)


def require_kept(app: Source, base: Source) -> None:
    """Checks that an app keeps its settings on a new base image if its present one is gone: nobody knows whose they are."""
    settings, expected = _settings(app), _expected(app, base)
    lost = [
        name
        for name in _SETTINGS
        if name not in ("Env", "Labels") and settings.get(name) not in (None, "", expected.get(name))
    ]
    variables = _variables(app.config.environment).keys() - _variables(expected.get("Env", ())).keys()
    lost += [f"variable {name[:100]}" for name in sorted(variables)]
    labels = sorted(app.labels.keys() - expected.get("Labels", {}).keys())
    lost += [f"label {name[:100]}" for name in labels if not name.startswith((PREFIX, "org.opencontainers."))]
    if lost:
        text = f"the base image of {app.name} is gone, so nobody knows who set {_first(lost)}; the new one has others"
        raise RosmlError(text, AGAIN, exit_code=2)


def _settings(app: Source) -> dict[str, Any]:
    return _ordered(app.config.content.get("config") or {}, _SETTINGS)


def _expected(app: Source, base: Source) -> dict[str, Any]:
    """The settings that an app has on a base image, if rosml alone made it."""
    settings: dict[str, Any] = _config(app, base, _app_history(app), _app_labels(app))["config"]
    return settings


def _first(names: Sequence[str]) -> str:
    return listed([*names[:SHOWN], *([f"{len(names) - SHOWN} more"] if len(names) > SHOWN else [])])


def index(app: Mapping[str, Any], members: Mapping[str, Joined]) -> bytes:
    """The index of an app on another base image. `members` are the new images by the digests of the present ones."""
    entries = []
    for entry in app["manifests"]:
        if image := members.get(entry["digest"]):
            annotations = _kept(entry.get("annotations", {}))
            entries.append({**oci.descriptor(oci.IMAGE, image.manifest), **annotations, "platform": entry["platform"]})
    annotations = _kept(app.get("annotations", {}))
    return as_buildkit({"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries, **annotations}, indent=2)


def _kept(annotations: Mapping[str, str]) -> dict[str, dict[str, str]]:
    """The field `annotations` without what rosml wrote and what is about the base image: that is true of the old image only."""
    of_old_image = (PREFIX, "org.opencontainers.image.base.")
    kept = {name: text for name, text in annotations.items() if not name.startswith(of_old_image)}
    return {"annotations": kept} if kept else {}


def as_buildkit(content: Mapping[str, Any], indent: int | None = None) -> bytes:
    """JSON as Go writes it: the keys have their order, and some characters are escaped."""
    separators = (",", ":") if indent is None else (",", ": ")
    text = json.dumps(content, ensure_ascii=False, separators=separators, indent=indent)
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text.encode()


def lock_of(app: Source) -> Lock | None:
    if LOCK not in app.labels:
        return None
    try:
        return Lock.model_validate(untrusted.json_value(app.labels[LOCK].encode()))
    except ValueError:
        raise RosmlError(f"{app.name}: its label {LOCK} is damaged", AGAIN, exit_code=2) from None


def require_app(image: Source) -> None:
    target = image.labels.get(APP)
    if not target:
        text = f"{image.name} is no app that rosml containerize built: it has no label {APP}"
        raise RosmlError(text, "name an app's run or slim image", exit_code=2)
    if target == DEV:
        text = f"{image.name} is an image to work on, with compilers of its base image"
        raise RosmlError(text, "name the app's run image; build the other one again", exit_code=2)


def _app_history(app: Source) -> list[dict[str, Any]]:
    """The entries of an app's own layer and of its settings, if it has one layer of its own."""
    require_app(app)
    if replaced := app.labels.get(REPLACED):
        text = f"{app.name} replaces what its base image has: {replaced[:200]}"
        raise RosmlError(text, AGAIN, exit_code=2)
    entries: list[dict[str, Any]] = app.config.content.get("history") or []
    last = max((number for number, entry in enumerate(entries) if not entry.get("empty_layer")), default=len(entries))
    history = entries[last:]
    if history and history[0].get("comment") == "joined in the registry":
        text = f"{app.name} is an app with parts that rosml join added"
        raise RosmlError(text, "name the app without them, and as its base an image that has them", exit_code=2)
    if not history or len(app.layers) < 2:
        raise RosmlError(f"{app.name}: its config does not say what its layers are", AGAIN, exit_code=2)
    _require_whole(app)
    first_line, *other_lines = map(_line, history)
    if not first_line.startswith("COPY / / "):
        text = f"{app.name}: its last layer is not the app, but {first_line[:60]!r}"
        raise RosmlError(text, "name the image that rosml containerize built; a build on top of it must run again", 2)
    arguments = [match[1] for line in other_lines if (match := _ARGUMENT.match(line))]
    for line in other_lines:
        variable = _VARIABLE.match(line)
        if not line.startswith(("ARG APP_", "CMD ")) and not (variable and variable[1] in arguments):
            text = f"{app.name} was changed after rosml containerize had built it: {line[:60]!r}"
            raise RosmlError(text, ONLY_OURS, exit_code=2)
    return history


def _line(entry: Mapping[str, Any]) -> str:
    return str(entry.get("created_by", ""))


def _app_labels(app: Source) -> dict[str, str]:
    return {name: app.labels[name] for name in OWN if name in app.labels}


def _require_whole(source: Source) -> None:
    layers = sum(not entry.get("empty_layer") for entry in source.config.content.get("history") or ())
    if not source.layers or not len(source.layers) == len(source.diff_ids) == layers:
        raise RosmlError(f"{source.name}: its config does not say what its layers are", AGAIN, exit_code=2)
    bases.require_no_triggers(source.config.facts.config, source.name)


def _config(
    app: Source, base: Source, history: Iterable[Mapping[str, Any]], labels: Mapping[str, str]
) -> dict[str, Any]:
    of_base, of_app = base.config.content, app.config.content
    app_settings, settings = of_app.get("config") or {}, dict(of_base.get("config") or {})
    settings |= {"Env": _environment(app, base, history), "Labels": dict(sorted({**base.labels, **labels}.items()))}
    settings |= {name: app_settings[name] for name in ("Cmd", "ArgsEscaped") if name in app_settings}
    content = {name: of_base[name] for name in ("author",) if of_base.get(name)}
    content |= {name: of_app[name] for name in ("architecture", "os", "variant", "created") if of_app.get(name)}
    content["config"] = _ordered(settings, _SETTINGS)
    content["history"] = [_ordered(entry, _HISTORY) for entry in (*(of_base.get("history") or ()), *history)]
    content["rootfs"] = {"type": "layers", "diff_ids": [*base.diff_ids, app.diff_ids[-1]]}
    return dict(sorted(content.items()))


def _environment(app: Source, base: Source, history: Iterable[Mapping[str, Any]]) -> list[str]:
    names = dict.fromkeys(match[1] for entry in history if (match := _VARIABLE.match(_line(entry))))
    values, merged = _variables(app.config.environment), _variables(base.config.environment)
    merged |= {name: values[name] for name in names if name in values}
    return [f"{name}={value}" for name, value in merged.items()]


def _variables(entries: Iterable[str]) -> dict[str, str]:
    return {name: value for name, _, value in (entry.partition("=") for entry in entries)}


def _ordered(fields: Mapping[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The named fields, in the order of the names, without empty ones."""
    return {name: fields[name] for name in names if fields.get(name) not in (None, "", [], {}, False)}
