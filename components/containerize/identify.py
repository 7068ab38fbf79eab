#!/usr/bin/env python3
"""Which packages of the operating system ROS packages need: their package.xml, and rosdep's lists.

    identify.py MANIFESTS LEFT_OUT INDEX SCRATCH OUT

OUT gets sorted lists `packages/KIND.WAY` for each kind of dependency (build, exec, test) and each way to install it (apt, pip);
`downstream/downstream.WAY`, the same for packages that use the others; and `dependencies.json`: what each key of rosdep became, and who
asked for it. The ROS packages of the list LEFT_OUT do not count.

Keys are looked up in the lists of INDEX, such as a checkout of ros/rosdistro, and of the image. If INDEX is empty and these do not know
all keys, the network is asked.
"""

from __future__ import annotations

import difflib
import json
import os
import re
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path
from typing import AbstractSet, Dict, Iterable, Iterator, NamedTuple, NoReturn, Set

import manifests
from manifests import fail
from rosdep2 import RosdepLookup, create_default_installer_context, get_default_installer
from rosdep2.lookup import ResolutionError
from rosdep2.rospkg_loader import DEFAULT_VIEW_KEY
from rosdep2.sources_list import SourcesListLoader

KINDS = {
    "build": ("buildtool_depends", "build_depends", "buildtool_export_depends", "build_export_depends"),
    "exec": ("exec_depends",),
    "test": ("test_depends",),
}
"""What a manifest calls dependencies of a kind."""

DOWNSTREAM = "downstream"
"""The folder of packages that use the others, and the one kind of what they need: they are in no image."""

NAME = re.compile(r"[A-Za-z0-9][!-~]*")
"""A package of apt or pip. Options of these programs begin with a dash."""

INSTALLERS = ("apt", "pip")
"""Of rosdep's, those that an image can have."""

SOURCES = Path("/etc/ros/rosdep/sources.list.d")

EMPTY = "empty.yaml"
"""An index of distributions that has none."""

BUSY = re.compile(r"HTTP Error (429|500|502|503|504)\b")
PAUSES = (1, 3)
"""Seconds before a server is asked again that gave such an answer."""

DEBIAN = "10-debian.list"
"""Of Debian's rosdep: it calls Debian's own packages of ROS 1 by names that ROS 2 has as well."""

PROGRAMS = {"libnodeletlib-dev": "libnodeletlib-tools"}
"""What Debian's rosdep forgets: the package with programs of this one and its package.xml, without which nothing loads a nodelet."""

ROS = Path("/opt/ros", os.environ.get("ROS_DISTRO", ""))
"""Where ROS is, if it is not in the system's own folders."""

WORKSPACES = (Path(os.environ.get("WORKSPACE", "/docker-ros/ws")), Path("/opt/ws_base_image"), ROS)
"""Where a base image may have built packages. Images for Jetson have all of ROS in the last one, as `install`."""

Packages = Dict[str, Dict[str, Set[str]]]
"""Keys of rosdep that packages ask for, by package and kind."""


class Answer(NamedTuple):
    """What a key became."""

    installer: str
    names: tuple[str, ...]


class NoWay(Exception):
    """A rule that no image can follow, which is the message."""


def read(folder: Path, left_out: Path) -> Packages:
    """What each package needs: its keys of rosdep by kind."""
    context = {name: os.environ.get(name, "") for name in ("ROS_DISTRO", "ROS_VERSION")}
    context["ROS_DISTRO"] = os.environ.get("CONDITIONS") or context["ROS_DISTRO"]
    context["ROS_PYTHON_VERSION"] = os.environ.get("ROS_PYTHON_VERSION", "3")
    packages: Packages = {}
    for path, package in manifests.packages(folder, left_out):
        try:
            package.evaluate_conditions(context)
        except Exception as error:  # whatever pyparsing raises
            fail(f"{path}: {str(error)[:500] or type(error).__name__}", "check its conditions")
        kinds = {
            kind: {
                dependency.name
                for attribute in attributes
                for dependency in getattr(package, attribute)
                if dependency.evaluated_condition
            }
            for kind, attributes in KINDS.items()
            if kind != "test" or path.parts[:1] != ("upstream",)  # tests of these do not run
        }
        if path.parts[:1] == (DOWNSTREAM,):
            kinds = {DOWNSTREAM: set().union(*kinds.values())}
        packages[package.name] = kinds
    return packages


