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
from rosml.registry.client import Registry
from tests import regctl
from tests.e2e.app_builds import BASE, RUNTIME, build_app, package
from tests.e2e.calls import NAMESPACE, Run, run
from tests.e2e.images import NATIVE, Publish, build_file, buildx

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


def push_base(
    services: Services, stages: tuple[str, str], name: str, folder: Path, version: str, functions: tuple[str, int]
) -> str:
    """Pushes a base image with a package of a library, and a library without one, both in C; gives its name.

    Args:
        stages: an image with a compiler, and the base image of this one.
        functions: the name of the library's function, and what that of the other one returns.
    """
    compiler, below = stages
    greeting, number = functions
    folder.mkdir()
    (folder / "control").write_text(DEBIAN.format(version, NATIVE))
    (folder / "greet.c").write_text(f'const char *{greeting}(void) {{ return "hello of {version} in {RUN}"; }}\n')
    (folder / "vendor.c").write_text(f"int vendor(void) {{ return {number}; }}\n")
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
    repository = f"{NAMESPACE}/ros"
    place = f"{services.registry}/{repository}:{name}"
    buildx(services, "--provenance=false", "--output", f"type=image,name={place},push=true,{COMPRESSION}", str(folder))
    with Registry(services.registry) as registry:
        image = (repository, registry.head(repository, name))
        contents.attach(services, load.load(ROOT / "matrix.yaml"), registry, [image], lambda _: None)
    return place


def rebased(app: str, *options: str) -> Run:
    return run(sys.executable, str(ROOT / "src"), "rebase", app, "--json", *options)


def test_an_app_moves_to_another_base_image(published: Publish, services: Services, tmp_path: Path) -> None:
    core, runtime = published(BASE).reference, published(RUNTIME).reference

    def night(number: int, greeting: str, vendor: int, name: str = "night", kinds: str = "run core") -> str:
        """Base images of a night, with compilers and without: their tags move. Gives the name of the last one."""
        for kind in kinds.split():
            folder, stages = tmp_path / f"{name}-{kind}-{number}", (core, core if kind == "core" else runtime)
            image = push_base(services, stages, f"{name}-{kind}", folder, f"1.{number}", (greeting, vendor))
        return image

    def digest(reference: str) -> str:
        return regctl.digest(services, reference)

    shutil.copytree(ROOT / "examples/ros1/src", tmp_path / "robot/src")
    package(tmp_path / "robot/src/greeter", files={"CMakeLists.txt": CMAKE, "greet.c": NODE})
    onto = night(0, "greeting", 1)

    def build(tag: str) -> dict[str, Any]:
        options = {"image-name": f"{NAMESPACE}/mover", "image-tag": tag, "target": "run", "enable-slim": "true"}
        options |= {"base-image": onto, "slim-base-image": onto.replace("-core", "-run")}
        return build_app(tmp_path / "robot", options | {"command": "rosrun greeter greet"}, "--no-tests")

    first = build("first")
    run_image, slim_image = (first[target]["reference"] for target in ("run", "slim"))
    before = digest(onto)
    night(1, "greeting", 2)

    moved = {}
    for target, image in (("run", run_image), ("slim", slim_image)):
        done = rebased(image, "--tag", f"{image}-moved")
        assert done.code == 0, done.err
        moved[target] = json.loads(done.out)
        assert moved[target]["verdict"] == "check by link" and moved[target]["linked"], done.err
        assert "check by link: libvendor.so changed" in done.err, "the other one has a name that says enough"
        assert digest(f"{image}-moved") == moved[target]["digest"]
    build_file(
        services,
        tmp_path / "chk",
        "".join(
            f"FROM {moved[target]['reference']} AS {target}\n"
            f"RUN /entrypoint.sh bash -c \"$DEFAULT_CMD\" | grep 'hello of 1.1 in {RUN} 2' && /entrypoint.sh rospack find compass\n"
            for target in moved
        )
        + "FROM scratch\nCOPY --from=run /tini /1\nCOPY --from=slim /tini /2\n",
    )

    refused = rebased(run_image, "--base", night(2, "salute", 2, "gone", "core"))
    assert refused.code == 2 and "uses greeting, which no library of the base image has any more" in refused.err
    assert digest(run_image) == first["run"]["digest"], "the tag stays"

    again = build("again")
    for target in moved:
        assert again[target]["digest"] == moved[target]["digest"], "as a build on that base image gives it"

    small = rebased(run_image, "--tag", f"{run_image}-small", "--no-sbom", "--check", "metadata")
    assert small.code == 0 and json.loads(small.out)["uploaded"] < 20_000, small.err
    back = rebased(f"{run_image}-moved", "--base", f"{onto.rpartition(':')[0]}@{before}")
    assert back.code == 0 and json.loads(back.out)["base_digest"] == before, back.err
    tested = rebased(run_image, "--check", "run", "--command", "rosrun greeter greet | grep 'hello of 1.0'")
    assert tested.code == 1 and digest(run_image) == first["run"]["digest"], "it failed, and the tag stays"
