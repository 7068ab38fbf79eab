"""Which framework for machine learning brings what manifests and sources name."""

from __future__ import annotations

from collections.abc import Collection

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.containerize.init import accelerator, synonyms
from rosml.containerize.init.libraries import CUPY
from rosml.containerize.init.situation import BY_ENV, Choice, Note, Question, Situation
from rosml.images.image_set import explain
from rosml.images.matrix import rules
from rosml.images.matrix.model import Matrix


def choose(situation: Situation, distribution: str, component: str) -> tuple[Choice, list[Note]]:
    matrix, plain, wish = situation.matrix, rules.plain(situation.matrix), situation.wishes.framework
    available = [
        name for name in matrix.frameworks if name == plain or accelerator.stacks(situation, distribution, name)
    ]

    def read(answer: str) -> str:
        name = meant(matrix, answer)
        if name in available:
            return name
        text = why_not(name) if name in matrix.frameworks else unknown("framework", name, matrix.frameworks)
        raise RosmlError(text, f"{distribution} has {listed(available)}", exit_code=2)

    def why_not(name: str) -> str:
        gpu = situation.wishes.gpu
        reason = explain.why_not(situation.image_set, f"{distribution}-{component}-{name}") if gpu is None else None
        kind = {None: "", True: " for GPUs", False: " for the CPU"}[gpu]
        return (reason or f"{distribution} has no {name}{kind}").rstrip(".")

    before = situation.before(distribution)
    follows_env = before and (before.stack or not situation.asks_for_gpu)
    proposal = Choice(before.framework, BY_ENV) if before and follows_env else needed(situation)
    notes: list[Note] = []
    if proposal.value not in available and not wish:
        notes = [(why_not(proposal.value), "take another distribution, or install it in the image")]
        proposal = Choice(plain, f"{distribution} has no {proposal.value}")
    question = Question("Framework for machine learning", read, available)
    return situation.settle(question, wish, proposal), notes


def meant(matrix: Matrix, text: str) -> str:
    """The smallest framework with all that a text of the user names; the text itself if that is none."""
    names = synonyms.frameworks(matrix, text)
    if len(names) == 1 and names[0].lower() in synonyms.NVIDIA:
        return _smallest(matrix, _cuda_parts(matrix))
    if not names or not set(names) <= matrix.frameworks.keys():
        return " ".join(names) or text
    return _smallest(matrix, {part for name in names for part in matrix.frameworks[name].parts})


def needed(situation: Situation) -> Choice:
    """The smallest framework that brings what manifests and sources name."""
    matrix, mentions, plain = situation.matrix, situation.scan.mentions, rules.plain(situation.matrix)
    in_frameworks = {name for facts in matrix.frameworks.values() for name in facts.parts}
    titles = {part.name: part.title for part in matrix.parts if part.title and part.release}
    mentioned = {name: mentions[title] for name, title in titles.items() if title in mentions}
    parts = {name: mention for name, mention in mentioned.items() if name in in_frameworks}
    others = [mention for name, mention in mentioned.items() if name not in in_frameworks]
    on_gpu = mentions.get(CUPY) or next((item for item in others if item.word.lower().endswith("gpu")), None)
    if on_gpu and not parts:
        parts = dict.fromkeys(_cuda_parts(matrix), on_gpu)
    if parts:
        places = listed([f"{mention.place} names {mention.word}" for mention in parts.values()])
        return Choice(_smallest(matrix, parts) or plain, places)
    if situation.asks_for_gpu:
        name = _smallest(matrix, _cuda_parts(matrix)) or plain
        return Choice(name, "you ask for a GPU, and no file names a framework")
    missing = listed([title for name, title in titles.items() if name in in_frameworks], "or")
    return Choice(plain, f"no package.xml and no source names {missing}")


def _cuda_parts(matrix: Matrix) -> list[str]:
    return [part.name for part in matrix.parts if part.versions]


def _smallest(matrix: Matrix, parts: Collection[str]) -> str:
    """The framework with these parts and the fewest others; empty if none has them."""
    fitting = [name for name, facts in matrix.frameworks.items() if {*parts} <= {*facts.parts}]
    return min(fitting, key=lambda name: len(matrix.frameworks[name].parts), default="")
