#!/usr/bin/env python3
"""What the image's parts recorded and what the login banner says are the versions that the tag and the labels promise."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

SHARE = Path("/usr/local/share/rosml")

RECORDED = {
    "cuda": r"nvidia-cuda-runtime(-cu\d+)?",
    "cudnn": r"nvidia-cudnn-cu\d+",
    "nccl": r"nvidia-nccl-cu\d+",
}
"""By what names a part records a version of the stack. A release has its own name, or that of its wheel for the CPU or for a CUDA."""

TITLES = {"cuda": "CUDA", "cudnn": "cuDNN", "torch": "PyTorch", "tensorflow": "TensorFlow"}
"""What the banner calls them. NCCL is not in it."""


def pairs(text: str) -> dict[str, str]:
    """The first word of each line, and the rest of it."""
    lines = (line.split(maxsplit=1) for line in text.splitlines())
    return {line[0]: line[1] for line in lines if len(line) == 2}


def same(present: str | None, promised: str | None) -> bool:
    """Whether a version is the promised one: 2.10.0+cpu is 2.10.0, built for another accelerator."""
    return (present and present.split("+")[0]) == promised


def wrong(
    banner: str, recorded: Mapping[str, str], system: Mapping[str, str], promised: Mapping[str, str]
) -> list[str]:
    """Everything that is not as promised.

    Args:
        banner: what it says. recorded: versions by the names of packages. system: what os-release says.
        promised: by name in small letters: EXPECT_TORCH is `torch`.
    """
    rows = pairs(banner)
    problems: list[str] = []

    def check(what: str, well: bool, is_: object, expected: object) -> None:
        if not well:
            problems.append(f"{what}: {is_}, expected {expected}")

    released = {
        name: rf"{name}(-cpu|-gpu|-cu\d+-bindings)?" for name in promised.get("releases", "").split(",") if name
    }
    for name, pattern in {**RECORDED, **released}.items():
        versions = {package: version for package, version in recorded.items() if re.fullmatch(pattern, package)}
        expected = promised.get(name.replace("-", "_"))
        well = all(same(version, expected) for version in versions.values()) and bool(versions) == bool(expected)
        check(f"recorded of {name}", well, versions or "nothing", expected)
        if name in TITLES:
            row = rows.get(TITLES[name])
            check(f"the banner's {TITLES[name]}", same(row, expected), row, expected)
    ros = f"{promised['ros_distro']} (ROS {promised['ros']})"
    check("the banner's ROS", rows.get("ROS") == ros, rows.get("ROS"), ros)
    check("the banner's RMW", *_middleware(rows.get("RMW", ""), promised))
    python = rows.get("Python", "")
    check("the banner's Python", python.startswith(promised["python"] + "."), python, promised["python"])
    system_names = {system.get("VERSION_CODENAME"), f"{system['ID']}-{system.get('VERSION_ID')}"}
    check(
        "the operating system's name in matrix.yaml",
        promised["os"] in system_names,
        promised["os"],
        sorted(filter(None, system_names)),
    )
    check(
        "the banner's OS",
        rows.get("OS", "").startswith(system["PRETTY_NAME"] + ", "),
        rows.get("OS"),
        system["PRETTY_NAME"],
    )
    return problems


def _middleware(row: str, promised: Mapping[str, str]) -> tuple[bool, str, str]:
    """Whether the banner names the middleware of ROS 2, and all that the matrix promises; and what it should say."""
    if promised["ros"] == "1":
        return not row, row, "none: ROS 1 has one of its own"
    match = re.fullmatch(r"(rmw_\w+) \(installed: (.*)\)", row)
    names = match[2].split() if match else []
    default = names[0] if names and "rmw_fastrtps_cpp" not in names else "rmw_fastrtps_cpp"
    needed = [default, *filter(None, promised.get("rmw", "").split(","))]
    well = bool(match and match[1] == default) and set(needed) <= set(names) and "rmw_implementation" not in names
    return well, row, f"{default}, and installed: {' '.join(needed)}"


def main() -> None:
    recorded = pairs("".join(file.read_text() for file in sorted((SHARE / "versions.d").iterdir())))
    system = dict(line.split("=", 1) for line in Path("/etc/os-release").read_text().splitlines() if "=" in line)
    prefix = "EXPECT_"
    promised = {key[len(prefix) :].lower(): value for key, value in os.environ.items() if key.startswith(prefix)}
    banner = subprocess.run([SHARE / "banner.sh"], stdout=subprocess.PIPE, text=True, check=True).stdout
    print(banner)
    if problems := wrong(banner, recorded, {key: value.strip("\"'") for key, value in system.items()}, promised):
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
