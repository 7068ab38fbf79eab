"""The entrypoint of images, where it needs no container: tests/e2e/test_contract.py has the rest."""

from __future__ import annotations

import os
import subprocess

import pytest

from rosml import ROOT

SCRIPT = (ROOT / "components/base/entrypoint.sh").read_text()


@pytest.mark.parametrize(("docker_uid", "says"), [("1000", True), ("65534", False), ("", False)])
def test_a_user_that_cannot_be_had_is_said(docker_uid: str, says: bool) -> None:
    """An image that starts as somebody, such as a company's, takes no DOCKER_UID."""
    user = os.geteuid()
    become = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"] if user == 0 else []
    uid = str(user) if user and docker_uid == "65534" else docker_uid
    variables = {"PATH": os.environ["PATH"], "HOME": "/tmp", "DOCKER_UID": uid, "DOCKER_GID": uid}
    command = [*become, "bash", "-c", SCRIPT, "entrypoint.sh", "echo", "started"]
    done = subprocess.run(command, env=variables, cwd="/", capture_output=True, text=True, check=False)
    assert done.stdout == "started\n"
    assert ("DOCKER_UID has no effect" in done.stderr) == says, done.stderr
