"""What stops an image: before the build, base images that do not fit; after it, packages and tests that failed."""

from __future__ import annotations

import functools
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.problems import SHOWN, listed, some
from rosml.containerize import lock
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import bases
from rosml.containerize.build.bake_file import Inputs
from rosml.containerize.build.call import Call
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.report import Facts, TestResults
from rosml.containerize.inputs import Values
from rosml.containerize.lock import Lock
from rosml.containerize.names import SLIM
from rosml.containerize.packages import manifest, workspace
from rosml.images.image_set import restricted
from rosml.images.image_set.labels import ENVIRONMENTS, PREFIX
from rosml.images.matrix import lacks
from rosml.registry import references
from rosml.registry.client import Registries

STARTS = re.compile(r"\b(roslaunch|rosrun|ros2\s+launch|ros2\s+run)\s+(?:-\S+\s+)*([\w.-]+)\s+([\w.-]+)")
"""A program of ROS that starts something of a package."""


# ---- Before the build ------------------------------------------------------------------------------------------------


def require_kept_platforms(call: Call) -> None:
    """Checks that no tag in a registry loses a platform."""
    if not call.names.loads:
        with Registries(call.services.ca_bundle) as registries:
            tags = [tag for target in call.names.targets for tag in call.names.tags(target)]
            app_base.require_kept(registries, tags, call.names.platforms)


def require_same_addons(followed_lock: Lock | None, values: Values, base: Base, slim: Base | None) -> None:
    """Checks that a lock file is of the wanted add-ons and environments. It may have more if it has a slim image, and none is built now."""
    if followed_lock is None:
        return
    locked_parts, parts = followed_lock.addons or {}, bases.parts(base, slim)
    has_some = values.addons or values.environments or base.labels.get(ENVIRONMENTS)
    may_have_more = has_some and followed_lock.slim_base_image and slim is None
    if parts.keys() - locked_parts.keys() or not (may_have_more or parts.keys() == locked_parts.keys()):
        text = f"the lock file is of {some(locked_parts) or 'no parts'}, and not of {some(parts) or 'none'}"
        raise RosmlError(text, lock.RENEW, exit_code=2)


def require_allowed(call: Call, base: Base, slim: Base | None) -> None:
    """Checks that base images may go to the registries of the app and of its cache: they may have restricted parts."""
    targets = [] if call.names.loads else [target for target in call.names.targets if slim or target != SLIM]
    places = {tag for target in targets for tag in call.names.tags(target)} | {*filter(None, [call.values.cache])}
    declared = functools.cache(restricted.of_this_machine)
    for image in filter(None, (base, slim)):
        for place in map(references.parse, sorted(places)):
            if parts := restricted.parts_of({**image.labels, **(image.addons.labels if image.addons else {})}):
                notice = restricted.require(parts, image.name, place.host, place.repository, declared())
                if notice:
                    call.say(notice)


def require_build_files(call: Call, inputs: Inputs) -> None:
    """Checks that colcon can build the packages of the folder, unless a script may still change them."""
    if not inputs.hooked:
        staged = inputs.contexts["target"] / "target"
        manifest.require_build_files(call.folder, staged, _variables(inputs), _left_out(inputs))


def require_provided(call: Call, inputs: Inputs) -> None:
    """Checks that the packages of the folder need nothing that the distribution of the base image lacks (matrix.yaml), unless the
    workspace has it, or a script may still change them."""
    base, matrix = inputs.base, addons.rosml_matrix()
    distribution = app_base.distribution(base, matrix)
    if inputs.hooked or not distribution:
        return
    lacking = {*matrix.distributions[distribution].lacks}.difference(
        workspace.names(inputs.contexts["manifests"]), re.split(r"[\s,]+", call.values.skip_keys)
    )
    needs = manifest.needed(call.folder, _variables(inputs), _left_out(inputs))
    keys = {key for needed in needs.values() for key in lacking & needed}
    if not keys:
        return
    users = [path for path, needed in needs.items() if lacking & needed]
    framework, stack = (base.labels.get(f"{PREFIX}{name}", "") for name in ("framework", "stack"))
    tag = lacks.instead(matrix, distribution, keys, framework, stack)
    place = "" if base.adopted else f"{base.repository.rpartition('/')[0]}/"
    remedy = f"take {tag}: --base-image {place}{tag}" if tag else "name another base image"
    text = (
        f"{base.name} lacks {listed(sorted(keys))}, which {some(users)} {'depends' if len(users) == 1 else 'depend'} on"
    )
    raise RosmlError(
        text,
        f"{remedy}; or leave out what your packages run without: --skip-keys '{' '.join(sorted(keys))}'",
        exit_code=2,
    )


