"""Apps and base images that are not as rosml makes them: nothing is lost in silence."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from fakes.rebasing import BOTH, App, Place, place
from rosml.base.errors import RosmlError
from rosml.containerize.rebase import trial
from rosml.containerize.rebase.image import as_buildkit
from rosml.delivery.pulled_layers import for_platform
from rosml.images.join.transfer import Transfer
from rosml.machine import exported
from rosml.machine.services import Services
from rosml.registry import oci, references

Change = Callable[[dict[str, Any]], object]


__all__ = ["place"]


def altered(place: Place, reference: str, config: Change = bool, manifest: Change = bool) -> str:
    """Puts an image for one platform again with another config or manifest, with what is attached to it; gives its reference. Of an
    index, its first image takes the tag."""
    where = references.parse(reference)
    image = place.image(where.repository, where.reference)
    assert image.config
    settings = place.registry.json_blob(where.repository, image.config.digest)
    config(settings)
    text = as_buildkit(settings)
    place.registry.put_blob(where.repository, text)
    content = {**image.content, "config": oci.descriptor(image.config.mediaType, text)}
    manifest(content)
    data = as_buildkit(content, indent=2)
    for entry in place.registry.referrers(where.repository, image.digest):
        artifact = place.manifest(where.repository, entry["digest"])
        part = place.registry.blob(where.repository, artifact.layers[0].digest)
        kind, subject = artifact.artifact_type, oci.descriptor(image.media_type, data)
        place.registry.attach(where.repository, subject, kind, part, artifact.layers[0].mediaType)
    place.server.checks = False
    place.registry.put_manifest(where.repository, where.reference, data, image.media_type)
    place.server.checks = True
    return reference


# ---- What nobody may lose --------------------------------------------------------------------------------------------


def test_a_tag_loses_no_platform(place: Place) -> None:
    base, new = place.base(), place.base("newer")
    app, other = place.app(base, platforms=BOTH), place.app(base, "other")
    text = place.refused(app, new, "", ["linux/arm64"])
    assert "is for linux/amd64, linux/arm64, and would be for linux/arm64 alone" in text
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
        (lambda it: it["config"]["Env"].append("MINE=1"), "MINE"),
        (lambda it: it["config"]["Labels"].update(mine="1"), "label mine"),
    ],
)
@pytest.mark.parametrize("is_gone", [False, True], ids=["", "base image gone"])
def test_what_others_set_in_an_app_is_not_lost(place: Place, change: Change, says: str, is_gone: bool) -> None:
    """`FROM robot` with `USER me`, or `crane mutate`: no layer of its own says so."""
    base, new = place.base(), place.base("newer")
    app = altered(place, place.app(base), change)
    if is_gone:
        place.registry.delete("rosml/ros", place.digest(base))
    assert says in place.refused(app, new)


# ---- Images that say something else ----------------------------------------------------------------------------------


def test_indexes_that_nobody_can_trust(place: Place) -> None:
    """Of another platform than the image's, of two images for a platform, and of more images than any real one."""
    base, new = place.base(), place.base("newer")
    for name in ("a", "b"):
        place.app(base, name, labels={"org.opencontainers.image.revision": name})
    many = [("a", f"a{number}") for number in range(5000)]
    assert "linux/arm64" in place.refused(place.index("odd", ("a", "arm64")), new)
    assert "two images for linux/amd64" in place.refused(place.index("twice", ("a", "amd64"), ("b", "amd64")), new)
    assert "is an index of 5,000 images" in place.refused(place.index("many", *many), new)


@pytest.mark.parametrize(
    "change", [lambda it: it["rootfs"].update(diff_ids=it["rootfs"]["diff_ids"] * 2), lambda it: it.pop("history")]
)
def test_a_base_image_whose_config_is_damaged(place: Place, change: Change) -> None:
    app = place.app(place.base())
    assert "does not say what its layers are" in place.refused(app, altered(place, place.base("newer"), change))


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
    new = altered(place, place.base("newer"), manifest=lambda it: it["layers"][0].update(mediaType=kind))
    assert kind in place.refused(app, new)
    app = altered(place, app, manifest=lambda it: it["layers"][-1].update(mediaType=kind, urls=["http://x"]))
    assert kind in place.refused(app, place.base("third"))


def test_a_command_that_is_no_list(place: Place) -> None:
    app = altered(place, place.app(place.base()), lambda it: it["config"].update(Cmd="bash"))
    before = place.digest(app)
    with pytest.raises(RosmlError, match=r"its config is damaged: config\.Cmd"):
        place.rebase(app, place.base("newer"))
    assert place.digest(app) == before


