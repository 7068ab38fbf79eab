"""A thousand apps that move to tonight's base images, beside one app that is built again.

The apps are of 20 kinds, on ten base images. All are made from one real app and one real base image, in the local registry, by new
manifests and configs: layers, lists and facts have the sizes of real ones. Everything is in a namespace of its own, and is removed at the end.
"""

from __future__ import annotations

import copy
import gzip
import io
import logging
import tarfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from bench import local
from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.base.terminal import show, table
from rosml.base.units import duration, size
from rosml.containerize.rebase import image
from rosml.containerize.rebase.fleet import Entry, Fleet
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.containerize.rebase.trial import Pair, Trial
from rosml.images.image_set.labels import BASE_DIGEST, BASE_NAME, TITLE
from rosml.images.join import facts, file_lists
from rosml.images.join.layers import Joined, Source
from rosml.images.join.transfer import Transfer, Transferred
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries, Registry

NAMESPACE = "bench-fleet"
APPS, KINDS, BASES = 1000, 20, 10
SECONDS, BYTES, LINKED = 1.0, 20_000, 20.0
"""What one app alone may take: to move by the facts, what is sent for it, and with the link check in the builder."""
LISTS = ((file_lists.ARTIFACT, file_lists.MEDIA_TYPE), (facts.ARTIFACT, facts.MEDIA_TYPE))


@dataclass
class Result:
    """What moving came to.

    Attributes:
        states: how many apps moved, were refused or failed.
        seconds: wall time of the whole run.
        uploaded: bytes sent. requests: to the registry.
        one: seconds, bytes and requests of one app alone, with an empty cache.
        linked: seconds of its link check in the builder.
    """

    states: Mapping[str, int]
    seconds: float
    uploaded: int
    requests: int
    one: tuple[float, int, int]
    linked: float

    @property
    def beyond(self) -> list[str]:
        """What took more than it may."""
        limits = (("seconds", self.one[0], SECONDS), ("bytes", self.one[1], BYTES),
                  ("seconds with the link check", self.one[0] + self.linked, LINKED))  # fmt: skip
        return [f"{value:.1f} {what}, and at most {limit}" for what, value, limit in limits if value > limit]


