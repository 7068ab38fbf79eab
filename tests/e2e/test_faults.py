"""What goes wrong: a clear message, a non-zero exit code, no tag moved, and the next call carries on."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from tests import regctl
from tests.e2e.conftest import HANGS, NAMESPACE, Published, publish, run, small_file_system
from tests.e2e.images import NATIVE

TARGET = "ros1-bookworm-core"


def test_a_failing_structure_test_leaves_every_tag(
    published: Callable[[str], Published], services: Services, checkout: Path
) -> None:
    """The matrix promises a Python that the image does not have: the label is right, the content is not."""
    before = published(TARGET)
    matrix = checkout / "matrix.yaml"
    text = matrix.read_text().replace('python: "3.11"', 'python: "3.12"', 1)
    # Systems with one Python agree on what parts depend on: bookworm provides what Ubuntu 24.04 does.
    system = text.index("  ubuntu-24.04:")
    provides = text[text.index("provides:", system) :].splitlines()[0]
    matrix.write_text(text.replace(text[text.index("provides: {") :].splitlines()[0], provides, 1))
    outcome = publish(TARGET, root=checkout)
    assert outcome.code == 1
    assert "gets no tag" in outcome.err
    assert "Python 3.11, expected 3.12" in outcome.err
    for tag in before.result["tags"]:
        assert regctl.digest(services, tag) == before.result["digest"]


BROKEN = {
    "useradd --uid 1000 somebody": "contract: nobody has uid 1000",
    "rm /usr/bin/colcon": "missing: colcon",
    "rm /usr/bin/rosrun": "ros1: rosrun finds and starts a node",
    "groupdel video": "contract: entrypoint becomes the user DOCKER_UID:DOCKER_GID",  # judged by what user.sh prints
    "mkdir -p /var/lib/apt/lists && touch /var/lib/apt/lists/lock": "no package lists are left",
    "echo 0123456789abcdef >/etc/machine-id": "contract: no identity of a machine is left",
    "install --mode=4755 /bin/true /opt/tool": "4755 /opt/tool",
    "rm /etc/ros/rosdep/sources.list.d/20-default.list": "rosdep is not initialised",
    "sed -i '/^Package: ros-core$/,/^$/s/ok installed/ok unpacked/' /var/lib/dpkg/status": "ros-core: unpacked",
    # pip_install.py: numpy is no longer kept to its range
    "sed -i '/constraint/d' /etc/pip.conf": "AssertionError: 9999.0",
    "echo index-url = http://index.example.org >>/etc/pip.conf": "install.index-url='http://index.example.org'",
}
"""What breaks a whole image, and what names it. Checks of single files: tests/unit/components/test_checks.py."""


def test_each_thing_that_is_broken_in_an_image_is_named(
    published: Callable[[str], Published], services: Services, checkout: Path
) -> None:
    """All of them at once, in one copy of the image."""
    before = published(TARGET)
    (checkout / "tests/structure/break.sh").write_text("\n".join(["set -e", *BROKEN, ""]))
    dockerfile = checkout / "Dockerfile"
    stage = "FROM image AS test-run\n"
    text = dockerfile.read_text()
    assert text.count(stage) == 1
    step = "RUN --mount=type=bind,source=tests/structure,target=/run/tests bash /run/tests/break.sh\n"
    dockerfile.write_text(text.replace(stage, stage + step))
    outcome = publish(TARGET, root=checkout)
    assert outcome.code == 1
    assert [words for words in BROKEN.values() if words not in outcome.err] == [], outcome.err
    for tag in before.result["tags"]:
        assert regctl.digest(services, tag) == before.result["digest"]


QUICK_TEST = """\
schemaVersion: 2.0.0
commandTests:
  - {{name: a quick one, command: /bin/true, exitCode: {expected}}}
