"""Runs `buildx bake` for the publisher: shows progress, keeps a log, and turns failures into errors with a remedy."""

from __future__ import annotations

import os
import re
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from rosml import user_cache
from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.file_lock import holder, turn
from rosml.base.problems import listed
from rosml.machine import mirrors
from rosml.machine.progress import TAIL_LINES, BuildProgress, Step
from rosml.machine.services import Services
from rosml.registry import credentials, failures, references, retries
from rosml.registry.client import Registry

_LOGIN = "docker login, with an account that may push there; then run it again"
_REFUSED = (
    "a package index or mirror refuses this machine: check its address, the user and password in it, and what the proxy"
    " allows; then run it again"
)
_AGAIN = "a mirror or index did not answer; run it again, finished steps are kept"

_NO_BASE = (
    "Docker Hub does not answer: run 'rosml setup', which looks for another way, or name a base image that answers, by its"
    " digest: OS_BOOKWORM=registry.example.com/debian:bookworm@sha256:…"
)

NO_SPACE_REMEDY = (
    "free some disk space, then run it again: 'docker builder prune' empties the cache of Docker, if it builds; 'rosml setup clean'"
    " removes all that was made here"
)
_NO_SPACE = ("no space left on device", NO_SPACE_REMEDY)
_REFUSED_CONNECTION = (
    "connection refused",
    "check HTTP_PROXY, HTTPS_PROXY and the mirrors; if it was the registry or the builder, run 'rosml setup'",
)

_NO_MEMORY_REMEDY = (
    "give the builder more memory, or let fewer compilers run at the same time: rosml containerize --parallel-jobs 1"
)

_Remedies = tuple[tuple[str, str], ...]
_BUILDER_REMEDIES: _Remedies = (
    (
        "x509: certificate signed by unknown authority",
        "put the registry's authority into certs.d/<host>/ca.crt beside Docker's config.json, then run 'rosml setup', which tells"
        " the builder of it",
    ),
    ("x509: certificate has expired", "the registry's operator has to renew its certificate"),
    (r"unexpected status\b.*: 40[13]\b|insufficient_scope|no basic auth credentials", _LOGIN),
    ("failed to calculate checksum of ref", "a file of the build is missing; if it is a lock: run 'rosml locks'"),
    (r"successfully: (exit code: 137\b|cannot allocate memory)", _NO_MEMORY_REMEDY),
    _NO_SPACE,
    (
        r"429 Too Many Requests|\btoomanyrequests\b",
        "the registry limits how often you may ask: wait, or log in, since accounts may ask more often (docker login)",
    ),
    (r"registry-1\.docker\.io", _NO_BASE),
    _REFUSED_CONNECTION,
    (
        "unsupported frontend capability",
        "the builder's BuildKit is too old for contexts with names: update Docker to 23 or newer, or unset BUILDX_BUILDER and run"
        " 'rosml setup', which makes a builder",
    ),
    (
        r"code = Unavailable\b.*\b(error reading from server|connection (error|refused)|closing)",
        "the builder ended, or was restarted: run it again, finished steps are kept",
    ),
    ("network.host is not allowed", "run 'rosml setup', which tells the builder of a mirror on this machine"),
    ("failed to dial", "run 'rosml setup', which starts what is down, then run it again"),
    (
        r"//(127\.|localhost\b|\[::1\])\S*: 500 Internal Server Error",
        "the local registry's storage is damaged: rosml setup down; rm -r .state/registry; run it again",
    ),
)
"""Patterns of BuildKit's messages about problems outside of the build, and remedies."""

_STEP_REMEDIES: _Remedies = (
    (r"(client error \(|returned error: |failed to fetch .* )40[13]\b", _REFUSED),
    ("Hash mismatch", "a download is not what the lock says: run 'rosml locks' if that is intended"),
    ("all requirements must have their versions pinned", "a lock is damaged: run 'rosml locks'"),
    _NO_SPACE,
    ("memory may have run out", _NO_MEMORY_REMEDY),
    ("Could not resolve", "check that this machine reaches the package indexes (proxy? CA bundle?), then run it again"),
    ("Temporary failure resolving", "check that this machine reaches Debian's mirrors, then run it again"),
    ("Failed to fetch|error sending request", _AGAIN),
    _REFUSED_CONNECTION,
)
"""The same for the output of uv, curl and apt in rosml's own steps."""