def provided() -> set[str]:
    """ROS packages that are built in the base image, or that it has as Python wheels."""
    patterns = ("install/share/*/package.xml", "install/*/share/*/package.xml")  # merged, and each in its folder
    manifests_of_base = (path for place in WORKSPACES for pattern in patterns for path in place.glob(pattern))
    names = {path.parent.name for path in manifests_of_base}
    wheels = ROS.glob("lib/python3*/site-packages/ros_*.dist-info")
    return names | {path.name[len("ros_") :].partition("-")[0] for path in wheels}


def reasons(output: str) -> str:
    """What a call of rosdep says went wrong: all addresses that failed, those with the same reason together."""
    by_reason: defaultdict[str, list[str]] = defaultdict(list)
    for address, why in dict.fromkeys(re.findall(r"unable to process source \[(.*)\]:\n\s*(.*)", output)):
        by_reason[why.replace(f"({address})", "").strip()].append(address)
    if by_reason:
        return "; ".join(f"{', '.join(dict.fromkeys(addresses))}: {why}" for why, addresses in by_reason.items())
    lines = [line for line in map(str.strip, output.split("\n")) if line not in ("", "[[[", "]]]")]
    return lines[-1] if lines else ""


def failure(command: list[str], environment: dict[str, str]) -> str:
    """Why a call of rosdep failed; empty if it did not. A server that is too busy is asked again."""
    for pause in (*PAUSES, 0):
        done = subprocess.run(command, env=environment, capture_output=True)
        output = done.stderr.decode(errors="replace")
        if not (done.returncode and pause and BUSY.search(output)):
            break
        time.sleep(pause)
    return (reasons(output) or f"rosdep ended with {done.returncode}") if done.returncode else ""


