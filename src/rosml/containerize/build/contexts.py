"""The folders that the builder gets: sources, manifests, and what the repository's files ask for."""

from __future__ import annotations

import functools
import shlex
import shutil
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, some
from rosml.containerize import within
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.base_image.base import Base
from rosml.containerize.build.bake_file import Inputs
from rosml.containerize.build.call import Call
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.lock import Lock
from rosml.containerize.names import SLIM
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.sources import fetch as sources
from rosml.containerize.sources.git import Access
from rosml.images.image_set.system import CALLED, DEBIAN
from rosml.machine import buildx, git, mirrors

TIME = 1767225600
"""2026-01-01T00:00:00Z: the time of images whose sources are in no commit."""


@dataclass(frozen=True)
class Fetched:
    """The repositories that `.repos` files name: those that the app needs, and those of the downstream workspace."""

    upstream: Sequence[sources.Repository]
    downstream: Sequence[sources.Repository]


def fetch(call: Call, followed_lock: Lock | None) -> Fetched:
    values = call.values
    access = Access(
        https_server=values.git_https_server,
        https_user=values.git_https_user,
        https_password=values.git_https_password,
        ssh_key=values.git_ssh_private_key,
        ssh_known_hosts=values.git_ssh_known_host_keys,
    )
    into = functools.partial(
        sources.fetch,
        call.folder,
        cache=call.services.state / "cache" / "git",
        access=access,
        say=call.say,
    )
    list_file = values.downstream_workspace
    options = sources.Options(
        recursive=values.enable_recursive_vcs_import,
        file=values.vcs_import_file,
        without=list_file,
        pins=followed_lock.repositories if followed_lock else None,
        local=values.allow_file_urls,
    )
    upstream = into(call.state / "upstream", options=options)
    place = call.state / "downstream"
    if not list_file:
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        return Fetched(upstream, ())
    if not within.exists(call.folder / list_file, call.folder):
        text = f"downstream-workspace: there is no file {list_file} in {call.folder}"
        raise RosmlError(text, "name a .repos file there; other forms of industrial_ci do not count", exit_code=2)
    # If it was added after the lock file was written, it is the newest.
    pins = followed_lock.downstream if followed_lock and followed_lock.downstream else None
    options = replace(options, recursive=False, file=list_file, without="", pins=pins)
    return Fetched(upstream, into(place, options=options))


def write(call: Call, base: Base, slim: Base | None, followed_lock: Lock | None) -> Inputs:
    """Writes the folders. Says what of them may surprise."""
    values, folder, state, say = call.values, call.folder, call.state, call.say
    distribution, conditions = _distribution(call, base)
    staged, empty, requests, manifests = (state / name for name in ("staged", "empty", "requests", "manifests"))
    roots = {"target": folder, "upstream": state / "upstream", "downstream": state / "downstream"}
    private = workspace.stage(folder, staged / "target", call.lock_file, IgnoredFiles(folder))
    empty.mkdir(parents=True, exist_ok=True)
    if not values.allow_mirror_password:
        mirrors.require_no_password(call.environment)
    counts = _write_manifests(call, roots, manifests)
    of_base = replace(values, ros_distro=distribution)
    workspace.write_requests(of_base, folder, roots["upstream"], base.environment, requests)
    if followed_lock:
        followed_lock.write_requests(requests)
    if call.renew:  # an earlier build may have installed older versions
        (requests / "renewed").write_text(f"{time.time()}\n")
    _say_odd_sources(call, staged / "target", private)
    if unread := workspace.unread_lists(requests, staged / "target"):
        say(
            f"pip does not install what {some(unread)} names: that takes --additional-pip-file {shlex.quote(unread[0])}"
        )
    packages = counted(counts["target"] + counts["upstream"], "package")
    packages += f", and {counts['downstream']} that use them," if counts["downstream"] else ""
    say(f"{packages} for {', '.join(call.names.platforms)}")
    additional = workspace.additional_files(values.additional_files_dir, folder)
    workspace.stage_additional(additional, state / "additional", IgnoredFiles(folder))
    if values.allow_script_secrets:
        say(
            "the scripts before and after the installation of dependencies get your git-https-password (--allow-script-secrets)"
        )
    if local := buildx.local_servers(call.services):
        say(
            f"{' and '.join(local)}: on this machine, so steps of the build share its network: the repository's code"
            " reaches what listens here"
        )
    hooked = any((requests / workspace.IDENTIFICATION).iterdir())
    if not hooked:  # a script may make other packages
        _require_buildable(call, base, conditions, requests, manifests)
    commit = git.commit(folder, say) or git.Commit("", TIME)
    return Inputs(
        targets=tuple(target for target in call.names.targets if slim or target != SLIM),
        base=base,
        slim=slim,
        distribution=distribution,
        conditions=conditions,
        values=values,
        contexts={
            **roots,
            "target": staged,
            "manifests": manifests,
            "requests": requests,
            "additional": state / "additional" if additional else empty,
            "rosdep": empty,
        },
        empty=empty,
        hooked=hooked,
        commit=commit.hash,
        time=commit.time,
    )


