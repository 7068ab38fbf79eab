"""Local replacements for the programs that the publisher calls: small shell scripts."""

from __future__ import annotations

import contextlib
import importlib.util
import json
import os
import pty
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from rosml import ROOT
from rosml.machine.services import Services

NO_FORMAT_1 = (
    (b"", "invalid JSON"),
    (b"\xff", "it is not UTF-8"),
    (b"[]", "input should be an object"),
    (b"{}", "version: field required"),
    (b'{"version": 2}', "version: input should be 1"),
)
"""Contents of files of which format 1 alone is read, and what is said of each."""


def on_a_terminal(code: str, *arguments: str, env: Mapping[str, str]) -> tuple[int, bytes]:
    main, other = pty.openpty()
    with subprocess.Popen([sys.executable, "-c", code, *arguments], env=env, stdout=other, stderr=other) as process:
        os.close(other)
        output = b""
        with contextlib.suppress(OSError):  # how a terminal says that nobody writes any more
            while part := os.read(main, 1000):
                output += part
    os.close(main)
    return process.returncode, output


BUILDX = """\
here='{folder}'
echo "buildx $*" >>"$here/calls"
case $1 in inspect) cat "$here/status"; exit 0 ;; esac
metadata= report= archive= previous= target=
for word; do
    case $previous in --metadata-file) metadata=$word ;; esac
    case $word in
        *.output=type=local,dest=*) report=${{word#*dest=}} ;;
        *.output=type=tar,dest=*) archive=${{word#*dest=}} report=$archive.left ;;
    esac
    previous=$word target=$word
done
[ -z "$archive" ] || rm -rf "$report"
trap '[ -z "$archive" ] || [ ! -d "$report" ] || tar -cf "$archive" -C "$report" .' EXIT
"""
"""A buildx that records its calls; what `bake` does is up to the test: it finds $metadata, $report and $target, and what is in
$report comes out of the build."""


OFFLINE = [sys.executable, str(Path(__file__).resolve().parents[3] / "tools" / "offline")]
"""The command that is asked for base images where Docker Hub does not answer."""


def script_of_a_build(name: str) -> ModuleType:
    file = ROOT / "components" / name
    spec = importlib.util.spec_from_file_location(f"{file.stem}_of_a_build", file)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(file.parent))  # where scripts find each other
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(file.parent))
    return module


def executable(path: Path, text: str) -> str:
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return str(path)


def buildx(folder: Path, bake: str) -> tuple[str, ...]:
    (folder / "status").write_text("Status: running\n")
    return (executable(folder / "buildx", BUILDX.format(folder=folder) + bake),)


def calls(folder: Path) -> list[str]:
    """What was called, in order: program and arguments."""
    file = folder / "calls"
    return file.read_text().splitlines() if file.exists() else []


def services(root: Path, registry: str = "127.0.0.1:1", **changes: Any) -> Services:
    """Services of a checkout, as the set-up writes them down; nothing listens on port 1."""
    facts = {
        "registry": registry,
        "buildx": ["/nowhere/buildx"],
        "builder": "rosml",
        "builder_kind": "buildkitd",
        "buildx_config": None,
        "uv": "/nowhere/uv",
        "ca_bundle": "",
        "docker_hub": True,
        "bases": [],
        **changes,
    }
    (root / ".state").mkdir(exist_ok=True)
    (root / ".state" / "services.json").write_text(json.dumps(facts))
    return Services.load(root)


def load(root: Path, **changes: Any) -> Services:
    """Those of a machine with Docker, an authority of its own, and no Docker Hub."""
    docker = {"buildx": ["docker", "buildx"], "buildx_config": "/x/.state/buildx", "uv": "/x/uv"}
    return services(root, **{**docker, "ca_bundle": "/ca.pem", "docker_hub": False, **changes})


HOSTILE = (
    *(
        "${{ toJSON(secrets) }}",
        "${{{{ a }}",
        "$CI_JOB_TOKEN",
        "${TOKEN}",
        "${localEnv:TOKEN}",
        "${containerEnv:PATH}",
        "$(id)",
        "$$(HOME)",
        "%{ if true }",
        '"} x="',
        "`id`",
        "%h%%",
        "{{ .Values }}",
        "a: b",
    ),
    *("# x", "- x", "'x'", '"x"', "\\", "é", "*a", "&a", "!b", "@c", "|", ">"),
)
"""Texts that mean something in a file for GitHub, GitLab, editors, compose, systemd, Kubernetes, Docker or buildx."""
