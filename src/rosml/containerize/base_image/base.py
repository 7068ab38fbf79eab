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
from rosml.images.image_set.labels import PREFIX, RESTRICTED, RUNTIME, VERSION
from rosml.images.image_set.load import load
from rosml.images.matrix.names import DATED, main_tag
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import bases, oci, references
from rosml.registry.client import Registries, Registry
from rosml.registry.credentials import DOCKER_HUB
from rosml.registry.documents import Config, Platform, Settings


@dataclass(frozen=True)
class AddOns:
    """What add-ons bring to a base image.

    Attributes:
        parts: references of parts by digest, in the order in which they are joined; by their names with a tag.
        environment: variables that the base image does not have, or has with other values.
        labels: the same of labels.
    """

    parts: Mapping[str, str]
    environment: Mapping[str, str]
    labels: Mapping[str, str]

    def dockerfile(self, base: str) -> str:
        """The Dockerfile that joins the parts.

        Args:
            base: the name of the context with the base image. The contexts of parts are `part-0`, `part-1` …
        """
        lines = [f"FROM {base}"]
        lines += [f"COPY --link --from=part-{number} / /" for number in range(len(self.parts))]
        return "\n".join([*lines, *(f'ENV {name}="{value}"' for name, value in self.environment.items()), ""])

    def contexts(self) -> dict[str, str]:
        """The contexts of the parts."""
        return {f"part-{number}": f"docker-image://{reference}" for number, reference in enumerate(self.parts.values())}


@dataclass(frozen=True)
class Base:
    """A base image.

    Attributes:
        name: its name as people write it, with its registry and tag.
        digest: the digest of its index, or of its manifest.
        environment: its variables, for the first wanted platform.
        labels: the labels of its configuration.
        user: the user as whom it starts.
        entrypoint: its entrypoint.
        shell: its shell for RUN in Dockerfiles; empty if it names none.
        local: whether it is in the user's Docker, and in no registry that answers.
        adopted: the ROS to install on it, if it has none.
        addons: the parts to join to it, if there are some.
    """

    name: str
    digest: str
    environment: Mapping[str, str]
    labels: Mapping[str, str] = field(default_factory=dict)
    user: str = ""
    entrypoint: tuple[str, ...] = ()
    shell: tuple[str, ...] = ()
    local: bool = False
    adopted: Adopted | None = None
    addons: AddOns | None = None

    @property
    def reference(self) -> str:
        """The reference for the builder, by digest, as the tag may move. Docker finds its own images only by their names."""
        if self.local:
            return self.name
        return f"{self.repository}@{self.digest}"

    @property
    def repository(self) -> str:
        """Its name without a tag or digest."""
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
    """The base image with a name: in a registry, or else in the user's Docker if that builds.

    Args:
        digest: the wanted digest, wherever the tag is now; empty for any.

    Raises:
        RosmlError: there is no such image, or it is for other platforms.
    """
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
                tags = [tag for tag in registry.tags(place.repository) if not tag.startswith("sha256-")]
                near = unknown("tag", place.reference, tags).partition("; ")[2]
    if services.builder_kind != "buildkitd" and (found := _in_docker(text, digest)):
        return found
    if refused and services.bases and (found := _made_here(names[-1], services, platforms, digest)):
        return found
    if "@" in text and not (refused and len(names) == 1):
        raise without_digest(text, services)
    ours = _ours(text) or _app_here(text, services)
    if refused:
        if len(names) == 1:
            raise refused
        problem = f"there is no image {text} in the local registry, and {refused.message}"
        raise RosmlError(problem, ours or near or refused.remedy)
    if digest:
        text = f"there is no image {text} with the digest {digest} of the lock file{_sought(text, names)}"
        raise RosmlError(text, lock.RENEW, exit_code=2)
    raise RosmlError(
        f"there is no image {text}{_sought(text, names)}",
        ours
        or f"{near}{' ' if near.endswith('?') else '. ' if near else ''}"
        "'rosml list' has all names; 'rosml image TARGET' builds one; 'docker login' for a private one",
        exit_code=2,
    )


