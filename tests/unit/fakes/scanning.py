"""A local replacement for trivy, with the real one's command line."""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from fakes.memory_registry import MemoryRegistry, sbom_of
from rosml.images.matrix.source import parse
from rosml.images.scan import judge
from rosml.images.scan.judge import Image, Part
from rosml.images.scan.policy import Rules, parsed
from rosml.images.scan.sbom import FORMAT, MEDIA_TYPE, Shelf
from rosml.images.scan.trivy import Trivy
from rosml.registry import oci

NOW = datetime(2026, 11, 22, 3, 0, tzinfo=UTC)
VERSION = "0.65.0"
HOST = "127.0.0.1:1"

PROGRAM = f"""#!{sys.executable} -IS
import json, os, pathlib, sys, time
here = pathlib.Path(__file__).parent
world = json.loads((here / "world.json").read_text())
argv = sys.argv[1:]
with (here / "calls").open("a") as stream:
    stream.write(" ".join(argv) + "\\n")
(here / "environment").write_text(json.dumps(dict(os.environ, FOLDER=os.getcwd())))
after = lambda option: argv[argv.index(option) + 1]
cache = pathlib.Path(after("--cache-dir"))

def fail(text, code=1):
    sys.stderr.write("2026-11-22T03:00:00Z\\tINFO\\tnoise\\n2026-11-22T03:00:00Z\\tFATAL\\tFatal error\\t" + text + "\\n")
    sys.exit(code)

def behave(how):
    if how == "crash":
        fail("run error: it crashed\\n\\t* for two\\n\\t* reasons")
    elif how == "killed":
        os.kill(os.getpid(), 9)
    elif how == "silent":
        sys.exit(7)
    elif how == "hang":
        time.sleep(60)
    elif how == "nothing":
        sys.exit(0)
    elif how:
        pathlib.Path(after("--output")).write_text(how)
        sys.exit(0)

if "--version" in argv:
    print("Version: " + world["version"])
elif "--download-db-only" in argv:
    source = after("--db-repository")
    if source not in world["repositories"]:
        fail("run error: " + source + ": MANIFEST_UNKNOWN")
    behave(world["fail"].get("fetch"))
    (cache / "db").mkdir(parents=True, exist_ok=True)
    (cache / "db/trivy.db").write_text(json.dumps(world["repositories"][source]["advisories"]))
    (cache / "db/trivy.db").open("a").write(" " + world["buckets"])
    (cache / "db/metadata.json").write_text(json.dumps(world["repositories"][source]["metadata"]))
elif "sbom" in argv:
    document = json.loads(pathlib.Path(argv[-1]).read_text())
    digest = document["metadata"]["component"]["name"].partition("@")[2]
    behave(world["fail"].get(digest) or world["fail"].get("sbom"))
    if not (cache / "db/trivy.db").exists():
        fail("init error: DB error: database error: --skip-db-update cannot be specified on the first run")
    advisories = json.JSONDecoder().raw_decode((cache / "db/trivy.db").read_text())[0]
    components = document["components"]
    packages = [c for c in components if c["type"] == "library"]
    system = [c["version"] for c in components if c["type"] == "operating-system"]
    vulnerabilities = [
        {{**a, "PkgName": p["name"], "InstalledVersion": p["version"], "Title": "what it is about",
          "PkgIdentifier": {{"PURL": p["purl"], "BOMRef": p["bom-ref"], "UID": "1"}}}}
        for p in packages for a in advisories.get(p["name"], [])
    ]
    missed = world["fail"].get("missed", 0)
    pathlib.Path(after("--output")).write_text(json.dumps({{
        "SchemaVersion": 2,
        "Metadata": {{"OS": {{"Family": "debian", "Name": system[0], "EOSL": world.get("eosl", False)}}}} if system else {{}},
        "Results": [{{"Target": "t", "Class": "os-pkgs", "Type": "debian", "Packages": packages[missed:],
                     "Vulnerabilities": vulnerabilities}}],
    }}))
else:
    fail("unknown command")
"""


def digest(name: str) -> str:
    return f"sha256:{hashlib.sha256(name.encode()).hexdigest()}"


def advisory(name: str, severity: str = "HIGH", fixed: str = "2.0") -> dict[str, str]:
    """An advisory as trivy reports it."""
    return {"VulnerabilityID": name, "Severity": severity, **({"FixedVersion": fixed} if fixed else {})}


