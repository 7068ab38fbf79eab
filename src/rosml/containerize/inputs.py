"""The inputs of an app: one table, from which the command's options and their documentation are made.

Names, variables and defaults are those of docker-ros (https://github.com/ika-rwth-aachen/docker-ros), so that its users keep
their files. Values come from the command line, else from the environment, else from a file `.env` in the folder. On the command
line, an empty value counts. An empty variable does not, as in `${VARIABLE:-default}`.

The file `.env` belongs to the repository, which may be a stranger's, such as a pull request. It decides what is built. Only the
user decides what is done with their rights and secrets.
"""

from __future__ import annotations

import contextlib
import functools
import os
import re
import shlex
from collections.abc import Callable, Iterator, Mapping
from dataclasses import Field, dataclass, field, fields
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize import within

YES, NO, UNPUSHED, WITH_SECRET = (
    "yes",
    "no",
    "if nothing is pushed; a name without `/`",
    "with its secret, or without one",
)
"""Whether `.env` may set an input. UNPUSHED: it names images that are pushed, or that other builds and Docker find by name.
WITH_SECRET: it names the server that gets a secret, so the user who gives the secret names the server."""


@dataclass(frozen=True)
class Input:
    """An input.

    Attributes:
        name: its name as an option of the command and an input of the action, such as `base-image`.
        help: its meaning, in one clause.
        default: its default value.
        flag: it is `true` or `false`.
        gone: for inputs of docker-ros that are not used here: the reason, which we print.
        in_repository: whether the file `.env` of a repository may set it: YES, NO, UNPUSHED or WITH_SECRET.
    """

    name: str
    help: str = ""
    default: str = ""
    flag: bool = False
    gone: str = ""
    in_repository: str = YES

    @property
    def variable(self) -> str:
        """Its name as a variable, such as `BASE_IMAGE`."""
        return self.name.upper().replace("-", "_")


def _gone(name: str, why: str) -> Input:
    return Input(name, gone=why)


_RECURSIVE = "take every file of that name in the repository and its upstream sources"


def _text(help: str, default: str = "", in_repository: str = YES) -> Any:
    """A field with a text. The arguments are those of `Input`."""
    return field(default=default, metadata={"help": help, "in_repository": in_repository})


def _flag(help: str, default: bool = False, in_repository: str = YES) -> Any:
    """A field that is true or false."""
    return field(default=default, metadata={"help": help, "in_repository": in_repository})


