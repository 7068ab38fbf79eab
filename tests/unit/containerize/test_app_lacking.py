"""What an install space lacks in an image: found by reading its files."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from fakes.apps import Robot, robot, services
from fakes.stubs import script_of_a_build
from rosml.base.errors import RosmlError
from rosml.containerize.build.verdict import unstarted

__all__ = ["robot", "services"]

WS = "docker-ros/ws"
X86, ARM = 62, 183


@pytest.fixture
def script() -> ModuleType:
    return script_of_a_build("containerize/lacking.py")


def elf(needed: Iterable[str] = (), machine: int = X86, wide: bool = True, order: str = "<") -> bytes:
    """A library of two segments: one that is loaded at 0x1000, and in it what is to be known of the library."""
    names = b"\0" + b"".join(name.encode() + b"\0" for name in needed)
    number, (header, entry) = "Q" if wide else "I", ((64, 56) if wide else (52, 32))
    start = header + 2 * entry
    places, place = [], 1
    for name in needed:
        places.append(place)
        place += len(name) + 1
    tags = [(5, 0x1000 + start), *((1, place) for place in places), (0, 0)]
    dynamic = b"".join(struct.pack(f"{order}{number}{number}", *tag) for tag in tags)
    size = start + len(names) + len(dynamic)
    head = b"\x7fELF" + bytes((2 if wide else 1, 1 if order == "<" else 2, 1)) + bytes(9)
    head += struct.pack(
        f"{order}HHI{number}{number}{number}IHHHHHH", 3, machine, 1, 0, header, 0, 0, header, entry, 2, 0, 0, 0
    )
    for kind, offset, length in ((1, 0, size), (2, start + len(names), len(dynamic))):
        address = 0x1000 + offset
        if wide:
            head += struct.pack(f"{order}IIQQQQQQ", kind, 0, offset, address, 0, length, length, 1)
        else:
            head += struct.pack(f"{order}IIIIIIII", kind, offset, address, 0, length, length, 0, 1)
    return head + names + dynamic


def write(root: Path, files: Mapping[str, str | bytes]) -> Path:
    for name, content in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(content.encode() if isinstance(content, str) else content)
        (root / name).chmod(0o755)
    return root


@pytest.mark.parametrize("wide", [True, False])
@pytest.mark.parametrize("order", ["<", ">"])
def test_what_a_library_names_is_read(wide: bool, order: str, script: ModuleType, tmp_path: Path) -> None:
    whole = elf(("liba.so.1", "libc.so.6"), wide=wide, order=order)
    write(tmp_path, {"lib.so": whole, "torn.so": whole[:90]})
    assert script.elf(tmp_path / "lib.so").needed == ["liba.so.1", "libc.so.6"] and not script.elf(tmp_path / "torn.so")


def lacking(
    script: ModuleType, folder: Path, files: Mapping[str, str | bytes], *packages: str, **runtime: bytes
) -> Any:
    """What a workspace with these files lacks in an image, of packages, in the place of which `ni` stands if there are none."""
    image = write(folder / "runtime", {"etc/x": "", **runtime})
    return script.Lacking(image, write(folder / "built", files), [], packages or ["ni"])


def test_libraries_that_only_the_build_had_are_lost(script: ModuleType, tmp_path: Path) -> None:
    """What nobody had is absent, and no error: a driver's, an optional plugin's."""
    image = {"usr/bin/dash": elf(), "usr/lib/x86_64-linux-gnu/libc.so.6": elf()}
    needs = ("libc.so.6", "libanswer.so", "libbuilt.so", "libinstalled.so", "libcuda.so.1", "libvendor.so.3")
    built = write(
        tmp_path / "built",
        {
            **image,
            f"{WS}/install/ni/lib/ni/node": elf(needs),
            f"{WS}/install/ni/lib/libinstalled.so": elf(("libc.so.6",)),
            f"{WS}/install/ni/share/firmware": elf(("libmcu.so",), machine=ARM),
            f"{WS}/build/ni/libanswer.so": elf(),
            "usr/lib/libbuilt.so": elf(),
        },
    )
    (built / f"{WS}/install/ni/share/model").symlink_to(f"/{WS}/src/target/model")
    app = lacking(script, tmp_path, {}, **image)
    assert sorted(app.lost) == [
        f"ni/lib/ni/node needs libanswer.so, which is in no image: {WS}/build/ni/libanswer.so",
        "ni/lib/ni/node needs libbuilt.so, which is in no image: usr/lib/libbuilt.so",
        f"ni/share/model is a link to /{WS}/src/target/model, which is in no image",
    ]
    assert app.absent == {"ni/lib/ni/node needs libvendor.so.3"}


def test_modules_and_programs_that_only_the_build_had_are_lost(script: ModuleType, tmp_path: Path) -> None:
    site, python = f"{WS}/install/ni/lib/python3.11/site-packages", "usr/lib/python3.11"
    image = {f"{python}/os.py": b"", "usr/lib/python3/dist-packages/rospy/__init__.py": b"", "usr/bin/python3": elf()}
    nodes = ("ni run.py", "ni forgotten", "ni never", "other x", "ni $(arg which)")
    launch = "".join('<node pkg="{}" type="{}"/>'.format(*node.split(" ", 1)) for node in nodes)
    app = lacking(
        script,
        tmp_path,
        {
            **image,
            f"{site}/ni/__init__.py": "import ni.helper\n",
            f"{site}/ni/node.py": "from . import here\nfrom .missing import x\nimport testing_tool\nimport os, rospy, sys\n",
            f"{site}/ni/here.py": "try:\n    import optional\nexcept ImportError:\n    pass\n",
            f"{site}/ni/for_tests.py": "import testing_tool\n",
            f"{site}/ni-1.0.egg-info/entry_points.txt": "[console_scripts]\nnode = ni.node:main\nold = ni.gone:main\n",
            f"{WS}/install/ni/lib/ni/run.py": "#!/usr/bin/env python3\nimport beside\nimport unknown\n",
            f"{WS}/install/ni/lib/ni/beside.py": "",
            f"{WS}/install/ni/share/ni/launch/all.launch": f"<launch>{launch}</launch>",
            f"{WS}/install/ni/share/ni/launch/a.launch.py": "Node(package='ni', executable='forgotten', name=n)\n",
            f"{WS}/src/target/ni/ni/helper.py": "",
            f"{WS}/src/target/ni/ni/missing/__init__.py": "",
            f"{WS}/build/ni/forgotten": elf(),
            "usr/lib/python3/dist-packages/testing_tool.py": "",
        },
        **image,
    )
    below = site.removeprefix(f"{WS}/install/")
    assert sorted(app.lost) == [
        f"{below}/ni-1.0.egg-info/entry_points.txt needs the module ni.gone for old, which is in no image: nor is it in its sources",
        f"{below}/ni/__init__.py needs the module ni.helper, which is in no image: its sources have it",
        f"{below}/ni/node.py needs the module ni.missing, which is in no image: its sources have it",
        f"{below}/ni/node.py needs the module testing_tool, which is in no image: usr/lib/python3/dist-packages",
        f"ni/share/ni/launch/a.launch.py needs the program forgotten of ni, which is in no image: {WS}/build/ni/forgotten",
        f"ni/share/ni/launch/all.launch needs the program forgotten of ni, which is in no image: {WS}/build/ni/forgotten",
    ]
    assert sorted(app.absent) == [
        "ni/lib/ni/run.py needs the module unknown",
        "ni/share/ni/launch/all.launch needs the program never of ni",
    ]


def test_a_script_with_lines_of_windows(script: ModuleType, tmp_path: Path) -> None:
    """Linux looks for an interpreter whose name ends with CR. Other files may end their lines so."""
    names = {"lib/ni/a.py": "#!/usr/bin/env python3\r\nx = 1\r\n", "lib/ni/b.py": "#!/bin/sh\nprintf '\r\n'\n"}
    names |= {"share/ni/c.yaml": "a: 1\r\n", "share/ni/d.py": names["lib/ni/a.py"]}
    built = write(tmp_path / "built", {f"{WS}/install/ni/{name}": text for name, text in names.items()})
    (built / f"{WS}/install/ni/share/ni/d.py").chmod(0o644)
    [line] = lacking(script, tmp_path, {}).lost
    assert line.startswith("ni/lib/ni/a.py cannot start: its lines end with CR LF")


def test_a_file_that_git_lfs_has_not_fetched(script: ModuleType, tmp_path: Path) -> None:
    pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"
    files = {f"{WS}/install/ni/share/ni/arm.stl": pointer, f"{WS}/install/ni/share/ni/about": f"# {pointer}"}
    files[f"{WS}/src/target/not_installed.stl"] = pointer
    [line] = lacking(script, tmp_path, files).lost
    assert line.startswith("ni/share/ni/arm.stl is a pointer of Git LFS")


def test_files_that_a_launch_file_reads(script: ModuleType, tmp_path: Path) -> None:
    """In any case: not behind a condition, and not where an argument names the file."""
    launch = """<launch>
      <include file="$(find ni)/launch/part.launch"/><include file="$(find-pkg-share ni)/launch/present.launch"/>
      <include file="$(find other)/launch/x.launch"/><include file="$(find ni)/maps/$(arg map).launch"/>
      <node pkg="a" type="b" name="c"><rosparam command="load" file="$(find ni)/config/a.yaml"/></node>
      <group if="$(arg sim)"><include file="$(find ni)/launch/sim.launch"/></group>
      <param name="d" command="$(find xacro)/xacro $(find ni)/urdf/ni.xacro size:=1"/>
      <param name="e" textfile="$(find ni)/made.txt"/><param name="f" command="$(find ni)/scripts/make.py"/>
    </launch>"""
    share, source = f"{WS}/install/ni/share/ni", f"{WS}/src/target/folder"
    names = ("launch/part.launch", "launch/sim.launch", "config/a.yaml", "urdf/ni.xacro", "maps/$(arg map).launch")
    app = lacking(
        script,
        tmp_path,
        {
            f"{source}/package.xml": "<package><name>ni</name></package>",
            **{f"{source}/{name}": "" for name in names},
            f"{share}/launch/all.launch": launch,
            f"{share}/launch/present.launch": "<launch/>",
            f"{WS}/install/ni/lib/ni/make.py": "",
        },
    )
    assert sorted(app.lost) == [
        f"ni/share/ni/launch/all.launch needs {name} of ni, which is in no image: {source}/{name}"
        for name in ("config/a.yaml", "launch/part.launch", "urdf/ni.xacro")
    ]
    assert "ni/share/ni/launch/all.launch needs made.txt of ni" in app.absent


def test_launch_files_and_programs_that_are_not_installed(script: ModuleType, tmp_path: Path) -> None:
    """Of a package in a folder of another name, or in that of the repository."""
    manifest = "<package><name>{}</name></package>"
    built = write(
        tmp_path / "built",
        {
            f"{WS}/src/target/package.xml": manifest.format("top"),
            f"{WS}/src/target/launch/all.launch": "",
            f"{WS}/src/target/launch/present.launch.py": "",
            f"{WS}/src/target/some_folder/package.xml": manifest.format("ni"),
            f"{WS}/src/target/some_folder/scripts/talker.py": "#!/usr/bin/env python3",
            f"{WS}/src/target/broken/package.xml": "<package",
            f"{WS}/src/target/broken/a.launch": "",
            f"{WS}/build/ni/listener": elf(),
            f"{WS}/build/top/node": elf(),
            f"{WS}/install/top/lib/top/node": elf(),
            f"{WS}/install/top/share/top/launch/present.launch.py": "",
        },
    )
    (built / f"{WS}/install/top/share/top/launch/present.launch.py").chmod(0o644)
    for folder in (".", "some_folder", "broken"):
        (built / f"{WS}/src/target/{folder}/package.xml").chmod(0o644)
    assert lacking(script, tmp_path, {}, "ni", "top").forgotten() == {
        "top all.launch": f"{WS}/src/target/launch/all.launch",
        "ni talker.py": f"{WS}/src/target/some_folder/scripts/talker.py",
        "ni listener": f"{WS}/build/ni/listener",
    }


@pytest.mark.parametrize(
    ("command", "starts"),
    [
        ("roslaunch ni all.launch rate:=5", "all.launch of ni: src/all.launch"),
        ("source /x && exec roslaunch --wait -v ni all.launch", "all.launch of ni: src/all.launch"),
        ("rosrun ni talker.py", "talker.py of ni: src/talker.py"),
        ("bash -c 'ros2 launch ni all.launch'", "all.launch of ni: src/all.launch"),
        ("roslaunch /launch/all.launch", ""),
        ("roslaunch other all.launch", ""),
    ],
)
def test_what_a_command_starts(command: str, starts: str) -> None:
    forgotten = {"ni all.launch": "src/all.launch", "ni talker.py": "src/talker.py"}
    assert unstarted(command, forgotten) == ([starts] if starts else [])


def test_no_image_is_made_whose_command_starts_nothing(robot: Robot) -> None:
    robot.app["forgotten"] = {"robot all.launch": "docker-ros/ws/src/target/launch/all.launch"}
    command = "roslaunch robot all.launch"
    with pytest.raises(RosmlError, match="the command starts what is not installed; no image was made") as caught:
        robot.build(command=command)
    assert "src/target/launch/all.launch" in caught.value.message and "install(DIRECTORY" in caught.value.remedy
    assert robot.names == ["packages"]
    built = robot.build(command=command, tests="false")
    assert built.images and any("all.launch of robot" in text for _, text in built.summary()), "it is said"
    assert robot.build(command="roslaunch robot other.launch").images
    assert robot.build(command=command, target="dev").images


def test_scripts_that_nothing_starts_are_named(script: ModuleType, tmp_path: Path) -> None:
    """Python 2's name, and a virtual environment that only the build had."""
    lines = {
        "good.py": "#!/usr/bin/env python3",
        "plain.sh": "#!/bin/sh -e",
        "options.py": "#!/usr/bin/env -S A=1 python3 -u",
        "inside": f"#!/{WS}/install/ni/lib/ni/good.py",
        "module.py": "import sys",
        "old.py": "#!/usr/bin/env python",
        "venv.py": "#!/opt/venv/bin/python3",
    }
    image = dict.fromkeys(("bin/sh", "usr/bin/env", "usr/bin/python3"), elf())
    scripts = {f"{WS}/install/ni/lib/ni/{name}": f"{line}\n" for name, line in lines.items()}
    app = lacking(script, tmp_path, {"usr/bin/python3": elf(), "opt/venv/bin/python3": elf(), **scripts}, **image)
    [line] = app.lost
    assert line.startswith("ni/lib/ni/venv.py needs /opt/venv/bin/python3 to start, which is in no image")
    assert app.absent == {"ni/lib/ni/old.py needs python to start"}


