"""Whatever a user selects, of what there is or nearly is: every command ends as documented, and never in a traceback."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import click
import pytest
from conftest import ROOT
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from fakes import memory_registry, stubs
from fakes.http_registry import LocalRegistry, local_registry
from fakes.memory_registry import DAY, NEXT, MemoryRegistry
from rosml.cli import command, main
from rosml.cli.images import call, catalogue, generate, image, locks, part, publish
from rosml.cli.machine import setup
from rosml.images.builds import base_images, package_state
from rosml.images.image_set import load
from rosml.images.publish.steps.build import build
from rosml.machine.services import Services
from rosml.registry import oci, retries

REAL = load.load(ROOT / "matrix.yaml")
PUBLISHED = "ros1-bookworm-core*"

CODES = {0, 1, 2, 3, 4}
"""Exit codes as documented: done, failed, wrong input, and two of scans."""

LOAD = load.load
COMMANDS: dict[str, click.Command] = {
    **{f"publish {name}": subcommand for name, subcommand in publish.main.commands.items()},
    **{
        name: main.cli.commands[name]
        for name in [
            "catalogue",
            "delta",
            "generate",
            "image",
            "init",
            "join",
            "load",
            "locks",
            "part",
            "plan",
            "save",
            "status",
        ]
    },
}


class Shop:
    def __init__(self, root: Path, server: LocalRegistry, content: LocalRegistry) -> None:
        self.root, self.host, self.server, self.content = root, server.address, server, content

    def reset(self) -> None:
        self.server.blobs, self.server.manifests = dict(self.content.blobs), dict(self.content.manifests)
        self.server.tags = {repository: dict(tags) for repository, tags in self.content.tags.items()}
        self.server.requests, self.server.headers = [], []


# ---- What there is ---------------------------------------------------------------------------------------------------


def copied(content: LocalRegistry, registry: MemoryRegistry, prefix: str) -> None:
    def renamed(repository: str) -> str:
        return f"{prefix}/{repository.partition('/')[2]}"

    for repository, blobs in registry.blobs.items():
        content.blobs |= {(renamed(repository), name): data for name, data in blobs.items()}
    for repository, manifests in registry.manifests.items():
        for name, manifest in manifests.items():
            data = oci.encoded(manifest.content)
            assert memory_registry.digest(data) == name
            content.manifests[renamed(repository), name] = (manifest.media_type, data)
    for repository, names in registry.names.items():
        content.tags[renamed(repository)] = dict(names)


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    """One place per state: `published`, `half` (amd64 alone, no tag), `failed`, `moved` (published, then ROS moved)."""
    root = tmp_path_factory.mktemp("checkout")
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, root / name)
    subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
    with local_registry() as server:
        services = stubs.services(root, registry=server.address)
        content = LocalRegistry()
        with pytest.MonkeyPatch.context() as patch:
            fill(content, root, services, patch)
        server.referrers = True
        yield Shop(root, server, content)


def fill(content: LocalRegistry, root: Path, services: Services, patch: pytest.MonkeyPatch) -> None:
    for prefix in ("published", "half", "failed", "moved"):
        place = memory_registry.publisher(root, services, patch)
        place.packages = dict.fromkeys(REAL.matrix.distributions, "monday")
        facts: dict[str, Any] = {"only": (PUBLISHED,)}
        if prefix == "half":
            facts["architectures"] = ("amd64",)
        if prefix == "failed":
            facts |= {"poisoned": {"ros1-bookworm-core-cuda-cu130"}, "broken": {"part-torch-cu128-py311"}}
        place.publish(REAL, **facts)
        if prefix == "moved":
            place.packages["ros1-bookworm"] = "tuesday"
            build(place.run(REAL, date=NEXT, only=("ros1-bookworm-core",), architectures=("amd64",)))
        copied(content, place.registry, prefix)


@pytest.fixture(autouse=True)
def around(shop: Shop, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (call, catalogue, generate, image, locks, part, publish):
        monkeypatch.setattr(module, "ROOT", shop.root)
    monkeypatch.setattr(setup, "is_up", lambda _: True)
    monkeypatch.setattr(load, "load", lambda *_: REAL)
    monkeypatch.setattr(package_state, "state", lambda *_: "monday")
    monkeypatch.setattr(package_state, "lacking", lambda *_: [])
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr("signal.signal", lambda *_: None)
    monkeypatch.setenv("ROSML_DOCKER_HUB", "0")
    stubs.executable(shop.root / "uv", "exit 1")
    monkeypatch.setenv("PATH", f"{shop.root}:/usr/bin:/bin")
    for name in ("HTTP_PROXY", "HTTPS_PROXY", "http_proxy", "https_proxy", "ALL_PROXY", "all_proxy"):
        monkeypatch.setenv(name, "http://127.0.0.1:9")  # the discard port: nothing answers
    for name in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY", "SSL_CERT_FILE", "ROSML_FORCE", "ROSML_SIGN", "COSIGN_KEY"):
        monkeypatch.delenv(name, raising=False)


# ---- What users type -------------------------------------------------------------------------------------------------

TARGETS = st.sampled_from([image.target for image in REAL.images])
GROUPS = sorted(name for name, targets in REAL.groups.items() if len(targets) < 60)

NAMES = st.one_of(
    st.sampled_from([image.target for image in REAL.images if image.target.startswith("ros1-bookworm-core")]),
    TARGETS,
    st.sampled_from([tag for image in REAL.images for tag in image.tags]),
    st.sampled_from([part.name for part in REAL.parts]),
    st.sampled_from([*GROUPS, *REAL.matrix.operating_systems]),
)


@st.composite
def patterns(draw: st.DrawFn) -> str:
    words = draw(TARGETS).split("-")
    place = draw(st.integers(0, len(words) - 1))
    return "-".join(
        [*words[:place], draw(st.sampled_from(["?*", "[bt]*", words[place][:2] + "*"])), *words[place + 1 :]]
    )


@st.composite
def typos(draw: st.DrawFn) -> str:
    name = draw(NAMES)
    place = draw(st.integers(0, len(name) - 1))
    letter = draw(st.sampled_from(["", "x", "-", "*", "[", ":", "/", " ", "ü", "\n"]))
    return name[:place] + letter + name[place + draw(st.integers(0, 1)) :]


WORDS = st.one_of(NAMES, NAMES, patterns(), typos(), st.sampled_from(["", " ", "-", "*x", "../x"]))
ARCHITECTURES = st.sampled_from(["amd64", "amd64", "arm64", "arm64", "amd64 arm64", "arm46", "linux/arm64", ""])
PREFIXES = ("published", "half", "failed", "moved", "nothing")

VALUES: Mapping[str, st.SearchStrategy[str]] = {
    "registry": st.sampled_from(
        [*(f"{{host}}/{name}" for name in PREFIXES), "", "{host}", "https://{host}/x", "x y/z"]
    ),
    "only": WORDS,
    "checkout": st.sampled_from(["/", "/no/such/folder", ""]),
    "target": WORDS,
    "environments": WORDS,
    "parts": WORDS,
    "groups": WORDS,
    "explain": WORDS,
    "stacks": WORDS,
    "architectures": ARCHITECTURES,
    "serve": ARCHITECTURES,
    "on": st.sampled_from(["{host}/none/debian:bookworm", "x y/z", ""]),
    "platform": st.sampled_from(["linux/amd64", "linux/arm64", "arm64", "linux/amd46", ""]),
    "platforms": st.sampled_from(["linux/amd64", "linux/arm64", "arm64", ""]),
    "namespace": st.sampled_from(["rosml", "a/b", "A", ""]),
    "matrix": st.just(str(ROOT / "matrix.yaml")),
    "plan_file": st.sampled_from(["{root}/plan.json", "{root}/none.json", "{root}/matrix.yaml", "{root}/locks", "-"]),
    "file": st.sampled_from(["{root}/plan.json", "{root}/none.json", "{root}/matrix.yaml", "{root}/locks", "-"]),
    "shard": st.sampled_from(["amd64-1", "arm64-1", "x", ""]),
    "date": st.sampled_from([DAY, NEXT, "2999-01-01T00:00:00Z", "yesterday", "2026-11-22T03:00:00", ""]),
    "run": st.sampled_from([DAY, NEXT, "yesterday", ""]),
    "since": st.sampled_from(["HEAD", "no-such", "--help", "{root}/matrix.yaml", ""]),
    "diff": st.sampled_from(["HEAD", "no-such", "--help", "{root}/matrix.yaml", "{root}/locks", ""]),
    "policy": st.sampled_from(["{root}/policy.yaml", "{root}/none.yaml", "{root}/matrix.yaml"]),
    "database": st.sampled_from(["{host}/x:1", "{host}/x@sha256:1", "x", ""]),
    **dict.fromkeys(("output", "markdown"), st.sampled_from(["{root}/out", "{root}/matrix.yaml/x"])),
    "folder": st.sampled_from(["{root}/examples/ros1", "{root}/examples/ros2", "{root}/docs", "{root}/none"]),
    "distribution": st.sampled_from([*REAL.matrix.distributions, "bookworm", "Ubuntu 24.04", "jazy", ""]),
    "component": st.sampled_from([*REAL.matrix.components, "bse", ""]),
    "framework": st.sampled_from([*REAL.matrix.frameworks, "PyTorch", "tf", "trch", ""]),
    "accelerator": st.sampled_from([*REAL.matrix.stacks, "gpu", "CUDA 13", "none", "tpu", ""]),
    "command": st.sampled_from(["ros2 launch a b.launch.py", "x 'y", "a; b", ""]),
    "rosml": st.sampled_from(["https://github.com/me/rosml", "/no/such/folder", "git@github.com:me/rosml", ""]),
    "ci": st.sampled_from(["github", "gitlab", "none", "jenkins", ""]),
    "push_to": st.sampled_from(["ghcr.io/me/robot", "quay.io/me/robot", "robot", "https://x/y", "none", ""]),
    "report": st.just("{root}/report.md"),
    "into": st.sampled_from(["{root}/out", "{root}/none/out", "{root}", ""]),
    **dict.fromkeys(
        ("image", "have", "origins"),
        st.sampled_from(["{host}/published/ros:ros1-bookworm-core", "{host}/none:1", "{root}/matrix.yaml", "a b", ""]),
    ),
    "reports": st.just("{root}/reports"),
    "day": st.sampled_from(["2026-11-22", "today"]),
    **dict.fromkeys(
        ("one", "other", "ros_image", "tag"),
        st.one_of(
            st.builds("{{host}}/published/{}".format, st.one_of(NAMES, typos())),
            st.sampled_from(["ros:ros1-bookworm-core", "", "a b", "{host}/published/ros:ros1-bookworm-core"]),
        ),
    ),
    **dict.fromkeys(
        ("at_most", "shards", "days", "newest", "history", "minutes", "unpublished"),
        st.sampled_from(["1", "8", "0", "-1", "x"]),
    ),
}


@st.composite
def arguments(draw: st.DrawFn, name: str) -> list[str]:
    argv: list[str] = []
    behind: list[str] = []
    for parameter in COMMANDS[name].params:
        if isinstance(parameter, click.Option) and parameter.is_flag:
            argv += [parameter.opts[0]] * draw(st.booleans())
            continue
        assert parameter.name in VALUES, f"{name} has a new option: say in VALUES what users give for {parameter.name}"
        value = VALUES[parameter.name]
        if isinstance(parameter, click.Argument):
            behind += draw(st.lists(value, max_size=2)) if parameter.nargs < 0 else [draw(value)]
        elif parameter.name in ALWAYS.get(name, ()) or draw(st.integers(0, 2)) == 0 or parameter.name == "only":
            many = st.lists(value, min_size=1, max_size=2) if parameter.multiple else value.map(lambda text: [text])
            argv += [word for text in draw(many) for word in (parameter.opts[0], text)]
    return [*argv, "--", *behind] if behind else argv


ALWAYS: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(COMMANDS, ("registry",)),
    "generate": ("output",),  # it would write the checkout's own files
    "publish scan": ("registry", "policy"),
    "publish database": ("policy",),
}


def ended(shop: Shop, name: str, words: list[str], capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    shop.reset()
    argv = [word.replace("{host}", shop.host).replace("{root}", str(shop.root)) for word in words]
    try:
        code = command.run(main.cli, arguments=[*name.split(), *argv])
    except SystemExit as end:
        code = int(end.code or 0)
    done = capsys.readouterr()
    return code, done.out, done.err


PROFILE = settings(
    max_examples=3,
    phases=(Phase.explicit, Phase.reuse, Phase.generate),  # each call takes a moment: what failed is not made shorter
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


@pytest.mark.parametrize("name", COMMANDS)
@given(data=st.data())
@PROFILE
def test_any_call_ends_as_documented(
    shop: Shop, capsys: pytest.CaptureFixture[str], name: str, data: st.DataObject
) -> None:
    words = data.draw(arguments(name))
    code, out, err = ended(shop, name, words, capsys)
    assert code in CODES
    assert "Traceback" not in out + err
    assert code == 0 or err
    if "--json" in words and "--check" not in words:
        json.loads(out)


# ---- What a selection must not change --------------------------------------------------------------------------------


def status_of(shop: Shop, capsys: pytest.CaptureFixture[str], place: str, *only: str) -> dict[str, dict[str, Any]]:
    words = ["--registry", f"{{host}}/{place}", "--json", *(word for name in only for word in ("--only", name))]
    code, out, _ = ended(shop, "status", words, capsys)
    assert code == 0
    return {item["target"]: {**item, "age": None} for item in json.loads(out)["images"]}


NARROW = ("ros1-bookworm-core-torch-cu128", "ros1-bookworm-core-cuda-cu130", "jazzy-wheels-core-tensorflow-cpu")


@pytest.mark.parametrize("place", PREFIXES)
def test_an_image_stands_as_it_stands_whatever_else_is_asked_for(
    shop: Shop, capsys: pytest.CaptureFixture[str], place: str
) -> None:
    assert {len(REAL.image(target).architectures) for target in NARROW} == {1, 2}
    every = status_of(
        shop, capsys, place, "ros1-bookworm-core", "ros1-bookworm-core-*-cu1[23]?", "jazzy-wheels-core*-cpu"
    )
    for target in NARROW:
        images = status_of(shop, capsys, place, target)
        assert target in images
        assert images == {name: every[name] for name in images}


@pytest.fixture
def without_services(shop: Shop) -> Iterator[None]:
    state = shop.root / ".state"
    state.rename(shop.root / "state")
    yield
    shutil.rmtree(state, ignore_errors=True)
    (shop.root / "state").rename(state)


@pytest.mark.usefixtures("without_services")
def test_another_registry_is_read_without_services(shop: Shop, capsys: pytest.CaptureFixture[str]) -> None:
    images = status_of(shop, capsys, "published", "ros1-bookworm-core")
    assert images["ros1-bookworm-core"]["state"] == "published"
    words = ["--only", "ros1-bookworm-core"]
    assert ended(shop, "catalogue", [*words, "--registry", "{host}/published", "--json"], capsys)[0] == 0
    for name in ("status", "catalogue"):
        code, _, err = ended(shop, name, words, capsys)
        assert (code, err.splitlines()[0]) == (1, "error: the local registry and the builder are not up")
        assert "run './rosml setup'" in err


@pytest.fixture
def without_docker_hub(shop: Shop) -> Iterator[None]:
    stubs.services(shop.root, registry=shop.host, bases=stubs.OFFLINE)
    yield
    stubs.services(shop.root, registry=shop.host)


@pytest.mark.usefixtures("without_docker_hub")
def test_parts_are_planned_where_their_images_cannot_be_built(
    shop: Shop, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(load, "load", LOAD)
    matrix = shutil.copy(ROOT / "matrix.yaml", tmp_path / "own.yaml")
    words = ["--registry", "{host}/nothing", "--matrix", str(matrix), "--only", "jazzy-core*", "--json"]
    code, out, err = ended(shop, "plan", words, capsys)
    assert code == 0, err
    plan = json.loads(out)
    planned = {task["target"] for task in plan["tasks"] if task["steps"]}
    assert "part-torch-cu128-py312" in planned
    assert "jazzy-core" not in planned
    assert plan["shards"] == []
