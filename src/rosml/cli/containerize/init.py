"""`rosml init`: the files with which people begin, for the ROS packages in a folder."""

from __future__ import annotations

import datetime
import json
import os
import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from rosml import IN_CHECKOUT, ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, first_files, options
from rosml.cli.checkout import Command
from rosml.cli.command import warn
from rosml.cli.first_files import Calls

if TYPE_CHECKING:
    from rosml.containerize.init.choices import Decision
    from rosml.containerize.init.file_texts import Project
    from rosml.containerize.init.folder import File
    from rosml.containerize.init.forge import Ci
    from rosml.containerize.init.packages import FolderScan
    from rosml.containerize.init.situation import Ask, Choice, Note, Question, Surroundings
    from rosml.images.image_set.model import Image, ImageSet

KEPT = "interrupted: nothing was written"

UNNAMED = (
    "no registry is named: the base image in .env is one that only a checkout has on its machine",
    "name a registry with --registry; or write it before the name in .env, such as ghcr.io/me/rosml/",
)
"""What to say where rosml is installed, and nobody said where base images are."""

UNCONFIRMED = "{} of the repository names the registry {}, and nobody has confirmed it: the files do not"


@dataclass(frozen=True)
class Call:
    folder: Path
    distribution: str
    component: str
    framework: str
    gpu: bool | None
    accelerator: str
    command: str
    ci: str
    registry: str
    push_to: str
    images: bool
    rosml: str
    matrix: Path
    yes: bool
    dry_run: bool
    as_json: bool


@click.command(
    "init",
    short_help="Writes the first files for the ROS packages in a folder.",
    cls=Command,
    alone=True,
    kept=KEPT,
)
@click.argument("folder", type=click.Path(file_okay=False, path_type=Path), default=".")
@click.option("--distribution", default="", metavar="NAME", help="ROS distribution of the base image, such as jazzy")
@click.option("--component", default="", metavar="NAME", help="how much of ROS it has, such as base")
@click.option("--framework", default="", metavar="NAME", help="what it has for machine learning; none for nothing")
@click.option("--gpu/--cpu", default=None, help="compute on NVIDIA GPUs, or on the CPU")
@click.option("--accelerator", default="", metavar="NAME", help="its stack, such as cpu; rosml list names all")
@click.option("--command", default="", metavar="TEXT", help="what the run image starts, as a shell reads it")
@click.option("--ci", default="", metavar="FORGE", help="write a CI file for github or gitlab, or for none")
@options.registry("where base images are; with --images, where yours go")
@click.option("--push-to", default="", metavar="NAME", help="where CI pushes the images, such as ghcr.io/me/robot")
@click.option("--images", is_flag=True, help="write the files of a set of your own images, which extends rosml's")
@click.option("--rosml", default="", metavar="ADDRESS", help="the address of rosml's repository, if it is not known")
@options.MATRIX
@click.option("-y", "--yes", is_flag=True, help="take what is proposed, and ask nothing")
@click.option("--dry-run", is_flag=True, help="print the files, and write nothing")
@options.JSON
def main(**values: Any) -> None:
    """Finds the ROS packages in FOLDER, proposes a base image for them, and writes what you need to build and run them.

    \b
    .env           inputs of rosml containerize: base image, command, name
    .rosml.toml    defaults of rosml run in this folder
    Dockerfile     for those who build with Docker alone
    .dockerignore  what neither of them gets
    a CI file      if --registry names a registry that CI reaches

    On a terminal, it asks about each choice; options answer in advance. Files that are there stay as they are. It reaches no
    network.

    \b
    Examples:
      rosml init
      rosml init --yes --distribution jazzy --framework torch --gpu
      rosml init --ci github --registry ghcr.io/me/rosml
      rosml init --images robot-images --registry ghcr.io/me/robot-images --distribution jazzy,humble
    """
    call = Call(**values)
    if call.images:
        _set_of_images(call)
    elif call.folder.is_dir():
        _begin(call, call.folder.resolve())
    else:
        raise click.BadParameter(f"Directory '{call.folder}' does not exist.", param_hint="'[FOLDER]'")