@dataclass(frozen=True, kw_only=True)
class Values:
    """The values of all inputs, in the order of their documentation."""

    base_image: str = _text("the image to build on; without a registry, one of the local registry or of Docker Hub")
    addons: str = _text("add-ons for the base image, separated by commas, such as onnx; onnx-cpu if it has no stack")
    command: str = _text("what the run image starts, as a shell reads it")
    target: str = _text("images to build, separated by commas: run, dev", "run,dev")
    platform: str = _text("platforms, separated by commas, such as linux/arm64; this machine's own if left out")
    image_name: str = _text("name of the run image; the folder's name if left out", in_repository=UNPUSHED)
    image_tag: str = _text("its tag", "latest", in_repository=UNPUSHED)
    dev_image_name: str = _text("name of the dev image; that of the run image if left out", in_repository=UNPUSHED)
    dev_image_tag: str = _text("its tag; that of the run image with -dev if left out", in_repository=UNPUSHED)
    enable_slim: bool = _flag("also build a slim image to run: on a base image without compilers and headers")
    slim_base_image: str = _text(
        "its base image; the one with -run in its name that belongs to the base image if left out"
    )
    slim_image_name: str = _text("name of the slim image; that of the run image if left out", in_repository=UNPUSHED)
    slim_image_tag: str = _text("its tag; that of the run image with -slim if left out", in_repository=UNPUSHED)
    push: bool = _flag("push the images to the registry that their names begin with", in_repository=NO)
    enable_push_as_latest: bool = _flag("also give the tags latest, latest-dev and latest-slim", in_repository=UNPUSHED)
    ros_distro: str = _text(
        "the ROS distribution, if the base image does not say it; on Debian's ROS 1, the one that conditions in package.xml compare with"
    )
    ros_component: str = _text(
        "what is installed if the base image has no ROS: core, base and others of its distribution", "core"
    )
    disable_ros_installation: bool = _flag(
        "install no ROS on a base image that seems to have none, such as one with a ROS built from its sources"
    )
    base_entrypoint: bool = _flag(
        'call the entrypoint of a base image without ROS before the command, if it is a script that ends in exec "$@"',
        True,
    )
    rmw_implementation: str = _text("the middleware, such as rmw_cyclonedds_cpp: installs it and sets the variable")
    tests: bool = _flag("run the tests of your packages, and make no image if one fails", True)
    downstream_workspace: str = _text(
        "a .repos file with packages that use yours: they are built and tested with yours, and are in no image"
    )
    cmake_args: str = _text("arguments of CMake for all packages", "-DCMAKE_BUILD_TYPE=Release")
    colcon_args: str = _text("arguments of colcon build, such as --executor sequential")
    parallel_jobs: str = _text(
        "how many compilers run at the same time; if left out, as many as cores, and fewer if the builder has less than 2 GB"
        " of memory for each"
    )
    cache: str = _text(
        "repository in a registry that keeps finished stages, for machines that have none; such as ghcr.io/me/robot-cache",
        in_repository=NO,
    )
    skip_keys: str = _text("keys of rosdep that are left out, separated by blanks or commas")
    rosdep_index: str = _text(
        "rosdep's lists: of a registry, such as ghcr.io/me/rosml/rosdep:latest, or of a checkout of ros/rosdistro; the newest"
        " beside the base image if left out",
        in_repository=NO,
    )
    sbom: bool = _flag("attach an SBOM and a list of files to the images to run; in a registry, not in Docker", True)
    lock_file: str = _text("what the images are built from, if it is there; --lock writes it", "containerize.lock")
    additional_debs_file: str = _text("packages for apt, one a line", "docker/additional-debs.txt")
    enable_recursive_additional_debs: bool = _flag(_RECURSIVE)
    additional_pip_file: str = _text("requirements for pip, one a line", "docker/additional-pip-requirements.txt")
    enable_recursive_additional_pip: bool = _flag(_RECURSIVE)
    additional_files_dir: str = _text("folder that becomes /docker-ros/additional-files", "docker/additional-files")
    before_dependency_identification_script: str = _text(
        "script that may change the sources before their dependencies are read",
        "docker/before_dependency_identification.sh",
    )
    before_dependency_installation_script: str = _text(
        "script that runs before dependencies are installed", "docker/before_dependency_installation.sh"
    )
    enable_recursive_before_dependency_installation_script: bool = _flag(_RECURSIVE)
    after_dependency_installation_script: str = _text(
        "script that runs after dependencies are installed", "docker/custom.sh"
    )
    enable_recursive_after_dependency_installation_script: bool = _flag(_RECURSIVE)
    blacklisted_packages_file: str = _text("names of ROS packages to leave out", "docker/blacklisted-packages.txt")
    enable_recursive_blacklisted_packages: bool = _flag(_RECURSIVE)
    enable_recursive_vcs_import: bool = _flag("import every .repos file, also of what was imported", True)
    vcs_import_file: str = _text("the .repos file, if not every one is imported", ".repos")
    allow_file_urls: bool = _flag(
        "let your .repos files name repositories of this machine, such as file:///srv/git/driver", in_repository=NO
    )
    allow_mirror_password: bool = _flag(
        "let steps that run code of the repository have the password in the address of your apt mirror",
        in_repository=NO,
    )
    git_https_server: str = _text(
        "server of private repositories, without https://", "github.com", in_repository=WITH_SECRET
    )
    git_https_user: str = _text("user on it")
    git_https_password: str = _text("password or token on it; name it in the environment, not on the command line")
    git_ssh_private_key: str = _text("key for private repositories over ssh; name it in the environment")
    git_ssh_known_host_keys: str = _text("what ssh-keyscan says of their servers", in_repository=WITH_SECRET)

    def named(self, name: str) -> str:
        """The text of an input, by its name, such as `dev-image-tag`."""
        value = getattr(self, name.replace("-", "_"))
        return str(value).lower() if isinstance(value, bool) else str(value)


def _input(item: Field[Any]) -> Input:
    flag = isinstance(item.default, bool)
    default = str(item.default).lower() if flag else str(item.default)
    return Input(item.name.replace("_", "-"), default=default, flag=flag, **item.metadata)


