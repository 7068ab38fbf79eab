"""An app on other base images, whose packages really changed: it is the image that a build there gives, and runs; or it is refused."""

from __future__ import annotations

import json
import secrets
import shutil
import sys
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.images.builds import contents
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set import load
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry
from tests.e2e.conftest import NAMESPACE, Run, run
from tests.e2e.images import Publish
from tests.e2e.images import build as build_folder
from tests.e2e.test_containerize import BASE, PACKAGE, RUNTIME, made

DEBIAN = """Package: libgreet1
Version: {0}
Architecture: {1}
Maintainer: nobody <nobody@example.org>
Description: greets
"""
LIBRARIES = """#!/bin/bash
set -eu
folder=$(mktemp -d)
cd "$folder"
mkdir -p deb/DEBIAN deb/usr/lib deb/usr/include /opt/vendor
cp /in/control deb/DEBIAN/control
cp /in/libgreet.so.1 deb/usr/lib/
ln -s libgreet.so.1 deb/usr/lib/libgreet.so
dpkg-deb --build deb greet.deb
dpkg --install greet.deb
cp /in/libvendor.so /opt/vendor/
rm -r "$folder"
"""
RUN = secrets.token_hex(4)
"""Makes images of this run: tags that an earlier one left point at others."""

NODE = """#include <stdio.h>
const char *greeting(void);
int vendor(void);
int main(void) { printf("%s %d\\n", greeting(), vendor()); return 0; }
"""
CMAKE = """cmake_minimum_required(VERSION 3.16)
project(greeter C)
find_package(catkin REQUIRED)
catkin_package()
add_executable(greet greet.c)
set_target_properties(greet PROPERTIES BUILD_RPATH /opt/vendor INSTALL_RPATH /opt/vendor)
target_link_libraries(greet /usr/lib/libgreet.so.1 /opt/vendor/libvendor.so)
install(TARGETS greet DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""


def base(
    services: Services, compiler: str, below: str, name: str, folder: Path, version: str, greeting: str, vendor: int
) -> str:
    """Pushes a base image with a package of a library, and a library without one, both in C; gives its name.

    Args:
        compiler: an image with a compiler. below: the base image of this one. greeting: the function of the library. vendor: what the
            other one returns.
    """
    folder.mkdir()
    architecture = run("dpkg", "--print-architecture").out.strip()
    (folder / "control").write_text(DEBIAN.format(version, architecture))
    (folder / "greet.c").write_text(f'const char *{greeting}(void) {{ return "hello of {version} in {RUN}"; }}\n')
    (folder / "vendor.c").write_text(f"int vendor(void) {{ return {vendor}; }}\n")
    (folder / "install.sh").write_text(LIBRARIES)
    (folder / "Dockerfile").write_text(
        f"""FROM {compiler} AS built
COPY . /in
WORKDIR /in
RUN gcc -shared -fPIC -Wl,-soname,libgreet.so.1 -o libgreet.so.1 greet.c && \\
    gcc -shared -fPIC -Wl,-soname,libvendor.so -o libvendor.so vendor.c && chmod 755 install.sh
