"""The order of the steps that build an app: its packages once, as a part, and the images that join the part and a base image."""

from __future__ import annotations

import time
from dataclasses import replace

from rosml.containerize.build import bases, contexts, result, stages, verdict
from rosml.containerize.build.call import Call, Headings, new_call
from rosml.containerize.build.result import Result, ShellImage
from rosml.containerize.names import DESK
from rosml.machine import buildx

__all__ = ["Call", "build_images", "build_shell_image", "new_call"]


def build_images(call: Call) -> Result:
    """Builds, tests and joins the images of an app."""
    with call.turn():
        started, waited = time.monotonic(), buildx.waited()
        work = f"build {'and test ' * (call.values.tests)}the packages"
        headings = Headings(call, "find the base image, fetch sources", work, "join the images")
        headings.begin()
        followed_lock = bases.read_lock(call)
        base = bases.find(call, followed_lock)
        verdict.require_kept_platforms(call)
        fetched = contexts.fetch(call, followed_lock)
        slim = bases.find_slim(call, base, followed_lock)
        slim = slim and bases.slim_with_addons(call, slim, base, followed_lock)
        base = bases.with_addons(call, base, followed_lock)
        verdict.require_same_addons(followed_lock, call.values, base, slim)
        verdict.require_allowed(call, base, slim)
        inputs = contexts.write(call, base, slim, followed_lock)
        verdict.require_provided(call, inputs)
        verdict.require_build_files(call, inputs)
        headings.begin()
        with stages.open_cache(call) as cache:
            chosen = stages.choose(call, inputs, followed_lock, cache)
            packages = stages.earlier_build(chosen, cache)
            if packages is None:
                packages = stages.build_packages(chosen)
                verdict.require_passed(packages.tests, call.reports, slim=slim is not None)
                if call.values.tests:
                    verdict.require_complete(packages.outcome, inputs.targets)
                if cache and chosen.keys:
                    cache.keep(chosen.keys, packages.outcome, packages.tests.target, packages.details())
            unstarted = verdict.require_started(call, packages.outcome, inputs.targets)
            lock = result.lock_of(call, chosen.recipe.inputs, packages.outcome, fetched, followed_lock)
            headings.begin()
            images = stages.join_images(chosen, packages.outcome, lock)
            described = stages.attach_contents(chosen, images, packages, fetched.upstream)
        return Result(
            base=base.reference,
            images=images,
            outcome=packages.outcome,
            unstarted=unstarted,
            upstream=fetched.upstream,
            downstream=fetched.downstream,
            lock=lock,
            lock_file=result.write_lock(call, lock, inputs),
            described=described,
            tests=packages.tests,
            reports=packages.reports,
            seconds=time.monotonic() - started,
            waited=buildx.waited() - waited,
        )


def build_shell_image(call: Call) -> ShellImage:
    """Builds the image for `rosml dev`: the environment of the packages, with debuggers. The packages are not built."""
    with call.turn():
        headings = Headings(call, "find the base image, fetch sources", "install what the packages need")
        headings.begin()
        followed_lock = bases.read_lock(call)
        base = bases.find(call, followed_lock)
        fetched = contexts.fetch(call, followed_lock)
        base = bases.with_addons(call, base, followed_lock)
        verdict.require_same_addons(followed_lock, call.values, base, None)
        inputs = contexts.write(call, base, None, followed_lock)
        verdict.require_provided(call, inputs)
        # It is the same image for each commit: a new one would be no reason to leave a container that runs.
        inputs = replace(inputs, targets=(DESK,), time=contexts.TIME)
        headings.begin()
        with stages.open_cache(call) as cache:
            chosen = stages.choose(call, inputs, followed_lock, cache)
        image = stages.build_shell_image(chosen)
        return replace(image, upstream=call.state / "upstream" if fetched.upstream else None)
