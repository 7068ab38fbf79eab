"""Which tests an image runs itself, and whether those that it shares with other images have passed there.

Images of a distribution have the same ROS image and the same parts below them. So most tests run in one of these images only,
and count for the others as long as the digests of what they have in common are the same.
"""

from __future__ import annotations

import hashlib
import json
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from rosml.base.problems import some
from rosml.images.bake.inputs import TARGET, Inputs
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.publish.items import Item, Key, ros_images
from rosml.images.records.store import Entry

Names = tuple[str, ...]


@dataclass
class SharedTests:
    """The tests of the images of a run."""

    image_set: ImageSet
    inputs: Inputs
    entries: Mapping[Key, Entry]  # of the records; a run keeps them up to date
    requested: frozenset[str]  # targets of the images that are part of the run
    everything: bool  # these run all tests, also those that passed in others with the same parts
    outdated: Callable[[Key], list[str]]  # why an image has to be rebuilt; empty if it is not part of the run
    _digests: dict[tuple[str, str, Names], str] = field(default_factory=dict)
    _provers: dict[str, Names] = field(default_factory=dict)

    def to_run(self, item: Item) -> Names:
        """The tests that an image runs: its own; and shared ones, unless another image runs them, or passed with the same parts."""
        image = _image(item)
        of_ros, of_parts = _of_ros(image), _of_parts(image)
        if self._runs_all(item):
            return (*image.tests, *image.shared)
        if not of_ros or self._proven_elsewhere(item, of_ros, image.parent):
            of_ros = ()
        if not of_parts or self._proven_elsewhere(item, of_parts, *image.carriers[:1]):
            of_parts = ()
        return (*image.tests, *of_ros, *of_parts)

    def passed(self, item: Item, entry: Entry) -> bool:
        """Whether an image passed today's tests: all of them, or those that it runs itself."""
        return self._tested(item, entry) and entry.passed > 0 and not entry.failures

    def outcome(self, item: Item) -> str:
        """What the records say about an image that did not pass today's tests."""
        entry = self.entries[item.key]
        if not entry.tested:
            return "not tested yet"
        if not self._tested(item, entry):
            return "tested before its tests changed"
        return f"tested, and failed: {some(list(entry.failures))}" if entry.failures else "tested, and no test ran"

    def digest(self, item: Item, names: Names) -> str:
        """A digest of tests of an image: files, programs and expected values, without the image itself."""
        key = (*item.key, names)
        if key not in self._digests:
            inputs = self.inputs.of_tests(_image(item), item.architecture, names)
            content = {name: value for name, value in inputs.items() if not name.startswith(TARGET)}
            content["budget"] = str(_image(item).budget)
            self._digests[key] = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
        return self._digests[key]

    def provers(self, image: Image) -> Names:
        """Images that may have run tests that an image shares: on the same ROS image; or on that or a lower one, with all its parts."""
        if image.target not in self._provers:
            lower = {link.target for link in ros_images(self.image_set, image)}
            self._provers[image.target] = tuple(
                other.target
                for other in self._by_distribution[image.distribution]
                if other.target != image.target
                and (
                    other.parent == image.parent
                    or (
                        other.stack == image.stack
                        and (other.parent if other.stack else other.target) in lower
                        and {*image.parts} <= {*other.parts}
                    )
                )
            )
        return self._provers[image.target]

    def unproven(self, item: Item) -> str:
        """Why shared tests in other images prove nothing for this image; empty if they passed, or the image ran all tests."""
        image = _image(item)
        names = {*self._ran(item, self.entries[item.key])}
        for shared, first in ((_of_ros(image), image.parent), (_of_parts(image), next(iter(image.carriers), ""))):
            if first in self.requested and first != image.target and (reason := self._unproven_in(item, first, shared)):
                return reason
            if not names.issuperset(shared) and (reason := self._unproven(item, shared, first)):
                return reason
        return ""

    def _runs_all(self, item: Item) -> bool:
        return self.everything and item.target in self.requested

    def _tested(self, item: Item, entry: Entry) -> bool:
        required = {*_image(item).shared} if self._runs_all(item) else set()
        ran = self._ran(item, entry)
        return bool(ran) and required <= {*ran}

    def _ran(self, item: Item, entry: Entry) -> Names:
        """The tests that ran in an image, if they are today's: its own, and perhaps some that it shares."""
        image = _image(item)
        for shared in (image.shared, _of_ros(image), _of_parts(image), ()):
            if entry.tested == self.digest(item, (*image.tests, *shared)):
                return (*image.tests, *shared)
        return ()

    def _proven_elsewhere(self, item: Item, names: Names, first: str = "") -> bool:
        """Whether tests that an image shares passed in another one, or run in `first`, which is part of this run."""
        return (first in self.requested and first != item.target) or not self._unproven(item, names, first)

    def _unproven(self, item: Item, names: Names, first: str) -> str:
        """Why tests that an image shares passed in no image that counts for it; the reason is about `first`."""
        reason = ""
        for target in dict.fromkeys((first, *self.provers(_image(item)))):
            if target in self.image_set.by_target and (target, item.architecture) in self.entries:
                why = self._unproven_in(item, target, names)
                if not why:
                    return ""
                reason = reason or why
        return reason or f"tests that it shares with {first}: that image is missing"

    def _unproven_in(self, item: Item, target: str, names: Names) -> str:
        """Why tests prove nothing that ran in one other image; empty if they passed there, with the same parts."""
        prover = self.image_set.by_target[target]
        proof = Item(prover, item.architecture, ())
        entry = self.entries.get(proof.key)
        what = f"tests that it shares with {target}"
        if entry is None or not entry.digest:
            return f"{what}: that image is missing"
        if why := self.outdated(proof.key):
            return f"{what}: {why[0]}"
        ran = {*self._ran(proof, entry)}
        if not ran or not (entry.passed or entry.failures):
            return f"{what} have not passed"
        image = _image(item)
        common = {*image.shared, *prover.carried}
        if failures := [failure for failure in entry.failures if failure.partition(":")[0] in common]:
            return f"{what} failed: {some(failures)}"
        for name, digest in entry.parts.items():
            if (part := self.entries.get((name, item.architecture))) and part.digest != digest:
                return f"{what}: that image has another {name}"
        if not (open_names := tuple(name for name in names if name not in ran)):
            return ""
        if target == image.parent:
            return self._unproven(proof, open_names, prover.parent)
        if image.environment and target in image.carriers:  # the image without it: others ran what that one shares
            return self._unproven(proof, open_names, next(iter(prover.carriers), ""))
        return f"{what} did not run"

    @cached_property
    def _by_distribution(self) -> Mapping[str, Sequence[Image]]:
        images: defaultdict[str, list[Image]] = defaultdict(list)
        for image in self.image_set.images:
            images[image.distribution].append(image)
        return images


def _image(item: Item) -> Image:
    assert isinstance(item.thing, Image)
    return item.thing


def _of_ros(image: Image) -> Names:
    """The tests of the ROS image below an image."""
    return tuple(name for name in image.shared if name not in image.carried)


def _of_parts(image: Image) -> Names:
    """The tests of its parts that an image does not carry itself."""
    return tuple(name for name in image.shared if name in image.carried)
