"""Completion in shells: commands, options and names."""

from __future__ import annotations

import os

import click
from click.shell_completion import (
    BashComplete,
    CompletionItem,
    FishComplete,
    ShellComplete,
    ZshComplete,
    add_completion_class,
    shell_complete,
    split_arg_string,
)

from rosml import MATRIX, ROOT
from rosml.base.errors import RosmlError

VARIABLE = "_ROSML_COMPLETE"


class Name(click.ParamType[str]):
    name = "name"

    def __init__(self, kind: str) -> None:
        self.kind = kind

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        from rosml.images.image_set import load, selection

        try:
            images = load.load(MATRIX, ROOT)
        except RosmlError:
            return []
        groups = selection.groups_of(images)
        names = {"targets": [*images.by_target], "parts": [*images.part_by_name], "groups": groups}
        return [CompletionItem(name) for name in names[self.kind] if name.startswith(incomplete)]


# ---- Shells ----------------------------------------------------------------------------------------------------------

BASH = """\
%(complete_func)s() {
    local type value
    COMPREPLY=()
    while IFS=, read -r type value; do
        case $type in
            plain) COMPREPLY+=("$value") ;;
            file) compopt -o default ;;
            dir) compopt -o dirnames ;;
        esac
    done < <(env COMP_LINE="${COMP_LINE:0:COMP_POINT}" COMP_WORDBREAKS="$COMP_WORDBREAKS" \
        %(complete_var)s=bash_complete "$1" 2>/dev/null)
}
complete -o nosort -F %(complete_func)s %(prog_name)s
"""
"""The script that bash evaluates. click's own splits words at `:` and `=`, and most images have a colon."""


class _Shell(ShellComplete):
    """Completes commands whose words click does not read all."""

    def get_completions(self, args: list[str], incomplete: str) -> list[CompletionItem[str]]:
        if args and args[0] in OF_WORDS and isinstance(self.cli, click.Group):
            from rosml.cli.run import words_completion  # no other command needs it

            return words_completion.items(self.cli.commands[args[0]], args[1:], incomplete)
        return super().get_completions(args, incomplete)


class Bash(_Shell, BashComplete):
    """Completion in bash. `prefix` is the part of the word that bash keeps before the part that it completes."""

    source_template = BASH
    prefix = ""

    def get_completion_args(self) -> tuple[list[str], str]:
        line = os.environ.get("COMP_LINE")
        if line is None:  # this shell evaluated click's own script
            return super().get_completion_args()
        words = split_arg_string(line)
        incomplete = "" if line[-1:].isspace() else words.pop()
        breaks = [incomplete.rfind(x) for x in ":=" if x in os.environ.get("COMP_WORDBREAKS", "")]
        self.prefix = incomplete[: max(breaks, default=-1) + 1]
        return words[1:], incomplete

    def format_completion(self, item: CompletionItem[str]) -> str:
        return f"{item.type},{item.value.removeprefix(self.prefix)}"


class Zsh(_Shell, ZshComplete):
    """zsh."""


class Fish(_Shell, FishComplete):
    """fish."""


OF_WORDS = ("attach", "run")


def question() -> str:
    """The question of a shell, such as `bash_complete`; empty if there is none."""
    value = os.environ.get(VARIABLE, "")
    return value if value.endswith(("_source", "_complete")) else ""


def first_word() -> str:
    line = os.environ.get("COMP_LINE") or os.environ.get("COMP_WORDS", "")
    return next(iter(line.split()[1:]), "")


def answer(cli: click.Command) -> int | None:
    if not question():
        return None
    for shell in (Bash, Zsh, Fish):
        add_completion_class(shell)
    try:
        return shell_complete(cli, {}, "rosml", VARIABLE, question())
    except (KeyError, ValueError, IndexError):  # a shell that says too little
        return 1
