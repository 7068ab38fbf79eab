"""What is attached to images of a real run: their entries of the records, where they came from, and signatures; that none
of it is uploaded twice, and none of it is in an image."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from rosml.images.builds.maker import BuildKitMaker
from rosml.images.publish import provenance
from rosml.images.publish.cosign import Signer, SignerFailed
from rosml.images.publish.run import Run
from rosml.images.publish.state import Request
from rosml.images.publish.steps import STEPS
from rosml.images.publish.survey import survey
from rosml.images.records import store
from rosml.images.records.store import INDEX, Records
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.place import Place
from tests import regctl
from tests.e2e import secure
from tests.e2e.calls import LOG
from tests.e2e.images import NATIVE
from tests.e2e.mini import Mini

ONLY = ("--only", "ros1-bookworm-core-tensorflow-cpu")


def entries(mini: Mini) -> dict[tuple[str, str], store.Entry]:
    book = Records(mini.place())
    names = [
        (name.rpartition(".")[0], name.rpartition(".")[2])
        for name in book.registry.tags(book.repository)
        if not name.startswith("undo.")
    ]
    return {key: entry for key in names if (entry := book.read(*key))}


def test_entries_and_provenance(mini: Mini) -> None:
    """A second run sends nothing; one whose records were lost carries on; another place has the same manifests."""
    mini.all(*ONLY)
    client, published = mini.client(), entries(mini)
    sizes = []
    for (target, architecture), entry in published.items():
        path = f"{mini.prefix}/{entry.repository}"
        if architecture != INDEX:
            assert Records(Place(client, mini.prefix)).attached(entry.repository, entry.digest) == entry
        reference = f"{mini.services.registry}/{path}@{entry.digest}"
        listed = regctl.regctl(mini.services, "artifact", "list", "--format", "{{json .}}", reference)
        kinds = [item["artifactType"] for item in json.loads(listed)["descriptors"]]
        for kind in (store.ARTIFACT, provenance.MEDIA_TYPE):
            assert kinds.count(kind) == (architecture != INDEX), f"{target}: {kinds}"
        for item in client.referrers(path, entry.digest):
            content = client.manifest(path, item["digest"])
            assert content
            if item["artifactType"] in (store.ARTIFACT, provenance.MEDIA_TYPE):
                sizes.append((item["artifactType"], content.size + content.content["layers"][0]["size"]))
    for kind in (store.ARTIFACT, provenance.MEDIA_TYPE):
        amounts = [size for name, size in sizes if name == kind]
        LOG.info("%s: %d, of %d bytes on average", kind, len(amounts), sum(amounts) / len(amounts))

    with Registry(mini.services.registry) as counting:
        services, place = Services.load(mini.folder), Place(counting, mini.prefix)
        here = (NATIVE,)
        state = survey(Request(services, mini.image_set, place, "2027-01-01T00:00:00Z", (ONLY[1],), here, here))
        again = Run(state, BuildKitMaker(services, mini.image_set, place, LOG.info), LOG.info)
        for step in STEPS.values():
            step(again)
        assert (again.outcomes, counting.uploaded) == ([], 0)

    other = mini.elsewhere()
    other.all(*ONLY, "--force")
    images = {key: entry.digest for key, entry in published.items() if key[1] != INDEX}
    assert {key: entry.digest for key, entry in entries(other).items() if key[1] != INDEX} == images


@pytest.fixture
def cosign(tmp_path: Path, mini: Mini) -> dict[str, str]:
    """The environment of a run that signs with a key of its own."""
    (mini.folder / ".state/signer.json").write_text(json.dumps({"cosign": secure.cosign()}))
    return secure.signing_key(tmp_path / "test")


@pytest.mark.full(proof="signer")
def test_signatures(mini: Mini, cosign: dict[str, str]) -> None:
    """By the real cosign: before tags move, once, and only ours count."""
    refused = mini.publish("all", "--serve", NATIVE, "--sign", *ONLY, env=cosign | {"COSIGN_PASSWORD": "wrong"})
    assert refused.code == 1 and "the signing key cannot be read" in refused.err and "COSIGN_PASSWORD" in refused.err
    assert mini.tags() == {}, "it is told before anything is built"
    done = mini.all(*ONLY, "--sign", env=cosign)
    signed = [item["target"] for item in done["outcomes"] if item["step"] == "sign"]
    signer = Signer.find(mini.folder, {**os.environ, **cosign})
    client, published = mini.client(), entries(mini)
    indexes = {target: entry for (target, architecture), entry in published.items() if architecture == INDEX}
    assert sorted(signed) == sorted(indexes)
    for entry in indexes.values():
        reference = f"{mini.services.registry}/{mini.prefix}/{entry.repository}@{entry.digest}"
        signer.verify(reference)
        assert signer.identity in entry.signed
        assert signer.ensure(reference) is False
        kinds = [item["artifactType"] for item in client.referrers(f"{mini.prefix}/{entry.repository}", entry.digest)]
        assert sum("sigstore" in kind for kind in kinds) == 1, kinds
    assert mini.all(*ONLY, "--sign", env=cosign)["outcomes"] == []

    image = published["ros1-bookworm-core", NATIVE]
    with pytest.raises(SignerFailed, match="has no signature"):
        signer.verify(f"{mini.services.registry}/{mini.prefix}/ros@{image.digest}")
    pruned = mini.says("prune", "--days", "0", "--newest", "0")
    assert pruned["manifests"] == [], "signatures of kept indexes stay"
