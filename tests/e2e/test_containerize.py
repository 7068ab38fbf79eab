"""Apps, built, tested and entered: the example as its folder stands, and a repository that asks for everything at once."""

from __future__ import annotations

import dataclasses
import functools
import json
import os
import random
import re
import secrets
import shlex
import shutil
import signal
import subprocess
import sys
import tarfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order as build
from rosml.containerize.build.result import Result
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry
from tests import recording, regctl
from tests.e2e.app_builds import (
    BASE,
    CANARY,
    CMAKE,
    PACKAGE,
    RUNTIME,
    build_app,
    commit,
    containerize,
    hears,
    log_of,
    package,
    pinned,
    repos,
    stages_run,
    write,
)
from tests.e2e.calls import NAMESPACE, rosml
from tests.e2e.images import PLATFORM, Publish, build_file, config, layers
from tests.recording import COMMANDS

PACKAGES_WITHOUT_A_SCAN = """RUN --mount=type=bind,source={0}-apt,target=/said \\
    {{ dpkg-query --show --showformat '${{Package}} ${{Version}}\\n'; \\
      awk '/^Package:/ {{p = $2}} /^Version:/ {{print p, $2}}' /var/lib/dpkg/status.d/*; }} | LC_ALL=C sort | diff - /said
"""
"""A step that compares the packages in an SBOM with what dpkg says in its image."""

FILES_WITHOUT_A_SCAN = """RUN --mount=type=bind,from={1},target=/listed --mount=type=bind,source={0}-files,target=/said.gz \\
    find /listed -mindepth 1 \\( -type f -o -type l \\) ! \\( -path '*/rosml/constraints.d/*' -empty \\) -printf '%P\\n' | \\
      LC_ALL=C sort >/found && zcat /said.gz | diff /found -
"""
"""A step that compares the list of files that is attached to an image with its files."""

WITHOUT_A_SCAN = PACKAGES_WITHOUT_A_SCAN + FILES_WITHOUT_A_SCAN

SBOM, FILES = "application/vnd.cyclonedx+json", "application/vnd.rosml.files.v1"


@dataclass(frozen=True)
class Compass:
    """The example as `rosml init` sets it up, with what was said of its images, and the options of that call."""

    folder: Path
    options: dict[str, str]
    result: dict[str, Any]

    @property
    def name(self) -> str:
        return self.options["image-name"]


@pytest.fixture(scope="module")
def compass(base: str, published: Publish, services: Services, tmp_path_factory: pytest.TempPathFactory) -> Compass:
    folder, name = tmp_path_factory.mktemp("app") / "compass", f"{NAMESPACE}/example"
    shutil.copytree(ROOT / "examples/ros1", folder)
    (folder / ".env").unlink()  # rosml init writes another one, which names the command
    source = folder / "src/compass/src/compass.cpp"
    source.write_text(source.read_text() + f"// {secrets.token_hex()}\n")  # as never before
    rosml("init", str(folder), "--yes", "--component", "core")
    with (folder / ".env").open("a") as file:
        file.write(f"GIT_HTTPS_PASSWORD={CANARY}\n")
    commit(folder)
    options = {"base-image": base, "image-name": name, "cache": f"{services.registry}/{name}-cache"}
    options |= {"enable-slim": "true", "slim-base-image": published(RUNTIME).reference}
    return Compass(folder, options, build_app(folder, options))


def attached(services: Services, image: dict[str, Any], artifact_type: str) -> bytes:
    """What is attached to an image for one platform."""
    repository = references.parse(image["reference"]).repository
    with Registry(services.registry) as registry:
        [entry] = registry.referrers(repository, image["digest"], artifact_type)
        manifest = registry.manifest(repository, entry["digest"])
        assert manifest
        return registry.blob(repository, manifest.content["layers"][0]["digest"])


