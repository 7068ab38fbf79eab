"""The stages of a build: which of them a cache has, and the builder's calls that make the others and join the images."""

from __future__ import annotations

import contextlib
import functools
import re
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize.build import adopt, attachments, bake_file, contexts, outcome, report, stage_cache, verdict
from rosml.containerize.build.bake_file import ASKED, REPORT, RESULTS, Inputs, Recipe
from rosml.containerize.build.call import Call
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.result import Image, ShellImage
from rosml.containerize.build.stage_cache import IDENTIFIED, Cache, Keys
from rosml.containerize.lock import Lock
from rosml.containerize.names import DESK, DEV
from rosml.containerize.packages import workspace
from rosml.containerize.sources.fetch import Repository
from rosml.images.builds.contents import FACTS
from rosml.machine import buildx
from rosml.registry import references
from rosml.registry.client import Registries

_UNAVAILABLE = re.compile(
    r"Unable to locate package ([a-z0-9][a-z0-9.+-]*)|Package '([^' ]+)' has no installation candidate"
)
"""apt's messages about a package that no source has."""


@dataclass(frozen=True)
class Stages:
    recipe: Recipe
    keys: Keys | None  # None without a cache

    @property
    def call(self) -> Call:
        return self.recipe.call


@dataclass(frozen=True)
class Packages:
    outcome: Outcome
    tests: report.TestResults
    reports: str  # the folder of the tests' JUnit files; empty if an earlier build passed them
    load: Callable[[str], bytes]  # reads the contents of an image, by a name as in `AppReport.details`
    details: Callable[[], Mapping[str, bytes]]  # reads all contents that no cache has


def open_cache(call: Call) -> contextlib.AbstractContextManager[Cache | None]:
    """The cache that the user names. A build that renews the lock file takes nothing from it: what is there may be outdated."""
    if call.values.cache and not call.renew:
        return Cache(call.values.cache, call.services.ca_bundle)
    return contextlib.nullcontext()


def choose(call: Call, inputs: Inputs, followed_lock: Lock | None, cache: Cache | None) -> Stages:
    """Which stages the cache has, and which are built. Fetches rosdep's lists only if a stage reads them."""
    by_name = bool(call.values.rosdep_index)
    if by_name or not cache:
        inputs = contexts.with_rosdep_lists(call, inputs, followed_lock)
    if not cache:
        return Stages(Recipe(call, inputs), None)
    keys = stage_cache.keys(inputs, call.names.platforms)
    cached = cache.stages(keys)
    if not by_name and IDENTIFIED not in cached:
        inputs = contexts.with_rosdep_lists(call, inputs, followed_lock)
    pushed = {stage: cache.reference(tag) for stage, tag in keys.stages.items() if stage not in cached}
    return Stages(Recipe(call, inputs, cached, pushed), keys)


def earlier_build(stages: Stages, cache: Cache | None) -> Packages | None:
    """The packages of an earlier build from the same inputs, if the cache has all stages that images join."""
    if not cache or not stages.keys or {*stages.recipe.inputs.stages} - stages.recipe.cached_stages.keys():
        return None
    kept = cache.report(stages.keys)
    if kept is None:
        return None
    stages.call.say(f"nothing to build: {stages.call.values.cache} has it")
    load = functools.partial(cache.detail, stages.keys)
    return Packages(kept.outcome, report.TestResults(kept.passed), "", load, dict)


def build_packages(stages: Stages) -> Packages:
    """Builds the packages and runs their tests. Only some failed tests end the build."""
    recipe, call = stages.recipe, stages.call
    shutil.rmtree(call.reports, ignore_errors=True)
    for name in (REPORT, RESULTS, ASKED):
        recipe.archive(name).unlink(missing_ok=True)
    file = _write_bake_file(call, bake_file.render(recipe))
    _install_ros(recipe)
    try:
        _bake(recipe, bake_file.PACKAGES, file)
    except buildx.StepFailed as error:
        if error.stage == bake_file.PASSED:
            buildx.run(call.services, _bake_call(call, bake_file.FAILED, file, "read the reports of the tests"))
            verdict.require_passed(_test_results(recipe), call.reports, slim=False)
        raise
    app_report = report.of_app(recipe.archive(REPORT), call.state / "said", call.names.platforms)
    dependencies, apps = app_report.dependencies(), app_report.apps()
    verdict.require_built(dependencies.packages, apps)
    built = outcome.of_reports(dependencies, apps, app_report.apps(report.SLIM_APP) if recipe.inputs.slim else None)
    tests, reports = report.TestResults(), ""
    if call.values.tests:
        tests = _test_results(recipe)
        reports = str(call.reports if len(call.names.platforms) > 1 else call.reports / report.TARGET)
    return Packages(built, tests, reports, app_report.detail, app_report.details)


def _test_results(recipe: Recipe) -> report.TestResults:
    return report.of_tests(recipe.archive(RESULTS), recipe.call.reports, recipe.call.names.platforms)


