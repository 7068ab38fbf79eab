"""HTTP clients, as the environment has it: proxies and certificates that cannot be used are told, and are no traceback."""

from __future__ import annotations

import os
from typing import Any

import httpx

from rosml.base.errors import RosmlError

PROXIES = ("HTTPS_PROXY", "https_proxy", "HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy")


def client(**options: Any) -> httpx.Client:
    """A client of httpx.

    Raises:
        RosmlError: a variable of the environment names a proxy of a kind that is not supported, or certificates that cannot
            be read (exit code 2).
    """
    try:
        return httpx.Client(**options)
    except (ImportError, ValueError) as error:
        named = [f"{name}={os.environ[name].rpartition('@')[2]}" for name in PROXIES if os.environ.get(name)]
        text = f"a proxy of the environment cannot be used: {', '.join(named) or error}"
        raise RosmlError(text, "name proxies as http://host:port or https://host:port", exit_code=2) from None
    except OSError as error:
        name = os.environ.get("SSL_CERT_FILE", "")
        raise RosmlError(
            f"SSL_CERT_FILE={name}: {error.strerror or error}", "let it name certificates in PEM", exit_code=2
        ) from None