def without_digest(text: str, services: Services) -> RosmlError:
    """The error if no registry has an image with a digest (exit code 2).

    Args:
        text: the user's name of the image, with the digest.
    """
    names, refused = candidates(text, services), ""
    short, _, digest = text.partition("@")
    tagged = ":" in short.rpartition("/")[2]
    with Registries(services.ca_bundle) as registries:
        for name in names:
            place = references.parse(name.partition("@")[0])
            where = f"{place.host}/{place.repository}"
            try:
                registry = registries(place.host)
                if tagged and (present := registry.head(place.repository, place.reference)):
                    message = f"{place} is there, but not with the digest {digest}"
                    return RosmlError(message, f"take {short}, or the digest that it has now: {short}@{present}", 2)
                tags = (
                    [] if tagged else [tag for tag in registry.tags(place.repository) if not tag.startswith("sha256-")]
                )
            except RosmlError as error:  # the registry does not answer, or wants a log-in
                refused = f"; {error.message}"
                continue
            if tags:
                return RosmlError(
                    f"{where} has no image with the digest {digest}", f"take one of its tags: {some(tags)}", 2
                )
    return RosmlError(
        f"there is no image {text}{_sought(text, names)}{refused}",
        "check its name and its digest; 'rosml list' has all names; 'docker login' for a private one",
        exit_code=2,
    )


def _ours(text: str) -> str:
    """What to do about the name of one of our images that nobody has built, or of its target; empty for others."""
    images = load(MATRIX)
    if image := images.by_tag(text):
        return f"build it first: rosml image {image.target}"
    if image := images.by_target.get(text):
        return f"name the image by its tag: {image.tags[0]}"
    return ""


def _app_here(text: str, services: Services) -> str:
    """How to write the name of an app in the local registry, if it has one of that name; empty if not."""
    if not services.registry or references.has_registry(text):
        return ""
    with Registries(services.ca_bundle) as registries, contextlib.suppress(RosmlError):
        where = references.parse(f"{services.registry}/{text}")
        if registries(where.host).head(where.repository, where.reference):
            return f"an app in the local registry has to be named in full: {services.registry}/{text}"
    return ""


def _sought(text: str, names: Iterable[str]) -> str:
    """Where an image was looked for, if its name does not say so itself."""
    others = [name for name in dict.fromkeys(names) if name != text]
    return f" (looked for {', '.join(others)})" if others else ""


def _made_here(name: str, services: Services, platforms: tuple[str, ...], digest: str) -> Base | None:
    """An operating system's image that this machine makes if Docker Hub does not answer. The builder uses it as the original."""
    systems = load(MATRIX).matrix.operating_systems
    system = next((key for key, facts in systems.items() if facts.image == name), "")
    if not system:
        return None
    architecture = platforms[0].split("/")[1] if platforms else ""
    place = references.parse(base_images.reference(services, systems, system, architecture))
    with Registries(services.ca_bundle) as registries:
        registry = registries(services.registry if place.host == DOCKER_HUB else place.host)
        manifest = registry.manifest(place.repository, digest or place.reference)
        return _read(registry, references.parse(name), manifest, platforms) if manifest else None


def runtime(base: Base) -> str:
    """The name of the image without compilers that belongs to one of our images; empty if labels name none.

    Programs built on one run on the other. It is in the same repository, and of the same day and the same versions if the tag has
    them.
    """
    labels = base.labels
    component, distribution = labels.get(RUNTIME, ""), labels.get(f"{PREFIX}distribution", "")
    if not component or not distribution:
        return ""
    stack, day = labels.get(f"{PREFIX}stack"), DATED.search(base.name)
    own, spelled = main_tag(distribution, labels.get(f"{PREFIX}component", ""), stack), labels.get(VERSION, "")
    versions = spelled.removeprefix(own) if f":{spelled}" in base.name else ""
    return f"{base.repository}:{main_tag(distribution, component, stack)}{versions}{day[0] if day else ''}"


def differing(base: Base, other: Base) -> list[str]:
    """The labels that differ between two of our images: versions, systems, days."""
    own = {f"{PREFIX}{name}" for name in ("component", "runtime", "app")}
    names = {name for labels in (base.labels, other.labels) for name in labels if name.startswith(PREFIX)} - own
    return sorted(name.removeprefix(PREFIX) for name in names if base.labels.get(name) != other.labels.get(name))


def _in_docker(text: str, digest: str) -> Base | None:
    """An image in the user's Docker, with the wanted digest if there is one."""
    try:
        command = ["docker", "image", "inspect", text]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
        [facts] = _INSPECTED.validate_python(untrusted.json_value(done.stdout))
    except (OSError, ValueError):
        return None
    known = [facts.Id, *(name.partition("@")[2] for name in facts.RepoDigests or [])]
    if digest and digest not in known:
        return None
    bases.require_no_triggers(facts.Config, text)
    return _base(text, facts.Id, facts.Config, local=True)


