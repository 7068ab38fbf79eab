"""All parsers of what comes from outside: the kind of their documents, some valid ones, and what reads one. A new parser is one
more line of `PARSERS`."""

from __future__ import annotations

import contextlib
import functools
import gzip
import hashlib
import io
import json
import sys
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any, TypeVar

import httpx
import pytest
from conftest import ROOT, SMALL

from fakes import documents, stubs
from fakes.fuzz import Parser
from fakes.memory_registry import PREFIX, MemoryRegistry
from fakes.mutations import tar_of
from fakes.stubs import script_of_a_build

sys.path.insert(0, str(ROOT / "components/containerize"))  # where its scripts find each other

from rosml.base import archives, untrusted, web
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize import lock
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.build import attachments as contents
from rosml.containerize.build import dev_folder, junit, report
from rosml.containerize.ci import job as ci_job
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.init import folder as init_folder
from rosml.containerize.init import forge, packages
from rosml.containerize.packages import workspace
from rosml.containerize.packages.conditions import holds
from rosml.containerize.rebase import compatibility, fleet, image, trial
from rosml.containerize.rebase.attachments import BaseContents
from rosml.containerize.sources import repos_file, tree, versions
from rosml.containerize.sources import store as sources_store
from rosml.delivery import apply_patch, archive, make_patch
from rosml.delivery import engine as layers_of_engine
from rosml.delivery import image as saved_image
from rosml.delivery.complete import choose, complete
from rosml.delivery.sources import InArchive
from rosml.images.builds import adopted, apt_sources, base_images, package_state, release_file, structure_tests, sync
from rosml.images.catalogue import scans
from rosml.images.dossier import fields as dossier_fields
from rosml.images.dossier import licences, spdx_document
from rosml.images.dossier import scan as dossier_scan
from rosml.images.dossier import texts as licence_texts
from rosml.images.dossier.bill import Bill
from rosml.images.dossier.evidence import Origin
from rosml.images.image_set import labels, load, lock_file, restricted, system
from rosml.images.image_set.apt_repository import AptRepository
from rosml.images.join import facts, file_lists, label_claims
from rosml.images.join.layers import Source
from rosml.images.locks import index, resolve
from rosml.images.locks.uv import Uv
from rosml.images.matrix import source
from rosml.images.publish import issue, plan, scan_results
from rosml.images.records import store, tag_moves
from rosml.images.scan import judge, policy, trivy
from rosml.images.scan.sbom import Sbom
from rosml.machine import buildx, progress
from rosml.machine.services import Services
from rosml.registry import answers, challenge, credentials, oci, references
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor
from rosml.registry.place import Place
from rosml.run import check, consent, defaults, engine, paths
from rosml.run.context import Context, Engine, Host, Image, Person
from rosml.run.exports import compose, compose_file, devcontainer, kubernetes, quadlet
from rosml.run.exports.description import describe
from rosml.run.plugins import places, xauthority
from rosml.run.words import split

T = TypeVar("T")

NOW = datetime(2026, 11, 22, tzinfo=UTC)
SMALL_SET = load.image_set(source.parse(SMALL.encode()))


def written(name: str, read: Callable[[Path], object]) -> Callable[[bytes, Path], object]:
    """Reads a document that is a file of that name, below the folder."""

    def put(document: bytes, folder: Path) -> object:
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(document)
        return read(file)

    return put


def text(read: Callable[[str], object]) -> Callable[[bytes, Path], object]:
    return lambda document, folder: read(document.decode(errors="replace"))


def as_json(*values: Any) -> tuple[bytes, ...]:
    return tuple(json.dumps(value, indent=1).encode() for value in values)


# ---- Apps ------------------------------------------------------------------------------------------------------------


def uncompressed(document: bytes) -> bytes:
    """The builder's archives are not compressed, and some documents have more than memory holds."""
    with contextlib.suppress(zlib.error):
        return zlib.decompressobj(31).decompress(document, 20 << 20)
    return document


def app_report_of(document: bytes, folder: Path) -> object:
    (folder / "report.tar").write_bytes(gzip.decompress(tar_of(("app.json", document))))
    return report.of_app(folder / "report.tar", folder / "report", ("linux/amd64",)).apps()


def results_of_tests(document: bytes, folder: Path) -> object:
    (folder / "results.tar").write_bytes(uncompressed(document))
    return report.of_tests(folder / "results.tar", folder / "report", ("linux/amd64",))


def job_of(document: bytes, folder: Path) -> object:
    inputs = {"image-name": "ghcr.io/me/robot", "platform": "amd64", "push": "true"}
    job = ci_job.Job(
        app_inputs.values(inputs, folder, {}), {}, ci_job.Commit("main", "", True, folder), lambda line: None
    )
    (folder / job.name).mkdir()
    (folder / job.name / ci_job.FILE).write_bytes(document)
    return job.built_images(folder)


def rosdep_lists(folder: Path, index: bytes = documents.INDEX, keys: bytes = documents.KEYS) -> object:
    texts = {"rosdep/base.yaml": keys, "jazzy/distribution.yaml": b"repositories: {}\n", "index-v4.yaml": index}
    for name, text in texts.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(text)
    return rosdep_index.packed(folder)


def tests_of(file: Path) -> object:
    return junit.read(file.parents[1])


@functools.cache
def script(name: str) -> ModuleType:
    return script_of_a_build(f"containerize/{name}.py")


def options_of(file: Path) -> object:
    return script("pip_install").from_where(["-r", str(file)])


def commands_of_compilers(file: Path) -> object:
    return script("compile_commands").main(file.parents[1], "/home/jo/robot")


