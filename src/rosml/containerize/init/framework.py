"""Which framework for machine learning brings what manifests and sources name, and which stack of it fits this machine."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.containerize.init import synonyms
from rosml.containerize.init.libraries import CUPY
from rosml.containerize.init.situation import Choice, Note, Question, Situation, settle
from rosml.images.image_set import explain
from rosml.images.matrix import combinations, names
from rosml.images.matrix.model import Matrix
from rosml.run.plugins.gpu import numbers


def choose(situation: Situation, distribution: str, component: str) -> tuple[Choice, list[Note]]:
    matrix, plain, wish = situation.matrix, combinations.plain(situation.matrix), situation.wishes.framework
    available = [name for name in matrix.frameworks if name == plain or stacks(situation, distribution, name)]

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
    proposal = Choice(before.framework, situation.by_repository) if before and follows_env else needed(situation)
    notes: list[Note] = []
    if proposal.value not in available and not wish:
        notes = [(why_not(proposal.value), "take another distribution, or install it in the image")]
        proposal = Choice(plain, f"{distribution} has no {proposal.value}")
    question = Question("Framework for machine learning", read, available)
    return settle(situation.ask, question, wish, proposal), notes


def meant(matrix: Matrix, text: str) -> str:
    """The smallest framework with all that a text of the user names; the text itself if that is none."""
    meanings = synonyms.frameworks(matrix, text)
    if len(meanings) == 1 and meanings[0].lower() in synonyms.NVIDIA:
        return _smallest(matrix, _cuda_parts(matrix))
    if not meanings or not set(meanings) <= matrix.frameworks.keys():
        return " ".join(meanings) or text
    return _smallest(matrix, {part for name in meanings for part in matrix.frameworks[name].parts})


def needed(situation: Situation) -> Choice:
    """The smallest framework that brings what manifests and sources name."""
    matrix, mentions, plain = situation.matrix, situation.scan.mentions, combinations.plain(situation.matrix)
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


# ---- Its stack -------------------------------------------------------------------------------------------------------


def choose_stack(situation: Situation, distribution: str, component: str, framework: str) -> Choice:
    """The stack; none for a framework without parts, which the user may not want on a GPU."""
    matrix, wish = situation.matrix, situation.wishes.stack
    usable = stacks(situation, distribution, framework)

    def read(answer: str) -> str:
        name = synonyms.stack(matrix, answer, usable)
        if name not in matrix.stacks:
            text = unknown("accelerator", name, matrix.stacks)
            raise RosmlError(text, f"take {listed(usable, 'or') or 'none'}; or --gpu or --cpu", exit_code=2)
        if name not in usable:
            text = combinations.stack_reason(matrix, distribution, framework, name) or f"{name} is not what you ask for"
            raise RosmlError(text, f"take {listed(usable, 'or')}", exit_code=2)
        return name

    if not matrix.frameworks[framework].parts:
        if wish and wish not in matrix.stacks:
            read(wish)
        if situation.asks_for_gpu:
            with_gpu = [name for name, facts in matrix.frameworks.items() if facts.parts]
            text = f"framework {framework} computes nothing on a GPU"
            raise RosmlError(text, f"take {listed(with_gpu, 'or')}", exit_code=2)
        return Choice("", "an image without a framework fits every machine")
    before = situation.before(distribution)
    if before and before.framework == framework and before.stack in usable:
        proposal = Choice(before.stack, situation.by_repository)
    else:
        images = {name: names.image_target(distribution, component, framework, name) for name in usable}
        locked = [name for name in usable if situation.image_set.by_target[images[name]].locked]
        proposal = _fitting(situation, locked or usable)
    question = Question("Accelerator", read, usable, lambda name: _computes(situation, name))
    return settle(situation.ask, question, wish, proposal)


def stacks(situation: Situation, distribution: str, framework: str) -> list[str]:
    """The stacks of a framework that the user allows, the default of the distribution first."""
    matrix, gpu = situation.matrix, situation.wishes.gpu
    if not matrix.frameworks[framework].parts:
        return []
    default = matrix.distributions[distribution].default_stacks
    usable = [
        name
        for name in matrix.stacks
        if gpu in (None, situation.is_gpu(name))
        and combinations.stack_reason(matrix, distribution, framework, name) is None
    ]
    return sorted(usable, key=lambda name: default.index(name) if name in default else len(default))


def _fitting(situation: Situation, usable: Sequence[str]) -> Choice:
    nvidia, driver = situation.surroundings.nvidia, situation.surroundings.driver
    gpus = [name for name in usable if situation.is_gpu(name)]
    others = [name for name in usable if not situation.is_gpu(name)]
    runs = [name for name in gpus if not numbers(driver) or numbers(driver) >= numbers(_driver(situation, name))]
    if nvidia and runs:
        machine = f"this machine's driver {driver}" if driver else "this machine's GPU"
        return Choice(runs[0], f"{machine} runs CUDA {situation.matrix.stacks[runs[0]].cuda}")
    if others:
        if situation.wishes.gpu is False:
            return Choice(others[0], "you ask for the CPU")
        why = "this machine's driver runs no other" if nvidia else "this machine has no NVIDIA GPU"
        return Choice(others[0], f"{why}; --gpu for one that has")
    first, *rest = gpus
    needs = {name: _driver(situation, name) for name in gpus}
    older = next((name for name in rest if numbers(needs[name]) < numbers(needs[first])), "")
    hint = f"; for driver {needs[older]}: --accelerator {older}" if older else ""
    return Choice(first, _computes(situation, first) + hint)


def _driver(situation: Situation, stack: str) -> str:
    """The oldest driver that runs a stack; 0 if any does."""
    return situation.matrix.drivers.get((situation.matrix.stacks[stack].cuda or "").partition(".")[0], "0")


def _computes(situation: Situation, stack: str) -> str:
    cuda, driver = situation.matrix.stacks[stack].cuda, _driver(situation, stack)
    return f"CUDA {cuda}" + (f", for driver {driver} or newer" if driver != "0" else "") if cuda else "for the CPU"
