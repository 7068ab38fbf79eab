"""The base image of an app: finds it in a registry, and reads it."""

from __future__ import annotations

import contextlib
import posixpath
import re
import subprocess
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace

from rosml import MATRIX
from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import some, unknown
from rosml.base.shapes import Shape, adapter
from rosml.containerize import lock
from rosml.images.builds import base_images
from rosml.images.builds.adopted import Adopted
from rosml.images.builds.base_images import native_architecture
from rosml.images.image_set import restricted
from rosml.images.image_set.labels import ENVIRONMENTS, PREFIX, RESTRICTED, RUNTIME, VERSION
from rosml.images.image_set.load import load
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.names import environments_end
from rosml.images.matrix.tags import DATED, main_tag
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import bases, oci, references
from rosml.registry.client import Registries, Registry
from rosml.registry.credentials import DOCKER_HUB
from rosml.registry.documents import Config, Platform, Settings


@dataclass(frozen=True)
class AddOns:
    """What add-ons and environments bring to a base image."""

    parts: Mapping[str, str]  # references by digest, by their names with a tag
    environment: Mapping[str, str]  # variables that it lacks
    labels: Mapping[str, str]

    def dockerfile(self, base: str) -> str:
        """The Dockerfile that joins the parts to a context with the base image."""
        lines = [f"FROM {base}"]
        lines += [f"COPY --link --from=part-{number} / /" for number in range(len(self.parts))]
        return "\n".join([*lines, *(f'ENV {name}="{value}"' for name, value in self.environment.items()), ""])

    def contexts(self) -> dict[str, str]:
        return {f"part-{number}": f"docker-image://{reference}" for number, reference in enumerate(self.parts.values())}


@dataclass(frozen=True)
class Base:
    name: str  # with its registry and tag
    digest: str  # of its index, or of its manifest
    environment: Mapping[str, str]  # for the first of the platforms
    labels: Mapping[str, str] = field(default_factory=dict)
    user: str = ""
    entrypoint: tuple[str, ...] = ()
    shell: tuple[str, ...] = ()
    local: bool = False  # in the user's Docker, and in no registry that answers
    adopted: Adopted | None = None  # the ROS to install on it, if it has none
    addons: AddOns | None = None
    copy: str = ""  # the repository that the builder pulls from, if it is not that of the name

    @property
    def reference(self) -> str:
        """For the builder: by digest, as the tag may move. Docker finds its own images only by their names."""
        return self.name if self.local else f"{self.copy or self.repository}@{self.digest}"

    @property
    def repository(self) -> str:
        return re.sub(r":[^:/]+$", "", self.name.partition("@")[0])


def candidates(text: str, services: Services) -> tuple[str, ...]:
    """The full references that a user may mean, the likeliest first."""
    text = text.removeprefix(f"{DOCKER_HUB}/")
    if references.has_registry(text):
        return (text,)
    # An app there has to be named in full: otherwise it could replace any image of Docker Hub.
    local = (f"{services.registry}/{NAMESPACE}/{text}",) if services.registry else ()
    return (*local, references.complete(text))


def find(text: str, services: Services, platforms: tuple[str, ...], digest: str = "") -> Base:
    """The base image with a name, and with this digest unless it is empty: in a registry, or in the user's Docker if that builds."""
    names = candidates(text, services)
    refused: RosmlError | None = None
    near = ""
    with Registries(services.ca_bundle) as registries:
        for name in names:
            place = references.parse(name)
            registry = registries(place.host)
            try:
                manifest = registry.manifest(place.repository, digest or place.reference)
            except RosmlError as error:  # the registry does not answer, or wants a log-in
                refused = error
                continue
            if manifest is not None:
                return _read(registry, place, manifest, platforms)
            if place.host == services.registry and not digest:  # others may have thousands of tags
                near = unknown("tag", place.reference, _tags(registry, place)).partition("; ")[2]
    if services.builder_kind != "buildkitd" and (base := _in_docker(text, digest)):
        return base
    if refused and services.bases and (base := _made_here(names[-1], services, platforms, digest)):
        return base
    if "@" in text and not (refused and len(names) == 1):
        raise without_digest(text, services)
    raise _none(text, services, digest, near, refused)


def _none(text: str, services: Services, digest: str, near: str, refused: RosmlError | None) -> RosmlError:
    """The error if there is no image of a name. `near`: a sentence with similar tags. `refused`: the error of a registry."""
    names = candidates(text, services)
    if refused and len(names) == 1:
        return refused
    ours = _remedy_for_ours(text, services)
    if refused:
        problem = f"there is no image {text} in the local registry, and {refused.message}"
        return RosmlError(problem, ours or near or refused.remedy)
    if digest:
        problem = f"there is no image {text} with the digest {digest} of the lock file{_sought(text, names)}"
        return RosmlError(problem, lock.RENEW, exit_code=2)
    hint = f"{near}{' ' if near.endswith('?') else '. ' if near else ''}"
    remedy = f"{hint}'rosml list' has all names; 'rosml image TARGET' builds one; 'docker login' for a private one"
    return RosmlError(f"there is no image {text}{_sought(text, names)}", ours or remedy, exit_code=2)


