"""What the unit tests share: a small matrix with every axis, and ways to change it."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis.configuration import set_hypothesis_home_dir

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
set_hypothesis_home_dir(ROOT / ".state/cache/hypothesis")
os.environ["XDG_CACHE_HOME"] = str(ROOT / ".state/cache/user")  # no test writes into the user's own

from tests.fork import FORK  # noqa: E402

if FORK:  # unit tests are about rosml, whose matrix a fork with a set still has
    os.environ["ROSML_MATRIX"] = "matrix.yaml"

from fakes import projects  # noqa: E402
from fakes.http_registry import LocalRegistry, local_registry  # noqa: E402
from rosml.images.image_set import load, locked  # noqa: E402
from rosml.images.image_set import model as sets  # noqa: E402
from rosml.images.matrix import (  # noqa: E402
    names,
    source,
)

SMALL = f"""\
version: 1
registry: localhost:5000
source: https://example.org/images
default: {{targets: [alpha-core-torch-cu1], assembler: ubuntu-24.04, group: [alpha-core]}}
architectures:
  amd64: {{platform: linux/amd64, wheels: x86_64-manylinux_2_28, runner: amd}}
  arm64: {{platform: linux/arm64, wheels: aarch64-manylinux_2_28, runner: arm}}
operating_systems:
  ubuntu-24.04:
    image: docker.io/library/ubuntu:24.04
    digest: sha256:{"1" * 64}
    python: "3.12"
    numpy: "<2"
    architectures: [amd64, arm64]
    tools: colcon
    codename: noble
    apt_sources: {{ros2: {{version: 2.0.0, digest: sha256:{"3" * 64}}}}}
  ubuntu-26.04:
    image: docker.io/library/ubuntu:26.04
    digest: sha256:{"2" * 64}
    python: "3.14"
    numpy: ">=2.2,<2.3"
    architectures: [amd64, arm64]
    tools: colcon
    codename: resolute
components:
  core: {{metapackage: ros-core}}
  base: {{metapackage: ros-base, builds_on: core}}
  robot: {{builds_on: base}}
  desktop: {{builds_on: robot}}
frameworks:
  none: {{repository: ros}}
  cuda: {{repository: ros-cuda, parts: [cuda], accelerators: [cuda]}}
  torch: {{repository: ros-torch, parts: [cuda, common, torch]}}
  ml: {{repository: ros-ml, parts: [cuda, common, torch, tensorflow-cc, tensorflow]}}
releases:
  torch:
    2.10.0: {{python: ["3.12", "3.14"], wheels: {{cu1: [amd64], cpu: [arm64]}}}}
  tensorflow:
    2.20.0: {{python: ["3.12"], wheels: {{cu1: [amd64], cpu: [amd64, arm64]}}}}
stacks:
  cu1: {{accelerator: cuda, cuda: 12.8.90, cudnn: 9.10.2.21, releases: {{torch: 2.10.0, tensorflow: 2.20.0}}}}
  cpu:
    accelerator: cpu
    releases:
      {{torch: 2.10.0, tensorflow: 2.20.0}}
    packages: {{tensorflow: {{amd64: tensorflow-cpu, arm64: tensorflow}}}}
distributions:
  alpha:
    os: ubuntu-24.04
    ros: 2
    packages: ros-{{ros_distro}}-{{metapackage}}
    components: [core, base, desktop]
    default_stack: cu1
    eol: 2029-05-31
    lts: true
    apt: {{channel: live}}
  omega:
    os: ubuntu-26.04
    ros: 2
    packages: ros-{{ros_distro}}-{{metapackage}}
    components: [core, base]
    default_stack: cpu
    apt: {{channel: snapshot, date: 2026-11-01}}
disk:
  os: {{unpacked: 100, compressed: 10}}
  components:
    core: {{unpacked: 20, compressed: 2}}
    base: {{unpacked: 20, compressed: 2}}
    robot: {{unpacked: 20, compressed: 2}}
    desktop: {{unpacked: 20, compressed: 2}}
  parts:
    cu1:
      cuda: {{unpacked: 1000, compressed: 100}}
      common: {{unpacked: 300, compressed: 30}}
      torch: {{unpacked: 2000, compressed: 200}}
      tensorflow-cc: {{unpacked: 1000, compressed: 100}}
      tensorflow: {{unpacked: 500, compressed: 50}}
    cpu:
      common: {{unpacked: 300, compressed: 30}}
      torch: {{unpacked: 500, compressed: 50}}
      tensorflow-cc: {{unpacked: 400, compressed: 40}}
      tensorflow: {{unpacked: 100, compressed: 10}}
