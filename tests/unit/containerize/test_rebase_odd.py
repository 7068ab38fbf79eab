"""Apps and base images that are not as rosml makes them, and calls that are not as people mean them: nothing is lost in silence."""

from __future__ import annotations

import gzip
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.rebasing import BASE_FACTS, BOTH, App, Place, changed, moving, package
from rosml.base.errors import RosmlError
from rosml.containerize.rebase import trial
from rosml.containerize.rebase.image import as_buildkit
from rosml.delivery.delta import for_platform
from rosml.images.join import file_lists
from rosml.images.join.transfer import Transfer
from rosml.machine import exported
from rosml.machine.services import Services
from rosml.registry import oci, references
from tests.e2e.parts import ros


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as found:
        yield found


def altered(
    place: Place,
    reference: str,
    config: Callable[[dict[str, Any]], object] = lambda _: None,
    manifest: Callable[[dict[str, Any]], object] = lambda _: None,
) -> str:
    """Puts an image for one platform again with another config or manifest, with what is attached to it; gives its reference."""
    where = references.parse(reference)
    found = place.registry.manifest(where.repository, where.reference)
    assert found and found.config
    content, said = found.content, place.registry.json_blob(where.repository, found.config.digest)
    config(said)
    text = as_buildkit(said)
    place.registry.put_blob(where.repository, text)
    content = {**content, "config": oci.descriptor(found.config.mediaType, text)}
    manifest(content)
    data = as_buildkit(content, indent=2)
    for entry in place.registry.referrers(where.repository, found.digest):
        artifact = place.registry.manifest(where.repository, entry["digest"])
        assert artifact
        part = place.registry.blob(where.repository, artifact.layers[0].digest)
        kind, subject = artifact.artifact_type, oci.descriptor(found.media_type, data)
        place.registry.attach(where.repository, subject, kind, part, artifact.layers[0].mediaType)
    place.server.checks = False
    place.registry.put_manifest(where.repository, where.reference, data, found.media_type)
    place.server.checks = True
    return reference


def single(place: Place, index: str) -> str:
    """The first image of an index, under the same tag."""
    where = references.parse(index)
    found = place.registry.manifest(where.repository, where.reference)
    assert found
    place.registry.tag(where.repository, found.members[0].digest, where.reference)
    return index


# ---- What nobody may lose --------------------------------------------------------------------------------------------


def test_a_tag_loses_no_platform(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old, platforms=BOTH)
    text = place.refused(app, new, "", ["linux/arm64"])
    assert "is for linux/amd64, linux/arm64, and would be for linux/arm64 alone" in text
    other = place.app(old, "other")
    assert "would be for linux/amd64 alone" in place.refused(other, new, app)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda it: it["history"].append({"created_by": "USER me", "empty_layer": True}), "USER me"),
        (lambda it: it["history"].append({"created_by": 'ENTRYPOINT ["/x"]', "empty_layer": True}), "ENTRYPOINT"),
        (lambda it: it["config"].update(User="me"), "User"),
        (lambda it: it["config"].update(OnBuild=["RUN x"]), "ONBUILD"),
        (lambda it: it["config"].update(Healthcheck={"Test": ["CMD", "true"]}), "Healthcheck"),
        (lambda it: it["config"].update(Entrypoint=["/mine"]), "Entrypoint"),
        (lambda it: it["config"].update(ExposedPorts={"80/tcp": {}}), "ExposedPorts"),
        (lambda it: it["config"]["Env"].append("MINE=1"), "MINE"),
        (lambda it: it["config"]["Labels"].update(mine="1"), "label mine"),
    ],
)
@pytest.mark.parametrize("is_gone", [False, True], ids=["", "base image gone"])
def test_what_others_set_in_an_app_is_not_lost(
    place: Place, change: Callable[[dict[str, Any]], object], says: str, is_gone: bool
) -> None:
    """`FROM robot` with `USER me`, or `crane mutate`: no layer of its own says so."""
    old, new = place.base(), place.base("newer")
    app = altered(place, place.app(old), change)
    if is_gone:
        place.registry.delete("rosml/ros", place.digest(old))
    assert says in place.refused(app, new)


def test_lists_of_many_parts_hide_no_file(place: Place) -> None:
    """Of an app on an image with a framework: its own list, and those of the ROS image and of each part."""
    texts = [gzip.compress(f"file-{number}\n".encode(), mtime=0) for number in range(7)]
    where = "rosml/ros"
    place.base()
    found = place.registry.manifest(where, "core")
    assert found
    for data in texts:
        place.registry.put_blob(where, data)
    more = [oci.descriptor(file_lists.MEDIA_TYPE, data) for data in texts[1:]]
    member = found.members[1]
    subject = {"mediaType": member.mediaType, "digest": member.digest, "size": member.size}
    place.registry.attach(where, subject, file_lists.ARTIFACT, texts[0], file_lists.MEDIA_TYPE, more=more)
    listed = file_lists.Lists().of(place.registry, where, member.digest)
    assert listed and {f"file-{number}" for number in range(7)} <= listed.entries


