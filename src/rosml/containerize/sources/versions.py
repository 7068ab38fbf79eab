"""The commit of a version, as the repository's server has it now."""

from __future__ import annotations

import re
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize.sources.git import Git


@dataclass(frozen=True)
class Version:
    commit: str  # its hash, abbreviated if the version is an abbreviated hash
    ref: str = ""  # the server's name for it; empty for a hash
    moving: bool = False  # it may mean another commit tomorrow
    also_branch: bool = False  # a tag hides a branch of this name

    @property
    def is_exact(self) -> bool:
        return len(self.commit) == 40


_HASH = re.compile(r"[0-9a-fA-F]{7,40}")


def resolve(git: Git, url: str, version: str) -> Version:
    """Asks the server for a version. As with vcstool, a tag counts before a branch."""
    if re.fullmatch(r"[0-9a-fA-F]{40}", version):
        return Version(version.lower())
    lines = [line.split("\t", 1) for line in git("ls-remote", "--quiet", "--", url).split("\n") if "\t" in line]
    refs = {name: commit for commit, name in lines}
    name = version or "HEAD"
    tag, branch = f"refs/tags/{name}", f"refs/heads/{name}"
    likely = [name] if name == "HEAD" or name.startswith("refs/") else []
    for ref in (*likely, tag, branch, f"refs/{name}"):
        if ref in refs:
            commit = refs.get(f"{ref}^{{}}", refs[ref])  # the commit of an annotated tag
            return Version(commit, ref, not ref.startswith("refs/tags/"), ref == tag and branch in refs)
    if _HASH.fullmatch(version):
        return Version(version.lower())
    if not version:
        raise RosmlError("it has no default branch, or no commit at all", "name a version", exit_code=2)
    names = [match[1] for ref in refs if (match := re.fullmatch(r"refs/(?:tags|heads)/(.*[^}])", ref))]
    raise RosmlError(f"it has no version {version!r}", near(version, names) or "name a tag, a branch or a commit", 2)
