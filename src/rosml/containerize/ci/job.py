"""`rosml containerize` in CI: reads the commit from GitHub or GitLab, chooses the tags of its images, and reports the result.

The files in `containerize/` and the workflow pass every input as a variable and call `rosml ci`. `SETTINGS` in `inputs.py` has
their inputs and defaults; `files.py` writes these into the files.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from pydantic import ValidationError

from rosml.base import files, github
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import adapter
from rosml.containerize.base_image import base as app_base
from rosml.containerize.build import junit
from rosml.containerize.build.report import KINDS, TARGET
from rosml.containerize.build.step_order import build_images, new_call
from rosml.containerize.inputs import Values
from rosml.containerize.lock import Digest
from rosml.containerize.names import SLIM, listed, listed_platforms
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries
from rosml.registry.credentials import DOCKER_HUB

FILE = "images.json"
"""The file with the images of a job, for the job that makes the index."""

_TAG = re.compile(r"[^A-Za-z0-9_.-]")

Say = Callable[[str], None]


# ---- The commit ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Commit:
    branch: str  # also a pull request's; in small letters, digits and hyphens
    tag: str  # its git tag, if it has one
    default: bool  # it is of the default branch
    folder: Path


def commit(environment: Mapping[str, str]) -> Commit:
    """The commit, from the forge's variables."""
    if environment.get("GITHUB_ACTIONS") == "true":
        # In an event pull_request_target, the ref is the default branch, but the commit may be anybody's.
        head, ref = environment.get("GITHUB_HEAD_REF", ""), environment.get("GITHUB_REF", "")
        name = environment.get("GITHUB_REF_NAME", "")
        tag = name if environment.get("GITHUB_REF_TYPE") == "tag" else ""
        by_night = name if environment.get("GITHUB_EVENT_NAME") == "schedule" else ""
        default_branch = environment.get("DEFAULT_BRANCH") or by_night
        default = not head and bool(default_branch) and ref == f"refs/heads/{default_branch}"
        return Commit(_slug(head or name), tag, default, Path(environment.get("GITHUB_WORKSPACE", ".")))
    if environment.get("GITLAB_CI") == "true":
        branch, tag = environment.get("CI_COMMIT_BRANCH", ""), environment.get("CI_COMMIT_TAG", "")
        default = bool(branch) and branch == environment.get("CI_DEFAULT_BRANCH")
        name = environment.get("CI_COMMIT_REF_NAME", "")
        return Commit(_slug(name), tag, default, Path(environment.get("CI_PROJECT_DIR", ".")))
    raise RosmlError("this is no job of GitHub or GitLab", "call 'rosml containerize' here", exit_code=2)


def _slug(name: str) -> str:
    """A name with few kinds of characters, as in GitLab's slugs."""
    return re.sub(r"[^a-z0-9]", "-", name.lower())[:63].strip("-")


def tags(target: str, values: Values, commit: Commit) -> list[str]:
    """The tags of an image. Only the default branch moves the tag that the inputs name."""
    end = "" if target == "run" else f"-{target}"
    main_tag = values.image_tag
    if end:
        main_tag = values.text(f"{target}-image-tag") or f"{values.image_tag}{end}"
    latest = values.enable_push_as_latest
    if commit.tag:
        release = _TAG.sub("-", commit.tag)
        bare = [f"{release}{end}"] if latest or values.image_tag == "latest" else []
        return [*bare, f"{main_tag}-{release}"]
    if commit.default:
        return list(dict.fromkeys([main_tag, *([f"latest{end}"] if latest else [])]))
    return [f"{main_tag}_{commit.branch}_ci"]


# ---- Images ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Image:
    target: str  # run, dev or slim
    name: str  # without a tag
    tags: tuple[str, ...]  # of the commit's images
    end: str  # of its own tags, such as `-arm64`
    platforms: tuple[str, ...]
    digest: Digest

    @property
    def reference(self) -> str:
        return f"{self.name}:{self.tags[0]}{self.end}"


_IMAGES = adapter(list[Image])

_MOST = 1 << 20


