"""A newcomer adds a distribution, a release and a stack by the page that says how, on a copy of the project."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.projects import copy_for_generator
from rosml.base.errors import RosmlError
from rosml.images.bake import targets
from rosml.images.bake.inputs import Inputs
from rosml.images.image_set import load, lock_file, restricted
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names
from tests import walk
from tests.walk import follow, insert, section


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return copy_for_generator(tmp_path)


def test_a_distribution(project: Path, real: ImageSet) -> None:
    [entry] = [block for block in section("A distribution") if block.title]
    assert entry.text.count("\n") <= 10
    output = follow(project, "A distribution")
    assert "docker-bake.hcl: written" in output and "docs/tags.md: written" in output
    assert "warning" not in output
    assert "example-desktop-ml-cu128" in output
    assert "example-base-torch-cu128 exists:" in output
    assert "locks/" not in output, "no lock is new"
    assert (
        "| `example` | 2 | ubuntu-24.04, 3.12 | core, base, desktop | 2032-05-31 (LTS) |"
        in (project / "docs/tags.md").read_text()
    )
    image_set = load.load(project / "matrix.yaml", project)
    new = {image.target for image in image_set.images} - {image.target for image in real.images}
    assert new and all(target.startswith("example-") for target in new)
    assert all(image.locked for image in image_set.images if image.target in new and not image.target.endswith("-cpu"))


KEY = "-----BEGIN PGP PUBLIC KEY BLOCK-----\n"


def missing_of_colcon(tools: str) -> set[str]:
    """Packages that `rosml containerize` needs of colcon, and that are not among developers' tools."""
    script = (ROOT / "components/containerize/install_packages.sh").read_text()
    [names] = re.findall(r"for extension in (.*); do", script)
    if "python3-colcon-common-extensions" in tools.split():
        return set()
    return {f"python3-colcon-{name}".replace("_", "-") for name in names.split()} - {*tools.split()}


def test_ros_from_an_archive_of_ones_own(project: Path) -> None:
    """tests/e2e/test_own_archive.py builds it."""
    insert(project, next(block for block in section("ROS from your own archive") if block.title))
    with pytest.raises(RosmlError, match=r"archive\.key: components/archive-keys/ours\.asc is no armored public key"):
        load.load(project / "matrix.yaml", project)
    (project / "matrix.yaml").write_text((ROOT / "matrix.yaml").read_text())
    before = Inputs(project, load.load(project / "matrix.yaml", project))
    (project / "components/archive-keys/ours.asc").write_text(KEY)
    output = follow(project, "ROS from your own archive")
    assert "docker-bake.hcl: written" in output and "warning" not in output
    assert "packages come from the suite bookworm of an apt archive, http://packages.example.com/ros2" in output
    image_set = load.load(project / "matrix.yaml", project)
    arguments = targets.of(image_set)["jazzy-ours-core"].arguments
    assert {name: value for name, value in arguments.items() if name.startswith("ROS_")}.items() >= {
        "ROS_ARCHIVE": "http://packages.example.com/ros2",
        "ROS_CODENAME": "bookworm",
        "ROS_COMPONENTS": "main",
        "ROS_SIGNED_BY": "ours.asc",
        "ROS_PACKAGES": "ros-jazzy-ros-core",
    }.items()
    assert missing_of_colcon(str(arguments["ROS_TOOLS"])) == set()
    assert "ROS_CHANNEL" not in arguments and "ROS_ARCHIVE" not in targets.of(image_set)["ros1-bookworm-core"].arguments
    after = Inputs(project, image_set)
    for target in ("ros1-bookworm-core", "jazzy-base"):
        assert after.of(target, "amd64") == before.of(target, "amd64"), "a key is an input of its own rows alone"
    assert "components/archive-keys/ours.asc" in after.of("jazzy-ours-core", "amd64")


def test_all_rows_have_what_containerize_needs_of_colcon(real: ImageSet) -> None:
    tools = {str(it.arguments["ROS_TOOLS"]) for it in targets.of(real).values() if it.arguments.get("ROS_TOOLS")}
    assert tools and not any(map(missing_of_colcon, tools))
    assert missing_of_colcon("colcon python3-colcon-ros") >= {"python3-colcon-package-information"}


def test_ros_one(project: Path) -> None:
    (project / "components/archive-keys/ros-one.asc").write_text(KEY)
    [row] = section("ROS One")
    matrix = project / "matrix.yaml"
    matrix.write_text(matrix.read_text().replace("\n# Forecast in", f"\n{row.text.rstrip()}\n\n# Forecast in", 1))
    assert load.load(matrix, project).image("one-base").packages == "ros-one-ros-base"


def test_a_release_and_a_stack(project: Path, real: ImageSet) -> None:
    insert(project, next(section("A release of PyTorch or TensorFlow")))
    output = follow(project, "A stack")
    assert "jazzy-base-torch-cu126 exists, but cannot be built yet:" in output
    assert "run './rosml locks'" in output
    assert "stack cu126 carries torch 2.7.1, cuda 12.6.77, cudnn 9.5.1.17 and nccl 2.26.2" in output
    image_set = load.load(project / "matrix.yaml", project)
    new = {image.target for image in image_set.images} - {image.target for image in real.images}
    assert new and all(target.endswith("-cu126") for target in new)


