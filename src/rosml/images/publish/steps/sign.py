"""Signs the indexes of images, each once."""

from __future__ import annotations

import time
from dataclasses import replace

from rosml.images.image_set.model import Image, Part
from rosml.images.publish.cosign import PATIENCE, SignerFailed
from rosml.images.publish.run import Run
from rosml.images.records.store import INDEX


def sign(run: Run, thing: Image | Part, moving: bool = False) -> bool:
    """Signs an index that lacks a signature. Returns whether it has what it needs. If a tag moves to it, cosign checks it."""
    entry = run.state.entries[thing.target, INDEX]
    if run.signer is None or (run.signer.identity in entry.signed and not moving):
        return True

    with run.signing:
        if run.refused >= PATIENCE:
            run.add("sign", thing, "waits", f"the signer failed {PATIENCE} times")
            return False
        started = time.monotonic()
        try:
            is_new = run.signer.ensure(run.state.place.reference(entry.repository, entry.digest))
        except SignerFailed as error:
            run.refused += 1
            run.say(f"failed: {error.message}; {error.remedy}")
            run.add("sign", thing, "failed", error.message, started)
            return False
        run.refused = 0
    if run.signer.identity not in entry.signed:
        run.write(replace(entry, signed={**entry.signed, run.signer.identity: run.state.date}))
    if is_new:
        run.add("sign", thing, "done", f"by {run.signer.identity}", started)
    return True
