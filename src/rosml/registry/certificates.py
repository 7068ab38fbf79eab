"""Certificates of private authorities for registries, from the folders that Docker reads: `certs.d/<host>/*.crt`.

`rosml setup` gives them to the builder. buildx and trivy do not read these folders: they get a bundle with all certificates.
"""

from __future__ import annotations

import os
import ssl
from pathlib import Path

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.registry import credentials

SYSTEM = Path("/etc/docker/certs.d")


def folders() -> list[Path]:
    """The folders with certificates: of the machine, and beside the user's config file of Docker."""
    user_folder = credentials.folder()
    return [SYSTEM, *([user_folder / "certs.d"] if user_folder else [])]


def of(host: str) -> list[Path]:
    files: list[Path] = []
    for folder in folders():
        try:
            files += sorted(file for file in (folder / host).iterdir() if file.suffix == ".crt")
        except OSError:  # the folder is missing, or unreadable for this user
            continue
    return files


def by_host() -> dict[str, list[Path]]:
    """As far as they are readable."""
    files_by_host: dict[str, list[Path]] = {}
    for file in [file for folder in folders() for file in sorted(folder.glob("*/*.crt"))]:
        if file.is_file() and os.access(file, os.R_OK):
            files_by_host.setdefault(file.parent.name, []).append(file)
    return files_by_host


def context(ca_bundle: str, authorities: list[Path]) -> ssl.SSLContext:
    """The TLS context that trusts a bundle and further files. The default of `ca_bundle` is that of SSL_CERT_FILE, or the usual one."""
    source = ca_bundle or "the file that SSL_CERT_FILE names"
    try:
        if not (ca_bundle or authorities):
            return web.trusted()
        trusting = ssl.create_default_context(cafile=ca_bundle) if ca_bundle else httpx.create_ssl_context()
        for file in authorities:
            source = str(file)
            trusting.load_verify_locations(file)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else "it has no certificate"
        if isinstance(error, ssl.SSLError):
            reason = "it has no certificate in PEM"
        raise RosmlError(f"{source}: {reason}", "use a file with certificates in PEM", exit_code=2) from None
    return trusting


def remedy(host: str, reason: str) -> str:
    """The remedy for a reason in the words of OpenSSL or Go."""
    if "expired" in reason:
        return "its operator has to renew it; if it is new, check this machine's clock"
    if "not yet valid" in reason:
        return "check this machine's clock"
    if "mismatch" in reason or "not valid for" in reason or "is valid for" in reason or "IP SANs" in reason:
        return "call the registry by a name that its certificate has"
    place = folders()[-1] / host / "ca.crt"
    return f"put its authority's certificate into {place}, then run 'rosml setup' for the builder"