TABLE = (
    *map(_input, fields(Values)),
    _gone("custom-script-file", "it is after-dependency-installation-script"),
    _gone("slim-build-args", "no program is watched to find out what an image needs"),
    _gone("additional-slim-build-args", "no program is watched to find out what an image needs"),
    _gone(
        "enable-industrial-ci",
        "tests run here without it; its ROSDEP_SKIP_KEYS, NOT_TEST_BUILD, CMAKE_ARGS and DOWNSTREAM_WORKSPACE count",
    ),
    _gone(
        "buildx-attestations",
        "an SBOM is attached to images, and is not in them, so that the same sources have the same digest",
    ),
    _gone("docker-ros-git-ref", "the version of rosml decides"),
)
"""All inputs, in the order of their documentation."""

SECRET = ("git-https-password", "git-ssh-private-key")
"""Inputs that are no options, because other users of the machine can see command lines."""

_SECRET_OF = {"git-https-server": "git-https-password", "git-ssh-known-host-keys": "git-ssh-private-key"}
"""For inputs that name servers: the secret that these get."""

_IMAGE = Input("image", in_repository=UNPUSHED)
"""The run image with its tag, as in docker-ros' local script: image-name and image-tag in one."""

_INDUSTRIAL_CI = ("ROSDEP_SKIP_KEYS", "NOT_TEST_BUILD")
"""Variables of industrial_ci with another name here. Those with the same name count anyway."""

FILE = ".env"

_PATTERNS = {
    "ros-distro": ("[a-z][a-z0-9]*|Debian", "name one, such as jazzy"),
    "rmw-implementation": ("rmw_[a-z0-9_]+", "name one, such as rmw_cyclonedds_cpp"),
    "parallel-jobs": ("[1-9][0-9]{0,3}", "name a number, such as 1"),
}
"""Inputs that become part of package names, or numbers in a script: the pattern of their values, and a remedy."""

_PIECE = re.compile(r"""'([^']*)'|"((?:[^"\\]|\\.)*)"|\\(.)|([^\s'"\\]+)""", re.DOTALL)


def default(name: str) -> str:
    """The default of an input of the table."""
    return next(item.default for item in TABLE if item.name == name)


def values(given: Mapping[str, str | None], folder: Path, environment: Mapping[str, str]) -> Values:
    """The values of all inputs.

    Args:
        given: values of the command line; None if an input is not given.
        folder: the repository, which may have `.env`.
        environment: the variables of the process.

    Raises:
        RosmlError: `.env` cannot be read, or sets an input that it may not set; or a value is wrong (exit code 2).
    """
    variables = read_env(folder / FILE)
    line = {name: value for name, value in given.items() if value is not None}
    both = line.keys().isdisjoint(("image-name", "image-tag"))  # if one of them is typed, the other one has its default
    of_repository = _said(_of_industrial_ci(environment, variables) | variables, both)
    of_person = _said(environment, both) | line
    found: dict[str, str] = {}
    for item in TABLE:
        if item.gone:
            continue
        value = of_person.get(item.name, of_repository.get(item.name, item.default))
        if item.flag:
            value = value.lower()
            if value not in ("true", "false"):
                raise RosmlError(f"{item.name} is true or false, not {value!r}", f"check {item.variable}", exit_code=2)
        _require_possible(item.name, value)
        found[item.name] = value
    for name in (name for name in of_repository if name not in of_person):
        _require_allowed(name, found, of_person, folder / FILE, variables)
    flags = {item.name for item in TABLE if item.flag}
    said: dict[str, Any] = {name: text == "true" if name in flags else text for name, text in found.items()}
    return Values(**{name.replace("-", "_"): value for name, value in said.items()})


def first_look(name: str, given: Mapping[str, str], folder: Path, environment: Mapping[str, str]) -> str:
    """The text of one input before any is checked; `.env` says nothing if it cannot be read. The arguments are those of `values`."""
    variable = next(item.variable for item in TABLE if item.name == name)
    in_file: dict[str, str] = {}
    with contextlib.suppress(RosmlError):
        in_file = read_env(folder / FILE)
    return given.get(name) or environment.get(variable) or in_file.get(variable) or default(name)


def _said(variables: Mapping[str, str], image: bool) -> dict[str, str]:
    """The inputs that variables set, by name. Empty variables do not count.

    Args:
        image: `IMAGE` counts, before the variables for its name and its tag.
    """
    found = {item.name: text for item in TABLE if not item.gone and (text := variables.get(item.variable, ""))}
    if image and (named := variables.get(_IMAGE.variable, "")):
        name, colon, tag = named.rpartition(":")
        if not colon or "/" in tag:
            name, tag = named, ""
        found |= {"image-name": name} | ({"image-tag": tag} if tag else {})
    return found


