"""The files of a set of somebody's own, which extends rosml without a fork of it: `rosml init --images`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import combinations

SET, COMMAND, WORKFLOW, NIGHT = "set.yaml", "rosml", ".github/workflows/images.yml", "night.sh"

PROGRAMS = (COMMAND, NIGHT)
"""Those of the files that people call."""

GITHUB = "https://github.com/"


@dataclass(frozen=True)
class Upstream:
    """Where rosml itself is: its address for git, and the whole hash of a commit."""

    repository: str
    commit: str

    @property
    def on_github(self) -> str:
        """Owner and name on GitHub; empty if it is elsewhere."""
        name = self.repository.removeprefix(GITHUB).removesuffix(".git")
        return name if self.repository.startswith(GITHUB) else ""


@dataclass(frozen=True)
class Chosen:
    """What a set has: names on the axes of the matrix, and where its images go. `without_locks` has stacks that it could have if they had
    their locks."""

    distributions: tuple[str, ...]
    components: tuple[str, ...]
    frameworks: tuple[str, ...]
    stacks: tuple[str, ...]
    image: Image
    registry: str
    source: str = ""
    without_locks: tuple[str, ...] = ()


def chosen(
    image_set: ImageSet,
    distributions: Sequence[str],
    frameworks: Sequence[str],
    registry: str,
    source: str,
    accelerator: str = "",
) -> Chosen:
    """A small set out of rosml's own: the components up to that of rosml's default image, for its stack and for the CPU. What is empty is
    as in that image. Raises a RosmlError if rosml does not have it."""
    matrix = image_set.matrix
    default = image_set.image(matrix.default.targets[0])
    distributions = tuple(dict.fromkeys(distributions)) or (default.distribution,)
    frameworks = tuple(dict.fromkeys(frameworks)) or (default.framework,)
    for kind, names, section in (
        ("distribution", distributions, matrix.distributions),
        ("framework", frameworks, matrix.frameworks),
    ):
        for name in names:
            if name not in section:
                raise RosmlError(unknown(kind, name, section), f"there are {listed(list(section))}", exit_code=2)
    plain = combinations.plain(matrix)
    frameworks = tuple(name for name in frameworks if name != plain)
    stacks, without_locks = _stacks(image_set, distributions, frameworks, accelerator)
    chain = combinations.chain(matrix, default.component)
    components = (*chain, *(name for name, facts in matrix.components.items() if facts.runtime_of in chain))
    images = [
        item
        for item in image_set.images
        if item.distribution == distributions[0]
        and item.combination in (frameworks or [plain])
        and item.component in components
        and item.stack in (None, *stacks)
    ]
    if not images:
        text = f"{distributions[0]} has no images with {listed(frameworks, 'or') or 'these'}{f' for {accelerator}' * bool(accelerator)}"
        raise RosmlError(text, f"see why: rosml list {distributions[0]}", exit_code=2)
    image = next((item for item in images if item.component == default.component), images[0])
    return Chosen(distributions, components, (plain, *frameworks), stacks, image, registry, source, without_locks)


def _stacks(
    image_set: ImageSet, distributions: Sequence[str], frameworks: Sequence[str], accelerator: str
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """For each distribution and framework, a stack for GPUs and one for the CPU: of those that have their locks, that of its short tags or
    the first one. If none has, its usual stack. Then the stacks of accelerators for which none has its locks."""
    matrix = image_set.matrix
    locked = {(image.distribution, image.combination, image.stack) for image in image_set.images if image.locked}
    stacks, without_locks = set[str](), set[str]()
    for distribution, framework in product(distributions, frameworks):
        names = [
            name
            for name in dict.fromkeys((*matrix.distributions[distribution].default_stacks, *matrix.stacks))
            if combinations.stack_reason(matrix, distribution, framework, name) is None
            and accelerator in ("", matrix.stacks[name].accelerator)
        ]
        buildable = [name for name in names if (distribution, framework, name) in locked]
        first = {matrix.stacks[name].accelerator: name for name in reversed(buildable)}
        stacks.update(first.values() or names[:1])
        without_locks.update(name for name in names if matrix.stacks[name].accelerator not in first)
    listed_stacks = tuple(name for name in matrix.stacks if name in stacks)
    return listed_stacks, tuple(name for name in matrix.stacks if name in without_locks - stacks)


def unlocked(image_set: ImageSet, choice: Chosen) -> list[Image]:
    """The images of a set that lack a lock. They are there if no other stack of the same accelerator has its locks, or one is chosen for
    another distribution."""
    return [
        image
        for image in image_set.images
        if not image.locked
        and not image.addons
        and image.distribution in choice.distributions
        and image.component in choice.components
        and image.combination in choice.frameworks
        and image.stack in (None, *choice.stacks)
    ]


def files(image_set: ImageSet, choice: Chosen, upstream: Upstream) -> dict[str, str]:
    """The texts of the set's files by their paths. Those on GitHub get the workflow; others a script for cron or CI."""
    native = next(iter(image_set.matrix.architectures))
    nightly = (
        {WORKFLOW: _workflow(choice, upstream)} if upstream.on_github else {NIGHT: _NIGHT.replace("@native@", native)}
    )
    return {
        SET: _set(image_set, choice),
        COMMAND: _command(upstream),
        "README.md": _readme(choice, upstream, native),
        ".gitignore": "/.rosml/\n/night.log\n",
        **nightly,
    }


