"""Programs that setup finds or builds: their pins, Go's builds, the cache of all checkouts, Debian packages."""

from __future__ import annotations

import os
import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.setups import go_module, new_state, program
from rosml.base import programs
from rosml.base.errors import RosmlError
from rosml.machine import docker
from rosml.machine.docker import Docker
from rosml.machine.setup import installer, process, step_network, tools
from rosml.machine.setup.daemon import command_line, wait_until
from rosml.machine.setup.installer import Installer
from rosml.machine.setup.state import State
from rosml.machine.setup.tool_cache import ToolCache


@pytest.fixture
def state(tmp_path: Path) -> State:
    return new_state(tmp_path)


# ---- Pins ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", installer.GO_PROGRAMS)
def test_every_go_program_is_pinned(name: str) -> None:
    module = ROOT / "tools" / "go" / name
    pin = programs.parse_pin((module / "go.mod").read_text())
    assert re.fullmatch(r"v\d+\.\d+\.\d+(-beta\.\d+|\+incompatible)?", pin.version)
    direct = re.search(r"^require (\S+) v", (module / "go.mod").read_text(), re.MULTILINE)
    root = direct[1] if direct and pin.package == "." else pin.package.split("/cmd/")[0]
    assert f"{root} {pin.version} h1:" in (module / "go.sum").read_text()


def test_the_local_registry_links_no_cloud() -> None:
    """The stock program links three clouds' drivers: twice the code to fetch, compile and link, for a local folder."""
    pins = (ROOT / "tools/go/registry/go.sum").read_text().lower()
    assert not {word for word in ("aws-sdk", "azure", "cloud.google.com", "oauth2") if word in pins}


PINNED = """module x.invalid/tools

go 1.26.8

tool example.org/a/v3/cmd/a

require (
\texample.org/a v1.0.0 // indirect
\texample.org/a/v3 v3.1.2 // indirect
\texample.org/b v0.1.0 // indirect
)
"""


def test_the_pin_of_a_program() -> None:
    assert programs.parse_pin(PINNED) == programs.Pin("example.org/a/v3/cmd/a", "v3.1.2")
    ours = "module x.invalid/tools\n\nrequire example.org/a/v3 v3.1.2\n\nrequire (\n\texample.org/b v0.1.0 // indirect\n)\n"
    assert programs.parse_pin(ours) == programs.Pin(".", "v3.1.2")
    for text in ("", "tool example.org/a/cmd/a\n"):
        with pytest.raises(ValueError, match=r"tool|module"):
            programs.parse_pin(text)


# ---- Tools -----------------------------------------------------------------------------------------------------------


def test_a_tool_on_path_is_used_if_it_is_new_enough(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    path = program(state.root / "mine", "regctl", "echo VCSTag: v0.11.9")
    program(state.bin, "regctl", "echo v9.9.9")
    monkeypatch.setenv("PATH", f"{state.bin}:{path.parent}")
    installer = Installer(state)
    assert installer.on_path("regctl", "version", (0, 11)) == str(path), "our own folder does not count"
    assert installer.on_path("regctl", "version", (0, 12)) is None
    assert installer.have == ["regctl v0.11.9 (found on PATH)"]


@pytest.mark.parametrize(("version", "used"), [("0.65.0", True), ("0.64.9", False), ("0.66.0", False), ("dev", False)])
def test_a_tool_on_path_has_the_pinned_version(
    state: State, monkeypatch: pytest.MonkeyPatch, version: str, used: bool
) -> None:
    """Neither older nor newer, for a scanner: findings must not depend on the machine."""
    go_module(state, "trivy", "v0.65.0")
    path = program(state.root / "mine", "trivy", f"echo Version: {version}; echo Vulnerability DB:; echo Version: 2")
    monkeypatch.setenv("PATH", f"{path.parent}:/usr/bin:/bin")
    assert Installer(state).on_path("trivy", "--version") == (str(path) if used else None)


@pytest.fixture
def bare(state: State, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout on a machine that has local replacements for Go and apt, which write their calls into a file, and nothing else."""
    calls = state.root / "calls"
    for name in installer.GO_PROGRAMS:
        go_module(state, name)
    script = f"""case $1 in
  version) echo go version go1.26.8 linux/amd64 ;;
  mod) echo "fetch $(basename $PWD)" >>{calls} ;;
  build) echo "build $(basename $PWD)" >>{calls}; mkdir -p $GOCACHE; while [ "$1" != -o ]; do shift; done; echo >"$2"; chmod +x "$2" ;;
