"""What is read from services.json, and the checks before work starts."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from fakes.stubs import executable, load
from rosml.base.errors import RosmlError
from rosml.machine.services import Services


def test_not_up(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match="not up") as caught:
        Services.load(tmp_path)
    assert caught.value.remedy == "run 'rosml setup'"


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"registry": 1}', "null"])
def test_damaged(tmp_path: Path, text: str) -> None:
    (tmp_path / ".state").mkdir()
    (tmp_path / ".state" / "services.json").write_text(text)
    with pytest.raises(RosmlError, match="damaged"):
        Services.load(tmp_path)


def environment(monkeypatch: pytest.MonkeyPatch, services: Services, **variables: str) -> dict[str, str]:
    monkeypatch.setattr(os, "environ", variables)
    return services.environment()


def test_environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    env = environment(monkeypatch, load(tmp_path), PATH="/bin", NO_PROXY="example.org")
    assert env == {
        "PATH": "/bin",
        "BUILDX_BUILDER": "rosml",
        "BUILDX_CONFIG": "/x/.state/buildx",
        "SSL_CERT_FILE": "/ca.pem",
        "NO_PROXY": "example.org,127.0.0.1,localhost",
        "no_proxy": "example.org,127.0.0.1,localhost",
    }
    env = environment(monkeypatch, load(tmp_path, builder="mine", buildx_config=None, ca_bundle=""))
    assert env["BUILDX_BUILDER"] == "mine" and not {"BUILDX_CONFIG", "SSL_CERT_FILE"} & env.keys()


@pytest.mark.parametrize(
    ("variables", "both"),
    [
        ({"no_proxy": "intern.test"}, "intern.test,127.0.0.1,localhost"),
        ({"no_proxy": "a.test, localhost", "NO_PROXY": "b.test,a.test"}, "a.test,localhost,b.test,127.0.0.1"),
        ({}, "127.0.0.1,localhost"),
    ],
)
def test_what_needs_no_proxy_is_said_in_both_spellings(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], both: str
) -> None:
    """Go's programs and build steps read the one, curl the other."""
    env = environment(monkeypatch, load(tmp_path), **variables)
    assert (env["NO_PROXY"], env["no_proxy"]) == (both, both)


def test_registry_answers(tmp_path: Path, registry: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("http_proxy", "http://127.0.0.1:1")  # a proxy could not reach loopback
    services = load(tmp_path, registry=registry)
    services.require_registry()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("echo 'Status: inactive'", "'rosml' is inactive"),
        ("echo 'Error: running out of luck'", "does not answer"),
        ("echo no builder >&2; exit 1", "does not answer"),
    ],
)
def test_builder_is_down(tmp_path: Path, text: str, says: str) -> None:
    buildx = [executable(tmp_path / "buildx", text)]
    with pytest.raises(RosmlError, match=says) as caught:
        load(tmp_path, buildx=buildx).require_builder()
    assert caught.value.remedy == "run 'rosml setup'"
    with pytest.raises(RosmlError) as caught:
        load(tmp_path, builder_kind="user", buildx=buildx).require_builder()
    assert "unset BUILDX_BUILDER" in caught.value.remedy


def test_builder_runs(tmp_path: Path) -> None:
    says = "printf 'Name: %s\\nStatus:   running\\nBuildKit version: v0.33.0\\n' $2"
    services = load(tmp_path, buildx=[executable(tmp_path / "buildx", says)])
    assert services.require_builder() == "v0.33.0"
    (tmp_path / "buildx").unlink()
    with pytest.raises(RosmlError, match="does not answer"):
        services.require_builder()


@pytest.mark.parametrize(
    ("reason", "remedy"),
    [
        ("permission denied while trying to connect to the docker API", "sudo usermod -aG docker $USER"),
        ("failed to connect to the docker API at unix:///x", "sudo systemctl start docker"),
    ],
)
@pytest.mark.parametrize(("registry", "again"), [("127.0.0.1:5001", "; or run 'rosml setup'"), ("", "")])
def test_a_docker_that_builds_no_more(tmp_path: Path, reason: str, remedy: str, registry: str, again: str) -> None:
    """buildx names no driver then, and ends without an error. Without a checkout, there is no setup."""
    buildx = executable(tmp_path / "buildx", f"printf 'Name:   default\\nDriver: \\nError:  {reason}\\n'")
    services = load(tmp_path, builder="default", buildx=[buildx], registry=registry)
    with pytest.raises(RosmlError, match=f"the builder 'default' does not answer: {reason}") as caught:
        services.require_builder()
    assert remedy in caught.value.remedy and caught.value.remedy.endswith(again)


def test_the_builder_is_in_the_docker_that_runs_the_images(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    buildx = executable(tmp_path / "buildx", "echo Status: running")
    executable(tmp_path / "docker", 'echo "$DOCKER_HOST"')
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    services = load(tmp_path, builder_kind="engine", buildx=[buildx], docker_address="unix:///one")
    for address in ("unix:///one", ""):  # a client that does not say counts as the same
        monkeypatch.setenv("DOCKER_HOST", address)
        services.require_builder()
    monkeypatch.setenv("DOCKER_HOST", "ssh://robot")
    with pytest.raises(RosmlError, match="the Docker at unix:///one, and docker asks the one at ssh://robot") as caught:
        services.require_builder()
    assert caught.value.remedy == "run 'rosml setup', which looks at that one; or set DOCKER_HOST=unix:///one"
