"""The commit of a version, as the repository's server has it now."""

from __future__ import annotations

import re
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize.sources.git import Git


@dataclass(frozen=True)
class Version:
    """A version of a repository.

    Attributes:
        commit: its hash, abbreviated if the version is an abbreviated hash.
        ref: the server's name for it; empty for a hash.
        moving: whether it may mean another commit tomorrow.
        also_branch: whether a tag hides a branch of this name.
    """

    commit: str
    ref: str = ""
    moving: bool = False
    also_branch: bool = False

    @property
    def is_exact(self) -> bool:
        """Whether the hash is whole."""
        return len(self.commit) == 40


_HASH = re.compile(r"[0-9a-fA-F]{7,40}")


def resolve(git: Git, url: str, version: str) -> Version:
    """Asks the server for a version. As with vcstool, a tag counts before a branch.

    Raises:
        Failed: the server does not answer, or has no such repository.
        RosmlError: the repository has no such version (exit code 2).
    """
    if re.fullmatch(r"[0-9a-fA-F]{40}", version):
        return Version(version.lower())
    lines = [line.split("\t", 1) for line in git("ls-remote", "--quiet", "--", url).split("\n") if "\t" in line]
    refs = {name: commit for commit, name in lines}
    wanted = version or "HEAD"
    names = [wanted] if wanted == "HEAD" or wanted.startswith("refs/") else []
    names += [f"refs/tags/{wanted}", f"refs/heads/{wanted}", f"refs/{wanted}"]
    for name in names:
        if name in refs:
            tag = name.startswith("refs/tags/")
            both = name == f"refs/tags/{wanted}" and f"refs/heads/{wanted}" in refs
            return Version(refs.get(f"{name}^{{}}", refs[name]), name, not tag, both)
    if _HASH.fullmatch(version):
        return Version(version.lower())
    if not version:
        raise RosmlError("it has no default branch, or no commit at all", "name a version", exit_code=2)
    known = [match[1] for name in refs if (match := re.fullmatch(r"refs/(?:tags|heads)/(.*[^}])", name))]
    raise RosmlError(f"it has no version {version!r}", near(version, known) or "name a tag, a branch or a commit", 2)
