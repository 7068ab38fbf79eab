"""What can be reached, and through which certificates."""

from __future__ import annotations

import http.client
import os
import socket
import ssl
import threading
import urllib.error
import urllib.request
from collections.abc import Mapping
from email.message import Message

from machine.console import Failure

HUB_API = "https://registry-1.docker.io/v2/"
HUB_SECONDS = 5.0
CERTIFICATES = "/etc/docker/certs.d"
CA_VARIABLES = ("ROSML_CA_BUNDLE", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "CURL_CA_BUNDLE")


def ca_bundle(env: Mapping[str, str]) -> str:
    """The user's own CA bundle: absolute path, or empty.

    Raises:
        Failure: ROSML_CA_BUNDLE, which only this project reads, names no file.
    """
    for variable in CA_VARIABLES:
        path = env.get(variable, "")
        if path and os.path.isfile(path):
            return os.path.abspath(path)
        if path and variable == "ROSML_CA_BUNDLE":
            raise Failure(f"ROSML_CA_BUNDLE={path}: no such file", "set it to a file of PEM certificates, or unset it")
    return ""


def registry_certificates(env: Mapping[str, str]) -> dict[str, list[str]]:
    """Files with the authorities that are trusted for registries, by host, where Docker looks for them.

    rosml/registry/certificates.py, which speaks to registries later, looks likewise.
    """
    own = env.get("DOCKER_CONFIG") or os.path.join(os.path.expanduser("~"), ".docker")
    found: dict[str, list[str]] = {}
    for folder in (CERTIFICATES, os.path.join(os.path.abspath(own), "certs.d")):
        for host in listing(folder):
            files = [os.path.join(folder, host, name) for name in listing(os.path.join(folder, host))]
            if files := [file for file in files if file.endswith(".crt") and os.access(file, os.R_OK)]:
                found.setdefault(host, []).extend(files)
    return found


def listing(folder: str) -> list[str]:
    """What is in a folder, sorted; nothing where it is none, or not this user's to read."""
    try:
        return sorted(os.listdir(folder))
    except OSError:
        return []


def docker_hub_answers(env: Mapping[str, str], bundle: str) -> bool:
    """Whether Docker Hub can be used: its registry API answers in time. ROSML_DOCKER_HUB=0 or 1 decides without asking.

    Only an answer of a registry counts: a proxy that turns a request down answers as well.
    """
    wish = env.get("ROSML_DOCKER_HUB", "")
    if wish in ("0", "1"):
        return wish == "1"
    if wish:
        raise Failure(f"ROSML_DOCKER_HUB={wish} is neither 0 nor 1", "unset it to let the set-up find out")
    answers: list[bool] = []
    # A thread, since the time limit of a request does not hold for the look-up of the name.
    asking = threading.Thread(target=lambda: answers.append(ask_docker_hub(bundle)), daemon=True)
    asking.start()
    asking.join(HUB_SECONDS + 1)
    return answers == [True]


def ask_docker_hub(bundle: str) -> bool:
    """One request to Docker Hub's registry API."""
    try:
        context = ssl.create_default_context(cafile=bundle or None)
        with urllib.request.urlopen(HUB_API, timeout=HUB_SECONDS, context=context) as answer:
            return is_registry(answer.status, answer.headers)
    except urllib.error.HTTPError as error:
        return is_registry(error.code, error.headers)
    except (OSError, http.client.HTTPException, ValueError):
        return False


def is_registry(status: int, headers: Message) -> bool:
    """Whether an answer to ``GET /v2/`` is a registry's: 200, or 401 that says where to get a token."""
    return status in (200, 401) and headers.get("Docker-Distribution-Api-Version", "").startswith("registry/")


def registry_answers(address: str, seconds: float = 3.0) -> bool:
    """Whether a registry answers on a loopback address; never through a proxy."""
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    try:
        with opener.open(f"http://{address}/v2/", timeout=seconds) as answer:
            return is_registry(answer.status, answer.headers)
    except (OSError, http.client.HTTPException):
        return False


def port_is_free(port: int) -> bool:
    """Whether a service could listen on this loopback port now."""
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return False
        return True


def free_port() -> int:
    """A loopback port that nothing listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def socket_answers(path: str, seconds: float = 3.0) -> bool:
    """Whether something accepts connections on a unix socket."""
    with socket.socket(socket.AF_UNIX) as probe:
        probe.settimeout(seconds)
        try:
            probe.connect(path)
        except OSError:
            return False
        return True