def test_python_that_a_base_image_no_longer_has(place: Place) -> None:
    had = changed(BASE_FACTS, packages=[*BASE_FACTS["packages"], package("python3-opencv", "4.6")])
    app = place.app(place.base(said=had))
    _, plan = place.plan(app, place.base("newer"))
    assert plan.judgement.words == "check by link"
    assert "python3-opencv" in plan.judgement.undecided[0]


def test_a_framework_that_a_base_image_no_longer_has(place: Place) -> None:
    said = {**ros().labels, "io.rosml.framework": "torch", "io.rosml.torch": "2.14.0"}
    made = replace(ros(salt="torch"), labels=said)
    app = place.app(made.put(place.registry, "rosml/ros", "torch", BOTH[:1]))
    _, plan = place.plan(app, place.base("newer"))
    assert "this base image has no torch; the app's Python may use it" in plan.judgement.undecided


# ---- Images that say something else ----------------------------------------------------------------------------------


def test_an_index_that_says_another_platform_than_its_image(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    found = place.registry.manifest("me/robot", "latest")
    assert found
    entry = {**found.descriptor, "platform": {"os": "linux", "architecture": "arm64"}}
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [entry]}
    place.registry.put_manifest("me/robot", "latest", content, oci.INDEX)
    assert "linux/arm64" in place.refused(app, new)


