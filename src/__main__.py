"""`python src`: the command `rosml` of a checkout, where nothing is installed and whatever the working folder is."""

import os.path
import sys

# As in many containers: each call would compile all of rosml again, and take three times as long.
if sys.dont_write_bytecode:
    state = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), ".state")
    if os.path.isdir(state):
        sys.dont_write_bytecode = False
        sys.pycache_prefix = os.path.join(state, "bytecode")

# isort: split

from rosml.__main__ import run

if __name__ == "__main__":
    sys.exit(run())
