"""`rosml init`: the files with which people begin, for the ROS packages in a folder."""

from __future__ import annotations

import datetime
import json
import os
import re
import shlex
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from rosml import IN_CHECKOUT, ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import checkout, first_files, options
from rosml.cli.checkout import Command
from rosml.cli.command import warn
from rosml.cli.first_files import Calls

if TYPE_CHECKING:
    from rosml.containerize.init.choices import Choice, Decided
    from rosml.containerize.init.contents import Project
    from rosml.containerize.init.folder import File
    from rosml.containerize.init.packages import Found
    from rosml.images.image_set.model import Image, ImageSet

KEPT = "interrupted: nothing was written"
"""The message after Ctrl-C."""

UNNAMED = (
    "no registry is named: the base image in .env is one that only a checkout has on its machine",
    "name a registry with --registry; or write it before the name in .env, such as ghcr.io/me/rosml/",
)
"""What to say where rosml is installed, and nobody said where base images are."""


@click.command(
    "init",
    short_help="Writes the first files for the ROS packages in a folder.",
    cls=Command,
    alone=True,
    kept=KEPT,
)
@click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path), default=".")
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
def main(
    folder: Path,
    ci: str,
    registry: str,
    push_to: str,
    matrix: Path,
    yes: bool,
    dry_run: bool,
    as_json: bool,
    accelerator: str,
    images: bool,
    rosml: str,
    **given: Any,
) -> None:
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
    if images:
        _set_of_images(folder, registry, rosml, dry_run, as_json)
        return
    if not folder.is_dir():
        raise click.BadParameter(f"Directory '{folder}' does not exist.", param_hint="'[FOLDER]'")
    from rosml.cli.images import own_set
    from rosml.containerize import inputs as app_inputs
    from rosml.containerize.init import choices, contents, forge, packages
    from rosml.containerize.init import folder as folders
    from rosml.containerize.init.choices import Choice
    from rosml.images.image_set import load
    from rosml.run.host import host
    from rosml.run.plugins import gpu as gpus

    folder = folder.resolve()
    place, images_to = forge.place_of(registry), forge.place_of(push_to)
    image_set = load.load(matrix, ROOT)
    found = packages.find(folder, choices.libraries(image_set.matrix))
    env, broken = folders.env(folder)
    machine = host(os.environ)
    here = choices.Here(
        datetime.datetime.now(datetime.UTC).date(),
        env,
        tuple(folders.hints(folder, os.environ)),
        gpus.is_nvidia(machine),
        gpus.driver(machine),
    )
    ask: choices.Ask = _take
    if not (yes or as_json) and _has_terminal():
        terminal.echo(f"{_packages(found)}\nEnter takes what is in brackets; ? lists the answers.\n", err=True)
        ask = _ask
    proposed = "" if place else _registry_of(env, image_set)
    if proposed and ask is _ask:
        place = ask("Registry of the base images", Choice(proposed, f"{app_inputs.FILE} names it"), (), forge.place_of)
    address = own_set.address_of_rosml(rosml)
    decided = choices.decide(image_set, found, choices.Given(stack=accelerator, **given), here, ask)
    jobs = forge.chosen(folder, ci, place, images_to, address, image_set.matrix, ask)
    project = contents.Project(
        name=contents.image_name(env.get("IMAGE_NAME") or folder.name),
        tag=decided.image.tags[0],
        place=jobs.place,
        ros=decided.image.ros,
        gpu="cuda" in decided.image.versions,
        command=decided.command,
        ended=decided.ended,
        pip=found.pip,
        repos=contents.repos_of(found.repos, image_set.matrix, decided.image.distribution),
        one_of_several=len(found.repos) > 1,
        packages=tuple(str(package.folder) for package in found.packages),
        forge=jobs.forge.value,
        source=forge.source(jobs.forge.value, jobs.place, address, image_set.matrix),
        revision=forge.revision(jobs.forge.value),
        images=jobs.images,
        keys=decided.keys,
        addons=decided.addons,
    )
    wanted = folders.compared(folder, contents.contents(project))
    if not dry_run:
        folders.write(folder, wanted)
    notes = [
        *_guessed(project, address, wanted),
        *(
            [(UNCONFIRMED.format(proposed), f"--registry {proposed}, if you trust it")]
            if proposed and not place
            else []
        ),
        *decided.notes,
        *([broken] if broken else _lacking(env, wanted, project)),
        *_kept(folder, wanted, project),
        *_secrets(project),
    ]
    if folders.ignores_env(folder):
        notes.append((".gitignore leaves out .env: who clones the repository has none", "git add --force .env"))
    for message, remedy in [*notes, *([] if IN_CHECKOUT or project.place else [UNNAMED])]:
        warn(message, remedy)
    chosen = {**decided.choices, "ci": jobs.forge}
    if pushed := jobs.images or jobs.usual:
        chosen["push to"] = choices.Choice(pushed, "you ask for it" if jobs.images else "the repository's own place")
    calls = [*_published(image_set, decided.image, project), *_calls(folder, decided, project, wanted)]
    if as_json:
        terminal.echo(json.dumps(_as_json(folder, found, chosen, project, wanted, calls), indent=2))
    else:
        _print(found, chosen, wanted, calls, dry_run)


