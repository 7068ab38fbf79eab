"""Which package of an app needs a component that the app brings, by the dependencies in the app's SBOM."""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice

from rosml.containerize.affected.inventory import MOST
from rosml.images.dossier.bill import Bill, text
from rosml.images.scan.cyclonedx import APP, PART

ROS = "pkg:generic/ros/"

EDGES = 100_000
"""The most dependencies that are read: an image with all frameworks has a third of them."""

STEPS = 500_000
"""The most steps from one package to another, for all components of an app together. After them, who needs a component itself is its cause."""

COMPONENTS, CAUSES = 100, 20
"""The most components that causes are looked up for, and the most causes of each."""


@dataclass(frozen=True)
class Cause:
    """A ROS package of the app, or another one that nothing in the app needs. `through`: the package that needs the component itself."""

    package: str
    through: str = ""


class Causes:
    """The causes within an app, by the package URLs of components."""

    def __init__(self, bill: Bill) -> None:
        self._steps = STEPS
        self._titles, self._ros = dict[str, str](), set[str]()
        self._refs, self._users = defaultdict[str, list[str]](list), defaultdict[str, list[str]](list)
        for it in bill.components[:MOST]:
            if it.ref and it.properties.get(PART, APP) == APP:
                self._titles[it.ref] = it.title
                purl = text(it.content, "purl")
                self._refs[purl].append(it.ref)
                if purl.startswith(ROS):
                    self._ros.add(it.ref)
        pairs = ((user, ref) for user, refs in bill.needs.items() for ref in refs)
        for user, ref in islice(pairs, EDGES):
            if user in self._titles and user != ref:
                self._users[ref].append(user)

    def of_all(self, purls: Iterable[str]) -> dict[str, tuple[Cause, ...]]:
        return {purl: self._of(self._refs[purl]) for purl in islice(purls, COMPONENTS) if purl in self._refs}

    def _of(self, refs: list[str]) -> tuple[Cause, ...]:
        """The nearest first. If packages need each other, and nothing else needs them, the nearest are named."""
        direct = dict.fromkeys(user for ref in refs for user in self._users.get(ref, ()))
        through = {**dict.fromkeys(refs, ""), **{user: user for user in direct}}
        queue, causes = deque(direct), list[str]()
        while queue and self._steps > 0:
            ref = queue.popleft()
            users = self._users.get(ref, ())
            self._steps -= 1 + len(users)
            if ref in self._ros or not users:
                causes.append(ref)
                continue
            for user in users:
                if user not in through:
                    through[user] = through[ref]
                    queue.append(user)
        titles = ((self._titles[ref], self._titles[through[ref]]) for ref in [*(causes or direct)][:CAUSES])
        return tuple(Cause(title, by if by != title else "") for title, by in titles)
