"""Two nights against a registry that does, over HTTP, what ghcr.io does or may do: it denies what does not exist yet, has no
referrers, deletes nothing, forgets tokens, has no time, and learns of blobs a moment late. Never run against ghcr.io itself."""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, cast

import pytest
from conftest import SMALLER

from fakes.http_registry import DENIED, LocalRegistry, local_registry
from fakes.memory_registry import DAY, NEXT, PREFIX, Publisher, Run, publisher
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.cli.images import publish
from rosml.images.image_set.model import ImageSet
from rosml.images.publish.plan import make_plan
from rosml.images.publish.steps import STEPS
from rosml.registry import retries
from rosml.registry.client import Registry
from rosml.registry.credentials import Credentials
from rosml.registry.place import Place

NAME, SECRET = "somebody", "s3cret-Pass"
UNKNOWN = b'{"errors": [{"code": "MANIFEST_BLOB_UNKNOWN", "message": "blob unknown to registry"}]}'


@pytest.fixture(params=["registry", "token"])
def ghcr(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[LocalRegistry]:
    """The registry, and who denies what does not exist yet."""
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.02)
    with local_registry() as pages, local_registry() as server:
        server.hides, server.users, server.bearer, server.scoped = request.param, {NAME: SECRET}, True, True
        server.expires, server.deletes, server.people = 3.0, False, f"http://{pages.address}/me"
        yield server
        assert pages.requests == [], "nobody asks a page for people"


class Night:
    """The jobs of a night, each a machine of its own, which shares nothing with the others but the registry."""

    def __init__(self, server: LocalRegistry, image_set: ImageSet, here: Publisher, date: str, *only: str) -> None:
        self.server, self.image_set, self.here, self.date, self.only = server, image_set, here, date, only

    def job(self, *steps: str, architectures: tuple[str, ...] = ("amd64", "arm64")) -> list[Run]:
        """Steps of a job: a process, with a client, for each."""
        runs = []
        for step in steps:
            with Registry(self.server.address, credentials=lambda _: Credentials(NAME, SECRET)) as client:
                where = Publisher(self.here.services, cast(Any, client), self.here.packages)
                run = where.run(self.image_set, self.date, only=self.only, architectures=architectures)
                if step != "plan":
                    STEPS[step](run)
                runs.append(run)
        return runs

    def whole(self) -> list[Run]:
        """All jobs, as the workflow has them; those of the architectures at the same time."""
        runs = self.job("plan")
        runs += self.on_each("build")
        runs += self.job("join")
        runs += self.on_each("test")
        return runs + self.job("index", "promote")

    def on_each(self, step: str) -> list[Run]:
        """A step on a machine of each architecture."""
        with ThreadPoolExecutor(2) as pool:
            shards = [pool.submit(self.job, step, architectures=(name,)) for name in ("amd64", "arm64")]
        return [run for shard in shards for run in shard.result()]


def tags(server: LocalRegistry) -> dict[str, dict[str, str]]:
    """Where tags point, without the lists of what is attached."""
    return {
        repository: {name: digest for name, digest in names.items() if not name.startswith("sha256-")}
        for repository, names in server.tags.items()
    }