class _Inspected(Shape):
    """Docker's facts about one of its images."""

    Id: str
    RepoDigests: list[str] | None = None
    Config: Settings | None = None


_INSPECTED = adapter(list[_Inspected])


def _base(name: str, digest: str, settings: Settings | None, local: bool = False) -> Base:
    """A base image from its configuration."""
    said = settings or Settings()
    if not re.fullmatch(r"([A-Za-z0-9_][A-Za-z0-9_.-]*(:[A-Za-z0-9_][A-Za-z0-9_.-]*)?)?", said.User or ""):
        raise RosmlError(f"{name} starts as a user of no name: {said.User!r}", "set another USER in an image on it", 2)
    variables = {name: value for name, _, value in (item.partition("=") for item in said.Env or ())}
    entrypoint = tuple(said.Entrypoint or ())
    if entrypoint and "/" in entrypoint[0]:  # it may be relative to the folder in which the image starts
        place = posixpath.normpath(posixpath.join(said.WorkingDir or "/", entrypoint[0]))
        entrypoint = (place, *entrypoint[1:])
    return Base(name, digest, variables, said.Labels or {}, said.User or "", entrypoint, tuple(said.Shell or ()), local)


def _read(registry: Registry, place: references.Reference, found: oci.Manifest, platforms: tuple[str, ...]) -> Base:
    # Some steps run on the builder's own architecture.
    needed = {name.split("/")[1] for name in platforms} | {native_architecture()} if platforms else ()
    configs: dict[str, oci.Config] = {}
    for facts, config in bases.configs(registry, place.repository, found, str(place), needed):
        configs.setdefault(_platform(facts), config)
    missing = [name for name in platforms if name not in configs]
    if missing or not configs:
        text = f"{place} is not for {', '.join(missing)}" if missing else f"{place} has no image for any platform"
        raise RosmlError(text, "name another base image, or other platforms", exit_code=2)
    config = configs[platforms[0]] if platforms else next(iter(configs.values()))
    base = _base(str(place), found.digest, config.facts.config)
    taken = [config for name, config in configs.items() if not platforms or name in platforms]
    held = {name: "" for known in taken for name in restricted.parts_of(known.labels)}
    return replace(base, labels={**base.labels, RESTRICTED: " ".join(held)}) if held else base


def require_kept(
    registries: Callable[[str], Registry], named: Iterable[str], platforms: tuple[str, ...], remedy: str = ""
) -> None:
    """Checks that no tag would lose a platform.

    Args:
        remedy: of the error; that of a build by default.

    Raises:
        RosmlError: a tag's present image is also for other platforms (exit code 2), or a registry does not answer.
    """
    for reference in named:
        place = references.parse(reference)
        registry = registries(place.host)
        found = registry.manifest(place.repository, place.reference)
        there = _platforms(registry, place, found) if found else []
        if not {name.replace("arm64/v8", "arm64") for name in platforms}.issuperset(there):
            every = ",".join(dict.fromkeys([*there, *platforms]))
            architecture = platforms[0].partition("/")[2].replace("/", "-")
            raise RosmlError(
                f"{reference} is for {', '.join(there)}, and would be for {', '.join(platforms)} alone; no tag was moved",
                remedy
                or f"name all: --platform {every}; or give this image a tag of its own, such as --image-tag"
                f" {place.reference}-{architecture}, as enable-singlearch-push does in CI",
                exit_code=2,
            )


def _platforms(registry: Registry, place: references.Reference, found: oci.Manifest) -> list[str]:
    """The platforms of an image; none if it is no image."""
    facts: list[Platform | Config] = [entry.platform for entry in found.members if entry.platform]
    if not found.is_index:
        with contextlib.suppress(RosmlError):
            facts.append(registry.config(place.repository, found).facts)
    known = [item for item in facts if item.architecture and item.os != "unknown"]
    names = {f"{_platform(item)}{'/' + item.variant if item.variant else ''}" for item in known}
    return sorted(name.replace("arm64/v8", "arm64") for name in names)


def _platform(facts: Platform | Config) -> str:
    """A platform's usual name, without a variant."""
    return "/".join(filter(None, (facts.os, facts.architecture)))
