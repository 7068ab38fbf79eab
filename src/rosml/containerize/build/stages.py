"""What is built, and what a cache has: the stages of the packages, then the images that join them."""

from __future__ import annotations

import contextlib
import functools
import re
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize.build import adopt, attachments, bake_file, contexts, outcome, report, stage_cache, verdict
from rosml.containerize.build.bake_file import ASKED, REPORT, RESULTS, Inputs, Recipe
from rosml.containerize.build.call import Call
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.result import Image, ShellImage
from rosml.containerize.build.stage_cache import IDENTIFIED, Cache, Keys, StageInputs
from rosml.containerize.lock import Lock
from rosml.containerize.names import DESK
from rosml.containerize.packages import workspace
from rosml.containerize.sources.fetch import Repository
from rosml.machine import buildx
from rosml.registry import references
from rosml.registry.client import Registries

_UNAVAILABLE = re.compile(
    r"Unable to locate package ([a-z0-9][a-z0-9.+-]*)|Package '([^' ]+)' has no installation candidate"
)
"""apt's messages about a package that no source has."""


@dataclass(frozen=True)
class Stages:
    """The stages of an app. `keys` is None if there is no cache."""

    recipe: Recipe
    keys: Keys | None


@dataclass(frozen=True)
class Packages:
    """The built packages.

    Attributes:
        reports: the folder of the tests' JUnit files; empty if an earlier build passed them.
        load: reads the contents of an image, by a name as in `AppReport.details`.
        details: reads all of them, for a cache; None if they are from there.
    """

    outcome: Outcome
    tests: report.TestResults
    reports: str
    load: Callable[[str], bytes]
    details: Callable[[], Mapping[str, bytes]] | None = None


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
    archives = {name: call.state / f"{name}.tar" for name in (REPORT, RESULTS, ASKED)}
    recipe = Recipe(inputs, call.names, call.services, [*call.environment], archives)
    if not cache:
        return Stages(recipe, None)
    keys = _stage_inputs(call, inputs).keys()
    cached = cache.stages(keys)
    if not by_name and IDENTIFIED not in cached:
        inputs = contexts.with_rosdep_lists(call, inputs, followed_lock)
    pushed = {stage: cache.reference(tag) for stage, tag in keys.stages.items() if stage not in cached}
    return Stages(replace(recipe, inputs=inputs, cached_stages=cached, pushed_stages=pushed), keys)


def _stage_inputs(call: Call, inputs: Inputs) -> StageInputs:
    values, folders = inputs.values, inputs.contexts
    names = ["manifests", "requests", "additional"]
    if values.rosdep_index:  # other lists are the newest, and change every day for nothing
        names.append("rosdep")
    decisive: dict[str, object] = {"base": inputs.base.digest, "platforms": call.platforms, "ros": inputs.distribution}
    if inputs.base.adopted:
        decisive[stage_cache.ADOPTED] = inputs.base.adopted.inputs
    if inputs.slim:
        decisive["slim"] = inputs.slim.digest
    if inputs.base.addons:
        decisive["addons"] = [*inputs.base.addons.parts.values()]
    scripts = [bake_file.SCRIPTS / name for name in ("containerize", "build", "ros")]
    return StageInputs(
        decisive | {"skip-keys": values.skip_keys, "conditions": inputs.conditions},
        [*(folders[name] for name in names), *scripts],
        folders["upstream"],
        folders["target"],
        folders["downstream"],
        f"{values.cmake_args}\0{values.colcon_args}" if values.colcon_args else values.cmake_args,
        str(values.tests),
        inputs.hooked,
    )


def earlier_build(call: Call, stages: Stages, cache: Cache | None) -> Packages | None:
    """The packages of an earlier build from the same inputs, if the cache has all stages that images join."""
    if not cache or not stages.keys or {*stages.recipe.inputs.stages} - stages.recipe.cached_stages.keys():
        return None
    kept = cache.report(stages.keys)
    if kept is None:
        return None
    call.say(f"nothing to build: {call.values.cache} has it")
    load = functools.partial(cache.detail, stages.keys)
    return Packages(kept.outcome, report.TestResults(kept.passed), "", load)


def build_packages(call: Call, stages: Stages) -> Packages:
    """Builds the packages and runs their tests.

    Raises:
        RosmlError: a step failed, or a test that ends the build.
    """
    inputs, archives = stages.recipe.inputs, stages.recipe.archives
    shutil.rmtree(call.reports, ignore_errors=True)
    for archive in archives.values():
        archive.unlink(missing_ok=True)
    file = _write_bake_file(call, bake_file.render(stages.recipe))
    _install_ros(call, stages.recipe)
    try:
        _bake(call, bake_file.PACKAGES, file, archives[ASKED])
    except buildx.StepFailed as error:
        if error.stage == bake_file.PASSED:
            buildx.run(call.services, _bake_call(call, bake_file.FAILED, file, "read the reports of the tests"))
            verdict.require_passed(_test_results(call, archives), call.reports, slim=False)
        raise
    app_report = report.of_app(archives[REPORT], call.state / "said", call.platforms)
    dependencies, apps = app_report.dependencies(), app_report.apps()
    verdict.require_built(dependencies.packages, apps)
    built = outcome.of_reports(dependencies, apps, app_report.slim_apps() if inputs.slim else None)
    if not inputs.values.tests:
        return Packages(built, report.TestResults(), "", app_report.detail, app_report.details)
    tests = _test_results(call, archives)
    reports = call.reports if len(call.platforms) > 1 else call.reports / report.TARGET
    return Packages(built, tests, str(reports), app_report.detail, app_report.details)


