"""Builders that are not our own: Docker's own BuildKit, and remote ones."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from rosml.images.records.store import Records
from rosml.machine.services import Services
from rosml.machine.setup import fitness
from tests.e2e import engine, mini
from tests.e2e.builders import builder
from tests.e2e.calls import run
from tests.e2e.images import NATIVE

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
    ours = mini.make(tmp_path, beside)
    digests = built(ours, {})
    theirs = ours.elsewhere()
    mini.use(ours.folder, builder="default", builder_kind="engine", buildx_config=None)
    assert built(theirs, docker.variables()) == digests
    assert {*mini.PARTS, "ros1-bookworm-core", "ros1-bookworm-base"} <= {name.removeprefix("part-") for name in digests}
    assert docker.docker("image", "ls", "--quiet").out == ""
    assert not [tag for tag in theirs.tags() if "building" in tag]


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