def test_two_images_for_one_platform(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    entries = []
    for name in ("a", "b"):
        place.app(old, name, labels={"org.opencontainers.image.revision": name})
        found = place.registry.manifest("me/robot", name)
        assert found
        entries.append({**found.descriptor, "platform": {"os": "linux", "architecture": "amd64"}})
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
    place.registry.put_manifest("me/robot", "latest", content, oci.INDEX)
    assert "two images for linux/amd64" in place.refused(f"{place.server.address}/me/robot:latest", new)


@pytest.mark.parametrize("broken", ["diff_ids", "history"])
def test_a_base_image_whose_config_is_damaged(place: Place, broken: str) -> None:
    app = place.app(place.base())

    def change(it: dict[str, Any]) -> None:
        if broken == "history":
            it.pop("history")
        else:
            it["rootfs"]["diff_ids"] *= 2

    new = altered(place, single(place, place.base("newer")), change)
    assert "does not say what its layers are" in place.refused(app, new)


@pytest.mark.parametrize(
    "kind",
    [
        "application/vnd.oci.image.layer.v1.tar+gzip+encrypted",
        "application/vnd.docker.image.rootfs.foreign.diff.tar.gzip",
        "application/x-squashfs",
    ],
)
def test_layers_that_nobody_can_take_over(place: Place, kind: str) -> None:
    app = place.app(place.base())
    new = altered(place, single(place, place.base("newer")), manifest=lambda it: it["layers"][0].update(mediaType=kind))
    assert kind in place.refused(app, new)
    own = altered(place, app, manifest=lambda it: it["layers"][-1].update(mediaType=kind, urls=["http://x"]))
    assert kind in place.refused(own, place.base("third"))


def test_facts_without_libraries_prove_nothing(place: Place) -> None:
    app = place.app(place.base())
    text = place.refused(app, place.base("newer", changed(BASE_FACTS, libraries=[])))
    assert "librclcpp.so" in text


@pytest.mark.parametrize(
    ("files", "says"),
    [
        (("usr/bin/env", "usr/lib/python3"), "/usr/lib/python3"),
        (("usr/bin/env", "usr/lib/python3/angles.py/x"), "/usr/lib/python3/angles.py"),
    ],
)
def test_a_folder_in_place_of_a_file(place: Place, files: tuple[str, ...], says: str) -> None:
    assert f"{says}" in place.refused(place.app(place.base()), place.base("newer", files=files))


def test_an_app_on_itself(place: Place) -> None:
    app = App(place.base()).put(place.registry, "latest", index=True)
    assert "is the app itself" in place.refused(app, app)


def test_a_command_that_is_no_list(place: Place) -> None:
    app = altered(place, place.app(place.base()), lambda it: it["config"].update(Cmd="bash"))
    before = place.digest(app)
    with pytest.raises(RosmlError, match=r"its config is damaged: config\.Cmd"):
        place.rebase(app, place.base("newer"))
    assert place.digest(app) == before


def test_an_old_base_image_that_nobody_reaches(place: Place) -> None:
    """Such as one in the registry of the machine that built the app."""
    old, new = place.base(), place.base("newer")
    app = place.app(old, labels={"org.opencontainers.image.base.name": "127.0.0.1:9/rosml/ros:core"})
    found = place.rebase(app, new)
    assert found.moved and found.verdict == "check by link"
    assert any("127.0.0.1:9" in line for line in place.said)


def test_attestations_in_an_index_are_not_taken_over_in_silence(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = App(old).put(place.registry, "latest", index=True)
    found = place.registry.manifest("me/robot", "latest")
    assert found
    other = place.registry.put_manifest("me/robot", "", {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []})
    entry = {
        "mediaType": oci.IMAGE,
        "digest": other,
        "size": 80,
        "platform": {"os": "unknown", "architecture": "unknown"},
    }
    content = {**found.content, "manifests": [*found.content["manifests"], entry]}
    place.registry.put_manifest("me/robot", "latest", content, oci.INDEX)
    moved = place.rebase(app, new)
    assert moved.digest == place.digest(App(new).put(place.registry, "built", index=True))
    assert any("attestations in its index are of the old image, and stay there (1)" in line for line in place.said)


def test_an_index_of_more_images_than_any_real_one(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    place.app(old)
    found = place.registry.manifest("me/robot", "latest")
    assert found
    entries = [
        {**found.descriptor, "platform": {"os": "linux", "architecture": f"a{number}"}} for number in range(5000)
    ]
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
    place.registry.put_manifest("me/robot", "latest", content, oci.INDEX)
    assert "is an index of 5,000 images" in place.refused(f"{place.server.address}/me/robot:latest", new)


@pytest.mark.parametrize("how", ["tag", "artifact", ""])
def test_a_signature_is_of_the_old_image(place: Place, how: str) -> None:
    app, new = place.app(place.base()), place.base("newer")
    found = place.registry.manifest("me/robot", "latest")
    assert found
    if how == "tag":
        place.registry.tag("me/robot", found.digest, f"{found.digest.replace(':', '-')}.sig")
    elif how:
        kind = "application/vnd.dev.sigstore.bundle.v0.3+json"
        place.registry.attach("me/robot", found.descriptor, kind, b"{}", kind)
    moved = place.rebase(app, new)
    said = f"{app} is signed, and the new image is not: sign {place.server.address}/me/robot@{moved.digest}"
    assert (said in place.said) == bool(how)


def test_two_trials_of_an_app_take_turns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """They leave their lines in the same place; and an app's name may be longer than one of a file."""
    services = Services.load(tmp_path, required=False)
    running, most = [0.0], [0.0]

    def build(*_: object) -> None:
        running[0] += 1
        most[0] = max(most[0], running[0])
        time.sleep(0.1)

    def read(*_: object) -> bytes:
        running[0] -= 0.5  # it is called twice
        return b""

    monkeypatch.setattr(trial.Trial, "_build", build)
    monkeypatch.setattr(exported, "unpack", lambda *_: None)
    monkeypatch.setattr(exported, "read", read)
    name = f"localhost:5000/{'a' * 300}:latest"
    with ThreadPoolExecutor(3) as pool:
        work = [
            pool.submit(lambda: trial.Trial(services, name).link({"linux/amd64": trial.Pair("a", "b")}))
            for _ in range(3)
        ]
        assert [item.result() for item in work] == [None] * 3
    assert most == [1]


def test_an_app_as_base_image_is_the_one_cause(place: Place) -> None:
    base = place.base()
    app, other = place.app(base), place.app(base, name="other")
    place.rebase(other, place.base("newer"))  # now it has a list of its files, as a build gives it
    with pytest.raises(RosmlError) as caught:
        place.plan(app, other)
    assert f"{other} is an app itself, and has files of {app}: /" in caught.value.message
    assert "\n" not in caught.value.message and caught.value.remedy.startswith("name the image below it: --base ")


def test_a_base_image_that_is_an_app_of_the_local_registry(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its name without a registry could be one of Docker Hub: the remedy says how to write it."""
    place.services = replace(place.services, registry=place.server.address)
    app = place.app(place.base())
    monkeypatch.setattr(
        references, "complete", lambda text: text if text[:3] == "127" else f"{place.server.address}/hub/{text}"
    )
    for text, says in (
        ("me/robot:latest", f"has to be named in full: {place.server.address}/me/robot:latest"),
        (f"{place.server.address}/rosml/ros:cord", "did you mean 'core'? 'rosml list' has"),
        (f"{place.server.address}/rosml/ros:x", "known: core. 'rosml list' has"),
    ):
        with pytest.raises(RosmlError) as caught:
            place.plan(app, text)
        assert says in caught.value.remedy, text
        assert text in caught.value.message and caught.value.message.count("ros:") <= 1, "a name stands once"


def test_a_wrong_tag_names_tags_that_are_there(place: Place) -> None:
    base = place.base()
    for number in range(20):
        place.registry.tag("rosml/ros", place.digest(base), f"{number}-night")
    with place.rebaser() as rebaser, Transfer(rebaser.registries) as transfer:
        for name, says in (
            (f"{place.server.address}/rosml/ros:zzz", "its tags are "),
            (f"{place.server.address}/no/x:y", "has no tags"),
        ):
            with pytest.raises(RosmlError) as caught:
                transfer.platforms(name)
            assert says in caught.value.remedy
        with pytest.raises(RosmlError) as caught:
            for_platform(transfer, base, "linux/riscv64")
        assert caught.value.remedy == "name one that it has: --platform linux/amd64"
