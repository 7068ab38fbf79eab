"""Certificates for programs that this project calls."""

from __future__ import annotations

import ssl
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.machine.services import Services
from rosml.registry import certificates


def trusting(services: Services) -> dict[str, str]:
    """The environment of a program that looks for authorities only in a bundle, for all registries.

    Certificates that this user may not read are left out. If the client asks their registry, its error names them.
    """
    env = services.environment()
    certificate_files = [file for files_of_host in certificates.by_host().values() for file in files_of_host]
    if not certificate_files:
        return env
    base = services.ca_bundle or ssl.get_default_verify_paths().cafile or ""
    try:
        texts = [file.read_text(errors="replace") for file in (*([Path(base)] if base else []), *certificate_files)]
    except OSError as error:
        raise RosmlError(f"cannot read {error.filename}: {error.strerror}", "let this user read it") from None
    bundle = services.state / "cache" / "authorities.pem"
    bundle.parent.mkdir(parents=True, exist_ok=True)
    files.write(bundle, "\n".join(texts))
    return {**env, "SSL_CERT_FILE": str(bundle)}
