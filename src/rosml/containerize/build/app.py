"""Builds an app: its part, and the images that join the part and a base image."""

from __future__ import annotations

import contextlib
import functools
import re
import shutil
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.file_lock import holder, turn
from rosml.base.problems import SHOWN, counted, some
from rosml.base.units import time_taken
from rosml.containerize import lock, within
from rosml.containerize.base_image import addons, rosdep_index
from rosml.containerize.base_image import base as app_base
from rosml.containerize.build import adopt, junit, report, stage_cache
from rosml.containerize.build import attachments as contents
from rosml.containerize.build import bake_file as app_bake_file
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.stage_cache import IDENTIFIED
from rosml.containerize.inputs import Values
from rosml.containerize.names import DESK, SLIM, Names
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.packages.ignored import IgnoredFiles
from rosml.containerize.sources import fetch as sources
from rosml.containerize.sources.git import Access
from rosml.images.image_set import restricted
from rosml.images.image_set.system import CALLED, DEBIAN
from rosml.machine import buildx, git
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries

_LACKING = re.compile(
    r"Unable to locate package ([a-z0-9][a-z0-9.+-]*)|Package '([^' ]+)' has no installation candidate"
)
"""apt's messages about a package that no source has."""

TIME = 1767225600
"""2026-01-01T00:00:00Z: the time of images whose sources are in no commit."""


@dataclass(frozen=True)
class Made:
    """A new image. `digest` is its digest in the registry, or its id in Docker."""

    target: str
    reference: str
    digest: str


@dataclass(frozen=True)
class Desk:
    """The image for `rosml dev`.

    Attributes:
        reference: its name in Docker, or its name by digest in a registry.
        loaded: whether it is in Docker.
        upstream: the folder with the imported repositories; None if there are none.
    """

    reference: str
    loaded: bool
    upstream: Path | None


@dataclass
class Built:
    """The result of a build.

    Attributes:
        base: the base image by its digest.
        images: the new images.
        outcome: the part of the result that another build from the same would repeat.
        unstarted: the files of `outcome.forgotten` that the command starts.
        upstream: the imported repositories.
        downstream: the repositories of the downstream workspace.
        lock: the inputs of the images, for a lock file.
        locked: the lock file, if it was written.
        described: images with an SBOM and a list of files beside them in the registry.
        tests: the packages' tests.
        slim_tests: the same tests in the slim image.
        downstream_tests: the tests of packages that use the app's.
        reports: the folder of their JUnit files; empty if an earlier build passed them.
        seconds: the time that it took.
        waited: how much of it other builds had the builder.
    """

    base: str
    images: list[Made] = field(default_factory=list)
    outcome: Outcome = field(default_factory=Outcome)
    unstarted: list[str] = field(default_factory=list)
    upstream: list[sources.Repository] = field(default_factory=list)
    downstream: list[sources.Repository] = field(default_factory=list)
    lock: lock.Lock | None = None
    locked: str = ""
    described: list[str] = field(default_factory=list)
    tests: junit.Tests = field(default_factory=junit.Tests)
    slim_tests: junit.Tests = field(default_factory=junit.Tests)
    downstream_tests: junit.Tests = field(default_factory=junit.Tests)
    reports: str = ""
    seconds: float = 0.0
    waited: float = 0.0

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        facts = asdict(self) | {"lock": self.lock.model_dump() if self.lock else None}
        del facts["outcome"]
        return facts | self.outcome.model_dump()

    def summary(self) -> Iterator[tuple[str, str]]:
        """Lines for people at the end: a subject and a sentence."""
        yield (
            "app",
            f"{counted(len(self.outcome.packages), 'ROS package')}, {counted(len(self.outcome.installed), 'package')} of apt added",
        )
        for which, replaced in (
            ("the base image", self.outcome.replaced),
            ("the base image of the slim one", self.outcome.slim_replaced),
        ):
            if replaced:
                names = ", ".join(replaced[:3]) + (" …" if len(replaced) > 3 else "")
                yield (
                    "",
                    f"not joined to {which}, of which its packages change {counted(len(replaced), 'thing')}: {names}",
                )
        if self.outcome.outside:
            names = ", ".join(f"/{name}" for name in self.outcome.outside[:3]) + (
                " …" if len(self.outcome.outside) > 3 else ""
            )
            yield "", f"installed outside of the install space, and in no image: {names}"
        for which, found in (
            ("the run image lacks what the build has", self.outcome.lost),
            ("the slim image lacks what the build has", self.outcome.slim_lost),
            ("neither the build nor an image has", self.outcome.absent),
            ("the command starts what is in no image", self.unstarted),
        ):
            if found:
                yield (
                    "",
                    f"{which}: {'; '.join(found[:3])}" + (f"; and {len(found) - 3} more" if len(found) > 3 else ""),
                )
        tests = self.tests
        where = f"reports: {files.shown(Path(self.reports))}" if self.reports else "in an earlier build from the same"
        passed = f"{tests.count - tests.skipped} passed, {tests.skipped} skipped; {where}"
        yield "tests", passed if tests.count else "none ran"
        for where, tests, ran in (
            ("in the slim image", self.slim_tests, False),
            ("of packages that use yours", self.downstream_tests, bool(self.downstream)),
        ):
            if tests.count or ran:
                yield "", f"{where}: {tests.count - tests.skipped} passed, {tests.skipped} skipped"
        if self.locked:
            yield "lock", self.locked
        if self.described:
            yield "sbom", f"beside {' and '.join(self.described)} in the registry"
        yield "time", time_taken(self.seconds, self.waited)


