"""`python -m rosml`: the command `rosml`, where nobody installed it; what the scripts of a checkout call."""

import sys

import rosml.base.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

from rosml.cli import main

run = main.run

if __name__ == "__main__":
    sys.exit(run())