rates: {{packages: 10, parts: 100, test: 5, carried: 1}}
ros_archive:
  live: http://ros.test/{{generation}}/ubuntu
  snapshot: http://snapshots.ros.test/{{ros_distro}}/{{day}}/ubuntu
  apt_source: https://git.test/{{version}}/{{generation}}.{{codename}}.deb
parts:
  - {{name: cuda, title: CUDA, accelerator: cuda, any_python: true, versions: [cuda, cudnn], takes: [nvidia-*]}}
  - {{name: common, needs: [cuda], shared: true, tested: false, slot: 1}}
  - {{name: torch, title: PyTorch, release: torch, needs: [common], slot: 2, compiled: true}}
  - {{name: tensorflow-cc, release: tensorflow, any_python: true, needs: [tensorflow], repeats: [tensorflow, tensorflow-cpu, tensorflow-cpu-aws], tested: false}}
  - {{name: tensorflow, title: TensorFlow, short: tf, release: tensorflow, needs: [common, tensorflow-cc], slot: 3}}
"""

SMALLER = SMALL.replace("components: [core, base, desktop]", "components: [core, base]")
"""The small matrix with fewer images, for tests that publish all of them."""

PINS = "".join(
    f"{package} \\\n    --hash=sha256:{'0' * 64}\n"
    for package in ("torch==2.10.0", "tensorflow==2.20.0", "tensorflow-cpu==2.20.0")
)

WHEELS = SMALL.replace(
    "\ndisk:\n",
    """
  sigma:
    os: ubuntu-24.04
    ros: 2
    ros_distro: alpha
    wheels: ["ros-alpha-rclpy[fastrtps]==7.1.6", ros-std-msgs==5.3.6]
    tools: colcon python3-numpy
    architectures: [amd64]
    components: [core]
    default_stack: cu1
    eol: 2040-01-01
    lts: true
    experimental: true
disk:
""",
)
"""The small matrix and a distribution that comes from wheels, for fewer architectures than its operating system."""

Parse = Callable[[str], sets.ImageSet]


def parse(text: str) -> sets.ImageSet:
    return load.image_set(source.parse(text.encode()))


def write_locks(root: Path, image_set: sets.ImageSet) -> None:
    """Every lock of a catalogue but those of environments, as far as it is looked at without a build."""
    for part in image_set.parts_of_stacks:
        for architecture, lock in zip(part.architectures, part.locks, strict=True):
            head = names.lock_head(part.stack, architecture, part.python, part.kind)
            (root / lock).parent.mkdir(parents=True, exist_ok=True)
            (root / lock).write_text(f"{head}\n{PINS}")
    for item in image_set.wheels:
        names_alone = [re.sub(r"\[.*\]", "", pin) for pin in item.requirements]
        pins = "".join(f"{pin} \\\n    --hash=sha256:{'0' * 64}\n" for pin in names_alone)
        for architecture, lock in zip(item.architectures, item.locks, strict=True):
            (root / lock).parent.mkdir(parents=True, exist_ok=True)
            (root / lock).write_text(f"{names.wheels_head(item.distribution, architecture, item.python)}\n{pins}")


def changed(place: str, replacement: str, text: str = SMALL) -> str:
    assert text.count(place) == 1, f"{text.count(place)} times in the matrix: {place!r}"
    return text.replace(place, replacement)


@pytest.fixture
def server() -> Iterator[LocalRegistry]:
    with local_registry() as server:
        yield server


@pytest.fixture(scope="session")
def small() -> sets.ImageSet:
    return parse(SMALL)


@pytest.fixture(scope="session")
def real() -> sets.ImageSet:
    return load.load(ROOT / "matrix.yaml")


@pytest.fixture(scope="session")
def registry() -> Iterator[str]:
    with local_registry() as server:
        yield server.address


@pytest.fixture(scope="session")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All that images are built from, copied once; nobody writes into it."""
    return projects.copy(tmp_path_factory.mktemp("sources") / "project")


@pytest.fixture
def project(tmp_path: Path, sources: Path) -> Path:
    shutil.copytree(sources, tmp_path / "project")
    return tmp_path / "project"


@pytest.fixture
def image_set(project: Path) -> sets.ImageSet:
    return smaller(project)


def smaller(project: Path, text: str = SMALLER) -> sets.ImageSet:
    image_set = parse(text)
    write_locks(project, image_set)
    return locked.with_locks(image_set, locked.current_locks(image_set, project))


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    return projects.copy_with_commands(tmp_path / "project", SMALL)
