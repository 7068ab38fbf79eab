"""A checkout whose images are small: the real Dockerfile, builder, registry and test runner, with scripts that install
next to nothing. A publishing run of six images takes seconds, so that it can be broken many times."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
import uuid
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import yaml

from rosml import ROOT
from rosml.base.file_lock import turn
from rosml.images.bake import bake_file
from rosml.images.environments.lock import Lock
from rosml.images.image_set import load
from rosml.images.image_set.model import ImageSet
from rosml.images.publish.state import Request
from rosml.images.publish.survey import survey
from rosml.images.records import store
from rosml.images.records.store import ARTIFACT, INDEX, Records
from rosml.images.records.tag_moves import UNDO
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from rosml.registry.place import Place
from tests import regctl
from tests.e2e.calls import Run, run
from tests.e2e.images import NATIVE, buildx, system

CHECKOUT = (
    *("Dockerfile", ".dockerignore", bake_file.NAME, bake_file.TESTS, "matrix.yaml"),
    *("components", "environments", "locks", "src", "scripts", "tools", "tests/structure"),
)
"""What a build needs of a checkout."""

OTHER = "amd64" if NATIVE == "arm64" else "arm64"

PARTS = ("common-cpu-py311", "grpc-cpu-py311", "tensorflow-cc-cpu", "tensorflow-cpu-py311")
"""What an image with TensorFlow has."""

PARTS_OF = ("part", "env")
"""The repositories of what is no image: it is tested in the images that have it."""

NOTHING = "#!/usr/bin/env bash\n"

CONTRACT = """\
#!/usr/bin/env bash
set -euo pipefail
source "$(dirname "$0")/../build/network.sh"
mkdir -p /docker-ros/ws
"$(dirname "$0")/../build/clean.sh"
"""
"""The workspace: where WORKDIR has to make a folder, it has the time of day."""

BASE = """\
FROM {os}
RUN --mount=type=bind,source=components,target=/run/components --mount=type=bind,source=tools,target=/run/tools \\
    --mount=type=bind,source=tools/requirements.txt,target=/run/requirements.txt --mount=type=secret,id=ca-bundle \\
    /run/components/part/install-assembler.sh
"""
"""The base image of small projects: what the real Dockerfile would install on top of Debian, which a builder with an empty
cache need not do."""

ROS = """\
#!/usr/bin/env bash
set -euo pipefail
source "$(dirname "$0")/../build/network.sh"
mkdir -p /opt/mini /usr/local/share/rosml/versions.d
echo "ros-distro $ROS_DISTRO" >/usr/local/share/rosml/versions.d/ros
for package in $ROS_PACKAGES; do echo {mark} >"/opt/mini/$package"; done
"$(dirname "$0")/../build/clean.sh"
"""

PART = """\
#!/usr/bin/env bash
set -euo pipefail
mkdir -p /out/opt/mini-part
echo "$PART $STACK $PYTHON {mark}" >"/out/opt/mini-part/$PART"
mkdir -p "/out/opt/mini-part/$PART.dist-info"
printf 'Name: %s\nVersion: 1\n' "$PART" >"/out/opt/mini-part/$PART.dist-info/METADATA"
find /out -exec touch --no-dereference --date=@"${{SOURCE_DATE_EPOCH:-0}}" {{}} +
"""

TEST = """\
schemaVersion: 2.0.0
commandTests:
  - {{name: it works, command: cat, args: [{path}]}}
