"""What code of a repository can do while an app is built: it says nothing of the machine, reaches none of its services, and gives
no commands to a terminal or a forge."""

from __future__ import annotations

import contextlib
import json
import re
import secrets
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from rosml.registry import oci
from tests.e2e.app_builds import CANARY, build_app, containerize, log_of, package
from tests.e2e.calls import NAMESPACE
from tests.e2e.local_servers import Handler, serving

HARM = r"""set -eu
say() { printf '\033]52;c;aGFybQ==\007\033[8m%s\n::error::harm\n##[add-mask]harm\n' "$1"; }
for folder in /tests/results /tests /tests/results/harm; do
  mkdir -p $folder
  for name in app.json dependencies.json images.json slim.json; do echo '{"packages": ["harm"]}' >$folder/$name; done
done
ln -s /proc/self/environ /tests/results/harm/link.xml
ln -s / /tests/results/root
mkfifo /tests/results/harm/pipe.xml
mknod /tests/results/harm/device.xml c 1 5 || mkfifo /tests/results/harm/device.xml
say the-last-line
exit "$1"
"""
"""What a test may do: it is root in its step."""


def test_what_tests_leave_says_nothing_of_the_machine_or_the_images(
    base: str, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = "enable_testing()\nadd_test(NAME harm COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/harm.sh 0)\n"
    folder, name = package(tmp_path / "harm", "", lines, {"harm.sh": HARM}), f"{NAMESPACE}/harm"
    monkeypatch.setenv("GIT_HTTPS_PASSWORD", CANARY)
    options = {"base-image": base, "image-name": name, "command": "true", "target": "run"}
    outcome = containerize(folder, options)
    assert outcome.code == 1
    error = json.loads(outcome.out)["error"]
    assert "4 of 5 tests failed; no image was made" in error, error
    for words in ("link.xml: it is a link", "root: it is a link", "pipe.xml: it is a pipe", "device.xml: it is a"):
        assert words in error
    state = services.state / f"containerize/{name.replace('/', '+')}@latest"
    paths = [path for path in state.rglob("*") if "said" not in path.parts and path.name != "harm.sh"]
    assert not [path for path in paths if path.is_symlink() or not (path.is_file() or path.is_dir())]
    reports = [path for path in (state / "report").rglob("*") if path.is_file()]
    assert {path.suffix or path.name for path in reports} == {".xml"}
    assert CANARY not in outcome.out + outcome.err + "".join(path.read_text() for path in reports)
    assert "harm" not in json.loads((state / "said/dependencies.json").read_text())["keys"]
    assert json.loads((state / "said/app.json").read_text())["packages"] == []


REACHES = """import socket, sys
reached = []
for family, place in PLACES:
    with socket.socket(family) as client:
        client.settimeout(3)
        try:
            client.connect(place)
            reached.append(place)
        except OSError as error:
            print("not reached", place, error)
print(sys.argv[1], "asked; reached", reached)
sys.exit(bool(reached))
"""
"""What code of a repository may try: it ends with 1 if it reaches one of the places."""


@contextlib.contextmanager
def listening() -> Iterator[list[tuple[int, Any]]]:
    """Places at which this machine listens: loopback, its other addresses, and an abstract socket."""
    with contextlib.ExitStack() as stack:

        def listen(family: int, place: Any) -> Any:
            server = stack.enter_context(socket.socket(family))
            server.bind(place)
            server.listen()
            return server.getsockname()

        loopback = listen(socket.AF_INET, ("127.0.0.1", 0))
        *_others, port = listen(socket.AF_INET, ("0.0.0.0", 0))
        abstract = f"\0{secrets.token_hex(8)}"
        listen(socket.AF_UNIX, abstract)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            client.connect(("192.0.2.1", 9))  # sends nothing
            address = client.getsockname()[0]
        texts = "".join(file.read_text() for file in (ROOT / ".state/run").glob("buildkitd*.toml"))
        bridges = re.findall(r'^  bridgeSubnet = "(.*)0/24"$', texts, re.M)
        yield [
            (socket.AF_INET, loopback),
            (socket.AF_UNIX, abstract),
            *((socket.AF_INET, (host, port)) for host in (address, *(f"{start}1" for start in bridges))),
        ]


def nosy(folder: Path, places: list[tuple[int, Any]], script: str = "") -> Path:
    """A repository whose scripts, build and test try to reach places. `script`: further lines of the last script."""
    text = REACHES.replace("PLACES", repr([(int(family), place) for family, place in places]))
    call = "python3 - {} <<'END'\n" + text + "END\n"
    program = "python3 ${CMAKE_CURRENT_SOURCE_DIR}/reaches.py"
    lines = f"execute_process(COMMAND {program} build RESULT_VARIABLE code)\n"
    lines += 'if(code)\n  message(FATAL_ERROR "reached")\nendif()\n'
    lines += f"enable_testing()\nadd_test(NAME reaches COMMAND {program} test)\n"
    files = {
        "docker/before_dependency_identification.sh": f"#!/bin/bash\nset -e\n{call.replace('{}', 'first', 1)}",
        "docker/custom.sh": f"apt-get update\n{call.replace('{}', 'custom', 1)}{script}",
        "reaches.py": text,
    }
    return package(folder, "", lines, files)


def test_code_of_a_repository_reaches_no_service_of_the_machine(base: str, services: Services, tmp_path: Path) -> None:
    """It reaches what is outside: apt's archive. It changes no image in the local registry, nor in the mirror of Docker Hub: it
    does not reach it, or has no password for it."""
    debian = f"http://{services.registry}/v2/library/debian"
    requests = [
        f"-X POST {debian}/blobs/uploads/",
        f"-X PUT -H 'Content-Type: {oci.IMAGE}' -d '{{}}' {debian}/manifests/bookworm",
        f"-X DELETE {debian}/manifests/sha256:{'0' * 64}",
        f"-X POST -u rosml: {debian}/blobs/uploads/",
        f"-X POST -u rosml:rosml {debian}/blobs/uploads/",
    ]
    script = "".join(f"curl -s {words} -o /dev/null -w 'code %{{http_code}}\\n' || true\n" for words in requests)
    name = f"{NAMESPACE}/harm"
    options = {"base-image": base, "image-name": name, "command": "true", "target": "run"}
    with listening() as places:
        result = build_app(nosy(tmp_path / "harm", places, script), options)
    assert result["tests"]["count"] == 1 and not result["tests"]["failures"]
    log = log_of(services, name)
    assert {*re.findall(r"(\w+) asked; reached \[\]", log)} >= {"first", "custom"}
    codes = re.findall(r"\bcode (\d{3})$", log, re.MULTILINE)
    assert len(codes) >= len(requests) and {*codes} in ({"000"}, {"401"}), codes


def test_a_mirror_on_the_machine_is_reached(base: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By steps that have the machine's network, which is said: the repository's code has it as well."""

    class Mirror(Handler):
        def do_GET(self) -> None:
            self.reply(302, headers={"Location": f"http:/{self.path}"})

    with listening() as places, serving(Mirror) as address:
        folder = nosy(tmp_path / "harm", places)
        (folder / "docker/before_dependency_identification.sh").unlink()
        monkeypatch.setenv("OS_APT_MIRROR", f"http://{address}")
        outcome = containerize(folder, {"base-image": base, "command": "true"})
    assert "OS_APT_MIRROR: on this machine, so steps of the build share its network" in outcome.err
    assert "custom asked; reached [('127.0.0.1'" in json.loads(outcome.out)["error"]


def test_lines_of_a_build_are_no_commands(
    base: str, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To the terminal, or to the forge whose log they are in."""
    folder = package(tmp_path / "harm", files={"docker/custom.sh": HARM.replace('exit "$1"', "exit 1")})
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    outcome = containerize(folder, {"base-image": base, "command": "true"})
    assert "the script after the installation of dependencies ended with 1" in json.loads(outcome.out)["error"]
    assert outcome.code == 1 and "the-last-line" in outcome.err
    assert not re.search(r"^\s*::error::|##\[|\x1b\]|\x1b\[8m|\x07", outcome.err, re.MULTILINE)
    assert ": :error::harm" in outcome.err, "people read it all the same"
    log = log_of(services, "harm")
    assert "the-last-line" in log and "\x1b]" not in log