def without_digest(text: str, services: Services) -> RosmlError:
    """The error if no registry has an image with the digest in its name."""
    names, refused = candidates(text, services), ""
    short, _, digest = text.partition("@")
    is_tagged = ":" in short.rpartition("/")[2]
    with Registries(services.ca_bundle) as registries:
        for name in names:
            place = references.parse(name.partition("@")[0])
            try:
                registry = registries(place.host)
                if is_tagged and (present := registry.head(place.repository, place.reference)):
                    message = f"{place} is there, but not with the digest {digest}"
                    return RosmlError(message, f"take {short}, or the digest that it has now: {short}@{present}", 2)
                tags = [] if is_tagged else _tags(registry, place)
            except RosmlError as error:  # the registry does not answer, or wants a log-in
                refused = f"; {error.message}"
                continue
            if tags:
                message = f"{place.host}/{place.repository} has no image with the digest {digest}"
                return RosmlError(message, f"take one of its tags: {some(tags)}", 2)
    return RosmlError(
        f"there is no image {text}{_sought(text, names)}{refused}",
        "check its name and its digest; 'rosml list' has all names; 'docker login' for a private one",
        exit_code=2,
    )


def _tags(registry: Registry, place: references.Reference) -> list[str]:
    """The tags of a repository, without those that registries make for what is attached to an image."""
    return [tag for tag in registry.tags(place.repository) if not tag.startswith("sha256-")]


def _remedy_for_ours(text: str, services: Services) -> str:
    """For an image of ours that nobody has built, the name of a target, or an app in the local registry; empty for others."""
    images = load(MATRIX)
    if image := images.by_tag(text):
        return f"build it first: rosml image {image.target}"
    if image := images.by_target.get(text):
        return f"name the image by its tag: {image.tags[0]}"
    if not services.registry or references.has_registry(text):
        return ""
    with Registries(services.ca_bundle) as registries, contextlib.suppress(RosmlError):
        place = references.parse(f"{services.registry}/{text}")
        if registries(place.host).head(place.repository, place.reference):
            return f"an app in the local registry has to be named in full: {services.registry}/{text}"
    return ""


def _sought(text: str, names: Iterable[str]) -> str:
    """Where an image was looked for, if its name does not say so itself."""
    others = [name for name in dict.fromkeys(names) if name != text]
    return f" (looked for {', '.join(others)})" if others else ""


def _made_here(name: str, services: Services, platforms: tuple[str, ...], digest: str) -> Base | None:
    """An operating system's image that this machine makes if Docker Hub does not answer. It has the name of the original."""
    systems = load(MATRIX).matrix.operating_systems
    system = next((key for key, facts in systems.items() if facts.image == name), "")
    if not system:
        return None
    architecture = platforms[0].split("/")[1] if platforms else ""
    place = references.parse(base_images.reference(services, systems, system, architecture))
    with Registries(services.ca_bundle) as registries:
        registry = registries(services.registry if place.host == DOCKER_HUB else place.host)
        manifest = registry.manifest(place.repository, digest or place.reference)
        if manifest is None:
            return None
        base = _read(registry, references.parse(name), manifest, platforms)
        return replace(base, copy=f"{place.host}/{place.repository}")


def distribution(base: Base, matrix: Matrix) -> str:
    """The distribution of the matrix whose ROS a base image has as it is; empty if it has another, or if somebody may have added to it:
    an image on one of ours has its labels, and another name."""
    name = base.adopted.image.distribution if base.adopted else base.labels.get(f"{PREFIX}distribution", "")
    last = base.name.rpartition("/")[2]
    is_ours = any(last.startswith(f"{framework.repository}:{name}-") for framework in matrix.frameworks.values())
    return name if name in matrix.distributions and (base.adopted or is_ours) else ""


def runtime(base: Base) -> str:
    """The name of the image without compilers on which programs of this one run, of the same day and versions; empty for none. It has
    no environments: they are joined to it."""
    labels = base.labels
    component, distribution = labels.get(RUNTIME, ""), labels.get(f"{PREFIX}distribution", "")
    if not component or not distribution:
        return ""
    stack, day = labels.get(f"{PREFIX}stack"), DATED.search(base.name)
    tag = main_tag(distribution, labels.get(f"{PREFIX}component", ""), stack)
    spelled = labels.get(VERSION, "").removesuffix(environments_end(labels.get(ENVIRONMENTS, "").split()))
    versions = spelled.removeprefix(tag) if f":{spelled}" in base.name else ""
    return f"{base.repository}:{main_tag(distribution, component, stack)}{versions}{day[0] if day else ''}"


