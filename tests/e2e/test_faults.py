"""What goes wrong: a clear message, a non-zero exit code, no tag moved, and the next call carries on."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests import regctl
from tests.e2e.calls import HANGS, NAMESPACE, publish, wait_until
from tests.e2e.images import NATIVE, Publish, Published

TARGET = "ros1-bookworm-core"


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


def other_python(matrix: Path) -> None:
    """Has the matrix promise a Python that the image does not have: the label is right, the content is not."""
    text = matrix.read_text().replace('python: "3.11"', 'python: "3.12"', 1)
    # Systems with one Python agree on what parts depend on: bookworm provides what Ubuntu 24.04 does.
    provides = text[text.index("provides:", text.index("  ubuntu-24.04:")) :].splitlines()[0]
    matrix.write_text(text.replace(text[text.index("provides: {") :].splitlines()[0], provides, 1))


def stay(image: Published) -> None:
    """Asserts that no tag of an image moved."""
    for tag in image.result["tags"]:
        assert regctl.digest(image.services, tag) == image.result["digest"]


def test_each_thing_that_is_broken_in_an_image_is_named_and_no_tag_moves(published: Publish, checkout: Path) -> None:
    """All of them at once, in one copy of the image."""
    before = published(TARGET)
    other_python(checkout / "matrix.yaml")
    (checkout / "tests/structure/break.sh").write_text("\n".join(["set -e", *BROKEN, ""]))
    dockerfile = checkout / "Dockerfile"
    stage = "FROM image AS test-run\n"
    text = dockerfile.read_text()
    assert text.count(stage) == 1
    step = "RUN --mount=type=bind,source=tests/structure,target=/run/tests bash /run/tests/break.sh\n"
    dockerfile.write_text(text.replace(stage, stage + step))
    outcome = publish(TARGET, root=checkout)
    assert outcome.code == 1 and "gets no tag" in outcome.err
    failures = ("Python 3.11, expected 3.12", *BROKEN.values())
    assert [words for words in failures if words not in outcome.err] == [], outcome.err
    stay(before)


QUICK_TEST = """\
schemaVersion: 2.0.0
commandTests:
  - {{name: a quick one, command: /bin/true, exitCode: {expected}}}
"""


def test_a_failure_is_not_taken_from_the_cache(published: Publish, checkout: Path) -> None:
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


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_in_the_middle(published: Publish, checkout: Path, number: signal.Signals) -> None:
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
    wait_until(lambda: log.exists() and "$" in log.read_text(), HANGS, log.exists, process)
    time.sleep(3)
    assert process.poll() is None, "it ended before it was interrupted"
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "no tag points at what is not finished" in err
    assert "Traceback" not in err
    stay(before)
    assert publish(TARGET).code == 0


def test_the_root_of_a_build_step_is_the_builders_alone(published: Publish, services: Services, tmp_path: Path) -> None:
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
