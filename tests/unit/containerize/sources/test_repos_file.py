""".repos files: what they may name, and what is refused."""

from __future__ import annotations

import json

import pytest

from fakes.repositories import Place, commit, git, place, repos
from rosml.containerize.sources import repos_file

__all__ = ["place"]


def test_one_file_alone(place: Place) -> None:
    commit(place.root / "a", {"x.repos": repos(absent=("/absent", ""))})
    place.put(repos(absent=("/absent", "")), "other.repos")
    assert place.fetch(recursive=False) == [] and not [*place.out.iterdir()]
    place.put(repos(a=(place.root / "a", "main")))
    assert [item.path for item in place.fetch(recursive=False)] == ["a"]
    (place.root / "outside.repos").write_text("repositories: {}")
    (place.target / "link.repos").symlink_to("../outside.repos")
    for name in ("nowhere.repos", "../outside.repos", "link.repos"):
        assert f"{name}: no file below" in place.refused(recursive=False, file=name).message


def test_a_file_that_is_left_out(place: Place) -> None:
    place.a()
    place.put(repos(absent=("/absent", "")), "uses.repos")
    assert [item.path for item in place.fetch(without="uses.repos")] == ["a"]


def test_two_files_that_contradict_each_other(place: Place) -> None:
    a, _ = place.a()
    place.put(repos(a=(f"{a}/", "main")), "2.repos")
    assert len(place.fetch()) == 1
    place.put(repos(a=(a, "v2")), "2.repos")
    error = place.refused()
    assert f".repos:1: main of {a}" in error.message and f"2.repos:1: v2 of {a}" in error.message
    assert "--vcs-import-file .repos" in error.remedy and len(place.fetch(recursive=False)) == 1
    for first, second in (("a", "a/b"), ("a/b", "a")):
        place.put(repos(**{first: (a, "main")}))
        place.put(repos(**{second: (a, "main")}), "2.repos")
        assert "a/b lies within a, which " in place.refused().message


def test_the_format_of_rosinstall_is_read_as_vcstool_does(place: Place) -> None:
    url, _ = place.a()
    place.put(f"- git: {{local-name: lib/a, uri: {url}, version: main}}\n- git: {{local-name: b, uri: {url}}}\n")
    assert [(each.path, each.version) for each in place.fetch()] == [("b", ""), ("lib/a", "main")]


H = "type: git, url: 'https://h/x'"


@pytest.mark.parametrize(
    ("entry", "problem"),
    [
        (f"../x: {{{H}}}", "leads out of the folder"),
        (f"/x: {{{H}}}", "leads out of the folder"),
        (f"a/.git/x: {{{H}}}", "a name that git uses itself"),
        (f".: {{{H}}}", "'.' is the folder for sources itself"),
        ("x: {type: git, url: '--upload-pack=touch x'}", "the url is not valid"),
        ("x: {type: git, url: 'ext::sh -c x'}", "starts a program"),
        ("x: {type: git, url: 'fd://3/x'}", "not allowed"),
        ("x: {type: git, url: 'ssh://-oProxyCommand=x/y'}", "no host"),
        ("x: {type: git, url: 'git@-oProxyCommand=x:y'}", "the url is not valid"),
        ("x: {type: git, url: 'a/b'}", "the url is not valid"),
        ("x: {type: git, url: 'https://u:s3cret-canary@h/x'}", "holds a password"),
        (f"x: {{{H}, version: --x}}", "is no version"),
        ("x: {type: hg, url: 'https://h/x'}", "the type is hg; only git works"),
        ("x: {url: 'https://h/x'}", "x: no type; add 'type: git'"),
        ("x: {type: git}", "no url"),
        ("<<: [x], x: {type: git, url: /a}", "merges is no mapping"),
        ("x: {type: git, url: /a}, x: {type: git, url: /b}", "x is there twice"),
        (f"x: {{{H}, verison: '1'}}", "did you mean 'version'?"),
        (f"x: {{{H}, depth: 1}}", "unknown key 'depth'; known: type, url, version"),
    ],
)
def test_an_entry_that_is_refused(place: Place, entry: str, problem: str) -> None:
    refuses(place, f"repositories: {{{entry}}}", problem)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("- git: {local-name: x}", "git: no uri; write it as '- git:"),
        ("- git: {local-name: x, uri: /a, url: /b}", "unknown key 'url'; did you mean 'uri'?"),
        ("- git: {local-name: x, uri: /a}\n  hg: {}", "no repository of the format of rosinstall"),
        ("- git: {local-name: x, uri: 'https://h/x'}\n- git: {local-name: x, uri: 'https://h/y'}", "x is there twice"),
        ("repos: {}", "no key 'repositories'"),
        ("repositories: [", "not YAML"),
        ("extends: 2.repos", "it extends 2.repos, and there is no such file beside it"),
        ("extends: [y/a.repos, y/a.repos]", "extends has y/a.repos twice"),
        ("extends: x.repos", "it extends x.repos, which extends it"),
        ("extends: ../outside.repos", "leads out of"),
        ("extends: .env", "gets into no image"),
        ("extends: y", "a folder instead of a file"),
        ("extends: {a: b}", "extends is no file"),
    ],
)
def test_a_file_that_is_refused(place: Place, text: str, problem: str) -> None:
    place.put("repositories: {}", "y/a.repos")
    place.put("A=1", ".env")
    (place.root / "outside.repos").write_text("repositories: {}")
    refuses(place, text, problem)


