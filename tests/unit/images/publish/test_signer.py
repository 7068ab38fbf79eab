"""Signatures: with what cosign is called, what its failures become, and that nothing unsigned gets a tag."""

from __future__ import annotations

import json
from itertools import count
from pathlib import Path

import pytest

from fakes.memory_registry import HOST, LATER, NEXT, PREFIX, Pen, Publisher, Run, publisher
from fakes.stubs import calls, executable, services
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import cosign
from rosml.images.publish.cosign import PATIENCE, Signer, SignerFailed
from rosml.images.publish.run import Outcome
from rosml.images.records.store import INDEX

ONLY = ["alpha-core", "omega-core"]
REFERENCE = "127.0.0.1:5000/rosml/ros@sha256:1"
WORKFLOW = {
    "ACTIONS_ID_TOKEN_REQUEST_URL": "https://token.example",
    "GITHUB_SERVER_URL": "https://forge.example",
    "GITHUB_WORKFLOW_REF": "me/rosml/.github/workflows/nightly.yml@refs/heads/main",
}

COSIGN = """\
here='{folder}'
echo "cosign $*" >>"$here/calls"
for word; do reference=$word; done
name=$(printf %s "$reference" | tr '/:@' '___')
case $1 in
  version) echo '{{"gitVersion": "v3.1.3"}}' ;;
  public-key) if [ "$COSIGN_PASSWORD" = right ]; then echo PUBLIC; else echo 'Error: no' >&2; exit 1; fi ;;
  verify) echo WARNING: blah >&2; if [ -e "$here/$name" ]; then echo '[]'; else echo 'Error: no signatures found' >&2; exit 10; fi ;;
  sign) if [ -e "$here/broken" ]; then cat "$here/broken" >&2; exit 1; fi; if [ ! -e "$here/idle" ]; then echo "$*" >>"$here/$name"; fi ;;
esac
"""


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A checkout with a local replacement for cosign."""
    (tmp_path / "tools/go/cosign").mkdir(parents=True)
    (tmp_path / "tools/go/cosign/go.mod").write_text("\tgithub.com/sigstore/cosign/v3 v3.1.3\n")
    (tmp_path / ".state").mkdir()
    program = executable(tmp_path / "cosign", COSIGN.format(folder=tmp_path))
    (tmp_path / ".state/signer.json").write_text(json.dumps({"cosign": program}))
    return tmp_path


def with_key(root: Path, **more: str) -> Signer:
    return Signer.find(root, {"PATH": "/usr/bin:/bin", "COSIGN_KEY": "my.key", "COSIGN_PASSWORD": "right", **more})


# ---- The program -----------------------------------------------------------------------------------------------------


def test_by_a_key(root: Path) -> None:
    signer = with_key(root)
    assert signer.identity.startswith("sha256:") and signer.ensure(REFERENCE)
    (sign,) = [call for call in calls(root) if " sign " in call]
    assert sign == (
        "cosign sign --yes --key my.key --use-signing-config=false --tlog-upload=false --allow-http-registry "
        + REFERENCE
    )
    verify = [call for call in calls(root) if " verify " in call][-1].split()
    assert Path(verify[verify.index("--key") + 1]).read_text() == "PUBLIC\n", "the public one"
    assert signer.ensure(REFERENCE) is False, "it is there"
    assert sum(" sign " in call for call in calls(root)) == 1
    assert "right" not in repr(signer)


def test_keyless(root: Path) -> None:
    signer = Signer.find(root, {"PATH": "/usr/bin:/bin", **WORKFLOW})
    assert signer.identity == "https://forge.example/me/rosml/.github/workflows/nightly.yml@refs/heads/main"
    assert signer.ensure("ghcr.io/me/rosml/ros@sha256:1")
    assert [call for call in calls(root) if " sign " in call] == ["cosign sign --yes ghcr.io/me/rosml/ros@sha256:1"]
    assert f"--certificate-identity {signer.identity} --certificate-oidc-issuer {cosign.ISSUER}" in calls(root)[-1]


@pytest.mark.parametrize("absent", list(WORKFLOW))
def test_without_a_key_and_an_identity(root: Path, absent: str) -> None:
    environment = {"PATH": "/usr/bin:/bin"} | {name: text for name, text in WORKFLOW.items() if name != absent}
    with pytest.raises(SignerFailed, match="cannot sign") as caught:
        Signer.find(root, environment)
    assert "COSIGN_KEY" in caught.value.remedy and "id-token: write" in caught.value.remedy
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("file", "text", "password", "reason"),
    [
        ("idle", "", "right", r"has no signature of sha256:.*: Error: no signatures found"),
        (
            "broken",
            "WARNING: x\nError: x\nerror during command execution: the log is down\n",
            "right",
            rf"{REFERENCE} could not be signed: the log is down$",
        ),
        (".state/signer.json", "[]", "right", r"signer\.json is damaged"),
        ("tools/go/cosign/go.mod", "", "right", "pins no cosign"),
        ("idle", "", "wrong", "the signing key cannot be read: Error: no"),
    ],
)
def test_a_failure_of_cosign(root: Path, file: str, text: str, password: str, reason: str) -> None:
    (root / file).write_text(text)
    with pytest.raises(SignerFailed, match=reason):
        with_key(root, COSIGN_PASSWORD=password).ensure(REFERENCE)


def test_a_cosign_on_path(root: Path) -> None:
    (root / ".state/signer.json").unlink()
    assert with_key(root, PATH=f"{root}:/usr/bin:/bin").program == str(root / "cosign")
    with pytest.raises(SignerFailed, match="cosign, is not installed") as caught:
        with_key(root)
    assert caught.value.remedy == "run 'rosml setup signer'"


def test_another_version_is_not_used(root: Path) -> None:
    module = root / "tools/go/cosign/go.mod"
    module.write_text(module.read_text().replace("3.1.3", "3.1.4"))
    with pytest.raises(SignerFailed, match=r"is cosign 3\.1\.3, and 3\.1\.4 is pinned"):
        with_key(root)


# ---- A publishing run ------------------------------------------------------------------------------------------------


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    place = publisher(project, services(project), monkeypatch)
    place.pen = Pen(place.registry)
    return place


def signing(run: Run) -> list[Outcome]:
    return [outcome for outcome in run.outcomes if outcome.step == "sign"]


def test_every_index_is_signed_once(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    registry.check(image_set)
    indexes = {entry.digest for key, entry in run.state.entries.items() if key[1] == INDEX}
    assert {name.rpartition("@")[2] for name in registry.pen.signed} == indexes
    assert f"{HOST}/{PREFIX}/ros@{registry.tagged('ros')['alpha-core']}" in registry.pen.signed
    assert [outcome.state for outcome in signing(run)] == ["done"] * len(indexes)
    calls_before, writes = registry.pen.calls, registry.registry.writes
    again = registry.publish(image_set, only=ONLY, date=NEXT)
    assert (again.outcomes, registry.pen.calls, registry.registry.writes) == ([], calls_before, writes)
    registry.pen.identity = "sha256:another"
    registry.pen.signed.clear()
    other = registry.publish(image_set, only=ONLY, date=NEXT)
    assert len(registry.pen.signed) == len(indexes) and not other.actions
    entry = other.state.entries["alpha-core", INDEX]
    assert entry.signed.keys() == {"sha256:pen", "sha256:another"}


def test_without_a_signature_no_tag(registry: Publisher, image_set: ImageSet) -> None:
    registry.pen.broken = "the key is gone"
    run = registry.publish(image_set, only=ONLY)
    assert run.failed and registry.tagged("ros") == {}
    assert ("alpha-core", "failed", "the key is gone") in [(it.target, it.state, it.reason) for it in signing(run)]
    assert registry.pen.calls == PATIENCE, "a signer that is broken is not asked for every image"
    registry.pen.broken = ""
    mended = registry.publish(image_set, only=ONLY)
    assert not mended.actions and "alpha-core" in registry.tagged("ros")
    registry.check(image_set)


def test_a_signer_that_fails_now_and_then_is_asked_for_every_image(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, numbers = Pen.ensure, count()

    def ensure(pen: Pen, reference: str) -> bool:
        pen.broken = "the log is down" if next(numbers) % 2 else ""
        return real(pen, reference)

    monkeypatch.setattr(Pen, "ensure", ensure)
    states = [outcome.state for outcome in signing(registry.publish(image_set))]
    assert states.count("failed") > PATIENCE and "waits" not in states


def test_a_tag_that_moves_wants_more_than_the_recordss_word(registry: Publisher, image_set: ImageSet) -> None:
    """Somebody may have deleted the signature since."""
    run = registry.publish(image_set, only=ONLY)
    name = f"{HOST}/{PREFIX}/ros@{run.state.entries['alpha-core', INDEX].digest}"
    registry.pen.signed.remove(name)
    registry.registry.delete(f"{PREFIX}/ros", "alpha-core")
    again = registry.publish(image_set, only=ONLY, date=LATER)
    assert name in registry.pen.signed and [outcome.target for outcome in signing(again)] == ["alpha-core"]
    registry.check(image_set)
