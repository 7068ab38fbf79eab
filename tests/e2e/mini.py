"""A checkout whose images are small: the real Dockerfile, builder, registry and test runner, with scripts that install
next to nothing. A publishing run of six images takes seconds, so that it can be broken many times."""

from __future__ import annotations

import hashlib
import json
import os
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
from rosml.images.builds import base_images
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
from tests.e2e.conftest import CHECKOUT, Run, run
from tests.e2e.images import ca_secret

NOTHING = "#!/usr/bin/env bash\n"

NATIVE = base_images.native_architecture()
OTHER = "amd64" if NATIVE == "arm64" else "arm64"

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

    def all(self, *arguments: str, env: dict[str, str] | None = None) -> dict[str, Any]:
        """A whole publishing run that succeeds; what it says."""
        outcome = self.publish("all", "--serve", NATIVE, "--json", *arguments, env=env)
        assert outcome.code == 0, outcome.err + outcome.out
        content = json.loads(outcome.out)
        assert isinstance(content, dict)
        return content

    def start(
        self, *arguments: str, env: dict[str, str] | None = None, log: Path = Path(os.devnull)
    ) -> subprocess.Popen[bytes]:
        """A publishing run that somebody ends; what it says goes into a file."""
        command = self.command("all", "--serve", NATIVE, "--registry", self.registry, *arguments)
        with log.open("wb") as said:
            return subprocess.Popen(
                command,
                cwd=self.folder,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=said,
                env={**os.environ, **(env or {})},
            )

    def recorded(self, date: str) -> set[tuple[str, str]]:
        """The work of a run, by its date, whose result the records have: step and target."""
        book = Records(self.place())
        names = [name for name in book.registry.tags(book.repository) if not name.startswith(("sha256-", UNDO))]
        entries = [book.read(*name.rpartition(".")[::2]) for name in names if not name.endswith(f".{INDEX}")]
        found = set[tuple[str, str]]()
        for entry in entries:
            if entry and entry.digest and entry.date == date and not entry.failed:
                found.add(("join" if entry.repository == "ros-tf" else "build", entry.target))
                found |= {("test", entry.target)} if entry.passed else set()
        return found

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
        known = book.read(*item.key)
        before = (*known.superseded, known.digest) if known else ()
        tested = state.tests.digest(item, state.tests.to_run(item))
        own = {"inputs": state.inputs.digest(*item.key), "tested": tested, "digest": digest}
        book.write(replace(other, architecture=OTHER, superseded=before, **own), state.inputs.of(*item.key))  # type: ignore[arg-type]
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

    def client(self) -> Registry:
        """The registry."""
        return Registry(self.services.registry)

    def tags(self) -> dict[str, str]:
        """Every tag of every image and part, and where it points."""
        client = self.client()
        found = {}
        for repository in ("ros", "ros-tf", "part"):
            path = f"{self.prefix}/{repository}"
            for tag in client.tags(path):
                if not tag.startswith("sha256-"):
                    found[f"{repository}:{tag}"] = client.head(path, tag)
        return found

    def check(self) -> None:
        """What must hold at any time: a tag points at a whole index of images that passed their tests."""
        client = self.client()
        book = Records(self.place())
        for tag, digest in self.tags().items():
            repository = f"{self.prefix}/{tag.split(':')[0]}"
            index = client.manifest(repository, digest)
            assert index and index.content.get("manifests"), f"{tag} points at no index"
            if not tag.startswith("part:"):
                require_oci_set(index.content["annotations"], tag)
            assert store.DATE in index.content["annotations"], f"{tag} was not made by a run"
            for member in index.content["manifests"]:
                assert client.referrers(repository, member["digest"], ARTIFACT), f"{tag}: its entry is not attached"
                manifest = client.manifest(repository, member["digest"])
                assert manifest, f"{tag} is partial"
                if not tag.startswith("part:"):
                    attached = book.attached(repository.removeprefix(f"{self.prefix}/"), member["digest"])
                    assert attached and attached.passed and not attached.failures, f"{tag}: an untested image"
                    config = client.json_blob(repository, manifest.content["config"]["digest"])
                    require_oci_set(config["config"]["Labels"], tag)
                for layer in (manifest.content["config"], *manifest.content["layers"]):
                    assert client.has_blob(repository, layer["digest"]), f"{tag} lacks a layer"


SOURCE = "https://example.org/images"
"""Where the small project says that it lives."""

OCI = {
    "title": r"(ros1-bookworm|broken|late)-(core|base)(-tensorflow-cpu)?",
    "description": r"ROS 1 (core|base) \((ros1-bookworm|broken|late)\)(, TensorFlow 2\.21\.0)?",
    "version": r"(ros1-bookworm|broken|late)-(core|base)(-cpu-tf2\.21\.0)?",
    "created": r"2026-01-01T00:00:00Z",
    "licenses": r"Apache-2\.0( AND [A-Za-z0-9.-]+)*",
    "base.name": r"\S*debian:bookworm",
    "base.digest": r"sha256:[0-9a-f]{64}",
    "source": re.escape(SOURCE),
}
"""What every image of the small project says of itself, but for the revision: an index has that where the checkout is one
of git, and no image has it. Expressions for the whole of each."""