def _begin(call: Call, folder: Path) -> None:
    from rosml.cli.images import own_set
    from rosml.containerize.init import choices, file_texts, forge, libraries, packages
    from rosml.containerize.init import folder as folders
    from rosml.containerize.init.situation import Situation, Wishes
    from rosml.images.image_set import load

    registry, push_to = forge.place_of(call.registry), forge.place_of(call.push_to)
    image_set = load.load(call.matrix, ROOT)
    env, broken = folders.env(folder)
    scan = packages.find(folder, libraries.words(image_set.matrix), env)
    ask = _asker(call, scan)
    locked = "" if env.get("BASE_IMAGE") else folders.locked_base_image(folder, env)
    proposed = "" if registry else _registry_of(env.get("BASE_IMAGE") or locked, image_set)
    source = "the lock file" if locked else ".env"
    place = _confirmed(proposed, source) if proposed and ask is _ask else registry
    address = own_set.address_of_rosml(call.rosml)
    wishes = Wishes(call.distribution, call.component, call.framework, call.accelerator, call.gpu, call.command)
    decision = choices.decide(Situation(image_set, scan, wishes, _surroundings(folder, env, locked), ask))
    ci = forge.choose(folder, forge.CiWishes(call.ci, place, push_to, address), image_set.matrix, ask)
    name = file_texts.image_name(env.get("IMAGE_NAME") or folder.name)
    project = _project(name, scan, decision, ci, address, image_set)
    if image_set.by_tag(locked) is decision.image and locked.rpartition("/")[0] == place:
        project = replace(project, locked=locked)
    first = folders.compared(folder, file_texts.texts(project))
    if not call.dry_run:
        folders.write(folder, first)
    unconfirmed = (
        UNCONFIRMED.format(source, proposed),
        f"--registry {proposed}, if you trust it",
    )
    notes = [
        *_guessed(project, address, first),
        *([unconfirmed] if proposed and not place else []),
        *decision.notes,
        *_about_files(folder, env, broken, first, project),
        *_about_lists(locked, project),
    ]
    for message, remedy in notes:
        warn(message, remedy)
    calls = [*_published(image_set, decision.image, project), *_calls(folder, decision, project, first)]
    if call.as_json:
        documents = _as_json(folder, scan, _choices(decision, ci), project.base_image)
        terminal.echo(json.dumps({**documents, **first_files.as_json(first, calls)}, indent=2))
    else:
        _print(scan, _choices(decision, ci))
        first_files.show(first, calls, call.dry_run)


def _surroundings(folder: Path, env: Mapping[str, str], locked: str) -> Surroundings:
    from rosml.containerize.init import folder as folders
    from rosml.containerize.init.situation import Surroundings
    from rosml.run.host import host
    from rosml.run.plugins import gpu

    machine, today = host(os.environ), datetime.datetime.now(datetime.UTC).date()
    hints = tuple(folders.hints(folder, os.environ))
    return Surroundings(today, env, hints, gpu.is_nvidia(machine), gpu.driver(machine), locked)


def _project(name: str, scan: FolderScan, decision: Decision, ci: Ci, address: str, image_set: ImageSet) -> Project:
    from rosml.containerize.init import file_texts, forge

    image, matrix = decision.image, image_set.matrix
    return file_texts.Project(
        name=name,
        tag=image.tags[0],
        place=ci.place,
        ros=image.ros,
        gpu="cuda" in image.versions,
        command=decision.choices["command"].value,
        ended=decision.ended,
        pip=scan.pip,
        repos=file_texts.repos_of(scan.repos, matrix, image.distribution),
        is_one_of_several=len(scan.repos) > 1,
        packages=tuple(str(package.folder) for package in scan.packages),
        forge=ci.forge.value,
        source=forge.source(ci.forge.value, ci.place, address, matrix),
        revision=forge.revision(ci.forge.value),
        images=ci.images,
        keys=decision.keys,
        addons=decision.addons,
        additional=scan.additional,
    )


def _choices(decision: Decision, ci: Ci) -> dict[str, Choice]:
    from rosml.containerize.init.forge import OWN_PLACE
    from rosml.containerize.init.situation import BY_USER, Choice

    choices = {**decision.choices, "ci": ci.forge}
    if ci.images or ci.usual:
        choices["push to"] = Choice(ci.images, BY_USER) if ci.images else Choice(ci.usual, OWN_PLACE)
    return choices


# ---- A set of images -------------------------------------------------------------------------------------------------


def _set_of_images(call: Call) -> None:
    from rosml.cli.images import own_set

    context = click.get_current_context()
    useful = ("folder", "registry", "images", "rosml", "dry_run", "as_json", "yes", "distribution", "framework", "gpu")
    for parameter in context.command.params:
        source = context.get_parameter_source(str(parameter.name))
        if parameter.name not in useful and source is not ParameterSource.DEFAULT:
            raise click.UsageError(f"{parameter.opts[0]} has no meaning with --images: {own_set.EDIT}.")
    distributions, frameworks = (tuple(re.findall(r"[^,\s]+", text)) for text in (call.distribution, call.framework))
    accelerator = {None: "", True: "cuda", False: "cpu"}[call.gpu]
    wishes = own_set.Wishes(distributions, frameworks, call.registry, call.rosml, accelerator)
    own_set.begin(call.folder, wishes, call.dry_run, call.as_json)