def test_a_step_that_is_left_out_is_told(project: Path) -> None:
    """A stack without its forecast."""
    blocks_of_stack = [block for block in section("A stack") if block.title]
    insert(project, next(section("A release of PyTorch or TensorFlow")))
    insert(project, blocks_of_stack[0])
    argv = [sys.executable, "src", "generate"]
    done = subprocess.run(argv, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "cu126" in done.stderr and "disk" in done.stderr


def test_a_set_of_ones_own(project: Path) -> None:
    """In a fork: what is generated is of the set."""
    output = walk.make_set(project)
    assert "docker-bake.hcl: written" in output and "warning" not in output
    assert "noetic" not in (project / "docs/tags.md").read_text().partition("<!-- images:")[2]
    image_set = load.load(project / "set.yaml", project)
    assert {image.target.split("-")[0] for image in image_set.images} == {"humble", "jazzy"}
    assert image_set.matrix.source == "https://github.com/me/robot-images"
    check = [sys.executable, "scripts/generate_bake.py", "--check"]
    assert subprocess.run(check, cwd=project, check=False).returncode == 0


def test_an_addon(project: Path, real: ImageSet) -> None:
    """A part is data: its entries, a folder, a file of tests. No code is touched, and no image but its own changes."""
    for block in section("A part, an add-on, a framework"):
        if block.title.startswith("matrix.yaml"):
            insert(project, block)
    matrix = project / "matrix.yaml"
    text = matrix.read_text()
    text = text.replace(
        "releases: {torch: 2.10.0, tensorflow: 2.20.0",
        "releases: {einops: 0.8.1, torch: 2.10.0, tensorflow: 2.20.0",
        1,
    )
    text = text.replace("\n    cu128:\n", "\n    cu128:\n      einops: {unpacked: 1, compressed: 1}\n", 1)
    matrix.write_text(text)
    for file, content in {
        "components/einops/prune.txt": "# Nothing.\n",
        "tests/structure/einops.yaml": "schemaVersion: 2.0.0\n",
    }.items():
        (project / file).parent.mkdir(exist_ok=True, parents=True)
        (project / file).write_text(content)
    image_set = load.load(matrix, project)
    new = {image.target: image for image in image_set.images if image.target not in real.by_target}
    assert {*new} == {
        f"{row}-core-einops-cu128" for row in ("humble", "jazzy", "lyrical", "ros1-bookworm", "ros1-trixie")
    }, "one for each Python, on the lowest component"
    jazzy = new["jazzy-core-einops-cu128"]
    assert jazzy.parts == ("cuda-cu128", "common-cu128-py312", "torch-cu128-py312", "einops-cu128-py312")
    assert (jazzy.tags, jazzy.groups, jazzy.addons, jazzy.combination) == ((), ("einops",), ("einops",), "einops")
    assert jazzy.tests[-3:] == ("torch", "einops", "pip"), "what PyTorch has to compile was tested without it"
    assert jazzy.versions["einops"] == "0.8.1"
    argv = [sys.executable, "scripts/generate_bake.py"]
    subprocess.run(argv, cwd=project, check=True)
    every = targets.of(image_set)
    inline = every["jazzy-core-einops-cu128"].join
    assert inline and inline.dockerfile().count("COPY --link") == 4
    output = every["part-einops-cu128-py312"].labels
    assert output["io.rosml.addons"] == "einops=cuda*,common,torch,einops" and "io.rosml.frameworks" not in output
    before, after = Inputs(ROOT, real), Inputs(project, image_set)
    for target in ("jazzy-base-torch-cu128", "part-torch-cu128-py312"):
        assert after.of(target, "amd64").keys() == before.of(target, "amd64").keys()

    tagged = "{parts: [einops], beside: [torch], tags: {distributions: [jazzy], components: [base], stacks: [cu128]}}"
    matrix.write_text(text.replace("einops: {parts: [einops]}", f"einops: {tagged}"))
    image_set = load.load(matrix, project)
    base, core = image_set.image("jazzy-base-einops-cu128"), image_set.image("jazzy-core-einops-cu128")
    tags = ("jazzy-base-cu128", "jazzy-base-cu128-torch2.10.0-einops0.8.1", "jazzy", "latest")
    assert base.tags == tuple(f"ros-einops:{tag}" for tag in tags)
    assert base.carriers == (core.target,) and not core.tags and "all" in base.groups
    assert (
        "jazzy-core-torch-einops-cu128" in image_set.by_target
        and "jazzy-base-torch-einops-cu128" not in image_set.by_target
    )
    assert sum(len(image.tags) for image in image_set.images) == sum(len(image.tags) for image in real.images) + 4


def tensorrt(title: str) -> str:
    """A file of the page about TensorRT."""
    [text] = [block.text for name in ("The set", "Its files") for block in section(name) if block.title == title]
    return text


def test_tensorrt_from_an_index_of_ones_own(tmp_path: Path) -> None:
    """A set whose parts are restricted: their packages are asked of that index, and no public registry gets them."""
    (tmp_path / "set.yaml").write_text(tensorrt("set.yaml"))
    image_set = load.without_locks(tmp_path / "set.yaml", ROOT)
    image = image_set.image("jazzy-core-tensorrt-cu130")
    assert image.parts[-4:] == (
        "onnxruntime-cc-cu130",
        "onnxruntime-cu130-py312",
        "tensorrt-cc-cu130",
        "tensorrt-cu130-py312",
    )
    assert image.architectures == ("amd64",) and image.versions["tensorrt"] == "10.16.1.11"
    assert "tensorrt" in image.tests and "onnxruntime" in image.tests
    bake_targets = targets.of(image_set)
    assert bake_targets[image.target].labels["io.rosml.restricted"] == "tensorrt-cc tensorrt"
    asking = {part.kind for part in image_set.parts if bake_targets[part.target].arguments.get("INDEX")}
    assert asking == {"tensorrt-cc", "tensorrt"}
    assert bake_targets["part-tensorrt-cu130-py312"].arguments["SHOWS"] == "tensorrt-cc"
    # What `rosml locks` writes is the lock of the parts, whatever other releases of the stack are called.
    hashed = f"10.16.1.11 \\\n    --hash=sha256:{'0' * 64}\n"
    for part in (item for item in image_set.parts if item.kind in asking):
        head = f"{names.lock_head(part.stack, 'amd64', part.python, part.kind)}\n# Made by 'rosml locks' from matrix.yaml; do not edit.\n"
        package = "tensorrt-cu13-libs" if part.kind == "tensorrt-cc" else "tensorrt-cu13-bindings"
        assert lock_file.current(f"{head}{package}=={hashed}", part, image_set.matrix, "amd64")
    declared = restricted.Declared.of(image_set.matrix, {})
    host, _, path = image_set.matrix.registry.partition("/")
    assert restricted.require(["tensorrt"], image.target, host, path, declared) == ""
    with pytest.raises(RosmlError, match="is a public registry"):
        restricted.require(["tensorrt"], image.target, "ghcr.io", path, declared)


NEEDED = ("libnvinfer.so.10", "libnvinfer_plugin.so.10", "libnvonnxparser.so.10")
"""What ONNX Runtime's provider and the module of Python link, as `readelf -d` says of 1.19.2 to 1.31.1 and of 10.16.1.11."""


def followed(path: Path, root: Path) -> Path:
    """Where a path of an image leads, whose root is a folder."""
    while path.is_symlink():
        leads = path.readlink()
        path = root / str(leads)[1:] if leads.is_absolute() else path.parent / leads
    return path


def test_tensorrts_libraries_are_where_the_loader_looks(tmp_path: Path) -> None:
    """ONNX Runtime's provider and programs in C++ have no path to them: they are in a default one."""
    out, triplet = tmp_path / "out", "x86_64-linux-gnu"
    cc, python = "/usr/local/lib/rosml/tensorrt-cc", "/usr/local/lib/python3.12/dist-packages"
    version = "10.16.1.11"
    for file, text in {
        **{f"{cc}/tensorrt_libs/{name}": name for name in (*NEEDED, "libnvinfer_builder_resource_sm90.so.10.16.1")},
        f"{cc}/tensorrt_libs/__init__.py": "",
        f"{python}/tensorrt_bindings/__init__.py": f"__version__ = '{version}'\nLogger = print\n",
        f"{python}/tensorrt_bindings/plugin/__init__.py": "__all__ = ['register']\nregister = print\n",
        f"{python}/tensorrt_cu13_bindings-{version}.dist-info/METADATA": "",
        f"{python}/tensorrt_cu13_bindings-{version}.dist-info/RECORD": "tensorrt_bindings/__init__.py,,\n",
    }.items():
        (out / file[1:]).parent.mkdir(parents=True, exist_ok=True)
        (out / file[1:]).write_text(text)
    libraries = out / "usr/lib" / triplet
    libraries.mkdir(parents=True)
    (tmp_path / "components").mkdir()
    (tmp_path / "components/part").symlink_to(ROOT / "components/part")
    for part, site in (("tensorrt-cc", cc), ("tensorrt", python)):
        script = tmp_path / f"components/{part}/files.sh"
        script.parent.mkdir(parents=True)
        script.write_text(tensorrt(f"components/{part}/files.sh"))
        environment = {"PATH": os.environ["PATH"], "OUT": str(out), "SITE": site, "TRIPLET": triplet}
        subprocess.run(["bash", script], env=environment, check=True)
    for name in NEEDED:
        for called in (name, f"{name.partition('.so')[0]}.so"):
            assert followed(libraries / called, out).read_text() == name
    asks = "import tensorrt, tensorrt.plugin, importlib.metadata as m; print(tensorrt.__version__, tensorrt.plugin.register.__name__, m.version('tensorrt'))"
    isolated = [sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(out / python[1:])!r}); {asks}"]
    assert subprocess.run(isolated, capture_output=True, text=True, check=True).stdout.split() == [
        version,
        "print",
        version,
    ]
