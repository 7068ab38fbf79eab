"""Signs the indexes of images, each once."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Literal

from rosml.images.image_set.model import Image, Part
from rosml.images.publish.cosign import PATIENCE, SignerFailed
from rosml.images.publish.run import Outcome, Run
from rosml.images.records.store import INDEX


def sign(run: Run, thing: Image | Part, moving: bool = False) -> bool:
    """Signs the index of an image or part, if it needs a signature and lacks it. Returns whether it has what it needs.

    If a tag is about to move to the index (`moving`), cosign has to confirm the signature, even if the records name it.
    """
    entry = run.state.entries[thing.target, INDEX]
    if run.signer is None or (run.signer.identity in entry.signed and not moving):
        return True

    def add_outcome(state: Literal["done", "failed", "waits"], reason: str, seconds: float = 0.0) -> None:
        run.outcomes.append(Outcome("sign", thing.target, "", state, reason, seconds))

    with run.signing:
        if run.refused >= PATIENCE:
            add_outcome("waits", f"the signer failed {PATIENCE} times")
            return False
        started = time.monotonic()
        try:
            is_new = run.signer.ensure(run.state.place.reference(entry.repository, entry.digest))
        except SignerFailed as error:
            run.refused += 1
            run.say(f"failed: {error.message}; {error.remedy}")
            add_outcome("failed", error.message, time.monotonic() - started)
            return False
        run.refused = 0
    if run.signer.identity not in entry.signed:
        entry = replace(entry, signed={**entry.signed, run.signer.identity: run.state.date})
        run.state.entries[thing.target, INDEX] = entry
        run.records.write(entry, {})
    if is_new:
        add_outcome("done", f"by {run.signer.identity}", time.monotonic() - started)
    return True