def _test_results(call: Call, archives: Mapping[str, Path]) -> report.TestResults:
    return report.of_tests(archives[RESULTS], call.reports, call.platforms)


def keep(cache: Cache | None, stages: Stages, packages: Packages) -> None:
    """Keeps the report of packages whose tests passed, for the next build from the same inputs."""
    if cache and stages.keys and packages.details:
        cache.keep(stages.keys, packages.outcome, packages.tests.target, packages.details())


def join_images(call: Call, stages: Stages, built: Outcome, lock: Lock) -> tuple[Image, ...]:
    """Joins the images, and puts them where they belong."""
    file = _write_bake_file(call, bake_file.render(stages.recipe, built.replacing, lock.line()))
    first, *others = targets = stages.recipe.inputs.targets
    bake = buildx.Bake(first, f"containerize-{call.state.name}-images", file, beside=others)
    _progress, metadata = buildx.run_all(call.services, bake)
    fact = f"containerimage.{'config.' if call.names.loads else ''}digest"
    return tuple(
        Image(target, call.names.reference(target), metadata.get(target, {}).get(fact, "")) for target in targets
    )


def attach_contents(
    call: Call, images: Sequence[Image], packages: Packages, upstream: Sequence[Repository]
) -> tuple[str, ...]:
    """Attaches an SBOM, a list of files and facts to images in a registry. Some registries refuse that.

    Returns:
        The images that have them.
    """
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
            if image.target not in report.DESCRIBED:
                continue

            def load(platform: str, kind: str, target: str = image.target) -> bytes:
                return packages.load(f"{target}/{platform}/{kind}")

            place = references.parse(image.reference)
            registry, linked = registries(place.host), image.target not in packages.outcome.replacing
            try:
                attachments.attach(registry, place.repository, image.digest, load, owners, linked)
            except RosmlError as error:
                call.say(f"{image.reference} lacks its SBOM or its list of files: {error.message}")
            else:
                described.append(image.reference)
    return tuple(described)


def build_shell_image(call: Call, stages: Stages) -> ShellImage:
    """Builds the environment of the packages with debuggers, and not the packages."""
    file = _write_bake_file(call, bake_file.render_shell_image(stages.recipe))
    _install_ros(call, stages.recipe)
    metadata = _bake(call, DESK, file, stages.recipe.archives[ASKED])
    reference = call.names.reference(DESK)
    if not call.names.loads:
        reference = f"{reference.rpartition(':')[0]}@{metadata.get('containerimage.digest', '')}"
    return ShellImage(reference, call.names.loads)


def _write_bake_file(call: Call, text: str) -> Path:
    file = call.state / "bake.json"
    files.write(file, text)
    return file


def _install_ros(call: Call, recipe: Recipe) -> None:
    """Installs ROS on a base image without it, one app after the other. All other steps wait for nobody."""
    if recipe.inputs.base.adopted and stage_cache.BASE not in recipe.cached_stages:
        adopt.prepare(recipe.inputs.base, call.services, call.environment, call.platforms)


def _bake(call: Call, target: str, file: Path, identified: Path) -> Mapping[str, str]:
    """Builds a target that installs packages. Returns the builder's facts about it.

    Args:
        file: the bake file.
        identified: the archive of its target `ASKED`.
    """
    try:
        return buildx.run(call.services, _bake_call(call, target, file))[1]
    except RosmlError as error:
        _explain_unavailable(call, error, file, identified)
        raise


def _bake_call(call: Call, target: str, file: Path, glance: str = "") -> buildx.Bake:
    """The call that builds a target with steps. `glance` as in `buildx.Bake`."""
    name = f"containerize-{call.state.name}" + (f"-{target}" if glance else "")
    jobs = {"PARALLEL_JOBS": call.values.parallel_jobs}
    return buildx.Bake(target, name, file, variables=jobs, foreign=bake_file.FOREIGN, glance=glance)


def _explain_unavailable(call: Call, error: RosmlError, file: Path, identified: Path) -> None:
    """If a build failed because apt lacks packages, adds to the error which rule of rosdep names them, and which package
    asks for that rule. The steps that install them do not know: they run again only if the packages differ."""
    unavailable = {name for names in _UNAVAILABLE.findall(error.message) for name in names if name}
    if not unavailable:
        return
    with contextlib.suppress(RosmlError):
        buildx.run(call.services, buildx.Bake(ASKED, f"containerize-{call.state.name}-asked", file))
        dependencies = report.of_app(identified, call.state / "asked", call.platforms).dependencies()
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