SYMLINKS = "--symlink-install"
"""The option of colcon for a workspace whose sources stay where they are."""


class App:
    """Makes images of a repository with ROS packages.

    Args:
        folder: the repository.
        values: the inputs, as `app_inputs.values` gives them.
        environment: the variables of the process.
        services: this machine's builder and registry.
        say: tells the user what begins now.
        renew: take the newest versions and write the lock file, instead of following it.

    Raises:
        RosmlError: a value is wrong (exit code 2).
    """

    def __init__(
        self,
        folder: Path,
        values: Values,
        environment: Mapping[str, str],
        services: Services,
        say: Callable[[str], None],
        renew: bool = False,
    ) -> None:
        self._folder, self._values, self._environment = folder, values, environment
        self._services, self._say, self._renew = services, say, renew
        self._lock_file = lock.place(folder, values.lock_file, renew)
        self._names = Names(values, folder.name, services)
        if "run" in self._names.targets and not values.command:
            raise RosmlError(
                "there is no command for the run image",
                "add --command 'ros2 launch …', or --target dev; rosml init proposes one",
                exit_code=2,
            )
        if "run" in self._names.targets and SYMLINKS in values.colcon_args:
            text = f"colcon-args: with {SYMLINKS}, colcon installs links to your sources, which are in no run image"
            raise RosmlError(
                text, f"leave {SYMLINKS} out; rosml dev takes it: rosml dev -- colcon build {SYMLINKS}", exit_code=2
            )
        if not values.base_image:
            raise RosmlError(
                "there is no base image",
                "add --base-image, such as ros:jazzy-base; rosml init proposes one",
                exit_code=2,
            )
        # Two calls may work side by side, unless they make the same image: then they take turns.
        name = f"{self._names.app}@{values.image_tag}".replace("/", "+").replace(":", "=")
        self._state = services.state / "containerize" / name

    @property
    def report(self) -> Path:
        """The folder of test reports, in which `results` has the packages' own; one for each platform if there are several."""
        return self._state / "report"

    def build(self) -> Built:
        """Builds the images.

        Raises:
            RosmlError: an input is wrong, or a step or a test failed.
        """
        self._state.mkdir(parents=True, exist_ok=True)
        with self._turn():
            return self._build()

    def _turn(self) -> contextlib.AbstractContextManager[int]:
        """Waits for another call that makes this app."""
        file, waiting = self._state / "lock", f"waiting for another call that makes {self._names.app}"
        return turn(file, lambda: self._say(f"{waiting} ({holder(file)})"))

    def _build(self) -> Built:
        started, waited = time.monotonic(), buildx.waited()
        base, locked = self._base()
        if not self._names.loads:
            with Registries(self._services.ca_bundle) as registries:
                tags = [tag for target in self._names.targets for tag in self._names.tags(target)]
                app_base.require_kept(registries, tags, self._names.platforms)
        built = Built(base.reference)
        built.upstream, built.downstream = self._import(locked)
        slim = self._slim(base, locked)
        base = self._with_addons(base, locked)
        slim = slim and self._with_addons(slim, locked)
        require_locked(locked, self._values.addons, base, slim)
        self._require_allowed(base, slim)
        inputs = self._inputs(base, slim, locked)
        with contextlib.ExitStack() as stack:
            cache = None
            if self._values.cache and not self._renew:
                cache = stack.enter_context(stage_cache.Cache(self._values.cache, self._services.ca_bundle))
            self._make(inputs, built, cache, locked)
        if self._renew and built.lock:
            self._write_lock(built.lock)
            built.locked = str(self._lock_file)
            if base.adopted:
                text = (
                    "it has no versions of the ROS that was installed on the base image: keep that image with --cache"
                )
                self._say(f"{self._lock_file}: {text}")
        built.seconds, built.waited = time.monotonic() - started, buildx.waited() - waited
        return built

    def desk(self) -> Desk:
        """Builds the image for `rosml dev`: the environment of the packages, with debuggers. The packages are not built.

        Raises:
            RosmlError: an input is wrong, or a step failed.
        """
        self._state.mkdir(parents=True, exist_ok=True)
        with self._turn():
            base, locked = self._base()
            upstream, _ = self._import(locked)
            base = self._with_addons(base, locked)
            require_locked(locked, self._values.addons, base, None)
            inputs = replace(self._inputs(base, None, locked), time=TIME)
            known: dict[str, str] = {}
            if self._values.cache:
                if self._values.rosdep_index:
                    inputs = self._with_lists(inputs, locked)
                with stage_cache.Cache(self._values.cache, self._services.ca_bundle) as cache:
                    known = cache.found(self._keys(inputs))
            if IDENTIFIED not in known:
                inputs = self._with_lists(inputs, locked)
            self._names.targets = (DESK,)
            file, asked = self._state / "bake.json", self._state / f"{app_bake_file.ASKED}.tar"
            files.write(
                file,
                app_bake_file.render_desk(inputs, self._names, self._services, [*self._environment], asked, known),
            )
            self._install_ros(base, known)
            metadata = self._bake(DESK, file, asked)
            reference = self._names.reference(DESK)
            if not self._names.loads:
                reference = f"{reference.rpartition(':')[0]}@{metadata.get('containerimage.digest', '')}"
            return Desk(reference, self._names.loads, self._state / "upstream" if upstream else None)

    def _base(self) -> tuple[app_base.Base, lock.Lock | None]:
        """The base image, and the lock file; None if there is none."""
        locked = None if self._renew else lock.read(self._lock_file, self._folder)
        named = self._values.base_image
        digest = locked.base_image.of(named) if locked else ""
        base = app_base.find(named, self._services, self._names.platforms, digest)
        self._say(f"base image {base.name}")
        base = adopt.with_ros(base, self._services, self._values, self._names.platforms, self._say)
        if locked:
            self._say(f"{self._lock_file} says which versions")
            if missing := locked.lacks(self._names.platforms):
                self._say(f"it has no packages for {', '.join(missing)}: they are the newest; {lock.RENEW}")
        return base, locked

    def _make(
        self, inputs: app_bake_file.Inputs, built: Built, cache: stage_cache.Cache | None, locked: lock.Lock | None
    ) -> None:
        """Builds the stages that no cache has, and joins the images."""
        file = self._state / "bake.json"
        left = {
            name: self._state / f"{name}.tar"
            for name in (app_bake_file.REPORT, app_bake_file.RESULTS, app_bake_file.ASKED)
        }
        said: report.Said | None = None
        known: dict[str, str] = {}
        kept: dict[str, str] = {}
        earlier = None
        named = bool(self._values.rosdep_index)
        if named or not cache:
            inputs = self._with_lists(inputs, locked)
        if cache:
            keys = self._keys(inputs)
            known, earlier = cache.found(keys), cache.report(keys)
            if {*inputs.stages} - known.keys():
                earlier = None
            if not named and IDENTIFIED not in known:  # this stage reads them
                inputs = self._with_lists(inputs, locked)
            kept = {stage: cache.reference(tag) for stage, tag in keys.stages.items() if stage not in known}
        arguments = (inputs, self._names, self._services, [*self._environment], left, known, kept)
        if earlier:
            self._say(f"nothing to build: {self._values.cache} has it")
            built.outcome, built.tests = earlier.outcome, earlier.passed
        else:
            shutil.rmtree(self.report, ignore_errors=True)
            for archive in left.values():
                archive.unlink(missing_ok=True)
            files.write(file, app_bake_file.render(*arguments))
            self._install_ros(inputs.base, known)
            self._make_stages(file, left, built)
            said = report.Said(left[app_bake_file.REPORT], self._state / "said", self._names.platforms)
            _take(built, said, slim=inputs.slim is not None)
            if self._values.tests:
                self._test(left[app_bake_file.RESULTS], built)
                self._require_complete(built)
            if cache:
                cache.keep(keys, built.outcome, built.tests, said.details())
        self._require_started(built)
        made = self._locked(inputs, built)
        if locked and not locked.lacks(self._names.platforms):
            made = locked  # it may have more: of another platform, or of a slim image
        built.lock = made
        files.write(file, app_bake_file.render(*arguments, replaced=built.outcome.replacing, lock=made.line()))
        built.images = self._join(file)
        if self._values.sbom and not self._names.loads:
            if said:
                self._describe(built, said.detail)
            elif cache:
                self._describe(built, functools.partial(cache.detail, keys))

    def _make_stages(self, file: Path, left: Mapping[str, Path], built: Built) -> None:
        """Builds the stages of the packages and runs their tests. A failed test ends the build.

        Args:
            file: the bake file.
            left: the archives of its targets.

        Raises:
            RosmlError: a step or a test failed.
        """
        try:
            self._bake(app_bake_file.PACKAGES, file, left[app_bake_file.ASKED])
        except buildx.StepFailed as error:
            if error.stage == app_bake_file.PASSED:
                buildx.run(self._services, self._call(app_bake_file.FAILED, file, "read the reports of the tests"))
                self._test(left[app_bake_file.RESULTS], built)
            raise

    def _join(self, file: Path) -> list[Made]:
        """Joins the images of a bake file.

        Raises:
            RosmlError: one cannot be joined, or cannot be pushed.
        """
        first, *others = self._names.targets
        call = buildx.Bake(first, f"containerize-{self._state.name}-images", file, beside=others)
        _progress, metadata = buildx.run_all(self._services, call)
        fact = f"containerimage.{'config.' if self._names.loads else ''}digest"
        return [
            Made(target, self._names.reference(target), metadata.get(target, {}).get(fact, ""))
            for target in self._names.targets
        ]

    def _install_ros(self, base: app_base.Base, known: Mapping[str, str]) -> None:
        """Has the builder install ROS on a base image without it, one app after the other. All other steps wait for nobody.

        Args:
            known: stages that the cache has.

        Raises:
            RosmlError: a step failed.
        """
        if base.adopted and stage_cache.BASE not in known:
            adopt.prepare(base, self._services, self._environment, self._names.platforms)

    def _bake(self, target: str, file: Path, asked: Path) -> Mapping[str, str]:
        """Builds a target that installs packages. Returns the builder's facts about it.

        Args:
            file: the bake file.
            asked: the archive of its target `ASKED`.

        Raises:
            RosmlError: a step failed.
        """
        try:
            return buildx.run(self._services, self._call(target, file))[1]
        except RosmlError as error:
            self._explain(error, file, asked)
            raise

    def _call(self, target: str, file: Path, glance: str = "") -> buildx.Bake:
        """The call that builds a target with steps. `glance` as in `buildx.Bake`."""
        name = f"containerize-{self._state.name}" + (f"-{target}" if glance else "")
        jobs = {"PARALLEL_JOBS": self._values.parallel_jobs}
        return buildx.Bake(target, name, file, variables=jobs, foreign=app_bake_file.FOREIGN, glance=glance)

    def _explain(self, error: RosmlError, file: Path, left: Path) -> None:
        """If a build failed because apt lacks packages, adds to the error which rule of rosdep names them, and which package
        asks for that rule. The steps that install them do not know: they run again only if the packages differ.

        Args:
            file: the bake file.
            left: the archive of its target `ASKED`.
        """
        lacking = {name for names in _LACKING.findall(error.message) for name in names if name}
        if not lacking:
            return
        with contextlib.suppress(RosmlError):
            buildx.run(self._services, buildx.Bake(app_bake_file.ASKED, f"containerize-{self._state.name}-asked", file))
            asked = report.Said(left, self._state / "asked", self._names.platforms).dependencies()
            wrong = []
            for key, answers in asked.keys.items():
                by = ", ".join(
                    name for name, kinds in asked.packages.items() if any(key in keys for keys in kinds.values())
                )
                for name in sorted(lacking & {name for answer in answers for name in answer.names}):
                    wrong.append(key)
                    by = by or "a package of the downstream workspace"
                    error.message += f"\n  rosdep's rule for {key}, which {by} asks for, names {name}"
            if wrong:
                error.remedy = (
                    "if the archive never had it, correct the rule, or name other lists with --rosdep-index; or leave out what"
                    f" your packages run without: --skip-keys '{' '.join(sorted(set(wrong)))}'"
                )

    def _describe(self, built: Built, load: Callable[[str], bytes]) -> None:
        """Attaches an SBOM, a list of files and facts to the images to run. Some registries refuse that.

        Args:
            load: reads the contents of an image, by a name as in `report.Said.details`.
        """
        owners = {
            name: repository
            for repository in built.upstream
            for name in workspace.names(self._state / "manifests" / "upstream" / repository.path)
        }
        with Registries(self._services.ca_bundle) as registries:
            for image in built.images:
                if image.target not in report.DESCRIBED:
                    continue
                place = references.parse(image.reference)

                def said(platform: str, kind: str, target: str = image.target) -> bytes:
                    return load(f"{target}/{platform}/{kind}")

                replaced = built.outcome.slim_replaced if image.target == SLIM else built.outcome.replaced
                where = registries(place.host), place.repository, image.digest
                try:
                    contents.attach(*where, said, owners, linked=not replaced)
                except RosmlError as error:
                    self._say(f"{image.reference} lacks its SBOM or its list of files: {error.message}")
                else:
                    built.described.append(image.reference)

    def _write_lock(self, made: lock.Lock) -> None:
        """Writes the lock file. Says which of its packages are lost."""
        try:
            before = lock.read(self._lock_file, self._folder)
        except RosmlError as error:
            self._say(f"written again: {error.message}")
            before = None
        if before:
            made = made.with_other_architectures(before)
            if lost := sorted(before.apt.keys() - made.apt.keys()):
                self._say(f"the lock file has no packages for {', '.join(lost)} any more: name all platforms at once")
        files.write(self._lock_file, made.text(), within=self._folder)

    def _locked(self, inputs: app_bake_file.Inputs, built: Built) -> lock.Lock:
        """The lock: the inputs of the images."""
        slim = inputs.slim and lock.Image(name=self._values.slim_base_image, digest=inputs.slim.digest)
        named, rosdep = self._values.rosdep_index, None
        if inputs.rosdep and (named or self._renew):  # otherwise they change every day, and the image does not
            rosdep = lock.Image(name=named, digest=inputs.rosdep)
        parts = _parts(inputs.base, inputs.slim)
        return lock.Lock(
            addons={name: reference.rpartition("@")[2] for name, reference in parts.items()} or None,
            base_image=lock.Image(name=self._values.base_image, digest=inputs.base.digest),
            slim_base_image=slim,
            rosdep_index=rosdep,
            repositories=_pins(built.upstream),
            downstream=_pins(built.downstream),
            apt=built.outcome.added.apt,
            pip=built.outcome.added.pip,
        )

    def _with_addons(self, base: app_base.Base, locked: lock.Lock | None) -> app_base.Base:
        """The base image with the add-ons that the user wants.

        Raises:
            RosmlError: they cannot be joined.
        """
        known = locked.addons or {} if locked else None
        found = addons.onto(base, self._values.addons, self._services, self._names.platforms, known)
        if found.addons:
            self._say(f"{base.name} with {', '.join(name.rpartition('/')[2] for name in found.addons.parts)}")
        return found

    def _require_allowed(self, *bases: app_base.Base | None) -> None:
        """Checks that base images may go to the registries of the app and of its cache: they may have restricted parts.

        Raises:
            RosmlError: one may not (exit code 2).
        """
        targets = () if self._names.loads else self._names.targets
        places = {tag for target in targets for tag in self._names.tags(target)} | {*filter(None, [self._values.cache])}
        declared = functools.cache(restricted.of_this_machine)
        for base in filter(None, bases):
            for place in map(references.parse, sorted(places)):
                if parts := restricted.parts_of({**base.labels, **(base.addons.labels if base.addons else {})}):
                    told = restricted.require(parts, base.name, place.host, place.repository, declared())
                    if told:
                        self._say(told)

    def _slim(self, base: app_base.Base, locked: lock.Lock | None) -> app_base.Base | None:
        """The base image of the slim image; None if there is to be no slim image, or if none belongs to the base image."""
        if SLIM not in self._names.targets:
            return None
        named = self._values.slim_base_image
        name = named or app_base.runtime(base)
        reason = f"there is no {name}" if name else f"{base.name} does not say which base image has no compilers"
        digest = locked.slim_base_image.of(named) if locked and locked.slim_base_image else ""
        if name:
            try:
                found = app_base.find(name, self._services, self._names.platforms, digest)
            except RosmlError as error:
                if named or digest or not (error.exit_code == 2 or base.local):  # it was not found
                    raise
            else:
                others = [] if named else app_base.differing(base, found)
                if not others and locked and not digest:
                    raise RosmlError(
                        "the lock file has no slim image", f"{lock.RENEW} --enable-slim, or leave the image out", 2
                    )
                if not others:
                    return found
                reason = f"{name} is of another {', '.join(others)}"
        self._names.targets = tuple(target for target in self._names.targets if target != SLIM)
        self._say(f"no slim image: {reason}; name one with --slim-base-image")
        return None

    def _import(self, locked: lock.Lock | None) -> tuple[list[sources.Repository], list[sources.Repository]]:
        """Fetches the upstream sources, and those of the downstream workspace."""
        values = self._values
        access = Access(
            https_server=values.git_https_server,
            https_user=values.git_https_user,
            https_password=values.git_https_password,
            ssh_key=values.git_ssh_private_key,
            ssh_known_hosts=values.git_ssh_known_host_keys,
        )
        fetch = functools.partial(
            sources.fetch,
            self._folder,
            cache=self._services.state / "cache" / "git",
            access=access,
            say=self._say,
        )
        named = values.downstream_workspace
        options = sources.Options(
            recursive=values.enable_recursive_vcs_import,
            file=values.vcs_import_file,
            without=named,
            pins=locked.repositories if locked else None,
            local=values.allow_file_urls,
        )
        upstream = fetch(self._state / "upstream", options=options)
        place = self._state / "downstream"
        if not named:
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir()
            return upstream, []
        if not within.exists(self._folder / named, self._folder):
            text = f"downstream-workspace: there is no file {named} in {self._folder}"
            raise RosmlError(text, "name a .repos file there; other forms of industrial_ci do not count", exit_code=2)
        # If it was added after the lock file was written, it is the newest.
        pins = locked.downstream if locked and locked.downstream else None
        options = replace(options, recursive=False, file=named, without="", pins=pins)
        return upstream, fetch(place, options=options)

    def _inputs(
        self, base: app_base.Base, slim: app_base.Base | None, locked: lock.Lock | None
    ) -> app_bake_file.Inputs:
        """Writes the inputs of the build."""
        values, folder, state = self._values, self._folder, self._state
        distribution = base.environment.get("ROS_DISTRO") or values.ros_distro
        conditions = distribution
        if distribution == DEBIAN:
            row = {base.adopted.image.distribution, DEBIAN} if base.adopted else {DEBIAN}
            conditions = CALLED if values.ros_distro in row else values.ros_distro or CALLED
            if conditions != CALLED:
                self._say(f"conditions in package.xml compare $ROS_DISTRO with {conditions}, which --ros-distro names")
        elif values.ros_distro not in ("", distribution):
            self._say(f"ROS_DISTRO={values.ros_distro} is not used: the base image has {distribution}")
        if not distribution:
            text = f"{base.name} does not say which ROS it has"
            raise RosmlError(text, "add --ros-distro, such as jazzy", exit_code=2)
        names = ("upstream", "downstream", "manifests", "requests", "empty")
        upstream, downstream, manifests, requests, empty = (state / name for name in names)
        private = workspace.stage(folder, state / "staged" / "target", self._lock_file, IgnoredFiles(folder))
        empty.mkdir(parents=True, exist_ok=True)
        roots = {"target": folder, "upstream": upstream, "downstream": downstream}
        named = app_bake_file.mirrors_with_a_password(self._environment)
        if named and not values.allow_mirror_password:
            text = f"{' and '.join(named)} has a password, and steps that ask the mirror run code of the repository"
            remedy = "name a mirror without a password; if you trust all of that code, add --allow-mirror-password"
            raise RosmlError(text, remedy, exit_code=2)
        counts = workspace.write_manifests(roots, manifests, self._say)
        if values.downstream_workspace and not counts["downstream"]:
            text = f"downstream-workspace: the repositories of {values.downstream_workspace} have no package"
            raise RosmlError(text, "name some that have, or leave the input out", exit_code=2)
        of_base = replace(values, ros_distro=distribution)
        workspace.write_requests(of_base, folder, upstream, base.environment, requests)
        if locked:
            locked.write_requests(requests)
        if self._renew:  # an earlier build may have installed older versions
            (requests / "renewed").write_text(f"{time.time()}\n")
        self._tell_sources(folder, state / "staged" / "target", private)
        packages = counted(counts["target"] + counts["upstream"], "package")
        packages += f", and {counts['downstream']} that use them," if counts["downstream"] else ""
        self._say(f"{packages} for {', '.join(self._names.platforms)}")
        if additional := workspace.additional_files(values.additional_files_dir, folder):
            workspace.stage(additional, state / "additional")
        contexts = {
            "manifests": manifests,
            "target": state / "staged",
            "upstream": upstream,
            "downstream": downstream,
            "requests": requests,
            "additional": state / "additional" if additional else empty,
            "rosdep": empty,
        }
        if local := buildx.local_servers(self._services):
            self._say(
                f"{' and '.join(local)}: on this machine, so steps of the build share its network: the repository's code"
                " reaches what listens here"
            )
        hooked = (requests / "identification.sh").stat().st_size > 0
        if not hooked:  # a script may make other packages
            self._check(base, conditions, requests, manifests)
        commit = git.commit(folder, self._say) or git.Commit("", TIME)
        return app_bake_file.Inputs(
            base, distribution, values, contexts, empty, hooked, commit.hash, commit.time, slim, conditions=conditions
        )

    def _tell_sources(self, folder: Path, staged: Path, private: Sequence[str]) -> None:
        """Says what of a repository is not as its authors may expect.

        Args:
            staged: its files as the builder gets them.
            private: those that others may not read in the repository.
        """
        for path in workspace.empty_submodules(folder):
            self._say(f"the submodule {path} is not there: git submodule update --init --recursive")
        if found := workspace.pointers(staged):
            more = f" and {counted(len(found) - 1, 'file')} more" if len(found) > 1 else ""
            self._say(f"{found[0]}{more} of Git LFS: only a pointer is there, and gets into the images: git lfs pull")
        if private:
            self._say(
                f"in the images everybody may read {some(sorted(private))}, which others may not read here (umask)"
            )

    def _check(self, base: app_base.Base, conditions: str, requests: Path, manifests: Path) -> None:
        """Tells of names to leave out that no package has. Checks that packages are for the ROS of the base image, if it says which,
        and that they can be built one after another.

        Raises:
            RosmlError: some are for the other ROS, or depend on each other in a ring (exit code 2).
        """
        for warning in workspace.stale(requests, manifests):
            self._say(warning)
        ros = base.environment.get("ROS_VERSION", "")
        without = {*(requests / workspace.BLACKLIST).read_text().split()}
        manifest.require_order(manifests, {"ROS_VERSION": ros, "ROS_DISTRO": conditions}, without)
        if ros in ("1", "2"):
            manifest.require_one_ros(self._folder, base.name, int(ros), conditions, without)

    def _with_lists(self, inputs: app_bake_file.Inputs, locked: lock.Lock | None) -> app_bake_file.Inputs:
        """The inputs with rosdep's lists, if there are others than the image's own."""
        named = self._values.rosdep_index
        pin = locked.rosdep_index.of(named) if locked and locked.rosdep_index else ""
        finder = rosdep_index.Finder(self._services, self._folder, self._say)
        found = finder.find(named, inputs.base, pin, locked is not None)
        if not found:
            return inputs
        index, digest = found
        if not digest:
            index = rosdep_index.copied(index, self._state / "rosdep")
        return replace(inputs, contexts={**inputs.contexts, "rosdep": index}, rosdep=digest)

    def _keys(self, inputs: app_bake_file.Inputs) -> stage_cache.Keys:
        """The keys of the build's stages: digests of their inputs."""
        values, contexts = self._values, inputs.contexts
        names = ["manifests", "requests", "additional"]
        if values.rosdep_index:  # other lists are the newest, and change every day for nothing
            names.append("rosdep")
        given = {"base": inputs.base.digest, "platforms": self._names.platforms, "ros": inputs.distribution}
        if inputs.base.adopted:
            given[stage_cache.ADOPTED] = inputs.base.adopted.inputs
        if inputs.slim:
            given["slim"] = inputs.slim.digest
        if inputs.base.addons:
            given["addons"] = [*inputs.base.addons.parts.values()]
        return stage_cache.keys(
            given | {"skip-keys": values.skip_keys, "conditions": inputs.conditions},
            [
                *(contexts[name] for name in names),
                *(app_bake_file.SCRIPTS / name for name in ("containerize", "build", "ros")),
            ],
            contexts["upstream"],
            contexts["target"],
            contexts["downstream"],
            f"{values.cmake_args}\0{values.colcon_args}" if values.colcon_args else values.cmake_args,
            str(values.tests),
            inputs.hooked,
        )

    def _test(self, left: Path, built: Built) -> None:
        """Reads the test reports.

        Raises:
            RosmlError: a test failed; no image is made.
        """
        found = report.tests(left, self.report, self._names.platforms)
        built.tests, built.slim_tests, built.downstream_tests = found.target, found.slim, found.downstream
        built.reports = str(self.report if len(self._names.platforms) > 1 else self.report / report.TARGET)
        self._require_passed(built)

    def _require_complete(self, built: Built) -> None:
        """Checks that the images have everything that the install space needs and had in the build and its tests.

        Raises:
            RosmlError: something is lost; no image is made.
        """
        for which, lost in (
            ("run", built.outcome.lost if "run" in self._names.targets else []),
            (SLIM, built.outcome.slim_lost),
        ):
            if lost:
                raise RosmlError(
                    f"the {which} image would lack what the tests had; no image was made{_lines(lost)}",
                    "install it with the package that it is of, or name the package that has it as exec_depend in"
                    " package.xml; --no-tests makes the images anyway",
                )

    def _require_started(self, built: Built) -> None:
        """Checks that the app installs what the command starts, if the app has it.

        Raises:
            RosmlError: it does not; no image is made.
        """
        if not {"run", SLIM} & {*self._names.targets}:
            return
        built.unstarted = unstarted(self._values.command, built.outcome.forgotten)
        if built.unstarted and self._values.tests:
            raise RosmlError(
                f"the command starts what is not installed; no image was made{_lines(built.unstarted)}",
                "install it: install(DIRECTORY launch DESTINATION share/${PROJECT_NAME}) or install(PROGRAMS …) in"
                " CMakeLists.txt, data_files or entry_points in setup.py; --no-tests makes the images anyway",
            )

    def _require_passed(self, built: Built) -> None:
        """Checks that no test failed.

        Raises:
            RosmlError: a test failed; no image is made.
        """
        reports = f"\n  reports: {self.report}"
        ran = built.tests.count and not built.tests.failures
        missing = any("No module named " in line for line in built.tests.failures)
        if built.outcome.slim_replaced is not None and ran and not built.slim_tests.count:
            text = f"none of {built.tests.count} tests ran in the slim image; no image was made"
            raise RosmlError(text, "leave out the slim image with --no-enable-slim, or report this")
        for tests, where, remedy in (
            (
                built.tests,
                "",
                f"{'name what has the module in package.xml, as test_depend; or ' if missing else ''}"
                "correct the packages or their tests; --no-tests makes the images without tests",
            ),
            (
                built.downstream_tests,
                " in packages that use yours",
                "correct yours or theirs, or leave --downstream-workspace out",
            ),
            (
                built.slim_tests,
                " in the slim image, and passed in the build",
                "name what they need to run in package.xml, as exec_depend; or leave the slim image out: --no-enable-slim",
            ),
        ):
            if tests.failures:
                count = f"{len(tests.failures)} of {tests.count} tests failed"
                raise RosmlError(f"{count}{where}; no image was made{_lines(tests.failures)}{reports}", remedy)


