#!/usr/bin/env python3
"""A release: `make release VERSION=0.2.0`, a push, and the workflow `release`, which calls the other two steps.

start VERSION   writes the version and the changelog's date, commits and tags; it pushes nothing
build           from a checkout of the tag: the wheel and the notes, in .state/release
publish         makes GitHub's release of them, and moves the tag of the major version, such as v1, to it
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src"))

import rosml.base.environment  # noqa: F401 (first: says what to do if the others are missing)

# isort: split

from rosml import ROOT
from rosml.base.errors import RosmlError

VERSION_FILE, CHANGELOG = ROOT / "src/rosml/__init__.py", ROOT / "CHANGELOG.md"
OUTPUT = ROOT / ".state/release"

IN_WORK = re.compile(r"^## \S+ \(in work\)$", re.MULTILINE)


def run(*argv: str, environment: dict[str, str] | None = None) -> str:
    env = {**os.environ, **(environment or {})}
    try:
        done = subprocess.run(argv, cwd=ROOT, env=env, capture_output=True, text=True, check=False)
    except OSError as error:
        raise RosmlError(f"{argv[0]}: {error.strerror}", "install it, or put it on PATH") from None
    if done.returncode:
        text = f"{' '.join(argv[:3])}: {done.stderr.strip() or done.stdout.strip()}"
        raise RosmlError(text, "correct that, then call it again")
    return done.stdout.strip()


def numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def start(version: str) -> None:
    if not re.fullmatch(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)", version):
        remedy = "name one of three numbers: make release VERSION=0.2.0"
        raise RosmlError(f"{version or 'nothing'} is no version", remedy, exit_code=2)
    if run("git", "status", "--porcelain"):
        raise RosmlError("the checkout has changes", "commit them, or remove them")
    tags = re.findall(r"^v(\d+\.\d+\.\d+)$", run("git", "tag", "--list"), re.MULTILINE)
    if (newest := max(tags, key=numbers, default="")) and numbers(version) <= numbers(newest):
        raise RosmlError(f"{newest} is released already", "name a newer version", exit_code=2)
    changes = CHANGELOG.read_text(encoding="utf-8")
    if not IN_WORK.search(changes):
        remedy = f"begin it with the heading: ## {version} (in work)"
        raise RosmlError("CHANGELOG.md has no section of what is new", remedy)
    day = datetime.now(UTC).date().isoformat()
    CHANGELOG.write_text(IN_WORK.sub(f"## {version} ({day})", changes, count=1), encoding="utf-8")
    code = VERSION_FILE.read_text(encoding="utf-8")
    code = re.sub(r'^__version__ = ".*"$', f'__version__ = "{version}"', code, flags=re.MULTILINE)
    VERSION_FILE.write_text(code, encoding="utf-8")
    try:
        run("git", "commit", "--all", "--message", f"Release {version}")
    except RosmlError:
        run("git", "checkout", "--", str(CHANGELOG), str(VERSION_FILE))
        raise
    run("git", "tag", "--annotate", f"v{version}", "--message", f"rosml {version}")
    branch = run("git", "rev-parse", "--abbrev-ref", "HEAD")
    print(f"tagged v{version}; the workflow makes the release after:\n  git push --atomic origin {branch} v{version}")


def released() -> str:
    [version] = re.findall(r'^__version__ = "(.*)"$', VERSION_FILE.read_text(encoding="utf-8"), re.MULTILINE)
    if f"v{version}" not in run("git", "tag", "--points-at", "HEAD").split():
        raise RosmlError(f"this commit has no tag v{version}", f"start the release: make release VERSION={version}")
    return str(version)


def notes(version: str) -> str:
    pattern = rf"^## {re.escape(version)} \(.*\)\n(.*?)(?=^## |\Z)"
    section = re.search(pattern, CHANGELOG.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    if not section:
        raise RosmlError(f"CHANGELOG.md says nothing of {version}", "write what is new in it")
    return section[1].strip() + "\n"


def build() -> None:
    """Makes the wheel, whose bytes follow from the commit, and the notes."""
    version = released()
    text = notes(version)
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir(parents=True)
    (OUTPUT / "notes.md").write_text(text, encoding="utf-8")
    pinned = ("--build-constraints", "tools/requirements-build.txt", "--require-hashes")
    when = {"SOURCE_DATE_EPOCH": run("git", "log", "-1", "--format=%ct")}
    run("uv", "build", "--wheel", "--out-dir", str(OUTPUT), *pinned, str(ROOT), environment=when)
    (OUTPUT / ".gitignore").unlink(missing_ok=True)  # uv's
    print("\n".join(str(file.relative_to(ROOT)) for file in sorted(OUTPUT.iterdir())))


def publish() -> None:
    """Makes GitHub's release with what `build` made; a second call completes a first one that was interrupted."""
    version = released()
    files = [str(file) for file in sorted(OUTPUT.glob("*.whl"))]
    if not files:
        raise RosmlError(f"{OUTPUT} has no wheel", "build it: make release-build")
    tag, major = f"v{version}", f"v{version.partition('.')[0]}"
    try:
        run("gh", "release", "view", tag)
        run("gh", "release", "upload", tag, *files, "--clobber")
    except RosmlError:
        options = ["--verify-tag", "--title", f"rosml {version}", "--notes-file", str(OUTPUT / "notes.md")]
        run("gh", "release", "create", tag, *files, *options)
    commit = run("git", "rev-parse", "HEAD")
    reference = f"repos/{{owner}}/{{repo}}/git/refs/tags/{major}"
    try:
        run("gh", "api", reference)
        run("gh", "api", "--method", "PATCH", reference, "--field", f"sha={commit}", "--field", "force=true")
    except RosmlError:
        place = reference.rpartition("/tags/")[0]
        run("gh", "api", "--method", "POST", place, "--field", f"ref=refs/tags/{major}", "--field", f"sha={commit}")
    print(f"released {tag}; {major} points to it")


def main(argv: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", choices=("start", "build", "publish"))
    parser.add_argument("version", nargs="?", default="")
    options = parser.parse_args(argv)
    try:
        if options.step == "start":
            start(options.version)
        elif options.step == "build":
            build()
        else:
            publish()
    except RosmlError as error:
        print(f"error: {error.message}\nremedy: {error.remedy}", file=sys.stderr)
        return error.exit_code
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