def test_two_nights(ghcr: LocalRegistry, image_set: ImageSet, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    here = publisher(project, services(project), monkeypatch)
    later = {"Retry-After": "1"}
    elsewhere = {"Location": "http://127.0.0.1:1/elsewhere"}
    ghcr.fault("POST", "/uploads/", 403, 1000, each=3, body=DENIED)  # somebody makes the repository just now
    ghcr.fault("PUT", r"/uploads/\d*5\?", 404, 1000)
    ghcr.fault("PUT", "/manifests/", 404, 1000, each=2, body=UNKNOWN)  # a part of the registry knows no blobs yet
    ghcr.fault("GET", "/manifests/", 429, 1000, each=1, headers=later)
    ghcr.fault("HEAD", "/manifests/", 307, 1000, each=1, headers=elsewhere)
    ghcr.fault("GET", "/token", 503, 1000, each=1)
    first = Night(ghcr, image_set, here, DAY).whole()
    assert [outcome for run in first for outcome in run.outcomes if outcome.state == "failed"] == []
    assert all(fault.times < 1000 for fault in ghcr.faults), "something did not go wrong"
    assert ghcr.count("/referrers/") <= len(first), "each process asks once"
    published = tags(ghcr)
    assert published[f"{PREFIX}/ros"].keys() >= {"alpha-core", "alpha-core-20261122", "alpha", "latest", "omega-base"}
    assert published[f"{PREFIX}/ros-torch"].keys() >= {"alpha-base-cu1", "alpha-base-cu1-torch2.10.0", "latest"}
    with Registry(ghcr.address, credentials=lambda _: Credentials(NAME, SECRET)) as client:
        whole = Publisher(here.services, cast(Any, client))
        monkeypatch.setattr(whole, "tagged", lambda repository: published[f"{PREFIX}/{repository}"])
        whole.check(image_set)
    before = ghcr.count("^(PUT|POST|DELETE)")
    second = Night(ghcr, image_set, here, NEXT).whole()
    assert [outcome for run in second for outcome in run.outcomes if outcome.state != "waits"] == []
    assert [run.actions for run in second if run.actions] == []
    assert (tags(ghcr), ghcr.count("^(PUT|POST|DELETE)")) == (published, before)


Make = Callable[[], tuple[int, dict[str, Any]]]


@pytest.fixture
def make(
    ghcr: LocalRegistry,
    image_set: ImageSet,
    project: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> Iterator[Make]:
    """Calls the command that makes the repositories which a plan writes into: its exit code, and what it prints."""
    here = publisher(project, services(project), monkeypatch)
    (run,) = Night(ghcr, image_set, here, DAY, "alpha-core", "alpha-base-torch-cu1").job("plan")
    (project / "plan.json").write_text(make_plan(run.state, 4).text())
    (project / "matrix.yaml").write_text(SMALLER)
    ghcr.requests.clear()
    with Registry(ghcr.address, credentials=lambda _: Credentials(NAME, SECRET)) as client:
        monkeypatch.setattr(publish, "place_of", lambda *_: Place(client, PREFIX))
        monkeypatch.setattr(Registry, "close", lambda _: None)
        arguments = ["--plan", f"{project}/plan.json", "--matrix", f"{project}/matrix.yaml", "--json"]

        def call() -> tuple[int, dict[str, Any]]:
            with pytest.raises(SystemExit) as ended:
                publish.main(["repositories", *arguments], standalone_mode=False)
            return int(ended.value.code or 0), json.loads(capsys.readouterr().out)

        yield call


REPOSITORIES = ["records", "ros", "part", "ros-torch", "rosdep"]


def test_repositories_are_made_before_machines_push_at_once(ghcr: LocalRegistry, make: Make) -> None:
    ghcr.fault("POST", "/uploads/", 403, 1000, each=3, body=DENIED)
    assert make() == (0, {"made": REPOSITORIES, "failed": {}})
    repositories = [
        repositories[1] for request in ghcr.requests if (repositories := re.search(rf"/v2/{PREFIX}/([^/]+)/", request))
    ]
    assert [name for name, _ in itertools.groupby(repositories)] == REPOSITORIES
    assert all(ghcr.exists(f"{PREFIX}/{name}") for name in REPOSITORIES) and not any(ghcr.tags.values())
    before = ghcr.count("^(PUT|POST)")
    assert make() == (0, {"made": [], "failed": {}}) and ghcr.count("^(PUT|POST)") == before


def test_a_repository_that_cannot_be_made_holds_up_no_other(ghcr: LocalRegistry, make: Make) -> None:
    ghcr.fault("POST", "/records/blobs/uploads/", 403, 1000, body=DENIED)
    code, printed = make()
    assert (code, printed["made"]) == (1, REPOSITORIES[1:])
    assert "access denied: cannot push to rosml/records" in printed["failed"]["records"]


def test_a_tag_that_is_denied_to_a_reader_does_not_move(
    ghcr: LocalRegistry, image_set: ImageSet, project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = publisher(project, services(project), monkeypatch)
    Night(ghcr, image_set, here, NEXT, "alpha-core").whole()
    published = tags(ghcr)
    here.packages["alpha"] = "tuesday"
    older = Night(ghcr, image_set, here, DAY, "alpha-core")
    older.job("build", "join", "test", "index")
    ghcr.fault("HEAD", f"/{PREFIX}/ros/manifests/alpha-core$", 403, 1000, body=DENIED)
    with pytest.raises(RosmlError, match="access denied: cannot pull from rosml/ros with the account"):
        older.job("promote")
    assert tags(ghcr)[f"{PREFIX}/ros"] == published[f"{PREFIX}/ros"]
