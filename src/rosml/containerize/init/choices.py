"""Which base image and command fit the packages of a folder: a proposal with its reason for each, unless the user chooses."""

from __future__ import annotations

import contextlib
import datetime
import re
import shlex
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, unknown
from rosml.containerize import inputs as app_inputs
from rosml.containerize.init import contents, spoken
from rosml.containerize.init.packages import Found
from rosml.containerize.packages.manifest import Package
from rosml.images.image_set import explain, missing
from rosml.images.image_set.expand import FLOATING
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import names, rules
from rosml.images.matrix.model import Matrix
from rosml.run.plugins.gpu import numbers

DEBIAN = "noetic"
"""The distribution whose name conditions in package.xml compare with if ROS 1 is Debian's own (docs/containerize.md, rosdep)."""

SHELL = "bash"

CUPY, CUDA, OPENCV = "CuPy", "CUDA", "OpenCV"

OTHERS = {
    CUPY: ("cupy",),
    CUDA: ("cuda",),
    OPENCV: ("opencv", "opencv2", "cv2", "libopencv", "cv_bridge"),
}
"""Libraries that no part brings, and the words for each."""

_PIP = f"a line in {app_inputs.default('additional-pip-file')}"

LACKING = {
    CUPY: ("no package.xml does", _PIP),
    CUDA: (
        "base images have CUDA's libraries, and no nvcc",
        "if it is to be compiled, take the add-on devel on a stack with CUDA 13 (docs/addons/devel.md), or NVIDIA's image with -devel"
        " as BASE_IMAGE: containerize installs ROS on it",
    ),
    OPENCV: (
        "no package.xml does",
        "write <depend>libopencv-dev</depend> for C++, <depend>python3-opencv</depend> for Python",
    ),
}
"""What is missing if only sources name them, and the remedy."""


@dataclass(frozen=True)
class Choice:
    """A value, and why it is proposed or taken, in one clause."""

    value: str
    reason: str


@dataclass(frozen=True)
class Given:
    """What the user says; empty if nothing, and None for `gpu`."""

    distribution: str = ""
    component: str = ""
    framework: str = ""
    stack: str = ""
    gpu: bool | None = None
    command: str = ""


@dataclass(frozen=True)
class Here:
    """What counts of this machine and of the folder's repository.

    Attributes:
        today: the day, for ends of life.
        env: the variables of the folder's `.env`.
        hints: words among which are names of ROS distributions, the most telling first, and what has them.
        nvidia: there is an NVIDIA GPU with its driver.
        driver: the driver's version; empty if unknown.
    """

    today: datetime.date
    env: Mapping[str, str] = field(default_factory=dict)
    hints: tuple[tuple[frozenset[str], str], ...] = ()
    nvidia: bool = False
    driver: str = ""


_BEFORE = ".env says so"

Ask = Callable[[str, Choice, Sequence[str], Callable[[str], str]], str]
"""Asks the user: the question, the proposal, all possible answers if they can be counted, and what reads an answer, which raises
RosmlError for one that cannot be. Returns the answer that was read."""


@dataclass(frozen=True)
class Decided:
    """What is decided.

    Attributes:
        choices: what was chosen, by the name of the question, with the reason.
        image: the base image.
        command: what the run image starts.
        ended: the end of life of the distribution has passed.
        notes: sentences for the user, each with a remedy.
        keys: keys of rosdep that manifests name, for what the base image has.
        addons: the add-ons that sources name, as `containerize --addons` takes them.
    """

    choices: Mapping[str, Choice]
    image: Image
    command: str
    ended: bool
    notes: tuple[tuple[str, str], ...] = field(default=())
    keys: tuple[str, ...] = ()
    addons: tuple[str, ...] = ()


