"""Puts a dossier together from what a registry has of an image: manifests, configs and what is attached. It needs read access alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeVar

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed
from rosml.images.dossier import evidence, fields, licences, rebuild, scan, spdx_document, support, texts
from rosml.images.dossier.bill import Bill
from rosml.images.dossier.evidence import Origin, Signature, Statement
from rosml.images.dossier.fields import Field
from rosml.images.dossier.licences import Texts
from rosml.images.dossier.rebuild import Rebuild
from rosml.images.dossier.scan import Scan
from rosml.images.dossier.support import End
from rosml.images.image_set.labels import LOCK
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.matrix.model import Matrix
from rosml.images.scan import attached
from rosml.images.scan.sbom import Sbom
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

TEXTS = "licence-texts.txt"

Form = Literal["cyclonedx", "spdx"]

T = TypeVar("T")


@dataclass(frozen=True)
class Request:
    """`signer`: whom the caller trusts, as in `evidence.signature_of`. `root`: of the checkout, which may have trivy and cosign."""

    name: str
    platform: str
    form: Form
    signer: str
    root: Path
    matrix: Matrix
    now: str
    with_texts: bool = False
    say: Callable[[str], None] = lambda line: None


@dataclass
class Dossier:
    """All that a dossier says. `missing` has what it lacks, and why, in sentences; `files` are its files by name, without the page."""

    image: Source
    tagged: str  # the digest of what the name points at: an index, or the image itself
    now: str
    signature: Signature
    bill: Bill | None = None
    fields: tuple[Field, ...] = ()
    ends: list[End] = field(default_factory=list)
    scan: Scan | None = None
    texts: list[Texts] = field(default_factory=list)
    origins: list[Origin] = field(default_factory=list)
    vex: Statement | None = None
    rebuild: Rebuild | None = None
    missing: list[str] = field(default_factory=list)
    files: dict[str, str] = field(default_factory=dict)

    @property
    def reference(self) -> str:
        return f"{self.image.host}/{self.image.repository}@{self.image.digest}"

    def to_json(self) -> dict[str, Any]:
        return {
            "image": self.reference,
            "name": self.image.name,
            "platform": self.image.platform,
            "tagged": self.tagged,
            "written": self.now,
            "components": len(self.bill.components) if self.bill else 0,
            "fields": [it.to_json() for it in self.fields],
            "support": [it.to_json() for it in self.ends],
            "vulnerabilities": dict(self.scan.counts) if self.scan else None,
            "database": self.scan.database.updated if self.scan else None,
            "database_age_in_days": self.scan.age if self.scan else None,
            "signature": self.signature.state,
            "missing": self.missing,
        }


def gather(request: Request, transfer: Transfer) -> Dossier:
    """RosmlError with exit code 2 if there is no such image. Everything else that is not there is said in the dossier."""
    image, manifest = _image(request, transfer)
    registry = transfer.registries(image.host)
    missing = list[str]()
    signature = _tried(
        "signature",
        lambda: evidence.signature_of(registry, image.repository, manifest, request.signer, request.root),
        missing,
    )
    dossier = Dossier(image, manifest.digest, request.now, signature or Signature("unknown", ""), missing=missing)
    if not rebuild.is_ours(image.labels):
        missing.append("rosml did not make this image: what rosml attaches to its images is missing")
    sbom = _sbom(dossier, registry, request)
    _evidence(dossier, registry, request)
    _support(dossier, request.matrix)
    if sbom and dossier.bill:
        _licences(dossier, registry, request)
        request.say("look for vulnerabilities")
        _scan(dossier, sbom, request)
    return dossier


def _image(request: Request, transfer: Transfer) -> tuple[Source, Manifest]:
    """The image for one platform, and what the name points at."""
    from rosml.images.builds.base_images import native_architecture

    where = references.parse(request.name)
    members = transfer.platforms(request.name)  # says what else there is if the name is wrong
    manifest = transfer.manifest(where)
    if manifest is None or not members:
        raise RosmlError(f"{request.name} is for no platform", "name another image", exit_code=2)
    here = f"linux/{native_architecture()}"
    platform = request.platform or (here if here in members else next(iter(members)))
    if platform not in members:
        text = f"{request.name} is not for {platform}"
        raise RosmlError(text, f"name one of its platforms: {listed(sorted(members))}", exit_code=2)
    if not request.platform and len(members) > 1:
        request.say(f"{platform} of {listed(sorted(members))}; --platform names another one")
    return members[platform], manifest


def _tried(what: str, read: Callable[[], T], missing: list[str]) -> T | None:
    """What a part of the dossier says. If it cannot be read, the others still can."""
    try:
        return read()
    except RosmlError as error:
        missing.append(f"{what}: {error.message}{f'; {error.remedy}' if error.remedy else ''}")
        return None


# ---- The parts -------------------------------------------------------------------------------------------------------


def _sbom(dossier: Dossier, registry: Registry, request: Request) -> Sbom | None:
    request.say("read the SBOM")
    image, missing = dossier.image, dossier.missing
    answer = _tried("SBOM", lambda: attached.read(registry, image.repository, image.digest), missing)
    if answer is None:
        return None
    missing += [f"the SBOM {it.digest} does not count: {it.why}" for it in answer.ignored]
    if not answer.sboms:
        missing.append("SBOM: none of rosml is attached; build the image again with this rosml, and without --no-sbom")
        return None
    covered = [it for it in zip(answer.artifacts, answer.sboms, strict=True) if evidence.names_sbom(image, it[0])]
    if len(answer.sboms) > 1 and not covered:
        missing.append(f"{len(answer.sboms)} SBOMs are attached, and the index names none of them: this is the first")
    sbom = covered[0][1] if covered else answer.sboms[0]
    dossier.bill = bill = Bill.of(sbom.content)
    dossier.fields = fields.check(bill)
    if request.form == "spdx":
        dossier.files["sbom.spdx.json"] = spdx_document.document(bill, dossier.reference).decode()
    else:
        dossier.files["sbom.cdx.json"] = sbom.content.decode()
    return sbom


def _evidence(dossier: Dossier, registry: Registry, request: Request) -> None:
    image, missing = dossier.image, dossier.missing
    place = image.host, image.repository

    def is_signed(digest: str) -> bool:
        return evidence.is_signed(*place, digest, request.signer, request.root)

    if answer := _tried("provenance", lambda: evidence.provenance_of(registry, image), missing):
        statements, others = answer
        dossier.origins = [Origin.of(it.content) for it in statements]
        for number, it in enumerate(statements):
            dossier.files[f"provenance{f'-{number + 1}' if number else ''}.json"] = evidence.encoded(it.content)
        if others:
            missing.append(f"{counted(others, 'statement')} of provenance that the index does not name are left out")
        if not statements:
            missing.append("provenance: the index names none, as of images that rosml publish did not make")
    if answer_about := _tried("VEX", lambda: (evidence.vex_of(registry, image, is_signed),), missing):
        _vex(dossier, *answer_about)
    lock = _tried("lock", lambda: evidence.lock_of(image.labels, LOCK), missing)
    if lock:
        dossier.files[rebuild.LOCK_FILE] = lock
    if rebuild.is_ours(image.labels):
        dossier.rebuild = rebuild.of(image.labels, bool(lock), next((it.commit for it in dossier.origins), ""))


def _vex(dossier: Dossier, vex: Statement | None) -> None:
    if vex is None:
        dossier.missing.append("VEX: none is attached")
        return
    dossier.vex = vex
    dossier.files["vex.openvex.json"] = evidence.encoded(vex.content)
    if not vex.vouched:
        dossier.missing.append("no signature covers the VEX: anyone who may push there may have made it")


def _support(dossier: Dossier, matrix: Matrix) -> None:
    components = dossier.bill.components if dossier.bill else []
    distribution = dossier.image.labels.get(rebuild.DISTRIBUTION, "")
    dossier.ends = support.ends(components, distribution, matrix)


def _licences(dossier: Dossier, registry: Registry, request: Request) -> None:
    assert dossier.bill
    files, why = licences.read(registry, dossier.image)
    dossier.texts = licences.of(dossier.bill, files)
    dossier.files["licences.txt"] = licences.listing(dossier.texts, files is not None)
    if why:
        dossier.missing.append(f"whether the texts of licences are in the image: {why}")
    elif without := licences.without_text(dossier.texts):
        dossier.missing.append(f"the image has no text of the licences of {counted(len(without), 'component')}")
    if request.with_texts:
        places = licences.all_places(dossier.bill, files or ())
        if by_path := _tried(
            "texts of licences", lambda: texts.read(registry, dossier.image, places, request.say), dossier.missing
        ):
            dossier.files[TEXTS] = texts.listing(by_path)


def _scan(dossier: Dossier, sbom: Sbom, request: Request) -> None:
    vex: Mapping[str, Any] | None = dossier.vex.content if dossier.vex else None
    dossier.scan = _tried(
        "scan", lambda: scan.scan(dossier.image, sbom, vex, request.root, request.now), dossier.missing
    )
    if dossier.scan:
        dossier.files["scan.json"] = evidence.encoded(dossier.scan.to_json())
        dossier.missing += [f"scan: {it}" for it in dossier.scan.remarks]
