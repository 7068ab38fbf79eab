"""Writes the table of inputs into files of `rosml containerize` for CI, and into their pages in docs/, between markers."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator

from rosml.base import github
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize.ci.inputs import SECRET, SETTINGS, Setting

ACTION = "containerize/action.yml"
INDEX = "containerize/index/action.yml"
WORKFLOW = ".github/workflows/containerize.yml"
GITLAB = "containerize/gitlab.yml"
INPUTS_PAGE = "docs/containerize/inputs.md"
CI_PAGE = "docs/containerize/ci.md"
FILES = (ACTION, INDEX, WORKFLOW, GITLAB, INPUTS_PAGE, CI_PAGE)

_DECIDED = ("enable-checkout", "enable-singlearch-push")
"""Inputs of the action that callers of the workflow cannot set."""

_OF_CHECKOUT = ("enable-checkout", "enable-checkout-lfs", "enable-checkout-submodules")
NOT_OF_GITLAB = ("enable-singlearch-push", *_OF_CHECKOUT)
"""Inputs that GitLab, or its jobs for one platform each, decide."""

_OF_REGISTRY = ("registry", "registry-user", "registry-password")
_OTHER_STEPS = (*_OF_REGISTRY, *_OF_CHECKOUT)
"""Inputs of the action that the command does not need."""

_OF_TAGS = [f"{before}image-{part}" for before in ("", "dev-", "slim-") for part in ("name", "tag")]
_INDEX = ("target", "platform", *_OF_TAGS, "push", "enable-push-as-latest", *_OF_REGISTRY, "build-context")
"""Inputs of the job that moves the tags."""

_BLOCK = re.compile(
    r"^(?P<begin>(?P<indent> *)(#|<!--) (?P<name>\w+): written by rosml generate( -->)?\n)(?:.*\n)*?"
    r"(?P<end>(?P=indent)(#|<!--) /(?P=name)( -->)?\n)",
    re.MULTILINE,
)


def render(path: str, text: str) -> str:
    """The new content of a file, from its present content."""
    blocks = _blocks()[path]
    written: set[str] = set()

    def block(match: re.Match[str]) -> str:
        name = match["name"]
        if name not in blocks:
            return match[0]
        written.add(name)
        return "".join((match["begin"], *(f"{match['indent']}{line}\n" for line in blocks[name]), match["end"]))

    rendered = _BLOCK.sub(block, text)
    if missing := sorted(blocks.keys() - written):
        mark = "'<!-- {} -->'" if path.endswith(".md") else "'# {}'"
        begin, end = (mark.format(text) for text in (f"{missing[0]}: written by rosml generate", f"/{missing[0]}"))
        raise RosmlError(f"{path}: the marker {begin} is missing", f"put it back, and {end} after it")
    return rendered


def _blocks() -> dict[str, dict[str, Iterable[str]]]:
    """The lines of each block, by file."""
    index = [setting for setting in SETTINGS if setting.input.name in _INDEX]
    called = [setting for setting in SETTINGS if setting.input.name not in _DECIDED]
    gitlab = [setting for setting in SETTINGS if setting.input.name not in NOT_OF_GITLAB]
    secret = [setting for setting in called if setting.input.name in SECRET]
    return {
        ACTION: {"inputs": _inputs(SETTINGS, _of_github), "environment": _environment(SETTINGS)},
        INDEX: {"inputs": _inputs(index, _of_github), "environment": _environment(index)},
        WORKFLOW: {
            "inputs": _inputs([it for it in called if it not in secret], _of_workflow, "type: string"),
            "secrets": [
                line
                for setting in secret
                for line in (f"{setting.input.name}:", f"  description: {json.dumps(_help(setting, _of_github))}")
            ],
            "values": _passed(called),
            "names": _passed(index),
        },
        GITLAB: {"inputs": _inputs(gitlab, _of_gitlab), "environment": _variables(gitlab)},
        INPUTS_PAGE: {"inputs": _table_of_inputs(), "gone": _table_of_unused_inputs()},
        CI_PAGE: {"ci": _table_of_defaults()},
    }


def _of_github(setting: Setting) -> tuple[str, str]:
    """The default in the action, and its words in the description."""
    if setting.server:
        return "", f"the job's token for {setting.server[1]}"
    return setting.github, "" if setting.github else setting.input.default


def _of_workflow(setting: Setting) -> tuple[str, str]:
    """The default in the workflow: that of the action, but each platform has a machine here."""
    return ("amd64,arm64", "") if setting.input.name == "platform" else _of_github(setting)


def _of_gitlab(setting: Setting) -> tuple[str, str]:
    """No default, so that variables of the pipeline count."""
    return "", setting.gitlab or setting.input.default


Default = Callable[[Setting], tuple[str, str]]


def _inputs(settings: Iterable[Setting], default: Default, *more: str) -> Iterator[str]:
    for setting in settings:
        yield f"{setting.input.name}:"
        yield f"  description: {json.dumps(_help(setting, default))}"
        yield from (f"  {line}" for line in more)
        yield f"  default: {json.dumps(default(setting)[0])}"


def _help(setting: Setting, default: Default) -> str:
    """The help of an input, with its default, unless that has its own line."""
    item, (value, words) = setting.input, default(setting)
    if item.gone:
        return f"not used: {item.gone}"
    text = item.help.partition("; ")[0] if value or words or item.name in SECRET else item.help
    return f"{text} [{words}]" if words else text


def _environment(settings: Iterable[Setting]) -> Iterator[str]:
    for setting in settings:
        if setting.input.name not in _OTHER_STEPS:
            token = f" || {setting.token}" if setting.token else ""
            yield f"{setting.input.variable}: ${{{{ inputs.{setting.input.name}{token} }}}}"


def _passed(settings: Iterable[Setting]) -> Iterator[str]:
    """The inputs that the workflow passes to an action, except for the platform, which is the job's."""
    for name in (setting.input.name for setting in settings):
        if name != "platform":
            yield f"{name}: ${{{{ {'secrets' if name in SECRET else 'inputs'}.{name} }}}}"