"""


@dataclass
class Mini:
    """A small project and a place in the registry.

    Attributes:
        folder: the checkout. services: registry and builder. prefix: path of its repositories.
    """

    folder: Path
    services: Services
    prefix: str

    @property
    def registry(self) -> str:
        """For --registry."""
        return f"{self.services.registry}/{self.prefix}"

    def place(self) -> Place:
        """Where its images are, with a client of its own."""
        return Place(self.client(), self.prefix)

    def elsewhere(self) -> Mini:
        """The same project with an empty place."""
        return Mini(self.folder, self.services, f"rosml-test/{uuid.uuid4().hex[:12]}")

    @property
    def image_set(self) -> ImageSet:
        """All that its matrix describes."""
        return load.load(self.folder / "matrix.yaml", self.folder)

    def command(self, *arguments: str) -> list[str]:
        """A call of its rosml: of a publishing step, if the first word is no command of its own."""
        words = arguments if arguments[0] in ("image", "part", "plan", "status") else ("publish", *arguments)
        return [sys.executable, str(self.folder / "src"), *words]

    def publish(self, *arguments: str, env: dict[str, str] | None = None) -> Run:
        """A publishing command with its place."""
        return run(*self.command(*arguments, "--registry", self.registry), cwd=self.folder, env=env)

    def says(self, *arguments: str, env: dict[str, str] | None = None) -> dict[str, Any]:
        """What a publishing command says that succeeds."""
        outcome = self.publish(*arguments, "--json", env=env)
        assert outcome.code == 0, outcome.err + outcome.out
        content: dict[str, Any] = json.loads(outcome.out)
        return content

    def all(self, *arguments: str, env: dict[str, str] | None = None) -> dict[str, Any]:
        """What a whole publishing run says that succeeds."""
        return self.says("all", "--serve", NATIVE, *arguments, env=env)

    def start(self, *arguments: str, log: Path) -> subprocess.Popen[bytes]:
        """A publishing run that somebody ends; what it says goes into a file."""
        command = self.command("all", "--serve", NATIVE, "--registry", self.registry, *arguments)
        with log.open("wb") as err:
            return subprocess.Popen(
                command, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err
            )

    def recorded(self, date: str) -> set[tuple[str, str]]:
        """The work of a run, by its date, whose result the records have: step and target."""
        book = Records(self.place())
        names = [name for name in book.registry.tags(book.repository) if not name.startswith(("sha256-", UNDO))]
        entries = [book.read(*name.rpartition(".")[::2]) for name in names if not name.endswith(f".{INDEX}")]
        work = set[tuple[str, str]]()
        for entry in entries:
            if entry and entry.digest and entry.date == date and not entry.failed:
                work.add(("join" if entry.repository == "ros-tf" else "build", entry.target))
                work |= {("test", entry.target)} if entry.passed else set()
        return work

    def put_other(self, target: str = "ros1-bookworm-core", **labels: str) -> str:
        """Puts what a runner for the other architecture would have left: an image, here of this one's layers, and its entry, with tests
        that passed. Gives its digest.

        Args:
            target: a ROS image that stands on no other one, and is there for this architecture. labels: that it has to itself.
        """
        place = self.place()
        book, client = Records(place), place.client
        here = Services.load(self.folder)
        state = survey(Request(here, self.image_set, place, only=(target,), architectures=(OTHER,)))
        item, other = state.by_key[target, OTHER], book.read(target, NATIVE)
        assert other and not item.needs
        path = book.place.path(item.repository)
        manifest = client.manifest(path, other.digest)
        assert manifest
        config = client.json_blob(path, manifest.content["config"]["digest"])
        config["architecture"] = OTHER
        config["config"]["Labels"] |= {f"io.rosml.{name}": value for name, value in labels.items()}
        data = oci.encoded(config)
        client.put_blob(path, data)
        content = manifest.content | {"config": oci.descriptor(oci.CONFIG, data)}
        digest = client.put_manifest(path, "", content)
        entry = book.read(*item.key)
        before = (*entry.superseded, entry.digest) if entry else ()
        tested = state.tests.digest(item, state.tests.to_run(item))
        digests = {"inputs": state.inputs.digest(*item.key), "tested": tested, "digest": digest}
        book.write(replace(other, architecture=OTHER, superseded=before, **digests), state.inputs.of(*item.key))  # type: ignore[arg-type]
        return digest

    def mark(self, ros: str = "1", part: str = "1") -> None:
        """Changes what ROS images, or parts, hold."""
        for name, text in {
            "components/ros/install.sh": ROS.format(mark=ros),
            "components/part/assemble.sh": PART.format(mark=part),
        }.items():
            (self.folder / name).write_text(text)
            (self.folder / name).chmod(0o755)

    def poison(self, name: str = "ros1-base", poisoned: bool = True) -> None:
        """Has a test of some images fail, or succeed again."""
        path = "/nowhere" if poisoned else "/etc/os-release"
        (self.folder / f"tests/structure/{name}.yaml").write_text(TEST.format(path=path))

    def with_environment(self, *images: str) -> None:
        """Gives images one that has no packages, built by the real scripts."""
        text = str(Lock("empty", "3.11", NATIVE, 36, {}, {}))
        file = self.folder / f"environments/empty/3.11/{NATIVE}.txt"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        matrix = yaml.safe_load((self.folder / "matrix.yaml").read_text())
        size = {"unpacked": 1, "compressed": 1}
        matrix["environments"] = {"empty": {"images": [*images], "architectures": [NATIVE], "disk": size}}
        (self.folder / "matrix.yaml").write_text(yaml.safe_dump(matrix, sort_keys=False))

    def client(self) -> Registry:
        """The registry."""
        return Registry(self.services.registry)

    def tags(self) -> dict[str, str]:
        """Every tag of every image and part, and where it points."""
        client = self.client()
        paths = {repository: f"{self.prefix}/{repository}" for repository in ("ros", "ros-tf", *PARTS_OF)}
        return {
            f"{repository}:{tag}": client.head(path, tag)
            for repository, path in paths.items()
            for tag in client.tags(path)
            if not tag.startswith("sha256-")
        }

    def check(self) -> None:
        """What must hold at any time: a tag points at a whole index of images that passed their tests."""
        client = self.client()
        book = Records(self.place())
        for tag, digest in self.tags().items():
            repository = f"{self.prefix}/{tag.split(':')[0]}"
            index = client.manifest(repository, digest)
            assert index and index.content.get("manifests"), f"{tag} points at no index"
            if not tag.startswith(PARTS_OF):
                require_oci_set(index.content["annotations"], tag)
            assert store.DATE in index.content["annotations"], f"{tag} was not made by a run"
            for member in index.content["manifests"]:
                assert client.referrers(repository, member["digest"], ARTIFACT), f"{tag}: its entry is not attached"
                manifest = client.manifest(repository, member["digest"])
                assert manifest, f"{tag} is partial"
                if not tag.startswith(PARTS_OF):
                    attached = book.attached(repository.removeprefix(f"{self.prefix}/"), member["digest"])
                    assert attached and attached.passed and not attached.failures, f"{tag}: an untested image"
                    config = client.json_blob(repository, manifest.content["config"]["digest"])
                    require_oci_set(config["config"]["Labels"], tag)
                for layer in (manifest.content["config"], *manifest.content["layers"]):
                    assert client.has_blob(repository, layer["digest"]), f"{tag} lacks a layer"


SOURCE = "https://example.org/images"
"""Where the small project says that it lives."""

OCI = {
    "title": r"(ros1-bookworm|broken|late)-(core|base)(-tensorflow-cpu)?(-env-empty)?",
    "description": r"ROS 1 (core|base) \((ros1-bookworm|broken|late)\)(, TensorFlow 2\.21\.0)?(, environment empty)?",
    "version": r"(ros1-bookworm|broken|late)-(core|base)(-cpu-tf2\.21\.0)?(-env-empty)?",
    "created": r"2026-01-01T00:00:00Z",
    "licenses": r"Apache-2\.0( AND [A-Za-z0-9.-]+)*",
    "base.name": r"\S*debian:bookworm",
    "base.digest": r"sha256:[0-9a-f]{64}",
    "source": re.escape(SOURCE),
}
"""What every image of the small project says of itself, but for the revision: an index has that where the checkout is one
of git, and no image has it. Expressions for the whole of each."""


def require_oci_set(labels: Mapping[str, str], tag: str) -> None:
    """That labels, or annotations, hold the whole set that the OCI names."""
    prefix = "org.opencontainers.image."
    texts = {name.removeprefix(prefix): text for name, text in labels.items() if name.startswith(prefix)}
    texts.pop("revision", "")
    assert texts.keys() == OCI.keys(), f"{tag}: {sorted(texts)}"
    for name, pattern in OCI.items():
        assert re.fullmatch(pattern, texts[name]), f"{tag}: {name} is {texts[name]!r}"


def begun(log: str) -> set[tuple[str, str]]:
    """The work that a run began: step and target."""
    return {(step, target) for step, target in re.findall(r"^==> (build|join|test) (\S+) for ", log, re.M)}


USED = ("components/part/install-assembler.sh", "components/build/network.sh", "tools/requirements.txt")
"""What the recipe of the base image uses."""


def base(services: Services) -> tuple[str, str]:
    """Name and digest of the base image of small projects; made where the registry has none of today's recipe."""
    recipe = BASE.format(os=system(services, "bookworm"))
    content = recipe.encode() + b"".join((ROOT / name).read_bytes() for name in USED)
    repository = f"rosml-test/{hashlib.sha256(content).hexdigest()[:12]}/debian"
    client = Registry(services.registry)
    with turn(ROOT / ".state/base/mini.lock", lambda: None):
        if not client.head(repository, "bookworm"):
            build_base(services, recipe, f"{services.registry}/{repository}:bookworm")
        return f"{services.registry}/{repository}:bookworm", client.head(repository, "bookworm")


