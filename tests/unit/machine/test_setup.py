"""The set-up's parts that need no network: pins, ports, daemons, configurations, commands it would run."""

from __future__ import annotations

import http.server
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from fakes.workflows import accepted
from rosml.base import programs
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version
from rosml.cli import main
from rosml.cli.machine import setup as commands
from rosml.machine.services import Services
from rosml.machine.setup import builder, installer, network, process, registry, services, step_network, tools
from rosml.machine.setup.builder_cache import CacheLimits
from rosml.machine.setup.daemon import Daemon, command_line, wait_until
from rosml.machine.setup.installer import Installer
from rosml.machine.setup.state import LONGEST_SOCKET_PATH, State
from rosml.machine.setup.tool_cache import ToolCache
from rosml.registry import credentials

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def state(tmp_path: Path) -> State:
    made = State(tmp_path, print, uv="/uv", cache=tmp_path / "cache")
    for folder in (made.bin, made.log, made.run):
        folder.mkdir(parents=True)
    return made


def program(folder: Path, name: str, text: str) -> Path:
    """Makes a shell program."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def call(state: State, monkeypatch: pytest.MonkeyPatch, *words: str) -> str:
    """Runs a command of `rosml setup` for a checkout, as scripts/bootstrap.py calls it; what it says."""
    monkeypatch.setattr(commands, "ROOT", state.root)
    monkeypatch.setenv(commands.UV, "/uv")
    monkeypatch.setenv("XDG_CACHE_HOME", str(state.cache))
    return CliRunner().invoke(commands.main, words, catch_exceptions=False).output


# ---- pins -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", installer.GO_PROGRAMS)
def test_every_go_program_is_pinned(name: str) -> None:
    module = ROOT / "tools" / "go" / name
    pin = programs.parse_pin((module / "go.mod").read_text())
    assert re.fullmatch(r"v\d+\.\d+\.\d+", pin.version)
    direct = re.search(r"^require (\S+) v", (module / "go.mod").read_text(), re.MULTILINE)
    root = direct[1] if direct and pin.package == "." else pin.package.split("/cmd/")[0]
    assert f"{root} {pin.version} h1:" in (module / "go.sum").read_text()


def test_the_local_registry_links_no_cloud() -> None:
    """The stock program links three clouds' drivers: twice the code to fetch, compile and link, for a local folder."""
    pins = (ROOT / "tools/go/registry/go.sum").read_text().lower()
    assert not {word for word in ("aws-sdk", "azure", "cloud.google.com", "oauth2") if word in pins}


def test_python_tools_are_pinned_by_hash() -> None:
    text = (ROOT / "tools" / "requirements.txt").read_text()
    assert re.search(r"^uv==\d+\.\d+\.\d+ ", text, re.MULTILINE)
    assert text.count("--hash=sha256:") == 2
    assert "http" not in text


def test_parse_pin_takes_the_module_of_the_tool() -> None:
    go_mod = """module x.invalid/tools

go 1.26.8

tool example.org/a/v3/cmd/a

require (
\texample.org/a v1.0.0 // indirect
\texample.org/a/v3 v3.1.2 // indirect
\texample.org/b v0.1.0 // indirect
)
"""
    assert programs.parse_pin(go_mod) == programs.Pin("example.org/a/v3/cmd/a", "v3.1.2")


def test_parse_pin_takes_the_module_that_an_own_program_requires() -> None:
    go_mod = "module x.invalid/tools\n\nrequire example.org/a/v3 v3.1.2\n\nrequire (\n\texample.org/b v0.1.0 // indirect\n)\n"
    assert programs.parse_pin(go_mod) == programs.Pin(".", "v3.1.2")


@pytest.mark.parametrize("text", ["", "tool example.org/a/cmd/a\n"])
def test_parse_pin_without_a_pin(text: str) -> None:
    with pytest.raises(ValueError, match=r"tool|module"):
        programs.parse_pin(text)


@pytest.mark.parametrize(
    ("text", "version"),
    [
        ("VCSTag:     v0.11.7\nVCSRef: unknown", (0, 11, 7)),
        ("uv 0.13.8 (x86_64)", (0, 13, 8)),
        ("go version go1.26.8 linux/amd64", (1, 26, 8)),
        ("github.com/docker/buildx v0.33.0 abc", (0, 33, 0)),
        ("unknown", ()),
    ],
)
def test_version_in(text: str, version: tuple[int, ...]) -> None:
    assert installer.version_in(text) == version


# ---- tools ----------------------------------------------------------------------------------------------------------
def test_a_tool_on_path_is_used_if_it_is_new_enough(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    mine = program(state.root / "mine", "regctl", "echo VCSTag: v0.11.9")
    monkeypatch.setenv("PATH", str(mine.parent))
    installer = Installer(state)
    assert installer.on_path("regctl", "version", (0, 11)) == str(mine)
    assert installer.on_path("regctl", "version", (0, 12)) is None
    assert installer.have == ["regctl v0.11.9 (found on PATH)"]


@pytest.mark.parametrize("name", ["trivy", "cosign"])
@pytest.mark.parametrize(("version", "used"), [("0.65.0", True), ("0.64.9", False), ("0.66.0", False), ("dev", False)])
def test_a_scanner_or_signer_on_path_is_used_if_it_is_the_pinned_one(
    state: State,
    monkeypatch: pytest.MonkeyPatch,
    version: str,
    used: bool,
    name: str,
) -> None:
    """Neither older nor newer: what is found must not depend on the machine."""
    module = state.root / "tools" / "go" / name
    module.mkdir(parents=True)
    (module / "go.mod").write_text(f"tool example.org/{name}/cmd/{name}\nrequire example.org/{name} v0.65.0\n")
    (module / "go.sum").write_text("")
    mine = program(state.root / "mine", name, f"echo Version: {version}; echo Vulnerability DB:; echo Version: 2")
    go = program(
        state.root / "go-bin",
        "go",
        """case $1 in
  version) echo go version go1.26.8 linux/amd64 ;;
  build) while [ "$1" != -o ]; do shift; done; echo built >"$2" ;;
esac""",
    )
    monkeypatch.setenv("PATH", f"{mine.parent}:{go.parent}:/usr/bin:/bin")
    word = {"trivy": "scanner", "cosign": "signer"}[name]
    said = call(state, monkeypatch, word)
    found = json.loads((state.folder / f"{word}.json").read_text())
    assert found == {name: str(mine if used else state.bin / name)}
    assert ("is not v0.65.0, which is pinned: not used" in said) is not used


def test_set_up_does_not_build_the_scanner_and_the_signer(state: State, bare: Path) -> None:
    """Each takes ten minutes or more; most who build an image never scan or sign one."""
    tools.install(state, hub=True)
    built = {line.split()[1] for line in bare.read_text().splitlines() if line.startswith("build ")}
    assert "buildx" in built
    assert not {"trivy", "cosign", "actionlint", "composecheck"} & built


@pytest.fixture
def bare(state: State, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout on a machine that has local replacements for Go and apt, which note their calls, and nothing else."""
    calls = state.root / "calls"
    for name in installer.GO_PROGRAMS:
        module = state.root / "tools/go" / name
        module.mkdir(parents=True)
        (module / "go.mod").write_text(f"tool example.org/{name}/cmd/x\nrequire example.org/{name} v1.2.3\n")
    script = f"""case $1 in
  version) echo go version go1.26.8 linux/amd64 ;;
  mod) echo "fetch $(basename $PWD)" >>{calls} ;;
  build) echo "build $(basename $PWD)" >>{calls}; mkdir -p $GOCACHE; while [ "$1" != -o ]; do shift; done; echo >"$2" ;;
