"""Decides whether an app may move to another base image, by facts about the app and both base images: no layer is read. docs/rebase.md
has the rules in words, and what they cannot see."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.containerize.rebase.attachments import BaseContents
from rosml.containerize.rebase.debian import Budget, PackageSet, relations
from rosml.containerize.rebase.image import AGAIN
from rosml.images.image_set.labels import PREFIX
from rosml.images.image_set.lock_file import package_name
from rosml.images.join import facts as join_facts
from rosml.images.join.facts import Facts, Library
from rosml.images.join.layers import Source

SAME = {"distribution": "ROS distribution", "os": "system", "python": "Python", "ros": "generation of ROS"}

FRAMEWORK = f"{PREFIX}framework"

VERSION = re.compile(r"[0-9]+(\.[0-9]+)+([+.-].*)?")

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

STEPS = 10_000_000
"""The most libraries that are looked at for one app, which takes some seconds. An app with 500 libraries takes a million."""


class Verdict(IntEnum):
    """What the move takes: nothing, a link in the builder first, or a new build."""

    SAFE = 0
    LINK = 1
    BUILD = 2


WORDS = {Verdict.SAFE: "safe", Verdict.LINK: "check by link", Verdict.BUILD: "build again"}

Reason = tuple[str, Verdict]


@dataclass(frozen=True)
class Judgement:
    """What speaks against a move: each reason once, with the worst verdict that it led to."""

    reasons: Mapping[str, Verdict]

    @classmethod
    def of(cls, reasons: Iterable[Reason]) -> Judgement:
        worst: dict[str, Verdict] = {}
        for reason, verdict in reasons:
            worst[reason] = max(verdict, worst.get(reason, verdict))
        return cls(worst)

    def reasons_for(self, verdict: Verdict) -> list[str]:
        return [reason for reason, its_verdict in self.reasons.items() if its_verdict is verdict]

    @property
    def undecided(self) -> list[str]:
        """Why the app has to be linked before its tag moves."""
        return self.reasons_for(Verdict.LINK)

    @property
    def words(self) -> str:
        return WORDS[max(self.reasons.values(), default=Verdict.SAFE)]


def require_fit(app: Source, base: Source) -> None:
    """Checks by labels that a base image is of the app's kind."""
    for name, words in SAME.items():
        app_has, base_has = (source.labels.get(PREFIX + name, "") for source in (app, base))
        if app_has and not base_has:
            text = f"{base.name} does not say which {words} it has: it is no image of rosml with ROS"
            raise RosmlError(text, "name one, such as ros:jazzy-base", exit_code=2)
        if app_has != base_has:
            text = f"{app.name} was built on {words} {app_has or 'unknown'}, and {base.name} has {base_has}"
            raise RosmlError(text, f"name a base image with {app_has or 'the same'}; or {AGAIN}", exit_code=2)


def judge(
    app: Facts,
    old_facts: Facts | None,
    base: BaseContents,
    app_labels: Mapping[str, str],
    base_labels: Mapping[str, str],
) -> Judgement:
    """Judges a move. `app` has the facts of the app's own layer, `old_facts` those of its present base image unless that is gone."""
    new = base.facts
    try:
        base_packages, all_packages = PackageSet(new.packages), PackageSet([*new.packages, *app.packages])
        reasons = [
            *_package_relations(app, new, base_packages, all_packages),
            *_missing_packages(app, old_facts, all_packages),
            *_libraries(app, old_facts, new),
        ]
    except ValueError as error:
        raise RosmlError(f"the facts of an image are damaged: {error}", AGAIN) from None
    reasons += [
        *_file_clashes(app, base, base_packages),
        *_missing_python(app, base.files),
        *_part_releases(app, app_labels, base_labels),
    ]
    if old_facts is None:
        text = "the base image that the app was built on is gone, or has no facts beside it"
        reasons.append((f"{text}, so nobody can compare with it", Verdict.LINK))
    return Judgement.of(reasons)


# ---- Packages --------------------------------------------------------------------------------------------------------


def _package_relations(app: Facts, new: Facts, base_packages: PackageSet, all_packages: PackageSet) -> Iterator[Reason]:
    for package in app.packages:
        base_version = base_packages.version_of(package.name)
        if base_version and base_version != package.version:
            text = f"the app has {package.name} {package.version}, and the base image has {base_version}"
            yield text, Verdict.BUILD
            continue
        for alternatives in relations(package.depends):
            if not all_packages.meets(alternatives):
                versions = {item.name: all_packages.version_of(item.name) for item in alternatives}
                present = listed([f"{name} {version}" for name, version in versions.items() if version])
                needs = f"{package.name} needs {' | '.join(map(str, alternatives))}"
                yield f"{needs}, and the base image has {present or 'none'}", Verdict.BUILD
        for other, relation in base_packages.conflicts(package):
            yield f"{package.name} cannot stand beside {relation}, and the base image has {other}", Verdict.BUILD
    app_packages = PackageSet(app.packages)
    for package in new.packages:
        for other, relation in app_packages.conflicts(package):
            text = f"{package.name} of the base image cannot stand beside {relation}, and the app has {other}"
            yield text, Verdict.BUILD