class Rosdep:
    """rosdep's lists: those of a folder and of the image; then those of the network, if the folder is empty."""

    def __init__(self, index: Path, scratch: Path) -> None:
        self._index, self._scratch = index, scratch
        self._may_ask = not any(index.iterdir())
        # Debian's own ROS 1 is in no index of distributions.
        self._distribution = os.environ.get("ROS_DISTRO", "").replace("Debian", "")
        self.failure = ""
        os.environ["ROS_HOME"] = str(scratch / "ros")
        self._update(self._local(), self._own_index())
        if self.failure:
            fail(f"rosdep's lists cannot be read: {self.failure}", "check them, and the folder of --rosdep-index")

    def find(self, key: str) -> list[Answer]:
        """What a key becomes, with what its rule depends on. KeyError: no list has it, nor has the network. NoWay: no image can have it."""
        try:
            return list(self._resolve(key))
        except KeyError:
            if not self._may_ask:
                raise
        self._may_ask = False
        self._update("", "")
        return list(self._resolve(key))

    def why_not(self, key: str, others: Iterable[str]) -> tuple[str, bool]:
        """Why no list has a key, and whether some have it for other systems. `others`: more names that somebody may have meant."""
        system, version, installers, _ = self._platform
        try:
            rules = self._view.lookup(key).data
        except KeyError:
            near = difflib.get_close_matches(key, {*self._view.keys(), *others}, 3, 0.8)
            return f"there is {' or '.join(near)}" if near else "no list has it", False
        systems = [name for name, rule in rules.items() if rule is not None and name != system]
        rule_here = rules.get(system)
        if isinstance(rule_here, dict) and not any(installer in rule_here for installer in installers):
            systems += [f"{system} {name}" for name, rule in rule_here.items() if rule is not None and name != version]
        return f"there is one for {', '.join(map(str, systems)) or 'no other system'}", True

    @property
    def system(self) -> str:
        return f"{self._platform[0].capitalize()} {self._platform[1]}"

    def _resolve(self, key: str, above: tuple[str, ...] = ()) -> Iterator[Answer]:
        if key in above:
            fail(f"rosdep's lists are wrong about {key}: it depends on itself", "correct them")
        try:
            rule_installer, rule = self._view.lookup(key).get_rule_for_platform(*self._platform)
            if rule_installer not in INSTALLERS:  # one of sources would ask the network now
                raise NoWay(f"{rule_installer}: {json.dumps(rule, default=str)[:200]}")
            installer = self._context.get_installer(rule_installer)
            names = tuple(str(name) for name in installer.resolve(rule))
            others = [str(other) for other in installer.get_depends(rule)]
        except (KeyError, ResolutionError):
            raise KeyError(key) from None
        except NoWay:
            raise
        except Exception as error:  # rosdep takes its lists to have the right shape
            fail(f"rosdep's lists are wrong about {key}: {str(error)[:500] or type(error).__name__}", "correct them")
        if wrong := [name for name in names if not NAME.fullmatch(name)]:
            fail(f"rosdep's lists are wrong about {key}: {wrong[0][:100]!r} is no package", "correct them")
        yield Answer(rule_installer, (*names, *(PROGRAMS[name] for name in names if name in PROGRAMS)))
        for other in others:
            yield from self._resolve(other, (*above, key))

    def _local(self) -> str:
        """A folder with the lists that are files: the image's and the folder's."""
        folder = self._scratch / "sources"
        folder.mkdir()
        for path in sorted(SOURCES.glob("*.list")):
            if path.name == DEBIAN and os.environ.get("ROS_VERSION") != "1":
                continue
            lines = [line for line in path.read_text("utf-8", "replace").split("\n") if line.startswith("yaml file:")]
            (folder / path.name).write_text("\n".join(lines) + "\n")
        listed = [f"yaml file://{path}" for path in sorted(self._index.glob("rosdep/*.yaml"))]
        (folder / "00-index.list").write_text("\n".join(listed) + "\n")
        return str(folder)

    def _own_index(self) -> str:
        """The address of the index of distributions: the folder's, or of an empty one."""
        index_file = self._index / "index-v4.yaml"
        if self._distribution and index_file.exists():
            return f"file://{index_file}"
        empty = self._scratch / EMPTY
        empty.write_text("%YAML 1.1\n---\ndistributions: {}\ntype: index\nversion: 4\n")
        return f"file://{empty}"

    def _update(self, sources: str, index: str) -> None:
        """Reads lists and index, from the network if they are empty."""
        command = ["rosdep", "update"]
        if self._distribution and not index.endswith(EMPTY):
            command.append(f"--rosdistro={self._distribution}")
        variables = {"ROSDEP_SOURCE_PATH": sources, "ROSDISTRO_INDEX_URL": index} if index else {}
        self.failure = failure(command, {**os.environ, **variables}) or self.failure
        try:
            lookup = RosdepLookup.create_from_rospkg(sources_loader=SourcesListLoader.create_default())
            self._view = lookup.get_rosdep_view(DEFAULT_VIEW_KEY)
        except Exception as error:
            fail(f"rosdep's lists cannot be read: {str(error)[:500] or type(error).__name__}", "correct them")
        self._context = create_default_installer_context()
        _, keys, default, system, version = get_default_installer(self._context)
        self._platform = system, version, keys, default


def answers(
    packages: Packages, skipped: set[str], rosdep: Rosdep, plain: AbstractSet[str] = frozenset()
) -> dict[str, list[Answer]]:
    """What each key became that is no package of the workspace. Ends the program if no list has some.

    Args:
        plain: packages of the workspace without a manifest. rosdep may know another package of that name.
    """
    asking: defaultdict[str, set[str]] = defaultdict(set)
    for package, kinds in packages.items():
        for key in set().union(*kinds.values()) - packages.keys() - skipped:
            asking[key].add(package)
    rules, unknown = {}, []
    for key in sorted(asking):
        try:
            rules[key] = rosdep.find(key)
        except KeyError:
            if key not in plain:
                unknown.append(key)
        except NoWay as rule:
            fail(
                f"rosdep's rule for {key}, which {', '.join(sorted(asking[key]))} asks for, is not one of apt or pip: {rule}",
                f"install it in docker/custom.sh, and leave it out with --skip-keys {key}",
            )
    if unknown:
        explain({key: asking[key] for key in unknown}, packages, rosdep)
    return rules


OTHER = {
    "1": re.compile(r"ament_.+|rcl(cpp|py)(_.+)?|rosidl_.+|ros2(cli|launch|run|bag.*)|launch_ros"),
    "2": re.compile(r"catkin|ros(cpp|py|lib|launch|bash|core)|message_(generation|runtime)|nodelet|roslaunch"),
}
"""By the ROS of the base image: keys that packages of the other one ask for."""