esac"""
    folder = program(state.root / "mine", "go", script).parent
    program(folder, "apt-get", f'case $* in *install*) echo "apt ${{*##*recommends }}" >>{calls} ;; esac')
    for name in ("sh", "basename", "mkdir", "rm"):
        os.symlink(str(shutil.which(name)), folder / name)
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setattr(
        installer, "which_system", lambda name: str(folder / name) if (folder / name).exists() else None
    )
    monkeypatch.setattr(tools, "which_system", installer.which_system)
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    return calls


@pytest.mark.parametrize("tests", [False, True])
def test_set_up_of_a_bare_machine(state: State, bare: Path, capsys: pytest.CaptureFixture[str], tests: bool) -> None:
    """One call of apt, each module fetched and each program built once, and the compiler's caches dropped after the last of
    them: otherwise the standard library would be compiled twice."""
    found = tools.install(state, hub=False, tests=tests)
    calls = bare.read_text().splitlines()
    names = sorted(["actionlint", "composecheck", "regctl"] * tests + ["buildkitd", "buildx", "registry"])
    assert sorted(call for call in calls if call.startswith("build ")) == [f"build {name}" for name in names]
    for_tests = " docker.io chromium" if tests else ""
    assert [call for call in calls if call.startswith("apt ")] == [f"apt runc mmdebstrap{for_tests}"]
    assert not (state.folder / "go").exists()
    assert found.buildx == (str(state.bin / "buildx"),)
    assert (found.uv, found.registry, bool(found.bases)) == ("/uv", "", True)
    said = capsys.readouterr().out
    assert "fetching them in the background" in said and "installs the Debian packages runc (" in said
    bare.unlink()
    tools.install(state, hub=False, tests=tests)
    assert not [call for call in bare.read_text().splitlines() if call.startswith(("build ", "fetch "))]


def test_what_may_not_be_installed_is_told_before_minutes_of_compiling(
    state: State, bare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(tools, "choose_builder", lambda installer, hub: ("docker", "rosml"))
    with pytest.raises(RosmlError, match=r"docker\.io .*chromium .*only root may") as caught:
        tools.install(state, hub=True, tests=True)
    assert "apt-get install --no-install-recommends docker.io chromium" in caught.value.remedy
    assert not bare.exists()


def test_a_failure_of_apt_ends_the_set_up(state: State, bare: Path) -> None:
    program(state.root / "mine", "apt-get", "echo no mirror >&2; exit 2")
    with pytest.raises(RosmlError, match=r"(?s)apt-get update: failed.*no mirror"):
        tools.install(state, hub=True)


def test_modules_are_fetched_in_the_background_and_no_longer_than_they_are_needed(state: State, go: Path) -> None:
    began = state.root / "began"
    program(go.parent, "go", f"case $1 in version) echo go1.26.8 ;; mod) echo $$ >{began}; exec sleep 60 ;; esac")
    with Installer(state).fetching(["regctl"]):
        assert wait_until(lambda: began.exists() and bool(began.read_text()), 20)
        pid = int(began.read_text())
        # between the shell and sleep, a process has no command line
        assert wait_until(lambda: "sleep" in command_line(pid), 10)
    assert wait_until(lambda: not command_line(pid), 10), "a signal takes a moment"


def test_a_client_of_a_registry_builds_no_program(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    """Jobs that only read and write a registry have no use for a local one, a builder, buildx or regctl."""
    monkeypatch.setattr(Installer, "go_program", lambda self, name: pytest.fail(f"{name} was built"))
    monkeypatch.setattr(Installer, "debian_packages", lambda self, wanted: pytest.fail("packages of the system"))
    path = state.root / "path"
    monkeypatch.setenv("GITHUB_PATH", str(path))
    call(state, monkeypatch, "client")
    assert path.read_text() == f"{state.bin}\n"
    found = Services.load(state.root)
    assert not found.bases, "base images are the official ones, on the machines that build"
    for ask in (found.require_registry, found.require_builder, lambda: found.place):
        with pytest.raises(RosmlError) as caught:
            ask()
        assert caught.value.remedy == "run 'rosml setup'"
    assert services.status(state)["up"] is False
    assert "not up (rosml setup)" in call(state, monkeypatch, "status")


def test_a_client_leaves_services_that_are_up(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    facts = machine(state, "buildkitd")
    facts.save()
    call(state, monkeypatch, "client")
    assert Services.load(state.root) == facts


def test_our_own_folder_does_not_count_as_the_machines(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    program(state.bin, "regctl", "echo v9.9.9")
    monkeypatch.setenv("PATH", str(state.bin))
    assert Installer(state).on_path("regctl", "version", (0, 11)) is None


@pytest.fixture
def go(state: State, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with one tool to build, and a local replacement for Go that writes the file it was asked for."""
    module = state.root / "tools" / "go" / "regctl"
    module.mkdir(parents=True)
    (module / "go.mod").write_text("tool example.org/r/cmd/regctl\nrequire example.org/r v1.2.3\n")
    (module / "go.sum").write_text("")
    script = """case $1 in
  version) echo go version go1.26.8 linux/amd64 ;;
  build) while [ "$1" != -o ]; do shift; done; echo "$GOFLAGS|$CGO_ENABLED|$GOMODCACHE" >"$2" && chmod +x "$2" ;;
esac"""
    path = program(state.root / "go-bin", "go", script)
    monkeypatch.setenv("PATH", f"{path.parent}:/usr/bin:/bin")
    monkeypatch.setenv("GOFLAGS", "-mod=mod")
    return path


def test_go_tool_is_built_once(state: State, go: Path, capsys: pytest.CaptureFixture[str]) -> None:
    built = Path(Installer(state).go_program("regctl"))
    assert built.read_text() == f"-mod=readonly -modcacherw -buildvcs=false|0|{state.folder}/go/modules\n"
    assert "regctl v1.2.3: built from its Go module in" in capsys.readouterr().out
    go.unlink()
    again = Installer(state)
    again.go_program("regctl")
    assert again.have == ["regctl v1.2.3"]


def test_another_checkout_takes_a_go_tool(state: State, go: Path, tmp_path: Path) -> None:
    Installer(state).go_program("regctl")
    other = replace(state, root=tmp_path / "other")
    other.bin.mkdir(parents=True)
    (other.root / "tools").symlink_to(state.root / "tools")
    go.unlink()
    taken = Installer(other)
    path = Path(taken.go_program("regctl"))
    assert path.parent == other.bin and "readonly" in path.read_text() and os.access(path, os.X_OK)
    assert taken.have == ["regctl v1.2.3 (built for another checkout)"] and taken.is_built("regctl")
    (kept,) = (state.cache / "tools").iterdir()
    assert re.fullmatch(r"regctl-v1\.2\.3-[0-9a-f]{16}-\w+", kept.name)