def _missing_packages(app: Facts, old_facts: Facts | None, all_packages: PackageSet) -> Iterator[Reason]:
    """Packages that only the old base image has. The app asked for some; Python and launch files may use others, and no list says so."""
    for name in app.asks:
        if name not in all_packages:
            yield f"the app asked for {name}, which the base image lacks", Verdict.BUILD
    packages = old_facts.packages if old_facts else ()
    gone = sorted({package.name for package in packages if package.name not in all_packages})
    if gone and app.imports != []:
        text = f"the base image until now has {_some(gone)}, and this one has not; the app's Python may use it"
        yield text, Verdict.LINK


# ---- Files -----------------------------------------------------------------------------------------------------------


def _missing_python(app: Facts, files: Iterable[str]) -> Iterator[Reason]:
    """What the app imports, or asked pip for, and took from its present base image."""
    modules = modules_of(files) if app.imports else ()
    for item in app.imports or ():
        if item.module not in modules:
            yield f"{item.file} imports {item.module}, which the base image lacks", Verdict.BUILD
    matches = map(_DISTRIBUTION.search, files if app.asks_pip else ())
    distributions = {package_name(match[1]) for match in matches if match}
    for name in app.asks_pip:
        if name not in distributions:
            yield f"the app asked pip for {name}, which the base image lacks", Verdict.BUILD


_DISTRIBUTION = re.compile(r"/(?:site|dist)-packages/([A-Za-z0-9._]+)(?:-[^/]*)?\.(?:dist|egg)-info(?:/|$)")


def modules_of(files: Iterable[str]) -> set[str]:
    """The first names of the modules in folders that Python looks into."""
    return {match[1] for path in files if (match := _MODULE.match(path))}


_MODULE = re.compile(
    r"(?:.*/(?:site|dist)-packages|(?:.*/)?(?:usr/(?:local/)?|opt/[^/]+/[^/]+/)?lib/python3(?:\.\d+)?(?:/lib-dynload)?)/([^/.]+)(?:[/.]|$)"
)


def _file_clashes(app: Facts, base: BaseContents, base_packages: PackageSet) -> Iterator[Reason]:
    """Files that both have, except those of packages that both have: in another version, such a package is a reason itself."""
    added = [package for package in app.packages if not base_packages.version_of(package.name)]
    parents: dict[str, str] = {}
    for path in (*(path for package in added for path in package.files), *app.files):
        if GENERATED.fullmatch(path):
            continue
        if path in base.files:
            yield f"{BOTH}{path}", Verdict.BUILD
        elif path in base.folders:
            yield f"the app has a file /{path}, which is a folder in the base image", Verdict.BUILD
        elif parent := _parent_file(path.rpartition("/")[0], base.files, parents):
            text = f"the app has a folder /{parent}, which is a file or a link in the base image"
            yield text, Verdict.BUILD


def _parent_file(folder: str, files: Container[str], parents: dict[str, str]) -> str:
    """The folder or one above it that is a file in an image; empty if none is. `parents` keeps the answers."""
    unanswered = []
    while folder and folder not in parents and folder not in files:
        unanswered.append(folder)
        folder = folder.rpartition("/")[0]
    parent = parents.get(folder, folder)
    parents |= dict.fromkeys(unanswered, parent)
    return parent


def _part_releases(app: Facts, app_labels: Mapping[str, str], base_labels: Mapping[str, str]) -> Iterator[Reason]:
    """Parts of another release, whose libraries keep their names: one minor release runs no programs of another."""
    releases = {
        name.removeprefix(PREFIX): (text, base_labels.get(name))
        for name, text in app_labels.items()
        if name.startswith(PREFIX) and VERSION.fullmatch(text)
    }
    lost = [part for part, (_, base_has) in releases.items() if base_has is None]
    if lost and app_labels.get(FRAMEWORK) != base_labels.get(FRAMEWORK) and app.imports != []:
        yield f"this base image has no {listed(lost, 'or')}; the app's Python may use it", Verdict.LINK
    needed = sorted({name for library in app.libraries for name in library.needed})
    for part, (app_has, base_has) in releases.items():
        if not VERSION.fullmatch(base_has or "") or app_has.split(".")[:2] == (base_has or "").split(".")[:2]:
            continue
        if used := next((name for name in needed if name.startswith(f"lib{part}")), ""):
            yield f"the app was built with {part} {app_has} ({used}), and the base image has {base_has}", Verdict.BUILD