_SCRIPT_ERROR = re.compile(r"error: .+; .+")
"""The last line of a script of rosml that has the reason and its remedy."""

_APT_DISK_FULL = re.compile(r"\(28: No space left on device\)")
"""apt's words on a full disk. They may stand above a script's error: it takes a list that was cut off for one with a wrong signature."""

CANCEL_SECONDS = 15.0

_PUSH = re.compile(r"failed to push (\S+): (.*)", re.DOTALL)
_STATUS = re.compile(r"unexpected status(?: code)?(?: from \w+ request to)?(?: \S+)?: (\d{3}\b[\w ]*)")
_CUT_OFF = re.compile(r"\bEOF\b|connection (?:reset|refused)|broken pipe|timeout|timed out|no such host", re.IGNORECASE)

_waits: list[float] = []

STEP_NETWORK = "STEP_NETWORK"
"""The variable of bake files with the network of steps: `host` for this machine's; empty for the builder's default."""

_BAKE_VARIABLES = re.compile(
    r"DOCKER_HUB|STEP_NETWORK|PLATFORM|SOURCE_DATE_EPOCH|REVISION|DIGESTS|ROS_SYNC_DATES|OS_(?!APT_MIRROR$).*"
)
"""Variables of the bake file that a shell may have for other reasons, and that would change the build."""


class Unanswered(RosmlError):
    """A build that failed because a registry answered with an error, or not at all."""

    def __init__(self, message: str, remedy: str, answer: str, push_target: str) -> None:
        super().__init__(message, remedy)
        self.answer = answer  # such as `403 Forbidden`
        self.push_target = push_target  # empty if something was pulled


class StepFailed(RosmlError):
    def __init__(self, message: str, remedy: str, stage: str) -> None:
        super().__init__(message, remedy)
        self.stage = stage


@dataclass(frozen=True)
class Bake:
    """One call of `buildx bake`."""

    target: str
    name: str  # of the log, without its ending
    file: Path
    sets: Sequence[str] = ()  # overrides of targets, `target.key=value` each
    variables: Mapping[str, str] = field(default_factory=dict)
    foreign: Sequence[str] = ()  # scripts that run other people's code; its output gets no remedy from rosml
    glance: str = ""  # what a call does that only copies files out of an image; its steps are not shown
    shares: str = ""  # the name of steps that other calls have as well; calls with the same name take turns
    beside: Sequence[str] = ()  # targets that the call builds as well
    hidden: Sequence[str] = ()  # texts that no line of the output shows


IMAGES = "images"
"""The name of the steps that the builds of parts and ROS images share."""


def local_servers(services: Services) -> list[str]:
    """The variables that name a mirror or a proxy on this machine, which only steps with the machine's network can reach."""
    if services.builder_kind == "user":
        return []
    return [name for name in (*mirrors.VARIABLES, *web.PROXIES) if web.is_here(os.environ.get(name, ""))]


def command(services: Services, bake: Bake, metadata: Path) -> list[str]:
    arguments = [*services.buildx, "bake", "--file", str(bake.file), "--progress", "rawjson"]
    arguments += ["--metadata-file", str(metadata)]
    if services.ca_bundle:
        arguments += ["--allow", f"fs.read={services.ca_bundle}"]
    if local_servers(services):
        arguments += ["--allow", "network.host"]
    for item in bake.sets:
        arguments += ["--set", item]
    return [*arguments, bake.target, *bake.beside]


def environment(services: Services, bake: Bake) -> dict[str, str]:
    env = services.trusting()
    # With attestations, the pushed digest would be that of an index that changes with every build. We keep them apart.
    env["BUILDX_NO_DEFAULT_ATTESTATIONS"] = "1"
    env["CA_BUNDLE"] = services.ca_bundle
    for name in [name for name in env if _BAKE_VARIABLES.fullmatch(name)]:
        del env[name]
    for name in ("HTTP_PROXY", "HTTPS_PROXY"):
        env.setdefault(name, os.environ.get(name.lower(), ""))
    env[STEP_NETWORK] = "host" if local_servers(services) else ""
    env.update(bake.variables)
    return env


