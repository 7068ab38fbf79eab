"""Lock files of apps: they are written, read and followed, and a build takes nothing that they do not have."""

from __future__ import annotations

import base64
import contextlib
import hashlib
import json
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from fakes.documents import DIGEST, LOCK
from fakes.stubs import script_of_a_build
from rosml.base.errors import RosmlError
from rosml.containerize import lock


def test_a_lock_file_is_read_as_it_was_written(tmp_path: Path) -> None:
    file = tmp_path / "containerize.lock"
    assert lock.read(file, tmp_path) is None
    file.write_text(LOCK.text())
    assert lock.read(file, tmp_path) == LOCK
    assert json.loads(LOCK.line()) | {"downstream": {}} == json.loads(LOCK.text()) and "\n" not in LOCK.line()


def other(**changes: Any) -> str:
    return json.dumps(json.loads(LOCK.text()) | changes)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{}", "base_image: Field required"),
        ("<<<<<<< HEAD", "Expecting value"),
        (LOCK.text().replace('"amd64"', '"tree"').replace('"tree": "2.1"', '"tree": "1", "tree": "2"'), "a key is there twice"),
        (other(format=2), "format: "),
        (other(base_image={"name": "ros:jazzy-base", "digest": "jazzy"}), "base_image.digest: "),
        (other(repositories={"up": {"url": "x", "version": "main", "commit": "refs/heads/main"}}), "repositories.up.commit"),
        (other(apt={"../../../escaped": {"tree": "1"}}), "apt."),
        (other(apt={"amd64": {"tree": "1\nPin: origin *"}}), "apt.amd64.tree"),
        (other(pip={"amd64": ["--index-url https://example.org"]}), "pip.amd64.0"),
        (other(pip={"amd64": ["a @ https://example.org/a.whl?private_token=x"]}), "pip.amd64.0: its address has a user or a query, which may be a secret"),
        (other(pip={"amd64": ["a @ git+https://me:x@example.org/a@c0"]}), "which may be a secret"),
        ],
)  # fmt: skip
def test_what_is_no_lock_file_is_refused_with_a_remedy(text: str, why: str, tmp_path: Path) -> None:
    file = tmp_path / "containerize.lock"
    file.write_text(text)
    with pytest.raises(RosmlError, match="is no lock file") as caught:
        lock.read(file, tmp_path)
    assert why in caught.value.message and "\n" not in caught.value.message
    assert caught.value.exit_code == 2 and "--lock" in caught.value.remedy


@pytest.mark.parametrize(
    ("name", "renew", "why"),
    [
        ("typo.lock", False, "there is no file"),
        ("missing/x.lock", True, "there is no folder"),
        ("../x.lock", True, "leads out of"),
        ("/tmp/x.lock", True, "leads out of"),
        ("package.xml", True, "does not end in"),
        ("out/x.lock", True, "leads out of"),
    ],
)
def test_a_place_where_no_lock_file_can_be(name: str, renew: bool, why: str, tmp_path: Path) -> None:
    (tmp_path / "out").symlink_to("/tmp")
    with pytest.raises(RosmlError, match=why) as caught:
        lock.place(tmp_path, name, renew)
    assert caught.value.exit_code == 2


def test_a_place_has_one_name(tmp_path: Path) -> None:
    for name, renew in (("docker/../containerize.lock", True), ("containerize.lock", False)):
        assert lock.place(tmp_path, name, renew) == tmp_path / "containerize.lock"


def test_a_lock_file_of_another_base_image_is_refused() -> None:
    assert LOCK.base_image.of("ros:jazzy-base") == DIGEST
    with pytest.raises(RosmlError, match="the lock file is of ros:jazzy-base, and not of ros:jazzy-core"):
        LOCK.base_image.of("ros:jazzy-core")


def test_other_architectures_stay_while_all_else_is_the_same() -> None:
    new = LOCK.model_copy(update={"apt": {"arm64": {"tree": "2.2"}}, "pip": {}})
    assert set(new.with_other_architectures(LOCK).apt) == {"amd64", "arm64"}
    newer = new.model_copy(update={"base_image": lock.Image(name="ros:jazzy-base", digest=DIGEST.replace("1", "2"))})
    assert set(newer.with_other_architectures(LOCK).apt) == {"arm64"}, "the others were of another image"