def test_the_example(compass: Compass, base: str, published: Publish, services: Services, tmp_path: Path) -> None:
    result = compass.result
    assert result["packages"] == ["compass"]
    assert result["installed"] == ["libangles-dev:all", "python3-angles:all"]
    for tests in ("tests", "slim_tests"):
        assert result[tests]["count"] == 2 and not result[tests]["failures"]
    assert list(Path(result["reports"]).rglob("gtest-*.xml"))
    run_image, dev_image, slim_image = (result[target]["reference"] for target in ("run", "dev", "slim"))
    assert layers(services, run_image)[:-1] == layers(services, base), "the base image and one layer of the app"
    assert layers(services, slim_image)[:-1] == published(RUNTIME).layers
    whole, slim = (sum(layer.size for layer in regctl.layers(services, name)) for name in (run_image, slim_image))
    assert slim < 0.45 * whole
    for reference in (run_image, dev_image, slim_image):
        assert CANARY not in json.dumps(config(services, reference))
    assert CANARY not in log_of(services, compass.name)

    (tmp_path / "chk").mkdir()
    for target in ("run", "slim"):
        (tmp_path / f"chk/{target}-files").write_bytes(attached(services, result[target], FILES))
    for target in ("run", "slim", "dev"):
        document = json.loads(attached(services, result[target], SBOM))
        apt = [item for item in document["components"] if item.get("purl", "").startswith("pkg:deb/")]
        lines = sorted(f"{item['name']} {item['version']}" for item in apt)
        (tmp_path / f"chk/{target}-apt").write_text("\n".join([*lines, ""]))
        [ros] = [item for item in document["components"] if item.get("purl", "").startswith("pkg:generic/ros/")]
        assert (ros["name"], ros["licenses"]) == ("compass", [{"license": {"id": "Apache-2.0"}}])
    build_file(
        services,
        tmp_path / "chk",
        f"""FROM {run_image} AS run
{hears(4, "/said")} && \\
    sort -u /said && test "$(grep -c -E "east|north|west|south" /said)" -ge 4
RUN test -e /var/lib/dpkg/status.d/python3-angles && ! grep -q libangles /var/lib/dpkg/status && \\
    test ! -e /docker-ros/ws/src && test ! -e /docker-ros/ws/build
{WITHOUT_A_SCAN.format("run", run_image)}
FROM {slim_image} AS slim
# After the other one: builders may run both steps at once, on one network.
COPY --from=run /said /said
{hears(1, "/slim")} && \\
    grep -E "east|north|west|south" /slim && ! command -v g++ && ! find /usr/include -type f | grep . && test -e /var/lib/dpkg/status.d/python3-angles && \\
    ! test -e /var/lib/dpkg/status.d/libangles-dev
{WITHOUT_A_SCAN.format("slim", slim_image)}
FROM {dev_image} AS dev
{PACKAGES_WITHOUT_A_SCAN.format("dev")}
RUN test -e /docker-ros/ws/src/target/src/compass/package.xml && ! grep -r {CANARY} /docker-ros && \\
    test -z "$(find /docker-ros -name .git -o -name .env)"
RUN DOCKER_UID=1000 DOCKER_GID=1000 /entrypoint.sh bash -c 'cd ~/ws && colcon build && . install/setup.bash && rospack find compass'
FROM scratch
COPY --from=run /said /
COPY --from=slim /slim /
COPY --from=dev /tini /
""",
    )


def test_the_dossiers_of_an_app_and_of_its_base_image(compass: Compass, base: str, tmp_path: Path) -> None:
    """They have what is attached to real images, with the shares of fields that docs/use/dossier.md speaks of."""
    for reference, more in ((base, set()), (compass.result["run"]["reference"], {"compass", "python3-angles"})):
        folder = tmp_path / f"{len(more)}-dossier"
        done = rosml("dossier", reference, "--platform", PLATFORM, "--output", str(folder), "--json")
        facts = json.loads(done.out)
        document = json.loads((folder / "sbom.cdx.json").read_text())
        names = {item["name"] for item in document["components"]}
        assert names >= {"bash", "ros-core", *more} and facts["components"] == len(document["components"]) > 400
        fields = {field["name"]: field for field in facts["fields"]}
        assert all(fields[name]["have"] == facts["components"] for name in ("name", "version", "dependencies"))
        assert all(lack["reason"] for field in fields.values() for lack in field["lacks"])
        ends = {end["title"]: end["day"] for end in facts["support"]}
        assert ends == {"Python": "2027-10-31", "Debian": "2028-06-30", "ROS": "2028-06-30"}
        assert (folder / "containerize.lock").exists() == bool(more)
        page = (folder / "index.html").read_text()
        assert all(f"{name} " in page for name in more) and "no text" not in (folder / "licences.txt").read_text()
        rosml("dossier", reference, "--platform", PLATFORM, "--output", str(folder), "--format", "spdx")
        packages = json.loads((folder / "sbom.spdx.json").read_text())["packages"]
        assert {item["name"] for item in packages[1:]} == names and not (folder / "sbom.cdx.json").exists()