class Job:
    """A job of CI. It builds a repository, or makes an index of images of other jobs."""

    def __init__(self, values: Values, environment: Mapping[str, str], commit: Commit, say: Say) -> None:
        run, dev, slim = map(_complete, (values.image_name, values.dev_image_name, values.slim_image_name))
        self._values = replace(values, image_name=run, dev_image_name=dev, slim_image_name=slim)
        self._names = {"run": run, "dev": dev or run, "slim": slim or run}
        self._tags = {target: tuple(tags(target, self._values, commit)) for target in self._names}
        self._environment, self._commit, self._say = environment, commit, say
        self._platforms = listed_platforms(values.platform)

    @property
    def name(self) -> str:
        """The name of this job's artifact and folder."""
        parts = (self._names["run"], self._tags["run"][0], *self._platforms)
        return "containerize-" + re.sub(r"[^a-z0-9._]+", "-", "-".join(parts).lower())

    def build(self, folder: Path, services: Services, out: Path, apart: bool) -> list[Image]:
        """Builds and tests the images. If `apart`, each platform gets its own tags, and there is no index.

        Reports and `images.json` are in `out`."""
        images: list[Image] = []
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir(parents=True)
        for platforms in [(name,) for name in self._platforms] if apart else [self._platforms]:
            end = f"-{platforms[0].partition('/')[2].replace('/', '-')}" if apart else ""
            images += self._build(folder, services, out, platforms, end)
        files.write(out / FILE, json.dumps([asdict(image) for image in images], indent=2) + "\n")
        return images

    def _build(self, folder: Path, services: Services, out: Path, platforms: tuple[str, ...], end: str) -> list[Image]:
        values = replace(
            self._values,
            platform=",".join(platforms),
            image_tag=self._tags["run"][0] + end,
            dev_image_tag=self._tags["dev"][0] + end,
            slim_image_tag=self._tags["slim"][0] + end,
            enable_push_as_latest=False,
        )
        if values.push:  # all tags, before the first one moves
            with Registries(services.ca_bundle) as registries:
                for target in {*listed(values.target)} | ({SLIM} if values.enable_slim else set()):
                    references = [f"{self._names[target]}:{tag}{end}" for tag in self._tags.get(target, ())]
                    app_base.require_kept(registries, references, platforms)
        call = new_call(folder, values, self._environment, services, self._say)
        shutil.rmtree(call.reports, ignore_errors=True)
        try:
            result = build_images(call)
        finally:
            _keep(call.reports, out / f"reports{end}")
        if result.lock:
            files.write(out / f"containerize{end}.lock", result.lock.text())
        images = [
            Image(image.target, self._names[image.target], self._tags[image.target], end, platforms, image.digest)
            for image in result.images
        ]
        if values.push:
            with Registries(services.ca_bundle) as registries:
                for image in images:
                    _move(registries, image, 1)
        return images

    def missing_slim(self, images: list[Image]) -> str:
        """A sentence if the inputs ask for a slim image, and its base image has none without compilers."""
        if not self._values.enable_slim or "run" not in listed(self._values.target):
            return ""
        if any(image.target == SLIM for image in images):
            return ""
        name = f"{self._names[SLIM]}:{self._tags[SLIM][0]}"
        return f"no slim image: {name} stays as it is; publish its base image, or write enable-slim: false"

    def built_images(self, folder: Path) -> list[Image]:
        """The images of the job for all platforms, and of those for one platform each. We find their files by the jobs' names: a
        job may have kept other files, such as its tests'."""
        jobs = [Job(replace(self._values, platform=name), {}, self._commit, self._say).name for name in self._platforms]
        return [image for name in dict.fromkeys((self.name, *jobs)) for image in _read(folder / name / FILE)]

    def index(self, folder: Path, registries: Registries) -> list[Image]:
        """Makes an index of the images that jobs for one platform each pushed. Then moves the tags to it: all of them, once all
        images are there. If images were not pushed, it makes nothing."""
        if not self._values.push:
            return []
        built_images, indexes = self.built_images(folder), []
        for target in [*listed(self._values.target), SLIM]:
            key = (target, self._names.get(target, ""), tuple(tags(target, self._values, self._commit)))
            members = [image for image in built_images if (image.target, image.name, image.tags) == key]
            if target == SLIM and not members:  # there is one if the base image has one without compilers
                continue
            by_platform = {name: image for image in members for name in image.platforms}
            missing = [name for name in self._platforms if name not in by_platform]
            if missing and target == SLIM and not self._values.slim_base_image:
                self._say(f"no slim image: there is none for {', '.join(missing)}")
                continue
            if missing:
                text = f"there is no {target} image {key[1]}:{key[2][0]} for {', '.join(missing)}"
                raise RosmlError(f"{text}; no tag was moved", "look at the jobs that build for these platforms")
            indexes.append(_join([by_platform[name] for name in self._platforms], registries))
        for image in indexes:
            app_base.require_kept(registries, [f"{image.name}:{tag}" for tag in image.tags], image.platforms)
        for image in indexes:
            _move(registries, image, 0)
        return indexes


