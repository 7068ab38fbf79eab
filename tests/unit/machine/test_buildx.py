"""One call of `buildx bake`: what it is told, what becomes of its answer, and what its failures say."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.http_registry import local_registry
from fakes.stubs import buildx, calls, services
from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.machine import buildx as builder
from rosml.machine.buildx import Bake
from rosml.machine.progress import BuildProgress
from rosml.machine.services import Services
from rosml.registry import retries
from rosml.registry.client import Registry

NAME = "[a ros 1/2] RUN --mount=type=secret,id=ca-bundle /run/components/ros/install.sh ros-core"
DAY = "2026-11-21T11:03:"


def vertex(name: str = NAME, **facts: Any) -> str:
    return json.dumps({"vertexes": [{"digest": name, "name": name, "started": f"{DAY}10.123456789Z", **facts}]})


def prints(data: str, name: str = NAME) -> str:
    """A line of rawjson with what a step prints; `data` is base64."""
    return json.dumps({"logs": [{"vertex": name, "stream": 2, "data": data}]})


def says(*lines: str, code: int = 0) -> str:
    return "cat >&2 <<'END'\n" + "\n".join(lines) + f"\nEND\nexit {code}"


@pytest.fixture(scope="module")
def registry() -> Iterator[str]:
    with local_registry() as server:
        yield server.address


@pytest.fixture
def bake(tmp_path: Path) -> Bake:
    return Bake("a", "build-a", tmp_path / "docker-bake.hcl")


def having(tmp_path: Path, registry: str, text: str, **changes: Any) -> Services:
    return services(tmp_path, registry, buildx=buildx(tmp_path, text), **changes)


# ---- What buildx is told ---------------------------------------------------------------------------------------------


def test_command(tmp_path: Path) -> None:
    call = Bake("a", "build-a", Path("x.hcl"), sets=("a.tags=", "a.output=type=image"))
    words = ["--file", "x.hcl", "--progress", "rawjson", "--metadata-file", "m.json"]
    sets = ["--set", "a.tags=", "--set", "a.output=type=image"]
    buildx = services(tmp_path, buildx=["docker", "buildx"])
    assert builder.command(buildx, call, Path("m.json")) == ["docker", "buildx", "bake", *words, *sets, "a"]
    bundled = replace(buildx, ca_bundle="/ca.pem")
    assert "--allow fs.read=/ca.pem" in " ".join(builder.command(bundled, call, Path("m.json")))
    assert builder.environment(bundled, call)["CA_BUNDLE"] == "/ca.pem"


def test_environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("HTTP_PROXY", "HTTPS_PROXY", "https_proxy"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("http_proxy", "http://small")
    call = Bake("a", "build-a", Path("x.hcl"), variables={"REGISTRY": "127.0.0.1:1/rosml"})
    env = builder.environment(services(tmp_path), call)
    assert (env["HTTP_PROXY"], env["HTTPS_PROXY"]) == ("http://small", "")
    assert (env["REGISTRY"], env["BUILDX_BUILDER"]) == ("127.0.0.1:1/rosml", "rosml")
    assert (env["BUILDX_NO_DEFAULT_ATTESTATIONS"], env["CA_BUNDLE"]) == ("1", "")
    monkeypatch.setenv("HTTP_PROXY", "http://large")
    assert builder.environment(services(tmp_path), call)["HTTP_PROXY"] == "http://large"


def test_mirrors_reach_the_build_and_a_shells_own_variables_do_not(
    tmp_path: Path, bake: Bake, monkeypatch: pytest.MonkeyPatch
) -> None:
    mirrors = {"ROS_APT_MIRROR": "http://mirror:1", "OS_APT_MIRROR": "http://mirror:2"}
    of_the_shell = {"OS_BOOKWORM", "OS_TYPE", "PLATFORM", "SOURCE_DATE_EPOCH", "REVISION"}
    for name in {*mirrors} | of_the_shell:
        monkeypatch.setenv(name, mirrors.get(name, "x"))
    env = builder.environment(services(tmp_path), bake)
    assert {name: env[name] for name in mirrors} == mirrors
    assert not of_the_shell & env.keys()


@pytest.mark.parametrize(
    ("address", "here"),
    [
        ("http://user:pw@localhost:3142/debian", True),
        ("http://[::1]:3142", True),
        ("127.0.0.1:3128", True),
        (f"http://{socket.gethostname()}", True),
        ("http://192.0.2.77:3142", False),
        ("http://[", False),
    ],
)
def test_steps_have_the_network_of_the_machine_if_a_mirror_is_on_it(
    tmp_path: Path, bake: Bake, monkeypatch: pytest.MonkeyPatch, address: str, here: bool
) -> None:
    for name in (*web.PROXIES, "STEP_NETWORK"):
        monkeypatch.setenv(name, "")
    monkeypatch.setenv("OS_APT_MIRROR", address)
    ours, theirs = services(tmp_path), services(tmp_path, builder_kind="user")
    assert builder.local_servers(ours) == ["OS_APT_MIRROR"] * here
    assert builder.environment(ours, bake)["STEP_NETWORK"] == "host" * here
    assert ("network.host" in builder.command(ours, bake, Path("m.json"))) is here
    assert builder.local_servers(services(tmp_path, builder_kind="docker")) == builder.local_servers(ours)
    assert "network.host" not in builder.command(theirs, bake, Path("m.json"))
    monkeypatch.setenv("OS_APT_MIRROR", "")
    monkeypatch.setenv("https_proxy", address)
    assert builder.local_servers(ours) == ["https_proxy"] * here


# ---- What becomes of its answer --------------------------------------------------------------------------------------


def test_build(tmp_path: Path, registry: str, bake: Bake, capsys: pytest.CaptureFixture[str]) -> None:
    digest = '{"a": {"containerimage.digest": "sha256:1", "containerimage.descriptor": {}, "n": 1}, "b": {}}'
    text = f"echo '{digest}' >$metadata\n" + says(vertex(), prints("aGVsbG8K"), vertex(completed=f"{DAY}12.623456789Z"))
    progress, metadata = builder.run(having(tmp_path, registry, text), bake)
    assert metadata == {"containerimage.digest": "sha256:1"}
    assert [step.seconds for step in progress.steps.values()] == [pytest.approx(2.5)]
    assert "2.5 s  [a ros 1/2] /run/components/ros/install.sh ros-core" in capsys.readouterr().err
    log = (tmp_path / ".state/log/build-a.log").read_text()
    assert log.startswith(f"$ {tmp_path}/buildx bake --file {tmp_path}/docker-bake.hcl --progress rawjson")
    assert "\n    hello\n" in log
    assert f"2.5 s {NAME}\n" in log


def test_runs_in_the_checkout_with_no_input(tmp_path: Path, registry: str, bake: Bake) -> None:
    text = 'printf \'{"a":{"cwd":"%s","input":"%s","builder":"%s"}}\' "$PWD" "$(cat)" "$BUILDX_BUILDER" >$metadata'
    _, metadata = builder.run(having(tmp_path, registry, text), bake)
    assert metadata == {"cwd": str(tmp_path), "input": "", "builder": "rosml"}


@pytest.mark.parametrize("kind", ["docker", "engine"])
def test_builds_that_share_steps_take_turns(
    tmp_path: Path,
    registry: str,
    bake: Bake,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    kind: str,
) -> None:
    """Two checkouts, one builder: each build has ended before the next one begins. All have Docker's own."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    bake = replace(bake, shares="parts")
    roots = [tmp_path / name for name in ("one", "other")]

    def build(root: Path) -> None:
        text = f"echo begin >>{tmp_path}/order; sleep 0.3; echo end >>{tmp_path}/order"
        config = root if kind == "engine" else tmp_path / "buildx-config"
        builder.run(having(root, registry, text, buildx_config=str(config), builder_kind=kind), bake)

    before = builder.waited()
    for root in roots:
        root.mkdir()
    threads = [threading.Thread(target=build, args=(root,)) for root in roots]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (tmp_path / "order").read_text().split() == ["begin", "end"] * 2
    output = capfd.readouterr().err
    (line,) = [line for line in output.splitlines() if "waiting for another build in builder 'rosml'" in line]
    assert re.search(rf"\(process {os.getpid()}, which began \d+ s ago: rosml", line), line
    assert output.count("this one begins") == 1, "the end of the wait is seen as well"
    assert 0.1 < builder.waited() - before < 30, "a summary says how long it was"