@pytest.mark.parametrize("target", ["run", "slim"])
def test_no_image_is_made_that_lacks_what_the_tests_had(target: str, robot: Robot) -> None:
    robot.put("small:1")
    content = robot.app if target == "run" else robot.slim_app
    content["lost"] = ["robot/lib/robot/node needs libanswer.so, which is in no image: build/libanswer.so"]
    slim = {"enable_slim": "true", "slim_base_image": f"{robot.services.registry}/small:1"}
    with pytest.raises(RosmlError, match=f"the {target} image would lack what the tests had") as caught:
        robot.build(**slim)
    assert "needs libanswer.so" in caught.value.message and "exec_depend" in caught.value.remedy
    assert robot.names == ["packages"]
    built = robot.build(**slim, tests="false")
    assert built.images and any("libanswer.so" in text for _, text in built.summary()), "it is said"


def test_what_python_imports_of_the_base_image(script: ModuleType, tmp_path: Path) -> None:
    """Scripts, modules and launch files; not what comes with the app, with Python, or in some cases alone."""
    sites = "usr/lib/python3/dist-packages"
    runtime = {f"{sites}/{name}/__init__.py": "" for name in ("torch", "numpy", "yaml", "extra", "brought", "cv2")}
    install = f"{WS}/install/ni"
    files = {
        **runtime,
        f"{install}/lib/ni/node": "#!/usr/bin/env python3\nimport torch.nn, sys, os.path, gone\nfrom ni_msgs import msg\n",
        f"{install}/lib/ni/text": "#!/bin/sh\nimport extra\n",
        f"{install}/lib/python3/dist-packages/ni/core.py": "from numpy import array\nfrom .extra import other\nimport brought\n",
        f"{install}/share/ni/launch/all.launch.py": "import yaml\ntry:\n    import extra\nexcept ImportError:\n    pass\n",
        f"{install}/share/ni/broken.py": "import (\n",
        f"{install}/share/ni/later.py": "def now():\n    import cv2\n",
    }
    built, layer = write(tmp_path / "built", files), write(tmp_path / "layer", {f"{sites}/brought/__init__.py": ""})
    assert script.Lacking(write(tmp_path / "runtime", runtime), built, [], ["ni"]).imported(layer) == {
        "torch": "ni/lib/ni/node",
        "numpy": "ni/lib/python3/dist-packages/ni/core.py",
        "yaml": "ni/share/ni/launch/all.launch.py",
    }
