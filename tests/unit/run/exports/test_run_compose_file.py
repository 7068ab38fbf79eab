"""`rosml run --export compose --add FILE`: the service is added, and the rest stays byte for byte."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from fakes.exports import call
from rosml.base.errors import RosmlError
from rosml.run.exports import compose_file

SERVICE = {"services": {"robot": {"image": "x", "command": ["a", "$$b"]}}}
WHOLE: dict[str, Any] = {
    **SERVICE,
    "networks": {"lan": {"name": "lan", "external": True}},
    "volumes": {"data": {"name": "data"}},
}


def added(text: str, content: dict[str, Any] = SERVICE) -> str:
    """The text with the content. Nothing of the text is gone, and a second call adds nothing."""
    after = compose_file.added(text, content, "compose.yaml")
    lines = difflib.ndiff(text.splitlines(keepends=True), after.splitlines(keepends=True))
    kept = "".join(line[2:] for line in lines if line[:2] in ("  ", "- "))
    assert kept == text and len(after.encode()) >= len(text.encode())
    assert compose_file.added(after, content, "compose.yaml") == after
    return after


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "services:\n  robot:\n    image: x\n    command:\n    - a\n    - \"$$b\"\n"),
        ("services:\n  a:\n    image: y  # why\n", "services:\n  a:\n    image: y  # why\n  robot:\n    image: x\n"),
        ("services:\n    a:\n        image: y\n", "image: y\n    robot:\n      image: x\n"),
        ("services:\n  a:\n    image: y\n    # ports: no\n\n# next\nvolumes:\n", "# ports: no\n  robot:\n"),
        ("services:\n", "services:\n  robot:\n    image: x\n"),
        ("name: x\n", "name: x\nservices:\n  robot:\n"),
        ("services:\r\n  a:\r\n    image: y\r\n", "image: y\r\n  robot:\r\n    image: x\r\n"),
        ("services:\n  a:\n    command: |\n      one\n\n      two\nname: x\n", "two\n  robot:\n"),
        ("x: &a {image: y}\nservices:\n  a: *a\n  b:\n    <<: *a\n    ports: !override [1]\n", "!override [1]\n  robot:\n"),
        ("services:\n  a:\n    image: y", "services:\n  a:\n    image: y\n  robot:\n"),
    ],
)  # fmt: skip
def test_what_is_there_stays(text: str, expected: str) -> None:
    if text.endswith("y"):  # only the end of the last line is added to it
        assert compose_file.added(text, SERVICE, "compose.yaml").startswith(f"{text}\n  robot:")
        return
    assert expected in added(text)


def test_networks_and_volumes() -> None:
    text = "services:\n  a:\n    image: y\n\nvolumes:\n  b:\n"
    document = yaml.safe_load(added(text, WHOLE))
    assert document == {
        "services": {"a": {"image": "y"}, **WHOLE["services"]},
        "volumes": {"b": None, "data": {"name": "data"}},
        "networks": WHOLE["networks"],
    }
    assert list(yaml.safe_load(added("services:\n", WHOLE))) == ["services", "networks", "volumes"]
    same = "services:\n  robot: {command: [a, '$$b'], image: x}\n"
    assert compose_file.added(same, SERVICE, "compose.yaml") == same


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("services:\n  robot:\n    image: y\n", "has a service robot already, with other content"),
        ("services:\n  robot: *a\n", "is no YAML: line 2"),
        ("volumes:\n  data:\n", "has a volume data already, with other content"),
        ("services: &a\n  b:\n    image: y\nx: *a\n", "services has the anchor a"),
        ("services:\n  a:\n    command: |\n      x", "the addition would change what is there"),
        ("services: {}\n", "services has no line for each key"),
        ("{services: {a: {image: y}}}\n", "no file of compose"),
        ("- a\n", "no file of compose"),
        ("a: 1\n---\nb: 2\n", "another document"),
        ("services:\n  a:\n    image: y\n...\n", "no file of compose"),
        ("a: \x07\n", "a character that YAML does not allow"),
        ("a: " + "[" * 300 + "]" * 300 + "\n", "nested more than"),
    ],
)
def test_what_is_refused(text: str, says: str) -> None:
    with pytest.raises(RosmlError) as caught:
        compose_file.added(text, WHOLE, "compose.yaml")
    assert says in caught.value.message and caught.value.remedy and caught.value.exit_code == 2


PLAIN = st.text("ab #:-|>'\"\n", max_size=12)


@settings(max_examples=100, deadline=None)
@given(
    st.dictionaries(st.sampled_from(["a", "b c", "robots"]), PLAIN | st.lists(PLAIN, max_size=2), max_size=3),
    st.integers(2, 6),
    st.booleans(),
)
def test_any_file_is_kept_or_refused(services: dict[str, Any], indent: int, block: bool) -> None:
    style = "|" if block else None
    more = {key: [*value] if isinstance(value, list) else value for key, value in services.items()}
    text = yaml.dump(
        {"name": "x", "services": services, "x-more": more}, indent=indent, sort_keys=False, default_style=style
    )
    try:
        text_after = compose_file.added(text, WHOLE, "compose.yaml")
    except RosmlError as error:
        assert error.remedy
        return
    before, after = yaml.safe_load(text), yaml.safe_load(text_after)
    assert after == before | WHOLE | {"services": before["services"] | WHOLE["services"]}


def test_the_file_keeps_its_mode_and_paths_begin_at_its_folder(tmp_path: Path) -> None:
    file = tmp_path / "compose.yaml"
    file.write_text("services:\n  a:\n    image: y\n")
    file.chmod(0o600)
    mounted = ["--name", "camera", "-v", f"{tmp_path}/bags:/bags", "--env-file", "e", "x", "ls"]
    message = compose_file.add(file, call(*mounted, place=str(tmp_path)))
    services = yaml.safe_load(file.read_text())["services"]
    assert message == f"{file}: added the service camera" and file.stat().st_mode & 0o777 == 0o600
    assert services["camera"]["volumes"] == ["./bags:/bags"]
    assert services["camera"]["env_file"][0]["path"] == "/home/jo/robot/e"
    assert [path.name for path in tmp_path.iterdir()] == ["compose.yaml"]
    assert compose_file.add(file, call(*mounted, place=str(tmp_path))) == f"{file}: has the service camera already"


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda file: None, "there is no such file"),
        (lambda file: file.mkdir(), "it is no file"),
        (lambda file: file.symlink_to(file.with_name("other")), "it is a link"),
        (lambda file: file.write_bytes(b"\xff"), "no text in UTF-8"),
    ],
)
def test_a_file_that_cannot_be_read(tmp_path: Path, make: Any, says: str) -> None:
    (tmp_path / "other").write_text("services:\n")
    make(tmp_path / "compose.yaml")
    with pytest.raises(RosmlError, match=says) as caught:
        compose_file.add(tmp_path / "compose.yaml", call("x"))
    assert caught.value.remedy and (tmp_path / "other").read_text() == "services:\n"