def test_builds_that_share_nothing_run_side_by_side(tmp_path: Path, registry: str, bake: Bake) -> None:
    shared, roots = tmp_path / "buildx-config", [tmp_path / name for name in ("one", "other", "part")]
    wait = f"touch {{}}; while [ $(ls {tmp_path}/begun-* | wc -l) != 3 ]; do sleep 0.05; done"

    def build(root: Path) -> None:
        text = f"timeout 20 sh -c '{wait.format(tmp_path / f'begun-{root.name}')}'"
        machine = having(root, registry, text, buildx_config=str(shared))
        builder.run(machine, replace(bake, shares="parts" if root.name == "part" else ""))

    for root in roots:
        root.mkdir()
    with ThreadPoolExecutor(len(roots)) as pool:
        assert len([*pool.map(build, roots)]) == len(roots)


def test_a_look_into_an_image_has_no_line_for_each_file(
    tmp_path: Path, registry: str, bake: Bake, capfd: pytest.CaptureFixture[str]
) -> None:
    steps = [vertex(f"[system {number}/9] COPY --from=os /x /", completed=f"{DAY}12Z") for number in range(9)]
    progress, _ = builder.run(having(tmp_path, registry, says(*steps)), replace(bake, glance="looking into vendor:1"))
    assert len(progress.steps) == 9 and capfd.readouterr().err == ""


