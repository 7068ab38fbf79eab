"""What setup starts: daemons, the local registry, calls with a log; the state folder, and what answers on the network."""

from __future__ import annotations

import http.server
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from fakes.setups import new_state, services_of
from rosml.base.errors import RosmlError
from rosml.machine.services import Services, registry_answers
from rosml.machine.setup import network, process, registry
from rosml.machine.setup.daemon import Daemon, command_line, wait_until
from rosml.machine.setup.state import LONGEST_SOCKET_PATH, State
from rosml.registry import credentials


@pytest.fixture
def state(tmp_path: Path) -> State:
    return new_state(tmp_path)


# ---- Network ---------------------------------------------------------------------------------------------------------


def test_docker_hub_can_be_decided_by_the_user(monkeypatch: pytest.MonkeyPatch) -> None:
    for wish, answers in (("1", True), ("0", False)):
        monkeypatch.setenv("ROSML_DOCKER_HUB", wish)
        assert network.docker_hub_answers("") == answers
    monkeypatch.setenv("ROSML_DOCKER_HUB", "yes")
    with pytest.raises(RosmlError, match="neither 0 nor 1"):
        network.docker_hub_answers("")


@pytest.fixture
def answer(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[tuple[int, dict[str, str]]]]:
    """A server in the place of Docker Hub; the list's one entry is the answer."""
    answers: list[tuple[int, dict[str, str]]] = []

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            code, headers = answers[0]
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
        yield answers
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
    assert not registry_answers(f"127.0.0.1:{port}")


# ---- Sockets ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("root", ["/" + "deep/" * 30, "/with space", "/ümlaut"])
def test_socket_of_a_path_that_cannot_hold_one(root: str) -> None:
    assert State(Path("/work/x")).socket("b.sock") == Path("/work/x/.state/run/b.sock")
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


# ---- Daemons ---------------------------------------------------------------------------------------------------------


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


# ---- The registry ----------------------------------------------------------------------------------------------------


def test_config_of_the_registry(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    text = registry.config(Path("/a b/.state/registry"), 5001, Path("/p"))
    config = json.loads(text)
    assert config["auth"] == {"writers": {"path": "/p"}}
    assert config["http"] == {"addr": "127.0.0.1:5001"}
    assert config["storage"]["delete"] == {"enabled": True}
    assert config["storage"]["filesystem"]["rootdirectory"] == "/a b/.state/registry"
    assert registry.last_port(state) is None
    (state.run / "registry.yaml").write_text(text)
    assert registry.last_port(state) == 5001
    monkeypatch.setenv("REGISTRY_HTTP_ADDR", "0.0.0.0:80")
    assert "REGISTRY_HTTP_ADDR" not in registry.daemon(state).env


def test_the_password_of_the_registry_is_this_users_alone(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    secret = registry.password(state)
    assert len(secret) > 20 and registry.password(state) == secret, "it stays"
    assert (state.run / registry.PASSWORD).stat().st_mode & 0o777 == 0o600
    (state.folder / credentials.OWN).parent.mkdir()
    (state.folder / credentials.OWN).write_text(json.dumps({"auths": {"127.0.0.1:5001": {"auth": "bWU6cHc="}}}))
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"ghcr.io": {"auth": "eDp5"}}}))
    config = json.loads(services_of(state, "buildkitd").environment()["DOCKER_AUTH_CONFIG"])
    assert config == {"auths": {"ghcr.io": {"auth": "eDp5"}, "127.0.0.1:5001": {"auth": "bWU6cHc="}}}, (
        "what buildx gets"
    )
    monkeypatch.delenv("DOCKER_AUTH_CONFIG")
    monkeypatch.setattr(credentials, "STATE", state.folder)
    assert credentials.from_docker("127.0.0.1:5001") == credentials.Credentials("me", "pw")


def test_services_json(state: State) -> None:
    services = services_of(state, "buildkitd")
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
        "no_engine": "",
        "docker_address": "",
    }
    assert Services.load(state.root) == services


# ---- Calls -----------------------------------------------------------------------------------------------------------


def test_run_shows_signs_of_life(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(process, "HEARTBEAT_SECONDS", 0.1)
    process.run(print, process.Call("nap", ["sleep", "0.25"], tmp_path / "log"))
    assert "  nap: still at work (0.1 s)\n" in capsys.readouterr().out


def test_interrupt_ends_what_runs(tmp_path: Path) -> None:
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        argv = ["sh", "-c", f"sleep 60 & echo $! >{tmp_path}/pid; wait"]
        process.run(print, process.Call("nap", argv, tmp_path / "log"))
    child = int((tmp_path / "pid").read_text())
    assert wait_until(lambda: command_line(child) == (), 5.0)  # it ends at the same time as its parent


def test_interrupt_waits_for_what_must_not_be_torn(tmp_path: Path) -> None:
    threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        argv = ["sh", "-c", f"sleep 0.6; touch {tmp_path}/done"]
        process.run(print, process.Call("dpkg", argv, tmp_path / "log", finish_on_interrupt=True))
    assert (tmp_path / "done").exists()
