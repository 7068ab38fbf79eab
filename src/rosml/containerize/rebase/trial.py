"""Tries an app on its new base image in the builder, before its tag moves there."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

from rosml.base import files, terminal, untrusted
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.base.problems import SHOWN
from rosml.containerize.build.bake_file import SCRIPTS
from rosml.containerize.rebase.image import AGAIN
from rosml.machine import buildx, exported
from rosml.machine.services import Services

LINES = 10_000  # most lines about what an app does not find

SECONDS = 120  # how long the user's command may take: other builds wait meanwhile

_LINK = """FROM {0} AS {0}-linked
USER root
RUN --network=none --mount=type=bind,from=scripts,source=containerize/link.py,target=/run/link.py \\
    mkdir /rosml-linked && /entrypoint.sh python3 /run/link.py /rosml-linked/{0}
"""
_RUN = """FROM app
ARG TRIAL
RUN timeout --kill-after=10 {0} /entrypoint.sh bash -c "$TRIAL" || {{ code=$?; [ "$code" != 124 ] || \\
    echo "error: the command did not end within {0} s; name one that ends by itself"; exit "$code"; }}
"""


@dataclass(frozen=True)
class Pair:
    """An app for one platform, on its new and on its old base image, each by digest."""

    new: str
    present: str


class Trial:
    """Steps in a builder, which reaches the registry of the images. Each app has a folder of its own."""

    def __init__(self, services: Services, name: str) -> None:
        self._services = services
        short = re.sub(r"[^A-Za-z0-9._-]", "+", name)[-80:]
        self._state = services.state / "rebase" / f"{short}-{hashlib.sha256(name.encode()).hexdigest()[:12]}"
        self._state.mkdir(parents=True, exist_ok=True)

    def link(self, images: Mapping[str, Pair]) -> None:
        """Checks by the dynamic linker and by Python that an app finds on the new base image what it found on the old one."""
        with self._turn():
            for platform, pair in images.items():
                if lost := sorted(self._lost_lines(platform, pair)):
                    more = [f"and {len(lost) - SHOWN} more"] if len(lost) > SHOWN else []
                    shown = "".join(f"\n    {line}" for line in [*lost[:SHOWN], *more])
                    text = f"on its new base image the app does not find ({platform}):{shown}"
                    raise RosmlError(text, AGAIN, exit_code=2)

    def _turn(self) -> AbstractContextManager[int]:
        return turn(
            self._state / "lock", lambda: terminal.echo("another process tries the same app; waiting", err=True)
        )

    def _lost_lines(self, platform: str, pair: Pair) -> set[str]:
        archive = self._state / "linked.tar"
        archive.unlink(missing_ok=True)
        stages = [_LINK.format(name) for name in ("app", "before")]
        copies = [f"COPY --from={name}-linked /rosml-linked/{name} /" for name in ("app", "before")]
        target = {
            "dockerfile-inline": "\n".join([*stages, "FROM scratch", *copies, ""]),
            "contexts": {"app": _image(pair.new), "before": _image(pair.present), "scripts": str(SCRIPTS)},
            "output": [exported.output(archive)],
        }
        self._build("link", platform, target)
        exported.unpack(archive, self._state / "linked")
        now, before = (lines(exported.read(self._state / "linked", name)) for name in ("app", "before"))
        return now - before

    def run(self, images: Mapping[str, Pair], command: str) -> None:
        """Runs a command in the new image, as after `rosml run IMAGE`."""
        for platform, pair in images.items():
            target = {
                "dockerfile-inline": _RUN.format(SECONDS),
                "contexts": {"app": _image(pair.new)},
                "args": {"TRIAL": command.replace("${", "$${").replace("%{", "%%{")},
                "output": ["type=cacheonly"],
            }
            with self._turn():
                self._build("run", platform, target)

    def _build(self, name: str, platform: str, target: Mapping[str, Any]) -> None:
        self._services.require_builder(platform)
        (self._state / "empty").mkdir(exist_ok=True)
        whole = {"context": str(self._state / "empty"), "platforms": [platform], **target}
        file = self._state / f"{name}.json"
        files.write(file, json.dumps({"target": {name: whole}}, indent=2) + "\n")
        call = buildx.Bake(name, f"rebase-{self._state.name}-{name}", file, foreign=("link.py", "$TRIAL"))
        buildx.run(self._services, call)


def _image(reference: str) -> str:
    return f"docker-image://{reference}"


def lines(content: bytes) -> set[str]:
    """The lines of components/containerize/link.py. Code of the app may have written others, which are refused."""
    texts: set[str] = set()
    for line in filter(None, content.split(b"\n")[: LINES + 1]):
        try:
            text = untrusted.json_value(line)
        except ValueError:
            text = None
        if not isinstance(text, str) or len(texts) == LINES:
            raise RosmlError("the step that links the app left something else than its lines", AGAIN)
        texts.add("".join(character if character.isprintable() else "?" for character in text))
    return texts