"""


def test_a_failure_is_not_taken_from_the_cache(published: Callable[[str], Published], checkout: Path) -> None:
    """A structure test that failed runs again: what made it fail may be gone."""
    published(TARGET)
    for file in (checkout / "tests" / "structure").glob("*.yaml"):
        file.write_text(QUICK_TEST.format(expected=0))
    contract = checkout / "tests" / "structure" / "contract.yaml"
    whole = contract.read_text()
    # No earlier call of this test has it in the builder's cache.
    contract.write_text(f"{QUICK_TEST.format(expected=38)}# {time.time_ns()}\n")
    for _ in range(2):
        outcome = publish(TARGET, root=checkout)
        assert outcome.code == 1
        assert "run.sh /structure-report" in outcome.err, "the tests did not run again"
    contract.write_text(whole)
    assert publish(TARGET, root=checkout).code == 0


def test_a_stale_bake_file_is_found_and_left_alone(published: Callable[[str], Published], checkout: Path) -> None:
    published(TARGET)
    with (checkout / "docker-bake.hcl").open("a") as stream:
        stream.write("# somebody's edit\n")
    generator = str(checkout / "scripts" / "generate_bake.py")
    check = run(sys.executable, generator, "--check", "--output", str(checkout / "docker-bake.hcl"))
    assert check.code == 1
    assert "somebody's edit" in check.out
    stale = (checkout / "docker-bake.hcl").read_text()
    assert publish(TARGET, root=checkout).code == 0
    assert (checkout / "docker-bake.hcl").read_text() == stale
    assert run(sys.executable, generator, "--output", str(checkout / "docker-bake.hcl")).code == 0
    assert run(sys.executable, generator, "--check", "--output", str(checkout / "docker-bake.hcl")).code == 0


@pytest.fixture
def full_disk(checkout: Path, services: Services) -> Iterator[Path]:
    """The checkout with its state on a file system of 50 MB."""
    content = (checkout / ".state" / "services.json").read_text()
    state = checkout / ".state"
    small_file_system(state, "50m", services)
    (state / "services.json").write_text(content)
    (state / "auth").symlink_to(ROOT / ".state/auth")
    yield checkout
    subprocess.run(["umount", str(state)], check=True)


def test_a_disk_without_room(full_disk: Path) -> None:
    outcome = publish("ros1-bookworm-core-torch-cu128", root=full_disk)
    assert outcome.code == 1
    assert "not enough disk space" in outcome.err
    assert "are needed" in outcome.err and "are free" in outcome.err


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_in_the_middle(
    published: Callable[[str], Published], services: Services, checkout: Path, number: signal.Signals
) -> None:
    before = published(TARGET)
    install = checkout / "components" / "ros" / "install.sh"
    install.write_text(install.read_text() + f"sleep 60 # {time.time_ns()}\n")
    process = subprocess.Popen(
        [sys.executable, str(checkout / "src"), "image", TARGET, "--namespace", NAMESPACE],
        cwd=checkout,
        stderr=subprocess.PIPE,
        text=True,
    )
    log = checkout / ".state" / "log" / f"build-{TARGET}-{NATIVE}.log"
    deadline = time.monotonic() + HANGS
    while time.monotonic() < deadline and not (log.exists() and "$" in log.read_text()):
        time.sleep(0.2)
    time.sleep(3)
    assert process.poll() is None, "it ended before it was interrupted"
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "no tag points at what is not finished" in err
    assert "Traceback" not in err
    for tag in before.result["tags"]:
        assert regctl.digest(services, tag) == before.result["digest"]
    assert publish(TARGET).code == 0


def test_the_root_of_a_build_step_is_the_builders_alone(
    published: Callable[[str], Published], services: Services, tmp_path: Path
) -> None:
    """A search or an indexer that walks through the checkout must not hold a build step's root open: unmounting it
    would fail then, and what the builder removes next would be the step's result."""
    image = published(TARGET)
    (tmp_path / "Dockerfile").write_text(
        f"FROM {image.result['reference']}\nRUN echo $(date) is running && sleep 60 # {time.time_ns()}\n"
    )
    arguments = ["build", "--progress", "plain", "--output", "type=cacheonly", str(tmp_path)]
    process = subprocess.Popen(
        [*services.buildx, *arguments], env=services.environment(), stderr=subprocess.PIPE, text=True
    )
    try:
        assert process.stderr
        assert any("is running" in line and "RUN" not in line for line in process.stderr), "the step did not start"
        mounts = Path("/proc/self/mounts").read_text().splitlines()
        assert not [line for line in mounts if f" {services.state / 'buildkit'}/" in line]
    finally:
        process.terminate()
        process.wait(30)
