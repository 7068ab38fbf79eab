"""What speaks against another base image: facts of the app and of both base images, without a look into a layer.

docs/rebase.md has the rules in words, and what they cannot see.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.containerize.rebase import debian
from rosml.containerize.rebase.image import AGAIN
from rosml.images.image_set.labels import PREFIX
from rosml.images.join import facts as of_images
from rosml.images.join.facts import Facts, Library
from rosml.images.join.layers import Source

SAME = {"distribution": "ROS distribution", "os": "system", "python": "Python", "ros": "generation of ROS"}
"""The labels that the old and the new base image must have in common, by the words for people."""

FRAMEWORK = f"{PREFIX}framework"

VERSION = re.compile(r"[0-9]+(\.[0-9]+)+([+.-].*)?")
"""The value of a label with a version."""

DRIVER = re.compile(
    r"lib(cuda|nvcuvid|nvidia-[a-z0-9-]+|nvoptix|cudadebugger|GLX_nvidia|EGL_nvidia|dxcore)\.so(\.[0-9.]+)?"
)
"""Libraries that a driver brings when a container starts."""

OF_THE_SYSTEM = re.compile(r"(usr/)?lib(32|64)?/(?!python)([^/]+/)?[^/]+")
"""Places of a Debian system's own libraries: as long as a library has the same name, it keeps its interface (Debian's policy, 8.1)."""

GENERATED = re.compile(
    r"docker-ros/ws/install/(\.colcon_install_layout|_?(local_)?setup[^/]*|_order_packages\.py|_local_setup_util_\w+\.py)"
    r"|(.*/)?__pycache__/.*"
)
"""Files that each app has of its own, and Python's compiled files, which belong to their sources."""


BOTH = "the app and the base image both have /"
"""The beginning of the reason about a file that both have."""


class Verdict(IntEnum):
    """What to do about another base image."""

    SAFE = 0
    LINK = 1
    BUILD = 2


WORDS = {Verdict.SAFE: "safe", Verdict.LINK: "check by link", Verdict.BUILD: "build again"}


@dataclass
class Judgement:
    """A verdict with its reasons, the worst first."""

    verdict: Verdict = Verdict.SAFE
    reasons: dict[str, Verdict] = field(default_factory=dict)

    def add(self, verdict: Verdict, reason: str) -> None:
        """Adds a reason."""
        self.reasons[reason] = max(verdict, self.reasons.get(reason, verdict))
        self.verdict = max(self.verdict, verdict)

    def of(self, verdict: Verdict) -> list[str]:
        """The reasons for one verdict."""
        return [reason for reason, found in self.reasons.items() if found is verdict]

    @property
    def undecided(self) -> list[str]:
        """Why the app has to be linked before its tag moves; none if it is safe."""
        return self.of(Verdict.LINK)

    @property
    def words(self) -> str:
        """The verdict for people."""
        return WORDS[self.verdict]


def require_fit(app: Source, base: Source) -> None:
    """Checks that a base image is of the app's kind.

    Raises:
        RosmlError: it is not (exit code 2).
    """
    for name, words in SAME.items():
        old, new = (source.labels.get(PREFIX + name, "") for source in (app, base))
        if not new and not old:
            continue
        if not new:
            text = f"{base.name} does not say which {words} it has: it is no image of rosml with ROS"
            raise RosmlError(text, "name one, such as ros:jazzy-base", exit_code=2)
        if old != new:
            text = f"{app.name} was built on {words} {old or 'unknown'}, and {base.name} has {new}"
            raise RosmlError(text, f"name a base image with {old or 'the same'}; or {AGAIN}", exit_code=2)