# ---- Questions -------------------------------------------------------------------------------------------------------


def _has_terminal() -> bool:
    return os.isatty(0) and os.isatty(2)


def _asker(call: Call, scan: FolderScan) -> Ask:
    if call.yes or call.as_json or not _has_terminal():
        return lambda question, proposal: proposal.value
    terminal.echo(f"{_packages(scan)}\nEnter takes what is in brackets; ? lists the answers.\n", err=True)
    return _ask


def _ask(question: Question, proposal: Choice) -> str:
    """Asks until an answer can be read. The first clause of the proposal's reason stands behind it."""
    from rosml.base.problems import listed
    from rosml.cli.run.questions import drop_typed

    text = f"{question.text} [{proposal.value or 'none'}] ({proposal.reason.partition(';')[0]})"
    while True:
        drop_typed()
        answer: str = click.prompt(text, default=proposal.value, show_default=False, err=True).strip()
        if answer == proposal.value:
            return answer
        if answer == "?":
            terminal.echo(f"  {listed(question.answers, 'or') or 'what you like'}", err=True)
            continue
        try:
            return question.read(answer)
        except RosmlError as error:
            terminal.echo(f"  {error.message}; {error.remedy}", err=True)


def _confirmed(place: str, source: str) -> str:
    """Asks for the registry that a stranger's file may have named."""
    from rosml.containerize.init.forge import place_of
    from rosml.containerize.init.situation import Choice, Question

    return _ask(Question("Registry of the base images", place_of), Choice(place, f"{source} names it"))


# ---- Warnings --------------------------------------------------------------------------------------------------------


def _guessed(project: Project, address: str, first: Sequence[File]) -> Iterator[Note]:
    """A CI file takes rosml from a repository that only the registry's path suggests."""
    from rosml.containerize.init.file_texts import FORGES

    if not address and any(file.path == FORGES.get(project.forge) and not file.exists for file in first):
        text = f"that rosml is at {project.source} on {project.forge} is a guess from the registry's path"
        yield text, "name its address with --rosml, such as https://github.com/me/rosml"


def _registry_of(base_image: str, image_set: ImageSet) -> str:
    """The registry and path of the base image that a repository names; empty if it is none of our images, or at no such place."""
    from rosml.containerize.init import forge
    from rosml.registry import references

    if not image_set.by_tag(base_image) or not references.has_registry(base_image):
        return ""
    try:
        return forge.place_of(base_image.rpartition("/")[0])
    except RosmlError:
        return ""


def _about_files(
    folder: Path, env: Mapping[str, str], broken: Note | None, first: Sequence[File], project: Project
) -> Iterator[Note]:
    """What the files that stay do not say, and what else a build of them needs."""
    from rosml.containerize.init import file_texts
    from rosml.containerize.init import folder as folders

    if broken:
        yield broken
    elif any(file.path == ".env" and file.exists for file in first):
        values = {**env, **({"IMAGE_NAME": project.name} if "IMAGE" in env else {})}
        variables = file_texts.variables(project).items()
        if lines := [file_texts.assigned(name, value) for name, value in variables if values.get(name) != value]:
            yield f".env stays as it is, and does not say {', '.join(lines)}", "write that into it"
    for file in first:
        if file.exists and not file.same:
            pairs = [*file_texts.lacking(file.path, folders.text_of(folder / file.path), project)]
            if pairs:
                lacks, additions = (", and ".join(texts) for texts in zip(*pairs, strict=True))
                yield f"{file.path} stays as it is, and {lacks}", f"{additions}; rosml init --dry-run prints ours"
    if host := file_texts.other_registry(project):
        secrets = "secrets" if project.forge == "github" else "masked variables"
        text = f"CI logs in to {host} alone, with REGISTRY_USER and REGISTRY_PASSWORD"
        yield text, f"make these {secrets} in the repository's settings"
    if folders.ignores_env(folder):
        yield ".gitignore leaves out .env: who clones the repository has none", "git add --force .env"
    if not IN_CHECKOUT and not project.place:
        yield UNNAMED


def _about_lists(locked: str, project: Project) -> Iterator[Note]:
    """What a lock file or a list of the repository says, and the new files do not."""
    if locked and project.base_image != locked:
        text = f"the lock file is of the base image {locked}, and not of {project.base_image}"
        yield text, "keep that one with --base-image, or write the lock file again: rosml containerize --lock"
    from rosml.base.problems import listed

    pip_list = project.additional.get("additional-pip-file", "")
    if pip_list and project.pip and pip_list not in project.pip:
        text = f"rosml containerize reads {pip_list}, and not {listed(project.pip)}"
        yield text, f"write their lines into {pip_list}"