def _distribution(call: Call, base: Base) -> tuple[str, str]:
    """The ROS distribution, and the one with which conditions in manifests compare."""
    values, say = call.values, call.say
    distribution = base.environment.get("ROS_DISTRO") or values.ros_distro
    if distribution == DEBIAN:
        debians = {base.adopted.image.distribution, DEBIAN} if base.adopted else {DEBIAN}
        conditions = CALLED if values.ros_distro in debians else values.ros_distro or CALLED
        if conditions != CALLED:
            say(f"conditions in package.xml compare $ROS_DISTRO with {conditions}, which --ros-distro names")
        return distribution, conditions
    if values.ros_distro not in ("", distribution):
        say(f"ROS_DISTRO={values.ros_distro} is not used: the base image has {distribution}")
    if not distribution:
        text = f"{base.name} does not say which ROS it has"
        raise RosmlError(text, "add --ros-distro, such as jazzy", exit_code=2)
    return distribution, distribution


def _write_manifests(call: Call, roots: Mapping[str, Path], out: Path) -> dict[str, int]:
    counts = workspace.write_manifests(roots, out, call.say)
    if call.values.downstream_workspace and not counts["downstream"]:
        text = f"downstream-workspace: the repositories of {call.values.downstream_workspace} have no package"
        raise RosmlError(text, "name some that have, or leave the input out", exit_code=2)
    return counts


def _say_odd_sources(call: Call, staged: Path, private: Sequence[str]) -> None:
    """Says what of a repository is not as its authors may expect. `private`: files that others may not read there."""
    for path in workspace.empty_submodules(call.folder):
        call.say(f"the submodule {path} is not there: git submodule update --init --recursive")
    if pointers := workspace.pointers(staged):
        more = f" and {counted(len(pointers) - 1, 'file')} more" if len(pointers) > 1 else ""
        call.say(f"{pointers[0]}{more} of Git LFS: only a pointer is there, and gets into the images: git lfs pull")
    if private:
        call.say(f"in the images everybody may read {some(sorted(private))}, which others may not read here (umask)")


def _require_buildable(call: Call, base: Base, conditions: str, requests: Path, manifests: Path) -> None:
    """Checks that packages are for the ROS of the base image, if it says which, and that they can be built one after another."""
    for warning in workspace.stale(requests, manifests):
        call.say(warning)
    ros = base.environment.get("ROS_VERSION", "")
    without = {*(requests / workspace.BLACKLIST).read_text().split()}
    manifest.require_order(manifests, {"ROS_VERSION": ros, "ROS_DISTRO": conditions}, without)
    if ros in ("1", "2"):
        manifest.require_one_ros(call.folder, base.name, int(ros), conditions, without)


def with_rosdep_lists(call: Call, inputs: Inputs, followed_lock: Lock | None) -> Inputs:
    """The inputs with rosdep's lists, if there are others than the image's own."""
    name = call.values.rosdep_index
    pin = followed_lock.rosdep_index.of(name) if followed_lock and followed_lock.rosdep_index else ""
    finder = rosdep_index.Finder(call.services, call.folder, call.say)
    lists = finder.find(name, inputs.base, pin, followed_lock is not None)
    if not lists:
        return inputs
    index, digest = lists
    if not digest:
        index = rosdep_index.copied(index, call.state / "rosdep")
    return replace(inputs, contexts={**inputs.contexts, "rosdep": index}, rosdep=digest)