def test_what_the_readme_shows_is_what_is_said(published: Publish, services: Services, tmp_path: Path) -> None:
    """The recording's build and its container; unit/project/test_recording.py has its other command. An image has another
    name here."""
    recording.package(tmp_path, fresh=False)
    published(BASE)
    cast, place = recording.read(), f"{services.registry}/{NAMESPACE}"
    typed = COMMANDS["containerize"].replace(f"ros:{BASE}", f"{place}/ros:{BASE}")
    typed = typed.replace("./rosml", f"{sys.executable} {ROOT / 'src'}")
    # --push: into the registry, as it was recorded, also if Docker is the builder here.
    now = recording.recorded(f"{typed} --push --image-name {place}/compass", tmp_path, {})
    file = f"{place}/compass".replace(":", "=").replace("/", "+")
    names = {f"{NAMESPACE}/ros": "rosml/ros", f"{NAMESPACE}/": "", file: "compass"}
    output = functools.reduce(lambda text, name: text.replace(name, names[name]), names, now.output)
    shown = re.sub(r"where .*\n +.*\n", "", cast["containerize"].output.replace("\r", ""))  # nothing was pushed there
    assert recording.stable(output) == recording.stable(shown)
    logs = (services.state / "log").glob(f"containerize-{file}@latest*.log")
    logged = set[str]().union(*(recording.steps(log.read_text()) for log in logs))
    shown_steps = recording.steps(cast["containerize"].output)
    assert [step for step in shown_steps if not any(name.startswith(step) for name in logged)] == []
    build_file(
        services,
        tmp_path,
        f"FROM {recording.image(now)}\nRUN echo {shlex.quote(cast['run'].output.strip())} >/expected && "
        f"/entrypoint.sh {COMMANDS['run']} | diff /expected -\n",
    )


def test_a_machine_that_has_nothing_builds_nothing_twice(
    compass: Compass, services: Services, beside: Services
) -> None:
    """What another one has finished is in the registry: of an unchanged app all, of a changed one all but the app."""
    first, name, lines = compass.result["run"]["digest"], compass.name, list[str]()
    fresh = dataclasses.replace(services, builder=beside.builder)

    def on_the_other(**changes: str) -> Result:
        values = app_inputs.values(compass.options | changes, compass.folder, {})
        return build.build_images(build.new_call(compass.folder, values, {}, fresh, lines.append))

    again = on_the_other()
    assert {image.target: image.digest for image in again.images}["run"] == first
    assert f"nothing to build: {compass.options['cache']} has it" in lines
    assert again.tests.target.count == 2 and again.outcome.packages == ["compass"]
    assert "RUN" not in log_of(services, name, "-images"), "no step at all"

    source = compass.folder / "src/compass/src/compass.cpp"
    source.write_text(source.read_text().replace('"west"', '"WEST"'))
    with pytest.raises(RosmlError, match="1 of 2 tests failed; no image was made") as caught:
        on_the_other()
    assert "Compass.Quarters" in caught.value.message
    of_the_app = {"sources", "built", "tested", "app-files", "dev-files", "slim-files", "slim-tested"}
    assert {"built", "tested"} <= stages_run(services, name) <= of_the_app, (
        "no identification, no upstream, no packages"
    )
    with Registry(services.registry) as registry:
        assert registry.head(name, "latest") == first, "the tag stays where it was"
    untested = on_the_other(tests="false")
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
        output = tmp_path / f"{used}.tar"
        options = ("--target=results", f"--build-arg=DOWNSTREAM={used}", f"--output=type=tar,dest={output}")
        subprocess.run([*services.buildx, "build", *options, tmp_path], env=services.environment(), check=True)
        with tarfile.open(output) as archive:
            assert sorted(entry.name for entry in archive if entry.isfile()) == sorted(expected)


def test_apps_and_a_part_at_once_repeat_no_step(
    base: str, published: Publish, services: Services, tmp_path: Path
) -> None:
    """What two apps both need is made once, and neither waits for the other or for the part, which is the same as before."""
    image, name = published("ros1-bookworm-core-tensorflow-cpu"), "common-cpu-py311"
    # Another number each time that it runs, and the same file for both apps.
    script = {"docker/custom.sh": f"# {tmp_path}\necho made-$RANDOM-$RANDOM\n"}
    folders = [package(tmp_path / name, files=script) for name in ("first", "second")]
    names = [f"{NAMESPACE}/{folder.name}" for folder in folders]
    options = {"base-image": base, "command": "true", "target": "run"}
    with ThreadPoolExecutor() as pool:
        part = pool.submit(rosml, "part", name, "--namespace", NAMESPACE, "--platform", PLATFORM, "--again", "--json")
        apps = [
            pool.submit(build_app, folder, options | {"image-name": name})
            for folder, name in zip(folders, names, strict=True)
        ]
        assert [app.result()["packages"] for app in apps] == [["first"], ["second"]]
        digest, _ = json.loads(part.result().out)[0]["layers"][PLATFORM]
    assert digest == image.part_layers[image.image.parts.index(name)]
    numbers = [re.findall(r"\bmade-\d+-\d+", log_of(services, name)) for name in names]
    assert len({*numbers[0], *numbers[1]}) == len({*numbers[0]}) > 0, numbers
    assert all(app.result()["waited"] == 0 for app in apps)