def output(services: Services, repository: str, target: str) -> str:
    """The builder's output for a target that is pushed into a repository.

    It has no tag, so nobody sees it yet. Docker's own BuildKit pushes by a tag alone, so it gets one for a while.
    """
    if services.is_docker_itself:
        return f"type=image,name={repository}:{passing_tag(target)},push=true,store=false"
    return f"type=image,name={repository},push=true,push-by-digest=true"


def passing_tag(target: str) -> str:
    return f"building-{target}"


def command_on_it(services: Services) -> str:
    """The shell line by which users build their own Dockerfile with this builder, into its registry."""
    config = f"BUILDX_CONFIG={shlex.quote(str(services.buildx_config))} " if services.buildx_config else ""
    password = f'{credentials.VARIABLE}="$(cat {shlex.quote(str(services.state / credentials.OWN))})" '
    # OCI media types: Docker has none for a base image's zstd layers that podman 4 would take.
    output = f"type=image,name={services.registry}/mine,push=true,oci-mediatypes=true"
    return f"{password}{config}{shlex.join(services.buildx)} build --builder {services.builder} --output {output} ."


def waited() -> float:
    """Seconds for which the builds of this process have waited for their turns until now."""
    return sum(_waits)


@contextmanager
def _turn(services: Services, shares: str) -> Iterator[None]:
    if not shares:
        yield
        return
    # All checkouts have Docker's own builder.
    place = user_cache() if services.is_docker_itself else services.buildx_config or services.state
    file = place / "turns" / f"{services.builder}-{shares}"
    progress, started, others = BuildProgress(sys.stderr), time.monotonic(), False

    def say() -> None:
        nonlocal others
        others = True
        progress.say(f"waiting for another build in builder '{services.builder}' ({holder(file)})")

    with turn(file, say):
        if others:
            _waits.append(time.monotonic() - started)
            progress.say("the other build has ended: this one begins, and counts from 0:00")
        yield


def run(services: Services, bake: Bake) -> tuple[BuildProgress, dict[str, str]]:
    """Builds a target, as `run_all`; the facts are those about the target."""
    progress, facts = run_all(services, bake)
    return progress, facts.get(bake.target, {})


def run_all(services: Services, bake: Bake) -> tuple[BuildProgress, dict[str, dict[str, str]]]:
    """Builds targets. Returns the progress, and buildx's facts by target, e.g. `containerimage.digest`.

    Lines for people go to standard error, everything goes to `.state/log/<name>.log`.

    Builds in one builder that share steps take turns. BuildKit solves concurrent builds in one graph. If a build begins while another
    one holds their common steps, it runs steps again whose results are in the cache (https://github.com/moby/buildkit/issues/4674).

    BuildKit sends a request once, or four times within seconds if the registry is broken. A busy registry needs longer. So we repeat
    such a build, which keeps its finished steps, as often as our own client repeats a request (`registry/retries.py`).
    """
    attempt = 0
    while True:
        attempt += 1
        try:
            with _turn(services, bake.shares):
                return _run(services, bake, "w" if attempt == 1 else "a")
        except Unanswered as error:
            seconds = _pause(services, error, attempt)
            if seconds is None:
                raise
            work = f"the push to {error.push_target}" if error.push_target else "a download of the build"
            BuildProgress(sys.stderr).say(f"{work} failed: {error.answer}; attempt {attempt + 1} in {seconds:.0f} s")
            time.sleep(seconds)
            if error.push_target:  # the result is in the builder's cache, so its steps need not run again
                bake = replace(bake, sets=[item for item in bake.sets if not item.endswith(".no-cache=true")])


def _pause(services: Services, error: Unanswered, attempt: int) -> float | None:
    """Seconds to wait before the build is repeated; None if that does not help."""
    status = int(error.answer[:3]) if error.answer[:3].isdecimal() else 0
    transient = failures.Transient(error.answer)
    if status in web.BUSY:
        return retries.pause(transient, attempt)
    if not error.push_target or status not in (0, 403, 404, 409):
        return None
    if status in (404, 409):
        return retries.pause(failures.Refused(error), attempt)
    if status == 403:  # if our own client may push, the registry was making the repository
        try:
            place = references.parse(error.push_target)
            with Registry(place.host, ca_bundle=services.ca_bundle) as client:
                client.may_push(place.repository)
        except RosmlError:
            return None
    return retries.pause(transient, attempt, reached=bool(status))


