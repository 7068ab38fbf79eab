"""Builders that are not our own: Docker's own BuildKit, and remote ones."""

from __future__ import annotations

import json
import re
import shutil
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from rosml import ROOT, user_cache
from rosml.images.records.store import Records
from rosml.machine.services import Services
from rosml.machine.setup import fitness
from rosml.registry import references
from tests.e2e import engine, images, mini, person
from tests.e2e.builders import builder
from tests.e2e.calls import run
from tests.e2e.images import NATIVE

BUILDER = "default (Docker's own) answers"
INSTALLED = "/docker-ros/ws/install/"
CURRENT = "no current Docker is here: 'rosml setup engine' builds one"


@pytest.fixture(scope="module")
def docker() -> Iterator[engine.Engine]:
    if engine.version({}) < engine.ZSTD and not (engine.CURRENT / "dockerd").exists():
        pytest.skip(CURRENT)
    with engine.running(bridge="rosml-e2e") as docker:
        yield docker


def test_setup_takes_it(docker: engine.Engine, services: Services, checkout: Path) -> None:
    use = {**docker.variables(), "ROSML_UV": services.uv, "ROSML_DOCKER_HUB": "0"}
    setup = [sys.executable, str(checkout / "src"), "setup"]
    state = checkout / ".state"
    for link in state.iterdir():  # it gets a state of its own
        link.unlink()
    for name in ("log", "run", "bin"):
        (state / name).mkdir()
    try:
        done = run(*setup, "up", env=use)
        assert done.code == 0, done.out + done.err
        assert "builder: your Docker's own, 'default'" in done.out and "buildkitd" not in done.out
        facts = json.loads((state / "services.json").read_text())
        assert (facts["builder_kind"], facts["no_engine"]) == ("engine", "")
    finally:
        run(*setup, "down", env=use)


def test_it_makes_the_same_images(docker: engine.Engine, beside: Services, tmp_path: Path) -> None:
    """Layers, labels and all: a digest says so. Nothing stays in Docker, and no tag in the registry that a build needed."""
    ours, before = mini.make(tmp_path, beside), docker.docker("image", "ls", "--quiet").out
    digests = built(ours, {})
    theirs = ours.elsewhere()
    mini.use(ours.folder, builder="default", builder_kind="engine", buildx_config=None)
    assert built(theirs, docker.variables()) == digests
    assert {*mini.PARTS, "ros1-bookworm-core", "ros1-bookworm-base"} <= {name.removeprefix("part-") for name in digests}
    assert docker.docker("image", "ls", "--quiet").out == before
    assert not [tag for tag in theirs.tags() if "building" in tag]


@pytest.mark.full(proof="docker")
def test_it_is_all_that_a_user_needs(docker: engine.Engine, services: Services) -> None:
    """The README's first image, started, built on, worked on and moved, by a user without root, Go and tools of ours."""
    with person.somebody(docker) as user:
        checkout = clone(user, services)

        def call(*command: str) -> str:
            done = user.other(*command, place=checkout, timeout=1800)
            assert done.code == 0, (done.out + done.err)[-5000:]
            return done.out

        def image(target: str) -> str:
            (reference,) = re.findall(r"^FROM +(\S+)$", call("make", "image", f"TARGET={target}"), re.MULTILINE)
            return str(reference)

        def compass(image: str) -> str:
            return call("docker", "run", "--rm", image, "rospack", "find", "compass")

        try:
            core = image("ros1-bookworm-core")
            assert BUILDER in call("./rosml", "doctor")
            program = "import os, rospy; print(os.environ['ROS_DISTRO'])"
            assert call("docker", "run", "--rm", core, "python3", "-c", program) == "Debian\n"
            assert call("./rosml", "run", "--trust", core, "id", "-u") == f"{user.uid}\n"

            call("./rosml", "containerize", "examples/ros1")
            assert compass("compass").startswith(INSTALLED)
            assert call("docker", "run", "--rm", "compass:latest-dev", "gcc", "--version").startswith("gcc")
            dev = ("./rosml", "dev", "examples/ros1", "--", "sh", "-c")
            assert "1 package finished" in call(*dev, "colcon build && colcon test")

            app = f"{core.partition('/')[0]}/robot"
            call("./rosml", "containerize", "--push", "--image-name", app, "examples/ros1")
            call("./rosml", "rebase", app, "--base", image("ros1-bookworm-base"))
            call("docker", "pull", "--quiet", app)
            assert compass(app).startswith(INSTALLED)
            assert call("docker", "run", "--rm", app, "dpkg", "--status", "libnodeletlib-tools")
        finally:
            user.other("make", "clean", place=checkout)


def clone(user: person.Person, services: Services) -> Path:
    """A checkout of theirs, and buildx as a plugin. Without Docker Hub, they have its image of Debian from our registry, and the
    registry's program, which their Docker would build."""
    checkout, plugins, tools = (
        user.folder / "rosml",
        user.folder / ".docker/cli-plugins",
        user.folder / ".cache/rosml/tools",
    )
    assert run("git", "clone", "--quiet", str(ROOT), str(checkout)).code == 0
    for folder in (plugins, tools):
        folder.mkdir(parents=True)
    if len(services.buildx) == 1:
        shutil.copy(services.buildx[0], plugins / "docker-buildx")
    for program in (user_cache() / "tools").glob("registry-*"):
        shutil.copy(program, tools)
    client = Path(str(shutil.which("docker", path=user.environment.get("PATH")))).parent
    if services.bases:
        place = references.parse(references.complete(images.system(services, "bookworm")))
        user.environment["OS_BOOKWORM"] = str(place._replace(host=services.registry))
    user.environment["PATH"] = f"{client}:/usr/bin:/bin"
    if user.become:
        run("chown", "--recursive", f"{user.uid}:{user.uid}", str(user.folder))
    return checkout


def built(project: mini.Mini, env: dict[str, str]) -> dict[str, str]:
    """The digests of all ROS images and parts of a project, which are built now, by target."""
    plan = str(project.folder / "plan.json")
    assert project.publish("plan", "--output", plan, env=env).code == 0
    shards = [it["name"] for it in json.loads(Path(plan).read_text())["shards"] if it["architecture"] == NATIVE]
    for shard in shards:
        done = project.publish("build", "--plan", plan, "--shard", shard, env=env)
        assert done.code == 0, done.err
    book = Records(project.place())
    names = [name for name in book.registry.tags(book.repository) if name.endswith(f".{NATIVE}")]
    entries = {name: book.read(*name.rpartition(".")[::2]) for name in names}
    return {entry.target: entry.digest for entry in entries.values() if entry}


def test_two_remote_buildkitds(own_builders: None, services: Services, tmp_path: Path) -> None:
    """Setup tries the builder that BUILDX_BUILDER names, and builds as long as one of its nodes does."""
    env = services.environment()
    with builder("remote-one", tmp_path / "1", services) as one, builder("remote-two", tmp_path / "2", services) as two:
        append = ["create", "--name", one.name, "--append", "--driver", "remote", f"unix://{two.folder}/buildkitd.sock"]
        assert run(*services.buildx, *append, env=env).code == 0
        remote = replace(services, builder=one.name, builder_kind="user")
        for node in (two, one):
            fitness.require(remote)
            node.process.terminate()
            node.process.wait()
        with pytest.raises(fitness.Unfit, match="is inactive"):
            fitness.require(remote)