esac"""
    folder = program(state.root / "mine", "go", script).parent
    program(folder, "apt-get", f'case $* in *install*) echo "apt ${{*##*recommends }}" >>{calls} ;; esac')
    for name in ("sh", "basename", "mkdir", "rm", "chmod"):
        os.symlink(str(shutil.which(name)), folder / name)
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setattr(
        installer, "which_system", lambda name: str(folder / name) if (folder / name).exists() else None
    )
    for module in (tools, step_network):
        monkeypatch.setattr(module, "which_system", installer.which_system)
    monkeypatch.setattr(step_network, "FOLDERS", ())
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    return calls


@pytest.mark.parametrize("tests", [False, True])
def test_setup_of_a_bare_machine(state: State, bare: Path, capsys: pytest.CaptureFixture[str], tests: bool) -> None:
    """One call of apt for what must be there, each program built once, without those that take minutes, and Go's caches dropped after the last of them."""
    services = tools.install(state, hub=False, tests=tests)
    calls = bare.read_text().splitlines()
    names = sorted(["actionlint", "composecheck", "regctl"] * tests + ["buildkitd", "buildx", "registry"])
    assert sorted(call for call in calls if call.startswith("build ")) == [f"build {name}" for name in names]
    for_tests = " docker.io chromium" if tests else ""
    assert [call for call in calls if call.startswith("apt ")] == [
        f"apt runc mmdebstrap{for_tests}",
        "apt containernetworking-plugins iptables",  # without them the builder works as well
    ]
    assert not (state.folder / "go").exists()
    assert services.buildx == (str(state.bin / "buildx"),)
    assert (services.uv, services.registry, bool(services.bases)) == ("/uv", "", True)
    output = capsys.readouterr().out
    assert "in the background" in output and "installs the Debian packages runc (" in output
    bare.unlink()
    tools.install(state, hub=False, tests=tests)
    assert not [call for call in bare.read_text().splitlines() if call.startswith(("build ", "fetch "))]


def test_an_engine_that_was_built_serves_the_tests_of_other_checkouts(state: State, bare: Path) -> None:
    tools.build_engine(Installer(state))
    built = [f"build {name}" for name in installer.ENGINE]
    assert [call for call in bare.read_text().splitlines() if call.startswith("build ")] == built
    other = replace(state, root=state.root / "other")
    shutil.copytree(state.root / "tools", other.root / "tools")
    for folder in (other.bin, other.log, other.run):
        folder.mkdir(parents=True)
    tools.install(other, hub=False)
    assert not (other.folder / "engine").exists(), "only tests need it"
    bare.unlink()
    tools.install(other, hub=False, tests=True)
    assert {file.name for file in (other.folder / "engine").iterdir() if file.suffix != ".pin"} == {*installer.ENGINE}
    assert not {*built} & {*bare.read_text().splitlines()}


DOCKER = """\
if [ "$1" = info ]; then echo '{{"ServerVersion": "29.9.3"}}'; exit; fi
for word; do case $word in
  --output=*) dest=${{word##*dest=}} ;;
  --file=*) cat "${{word#--file=}}" >{folder}/Dockerfile ;;
esac; done
echo "$@" >{folder}/words; mkdir -p "$dest"; echo >"$dest/program"
"""