def libraries(matrix: Matrix) -> dict[str, set[str]]:
    """The libraries to look for: what the parts of the matrix bring, by title, and others. Each with the words for it."""
    found: dict[str, set[str]] = {}
    for part in matrix.parts:
        if part.title and part.release:
            beside = {
                name for release in matrix.releases.get(part.release or "", {}).values() for name in release.beside
            }
            found[part.title] = {part.name, f"lib{part.name}", part.title.lower(), *beside}
    return found | {name: set(words) for name, words in OTHERS.items()}


def brought(matrix: Matrix, image: Image, keys: Collection[str]) -> set[str]:
    """Those of rosdep's keys that stand for Python packages which parts of an image bring, such as `python3-torch`; and for ROS packages
    that an image has as wheels."""
    families = rules.families(matrix, matrix.frameworks[image.framework])
    has = {*families, *rules.company(matrix, image.stack, families)}
    has |= {part.title.lower() for part in matrix.parts if part.title and part.release in families}
    found = {key: re.fullmatch(r"python3?-(.+?)(-gpu)?(-pip)?", key) for key in keys}
    wheels = set[str]()
    for lock in image.locks if image.wheels else ():
        with contextlib.suppress(OSError):
            names_in_lock = re.findall(r"^ros-([a-z0-9-]+)==", (ROOT / lock).read_text(), re.MULTILINE)
            wheels |= {name.replace("-", "_") for name in names_in_lock}
    return {key for key, match in found.items() if key in wheels or (match and match[1] in has)}


def decide(image_set: ImageSet, found: Found, given: Given, here: Here, ask: Ask) -> Decided:
    """Decides by what the user says, and proposes the rest.

    Raises:
        RosmlError: the packages are for different ROS, or the user names what does not exist or fit (exit code 2).
    """
    return _Decision(image_set, found, given, here, ask).made()