@pytest.mark.parametrize("content", ["", "{", '{"b": {"containerimage.digest": "x"}}', "[]", '{"a": null}'])
def test_metadata_without_the_target(tmp_path: Path, registry: str, bake: Bake, content: str) -> None:
    file = tmp_path / ".state/log/build-a.metadata.json"
    file.parent.mkdir(parents=True)
    file.write_text('{"a": {"containerimage.digest": "sha256:of-an-earlier-call"}}')
    text = f"[ -z '{content}' ] || printf '%s' '{content}' >$metadata"
    assert builder.run(having(tmp_path, registry, text), bake)[1] == {}


# ---- What goes wrong -------------------------------------------------------------------------------------------------


def fails(tmp_path: Path, registry: str, bake: Bake, *lines: str) -> RosmlError:
    with pytest.raises(RosmlError) as caught:
        builder.run(having(tmp_path, registry, says(*lines, code=1)), bake)
    return caught.value


def test_failure_shows_the_step_and_its_last_lines(tmp_path: Path, registry: str, bake: Bake) -> None:
    cancelled = vertex("[a other 1/1] RUN x", completed=f"{DAY}12Z", error="Canceled: context canceled")
    output = prints("UmVhZGluZwpFOiBubyBwYWNrYWdlIHJvcy1jb3JlCg==")
    failed = vertex(completed=f"{DAY}12Z", error="process did not complete successfully: exit code: 100")
    error = fails(tmp_path, registry, bake, cancelled, vertex(), output, failed, "ERROR: target a: failed to solve")
    assert error.message == (
        "building a failed in step [a ros 1/2] /run/components/ros/install.sh ros-core\n"
        "    Reading\n    E: no package ros-core\n"
        f"  the whole log: {tmp_path}/.state/log/build-a.log"
    )
    assert error.remedy == ""
    assert "E: no package ros-core" in (tmp_path / ".state/log/build-a.log").read_text()


def test_failure_without_output_or_a_step(tmp_path: Path, registry: str, bake: Bake) -> None:
    error = fails(tmp_path, registry, bake, vertex(completed=f"{DAY}12Z", error="exit code: 137"))
    assert "\n    exit code: 137\n" in error.message
    assert "failed\n    ERROR: no such target\n" in fails(tmp_path, registry, bake, "ERROR: no such target").message
    assert "failed\n    buildx ended with exit code 1\n" in fails(tmp_path, registry, bake).message


LOGIN = "docker login"
PUSH = "failed to push {}/a: unexpected status from PUT request to http://x/v2/a/manifests/sha256:0: {}"