def _set(image_set: ImageSet, choice: Chosen) -> str:
    matrix = image_set.matrix

    def entries(names: Sequence[str]) -> str:
        return "".join(f"  {name}:\n" for name in names)

    rows = ""
    for name in choice.distributions:
        facts = matrix.distributions[name]
        kept = [item for item in facts.components if item in choice.components] or facts.components[:1]
        rows += f"  {name}: {{components: [{', '.join(kept)}]}}\n"
    plain = next(
        item
        for item in image_set.images
        if (item.distribution, item.component, item.stack) == (choice.image.distribution, choice.image.component, None)
    )
    stacks = f"\nstacks:\n{entries(choice.stacks)}" if choice.stacks else ""
    for name in choice.without_locks:
        stacks += f"  # {name}: # its locks are missing: uncomment this, call ./rosml locks --stack {name}, and commit locks/\n"
    source = f"source: {choice.source}" if choice.source else "# source: https://github.com/me/images"
    return f"""\
# The images of this set: what differs from rosml's matrix.yaml. What this file does not name is as in rosml.
# distributions, frameworks and stacks choose: only those that are named here exist, and nothing after a colon means "as in rosml".
# ./rosml list shows all images of it, ./rosml explain NAME says why there is one, or none.
extends: rosml
registry: {choice.registry} # where rosml plan, publish and status look, unless --registry says otherwise
{source} # the address of this repository, a label of the images
default:
  targets: [{choice.image.target}] # ./rosml image builds it
  group: [{plain.target}]

distributions:
{rows}
frameworks:
{entries(choice.frameworks)}{stacks}"""


_COMMAND = """\
#!/bin/sh
# Calls rosml at the commit below, with the files of this folder over its own: ./rosml list
# The first call fetches rosml into .rosml and installs what it needs there.
set -eu
here=$(dirname "$(readlink -f "$0")")
fail() { printf 'error: %s\nremedy: %s\n' "$1" "$2" >&2; exit 1; }
[ -f "$here/set.yaml" ] || fail "there is no set.yaml in $here" 'write it again: rosml init --images'
command -v git >/dev/null || fail 'git is not there' 'install it'
repository=@repository@
commit=@commit@
case $commit in *[!0-9a-f]*) commit= ;; esac
[ "${#commit}" = 40 ] || fail '@where@ names no commit of rosml' 'write all 40 digits of one'
rosml=$here/.rosml
own="scan.yaml components environments locks tests/structure" # of this folder, if it has them
# shellcheck disable=SC2086 # several names
now="$commit $(cd "$here" && find $own -type f -exec cksum {} + 2>/dev/null | cksum)"
if [ "$now" != "$(cat "$rosml/.state/set" 2>/dev/null)" ]; then
  [ -d "$rosml/.git" ] || git init --quiet "$rosml"
  if [ "$(git -C "$rosml" rev-parse --verify --quiet HEAD)" != "$commit" ]; then
    git -C "$rosml" fetch --quiet --depth 1 "$repository" "$commit" ||
      fail "git cannot fetch commit $commit of $repository" 'check the network; or name a commit that is there'
  fi
  git -C "$rosml" checkout --quiet --force --detach "$commit"
  git -C "$rosml" clean --quiet --force -d
  for name in $own; do
    [ -e "$here/$name" ] || continue
    mkdir -p "$(dirname "$rosml/$name")"
    cp -R "$here/$name" "$(dirname "$rosml/$name")/"
  done
  ln -sfn ../set.yaml "$rosml/set.yaml"
  mkdir -p "$rosml/.state"
  printf '%s\n' "$now" >"$rosml/.state/set"
fi
exec "$rosml/rosml" "$@"
"""


