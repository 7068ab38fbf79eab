"""Whether an image that somebody else made ends its entrypoint by becoming the command."""

from __future__ import annotations

import pytest

from rosml.images.builds import adopted


@pytest.mark.parametrize(
    ("entrypoint", "path", "paths"),
    [
        ((), "/bin", ()),
        (("/opt/nvidia/nvidia_entrypoint.sh",), "/bin", ("/opt/nvidia/nvidia_entrypoint.sh",)),
        (("/usr/bin/tini", "-g", "--", "/start.sh"), "/bin", ("/start.sh",)),
        (("dumb-init", "bash", "/start.sh"), "/bin", ("/start.sh",)),
        (("start.sh",), "/opt/x/bin:/bin", ("/opt/x/bin/start.sh", "/bin/start.sh", "/usr/bin/start.sh")),
        (("/tini", "--"), "/bin", ()),
        (("sleep", "1000"), "/bin", ()),
        (("/entrypoint.sh", "--quiet"), "/bin", ()),
        (("/bin/sh", "-c", "exec /start.sh"), "/bin", ()),
        (("/usr/local/bin/python3.12", "serve.py"), "/bin", ()),
        (("/a b.sh",), "/bin", ()),
        (("/x /\nRUN true",), "/bin", ()),
        (("/[a]*.sh",), "/bin", ()),
        (("start.sh",), "$X:a b:", ()),
    ],
)
def test_where_the_script_of_an_entrypoint_is(entrypoint: tuple[str, ...], path: str, paths: tuple[str, ...]) -> None:
    """Of two inits, one is left; a program that gets words of its own may be a server."""
    assert adopted.scripts(entrypoint, {"PATH": path}) == paths


NVIDIA = """#!/bin/bash
shopt -s nullglob
if [[ $# -eq 0 ]]; then
  exec "/bin/bash"
else
  exec "$@"
fi
"""


@pytest.mark.parametrize(
    ("script", "passes_on"),
    [
        (NVIDIA, True),
        ('#!/bin/bash\nset -e\nsource /opt/sdk/setup.sh --\nexec "$@"\n# the end\n\n', True),
        ('#!/usr/bin/env bash\nexec -- "${@}"', True),
        ('#!/bin/sh\nexec gosu me "$@"\n', True),
        ("#!/bin/sh\nexec $@\n", False),
        ('#!/bin/sh\nexec nginx "$@"\n', False),
        ('#!/bin/sh\nexec "$@"\nsleep 1000\n', False),
        ('#!/bin/sh\nif [ "$1" = debug ]; then\n  exec "$@"\nfi\n', False),
        ('#!/usr/bin/python3\nexec "$@"\n', False),
        ("#!/bin/sh\n", False),
        ("\x7fELF", False),
        ("", False),
    ],
)
def test_a_script_that_becomes_the_command(script: str, passes_on: bool) -> None:
    assert adopted.ends_in_the_command(script) is passes_on