# ---- A set of images -------------------------------------------------------------------------------------------------


def _set_of_images(folder: Path, registry: str, rosml: str, dry_run: bool, as_json: bool) -> None:
    """`--images`.

    Raises:
        click.UsageError: an option has no meaning for it.
    """
    from rosml.cli.images import own_set

    context = click.get_current_context()
    taken = ("folder", "registry", "images", "rosml", "dry_run", "as_json", "yes", "distribution", "framework", "gpu")
    for parameter in context.command.params:
        if (
            parameter.name not in taken
            and context.get_parameter_source(str(parameter.name)) is not ParameterSource.DEFAULT
        ):
            raise click.UsageError(f"{parameter.opts[0]} has no meaning with --images: {own_set.EDIT}.")
    names = {name: tuple(re.findall(r"[^,\s]+", context.params[name])) for name in ("distribution", "framework")}
    accelerator = {None: "", True: "cuda", False: "cpu"}[context.params["gpu"]]
    own_set.begin(folder, names["distribution"], names["framework"], registry, rosml, accelerator, dry_run, as_json)


# ---- Questions -------------------------------------------------------------------------------------------------------


def _has_terminal() -> bool:
    """Whether there is a terminal for questions and their answers."""
    return os.isatty(0) and os.isatty(2)


def _ask(asked: str, proposal: Choice, answers: Sequence[str], read: Callable[[str], str]) -> str:
    """Asks until an answer can be read. The first clause of the proposal's reason stands behind it."""
    from rosml.base.problems import listed
    from rosml.cli.run import question

    text = f"{asked} [{proposal.value or 'none'}] ({proposal.reason.partition(';')[0]})"
    while True:
        question.drop_typed()
        said: str = click.prompt(text, default=proposal.value, show_default=False, err=True).strip()
        if said == proposal.value:
            return said
        if said == "?":
            terminal.echo(f"  {listed(answers, 'or') or 'what you like'}", err=True)
            continue
        try:
            return read(said)
        except RosmlError as error:
            terminal.echo(f"  {error.message}; {error.remedy}", err=True)


def _take(question: str, proposal: Choice, answers: Sequence[str], read: Callable[[str], str]) -> str:
    return proposal.value


def _guessed(project: Project, address: str, wanted: Sequence[File]) -> Iterator[tuple[str, str]]:
    """A CI file takes rosml from a repository that only the registry's path suggests."""
    from rosml.containerize.init import contents

    if not address and any(file.path == contents.FORGES.get(project.forge) and not file.there for file in wanted):
        text = f"that rosml is at {project.source} on {project.forge} is a guess from the registry's path"
        yield text, "name its address with --rosml, such as https://github.com/me/rosml"


UNCONFIRMED = ".env of the repository names the registry {}, and nobody has confirmed it: the files do not"
"""What is said of a registry that only a file of the repository names."""


def _registry_of(env: Mapping[str, str], image_set: ImageSet) -> str:
    """The registry and path of the base image in a `.env`; empty if it names none of our images, or no such place."""
    from rosml.containerize.init import forge
    from rosml.registry import references

    named = env.get("BASE_IMAGE", "")
    if not image_set.by_tag(named) or not references.has_registry(named):
        return ""
    try:
        return forge.place_of(named.rpartition("/")[0])
    except RosmlError:
        return ""


def _secrets(project: Project) -> Iterator[tuple[str, str]]:
    """CI logs in to another registry than the forge's by a password that only people have."""
    from rosml.containerize.init import contents

    if host := contents.other_registry(project):
        yield (
            f"CI logs in to {host} alone, with REGISTRY_USER and REGISTRY_PASSWORD",
            f"make these {'secrets' if project.forge == 'github' else 'masked variables'} in the repository's settings",
        )


# ---- What comes next -------------------------------------------------------------------------------------------------


def _lacking(env: Mapping[str, str], wanted: Sequence[File], project: Project) -> Iterator[tuple[str, str]]:
    """What a `.env` that stays does not say."""
    from rosml.containerize import inputs as app_inputs
    from rosml.containerize.init import contents

    if any(file.path == app_inputs.FILE and file.there for file in wanted):
        inputs = contents.variables(project).items()
        said = {**env, **({"IMAGE_NAME": project.name} if "IMAGE" in env else {})}
        if lines := [contents.assigned(name, value) for name, value in inputs if said.get(name) != value]:
            yield f"{app_inputs.FILE} stays as it is, and does not say {', '.join(lines)}", "write that into it"