# ---- Libraries -------------------------------------------------------------------------------------------------------


class _Libraries:
    def __init__(self, libraries: Sequence[Library], machine: Sequence[int], budget: Budget) -> None:
        budget.take(len(libraries))
        self._budget = budget
        self._by_name: defaultdict[str, list[Library]] = defaultdict(list)
        usable = [library for library in libraries if list(library.machine) == list(machine)]
        # Python, whose extensions use its symbols.
        self._interpreters = [library for library in usable if not library.soname]
        for library in usable:
            for name in {library.soname, library.path.rpartition("/")[2], *library.names} - {""}:
                self._by_name[name].append(library)

    def __contains__(self, name: str) -> bool:
        return name in self._by_name

    def by_name(self, name: str) -> list[Library]:
        return self._by_name.get(name, [])

    def closure(self, names: Iterable[str]) -> dict[str, list[Library]]:
        """The libraries that are loaded with some, by name."""
        loaded: dict[str, list[Library]] = {}
        queue = [*names]
        while queue:
            name = queue.pop()
            if name not in loaded and name in self:
                loaded[name] = self._by_name[name]
                needed = [other for library in loaded[name] for other in library.needed]
                self._budget.take(len(loaded[name]) + len(needed))
                queue += needed
        return loaded

    def lacking(self, symbols: Sequence[str], names: Iterable[str]) -> list[str]:
        """The symbols that neither libraries with these names, nor those loaded with them, nor Python export."""
        libraries = [library for group in self.closure(names).values() for library in group] + self._interpreters
        self._budget.take(len(libraries) * (1 + len(symbols) // 10))
        return join_facts.lacking(symbols, libraries)


def _libraries(app: Facts, old_facts: Facts | None, new: Facts) -> Iterator[Reason]:
    budget = Budget(STEPS, "libraries")
    base_libraries = [*new.libraries, *(old_facts.libraries if old_facts else ())]
    for machine in {tuple(library.machine) for library in app.libraries}:
        if not any(tuple(library.machine) == machine for library in base_libraries):
            continue  # the app has it for another processor
        of_app, now = _Libraries(app.libraries, machine, budget), _Libraries(new.libraries, machine, budget)
        before = _Libraries(old_facts.libraries, machine, budget) if old_facts else None
        used: set[str] = set()
        for library in (item for item in app.libraries if tuple(item.machine) == machine):
            names = list(_needed(library, of_app))
            used.update(names)
            for name in names:
                if name not in now and not DRIVER.fullmatch(name) and (before is None or name in before):
                    yield f"{_short(library)} needs {name}, which the base image lacks", Verdict.BUILD
            if before:  # without it, the app is linked in a step anyway
                yield from _lost_symbols(library, {*names}, before, now)
        if before:
            yield from _changed(used, before, now)


def _needed(library: Library, of_app: _Libraries) -> Iterator[str]:
    """The libraries of others that a library of an app needs, also by others of the app."""
    groups = of_app.closure([library.path.rpartition("/")[2], library.soname]).values()
    yield from (name for group in groups for item in group for name in item.needed if name not in of_app)


def _lost_symbols(library: Library, names: set[str], before: _Libraries, now: _Libraries) -> Iterator[Reason]:
    lacking_now = now.lacking(library.uses, names)
    lost = {*lacking_now} - {*before.lacking(lacking_now, names)} if lacking_now else ()
    if lost:
        more = f" and {len(lost) - 1} more" if len(lost) > 1 else ""
        text = f"{_short(library)} uses {min(lost)[:200]}{more}, which no library of the base image has any more"
        yield text, Verdict.BUILD


def _changed(used: Iterable[str], before: _Libraries, now: _Libraries) -> Iterator[Reason]:
    """Libraries that are not as they were. Of those of the operating system, the name says that the interface is the same."""
    changed = {
        name
        for name, libraries in before.closure(used).items()
        for library in libraries
        if not OF_THE_SYSTEM.fullmatch(library.path)
        and name in now
        and not any((other.path, other.id) == (library.path, library.id) for other in now.by_name(name))
    }
    if changed:
        text = f"{_some(sorted(changed))} changed, and their names do not say whether their interfaces did"
        yield text, Verdict.LINK


def _short(library: Library) -> str:
    return library.path.removeprefix("docker-ros/ws/install/")


def _some(names: Sequence[str]) -> str:
    return listed([*names[:3], *([f"{len(names) - 3} more"] if len(names) > 3 else [])])