def print_table(result: Result, again: float) -> None:
    """Prints the result. `again`: seconds that a build of one app takes on a new base image; 0 if unknown."""
    count = sum(result.states.values())
    printed = table("apps on tonight's base images", f"{count} apps", "one app", right=(f"{count} apps", "one app"))
    printed.add_row("seconds", duration(result.seconds), duration(result.one[0]))
    printed.add_row("for each app", duration(result.seconds / count), duration(result.one[0]))
    printed.add_row("sent for each app", size(result.uploaded // count), size(result.one[1]))
    printed.add_row("requests for each app", f"{result.requests / count:.0f}", str(result.one[2]))
    printed.add_row("and linked in the builder", "", duration(result.one[0] + result.linked))
    if again:
        printed.add_row("rosml containerize, on the new base image", "", duration(again))
    show(printed)


class Counting(logging.Handler):
    """Counts requests, of which httpx logs each."""

    def __init__(self) -> None:
        super().__init__()
        self.requests = 0

    def emit(self, record: logging.LogRecord) -> None:
        """Counts one."""
        self.requests += record.getMessage().startswith("HTTP Request")

    @contextmanager
    def on(self) -> Iterator[None]:
        """Counts meanwhile."""
        log = logging.getLogger("httpx")
        level, shared = log.level, log.propagate
        log.addHandler(self)
        log.setLevel(logging.INFO)
        log.propagate = False
        try:
            yield
        finally:
            log.removeHandler(self)
            log.setLevel(level)
            log.propagate = shared


def measure(services: Services, apps: int, say: Callable[[str], None]) -> tuple[Result, float]:
    """Builds the example on the base image that is in the local registry, and moves many of it.

    Returns:
        The result, and the seconds that a build of the app takes if its base image has changed.

    Raises:
        RosmlError: no base image is there, or a build failed.
    """
    app, again = local.example(services, NAMESPACE, say)
    return Bench(services, app, f"{services.registry}/{local.BASE}", say, apps).measure(), again


@dataclass
class Bench:
    """One measurement.

    Attributes:
        services: the local registry.
        app: a real app in it, by its reference. base: its base image.
        say: tells what begins.
        pushed: repositories with the digests that are to be removed.
    """

    services: Services
    app: str
    base: str
    say: Callable[[str], None]
    apps: int = APPS
    pushed: set[tuple[str, str]] = field(default_factory=set)

    def measure(self) -> Result:
        """Makes base images and apps, moves all, and removes everything.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        with (
            Registries(self.services.ca_bundle) as registries,
            local.cleaned(registry := registries(self.services.registry), self.pushed, self.say),
        ):
            with Transfer(registries) as transfer:
                self.say(f"{BASES} base images and {self.apps} apps of {KINDS} kinds")
                core, app = (next(iter(transfer.platforms(name).values())) for name in (self.base, self.app))
                bases = [self._base(transfer, registry, core, number, "yesterday") for number in range(BASES)]
                onto = [next(iter(transfer.platforms(name).values())) for name in bases]
                names = [f"{NAMESPACE}/app-{number % KINDS}-{number // KINDS}" for number in range(self.apps)]
                side_by_side(
                    lambda item: self._app(
                        transfer, registry, app, onto[item[0] % BASES], bases[item[0] % BASES], item[1]
                    ),
                    [*enumerate(names)],
                    title="make",
                )
                for number in range(BASES):
                    self._base(transfer, registry, core, number, "tonight")
            self.say("move one")
            one = self._moved(registries, names[:1])
            self.say("link one")
            linked = self._linked(registries, names[0], app.platform)
            self.say("move all")
            states, seconds, uploaded, requests = self._moved(registries, names[1:])
            return Result(states, seconds, uploaded, requests, one[1:], linked)

    def _moved(self, registries: Registries, names: list[str]) -> tuple[dict[str, int], float, int, int]:
        counting, started = Counting(), time.monotonic()

        def nothing(*_: Any) -> None:
            raise RosmlError("the facts should decide")

        with counting.on(), Rebaser(self.services, registries) as rebaser:
            entries = [Entry(app=f"{self.services.registry}/{name}:latest") for name in names]
            moves = Fleet(rebaser, now(), nothing, with_sbom=False).run(entries)
        seconds, states = time.monotonic() - started, dict[str, int]()
        for item in moves:
            states[item.state] = states.get(item.state, 0) + 1
            if item.rebased:
                self.pushed.update(
                    (references.parse(item.app).repository, name) for name in item.rebased.manifests.values()
                )
        return states, seconds, sum(item.rebased.uploaded for item in moves if item.rebased), counting.requests

    def _linked(self, registries: Registries, name: str, platform: str) -> float:
        """Seconds in which the builder links a moved app."""
        registry = registries(self.services.registry)
        new = f"{registry.host}/{name}@{registry.head(name, 'latest')}"
        started = time.monotonic()
        Trial(self.services, f"{NAMESPACE}/linked").link({platform: Pair(new, self.app)})
        return time.monotonic() - started

    def _base(self, transfer: Transfer, registry: Registry, core: Source, number: int, night: str) -> str:
        """Puts a base image with one more layer, under a tag that moves."""
        stream = io.BytesIO()
        with tarfile.open(fileobj=stream, mode="w") as archive:
            text = f"{night} {number}\n".encode()
            entry = tarfile.TarInfo(f"etc/rosml-bench-{number}")
            entry.size = len(text)
            archive.addfile(entry, io.BytesIO(text))
        layer = gzip.compress(stream.getvalue(), mtime=0)
        config = copy.deepcopy(core.config.content)
        config["rootfs"]["diff_ids"].append(oci.digest_of(stream.getvalue()))
        config["history"].append({"created": config["created"], "created_by": f"COPY {night} /"})
        repository = f"{NAMESPACE}/ros"
        registry.put_blob(repository, layer)
        layers = [*core.layers, oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", layer)]
        data = oci.encoded(config)
        manifest = oci.encoded(
            {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, data), "layers": layers}
        )
        kept_layers = tuple((item, core) for item in core.layers)
        transfer.push(Joined(core.platform, data, manifest, {}, kept_layers), registry.host, repository, Transferred())
        registry.put_manifest(repository, f"base-{number}", manifest)
        self.pushed.add((repository, oci.digest_of(manifest)))
        for artifact, media_type in LISTS:
            self._attached(registry, core, repository, manifest, artifact, media_type)
        return f"{registry.host}/{repository}:base-{number}"

    def _app(
        self,
        transfer: Transfer,
        registry: Registry,
        app: Source,
        base: Source,
        base_name: str,
        repository: str,
    ) -> None:
        """Puts an app of a kind on a base image."""
        labels = {TITLE: repository, BASE_NAME: base_name, BASE_DIGEST: base.digest}
        joined = image.moved(app, base, labels)
        transfer.push(joined, registry.host, repository, Transferred())
        registry.put_manifest(repository, "latest", joined.manifest)
        self.pushed.add((repository, joined.digest))
        for artifact, media_type in LISTS[1:]:
            self._attached(registry, app, repository, joined.manifest, artifact, media_type)

    def _attached(
        self, registry: Registry, source: Source, repository: str, manifest: bytes, artifact: str, media_type: str
    ) -> None:
        """Attaches what a real image has."""
        [entry, *_] = registry.referrers(source.repository, source.digest, artifact)
        attached = registry.manifest(source.repository, entry["digest"])
        if attached is None:
            raise RosmlError(f"{source.name} has lost what was attached to it", "build it again")
        data = registry.part(source.repository, attached.layers[0])
        subject = oci.descriptor(oci.IMAGE, manifest)
        self.pushed.add((repository, registry.attach(repository, subject, artifact, data, media_type)))