def test_each_architecture_gets_its_lists(tmp_path: Path) -> None:
    LOCK.write_requests(tmp_path)
    assert (tmp_path / "lock/amd64/apt").read_text() == "libc6:i386 1:2.36+b1~x\ntree 2.1\n"
    assert (tmp_path / "lock/amd64/pip").read_text().splitlines() == LOCK.pip["amd64"]
    assert LOCK.lacks(["linux/amd64", "linux/arm64", "linux/arm/v7"]) == ["linux/arm64", "linux/arm/v7"]
    assert LOCK.model_copy(update={"apt": {"armhf": {"tree": "2.1"}}}).lacks(["linux/arm/v7"]) == [], "dpkg's name"


def test_the_first_of_two_versions_counts() -> None:
    first = {"architecture": "amd64", "apt": {"a": "1", "b": "1"}, "pip": [f"x==1 --hash={DIGEST}"]}
    second = {"architecture": "amd64", "apt": {"a": "2", "c": "1"}, "pip": [f"x==2 --hash={DIGEST}", "y==1"]}
    packages = lock.added([first, second])
    assert packages.apt == {"amd64": {"a": "1", "b": "1", "c": "1"}}
    assert packages.pip == {"amd64": [f"x==1 --hash={DIGEST}", "y==1"]}


# ---- pip, in the build -----------------------------------------------------------------------------------------------


@pytest.fixture
def script() -> ModuleType:
    return script_of_a_build("containerize/pip_install.py")


SUM = "0a" * 32
HASH = {"hash": f"sha256={SUM}", "hashes": {"sha256": SUM}}
GIT = {"vcs": "git", "commit_id": "c0"}


W, G = "https://e.org/a.whl", "git+https://e.org/a@c0"


@pytest.mark.parametrize(
    ("info", "direct", "line"),
    [
        ({"url": "x.whl", "archive_info": HASH}, False, f"a-b==1.0 --hash=sha256:{SUM}"),
        ({"url": "x.whl", "archive_info": {"hash": f"sha256={SUM}"}}, False, f"a-b==1.0 --hash=sha256:{SUM}"),
        ({}, False, "a-b==1.0"),
        ({"url": "https://e.org/a", "vcs_info": GIT}, True, f"a-b @ {G}"),
        ({"url": W, "archive_info": HASH}, True, f"a-b @ {W}#sha256={SUM}"),
        ({"url": "file:///a", "dir_info": {}}, True, ""),
        # Without a SHA-256 there is none to compare with.
        # A repository has several packages.
        ({"url": "https://e.org/a", "vcs_info": GIT, "subdirectory": "p/a"}, True, f"a-b @ {G}#subdirectory=p/a"),
        ({"url": W, "archive_info": HASH, "subdirectory": "a"}, True, f"a-b @ {W}#sha256={SUM}&subdirectory=a"),
        # Lines are in images and lock files: no password is.
        ({"url": "https://me:secret@e.org/a?private_token=secret", "vcs_info": GIT}, True, f"a-b @ {G}"),
        ({"url": "ssh://git:secret@e.org/a", "vcs_info": GIT}, True, "a-b @ git+ssh://git@e.org/a@c0"),
        ({"url": f"{W}?private_token=secret", "archive_info": {}}, True, f"a-b @ {W}"),
    ],
)
def test_a_package_that_pip_installed_becomes_a_line(
    info: dict[str, Any], direct: bool, line: str, script: ModuleType
) -> None:
    assert script.line("A.b", "1.0", info, direct) == line


