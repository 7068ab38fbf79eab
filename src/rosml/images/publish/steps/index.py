"""Makes an index of every image whose architectures are all built, tested and alike. No tag moves, so nobody sees it yet."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.labels import COVERED, OCI, REVISION, SBOM, SOURCE, TITLE, VEX, title
from rosml.images.image_set.model import Image, Part
from rosml.images.publish import provenance, same_content, vex
from rosml.images.publish.run import Run, failure
from rosml.images.publish.steps.sign import sign
from rosml.images.records.store import DATE, INDEX, INPUTS, Entry
from rosml.registry import oci
from rosml.registry.oci import Config, Manifest


def index(run: Run) -> None:
    """Makes and signs indexes, side by side: one after the other, hundreds would take hours on a distant registry."""
    before, things = len(run.outcomes), list[Image | Part]()
    for thing in run.state.things():
        if reason := run.state.unready(thing):
            run.add("index", thing, "waits", reason)
        elif _is_current(run, thing):
            vex.sign(run, thing)
        else:
            things.append(thing)
    side_by_side(partial(_make, run), things)
    run.put_in_order(before)


def _is_current(run: Run, thing: Image | Part) -> bool:
    state, entry = run.state, run.state.index_of(thing)
    if entry is None or (thing.target, INDEX) not in state.present:
        return False
    if state.request.force and entry.date != state.date:
        return False
    return state.is_of_these(thing, entry) and not entry.failed


def _make(run: Run, thing: Image | Part) -> None:
    """Makes and signs the index of an image, and records the result."""
    started, state = time.monotonic(), run.state
    members, inputs = [state.entries[key] for key in state.members(thing)], state.inputs.together(thing)
    entry = state.index_of(thing) or Entry(thing.target, INDEX)
    try:
        entry = entry.with_digest(
            _put(run, thing, members, inputs),
            inputs=inputs,
            repository=thing.repository,
            parts={member.architecture: member.digest for member in members},
            vex=vex.digests(members),
            date=state.date,
        )
        reason = counted(len(members), "architecture")
    except RosmlError as error:
        entry, reason = replace(entry, failed=failure("index", error.message, error.remedy)), error.message
    run.write(entry)
    run.add("index", thing, "failed" if entry.failed else "done", reason, started)
    if not entry.failed:
        sign(run, thing)


def _put(run: Run, thing: Image | Part, members: Sequence[Entry], inputs: str) -> str:
    """Puts an index, and returns its digest. Fails if the architectures differ in content, or the records name another image's manifest."""
    place = run.state.place
    repository = place.path(thing.repository)
    images = {entry.architecture: _image(run, repository, entry.digest) for entry in members}
    configs = {architecture: config for architecture, (_, config) in images.items()}
    for entry in members:
        _require_title(thing, entry, configs[entry.architecture])
    versions = {entry.architecture: entry.versions for entry in members}
    released = [item.name for item in thing.brought if item.released] if isinstance(thing, Image) else []
    contents = {architecture: config.content for architecture, config in configs.items()}
    same_content.require(thing.target, contents, versions, released)
    labels = configs[members[0].architecture].labels
    annotations = _checkout(run) | {name: text for name, text in labels.items() if name.startswith(OCI)}
    annotations |= {INPUTS: inputs, DATE: run.state.date}
    manifests = [
        {**manifest.descriptor, "platform": _platform(config), **_covered(run, entry)}
        for entry, (manifest, config) in zip(members, images.values(), strict=True)
    ]
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": manifests, "annotations": annotations}
    return place.client.put_manifest(repository, "", content, oci.INDEX)


def _image(run: Run, repository: str, digest: str) -> tuple[Manifest, Config]:
    registry = run.state.place.client
    manifest = registry.manifest(repository, digest)
    if manifest is None:
        raise RosmlError(f"{repository}@{digest} is not in the registry any more", "run 'build' and 'join' again")
    return manifest, registry.config(repository, manifest)


def _require_title(thing: Image | Part, entry: Entry, config: Config) -> None:
    """Checks that the manifest that an entry names is one of the entry's image: others may write into the registry."""
    image, architecture = config.labels.get(TITLE, ""), config.facts.architecture or ""
    if (image, architecture) != (title(thing), entry.architecture):
        raise RosmlError(
            f"the records' entry {entry.tag} names {entry.digest},"
            f" which is {image or 'an image without a title'} for {architecture or 'no architecture'}",
            "publish it again with --force",
        )


def _platform(config: Config) -> dict[str, str]:
    facts = config.facts
    platform = {"os": facts.os or "linux", "architecture": facts.architecture, "variant": facts.variant}
    return {name: value for name, value in platform.items() if value}


def _covered(run: Run, entry: Entry) -> dict[str, dict[str, str]]:
    """Annotations of an image in its index: digests of statements and SBOMs, so that a signature of the index covers them."""
    annotations = {provenance.COVERED: " ".join(sorted(entry.provenance.values()))} if entry.provenance else {}
    item = run.state.by_key[entry.target, entry.architecture]
    for target in item.needs if item.kind == "joined" else (item.target,):
        part = run.state.entries.get((target, entry.architecture))
        if part and part.sbom and part.digest == entry.parts.get(target, entry.digest):
            annotations[COVERED + target] = f"{part.repository}@{part.sbom}"
    if item.kind == "joined" and entry.sbom:
        annotations[SBOM] = f"{entry.repository}@{entry.sbom}"
    if entry.vex:
        annotations[VEX] = f"{entry.repository}@{entry.vex}"
    return {"annotations": annotations} if annotations else {}


def _checkout(run: Run) -> dict[str, str]:
    """Annotations of an index about the checkout. Images have no revision, because every commit would change all of them."""
    source = next(iter(run.source), {})
    address, revision = source.get("uri", "").removeprefix("git+"), source.get("digest", {}).get("gitCommit", "")
    annotations = {SOURCE: address, REVISION: "" if "annotations" in source else revision}
    return {name: text for name, text in annotations.items() if text}
