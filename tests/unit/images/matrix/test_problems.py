"""What a wrong matrix.yaml says: the exact message for each kind of mistake."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SMALL, changed, parse

from rosml.base.errors import RosmlError
from rosml.base.problems import InputError, Problem, dotted, listed, near
from rosml.images.image_set import load
from rosml.images.matrix import model, source
from rosml.images.matrix.patterns import MEANING

ZEROS = "sha256:" + "1" * 64

# What stands in the small matrix, what a user wrote instead, and all that is said about it.
WRONG = {
    "unknown assembler": (
        "assembler: ubuntu-24.04",
        "assembler: ubuntu-24.4",
        "4:44: default.assembler: no operating system named 'ubuntu-24.4'; did you mean 'ubuntu-24.04' or "
        "'ubuntu-26.04'?",
    ),
    "no assembler": (
        "assembler: ubuntu-24.04, ",
        "",
        "4:1: default: 'assembler' is missing; add 'assembler: …' (the operating system that builds parts for any "
        "Python, tests images and lists their files)",
    ),
    "unknown name": (
        "os: ubuntu-24.04",
        "os: ubuntu-24.4",
        "50:5: distributions.alpha.os: no operating system named 'ubuntu-24.4'; "
        "did you mean 'ubuntu-24.04' or 'ubuntu-26.04'?",
    ),
    "misspelt key": (
        "    default_stack: cpu\n",
        "    default_stak: cpu\n",
        "58:3: distributions.omega: 'default_stack' is missing; add 'default_stack: …' "
        "(stack of the short tags, such as ros-torch:jazzy; of several the first that a framework exists on)\n"
        "63:5: distributions.omega.default_stak: unknown key 'default_stak'; did you mean 'default_stack'?",
    ),
    "misspelt section": (
        "distributions:",
        "distribution:",
        "1:1: 'distributions' is missing; add 'distributions: …'\n"
        "48:1: distribution: unknown key 'distribution'; did you mean 'distributions'?",
    ),
    "number for text": (
        'python: "3.12"',
        "python: 3.10",
        '12:5: operating_systems.ubuntu-24.04.python: expected text, found the number 3.10; write it in quotes: "3.10"',
    ),
    "number in a list": (
        '["3.12", "3.14"]',
        '["3.12", 3.14]',
        '38:31: releases.torch.2.10.0.python[1]: expected text, found the number 3.14; write it in quotes: "3.14"',
    ),
    "number for a key": (
        "    2.20.0: {python",
        "    2.20: {python",
        '40:5: releases.tensorflow.2.20: YAML reads the key 2.20 as a number; write it in quotes: "2.20"',
    ),
    "true for a key": (
        "  alpha:",
        "  on:",
        '49:3: distributions.on: YAML reads the key on as true or false; write it in quotes: "on"',
    ),
    "password of an index": (
        "    2.20.0: {python",
        "    2.20.0: {index: 'https://me:secret@packages.test/simple', python",
        "40:14: releases.tensorflow.2.20.0.index: expected the address of a Python package index without a password, such as"
        " https://packages.example.org/simple, found 'https://me:secret@packages.test/simple'",
    ),
    "true for one": (
        "version: 1",
        "version: true",
        "1:1: version: expected a whole number, found true",
    ),
    "a number with a point": (
        "    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]",
        "    ros: 2.0\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]",
        "60:5: distributions.omega.ros: expected a whole number, found the number 2.0",
    ),
    "version of one number": (
        "9.10.2.21, releases: {torch: 2.10.0",
        "9.10.2.21, releases: {torch: v2",
        "42:72: stacks.cu1.releases.torch: expected a version, such as 2.10.0, found 'v2'",
    ),
    "key twice": (
        "eol: 2029-05-31",
        "eol: 2029-05-31\n    eol: 2029-05-30",
        "56:5: distributions.alpha.eol: the key 'eol' is there twice, first on line 55; keep one",
    ),
    "yes for true": (
        "lts: true",
        "lts: yes",
        "56:5: distributions.alpha.lts: YAML reads yes as true or false; write true or false; "
        'or, if text is meant, in quotes: "yes"',
    ),
    "text for true": (
        "lts: true",
        "lts: maybe",
        "56:5: distributions.alpha.lts: expected true or false, found 'maybe'",
    ),
    "octal": (
        "os: {unpacked: 100",
        "os: {unpacked: 0100",
        "66:8: disk.os.unpacked: YAML reads 0100 as a number; write it in decimal digits; "
        'or, if text is meant, in quotes: "0100"',
    ),
    "text for a list": (
        "components: [core, base]",
        "components: core",
        "62:5: distributions.omega.components: expected a list, such as [a, b], found 'core'",
    ),
    "list for text": (
        "    tools: colcon\n    codename: noble",
        "    tools: [colcon]\n    codename: noble",
        "15:5: operating_systems.ubuntu-24.04.tools: expected text, found a list; write it without brackets",
    ),
    "empty list": (
        "components: [core, base]",
        "components: []",
        "62:5: distributions.omega.components: nothing is there; add at least one entry, such as [a, b]",
    ),
    "nothing for keys": (
        "robot: {builds_on: base}",
        "robot:",
        "29:3: components.robot: expected keys and values, found nothing",
    ),
    "twice, and unknown, in a list": (
        "components: [core, base]",
        "components: [core, core, bse]",
        # names are looked at once the structure is sound
        "62:24: distributions.omega.components[1]: 'core' is there twice; keep one",
    ),
    "unknown in a list": (
        "components: [core, base]",
        "components: [core, bse]",
        "62:24: distributions.omega.components[1]: no component named 'bse'; did you mean 'base'?",
    ),
    "cycle": (
        "robot: {builds_on: base}",
        "robot: {builds_on: desktop}",
        "29:11: components.robot.builds_on: a cycle: robot -> desktop -> robot; one of them must build on nothing",
    ),
    "cycle of one": (
        "robot: {builds_on: base}",
        "robot: {builds_on: robot}",
        "29:11: components.robot.builds_on: a cycle: robot -> robot; one of them must build on nothing",
    ),
    "two mistakes in one row": (
        "    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n",
        "    ros: 3\n    packages: ros-{distro}-{metapackage}\n    components: [core, base]\n",
        # names are looked at once the structure is sound
        "60:5: distributions.omega.ros: expected 1 or 2, found the number 3",
    ),
    "unpaired brace": (
        "    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n",
        "    packages: ros-{ros_distro-x\n    components: [core, base]\n",
        "61:5: distributions.omega.packages: unpaired braces in 'ros-{ros_distro-x'; "
        "placeholders: component, metapackage and ros_distro",
    ),
    "placeholder where none is": (
        "    tools: colcon\n    codename: noble",
        "    tools: colcon-{component}\n    codename: noble",
        "15:5: operating_systems.ubuntu-24.04.tools: no placeholder {component}; no placeholders are filled in here",
    ),
    "format from the future": (
        "version: 1",
        "version: 2\nother: 1",
        "1:1: version: expected 1, found the number 2; take the rosml of the checkout that the file is from, or a newer one",
    ),
    "registry with a scheme": (
        "registry: localhost:5000",
        "registry: https://localhost",
        "2:1: registry: expected a registry without https://, such as ghcr.io/owner or localhost:5000, "
        "found 'https://localhost'",
    ),
    "short digest": (
        f"digest: {ZEROS}",
        "digest: sha256:11",
        "11:5: operating_systems.ubuntu-24.04.digest: expected a digest: sha256: and 64 hexadecimal digits, "
        "found 'sha256:11'",
    ),
    "unknown release": (
        "      {torch: 2.10.0",
        "      {torch: 2.10.1",
        "46:8: stacks.cpu.releases.torch: no release of torch named '2.10.1'; did you mean '2.10.0'?",
    ),
    "stack without CUDA": (
        "cuda: 12.8.90, ",
        "",
        "42:3: stacks.cu1: a stack with accelerator cuda needs 'cuda'; add its version",
    ),
    "CPU with CUDA": (
        "    accelerator: cpu\n",
        "    accelerator: cpu\n    nccl: 2.27.5\n",
        "45:5: stacks.cpu.nccl: a stack with accelerator cpu has no nccl; remove it",
    ),
    "unknown accelerator": (
        "accelerator: cuda, cuda",
        "accelerator: gpu, cuda",
        "42:9: stacks.cu1.accelerator: expected cpu or cuda, found 'gpu'",
    ),
    "package of nothing": (
        "      {torch: 2.10.0, tensorflow: 2.20.0}\n",
        "      {torch: 2.10.0}\n",
        "47:16: stacks.cpu.packages.tensorflow: stack cpu has no release of tensorflow; add 'tensorflow: …' to its releases",
    ),
    "package of one architecture": (
        "{amd64: tensorflow-cpu, arm64: tensorflow}",
        "{amd64: tensorflow-cpu}",
        "47:16: stacks.cpu.packages.tensorflow: tensorflow 2.20.0 has a wheel for arm64; name its package",
    ),
    "package that is a number": (
        "{amd64: tensorflow-cpu, arm64: tensorflow}",
        "{amd64: 3, arm64: tensorflow}",
        '47:29: stacks.cpu.packages.tensorflow.amd64: expected text, found the number 3; write it in quotes: "3"',
    ),
    "wheels for an unknown architecture": (
        "cu1: [amd64], cpu: [arm64]",
        "cu1: [amd46], cpu: [arm64]",
        "38:55: releases.torch.2.10.0.wheels.cu1[0]: no architecture named 'amd46'; did you mean 'amd64' or 'arm64'?",
    ),
    "wheels for an unknown stack": (
        "wheels: {cu1: [amd64], cpu: [arm64]}",
        "wheels: {rocm: [amd64], cpu: [arm64]}",
        "38:49: releases.torch.2.10.0.wheels.rocm: no stack named 'rocm'; known: cu1, cpu",
    ),
    "framework with an unknown part": (
        "parts: [cuda, common, torch]}",
        "parts: [cuda, common, torsh]}",
        "34:56: frameworks.torch.parts[2]: no part named 'torsh'; did you mean 'torch'?",
    ),
    "framework without CUDA on stacks that have it": (
        "parts: [cuda, common, torch]}",
        "parts: [common, torch]}",
        "34:34: frameworks.torch.parts: common needs the part cuda; add it to 'parts', or say 'accelerators: [cpu]'",
    ),
    "framework without common": (
        "parts: [cuda, common, torch]}",
        "parts: [cuda, torch]}",
        "34:34: frameworks.torch.parts: torch needs the part common; add it to 'parts'",
    ),
    "part twice": (
        "tested: false, slot: 1}\n",
        "tested: false, slot: 1}\n  - {name: common, slot: 4}\n",
        "92:6: parts[2].name: 'common' is there twice; keep one",
    ),
    "part that needs an unknown one": (
        "needs: [cuda]",
        "needs: [coda]",
        "91:28: parts[1].needs[0]: no part named 'coda'; did you mean 'cuda'?",
    ),
    "part of an unknown release": (
        "short: tf, release: tensorflow",
        "short: tf, release: tensorflo",
        "94:54: parts[4].release: no release named 'tensorflo'; did you mean 'tensorflow'?",
    ),
    "part that repeats itself": (
        "needs: [common], slot: 2, ",
        "needs: [common], slot: 2, repeats: [torch], ",
        "92:77: parts[2].repeats: it belongs to a part beside the one of its release's name; remove it",
    ),
    "a part without a slot": (
        ", slot: 2, compiled: true}",
        "}",
        "92:5: parts[2]: torch has no slot, so pip would replace what it holds; add 'slot: 2'",
    ),
    "two parts of one slot": (
        "slot: 3}",
        "slot: 2}",
        "94:107: parts[4].slot: slot 2 is that of torch; free is 3",
    ),
    "a slot that no image has": (
        "slot: 3}",
        "slot: 17}",
        "94:107: parts[4].slot: expected at most 16, found the number 17",
    ),
    "part that adds what it does not take": (
        "takes: [nvidia-*]}",
        'takes: [nvidia-*], adds: {"12": [nvidia-a, "cuda-b>=1"]}}',
        "90:136: parts[0].adds.12[1]: cuda-b>=1 is not what the part takes; add it to 'takes'",
    ),
    "two shared parts": (
        "release: torch,",
        "release: torch, shared: true,",
        "92:51: parts[2].shared: common holds what several releases need; remove it",
    ),
    "no shared part": (
        "shared: true",
        "shared: false",
        "89:1: parts: no part holds what several releases need; say 'shared: true' of one",
    ),
    "release of no part": (
        "  torch:\n    2.10.0",
        "  jax: {}\n  torch:\n    2.10.0",
        "37:3: releases.jax: no part is a release of it; add one to 'parts': {name: jax, release: jax}",
    ),
    "stack with an unknown release": (
        "9.10.2.21, releases: {torch:",
        "9.10.2.21, releases: {torsh:",
        "42:72: stacks.cu1.releases.torsh: no release named 'torsh'; did you mean 'torch'?",
    ),
    "forecast of an unknown part": (
        "      cuda: {unpacked",
        "      coda: {unpacked",
        "73:5: disk.parts.cu1: no forecast for part cuda; add 'cuda: {unpacked: 900, compressed: 250}', a guess will do\n74:7: disk.parts.cu1.coda: no part named 'coda'; did you mean 'cuda'?",
    ),
    "one repository for two": (
        "repository: ros-ml",
        "repository: ros",
        "35:8: frameworks.ml.repository: repository 'ros' belongs to framework none; tags would collide",
    ),
    "no plain framework": (
        "  none: {repository: ros}\n",
        "",
        "31:1: frameworks: exactly one framework has no parts: the ROS images that all others stand on; none has",
    ),
    "one name for two": (
        "none: {repository: ros}",
        "cpu: {repository: ros}",
        "43:3: stacks.cpu: the name 'cpu' is taken (by frameworks.cpu); both would be the same group of targets",
    ),
    "reserved name": (
        "none: {repository: ros}",
        "all: {repository: ros}",
        "32:3: frameworks.all: the name 'all' is taken (a group of its own); both would be the same group of targets",
    ),
    "upper case": (
        "  alpha:",
        "  Alpha:",
        "49:3: distributions.Alpha: expected a name of lower-case letters, digits and single hyphens, "
        "such as desktop-full, found 'Alpha'",
    ),
    "a name too long": (
        "  alpha:",
        f"  {'a' * 30}:",
        f"49:3: distributions.{'a' * 30}: too long: 30 characters, at most 24 are allowed",
    ),
    "no forecast": (
        "    robot: {unpacked: 20, compressed: 2}\n",
        "",
        "67:3: disk.components: no forecast for component robot; "
        "add 'robot: {unpacked: 900, compressed: 250}', a guess will do",
    ),
    "no forecast of a part": (
        "      torch: {unpacked: 500, compressed: 50}\n",
        "",
        "79:5: disk.parts.cpu: no forecast for part torch; "
        "add 'torch: {unpacked: 900, compressed: 250}', a guess will do",
    ),
    "budget of nothing": (
        "  parts:\n    cu1:",
        "  budgets: {cu2: {torch: 1}, cpu: {none: 1, torsh: 1}}\n  parts:\n    cu1:",
        "72:13: disk.budgets.cu2: no stack named 'cu2'; did you mean 'cu1' or 'cpu'?\n"
        "72:36: disk.budgets.cpu.none: no framework or add-on named 'none'; known: cuda, torch, ml\n"
        "72:45: disk.budgets.cpu.torsh: no framework or add-on named 'torsh'; did you mean 'torch'?",
    ),
    "double braces": (
        "packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]",
        "packages: ros-{{ros_distro}}-{metapackage}\n    components: [core, base, desktop]",
        "52:5: distributions.alpha.packages: double braces in 'ros-{{ros_distro}}-{metapackage}' are no placeholder; "
        "write them once",
    ),
    "options for packages": (
        "tools: colcon\n    codename: noble",
        "tools: colcon -y bash-\n    codename: noble",
        "15:5: operating_systems.ubuntu-24.04.tools: no package is called '-y': apt would take it for an option, or "
        "remove it\n"
        "15:5: operating_systems.ubuntu-24.04.tools: no package is called 'bash-': apt would take it for an option, or "
        "remove it",
    ),
    "upper case in package names": (
        "    lts: true",
        "    lts: true\n    ros_distro: Alpha",
        "57:5: distributions.alpha.ros_distro: packages have lower-case names, and {ros_distro} is part of them",
    ),
    "negative size": (
        "os: {unpacked: 100",
        "os: {unpacked: -1",
        "66:8: disk.os.unpacked: expected at least 0, found the number -1",
    ),
    "absurd size": (
        "os: {unpacked: 100",
        "os: {unpacked: 100000000",
        "66:8: disk.os.unpacked: expected at most 1000000, found the number 100000000",
    ),
    "part of a megabyte": (
        "os: {unpacked: 100",
        "os: {unpacked: 1.5",
        "66:8: disk.os.unpacked: expected a whole number, found the number 1.5",
    ),
    "no such day": (
        "eol: 2029-05-31",
        "eol: 2029-02-31",
        "55:5: distributions.alpha.eol: 2029-02-31 is not a day of the calendar, as in 2028-06-30",
    ),
    "day in quotes": (
        "eol: 2029-05-31",
        'eol: "2029-05-31"',
        "55:5: distributions.alpha.eol: expected a day, such as 2028-06-30, without quotes, found '2029-05-31'",
    ),
    "long-term without end": (
        "    eol: 2029-05-31\n",
        "",
        "55:5: distributions.alpha.lts: a long-term release has an end of life; add 'eol: …'",
    ),
    "no RMW implementation": (
        "    apt: {channel: live}",
        "    apt: {channel: live}\n    rmw: [cyclonedds]",
        "58:11: distributions.alpha.rmw[0]: expected an RMW implementation, such as rmw_cyclonedds_cpp, found 'cyclonedds'",
    ),
    "an RMW implementation twice": (
        "    apt: {channel: live}",
        "    apt: {channel: live}\n    rmw: [rmw_cyclonedds_cpp, rmw_zenoh_cpp, rmw_cyclonedds_cpp]",
        "58:46: distributions.alpha.rmw[2]: 'rmw_cyclonedds_cpp' is there twice; keep one",
    ),
    "RMW implementations of ROS 1": (
        "    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]",
        "    ros: 1\n    rmw: [rmw_cyclonedds_cpp]\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]",
        "61:5: distributions.omega.rmw: ROS 1 has no RMW implementations; they are ROS 2's",
    ),
    "snapshot without a day": (
        ", date: 2026-11-01",
        "",
        "64:5: distributions.omega.apt: 'date' belongs to the channel snapshot, and to it alone",
    ),
    "live without its package": (
        "{channel: snapshot, date: 2026-11-01}",
        "{channel: live}",
        "64:5: distributions.omega.apt: the live channel needs a pinned ros2-apt-source for ubuntu-26.04; "
        "add 'apt_sources: {ros2: {version: …, digest: …}}' to it",
    ),
    "no suite": (
        "    codename: resolute\n",
        "",
        "63:5: distributions.omega.apt: ROS's apt repositories need the suite of ubuntu-26.04; add 'codename: …' to it",
    ),
    "nothing says where ROS's repositories are": (
        "ros_archive:\n  live: http://ros.test/{generation}/ubuntu\n"
        "  snapshot: http://snapshots.ros.test/{ros_distro}/{day}/ubuntu\n"
        "  apt_source: https://git.test/{version}/{generation}.{codename}.deb\n",
        "",
        "57:5: distributions.alpha.apt: ROS's apt repositories have no address; "
        "add 'ros_archive: {live: …, snapshot: …, apt_source: …}'\n"
        "64:5: distributions.omega.apt: ROS's apt repositories have no address; "
        "add 'ros_archive: {live: …, snapshot: …, apt_source: …}'",
    ),
    "a placeholder that is not filled in": (
        "{ros_distro}/{day}/ubuntu",
        "{ros_distro}/{date}/ubuntu",
        "87:3: ros_archive.snapshot: no placeholder {date}; known: ros_distro, day",
    ),
    "a placeholder of the package that sets up the source": (
        "{generation}.{codename}.deb",
        "{generation}.{suite}.deb",
        "88:3: ros_archive.apt_source: no placeholder {suite}; known: generation, version, codename",
    ),
    "packages from nowhere": (
        "    apt: {channel: snapshot, date: 2026-11-01}\n",
        "",
        "58:3: distributions.omega: ubuntu-26.04 does not have ROS's packages itself, and no other source is named; "
        "add 'apt: {channel: live}', 'apt: {channel: snapshot, date: …}', past the end of life "
        "'apt: {channel: final}', or 'archive: {address: …, suite: …, key: …}'",
    ),
    "packages from two places": (
        "    apt: {channel: snapshot, date: 2026-11-01}\n",
        "    apt: {channel: snapshot, date: 2026-11-01}\n    archive: {address: http://a.test, suite: x, key: a.asc}\n",
        "65:5: distributions.omega.archive: ROS comes from 'apt' already; keep one of the two",
    ),
    "a key that is no file": (
        "    apt: {channel: snapshot, date: 2026-11-01}\n",
        "    archive: {address: http://a.test, suite: x, key: ../a.asc}\n",
        "64:49: distributions.omega.archive.key: expected a file in components/archive-keys with an armored public key, "
        "such as mine.asc, found '../a.asc'",
    ),
    "a generation in quotes": (
        "    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]",
        '    ros: "2"\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]',
        "51:5: distributions.alpha.ros: expected 1 or 2, found '2'",
    ),
    "a package source that is wrong itself": (
        "apt_sources: {ros2: {version: 2.0.0, digest: sha256:" + "3" * 64 + "}}",
        "apt_sources: 2.0.0",
        "17:5: operating_systems.ubuntu-24.04.apt_sources: expected keys and values, found '2.0.0'",
    ),
    "a stack without forecasts": (
        "    cpu:\n      common: {unpacked: 300, compressed: 30}\n      torch: {unpacked: 500, compressed: 50}\n"
        "      tensorflow-cc: {unpacked: 400, compressed: 40}\n      tensorflow: {unpacked: 100, compressed: 10}\n",
        "",
        "\n".join(
            f"72:3: disk.parts.cpu: no forecast for part {part}; "
            f"add '{part}: {{unpacked: 900, compressed: 250}}', a guess will do"
            for part in ("common", "tensorflow-cc", "tensorflow", "torch")
        ),
    ),
    "an architecture by another name": (
        "    architectures: [amd64, arm64]\n    tools: colcon\n    codename: noble",
        "    architectures: [x86-64]\n    tools: colcon\n    codename: noble",
        "14:21: operating_systems.ubuntu-24.04.architectures[0]: no architecture named 'x86-64'; known: amd64, arm64",
    ),
    "unknown channel": (
        "channel: snapshot",
        "channel: nightly",
        "64:11: distributions.omega.apt.channel: expected live, testing, snapshot or final, found 'nightly'",
    ),
    "default without a stack": (
        "alpha-core-torch-cu1",
        "alpha-core-torch",
        "4:21: default.targets[0]: alpha-core-torch names no stack; there is alpha-core-torch-cu1 and alpha-core-torch-cpu.",
    ),
    "default that nothing has, default that cannot be": (
        "[alpha-core]",
        "[alpha-cor, omega-robot]",
        "4:77: default.group[0]: no image named 'alpha-cor'; did you mean 'alpha-core', 'alpha-core-ml-cu1' "
        "or 'alpha-core-ml-cpu'?\n"
        "4:88: default.group[1]: omega-robot does not exist: omega (ROS 2) has no robot metapackage; "
        "it has core and base.",
    ),
    "anchor": (
        "lts: true",
        "lts: &yes true",
        "56:10: the anchor yes is not allowed; write plain values out",
    ),
    "anchor and alias": (
        "components: [core, base]\n",
        "components: &c [core, base]\n    extra: *c\n",
        "62:17: the anchor c is not allowed; write plain values out\n"
        "63:12: the alias c is not allowed; write plain values out",
    ),
    "tag": (
        "lts: true",
        "lts: !!python/name:os.system true",
        "56:10: the tag tag:yaml.org,2002:python/name:os.system is not allowed; write plain values out",
    ),
    "list for a key": ("lts: true", "? [a]\n    : true", "56:7: distributions.alpha: a key must be plain text"),
    "tab at the very start": (
        "version: 1\n",
        "\tversion: 1\n",
        "1:1: not YAML: this line is indented with a tab; indent with spaces",
    ),
    "a range without quotes": (
        'numpy: ">=2.2,<2.3"',
        "numpy: >=2.2,<2.3",
        "22:13: not YAML: did not find expected comment or line break; put the text in quotes",
    ),
    "tab": (
        "    lts: true",
        "\tlts: true",
        "56:1: not YAML: found a tab character that violates indentation; indent with spaces",
    ),
    "open brace": (
        "lts: true",
        "lts: {",
        "58:3: not YAML: did not find expected ',' or '}'; close the bracket, and put commas between its items",
    ),
    "no space after a colon": (
        "lts: true",
        "lts:true",
        "56:5: not YAML: could not find expected ':'; a key is followed by a colon and a space, as in 'key: value'",
    ),
    "no space after the first colon": (
        "    os: ubuntu-24.04\n    ros: 2",
        "    os:ubuntu-24.04\n    ros: 2",
        "51:8: not YAML: mapping values are not allowed in this context; indent keys of one level alike, "
        "put a space after each colon, and text with ': ' in it in quotes",
    ),
    "open quote": (
        'numpy: "<2"',
        'numpy: "<2',
        "21:14: not YAML: did not find expected key; "
        "look at this line and those above for a quote that is left open, or another indentation",
    ),
    "another indentation": (
        "    lts: true",
        "   lts: true",
        "56:4: not YAML: did not find expected key; "
        "look at this line and those above for a quote that is left open, or another indentation",
    ),
    "list for a version": (
        'python: "3.12"',
        'python: ["3.12"]',
        "12:5: operating_systems.ubuntu-24.04.python: expected text, found a list; write it without brackets",
    ),
    "architecture that is none of BuildKit's": (
        "arm64: {platform: linux/arm64,",
        "arm64: {platform: linux/arm/v7,",
        "7:11: architectures.arm64.platform: BuildKit calls the architecture of linux/arm/v7 'arm', and locks are found "
        "by that name; rename 'arm64' to it, or correct the platform",
    ),
    "two architectures of one platform": (
        "arm64: {platform: linux/arm64,",
        "arm64: {platform: linux/amd64,",
        "7:11: architectures.arm64.platform: BuildKit calls the architecture of linux/amd64 'amd64', and locks are found "
        "by that name; rename 'arm64' to it, or correct the platform",
    ),
    "registry with two ports": (
        "registry: localhost:5000",
        "registry: localhost:::5000",
        "2:1: registry: expected a registry without https://, such as ghcr.io/owner or localhost:5000, "
        "found 'localhost:::5000'",
    ),
    "second document": (
        "distributions:",
        "---\ndistributions:",
        "48:1: not YAML: but found another document; keep one document in a file",
    ),
    "control character": ("lts: true", "lts: \x07", "56:10: a character that YAML does not allow; remove it"),
    "three mistakes far apart": (
        SMALL,
        changed(
            "lts: true", "lts: 1", changed("os: ubuntu-24.04", "os: debian", changed("core: {meta", "core: {mata"))
        ),
        "27:10: components.core.matapackage: unknown key 'matapackage'; did you mean 'metapackage'?\n"
        "56:5: distributions.alpha.lts: expected true or false, found the number 1",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_message(name: str) -> None:
    old, new, expected = WRONG[name]
    with pytest.raises(InputError) as caught:
        parse(changed(old, new))
    assert str(caught.value) == "\n".join(f"matrix.yaml:{line}" for line in expected.split("\n"))
    assert caught.value.exit_code == 2


CONTENT = {
    "empty": (b"", "matrix.yaml:1:1: the file is empty; it needs at least 'version: 1'"),
    "comments only": (b"# nothing\n", "matrix.yaml:1:1: the file is empty; it needs at least 'version: 1'"),
    "text": (b"hello", "matrix.yaml:1:1: expected keys and values, such as 'version: …', found 'hello'"),
    "list": (b"- 1\n- 2\n", "matrix.yaml:1:1: expected keys and values, such as 'version: …', found a list"),
    "null": (b"~", "matrix.yaml:1:1: expected keys and values, such as 'version: …', found nothing"),
    "not UTF-8": (b"version: 1\nsource: \xff", "matrix.yaml:2:9: not UTF-8 (byte 0xff); save the file as UTF-8"),
    "UTF-16": ("version: 1".encode("utf-16"), "matrix.yaml:1:1: not UTF-8 (byte 0xff); save the file as UTF-8"),
    "NUL": (b"version: \x00", "matrix.yaml:1:10: a character that YAML does not allow; remove it"),
    "bomb": (
        b"a: &a [x]\nb: [*a, *a]",
        "matrix.yaml:1:4: the anchor a is not allowed; write plain values out\n"
        "matrix.yaml:2:5: the alias a is not allowed; write plain values out\n"
        "matrix.yaml:2:9: the alias a is not allowed; write plain values out",
    ),
}


@pytest.mark.parametrize("name", CONTENT)
def test_content(name: str) -> None:
    content, expected = CONTENT[name]
    with pytest.raises(InputError) as caught:
        load.image_set(source.parse(content))
    assert str(caught.value) == expected


def test_byte_order_mark() -> None:
    assert load.image_set(source.parse(b"\xef\xbb\xbf" + SMALL.encode())).images


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=r"none\.yaml: no such file") as caught:
        load.load(tmp_path / "none.yaml")
    assert caught.value.exit_code == 2
    assert caught.value.remedy


def test_folder(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match="cannot be read: Is a directory") as caught:
        load.load(tmp_path)
    assert caught.value.exit_code == 2


def test_link_that_leads_to_itself(tmp_path: Path) -> None:
    link = tmp_path / "loop.yaml"
    link.symlink_to(link)
    with pytest.raises(RosmlError, match=r"loop\.yaml: cannot be read: Too many levels of symbolic links"):
        load.load(link)


def test_file_name_with_nul() -> None:
    with pytest.raises(RosmlError, match="cannot be read"):
        load.load(Path("a\0b"))


def test_long_lists_of_problems_are_cut() -> None:
    wrong = ", ".join(f"x{n}" for n in range(60))
    with pytest.raises(InputError) as caught:
        parse(changed("[core, base]", f"[{wrong}]"))
    lines = str(caught.value).splitlines()
    assert len(lines) == 51
    assert lines[-1] == "matrix.yaml: and more; the first 50 problems are shown"


def test_problems_are_sorted_and_unique() -> None:
    problems = [Problem(2, 1, "b", "y"), Problem(1, 5, "a", "x"), Problem(2, 1, "b", "y")]
    assert str(InputError("m.yaml", problems)) == "m.yaml:1:5: a: x\nm.yaml:2:1: b: y"


def test_words() -> None:
    assert dotted(("a", "b", 2, "c")) == "a.b[2].c"
    assert listed(["a"]) == "a"
    assert listed(["a", "b", "c"], last="or") == "a, b or c"
    assert listed([]) == ""
    assert near("jazy", ["jazzy", "humble"]) == "did you mean 'jazzy'?"
    assert near("x", ["humble"]) == "known: humble"
    assert near("x", []) == ""


def patterns(content: object) -> set[str]:
    """Every pattern of a JSON schema."""
    if isinstance(content, dict):
        own = {content["pattern"]} if isinstance(content.get("pattern"), str) else set()
        return own.union(*map(patterns, content.values()))
    return set[str]().union(*map(patterns, content)) if isinstance(content, list) else set()


def test_every_pattern_has_a_meaning() -> None:
    """Without it a wrong value of that kind says only that text was expected."""
    found = patterns(model.Matrix.model_json_schema())
    assert len(found) > 10
    assert found - MEANING.keys() == set()


def test_what_is_nested_without_end() -> None:
    with pytest.raises(InputError, match="nested more than 100 levels deep; remove what was pasted"):
        source.parse(b"a: " + b"[" * 1_500 + b"]" * 1_500)


def test_two_systems_of_one_target() -> None:
    text = SMALL.replace("  ubuntu-26.04:\n", "  ubuntu-24-04:\n").replace("os: ubuntu-26.04", "os: ubuntu-24-04")
    with pytest.raises(InputError, match="would both be called _os-ubuntu-24-04; rename one"):
        parse(text)
