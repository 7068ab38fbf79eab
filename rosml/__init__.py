"""The library behind the commands in `scripts/`: small modules, one noun each.

The way of the data: `source` (YAML with places) -> `model` (structure) -> `references` (names that must exist) ->
`expand` (images and payloads) -> `targets` (what buildx is told of each), `bake`, `listing`, `explain`, `plan` (what people
and tools read). What decides the content of an image is in `inputs`; `difference` compares it with another version's.
None of these touches the network, reads the clock, or depends on the machine.
"""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
"""The project's root: the folder of `matrix.yaml` and `docker-bake.hcl`."""