@dataclass
class World:
    """A folder with a local replacement for trivy and its database, and a registry in memory.

    Attributes:
        fail: what goes wrong, by call: `fetch`, `sbom`, that of a digest; `missed`: packages that are not checked.
        records: the SBOMs that the publisher's records name.
    """

    folder: Path
    version: str = VERSION
    advisories: dict[str, list[dict[str, str]]] = field(default_factory=dict)
    updated: str = "2026-11-22T00:00:00.123456789Z"
    schema: int = 2
    sources: tuple[str, ...] = ("example.org/db:2",)
    eosl: bool = False
    buckets: str = "debian 12, pip::GitHub"  # the sources of advisories in the database
    fail: dict[str, Any] = field(default_factory=dict)
    memory: MemoryRegistry = field(default_factory=MemoryRegistry)
    records: dict[str, str] = field(default_factory=dict)

    def write(self) -> None:
        """Lets the program see what changed."""
        metadata = {"Version": self.schema, "UpdatedAt": self.updated, "DownloadedAt": "0001-01-01T00:00:00Z"}
        state = {"advisories": self.advisories, "metadata": metadata}
        content = {
            "version": self.version,
            "repositories": dict.fromkeys(self.sources, state),
            "fail": self.fail,
            "eosl": self.eosl,
            "buckets": self.buckets,
        }
        (self.folder / "world.json").write_text(json.dumps(content))

    def part(self, name: str, *names: str, ros: bool = False, system: str = "12.15") -> Part:
        """A part with packages, and with its SBOM."""
        part = Part(name, HOST, f"rosml/{name}", digest(name), ros)
        self.records[part.digest] = self.attach(part, sbom_of(part.reference, names, system if ros else ""))
        return part

    def attach(self, to: Part, content: bytes, annotations: Mapping[str, str] = FORMAT) -> str:
        subject = {"mediaType": oci.IMAGE, "digest": to.digest, "size": 7}
        return self.memory.attach(to.repository, subject, MEDIA_TYPE, content, MEDIA_TYPE, annotations)

    def shelf(self) -> Shelf:
        return Shelf(self.memory, self.records)

    def trivy(self, **changes: Any) -> Trivy:
        self.write()
        program = self.folder / "trivy"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        root = self.folder / "checkout"
        (root / ".state").mkdir(parents=True, exist_ok=True)
        (root / ".state" / "scanner.json").write_text(json.dumps({"trivy": str(program)}))
        (root / "tools/go/trivy").mkdir(parents=True, exist_ok=True)
        (root / "tools/go/trivy/go.mod").write_text(f"require (\n\tgithub.com/aquasecurity/trivy v{VERSION}\n)\n")
        trivy = Trivy.find(root, self.folder / "cache")
        for name, value in {"pause": 0.0, **changes}.items():
            setattr(trivy, name, value)
        return trivy

    def ready(self, **changes: Any) -> Trivy:
        """The program with a database that was just fetched."""
        program = self.trivy(**changes)
        program.fetch(rules().policy.database)
        return program

    def run(self, *images: Image, **options: Any) -> judge.Run:
        """A scan of images."""
        policy, now = options.pop("rules", rules()), options.pop("now", NOW)
        scanner = judge.Scanner(self.ready(**options.pop("trivy", {})), self.shelf())
        scans = judge.scan_images(images, policy, scanner, now)
        return judge.summarise(scans, policy, now.date(), options.pop("whole", True), **options)

    def calls(self, word: str) -> list[str]:
        """The calls of the program with a word in them."""
        file = self.folder / "calls"
        return [line for line in file.read_text().splitlines() if word in line.split()] if file.exists() else []


POLICY = """\
version: 1
fail: [critical, high]
fixable_only: true
database: {repositories: [example.org/db:2], max_age_hours: 48}
"""


def rules(ignore: str = "", **changes: str) -> Rules:
    """A policy, with entries of `ignore` and other values."""
    text = POLICY + (f"ignore:\n{ignore}" if ignore else "")
    for name, value in changes.items():
        line = next(line for line in text.splitlines() if line.startswith(f"{name}:"))
        text = text.replace(line, f"{name}: {value}")
    return parsed(parse(text.encode(), "scan.yaml"))


def image(target: str, *parts: Part) -> Image:
    return Image(target, "amd64", parts)