def _variables(inputs: Inputs) -> dict[str, str]:
    """What conditions in manifests compare with."""
    return {"ROS_VERSION": inputs.base.environment.get("ROS_VERSION", ""), "ROS_DISTRO": inputs.conditions}


def _left_out(inputs: Inputs) -> set[str]:
    return {*(inputs.contexts["requests"] / workspace.BLACKLIST).read_text().split()}


# ---- After the packages were built -----------------------------------------------------------------------------------


def require_built(packages: Iterable[str], apps: Collection[Facts]) -> None:
    """Checks that all packages with a manifest are in the install space, on every platform."""
    if missing := [name for name in packages if not all(name in app.built for app in apps)]:
        raise RosmlError(
            f"colcon has not built {', '.join(missing)}; no image was made",
            "see its messages about them above, such as an unknown <build_type>; or put COLCON_IGNORE into them",
        )


def require_passed(tests: TestResults, reports: Path, slim: bool) -> None:
    """Checks that no test failed, and that tests ran in the slim image, if there is one."""
    if slim and tests.target.count and not tests.target.failures and not tests.slim.count:
        text = f"none of {tests.target.count} tests ran in the slim image; no image was made"
        raise RosmlError(text, "leave out the slim image with --no-enable-slim, or report this")
    lacks_module = any("No module named " in line for line in tests.target.failures)
    for results, where, remedy in (
        (
            tests.target,
            "",
            f"{'name what has the module in package.xml, as test_depend; or ' if lacks_module else ''}"
            "correct the packages or their tests; --no-tests makes the images without tests",
        ),
        (
            tests.downstream,
            " in packages that use yours",
            "correct yours or theirs, or leave --downstream-workspace out",
        ),
        (
            tests.slim,
            " in the slim image, and passed in the build",
            "name what they need to run in package.xml, as exec_depend; or leave the slim image out: --no-enable-slim",
        ),
    ):
        if results.failures:
            count = f"{len(results.failures)} of {results.count} tests failed"
            lines = _lines(results.failures)
            raise RosmlError(f"{count}{where}; no image was made{lines}\n  reports: {reports}", remedy)


def require_complete(outcome: Outcome, targets: Collection[str]) -> None:
    """Checks that the images have everything that the install space needs and had in the build and its tests."""
    for name, lost in (("run", outcome.lost if "run" in targets else []), (SLIM, outcome.slim_lost)):
        if lost:
            raise RosmlError(
                f"the {name} image would lack what the tests had; no image was made{_lines(lost)}",
                "install it with the package that it is of, or name the package that has it as exec_depend in"
                " package.xml; --no-tests makes the images anyway",
            )


def require_started(call: Call, outcome: Outcome, targets: Collection[str]) -> list[str]:
    """Checks that the app installs what the command starts, if the app has it. Without tests, returns what it does not."""
    if not {"run", SLIM} & {*targets}:
        return []
    missing_files = unstarted(call.values.command, outcome.forgotten)
    if missing_files and call.values.tests:
        raise RosmlError(
            f"the command starts what is not installed; no image was made{_lines(missing_files)}",
            "install it: install(DIRECTORY launch DESTINATION share/${PROJECT_NAME}) or install(PROGRAMS …) in"
            " CMakeLists.txt, data_files or entry_points in setup.py; --no-tests makes the images anyway",
        )
    return missing_files


def unstarted(command: str, forgotten: Mapping[str, str]) -> list[str]:
    """The files that a command starts, and that their packages do not install. `forgotten` as in `Outcome`."""
    keys = dict.fromkeys(f"{package} {name}" for _, package, name in STARTS.findall(command))
    return [f"{key.partition(' ')[2]} of {key.partition(' ')[0]}: {forgotten[key]}" for key in keys if key in forgotten]


def _lines(texts: Sequence[str]) -> str:
    more = [f"and {len(texts) - SHOWN} more"] if len(texts) > SHOWN else []
    return "".join(f"\n    {line}" for line in [*texts[:SHOWN], *more])
