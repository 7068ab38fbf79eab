"""Signs indexes with cosign: with a key, or keyless as the workflow that runs on GitHub.

cosign signs the digest of an index, before a tag points at it. The signature covers the images, too, because the index
names their digests. A signature is an artifact beside the index. If cosign finds one, no other is made.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version

INSTALL = "run 'rosml setup signer'"
SECONDS = 180.0
"""Time limit of a call: keyless ones ask three services."""

PATIENCE = 3
"""After this many failures in a row, the signer is not called again in this run."""

LOOPBACK = re.compile(r"(?:127\.0\.0\.1|localhost|\[::1\])(?::\d+)?(?=/)")
"""A registry of this machine."""

ISSUER = "https://token.actions.githubusercontent.com"
"""The issuer of a workflow's identity."""

WITHOUT_LOG = ("--use-signing-config=false", "--tlog-upload=false")
"""Options for keys: cosign asks no service and writes into no public log."""


class SignerFailed(RosmlError):
    """Nothing was signed."""


@dataclass(frozen=True)
class Signer:
    """The program, and whose signature it makes."""

    program: str  # path of cosign
    identity: str  # of the signature: a digest of the public key, or the workflow
    signing: tuple[str, ...]  # options for signing
    verifying: tuple[str, ...]  # options for verification
    environment: Mapping[str, str] = field(default_factory=dict, repr=False)  # of calls; a key's password may be in it

    @classmethod
    def find(cls, root: Path, environment: Mapping[str, str] = os.environ) -> Signer:
        """The cosign of `rosml setup signer`, or one of that version on PATH. `COSIGN_KEY` names a key; without it, it is keyless."""
        program = _program(root, environment)
        key = environment.get("COSIGN_KEY", "")
        if key:
            return cls._with_key(program, key, root, environment)
        workflow, server = environment.get("GITHUB_WORKFLOW_REF", ""), environment.get("GITHUB_SERVER_URL", "")
        if not (environment.get("ACTIONS_ID_TOKEN_REQUEST_URL") and workflow and server):
            text = "cannot sign: COSIGN_KEY names no key, and this is no workflow with an identity"
            remedy = "set COSIGN_KEY to a key (cosign generate-key-pair), or give the job the right 'id-token: write'"
            raise SignerFailed(text, remedy, exit_code=2)
        identity = f"{server}/{workflow}"
        verifying = ("--certificate-identity", identity, "--certificate-oidc-issuer", ISSUER)
        return cls(program, identity, (), verifying, environment)

    @classmethod
    def trusted(cls, root: Path, signer: str, environment: Mapping[str, str] = os.environ) -> Signer:
        """To verify alone. `signer` is whom the caller trusts: a file with a public key, or a workflow on GitHub, `https://…`."""
        workflow = ("--certificate-identity", signer, "--certificate-oidc-issuer", ISSUER)
        key = ("--key", signer, "--insecure-ignore-tlog=true")
        verifying = workflow if signer.startswith("https://") else key
        return cls(_program(root, environment), signer, (), verifying, environment)

    @classmethod
    def _with_key(cls, program: str, key: str, root: Path, environment: Mapping[str, str]) -> Signer:
        remedy = "set COSIGN_KEY to a file with a private key or to a key service, and COSIGN_PASSWORD to the file's password"
        public = _call(program, ("public-key", "--key", key), environment, "the signing key cannot be read", remedy)
        identity = f"sha256:{hashlib.sha256(public.strip().encode()).hexdigest()}"
        folder = root / ".state" / "signer"
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / f"{identity.partition(':')[2][:16]}.pub"
        files.write(file, public)
        verifying = ("--key", str(file), "--insecure-ignore-tlog=true")
        return cls(program, identity, ("--key", key, *WITHOUT_LOG), verifying, environment)

    def signed(self, reference: str) -> bool:
        """Whether cosign finds our signature of an index."""
        with contextlib.suppress(SignerFailed):
            self.verify(reference)
            return True
        return False

    def verify(self, reference: str) -> None:
        """Checks that an index has our signature."""
        text = f"{reference} has no signature of {self.identity}"
        arguments = ("verify", *self.verifying, *_plain(reference), reference)
        _call(self.program, arguments, self.environment, text, "sign it: rosml publish promote --sign")

    def ensure(self, reference: str) -> bool:
        """Signs an index, unless it has our signature. Returns whether it was signed now."""
        if self.signed(reference):
            return False
        remedy = "see cosign's message; the next run signs indexes without a signature"
        arguments = ("sign", "--yes", *self.signing, *_plain(reference), reference)
        _call(self.program, arguments, self.environment, f"{reference} could not be signed", remedy)
        self.verify(reference)
        return True


def _program(root: Path, environment: Mapping[str, str]) -> str:
    file = root / ".state" / "signer.json"
    try:
        program = str(untrusted.json_value(file.read_bytes())["cosign"])
    except FileNotFoundError:
        program = shutil.which("cosign", path=environment.get("PATH")) or ""
    except (OSError, ValueError, KeyError, TypeError):
        raise SignerFailed(f"{file} is damaged", INSTALL) from None
    if not program:
        raise SignerFailed("the signer, cosign, is not installed", INSTALL)
    output = _call(program, ("version", "--json"), environment, f"{program} does not say its version", INSTALL)
    match = re.search(r'"gitVersion":\s*"v?([^"]*)"', output)
    version, pinned = match[1] if match else "", pinned_version(root, "cosign", SignerFailed)
    if version != pinned:
        raise SignerFailed(f"{program} is cosign {version or 'of unknown version'}, and {pinned} is pinned", INSTALL)
    return program


def _plain(reference: str) -> tuple[str, ...]:
    """Options for registries on loopback, which speak plain http."""
    return ("--allow-http-registry",) if LOOPBACK.match(reference) else ()


def _call(program: str, arguments: tuple[str, ...], environment: Mapping[str, str], text: str, remedy: str) -> str:
    try:
        done = subprocess.run(
            [program, *arguments],
            env=dict(environment),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
        )
    except OSError as error:
        raise SignerFailed(f"cannot run {program}: {error.strerror}", INSTALL) from None
    except subprocess.TimeoutExpired:
        raise SignerFailed(f"{text}: cosign did not end within {SECONDS:.0f} s", remedy) from None
    if done.returncode != 0:
        lines = [line for line in done.stderr.strip().splitlines() if not line.startswith("WARNING:")]
        reason = lines[-1].removeprefix("error during command execution: ")[:500] if lines else ""
        raise SignerFailed(f"{text}: {reason or f'exit code {done.returncode}'}", remedy)
    return done.stdout