@pytest.mark.parametrize(
    ("reason", "remedy"),
    [
        ("failed to dial gRPC", "run 'rosml setup'"),
        ("failed to solve: failed to load LLB: network.host is not allowed", "run 'rosml setup'"),
        ("failed to solve: unsupported frontend capability moby.buildkit.frontend.contexts", "Docker to 23 or newer"),
        (
            "failed to resolve source metadata for docker.io/library/a:1: failed to do request: Head"
            ' "https://registry-1.docker.io/v2/library/a/manifests/1": dial tcp: connect: connection refused',
            "name a base image that answers",
        ),
        ("failed to push ghcr.io/a: unexpected status from POST request to https://ghcr.io/v2/: 403 Forbidden", LOGIN),
        (
            "failed to resolve source metadata for x: unexpected status from HEAD request to https://x: 401 Unauthorized",
            LOGIN,
        ),
        (PUSH.format("127.0.0.1:1", "500 Internal Server Error").replace("x/v2", "127.0.0.1:1/v2"), ".state/registry"),
        (PUSH.format("ghcr.io", "500 Internal Server Error"), ""),
        (
            "failed to receive status: rpc error: code = Unavailable desc = error reading from server: EOF",
            "run it again",
        ),
        ('process "/bin/sh -c x" did not complete successfully: exit code: 137', "--parallel-jobs"),
        ('process "/bin/sh -c x" did not complete successfully: exit code: 1', ""),
    ],
)
@pytest.mark.parametrize("where", ["error", "other"])
def test_remedies_for_what_the_builder_says(tmp_path: Path, bake: Bake, reason: str, remedy: str, where: str) -> None:
    progress = BuildProgress()
    progress.feed(vertex(completed=f"{DAY}12Z", error=reason if where == "error" else "exit code: 1"))
    if where == "other":
        progress.feed(f"ERROR: {reason}")
    error = builder.failure(bake, progress, tmp_path / "x.log", 1)
    assert remedy in error.remedy
    assert bool(error.remedy) == bool(remedy)


def printed(*lines: str, name: str = NAME) -> BuildProgress:
    progress = BuildProgress()
    progress.feed(vertex(name, completed=f"{DAY}12Z", error="exit code: 1"))
    progress.steps[name].tail.extend(lines)
    return progress


PRINTED = [
    ("No space left on device (28)", "free some disk space"),
    ("error: a program was killed (Killed); memory may have run out", "--parallel-jobs"),
    ("E: Failed to fetch x.deb", "run it again"),
    ("curl: (7) Failed to connect to 127.0.0.1 port 1: Connection refused", "HTTP_PROXY"),
    ("Hash mismatch for `x`", "rosml locks"),
    ("error: HTTP status client error (403 Forbidden) for url (https://example.org/simple/torch/)", "its address"),
    ("E: Failed to fetch http://example.org/x.deb  403  Forbidden [IP: 192.0.2.1 80]", "its address"),
    ("curl: (22) The requested URL returned error: 403", "its address"),
]


@pytest.mark.parametrize(("line", "remedy"), PRINTED)
def test_remedies_for_what_our_own_steps_print(tmp_path: Path, bake: Bake, line: str, remedy: str) -> None:
    assert remedy in builder.failure(bake, printed(line), tmp_path / "x.log", 1).remedy


@pytest.mark.parametrize(
    "line",
    [
        *(line for line, _ in PRINTED if "memory may" not in line),
        "x509: certificate has expired",
        "PUT http://127.0.0.1:1: 500 Internal Server Error",
    ],
)
def test_what_somebody_elses_code_prints_is_no_reason_of_ours(tmp_path: Path, bake: Bake, line: str) -> None:
    """A project's own download has another hash, its tests refuse a connection, its CMake warns of a proxy."""
    name = "[built 1/1] RUN --mount=type=bind,target=/run/scripts/workspace.sh /run/scripts/workspace.sh target"
    foreign = replace(bake, foreign=("scripts/workspace.sh",))
    error = builder.failure(foreign, printed(line, "Summary: 1 package failed: a", name=name), tmp_path / "x.log", 1)
    assert error.remedy == "" and line in error.message
    ours = printed(line, "error: no room: No space left on device; free some", name=name)
    assert "free some disk space" in builder.failure(foreign, ours, tmp_path / "x.log", 1).remedy


