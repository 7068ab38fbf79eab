"""How publishing grows with the number of tags: images that are joined in the registry, beside the usual way, where every
tag is built. And what a run over the whole matrix takes where nothing changed.

Each tag stands on a ROS image of its own, as if so many components had changed overnight: a config of its own over layers
that are there. What a build of the usual way takes was measured once, by `second_image`; so many tags take so many times that.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from bench import idle_run, scan
from bench.here import Here
from bench.idle_run import IdleRun
from bench.scan import Scan
from bench.second_image import NAMESPACE, Comparison
from bench.temporary import Temporary
from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.base.terminal import console, show, table
from rosml.base.units import duration, size
from rosml.images.builds.maker import Maker
from rosml.images.join import file_lists
from rosml.images.join.joiner import Joiner
from rosml.images.publish import plan
from rosml.images.publish.pipeline import Pipeline
from rosml.registry import oci, references
from rosml.registry.client import Registry

TAGS = (10, 20, 40)


@dataclass(frozen=True)
class Growth:
    """Publishing so many tags after a change of ROS: seconds and new bytes in the registry of both ways.

    The usual way's are those of one tag, times the number of tags.
    """

    tags: int
    seconds: float
    uploaded: int
    usual_seconds: float
    usual_bytes: int

    def to_json(self) -> dict[str, float | int]:
        """For `--json`."""
        return dict(vars(self))


@dataclass(frozen=True)
class Grown:
    """All sizes, a second run over the whole matrix, and a scan of it; None if there is no scanner."""

    rows: tuple[Growth, ...]
    again: IdleRun
    scan: Scan | None

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        found = {"rows": [row.to_json() for row in self.rows], "again": self.again.to_json()}
        return found | ({"scan": self.scan.to_json()} if self.scan else {})


def measure(
    here: Here,
    target: str,
    usual: Comparison,
    sizes: Sequence[int] = TAGS,
    maker: Maker | None = None,
) -> Grown:
    """Joins images of a target's parts and removes them again.

    Args:
        here: with the bench's own namespace. target: an image with a framework. usual: what one build of it took.
        sizes: numbers of tags. maker: builds the parts; with this checkout's builder if None.

    Raises:
        RosmlError: a build failed, or the registry does not answer.
    """
    services, image_set = here.services, here.image_set
    client = Registry(services.registry, ca_bundle=services.ca_bundle)
    date = now()
    place = f"{NAMESPACE}/night-{secrets.token_hex(4)}"
    again = idle_run.measure(services, image_set, place, date, here.say)

    found = plan.survey(services, image_set, client, NAMESPACE, [target], date=date)
    run = Pipeline(found, client, services.registry, NAMESPACE, here.say, maker=maker)
    here.say(f"the parts of {target}, by digest")
    run.build()
    if run.failed:
        raise RosmlError(f"a part of {target} cannot be built", "see the log that the message above names")
    image, architecture = image_set.image(target), here.architecture
    needs = found.by_key[image.target, architecture].needs
    scanned = [run.scanned_part(target, architecture) for target in needs]
    night = scan.measure(here, run.shelf, scanned)
    ros, *parts = (references.Reference(services.registry, part.repository, part.digest) for part in scanned)
    rows = []
    for number in sizes:
        here.say(f"{number} tags, joined in the registry")
        with Temporary(services.registry, ca_bundle=services.ca_bundle) as temporary:
            made = _Made(temporary, secrets.token_hex(4))
            variants = [made.ros(ros, index) for index in range(number)]
            with Joiner(lambda _: temporary) as joiner:
                start = time.monotonic()
                results = [
                    joiner.join(str(variant), [str(item) for item in parts], made.target(ros.host, index))
                    for index, variant in enumerate(variants)
                ]
                seconds = time.monotonic() - start
        uploaded = sum(result.uploaded for result in results)
        side = usual.usual
        rows.append(
            Growth(number, seconds, uploaded, number * side.build_and_push_seconds, number * side.registry_new_bytes)
        )
    return Grown(tuple(rows), again, night)


@dataclass
class _Made:
    """Images that are removed again by their client. `run` tells them from all others."""

    client: Temporary
    run: str

    def ros(self, ros: references.Reference, index: int) -> references.Reference:
        """A ROS image with a config of its own over the layers of another, and with that one's list of files."""
        found = self.client.manifest(ros.repository, ros.reference)
        if found is None:
            raise RosmlError(f"{ros} is not there any more", "run it again")
        config = self.client.json_blob(ros.repository, found.content["config"]["digest"])
        config["config"] = {**config["config"], "Env": [*config["config"]["Env"], f"ROSML_BENCH={self.run}-{index}"]}
        data = oci.encoded(config)
        self.client.put_blob(ros.repository, data)
        content = oci.encoded({**found.content, "config": oci.descriptor(oci.CONFIG, data)})
        digest = self.client.put_manifest(ros.repository, "", content, oci.IMAGE)
        variant = ros._replace(reference=digest)
        manifest = self.client.manifest(ros.repository, digest)
        for entry in self.client.referrers(ros.repository, ros.reference, file_lists.ARTIFACT)[:1]:
            listed = self.client.manifest(ros.repository, entry["digest"])
            if listed and manifest:
                names = self.client.blob(ros.repository, listed.content["layers"][0]["digest"])
                kind = file_lists.ARTIFACT, names, file_lists.MEDIA_TYPE
                self.client.attach(ros.repository, manifest.descriptor, *kind)
        return variant

    def target(self, host: str, index: int) -> str:
        """The tag of a joined image."""
        return f"{host}/{NAMESPACE}/growth-{self.run}:{index}"


def cells(row: Growth) -> tuple[str, ...]:
    """A row of both ways for people: tags, time and bytes of ours, time and bytes of the usual way."""
    usual = (duration(row.usual_seconds), size(row.usual_bytes))
    return (str(row.tags), duration(row.seconds), size(row.uploaded), *usual)


def print_table(found: Grown, target: str) -> None:
    """Prints both ways side by side."""
    numbers = ("joined", "new in registry", "every tag built", "new in registry", "a tag")
    made = table(f"tags of {target}", *numbers, right=numbers)
    for row in found.rows:
        made.add_row(*cells(row), f"{row.seconds / row.tags:.2f} s")
    show(made)
    out = console()
    out.print("every tag built: one build was measured, above, and multiplied", style="dim")
    out.print(f"{idle_run.HEADING}: {idle_run.text(found.again)}", style="dim")
    if found.scan:
        out.print(f"{scan.HEADING}: {scan.text(found.scan)}", style="dim")