_NIGHT = """\
#!/usr/bin/env bash
# Scans, builds, tests and publishes what is missing or outdated in the set, for cron or CI. By cron, at 02:17; flock lets one run begin
# at a time: 17 2 * * * cd "$HOME/images" && flock --nonblock night.sh bash -c './night.sh >>night.log 2>&1'
set -e
cd "$(dirname "$0")"
./rosml setup
./rosml setup scanner # builds trivy in the first night: 10 minutes
set +e # from here on the night goes on, and ends with the code of the first command that failed
code=0 last=0
trap 'last=$?; test $code -ne 0 || code=$last' ERR
./rosml publish scan --fetch
./rosml publish all --require-scan --serve @native@
./rosml publish rosdep # rosdep's lists from GitHub, for rosml containerize
./rosml status
./rosml publish prune # says what could go; --apply removes it
exit $code
"""


def _command(upstream: Upstream) -> str:
    """The set's own `rosml`. On GitHub, the workflow alone names the commit, so that programs that update actions update it."""
    read = r"""$(sed -n 's|^ *uses: .*/nightly\.yml@\([0-9a-f]*\).*|\1|p' "$here/.github/workflows/images.yml" 2>/dev/null || :)"""
    values = {
        "@repository@": upstream.repository,
        "@commit@": read if upstream.on_github else upstream.commit,
        "@where@": f"the line uses: in {WORKFLOW}" if upstream.on_github else f"the line commit= in {COMMAND}",
    }
    text = _COMMAND
    for name, value in values.items():
        text = text.replace(name, value)
    return text


def _workflow(choice: Chosen, upstream: Upstream) -> str:
    host, _, namespace = choice.registry.partition("/")
    ours = host == "ghcr.io"
    place = f"      namespace: {namespace}\n"
    place = place if ours else f"      registry: {host}\n{place}"
    secrets_note = "" if ours else " # ROSML_USER and ROSML_PASSWORD: who publishes there"
    secrets = "".join(f"      {name}: ${{{{ secrets.{name} }}}}\n" for name in ("ROSML_USER", "ROSML_PASSWORD"))
    return f"""\
# Builds, tests and publishes what is missing or outdated in the set, every night. To move to a newer rosml, take a newer commit.
name: images

on:
  schedule:
    - cron: "17 2 * * *"
  workflow_dispatch:
    inputs:
      only:
        description: Images by target, pattern or group; all if empty
        type: string
        default: ""
      force:
        description: Make everything anew
        type: boolean
        default: false

permissions: {{}}

jobs:
  images:
    name: Images
    uses: {upstream.on_github}/.github/workflows/nightly.yml@{upstream.commit}
    permissions:
      contents: read # this repository
      packages: write # images in ghcr.io
      id-token: write # signatures, if ROSML_SIGN says so
      issues: write # the issue about what is not published
      pages: write # the catalogue, if ROSML_PAGES says so
    with:
      only: ${{{{ inputs.only || '' }}}}
      force: ${{{{ inputs.force || false }}}}
{place}    secrets:{secrets_note}
{secrets}"""


def _readme(choice: Chosen, upstream: Upstream, native: str) -> str:
    nightly = (
        f"Every night, `{WORKFLOW}` builds, tests and publishes what is missing or outdated. Start it by hand at first, with one image:"
        f' Actions, `images`, "Run workflow", with `only` = `{choice.image.target}`.\n'
        if upstream.on_github
        else f"Call `{NIGHT}` every night, by cron or CI. It also scans for known vulnerabilities; the line for cron is in it.\n"
    )
    updated = (
        f"Take a newer commit of rosml in `{WORKFLOW}`; Renovate and Dependabot propose those of releases."
        if upstream.on_github
        else f"Take a newer commit of rosml in `{COMMAND}`."
    )
    return f"""\
# Images with ROS and machine learning

A set of images in `{choice.registry}`, which extends [rosml]({upstream.repository}). `{SET}` says which images there are.

```sh
./rosml list                                # all images of the set
./rosml setup                               # a registry and a builder on this machine
./rosml plan --everywhere --shards 4        # what is to be built, how long it takes, how large the registry gets
./rosml image {choice.image.target}
./rosml publish all --serve {native}        # builds, tests and publishes what is missing, for this architecture alone
```

{nightly}
## Change it

- **Other images**: edit `{SET}`.
- **A newer rosml**, with newer releases, base images and fixes: {updated[0].lower()}{updated[1:]}
- **Which vulnerabilities stop an image**: put a `scan.yaml` here; rosml's own applies until then.
- **A key of your apt archive, a part or an environment of your own**: `components/`, `environments/`, `locks/` and `tests/structure/` go
  over rosml's folders.
"""
