"""The services for builds: the local registry and the builder of `rosml setup`."""

from __future__ import annotations

import json
import os
import re
import ssl
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import httpx

from rosml.base import files, silent_docker, untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.shapes import adapter
from rosml.machine import docker
from rosml.registry import certificates, credentials

NAMESPACE = "rosml"
"""Namespace of images in the local registry."""
REMEDY = "run 'rosml setup'"
NO_BUILDX = "install Docker with buildx, and start it"
REGISTRY_SECONDS = 5.0
BUILDER_SECONDS = 60.0
VERSION = re.compile(r"v?[0-9][0-9A-Za-z.+-]{0,40}")


@dataclass(frozen=True)
class Services:
    """The content of ``.state/services.json``."""

    root: Path
    registry: str  # the local one's address, which speaks plain http; empty on a client of another one
    buildx: tuple[str, ...]  # the command, e.g. ``("docker", "buildx")``
    builder: str
    builder_kind: str
    """``engine`` (in the user's Docker itself), ``docker`` (a container of it), ``buildkitd`` (our own) or ``user`` (theirs)."""
    buildx_config: Path | None  # the folder; None for the user's own
    uv: str
    ca_bundle: str  # the user's, an absolute path; empty if the system's certificates count
    bases: tuple[str, ...]  # the command that makes base images (`base_images`); empty for those of matrix.yaml
    no_engine: str = ""  # why the builder is not in the user's Docker itself
    docker_address: str = ""  # of the user's Docker, if the builder is in it; empty if unknown

    @classmethod
    def load(cls, root: Path, required: bool = True) -> Services:
        """Reads the services of a checkout. If they need not exist, the result may be a machine without services."""
        path = root / ".state" / "services.json"
        try:
            return _SERVICES_JSON.validate_python({**untrusted.json_value(path.read_bytes()), "root": root})
        except FileNotFoundError:
            if not required:
                return cls(root, "", (), "", "", None, "", os.environ.get("SSL_CERT_FILE", ""), bases=())
            raise RosmlError("the local registry and the builder are not up", REMEDY) from None
        except OSError as error:
            raise RosmlError(f"cannot read {path}: {error.strerror}", REMEDY) from None
        except (TypeError, ValueError):
            raise RosmlError(f"{path} is damaged", f"{REMEDY}, which writes it again") from None

    @classmethod
    def of_docker(
        cls, folder: Path, remedy: str = f"{NO_BUILDX}; or call this in a checkout, after 'rosml setup'"
    ) -> Services:
        """The builder of the user's Docker, without a registry. `folder`: its folder `.state` is for kept files."""
        buildx = ("docker", "buildx")
        done = _inspect([*buildx, "inspect"], "docker buildx", remedy)
        names = _values(done.stdout, "Name")
        if done.returncode != 0 or not names:
            errors = done.stderr.strip().splitlines() or ["it names no builder"]
            raise RosmlError(f"docker buildx does not answer: {errors[-1]}", remedy)
        bundle = os.environ.get("SSL_CERT_FILE", "")
        return cls(folder, "", buildx, names[0], "user", None, "", bundle, bases=())

    @property
    def is_docker_itself(self) -> bool:
        """Whether the builder is the BuildKit in the user's Docker."""
        return self.builder_kind == "engine"

    def save(self) -> None:
        text = _SERVICES_JSON.dump_json(self, indent=2, exclude={"root"}).decode() + "\n"
        files.write(self.state / "services.json", text)

    @property
    def state(self) -> Path:
        return self.root / ".state"

    def temporary_folder(self) -> tempfile.TemporaryDirectory[str]:
        """A folder for the files of one call of the builder, on the disk of the state."""
        (self.state / "tmp").mkdir(parents=True, exist_ok=True)
        return tempfile.TemporaryDirectory(dir=self.state / "tmp")

    def environment(self) -> dict[str, str]:
        """The environment for buildx and uv: this process' own, with our builder and folders, and the user's certificates."""
        env = {**os.environ, "BUILDX_BUILDER": self.builder}
        if self.buildx_config is not None:
            env["BUILDX_CONFIG"] = str(self.buildx_config)
        if auths := credentials.local_file(self.state).get("auths"):
            config = untrusted.json_object(env.get(credentials.VARIABLE, "")) or {}
            user_auths = config.get("auths")
            merged = {**(user_auths if isinstance(user_auths, dict) else {}), **auths}
            env[credentials.VARIABLE] = json.dumps({**config, "auths": merged})
        if self.ca_bundle:
            env["SSL_CERT_FILE"] = self.ca_bundle
        # The registry is on loopback: a proxy could not reach it. Both spellings have the same value: Go's programs and build
        # steps prefer NO_PROXY, curl prefers the other one.
        spellings = ("no_proxy", "NO_PROXY")
        entries = [entry.strip() for name in spellings for entry in env.get(name, "").split(",") if entry.strip()]
        return env | dict.fromkeys(spellings, ",".join(dict.fromkeys([*entries, "127.0.0.1", "localhost"])))

    def trusting(self) -> dict[str, str]:
        """The environment of a program that looks for authorities only in a bundle, for all registries.

        Certificates that this user may not read are left out. If the client asks their registry, its error names them.
        """
        env = self.environment()
        certificate_files = [file for files_of_host in certificates.by_host().values() for file in files_of_host]
        if not certificate_files:
            return env
        base = self.ca_bundle or ssl.get_default_verify_paths().cafile or ""
        try:
            texts = [file.read_text(errors="replace") for file in (*([Path(base)] if base else []), *certificate_files)]
        except OSError as error:
            raise RosmlError(f"cannot read {error.filename}: {error.strerror}", "let this user read it") from None
        bundle = self.state / "cache" / "authorities.pem"
        bundle.parent.mkdir(parents=True, exist_ok=True)
        files.write(bundle, "\n".join(texts))
        return {**env, "SSL_CERT_FILE": str(bundle)}

    @property
    def place(self) -> str:
        """The place of images in the local registry."""
        if not self.registry:
            raise RosmlError("no registry is named, and the local one is not up", REMEDY)
        return f"{self.registry}/{NAMESPACE}"

    def require_registry(self) -> None:
        if not self.registry:
            raise RosmlError("the local registry is not up", REMEDY)
        if not registry_answers(self.registry):
            raise RosmlError(f"the local registry at {self.registry} does not answer", REMEDY)

    def require_builder(self, platform: str = "") -> str:
        """Checks that buildx reaches the builder, and that the builder runs programs of a platform. Returns the version of its
        BuildKit, such as `v0.33.0`; empty if buildx names none."""
        remedy = REMEDY
        if not self.builder:
            raise RosmlError("the builder is not up", REMEDY)
        if self.builder_kind == "user":
            remedy = f"start your builder '{self.builder}', or unset BUILDX_BUILDER"
            remedy += f" and {REMEDY}" if self.registry else ""
        if self.docker_address:
            self._require_same_docker()
        argv = [*self.buildx, "inspect", self.builder]
        done = _inspect(argv, f"the builder '{self.builder}'", remedy, self.environment())
        status = _values(done.stdout, "Status")
        if done.returncode != 0 or "running" not in status:
            reasons = _values(done.stdout, "Error")
            state = f"is {status[0]}" if status else "does not answer"
            if reasons and not status:
                state = f"{state}: {reasons[0]}"
                if docker.SILENT.search(reasons[0]):
                    remedy = silent_docker.remedy(reasons[0]) + (f"; or {REMEDY}" if self.registry else "")
            raise RosmlError(f"the builder '{self.builder}' {state}", remedy)
        platforms = {name.strip(" *") for text in _values(done.stdout, "Platforms") for name in text.split(",")}
        if platform and platform not in platforms:
            text = f"the builder '{self.builder}' does not run programs for {platform}"
            raise RosmlError(text, "run 'rosml setup emulate'")
        return next(filter(VERSION.fullmatch, _values(done.stdout, "BuildKit version")), "")

    def _require_same_docker(self) -> None:
        """Checks that `docker` asks the Docker of setup, since images are loaded into it, and containers start there."""
        address = docker.address()
        if address and address != self.docker_address:
            text = f"the builder is the Docker at {self.docker_address}, and docker asks the one at {address}"
            raise RosmlError(text, f"{REMEDY}, which looks at that one; or set DOCKER_HOST={self.docker_address}")


def registry_answers(address: str) -> bool:
    """Whether a registry on loopback answers, without a proxy and without TLS."""
    try:
        with (
            web.client(timeout=REGISTRY_SECONDS, trust_env=False, verify=False) as client,
            client.stream("GET", f"http://{address}/v2/") as answer,
        ):
            return answer.is_success
    except (httpx.HTTPError, httpx.InvalidURL, ValueError):
        return False


def _inspect(
    argv: list[str], subject: str, remedy: str, env: dict[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            argv,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=BUILDER_SECONDS,
            env=env,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise RosmlError(f"{subject} does not answer: {error}", remedy) from None


def _values(output: str, key: str) -> list[str]:
    """The values of a key in the output of `buildx inspect`, one for each node."""
    return [line.split(":", 1)[1].strip() for line in output.splitlines() if line.startswith(f"{key}:")]


_SERVICES_JSON = adapter(Services)
