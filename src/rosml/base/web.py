"""HTTP clients, as the environment has it: proxies and certificates that cannot be used are told, and are no traceback."""

from __future__ import annotations

import functools
import os
import ssl
from typing import Any

import httpx

from rosml.base.errors import RosmlError

PROXIES = ("HTTPS_PROXY", "https_proxy", "HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy")


def client(**options: Any) -> httpx.Client:
    """A client of httpx, which trusts what `trusted` says unless told otherwise by `verify`.

    Raises:
        RosmlError: a variable of the environment names a proxy of a kind that is not supported, or certificates that cannot
            be read (exit code 2).
    """
    try:
        if "verify" not in options:  # who speaks plain http reads no certificates
            options["verify"] = trusted()
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


def trusted() -> ssl.SSLContext:
    """What TLS trusts by SSL_CERT_FILE or SSL_CERT_DIR, by default the usual authorities: for all clients, nobody changes it.

    Reading hundreds of certificates takes 50 ms, more than most requests.

    Raises:
        OSError: the file cannot be read, or has no certificate in PEM.
    """
    return _trusted(os.environ.get("SSL_CERT_FILE", ""), os.environ.get("SSL_CERT_DIR", ""))


@functools.cache
def _trusted(_file: str, _folder: str) -> ssl.SSLContext:
    return httpx.create_ssl_context()
