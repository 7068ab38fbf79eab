"""The folders of examples/, built as they stand there: a test gives another base image, and replaces nothing else."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from tests.e2e.conftest import NAMESPACE, run
from tests.e2e.images import Publish, build, ca_secret

EXAMPLES = ROOT / "examples"
HERE = Path(__file__).parent / "examples_base"

Base = Callable[[str], str]


def base(services: Services, reference: str, name: str) -> str:
    """An image with what the network has for others: lists for rosdep, the certificates of this machine, and `ros2 run` if
    ROS 2 is from wheels, which lack the command."""
    made = f"{services.registry}/{NAMESPACE}/examples/base:{name}"
    options = ["--output", f"type=image,name={made},push=true", "--build-arg", f"BASE_IMAGE={reference}"]
    options += ["--build-context", f"components={ROOT / 'components'}", *ca_secret(services)]
    done = run(*services.buildx, "build", "--progress", "plain", *options, str(HERE), env=services.environment())
    assert done.code == 0, done.err
    return made


def example(services: Services, name: str, image: str, folder: Path, *checks: str) -> str:
    """Builds the Dockerfile of an example on an image, then steps of its own; returns what the builder said."""
    place = folder / name
    shutil.copytree(EXAMPLES / name, place)
    with (place / "Dockerfile").open("a") as file:
        file.write("".join(f"RUN {check}\n" for check in checks))
    said = build(services, place, "--build-arg", f"BASE_IMAGE={image}")
    assert re.search(r"Summary: [1-9]\d* tests?, 0 errors, 0 failures", said), said
    return said


def command(name: str) -> str:
    """What the image of an example starts."""
    [words] = re.findall(r"^CMD (\[.*\])$", (EXAMPLES / name / "Dockerfile").read_text(), re.MULTILINE)
    return shlex.join(json.loads(words))


def says(words: str, what: str) -> str:
    """A step that starts a command, waits until it says something, and stops it as `docker stop` does."""
    script = (
        f"/tini -s -- /entrypoint.sh {what} >/said 2>&1 & for try in {{1..300}}; do "
        f"if grep -q {shlex.quote(words)} /said; then break; fi; sleep 0.1; done; "
        f"cat /said; kill $!; wait; grep {shlex.quote(words)} /said"
    )
    return f"bash -c {shlex.quote(script)}"


@pytest.mark.full(proof="cuda")
def test_torch_node(services: Services, published: Publish, tmp_path: Path) -> None:
    image = base(services, published("jazzy-wheels-core-torch-cu128").reference, "torch-node")
    said = example(services, "torch-node", image, tmp_path, says("PyTorch .* on cpu", command("torch-node")))
    assert re.search(r"PyTorch [\d.]+\S* on cpu", said)