def build_base(services: Services, recipe: str, name: str, *options: str) -> None:
    """Builds the base image, or its variant for another architecture, and pushes it."""
    with tempfile.TemporaryDirectory() as folder:
        for used in USED:
            target = Path(folder, used)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / used, target)
        (Path(folder) / "Dockerfile").write_text(recipe)
        output = f"type=image,push=true,name={name}"
        buildx(services, "--provenance=false", *options, "--output", output, folder)


def for_both(folder: Path, services: Services) -> None:
    """Gives the base image that a small project's matrix names a variant for the other architecture, under emulation."""
    matrix = yaml.safe_load((folder / "matrix.yaml").read_text())
    bookworm = matrix["operating_systems"]["bookworm"]
    repository = bookworm["image"].removesuffix(":bookworm")
    recipe = BASE.format(os=system(services, "bookworm", OTHER))
    build_base(services, recipe, f"{repository}:{OTHER}", "--platform", f"linux/{OTHER}")
    digests = [bookworm["digest"], regctl.digest(services, f"{repository}:{OTHER}")]
    bookworm["digest"] = regctl.create_index(services, repository, digests, {})
    (folder / "matrix.yaml").write_text(yaml.safe_dump(matrix, sort_keys=False))


def copy_checkout(folder: Path, *states: str) -> None:
    """Copies what a build needs into a folder. The state is this checkout's: base images, passwords, programs, and `states`."""
    for name in CHECKOUT:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / name, folder / name)
    (folder / ".state").mkdir()
    for name in ("registry", "base", "auth", "bin", *states):
        if (ROOT / ".state" / name).exists():
            (folder / ".state" / name).symlink_to(ROOT / ".state" / name)