def judge(
    app: Facts,
    old: Facts | None,
    new: Facts,
    files: tuple[Collection[str], Container[str]],
    labels: tuple[Mapping[str, str], Mapping[str, str]],
) -> Judgement:
    """Whether an app runs on another base image.

    Args:
        app: the facts of its layer.
        old: those of its present base image; None if they are gone.
        new: those of the new one.
        files: the files and the folders of the new base image.
        labels: of the app, and of the new base image.

    Raises:
        RosmlError: facts are damaged.
    """
    found = Judgement()
    try:
        _packages(app, new, found)
        _asked(app, new, found)
        if old:
            _vanished(app, old, new, found)
        _libraries(app, old, new, found)
    except ValueError as error:
        raise RosmlError(f"the facts of an image are damaged: {error}", AGAIN) from None
    _files(app, new, files, found)
    _imports(app, files[0], found)
    _asked_of_pip(app, files[0], found)
    _parts(app, labels, found)
    if old is None:
        found.add(
            Verdict.LINK,
            "the base image that the app was built on is gone, or has no facts beside it, so nobody can compare with it",
        )
    return found


# ---- Packages and files ----------------------------------------------------------------------------------------------


def _packages(app: Facts, new: Facts, found: Judgement) -> None:
    """What packages say of each other.

    Raises:
        ValueError: a field is damaged.
    """
    base, own = debian.Known(new.packages), debian.Known(app.packages)
    every = debian.Known([*new.packages, *app.packages])
    for package in app.packages:
        there = base.there(package.name)
        if there and there != package.version:
            found.add(Verdict.BUILD, f"the app has {package.name} {package.version}, and the base image has {there}")
            continue
        for alternatives in debian.relations(package.depends):
            if not every.met(alternatives):
                wanted = " | ".join(map(str, alternatives))
                has = [f"{item.name} {version}" for item in alternatives if (version := every.there(item.name))]
                lacks = f"the base image has {listed(has)}" if has else "the base image has none"
                found.add(Verdict.BUILD, f"{package.name} needs {wanted}, and {lacks}")
        for owner, named in base.conflicts(package):
            found.add(Verdict.BUILD, f"{package.name} cannot stand beside {named}, and the base image has {owner}")
    for package in new.packages:
        for owner, named in own.conflicts(package):
            text = f"{package.name} of the base image cannot stand beside {named}, and the app has {owner}"
            found.add(Verdict.BUILD, text)


def _asked(app: Facts, new: Facts, found: Judgement) -> None:
    """Packages that the app asked for by name. Its present base image has them, so they are not in its layer.

    Raises:
        ValueError: a field is damaged.
    """
    every = debian.Known([*new.packages, *app.packages])
    for name in app.asks:
        if name not in every:
            found.add(Verdict.BUILD, f"the app asked for {name}, which the base image lacks")


def _imports(app: Facts, files: Collection[str], found: Judgement) -> None:
    """Modules of its present base image that the app's Python imports."""
    modules = modules_of(files) if app.imports else ()
    for item in app.imports or ():
        if item.module not in modules:
            found.add(Verdict.BUILD, f"{item.file} imports {item.module}, which the base image lacks")


def _asked_of_pip(app: Facts, files: Collection[str], found: Judgement) -> None:
    """Packages of pip that the app asked for by name, and that its present base image has."""
    names = distributions_of(files) if app.asks_pip else ()
    for name in app.asks_pip:
        if name not in names:
            found.add(Verdict.BUILD, f"the app asked pip for {name}, which the base image lacks")


def distributions_of(files: Iterable[str]) -> set[str]:
    """The names of Python's packages, as indexes compare them, by the paths of an image's files."""
    names = {match[1] for path in files if (match := _DISTRIBUTION.search(path))}
    return {re.sub(r"[-_.]+", "-", name).lower() for name in names}


_DISTRIBUTION = re.compile(r"/(?:site|dist)-packages/([A-Za-z0-9._]+)(?:-[^/]*)?\.(?:dist|egg)-info(?:/|$)")


def modules_of(files: Iterable[str]) -> set[str]:
    """The first names of the modules in folders that Python looks into, by the paths of an image's files."""
    return {match[1] for path in files if (match := _MODULE.match(path))}


_MODULE = re.compile(
    r"(?:.*/(?:site|dist)-packages|(?:.*/)?(?:usr/(?:local/)?|opt/[^/]+/[^/]+/)?lib/python3(?:\.\d+)?(?:/lib-dynload)?)/([^/.]+)(?:[/.]|$)"
)


