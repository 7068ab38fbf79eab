"""The real cosign signs with a key and without a public log, in a registry with TLS and a password, or one that issues tokens.
Needs no builder: the nightly runs it before it relies on cosign. Keyless signing needs a service outside: it is not run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.publish.cosign import Signer, SignerFailed
from rosml.registry import oci
from rosml.registry.client import Registry
from tests.e2e import secure
from tests.e2e.secure import PASSWORD, Secure

pytestmark = pytest.mark.full(proof="signer")


@dataclass(frozen=True)
class Place:
    """A registry that is not everybody's, with an index.

    Attributes:
        secure: the registry. reference: of the index. environment: of a run that signs with a key of its own.
    """

    secure: Secure
    reference: str
    environment: Mapping[str, str]

    def signer(self) -> Signer:
        return Signer.find(ROOT, self.environment)


@pytest.fixture(params=["password", "tokens"])
def place(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with secure.used(tmp_path, request.param == "tokens", monkeypatch) as (secured, services, _docker):
        key = secure.signing_key(tmp_path / "test")
        index = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": []}
        digest = Registry(secured.host).put_manifest("images/small", "latest", index, oci.INDEX)
        reference = f"{secured.host}/images/small@{digest}"
        yield Place(secured, reference, {**services.trusting(), **key})


def test_it_signs_once_and_knows_its_signature(place: Place) -> None:
    signer = place.signer()
    with pytest.raises(SignerFailed, match="has no signature"):
        signer.verify(place.reference)
    assert signer.ensure(place.reference) is True
    signer.verify(place.reference)
    assert signer.ensure(place.reference) is False


def test_another_key_is_not_ours(place: Place, tmp_path: Path) -> None:
    place.signer().ensure(place.reference)
    other = {**place.environment, **secure.signing_key(tmp_path / "other")}
    with pytest.raises(SignerFailed, match="has no signature"):
        Signer.find(ROOT, other).verify(place.reference)


def test_where_it_may_not_write_it_fails(place: Place, tmp_path: Path) -> None:
    place.secure.docker_config(tmp_path / "other", {})
    signer = Signer.find(ROOT, {**place.environment, "DOCKER_CONFIG": str(tmp_path / "other")})
    with pytest.raises(SignerFailed, match="could not be signed") as caught:
        signer.ensure(place.reference)
    assert PASSWORD not in str(caught.value) and place.environment["COSIGN_PASSWORD"] not in str(caught.value)