def _require_allowed(
    name: str, values: Mapping[str, str], of_person: Mapping[str, str], file: Path, variables: Mapping[str, str]
) -> None:
    """Checks that a repository may set an input.

    Args:
        values: the values of all inputs.
        of_person: the values from the user.
        variables: the variables of the repository's file.

    Raises:
        RosmlError: it may not (exit code 2).
    """
    item = next(item for item in TABLE if item.name == name)
    secret = _SECRET_OF.get(name, "")
    allowed = {
        YES: True,
        NO: False,
        UNPUSHED: values["push"] == "false" and not ("/" in values[name] and name.endswith("-name")),
        WITH_SECRET: not (secret in of_person and values[secret]),
    }
    if allowed[item.in_repository] or values[name] == item.default:
        return
    variable = item.variable if item.variable in variables else _IMAGE.variable
    option = f"--{name}" if item.flag else f"--{name} {shlex.quote(values[name])}"
    text = f"{file}:{_line_of(file, variable)}: {variable} is not for a repository to say"
    if secret:
        text += f": {secret.upper().replace('-', '_')} is yours, and goes to servers that you name"
    elif values["push"] == "true":
        text += ", as the images are pushed"
    elif item.in_repository == UNPUSHED:
        text += ", as it names a place of its own: a name without / is enough here"
    raise RosmlError(text, f"if you want it, type {option}; or remove the line", exit_code=2)


def _line_of(file: Path, variable: str) -> int:
    """The last line of a file that sets a variable."""
    lines = file.read_text("utf-8-sig").split("\n")
    pattern = re.compile(rf"\s*(export\s+)?{variable}=")
    return max((number for number, line in enumerate(lines, 1) if pattern.match(line)), default=1)


def _of_industrial_ci(environment: Mapping[str, str], file: Mapping[str, str]) -> dict[str, str]:
    """The variables of industrial_ci, by our names, if the user has switched it on."""
    given = {**file, **environment}
    if given.get("ENABLE_INDUSTRIAL_CI", "").lower() != "true":
        return {}
    found = {"SKIP_KEYS": given.get("ROSDEP_SKIP_KEYS", "")}
    if given.get("NOT_TEST_BUILD", "").lower() == "true":
        found["TESTS"] = "false"
    return found


def _require_possible(name: str, value: str) -> None:
    """Checks a value that becomes words of a shell, or part of a package name.

    Raises:
        RosmlError: it cannot (exit code 2).
    """
    if name in ("cmake-args", "colcon-args"):
        problem, remedy = _problem_of_words(value), "write it as a shell reads it, such as -DNAME='a;b'"
    else:
        pattern, remedy = _PATTERNS.get(name, ("(?s:.*)", ""))
        problem = "" if not value or re.fullmatch(pattern, value) else "that is none"
    if problem:
        raise RosmlError(f"{name}: {value!r}: {problem}", remedy, exit_code=2)


def _problem_of_words(text: str) -> str:
    """Why a shell cannot read a text as plain words; empty if it can."""
    place = 0
    while place < len(text):
        if text[place].isspace():
            place += 1
            continue
        piece = _PIECE.match(text, place)
        if piece is None:
            return "its quotation has no end"
        begins = place == 0 or text[place - 1].isspace()
        if found := re.search(r"^#|[;|&()<>`]" if begins else "[;|&()<>`]", piece[4] or ""):
            return f"{found[0]} needs quotes"
        place = piece.end()
    return ""


def answers(folder: Path, environment: Mapping[str, str]) -> Iterator[str]:
    """A sentence for each set variable that has no effect: an input of docker-ros, or an unknown name in the file."""
    file = read_env(folder / FILE)
    for item in TABLE:
        if item.gone and (environment.get(item.variable) or file.get(item.variable)):
            yield f"{item.variable} is not used: {item.gone}"
    known = {item.variable for item in (*TABLE, _IMAGE)} | {*_INDUSTRIAL_CI}
    yield from (f"{name} in {FILE} is not used: there is no such input" for name in file if name not in known)


def read_env(file: Path) -> dict[str, str]:
    """The variables in a file of `NAME=VALUE` lines, as a shell reads them, without running or expanding anything.

    Raises:
        RosmlError: it cannot be read; or a line has another form, or would need a shell (exit code 2).
    """
    content = files.regular(file, LARGEST_ENV)
    if content is None:
        return {}
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        raise RosmlError(f"{file} is not UTF-8", "save it as UTF-8", exit_code=2) from None
    if "\0" in text:
        raise RosmlError(f"{file}: it has a NUL character", "write lines of NAME='value' into it", exit_code=2)
    found: dict[str, str] = {}
    place = 0
    while (place := _NOTHING.match(text, place).end()) < len(text):  # type: ignore[union-attr] # it matches anywhere
        refusal = functools.partial(_damaged, file, text, place)
        begun = _BEGIN.match(text, place)
        if not begun:
            raise refusal("it is not NAME=VALUE")
        found[begun[1]], place = _unquoted(text, begun.end(), refusal)
    return found