def test_an_app_is_a_base_image_as_well(compass: Compass, services: Services, tmp_path: Path) -> None:
    """The second one's layer has what the second one has built, and finds the first one. Built again, nothing of it runs."""
    first = pinned(compass.result["run"])
    folder = package(tmp_path / "upper", "<depend>compass</depend>")
    options = {"base-image": first, "image-name": f"{NAMESPACE}/upper", "command": "true", "target": "run"}
    second = pinned(build_app(folder, options)["run"])
    again = pinned(build_app(folder, options)["run"])
    assert (again, stages_run(services, options["image-name"])) == (second, set())
    assert layers(services, second)[:-1] == layers(services, first)
    find = "RUN /entrypoint.sh bash -c 'rospack find compass && rospack find upper'"
    checks = f"{find} && test -e install/upper/share/upper/said -a -e install/compass/share/compass\n"
    build_file(services, tmp_path / "chk", f"FROM {second}\n{checks}")


def test_a_framework_is_added_to_an_app(
    compass: Compass, published: Publish, services: Services, tmp_path: Path
) -> None:
    """Without a build and in some kilobytes: by the list of files that is attached to the app."""
    place, app = f"{services.registry}/{NAMESPACE}", pinned(compass.result["run"])
    parts = [f"{place}/part:{name}" for name in published("ros1-bookworm-core-tensorflow-cpu").image.parts]
    tag = f"{place}/example:learned"
    joined = rosml("join", app, *parts, "--tag", tag, "--json")
    assert json.loads(joined.out)["uploaded"] < 15_000
    command = [word for word in config(services, app)["Env"] if word.startswith("DEFAULT_CMD=")]
    assert command and {*command} <= {*config(services, tag)["Env"]}
    program = "import angles, tensorflow; print(tensorflow.constant(1) + 1)"
    checks = f"/entrypoint.sh rospack find compass | grep ws/install && /entrypoint.sh python3 -c '{program}'"
    build_file(services, tmp_path / "chk", f"FROM {tag}\nRUN {checks}\n")


def test_a_lock_file_holds_what_an_image_is_built_from(base: str, services: Services, tmp_path: Path) -> None:
    upstream = package(tmp_path / "upstream")
    commit(upstream)
    requests = {"docker/additional-debs.txt": "tree\n", "docker/additional-pip-requirements.txt": "toolz\n"}
    folder = package(tmp_path / "robot", files={".repos": repos(upstream), **requests})
    options = {"base-image": base, "image-name": f"{NAMESPACE}/locked", "command": "true", "target": "run"}

    first, file = build_app(folder, options, "--lock"), folder / "containerize.lock"
    lock = json.loads(file.read_text())
    [(architecture, debs)] = lock["apt"].items()
    [toolz] = lock["pip"][architecture]
    assert "tree" in debs and re.fullmatch(r"toolz==\S+ --hash=sha256:[0-9a-f]{64}", toolz)

    (upstream / "new").touch()
    commit(upstream)
    again = build_app(folder, options)
    assert again["run"]["digest"] == first["run"]["digest"]
    label = config(services, again["run"]["reference"])["Labels"]["io.rosml.lock"]
    assert json.loads(label) | {"downstream": {}} == lock, "whoever has the image has its lock file"

    debs["tree"] = "0.1-1"
    file.write_text(json.dumps(lock))
    write(folder, {"docker/additional-debs.txt": "tree\nsl\n"})
    error = json.loads(containerize(folder, options).out)["error"]
    assert re.search(r"the lock file does not have what apt installed: .*sl .*, tree ", error) and "--lock" in error

    debs["tree"] = first["lock"]["apt"][architecture]["tree"]
    lock["pip"][architecture] = [re.sub("sha256:.*", f"sha256:{'0' * 64}", toolz)]
    file.write_text(json.dumps(lock))
    write(folder, requests)
    outcome = containerize(folder, options)
    assert outcome.code == 1 and "toolz" in outcome.out