FROM {below}
RUN --mount=type=bind,from=built,source=/in,target=/in /in/install.sh
"""
    )
    place = f"{services.registry}/{NAMESPACE}/ros"
    output = f"type=image,name={place}:{name},push=true,{COMPRESSION}"
    command = [*services.buildx, "build", "--provenance=false", "--output", output, str(folder)]
    outcome = run(*command, env=services.environment())
    assert outcome.code == 0, outcome.err
    with Registry(services.registry) as registry:
        repository = f"{NAMESPACE}/ros"
        images = load.load(ROOT / "matrix.yaml")
        contents.attach(services, images, registry, [(repository, registry.head(repository, name))], lambda _: None)
    return f"{place}:{name}"


def rebased(app: str, *options: str) -> Run:
    return run(sys.executable, str(ROOT / "src"), "rebase", app, "--json", *options)


def digest(services: Services, name: str) -> str:
    where = references.parse(name)
    with Registry(services.registry) as registry:
        return registry.head(where.repository, where.reference)


def test_an_app_moves_to_another_base_image(published: Publish, services: Services, tmp_path: Path) -> None:
    core, runtime = published(BASE).reference, published(RUNTIME).reference

    def night(number: int, kinds: str, greeting: str, vendor: int, name: str = "night") -> str:
        """Base images of a night, with compilers and without: their tags move. Gives the name of the last one."""
        for kind in kinds.split():
            folder, below = tmp_path / f"{name}-{kind}-{number}", core if kind == "core" else runtime
            found = base(services, core, below, f"{name}-{kind}", folder, f"1.{number}", greeting, vendor)
        return found

    folder, name = tmp_path / "robot", f"{NAMESPACE}/mover"
    shutil.copytree(ROOT / "examples/ros1/src", folder / "src")
    greeter = folder / "src/greeter"
    greeter.mkdir()
    (greeter / "package.xml").write_text(PACKAGE.format("greeter", ""))
    (greeter / "CMakeLists.txt").write_text(CMAKE)
    (greeter / "greet.c").write_text(NODE)
    onto = night(0, "run core", "greeting", 1)

    def build(tag: str) -> dict[str, Any]:
        options = ["--image-name", name, "--image-tag", tag, "--target", "run", "--no-tests", "--enable-slim"]
        options += ["--command", "rosrun greeter greet", "--slim-base-image", onto.replace("-core", "-run")]
        return made(folder, "--base-image", onto, *options)

    first = build("first")
    run_image, slim_image = (first[target]["reference"] for target in ("run", "slim"))
    before = digest(services, onto)
    night(1, "run core", "greeting", 2)

    moved = {}
    for target, image in (("run", run_image), ("slim", slim_image)):
        done = rebased(image, "--tag", f"{image}-moved")
        assert done.code == 0, done.err
        moved[target] = json.loads(done.out)
        assert moved[target]["verdict"] == "check by link" and moved[target]["linked"], done.err
        assert "check by link: libvendor.so changed" in done.err, "the other one has a name that says enough"
        assert digest(services, f"{image}-moved") == moved[target]["digest"]
    (tmp_path / "chk").mkdir()
    (tmp_path / "chk/Dockerfile").write_text(
        "".join(
            f"FROM {moved[target]['reference']} AS {target}\n"
            f"RUN /entrypoint.sh bash -c \"$DEFAULT_CMD\" | grep 'hello of 1.1 in {RUN} 2' && /entrypoint.sh rospack find compass\n"
            for target in moved
        )
        + "FROM scratch\nCOPY --from=run /tini /1\nCOPY --from=slim /tini /2\n"
    )
    build_folder(services, tmp_path / "chk")

    gone = night(2, "core", "salute", 2, "gone")
    refused = rebased(run_image, "--base", gone)
    assert refused.code == 2 and "uses greeting, which no library of the base image has any more" in refused.err
    assert digest(services, run_image) == first["run"]["digest"], "the tag stays"

    again = build("again")
    for target in moved:
        assert again[target]["digest"] == moved[target]["digest"], "as a build on that base image gives it"

    small = rebased(run_image, "--tag", f"{run_image}-small", "--no-sbom", "--check", "metadata")
    assert small.code == 0 and json.loads(small.out)["uploaded"] < 20_000, small.err
    back = rebased(f"{run_image}-moved", "--base", f"{onto.rpartition(':')[0]}@{before}")
    assert back.code == 0 and json.loads(back.out)["base_digest"] == before, back.err
    tested = rebased(run_image, "--check", "run", "--command", "rosrun greeter greet | grep 'hello of 1.0'")
    assert tested.code == 1 and digest(services, run_image) == first["run"]["digest"], "it failed, and the tag stays"