def dpkg_of(document: bytes, folder: Path) -> object:
    file = folder / "var/lib/dpkg/status"
    file.parent.mkdir(parents=True)
    file.write_bytes(document)
    files = script("app_files")
    return files.versions(folder, [folder]), [*files.status(folder).values()]


def elf_of(document: bytes, folder: Path) -> object:
    (folder / "file").write_bytes(document)
    return script("elf").elf(folder / "file"), script("elf").symbols(folder / "file")


def installed(name: str) -> Callable[[bytes, Path], object]:
    """Reads a file of the install space of an app, as programs of a build do."""

    def read(document: bytes, folder: Path) -> object:
        file = folder / "docker-ros/ws/install" / name
        file.parent.mkdir(parents=True)
        file.write_bytes(document)
        file.chmod(0o755)
        (folder / "image").mkdir()
        lacking = script("lacking").Lacking(folder / "image", folder, [], ["a"])
        link = script("link")
        link.INSTALL = folder / "docker-ros/ws/install"  # type: ignore[attr-defined]
        return lacking.lost, lacking.absent, lacking.imported(folder / "image"), [*link.modules(), *link.not_found()]

    return read


def upstream(file: Path) -> object:
    folder = file.with_name("up")
    folder.mkdir()
    return tree.Tree(folder).has("a", "b", "c")


def submodules_of(document: bytes, folder: Path) -> object:
    links = [f"160000 {'d' * 40} 0\ta\0160000 {'e' * 40} 0\tb\0"]

    def git(*words: str, **_: object) -> str:
        if "ls-files" in words:
            return links.pop() if links else ""
        return document.decode(errors="surrogateescape") if "config" in words else "c" * 40

    run_git: Any = git
    source_store = sources_store.Store(run_git, folder, bool)
    source_store.write("https://example.org/x/y.git", versions.Version("c" * 40), folder / "into")
    return sorted((folder / "into").iterdir())


def refs_of(refs: str) -> object:
    def git(*_: str) -> str:
        return refs

    run_git: Any = git
    return [versions.resolve(run_git, "https://example.org/a.git", name) for name in ("", "main", "1.0")]