@pytest.mark.parametrize(
    "wrong", ["writable", "link", "another's folder", "a folder behind a link", "empty", "other pins"]
)
def test_a_go_tool_that_somebody_else_may_have_put_there_is_not_taken(
    state: State, go: Path, wrong: str, tmp_path: Path
) -> None:
    Installer(state).go_program("regctl")
    (kept,) = (state.cache / "tools").iterdir()
    kept.write_text("evil")
    if wrong == "writable":
        kept.chmod(0o775)
    elif wrong == "link":
        kept.rename(tmp_path / "evil")
        kept.symlink_to(tmp_path / "evil")
    elif wrong == "another's folder":
        kept.parent.chmod(0o777)
    elif wrong == "a folder behind a link":
        kept.parent.rename(tmp_path / "elsewhere")
        kept.parent.symlink_to(tmp_path / "elsewhere")
    elif wrong == "empty":
        kept.write_text("")
    else:
        (state.root / "tools/go/regctl/go.sum").write_text("changed")
    (state.bin / "regctl").unlink()
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_cache_that_cannot_be_written_loses_nothing(state: State, go: Path) -> None:
    state.cache.write_text("no folder")
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_go_tool_that_nobody_takes_any_more_goes(state: State, go: Path) -> None:
    cache = ToolCache(state.cache / "tools")
    cache.folder.mkdir(parents=True)
    old, new = (program(cache.folder, name, "") for name in (f"regctl-v1-{16 * '0'}-x86", f"regctl-v2-{16 * '0'}-x86"))
    mine = program(cache.folder, "my-thesis.tex", "")
    for path in (old, mine):
        os.utime(path, (0, 0))
    Installer(state).go_program("regctl")
    assert not old.exists() and new.exists() and mine.exists(), "nor does a file that is nobody's program"


@pytest.mark.parametrize("changed", ["go.sum", "main.go"])
def test_go_tool_is_built_anew_when_a_pin_changes(state: State, go: Path, changed: str) -> None:
    Installer(state).go_program("regctl")
    (state.root / "tools/go/regctl" / changed).write_text("changed")
    (state.bin / "regctl").write_text("old")
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_failed_build_shows_the_log_and_leaves_no_tool(state: State, go: Path) -> None:
    program(go.parent, "go", "[ $1 = version ] && echo go1.26.8 && exit 0; seq 100; echo no such module >&2; exit 3")
    with pytest.raises(RosmlError) as caught:
        Installer(state).go_program("regctl")
    message = caught.value.message
    assert "exit code 3" in message
    assert "no such module" in message
    assert str(state.log / "build-regctl.log") in message
    assert len(message.splitlines()) == process.TAIL_LINES + 2
    assert not (state.bin / "regctl").exists()


@pytest.mark.parametrize(("text", "says"), [("", "not installed"), ("echo go version go1.19.8 linux/amd64", "too old")])
def test_no_go(state: State, go: Path, monkeypatch: pytest.MonkeyPatch, text: str, says: str) -> None:
    go.unlink()
    which = shutil.which
    monkeypatch.setattr(shutil, "which", lambda name, path: which(name, path=str(go.parent)))
    if text:
        program(go.parent, "go", text)
    with pytest.raises(RosmlError, match=says) as caught:
        Installer(state).go_program("regctl")
    assert "install Go" in caught.value.remedy


def test_go_build_needs_disk(state: State, go: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installer, "BUILD_BYTES", 10**18)
    with pytest.raises(RosmlError, match="of disk are free"):
        Installer(state).go_program("regctl")