def _parts(*bases: app_base.Base | None) -> dict[str, str]:
    """The parts that base images get for add-ons, as `AddOns.parts`."""
    return {name: where for base in bases if base and base.addons for name, where in base.addons.parts.items()}


def require_locked(locked: lock.Lock | None, wanted: str, base: app_base.Base, slim: app_base.Base | None) -> None:
    """Checks that a lock file is of the wanted add-ons. It may have more parts if it has a slim image, and none is built now.

    Args:
        wanted: the user's names of add-ons.

    Raises:
        RosmlError: it is of others (exit code 2).
    """
    if locked is None:
        return
    known, parts = locked.addons or {}, _parts(base, slim)
    more = wanted and locked.slim_base_image and slim is None
    if parts.keys() - known.keys() or not (more or parts.keys() == known.keys()):
        text = f"the lock file is of {some(known) or 'no add-ons'}, and not of {some(parts) or 'none'}"
        raise RosmlError(text, lock.RENEW, exit_code=2)


STARTS = re.compile(r"\b(roslaunch|rosrun|ros2\s+launch|ros2\s+run)\s+(?:-\S+\s+)*([\w.-]+)\s+([\w.-]+)")
"""A program of ROS that starts something of a package."""


def unstarted(command: str, forgotten: Mapping[str, str]) -> list[str]:
    """The files that a command starts, and that their packages do not install.

    Args:
        forgotten: as in `Outcome`.
    """
    asked = dict.fromkeys(f"{package} {name}" for _, package, name in STARTS.findall(command))
    return [
        f"{key.partition(' ')[2]} of {key.partition(' ')[0]}: {forgotten[key]}" for key in asked if key in forgotten
    ]