def repository_of(document: bytes, folder: Path) -> object:
    for name in (".git/config", ".git/HEAD", ".gitlab-ci.yml", "docker/Dockerfile", ".gitignore"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(document)
    wishes = forge.CiWishes(place="ghcr.io/us/rosml", rosml="https://github.com/us/rosml")
    choice = forge.choose(folder, wishes, SMALL_SET.matrix, lambda _, choice: choice.value)
    return choice, [*init_folder.hints(folder, {})], init_folder.ignores_env(folder)


def lists_of(document: bytes, folder: Path) -> object:
    (folder / "docker").mkdir()
    for name in ("additional-debs.txt", "additional-pip-requirements.txt", "blacklisted-packages.txt"):
        (folder / "docker" / name).write_bytes(document)
    values = app_inputs.values({"image-name": "ghcr.io/me/robot"}, folder, {})
    workspace.write_requests(values, folder, folder / "upstream", {}, folder / "out")
    (folder / "manifests").mkdir()
    return [*workspace.stale(folder / "out", folder / "manifests")]


def projects_of(document: bytes, folder: Path) -> object:
    for name in ("a/package.xml", "b/CMakeLists.txt"):
        (folder / "src" / name).parent.mkdir(parents=True)
        (folder / "src" / name).write_bytes(documents.MANIFEST if name == "a/package.xml" else document)
    return workspace.write_manifests({"target": folder / "src"}, folder / "out")


def contents_of(name: str) -> Callable[[bytes, Path], object]:
    def read(document: bytes, folder: Path) -> object:
        (folder / "file").write_bytes(document)
        return script("contents").packages({name: folder / "file"}, [document.decode(errors="replace")], ())

    return read


# ---- Registries and records ------------------------------------------------------------------------------------------


def entry_of(document: bytes, folder: Path) -> object:
    registry = MemoryRegistry()
    records = store.Records(Place(registry, PREFIX))
    annotation = document.decode(errors="replace")
    records.artifact("alpha-base.amd64", document, {store.ANNOTATION: annotation})
    image = registry.put_manifest(f"{PREFIX}/ros", "", {"schemaVersion": 2, "layers": []})
    data = b'{"entry": ' + document + b', "inputs": {}}'
    registry.attach(
        f"{PREFIX}/ros", oci.descriptor(oci.IMAGE, b"") | {"digest": image}, store.ARTIFACT, data, store.LAYER
    )
    return records.read("alpha-base", "amd64"), records.attached("ros", image)


def scan_of(document: bytes, folder: Path) -> object:
    entry = store.parse({**documents.ENTRY, "scan": untrusted.json_of(document, "a")})
    return entry and scans.scan_of(entry)


class Receiver:
    def __init__(self) -> None:
        self.outcomes = list[Any]()
        self.records = store.Records(Place(MemoryRegistry(), PREFIX))
        self.state = SimpleNamespace(
            entries={("alpha-base", "amd64"): store.parse(documents.ENTRY)}, date="2026-11-22T03:00:00Z"
        )


def results_of(file: Path) -> object:
    receiver: Any = Receiver()
    scan_results.record(receiver, file)
    return [*receiver.outcomes]


def recorded(tag: str, read: Callable[[store.Records], object]) -> Callable[[bytes, Path], object]:
    """Reads an artifact of the records."""

    def read_document(document: bytes, folder: Path) -> object:
        records = store.Records(Place(MemoryRegistry(), PREFIX))
        records.artifact(tag, document, {})
        return read(records)

    return read_document


class Sent(MemoryRegistry):
    document = b""

    def read_blob(
        self, repository: str, digest: str, read: Callable[[Iterator[bytes]], T], size: int | None = None
    ) -> T:
        return read(iter([self.document[at : at + 65536] for at in range(0, len(self.document), 65536)]))


def layer_of(document: bytes, folder: Path) -> object:
    registry = Sent()
    registry.document = document
    facts = Descriptor(
        mediaType="application/vnd.oci.image.layer.v1.tar+gzip", digest=documents.DIGEST, size=len(document)
    )
    texts, _ = apt_sources.read_layer(registry, references.Reference("registry.test", "base", "1"), facts)
    return apt_sources.parse(texts, "base")


def texts_of(document: bytes, folder: Path) -> object:
    registry = Sent()
    registry.document = document
    facts = Descriptor(mediaType=oci.IMAGE, digest=documents.DIGEST, size=len(document))
    return licence_texts.of_layer(registry, "robot", facts, {"usr/share/doc/a/copyright"})


def archived(index: bytes = b"", manifest: bytes = b"", config: bytes = documents.SAVED) -> bytes:
    layers = [oci.descriptor("application/vnd.oci.image.layer.v1.tar", b"")]
    content = {"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, config), "layers": layers}
    manifest = manifest or oci.encoded(content)
    omitted = {"registry.test/a@sha256:1": [oci.digest_of(b"")]}
    index = index or archive.index(oci.descriptor(oci.IMAGE, manifest), "registry.test/b:1", omitted)
    blobs = [(archive.path(oci.digest_of(data)), data) for data in (manifest, config)]
    return tar_of((archive.LAYOUT, b"{}"), (archive.INDEX, index), *blobs)


def image_of(document: bytes, folder: Path) -> object:
    return saved_image.read(archive.Archive(io.BytesIO(uncompressed(document)), "a")).missing


def reply(code: int, content: bytes = b"", headers: Any = None) -> httpx.Response:
    return httpx.Response(code, headers=headers, stream=httpx.ByteStream(content))


def server(answer: Callable[[httpx.Request], httpx.Response]) -> Registry:
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(web, "client", lambda **_: httpx.Client(transport=httpx.MockTransport(answer)))
        return Registry("registry.test", credentials=lambda _: None)


def sent(ask: Callable[[Registry], object]) -> Callable[[bytes, Path], object]:
    return lambda document, folder: ask(
        server(lambda _: reply(200, document, {"docker-content-digest": documents.DIGEST}))
    )


def error_of(document: bytes, folder: Path) -> object:
    answer = answers.Answer("GET", httpx.URL("https://registry.test/v2/"), 403, httpx.Headers(), document)
    return answers.reason(answer), answers.codes(answer)


def token_of(document: bytes, folder: Path) -> object:
    asks = {"www-authenticate": 'Bearer realm="https://registry.test/token"'}

    def answer(request: httpx.Request) -> httpx.Response:
        if request.url.path == "/token":
            return reply(200, document)
        authorized = "authorization" in request.headers
        return reply(200, b'{"tags": ["a"]}') if authorized else reply(401, headers=asks)

    return server(answer).tags("a")


def headers_of(document: bytes, folder: Path) -> object:
    """What registries say in headers: each that is read, with this text."""
    line = bytes(byte for byte in document[:16000] if byte >= 0x20 and byte != 0x7F)
    names = ("link", "content-type", "docker-content-digest", "retry-after", "www-authenticate", "location")
    headers = [(name.encode(), line) for name in names]
    requests = []

    def answer(request: httpx.Request) -> httpx.Response:
        requests.append(request)
        code = (200, 401, 307)[len(requests) % 3] if len(requests) < 6 else 200
        return reply(code, b'{"schemaVersion": 2, "tags": []}', headers)

    text = line.decode("latin-1")
    web.after({"retry-after": text})
    challenge.read([text])
    asks: list[Callable[[Registry], object]] = [
        lambda registry: registry.manifest("a", "x"),
        lambda registry: registry.tags("a"),
        lambda registry: registry.head("a", "x"),
    ]
    for ask in asks:
        with contextlib.suppress(RosmlError):
            ask(server(answer))
    with contextlib.suppress(web.Unfit):
        web.joined(httpx.URL("https://registry.test/v2/"), text)
    return None


def docker_config_of(document: bytes, folder: Path) -> object:
    (folder / "config.json").write_bytes(document)
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("DOCKER_CONFIG", str(folder))
        patched.setenv("PATH", "")
        patched.delenv(credentials.VARIABLE, raising=False)
        login = credentials.from_docker("registry.test")
        if (text := document.decode(errors="replace").replace("\0", "")) and len(text) < 100_000:
            patched.setenv(credentials.VARIABLE, text)
            credentials.from_docker("registry.test")
    return login


def answering(folder: Path, name: str, document: bytes, before: str = "") -> str:
    """A program that prints a document."""
    (folder / "answer").write_bytes(document)
    return stubs.executable(folder / name, f"{before}\nexec cat {folder}/answer")


def helper_of(document: bytes, folder: Path) -> object:
    (folder / "config.json").write_text('{"credsStore": "a"}')
    answering(folder, "docker-credential-a", document)
    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("DOCKER_CONFIG", str(folder))
        patched.setenv("PATH", f"{folder}:/usr/bin:/bin")
        patched.delenv(credentials.VARIABLE, raising=False)
        return credentials.from_docker("registry.test")


def source_of(document: bytes) -> Source:
    layers = [oci.descriptor(f"application/vnd.oci.image.layer.v1.tar{end}", b"") for end in ("", "+gzip")]
    content = {"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, document), "layers": layers}
    registry = MemoryRegistry()
    registry.put_blob("a", document)
    manifest = oci.Manifest(content, documents.DIGEST, oci.IMAGE, 1)
    config = registry.config("a", manifest, "a")
    return Source("a", "registry.test", "a", documents.DIGEST, manifest, config)


BASE_OF_APP = source_of(
    json.dumps({**documents.BASED, "rootfs": {"diff_ids": [oci.digest_of(b"a"), oci.digest_of(b"c")]}}).encode()
)


def config_of(document: bytes, folder: Path) -> object:
    image_source, wrong = source_of(document), list[RosmlError]()
    calls: list[Callable[[], object]] = [
        lambda: docker_image_of(
            json.dumps([{"Id": documents.DIGEST, "Config": image_source.config.content.get("config")}]).encode(), folder
        ),
        lambda: label_claims.require(image_source.labels, "a"),
        lambda: restricted.parts_of(image_source.labels),
        lambda: compatibility.require_fit(image_source, BASE_OF_APP),
        lambda: image.moved(image_source, BASE_OF_APP, {}),
        lambda: image.moved(BASE_OF_APP, image_source, {}),
        lambda: image.require_unaltered(image_source, BASE_OF_APP),
        lambda: image.require_kept(image_source, BASE_OF_APP),
        lambda: image.lock_of(image_source),
    ]
    for call in calls:
        try:
            call()
        except RosmlError as error:
            wrong.append(error)
    if odd := [error for error in wrong if not error.remedy]:
        raise odd[0]
    return image_source


def judged(document: bytes, folder: Path) -> object:
    app_facts, base_facts = facts.parse(gzip.compress(document, 1)), facts.Facts.model_validate(documents.FACTS)
    files = (frozenset({"c", "usr/lib/python3/dist-packages/a-1.dist-info/METADATA"}), frozenset({"usr"}))
    pairs = ((app_facts, base_facts), (base_facts, app_facts))
    return [compatibility.judge(app, base, BaseContents((), base, *files), {}, {}) for app, base in pairs]


def packages_of_archive(document: bytes, folder: Path) -> object:
    release = f" {hashlib.sha256(document).hexdigest()} 1 main/binary-amd64/Packages.gz\n".encode()
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(release_file, "fetched", lambda url, *_: release if url.endswith("InRelease") else document)
        repository = AptRepository("live", "", "http://ros.test", "noble", ("main",))
        return sync.lacking(folder, repository, "amd64", ["tree"])


OLDER_LAYER = gzip.decompress(tar_of(("a", b"one" * 2000), ("b", bytes(9000))))
NEW_LAYER = gzip.decompress(tar_of(("a", b"one" * 1999 + b"two"), ("c", bytes(9000)), ("d", b"three")))
PATCH_PLAN, *FRAMES = make_patch.make(io.BytesIO(OLDER_LAYER), io.BytesIO(NEW_LAYER))
PATCH = b"".join((PATCH_PLAN, *FRAMES))


def patches_of(patch_bytes: bytes) -> bytes:
    older = {"digest": oci.digest_of(OLDER_LAYER), "diff_id": oci.digest_of(OLDER_LAYER), "size": len(OLDER_LAYER)}
    entry = {**oci.descriptor(apply_patch.MEDIA_TYPE, patch_bytes), "image": "a", "old": older}
    return json.dumps({oci.digest_of(NEW_LAYER): entry}).encode()


def with_patch(patch_bytes: bytes, document: bytes = b"") -> object:
    document = document or patches_of(patch_bytes)
    digest = oci.digest_of(NEW_LAYER)
    config = oci.encoded({"os": "linux", "architecture": "amd64", "rootfs": {"type": "layers", "diff_ids": [digest]}})
    layers = [oci.descriptor("application/vnd.oci.image.layer.v1.tar", NEW_LAYER)]
    manifest = oci.encoded({"schemaVersion": 2, "config": oci.descriptor(oci.CONFIG, config), "layers": layers})
    annotations = {archive.LEFT_OUT: json.dumps({"a": [digest]}), archive.PATCHES: document.decode(errors="replace")}
    content = {"schemaVersion": 2, "manifests": [oci.descriptor(oci.IMAGE, manifest)], "annotations": annotations}
    blobs = [(archive.path(oci.digest_of(data)), data) for data in (manifest, config, patch_bytes)]
    app_archive = tar_of((archive.LAYOUT, b"{}"), (archive.INDEX, oci.encoded(content)), *blobs)
    image = saved_image.read(archive.Archive(io.BytesIO(gzip.decompress(app_archive)), "a"))
    layer = (archive.path(oci.digest_of(OLDER_LAYER)), OLDER_LAYER)
    older_archive = tar_of((archive.LAYOUT, b"{}"), (archive.INDEX, b"{}"), layer)
    older_image = InArchive(archive.Archive(io.BytesIO(gzip.decompress(older_archive)), "b"))
    return complete(image, choose(image, [older_image]), io.BytesIO())


def unpacked(document: bytes, folder: Path) -> object:
    rosdep_index.unpack(document, folder, "the lists")
    return sorted(folder.rglob("*"))


def labels_of(label: str) -> object:
    return labels.any_python(label, "cuda"), labels.required_driver(label)


SOURCE = apt_sources.Source("http://archive.test/debian", "bookworm", ("main",))

# ---- Scans -----------------------------------------------------------------------------------------------------------


def sbom_of(document: bytes, folder: Path) -> object:
    sbom = Sbom(document)
    sbom.require("alpha", ros=True)
    return sbom.is_of(documents.DIGEST), sbom.packages, sbom.system, sbom.sources


def dossier_of(document: bytes, folder: Path) -> object:
    try:
        bill = Bill.of(document)
    except ValueError as error:
        raise trivy.ScannerFailed(str(error), "attach another one") from None
    fields = dossier_fields.check(bill)
    texts = licences.of(bill, ["usr/share/doc/bash/copyright"])
    return fields, texts, licences.listing(texts, True), spdx_document.document(bill, documents.DIGEST)


def provenance_of(document: bytes, folder: Path) -> object:
    content = untrusted.json_of(document, "a statement")
    return Origin.of(content if isinstance(content, dict) else {})


def vex_of(document: bytes, folder: Path) -> object:
    content = untrusted.json_of(document, "VEX")
    return dossier_scan.statuses(content if isinstance(content, dict) else {})


def report_of(document: bytes, folder: Path) -> object:
    return judge.part_report(
        trivy.read_report(document, "alpha"), judge.Part("alpha", "registry.test", "ros", documents.DIGEST, ros=True)
    )


def database_of(document: bytes, folder: Path) -> object:
    (folder / "db").mkdir()
    (folder / "db/metadata.json").write_bytes(document)
    (folder / "db/trivy.db").write_bytes(b"x")
    database = trivy.Trivy("trivy", "1", folder).database()
    database.require_fresh(policy.DatabaseRules(repositories=("a/b",), max_age_hours=24), NOW)
    return database


# ---- Run -------------------------------------------------------------------------------------------------------------


def answered(what: str, ask: Callable[[str], object]) -> Callable[[bytes, Path], object]:
    """Asks an engine that answers one question with the document, and fails at others."""

    return lambda document, folder: ask(answering(folder, "docker", document, f"[ $1 = {what} ] || exit 1"))


def defaults_of(document: bytes, folder: Path) -> object:
    (folder / ".rosml.toml").write_bytes(document)
    environment = {"XDG_CONFIG_HOME": str(folder / "none")}
    project_file = defaults.files(environment, str(folder), ["--mws"], ["--new"]).project
    return project_file and consent.questionable(project_file.line, trusted=False)


def words_of(document: bytes, folder: Path) -> object:
    options = document.decode(errors="surrogateescape").split("\n")
    line = split([word for option in options if option.startswith("--") for word in [option]] + ["ros:jazzy"], ())
    host = Host(folder, {"ROS_DOMAIN_ID": options[0].partition("=")[2][-5000:]})
    context = Context(
        line, Engine(), Person(1000, 1000, "me", str(folder)), Image(environment={"ROS_DISTRO": "jazzy"}), host
    )
    argv = ["docker", "run", *(word for option in line.engine for word in option.words), "ros:jazzy"]
    findings = check.findings(context, places.planned(context, argv), [], ())
    placed = [(defaults.without(option, line.engine[:1]), paths.anchored(option, "/x")) for option in line.engine]
    for write in (kubernetes.text, quadlet.text, devcontainer.text):
        with contextlib.suppress(RosmlError):
            write(describe(context, argv))
    return findings, placed, compose.text(describe(context, argv))


def kernel_of(document: bytes, folder: Path) -> object:
    for place in (check.RECEIVED, check.FRAGMENTS, check.SECONDS, "/sys/class/net/eth0/flags"):
        file = folder / place.lstrip("/")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(document)
    (folder / "variables").write_bytes(document)
    line = split(["--network=host", "--ipc=host", "--env-file=/variables", "ros:jazzy"], ())
    host = Host(folder, {}, echoes=bool)
    context = Context(line, Engine(), Person(0, 0, "me", "/"), Image(environment={"ROS_DISTRO": "jazzy"}), host)
    argv = ["docker", "run", *(word for option in line.engine for word in option.words), "ros:jazzy"]
    return check.findings(context, places.planned(context, argv), [], ())


def docker_image_of(document: bytes, folder: Path) -> object:
    answering(folder, "docker", document)
    with pytest.MonkeyPatch.context() as patched:
        nothing = httpx.MockTransport(lambda request: reply(404))
        patched.setattr(web, "client", lambda **_: httpx.Client(transport=nothing))
        patched.setattr(app_base, "load", lambda _: SMALL_SET)
        patched.setenv("PATH", f"{folder}:/usr/bin:/bin")
        return app_base.find("registry.test/a:b", stubs.services(folder, builder_kind="docker"), ())


def images_of_engine(document: bytes, folder: Path) -> object:
    program = answering(folder, "engine", document, f"[ $2 = ls ] && echo {'1' * 64} && exit")
    return engine.layers(program), engine.image_names(program)


def saved_by_engine(document: bytes, folder: Path) -> object:
    program = answering(folder, "docker", uncompressed(document))
    layer = saved_image.Layer(digest=documents.DIGEST, diff_id=oci.digest_of(b"x"), size=1)
    for item in layers_of_engine.InEngine(program, "1" * 64, frozenset([layer.diff_id])).take([layer]):
        item.send(lambda blocks: print(*map(len, blocks), file=io.StringIO()))
    return None


def composed(content: str) -> object:
    addition: dict[str, Any] = {"services": {"listener": {"image": "ros:jazzy"}}, "volumes": {"a": {}}}
    return compose_file.added(content, addition, "compose.yaml")


def cookies_of(document: bytes, folder: Path) -> object:
    cookies = xauthority.read(document)
    return xauthority.written(cookies), xauthority.cookie(cookies, "0", "a", "a")


COOKIES = xauthority.written([xauthority.Entry(xauthority.LOCAL, b"a", b"0", b"MIT-MAGIC-COOKIE-1", b"x" * 16)])


# ---- The machine -----------------------------------------------------------------------------------------------------

WHEEL = index.Wheel("https://index.test/a-1-py3-none-any.whl", 0)


def zip_of(**files: bytes) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in files.items():
            packed.writestr(f"a-1.dist-info/{name}", content)
    return buffer.getvalue()


def wheel_of(document: bytes, folder: Path) -> object:
    def answer(request: httpx.Request) -> httpx.Response:
        first, last = map(int, request.headers["range"].removeprefix("bytes=").split("-"))
        return reply(206, document[first : last + 1])

    wheel_index = index.Index(Uv(), httpx.Client(transport=httpx.MockTransport(answer)))
    wheel = index.Wheel(WHEEL.url, len(document))
    return wheel_index.metadata(wheel), wheel_index.record(wheel)


def pylock_of(document: bytes, folder: Path) -> object:
    class OneAnswer(Uv):
        def __call__(self, arguments: Sequence[str], folder: Path) -> tuple[int, str]:
            (folder / "pylock.toml").write_bytes(document)
            return 0, ""

    nothing = httpx.Client(transport=httpx.MockTransport(lambda _: reply(404)))
    return index.Index(OneAnswer(), nothing).wheels(index.WheelTarget("3.12", "x86_64-manylinux_2_28"), {"a": "1"})


def github_of(document: bytes, folder: Path) -> object:
    one = b'{"number": 1}'
    answer = httpx.MockTransport(lambda request: reply(200, document if request.method == "GET" else one))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(web, "client", lambda **options: httpx.Client(transport=answer, base_url=options["base_url"]))
        return issue.Issues("https://api.github.test", "me/robot", "x").keep("x", 1)


def progress_of(document: bytes, folder: Path) -> object:
    out = io.StringIO()
    followed = progress.BuildProgress(out, out, clock=lambda: 0.0)
    followed.follow(document.decode(errors="replace").splitlines(keepends=True))
    bake = buildx.Bake("a", "b", folder / "c")
    return buildx.failure(bake, followed, folder / "log", 1), [step.label for step in followed.steps.values()]


def base_of_command(document: bytes, folder: Path) -> object:
    machine, name = stubs.services(folder, bases=[answering(folder, "bases", document)]), "ubuntu-24.04"
    systems = SMALL_SET.matrix.operating_systems
    return base_images.reference(machine, systems, name), base_images.missing(machine, systems, name)


def adopted_of(file_text: str) -> object:
    return system.system(file_text), adopted.ends_in_the_command(file_text)


def sources_of(document: bytes, folder: Path) -> object:
    for name in ("package.xml", "a.py", "a.cpp", "setup.py", "CMakeLists.txt", "requirements.txt"):
        (folder / name).write_bytes(documents.MANIFEST if name == "package.xml" else document)
    return packages.find(folder, {"x": ("torch",)})


PARSERS: dict[str, Parser] = {
    ".env": Parser("text", [documents.ENV], written(".env", lambda file: app_inputs.of_file(file.parent))),
    ".repos": Parser("yaml", [documents.REPOS], written("a.repos", lambda file: repos_file.read([file], file.parent, "", local=False))),
    ".rosml.toml": Parser("text", [documents.DEFAULTS], defaults_of),
    "allowed.json": Parser(
        "json",
        as_json({"/a/.rosml.toml": hashlib.sha256(b"x").hexdigest()}),
        written(
            "a", lambda file: consent.is_allowed(defaults.File("/a/.rosml.toml", b"x", 0, split((), ())), "1", file)
        ),
    ),
    "compile_commands.json of a build": Parser(
        "json",
        as_json([{"directory": "/b", "file": "/a.cpp", "command": "c++ -c /a.cpp"}]),
        written("build/compile_commands.json", commands_of_compilers),
    ),
    "apt's list of sources": Parser("text", [documents.LINES], text(lambda content: apt_sources.parse({"a.list": content}, "base"))),
    "apt's paragraphs of sources": Parser("text", [documents.STANZAS], text(lambda content: apt_sources.parse({"a.sources": content}, "base"))),
    "apt's sources in a layer": Parser("tar", [tar_of(("etc/apt/sources.list", documents.LINES))], layer_of),
    "date of a Release file": Parser("text", [documents.RELEASE], text(lambda content: sync.date_of(content, "http://ros.test"))),
    "Release file": Parser("text", [documents.RELEASE], text(lambda content: package_state.described(SOURCE, content, "http://archive.test"))),
    "dpkg's status": Parser("text", [documents.STATUS], dpkg_of),
    "package.xml": Parser("xml", [documents.MANIFEST], written("a/package.xml", lambda file: [*workspace.names(file.parent)])),
    "package.xml for init": Parser(
        "xml",
        [documents.MANIFEST],
        written("a/package.xml", lambda file: packages.find(file.parent, {"x": ("torch",)})),
    ),
    "sources for init": Parser("text", [b"import a, torch\nfrom b import c\n"], sources_of),
    "condition in a manifest": Parser(
        "text", [b"($ROS_VERSION == 1 or $ROS_DISTRO > 'foxy') and a != b"], text(lambda content: holds(content, {}))
    ),
    "JUnit file": Parser("xml", [documents.SUITE.encode()], written("results/a/b.xml", tests_of)),
    "CTest's file": Parser("xml", [documents.CTEST.encode()], written("results/a/b.xml", tests_of)),
    "what steps of a build say": Parser("json", as_json(documents.APP), app_report_of),
    "archive of a build": Parser("tar", [tar_of(("results/a/b.xml", documents.SUITE.encode()))], results_of_tests),
    "images of a job": Parser("json", as_json([documents.JOB]), job_of),
    "packages of an image": Parser("json", as_json(documents.PACKAGES), lambda document, folder: contents.sbom(document, "a", 0.0, contents.Origins({}))),
    "package.xml in an image": Parser("xml", [documents.MANIFEST], contents_of("docker-ros/ws/install/share/a/package.xml")),
    "METADATA in an image": Parser("text", [b"Name: a\nVersion: 1\n\nx"], contents_of("usr/lib/python3/a-1.dist-info/METADATA")),
    "packages of apt in an image": Parser("text", [documents.STATUS], contents_of("var/lib/dpkg/status.d/a")),
    "os-release in an image": Parser("text", [b'ID=debian\nVERSION_ID="12"\n'], contents_of("usr/lib/os-release")),
    "relations of a package": Parser("text", [documents.STATUS], text(lambda content: script("facts").package(content))),
    "program in an image": Parser("text", [Path("/bin/true").read_bytes()], elf_of),
    "facts of an image": Parser("json", as_json(documents.FACTS), lambda document, folder: facts.parse(gzip.compress(document))),
    "apps that move": Parser("yaml", [documents.FLEET], written("apps.yaml", fleet.read)),
    "lines of a trial": Parser("json", [b'"lib/a: undefined symbol: b"\n"import c: d"\n'], lambda document, _: trial.lines(document)),
    "report of pip": Parser("json", as_json(documents.PIP), lambda document, _: script("pip_install").requirements(document)),
    "options in a list of pip": Parser(
        "text", [b"--index-url 'https://index.test/x'  # x\n-r b.txt\ntree==1.0\n"], written("a.txt", options_of)
    ),
    "lock file": Parser("json", [documents.LOCK.text().encode()], written("a.lock", lambda file: lock.read(file, file.parent))),
    "folder of upstream sources": Parser("json", as_json({"a": ["https://example.org/a", "c" * 40]}), written(".up.json", upstream)),
    "rosdep's index": Parser("yaml", [documents.INDEX], lambda document, folder: rosdep_lists(folder, index=document)),
    "rosdep's list": Parser("yaml", [documents.KEYS], lambda document, folder: rosdep_lists(folder, keys=document)),
    "rosdep's lists of a registry": Parser("tar", [tar_of(("rosdep/base.yaml", documents.KEYS), ("index-v4.yaml", documents.INDEX))], unpacked),
    "archive of an image": Parser("tar", [archived()], image_of),
    "patch of a layer": Parser("text", [PATCH], lambda document, folder: with_patch(document)),
    "plan of a patch": Parser(
        "json",
        [archives.zstd.decompress(PATCH_PLAN)],
        lambda document, folder: with_patch(b"".join((archives.zstd.compress(document), *FRAMES))),
    ),
    "patches in an archive": Parser("json", [patches_of(PATCH)], lambda document, folder: with_patch(PATCH, document or b"x")),
    "index in an archive": Parser(
        "json",
        [archive.index(documents.SAVED_MANIFEST, "registry.test/b:1", {"a": [oci.digest_of(b"")]})],
        lambda document, folder: image_of(archived(document), folder),
    ),
    "manifest in an archive": Parser("json", [documents.SAVED_CONTENT], lambda document, folder: image_of(archived(manifest=document), folder)),
    "config in an archive": Parser("json", [documents.SAVED], lambda document, folder: image_of(archived(config=document), folder)),
    "record": Parser("json", as_json(documents.ENTRY), entry_of),
    "record of rosml dev": Parser(
        "json",
        as_json({"key": "a", "image": "b:latest", "id": "1", "upstream": ""}),
        written("a.json", dev_folder.read_record),
    ),
    "scan of a record": Parser("json", as_json(documents.ENTRY["scan"]), scan_of),
    "inputs of a record": Parser(
        "json",
        as_json({"inputs": {"a": "b"}, **documents.ENTRY}),
        recorded("alpha-base.amd64", lambda records: records.inputs("alpha-base", "amd64")),
    ),
    "moves of tags": Parser(
        "json",
        as_json({"date": "x", "moves": [{"repository": "ros", "tag": "a", "old": "", "new": documents.DIGEST}]}),
        recorded("undo.1", lambda records: [move.to_json() for move in tag_moves.read_moves(records, "undo.1")]),
    ),
    "SBOM": Parser("json", as_json(documents.SBOM), sbom_of),
    "SBOM of a dossier": Parser("json", as_json(documents.SBOM), dossier_of),
    "texts of licences in a layer": Parser("tar", [tar_of(("usr/share/doc/a/copyright", b"MIT"))], texts_of),
    "provenance of a dossier": Parser("json", as_json({"predicate": {"buildDefinition": {"resolvedDependencies": [{"name": "a", "digest": {"sha256": "0"}}]}}}), provenance_of),
    "VEX of a dossier": Parser("json", as_json({"statements": [{"vulnerability": {"name": "CVE-2026-1"}, "products": [{"subcomponents": [{"@id": "pkg:deb/debian/a@1"}]}]}]}), vex_of),
    "report of trivy": Parser("json", as_json(documents.REPORT), report_of),
    "database of trivy": Parser("json", as_json({"Version": 2, "UpdatedAt": "2026-11-22T00:00:00.123Z", "NextUpdate": "x"}), database_of),
    "info of an engine": Parser(
        "json",
        as_json(documents.INFO, {"host": {"security": {"rootless": True}, "hostname": "a"}}),
        answered("info", lambda command: engine.ask(command, "a", "b")),
    ),
    "image of an engine": Parser(
        "json",
        as_json(documents.IMAGE, [documents.IMAGE]),
        answered("image", lambda command: engine.image(command, "a")),
    ),
    "container of an engine": Parser("text", [documents.CONTAINER], answered("container", lambda command: engine.container(command, "a"))),
    "words of run": Parser("text", [documents.WORDS], words_of),
    "files of run": Parser("text", [b"2147483647\n", b"0x1003\n", b"ROS_DOMAIN_ID=7\nA=b\n"], kernel_of),
    "results of structure tests": Parser(
        "json",
        as_json(documents.TESTS),
        written("contract.json", lambda file: structure_tests.read_report(file.parent, ("contract",))),
    ),
    "versions in an image": Parser(
        "text",
        [b"torch 2.10.0\ncuda 12.8\n"],
        written("versions", lambda file: structure_tests.read_report(file.parent, ("contract",))),
    ),
    "services.json": Parser(
        "json",
        as_json(documents.SERVICES),
        written(".state/services.json", lambda file: Services.load(file.parent.parent)),
    ),
    "results of a scan": Parser("json", as_json(documents.RESULTS), written("results.json", results_of)),
    "plan": Parser("json", as_json(documents.PLAN), written("plan.json", plan.read_plan)),
    "matrix": Parser("yaml", [SMALL.encode()], lambda document, folder: load.image_set(source.parse(document))),
    "scan policy": Parser("yaml", [(ROOT / "scan.yaml").read_bytes()], lambda document, folder: policy.parsed(source.parse(document))),
    ".dockerignore": Parser(
        "text",
        [b"# x\n*.log\n!a/**/b?.log\nbuild/\n[a-c]\\*\n"],
        written(".dockerignore", lambda file: IgnoredFiles(file.parent)(file.parent / "a/b/c.log")),
    ),
    ".gitmodules": Parser("text", [documents.MODULES], written(".gitmodules", lambda file: workspace.empty_submodules(file.parent))),
    "submodules of a repository": Parser("text", [documents.SETTINGS], submodules_of),
    "refs of a repository": Parser("text", [documents.REFS], text(refs_of)),
    "repository for init": Parser(
        "text",
        [b"ref: refs/heads/jazzy-1\n", b'[remote "origin"]\n\turl = git@github.com:me/robot.git\n'],
        repository_of,
    ),
    "lists of packages": Parser("text", [b"tree\nlibc6:i386=1.0 # x\n"], lists_of),
    "CMakeLists.txt": Parser("text", [b'cmake_minimum_required(VERSION 3.8)\nproject( "robot" CXX)\n'], projects_of),
    "launch file": Parser("xml", [documents.LAUNCH], installed("share/a/launch/b.launch")),
    "launch file in Python": Parser("text", [documents.LAUNCH_IN_PYTHON], installed("share/a/launch/b.launch.py")),
    "script of an app": Parser("text", [documents.LAUNCH_IN_PYTHON], installed("lib/a/b")),
    "entry points of an app": Parser("text", [documents.ENTRY_POINTS], installed("lib/python3.12/site-packages/a-1.dist-info/entry_points.txt")),
    "manifest of a registry": Parser("json", [documents.SAVED_CONTENT], sent(lambda registry: registry.manifest("a", "x"))),
    "index of a registry": Parser("json", as_json(documents.LISTED), sent(lambda registry: registry.manifest("a", "x"))),
    "tags of a registry": Parser("json", as_json({"name": "a", "tags": ["b", "c"]}), sent(lambda registry: registry.tags("a"))),
    "artifacts of a registry": Parser("json", as_json(documents.LISTED), sent(lambda registry: registry.referrers("a", documents.DIGEST))),
    "error of a registry": Parser("json", as_json({"errors": [{"code": "DENIED", "message": "no", "detail": {"a": 1}}]}), error_of),
    "token of a registry": Parser("json", as_json({"token": "a", "access_token": "b", "expires_in": 300}), token_of),
    "headers of a registry": Parser("text", documents.HEADERS, headers_of),
    "docker's config.json": Parser(
        "json",
        as_json({"auths": {"registry.test": {"auth": "YTpi", "identitytoken": ""}}, "credHelpers": {"a": "b"}}),
        docker_config_of,
    ),
    "answer of a credential helper": Parser("json", as_json({"Username": "a", "Secret": "b"}), helper_of),
    "config of an image": Parser("json", as_json(documents.BASED), config_of),
    "facts of an app that moves": Parser("json", as_json(documents.FACTS), judged),
    "files of an image": Parser(
        "tar",
        [gzip.compress(b"usr/bin/a\n" * 50, mtime=0)],
        lambda document, _: file_lists.Files.parse(file_lists.unpacked(document)),
    ),
    "packages of a repository": Parser("tar", [gzip.compress(documents.STATUS, mtime=0)], packages_of_archive),
    "image in docker": Parser("json", as_json([documents.IN_ENGINE]), docker_image_of),
    "images of an engine": Parser("json", as_json([documents.IN_ENGINE]), images_of_engine),
    "archive of an engine": Parser("tar", [tar_of((f"blobs/sha256/{oci.digest_of(b'x')[7:]}", b"x"))], saved_by_engine),
    "compose file": Parser("yaml", [documents.COMPOSE], text(composed)),
    "cookies of a display": Parser("text", [COOKIES], cookies_of),
    "progress of buildx": Parser("text", [documents.STEPS], progress_of),
    "base image of a command": Parser("json", as_json({"reference": f"a@{documents.DIGEST}", "missing": ""}), base_of_command),
    "files of a base image": Parser("text", [documents.SYSTEM], text(adopted_of)),
    "issues of GitHub": Parser("json", as_json(documents.ISSUES), github_of),
    "wheel of an index": Parser("text", [zip_of(METADATA=b"Name: a\n", RECORD=b"a.py,sha256=x,1\n")], wheel_of),
    "RECORD of a wheel": Parser(
        "text",
        [b'a.py,sha256=x,1\n"b,c.py",,\n'],
        lambda document, _: wheel_of(zip_of(METADATA=b"", RECORD=document), _),
    ),
    "wheels that uv found": Parser("text", [documents.PYLOCK], pylock_of),
    "pins of a lock": Parser("text", [documents.PINS], text(lambda content: (resolve.parse(content), lock_file.versions(content)))),
    "label of a part": Parser("text", [b"torch=cuda*,common tensorflow=cuda*"], text(labels_of)),
    "JSON": Parser("json", as_json(documents.PLAN), lambda document, folder: untrusted.json_of(document, "a")),
    "YAML": Parser("yaml", [documents.KEYS], lambda document, folder: untrusted.yaml_of(document, "a")),
}  # fmt: skip