def _complete(name: str) -> str:
    """The full name of an image. If it names no registry, it is on Docker Hub, as with docker."""
    name = name.lower()
    return name if not name or references.has_registry(name) else f"{DOCKER_HUB}/{name}"


def _keep(report: Path, out: Path) -> None:
    """Copies JUnit files: each platform has its own folder, with those of slim images and downstream packages beside it."""
    alone = any((report / name).is_dir() for name in KINDS)
    for folder in [report] if alone else sorted(report.glob("*")):
        for name in KINDS:
            if (folder / name).is_dir():
                end = "" if name == TARGET else f"-{name}"
                shutil.copytree(folder / name, out / f"{folder.name}{end}", symlinks=True)


def _join(members: list[Image], registries: Registries) -> Image:
    """Makes an index of images for one platform each, without a tag."""
    first, entries = members[0], []
    place = references.parse(first.reference)
    registry = registries(place.host)
    for image in members:
        manifest = registry.manifest(place.repository, image.digest)
        if manifest is None:
            raise RosmlError(f"{image.name}@{image.digest} is gone", "run all jobs again")
        system, architecture, *variant = image.platforms[0].split("/")
        platform = {"os": system, "architecture": architecture, **({"variant": variant[0]} if variant else {})}
        entries.append({**manifest.descriptor, "platform": platform})
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
    digest = registry.put_manifest(place.repository, "", content, oci.INDEX)
    platforms = tuple(name for image in members for name in image.platforms)
    return Image(first.target, first.name, first.tags, "", platforms, digest)


def _move(registries: Registries, image: Image, first: int) -> None:
    """Moves tags of an image to its digest: all after the first ones, which are there already."""
    place = references.parse(image.reference)
    for tag in image.tags[first:]:
        registries(place.host).tag(place.repository, image.digest, tag + image.end)


def _read(file: Path) -> list[Image]:
    data = files.regular(file, _MOST)
    try:
        return _IMAGES.validate_json(data) if data is not None else []
    except ValidationError as error:
        raise RosmlError(f"{file} is damaged: {first_of(error)}", "run all jobs again") from None


# ---- For the forge ---------------------------------------------------------------------------------------------------


def outputs(images: list[Image]) -> dict[str, str]:
    """Outputs of the action: name and digest of the first image of each target."""
    values: dict[str, str] = {}
    for image in images:
        before = "" if image.target == "run" else f"{image.target}-"
        values.setdefault(f"{before}image", image.reference)
        values.setdefault(f"{before}digest", image.digest)
    return values


def summary(images: list[Image], out: Path | None = None) -> str:
    """Markdown for the page of a run. `out`: the folder of reports."""
    rows = [
        (
            "<br>".join(f"`{image.name}:{tag}{image.end}`" for tag in image.tags),
            ", ".join(image.platforms),
            f"`{image.digest}`",
        )
        for image in images
    ]
    text = github.table(("image", "platforms", "digest"), rows) if rows else ""
    tests = _reported(out) if out else junit.Tests()
    if tests.count or tests.failures:
        text += f"\n{tests.count} tests, {len(tests.failures)} failed, {tests.skipped} skipped\n"
    return text + "".join(f"- `{line.replace('`', '')}`\n" for line in tests.failures)


def _reported(out: Path) -> junit.Tests:
    return junit.total(junit.read(folder) for folder in sorted(out.glob("reports*/*")))


def errors(out: Path, error: RosmlError) -> Iterator[str]:
    """Commands to GitHub: they show the failed tests on the page of the run, or else the error."""
    failures = _reported(out).failures
    title = "Test failed" if failures else "rosml containerize"
    for line in failures or (error.message,):
        yield command("error", title, line)


def command(kind: str, title: str, text: str) -> str:
    """A command to GitHub, which shows a text on the page of the run."""
    escaped = text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
    return f"::{kind} title={title}::{escaped}"