def _variables(settings: Iterable[Setting]) -> Iterator[str]:
    """Variables of a job of GitLab. GitLab does not expand the command's variables: the run image's shell does."""
    for setting in settings:
        name, value = f"INPUT_{setting.input.variable}", f"$[[ inputs.{setting.input.name} ]]"
        if setting.input.name == "command":
            yield from (f"{name}:", f"  value: {value}", "  expand: false")
        else:
            yield f"{name}: {value}"
    yield from (f"DEFAULT_{it.input.variable}: {json.dumps(it.gitlab)}" for it in settings if it.gitlab)


# ---- Tables in docs/ -------------------------------------------------------------------------------------------------


def _table_of_inputs() -> list[str]:
    used = (item for item in app_inputs.TABLE if not item.gone)
    rows = ((f"`{item.name}`", item.help, _code(item.default), item.in_repository) for item in used)
    return github.table(("input", "what it says", "if you say nothing", "in `.env`"), rows).splitlines()


def _table_of_unused_inputs() -> list[str]:
    rows = ((f"`{item.variable}`", item.gone) for item in app_inputs.TABLE if item.gone)
    return github.table(("variable", "why"), rows).splitlines()


def _table_of_defaults() -> list[str]:
    rows = []
    for setting in SETTINGS:
        if setting.server or setting.github or setting.gitlab:
            item = setting.input
            on_github = f"the job's token for {setting.server[1]}" if setting.server else _code(setting.github)
            on_gitlab = "no such input" if item.name in NOT_OF_GITLAB else _code(setting.gitlab)
            rows.append((f"`{item.name}`", item.help.partition("; ")[0], on_github, on_gitlab))
    return github.table(("input", "what it says", "on GitHub", "on GitLab"), rows).splitlines()


def _code(text: str) -> str:
    return f"`{text}`" if text else ""
