"""The command for a base image if Docker Hub does not answer; src/rosml/images/builds/base_images.py calls it."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:1] = [str(ROOT / "src"), str(ROOT / "tools")]

from offline import missing  # noqa: E402


def ensure(image: str, architecture: str, python: str) -> dict[str, str]:
    from offline import assembler, debian
    from rosml.machine.services import Services

    services = Services.load(ROOT)
    return assembler.ensure(services, image, python) if python else debian.ensure(services, image, architecture)


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/offline", description="Gives a base image that the builder can pull.")
    parser.add_argument("image", help="the official one, with its digest")
    parser.add_argument("--architecture", default="", help="amd64 or arm64; the machine's own if nothing is said")
    parser.add_argument("--assembler", default="", metavar="PYTHON", help="something to build parts for a Python on")
    parser.add_argument("--check", action="store_true", help="only say why it cannot be had")
    options = parser.parse_args()
    image: str = options.image.partition("@")[0]
    if options.check:  # the call for every system of a matrix, so without the imports for making one
        answer = {"missing": missing(image)}
    elif not image.startswith("docker.io/"):  # another registry may answer
        answer = {"reference": options.image, "python": options.assembler}
    else:
        from rosml.base.errors import RosmlError

        try:
            answer = ensure(image, options.architecture, options.assembler)
        except RosmlError as error:
            answer = {"error": error.message, "remedy": error.remedy}
        except KeyboardInterrupt:  # the caller reports it
            return 130
    print(json.dumps(answer))
    return int("error" in answer)


if __name__ == "__main__":
    sys.exit(main())