def _lines(found: Sequence[str]) -> str:
    """The first of many lines, for a message."""
    more = [f"and {len(found) - SHOWN} more"] if len(found) > SHOWN else []
    return "".join(f"\n    {line}" for line in [*found[:SHOWN], *more])


def _take(built: Built, said: report.Said, slim: bool) -> None:
    """Takes the report of rosml's own steps. `slim`: also that of the slim image."""
    dependencies, apps = said.dependencies(), said.apps()
    slim_apps = said.slim_apps() if slim else []
    _require_built([*dependencies.packages], apps)
    lost = {line for app in apps for line in app.lost}
    built.outcome = Outcome(
        packages=[*dependencies.packages],
        keys=dependencies.keys,
        installed=apps[0].packages,
        changed=apps[0].changed,
        replaced=_replaced(apps),
        slim_replaced=_replaced(slim_apps) if slim else None,
        outside=apps[0].outside,
        lost=sorted(lost),
        slim_lost=sorted({line for app in slim_apps for line in app.lost} - lost),
        absent=sorted({line for app in (*apps, *slim_apps) for line in app.absent}),
        forgotten={key: place for app in apps for key, place in app.forgotten.items()},
        added=lock.added(app.model_dump() for app in (*apps, *slim_apps)),
    )


def _require_built(packages: Sequence[str], apps: Iterable[report.Facts]) -> None:
    """Checks that all packages with a manifest are in the install space, on every platform.

    Raises:
        RosmlError: colcon skipped some; no image is made.
    """
    if missing := [name for name in packages if not all(name in app.built for app in apps)]:
        raise RosmlError(
            f"colcon has not built {', '.join(missing)}; no image was made",
            "see its messages about them above, such as an unknown <build_type>; or put COLCON_IGNORE into them",
        )


def _pins(repositories: Iterable[sources.Repository]) -> dict[str, lock.Pin]:
    return {item.path: lock.Pin(url=item.url, version=item.version, commit=item.commit) for item in repositories}


def _replaced(apps: Iterable[report.Facts]) -> list[str]:
    """The packages and files of the base image that an app's packages replace or remove, on any platform."""
    return sorted({name for app in apps for name in (*app.replaced, *app.removed)})
