"""The CI file of `rosml init`: for which forge, and where its jobs get rosml."""

from __future__ import annotations

import contextlib
import re
from dataclasses import dataclass
from pathlib import Path

from rosml import IN_CHECKOUT, ROOT
from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.containerize.ci import inputs as ci_inputs
from rosml.containerize.init import synonyms
from rosml.containerize.init.file_texts import FORGES, GITLAB
from rosml.containerize.init.folder import text_of
from rosml.containerize.init.situation import Ask, Choice, Question, settle
from rosml.images.matrix.model import Matrix
from rosml.machine import git
from rosml.registry.place import Place

NONE = "none"

OWN_PLACE = "the repository's own place"

BRANCH = "main"
"""The branch of rosml that jobs take if no commit is known to be there."""

GITHUB_ADDRESS = "https://github.com/"


@dataclass(frozen=True)
class CiWishes:
    """What the user says, empty if nothing: also where base images are, where images go, and the public address of rosml."""

    forge: str = ""
    place: str = ""
    images: str = ""
    rosml: str = ""


@dataclass(frozen=True)
class Ci:
    """The forge for which a file is written, or NONE, and where base images are. `images` is where images go, unless CI pushes there by
    itself; `usual` is where it does."""

    forge: Choice
    place: str
    images: str
    usual: str = ""


def choose(folder: Path, wishes: CiWishes, matrix: Matrix, ask: Ask) -> Ci:
    """The forge for which a CI file is written, and where its jobs push: as the user says, or as the repository does."""
    answers = [*FORGES, NONE]

    def read(answer: str) -> str:
        if (name := synonyms.forge(answer)) not in answers:
            raise RosmlError(unknown("forge", answer, answers), f"take {listed(answers, 'or')}", exit_code=2)
        return name

    forge, place = settle(ask, Question("CI file for", read, answers), wishes.forge, _proposed(folder)), wishes.place
    if not place and (forge.value != NONE or not IN_CHECKOUT):
        why = "such as ghcr.io/me/rosml" + ("" if forge.value == NONE else ": jobs do not reach this machine's images")
        place = ask(Question("Registry of the base images", place_of), Choice("", why))
    if forge.value != NONE and (hindrance := _hinders(folder, forge.value, place, wishes.rosml, matrix)):
        if wishes.forge:
            raise RosmlError(*hindrance, exit_code=2)
        forge = Choice(NONE, "; ".join(hindrance))
    if forge.value == NONE:
        return Ci(forge, place, wishes.images)
    usual = _pushes(folder, forge.value)
    question = Question("Push images to", place_of)
    pushed = wishes.images or ask(question, Choice(usual, OWN_PLACE))
    return Ci(forge, place, "" if pushed == usual else pushed, usual)


def place_of(text: str) -> str:
    """A registry and a path in it, as a user names it; empty for words such as none."""
    return "" if text.lower() in ("", *synonyms.NOTHING) else str(Place.at(text.lower()))


def _pushes(folder: Path, forge: str) -> str:
    for address in _remotes(folder):
        if forge == "github" and (match := re.search(r"\bgithub\.com[:/]([\w.-]+/[\w.-]+?)(?:\.git)?/?$", address)):
            return f"ghcr.io/{match[1].lower()}"
    return next(str(getattr(item, forge)) for item in ci_inputs.SETTINGS if item.input.name == "image-name")


def _proposed(folder: Path) -> Choice:
    if (folder / ".github").is_dir():
        return Choice("github", "there is a folder .github")
    if (folder / GITLAB).is_file():
        return Choice("gitlab", f"there is {GITLAB}")
    for address in _remotes(folder):
        if name := next((name for name in FORGES if re.search(rf"\b{name}\b", address)), ""):
            return Choice(name, f"git's remote is {address.rpartition('@')[2]}")
    return Choice(NONE, "no forge is known; --ci names one")


def _remotes(folder: Path) -> list[str]:
    return re.findall(r"^[ \t]*url[ \t]*=[ \t]*(\S+)", text_of(folder / ".git/config"), re.MULTILINE)


def _hinders(folder: Path, forge: str, place: str, rosml: str, matrix: Matrix) -> tuple[str, str] | None:
    if not place or place.partition("/")[0].partition(":")[0] in ("localhost", "127.0.0.1"):
        return "jobs do not reach this machine's images", "--registry ghcr.io/me/rosml names a registry that they reach"
    if (top := git.top(folder) or folder) != folder:
        return f"CI files belong into {top}", "call rosml init there"
    if not source(forge, place, rosml, matrix):
        remedy = f"name its address with --rosml, such as {GITHUB_ADDRESS}me/rosml"
        return f"nobody knows where on {forge} the repository of rosml is", remedy
    return None


def source(forge: str, place: str, rosml: str, matrix: Matrix) -> str:
    """The repository of rosml on a forge, such as `me/rosml`: by its address, or else by the registry's path or by matrix.yaml, which may
    be a set's. Empty if none is on that forge."""
    host, _, path = place.partition("/")
    if match := re.fullmatch(rf"https://{forge}\.com/([\w.-]+(?:/[\w.-]+)+?)(?:\.git)?", rosml):
        return match[1]
    if forge == "github":
        if host == "ghcr.io" and "/" in path:
            return "/".join(path.split("/")[:2])
        address = (matrix.source or "").removesuffix(".git")
        return address.removeprefix(GITHUB_ADDRESS) if address.startswith(GITHUB_ADDRESS) else ""
    return path if forge == "gitlab" and host.startswith("registry.") and "/" in path else ""


def revision(forge: str) -> str:
    """The commit of this checkout if its remote has it, for a forge that takes one; else the branch."""
    if forge == "github" and IN_CHECKOUT and (commit := git.commit(ROOT)):
        with contextlib.suppress(RosmlError):
            if git.ask(ROOT, "for-each-ref", "--count=1", f"--contains={commit.hash}", "refs/remotes").strip():
                return commit.hash
    return BRANCH
