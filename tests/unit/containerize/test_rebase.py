"""Apps on other base images, of a few bytes each, in a registry in this process. Real ones: tests/e2e/test_rebase.py."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.rebasing import (
    ADDON,
    BASE_FACTS,
    BOTH,
    LIBC,
    OTHER_BUILD,
    OWN,
    PYTHON,
    ROSCPP,
    App,
    Place,
    addon,
    app_with_addon,
    attach,
    changed,
    library,
    moving,
    on_stack,
    package,
)
from fakes.stubs import script_of_a_build
from rosml.base.errors import RosmlError
from rosml.containerize.build.bake_file import BASE_DIGEST, BASE_NAME, LOCK, REPLACED
from rosml.containerize.lock import Image, Lock
from rosml.containerize.rebase import compatibility, image, variants
from rosml.images.join import facts, file_lists
from rosml.images.scan import sbom
from rosml.registry import oci
from rosml.registry.client import Registry
from tests.e2e.parts import ros


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as found:
        yield found


# ---- What comes of it ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("platforms", [BOTH[:1], BOTH])
def test_it_is_what_a_build_gives(place: Place, platforms: Sequence[str]) -> None:
    old, new = place.base(), place.base("newer", environment=("ROS_SYNC_DATE=2026-11-26", "WORKSPACE=/other"))
    app = place.app(old, platforms=platforms)
    built = place.digest(App(new).put(place.registry, "built", platforms))
    found = place.rebase(app, new, f"{place.server.address}/me/robot:moved")
    assert found.digest == built == place.digest(found.reference)
    assert (found.verdict, found.reasons, found.moved) == ("safe", [], True)
    assert place.rebase(app, new, found.reference).moved is False, "again"
    back = place.rebase(found.reference, old)
    assert back.digest == place.digest(app) and back.before == built, "and back, with its own tag"


@pytest.mark.parametrize("platforms", [("linux/amd64",), ("linux/amd64", "linux/arm64")])
def test_annotations_of_an_app_come_along(place: Place, platforms: Sequence[str]) -> None:
    """Those that somebody gave it. What is said of the old base image is not true any more."""
    old, new = place.base(), place.base("newer")
    own = {"com.example.robot": "arm"}
    app = place.app(old, platforms=platforms, annotations={**own, "org.opencontainers.image.base.digest": "sha256:old"})
    built = place.digest(App(new, annotations=own).put(place.registry, "built", platforms))
    assert place.rebase(app, new).digest == built


@pytest.mark.parametrize("short", [False, True])
def test_the_way_back_keeps_the_tag(place: Place, short: bool) -> None:
    """`NAME:TAG@DIGEST` is the image of the digest, named by the tag: the old digest comes out, and the next night moves the app again."""
    full = place.base()
    place.services = replace(place.services, registry=place.server.address)
    old = place.digest(full)
    lock = Lock(base_image=Image(name="ros:core" if short else full, digest=old)).line()
    app = place.app(full, labels={LOCK: lock})
    before = place.digest(app)
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    found = place.rebase(app, "")
    assert found.moved and found.back == before
    newer = found.digest
    assert place.rebase(app, f"{'ros:core' if short else full}@{old}").digest == before == place.digest(app)
    assert place.rebase(app, f"{full}@{old}").moved is False, "another spelling of the same tag changes nothing"
    assert place.rebase(app, "").digest == newer, "and it follows the tag again"
    assert not any("stays there" in line for line in place.said)


def test_a_base_image_by_its_digest_alone_is_told(place: Place) -> None:
    full = place.base()
    app, pin = place.app(full), f"{full.rpartition(':')[0]}@{place.digest(full)}"
    place.base(files=("usr/bin/env", "bin", "usr/bin/new"))
    place.rebase(app, "")
    place.rebase(app, pin)
    assert f"{pin} has no tag, so the app stays there" in place.said[-1]
    wrong = f"sha256:{'0' * 64}"
    assert f"{full} is there, but not with the digest {wrong}" in place.refused(app, f"{full}@{wrong}")


def test_no_layer_is_pulled_and_little_is_sent(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    start, before = len(place.server.requests), place.registry.uploaded
    found = place.rebase(app, new, with_sbom=False)
    requests, headers = place.server.requests[start:], place.server.headers[start:]
    layers = {layer["digest"] for name in (old, new, app) for layer in place.layers(name)}
    pulled = [line for line in requests if line.startswith("GET") and line.rpartition("/")[2] in layers]
    assert not pulled and place.registry.uploaded == before
    assert sum(int(item.get("content-length", 0)) for item in headers) == found.uploaded < 10_000
    assert (found.mounted, found.present, found.copied) == (1, 1, 0)
    assert len(requests) <= 62, "in a registry without the API of referrers, which takes 14 more"


@pytest.mark.parametrize("answer", [202, 400, 404, 405])
def test_a_registry_that_mounts_nothing(place: Place, answer: int) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    place.server.mounts = False
    if answer != 202:  # not as the specification asks
        place.server.fault("POST", "mount=", answer, 100)
    found = place.rebase(app, new, with_sbom=False)
    assert found.copied == 1 and found.digest == place.digest(App(new).put(place.registry, "built"))


def test_what_is_attached_is_of_the_new_image(place: Place) -> None:
    old, new = place.base(), place.base("newer", files=("usr/bin/env", "bin", "usr/bin/new"))
    app = place.app(old)
    place.sbom("me/robot", app, ["python3@3.11.2-1", "old@1", "python3-angles@1.16"])
    place.sbom("rosml/ros", new, ["python3@3.11.2-2", "fresh@2"])
    found = place.rebase(app, new)
    [name] = found.manifests.values()
    listed = file_lists.Lists().of(place.registry, "me/robot", name)
    assert listed and listed.entries == {
        *OWN["files"],
        "usr/lib/python3/angles.py",
        "usr/bin/env",
        "bin",
        "usr/bin/new",
    }
    assert facts.of(place.registry, "me/robot", name) == facts.Facts.model_validate(OWN)
    [entry] = place.registry.referrers("me/robot", name, sbom.MEDIA_TYPE)
    artifact = place.registry.manifest("me/robot", entry["digest"])
    assert artifact
    document = place.registry.json_blob("me/robot", artifact.layers[0].digest)
    assert document["metadata"]["component"]["name"].endswith(name)
    assert [item["name"] for item in document["components"]] == ["python3", "fresh", "python3-angles"]
    last = place.rebase(found.reference, place.base("last"))
    assert last.moved, "the result can move again"


def test_an_app_on_an_app(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    lower = App(old, name="lower").put(place.registry, "a", index=True)
    own = {**OWN, "packages": [], "files": ["docker-ros/ws/install/lib/upper"], "libraries": []}
    upper = App(lower, own, name="upper").put(place.registry, "a")
    moved = place.rebase(lower, new, f"{place.server.address}/me/lower:b")
    found = place.rebase(upper, moved.reference)
    built = App(moved.reference, own, name="upper").put(place.registry, "built")
    assert found.digest == place.digest(built)


def test_one_platform_of_two(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old, platforms=BOTH)
    found = place.rebase(app, new, f"{place.server.address}/me/robot:arm", ["linux/arm64"])
    assert [*found.manifests] == ["linux/arm64"]
    assert "is for linux/amd64 and linux/arm64, not for linux/riscv64" in place.refused(app, new, "", ["linux/riscv64"])


# ---- What is refused -------------------------------------------------------------------------------------------------


WITHOUT_SPIN = library("opt/ros/lib/librclcpp.so", ("shutdown",), ["libc.so.6"], id="1" * 40)


@pytest.mark.parametrize(
    ("new", "says"),
    [
        ({"distribution": "jazzy"}, "was built on ROS distribution ros1-bookworm, and"),
        ({"python": "3.12"}, "was built on Python 3.11, and"),
        ({"platforms": BOTH[1:]}, "is not for linux/amd64"),
        ({"said": None}, "has no facts about its packages, libraries and files"),
        ({"unlisted": True}, "has no facts about its packages, libraries and files"),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.12.1-1")])},
            "python3-angles needs python3 (<< 3.12), and the base image has python3 3.12.1-1",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[])},
            "python3-angles needs python3 (<< 3.12), and the base image has none",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.11.2-1"), package("python3-angles", "1.17")])},
            "the app has python3-angles 1.16, and the base image has 1.17",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.11.2-1", conflicts="python3-angles (<< 2)")])},
            "python3 of the base image cannot stand beside python3-angles (<< 2), and the app has python3-angles",
        ),
        (
            {"files": ("usr/bin/env", "docker-ros/ws/install/lib/node")},
            "the app and the base image both have /docker-ros/ws/install/lib/node",
        ),
        ({"files": ("usr/lib/python3/angles.py",)}, "the app and the base image both have /usr/lib/python3/angles.py"),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, PYTHON])},
            "lib/node needs librclcpp.so, which the base image lacks",
        ),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, PYTHON, WITHOUT_SPIN])},
            "lib/node uses spin, which no library of the base image has any more",
        ),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, ROSCPP, library("usr/bin/python3.11", soname="")])},
            "lib/ext.so uses PyObject_Call, which no library of the base image has any more",
        ),
    ],
)
def test_another_base_image_is_refused(place: Place, new: dict[str, Any], says: str) -> None:
    old = place.base()
    app = place.app(old)
    assert says in place.refused(app, place.base("newer", **new))


TORCH = "usr/local/lib/python3.11/dist-packages/torch/__init__.py"
TABULATE = package("python3-tabulate", "0.9")


def test_what_the_apps_python_imports_has_to_be_in_the_base_image(place: Place) -> None:
    """By the list of files: no image is unpacked for that."""
    script = {"module": "torch", "file": "robot/lib/robot/node.py"}
    app = place.app(place.base(), facts=changed(OWN, imports=[script]))
    text = place.refused(app, place.base("newer"))
    assert "robot/lib/robot/node.py imports torch, which the base image lacks" in text
    assert place.rebase(app, place.base("newest", files=("usr/bin/env", TORCH))).verdict == "safe"


def test_what_the_app_asked_for_by_name_has_to_be_in_the_base_image(place: Place) -> None:
    """Its old base image had it, so it is in no layer of the app."""
    old = place.base(said=changed(BASE_FACTS, packages=[*BASE_FACTS["packages"], TABULATE]))
    app = place.app(old, facts=changed(OWN, imports=[], asks=["python3-tabulate"]))
    assert "the app asked for python3-tabulate, which the base image lacks" in place.refused(app, place.base("newer"))


def test_what_the_app_asked_pip_for_has_to_be_in_the_base_image(place: Place) -> None:
    app = place.app(place.base(), facts=changed(OWN, asks_pip=["typing-extensions"]))
    assert "the app asked pip for typing-extensions, which the base" in place.refused(app, place.base("newer"))
    there = "usr/local/lib/python3.11/dist-packages/typing_extensions-4.15.0.dist-info/METADATA"
    assert place.rebase(app, place.base("newest", files=("usr/bin/env", there))).moved


@pytest.mark.parametrize(
    ("more", "verdict"),
    [({}, "check by link"), ({"imports": []}, "safe"), ({"imports": [{"module": "os", "file": "a"}]}, "check by link")],
)
def test_packages_that_are_gone_matter_to_an_app_with_python(place: Place, more: dict[str, Any], verdict: str) -> None:
    """Of an app that was built earlier, nobody knows whether it has some."""
    old = place.base(said=changed(BASE_FACTS, packages=[*BASE_FACTS["packages"], TABULATE]))
    app = place.app(old, facts=changed(OWN, **more))
    new = place.base("newer", files=("usr/bin/env", "usr/lib/python3.11/os.py"))
    assert place.rebase(app, new).verdict == verdict


@pytest.mark.parametrize(
    ("path", "name"),
    [
        (TORCH, "torch"),
        ("usr/lib/python3/dist-packages/yaml/__init__.py", "yaml"),
        ("usr/lib/python3/dist-packages/six.py", "six"),
        ("usr/lib/python3/dist-packages/_yaml.cpython-311-x86_64-linux-gnu.so", "_yaml"),
        ("usr/lib/python3.11/json/__init__.py", "json"),
        ("usr/lib/python3.11/lib-dynload/_bz2.cpython-311-x86_64-linux-gnu.so", "_bz2"),
        ("opt/ros/jazzy/lib/python3.12/site-packages/rclpy/node.py", "rclpy"),
        ("opt/app/venv/lib/python3.12/site-packages/a/b/c.py", "a"),
        ("usr/lib/libtorch.so", ""),
        ("usr/share/doc/torch/README", ""),
    ],
)
def test_modules_in_a_list_of_files(path: str, name: str) -> None:
    assert compatibility.modules_of([path]) == ({name} if name else set())


def test_a_file_whose_name_is_no_unicode_is_found_in_a_base_image(place: Place) -> None:
    """As facts name it, which a step of the build wrote."""
    name = os.fsdecode(b"etc/M\xfcller")
    [shown] = script_of_a_build("containerize/facts.py").shown([name])
    app = place.app(place.base(), facts=changed(OWN, files=[shown]))
    says = f"the app and the base image both have /{shown}"
    assert says in place.refused(app, place.base("newer", files=("usr/bin/env", name)))


@pytest.mark.parametrize(
    ("app", "says"),
    [
        ({"facts": None}, "has no facts about its packages and libraries"),
        ({"target": "dev"}, "is an image to work on"),
        ({"target": ""}, "is no app that rosml containerize built"),
        ({"labels": {REPLACED: "less:amd64"}}, "replaces what its base image has: less:amd64"),
        ({"labels": {LOCK: "{}"}}, "its label io.rosml.lock is damaged"),
    ],
)
def test_an_image_that_is_no_such_app_is_refused(place: Place, app: dict[str, Any], says: str) -> None:
    assert says in place.refused(place.app(place.base(), **app), place.base("newer"))


def test_what_is_no_app(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    assert "is no app" in place.refused(old, new)
    assert "there is no app me/other:x" in place.refused("me/other:x", new)
    assert "there is no image" in place.refused(app, f"{place.server.address}/rosml/ros:none")
    by_digest = f"{app.rpartition(':')[0]}@{place.digest(app)}"
    assert "names the app by its digest" in place.refused(by_digest, new)
    assert "is a digest" in place.refused(app, new, by_digest)


def test_platforms_on_different_images(place: Place) -> None:
    one, other = place.base(), place.base("torch")
    first, second = (place.digest(place.app(name, tag)) for name, tag in ((one, "a"), (other, "b")))
    entries = []
    for digest, architecture in ((first, "amd64"), (second, "arm64")):
        found = place.registry.manifest("me/robot", digest)
        assert found
        entries.append({**found.descriptor, "platform": {"os": "linux", "architecture": architecture}})
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
    place.registry.put_manifest("me/robot", "mixed", content, oci.INDEX)
    text = place.refused(f"{place.server.address}/me/robot:mixed", place.base("newer"))
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
    new = place.base("newer", changed(BASE_FACTS, libraries=[*others, library_now]))
    _, plan = place.plan(place.app(place.base()), new)
    assert place.rebase(plan.app_name, new).verdict == verdict
    assert all("librclcpp.so changed" in reason for reason in plan.judgement.reasons)


def test_the_old_base_image_is_gone(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    place.registry.delete("rosml/ros", place.digest(old))
    found = place.rebase(app, new)
    assert found.verdict == "check by link" and "is gone" in found.reasons[0]


def test_a_part_of_another_release(place: Place) -> None:
    torch = library("usr/local/lib/libtorch.so", ("spin",))
    said = changed(BASE_FACTS, libraries=[*BASE_FACTS["libraries"], torch])
    uses = [library("docker-ros/ws/install/lib/node", needed=["libtorch.so"], uses=["spin"])]
    places = []
    for tag, version in (("core", "2.14.0"), ("newer", "2.15.0")):
        made = replace(ros(salt=tag), labels={**ros().labels, "io.rosml.torch": version})
        places.append(made.put(place.registry, "rosml/ros", tag, BOTH[:1]))
        found = place.registry.manifest("rosml/ros", tag)
        assert found
        [entry] = found.members
        subject = {"mediaType": entry.mediaType, "digest": entry.digest, "size": entry.size}
        attach(place.registry, "rosml/ros", subject, said)
    old, new = places
    app = place.app(old, facts=changed(OWN, libraries=uses))
    assert "the app was built with torch 2.14.0 (libtorch.so), and the base image has 2.15.0" in place.refused(app, new)


# ---- Others, and the end of the process ------------------------------------------------------------------------------


def test_an_addon_comes_along_from_beside_the_new_base_image(place: Place) -> None:
    """Its newest parts, and not those on which the app was built."""
    app = app_with_addon(place, place.base(), addon(place, "yesterday"))
    new, parts = place.base("tonight"), addon(place, "tonight")
    found = place.rebase(app, new)
    layers = [layer for reference in (new, *parts) for layer in place.layers(reference)]
    assert place.layers(app)[:-1] == layers
    assert found.copied == 0 and found.base == new
    source = next(iter(place.rebaser().read(app).values()))
    assert (source.labels["io.rosml.addons"], source.labels["io.rosml.stack"]) == ("graph", "cpu")
    assert source.labels[BASE_DIGEST] == place.digest(new)
    known = image.lock_of(source)
    assert known and known.addons
    assert {*known.addons} == {f"{place.server.address}/rosml/part:{tag}" for tag in ADDON}
    assert place.rebase(app, new).digest == found.digest, "a second call has nothing to do"


def test_an_addon_that_the_new_base_image_cannot_have_is_refused(place: Place) -> None:
    app = app_with_addon(place, place.base(), addon(place, "yesterday"))
    place.server.tags["rosml/part"].pop("graph-cpu-py311")
    said = place.refused(app, place.base("tonight"))
    assert "there is no add-on graph-cpu: neither" in said


def test_an_addon_goes_onto_our_images_alone(place: Place) -> None:
    app = app_with_addon(place, place.base(), addon(place, "yesterday"))
    foreign = replace(ros(), labels={})
    foreign.put(place.registry, "rosml/ros", "foreign", BOTH[:1])
    said = place.refused(app, f"{place.server.address}/rosml/ros:foreign")
    assert "foreign is none of rosml's images, so it can have no add-on" in said


@pytest.mark.parametrize(
    ("said", "why"),
    [
        (" ".join(f"a{number}" for number in range(10_000)), "it has 10,000 names"),
        ("../x", "'../x' is no name"),
        ("graph graph", "'graph' is there twice"),
    ],
)
def test_a_label_with_absurd_addons(said: str, why: str, place: Place) -> None:
    app = place.app(place.base(), labels={"io.rosml.addons": said, "io.rosml.stack": "cpu"})
    assert f"its label io.rosml.addons is damaged: {why}" in place.refused(app, place.base("tonight"))


def test_the_remedy_is_one_for_a_rebase(place: Place) -> None:
    app = place.app(place.base(), labels={"io.rosml.addons": "devel", "io.rosml.stack": "cpu"})
    with pytest.raises(RosmlError, match="stack cpu has no devel") as caught:
        place.rebase(app, place.base("tonight"))
    assert caught.value.remedy.startswith("name another --base; or build the app again: ")


def test_a_tag_that_moved_meanwhile_stays(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    rebaser, plan = place.plan(app, new)
    place.app(place.base("third"))  # somebody else pushes the same tag
    with rebaser, pytest.raises(RosmlError, match="has moved since it was read, and stays") as caught:
        rebaser.move(plan, rebaser.push(plan))
    assert caught.value.exit_code == 1 and place.digest(app) != plan.digest


def test_it_is_interrupted_at_any_request_that_writes(place: Place) -> None:
    """The old tag stands until the last one; the next call ends as an undisturbed one."""
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    before, expected = place.digest(app), place.digest(App(new).put(place.registry, "built"))
    content = dict(place.server.manifests), dict(place.server.blobs), {k: dict(v) for k, v in place.server.tags.items()}
    count = 0
    while True:
        place.server.manifests, place.server.blobs = dict(content[0]), dict(content[1])
        place.server.tags = {name: dict(tags) for name, tags in content[2].items()}
        rebaser, plan = place.plan(app, new, registry=Dying(place.server.address, count))
        try:
            with rebaser:
                rebaser.move(plan, rebaser.push(plan))
        except KeyboardInterrupt:
            assert place.digest(app) == before, "the old tag stands"
            assert place.rebase(app, new).digest == expected == place.digest(app)
            count += 1
        else:
            break
    assert count > 5


class Dying(Registry):
    """A client whose process ends at a write."""

    def __init__(self, host: str, left: int) -> None:
        super().__init__(host)
        self.left = left

    def _ask(self, method: str, *arguments: Any, **more: Any) -> Any:
        if method in ("PUT", "POST"):
            self.left -= 1
            if self.left < 0:
                raise KeyboardInterrupt
        return super()._ask(method, *arguments, **more)


# ---- Variants --------------------------------------------------------------------------------------------------------


def test_an_app_with_an_addon_alone_on_several_accelerators(place: Place) -> None:
    """Its base image has no stack, and stays; the add-on comes from each stack."""
    base = place.base()
    app = app_with_addon(place, base, addon(place, "tonight"))
    addon(place, "tonight", "cu128")
    with place.rebaser() as rebaser:
        found = variants.plans(rebaser, app, ["cpu", "cu128"])
    labels = [next(iter(plan.images.values())).labels for plan in found]
    assert [item["io.rosml.stack"] for item in labels] == ["cpu", "cu128", "cpu"]
    assert {item[image.VARIANTS] for item in labels} == {"cpu cu128:525"}
    assert {item[BASE_NAME] for item in labels} == {base}


def labels_of(place: Place, tag: str) -> dict[str, str]:
    found = place.registry.manifest("me/robot", tag)
    assert found and found.config
    return dict(place.registry.json_blob("me/robot", found.config.digest)["config"]["Labels"])


def test_an_app_on_several_accelerators(place: Place) -> None:
    cpu = on_stack(place, "cpu", BASE_FACTS)
    on_stack(place, "cu130", BASE_FACTS, "580")
    app = place.app(cpu)
    with place.rebaser() as rebaser:
        for plan in variants.plans(rebaser, app, ["cpu", "cu130"]):
            rebaser.move(plan, rebaser.push(plan))
    config = {}
    for tag in ("latest", "latest-cpu", "latest-cu130"):
        config[tag] = labels_of(place, tag)
        assert config[tag]["io.rosml.variants"] == "cpu cu130:580"
    assert [config[tag]["io.rosml.stack"] for tag in config] == ["cpu", "cpu", "cu130"]
    moved = place.rebase(f"{place.server.address}/me/robot:latest-cu130", on_stack(place, "cu132", BASE_FACTS))
    assert moved.moved, "and they follow their own base images"
    assert labels_of(place, "latest-cu130")["io.rosml.variants"] == "cpu cu130:580"
    place.rebase(app, on_stack(place, "cu132", BASE_FACTS), f"{place.server.address}/me/robot:candidate")
    assert "io.rosml.variants" not in labels_of(place, "candidate"), "nobody made candidate-cu130"


@pytest.mark.parametrize(
    ("stacks", "says"),
    [
        ([], "0 variants are named"),
        (["cpu"], "one variant is named"),
        (["cpu", "cu130", "cpu"], "cpu is named twice"),
        (["cpu", "cu13 0"], "'cu13 0' is no stack"),
        (["cpu", "cu999"], "there is no image"),
        (["cpu", "cu130"], "lib/node needs libcudart.so.12, which the base image lacks"),
    ],
)
def test_variants_are_refused(place: Place, stacks: list[str], says: str) -> None:
    cudart = changed(BASE_FACTS, libraries=[*BASE_FACTS["libraries"], library("usr/local/lib/libcudart.so.12")])
    cpu = on_stack(place, "cpu", cudart)
    on_stack(place, "cu130", BASE_FACTS, "580")
    uses = [library("docker-ros/ws/install/lib/node", needed=["libcudart.so.12"])]
    app = place.app(cpu, facts=changed(OWN, libraries=uses))
    with place.rebaser() as rebaser, pytest.raises(RosmlError) as caught:
        variants.plans(rebaser, app, stacks)
    assert says in caught.value.message and caught.value.exit_code == 2


def test_an_app_without_a_framework_has_no_variants(place: Place) -> None:
    with place.rebaser() as rebaser, pytest.raises(RosmlError, match="has no framework"):
        variants.plans(rebaser, place.app(place.base()), ["cpu", "cu130"])