def test_what_a_base_image_has_every_build_on_it_run(tmp_path: Path, bake: Bake) -> None:
    progress = BuildProgress()
    error = 'failed to calculate checksum of ref x::y: "/requirements.txt": not found'
    progress.feed(vertex("[base 1/3] ONBUILD COPY requirements.txt /", completed=f"{DAY}12Z", error=error))
    assert "name one without ONBUILD" in builder.failure(bake, progress, tmp_path / "x.log", 1).remedy


def test_a_script_of_ours_that_knows_the_reason_has_the_last_word(tmp_path: Path, bake: Bake) -> None:
    """Before that, a script of a repository may have printed whatever it likes."""
    last_line = "error: the script before the installation of dependencies ended with 1; the lines above say why"
    assert builder.failure(bake, printed("Hash mismatch", last_line), tmp_path / "x.log", 1).remedy == ""
    last_line = (
        "error: packages did not arrive, after 5 tries (Failed to fetch http://x  403  Forbidden); check the network"
    )
    assert "its address" in builder.failure(bake, printed("Hash mismatch", last_line), tmp_path / "x.log", 1).remedy


def test_apt_on_a_full_disk_takes_a_list_that_was_cut_off_for_a_forged_one(tmp_path: Path, bake: Bake) -> None:
    lines = (
        "  Error writing to file - write (28: No space left on device) [IP: 192.0.2.1 80]",
        "W: GPG error: x InRelease",
    )
    last_line = "error: an apt source has no valid signature (GPG error: x InRelease); check the mirror"
    assert "docker builder prune" in builder.failure(bake, printed(*lines, last_line), tmp_path / "x.log", 1).remedy


def test_the_reason_may_stand_far_above_the_last_lines(tmp_path: Path, bake: Bake) -> None:
    progress = printed("Hash mismatch for `torch==2.10.0`", *(f"  sha256:{number:02d}" for number in range(100)))
    error = builder.failure(bake, progress, tmp_path / "x.log", 1)
    assert "rosml locks" in error.remedy
    assert "sha256:79" not in error.message and "sha256:80" in error.message


def test_a_service_that_is_down_is_the_reason(tmp_path: Path, registry: str, bake: Bake) -> None:
    with pytest.raises(RosmlError, match=r"registry at 127\.0\.0\.1:1 does not answer") as caught:
        builder.run(having(tmp_path, "127.0.0.1:1", says("ERROR: whatever", code=1)), bake)
    assert caught.value.remedy == "run 'rosml setup'"
    broken = having(tmp_path, registry, says("ERROR: whatever", code=1))
    (tmp_path / "status").write_text("Status: stopped\n")
    with pytest.raises(RosmlError, match="builder 'rosml' is stopped") as caught:
        builder.run(broken, bake)
    assert caught.value.remedy == "run 'rosml setup'"


def test_buildx_is_gone(tmp_path: Path, bake: Bake) -> None:
    with pytest.raises(RosmlError, match="cannot run /nowhere/buildx: No such file") as caught:
        builder.run(services(tmp_path), bake)
    assert caught.value.remedy == "run 'rosml setup'"


TRY = """
echo x >>"$here/tries"
[ "$(wc -l <"$here/tries")" -gt {failures} ] && exit 0
"""


@pytest.fixture
def tries(
    tmp_path: Path, registry: str, bake: Bake, monkeypatch: pytest.MonkeyPatch
) -> Callable[[str, int], list[str]]:
    """What a build of which the first attempts fail calls; `{}` in the reason is the registry."""
    monkeypatch.setattr(retries, "WAIT", 0.001)

    def calling(reason: str, times: int) -> list[str]:
        line = vertex(completed=f"{DAY}12Z", error=reason.replace("{}", registry))
        text = TRY.format(failures=times) + says(line, code=1)
        with contextlib.suppress(RosmlError):
            builder.run(having(tmp_path, registry, text), replace(bake, sets=("a.no-cache=true", "a.tags=")))
        return [call for call in calls(tmp_path) if call.startswith("buildx bake")]

    return calling