def test_a_damaged_package_of_the_base_image_counts_for_none(
    script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A folder without METADATA, as a removed package may leave, and one that says no JSON of its place."""
    for name, files in {
        "a-1.dist-info": {"METADATA": "Name: a\nVersion: 1\n"},
        "b-1.dist-info": {},
        "c-1.dist-info": {"METADATA": "Name: c\nVersion: 1\n", "direct_url.json": "[" * 100_000},
    }.items():
        (tmp_path / name).mkdir()
        for file, text in files.items():
            (tmp_path / name / file).write_text(text)
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    assert script.installed() == {"a==1"}


def test_no_package_says_a_password(script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """pip leaves the query of an address in the image. Only packages that were installed now are changed."""
    before: dict[str, str] = {}
    for name in ("new", "present"):
        folder = tmp_path / f"{name}-1.dist-info"
        folder.mkdir()
        source = {
            "url": f"https://e.org/{name}?private_token=secret",
            "vcs_info": {**GIT, "requested_revision": "main"},
        }
        before[name] = json.dumps(source)
        (folder / "METADATA").write_text(f"Name: {name}\nVersion: 1\n")
        (folder / "direct_url.json").write_text(before[name])
        files = "".join(f"{folder.name}/{file},sha256=x,1\n" for file in ("METADATA", "direct_url.json"))
        (folder / "RECORD").write_text(f"{files}{folder.name}/RECORD,,\n")
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    install(script, tmp_path, ["new @ git+https://e.org/new@c0"], None)
    content = (tmp_path / "new-1.dist-info/direct_url.json").read_bytes()
    assert json.loads(content)["url"] == "https://e.org/new"
    assert (tmp_path / "present-1.dist-info/direct_url.json").read_text() == before["present"]
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
    assert (tmp_path / "new-1.dist-info/RECORD").read_text() == (
        "new-1.dist-info/METADATA,sha256=x,1\n"
        f"new-1.dist-info/direct_url.json,sha256={digest},{len(content)}\n"
        "new-1.dist-info/RECORD,,\n"
    )


def install(script: ModuleType, folder: Path, lines: list[str], locked: str | None) -> str:
    """Installs packages, as pip would report them. Returns pip's constraints."""
    constraints: list[str] = []

    def reported(arguments: list[str]) -> list[str]:
        if "--constraint" in arguments:
            constraints.append(Path(arguments[arguments.index("--constraint") + 1]).read_text())
        return lines

    script.knows_report = lambda: True  # type: ignore[attr-defined]
    script.reported = reported  # type: ignore[attr-defined]
    if locked is not None:
        (folder / "locked").write_text(locked)
    script.main(folder / "written", folder / "locked", "--requirement", "file")
    return "".join(constraints)


def test_pip_installs_what_the_lock_file_has_or_nothing(script: ModuleType, tmp_path: Path) -> None:
    assert install(script, tmp_path, ["b==1 --hash=sha256:bb", ""], None) == ""
    assert install(script, tmp_path, ["a==1"], None) == ""
    assert (tmp_path / "written").read_text() == "a==1\nb==1 --hash=sha256:bb\n"
    git = "g @ git+https://example.org/g@c0"
    locked = f"a==1.0 --hash=sha256:aa\n{git}\nunused==1\n"
    assert install(script, tmp_path, ["a==1.0 --hash=sha256:aa", git, ""], locked) == "a==1.0\nunused==1\n"
    for line in ("a==1.0 --hash=sha256:bb", "a==1.0", "b==1.0", "g @ git+https://example.org/g@c1"):
        with pytest.raises(SystemExit, match=r"the lock file does not have what pip installed: .*--lock"):
            install(script, tmp_path, [line], locked)
    with pytest.raises(SystemExit, match="the lock file does not have what pip installed: a==1"):
        install(script, tmp_path, ["a==1"], "")


def test_the_archives_of_the_lock_file_come_by_their_hashes(script: ModuleType, tmp_path: Path) -> None:
    """Before pip decides anything: an index may have another file of the same version by now. They come from where the requests say."""
    (tmp_path / "more").mkdir()
    (tmp_path / "pip").write_text("--index-url https://index.test/simple\n-r more/pip # others\na\n")
    (tmp_path / "more/pip").write_text('-f "https://wheels.test/a b"\n--no-index\n-e .\nb\n')
    (tmp_path / "lock").write_text(
        "a==1 --hash=sha256:aa\nb @ https://x.test/b.zip#sha256=bb\ng @ git+https://x.test/g@c0\n"
    )
    calls: list[tuple[list[str], str]] = []

    def installed(arguments: list[str]) -> list[str]:
        calls.append((arguments, Path(arguments[-1]).read_text()))
        return ["a==1 --hash=sha256:aa"] if "--require-hashes" in arguments else ["g @ git+https://x.test/g@c0"]

    script.knows_report = lambda: True  # type: ignore[attr-defined]
    script.reported = installed  # type: ignore[attr-defined]
    script.forget_secrets = lambda names: None  # type: ignore[attr-defined]
    script.main(tmp_path / "written", tmp_path / "lock", "--requirement", str(tmp_path / "pip"), "pytest")
    (hashed, locked), (usual, _) = calls
    where = ["--index-url", "https://index.test/simple", "-f", "https://wheels.test/a b", "--no-index"]
    assert hashed[:-1] == [*where, "--no-deps", "--require-hashes", "--requirement"]
    assert locked == "a==1 --hash=sha256:aa\nb @ https://x.test/b.zip#sha256=bb\n"
    assert usual[:3] == ["--requirement", str(tmp_path / "pip"), "pytest"] and usual[3] == "--constraint"
    assert (tmp_path / "written").read_text() == "a==1 --hash=sha256:aa\ng @ git+https://x.test/g@c0\n"


@pytest.mark.parametrize("kind", ["path", "uri"])
def test_another_archive_of_the_version_in_a_folder_is_not_seen(script: ModuleType, tmp_path: Path, kind: str) -> None:
    """pip takes the best archive of a folder by its name, and only then compares hashes."""
    (tmp_path / "wheels").mkdir()
    others = {"a-1-2-py3-none-any.whl": b"new", "a-1.tar.gz": b"sources", "builds_it-2.tar.gz": b"needed to build it"}
    for name, content in {"a-1-py3-none-any.whl": b"locked", **others}.items():
        (tmp_path / "wheels" / name).write_bytes(content)
    uri = (tmp_path / "wheels").as_uri()
    (tmp_path / "pip").write_text(f"--find-links {uri if kind == 'uri' else 'wheels'}\na\n")
    line = f"a==1 --hash=sha256:{hashlib.sha256(b'locked').hexdigest()}"
    names: list[list[str]] = []

    def installed(arguments: list[str]) -> list[str]:
        names.append(sorted(path.name for path in Path(arguments[1]).iterdir()))
        return [line]

    assert script.take_locked([line], ["-r", str(tmp_path / "pip")], installed) == [line]
    assert names == [["a-1-py3-none-any.whl", "builds_it-2.tar.gz"]], "else an index would be asked for what builds it"


@pytest.mark.parametrize(
    ("requirement", "missing"),
    [
        ("a[x] >= 1  # why", ""),
        ("PyTest", ""),
        ("here/a-1.tar.gz", ""),
        ("b", "b"),
        ("-r more", "b~=1"),
        ("there/a-1.tar.gz", "there/a-1.tar.gz"),
        ("git+https://x.test/b", ""),
        ("b<2; python_version < '3'", ""),
    ],
)
def test_a_package_that_a_lock_file_lacks_is_named_before_pip_runs_anything(
    script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, requirement: str, missing: str
) -> None:
    """Sources run code when pip looks at them. What is installed already is in no lock file."""
    monkeypatch.chdir(tmp_path)
    for folder in ("here", "there"):
        Path(folder).mkdir()
        Path(folder, "a-1.tar.gz").write_text(folder)
    Path("more").write_text("b~=1\n")
    Path("requirements").write_text(f"{requirement}\n")
    line = f"a @ file:///x/a-1.tar.gz#sha256={hashlib.sha256(b'here').hexdigest()}"
    with pytest.raises(SystemExit, match=re.escape(missing)) if missing else contextlib.nullcontext():
        script.require_locked([line], ["--requirement", "requirements"])
