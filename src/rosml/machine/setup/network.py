"""Checks of the network: Docker Hub, loopback ports and sockets."""

from __future__ import annotations

import os
import socket
import ssl
import threading
import time

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError

HUB_API = "https://registry-1.docker.io/v2/"
HUB_SECONDS = 5.0
WAIT_SECONDS = 5.0
"""Seconds before the second attempt; before the third one, twice as many."""


def docker_hub_answers(ca_bundle: str, attempts: int = 1) -> bool:
    """Whether Docker Hub's registry API answers in time. ROSML_DOCKER_HUB=0 or 1 decides without asking.

    Only a registry's answer counts, because a proxy also answers if it refuses a request.
    """
    wish = os.environ.get("ROSML_DOCKER_HUB", "")
    if wish in ("0", "1"):
        return wish == "1"
    if wish:
        raise RosmlError(f"ROSML_DOCKER_HUB={wish} is neither 0 nor 1", "unset it to let setup find out")
    for attempt in range(attempts):
        time.sleep(attempt * WAIT_SECONDS)
        answers: list[bool] = []
        # A thread, because a request's time limit does not cover the name's look-up.
        asking = threading.Thread(target=_ask_docker_hub, args=(ca_bundle, answers), daemon=True)
        asking.start()
        asking.join(HUB_SECONDS + 1)
        if answers == [True]:
            return True
    return False


def _ask_docker_hub(ca_bundle: str, answers: list[bool]) -> None:
    try:
        trusted = ssl.create_default_context(cafile=ca_bundle or None)
        with web.client(verify=trusted, timeout=HUB_SECONDS) as client, client.stream("GET", HUB_API) as answer:
            # A registry's answer to /v2/ is 200, or 401 with the place of a token.
            is_registry = answer.headers.get("Docker-Distribution-Api-Version", "").startswith("registry/")
            answers.append(is_registry and answer.status_code in (200, 401))
    except (httpx.HTTPError, httpx.InvalidURL, OSError, ValueError, RosmlError):
        answers.append(False)


def answers(address: str) -> bool:
    try:
        with web.client(timeout=HUB_SECONDS) as client:
            client.head(address)
    except (httpx.HTTPError, httpx.InvalidURL, OSError, ValueError, RosmlError):
        return False
    return True


def port_is_free(port: int) -> bool:
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return False
        return True


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def socket_answers(path: str) -> bool:
    with socket.socket(socket.AF_UNIX) as probe:
        probe.settimeout(3.0)
        try:
            probe.connect(path)
        except OSError:
            return False
        return True
