"""An image to build parts on for a Python that no Debian image has: Debian's image, with a Python of this machine."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from offline import debian, missing
from rosml.base.errors import RosmlError
from rosml.images.matrix.model import ANY_PYTHON
from rosml.machine.services import Services

VERSIONS = "~/.pyenv/versions"
REPLACEMENT = "docker.io/library/debian:bookworm"


def ensure(services: Services, image: str, python: str) -> dict[str, str]:
    """The reference of an image to build parts on, and the release of the Python on it.

    Args:
        image: of the operating system that the parts are for.
        python: such as `3.12`, or ANY_PYTHON.
    """
    if not missing(image):
        return {**debian.ensure(services, image), "python": python}
    replacement = debian.ensure(services, REPLACEMENT)
    version, home = ("", None) if python == ANY_PYTHON else interpreter(python)
    if home is None:
        return {**replacement, "python": ""}
    return {"reference": with_python(services, replacement["reference"], python, home), "python": version}


def interpreter(python: str) -> tuple[str, Path | None]:
    """The newest release of a Python that this machine has beside its own, and its folder."""
    homes = {path.parent.parent for path in Path(VERSIONS).expanduser().glob(f"{python}.*/bin/python{python}")}
    newest = max(homes, key=lambda home: [int(x) for x in home.name.split(".") if x.isdecimal()], default=None)
    return (newest.name, newest) if newest else ("", None)


def with_python(services: Services, reference: str, python: str, home: Path) -> str:
    (services.state / "tmp").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=services.state / "tmp") as folder:
        context = Path(folder)
        shared = [str(file.relative_to(home)) for file in (home / "lib").glob(f"libpython{python}*.so*")]
        for part in (f"bin/python{python}", f"lib/python{python}", *shared):
            (context / part).parent.mkdir(exist_ok=True)
            if (home / part).is_dir():
                ignore = shutil.ignore_patterns("test", "tests", "__pycache__", "site-packages", "config-*", "*.a")
                shutil.copytree(home / part, context / part, ignore=ignore)
            else:
                shutil.copy(home / part, context / part)
        (context / "Dockerfile").write_text(f"FROM {reference}\nCOPY bin /usr/bin\nCOPY lib /usr/lib\n")
        repository = f"{services.registry}/library/assembler"
        command = [*services.buildx, "build", "--builder", services.builder]
        command += ["--metadata-file", str(context / "metadata.json")]
        command += ["--output", f"type=image,name={repository},push=true,push-by-digest=true", str(context)]
        done = subprocess.run(
            command, env=services.environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise RosmlError(f"cannot add Python {python} to {reference}:\n{done.stderr.strip()}", "run 'rosml setup'")
        digest = json.loads((context / "metadata.json").read_text())["containerimage.digest"]
    return f"{repository}@{digest}"