def _kept(folder: Path, wanted: Sequence[File], project: Project) -> Iterator[tuple[str, str]]:
    """What a Dockerfile and a CI file that stay do not say."""
    from rosml.containerize.init import contents
    from rosml.containerize.init import folder as folders

    for file in wanted:
        if file.there and not file.same:
            found = list(contents.lacking(file.path, folders.text_of(folder / file.path), project))
            if found:
                lacks, lines = (", and ".join(texts) for texts in zip(*found, strict=True))
                yield f"{file.path} stays as it is, and {lacks}", f"{lines}; rosml init --dry-run prints ours"


def _published(image_set: ImageSet, image: Image, project: Project) -> Calls:
    """The line that publishes the base image; with CI also the one for its slim image. Nobody asks the registry whether it is there."""
    from rosml.containerize.init import contents
    from rosml.images.builds import base_images
    from rosml.images.matrix import rules

    if not project.place:
        return []
    targets = [image.target]
    if project.forge in contents.FORGES:
        kind = (image.distribution, rules.runtime(image_set.matrix, image.distribution, image.component))
        slim = (*kind, image.combination, image.stack)
        targets += [
            other.target
            for other in image_set.images
            if (other.distribution, other.component, other.combination, other.stack) == slim
        ]
    only = "".join(f" --only {target}" for target in targets)
    own, where = (checkout.call(), "") if IN_CHECKOUT else ("./rosml", "in a clone of rosml: ")
    what = "publishes the base image" + (", and the one for slim images" if targets[1:] else "")
    line = f"{own} publish all --registry {project.place}{only} --serve {base_images.native_architecture()}"
    return [(line, f"{where}{what}, if nobody has yet")]


def _calls(folder: Path, decided: Decided, project: Project, wanted: Sequence[File]) -> Calls:
    from rosml.containerize.init import contents

    here = Path.cwd()
    where = shlex.quote(str(folder.relative_to(here) if folder.is_relative_to(here) else folder))
    own = checkout.call()
    calls: Calls = []
    local, has = ("", False) if project.place else _local(project.tag)
    if IN_CHECKOUT and not project.place and not has:
        calls.append(
            (f"{own} image {decided.image.target}", "builds the base image, which this machine does not have yet")
        )
    made = f"{project.name} to run them, {project.dev_image} to work on them"
    calls.append(
        (f"{own} containerize{'' if where == '.' else f' {where}'}", f"builds and tests your packages: {made}")
    )
    run = f"{own} run" if where == "." else f"cd {where} && {checkout.call(folder)} run"
    calls.append((run, "a shell in the image to work in, with your folder in it"))
    if project.images and project.forge not in contents.FORGES:
        push = f"{own} containerize{'' if where == '.' else f' {where}'} --push --image-name {project.images}"
        calls.append((push, "the same, and pushes them"))
    ours = [file.path for file in wanted if file.same or not file.there]
    if contents.DOCKERFILE in ours:
        base = "" if project.place else f"--build-arg BASE_IMAGE={local or 'REGISTRY'}/{project.tag} "
        calls.append((f"docker build {base}-t {project.name} {where}", "the same without rosml, by the Dockerfile"))
    if (file := contents.FORGES.get(project.forge)) in ours:
        git = "git" if where == "." else f"git -C {where}"
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


def _packages(found: Found) -> str:
    from rosml.base.problems import counted, listed, some
    from rosml.containerize.init.packages import LANGUAGES

    spoken = listed([name for name in LANGUAGES if any(name in package.languages for package in found.packages)])
    text = f"{counted(len(found.packages), 'package')}: {some(package.name for package in found.packages)}"
    return f"{text} ({spoken})" if spoken else text


def _print(found: Found, chosen: Mapping[str, Choice], wanted: Sequence[File], calls: Calls, dry_run: bool) -> None:
    terminal.echo(f"{_packages(found)}\n")
    wide, width = max(map(len, chosen)), max(len(choice.value) for choice in chosen.values())
    for name, choice in chosen.items():
        terminal.echo(f"{name:<{wide}}  {choice.value or '-':<{width}}  {choice.reason}")
    terminal.echo()
    first_files.show(wanted, calls, dry_run)


def _as_json(
    folder: Path,
    found: Found,
    chosen: Mapping[str, Choice],
    project: Project,
    wanted: Sequence[File],
    calls: Calls,
) -> dict[str, Any]:
    return {
        "folder": str(folder),
        "packages": [
            {"name": package.name, "folder": str(package.folder), "languages": list(package.languages)}
            for package in found.packages
        ],
        "choices": {name: {"value": choice.value, "reason": choice.reason} for name, choice in chosen.items()},
        "base_image": project.base_image,
        **first_files.as_json(wanted, calls),
    }