def join_images(stages: Stages, built: Outcome, lock: Lock) -> tuple[Image, ...]:
    call = stages.call
    file = _write_bake_file(call, bake_file.render(stages.recipe, built.replacing, lock.line()))
    first, *others = targets = stages.recipe.inputs.targets
    bake = buildx.Bake(first, f"containerize-{call.state.name}-images", file, beside=others)
    _progress, metadata = buildx.run_all(call.services, bake)
    fact = f"containerimage.{'config.' if call.names.loads else ''}digest"
    return tuple(
        Image(target, call.names.reference(target), metadata.get(target, {}).get(fact, "")) for target in targets
    )


def attach_contents(
    stages: Stages, images: Sequence[Image], packages: Packages, upstream: Sequence[Repository]
) -> tuple[str, ...]:
    """Attaches SBOMs to images in a registry; to those to run, also a list of files and facts. Returns those that have them: some
    registries refuse."""
    call = stages.call
    if not call.values.sbom or call.names.loads:
        return ()
    owners = {
        name: repository
        for repository in upstream
        for name in workspace.names(call.state / "manifests" / "upstream" / repository.path)
    }
    described = []
    with Registries(call.services.ca_bundle) as registries:
        for image in images:
            replaces = image.target in packages.outcome.replacing
            kinds = [kind for kind in report.DESCRIBED[image.target] if kind != FACTS or not replaces]
            load = functools.partial(_contents, packages, image.target)
            place = references.parse(image.reference)
            registry = registries(place.host)
            base = stages.recipe.inputs.base_of(image.target)
            origins = attachments.Origins(owners, functools.partial(attachments.parts_of, registries, base))
            try:
                attachments.attach(registry, place.repository, image.digest, load, origins, kinds)
            except RosmlError as error:
                call.say(f"{image.reference} lacks its SBOM or its list of files: {error.message}")
            else:
                described.append(image.reference)
    return tuple(described)


def _contents(packages: Packages, target: str, platform: str, kind: str) -> bytes:
    """What a build says of an image. One to work on has the sources of the packages that the run image has."""
    data = packages.load(f"{target}/{platform}/{kind}")
    return attachments.with_sources(data, packages.load(f"run/{platform}/{kind}")) if target == DEV else data


def build_shell_image(stages: Stages) -> ShellImage:
    call = stages.call
    file = _write_bake_file(call, bake_file.render_shell_image(stages.recipe))
    _install_ros(stages.recipe)
    metadata = _bake(stages.recipe, DESK, file)
    reference = call.names.reference(DESK)
    if not call.names.loads:
        reference = f"{reference.rpartition(':')[0]}@{metadata.get('containerimage.digest', '')}"
    return ShellImage(reference, call.names.loads)


def _write_bake_file(call: Call, text: str) -> Path:
    file = call.state / "bake.json"
    files.write(file, text)
    return file


def _install_ros(recipe: Recipe) -> None:
    """Installs ROS on a base image without it, one app after the other. All other steps wait for nobody."""
    base, call = recipe.inputs.base, recipe.call
    if base.adopted and bake_file.BASE not in recipe.cached_stages:
        adopt.make(base, call.services, call.environment, call.names.platforms, "", "type=cacheonly")


def _bake(recipe: Recipe, target: str, file: Path) -> Mapping[str, str]:
    """Builds a target that installs packages. Returns the builder's facts about it."""
    try:
        return buildx.run(recipe.call.services, _bake_call(recipe.call, target, file))[1]
    except RosmlError as error:
        _explain_unavailable(recipe, error, file)
        raise


def _bake_call(call: Call, target: str, file: Path, glance: str = "") -> buildx.Bake:
    name = f"containerize-{call.state.name}" + (f"-{target}" if glance else "")
    secrets = bake_file.script_secrets(call.values) if call.values.allow_script_secrets else {}
    return buildx.Bake(
        target,
        name,
        file,
        variables={"PARALLEL_JOBS": call.values.parallel_jobs, **secrets},
        foreign=bake_file.FOREIGN,
        glance=glance,
        hidden=call.values.git_https_password.splitlines(),
    )


def _explain_unavailable(recipe: Recipe, error: RosmlError, file: Path) -> None:
    """If a build failed because apt lacks packages, adds to the error which rule of rosdep names them, and which package
    asks for that rule. The steps that install them do not know: they run again only if the packages differ."""
    unavailable = {name for names in _UNAVAILABLE.findall(error.message) for name in names if name}
    if not unavailable:
        return
    with contextlib.suppress(RosmlError):
        call = recipe.call
        buildx.run(call.services, buildx.Bake(ASKED, f"containerize-{call.state.name}-asked", file))
        dependencies = report.of_app(recipe.archive(ASKED), call.state / "asked", call.names.platforms).dependencies()
        wrong_rules = set()
        for key, answers in dependencies.keys.items():
            users = [
                name for name, kinds in dependencies.packages.items() if any(key in keys for keys in kinds.values())
            ]
            for name in sorted(unavailable & {name for answer in answers for name in answer.names}):
                wrong_rules.add(key)
                by = ", ".join(users) or "a package of the downstream workspace"
                error.message += f"\n  rosdep's rule for {key}, which {by} asks for, names {name}"
        if wrong_rules:
            error.remedy = (
                "if the archive never had it, correct the rule, or name other lists with --rosdep-index; or leave out what"
                f" your packages run without: --skip-keys '{' '.join(sorted(wrong_rules))}'"
            )