def require_oci_set(said: Mapping[str, str], tag: str) -> None:
    """That labels, or annotations, hold the whole set that the OCI names."""
    prefix = "org.opencontainers.image."
    found = {name.removeprefix(prefix): text for name, text in said.items() if name.startswith(prefix)}
    found.pop("revision", "")
    assert found.keys() == OCI.keys(), f"{tag}: {sorted(found)}"
    for name, pattern in OCI.items():
        assert re.fullmatch(pattern, found[name]), f"{tag}: {name} is {found[name]!r}"


def begun(said: str) -> set[tuple[str, str]]:
    """The work that a run began, by what it said: step and target."""
    return {(step, target) for step, target in re.findall(r"^==> (build|join|test) (\S+) for ", said, re.M)}


USED = ("components/part/install-assembler.sh", "components/build/network.sh", "tools/requirements.txt")
"""What the recipe of the base image uses."""


def base(services: Services, image_set: ImageSet) -> tuple[str, str]:
    """Name and digest of the base image of small projects; made where the registry has none of today's recipe."""
    recipe = BASE.format(os=base_images.reference(services, image_set.matrix.operating_systems, "bookworm"))
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
        command = [*services.buildx, "build", "--progress", "plain", "--provenance=false", *options]
        command += ["--output", f"type=image,push=true,name={name}", *ca_secret(services)]
        outcome = run(*command, folder, env=services.environment())
    assert outcome.code == 0, outcome.err


def for_both(folder: Path, services: Services, image_set: ImageSet) -> None:
    """Gives the base image that a small project's matrix names a variant for the other architecture, under emulation."""
    matrix = yaml.safe_load((folder / "matrix.yaml").read_text())
    system = matrix["operating_systems"]["bookworm"]
    repository = system["image"].removesuffix(":bookworm")
    [other] = {"amd64", "arm64"} - {base_images.native_architecture()}
    parent = base_images.reference(services, image_set.matrix.operating_systems, "bookworm", other)
    build_base(services, BASE.format(os=parent), f"{repository}:{other}", "--platform", f"linux/{other}")
    digests = [system["digest"], regctl.digest(services, f"{repository}:{other}")]
    system["digest"] = regctl.create_index(services, repository, digests, {})
    (folder / "matrix.yaml").write_text(yaml.safe_dump(matrix, sort_keys=False))


def make(folder: Path, services: Services) -> Mini:
    """A small checkout in a folder, with a place of its own in the registry."""
    for name in CHECKOUT:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / name, folder / name)
    shutil.copytree(ROOT / "tests" / "structure", folder / "tests" / "structure")
    for file in (folder / "tests/structure").glob("*.yaml"):
        file.write_text(TEST.format(path="/etc/os-release"))
    matrix = yaml.safe_load((ROOT / "matrix.yaml").read_text())
    matrix["distributions"] = {
        "ros1-bookworm": matrix["distributions"]["ros1-bookworm"] | {"components": ["core", "base"]}
    }
    matrix["distributions"]["ros1-bookworm"]["default_stack"] = "cpu"
    image, digest = base(services, load.load(ROOT / "matrix.yaml"))
    matrix["operating_systems"] = {
        "bookworm": matrix["operating_systems"]["bookworm"] | {"image": image, "digest": digest}
    }
    matrix["frameworks"] = {name: matrix["frameworks"][name] for name in ("none", "tensorflow")}
    chosen = matrix["frameworks"]["tensorflow"]["parts"]
    matrix["parts"] = [part for part in matrix["parts"] if part["name"] in chosen]
    release = matrix["stacks"]["cpu"]["releases"]["tensorflow"]
    package = matrix["stacks"]["cpu"]["packages"]["tensorflow"]
    matrix.pop("addons")
    alone: dict[str, Any] = {"releases": {"tensorflow": release}, "packages": {"tensorflow": package}}
    matrix["stacks"] = {"cpu": matrix["stacks"]["cpu"] | alone}
    matrix["releases"] = {"tensorflow": {release: matrix["releases"]["tensorflow"][release]}}
    parts = {name: size for name, size in matrix["disk"]["parts"]["cpu"].items() if name in chosen}
    matrix["disk"] |= {"parts": {"cpu": parts}, "budgets": {}}
    matrix["source"] = SOURCE
    matrix["default"] = {"targets": ["ros1-bookworm-core"], "group": ["ros1-bookworm-core"], "assembler": "bookworm"}
    (folder / "matrix.yaml").write_text(yaml.safe_dump(matrix, sort_keys=False))
    (folder / ".state").mkdir()
    (ROOT / ".state" / "base").mkdir(exist_ok=True)  # base images are made once, by whoever is the first
    for name in ("registry", "base", "auth", "bin"):
        if (ROOT / ".state" / name).exists():
            (folder / ".state" / name).symlink_to(ROOT / ".state" / name)
    facts = json.loads((ROOT / ".state" / "services.json").read_text())
    own = {"builder": services.builder, "builder_kind": services.builder_kind, "bases": []}
    (folder / ".state" / "services.json").write_text(json.dumps(facts | own))
    for name, text in {
        "base/install": NOTHING,
        "part/install-assembler": NOTHING,
        "base/contract": CONTRACT,
        "tensorflow/install-assembler": NOTHING,
    }.items():
        (folder / f"components/{name}.sh").write_text(text)
    found = Mini(folder, services, "").elsewhere()
    found.mark()
    return found
