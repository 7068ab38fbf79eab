"""The tables of inputs in docs/containerize/, rendered from the table in containerize/inputs.py between markers."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize.ci import files as ci_files
from rosml.containerize.ci import inputs as ci_inputs

_BY = "written by rosml generate"

PAGES = {"docs/containerize/inputs.md": ("inputs", "gone"), "docs/containerize/ci.md": ("ci",)}


def render(path: str, page: str) -> str:
    lines = {"inputs": _inputs, "gone": _gone, "ci": _ci}
    for name in PAGES[path]:
        begin, end = f"<!-- {name}: {_BY} -->\n", f"<!-- /{name} -->"
        pattern = re.compile(f"{re.escape(begin)}.*{re.escape(end)}", re.DOTALL)
        if not pattern.search(page):
            raise RosmlError(f"{path}: the markers {begin.strip()} and {end} are missing", "put them back")
        head, tail = pattern.split(page, maxsplit=1)
        page = "".join((head, begin, *(f"{line}\n" for line in lines[name]()), end, tail))
    return page


def _inputs() -> Iterator[str]:
    yield "| input | what it says | if you say nothing | in `.env` |"
    yield "| --- | --- | --- | --- |"
    for item in app_inputs.TABLE:
        if not item.gone:
            yield f"| `{item.name}` | {item.help} | {_code(item.default)} | {item.in_repository} |"


def _ci() -> Iterator[str]:
    yield "| input | what it says | on GitHub | on GitLab |"
    yield "| --- | --- | --- | --- |"
    for setting in ci_inputs.SETTINGS:
        if setting.server or setting.github or setting.gitlab:
            item = setting.input
            github = f"the job's token for {setting.server[1]}" if setting.server else _code(setting.github)
            gitlab = "no such input" if item.name in ci_files.NOT_OF_GITLAB else _code(setting.gitlab)
            yield f"| `{item.name}` | {item.help.partition('; ')[0]} | {github} | {gitlab} |"


def _code(text: str) -> str:
    return f"`{text}`" if text else ""


def _gone() -> Iterator[str]:
    yield "| variable | why |"
    yield "| --- | --- |"
    yield from (f"| `{item.variable}` | {item.gone} |" for item in app_inputs.TABLE if item.gone)
