"""`python -m bench`."""

import sys

import rosml.base.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

from bench.cli import main
from rosml.cli import command

sys.exit(command.run(main, "interrupted: no tag was made or moved; finished steps are kept"))