def test_debian_packages_by_a_plain_user(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(installer, "which_system", lambda name: f"/usr/bin/{name}")
    with pytest.raises(RosmlError, match="only root may") as caught:
        Installer(state).debian_packages({"runc": "runs build steps"})
    assert "sudo sh -c 'apt-get update && apt-get install --no-install-recommends runc'" in caught.value.remedy


def test_debian_packages_say_so_before(
    state: State, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    calls = state.root / "calls"
    apt = program(state.root / "apt", "apt-get", f'echo "$@" >>{calls}')
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(installer, "which_system", lambda name: str(apt))
    Installer(state).debian_packages({"runc": "runs build steps", "mmdebstrap": "makes images"})
    said = capsys.readouterr().out.splitlines()
    assert (
        said[0]
        == "this changes the system: installs the Debian packages runc (runs build steps), mmdebstrap (makes images)"
    )
    update, installs = calls.read_text().splitlines()
    assert update.endswith("update")
    assert installs.endswith("install --yes --no-install-recommends runc mmdebstrap")


def test_no_apt(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installer, "which_system", lambda name: None)
    with pytest.raises(RosmlError, match="no apt-get"):
        Installer(state).debian_packages({"runc": "runs build steps"})


def test_no_package_is_installed_without_need(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    Installer(state).debian_packages({})
    monkeypatch.setattr(tools, "which_system", lambda name: None)
    assert list(tools.missing_packages("buildkitd", hub=False)) == ["runc", "mmdebstrap"]
    assert list(tools.missing_packages("docker", hub=True)) == []
    monkeypatch.setattr(tools, "which_system", lambda name: name if name == "crun" else None)
    assert list(tools.missing_packages("buildkitd", hub=True)) == []


@pytest.mark.parametrize(
    ("answers", "there", "root", "asked", "remedy"),
    [
        (True, ["apt-get"], True, [], ""),
        (False, ["dockerd", "apt-get"], True, [], ""),
        (False, ["apt-get"], True, ["docker.io"], ""),
        (
            False,
            ["apt-get"],
            False,
            [],
            "sudo sh -c 'apt-get update && apt-get install --no-install-recommends docker.io'",
        ),
        (False, [], True, [], "install docker.io"),
    ],
)
def test_an_engine_for_the_tests_of_the_contract(
    state: State,
    monkeypatch: pytest.MonkeyPatch,
    answers: bool,
    there: list[str],
    root: bool,
    asked: list[str],
    remedy: str,
) -> None:
    """Installed only where no Docker answers; where it cannot be, tests would be missing: that is a failure."""
    monkeypatch.setattr(tools, "docker_is_there", lambda installer: answers)
    assert installed(tools.engine_packages, state, monkeypatch, there, root) == (asked, remedy)


def installed(
    lacking: Callable[[Installer], dict[str, str]],
    state: State,
    monkeypatch: pytest.MonkeyPatch,
    there: list[str],
    root: bool,
) -> tuple[list[str], str]:
    """What apt is to install on a machine with some programs, and the remedy where that fails."""
    packages: list[str] = []
    monkeypatch.setattr(tools, "which_system", lambda name: name if name in there else None)
    monkeypatch.setattr(installer, "which_system", lambda name: name if name in there else None)
    monkeypatch.setattr(os, "geteuid", lambda: 0 if root else 1000)
    monkeypatch.setattr(
        installer, "run", lambda say, call: packages.extend(call.argv[-1:] * ("install" in call.argv))
    )
    try:
        made = Installer(state)
        made.debian_packages(lacking(made))
    except RosmlError as error:
        return packages, error.remedy
    return packages, ""


@pytest.mark.parametrize(
    ("there", "root", "asked", "remedy"),
    [
        (["google-chrome", "apt-get"], True, [], ""),
        (["apt-get"], True, ["chromium"], ""),
        (["apt-get"], False, [], "sudo sh -c 'apt-get update && apt-get install --no-install-recommends chromium'"),
        ([], True, [], "install chromium"),
    ],
)
def test_a_browser_for_the_tests_of_the_page(
    state: State, monkeypatch: pytest.MonkeyPatch, there: list[str], root: bool, asked: list[str], remedy: str
) -> None:
    assert installed(lambda _: tools.browser_packages(), state, monkeypatch, there, root) == (asked, remedy)


@pytest.mark.parametrize(
    ("docker", "hub", "image", "root", "kind"),
    [
        (True, True, False, False, "docker"),
        (True, False, True, False, "docker"),
        (True, False, False, True, "buildkitd"),  # Docker could not pull BuildKit
        (False, True, False, True, "buildkitd"),
        (False, True, False, False, "needs root"),
        (True, False, False, False, "Docker Hub does not answer, and Docker has no moby/buildkit"),
    ],
)
def test_choice_of_the_builder(
    state: State, monkeypatch: pytest.MonkeyPatch, docker: bool, hub: bool, image: bool, root: bool, kind: str
) -> None:
    monkeypatch.delenv("BUILDX_BUILDER", raising=False)
    monkeypatch.setattr(tools, "docker_is_there", lambda installer: docker)
    monkeypatch.setattr(tools, "docker_has_buildkit", lambda installer: image)
    monkeypatch.setattr(tools, "buildkit_image", lambda state: "moby/buildkit:v1")
    monkeypatch.setattr(os, "geteuid", lambda: 0 if root else 1000)
    installer = Installer(state)
    if " " not in kind:
        assert tools.choose_builder(installer, hub) == (kind, "rosml")
    else:
        with pytest.raises(RosmlError, match=kind):
            tools.choose_builder(installer, hub)
    monkeypatch.setenv("BUILDX_BUILDER", "mine")
    assert tools.choose_builder(installer, hub) == ("user", "mine")


def test_buildkit_in_docker_is_of_the_pinned_release() -> None:
    version = re.escape(pinned_version(ROOT, "buildkitd", RosmlError))
    assert re.fullmatch(rf"moby/buildkit:v{version}@sha256:[0-9a-f]{{64}}", tools.buildkit_image(State(ROOT)))


# ---- network --------------------------------------------------------------------------------------------------------
def test_docker_hub_can_be_decided_by_the_user(monkeypatch: pytest.MonkeyPatch) -> None:
    for wish, answers in (("1", True), ("0", False)):
        monkeypatch.setenv("ROSML_DOCKER_HUB", wish)
        assert network.docker_hub_answers("") == answers
    monkeypatch.setenv("ROSML_DOCKER_HUB", "yes")
    with pytest.raises(RosmlError, match="neither 0 nor 1"):
        network.docker_hub_answers("")


@pytest.fixture
def answer(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[tuple[int, dict[str, str]]]]:
    """A server in the place of Docker Hub; the list's one entry is what it answers."""
    wanted: list[tuple[int, dict[str, str]]] = []

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            code, headers = wanted[0]
            self.send_response(code)
            for name, value in headers.items():
                self.send_header(name, value)
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        monkeypatch.setattr(network, "HUB_API", f"http://127.0.0.1:{server.server_port}/v2/")
        monkeypatch.setenv("no_proxy", "127.0.0.1")
        monkeypatch.delenv("ROSML_DOCKER_HUB", raising=False)
        yield wanted
        server.shutdown()


REGISTRY_HEADER = {"Docker-Distribution-Api-Version": "registry/2.0"}


@pytest.mark.parametrize(
    ("code", "headers", "answers"),
    [
        (401, REGISTRY_HEADER, True),
        (200, REGISTRY_HEADER, True),
        (403, REGISTRY_HEADER, False),
        (503, REGISTRY_HEADER, False),
        (200, {}, False),  # a sign-in page of a hotel
        (401, {}, False),  # a proxy that wants a password
    ],
)
def test_docker_hub_answers(
    answer: list[tuple[int, dict[str, str]]], code: int, headers: dict[str, str], answers: bool
) -> None:
    answer.append((code, headers))
    assert network.docker_hub_answers("") is answers


def test_a_hiccup_of_docker_hub(answer: list[tuple[int, dict[str, str]]], monkeypatch: pytest.MonkeyPatch) -> None:
    answer.append((503, REGISTRY_HEADER))
    waits: list[float] = []

    def wait(seconds: float) -> None:
        waits.append(seconds)
        if seconds:
            answer[0] = (401, REGISTRY_HEADER)

    monkeypatch.setattr("time.sleep", wait)
    assert network.docker_hub_answers("", attempts=3)
    assert waits == [0, network.WAIT_SECONDS]


@pytest.mark.timeout(60)
def test_docker_hub_that_hangs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(network, "HUB_SECONDS", 0.2)
    monkeypatch.delenv("ROSML_DOCKER_HUB", raising=False)
    monkeypatch.setenv("no_proxy", "127.0.0.1")
    with socket.create_server(("127.0.0.1", 0)) as server:
        monkeypatch.setattr(network, "HUB_API", f"http://127.0.0.1:{server.getsockname()[1]}/v2/")
        assert not network.docker_hub_answers("")


def test_ports() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        assert not network.port_is_free(port)
    assert network.port_is_free(port)
    assert network.free_port() > 1023
    assert not network.registry_answers(f"127.0.0.1:{port}")


# ---- state ----------------------------------------------------------------------------------------------------------
def test_socket_of_a_short_path() -> None:
    assert State(Path("/work/x")).socket("b.sock") == Path("/work/x/.state/run/b.sock")


@pytest.mark.parametrize("root", ["/" + "deep/" * 30, "/with space", "/ümlaut"])
def test_socket_of_a_path_that_cannot_hold_one(root: str) -> None:
    path = State(Path(root)).socket("buildkitd.sock")
    assert str(path).startswith(f"/tmp/rosml-{os.getuid()}-")
    assert len(str(path)) <= LONGEST_SOCKET_PATH
    assert path != State(Path(root + "x")).socket("buildkitd.sock")


def test_socket_folder_of_somebody_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "short"
    monkeypatch.setattr(State, "short_run", property(lambda self: folder))
    state = State(tmp_path)
    state.prepare_socket(folder / "s")
    assert folder.stat().st_mode & 0o777 == 0o700
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    with pytest.raises(RosmlError, match="belongs to another user"):
        state.prepare_socket(folder / "s")


# ---- daemons --------------------------------------------------------------------------------------------------------
@pytest.fixture
def sleeper(state: State) -> Iterator[Daemon]:
    config = state.run / "sleeper.conf"
    config.write_text("1")
    code = "import time; time.sleep(60)"
    daemon = Daemon(state, "sleeper", (sys.executable, "-c", code, str(config)), config, dict(os.environ))
    yield daemon
    daemon.stop()


def test_daemon_starts_and_stops(sleeper: Daemon) -> None:
    assert sleeper.pid() is None
    sleeper.start()
    pid = sleeper.pid()
    assert pid is not None
    assert os.getsid(pid) == pid
    assert sleeper.current()
    sleeper.config.write_text("2")
    assert not sleeper.current()
    assert sleeper.stop()
    assert sleeper.pid() is None
    assert not sleeper.stop()


def test_only_the_daemon_itself_is_stopped(sleeper: Daemon) -> None:
    """Not what has another command line, such as the daemon of another checkout."""
    foreign = [*sleeper.argv[:-1], "/another.conf"]
    with subprocess.Popen(foreign) as other:
        sleeper.start()
        assert sleeper.pid() not in (None, other.pid)
        assert sleeper.stop()
        assert other.poll() is None
        other.kill()


def test_daemon_that_ignores_sigterm_is_killed(state: State) -> None:
    config = state.run / "stubborn.conf"
    config.write_text("")
    code = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); open('ready', 'w'); time.sleep(60)"
    daemon = Daemon(state, "stubborn", (sys.executable, "-c", code, str(config)), config, dict(os.environ))
    daemon.start()
    while not (state.folder / "ready").exists():
        time.sleep(0.01)
    assert daemon.stop(patience=0.3)
    assert daemon.pid() is None


def test_daemon_that_cannot_be_run(state: State) -> None:
    config = state.run / "x"
    with pytest.raises(RosmlError, match="cannot run /nowhere/at/all"):
        Daemon(state, "x", ("/nowhere/at/all",), config, {}).start()


def test_command_line_of_nobody() -> None:
    assert command_line(2**22 + 1) == ()
    assert command_line(os.getpid())


# ---- services -------------------------------------------------------------------------------------------------------
def machine(state: State, kind: str, buildx: str = "buildx", registry: str = "127.0.0.1:5001") -> Services:
    config = None if kind == "user" else state.folder / "buildx"
    return Services(state.root, registry, (buildx,), "rosml", kind, config, "/uv", "", bases=())


def test_registry_config_is_yaml_of_a_plain_registry() -> None:
    config = json.loads(registry.config(Path("/a b/.state/registry"), 5001, Path("/p")))
    assert config["auth"] == {"writers": {"path": "/p"}}
    assert config["http"] == {"addr": "127.0.0.1:5001"}
    assert config["storage"]["delete"] == {"enabled": True}
    assert config["storage"]["filesystem"]["rootdirectory"] == "/a b/.state/registry"


def test_registry_port_is_remembered(state: State) -> None:
    assert registry.last_port(state) is None
    (state.run / "registry.yaml").write_text(registry.config(state.folder, 5001, Path("/p")))
    assert registry.last_port(state) == 5001


def test_the_password_of_the_registry_is_this_users_alone(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    secret = registry.password(state)
    assert len(secret) > 20 and registry.password(state) == secret, "it stays"
    assert (state.run / registry.PASSWORD).stat().st_mode & 0o777 == 0o600
    (state.folder / credentials.OWN).parent.mkdir()
    (state.folder / credentials.OWN).write_text(json.dumps({"auths": {"127.0.0.1:5001": {"auth": "bWU6cHc="}}}))
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"ghcr.io": {"auth": "eDp5"}}}))
    told = json.loads(machine(state, "buildkitd").environment()["DOCKER_AUTH_CONFIG"])
    assert told == {"auths": {"ghcr.io": {"auth": "eDp5"}, "127.0.0.1:5001": {"auth": "bWU6cHc="}}}, "what buildx gets"
    monkeypatch.delenv("DOCKER_AUTH_CONFIG")
    monkeypatch.setattr(credentials, "STATE", state.folder)
    assert credentials.from_docker("127.0.0.1:5001") == credentials.Credentials("me", "pw")


