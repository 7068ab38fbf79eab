"""`rosml init --images`: the files of a set of somebody's own."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from rosml import IN_CHECKOUT, MATRIX, ROOT
from rosml.base import terminal, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.base.project_addresses import addresses
from rosml.cli import first_files
from rosml.images.image_set import load, own_set
from rosml.images.image_set.model import Image
from rosml.images.image_set.own_set import Upstream
from rosml.machine import git
from rosml.registry.place import Place

EDIT = f"edit {own_set.SET} afterwards"


@dataclass(frozen=True)
class Wishes:
    """What the user wants in the set. Names in the matrix are the usual ones if empty.

    Attributes:
        rosml: the address of rosml's repository; empty if it is the one that this rosml is from.
        accelerator: `cuda` or `cpu`; both if empty.
    """

    distributions: Sequence[str]
    frameworks: Sequence[str]
    registry: str
    rosml: str
    accelerator: str


def begin(folder: Path, wishes: Wishes, dry_run: bool, as_json: bool) -> None:
    """Writes the files that are missing in the folder, and prints what to call next."""
    from rosml.containerize.init import folder as folders

    if not wishes.registry:
        remedy = "name it with --registry, such as ghcr.io/me/robot-images"
        raise RosmlError("a set needs a registry for its images", remedy, exit_code=2)
    registry = str(Place.at(wishes.registry))
    folder = folder.resolve()
    upstream = _upstream(wishes.rosml)
    image_set = load.load(MATRIX, ROOT)
    choice = own_set.chosen(
        image_set, wishes.distributions, wishes.frameworks, registry, _address(folder), wishes.accelerator
    )
    files = folders.compared(folder, own_set.files(image_set, choice, upstream))
    if not dry_run:
        folder.mkdir(parents=True, exist_ok=True)
        folders.write(folder, files)
        for file in files:
            if file.path in own_set.PROGRAMS and not file.exists:
                (folder / file.path).chmod(0o755)
    where = f"cd {shlex.quote(str(folder))} && " if folder != Path.cwd() else ""
    nightly = f"rosml is not on GitHub: call ./{own_set.NIGHT} every night, by cron or CI"
    nightly = "the workflow publishes the set every night" if upstream.on_github else nightly
    calls = [
        (f"{where}./rosml list", "all images of the set; the first call fetches rosml"),
        *_locks(own_set.unlocked(image_set, choice)),
        ("./rosml setup", "a registry and a builder on this machine, which plan, image and publish need"),
        ("./rosml plan --everywhere", "what is to be built, how long it takes, and how large the registry gets"),
        (f"./rosml image {choice.image.target}", "builds and tests an image on this machine"),
        ("git init && git add --all && git commit -m 'Our images' && git push", nightly),
    ]
    if as_json:
        terminal.echo(json.dumps({"folder": str(folder), **first_files.as_json(files, calls)}, indent=2))
    else:
        first_files.show(files, calls, dry_run)


def _locks(unlocked: Sequence[Image]) -> list[tuple[str, str]]:
    """The call that makes the locks that images of the set wait for."""
    if not unlocked:
        return []
    stacks = {image.stack for image in unlocked}
    names = some([image.target for image in unlocked])
    waiting = f"the locks that {'an image waits' if len(unlocked) == 1 else 'images wait'} for ({names})"
    where = "" if all(image.lost for image in unlocked) else ", on a machine that reaches PyTorch's own package index"
    return [(f"./rosml locks{f' --stack {stacks.pop()}' if len(stacks) == 1 else ''}", f"{waiting}{where}")]


def _upstream(repository: str) -> Upstream:
    """The repository and commit of this rosml. `repository` is the user's own address or folder of it; empty if none."""
    address, commit = _installed_from()
    if IN_CHECKOUT:
        head = git.commit(ROOT)
        address, commit = _address(ROOT), head.hash if head else ""
    address = address or _project()
    if repository:
        is_folder = Path(repository).exists()
        if not is_folder and not re.match(r"(https?|ssh|git|file)://|git@", repository):
            remedy = "write it as git takes it, such as https://github.com/me/rosml"
            raise RosmlError(f"{repository} is no address of a repository, and no folder", remedy, exit_code=2)
        address = _public(repository) or (str(Path(repository).resolve()) if is_folder else repository)
    if not address or not commit:
        what = "the address of rosml's repository" if commit else "the commit of this rosml"
        remedy = (
            "name it with --rosml, such as https://github.com/me/rosml, or a clone's folder for a set on this machine alone"
            if commit
            else "call it in a clone of rosml, or install it from one: uvx --from git+https://… rosml init --images"
        )
        raise RosmlError(f"{what} is not known, and the set's own command fetches it from there", remedy, exit_code=2)
    return Upstream(address, commit)


def address_of_rosml(repository: str) -> str:
    """The public address of rosml: the user's, that of this checkout or installation, or the project's; empty if unknown."""
    return _public(repository) or (_address(ROOT) if IN_CHECKOUT else _installed_from()[0]) or _project()


def _project() -> str:
    """The public address of the project's repository; empty before it has one."""
    return _public(addresses().get("Repository", ""))


def _installed_from() -> tuple[str, str]:
    """The address and the commit that pip or uv installed rosml from; empty if that was no repository."""
    try:
        origin = untrusted.json_value(metadata.distribution("rosml").read_text("direct_url.json") or "{}")
        return _public(str(origin["url"])), str(origin["vcs_info"]["commit_id"])
    except (metadata.PackageNotFoundError, ValueError, LookupError, TypeError):
        return "", ""


def _address(folder: Path) -> str:
    """The public address of the remote `origin`; empty if the folder is no repository's, or has none."""
    if git.top(folder) != folder:
        return ""
    try:
        return _public(git.ask(folder, "config", "--get", "remote.origin.url").decode(errors="replace").strip())
    except RosmlError:
        return ""


def _public(address: str) -> str:
    """An address as everybody reads it, without user and password; empty if it is of this machine."""
    address = re.sub(r"^(?:ssh://)?git@([\w.-]+)[:/]", r"https://\1/", address)
    match = re.fullmatch(r"https://(?:[^/@]*@)?([\w.:-]+/[\w./~-]+?)(?:\.git)?/?", address)
    return f"https://{match[1]}" if match else ""
