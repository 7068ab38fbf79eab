"""The library behind the commands: packages with one noun each and one direction of imports, which `lint-imports` holds.

From the top: cli; publish, catalogue; build, scan; join; records; machine, locks; registry, bake; images; matrix; base. Each
imports from those below it alone. docs/architecture.md walks through them.
"""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
"""The project's root: the folder of `matrix.yaml` and `docker-bake.hcl`."""