def make(folder: Path, services: Services) -> Mini:
    """A small checkout in a folder, with a place of its own in the registry."""
    (ROOT / ".state" / "base").mkdir(exist_ok=True)  # base images are made once, by whoever is the first
    copy_checkout(folder)
    for file in (folder / "tests/structure").glob("*.yaml"):
        file.write_text(TEST.format(path="/etc/os-release"))
    matrix = yaml.safe_load((ROOT / "matrix.yaml").read_text())
    changes = {"components": ["core", "base"], "default_stack": "cpu"}
    matrix["distributions"] = {"ros1-bookworm": matrix["distributions"]["ros1-bookworm"] | changes}
    image, digest = base(services)
    matrix["operating_systems"] = {
        "bookworm": matrix["operating_systems"]["bookworm"] | {"image": image, "digest": digest}
    }
    matrix["frameworks"] = {name: matrix["frameworks"][name] for name in ("none", "tensorflow")}
    chosen = matrix["frameworks"]["tensorflow"]["parts"]
    matrix["parts"] = [part for part in matrix["parts"] if part["name"] in chosen]
    release = matrix["stacks"]["cpu"]["releases"]["tensorflow"]
    package = matrix["stacks"]["cpu"]["packages"]["tensorflow"]
    matrix.pop("addons")
    matrix.pop("environments")
    matrix["stacks"] = {"cpu": matrix["stacks"]["cpu"] | {"releases": {"tensorflow": release}}}
    matrix["stacks"]["cpu"]["packages"] = {"tensorflow": package}
    matrix["releases"] = {"tensorflow": {release: matrix["releases"]["tensorflow"][release]}}
    parts = {name: size for name, size in matrix["disk"]["parts"]["cpu"].items() if name in chosen}
    matrix["disk"] |= {"parts": {"cpu": parts}, "budgets": {}}
    matrix["source"] = SOURCE
    matrix["default"] = {"targets": ["ros1-bookworm-core"], "group": ["ros1-bookworm-core"], "assembler": "bookworm"}
    (folder / "matrix.yaml").write_text(yaml.safe_dump(matrix, sort_keys=False))
    facts = (ROOT / ".state/services.json").read_text()
    (folder / ".state/services.json").write_text(facts)
    use(folder, builder=services.builder, builder_kind=services.builder_kind, bases=[])
    for name, text in {
        "base/install": NOTHING,
        "part/install-assembler": NOTHING,
        "base/contract": CONTRACT,
        "tensorflow/install-assembler": NOTHING,
    }.items():
        (folder / f"components/{name}.sh").write_text(text)
    mini = Mini(folder, services, "").elsewhere()
    mini.mark()
    return mini


def use(folder: Path, **changes: object) -> Services:
    """Has a checkout use other services."""
    file = folder / ".state/services.json"
    facts = json.loads(file.read_text()) | changes
    file.unlink()  # it may be a link
    file.write_text(json.dumps(facts))
    return Services.load(folder)
