"""Scripts of a repository that was made for docker-ros: what they find in a build, and what they can read."""

from __future__ import annotations

import hashlib
import re
import secrets
from collections.abc import Mapping
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests import regctl
from tests.e2e.app_builds import CANARY, build_app, log_of, package, write
from tests.e2e.calls import NAMESPACE
from tests.e2e.images import NATIVE, PLATFORM, build_file, config

WORKSPACE = "/docker-ros/ws"

STARTS = {"DOCKER_USER": "dockeruser", "DOCKER_UID": "", "DOCKER_GID": ""}
_BOTH = {"TARGETARCH": NATIVE, "WORKSPACE": WORKSPACE, "ROS_DISTRO": "Debian"}
_APT = {"DEBIAN_FRONTEND": "noninteractive"}
_LATER = {"DOCKER_ROS": "1", "RCUTILS_COLORIZED_OUTPUT": "1", "COLCON_HOME": f"{WORKSPACE}/.colcon"}
_MIDDLEWARE = {"RMW_IMPLEMENTATION": "rmw_fastrtps_cpp"}

VARIABLES: Mapping[str, Mapping[str, str]] = {
    "identification": {**_BOTH, **_APT},
    "before": {**_BOTH, **_APT, **_LATER, **STARTS},
    "after": {**_BOTH, **_APT, **_LATER, **STARTS},
    "build": {**_BOTH, **_APT, **_LATER, **STARTS, **_MIDDLEWARE, "CMAKE_ARGS": "-DX=1"},
    "run": {**_BOTH, **_LATER, **STARTS, **_MIDDLEWARE, "DEFAULT_CMD": "true"},
    "dev": {**_BOTH, **_LATER, **STARTS, **_MIDDLEWARE},
}
"""What `ARG` and `ENV` of docker-ros' Dockerfile, of its commit 3943707, say at each place: a script, colcon, a finished image."""

LEFT_OUT = {
    "BEFORE_DEPENDENCY_IDENTIFICATION_SCRIPT": "the script knows its own name",
    "DISABLE_ROS_INSTALLATION": "ROS is there, whoever installed it",
    "ADDITIONAL_FILES_DIR": "a path in sources that are not there; the files are in /docker-ros/additional-files",
    "GIT_HTTPS_URL": "docker-ros' scripts never set it",
    "GIT_HTTPS_USER": "for scripts alone, if a person allows it",
    "GIT_HTTPS_PASSWORD": "for scripts alone, if a person allows it",
    "TINI_VERSION": "it names a download, and tini is the distribution's package here",
}
"""What is there in docker-ros besides, and why it is not here."""

_SAYS = "env | sed 's/^/{} has /'\n"


def migrated(folder: Path) -> Path:
    """A repository with all kinds of scripts, which say what they have. No step of an earlier build is like theirs."""
    lines = 'execute_process(COMMAND env OUTPUT_VARIABLE all)\nstring(REPLACE "\\n" "\\nbuild has " all "\\n${all}")\nmessage("${all}")\n'
    says, new = _SAYS.format, f"# {secrets.token_hex()}\n"
    files = {
        "docker/before_dependency_identification.sh": f'#!/bin/bash\n{new}{says("identification")}ls "$(dirname "$0")"/custom.sh\n',
        "docker/before_dependency_installation.sh": f"{new}{says('before')}rm -rf /tmp/*\nexport GREETING=hello\ncd /opt\n"
        "echo 'DPkg::Pre-Invoke {\"echo apt says $GREETING\";};' >/etc/apt/apt.conf.d/99greets\n",
        "docker/custom.sh": f"{says('after')}rm /etc/apt/apt.conf.d/99greets\necho after says $GREETING in $PWD\n"
        "(cd /docker-ros/additional-files && find . -type f | sed 's/^/additional has /')\n",
        "docker/additional-debs.txt": "tree\n",
        "docker/additional-files/some/file": "",
        "docker/additional-files.txt": "",
    }
    return package(folder, "", lines, files)


def test_variables_and_files_are_those_of_docker_ros(base: str, services: Services, tmp_path: Path) -> None:
    """And what a script exports, and its folder, reach apt and the next script."""
    name = f"{NAMESPACE}/scripts"
    options = {"base-image": base, "image-name": name, "command": "true", "rmw-implementation": "rmw_fastrtps_cpp"}
    result = build_app(migrated(tmp_path / "robot"), options | {"cmake-args": "-DX=1"})
    log = log_of(services, name)
    for place, variables in VARIABLES.items():
        if place in ("run", "dev"):
            entries = config(services, result[place]["reference"])["Env"]
        else:
            entries = re.findall(rf"^ *{place} has (.*)$", log, re.MULTILINE)
        present = dict(entry.partition("=")[::2] for entry in entries)
        assert {key: present.get(key) for key in variables} == variables, place
        assert not present.keys() & LEFT_OUT.keys(), place
    assert {*re.findall(r"^ *((?:apt|after) says .*)", log, re.MULTILINE)} == {
        "apt says hello",
        "after says hello in /opt",
    }
    assert {*re.findall(r"additional has (.*)", log)} == {"./some/file", "./additional-files.txt"}


SEEKS = """{new}for place in /run/secrets /proc/self/environ /proc/1/environ /dev/shm /docker-ros /root; do
  grep -r -a -i -h "git.https" $place 2>/dev/null || true
done
env | grep GIT_HTTPS_ | grep -v PASSWORD || true
ls -A /run/secrets /dev/shm
echo "it is $(printf %s "$GIT_HTTPS_PASSWORD" | sha256sum) or $GIT_HTTPS_PASSWORD."
"""
"""A script that looks for a password."""


@pytest.mark.parametrize("allowed", [False, True])
def test_scripts_have_the_password_for_git_if_a_person_allows_it(
    allowed: bool, base: str, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing else shows it: neither the log, nor a layer, nor the history."""
    seeks, name = SEEKS.format(new=f"# {secrets.token_hex()}\n"), f"{NAMESPACE}/seeks"
    places = ("before_dependency_identification", "before_dependency_installation", "custom")
    folder = package(tmp_path / "seeks")
    write(folder, {f"docker/{place}.sh": f"#!/bin/bash\n{seeks}" for place in places})
    monkeypatch.setenv("GIT_HTTPS_PASSWORD", CANARY)
    monkeypatch.setenv("GIT_HTTPS_USER", "user-77")
    options = {"base-image": base, "image-name": name, "command": "true"}
    result = build_app(folder, options, *(["--allow-script-secrets"] if allowed else []))
    log = log_of(services, name)
    empty, full = (hashlib.sha256(text.encode()).hexdigest() for text in ("", CANARY))
    seen = re.findall(r"it is (\w+) .* or (.*)\.$", log, re.MULTILINE)
    assert {*seen} == ({(empty, ""), (full, "***")} if allowed else {(empty, "")})
    assert CANARY not in log and ("user-77" in log) is allowed
    lines = ""
    for target in ("run", "dev"):
        content = str(regctl.image_config(services, result[target]["reference"], PLATFORM))
        assert CANARY not in content and "user-77" not in content
        lines += f"FROM {result[target]['reference']} AS {target}\n"
        lines += f"RUN ! grep -r -s -F -e {CANARY} /dev/shm /docker-ros /etc /opt /root /run /tmp /usr/local /var\n"
    build_file(
        services, tmp_path / "check", f"{lines}FROM scratch\nCOPY --from=run /tini /run\nCOPY --from=dev /tini /dev\n"
    )
