"""What the simulation of a night takes from elsewhere: measured times and sizes, limits, and assumptions. A test finds the words of each source
in its file, and another one counts the requests again."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Fact:
    """A number that the simulation uses.

    Attributes:
        value: in seconds, bytes or MB, as the name says.
        source: a file of this checkout, an address, or `assumed`.
        words: how the source says it, or why it is assumed.
    """

    value: float
    source: str
    words: str


@dataclass(frozen=True)
class Step:
    """What a step of one item asks of a registry without the referrers API, such as ghcr.io: reads, writes, and bytes sent."""

    reads: int
    writes: int
    sent: int = 0


FACTS = {
    "join seconds": Fact(0.4, "docs/publishing/how-it-works.md", "12 joins of 0.1 to 0.4 s"),
    "pip seconds": Fact(208, "docs/parts/sizes.md", "second image: build and push | 0.6 s | 3 min 28 s"),
    "pip bytes": Fact(3.16e9, "docs/parts/sizes.md", "second image: new in the registry | 9.3 kB | 3.16 GB"),
    "pip unpacked MB": Fact(4250 + 110 + 2730, "matrix.yaml", "cuda: {unpacked: 4250, compressed: 2200}"),
    "pip compressed MB": Fact(2200 + 20 + 812, "matrix.yaml", "torch: {unpacked: 2730, compressed: 812}"),
    "rebase seconds": Fact(0.13, "docs/rebase.md", "129 s, 0.13 s for each"),
    "rebase bytes": Fact(13.9e3, "docs/rebase.md", "sent for each app, without an SBOM | 13.9 kB"),
    "containerize seconds": Fact(94, "docs/rebase.md", "of the same app on a new base image took 94 s"),
    "app bytes": Fact(66e3, "docs/containerize/docker-ros.md", "everything to build and test | 66 kB"),
    "SBOM bytes": Fact(840e3, "docs/publishing/scan.md", "(525 Debian packages) has 840 kB"),
    "seconds of a request": Fact(0.1, "src/rosml/base/side_by_side.py", "one far away in a tenth of a second"),
    "writes a minute": Fact(2000, "https://github.com/chainguard-images/images/issues/173", "allowed: 2000/minute"),
    "reads a minute": Fact(44_000, "https://github.com/falcosecurity/plugins/issues/1069", "allowed: 44000/minute"),
    "tags on a page": Fact(100, "src/rosml/registry/transport.py", "Registries give 100 to 1,000 tags on each page"),
    "minutes of a shard": Fact(300, ".github/workflows/nightly.yml", "--minutes 300"),
    "minutes of promote": Fact(120, ".github/workflows/nightly.yml", "timeout-minutes: 120"),
    "minutes of rebase": Fact(60, "docs/rebase.md", "timeout-minutes: 60"),
    "burst in minutes": Fact(1, "assumed", "a registry lets nobody save up requests for longer than its limit says"),
    "hours of pulls": Fact(8, "assumed", "pulls come while people and CI work; their rate rises to a peak and falls"),
    "requests of a pull": Fact(4, "assumed", "index, manifest, config and token; the layers that the client lacks come on top"),
}  # fmt: skip

STEPS = {
    "build": Step(23, 15, 7_500),
    "join": Step(34, 15, 11_300),
    "test": Step(4, 4, 4_400),
    "index": Step(6, 5, 2_500),
    "promote": Step(19, 8, 9_300),
    "rebase": Step(38, 17),
    "survey": Step(2, 0),
    "push": Step(8, 5),
    "fetch": Step(3, 0),
}
"""Requests by step: of an image or part on an architecture, of an index, of an app, of a record that is read. `push` and `fetch`
are a builder's, and assumed: a HEAD for each of 8 layers, POST and PUT for a new layer and the config, and the manifest; for a part that is
fetched its manifest, its config and its layer."""


def fact(name: str) -> float:
    """The value of a fact."""
    return FACTS[name].value