@pytest.mark.full(proof="kills")
def test_a_call_that_is_killed_is_finished_by_the_next(base: str, services: Services, tmp_path: Path) -> None:
    """SIGKILL at any moment, of rosml alone and of all that it started: tags stay on whole images."""
    upstream, name = package(tmp_path / "upstream"), f"{NAMESPACE}/killed"
    commit(upstream)
    folder = package(tmp_path / "robot", files={".repos": repos(upstream)})
    options = {"base-image": base, "image-name": name, "command": "true", "cache": f"{services.registry}/{name}-cache"}
    words = [word for option, value in options.items() for word in (f"--{option}", value)]
    build_app(folder, options)
    chance, killed, tags = random.Random(36), 0, ("latest", "latest-dev")
    for number in range(20):
        (upstream / "new").write_text(f"{number}\n")
        commit(upstream)
        (folder / "CMakeLists.txt").write_text(
            CMAKE.format("robot").replace("GREETING", f"GREETING}} {number} ${{GREETING")
        )
        process = subprocess.Popen(
            [sys.executable, str(ROOT / "src"), "containerize", str(folder), *words],
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
    image = build_app(folder, options)["run"]["reference"]
    build_file(services, tmp_path / "chk", f"FROM {image}\nRUN grep {number} install/robot/share/robot/said\n")


@pytest.mark.full(proof="wheels")
def test_the_example_of_ros_2(published: Publish, services: Services, tmp_path: Path) -> None:
    """On ROS 2 from wheels, of which rosdep knows nothing on Debian, and which has no command ros2."""
    folder = tmp_path / "counter"
    shutil.copytree(ROOT / "examples/ros2", folder)
    rules = "rclpy: {debian: []}\nstd_msgs: {debian: []}\npython3-pytest: {debian: [python3-pytest]}\n"
    options = {
        "base-image": published("jazzy-wheels-core").reference,
        "image-name": f"{NAMESPACE}/counter",
        "target": "run",
    }
    options |= {"rosdep-index": str(write(tmp_path / "index", {"rosdep/base.yaml": rules}))}
    options |= {"command": "/docker-ros/ws/install/counter/lib/counter/count"}
    result = build_app(folder, options)
    assert result["installed"] == [], "nothing of Debian's ROS 1"
    assert result["tests"]["count"] == 1 and not result["tests"]["failures"]
    build_file(
        services,
        tmp_path / "chk",
        f"""FROM {result["run"]["reference"]}
RUN (timeout --signal=INT 8 /tini -s -- /entrypoint.sh bash -c 'exec bash -c "$DEFAULT_CMD"' || true) 2>&1 | tee /said && \
    grep "round: 20" /said
""",
    )


@pytest.fixture
def everything(tmp_path: Path) -> Path:
    """A repository that uses each file which it may have, and upstream sources that name others."""
    further = package(tmp_path / "further")
    base = package(tmp_path / "base", "<depend>further</depend>", files={"more.repos": repos(further)})
    uses = "find_package(wanted REQUIRED)\nenable_testing()\n"
    uses += "add_test(NAME uses COMMAND python3 -c \"import toml; open('${wanted_DIR}/../said')\")\n"
    user = package(tmp_path / "user", "<depend>wanted</depend><test_depend>python3-toml</test_depend>", uses)
    for upstream in (further, base, user):
        commit(upstream)
    package(tmp_path / "robot/wanted", "<depend>base</depend>")
    package(tmp_path / "robot/unwanted", "<depend>nobody_has_this</depend>")
    files = {
        ".repos": repos(base),
        "uses.repos": repos(user),
        ".dockerignore": "*.bag\n",
        "docker/additional-files/hello": "from a file\n",
        "docker/additional-debs.txt": "# to look around\ntree  # and count\nlibcap2-bin\niputils-ping\n",
        "docker/additional-pip-requirements.txt": "toolz  # small\n",
        "docker/blacklisted-packages.txt": "unwanted  # needs what nobody has\n",
        "docker/before_dependency_identification.sh": "#!/usr/bin/env python3\nfrom pathlib import Path\n"
        "path = Path('src/target/wanted/package.xml')\n"
        "path.write_text(path.read_text().replace('</package>', '<depend>angles</depend></package>'))\n",
        "docker/before_dependency_installation.sh": "apt-get install --yes sl >/dev/null\ntouch /opt/before\n",
        "docker/custom.sh": "cp /docker-ros/additional-files/hello /opt/after\npython3 -c 'import toolz'\n"
        "sed -i s/Debian/Zebian/ /etc/motd\napt-get purge --yes less\n"
        "gcc -shared -Wl,-soname,libmine.so.1 -o /usr/local/lib/libmine.so.1.0 -x c /dev/null && ldconfig\n"
        "install -d --owner=games /var/log/mine && mkdir -p ~/.cache/model && touch ~/.cache/model/weights\n",
    }
    return write(tmp_path / "robot", files)


def test_a_repository_may_ask_for_everything(base: str, services: Services, everything: Path, tmp_path: Path) -> None:
    """Its packages may also replace what the base image has, or remove it."""
    lists = {
        "rosdep/base.yaml": "python3-toml: {debian: [python3-toml]}\n",
        "index-v4.yaml": "distributions: {noetic: {distribution: [noetic/distribution.yaml]}}\n",
        "noetic/distribution.yaml": "repositories: {}\n",
    }
    place = f"{services.registry}/{NAMESPACE}"
    rosml("publish", "rosdep", str(write(tmp_path / "rosdistro", lists)), "--registry", place)
    options = {"base-image": base, "image-name": f"{NAMESPACE}/everything", "downstream-workspace": "uses.repos"}
    options |= {"command": "# several lines\necho $((6 * 7)) ${NOTHING:-7}\ncat /opt/after"}
    result = build_app(everything, options | {"cmake-args": "-DGREETING='two words'"})
    assert result["packages"] == ["base", "further", "wanted"]
    assert result["downstream_tests"] == {"count": 1, "skipped": 0, "failures": []}, "of what uses them"
    moving = {repository["path"]: repository["moving"] for repository in result["upstream"]}
    assert moving == {"base": True, "further": True}
    installed, replaced = (
        {re.sub(":(arm64)$", ":amd64", name) for name in result[key]} for key in ("installed", "replaced")
    )
    assert {"tree:amd64", "sl:amd64", "python3-angles:all"} <= installed and "less:amd64" in replaced
    image, below = result["run"]["reference"], layers(services, base)
    assert layers(services, image)[: len(below)] == below
    lines = """FROM {} AS {}
RUN command -v tree && python3 -c 'import toolz' && test -e /opt/before && cat /opt/after && grep Zebian /etc/motd
RUN python3 -c 'import ctypes; ctypes.CDLL("libmine.so.1")' && getcap /usr/bin/ping | grep net_raw
RUN test "$(stat --format %U /var/log/mine)" = games && test -e /root/.cache/model/weights
RUN ! command -v less && ! dpkg -s less
"""
    build_file(
        services,
        tmp_path / "chk",
        lines.format(image, "run")
        + """RUN test "$(/entrypoint.sh bash -c 'exec bash -c "$DEFAULT_CMD"' | tr '\\n' /)" = '42 7/from a file/' && \\
    test "$(cat /docker-ros/ws/install/*/share/*/said | sort -u)" = "two words" && test ! -e /docker-ros/ws/install/unwanted
"""
        + lines.format(result["dev"]["reference"], "dev")
        + """RUN cd /docker-ros/ws/src && test -e upstream/base/package.xml -a -e upstream/further/package.xml && \\
    grep angles target/wanted/package.xml && test ! -e target/unwanted && ! python3 -c 'import toml'
FROM scratch
COPY --from=run /tini /run
COPY --from=dev /tini /dev
""",
    )


@pytest.mark.parametrize(
    ("file", "text", "says"),
    [
        ("a/package.xml", PACKAGE.format("a", "").replace('"2"', '"4"'), "error: a/package.xml is no manifest"),
        ("b/package.xml", PACKAGE.format("a", ""), "two packages are called a: a and b"),
        ("docker/additional-debs.txt", "no-such-package", "Unable to locate package no-such-package); check its name in"),
        ("docker/before_dependency_identification.sh", "#!/bin/sh\nexit 3", "identification of dependencies ended with 3"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(file: str, text: str, says: str, base: str, tmp_path: Path) -> None:
    files = {"a/package.xml": PACKAGE.format("a", ""), "a/CMakeLists.txt": "", "b/CMakeLists.txt": ""}
    folder = write(tmp_path / "robot", files | {file: text})
    outcome = containerize(folder, {"base-image": base, "command": "true"})
    assert outcome.code == 1 and says in json.loads(outcome.out)["error"]