SHOWN = 12
"""The most keys to tell one by one: people see the last lines of a step."""


def explain(unknown: dict[str, set[str]], packages: Iterable[str], rosdep: Rosdep) -> NoReturn:
    """Ends the program with one error: the reason for each unknown key, which comes with those that ask for it, and what to do."""
    version = os.environ.get("ROS_VERSION", "")
    foreign_keys = [key for key in unknown if version in OTHER and OTHER[version].fullmatch(key)]
    foreign = {name for key in foreign_keys for name in unknown[key]}
    if foreign:  # their keys are for the other ROS, which is all to say of them
        unknown = {key: names for key, names in unknown.items() if names - foreign}
    elsewhere, texts = [], []
    for key, names in unknown.items():
        why, ruled = rosdep.why_not(key, packages)
        elsewhere += [key] if ruled else []
        what = f"has no rule for {key} on {rosdep.system}" if ruled else f"does not know {key}"
        why = "" if rosdep.failure and not ruled else f" ({why})"  # lists that were not fetched may have it
        texts.append(f"rosdep {what}, which {', '.join(sorted(names))} {'asks' if len(names) == 1 else 'ask'} for{why}")
    if len(texts) > 1 or (texts and (foreign or rosdep.failure)):
        more = [f"and {len(texts) - SHOWN} keys more"] if len(texts) > SHOWN else []
        print("\n".join([*texts[:SHOWN], *more]), file=sys.stderr)
    if foreign:
        other = {"1": "2", "2": "1"}[version]
        fail(
            f"the base image has ROS {version}, and {', '.join(sorted(foreign))} {'asks' if len(foreign) == 1 else 'ask'} for packages of ROS {other}",
            f"name a base image with ROS {other} by --base-image; or leave them out: put COLCON_IGNORE into their folders,"
            " or name them in docker/blacklisted-packages.txt",
        )
    skip = f"--skip-keys '{' '.join(elsewhere or unknown)}'"
    if rosdep.failure:
        fail(
            f"rosdep's lists could not be fetched: {rosdep.failure}; those of the image do not know all keys",
            "check the network; or name lists with --rosdep-index, such as a checkout of ros/rosdistro; or name packages of apt in"
            f" docker/additional-debs.txt, and skip their keys: {skip}",
        )
    fail(
        texts[0] if len(texts) == 1 else f"rosdep knows no package for {len(texts)} of the keys",
        "correct a wrong name in package.xml; put a package that is missing into a .repos file, or name other lists with --rosdep-index;"
        f" or leave out what your packages run without: {skip}",
    )


def main(folder: Path, left_out: Path, index: Path, scratch: Path, out: Path) -> None:
    packages = read(folder, left_out)
    skipped = set(re.split(r"[\s,]+", os.environ.get("SKIP_KEYS", ""))) - {""}
    answers_by_key = answers(packages, skipped | provided(), Rosdep(index, scratch), manifests.plain(folder))
    lists: defaultdict[str, set[str]] = defaultdict(set)
    for kinds in packages.values():
        for kind, keys in kinds.items():
            for answer in (answer for key in keys if key in answers_by_key for answer in answers_by_key[key]):
                lists[f"{kind}.{answer.installer}"].update(answer.names)
    for place, called in (("packages", tuple(KINDS)), (DOWNSTREAM, (DOWNSTREAM,))):
        (out / place).mkdir(parents=True)
        for name in (f"{kind}.{installer}" for kind in called for installer in INSTALLERS):
            (out / place / name).write_text("".join(f"{package}\n" for package in sorted(lists[name])))
    described = {
        "packages": {
            name: {kind: sorted(keys) for kind, keys in kinds.items()}
            for name, kinds in sorted(packages.items())
            if DOWNSTREAM not in kinds
        },
        "keys": {key: [answer._asdict() for answer in answers_by_key[key]] for key in sorted(answers_by_key)},
        "skipped": sorted(skipped),
    }
    (out / "dependencies.json").write_text(json.dumps(described, indent=2, sort_keys=True) + "\n")
    print(f"{len(packages)} packages, {len(answers_by_key)} keys of rosdep")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
