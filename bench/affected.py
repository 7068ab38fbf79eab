"""`rosml affected` over a thousand apps on ten base images, in the local registry. Each has an SBOM of its own, as large as a real one.
Everything is in a namespace of its own, and is removed at the end."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from bench import local
from bench.fleet import Counting
from rosml.base.side_by_side import side_by_side
from rosml.base.terminal import show, table
from rosml.base.units import duration
from rosml.containerize.affected import query
from rosml.containerize.affected.images import Images
from rosml.containerize.affected.inventory import Matches
from rosml.containerize.affected.query import Query
from rosml.containerize.affected.search import Search
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME
from rosml.images.scan import attached, cyclonedx
from rosml.images.scan.packages import Apt, Packages, System
from rosml.images.scan.trivy import Trivy
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries, Registry

NAMESPACE = "bench-affected"
APPS, BASES, PACKAGES = 1000, 10, 525
SECONDS = 20.0
"""What a thousand apps may take."""


@dataclass(frozen=True)
class Result:
    """What one query took: seconds, seconds of this process's processor time, requests, and how many apps have each state."""

    query: str
    seconds: float
    processor: float
    requests: int
    states: dict[str, int]


def print_table(results: Iterable[Result], apps: int) -> None:
    """Prints the results, a row each."""
    columns = ("seconds", "processor time", "requests for each app", "affected")
    printed = table("query", *columns, right=columns)
    for it in results:
        times = duration(it.seconds), duration(it.processor)
        printed.add_row(it.query, *times, f"{it.requests / apps:.1f}", str(it.states.get("affected", 0)))
    show(printed)


def measure(services: Services, apps: int, trivy: Trivy | None, say: Callable[[str], None]) -> list[Result]:
    """Makes base images and apps, asks, and removes everything. `trivy`: with a database; None to ask for packages alone."""
    pushed = set[tuple[str, str]]()
    with (
        Registries(services.ca_bundle) as registries,
        local.cleaned(registry := registries(services.registry), pushed, say),
    ):
        say(f"{BASES} base images and {apps} apps")
        names = side_by_side(_Making(registry, pushed).app, range(apps), title="make")
        texts = ["libpackage7<1.9", "pypi:wheel-3<2", *(["CVE-2026-90004"] if trivy else [])]
        return [_ask(registries, query.parse(text), names, trivy, say) for text in texts]


def _ask(
    registries: Registries, question: Query, names: list[str], trivy: Trivy | None, say: Callable[[str], None]
) -> Result:
    say(f"ask for {question.text}")
    counting, started, processor = Counting(), time.monotonic(), time.process_time()
    with counting.on(), Images(registries, references.parse) as images:

        def judge(start: int) -> Matches:
            if trivy and question.is_advisory:
                return images.inventory.vulnerable(question.text, trivy, start)
            return images.inventory.matching(question, start)

        answers = Search(images, question, judge).run(names)
    seconds, states = time.monotonic() - started, [answer.state for answer in answers]
    processor = time.process_time() - processor
    return Result(
        question.text, seconds, processor, counting.requests, {state: states.count(state) for state in {*states}}
    )


def _packages(base: int) -> bytes:
    """The SBOM of a ROS image: a tenth of its packages are other ones in each base image."""
    versions = (f"1.{number}-1+deb12u{base if number % 10 == 7 else 0}" for number in range(PACKAGES))
    apt = [
        Apt(
            name=f"libpackage{number}",
            version=version,
            architecture="amd64",
            source=f"package{number}",
            source_version=version,
            maintainer="A team of Debian <team@example.org>",
            licenses=["GPL-2.0-or-later", "MIT"],
            depends=f"libpackage{number // 2}, libpackage{number // 3}",
        )
        for number, version in enumerate(versions)
    ]
    contents = Packages(system=System(name="debian", version="12.12"), apt=apt, python=[], ros=[])
    return cyclonedx.document(contents, "bench")


class _Making:
    """Puts images without layers, each with an SBOM."""

    def __init__(self, registry: Registry, pushed: set[tuple[str, str]]) -> None:
        self._registry, self._pushed = registry, pushed
        self._sboms = [json.loads(_packages(number)) for number in range(BASES)]
        self._bases = [self._put("ros", f"base-{number}", self._sboms[number], {}) for number in range(BASES)]
        self._digests = [registry.head(*references.parse(base)[1:]) for base in self._bases]

    def app(self, number: int) -> str:
        which = number % BASES
        labels = {APP: "run", BASE_NAME: self._bases[which], BASE_DIGEST: self._digests[which]}
        names = (f"wheel-{number % 20}", f"app-{number}")
        wheels = [
            {"bom-ref": name, "type": "library", "name": name, "version": "1.0", "purl": f"pkg:pypi/{name}@1.0"}
            for name in names
        ]
        base = self._sboms[which]
        return self._put(f"app-{number}", "latest", {**base, "components": [*base["components"], *wheels]}, labels)

    def _put(self, name: str, tag: str, document: Mapping[str, Any], labels: Mapping[str, str]) -> str:
        registry, repository = self._registry, f"{NAMESPACE}/{name}"
        facts = {"architecture": "amd64", "os": "linux", "config": {"Labels": {**labels, "name": f"{name}:{tag}"}}}
        config = oci.encoded({**facts, "rootfs": {"type": "layers", "diff_ids": []}})
        registry.put_blob(repository, config)
        about = {"mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": []}
        manifest = oci.encoded({"schemaVersion": 2, **about})
        digest = registry.put_manifest(repository, tag, manifest)
        component = {**document["metadata"]["component"], "name": f"{registry.host}/{repository}@{digest}"}
        data = oci.encoded({**document, "metadata": {**document["metadata"], "component": component}})
        subject = oci.descriptor(oci.IMAGE, manifest)
        artifact = attached.attach(registry, repository, subject, data)
        self._pushed.update({(repository, digest), (repository, artifact)})
        return f"{registry.host}/{repository}:{tag}"