def test_a_base_image_until_now_that_nobody_reaches(place: Place) -> None:
    """Such as one in the registry of the machine that built the app."""
    app = place.app(place.base(), labels={"org.opencontainers.image.base.name": "127.0.0.1:9/rosml/ros:core"})
    rebased = place.rebase(app, place.base("newer"))
    assert rebased.moved and rebased.verdict == "check by link"
    assert any("127.0.0.1:9" in line for line in place.messages)


def test_attestations_in_an_index_are_not_taken_over_in_silence(place: Place) -> None:
    base, new = place.base(), place.base("newer")
    app = App(base).put(place.registry, "latest", index=True)
    digest = place.registry.put_manifest("me/robot", "", {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []})
    unknown = {"architecture": "unknown", "os": "unknown"}
    content = place.manifest("me/robot", "latest").content
    entry = {"mediaType": oci.IMAGE, "digest": digest, "size": 80, "platform": unknown}
    place.registry.put_manifest(
        "me/robot", "latest", {**content, "manifests": [*content["manifests"], entry]}, oci.INDEX
    )
    assert place.rebase(app, new).digest == place.digest(App(new).put(place.registry, "built", index=True))
    says = "attestations in its index are of the old image, and stay there (1)"
    assert any(says in line for line in place.messages)


@pytest.mark.parametrize("how", ["tag", "artifact", ""])
def test_a_signature_is_of_the_former_image(place: Place, how: str) -> None:
    app, new = place.app(place.base()), place.base("newer")
    image = place.manifest("me/robot", "latest")
    if how == "tag":
        place.registry.tag("me/robot", image.digest, f"{image.digest.replace(':', '-')}.sig")
    elif how:
        kind = "application/vnd.dev.sigstore.bundle.v0.3+json"
        place.registry.attach("me/robot", image.descriptor, kind, b"{}", kind)
    digest = place.rebase(app, new).digest
    says = f"{app} is signed, and the new image is not: sign {place.server.address}/me/robot@{digest}"
    assert (says in place.messages) == bool(how)


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
    name, images = f"localhost:5000/{'a' * 300}:latest", {"linux/amd64": trial.Pair("a", "b")}
    with ThreadPoolExecutor(3) as pool:
        trials = [pool.submit(lambda: trial.Trial(services, name).link(images)) for _ in range(3)]
        assert [item.result() for item in trials] == [None] * 3
    assert most == [1]


def test_an_app_as_base_image_is_the_one_cause(place: Place) -> None:
    base = place.base()
    app, other = place.app(base), App(base, name="other").put(place.registry, "latest", index=True)
    assert "is the app itself" in place.refused(other, other)
    other = place.app(base, name="other")
    place.rebase(other, place.base("newer"))  # now it has a list of its files, as a build gives it
    with pytest.raises(RosmlError) as caught:
        place.plan(app, other)
    assert f"{other} is an app itself, and has files of {app}: /" in caught.value.message
    assert "\n" not in caught.value.message and caught.value.remedy.startswith("name the image below it: --base ")


def test_a_base_image_that_is_an_app_of_the_local_registry(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its name without a registry could be one of Docker Hub: the remedy says how to write it."""
    address = place.server.address
    app = place.app(place.base())
    monkeypatch.setattr(references, "complete", lambda text: text if text[:3] == "127" else f"{address}/hub/{text}")
    for text, remedy in (
        ("me/robot:latest", f"has to be named in full: {address}/me/robot:latest"),
        (f"{address}/rosml/ros:cord", "did you mean 'core'? 'rosml list' has"),
        (f"{address}/rosml/ros:x", "known: core. 'rosml list' has"),
    ):
        with pytest.raises(RosmlError) as caught:
            place.plan(app, text)
        assert remedy in caught.value.remedy, text
        assert text in caught.value.message and caught.value.message.count("ros:") <= 1, "a name stands once"


def test_a_wrong_tag_names_tags_that_are_there(place: Place) -> None:
    base = place.base()
    for number in range(20):
        place.registry.tag("rosml/ros", place.digest(base), f"{number}-night")
    with place.rebaser() as rebaser, Transfer(rebaser.registries) as transfer:
        for name, remedy in (("rosml/ros:zzz", "its tags are "), ("no/x:y", "has no tags")):
            with pytest.raises(RosmlError) as caught:
                transfer.platforms(f"{place.server.address}/{name}")
            assert remedy in caught.value.remedy
        with pytest.raises(RosmlError) as caught:
            for_platform(transfer, base, "linux/riscv64")
        assert caught.value.remedy == "name one that it has: --platform linux/amd64"
