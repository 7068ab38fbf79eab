"""Reads a `.container` file as podman's generator and then systemd do: podman-systemd.unit(5), systemd.service(5)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

ESCAPES = {"n": "\n", "r": "\r", "t": "\t", "\\": "\\", '"': '"', "'": "'"}

OPTIONS = {
    "AddCapability": "--cap-add",
    "AddDevice": "--device",
    "Annotation": "--annotation",
    "ContainerName": "--name",
    "DropCapability": "--cap-drop",
    "Environment": "--env",
    "EnvironmentFile": "--env-file",
    "HostName": "--hostname",
    "Label": "--label",
    "Network": "--network",
    "PublishPort": "--publish",
    "Pull": "--pull",
    "User": "--user",
    "UserNS": "--userns",
    "Volume": "--volume",
    "WorkingDir": "--workdir",
}
SWITCHES = {
    "NoNewPrivileges": "--security-opt=no-new-privileges",
    "SecurityLabelDisable": "--security-opt=label=disable",
}
QUOTED = ("Annotation", "Environment", "EnvironmentFile", "Exec", "Label", "PodmanArgs")
"""Keys whose values the generator splits into words; it removes quotes and escapes."""


def values(text: str) -> Iterator[tuple[str, str, str]]:
    """The part, the key and the value of each line."""
    part = ""
    for line in text.split("\n"):
        if line.startswith("["):
            part = line
        elif line and not line.startswith("#"):
            key, equals, value = line.partition("=")
            assert equals and key.isalpha() and not value.endswith("\\") and value == value.strip(), line
            yield part, key, value


def argv(text: str) -> list[str]:
    """The command that systemd starts, of the options that the file itself has."""
    options, more, image, command = list[str](), list[str](), "", list[str]()
    group = ""
    for part, key, value in values(text):
        if part != "[Container]":
            continue
        value_words = words(value) if key in QUOTED else [value]
        if key == "Image":
            image = value
        elif key == "Exec":
            command = value_words
        elif key == "PodmanArgs":
            more += value_words
        elif key == "Group":
            group = value
        elif key in SWITCHES:
            assert value == "true"
            options.append(SWITCHES[key])
        else:
            options += [f"{OPTIONS[key]}={word}" for word in value_words]
    options = [f"{word}:{group}" if word.startswith("--user=") and group else word for word in options]
    return started([*options, *more, image, *command])


def words(text: str) -> list[str]:
    """The words of a value. As in the generator, an empty word ends all."""
    split_words = list[str]()
    while text := text.lstrip(" \t"):
        word, quote = "", ""
        while text and (quote or text[0] not in " \t"):
            letter, text = text[0], text[1:]
            if letter == "\\":
                code = re.match("x([0-9a-f]{2})", text)
                word += chr(int(code[1], 16)) if code else ESCAPES[text[0]]
                text = text[3:] if code else text[1:]
            elif quote:
                word, quote = (word, "") if letter == quote else (word + letter, quote)
            elif letter in "'\"":
                quote = letter
            else:
                word += letter
        assert not quote, "quotes do not close"
        if not word:
            return split_words
        split_words.append(word)
    return split_words


def started(words: Sequence[str]) -> list[str]:
    """The words that systemd hands on: it replaces `%x` and `$x`, and takes `;` for the end of a command."""
    handed_on = list[str]()
    for word in words:
        assert word != ";" and "\x80" not in word, word
        rest = word.replace("%%", "").replace("$$", "")
        assert "%" not in rest and "$" not in rest, word
        handed_on.append(word.replace("%%", "%").replace("$$", "$"))
    return handed_on
