"""The command that is asked for a base image where Docker Hub does not answer: see src/rosml/images/builds/base_images.py."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:1] = [str(ROOT / "src"), str(ROOT / "tools")]

from offline.official import missing  # noqa: E402


def made(image: str, architecture: str, python: str) -> dict[str, str]:
    """An image that was made here.

    Raises:
        RosmlError: it cannot be.
    """
    from offline import assembler, debian
    from rosml.machine.services import Services

    services = Services.load(ROOT)
    return assembler.ensure(services, image, python) if python else debian.ensure(services, image, architecture)


def main() -> int:
    """Prints the answer; gives the exit code."""
    parser = argparse.ArgumentParser(prog="tools/offline", description="Gives a base image that the builder can pull.")
    parser.add_argument("image", help="the official one, with its digest")
    parser.add_argument("--architecture", default="", help="amd64 or arm64; the machine's own if nothing is said")
    parser.add_argument("--assembler", default="", metavar="PYTHON", help="something to build parts for a Python on")
    parser.add_argument("--check", action="store_true", help="only say why it cannot be had")
    said = parser.parse_args()
    image: str = said.image.partition("@")[0]
    if said.check:  # asked for every system of a matrix: without the imports that making one needs
        answer = {"missing": missing(image)}
    elif not image.startswith("docker.io/"):  # another registry, which is reached for all that is known
        answer = {"reference": said.image, "python": said.assembler}
    else:
        from rosml.base.errors import RosmlError

        try:
            answer = made(image, said.architecture, said.assembler)
        except RosmlError as error:
            answer = {"error": error.message, "remedy": error.remedy}
        except KeyboardInterrupt:  # whoever called says so
            return 130
    print(json.dumps(answer))
    return int("error" in answer)


if __name__ == "__main__":
    sys.exit(main())
