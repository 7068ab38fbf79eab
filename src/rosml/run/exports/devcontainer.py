"""Writes a call as a `devcontainer.json` for editors: https://containers.dev/implementors/json_reference/.

An editor replaces the image's entrypoint by a command that waits, then enters the container as its user.
"""

from __future__ import annotations

import json
import re
from dataclasses import replace
from typing import Any

from rosml.base.errors import RosmlError
from rosml.run.context import Context, Image
from rosml.run.exports.description import Call, Option, fields, file, placed, preceded, volume
from rosml.run.paths import FILES, bind, joined
from rosml.run.plugins.basic_options import FOLDER_LABEL
from rosml.run.plugins.user import VARIABLE

FOLDER = "${localWorkspaceFolder}"
VARIABLES = re.compile(r"\$\{\s*(?:env|local\w*|container\w*|devcontainer\w*)\b", re.IGNORECASE)
"""The beginning of a variable of editors: https://containers.dev/implementors/json_reference/#variables-in-devcontainerjson."""

ENVIRONMENTS_LABEL = "io.rosml.environments"
"""The label of an image with the names of its environments of Python packages: docs/environments.md."""

DROPPED = ("interactive", "tty")
LISTS = {"cap-add": "capAdd", "security-opt": "securityOpt"}
SWITCHES = ("init", "privileged")
ELSEWHERE = ("env", "mount", "user", *LISTS, *SWITCHES)


def bare(context: Context) -> Context:
    """The context without the image's entrypoint: the user's bare ids run. In a trusted image that makes users, the group 0 may
    write to the workspace, and also to mounted files of root's group."""
    line, image = context.line, context.image
    is_chosen = line.asks("no-user") or line.has("user") or (context.engine.rootless and not context.engine.podman)
    trusted = context.trusted or context.engine.rootless
    if VARIABLE in image.environment and trusted and context.person.uid and not is_chosen:
        line = preceded(line, "--group-add", "0")
    environment = {key: value for key, value in image.environment.items() if key != VARIABLE}
    return replace(context, line=line, image=replace(image, environment=environment))


def text(call: Call) -> str:
    """The file. Options without a counterpart go to the engine unchanged."""
    if call.command:
        message = f"a dev container has no command of yours, such as {call.command[0]}: its editor keeps it open"
        raise RosmlError(message, "leave the command out, and call it on the editor's terminal", exit_code=2)
    _require_no_variables(call)
    if call.values("entrypoint"):
        raise RosmlError("a dev container has its editor's entrypoint", "leave out --entrypoint", exit_code=2)
    workspace = next((option for option in call.options if _target(option, call)), None)
    others = [option for option in call.options if option is not workspace]
    user = call.value("user")
    document: dict[str, Any] = {"name": call.name, "image": call.image}
    if workspace:
        target = _target(workspace, call)
        document |= {"workspaceMount": bind(FOLDER, target), "workspaceFolder": target}
    if user:
        document["containerUser"] = "root" if user == "0:0" else user
    document |= {
        "updateRemoteUserUID": False,
        "containerEnv": dict(map(_variable, call.values("env"))),
        "mounts": [_mount(option, call) for option in others if option.name == "mount"],
        **{option.name: option.is_on for option in others if option.name in SWITCHES},
        **{key: [*dict.fromkeys(call.values(name))] for name, key in LISTS.items()},
        "runArgs": [_word(option, call) for option in others if option.name not in (*ELSEWHERE, *DROPPED)],
        "customizations": _customizations(call.about),
    }
    written = {key: value for key, value in document.items() if value not in ([], {})}
    return json.dumps(written, indent=2, ensure_ascii=False) + "\n"


def _customizations(image: Image) -> dict[str, Any]:
    """VS Code takes the Python of the image's environment, if there is one alone."""
    names = image.labels.get(ENVIRONMENTS_LABEL, "").split()
    if len(names) != 1 or not re.fullmatch(r"[a-z0-9-]{1,64}", names[0]):
        return {}
    return {"vscode": {"settings": {"python.defaultInterpreterPath": f"/opt/env/{names[0]}/bin/python"}}}


def _require_no_variables(call: Call) -> None:
    """Refuses variables of editors in texts of images, folders and words. An editor puts something of the desk in their place, such as a
    password from the environment, and knows no escape."""
    texts = [call.name, call.image, call.folder, call.place, *(option.value or "" for option in call.options)]
    if variable := next(filter(None, map(VARIABLES.search, texts)), None):
        text = f"{variable.string[:100]!a} has {variable[0]}, for which an editor puts in something of your machine"
        raise RosmlError(text, "leave it out, or take another image or folder", exit_code=2)


def _variable(value: str) -> tuple[str, str]:
    """A variable of the container. Without a value, it has that of the user who starts it."""
    name, equals, text = value.partition("=")
    return name, text if equals else f"${{localEnv:{name}}}"


def _target(option: Option, call: Call) -> str:
    """The path at which an option mounts the current folder; empty if it mounts something else, or in another way."""
    if option.name == "volume":
        source, _, target = (option.value or "").partition(":")
        return target if source == call.place and ":" not in target else ""
    if option.name != "mount":
        return ""
    mount = dict(fields(option))
    target = mount.pop("target", "")
    return target if mount == {"type": "bind", "source": call.place} else ""


def _mount(option: Option, call: Call) -> str:
    mount = dict(fields(option))
    if "source" in mount:
        mount["source"] = placed(mount["source"], call, FOLDER)
    return joined([f"{key}={value}" if value else key for key, value in mount.items()])


def _word(option: Option, call: Call) -> str:
    """An option of the engine, as one word."""
    value = option.value
    if value is None:
        return f"--{option.name}"
    if option.name in FILES:
        value = file(option, call, FOLDER)
    elif option.name == "volume":
        value = volume(option, call, FOLDER)
    elif value == f"{FOLDER_LABEL}={call.folder}":
        value = f"{FOLDER_LABEL}={FOLDER}"
    return f"--{option.name}={value}"