def differing(base: Base, other: Base) -> list[str]:
    """The labels that differ between two of our images: versions, systems, days. A slim image gets the environments of the other."""
    of_image = {ENVIRONMENTS, *(f"{PREFIX}{name}" for name in ("component", "runtime", "app"))}
    names = {name for name in {**base.labels, **other.labels} if name.startswith(PREFIX)} - of_image
    return sorted(name.removeprefix(PREFIX) for name in names if base.labels.get(name) != other.labels.get(name))


def _in_docker(text: str, digest: str) -> Base | None:
    """An image in the user's Docker, with this digest unless it is empty."""
    try:
        command = ["docker", "image", "inspect", text]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
        [facts] = _INSPECTED.validate_python(untrusted.json_value(done.stdout))
    except (OSError, ValueError):
        return None
    digests = [facts.Id, *(name.partition("@")[2] for name in facts.RepoDigests or [])]
    if digest and digest not in digests:
        return None
    bases.require_no_triggers(facts.Config, text)
    return _base(text, facts.Id, facts.Config, local=True)


class _Inspected(Shape):
    Id: str
    RepoDigests: list[str] | None = None
    Config: Settings | None = None


_INSPECTED = adapter(list[_Inspected])

_USER = re.compile(r"([A-Za-z0-9_][A-Za-z0-9_.-]*(:[A-Za-z0-9_][A-Za-z0-9_.-]*)?)?")


def _base(name: str, digest: str, settings: Settings | None, local: bool = False) -> Base:
    facts = settings or Settings()
    user, labels, shell = facts.User or "", facts.Labels or {}, tuple(facts.Shell or ())
    if not _USER.fullmatch(user):
        raise RosmlError(f"{name} starts as a user of no name: {user!r}", "set another USER in an image on it", 2)
    variables = dict(item.partition("=")[::2] for item in facts.Env or ())
    program, *words = facts.Entrypoint or [""]
    if "/" in program:  # it may be relative to the folder in which the image starts
        program = posixpath.normpath(posixpath.join(facts.WorkingDir or "/", program))
    entrypoint = (program, *words) if facts.Entrypoint else ()
    return Base(name, digest, variables, labels, user, entrypoint, shell, local)


def _read(registry: Registry, place: references.Reference, manifest: oci.Manifest, platforms: tuple[str, ...]) -> Base:
    # Some steps run on the builder's own architecture.
    needed = {name.split("/")[1] for name in platforms} | {native_architecture()} if platforms else ()
    configs: dict[str, oci.Config] = {}
    for facts, config in bases.configs(registry, place.repository, manifest, str(place), needed):
        configs.setdefault(_platform(facts), config)
    missing = [name for name in platforms if name not in configs]
    if missing or not configs:
        text = f"{place} is not for {', '.join(missing)}" if missing else f"{place} has no image for any platform"
        raise RosmlError(text, "name another base image, or other platforms", exit_code=2)
    used = [config for name, config in configs.items() if not platforms or name in platforms]
    first = configs[platforms[0]] if platforms else used[0]
    base = _base(str(place), manifest.digest, first.facts.config)
    parts = dict.fromkeys(name for config in used for name in restricted.parts_of(config.labels))
    return replace(base, labels={**base.labels, RESTRICTED: " ".join(parts)}) if parts else base


def require_kept(
    registries: Callable[[str], Registry], tags: Iterable[str], platforms: tuple[str, ...], remedy: str = ""
) -> None:
    """Checks that no tag would lose a platform of its present image. The default remedy is that of a build."""
    for reference in tags:
        place = references.parse(reference)
        registry = registries(place.host)
        manifest = registry.manifest(place.repository, place.reference)
        present = _platforms(registry, place, manifest) if manifest else []
        if not {name.replace("arm64/v8", "arm64") for name in platforms}.issuperset(present):
            every = ",".join(dict.fromkeys([*present, *platforms]))
            tag = f"{place.reference}-{platforms[0].partition('/')[2].replace('/', '-')}"
            own_tag = (
                f"give this image a tag of its own, such as --image-tag {tag}, as enable-singlearch-push does in CI"
            )
            text = f"{reference} is for {', '.join(present)}, and would be for {', '.join(platforms)} alone"
            default = f"name all: --platform {every}; or {own_tag}"
            raise RosmlError(f"{text}; no tag was moved", remedy or default, exit_code=2)


def _platforms(registry: Registry, place: references.Reference, manifest: oci.Manifest) -> list[str]:
    """The platforms of an image; none if it is no image."""
    facts: list[Platform | Config] = [entry.platform for entry in manifest.members if entry.platform]
    if not manifest.is_index:
        with contextlib.suppress(RosmlError):
            facts.append(registry.config(place.repository, manifest).facts)
    usable = [item for item in facts if item.architecture and item.os != "unknown"]
    names = {f"{_platform(item)}{'/' + item.variant if item.variant else ''}" for item in usable}
    return sorted(name.replace("arm64/v8", "arm64") for name in names)


def _platform(facts: Platform | Config) -> str:
    return "/".join(filter(None, (facts.os, facts.architecture)))