# ---- What comes next -------------------------------------------------------------------------------------------------


def _published(image_set: ImageSet, image: Image, project: Project) -> Calls:
    """The line that publishes the base image; with CI also the one for its slim image. Nobody asks the registry whether it has them."""
    from rosml.containerize.init.file_texts import FORGES
    from rosml.images.builds import base_images
    from rosml.images.matrix import combinations

    if not project.place:
        return []
    runtime = combinations.runtime(image_set.matrix, image.distribution, image.component)
    slim = (image.distribution, runtime, image.combination, image.stack)
    slim_targets = [
        other.target
        for other in image_set.images
        if (other.distribution, other.component, other.combination, other.stack) == slim and project.forge in FORGES
    ]
    only = "".join(f" --only {target}" for target in (image.target, *slim_targets))
    program, where = (command.call(), "") if IN_CHECKOUT else ("./rosml", "in a clone of rosml: ")
    what = "publishes the base image" + (", and the one for slim images" if slim_targets else "")
    line = f"{program} publish all --registry {project.place}{only} --serve {base_images.native_architecture()}"
    return [(line, f"{where}{what}, if nobody has yet")]


def _calls(folder: Path, decision: Decision, project: Project, first: Sequence[File]) -> Calls:
    from rosml.containerize.init.file_texts import DOCKERFILE, FORGES

    cwd = Path.cwd()
    where = shlex.quote(str(folder.relative_to(cwd) if folder.is_relative_to(cwd) else folder))
    is_here, program = where == ".", command.call()
    containerize = f"{program} containerize{'' if is_here else f' {where}'}"
    calls: Calls = []
    local, has_base = ("", False) if project.place else _local(project.tag)
    if IN_CHECKOUT and not project.place and not has_base:
        what = "builds the base image, which this machine does not have yet"
        calls.append((f"{program} image {decision.image.target}", what))
    images = f"{project.name} to run them, {project.dev_image} to work on them"
    calls.append((containerize, f"builds and tests your packages: {images}"))
    run = f"{program} run" if is_here else f"cd {where} && {command.call(folder)} run"
    calls.append((run, "a shell in the image to work in, with your folder in it"))
    if project.images and project.forge not in FORGES:
        calls.append((f"{containerize} --push --image-name {project.images}", "the same, and pushes them"))
    ours = [file.path for file in first if file.same or not file.exists]
    if DOCKERFILE in ours:
        base = "" if project.place else f"--build-arg BASE_IMAGE={local or 'REGISTRY'}/{project.tag} "
        calls.append((f"docker build {base}-t {project.name} {where}", "the same without rosml, by the Dockerfile"))
    if (file := FORGES.get(project.forge)) in ours:
        git = "git" if is_here else f"git -C {where}"
        calls.append((f"{git} add {' '.join(ours)}", f"then commit and push: {file} builds and tests each commit"))
    return calls


def _local(tag: str) -> tuple[str, bool]:
    """The place of a checkout's local registry, empty if it is not up; and whether it has a tag."""
    from rosml.machine.services import Services
    from rosml.registry.place import Place

    if not IN_CHECKOUT:
        return "", False
    try:
        place = Place.at(Services.load(ROOT).place)
        repository, _, name = tag.partition(":")
        return str(place), bool(place.client.head(place.path(repository), name))
    except RosmlError:
        return "", False


# ---- Output ----------------------------------------------------------------------------------------------------------


def _packages(scan: FolderScan) -> str:
    from rosml.base.problems import counted, listed, some
    from rosml.containerize.init.packages import LANGUAGES

    languages = listed([name for name in LANGUAGES if any(name in package.languages for package in scan.packages)])
    text = f"{counted(len(scan.packages), 'package')}: {some(package.name for package in scan.packages)}"
    return f"{text} ({languages})" if languages else text


def _print(scan: FolderScan, choices: Mapping[str, Choice]) -> None:
    terminal.echo(f"{_packages(scan)}\n")
    wide, width = max(map(len, choices)), max(len(choice.value) for choice in choices.values())
    for name, choice in choices.items():
        terminal.echo(f"{name:<{wide}}  {choice.value or '-':<{width}}  {choice.reason}")
    terminal.echo()


def _as_json(folder: Path, scan: FolderScan, choices: Mapping[str, Choice], base_image: str) -> dict[str, Any]:
    return {
        "folder": str(folder),
        "packages": [
            {"name": package.name, "folder": str(package.folder), "languages": list(package.languages)}
            for package in scan.packages
        ],
        "choices": {name: {"value": choice.value, "reason": choice.reason} for name, choice in choices.items()},
        "base_image": base_image,
    }
