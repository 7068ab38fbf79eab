"""What an environment shall have: words of a command line, files, and environment.toml."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from rosml.base.errors import RosmlError
from rosml.cli.images import env
from rosml.images.environments import add, declaration
from rosml.images.environments.add import Sized
from rosml.images.environments.declaration import FILE, Declaration
from rosml.images.join import short_names


def test_files_and_words_become_one_list(tmp_path: Path) -> None:
    listed, project = tmp_path / "requirements.txt", tmp_path / "pyproject.toml"
    listed.write_text("# policies\nlerobot==0.4.4  # the last one\n\ngymnasium\n")
    project.write_text('[project]\nname = "a"\ndependencies = ["numpy>=2; python_version > \'3.9\'", "gymnasium"]\n')
    wish = declaration.changed(None, [str(listed), "jax[cpu]", str(project)], ["evdev"])
    assert wish.requirements == [
        "lerobot==0.4.4",
        "gymnasium",
        "jax[cpu]",
        "numpy>=2; python_version > '3.9'",
    ]
    add.write(tmp_path / "lerobot", [], wish)
    assert declaration.read(tmp_path / "lerobot") == wish


@pytest.mark.parametrize(
    "text",
    ["--index-url https://example.com/simple", "-r other.txt", "-e .", "--extra-index-url=https://u:p@example.com"],
)
def test_options_of_pip_are_refused(text: str, tmp_path: Path) -> None:
    file = tmp_path / "requirements.txt"
    file.write_text(f"numpy\n{text}\n")
    with pytest.raises(RosmlError, match=r"requirements.txt:2 has an option of pip") as caught:
        declaration.changed(None, [str(file)], [])
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(
    "word",
    [
        *("a @ https://example.com/a.whl", "git+https://example.com/a", "./a", "../a.whl", "", "-e"),
        *(
            f"a>=1{end}--no-binary a" for end in ("\n", "\r", "\x0b", "\x0c", "\x85", "\u2028")
        ),  # uv reads an option after \r
    ],
)
def test_no_addresses_and_folders(word: str) -> None:
    with pytest.raises(RosmlError, match="requirements of an environment") as caught:
        declaration.changed(None, [word], [])
    assert caught.value.exit_code == 2


@pytest.mark.parametrize("name", ["gone.txt", "gone.toml", "pipe.txt", "folder.toml"])
def test_files_that_are_none(name: str, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.txt")
    (tmp_path / "folder.toml").mkdir()
    with pytest.raises(RosmlError, match=f"there is no file .*{name}") as caught:
        declaration.changed(None, [str(tmp_path / name)], [])
    assert caught.value.exit_code == 2


def test_a_wrong_line_is_named(tmp_path: Path) -> None:
    (tmp_path / "requirements.txt").write_text(f"numpy\nsix==1 --hash=sha256:{'a' * 64}\n")
    with pytest.raises(RosmlError, match=r"requirements\[1\]: 'six==1 --hash=sha256:a*' is no package of an index"):
        declaration.changed(None, [str(tmp_path / "requirements.txt")], [])


def test_dependencies_that_a_program_decides(tmp_path: Path) -> None:
    project = tmp_path / "pyproject.toml"
    project.write_text('[project]\nname = "a"\ndynamic = ["dependencies"]\n')
    with pytest.raises(RosmlError, match="no list of dependencies"):
        declaration.changed(None, [str(project)], [])


@pytest.mark.parametrize("name", ["", "LeRobot", "../a", "a/b", "a b", "-a", "a--b", "a" * 65, "a\n"])
def test_names(name: str) -> None:
    with pytest.raises(RosmlError, match="no name of an environment"):
        short_names.require(name)


@pytest.mark.parametrize(
    "text",
    [
        "requirements = []",
        'requirements = ["a"]\nbuild = true',
        "requirements = [1]",
        "requirements = [",
        'without = ["a"]',
    ],
)
def test_damaged_declarations(text: str, tmp_path: Path) -> None:
    (tmp_path / FILE).write_text(text)
    with pytest.raises(RosmlError) as caught:
        declaration.read(tmp_path)
    assert caught.value.exit_code == 2 and FILE in caught.value.message


def test_calls_keep_what_they_do_not_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Packages to leave out, and images: one of each Python, for all of which locks are made again."""
    targets = list[str]()

    def resolved(*arguments: Any) -> list[Sized]:
        targets.append(arguments[2])
        return []

    monkeypatch.setattr(add, "resolved", resolved)
    first, other, newer = "ros1-bookworm-core", "ros1-bookworm-base", "ros1-trixie-core"
    place = tmp_path / "policy"

    def call(*words: str) -> Declaration:
        targets.clear()
        env.main.main(["add", "policy", *words, "--folder", str(tmp_path)], standalone_mode=False)
        wish = declaration.read(place)
        assert targets == wish.images
        return wish

    with pytest.raises(RosmlError, match="no image is named"):
        call("lerobot")
    assert call("lerobot", "--without", "evdev", "--image", first).images == [first]
    assert call("--without", "opencv-python", "--image", newer) == Declaration(
        requirements=["lerobot"], without=["evdev", "opencv-python"], images=[first, newer]
    )
    assert call("--image", other).images == [other, newer]
    (place / FILE).write_text(f"# why\n{(place / FILE).read_text()}")
    call()
    assert (place / FILE).read_text().startswith("# why")  # nothing new is in it
    capsys.readouterr()
    assert call("jax") == Declaration(requirements=["jax"], images=[other, newer])
    assert "had other requirements: lerobot" in capsys.readouterr().err
    assert call("--apart").apart and call("--upgrade").apart, "it stays"


def test_a_set_begins_with_what_rosml_has(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its requirements, for the images that are in the set."""
    monkeypatch.setattr(add, "resolved", lambda *_: [])
    (tmp_path / "set.yaml").write_text(
        "extends: rosml\ndistributions: {jazzy: }\nframeworks: {none: , torch: }\nstacks: {cu128: }\n"
        "default: {targets: [jazzy-base], group: [jazzy-base]}\n"
    )
    words = ["lerobot", "--folder", str(tmp_path / "environments"), "--matrix", str(tmp_path / "set.yaml")]
    env.main.main(["add", *words], standalone_mode=False)
    ours = declaration.read(ROOT / "environments/lerobot")
    assert "ros1-bookworm-core-torch-cu128" in ours.images
    wish = declaration.read(tmp_path / "environments/lerobot")
    assert wish == ours.model_copy(update={"images": ["jazzy-base-torch-cu128"]})


def test_without_a_declaration(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=FILE):
        declaration.read(tmp_path)


def test_quotes_stay_quotes(tmp_path: Path) -> None:
    wish = Declaration(requirements=['numpy; platform_machine == "x86_64"'])
    add.write(tmp_path, [], wish)
    assert declaration.read(tmp_path) == wish