@pytest.mark.parametrize(
    ("reason", "most"),
    [
        (PUSH.format("{}", "429 Too Many Requests"), retries.ATTEMPTS),
        (PUSH.format("{}", "503 Service Unavailable"), retries.ATTEMPTS),
        (PUSH.format("{}", "404 Not Found"), retries.ATTEMPTS_REFUSED),
        (PUSH.format("{}", "401 Unauthorized"), 1),
        (PUSH.format("{}", "413 Content Too Large"), 1),
        ("failed to push {}/a: failed to do request: Put http://x: EOF", retries.ATTEMPTS_UNREACHED),
        ("failed to push {}/a: x509: certificate signed by unknown authority", 1),
        ("a: unexpected status from HEAD request to https://x: 429 Too Many Requests", retries.ATTEMPTS),
        ("a: unexpected status from HEAD request to https://x: 403 Forbidden", 1),
        ("process did not complete successfully: exit code: 1", 1),
    ],
)
def test_what_a_registry_may_take_later_is_sent_again(
    tries: Callable[[str, int], list[str]], reason: str, most: int
) -> None:
    assert len(tries(reason, 100)) == most


def test_a_result_that_is_there_is_not_built_again(tries: Callable[[str, int], list[str]], tmp_path: Path) -> None:
    first, second = tries(PUSH.format("{}", "429 Too Many Requests"), 1)
    assert "a.no-cache=true" in first and "a.no-cache=true" not in second and "a.tags=" in second
    log = (tmp_path / ".state/log/build-a.log").read_text()
    assert log.count("$ ") == 2 and "429 Too Many Requests" in log, "the log has what was built"
    (tmp_path / "tries").unlink()
    *_, again = tries("a: unexpected status from HEAD request to https://x: 429 Too Many Requests", 1)
    assert "a.no-cache=true" in again


@pytest.mark.parametrize(("may", "attempts"), [(True, retries.ATTEMPTS), (False, 1)])
def test_a_push_that_is_denied_is_sent_again_if_the_client_may_push(
    tries: Callable[[str, int], list[str]], monkeypatch: pytest.MonkeyPatch, may: bool, attempts: int
) -> None:
    requests = []

    def may_push(client: Registry, repository: str) -> None:
        requests.append((client.host, repository))
        if not may:
            raise RosmlError("access denied")

    monkeypatch.setattr(Registry, "may_push", may_push)
    assert len(tries(PUSH.format("{}", "403 Forbidden"), 100)) == attempts
    assert len(requests) == attempts and {repository for _, repository in requests} == {"a"}


# ---- Ctrl-C ----------------------------------------------------------------------------------------------------------

WAITS = "touch {0}/ready; while :; do sleep 0.02; done"


def interrupt_when(ready: Path) -> threading.Thread:
    def send() -> None:
        end = time.monotonic() + 60
        while not ready.exists() and time.monotonic() < end:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send, daemon=True)
    thread.start()
    return thread


@pytest.fixture
def interruptible() -> Iterator[None]:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interruptible")
def test_buildx_can_say_its_last_words(
    tmp_path: Path, registry: str, bake: Bake, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It reports every cancelled step before it ends: more than a pipe holds, and nobody may let it wait."""
    monkeypatch.setattr(builder, "CANCEL_SECONDS", 60)
    last = f"head -c 300000 /dev/zero >&2; echo told >>{tmp_path}/calls; exit 1"
    text = f"trap '{last}' INT; {WAITS.format(tmp_path)}"
    thread = interrupt_when(tmp_path / "ready")
    with pytest.raises(KeyboardInterrupt):
        builder.run(having(tmp_path, registry, text), bake)
    thread.join()
    assert calls(tmp_path)[-1] == "told"


@pytest.mark.usefixtures("interruptible")
def test_buildx_that_does_not_listen_is_ended(
    tmp_path: Path, registry: str, bake: Bake, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(builder, "CANCEL_SECONDS", 0.1)
    text = f"trap '' INT; echo $$ >{tmp_path}/pid; {WAITS.format(tmp_path)}"
    thread = interrupt_when(tmp_path / "ready")
    with pytest.raises(KeyboardInterrupt):
        builder.run(having(tmp_path, registry, text), bake)
    thread.join()
    assert subprocess.run(["kill", "-0", (tmp_path / "pid").read_text().strip()], capture_output=True).returncode != 0