def _vanished(app: Facts, old: Facts, new: Facts, found: Judgement) -> None:
    """Packages that only the old base image has. Python and launch files may use them, and no list says so.

    Raises:
        ValueError: a field is damaged.
    """
    every = debian.Known([*new.packages, *app.packages])
    gone = sorted({package.name for package in old.packages if package.name not in every})
    if gone and app.imports != []:
        text = f"the base image until now has {_some(gone)}, and this one has not; the app's Python may use it"
        found.add(Verdict.LINK, text)


def _files(app: Facts, new: Facts, files: tuple[Container[str], Container[str]], found: Judgement) -> None:
    """Files that both have. Those of a package that both have in the same version are the same."""
    base = debian.Known(new.packages)
    paths = [path for package in app.packages if not base.there(package.name) for path in package.files]
    known: dict[str, str] = {}
    for path in (*paths, *app.files):  # a package that is there in another version was named already
        if GENERATED.fullmatch(path):
            continue
        if path in files[0]:
            found.add(Verdict.BUILD, f"{BOTH}{path}")
        elif path in files[1]:
            found.add(Verdict.BUILD, f"the app has a file /{path}, which is a folder in the base image")
        elif above := _file_above(path.rpartition("/")[0], files[0], known):
            found.add(Verdict.BUILD, f"the app has a folder /{above}, which is a file or a link in the base image")


def _file_above(folder: str, files: Container[str], known: dict[str, str]) -> str:
    """The folder that is a file, among a folder and those above it; empty if none is."""
    todo = []
    while folder and folder not in known and folder not in files:
        todo.append(folder)
        folder = folder.rpartition("/")[0]
    above = known.get(folder, folder)
    known |= dict.fromkeys(todo, above)
    return above


def _parts(app: Facts, labels: tuple[Mapping[str, str], Mapping[str, str]], found: Judgement) -> None:
    """Releases of parts, whose libraries have their names: one minor release runs no programs of another."""
    lost = [name.removeprefix(PREFIX) for name in labels[0] if name.startswith(PREFIX) and name not in labels[1]]
    lost = [name for name in lost if VERSION.fullmatch(labels[0][PREFIX + name])]
    if lost and labels[0].get(FRAMEWORK) != labels[1].get(FRAMEWORK) and app.imports != []:
        found.add(Verdict.LINK, f"this base image has no {listed(lost, 'or')}; the app's Python may use it")
    needed = sorted({name for library in app.libraries for name in library.needed})
    for label, old in labels[0].items():
        new, part = labels[1].get(label, ""), label.removeprefix(PREFIX)
        if part == label or not (VERSION.fullmatch(old) and VERSION.fullmatch(new)) or _minor(old) == _minor(new):
            continue
        if used := [name for name in needed if name.startswith(f"lib{part}")]:
            found.add(Verdict.BUILD, f"the app was built with {part} {old} ({used[0]}), and the base image has {new}")


def _minor(version: str) -> list[str]:
    return version.split(".")[:2]


# ---- Libraries -------------------------------------------------------------------------------------------------------


STEPS = 10_000_000
"""The most libraries that are looked at for one app, which takes some seconds. An app with 500 libraries takes a million."""


class _Steps:
    """Counts libraries that are looked at."""

    def __init__(self) -> None:
        self._left = STEPS

    def take(self, count: int) -> None:
        """Counts some more.

        Raises:
            ValueError: it would take too long.
        """
        self._left -= count
        if self._left < 0:
            raise ValueError("libraries name each other more often than any real ones")


