"""Apps on other base images, of a few bytes each, in a registry in this process. Real ones: tests/e2e/test_rebase.py."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import pytest

from fakes.rebasing import (
    ADDON,
    BASE_FACTS,
    BOTH,
    FILES,
    LIBC,
    OTHER_BUILD,
    OWN,
    PYTHON,
    ROSCPP,
    App,
    Place,
    addon,
    app_with_addon,
    changed,
    library,
    on_stack,
    package,
    place,
)
from fakes.stubs import script_of_a_build
from rosml.base.errors import RosmlError
from rosml.containerize.build.bake_file import REPLACED
from rosml.containerize.lock import Image, Lock
from rosml.containerize.rebase import image, variants
from rosml.images.image_set.labels import ADDONS, BASE_DIGEST, BASE_NAME, LOCK, PREFIX
from rosml.images.join import facts, file_lists
from rosml.images.scan import sbom
from rosml.registry.answers import Answer
from rosml.registry.client import Registry
from rosml.registry.transport import Call
from tests.e2e.parts import ros

__all__ = ["place"]


# ---- What comes of it ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("platforms", [BOTH[:1], BOTH])
def test_it_is_what_a_build_gives(place: Place, platforms: Sequence[str]) -> None:
    """With the annotations that somebody gave the app, and without those about its former base image."""
    base, new = place.base(), place.base("newer", environment=("ROS_SYNC_DATE=2026-11-26", "WORKSPACE=/other"))
    kept = {"com.example.robot": "arm"}
    app = place.app(base, platforms=platforms, annotations={**kept, "org.opencontainers.image.base.digest": "sha256:x"})
    built, first = (
        place.digest(App(name, annotations=kept).put(place.registry, "built", platforms)) for name in (new, base)
    )
    rebased = place.rebase(app, new, f"{place.server.address}/me/robot:moved")
    assert rebased.digest == built == place.digest(rebased.reference)
    assert (rebased.verdict, rebased.reasons, rebased.moved) == ("safe", [], True)
    assert place.rebase(app, new, rebased.reference).moved is False, "again"
    back = place.rebase(rebased.reference, base)
    assert back.digest == first and back.before == built, "and back, with its own tag"


@pytest.mark.parametrize("short", [False, True])
def test_the_way_back_keeps_the_tag(place: Place, short: bool) -> None:
    """`NAME:TAG@DIGEST` is the image of the digest, named by the tag: the former digest comes out, and the next night moves the app again."""
    full = place.base()
    pin = place.digest(full)
    lock = Lock(base_image=Image(name="ros:core" if short else full, digest=pin)).line()
    app = place.app(full, labels={LOCK: lock})
    before = place.digest(app)
    place.base(files=FILES)
    newer = place.rebase(app, "")
    assert newer.moved and newer.back == before
    assert place.rebase(app, f"{'ros:core' if short else full}@{pin}").digest == before == place.digest(app)
    assert place.rebase(app, f"{full}@{pin}").moved is False, "another spelling of the same tag changes nothing"
    assert place.rebase(app, "").digest == newer.digest, "and it follows the tag again"
    assert not any("stays there" in line for line in place.messages)


def test_a_base_image_by_its_digest_alone(place: Place) -> None:
    full = place.base()
    app, pin = place.app(full), f"{full.rpartition(':')[0]}@{place.digest(full)}"
    place.base(files=FILES)
    place.rebase(app, "")
    place.rebase(app, pin)
    assert f"{pin} has no tag, so the app stays there" in place.messages[-1]
    assert "is there, but not with the digest" in place.refused(app, f"{full}@sha256:{'0' * 64}")


def test_no_layer_is_pulled_and_little_is_sent(place: Place) -> None:
    base, new = place.base(), place.base("newer")
    app = place.app(base)
    start, before = len(place.server.requests), place.registry.uploaded
    rebased = place.rebase(app, new, with_sbom=False)
    requests, headers = place.server.requests[start:], place.server.headers[start:]
    layers = {layer["digest"] for name in (base, new, app) for layer in place.layers(name)}
    pulled = [line for line in requests if line.startswith("GET") and line.rpartition("/")[2] in layers]
    assert not pulled and place.registry.uploaded == before
    assert sum(int(item.get("content-length", 0)) for item in headers) == rebased.uploaded < 10_000
    assert (rebased.mounted, rebased.present, rebased.copied) == (1, 1, 0)
    assert len(requests) <= 62, "in a registry without the API of referrers, which takes 14 more"


@pytest.mark.parametrize("answer", [202, 400, 404, 405])
def test_a_registry_that_mounts_nothing(place: Place, answer: int) -> None:
    app, new = place.app(place.base()), place.base("newer")
    place.server.mounts = False
    if answer != 202:  # not as the specification asks
        place.server.fault("POST", "mount=", answer, 100)
    rebased = place.rebase(app, new, with_sbom=False)
    assert rebased.copied == 1 and rebased.digest == place.digest(App(new).put(place.registry, "built"))


def test_what_is_attached_is_of_the_new_image(place: Place) -> None:
    base, new = place.base(), place.base("newer", files=FILES)
    app = place.app(base)
    place.sbom("me/robot", app, ["python3@3.11.2-1", "gone@1", "python3-angles@1.16"])
    place.sbom("rosml/ros", new, ["python3@3.11.2-2", "fresh@2"])
    rebased = place.rebase(app, new)
    [digest] = rebased.manifests.values()
    files = file_lists.Lists().of(place.registry, "me/robot", digest)
    assert files and files.entries == {*OWN["files"], "usr/lib/python3/angles.py", *FILES}
    assert facts.of(place.registry, "me/robot", digest) == facts.Facts.model_validate(OWN)
    [entry] = place.registry.referrers("me/robot", digest, sbom.MEDIA_TYPE)
    artifact = place.manifest("me/robot", entry["digest"])
    document = place.registry.json_blob("me/robot", artifact.layers[0].digest)
    assert document["metadata"]["component"]["name"].endswith(digest)
    assert [item["name"] for item in document["components"]] == ["fresh", "python3-angles", "python3"]
    assert place.rebase(rebased.reference, place.base("last")).moved, "it can move again"


def test_an_sbom_of_an_older_format_counts_if_there_is_no_other(place: Place) -> None:
    """It names the components in another way."""
    new = place.base("newer", files=FILES)
    app = place.app(place.base())
    place.sbom("me/robot", app, ["python3-angles@1.16"], version="1")
    place.sbom("rosml/ros", new, ["fresh@1"], version="1")
    place.sbom("rosml/ros", new, ["fresh@2"])
    [digest] = place.rebase(app, new).manifests.values()
    [entry] = place.registry.referrers("me/robot", digest, sbom.MEDIA_TYPE)
    document = place.registry.json_blob("me/robot", place.manifest("me/robot", entry["digest"]).layers[0].digest)
    assert [(item["name"], item["version"]) for item in document["components"]] == [
        ("fresh", "2"),
        ("python3-angles", "1.16"),
    ]


def test_an_app_on_an_app(place: Place) -> None:
    base, new = place.base(), place.base("newer")
    lower = App(base, name="lower").put(place.registry, "a", index=True)
    upper_facts = {**OWN, "packages": [], "files": ["docker-ros/ws/install/lib/upper"], "libraries": []}
    upper = App(lower, upper_facts, name="upper").put(place.registry, "a")
    moved = place.rebase(lower, new, f"{place.server.address}/me/lower:b")
    built = App(moved.reference, upper_facts, name="upper").put(place.registry, "built")
    assert place.rebase(upper, moved.reference).digest == place.digest(built)


def test_one_platform_of_two(place: Place) -> None:
    app, new = place.app(place.base(), platforms=BOTH), place.base("newer")
    rebased = place.rebase(app, new, f"{place.server.address}/me/robot:arm", ["linux/arm64"])
    assert [*rebased.manifests] == ["linux/arm64"]
    assert "is for linux/amd64 and linux/arm64, not for linux/riscv64" in place.refused(app, new, "", ["linux/riscv64"])


# ---- What is refused -------------------------------------------------------------------------------------------------


WITHOUT_SPIN = library("opt/ros/lib/librclcpp.so", ("shutdown",), ["libc.so.6"], id="1" * 40)
ANGLES, PYTHON3 = "python3-angles needs python3 (<< 3.12), and", package("python3", "3.11.2-1")


def packages(*items: dict[str, Any]) -> dict[str, Any]:
    return {"base_facts": changed(BASE_FACTS, packages=[*items])}


def libraries(*items: dict[str, Any]) -> dict[str, Any]:
    return {"base_facts": changed(BASE_FACTS, libraries=[*items])}


@pytest.mark.parametrize(
    ("new", "says"),
    [
        ({"distribution": "jazzy"}, "was built on ROS distribution ros1-bookworm, and"),
        ({"python": "3.12"}, "was built on Python 3.11, and"),
        ({"platforms": BOTH[1:]}, "is not for linux/amd64"),
        ({"base_facts": None}, "has no facts about its packages, libraries and files"),
        ({"unlisted": True}, "has no facts about its packages, libraries and files"),
        (packages(package("python3", "3.12.1-1")), f"{ANGLES} the base image has python3 3.12.1-1"),
        (packages(), f"{ANGLES} the base image has none"),
        (packages(PYTHON3, package("python3-angles", "1.17")), "1.16, and the base image has 1.17"),
        (packages(package("python3", "3.11.2-1", conflicts="python3-angles (<< 2)")), "cannot stand beside"),
        ({"files": ("usr/bin/env", "docker-ros/ws/install/lib/node")}, "both have /docker-ros/ws/install/lib/node"),
        ({"files": ("usr/lib/python3/angles.py",)}, "both have /usr/lib/python3/angles.py"),
        ({"files": ("usr/bin/env", "usr/lib/python3")}, "has a folder /usr/lib/python3, which is a file"),
        ({"files": ("usr/bin/env", "usr/lib/python3/angles.py/x")}, "which is a folder in the base image"),
        (libraries(LIBC, PYTHON), "lib/node needs librclcpp.so, which the base image lacks"),
        (libraries(LIBC, PYTHON, WITHOUT_SPIN), "lib/node uses spin, which no library of the base image has any more"),
        (libraries(LIBC, ROSCPP, library("usr/bin/python3.11", soname="")), "lib/ext.so uses PyObject_Call, which no"),
    ],
)
def test_another_base_image_is_refused(place: Place, new: dict[str, Any], says: str) -> None:
    app = place.app(place.base())
    assert says in place.refused(app, place.base("newer", **new))


DIST_PACKAGES = "usr/local/lib/python3.11/dist-packages"
TORCH = f"{DIST_PACKAGES}/torch/__init__.py"
BZ2 = "usr/lib/python3.11/lib-dynload/_bz2.cpython-311-x86_64-linux-gnu.so"
TABULATE = package("python3-tabulate", "0.9")
WITH_TABULATE = packages(PYTHON3, TABULATE)["base_facts"]


@pytest.mark.parametrize(
    ("app_facts", "says", "new"),
    [
        ({"imports": [{"module": "torch", "file": "lib/node.py"}]}, "lib/node.py imports torch", {"files": (*FILES, TORCH)}),
        ({"imports": [{"module": "_bz2", "file": "a.py"}]}, "a.py imports _bz2", {"files": (*FILES, BZ2)}),
        ({"imports": [], "asks": ["python3-tabulate"]}, "asked for python3-tabulate", {"base_facts": WITH_TABULATE}),
        (
            {"asks_pip": ["typing-extensions"]},
            "asked pip for typing-extensions",
            {"files": (*FILES, f"{DIST_PACKAGES}/typing_extensions-4.15.0.dist-info/METADATA")},
        ),
    ],
)  # fmt: skip
def test_what_the_app_took_from_its_base_image_has_to_be_in_the_new_one(
    place: Place, app_facts: dict[str, Any], says: str, new: dict[str, Any]
) -> None:
    """It is in no layer of the app. Lists of files and packages say so: no image is unpacked for that."""
    app = place.app(place.base(base_facts=WITH_TABULATE), facts=changed(OWN, **app_facts))
    assert f"{says}, which the base image lacks" in place.refused(app, place.base("newer"))
    assert place.rebase(app, place.base("newest", **new)).moved


@pytest.mark.parametrize(
    ("more", "verdict"),
    [({}, "check by link"), ({"imports": []}, "safe"), ({"imports": [{"module": "os", "file": "a"}]}, "check by link")],
)
def test_packages_that_are_gone_matter_to_an_app_with_python(place: Place, more: dict[str, Any], verdict: str) -> None:
    """Of an app that was built earlier, nobody knows whether it has some."""
    app = place.app(place.base(base_facts=WITH_TABULATE), facts=changed(OWN, **more))
    new = place.base("newer", files=("usr/bin/env", "usr/lib/python3.11/os.py"))
    rebased = place.rebase(app, new)
    assert rebased.verdict == verdict and ("python3-tabulate" in "".join(rebased.reasons)) == (verdict != "safe")


def test_a_file_whose_name_is_no_unicode_is_compared(place: Place) -> None:
    """As facts name it, which a step of the build wrote."""
    name = os.fsdecode(b"etc/M\xfcller")
    [shown] = script_of_a_build("containerize/facts.py").shown([name])
    app = place.app(place.base(), facts=changed(OWN, files=[shown]))
    assert f"both have /{shown}" in place.refused(app, place.base("newer", files=("usr/bin/env", name)))


@pytest.mark.parametrize(
    ("app", "says"),
    [
        ({"facts": None}, "has no facts about its packages and libraries"),
        ({"target": "dev"}, "is an image to work on"),
        ({"target": ""}, "is no app that rosml containerize built"),
        ({"labels": {REPLACED: "less:amd64"}}, "replaces what its base image has: less:amd64"),
        ({"labels": {LOCK: "{}"}}, "its label io.rosml.lock is damaged"),
        (
            {"labels": {ADDONS: "graph " * 10_000, f"{PREFIX}stack": "cpu"}},
            "its label io.rosml.addons is damaged: it has",
        ),
    ],
)
def test_an_image_that_is_no_such_app_is_refused(place: Place, app: dict[str, Any], says: str) -> None:
    assert says in place.refused(place.app(place.base(), **app), place.base("newer"))


def test_platforms_on_different_images(place: Place) -> None:
    place.app(place.base(), "a")
    place.app(place.base("torch"), "b")
    text = place.refused(place.index("mixed", ("a", "amd64"), ("b", "arm64")), place.base("newer"))
    assert "its platforms are on different images: linux/amd64 on" in text


# ---- What the facts do not decide ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("library_now", "verdict"),
    [
        (ROSCPP, "safe"),
        (OTHER_BUILD, "check by link"),
        (library("usr/lib/libc.so.6", ("printf",), id="2" * 40), "safe"),
    ],
)
def test_a_library_changed(place: Place, library_now: dict[str, Any], verdict: str) -> None:
    others = [item for item in BASE_FACTS["libraries"] if item["path"] != library_now["path"]]
    rebased = place.rebase(place.app(place.base()), place.base("newer", **libraries(*others, library_now)))
    assert rebased.verdict == verdict
    assert all("librclcpp.so changed" in reason for reason in rebased.reasons)


def test_the_present_base_image_is_gone(place: Place) -> None:
    base, new = place.base(), place.base("newer")
    app = place.app(base)
    place.registry.delete("rosml/ros", place.digest(base))
    rebased = place.rebase(app, new)
    assert rebased.verdict == "check by link" and "is gone" in rebased.reasons[0]


def test_a_part_of_another_release(place: Place) -> None:
    torch = libraries(*BASE_FACTS["libraries"], library("usr/local/lib/libtorch.so", ("spin",)))
    labels = {"io.rosml.framework": "torch", "io.rosml.torch": "2.14.0"}
    base = place.base(**torch, labels=labels)
    uses = [library("docker-ros/ws/install/lib/node", needed=["libtorch.so"], uses=["spin"])]
    new = place.base("newer", **torch, labels=labels | {"io.rosml.torch": "2.15.0"})
    text = place.refused(place.app(base, facts=changed(OWN, libraries=uses)), new)
    assert "the app was built with torch 2.14.0 (libtorch.so), and the base image has 2.15.0" in text
    _, plan = place.plan(place.app(base, "python"), place.base("without", **torch))
    assert "this base image has no torch; the app's Python may use it" in plan.judgement.undecided


# ---- Add-ons ---------------------------------------------------------------------------------------------------------


def test_an_addon_comes_along_from_beside_the_new_base_image(place: Place) -> None:
    """Its newest parts, and not those on which the app was built."""
    app = app_with_addon(place, place.base(), addon(place, "yesterday"))
    new, parts = place.base("tonight"), addon(place, "tonight")
    rebased = place.rebase(app, new)
    assert place.layers(app)[:-1] == [layer for reference in (new, *parts) for layer in place.layers(reference)]
    assert rebased.copied == 0 and rebased.base == new
    source = next(iter(place.rebaser().read(app).values()))
    assert (source.labels["io.rosml.addons"], source.labels["io.rosml.stack"]) == ("graph", "cpu")
    assert source.labels[BASE_DIGEST] == place.digest(new)
    app_lock = image.lock_of(source)
    assert app_lock and {*(app_lock.addons or ())} == {f"{place.server.address}/rosml/part:{tag}" for tag in ADDON}
    assert place.rebase(app, new).digest == rebased.digest, "a second call has nothing to do"


def test_an_addon_that_the_new_base_image_cannot_have_is_refused(place: Place) -> None:
    app = app_with_addon(place, place.base(), addon(place, "yesterday"))
    replace(ros(), labels={}).put(place.registry, "rosml/ros", "foreign", BOTH[:1])
    foreign = place.refused(app, f"{place.server.address}/rosml/ros:foreign")
    assert "foreign is none of rosml's images, so it can have no add-on" in foreign
    place.server.tags["rosml/part"].pop("graph-cpu-py311")
    assert "there is no add-on graph-cpu: neither" in place.refused(app, place.base("tonight"))


def test_the_remedy_is_one_for_a_rebase(place: Place) -> None:
    app = place.app(place.base(), labels={"io.rosml.addons": "devel", "io.rosml.stack": "cpu"})
    with pytest.raises(RosmlError, match="stack cpu has no devel") as caught:
        place.rebase(app, place.base("tonight"))
    assert caught.value.remedy.startswith("name another --base; or build the app again: ")


# ---- Others, and the end of the process ------------------------------------------------------------------------------


def test_a_tag_that_moved_meanwhile_stays(place: Place) -> None:
    app = place.app(place.base())
    rebaser, plan = place.plan(app, place.base("newer"))
    place.app(place.base("third"))  # somebody else pushes the same tag
    with rebaser, pytest.raises(RosmlError, match="has moved since it was read, and stays") as caught:
        rebaser.move(plan, rebaser.push(plan))
    assert caught.value.exit_code == 1 and place.digest(app) != plan.digest


def test_it_is_interrupted_at_any_request_that_writes(place: Place) -> None:
    """The former tag stands until the last one; the next call ends as an undisturbed one."""
    app, new = place.app(place.base()), place.base("newer")
    before, expected = place.digest(app), place.digest(App(new).put(place.registry, "built"))
    manifests, blobs, (_, tags) = dict(place.server.manifests), dict(place.server.blobs), place.content()
    count = 0
    while True:
        place.server.manifests, place.server.blobs = dict(manifests), dict(blobs)
        place.server.tags = {name: dict(of_name) for name, of_name in tags.items()}
        rebaser, plan = place.plan(app, new, registry=Dying(place.server.address, count))
        try:
            with rebaser:
                rebaser.move(plan, rebaser.push(plan))
        except KeyboardInterrupt:
            assert place.digest(app) == before, "the former tag stands"
            assert place.rebase(app, new).digest == expected == place.digest(app)
            count += 1
        else:
            break
    assert count > 5


class Dying(Registry):
    """A client whose process ends at a write."""

    def __init__(self, host: str, writes: int) -> None:
        super().__init__(host)
        self.writes = writes
        self._ask, self.transport.ask = self.transport.ask, self.ask  # type: ignore[method-assign]

    def ask(self, call: Call) -> Answer:
        if call.method in ("PUT", "POST"):
            self.writes -= 1
            if self.writes < 0:
                raise KeyboardInterrupt
        return self._ask(call)


# ---- Variants --------------------------------------------------------------------------------------------------------


def test_an_app_with_an_addon_alone_on_several_accelerators(place: Place) -> None:
    """Its base image has no stack, and stays; the add-on comes from each stack."""
    base = place.base()
    app = app_with_addon(place, base, addon(place, "tonight"))
    addon(place, "tonight", "cu128")
    with place.rebaser() as rebaser:
        plans = variants.plans(rebaser, app, ["cpu", "cu128"])
    labels = [next(iter(plan.members.values())).image.labels for plan in plans]
    assert [item["io.rosml.stack"] for item in labels] == ["cpu", "cu128", "cpu"]
    assert {item[image.VARIANTS] for item in labels} == {"cpu cu128:525"}
    assert {item[BASE_NAME] for item in labels} == {base}


def test_an_app_on_several_accelerators(place: Place) -> None:
    cpu, cu132 = on_stack(place, "cpu"), on_stack(place, "cu132")
    on_stack(place, "cu130", driver="580")
    app = place.app(cpu)
    with place.rebaser() as rebaser:
        for plan in variants.plans(rebaser, app, ["cpu", "cu130"]):
            rebaser.move(plan, rebaser.push(plan))
    labels = [place.labels("me/robot", tag) for tag in ("latest", "latest-cpu", "latest-cu130")]
    assert {item["io.rosml.variants"] for item in labels} == {"cpu cu130:580"}
    assert [item["io.rosml.stack"] for item in labels] == ["cpu", "cpu", "cu130"]
    moved = place.rebase(f"{place.server.address}/me/robot:latest-cu130", cu132)
    assert moved.moved, "and they follow their own base images"
    assert place.labels("me/robot", "latest-cu130")["io.rosml.variants"] == "cpu cu130:580"
    place.rebase(app, cu132, f"{place.server.address}/me/robot:candidate")
    assert "io.rosml.variants" not in place.labels("me/robot", "candidate"), "nobody made candidate-cu130"


@pytest.mark.parametrize(
    ("stacks", "says"),
    [
        (["cpu"], "one variant is named"),
        (["cpu", "cu130", "cpu"], "cpu is named twice"),
        (["cpu", "cu13 0"], "'cu13 0' is no stack"),
        (["cpu", "cu999"], "there is no image"),
        (["cpu", "cu130"], "lib/node needs libcudart.so.12, which the base image lacks"),
    ],
)
def test_variants_are_refused(place: Place, stacks: list[str], says: str) -> None:
    cudart = libraries(*BASE_FACTS["libraries"], library("usr/local/lib/libcudart.so.12"))["base_facts"]
    cpu = on_stack(place, "cpu", cudart)
    on_stack(place, "cu130", driver="580")
    uses = [library("docker-ros/ws/install/lib/node", needed=["libcudart.so.12"])]
    app = place.app(cpu, facts=changed(OWN, libraries=uses))
    with place.rebaser() as rebaser, pytest.raises(RosmlError) as caught:
        variants.plans(rebaser, app, stacks)
    assert says in caught.value.message and caught.value.exit_code == 2