def test_registry_environment(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("REGISTRY_HTTP_ADDR", "0.0.0.0:80")
    env = registry.daemon(state).env
    assert "REGISTRY_HTTP_ADDR" not in env


def test_buildkit_config(tmp_path: Path) -> None:
    own = {"root": '/r "x"', "socket": "/s", "otel": "/o", "runc": "/usr/sbin/runc"}
    text = builder.config("127.0.0.1:5001", True, own)
    toml = tomllib.loads(text)
    assert toml["root"] == '/r "x"'
    assert toml["grpc"]["address"] == ["unix:///s"]
    assert toml["registry"]["docker.io"]["mirrors"] == ["127.0.0.1:5001"]
    assert toml["registry"]["127.0.0.1:5001"] == {"http": True, "insecure": True}
    assert toml["worker"]["oci"]["gcpolicy"] == [{"all": True, "maxUsedSpace": "40GB", "minFreeSpace": "12GB"}]
    certificate = tmp_path / "ca.crt"
    certificate.write_text("one")
    trusted = {"reg.example:5000": [certificate], "127.0.0.1:5001": [Path("ours")], "docker.io": [Path("mirror")]}
    text = builder.config("127.0.0.1:5001", False, None, trusted)
    assert tomllib.loads(text)["registry"] == {
        "127.0.0.1:5001": {"http": True, "insecure": True},
        "reg.example:5000": {"http": False, "ca": [str(certificate)]},
    }
    certificate.write_text("another")
    assert builder.config("127.0.0.1:5001", False, None, trusted) != text, "a builder in Docker has copies"
    in_docker = builder.config("127.0.0.1:5001", False)
    assert "docker.io" not in in_docker
    assert "root" not in in_docker
    assert tomllib.loads(builder.config("127.0.0.1:5001", False, own))["worker"]["oci"]["networkMode"] == "host"
    bridge = step_network.Bridge("rosml1", "172.20.3.0/24", Path("/plugins"))
    text = builder.config("127.0.0.1:5001", False, own, bridge=bridge)
    assert tomllib.loads(text)["worker"]["oci"]["networkMode"] == "bridge"
    (tmp_path / "buildkitd.toml").write_text(text)
    assert step_network.Bridge.read(tmp_path / "buildkitd.toml") == bridge


@pytest.mark.parametrize(
    ("texts", "found"),
    [
        (["nameserver 10.0.0.1\nsearch x\nnameserver 127.0.0.1\n", "nameserver 10.0.0.2"], ["10.0.0.1"]),
        (["nameserver 127.0.0.53\noptions edns0\n", "nameserver 10.0.0.2"], ["10.0.0.2"]),
        (["nameserver 127.0.0.53\n"], []),
        (["nameserver 127.0.0.1\nnameserver ::1", "nameserver 10.0.0.2"], []),
    ],
)
def test_name_servers_of_steps(tmp_path: Path, texts: list[str], found: list[str]) -> None:
    """As BuildKit has them; without any, steps would ask Google's."""
    for number, text in enumerate(texts):
        (tmp_path / str(number)).write_text(text)
    assert step_network.nameservers(files=[str(tmp_path / str(number)) for number in range(2)]) == found


def test_steps_get_a_subnet_that_the_machine_has_no_route_to(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(step_network, "missing_packages", dict)
    monkeypatch.setattr(step_network, "plugins", lambda: Path("/plugins"))
    monkeypatch.setattr(step_network, "nameservers", lambda: ["10.0.0.1"])
    routes = "Iface Destination Gateway Flags RefCnt Use Metric Mask\neth0 00000000 0 0 0 0 0 00000000\n"
    monkeypatch.setattr(Path, "read_text", lambda self, errors="": routes)
    first = step_network.bridge(Path("/checkout"))
    assert isinstance(first, step_network.Bridge) and first != step_network.bridge(Path("/other"))
    assert len(first.name) < 16 and step_network.bridge(Path("/checkout")) == first
    route = bytes(map(int, first.subnet.split("/")[0].split(".")))[::-1].hex()
    routes += f"{first.name} {route} 0 0 0 0 0 00FFFFFF\n"
    assert step_network.bridge(Path("/checkout")) == first, "it has its own already"
    routes += f"tun0 {route} 0 0 0 0 0 00FFFFFF\n"
    other = step_network.bridge(Path("/checkout"))
    assert isinstance(other, step_network.Bridge) and other.subnet != first.subnet


@pytest.mark.parametrize(
    "why", ["without iptables", "as buildkitd does not start with a bridge", "as it reaches nothing"]
)
def test_a_builder_whose_steps_get_no_network_of_their_own_says_so(
    state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], why: str
) -> None:
    """What was tried is not tried again while the builder runs: a set-up ends no build."""
    bridge = step_network.Bridge("rosml-none", "192.0.2.0/24", state.root)
    monkeypatch.setattr(step_network, "bridge", lambda root: why if "without" in why else bridge)
    monkeypatch.setattr(step_network, "tidy", lambda left: None)
    monkeypatch.setattr(step_network, "enclose", lambda *_: why)
    monkeypatch.setattr(builder, "START_SECONDS", 1)
    ends = "'mode = \"bridge\"' in open(sys.argv[2]).read().lower()" if "start" in why else "False"
    file = state.run / "buildkitd.toml"
    command = (sys.executable, "-c", f"import sys, time; {ends} or time.sleep(60)", "--config", str(file))
    made = Daemon(state, "buildkitd", command, file, os.environ)
    monkeypatch.setattr(builder, "daemon", lambda state: made)
    for did in ("started buildkitd", "buildkitd runs"):
        builder.up(state, machine(state, "buildkitd", str(buildx)), "")
        said = capsys.readouterr().out
        assert did in said and f"network: code of a repository reaches what listens here, {why}" in said
    assert builder.stop(state) and not (state.run / "shared-network").exists()


@pytest.fixture
def buildx(state: State) -> Path:
    """A local replacement for buildx that notes its calls and keeps records of builders as buildx does."""
    return program(
        state.root / "fake",
        "buildx",
        f"""echo "$@" >>{state.root}/calls
case $1 in
  inspect) if [ -e {state.root}/broken ]; then echo no connection >&2; exit 1; fi; printf 'Name: rosml\\nStatus: running\\n' ;;
  create) mkdir -p "$BUILDX_CONFIG/instances" && echo '{RECORD}' >"$BUILDX_CONFIG/instances/$3"
    if grep -q '"bridge"' "$9" && [ -e {state.root}/crashes ]; then touch {state.root}/broken; else rm -f {state.root}/broken; fi
    [ "$5" != docker-container ] || cp "$9" {state.root}/container.toml ;;
esac""",
    )


RECORD = '{"Nodes": [{"Name": "rosml0", "Endpoint": "unix:///docker.sock"}]}'
ROUTES = "Iface Destination Gateway Flags RefCnt Use Metric Mask\neth0 00000000 0 0 0 0 0 00000000\n"
RULES = """*filter
-A INPUT -i NAME -j REJECT --reject-with icmp-port-unreachable
-A INPUT -i another -j REJECT
-A CNI-FORWARD -s NET.2/32 -j ACCEPT
*nat
-A POSTROUTING -s NET.2/32 -m comment --comment "name: \\"buildkit\\"" -j CNI-0123
"""


@pytest.fixture
def docker(state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A local replacement for Docker's client that answers for the container of a builder, and notes its calls."""
    root = state.root
    for name, text in {"lacking": "", "resolv": "nameserver 10.0.0.1\n", "routes": ROUTES, "rules": RULES}.items():
        (root / name).write_text(text)
    text = f"""echo "$@" >>{root}/docker-calls
[ "$1 $2" = "--host unix:///docker.sock" ] || exit 1
case "$3 $4 $*" in
  *"cat /proc/net/route") cat {root}/routes ;;
  *"cat /etc/resolv.conf") cat {root}/resolv ;;
  *"cat /etc/buildkit/buildkitd.toml") cat {root}/container.toml ;;
  "run "*"src=/run/systemd/resolve/resolv.conf"*) echo nameserver 10.0.0.9 ;;
  exec*"cat /run/systemd/resolve/resolv.conf") sed -n 's/^shown //p' {root}/shown ;;
  *"mkdir -p"*) printf 'shown %s' "$9" >{root}/shown ;;
  *command*) cat {root}/lacking; echo . ;;
  *pidof*) echo 31 7 ;;
  *" ls /proc/7/root/var/lib/buildkit/net/cni") echo abc ;;
  *iptables-save) cat {root}/rules ;;
  *"iptables "*" -C "*) exit 1 ;;
  *"iptables "*" -I "*) [ ! -e {root}/refused ] ;;
  *nsenter*) [ ! -e {root}/mute ] && [ ! -e {root}/offline ] ;;
  *nslookup*) [ ! -e {root}/offline ] ;;
esac"""
    program(root / "client", "docker", text)
    monkeypatch.setenv("PATH", f"{root}/client:{os.environ['PATH']}")
    return root / "docker-calls"


def docker_builder(state: State, buildx: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """What setting up a builder in Docker says."""
    builder.up(state, machine(state, "docker", str(buildx)), "moby/buildkit:v0.29.0")
    return capsys.readouterr().out


def test_steps_of_a_builder_in_docker_get_a_network_of_their_own(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert builder.SHARED not in docker_builder(state, buildx, capsys)
    toml = tomllib.loads((state.root / "container.toml").read_text())
    facts = toml["worker"]["oci"]
    assert facts["networkMode"] == "bridge" and "cniBinaryPath" not in facts, "BuildKit's image has the plugins"
    assert toml["insecure-entitlements"] == ["network.host"]
    assert "restart-policy=no" in (state.root / "calls").read_text(), "nothing would set the rules then"
    name, subnet = facts["bridgeName"], facts["bridgeSubnet"]
    inside = "--host unix:///docker.sock exec buildx_buildkit_rosml0"
    called = docker.read_text()
    assert f"{inside} iptables -w 5 -t filter -I INPUT -i {name} -j REJECT\n" in called
    assert f"{inside} iptables -w 5 -t mangle -I FORWARD -i {name} -p tcp" in called
    assert f"/proc/sys/net/ipv6/conf/{name}/disable_ipv6\n" in called
    assert (
        f"{inside} nsenter --net=/proc/7/root/var/lib/buildkit/net/cni/abc sh -c" in called and "sh 10.0.0.1" in called
    )
    docker.unlink()
    (state.root / "calls").unlink()
    docker_builder(state, buildx, capsys)
    assert (state.root / "calls").read_text().splitlines() == ["inspect --bootstrap rosml", "inspect rosml"]
    assert f"-I INPUT -i {name} -j REJECT" in docker.read_text(), "rules do not outlive the machine"
    (state.root / "offline").touch()
    assert builder.SHARED not in docker_builder(state, buildx, capsys), "nothing says that it is the bridge"
    net = subnet.removesuffix(".0/24")
    (state.root / "rules").write_text(RULES.replace("NAME", name).replace("NET", net))
    docker.unlink()
    machine(state, "docker", str(buildx)).save()
    assert services.down(state) == ["builder in Docker"]
    beside = "run --rm --privileged --userns=host --network=host --pull=never --entrypoint=env moby/buildkit:v0.29.0"
    *_save, tidied = docker.read_text().splitlines()
    assert tidied == f"--host unix:///docker.sock {beside} sh -c " + "; ".join(
        [
            f"iptables -w 5 -t filter -D INPUT -i {name} -j REJECT --reject-with icmp-port-unreachable",
            f"iptables -w 5 -t filter -D CNI-FORWARD -s {net}.2/32 -j ACCEPT",
            f"iptables -w 5 -t nat -D POSTROUTING -s {net}.2/32 -m comment --comment 'name: \"buildkit\"' -j CNI-0123",
            "iptables -w 5 -t nat -F CNI-0123",
            "iptables -w 5 -t nat -X CNI-0123",
            f"ip link delete {name}",
        ]
    ), "and no rule of others"


@pytest.mark.parametrize(
    ("blocks", "free", "available", "limits"),
    [
        (1000, 500, 500, (40, 12)),
        (1000, 60, 60, (30, 12)),
        (1000, 15, 15, (20, 12)),
        (1000, 110, 60, (30, 62)),  # 50 GB that only root may use: BuildKit counts them as free
    ],
)
def test_the_cache_leaves_half_of_the_disk_to_others(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    blocks: int,
    free: int,
    available: int,
    limits: tuple[int, int],
) -> None:
    """Once: what others take later starts no builder again."""
    size = {"f_frsize": 1_000_000_000, "f_blocks": blocks, "f_bfree": free, "f_bavail": available}
    monkeypatch.setattr(os, "statvfs", lambda _: SimpleNamespace(**size))
    file = tmp_path / "buildkitd.toml"
    first = CacheLimits.kept(file, tmp_path)
    assert (first.used, first.free) == limits
    file.write_text(builder.config("127.0.0.1:5001", False, limits=first))
    size |= {"f_bfree": 10, "f_bavail": 10}
    assert CacheLimits.kept(file, tmp_path) == first


@pytest.mark.parametrize(
    ("file", "text", "why"),
    [
        ("lacking", "iptables\nnslookup\n", "as its image is without iptables, nslookup"),
        ("resolv", "nameserver 127.0.0.1\n", "as its name server answers on loopback alone"),
        ("refused", "", "as iptables refuses a rule"),
        ("mute", "", "as they reach no name server from one of their own"),
        ("offline", "", "as they reach no name server from one of their own"),
        ("crashes", "", "as it does not start with a bridge"),
        ("client/docker", "#!/bin/sh\nexit 1\n", "as docker cannot enter its container"),
    ],
)
def test_a_builder_in_docker_whose_steps_get_none_is_as_before(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str], file: str, text: str, why: str
) -> None:
    """What was tried is not tried again until it is made anew, or stopped."""
    (state.root / file).write_text(text)
    line = f"builder: {builder.SHARED}, {why}\n"
    assert line in docker_builder(state, buildx, capsys)
    limits = CacheLimits.kept(state.root / "container.toml", state.root)
    assert (state.root / "container.toml").read_text() == "# moby/buildkit:v0.29.0\n" + builder.config(
        "127.0.0.1:5001", False, limits=limits
    )
    assert "restart-policy" not in (state.root / "calls").read_text().splitlines()[-2]
    docker.unlink(missing_ok=True)
    assert line in docker_builder(state, buildx, capsys)
    assert not docker.exists()
    machine(state, "docker", str(buildx)).save()
    services.down(state)
    for name in ("refused", "mute", "offline", "crashes", "broken"):
        (state.root / name).unlink(missing_ok=True)
    again = docker_builder(state, buildx, capsys)
    assert (line in again) == (file not in ("refused", "mute", "offline", "crashes"))


def test_steps_in_docker_ask_the_servers_of_systemd_resolved(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its own file is not in a container."""
    (state.root / "resolv").write_text("nameserver 127.0.0.53\n")
    assert builder.SHARED not in docker_builder(state, buildx, capsys)
    assert (state.root / "shown").read_text().strip() == "shown nameserver 10.0.0.9"
    assert "nsenter" in (called := docker.read_text()) and "sh 10.0.0.9\n" in called


def test_a_bridge_in_docker_moves_if_another_network_takes_its_subnet(
    state: State, buildx: Path, docker: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    docker_builder(state, buildx, capsys)
    first = step_network.Bridge.read(state.root / "container.toml")
    assert first
    route = bytes(map(int, first.subnet.split("/")[0].split(".")))[::-1].hex()
    (state.root / "routes").write_text(f"{ROUTES}br-0 {route} 0 0 0 0 0 00FFFFFF\n")
    assert builder.SHARED not in docker_builder(state, buildx, capsys)
    second = step_network.Bridge.read(state.root / "container.toml")
    assert second and second.name == first.name and second.subnet != first.subnet


def test_builder_in_docker(state: State, buildx: Path) -> None:
    docker = machine(state, "docker", str(buildx))
    other = machine(state, "docker", str(buildx), "127.0.0.1:5002")
    calls = state.root / "calls"
    builder.up(state, docker, "moby/buildkit:v0.29.0")
    assert calls.read_text().splitlines() == [
        "rm --force --keep-state rosml",
        "create --name rosml --driver docker-container --driver-opt network=host,image=moby/buildkit:v0.29.0"
        f" --buildkitd-config {state.run}/buildkitd-docker.new.toml",
        "inspect --bootstrap rosml",
    ]
    calls.unlink()
    builder.up(state, docker, "moby/buildkit:v0.29.0")
    assert calls.read_text().splitlines() == ["inspect --bootstrap rosml"]
    builder.up(state, other, "moby/buildkit:v0.29.0")
    assert "create" in calls.read_text(), "a new port of the registry needs a new configuration"
    (state.root / "broken").touch()
    with pytest.raises(RosmlError, match="no connection"):
        builder.up(state, other, "moby/buildkit:v0.29.0")


def test_builder_in_docker_is_stopped(state: State, buildx: Path) -> None:
    for remove, action in ((False, "stop rosml"), (True, "rm --force rosml")):
        machine(state, "docker", str(buildx)).save()
        assert services.down(state, remove) == ["builder in Docker"]
        assert (state.root / "calls").read_text().splitlines()[-1] == action
        assert not (state.folder / "services.json").exists()


def test_builder_of_the_user(state: State, buildx: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("BUILDX_CONFIG", raising=False)
    user = machine(state, "user", str(buildx))
    builder.up(state, user, "")
    assert (state.root / "calls").read_text() == "inspect --bootstrap rosml\n"
    (state.root / "broken").touch()
    with pytest.raises(RosmlError, match="BUILDX_BUILDER=rosml") as caught:
        builder.up(state, user, "")
    assert "unset BUILDX_BUILDER" in caught.value.remedy


def test_a_builder_that_answers_is_not_cut_off(tmp_path: Path) -> None:
    """Its record is lost, or tells of another folder: somebody may be building with it."""
    state = State(tmp_path / ".state")
    address = state.socket("buildkitd.sock")
    state.prepare_socket(address)
    address.unlink(missing_ok=True)  # of a killed test: its folder is named after a path that comes again
    state.run.mkdir(parents=True, exist_ok=True)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(str(address))
        server.listen()
        with pytest.raises(RosmlError, match="another buildkitd answers") as caught:
            builder.up(state, machine(state, "buildkitd"), "")
        assert "pkill buildkitd" in caught.value.remedy
        assert address.exists()
    shutil.rmtree(state.short_run, ignore_errors=True)


def test_own_builder_in_a_path_that_overlays_cannot_have(tmp_path: Path) -> None:
    state = State(tmp_path / "a:b")
    with pytest.raises(RosmlError, match="overlay"):
        builder.up(state, machine(state, "buildkitd"), "")


def test_services_json(state: State) -> None:
    services = machine(state, "buildkitd")
    services.save()
    assert json.loads((state.folder / "services.json").read_text()) == {
        "registry": "127.0.0.1:5001",
        "buildx": ["buildx"],
        "builder": "rosml",
        "builder_kind": "buildkitd",
        "buildx_config": str(state.folder / "buildx"),
        "uv": "/uv",
        "ca_bundle": "",
        "bases": [],
    }
    assert Services.load(state.root) == services


def test_build_steps_of_a_killed_builder_are_known(monkeypatch: pytest.MonkeyPatch) -> None:
    text = (
        "126 72 0:52 / / rw - overlay overlay rw,lowerdir=/a\\040b/.state/buildkit/x/3,upperdir=/y\n"
        "127 126 0:55 / /proc rw - proc proc rw\n"
    )
    monkeypatch.setattr(Path, "read_text", lambda self, errors="": text)
    assert builder.is_build_step(1, Path("/a b/.state/buildkit"))
    assert not builder.is_build_step(1, Path("/a/.state/buildkit"))
    assert not builder.is_build_step(1, Path("/a b/.state/build"))


def test_no_other_process_is_a_build_step(state: State) -> None:
    assert not builder.is_build_step(os.getpid(), state.folder / "buildkit")
    assert not builder.is_build_step(2**22 + 1, state.folder / "buildkit")


# ---- processes --------------------------------------------------------------------------------------------------------
def test_run_shows_signs_of_life(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(process, "HEARTBEAT_SECONDS", 0.1)
    process.run(print, process.Call("nap", ["sleep", "0.25"], tmp_path / "log"))
    assert "  nap: still at work (0.1 s)\n" in capsys.readouterr().out


def test_run_of_a_missing_program(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match="cannot run nothing-like-this"):
        process.run(print, process.Call("x", ["nothing-like-this"], tmp_path / "log"))


def test_interrupt_ends_what_runs(tmp_path: Path) -> None:
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        argv = ["sh", "-c", f"sleep 60 & echo $! >{tmp_path}/pid; wait"]
        process.run(print, process.Call("nap", argv, tmp_path / "log"))
    child = int((tmp_path / "pid").read_text())
    assert wait_until(lambda: command_line(child) == (), 5.0)  # it was told at the same time as its parent


def test_interrupt_waits_for_what_must_not_be_torn(tmp_path: Path) -> None:
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        argv = ["sh", "-c", f"sleep 0.6; touch {tmp_path}/done"]
        process.run(print, process.Call("dpkg", argv, tmp_path / "log", finish_on_interrupt=True))
    assert (tmp_path / "done").exists()


# ---- commands -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("typed", [["status", "--json"], []])
def test_a_call_by_people_begins_with_uv_and_packages(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: list[str]
) -> None:
    def become(_program: str, argv: list[str]) -> None:
        called.extend(argv)
        raise SystemExit

    called: list[str] = []
    monkeypatch.setattr(commands, "PROGRAM", (sys.executable, str(tmp_path / "scripts/bootstrap.py")))
    monkeypatch.setattr(os, "execv", become)
    monkeypatch.delenv(commands.UV, raising=False)
    monkeypatch.setattr(sys, "argv", ["rosml", "setup", *typed])
    CliRunner().invoke(main.cli, ["setup", *typed], catch_exceptions=False)
    assert called == [sys.executable, str(tmp_path / "scripts/bootstrap.py"), *(typed or ["up"])]


def test_help_has_an_example() -> None:
    """Each is one that the parser reads."""
    said = CliRunner().invoke(main.cli, ["setup", "--help"]).output.partition("Examples:\n")[2].partition("\n\n")[0]
    assert len(said.splitlines()) > 1
    for line in said.splitlines():
        accepted(commands.main, line.split()[2:] or ["up"])


def test_status_after_the_services_died(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    machine(state, "buildkitd", "/nowhere/buildx", "127.0.0.1:1").save()
    said = call(state, monkeypatch, "status")
    assert said.count("DOES NOT ANSWER (rosml setup)") == 2
    facts = json.loads(call(state, monkeypatch, "status", "--json"))
    assert (facts["up"], facts["registry"], facts["docker_hub"]) == (
        True,
        {"address": "127.0.0.1:1", "answers": False},
        True,
    )


@pytest.mark.parametrize(("word", "says"), [("down", "nothing was running\n"), ("clean", "")])
def test_down_where_nothing_runs(state: State, monkeypatch: pytest.MonkeyPatch, word: str, says: str) -> None:
    (state.folder / "services.json").write_text("{")
    assert call(state, monkeypatch, word) == says
    assert not (state.folder / "services.json").exists()


def test_mount_points_are_read_as_the_kernel_writes_them(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "overlay /a\\040b/.state/buildkit/x overlay rw 0 0\nproc /proc proc rw 0 0\n"
    monkeypatch.setattr(Path, "read_text", lambda self: text)
    assert builder.mounted_below(Path("/a b/.state")) == ["/a b/.state/buildkit/x"]


# ---- CI -------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("where", ["", "self-hosted", "github-hosted"])
def test_room_is_made_on_githubs_machines_only(
    state: State, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    big = tmp_path / "android"
    (big / "sdk").mkdir(parents=True)
    program(tmp_path / "bin", "sudo", 'exec "$@"')
    monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=os.pathsep)
    monkeypatch.setenv("RUNNER_ENVIRONMENT", where)
    monkeypatch.setattr(commands, "PREINSTALLED", (str(big), str(tmp_path / "nowhere")))
    call(state, monkeypatch, "room")
    assert big.exists() == (where != "github-hosted")


def test_later_steps_of_a_job_find_the_tools(state: State, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GITHUB_PATH", raising=False)
    Installer(state).report()
    monkeypatch.setenv("GITHUB_PATH", str(tmp_path / "path"))
    Installer(state).report()
    assert (tmp_path / "path").read_text() == f"{state.bin}\n"