class _Decision:
    def __init__(self, image_set: ImageSet, found: Found, given: Given, here: Here, ask: Ask) -> None:
        self._set, self._matrix, self._found, self._here, self._ask = image_set, image_set.matrix, found, here, ask
        if given.stack.lower() in spoken.NVIDIA and given.gpu is None:
            given = replace(given, stack="", gpu=True)
        if given.stack.lower() in spoken.NOTHING and not given.gpu:
            given = replace(given, stack="", gpu=False)
        self._given = given if not given.framework else replace(given, framework=self._named_framework(given.framework))
        self._before = image_set.by_tag(here.env.get("BASE_IMAGE", ""))
        self._notes: list[tuple[str, str]] = []

    def made(self) -> Decided:
        row = self._distribution()
        component = self._component(row.value)
        framework = self._framework(row.value, component.value)
        stack = self._stack(row.value, component.value, framework.value)
        target = names.image_target(row.value, component.value, framework.value, stack.value or None)
        image = self._set.by_target[target]
        command = self._command(row.value)
        others = (package for package in self._found.packages if not package.is_python)
        if self._matrix.distributions[row.value].wheels and (package := next(others, None)):
            text = f"{row.value} builds packages of Python alone, and {package.manifest} is none"
            self._notes.append(
                (text, "take another distribution, or leave the package out: put COLCON_IGNORE into its folder")
            )
        if not image.locked:
            self._notes.append((f"{target} cannot be built yet: {missing.reason(image)}", missing.remedy(image)))
        for library, (lacks, remedy) in LACKING.items():
            at = self._found.named.get(library)
            if at and not at.manifest and not (self._found.pip and remedy == _PIP):
                self._notes.append((f"{at.place} names {at.word}, and {lacks}", remedy))
        choices = {
            "distribution": row,
            "component": component,
            "framework": framework,
            "accelerator": stack,
            "command": command,
        }
        keys = brought(self._matrix, image, {key for package in self._found.packages for key in package.needs})
        addons = tuple(self._addons(row.value, image))
        notes = tuple(self._notes)
        return Decided(choices, image, command.value, self._ended(row.value), notes, tuple(sorted(keys)), addons)

    def _addons(self, row: str, image: Image) -> Iterator[str]:
        """The add-ons whose libraries sources name and the base image lacks, if a stack has them. With a list for pip, none: it says what
        the packages get."""
        if self._found.pip:
            return
        matrix, has = self._matrix, {name.rpartition("-")[0] for name in image.parts}
        for addon, facts in matrix.addons.items():
            parts = [matrix.part[name] for name in facts.parts]
            at = next((at for part in parts if (at := self._found.named.get(part.title or ""))), None)
            if at is None or any(name.startswith(facts.parts[-1]) for name in has):
                continue
            gpu = at.word.lower().endswith("gpu")
            stacks = (
                [image.stack]
                if image.stack
                else sorted(matrix.stacks, key=lambda s: bool(matrix.stacks[s].cuda) != gpu)
            )
            reasons = {stack: rules.stack_reason(matrix, row, image.framework, stack, addon) for stack in stacks}
            there = next((stack for stack, reason in reasons.items() if reason is None), None)
            if there is None:
                why = next(filter(None, reasons.values()), "")
                self._notes.append((f"{at.place} names {at.word}, and {why}", _PIP))
                continue
            yield addon if image.stack else f"{addon}-{there}"
            told = f"{at.place} names {at.word}: containerize adds the add-on {addon}"
            self._notes.append((told, "a Dockerfile gets it by the lines in docs/addons.md"))

    # ---- Distribution ------------------------------------------------------------------------------------------------

    def _distribution(self) -> Choice:
        fitting = [name for name in self._matrix.distributions if self._fits(name)]
        if not fitting:
            raise self._mixed()
        name = self._given.distribution
        if name:
            name = self._fitting_row(name, fitting)
            chosen = Choice(name, self._supported(name))
        else:
            proposal = self._proposed(fitting)
            name = self._ask(
                "ROS distribution", proposal, self._sorted(fitting), lambda said: self._fitting_row(said, fitting)
            )
            chosen = proposal if name == proposal.value else Choice(name, self._supported(name))
        if self._ended(name):
            others = [other for other in self._sorted(fitting) if not self._ended(other)]
            remedy = f"if your packages allow it, take {listed(others[:3], 'or')}" if others else ""
            self._notes.append((f"{name} had its end of life on {self._matrix.distributions[name].eol}", remedy))
        return chosen

    def _fits(self, name: str, packages: Collection[Package] = ()) -> bool:
        """Whether packages are for a distribution; all of them if none is named."""
        facts = self._matrix.distributions[name]
        words = facts.ros_distro or name
        words = DEBIAN if facts.ros == 1 and words not in self._matrix.distributions else words
        return all(package.fits(facts.ros, words) for package in packages or self._found.packages)

    def _mixed(self) -> RosmlError:
        by_ros = {
            ros: next((package for package in self._found.packages if self._only(package) == ros), None)
            for ros in (1, 2)
        }
        told = [f"{package.manifest} (ROS {ros})" for ros, package in by_ros.items() if package]
        if len(told) < 2:
            told = [
                package.manifest
                for package in self._found.packages
                if not any(self._fits(row, [package]) for row in self._matrix.distributions)
            ]
            return RosmlError(
                f"no distribution fits {listed(told) or 'all packages together'}",
                "check their build types",
                exit_code=2,
            )
        text = f"packages of ROS 1 and of ROS 2 do not build together: {listed(told)}"
        return RosmlError(text, "name the folder of some of them, or put COLCON_IGNORE into the others", exit_code=2)

    def _only(self, package: Package) -> int:
        """The ROS that a package is for, 1 or 2; 0 if it is for both or for none."""
        found = {facts.ros for name, facts in self._matrix.distributions.items() if self._fits(name, [package])}
        return found.pop() if len(found) == 1 else 0

    def _fitting_row(self, said: str, fitting: Sequence[str]) -> str:
        """The distribution that a word of the user means; the best one of several.

        Raises:
            RosmlError: there is none, or the packages are not for it (exit code 2).
        """
        rows, best = self._matrix.distributions, self._sorted(fitting)
        meant = spoken.distributions(self._matrix, said)
        if not meant:
            raise RosmlError(unknown("distribution", said, rows), f"take {listed(best, 'or')}", exit_code=2)
        if found := next((name for name in best if name in meant), ""):
            return found
        odd = next(package for package in self._found.packages if not self._fits(meant[0], [package]))
        text = f"{odd.manifest} is not for {meant[0]}, which is ROS {rows[meant[0]].ros}"
        raise RosmlError(text, f"take {listed(best, 'or')}", exit_code=2)

    def _proposed(self, fitting: Sequence[str]) -> Choice:
        before = self._before
        if before and before.distribution in fitting:
            return Choice(before.distribution, _BEFORE)
        alive = [name for name in self._sorted(fitting) if not self._ended(name)] or list(fitting)
        for words, told in self._here.hints:
            for name in alive:
                facts = self._matrix.distributions[name]
                if words.intersection((name, facts.ros_distro)):
                    return Choice(name, f"{told}; {self._supported(name)}")
        framework = self._given.framework or self._wanted().value
        best = next((name for name in alive if self._carries(name, framework)), alive[0])
        return Choice(best, self._supported(best))

    def _sorted(self, distributions: Collection[str]) -> list[str]:
        """Distributions, the best first: those of matrix.yaml's default, long-term ones, those with the longest support."""
        usual = {
            self._set.by_target[name].distribution
            for name in self._matrix.default.targets
            if name in self._set.by_target
        }

        def order(name: str) -> tuple[bool, bool, bool, bool, datetime.timedelta]:
            facts = self._matrix.distributions[name]
            support = datetime.date.max - (facts.eol or datetime.date.min)
            return self._ended(name), facts.experimental, name not in usual, not facts.lts, support

        return sorted(distributions, key=order)

    def _carries(self, distribution: str, framework: str) -> bool:
        """Whether a distribution has the framework with all locks, on the accelerator that this machine has or the user wants."""
        stacks = {
            image.stack
            for image in self._set.images
            if image.locked and (image.distribution, image.combination) == (distribution, framework)
        }
        wanted = self._here.nvidia if self._given.gpu is None else self._given.gpu
        with_cpu = any(
            not facts.cuda
            for facts in self._matrix.stacks.values()
            if facts.accelerator in self._accelerators(framework)
        )
        return any(stack is None or self._on_gpu(stack) == (wanted or not with_cpu) for stack in stacks)

    def _accelerators(self, framework: str) -> Collection[str]:
        facts = self._matrix.frameworks.get(framework)
        return facts.accelerators if facts else ()

    def _ended(self, name: str) -> bool:
        eol = self._matrix.distributions[name].eol
        return eol is not None and eol < self._here.today

    def _supported(self, name: str) -> str:
        facts = self._matrix.distributions[name]
        until = f"supported until {facts.eol}" if facts.eol else "without an end of life"
        until = f"without support since {facts.eol}" if self._ended(name) else until
        kind = ", experimental" if facts.experimental else ", long-term" if facts.lts else ""
        return f"ROS {facts.ros}{kind}, {until}"

    def _named_before(self, row: str) -> Image | None:
        """The base image that `.env` names, if it is of a distribution."""
        return self._before if self._before and self._before.distribution == row else None

    # ---- Component ---------------------------------------------------------------------------------------------------

    def _component(self, row: str) -> Choice:
        has = [name for name in self._matrix.distributions[row].components if not rules.only_runs(self._matrix, name)]
        rest = "the build installs what your packages need beyond it"

        def read(said: str) -> str:
            name = spoken.component(self._matrix, said)
            if name not in has:
                text = rules.component_reason(self._matrix, row, name) or f"{name} only runs programs that are built"
                raise RosmlError(text, f"take {listed(has, 'or')}", exit_code=2)
            return name

        if self._given.component:
            return Choice(read(self._given.component), rest)
        if (before := self._named_before(row)) and before.component in has:
            proposal = Choice(before.component, _BEFORE)
        else:
            proposal = Choice(FLOATING if FLOATING in has else has[0], rest)
            needs = {key: package for package in self._found.packages for key in package.needs}
            for name in has[has.index(proposal.value) + 1 :]:
                meta = (self._matrix.components[name].metapackage or name).replace("-", "_")
                if meta in needs:
                    proposal = Choice(name, f"{needs[meta].manifest} depends on {meta}")
        name = self._ask("How much of ROS", proposal, has, read)
        return proposal if name == proposal.value else Choice(name, rest)

    # ---- Framework ---------------------------------------------------------------------------------------------------

    def _wanted(self) -> Choice:
        """The smallest framework that brings what manifests and sources name."""
        matrix, named = self._matrix, self._found.named
        framed = {name for facts in matrix.frameworks.values() for name in facts.parts}
        asked = {part.name: at for part in matrix.parts if part.release and (at := named.get(part.title or ""))}
        needed = {name: at for name, at in asked.items() if name in framed}
        others = (at for name, at in asked.items() if name not in framed and at.word.lower().endswith("gpu"))
        at = named.get(CUPY) or next(others, None)
        if at and not needed:
            needed = {part.name: at for part in matrix.parts if part.versions}
        plain = rules.plain(matrix)
        if not needed:
            if self._asks_for_gpu():
                bare = self._smallest({part.name for part in matrix.parts if part.versions})
                return Choice(bare or plain, "you ask for a GPU, and no file names a framework")
            titles = [part.title for part in matrix.parts if part.title and part.release and part.name in framed]
            return Choice(plain, f"no package.xml and no source names {listed(titles, 'or')}")
        places = listed([f"{at.place} names {at.word}" for at in needed.values()])
        return Choice(self._smallest(needed.keys()) or plain, places)

    def _smallest(self, parts: Collection[str]) -> str:
        facts = self._matrix.frameworks
        return min(
            (name for name in facts if set(parts) <= set(facts[name].parts)),
            key=lambda name: len(facts[name].parts),
            default="",
        )

    def _framework(self, row: str, component: str) -> Choice:
        plain = rules.plain(self._matrix)
        there = [name for name in self._matrix.frameworks if name == plain or self._stacks(row, name)]

        def read(said: str) -> str:
            name = self._named_framework(said)
            if name not in self._matrix.frameworks:
                text = unknown("framework", name, self._matrix.frameworks)
                raise RosmlError(text, f"{row} has {listed(there)}", exit_code=2)
            if name not in there:
                raise RosmlError(self._lacking(row, component, name), f"{row} has {listed(there)}", exit_code=2)
            return name

        if self._given.framework:
            return Choice(read(self._given.framework), "you ask for it")
        if (before := self._named_before(row)) and (not self._asks_for_gpu() or before.stack):
            proposal = Choice(before.framework, _BEFORE)
        else:
            proposal = self._wanted()
        if proposal.value not in there:
            self._notes.append(
                (self._lacking(row, component, proposal.value), "take another distribution, or install it in the image")
            )
            proposal = Choice(plain, f"{row} has no {proposal.value}")
        name = self._ask("Framework for machine learning", proposal, there, read)
        return proposal if name == proposal.value else Choice(name, "you ask for it")

    def _named_framework(self, said: str) -> str:
        """The smallest framework with all that a text of the user names; the text itself if that is none."""
        named = spoken.frameworks(self._matrix, said)
        if [name.lower() for name in named] in [[word] for word in spoken.NVIDIA]:
            return self._smallest({part.name for part in self._matrix.parts if part.versions})
        facts = self._matrix.frameworks
        if not named or not set(named) <= facts.keys():
            return " ".join(named) or said
        return self._smallest({part for name in named for part in facts[name].parts})

    def _lacking(self, row: str, component: str, framework: str) -> str:
        """Why there is no framework on a distribution, on the wanted kind of accelerator."""
        told = explain.why_not(self._set, f"{row}-{component}-{framework}") if self._given.gpu is None else None
        asked = {None: "", True: " for GPUs", False: " for the CPU"}[self._given.gpu]
        return (told or f"{row} has no {framework}{asked}").rstrip(".")

    # ---- Accelerator -------------------------------------------------------------------------------------------------

    def _on_gpu(self, stack: str) -> bool:
        return bool(self._matrix.stacks[stack].cuda)

    def _asks_for_gpu(self) -> bool:
        """Whether the user asks for one, or for a stack that needs one."""
        stack = self._given.stack
        return bool(self._given.gpu or (stack in self._matrix.stacks and self._on_gpu(stack)))

    def _may(self, stack: str | None) -> bool:
        """Whether the user allows a stack."""
        if stack is None or self._given.gpu is None:
            return True
        return self._on_gpu(stack) == self._given.gpu

    def _stacks(self, row: str, framework: str) -> list[str]:
        """The stacks of a framework that the user allows, the default of the distribution first."""
        if not self._matrix.frameworks[framework].parts:
            return []
        default = self._matrix.distributions[row].default_stacks
        there = [name for name in self._matrix.stacks if rules.stack_reason(self._matrix, row, framework, name) is None]
        return sorted(
            filter(self._may, there), key=lambda name: default.index(name) if name in default else len(default)
        )

    def _stack(self, row: str, component: str, framework: str) -> Choice:
        there = self._stacks(row, framework)

        def read(said: str) -> str:
            name = spoken.stack(self._matrix, said, there)
            if name not in self._matrix.stacks:
                text = unknown("accelerator", name, self._matrix.stacks)
                raise RosmlError(text, f"take {listed(there, 'or') or 'none'}; or --gpu or --cpu", exit_code=2)
            if name not in there:
                text = rules.stack_reason(self._matrix, row, framework, name) or f"{name} is not what you ask for"
                raise RosmlError(text, f"take {listed(there, 'or')}", exit_code=2)
            return name

        if not self._matrix.frameworks[framework].parts:
            if self._given.stack not in ("", *self._matrix.stacks):
                read(self._given.stack)
            if self._asks_for_gpu():
                with_gpu = [name for name, facts in self._matrix.frameworks.items() if facts.parts]
                raise RosmlError(
                    f"framework {framework} computes nothing on a GPU", f"take {listed(with_gpu, 'or')}", exit_code=2
                )
            return Choice("", "an image without a framework fits every machine")
        if self._given.stack:
            name = read(self._given.stack)
            return Choice(name, self._computes(name))
        if (before := self._named_before(row)) and before.framework == framework and before.stack in there:
            proposal = Choice(before.stack, _BEFORE)
        else:
            proposal = self._fitting(row, component, framework, there)
        name = self._ask("Accelerator", proposal, there, read)
        return proposal if name == proposal.value else Choice(name, self._computes(name))

    def _fitting(self, row: str, component: str, framework: str, there: Sequence[str]) -> Choice:
        """The stack for this machine; without a GPU here, the one for the CPU."""
        locked = [
            name for name in there if self._set.by_target[names.image_target(row, component, framework, name)].locked
        ]
        gpus = [name for name in locked or there if self._on_gpu(name)]
        others = [name for name in locked or there if not self._on_gpu(name)]
        if self._here.nvidia and gpus and (runs := [name for name in gpus if self._runs(name)]):
            told = f"this machine's driver {self._here.driver}" if self._here.driver else "this machine's GPU"
            return Choice(runs[0], f"{told} runs CUDA {self._matrix.stacks[runs[0]].cuda}")
        if others:
            why = "this machine has no NVIDIA GPU" if not self._here.nvidia else "this machine's driver runs no other"
            why = "you ask for the CPU" if self._given.gpu is False else f"{why}; --gpu for one that has"
            return Choice(others[0], why)
        first, *rest = gpus or list(there)
        older = next((name for name in rest if numbers(self._driver(name)) < numbers(self._driver(first))), "")
        hint = f"; for driver {self._driver(older)}: --accelerator {older}" if older else ""
        return Choice(first, self._computes(first) + hint)

    def _runs(self, stack: str) -> bool:
        """Whether the driver of this machine runs a stack; also if the driver is unknown."""
        return not numbers(self._here.driver) or numbers(self._here.driver) >= numbers(self._driver(stack))

    def _driver(self, stack: str) -> str:
        """The oldest driver that runs a stack; 0 if any does."""
        return self._matrix.drivers.get((self._matrix.stacks[stack].cuda or "").partition(".")[0], "0")

    def _computes(self, stack: str) -> str:
        cuda = self._matrix.stacks[stack].cuda or ""
        driver = self._matrix.drivers.get(cuda.partition(".")[0], "")
        return f"CUDA {cuda}" + (f", for driver {driver} or newer" if driver else "") if cuda else "for the CPU"

    # ---- Command -----------------------------------------------------------------------------------------------------

    def _command(self, row: str) -> Choice:
        """A launch file, or the only program of Python; a shell if neither is likely, as an image to run must start something."""
        if self._given.command:
            return Choice(_words(self._given.command), "you ask for it")
        if said := self._here.env.get("COMMAND"):
            return Choice(_words(said), _BEFORE)
        proposal = self._started(row)
        text = self._ask("Command to start", proposal, (), _words)
        return proposal if text == proposal.value else Choice(text, "you ask for it")

    def _started(self, row: str) -> Choice:
        facts = self._matrix.distributions[row]
        launches = [(package, file) for package in self._found.packages for file in package.launches]
        scripts = [(package, name) for package in self._found.packages for name in package.scripts]
        if facts.wheels:  # there is no command ros2, and no launch (docs/limits.md)
            if len(scripts) == 1:
                return Choice(_installed(*scripts[0]), f"the only program, by its path: {row} has no ros2")
            return Choice(SHELL, f"a shell, as {row} has no ros2; --command names another")
        launch, run = ("roslaunch", "rosrun") if facts.ros == 1 else ("ros2 launch", "ros2 run")
        for found, verb, why in (
            (launches, launch, "the only launch file"),
            (list(_likely(launches)), launch, "the likeliest launch file"),
            ([] if launches else scripts, run, "the only program"),
        ):
            if len(found) == 1:
                package, name = found[0]
                return Choice(f"{verb} {shlex.join((package.name, name))}", why)
        count = counted(*((len(launches), "launch file") if launches else (len(scripts), "program")))
        why = f"a shell, as there are {count}" if launches or scripts else "a shell"
        return Choice(SHELL, f"{why}; --command names another")


def _installed(package: Package, script: str) -> str:
    """The path at which colcon installs a program of a Python package whose setup.cfg is as ROS's tools write it."""
    return shlex.quote(f"{contents.INSTALLED}/{package.name}/lib/{package.name}/{script}")


def _words(command: str) -> str:
    """A command that a shell can read.

    Raises:
        RosmlError: it could not (exit code 2).
    """
    try:
        shlex.split(command)
    except ValueError as error:
        text = f"the command {command!r} is none that a shell reads: {str(error).lower()}"
        raise RosmlError(text, "close its quotation", exit_code=2) from None
    return command


def _likely(launches: Sequence[tuple[Package, str]]) -> Iterator[tuple[Package, str]]:
    """The launch files that start a whole robot, by their names: those of a package for bringing it up, or called like their package."""
    for package, file in launches:
        stem = re.sub(r"[._]launch.*$", "", file)
        if stem in ("bringup", "all", "main", package.name):
            yield package, file