def _run(services: Services, bake: Bake, mode: Literal["w", "a"]) -> tuple[BuildProgress, dict[str, dict[str, str]]]:
    folder = services.state / "log"
    folder.mkdir(parents=True, exist_ok=True)
    log_path = folder / f"{bake.name}.log"
    metadata = folder / f"{bake.name}.metadata.json"
    metadata.unlink(missing_ok=True)
    with log_path.open(mode) as log:
        arguments = command(services, bake, metadata)
        log.write(f"$ {shlex.join(arguments)}\n")
        progress = BuildProgress(sys.stderr, log, summary=bake.glance, hidden=bake.hidden)
        env, null, pipe = environment(services, bake), subprocess.DEVNULL, subprocess.PIPE
        try:
            process = subprocess.Popen(
                arguments, cwd=services.root, env=env, stdin=null, stdout=null, stderr=pipe, text=True, errors="replace"
            )
        except OSError as error:
            raise RosmlError(f"cannot run {arguments[0]}: {error.strerror}", "run 'rosml setup'") from None
        try:
            assert process.stderr is not None
            progress.follow(process.stderr)
            code = process.wait()
        except BaseException:
            _stop(process)
            raise
    if code != 0:
        if services.registry:
            services.require_registry()
        services.require_builder()
        raise failure(bake, progress, log_path, code)
    return progress, _metadata(metadata)


def failure(bake: Bake, progress: BuildProgress, log: Path, code: int) -> RosmlError:
    """The error for a failed build: its step, last lines and log, and a remedy for a common reason."""
    step = progress.failed()
    lines = list(step.tail)[-TAIL_LINES:] if step else []
    remedy = _remedy(bake, progress, step)
    message = f"building {listed([bake.target, *bake.beside])} failed"
    if step:
        message += f" in step {step.label}"
        lines = lines or [step.error]
    else:
        lines = list(progress.other) or [f"buildx ended with exit code {code}"]
    message += "".join(f"\n    {line}" for line in lines)
    message += f"\n  the whole log: {log}"
    reason = step.error if step else ""
    push, status = _PUSH.search(reason), _STATUS.search(reason)
    if status or (push and _CUT_OFF.search(push[2])):
        return Unanswered(message, remedy, status[1] if status else reason, push[1] if push else "")
    return StepFailed(message, remedy, step.stage) if step else RosmlError(message, remedy)


def _remedy(bake: Bake, progress: BuildProgress, step: Step | None) -> str:
    """The remedy for the last line that matches a pattern: after earlier errors, the build went on."""
    if step and "] ONBUILD " in step.name:
        return "every build on the base image runs this, and the files it is for are not here: name one without ONBUILD"
    messages: list[tuple[str, _Remedies]]
    messages = [(line, _BUILDER_REMEDIES) for line in (*progress.other, step.error if step else "")]
    printed = list(step.tail) if step else []
    if printed and _SCRIPT_ERROR.match(printed[-1]):
        printed = [*filter(_APT_DISK_FULL.search, printed), printed[-1]]
    elif step and any(script in step.name for script in bake.foreign):
        printed = []
    messages += [(line, _STEP_REMEDIES) for line in printed]
    for line, remedies in reversed(messages):
        for pattern, remedy in remedies:
            if re.search(pattern, line, re.IGNORECASE):
                return remedy
    return ""


def _stop(process: subprocess.Popen[str]) -> None:
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
        try:
            process.communicate(timeout=CANCEL_SECONDS)  # keeps reading, so that buildx does not wait for a full pipe
        except (subprocess.TimeoutExpired, KeyboardInterrupt):
            process.kill()
            process.wait()


def _metadata(path: Path) -> dict[str, dict[str, str]]:
    try:
        content = untrusted.json_value(path.read_bytes()).items()
    except (OSError, ValueError, AttributeError):
        return {}
    return {
        target: {key: value for key, value in facts.items() if isinstance(value, str)}
        for target, facts in content
        if isinstance(facts, dict)
    }
