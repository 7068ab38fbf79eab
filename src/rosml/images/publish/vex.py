"""Attaches to an image what the policy says of its vulnerabilities, if that has changed. The index names it by its digest, so that
its signature covers it. If the image stays, its index stays as well, and a newer VEX gets a signature of its own."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

from rosml.base.errors import RosmlError
from rosml.images.image_set.model import Image, Part
from rosml.images.publish.cosign import PATIENCE, SignerFailed
from rosml.images.publish.run import Run
from rosml.images.records.store import CREATED, INDEX, Entry
from rosml.images.scan import vex
from rosml.images.scan.judge import Outcome, Scanned
from rosml.images.scan.sbom import MEDIA_TYPE as CYCLONEDX
from rosml.images.scan.vex import Statement
from rosml.registry import oci
from rosml.registry.place import Place


def statements(scanned: Scanned, entry: Entry) -> list[Statement] | None:
    """What is said of an image's findings; None if nobody knows. If an image has VEX already, all findings count: nothing is withdrawn in
    silence."""
    if scanned.outcome is Outcome.SCANNER_FAILED:
        return None
    return vex.statements(scanned.findings) or vex.statements(scanned.findings, every=bool(entry.vex))


def is_new(entry: Entry, judged: Sequence[Statement] | None) -> bool:
    """Whether an image's VEX does not say this yet. `entry` is the one before the scan."""
    return bool(judged) and not (entry.vex and entry.scan.get("vex") == vex.digest(judged or ()))


def attach(place: Place, entry: Entry, judged: Sequence[Statement], date: str) -> Entry:
    """Attaches VEX to an image; gives the entry that names it."""
    repository = place.path(entry.repository)
    subject = place.client.manifest(repository, entry.digest)
    if subject is None:
        raise RosmlError(f"{repository}@{entry.digest} is not in the registry any more", "publish it again")
    reference = f"{place.client.host}/{repository}@{entry.digest}"
    other = vex.in_cyclonedx(reference, judged, date)
    place.client.put_blob(repository, other)
    document = vex.openvex(reference, judged, date)
    artifact = oci.artifact(vex.MEDIA_TYPE, document, vex.MEDIA_TYPE, {CREATED: date}, subject.descriptor)
    digest = place.client.attach_with_layers(repository, document, artifact, [oci.descriptor(CYCLONEDX, other)])
    return replace(entry, vex=digest, signed={})


def digests(members: Sequence[Entry]) -> str:
    """The digests of the VEX of an index's images, for the entry of the index."""
    return " ".join(member.vex for member in members if member.vex)


def sign(run: Run, thing: Image | Part) -> None:
    """Signs the VEX of images whose index is older and does not name it. A failure stops no tag."""
    members = [run.state.entries[key] for key in run.state.members(thing)]
    if run.signer is None or run.state.entries[thing.target, INDEX].vex == digests(members):
        return
    for member in members:
        if not member.vex or run.signer.identity in member.signed or run.refused >= PATIENCE:
            continue
        started = time.monotonic()
        try:
            with run.signing:
                run.signer.ensure(run.state.place.reference(member.repository, member.vex))
        except SignerFailed as error:
            run.refused += 1
            run.add("sign", thing, "failed", f"its VEX: {error.message}", started)
            return
        run.write(replace(member, signed={**member.signed, run.signer.identity: run.state.date}))
        run.add("sign", thing, "done", f"its VEX for {member.architecture}, by {run.signer.identity}", started)
