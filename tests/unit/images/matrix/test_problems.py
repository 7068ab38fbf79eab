"""What a wrong matrix.yaml says: place and reason of each kind of mistake, and no password."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SMALL, changed, parse

from rosml.base.errors import RosmlError
from rosml.base.problems import InputError, Problem
from rosml.images.image_set import load
from rosml.images.matrix import model, source
from rosml.images.matrix.patterns import MEANING

ZEROS = "sha256:" + "1" * 64

FORECASTS = SMALL[SMALL.index("    cpu:\n      common:") : SMALL.index("rates:")]

# What stands in the small matrix, what a user wrote instead, and the beginning of each line about it.
WRONG = {
    "unknown name": ("os: ubuntu-24.04", "os: ubuntu-24.4", "50:5: distributions.alpha.os: no operating system named 'ubuntu-24.4'"),
    "misspelt key": ("    default_stack: cpu\n", "    default_stak: cpu\n", "58:3: distributions.omega: 'default_stack' is missing\n63:5: distributions.omega.default_stak: unknown key 'default_stak'"),
    "misspelt section": ("distributions:", "distribution:", "1:1: 'distributions' is missing\n48:1: distribution: unknown key 'distribution'"),
    "number for text": ('python: "3.12"', "python: 3.10", "12:5: operating_systems.ubuntu-24.04.python: expected text"),
    "number in a list": ('["3.12", "3.14"]', '["3.12", 3.14]', "38:31: releases.torch.2.10.0.python[1]: expected text"),
    "number for a key": ("    2.20.0: {python", "    2.20: {python", "40:5: releases.tensorflow.2.20: YAML reads the key 2.20 as a number"),
    "true for a key": ("  alpha:", "  on:", "49:3: distributions.on: YAML reads the key on as true or false"),
    "true for one": ("version: 1", "version: true", "1:1: version: expected a whole number"),
    "a number with a point": ("    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]", "    ros: 2.0\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]", "60:5: distributions.omega.ros: expected a whole number"),
    "version of one number": ("9.10.2.21, releases: {torch: 2.10.0", "9.10.2.21, releases: {torch: v2", "42:72: stacks.cu1.releases.torch: expected a version"),
    "key twice": ("eol: 2029-05-31", "eol: 2029-05-31\n    eol: 2029-05-30", "56:5: distributions.alpha.eol: the key 'eol' is there twice, first on line 55"),
    "yes for true": ("lts: true", "lts: yes", "56:5: distributions.alpha.lts: YAML reads yes as true or false"),
    "text for true": ("lts: true", "lts: maybe", "56:5: distributions.alpha.lts: expected true or false"),
    "octal": ("os: {unpacked: 100", "os: {unpacked: 0100", "66:8: disk.os.unpacked: YAML reads 0100 as a number"),
    "text for a list": ("components: [core, base]", "components: core", "62:5: distributions.omega.components: expected a list"),
    "list for text": ("    tools: colcon\n    codename: noble", "    tools: [colcon]\n    codename: noble", "15:5: operating_systems.ubuntu-24.04.tools: expected text"),
    "empty list": ("components: [core, base]", "components: []", "62:5: distributions.omega.components: nothing is there"),
    "nothing for keys": ("robot: {builds_on: base}", "robot:", "29:3: components.robot: expected keys and values"),
    "twice, and unknown, in a list": ("components: [core, base]", "components: [core, core, bse]", "62:24: distributions.omega.components[1]: 'core' is there twice"),
    "unknown in a list": ("components: [core, base]", "components: [core, bse]", "62:24: distributions.omega.components[1]: no component named 'bse'"),
    "cycle": ("robot: {builds_on: base}", "robot: {builds_on: desktop}", "29:11: components.robot.builds_on: a cycle: robot -> desktop -> robot"),
    "two mistakes in one row": ("    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n", "    ros: 3\n    packages: ros-{distro}-{metapackage}\n    components: [core, base]\n", "60:5: distributions.omega.ros: expected 1 or 2"),
    "unpaired brace": ("    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]\n", "    packages: ros-{ros_distro-x\n    components: [core, base]\n", "61:5: distributions.omega.packages: unpaired braces in 'ros-{ros_distro-x'"),
    "format from the future": ("version: 1", "version: 2\nother: 1", "1:1: version: expected 1"),
    "registry with a scheme": ("registry: localhost:5000", "registry: https://localhost", "2:1: registry: expected a registry without https://"),
    "short digest": (f"digest: {ZEROS}", "digest: sha256:11", "11:5: operating_systems.ubuntu-24.04.digest: expected a digest"),
    "unknown release": ("      {torch: 2.10.0", "      {torch: 2.10.1", "46:8: stacks.cpu.releases.torch: no release of torch named '2.10.1'"),
    "stack without CUDA": ("cuda: 12.8.90, ", "", "42:3: stacks.cu1: a stack with accelerator cuda needs 'cuda'"),
    "CPU with CUDA": ("    accelerator: cpu\n", "    accelerator: cpu\n    nccl: 2.27.5\n", "45:5: stacks.cpu.nccl: a stack with accelerator cpu has no nccl"),
    "unknown accelerator": ("accelerator: cuda, cuda", "accelerator: gpu, cuda", "42:9: stacks.cu1.accelerator: expected cpu or cuda"),
    "package of nothing": ("      {torch: 2.10.0, tensorflow: 2.20.0}\n", "      {torch: 2.10.0}\n", "47:16: stacks.cpu.packages.tensorflow: stack cpu has no release of tensorflow"),
    "package of one architecture": ("{amd64: tensorflow-cpu, arm64: tensorflow}", "{amd64: tensorflow-cpu}", "47:16: stacks.cpu.packages.tensorflow: tensorflow 2.20.0 has a wheel for arm64"),
    "package that is a number": ("{amd64: tensorflow-cpu, arm64: tensorflow}", "{amd64: 3, arm64: tensorflow}", "47:29: stacks.cpu.packages.tensorflow.amd64: expected text"),
    "wheels for an unknown stack": ("wheels: {cu1: [amd64], cpu: [arm64]}", "wheels: {rocm: [amd64], cpu: [arm64]}", "38:49: releases.torch.2.10.0.wheels.rocm: no stack named 'rocm'"),
    "framework with an unknown part": ("parts: [cuda, common, torch]}", "parts: [cuda, common, torsh]}", "34:56: frameworks.torch.parts[2]: no part named 'torsh'"),
    "framework without CUDA on stacks that have it": ("parts: [cuda, common, torch]}", "parts: [common, torch]}", "34:34: frameworks.torch.parts: common needs the part cuda"),
    "framework without common": ("parts: [cuda, common, torch]}", "parts: [cuda, torch]}", "34:34: frameworks.torch.parts: torch needs the part common"),
    "part twice": ("tested: false, slot: 1}\n", "tested: false, slot: 1}\n  - {name: common, slot: 4}\n", "92:6: parts[2].name: 'common' is there twice"),
    "part that needs an unknown one": ("needs: [cuda]", "needs: [coda]", "91:28: parts[1].needs[0]: no part named 'coda'"),
    "part of an unknown release": ("short: tf, release: tensorflow", "short: tf, release: tensorflo", "94:54: parts[4].release: no release named 'tensorflo'"),
    "part that repeats itself": ("needs: [common], slot: 2, ", "needs: [common], slot: 2, repeats: [torch], ", "92:77: parts[2].repeats: it belongs to a part beside the one of its release's name"),
    "a part without a slot": (", slot: 2, compiled: true}", "}", "92:5: parts[2]: torch has no slot, so pip would replace what it holds"),
    "two parts of one slot": ("slot: 3}", "slot: 2}", "94:107: parts[4].slot: slot 2 is that of torch"),
    "a slot that no image has": ("slot: 3}", "slot: 17}", "94:107: parts[4].slot: expected at most 16"),
    "part that adds what it does not take": ("takes: [nvidia-*]}", 'takes: [nvidia-*], adds: {"12": [nvidia-a, "cuda-b>=1"]}}', "90:136: parts[0].adds.12[1]: cuda-b>=1 is not what the part takes"),
    "two shared parts": ("release: torch,", "release: torch, shared: true,", "92:51: parts[2].shared: common holds what several releases need"),
    "no shared part": ("shared: true", "shared: false", "89:1: parts: no part holds what several releases need"),
    "release of no part": ("  torch:\n    2.10.0", "  jax: {}\n  torch:\n    2.10.0", "37:3: releases.jax: no part is a release of it"),
    "stack with an unknown release": ("9.10.2.21, releases: {torch:", "9.10.2.21, releases: {torsh:", "42:72: stacks.cu1.releases.torsh: no release named 'torsh'"),
    "forecast of an unknown part": ("      cuda: {unpacked", "      coda: {unpacked", "73:5: disk.parts.cu1: no forecast for part cuda\n74:7: disk.parts.cu1.coda: no part named 'coda'"),
    "one repository for two": ("repository: ros-ml", "repository: ros", "35:8: frameworks.ml.repository: repository 'ros' belongs to framework none"),
    "no plain framework": ("  none: {repository: ros}\n", "", "31:1: frameworks: exactly one framework has no parts: the ROS images that all others stand on"),
    "one name for two": ("none: {repository: ros}", "cpu: {repository: ros}", "43:3: stacks.cpu: the name 'cpu' is taken"),
    "reserved name": ("none: {repository: ros}", "all: {repository: ros}", "32:3: frameworks.all: the name 'all' is taken"),
    "upper case": ("  alpha:", "  Alpha:", "49:3: distributions.Alpha: expected a name of lower-case letters, digits and single hyphens"),
    "a name too long": ("  alpha:", f"  {'a' * 30}:", f"49:3: distributions.{'a' * 30}: too long"),
    "no forecast": ("    robot: {unpacked: 20, compressed: 2}\n", "", "67:3: disk.components: no forecast for component robot"),
    "no forecast of a part": ("      torch: {unpacked: 500, compressed: 50}\n", "", "79:5: disk.parts.cpu: no forecast for part torch"),
    "budget of nothing": ("  parts:\n    cu1:", "  budgets: {cu2: {torch: 1}, cpu: {none: 1, torsh: 1}}\n  parts:\n    cu1:", "72:13: disk.budgets.cu2: no stack named 'cu2'\n72:36: disk.budgets.cpu.none: no framework or add-on named 'none'\n72:45: disk.budgets.cpu.torsh: no framework or add-on named 'torsh'"),
    "double braces": ("packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]", "packages: ros-{{ros_distro}}-{metapackage}\n    components: [core, base, desktop]", "52:5: distributions.alpha.packages: double braces in 'ros-{{ros_distro}}-{metapackage}' are no placeholder"),
    "options for packages": ("tools: colcon\n    codename: noble", "tools: colcon -y bash-\n    codename: noble", "15:5: operating_systems.ubuntu-24.04.tools: no package is called '-y': apt would take it for an option, or remove it\n15:5: operating_systems.ubuntu-24.04.tools: no package is called 'bash-': apt would take it for an option, or remove it"),
    "upper case in package names": ("    lts: true", "    lts: true\n    ros_distro: Alpha", "57:5: distributions.alpha.ros_distro: packages have lower-case names, and {ros_distro} is part of them"),
    "negative size": ("os: {unpacked: 100", "os: {unpacked: -1", "66:8: disk.os.unpacked: expected at least 0"),
    "no such day": ("eol: 2029-05-31", "eol: 2029-02-31", "55:5: distributions.alpha.eol: 2029-02-31 is not a day of the calendar, as in 2028-06-30"),
    "day in quotes": ("eol: 2029-05-31", 'eol: "2029-05-31"', "55:5: distributions.alpha.eol: expected a day"),
    "long-term without end": ("    eol: 2029-05-31\n", "", "55:5: distributions.alpha.lts: a long-term release has an end of life"),
    "no RMW implementation": ("    apt: {channel: live}", "    apt: {channel: live}\n    rmw: [cyclonedds]", "58:11: distributions.alpha.rmw[0]: expected an RMW implementation"),
    "an RMW implementation twice": ("    apt: {channel: live}", "    apt: {channel: live}\n    rmw: [rmw_cyclonedds_cpp, rmw_zenoh_cpp, rmw_cyclonedds_cpp]", "58:46: distributions.alpha.rmw[2]: 'rmw_cyclonedds_cpp' is there twice"),
    "RMW implementations of ROS 1": ("    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]", "    ros: 1\n    rmw: [rmw_cyclonedds_cpp]\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base]", "61:5: distributions.omega.rmw: ROS 1 has no RMW implementations"),
    "snapshot without a day": (", date: 2026-11-01", "", "64:5: distributions.omega.apt: 'date' belongs to the channel snapshot, and to it alone"),
    "live without its package": ("{channel: snapshot, date: 2026-11-01}", "{channel: live}", "64:5: distributions.omega.apt: the live channel needs a pinned ros2-apt-source for ubuntu-26.04"),
    "no suite": ("    codename: resolute\n", "", "63:5: distributions.omega.apt: ROS's apt repositories need the suite of ubuntu-26.04"),
    "nothing says where ROS's repositories are": ("ros_archive:\n  live: http://ros.test/{generation}/ubuntu\n  snapshot: http://snapshots.ros.test/{ros_distro}/{day}/ubuntu\n  apt_source: https://git.test/{version}/{generation}.{codename}.deb\n", "", "57:5: distributions.alpha.apt: ROS's apt repositories have no address\n64:5: distributions.omega.apt: ROS's apt repositories have no address"),
    "a placeholder that is not filled in": ("{ros_distro}/{day}/ubuntu", "{ros_distro}/{date}/ubuntu", "87:3: ros_archive.snapshot: no placeholder {date}"),
    "a placeholder of the package that sets up the source": ("{generation}.{codename}.deb", "{generation}.{suite}.deb", "88:3: ros_archive.apt_source: no placeholder {suite}"),
    "packages from nowhere": ("    apt: {channel: snapshot, date: 2026-11-01}\n", "", "58:3: distributions.omega: ubuntu-26.04 does not have ROS's packages itself, and no other source is named"),
    "packages from two places": ("    apt: {channel: snapshot, date: 2026-11-01}\n", "    apt: {channel: snapshot, date: 2026-11-01}\n    archive: {address: http://a.test, suite: x, key: a.asc}\n", "65:5: distributions.omega.archive: ROS comes from 'apt' already"),
    "a key that is no file": ("    apt: {channel: snapshot, date: 2026-11-01}\n", "    archive: {address: http://a.test, suite: x, key: ../a.asc}\n", "64:49: distributions.omega.archive.key: expected a file in components/archive-keys with an armored public key"),
    "a generation in quotes": ("    ros: 2\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]", '    ros: "2"\n    packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]', "51:5: distributions.alpha.ros: expected 1 or 2"),
    "a package source that is wrong itself": (f"apt_sources: {{ros2: {{version: 2.0.0, digest: sha256:{'3' * 64}}}}}", "apt_sources: 2.0.0", "17:5: operating_systems.ubuntu-24.04.apt_sources: expected keys and values"),
    "a stack without forecasts": (FORECASTS, "", "\n".join(f"72:3: disk.parts.cpu: no forecast for part {part}" for part in ("common", "tensorflow-cc", "tensorflow", "torch"))),
    "an architecture by another name": ("    architectures: [amd64, arm64]\n    tools: colcon\n    codename: noble", "    architectures: [x86-64]\n    tools: colcon\n    codename: noble", "14:21: operating_systems.ubuntu-24.04.architectures[0]: no architecture named 'x86-64'"),
    "unknown channel": ("channel: snapshot", "channel: nightly", "64:11: distributions.omega.apt.channel: expected live, testing, snapshot or final"),
    "default without a stack": ("alpha-core-torch-cu1", "alpha-core-torch", "4:21: default.targets[0]: alpha-core-torch names no stack"),
    "default that nothing has, default that cannot be": ("[alpha-core]", "[alpha-cor, omega-robot]", "4:77: default.group[0]: no image named 'alpha-cor'\n4:88: default.group[1]: omega-robot does not exist: omega"),
    "GPUs of an unknown architecture": ("    2.20.0: {python", "    2.20.0: {gpus: {amd46: [sm_80]}, python", "40:21: releases.tensorflow.2.20.0.gpus.amd46: no architecture named 'amd46'"),
    "runtime of a runtime": ("robot: {builds_on: base}", "robot: {runtime_of: desktop}\n  desktop-run: {runtime_of: robot}", "30:17: components.desktop-run.runtime_of: robot is a runtime itself\n31:13: components.desktop.builds_on: one of them has runtime_of\n68:3: disk.components: no forecast"),
    "two runtimes": ("robot: {builds_on: base}", "robot: {runtime_of: core}\n  core-run: {runtime_of: core}", "30:14: components.core-run.runtime_of: robot is that of core already\n31:13: components.desktop.builds_on: one of them\n68:3: disk.components: no forecast"),
    "CUDA from PyTorch's own index": ("cpu: [arm64]}}", "cpu: [arm64]}, elsewhere: {cu1: {arm64: {}}}, requires: [jinja2]}", "38:90: releases.torch.2.10.0.elsewhere.cu1: stack cu1 is not one of the CPU"),
    "anchor": ("lts: true", "lts: &yes true", "56:10: the anchor yes is not allowed"),
    "anchor and alias": ("components: [core, base]\n", "components: &c [core, base]\n    extra: *c\n", "62:17: the anchor c is not allowed\n63:12: the alias c is not allowed"),
    "tag": ("lts: true", "lts: !!python/name:os.system true", "56:10: the tag tag:yaml.org,2002:python/name:os.system is not allowed"),
    "list for a key": ("lts: true", "? [a]\n    : true", "56:7: distributions.alpha: a key must be plain text"),
    "tab at the very start": ("version: 1\n", "\tversion: 1\n", "1:1: not YAML: this line is indented with a tab"),
    "a range without quotes": ('numpy: ">=2.2,<2.3"', "numpy: >=2.2,<2.3", "22:13: not YAML: did not find expected comment or line break"),
    "tab": ("    lts: true", "\tlts: true", "56:1: not YAML: found a tab character that violates indentation"),
    "open brace": ("lts: true", "lts: {", "58:3: not YAML: did not find expected ',' or '}'"),
    "no space after a colon": ("lts: true", "lts:true", "56:5: not YAML: could not find expected ':'"),
    "no space after the first colon": ("    os: ubuntu-24.04\n    ros: 2", "    os:ubuntu-24.04\n    ros: 2", "51:8: not YAML: mapping values are not allowed in this context"),
    "another indentation": ("    lts: true", "   lts: true", "56:4: not YAML: did not find expected key"),
    "architecture that is none of BuildKit's": ("arm64: {platform: linux/arm64,", "arm64: {platform: linux/arm/v7,", "7:11: architectures.arm64.platform: BuildKit calls the architecture of linux/arm/v7 'arm', and locks are found by that name"),
    "second document": ("distributions:", "---\ndistributions:", "48:1: not YAML: but found another document"),
    "control character": ("lts: true", "lts: \x07", "56:10: a character that YAML does not allow"),
    "three mistakes far apart": (SMALL, changed("lts: true", "lts: 1", changed("os: ubuntu-24.04", "os: debian", changed("core: {meta", "core: {mata"))), "27:10: components.core.matapackage: unknown key 'matapackage'\n56:5: distributions.alpha.lts: expected true or false"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "edit", "starts"), WRONG.values(), ids=WRONG)
def test_a_mistake_has_its_place_and_its_reason(text: str, edit: str, starts: str) -> None:
    with pytest.raises(InputError) as caught:
        parse(changed(text, edit))
    lines = str(caught.value).split("\n")
    for line, start in zip(lines, starts.split("\n"), strict=True):
        assert line.startswith(f"matrix.yaml:{start}")
    assert caught.value.exit_code == 2
    assert all("; " in line for line in lines if "not YAML" in line), "the parser's words need a remedy"


@pytest.mark.parametrize(
    ("text", "edit"),
    [
        ("    2.20.0: {python", "    2.20.0: {index: 'https://me:{}@packages.test/simple', python"),
        ("registry: localhost:5000", "registry: https://me:{}@localhost"),
        ("registry: localhost:5000", "registry: me:{}@localhost"),
        ("live: http://", "live: http://{}@"),
        ("https://example.org/images", "https://me:{}@example.org/images"),
        ("registry: localhost:5000\n", "registry: localhost:5000\nprivate: ['me:{0}@a', 'me:{0}@a']\n"),
    ],
)
@pytest.mark.parametrize("password", ["secret", "secret/1", "secret@1", "x:secret", "secret 1"])
def test_the_password_of_an_address_is_masked(text: str, edit: str, password: str) -> None:
    with pytest.raises(InputError) as caught:
        parse(changed(text, edit.replace("{0}", password).replace("{}", password)))
    assert "***@" in str(caught.value) and "secret" not in str(caught.value)


CONTENT = {
    "empty": (b"", "1:1: the file is empty; it needs at least 'version: 1'"),
    "text": (b"hello", "1:1: expected keys and values, such as 'version: …', found 'hello'"),
    "list": (b"- 1\n- 2\n", "1:1: expected keys and values"),
    "null": (b"~", "1:1: expected keys and values"),
    "not UTF-8": (b"version: 1\nsource: \xff", "2:9: not UTF-8 (byte 0xff)"),
    "UTF-16": ("version: 1".encode("utf-16"), "1:1: not UTF-8"),
    "NUL": (b"version: \x00", "1:10: a character that YAML does not allow"),
    "bomb": (b"a: &a [x]\nb: [*a, *a]", "1:4: the anchor a is not allowed"),
    "nested without end": (b"a: " + b"[" * 1_500 + b"]" * 1_500, "1:103: not YAML: nested more than 100 levels deep"),
    "too large": (b"#" * (source.LARGEST + 1), "1:1: the file has more than 1024 kB"),
}


@pytest.mark.parametrize(("content", "start"), CONTENT.values(), ids=CONTENT)
def test_a_file_that_is_no_matrix(content: bytes, start: str) -> None:
    with pytest.raises(InputError) as caught:
        load.image_set(source.parse(content))
    assert str(caught.value).startswith(f"matrix.yaml:{start}")


def test_byte_order_mark() -> None:
    assert load.image_set(source.parse(b"\xef\xbb\xbf" + SMALL.encode())).images


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("none.yaml", "no such file"),
        (".", "Is a directory"),
        ("loop.yaml", "symbolic links"),
        ("a\0b", "cannot be read"),
    ],
)
def test_a_file_that_cannot_be_read(name: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "loop.yaml").symlink_to("loop.yaml")
    with pytest.raises(RosmlError, match=reason) as caught:
        load.load(tmp_path / name)
    assert caught.value.exit_code == 2 and caught.value.remedy


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


def patterns(content: object) -> set[str]:
    """Every pattern of a JSON schema."""
    if isinstance(content, dict):
        pattern = {content["pattern"]} if isinstance(content.get("pattern"), str) else set()
        return pattern.union(*map(patterns, content.values()))
    return set[str]().union(*map(patterns, content)) if isinstance(content, list) else set()


def test_every_pattern_has_a_meaning() -> None:
    """Without it a wrong value of that kind says only that text was expected."""
    of_schema = patterns(model.Matrix.model_json_schema())
    assert len(of_schema) > 10
    assert of_schema - MEANING.keys() == set()