def test_without_go_docker_builds_a_program(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its image is pinned, and the user's proxy for modules counts, whose password stays out of files."""
    go_module(state, "registry")
    shutil.copy(ROOT / "tools/images.txt", state.root / "tools")
    client = program(state.root / "mine", "docker", DOCKER.format(folder=state.root))
    monkeypatch.setenv("PATH", f"{client.parent}:/usr/bin:/bin")
    monkeypatch.setenv("GOPROXY", "https://me:pw-of-proxy@proxy.example")
    monkeypatch.setattr(Installer, "go_path", lambda self: "/nowhere")
    assert Path(Installer(state).go_program("registry")).read_text() == "\n"
    text = (state.root / "Dockerfile").read_text()
    assert re.match(r"FROM golang:\S+@sha256:[0-9a-f]{64} AS build\nARG GOPROXY\n", text)
    assert "--build-arg GOPROXY" in (state.root / "words").read_text() and "pw-of-proxy" not in text
    assert not list(state.folder.glob("tmp*"))


def test_missing_rights_are_reported_before_minutes_of_compiling(
    state: State, bare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(tools, "choose_builder", lambda installer, hub, unfit: tools.Choice("docker", "rosml"))
    with pytest.raises(RosmlError, match=r"docker\.io .*chromium .*only root may") as caught:
        tools.install(state, hub=True, tests=True)
    command = "apt-get update && apt-get install --no-install-recommends docker.io chromium"
    assert caught.value.remedy == f"sudo sh -c '{command}'"
    assert not bare.exists()


def test_a_failure_of_apt_ends_the_setup(state: State, bare: Path) -> None:
    program(state.root / "mine", "apt-get", "echo no mirror >&2; exit 2")
    with pytest.raises(RosmlError, match=r"(?s)apt-get update: failed.*no mirror"):
        tools.install(state, hub=True)


@pytest.mark.parametrize(("answers", "installed"), [(True, ["google-chrome"]), (False, ["dockerd", "chromium"])])
def test_packages_of_the_tests_that_are_installed(
    state: State, monkeypatch: pytest.MonkeyPatch, answers: bool, installed: list[str]
) -> None:
    monkeypatch.setattr(docker, "ask", lambda program: Docker("" if answers else "Docker does not answer"))
    monkeypatch.setattr(tools, "which_system", lambda name: name if name in installed else None)
    assert not tools.engine_packages(Installer(state)) and not tools.browser_packages()


def test_no_apt(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installer, "which_system", lambda name: None)
    with pytest.raises(RosmlError, match="no apt-get"):
        Installer(state).debian_packages({"chromium": "opens a page"})


def test_modules_are_fetched_in_the_background_and_no_longer_than_they_are_needed(state: State, go: Path) -> None:
    began = state.root / "began"
    program(go.parent, "go", f"case $1 in version) echo go1.26.8 ;; mod) echo $$ >{began}; exec sleep 60 ;; esac")
    with Installer(state).fetching(["regctl"]):
        assert wait_until(lambda: began.exists() and bool(began.read_text()), 20)
        pid = int(began.read_text())
        # between the shell and sleep, a process has no command line
        assert wait_until(lambda: "sleep" in command_line(pid), 10)
    assert wait_until(lambda: not command_line(pid), 10), "a signal takes a moment"


@pytest.fixture
def go(state: State, monkeypatch: pytest.MonkeyPatch) -> Path:
    go_module(state, "regctl")
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
    second = Installer(state)
    second.go_program("regctl")
    assert second.have == ["regctl v1.2.3"]


def test_another_checkout_takes_a_go_tool(state: State, go: Path, tmp_path: Path) -> None:
    Installer(state).go_program("regctl")
    other = replace(state, root=tmp_path / "other")
    other.bin.mkdir(parents=True)
    (other.root / "tools").symlink_to(state.root / "tools")
    go.unlink()
    installer = Installer(other)
    path = Path(installer.go_program("regctl"))
    assert path.parent == other.bin and "readonly" in path.read_text() and os.access(path, os.X_OK)
    assert installer.have == ["regctl v1.2.3 (built for another checkout)"] and installer.is_built("regctl")
    (cached,) = (state.cache / "tools").iterdir()
    assert re.fullmatch(r"regctl-v1\.2\.3-[0-9a-f]{16}-\w+", cached.name)


@pytest.mark.parametrize(
    "wrong", ["writable", "link", "another's folder", "a folder behind a link", "empty", "other pins"]
)
def test_a_go_tool_that_somebody_else_may_have_put_there_is_not_taken(
    state: State, go: Path, wrong: str, tmp_path: Path
) -> None:
    Installer(state).go_program("regctl")
    (cached,) = (state.cache / "tools").iterdir()
    cached.write_text("evil")
    if wrong == "writable":
        cached.chmod(0o775)
    elif wrong == "link":
        cached.rename(tmp_path / "evil")
        cached.symlink_to(tmp_path / "evil")
    elif wrong == "another's folder":
        cached.parent.chmod(0o777)
    elif wrong == "a folder behind a link":
        cached.parent.rename(tmp_path / "elsewhere")
        cached.parent.symlink_to(tmp_path / "elsewhere")
    elif wrong == "empty":
        cached.write_text("")
    else:
        (state.root / "tools/go/regctl/go.sum").write_text("changed")
    (state.bin / "regctl").unlink()
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_cache_that_cannot_be_written_loses_nothing(state: State, go: Path) -> None:
    state.cache.write_text("no folder")
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_go_tool_that_nobody_takes_any_more_goes(state: State, go: Path) -> None:
    cache = ToolCache(state.cache / "tools")
    unused, recent = (
        program(cache.folder, name, "") for name in (f"regctl-v1-{16 * '0'}-x86", f"regctl-v2-{16 * '0'}-x86")
    )
    foreign = program(cache.folder, "my-thesis.tex", "")
    for path in (unused, foreign):
        os.utime(path, (0, 0))
    Installer(state).go_program("regctl")
    assert not unused.exists() and recent.exists() and foreign.exists()


@pytest.mark.parametrize("changed", ["go.sum", "main.go"])
def test_a_go_tool_is_built_again_if_a_pin_changes(state: State, go: Path, changed: str) -> None:
    Installer(state).go_program("regctl")
    (state.root / "tools/go/regctl" / changed).write_text("changed")
    (state.bin / "regctl").write_text("old")
    assert "readonly" in Path(Installer(state).go_program("regctl")).read_text()


def test_a_failed_build_shows_the_log_and_leaves_no_tool(state: State, go: Path) -> None:
    program(go.parent, "go", "[ $1 = version ] && echo go1.26.8 && exit 0; seq 100; echo no such module >&2; exit 3")
    with pytest.raises(RosmlError, match=r"(?s)exit code 3.*no such module.*build-regctl\.log") as caught:
        Installer(state).go_program("regctl")
    assert len(caught.value.message.splitlines()) == process.TAIL_LINES + 2
    assert not (state.bin / "regctl").exists()


@pytest.mark.parametrize(
    ("text", "reason"), [("", "not installed"), ("echo go version go1.19.8 linux/amd64", "too old")]
)
def test_no_go(state: State, go: Path, monkeypatch: pytest.MonkeyPatch, text: str, reason: str) -> None:
    go.unlink()
    which = shutil.which
    monkeypatch.setattr(shutil, "which", lambda name, path: which(name, path=str(go.parent)))
    if text:
        program(go.parent, "go", text)
    with pytest.raises(RosmlError, match=reason) as caught:
        Installer(state).go_program("regctl")
    assert "install Docker, or Go" in caught.value.remedy


def test_go_build_needs_disk(state: State, go: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installer, "BUILD_BYTES", 10**18)
    with pytest.raises(RosmlError, match="of disk are free"):
        Installer(state).go_program("regctl")
