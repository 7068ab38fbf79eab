"""Apps, built, tested and entered: the example as its folder stands, and a repository that asks for everything at once."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import http.server
import json
import os
import random
import re
import secrets
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tarfile
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order as build
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registry
from tests import recording, regctl
from tests.e2e.conftest import NAMESPACE, Run, run
from tests.e2e.images import Publish
from tests.e2e.images import build as build_folder
from tests.recording import COMMANDS

BASE = "ros1-bookworm-core"
RUNTIME = "ros1-bookworm-core-run"
CANARY = "canary-9d1f"

PACKAGE = """<package format="2"><name>{0}</name><version>1.0.0</version><description>{0}</description>
<maintainer email="nobody@example.org">nobody</maintainer><license>Apache-2.0</license>
<buildtool_depend>catkin</buildtool_depend>{1}</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.16)
project({0} C)
find_package(catkin REQUIRED)
catkin_package()
file(WRITE ${{CMAKE_CURRENT_BINARY_DIR}}/said "${{GREETING}}\\n")
install(FILES ${{CMAKE_CURRENT_BINARY_DIR}}/said DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
"""


WITHOUT_A_SCAN = """RUN --mount=type=bind,source={0}-apt,target=/said \\
    {{ dpkg-query --show --showformat '${{Package}} ${{Version}}\\n'; \\
      awk '/^Package:/ {{p = $2}} /^Version:/ {{print p, $2}}' /var/lib/dpkg/status.d/*; }} | LC_ALL=C sort | diff - /said
RUN --mount=type=bind,from={1},target=/listed --mount=type=bind,source={0}-files,target=/said.gz \\
    find /listed -mindepth 1 \\( -type f -o -type l \\) ! \\( -path '*/rosml/constraints.d/*' -empty \\) -printf '%P\\n' | \\
      LC_ALL=C sort >/found && zcat /said.gz | diff /found -
"""
"""Steps that compare what is attached to an image with what dpkg says in it, and with its files."""


def commit(folder: Path) -> None:
    for command in (("init", "--quiet"), ("add", "--all", "--force"), ("commit", "--quiet", "--message", "All")):
        names = ("-c", "user.name=nobody", "-c", "user.email=nobody@example.org")
        subprocess.run(["git", "-C", str(folder), *names, *command], check=True)


def with_upstream(place: Path) -> tuple[Path, Path]:
    """A repository with a package, and one that its `.repos` file names."""
    folder, upstream = place / "robot", place / "upstream"
    for root in (upstream, folder):
        root.mkdir()
        (root / "package.xml").write_text(PACKAGE.format(root.name, ""))
        (root / "CMakeLists.txt").write_text(CMAKE.format(root.name))
    subprocess.run(["git", "init", "--quiet", "--initial-branch=master", str(upstream)], check=True)
    commit(upstream)
    (folder / ".repos").write_text(f"repositories: {{up: {{type: git, url: 'file://{upstream}', version: master}}}}\n")
    return folder, upstream


def containerize(folder: Path, *options: str) -> Run:
    return run(sys.executable, str(ROOT / "src"), "containerize", str(folder), "--json", "--allow-file-urls", *options)


def made(folder: Path, *options: str) -> dict[str, Any]:
    outcome = containerize(folder, *options)
    assert outcome.code == 0, outcome.err + outcome.out
    found: dict[str, Any] = json.loads(outcome.out)
    return found | {image["target"]: image for image in found["images"]}


def ran(services: Services, name: str) -> set[str]:
    """The stages of which a step ran, and was not in the cache, in the last build of an app."""
    log = (services.state / f"log/containerize-{name.replace('/', '+')}@latest.log").read_text()
    return set(re.findall(r"^[\d.]+ s \[(?:[a-z-]+ )?([a-z-]+) \d+/\d+\] RUN", log, re.MULTILINE))


def config(services: Services, reference: str) -> dict[str, Any]:
    place = references.parse(reference)
    with Registry(services.registry) as registry:
        manifest = registry.manifest(place.repository, place.reference)
        assert manifest
        return registry.json_blob(place.repository, manifest.content["config"]["digest"])


def attached(services: Services, image: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
    """The SBOM of an image for one platform, and the list of its files as it is kept."""
    repository = references.parse(image["reference"]).repository
    found = []
    with Registry(services.registry) as registry:
        for artifact_type in ("application/vnd.cyclonedx+json", "application/vnd.rosml.files.v1"):
            [entry] = registry.referrers(repository, image["digest"], artifact_type)
            manifest = registry.manifest(repository, entry["digest"])
            assert manifest
            found.append(registry.blob(repository, manifest.content["layers"][0]["digest"]))
    return json.loads(found[0]), found[1]


def test_the_example(published: Publish, services: Services, tmp_path: Path) -> None:
    base, runtime = published(BASE), published(RUNTIME)
    folder, name = tmp_path / "compass", f"{NAMESPACE}/compass"
    shutil.copytree(ROOT / "examples/ros1", folder)
    (folder / ".env").unlink()  # rosml init writes another one, which names the command; tests below take this one
    written = run(sys.executable, str(ROOT / "src"), "init", str(folder), "--yes", "--component", "core")
    assert written.code == 0, written.err
    with (folder / ".env").open("a") as file:
        file.write(f"GIT_HTTPS_PASSWORD={CANARY}\n")
    commit(folder)
    options = ["--base-image", base.reference, "--image-name", name]
    options += ["--enable-slim", "--slim-base-image", runtime.reference]

    found = made(folder, *options)
    assert found["packages"] == ["compass"]
    assert found["installed"] == ["libangles-dev:all", "python3-angles:all"]
    assert found["tests"]["count"] == 2 and not found["tests"]["failures"]
    assert list(Path(found["reports"]).rglob("gtest-*.xml"))
    run_image, dev_image = found["run"]["reference"], found["dev"]["reference"]
    layers = [layer.digest for layer in regctl.layers(services, run_image)]
    assert layers[:-1] == base.layers, "the base image and one layer of the app"
    assert found["slim_tests"]["count"] == 2 and not found["slim_tests"]["failures"]
    slim_image = found["slim"]["reference"]
    slim = regctl.layers(services, slim_image)
    assert [layer.digest for layer in slim][:-1] == runtime.layers
    whole = sum(layer.size for layer in regctl.layers(services, run_image))
    assert sum(layer.size for layer in slim) < 0.45 * whole
    for reference in (run_image, dev_image, slim_image):
        assert CANARY not in json.dumps(config(services, reference))
    assert CANARY not in (services.state / f"log/containerize-{NAMESPACE}+compass@latest.log").read_text()

    (tmp_path / "chk").mkdir()
    for target in ("run", "slim"):
        document, files = attached(services, found[target])
        apt = [item for item in document["components"] if item.get("purl", "").startswith("pkg:deb/")]
        lines = sorted(f"{item['name']} {item['version']}" for item in apt)
        (tmp_path / f"chk/{target}-apt").write_text("\n".join([*lines, ""]))
        (tmp_path / f"chk/{target}-files").write_bytes(files)
        [ros] = [item for item in document["components"] if item.get("purl", "").startswith("pkg:generic/ros/")]
        assert (ros["name"], ros["licenses"]) == ("compass", [{"license": {"name": "Apache-2.0"}}])
    (tmp_path / "chk/Dockerfile").write_text(
        f"""FROM {run_image} AS run
RUN bash -c '(timeout 20 /tini -s -- /entrypoint.sh bash -c "exec bash -c \\"$DEFAULT_CMD\\"" & \\
      for try in {{1..200}}; do /entrypoint.sh timeout 5 rostopic echo -n 4 /direction && break; done >/said; wait) 2>&1' && \\
    sort -u /said && test "$(grep -c -E "east|north|west|south" /said)" -ge 4
RUN test -e /var/lib/dpkg/status.d/python3-angles && ! grep -q libangles /var/lib/dpkg/status && \\
    test ! -e /docker-ros/ws/src && test ! -e /docker-ros/ws/build
{WITHOUT_A_SCAN.format("run", run_image)}
FROM {slim_image} AS slim
# After the other one: builders may run both steps at once, on one network.
COPY --from=run /said /said
RUN bash -c '(timeout 20 /tini -s -- /entrypoint.sh bash -c "exec bash -c \\"$DEFAULT_CMD\\"" & \\
      for try in {{1..200}}; do /entrypoint.sh timeout 5 rostopic echo -n 1 /direction && break; done >/slim; wait) 2>&1' && \\
    grep -E "east|north|west|south" /slim && ! command -v g++ && ! find /usr/include -type f | grep . && test -e /var/lib/dpkg/status.d/python3-angles && \\
    ! test -e /var/lib/dpkg/status.d/libangles-dev
{WITHOUT_A_SCAN.format("slim", slim_image)}
FROM {dev_image} AS dev
RUN test -e /docker-ros/ws/src/target/src/compass/package.xml && ! grep -r {CANARY} /docker-ros && \\
    test -z "$(find /docker-ros -name .git -o -name .env)"
RUN DOCKER_UID=1000 DOCKER_GID=1000 /entrypoint.sh bash -c 'cd ~/ws && colcon build && . install/setup.bash && rospack find compass'
FROM scratch
COPY --from=run /said /
COPY --from=slim /slim /
COPY --from=dev /tini /
"""
    )
    build_folder(services, tmp_path / "chk")

    again = made(folder, *options)
    assert (again["run"]["digest"], ran(services, name)) == (found["run"]["digest"], set()), "nothing runs twice"


def test_what_the_readme_shows_is_what_is_said(published: Publish, services: Services, tmp_path: Path) -> None:
    """The recording's build and its container; unit/project/test_recording.py has its other command. An image's own name is
    another one here."""
    recording.package(tmp_path, fresh=False)
    published(BASE)
    cast, base = recording.read(), f"{services.registry}/{NAMESPACE}/ros:{BASE}"
    typed = COMMANDS["containerize"].replace(f"ros:{BASE}", base).replace("./rosml", f"{sys.executable} {ROOT / 'src'}")
    # --push: into the registry, as it was recorded, also if Docker is the builder here.
    now = recording.recorded(f"{typed} --push --image-name {services.registry}/{NAMESPACE}/compass", tmp_path, {})
    file = f"{services.registry}/{NAMESPACE}/compass".replace(":", "=").replace("/", "+")
    own = {f"{NAMESPACE}/ros": "rosml/ros", f"{NAMESPACE}/": "", file: "compass"}
    said = functools.reduce(lambda text, name: text.replace(name, own[name]), own, now.output)
    assert recording.stable(said) == recording.stable(cast["containerize"].output)
    log = recording.steps((services.state / f"log/containerize-{file}@latest.log").read_text())
    shown = recording.steps(cast["containerize"].output)
    assert [step for step in shown if not any(known.startswith(step) for known in log)] == []

    (tmp_path / "Dockerfile").write_text(
        f"FROM {recording.image(now)}\nRUN echo {shlex.quote(cast['run'].output.strip())} >/wanted && "
        f"/entrypoint.sh {COMMANDS['run']} | diff /wanted -\n"
    )
    build_folder(services, tmp_path)


def test_a_machine_that_has_nothing_builds_nothing_twice(
    published: Publish, services: Services, beside: Services, tmp_path: Path
) -> None:
    """What another one has finished is in the registry: of an unchanged app all, of a changed one all but the app."""
    folder, name = tmp_path / "compass", f"{NAMESPACE}/cached"
    shutil.copytree(ROOT / "examples/ros1", folder)
    source = folder / "src/compass/src/compass.cpp"
    source.write_text(source.read_text() + f"// {secrets.token_hex()}\n")  # as never before
    cache = f"{services.registry}/{name}-cache"
    options = {"base-image": published(BASE).result["reference"], "image-name": name, "cache": cache}
    first = made(folder, *(word for key, value in options.items() for word in (f"--{key}", value)))

    said: list[str] = []
    fresh = dataclasses.replace(services, builder=beside.builder)
    app = build.new_call(folder, app_inputs.values(options, folder, {}), {}, fresh, said.append)
    again = build.build_images(app)
    assert {image.target: image.digest for image in again.images}["run"] == first["run"]["digest"]
    assert f"nothing to build: {cache} has it" in said
    assert again.tests.target.count == 2 and again.outcome.packages == ["compass"]
    log = services.state / f"log/containerize-{NAMESPACE}+cached@latest-images.log"
    assert "RUN" not in log.read_text(), "no step at all"

    source.write_text(source.read_text().replace('"west"', '"WEST"'))
    with pytest.raises(RosmlError, match="1 of 2 tests failed; no image was made") as caught:
        build.build_images(app)
    assert "Compass.Quarters" in caught.value.message
    assert ran(services, name) == {"sources", "built", "tested", "app-files"}, "no apt, no identification, no upstream"
    with Registry(services.registry) as registry:
        assert registry.head(name, "latest") == first["run"]["digest"], "the tag stays where it was"

    app = build.new_call(folder, app_inputs.values(options | {"tests": "false"}, folder, {}), {}, fresh, said.append)
    untested = build.build_images(app)
    assert untested.tests.target.count == 0, "no result of the build before"


def test_a_build_gets_no_results_of_another(services: Services, tmp_path: Path) -> None:
    """BuildKit's cache took a copy of an empty stage for the copy of another one: results of packages that use another app's."""
    text = (ROOT / "components/containerize/Dockerfile").read_text()
    stages = text[text.index("FROM scratch AS nothing") : text.index("FROM results AS slim-results")]
    for folder in ("results", "user"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "report.xml").write_text(f"<testsuite name='{secrets.token_hex()}'/>")
    (tmp_path / "Dockerfile").write_text(
        "ARG DOWNSTREAM\nFROM scratch AS tested\nCOPY results /tests/results/\n"
        f"FROM scratch AS downstream-results\nCOPY user /downstream/user/\n{stages}"
    )
    for used, expected in (
        ("downstream-results", ["results/report.xml", "downstream/user/report.xml"]),
        ("nothing", ["results/report.xml"]),
    ):
        left = tmp_path / f"{used}.tar"
        options = ("--target=results", f"--build-arg=DOWNSTREAM={used}", f"--output=type=tar,dest={left}")
        subprocess.run([*services.buildx, "build", *options, tmp_path], env=services.environment(), check=True)
        with tarfile.open(left) as archive:
            assert sorted(entry.name for entry in archive if entry.isfile()) == sorted(expected)


def test_apps_and_a_part_at_once_repeat_no_step(published: Publish, services: Services, tmp_path: Path) -> None:
    """What two apps both need is made once, and neither waits for the other or for the part."""
    base = published(BASE).result["reference"]
    folders = [tmp_path / name for name in ("first", "second")]
    for folder in folders:
        (folder / "docker").mkdir(parents=True)
        (folder / "package.xml").write_text(PACKAGE.format(folder.name, ""))
        (folder / "CMakeLists.txt").write_text(CMAKE.format(folder.name))
        # Another number each time that it runs, and the same file for both apps.
        script = f"# {tmp_path}\necho made-$RANDOM-$RANDOM\n"
        (folder / "docker/custom.sh").write_text(script)
    part = (
        sys.executable,
        str(ROOT / "src"),
        "part",
        "common-cpu-py311",
        "--namespace",
        NAMESPACE,
        "--again",
        "--json",
    )
    with ThreadPoolExecutor() as pool:
        beside = pool.submit(run, *part)
        names = [f"{NAMESPACE}/{folder.name}" for folder in folders]
        apps = [
            pool.submit(made, folder, "--base-image", base, "--image-name", name, "--command", "true")
            for folder, name in zip(folders, names, strict=True)
        ]
        assert [app.result()["packages"] for app in apps] == [["first"], ["second"]]
        assert beside.result().code == 0, beside.result().err
    logs = [services.state / f"log/containerize-{name.replace('/', '+')}@latest.log" for name in names]
    said = [re.findall(r"\bmade-\d+-\d+", log.read_text()) for log in logs]
    assert len({*said[0], *said[1]}) == len({*said[0]}) > 0, said
    assert all(app.result()["waited"] == 0 for app in apps)


def test_an_app_is_a_base_image_as_well(published: Publish, services: Services, tmp_path: Path) -> None:
    """The second one's layer has what the second one has built, and finds the first one."""
    images = [published(BASE).reference]
    for number, needs in ((1, ""), (2, "<depend>level_1</depend>")):
        folder = tmp_path / f"level_{number}"
        folder.mkdir()
        (folder / "package.xml").write_text(PACKAGE.format(folder.name, needs))
        (folder / "CMakeLists.txt").write_text(CMAKE.format(folder.name))
        name = f"{NAMESPACE}/level{number}"
        options = ("--base-image", images[-1], "--image-name", name, "--command", "true", "--target", "run")
        run_image = made(folder, *options)["run"]
        images.append(f"{run_image['reference'].rpartition(':')[0]}@{run_image['digest']}")
    base, first, second = ([layer.digest for layer in regctl.layers(services, image)] for image in images)
    assert (first[:-1], second[:-1]) == (base, first)
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        f"""FROM {images[-1]}
RUN /entrypoint.sh bash -c 'rospack find level_1 && rospack find level_2' && \\
    test -e install/level_1/share/level_1/said -a -e install/level_2/share/level_2/said
"""
    )
    build_folder(services, tmp_path / "chk")


def test_a_framework_is_added_to_an_app(published: Publish, services: Services, tmp_path: Path) -> None:
    """Without a build and in some kilobytes: by the list of files that is attached to the app."""
    folder, framework = tmp_path / "robot", published("ros1-bookworm-core-tensorflow-cpu")
    folder.mkdir()
    (folder / "package.xml").write_text(PACKAGE.format(folder.name, "<exec_depend>angles</exec_depend>"))
    (folder / "CMakeLists.txt").write_text(CMAKE.format(folder.name))
    options = ("--base-image", published(BASE).reference, "--image-name", f"{NAMESPACE}/robot", "--target", "run")
    app = made(folder, *options, "--command", "rospack find robot")["run"]
    parts = [f"{services.registry}/{NAMESPACE}/part:{name}" for name in framework.image.parts]
    tag = f"{services.registry}/{NAMESPACE}/robot:learned"
    joined = run(
        sys.executable, str(ROOT / "src"), "join", app["reference"], *parts, "--tag", tag, "--json", cwd=tmp_path
    )
    assert joined.code == 0, joined.err
    assert json.loads(joined.out)["uploaded"] < 15_000
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        f"""FROM {tag}
RUN /entrypoint.sh bash -c 'exec bash -c "$DEFAULT_CMD"' | grep ws/install && \\
    /entrypoint.sh python3 -c 'import angles, tensorflow; print(tensorflow.constant(1) + 1)'
"""
    )
    build_folder(services, tmp_path / "chk")


def test_a_lock_file_holds_what_an_image_is_built_from(published: Publish, tmp_path: Path) -> None:
    folder, upstream = with_upstream(tmp_path)
    (folder / "docker").mkdir()
    (folder / "docker/additional-debs.txt").write_text("tree\n")
    (folder / "docker/additional-pip-requirements.txt").write_text("toolz\n")
    options = ("--base-image", published(BASE).reference, "--image-name", f"{NAMESPACE}/locked", "--command", "true")

    first, file = made(folder, *options, "--lock"), folder / "containerize.lock"
    lock = json.loads(file.read_text())
    [(architecture, debs)] = lock["apt"].items()
    [toolz] = lock["pip"][architecture]
    assert "tree" in debs and re.fullmatch(r"toolz==\S+ --hash=sha256:[0-9a-f]{64}", toolz)

    (upstream / "new").touch()
    commit(upstream)
    again = made(folder, *options)
    assert [image["digest"] for image in again["images"]] == [image["digest"] for image in first["images"]]
    label = config(Services.load(ROOT), again["run"]["reference"])["config"]["Labels"]["io.rosml.lock"]
    assert json.loads(label) | {"downstream": {}} == lock, "whoever has the image has its lock file"

    debs["tree"] = "0.1-1"
    file.write_text(json.dumps(lock))
    (folder / "docker/additional-debs.txt").write_text("tree\nsl\n")
    said = json.loads(containerize(folder, *options).out)["error"]
    assert re.search(r"the lock file does not have what apt installed: .*sl .*, tree ", said) and "--lock" in said

    debs["tree"] = first["lock"]["apt"][architecture]["tree"]
    lock["pip"][architecture] = [re.sub("sha256:.*", f"sha256:{'0' * 64}", toolz)]
    file.write_text(json.dumps(lock))
    (folder / "docker/additional-debs.txt").write_text("tree\n")
    outcome = containerize(folder, *options)
    assert outcome.code == 1 and "toolz" in outcome.out


@pytest.mark.full(proof="kills")
def test_a_call_that_is_killed_is_finished_by_the_next(published: Publish, services: Services, tmp_path: Path) -> None:
    """SIGKILL at any moment, of rosml alone and of all that it started: tags stay on whole images."""
    (folder, upstream), name = with_upstream(tmp_path), f"{NAMESPACE}/killed"
    options = ("--base-image", published(BASE).reference, "--image-name", name, "--command", "true")
    cache = ("--cache", f"{services.registry}/{name}-cache")
    made(folder, *options, *cache)
    chance, killed, tags = random.Random(36), 0, ("latest", "latest-dev")
    for number in range(20):
        (upstream / "new").write_text(f"{number}\n")
        commit(upstream)
        (folder / "CMakeLists.txt").write_text(
            CMAKE.format("robot").replace("GREETING", f"GREETING}} {number} ${{GREETING")
        )
        process = subprocess.Popen(
            [sys.executable, str(ROOT / "src"), "containerize", str(folder), *options, *cache],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
        )  # fmt: skip
        try:
            process.wait(timeout=chance.uniform(0.2, 8.0))
        except subprocess.TimeoutExpired:
            killed += 1
            (os.killpg if number % 2 else os.kill)(process.pid, signal.SIGKILL)
            process.wait()
        with Registry(services.registry) as registry:
            for tag in tags:
                manifest = registry.manifest(name, tag)
                assert manifest
                layers = [manifest.content["config"], *manifest.content["layers"]]
                assert all(registry.has_blob(name, layer["digest"]) for layer in layers)
    assert killed >= 8
    last = made(folder, *options, *cache)
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        f"FROM {last['run']['reference']}\nRUN grep {number} install/robot/share/robot/said\n"
    )
    build_folder(services, tmp_path / "chk")


@pytest.mark.full(proof="wheels")
def test_the_example_of_ros_2(published: Publish, services: Services, tmp_path: Path) -> None:
    """On ROS 2 from wheels, of which rosdep knows nothing on Debian, and which has no command ros2."""
    folder, name = tmp_path / "counter", f"{NAMESPACE}/counter"
    shutil.copytree(ROOT / "examples/ros2", folder)
    options = ("--base-image", published("jazzy-wheels-core").result["reference"], "--image-name", name)
    program = "/docker-ros/ws/install/counter/lib/counter/count"
    (tmp_path / "index/rosdep").mkdir(parents=True)
    (tmp_path / "index/rosdep/base.yaml").write_text(
        "rclpy: {debian: []}\nstd_msgs: {debian: []}\npython3-pytest: {debian: [python3-pytest]}\n"
    )
    found = made(folder, *options, "--rosdep-index", str(tmp_path / "index"), "--command", program)
    assert found["installed"] == [], "nothing of Debian's ROS 1"
    assert found["tests"]["count"] == 1 and not found["tests"]["failures"]
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        f"""FROM {found["run"]["reference"]}
RUN (timeout --signal=INT 8 /tini -s -- /entrypoint.sh bash -c 'exec bash -c "$DEFAULT_CMD"' || true) 2>&1 | tee /said && \
    grep "round: 20" /said
"""
    )
    build_folder(services, tmp_path / "chk")


@pytest.fixture
def everything(tmp_path: Path) -> Path:
    """A repository that uses each file which it may have, and upstream sources that name others."""
    for name, needs in (("wanted", "<depend>base</depend>"), ("unwanted", "<depend>nobody_has_this</depend>")):
        (tmp_path / f"robot/{name}").mkdir(parents=True)
        (tmp_path / f"robot/{name}/package.xml").write_text(PACKAGE.format(name, needs))
        (tmp_path / f"robot/{name}/CMakeLists.txt").write_text(CMAKE.format(name))
    for number, (name, names) in enumerate((("base", "further"), ("further", ""))):
        upstream = tmp_path / name
        upstream.mkdir()
        (upstream / "package.xml").write_text(PACKAGE.format(name, f"<depend>{names}</depend>" if names else ""))
        (upstream / "CMakeLists.txt").write_text(CMAKE.format(name))
        if names:
            (upstream / "more.repos").write_text(
                f"repositories:\n  {names}: {{type: git, url: 'file://{tmp_path / names}', version: master}}\n"
            )
        subprocess.run(["git", "init", "--quiet", "--initial-branch=master", str(upstream)], check=True)
        commit(upstream)
        assert number < 2
    folder = tmp_path / "robot"
    (folder / ".repos").write_text(
        f"repositories:\n  base: {{type: git, url: 'file://{tmp_path / 'base'}', version: master}}\n"
    )
    user = tmp_path / "user"
    user.mkdir()
    (user / "package.xml").write_text(
        PACKAGE.format("user", "<depend>wanted</depend><test_depend>python3-toml</test_depend>")
    )
    (user / "CMakeLists.txt").write_text(
        CMAKE.format("user")
        + "find_package(wanted REQUIRED)\nenable_testing()\n"
        + "add_test(NAME uses COMMAND python3 -c \"import toml; open('${wanted_DIR}/../said')\")\n"
    )
    subprocess.run(["git", "init", "--quiet", "--initial-branch=master", str(user)], check=True)
    commit(user)
    (folder / "uses.repos").write_text(
        f"repositories: {{user: {{type: git, url: 'file://{user}', version: master}}}}\n"
    )
    docker = folder / "docker"
    (docker / "additional-files").mkdir(parents=True)
    (docker / "additional-files/hello").write_text("from a file\n")
    (folder / ".dockerignore").write_text("*.bag\n")
    (docker / "additional-debs.txt").write_text("# to look around\ntree  # and count\nlibcap2-bin\niputils-ping\n")
    (docker / "additional-pip-requirements.txt").write_text("toolz  # small\n")
    (docker / "blacklisted-packages.txt").write_text("unwanted  # needs what nobody has\n")
    (docker / "before_dependency_identification.sh").write_text(
        "#!/usr/bin/env python3\nfrom pathlib import Path\n"
        "path = Path('src/target/wanted/package.xml')\n"
        "path.write_text(path.read_text().replace('</package>', '<depend>angles</depend></package>'))\n"
    )
    (docker / "before_dependency_installation.sh").write_text(
        "apt-get install --yes sl >/dev/null\ntouch /opt/before\n"
    )
    (docker / "custom.sh").write_text(
        "cp /docker-ros/additional-files/hello /opt/after\npython3 -c 'import toolz'\n"
        "sed -i s/Debian/Zebian/ /etc/motd\n"
        "gcc -shared -Wl,-soname,libmine.so.1 -o /usr/local/lib/libmine.so.1.0 -x c /dev/null && ldconfig\n"
        "install -d --owner=games /var/log/mine && mkdir -p ~/.cache/model && touch ~/.cache/model/weights\n"
    )
    return folder


def test_a_repository_may_ask_for_everything(
    published: Publish, services: Services, everything: Path, tmp_path: Path
) -> None:
    for name, text in (
        ("rosdep/base.yaml", "python3-toml: {debian: [python3-toml]}\n"),
        ("index-v4.yaml", "distributions: {noetic: {distribution: [noetic/distribution.yaml]}}\n"),
        ("noetic/distribution.yaml", "repositories: {}\n"),
    ):
        (tmp_path / "rosdistro" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "rosdistro" / name).write_text(text)
    place = f"{services.registry}/{NAMESPACE}"
    command = ("publish", "rosdep", str(tmp_path / "rosdistro"), "--registry", place)
    lists = run(sys.executable, str(ROOT / "src"), *command)
    assert lists.code == 0, lists.err
    options = ("--base-image", published(BASE).result["reference"], "--image-name", f"{NAMESPACE}/everything")
    script = "# several lines\necho $((6 * 7)) ${NOTHING:-7}\ncat /opt/after"
    found = made(
        everything, *options, "--command", script, "--cmake-args", "-DGREETING='two words'",
        "--downstream-workspace", "uses.repos",
    )  # fmt: skip
    assert found["packages"] == ["base", "further", "wanted"]
    assert found["downstream_tests"] == {"count": 1, "skipped": 0, "failures": []}, "of what uses them"
    assert {repository["path"]: repository["moving"] for repository in found["upstream"]} == {
        "base": True,
        "further": True,
    }
    assert {"tree:amd64", "sl:amd64", "python3-angles:all"} <= {
        re.sub(":(arm64)$", ":amd64", name) for name in found["installed"]
    }
    (tmp_path / "chk").mkdir()
    lines = [
        "FROM {} AS {}",
        "RUN command -v tree && python3 -c 'import toolz' && test -e /opt/before && cat /opt/after && grep Zebian /etc/motd",
        "RUN python3 -c 'import ctypes; ctypes.CDLL(\"libmine.so.1\")' && getcap /usr/bin/ping | grep net_raw",
        'RUN test "$(stat --format %U /var/log/mine)" = games && test -e /root/.cache/model/weights',
    ]
    (tmp_path / "chk/Dockerfile").write_text(
        "\n".join(
            [
                *(line.format(found["run"]["reference"], "run") for line in lines),
                """RUN test "$(/entrypoint.sh bash -c 'exec bash -c "$DEFAULT_CMD"' | tr '\\n' /)" = '42 7/from a file/' && \\
    test "$(cat /docker-ros/ws/install/*/share/*/said | sort -u)" = "two words" && test ! -e /docker-ros/ws/install/unwanted""",
                *(line.format(found["dev"]["reference"], "dev") for line in lines),
                "RUN cd /docker-ros/ws/src && test -e upstream/base/package.xml -a -e upstream/further/package.xml && \\",
                "    grep angles target/wanted/package.xml && test ! -e target/unwanted && ! python3 -c 'import toml'",
                "FROM scratch",
                "COPY --from=run /tini /run",
                "COPY --from=dev /tini /dev",
            ]
        )
    )
    build_folder(services, tmp_path / "chk")


def test_packages_may_replace_what_the_base_image_has(published: Publish, services: Services, tmp_path: Path) -> None:
    folder, name = tmp_path / "robot", f"{NAMESPACE}/replaces"
    (folder / "docker").mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format("a", ""))
    (folder / "CMakeLists.txt").write_text(CMAKE.format("a"))
    (folder / "docker/custom.sh").write_text("apt-get purge --yes less\n")
    base = published(BASE)
    found = made(
        folder, "--base-image", base.result["reference"], "--image-name", name, "--command", "true", "--target", "run"
    )
    assert "less:amd64" in [name.replace("arm64", "amd64") for name in found["replaced"]]
    assert [layer.digest for layer in regctl.layers(services, found["run"]["reference"])][
        : len(base.layers)
    ] == base.layers
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        f"FROM {found['run']['reference']}\nRUN ! command -v less && ! dpkg -s less && test -e install/a/share/a/said\n"
    )
    build_folder(services, tmp_path / "chk")


HARM = r"""set -eu
say() { printf '\033]52;c;aGFybQ==\007\033[8m%s\n::error::harm\n##[add-mask]harm\n' "$1"; }
for folder in /tests/results /tests /tests/results/harm; do
  mkdir -p $folder
  for name in app.json dependencies.json images.json slim.json; do echo '{"packages": ["harm"]}' >$folder/$name; done
done
ln -s /proc/self/environ /tests/results/harm/link.xml
ln -s / /tests/results/root
mkfifo /tests/results/harm/pipe.xml
mknod /tests/results/harm/device.xml c 1 5 || mkfifo /tests/results/harm/device.xml
say the-last-line
exit "$1"
"""
"""What a test may do: it is root in its step."""


def test_what_tests_leave_says_nothing_of_the_machine_or_the_images(
    published: Publish, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, name = tmp_path / "harm", f"{NAMESPACE}/harm"
    folder.mkdir()
    (folder / "package.xml").write_text(PACKAGE.format("harm", ""))
    lines = "enable_testing()\nadd_test(NAME harm COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/harm.sh 0)\n"
    (folder / "CMakeLists.txt").write_text(CMAKE.format("harm") + lines)
    (folder / "harm.sh").write_text(HARM)
    monkeypatch.setenv("GIT_HTTPS_PASSWORD", CANARY)
    base = published(BASE).result["reference"]
    options = ("--base-image", base, "--image-name", name, "--command", "true", "--target", "run")
    outcome = containerize(folder, *options)
    assert outcome.code == 1
    error = json.loads(outcome.out)["error"]
    assert "4 of 5 tests failed; no image was made" in error, error
    for said in ("link.xml: it is a link", "root: it is a link", "pipe.xml: it is a pipe", "device.xml: it is a"):
        assert f"{said}" in error
    state = services.state / f"containerize/{name.replace('/', '+')}@latest"
    left = [path for path in state.rglob("*") if "said" not in path.parts and path.name != "harm.sh"]
    assert not [path for path in left if path.is_symlink() or not (path.is_file() or path.is_dir())]
    reports = [path for path in (state / "report").rglob("*") if path.is_file()]
    assert {path.suffix or path.name for path in reports} == {".xml"}
    assert CANARY not in outcome.out + outcome.err + "".join(path.read_text() for path in reports)
    assert "harm" not in json.loads((state / "said/dependencies.json").read_text())["keys"]
    assert json.loads((state / "said/app.json").read_text())["packages"] == []


def test_a_step_of_a_build_changes_no_image_in_the_local_registry(
    published: Publish, services: Services, tmp_path: Path
) -> None:
    """The mirror of Docker Hub as well: it does not reach it, or has no password for it."""
    folder = tmp_path / "harm"
    (folder / "docker").mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format("harm", ""))
    (folder / "CMakeLists.txt").write_text(CMAKE.format("harm"))
    asked = f"http://{services.registry}/v2/library/debian"
    calls = [
        f"curl -s -X POST {asked}/blobs/uploads/",
        f"curl -s -X PUT -H 'Content-Type: {oci.IMAGE}' -d '{{}}' {asked}/manifests/bookworm",
        f"curl -s -X DELETE {asked}/manifests/sha256:{'0' * 64}",
        f"curl -s -X POST -u rosml: {asked}/blobs/uploads/",
        f"curl -s -X POST -u rosml:rosml {asked}/blobs/uploads/",
    ]
    lines = [f"{call} -o /dev/null -w '%{{http_code}}\\n' || true" for call in calls]
    (folder / "docker/custom.sh").write_text("\n".join([*lines, "exit 1"]))
    outcome = containerize(folder, "--base-image", published(BASE).result["reference"], "--command", "true")
    said = json.loads(outcome.out)["error"]
    assert re.findall(r"^ +(\d{3})$", said, re.MULTILINE) in (["000"] * len(calls), ["401"] * len(calls)), said


REACHES = """import socket, sys
found = []
for family, place in PLACES:
    with socket.socket(family) as asking:
        asking.settimeout(3)
        try:
            asking.connect(place)
            found.append(place)
        except OSError as error:
            print("not reached", place, error)
print(sys.argv[1], "asked; reached", found)
sys.exit(bool(found))
"""
"""What code of a repository may try: it ends with 1 if it reaches one of the places."""


@contextlib.contextmanager
def listening() -> Iterator[list[tuple[int, Any]]]:
    """Places at which this machine listens: loopback, its other addresses, and an abstract socket."""
    with contextlib.ExitStack() as stack:

        def listen(family: int, place: Any) -> Any:
            server = stack.enter_context(socket.socket(family))
            server.bind(place)
            server.listen()
            return server.getsockname()

        loopback = listen(socket.AF_INET, ("127.0.0.1", 0))
        *_others, port = listen(socket.AF_INET, ("0.0.0.0", 0))
        abstract = f"\0{secrets.token_hex(8)}"
        listen(socket.AF_UNIX, abstract)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
            asking.connect(("192.0.2.1", 9))  # sends nothing
            address = asking.getsockname()[0]
        texts = "".join(file.read_text() for file in (ROOT / ".state/run").glob("buildkitd*.toml"))
        bridges = re.findall(r'^  bridgeSubnet = "(.*)0/24"$', texts, re.M)
        yield [
            (socket.AF_INET, loopback),
            (socket.AF_UNIX, abstract),
            *((socket.AF_INET, (host, port)) for host in (address, *(f"{start}1" for start in bridges))),
        ]


def nosy(folder: Path, places: list[tuple[int, Any]]) -> None:
    """A repository whose scripts, build and test try to reach places."""
    (folder / "docker").mkdir(parents=True)
    text = REACHES.replace("PLACES", repr([(int(family), place) for family, place in places]))
    call = "python3 - {} <<'END'\n" + text + "END\n"
    (folder / "docker/before_dependency_identification.sh").write_text(
        "#!/bin/bash\nset -e\n" + call.replace("{}", "first", 1)
    )
    (folder / "docker/before_dependency_identification.sh").chmod(0o755)
    (folder / "docker/custom.sh").write_text("apt-get update\n" + call.replace("{}", "custom", 1))
    (folder / "reaches.py").write_text(text)
    (folder / "package.xml").write_text(PACKAGE.format("harm", ""))
    program = "python3 ${CMAKE_CURRENT_SOURCE_DIR}/reaches.py"
    lines = f"execute_process(COMMAND {program} build RESULT_VARIABLE code)\n"
    lines += 'if(code)\n  message(FATAL_ERROR "reached")\nendif()\n'
    lines += f"enable_testing()\nadd_test(NAME reaches COMMAND {program} test)\n"
    (folder / "CMakeLists.txt").write_text(CMAKE.format("harm") + lines)


def test_code_of_a_repository_reaches_no_service_of_the_machine(
    published: Publish, services: Services, tmp_path: Path
) -> None:
    """It reaches what is outside: apt's archive."""
    folder, name = tmp_path / "harm", f"{NAMESPACE}/harm"
    options = ("--base-image", published(BASE).result["reference"], "--image-name", name, "--command", "true")
    with listening() as places:
        nosy(folder, places)
        found = made(folder, *options, "--target", "run")
    assert found["tests"]["count"] == 1 and not found["tests"]["failures"]
    log = (services.state / f"log/containerize-{name.replace('/', '+')}@latest.log").read_text()
    assert {*re.findall(r"(\w+) asked; reached \[\]", log)} >= {"first", "custom"}


def test_a_mirror_on_the_machine_is_reached(
    published: Publish, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By steps that have the machine's network, which is said: the repository's code has it as well."""

    class Mirror(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(302)
            self.send_header("Location", f"http:/{self.path}")
            self.end_headers()

    folder = tmp_path / "harm"
    base = published(BASE).result["reference"]
    with listening() as places, http.server.ThreadingHTTPServer(("127.0.0.1", 0), Mirror) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        nosy(folder, places)
        (folder / "docker/before_dependency_identification.sh").unlink()
        monkeypatch.setenv("OS_APT_MIRROR", f"http://127.0.0.1:{server.server_port}")
        outcome = containerize(folder, "--base-image", base, "--command", "true")
        server.shutdown()
    assert "OS_APT_MIRROR: on this machine, so steps of the build share its network" in outcome.err
    assert "custom asked; reached [('127.0.0.1'" in json.loads(outcome.out)["error"]


def test_lines_of_a_build_are_no_commands(
    published: Publish, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To the terminal, or to the forge whose log they are in."""
    folder = tmp_path / "harm"
    (folder / "docker").mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format("harm", ""))
    (folder / "CMakeLists.txt").write_text(CMAKE.format("harm"))
    (folder / "docker/custom.sh").write_text(HARM.replace('exit "$1"', "exit 1"))
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    outcome = containerize(folder, "--base-image", published(BASE).result["reference"], "--command", "true")
    assert outcome.code == 1 and "the-last-line" in outcome.err
    assert not re.search(r"^\s*::error::|##\[|\x1b\]|\x1b\[8m|\x07", outcome.err, re.MULTILINE)
    assert ": :error::harm" in outcome.err, "people read it all the same"
    log = (services.state / "log/containerize-harm@latest.log").read_bytes()
    assert b"the-last-line" in log and b"\x1b]" not in log


@pytest.mark.parametrize(
    ("file", "text", "says"),
    [
        ("a/package.xml", PACKAGE.format("a", "<depend>a_typo</depend>"), " not know a_typo (asked for by a)"),
        ("a/package.xml", PACKAGE.format("a", "").replace('"2"', '"4"'), "error: a/package.xml is no manifest"),
        ("b/package.xml", PACKAGE.format("a", ""), "two packages are called a: a and b"),
        ("docker/custom.sh", "echo before; false; echo after", "the script after the installation of dependencies ended with 1"),
        ("docker/additional-debs.txt", "no-such-package", "Unable to locate package no-such-package); check its name in docker/additional-debs.txt"),
        ("docker/before_dependency_identification.sh", "#!/bin/sh\nexit 3", "identification of dependencies ended with 3"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(file: str, text: str | bytes, says: str, published: Publish, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    for path, content in (("a/package.xml", PACKAGE.format("a", "")), (file, text)):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content if isinstance(content, bytes) else content.encode())
    outcome = containerize(folder, "--base-image", published(BASE).result["reference"], "--command", "true")
    assert outcome.code == 1
    assert says in json.loads(outcome.out)["error"]