LARGEST_TEXT = 1 << 20
"""The most bytes of a list or a script of a repository."""

LARGEST_ENV = 256 << 10
"""The most bytes of a file of variables."""

# No possessive group, such as (…)*+: up to Python 3.11.4 it may end too early.
_NOTHING = re.compile(r"(?:[ \t\n]+|(?<![^ \t\n])#[^\n]*)*")
"""Blanks, empty lines, and comments."""

_BEGIN = re.compile(r"(?:export[ \t]+)?([A-Za-z_][A-Za-z0-9_]*)=")

_PART = re.compile(r"""'([^']*)'|"([^"\\]*(?:\\.[^"\\]*)*)"|\\(.)|([^ \t\n'"\\]++)""", re.DOTALL)
"""A piece of a value. A shell's only blanks are spaces, tabs and line ends."""


def _damaged(file: Path, text: str, place: int, why: str) -> RosmlError:
    line = text.count("\n", 0, place) + 1
    return RosmlError(f"{file}:{line}: {why}", "write NAME='value'", exit_code=2)


def _unquoted(text: str, place: int, refusal: Callable[[str], RosmlError]) -> tuple[str, int]:
    """The value of a variable that begins at a place, as a shell reads it, and its end.

    Raises:
        RosmlError: a quotation has no end, or a shell would expand the value.
    """
    pieces: list[str] = []
    while place < len(text) and text[place] not in " \t\n":
        piece = _PART.match(text, place)
        if piece is None:
            raise refusal("its quotation has no end")
        single, double, escaped, bare = piece.groups()
        if re.search(r"(?<!\\)(\\\\)*(\$[A-Za-z_{(]|`)", double or bare or ""):
            raise refusal("a shell would expand it: put the value into single quotes")
        if double is not None:
            pieces.append(re.sub(r"\\([$`\"\\\n])", lambda found: found[1].strip("\n"), double))
        elif escaped != "\n":  # an escaped line end joins two lines
            pieces.append(single or escaped or bare or "")
        place = piece.end()
    end = text.find("\n", place)
    end = len(text) if end < 0 else end
    rest = text[place:end].strip(" \t")
    if rest and not rest.startswith("#"):
        raise refusal("a value with blanks needs quotes")
    return "".join(pieces), end


def text_of(folder: Path, name: str, recursive: bool, roots: tuple[Path, ...]) -> str:
    """The text of a file of the repository, or of all files of that name; empty if there is none.

    Args:
        folder: the repository.
        name: the file's path in it.
        recursive: every file of that name below the roots counts.
        roots: the repository and its upstream sources.

    Raises:
        RosmlError: a file cannot be read, is no file, or leads out of its repository (exit code 2).
    """
    found = [(folder / name, folder)]
    if recursive:
        found = [(path, root) for root in roots for path in _called(os.path.basename(name), root)]
    texts = []
    for path, root in found:
        if not within.there(path, root):
            continue
        try:
            content = files.limited(path, LARGEST_TEXT)
            if len(content) > LARGEST_TEXT:
                raise RosmlError(f"{path} has more than {LARGEST_TEXT >> 20} MiB", "check the file", exit_code=2)
            texts.append(content.decode().replace("\r\n", "\n"))
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "not UTF-8"
            raise RosmlError(f"cannot read {path}: {reason}", "check the file", exit_code=2) from None
    return "".join(text if text.endswith("\n") or not text else f"{text}\n" for text in texts)


def _called(name: str, root: Path) -> list[Path]:
    """All files and folders of a name below a folder, also broken links, without those of git."""
    found = []
    for path, folders, names in os.walk(root):
        folders[:] = [below for below in folders if below != ".git"]
        if name in folders or name in names:
            found.append(Path(path, name))
    return sorted(found)


def lines_of(text: str) -> list[str]:
    """The lines of a list, without comments and empty ones."""
    stripped = ((re.sub(r"(^|\s)#.*", "", line) if "#" in line else line).strip() for line in text.split("\n"))
    return [line for line in stripped if line]
