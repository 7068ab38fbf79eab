"""`python src`: the command `rosml` of a checkout, where nothing is installed and whatever the working folder is."""

import sys

from rosml.__main__ import run

if __name__ == "__main__":
    sys.exit(run())