class _Libraries:
    """Libraries by each of their names, for one machine.

    Raises:
        ValueError: it would take too long, as of its methods.
    """

    def __init__(self, libraries: Sequence[Library], machine: Sequence[int], steps: _Steps) -> None:
        steps.take(len(libraries))
        self.steps = steps
        self._known: defaultdict[str, list[Library]] = defaultdict(list)
        self._every = [library for library in libraries if list(library.machine) == list(machine)]
        for library in self._every:
            for name in {library.soname, library.path.rpartition("/")[2], *library.names} - {""}:
                self._known[name].append(library)

    def __contains__(self, name: str) -> bool:
        return name in self._known

    def named(self, name: str) -> list[Library]:
        """The libraries with a name."""
        return self._known.get(name, [])

    def closure(self, names: Iterable[str]) -> dict[str, list[Library]]:
        """The libraries that are loaded with some, by name."""
        found: dict[str, list[Library]] = {}
        wanted = [*names]
        while wanted:
            name = wanted.pop()
            if name not in found and name in self._known:
                found[name] = self._known[name]
                more = [other for library in found[name] for other in library.needed]
                self.steps.take(len(found[name]) + len(more))
                wanted += more
        return found

    @property
    def interpreters(self) -> list[Library]:
        """Python, whose extensions use what it exports."""
        return [library for library in self._every if not library.soname]


def _libraries(app: Facts, old: Facts | None, new: Facts, found: Judgement) -> None:
    """What the app's programs and libraries need of the base image's.

    Raises:
        ValueError: it would take too long.
    """
    steps = _Steps()
    for machine in {tuple(library.machine) for library in app.libraries}:
        own, here = _Libraries(app.libraries, machine, steps), _Libraries(new.libraries, machine, steps)
        before = _Libraries(old.libraries, machine, steps) if old else None
        known = [*new.libraries, *(old.libraries if old else ())]
        if not any(tuple(item.machine) == machine for item in known):
            continue  # the app has it for another processor
        used: dict[str, str] = {}
        for library in (item for item in app.libraries if tuple(item.machine) == machine):
            for name in _needed(library, own):
                used.setdefault(name, library.path)
                if name not in here and not DRIVER.fullmatch(name) and (before is None or name in before):
                    found.add(Verdict.BUILD, f"{_short(library)} needs {name}, which the base image lacks")
            _symbols(library, own, before, here, found)
        if before:
            _changed(used, before, here, found)


def _needed(library: Library, own: _Libraries) -> Iterator[str]:
    """The libraries of others that a library of an app needs, also by others of the app."""
    every = own.closure([library.path.rpartition("/")[2], library.soname]).values()
    yield from (name for libraries in every for item in libraries for name in item.needed if name not in own)


def _symbols(library: Library, own: _Libraries, before: _Libraries | None, here: _Libraries, found: Judgement) -> None:
    """Symbols that the old base image had for a library, and the new one has not."""
    names = {*_needed(library, own)}
    lost = _lacking(library.uses, names, here)
    if not lost or before is None:  # then it is linked in a step anyway
        return
    gone = {*lost} - {*_lacking(lost, names, before)}
    if gone:
        more = f" and {len(gone) - 1} more" if len(gone) > 1 else ""
        text = f"{_short(library)} uses {min(gone)[:200]}{more}, which no library of the base image has any more"
        found.add(Verdict.BUILD, text)


def _lacking(symbols: Iterable[str], names: Iterable[str], libraries: _Libraries) -> list[str]:
    wanted = [*symbols]
    known = [library for named in libraries.closure(names).values() for library in named] + libraries.interpreters
    libraries.steps.take(len(known) * (1 + len(wanted) // 10))
    return of_images.lacking(wanted, known)


def _changed(used: Mapping[str, str], before: _Libraries, here: _Libraries, found: Judgement) -> None:
    """Libraries that are not as they were. Of those of the operating system, the name says that the interface is the same."""
    changed: dict[str, str] = {}
    for name, libraries in before.closure(used).items():
        for library in libraries:
            if OF_THE_SYSTEM.fullmatch(library.path):
                continue
            same = [other for other in here.named(name) if other.path == library.path and other.id == library.id]
            if not same and here.named(name):
                changed[name] = library.path
    if changed:
        found.add(
            Verdict.LINK, f"{_some(sorted(changed))} changed, and their names do not say whether their interfaces did"
        )


def _short(library: Library) -> str:
    return library.path.removeprefix("docker-ros/ws/install/")


def _some(names: Sequence[str]) -> str:
    return listed([*names[:3], *([f"{len(names) - 3} more"] if len(names) > 3 else [])])
