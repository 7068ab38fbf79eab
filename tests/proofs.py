"""What only `make test-all` runs: tests that are marked `full(proof=NAME)`, and those that a proof names itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Proof:
    """One or several tests that take too long for every change."""

    minutes: float  # on two cores
    needs: Sequence[str] = ()  # commands of scripts/bootstrap.py that set up for them
    tests: Sequence[str] = ()  # what pytest runs; the tests with the proof's mark if empty
    environment: Mapping[str, str] = field(default_factory=dict)


PROOFS = {
    # Every component of every distribution, from signed apt repositories; an image from an archive of somebody's own.
    "apt": Proof(6),
    # Images for arm64 under emulation; a part for arm64 without it.
    "arm64": Proof(45, needs=("emulate",)),
    # The runtime contract of an image with TensorFlow, whoever starts it, with a current Docker.
    "contract": Proof(18, needs=("engine",)),
    # Images with CUDA, PyTorch and TensorFlow: their layers, and programs in Python and C++ that use all of it.
    "cuda": Proof(40),
    # Windows of desktop images: rviz by X11, and Qt by Wayland.
    "desktop": Proof(25),
    # A user without root who has Docker, and nothing else: the first image, and what people do with it.
    "docker": Proof(8, needs=("engine",)),
    # rosml run, attach, dev and what they export with podman, with root too.
    "engines": Proof(11),
    # Apps with an environment, and a rebase of one; messages of ROS 2 beside both numpys.
    "environments": Proof(12),
    # What users install next by pip and uv leaves PyTorch, TensorFlow, CUDA and ROS as they are.
    "everyday": Proof(20),
    # Object detection on ROS 1 and the CPU: an add-on, messages, nodes in Python and C++, and their tests. A policy in another process.
    "examples": Proof(10),
    # A fork made from the documentation, step by step, passes its own unit tests.
    "fork": Proof(8),
    # C++ headers of PyTorch and TensorFlow compile, alone and together; so does a kernel with NVIDIA's compiler.
    "includes": Proof(45),
    # What people install is as new as the packages allow that keep their version in an image.
    "installs": Proof(30),
    # Publishing runs killed thirty times, and containerize killed twenty times, lose and repeat nothing.
    "kills": Proof(14),
    # A night whose jobs set themselves up, for two architectures; a night in which much fails, and the next one.
    "night": Proof(9, needs=("emulate",)),
    # A thousand examples for each property, 10,000 commands for rosml run, 5,000 damaged documents for each parser.
    "properties": Proof(
        15,
        tests=(
            "tests/unit/images/matrix/test_matrix.py",
            "tests/unit/images/publish/test_plan.py",
            "tests/unit/run/test_run_words.py",
            "tests/unit/cli/test_parsers.py",
        ),
        environment={"HYPOTHESIS_PROFILE": "thorough"},
    ),
    # A build without any cache, and one in another folder, give the same layers.
    "rebuild": Proof(12),
    # The base layer on Debian's relatives of Ubuntu 20.04 and 26.04.
    "relatives": Proof(8),
    # The real trivy finds what it must.
    "scanner": Proof(18, needs=("scanner",)),
    # The real cosign signs with a key, once, before tags move.
    "signer": Proof(18, needs=("signer",)),
    # Each stack's frameworks on Debian bookworm, trixie and sid, with Python 3.11, 3.13 and 3.14: all tests of these images.
    "systems": Proof(100),
    # ROS 2 from Python wheels: built, started, and an app built on it.
    "wheels": Proof(8),
}
"""By name, for `make test-all PROOF=NAME`."""
