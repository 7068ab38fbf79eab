"""The programs that a `CMakeLists.txt` installs where `rosrun` and `ros2 run` look for them: `lib/PACKAGE`."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence

_COMMENT = re.compile(r"#[^\n]*")
_CALL = re.compile(
    r"\b(project|add_executable|install|catkin_install_python|rclcpp_components_register_node)\s*\(([^()]*)\)",
    re.IGNORECASE,
)
_KEYWORD = re.compile(r"[A-Z_]+")
_NAME = re.compile(r"\w[\w.+-]*")


def installed(text: str) -> list[str]:
    """The programs that it installs, in the order of the text. Names that it computes are left out, but for those of the project."""
    project, built, programs = "", set[str](), list[str]()
    for call in _CALL.finditer(_COMMENT.sub("", text)):
        function = call[1].lower()
        words = [word.strip('"').replace("${PROJECT_NAME}", project) for word in call[2].split()]
        if function == "project":
            project = next(iter(words), "")
        elif function == "add_executable":
            built.update(words[:1])
        elif function == "rclcpp_components_register_node":
            programs += _after("EXECUTABLE", words)
        elif not {f"lib/{project}", "${CATKIN_PACKAGE_BIN_DESTINATION}"}.isdisjoint(_after("DESTINATION", words)):
            programs += _items("PROGRAMS", words)
            programs += [target for target in _items("TARGETS", words) if target in built]
    return list(dict.fromkeys(name for name in programs if _NAME.fullmatch(name)))


def _after(keyword: str, words: Sequence[str]) -> Iterator[str]:
    return (value for word, value in itertools.pairwise(words) if word == keyword)


def _items(keyword: str, words: Sequence[str]) -> Iterator[str]:
    """The names of the files or targets between a keyword, which is the first word, and the next one."""
    if words and words[0] == keyword:
        for word in words[1:]:
            if _KEYWORD.fullmatch(word):
                return
            yield word.rpartition("/")[2]