def refuses(place: Place, text: str, problem: str) -> None:
    place.put(f"\n{text}", "x.repos")
    error = place.refused()
    assert error.message.startswith(("x.repos:2: ", "x.repos:3: ")) and error.exit_code == 2
    assert problem in f"{error.message}; {error.remedy}"


def test_a_file_may_extend_others(place: Place) -> None:
    """As in vcs2l: the later one counts, and the file itself counts before them. Those that it extends do not count alone."""
    for name in ("a", "b", "c", "d"):
        commit(place.root / name, {"f": name})
        git(place.root / name, "tag", "v1")
    place.put(repos(**{name: (place.root / name, "main") for name in ("a", "b", "c")}), "deps/base.repos")
    place.put(repos(b=(place.root / "b", "v1"), d=(place.root / "d", "main")), "deps/more.yaml")
    repositories = json.loads(repos(a=(place.root / "a", "v1")))["repositories"]
    place.put(f"extends: [deps/base.repos, deps/more.yaml]\nrepositories: {json.dumps(repositories)}", "my.repos")
    assert {each.path: (each.version, each.named_in) for each in place.fetch()} == {
        "a": ("v1", "my.repos"),
        "b": ("v1", "deps/more.yaml"),
        "c": ("main", "deps/base.repos"),
        "d": ("main", "deps/more.yaml"),
    }
    place.put("extends: my.repos\n", "other.repos")
    assert len(place.fetch(recursive=False, file="other.repos")) == 4
    place.put("extends: ../other.repos\n", "deps/more.yaml")
    assert "which extends it" in place.refused(recursive=False, file="other.repos").message
    for number in range(repos_file.EXTENDS + 2):
        place.put(f"extends: {number + 1}.yaml\n", f"{number}.yaml")
    assert "more than 10 files extend each other" in place.refused(recursive=False, file="0.yaml").message


def test_a_mapping_has_what_it_merges(place: Place) -> None:
    a, _ = place.a()
    git(a, "tag", "v1")
    place.put(
        f"""defaults: &defaults {{type: git, url: '{a}', version: main}}
repositories:
  one: {{<<: *defaults}}
  two: {{version: v1, <<: [{{version: v2}}, *defaults]}}
"""
    )
    assert {repository.path: repository.version for repository in place.fetch()} == {"one": "main", "two": "v1"}


def test_links_in_a_repository_lead_nowhere(place: Place) -> None:
    a, _ = place.a()
    (place.root / "outside.repos").write_text("repositories: {}")
    (a / "x.repos").symlink_to(place.root / "outside.repos")
    commit(a)
    assert "a link that leads out" in place.refused().message


@pytest.mark.parametrize("before", ["", "file://"])
def test_a_folder_names_no_repository_of_this_machine_unless_a_person_lets_it(before: str, place: Place) -> None:
    """It may be a stranger's, and what it names gets into images and into steps of the build."""
    url, _ = place.a()
    place.put(repos(a=(f"{before}{url}", "main")))
    refused = place.refused(local=False)
    assert "the url names a repository of this machine" in refused.message and "--allow-file-urls" in refused.remedy
    assert not [*place.out.iterdir()] and [item.path for item in place.fetch()] == ["a"]
