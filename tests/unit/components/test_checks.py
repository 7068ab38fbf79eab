"""The checks of the structure tests can fail: each passes on a small root that is as it should be, and names what is wrong
on one in which a single thing was broken. Those that only a whole image can show: tests/e2e/test_faults.py."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import struct
import subprocess
import sys
import venv
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

STRUCTURE = ROOT / "tests/structure"
SITE = "usr/local/lib/python3.11/dist-packages"
DEBIAN = "usr/lib/python3/dist-packages"
PART_TIME = 1767225600  # 2026-01-01, the time of every file of a part


@dataclass
class Root:
    """A made-up root file system, programs that come before the machine's own, and what the tag promises."""

    folder: Path
    programs: Path
    env: dict[str, str] = field(default_factory=dict)

    def file(self, path: str, text: str = "", mode: int = 0o644) -> Path:
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(mode)
        return file

    def link(self, path: str, target: str) -> None:
        link = self.folder / path
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(target)
        os.utime(link, (PART_TIME, PART_TIME), follow_symlinks=False)

    def program(self, name: str, text: str) -> None:
        executable(self.programs / name, text)

    def run(self, *command: str) -> subprocess.CompletedProcess[str]:
        kept = {name: os.environ[name] for name in ("HOME", "LANG") if name in os.environ}
        env = {**kept, "CHECK_ROOT": str(self.folder), "PATH": f"{self.programs}:/usr/bin:/bin", **self.env}
        script, *arguments = command
        return subprocess.run(
            [str(STRUCTURE / "checks" / script), *arguments], env=env, capture_output=True, text=True, check=False
        )


# ---- Roots as they should be, by check -------------------------------------------------------------------------------


def cuda(root: Root) -> None:
    for name in ("libcudart.so.12", "libcublas.so.12", "libcublasLt.so.12", "libcudnn.so.9", "libcudnn_ops.so.9"):
        root.file(f"usr/local/lib/rosml/cuda/{name}")
    for name in ("libcufft.so.11", "libcufftw.so.11", "libnvrtc.so.12", "libnvrtc-builtins.so.12.8", "libnccl.so.2"):
        root.file(f"usr/local/lib/rosml/cuda/{name}")
    root.link("usr/lib/x86_64-linux-gnu/libcudart.so.12", "/usr/local/lib/rosml/cuda/libcudart.so.12")
    for name in ("libcurl.so.4", "libcurl-gnutls.so.4", "libcups.so.2"):
        root.file(f"usr/lib/x86_64-linux-gnu/{name}")


def loader(root: Root) -> None:
    """The loader finds libraries that say of themselves to be CUDA 12.8's, cuDNN 9.10.2 and NCCL 2.27.5."""
    answers = {
        "libcudart.so.12": "int cudaRuntimeGetVersion(int *version) { *version = 12080; return 0; }",
        "libcudnn.so.9": "unsigned long cudnnGetVersion(void) { return 91002; }",
        "libnccl.so.2": "int ncclGetVersion(int *version) { *version = 22705; return 0; }",
    }
    for name, code in answers.items():
        source = root.file(f"{name}.c", f"{code}\n")
        command = ["gcc", "-shared", "-fPIC", f"-Wl,-soname,{name}", "-o", str(root.folder / name), str(source)]
        subprocess.run(command, check=True)
    root.env |= {"EXPECT_CUDA": "12.8.90", "EXPECT_CUDNN": "9.10.2.21", "EXPECT_NCCL": "2.27.5"}
    root.env["LD_PRELOAD"] = ":".join(str(root.folder / name) for name in answers)
    root.program("ldconfig", "echo libc.so.6")


def language(root: Root) -> None:
    root.env["LANG"] = "C.UTF-8"


def links(root: Root) -> None:
    root.file("usr/local/lib/rosml/torch/libtorch.so")
    root.link("usr/lib/x86_64-linux-gnu/libtorch.so", "../../local/lib/rosml/torch/libtorch.so")
    (root.folder / "usr/lib/x86_64-linux-gnu/a-debian-link").symlink_to("nowhere")  # of another time: not a part's


def clean(root: Root) -> None:
    for name in ("usr/local/share/ca-certificates", "run/secrets", "root"):
        (root.folder / name).mkdir(parents=True)
    root.file("etc/apt/apt.conf.d/01autoremove", "APT::NeverAutoRemove {};\n")
    root.program("pip", "echo global.break-system-packages=true")


def debian_packages(root: Root) -> None:
    status = "Status: install ok installed\nMaintainer: nobody\nArchitecture: all\nVersion: 1\nDescription: none\n"
    text = "".join(f"Package: {name}\n{status}\n" for name in ("ros-core", "ros-base"))
    root.file("var/lib/dpkg/status", text)
    root.env |= {"EXPECT_PACKAGES_DESKTOP_FULL": "ros-core,ros-base", "DPKG_ADMINDIR": f"{root.folder}/var/lib/dpkg"}


def recorded_files(root: Root) -> None:
    names = [f"torch/{number}.py" for number in range(100)]
    for name in names:
        root.file(f"{SITE}/{name}", "pass\n")
    rows = "".join(f"{name},sha256=x,5\n" for name in names)
    root.file(f"{SITE}/torch-2.dist-info/RECORD", f"{rows}torch-2.dist-info/RECORD,,\n")
    row = "tensorflow/libtensorflow_cc.so.2,sha256=x,7"
    root.file("usr/local/lib/rosml/tensorflow-cc/tensorflow/libtensorflow_cc.so.2", "library")
    root.file("usr/local/lib/rosml/tensorflow-cc/tensorflow-2.dist-info/RECORD", f"{row}\n")
    root.file("usr/local/share/rosml/expected.d/tensorflow-cc", f"{hashlib.sha256(row.encode()).hexdigest()}\n")


TORCH_ALONE = "torch==2.10.0+cpu\npillow!=8.3.*,>=5.3.0; python_version > '3'\n"


def pinned(root: Root) -> None:
    constraints = "usr/local/share/rosml/constraints.d/all.txt"
    root.env["UV_CONSTRAINT"] = f"/{constraints}"
    root.file("etc/pip.conf", f"[install]\nconstraint = /{constraints}\n")
    root.file("usr/local/share/rosml/constraints.txt", "numpy<2\nempy<4\n")
    root.file(constraints, "-c ../constraints.txt\n-c 01.txt\n-c 02.txt\n")
    root.file("usr/local/share/rosml/constraints.d/01.txt", f"# What the part torch holds\n{TORCH_ALONE}")
    root.file("usr/local/share/rosml/constraints.d/02.txt")
    root.file(
        f"{SITE}/torch-2.10.0+cpu.dist-info/METADATA",
        "Name: Torch\nVersion: 2.10.0+cpu\n"
        "Requires-Dist: pillow[x] (!=8.3.*,>=5.3.0) ; python_version > '3'\nRequires-Dist: x>1; extra == 'x'\n",
    )
    root.file(f"{SITE}/pillow-13.dist-info/METADATA", "Name: Pillow\nVersion: 13\n")


def pip(root: Root) -> None:
    root.file("usr/local/share/rosml/versions.d/torch", "torch 2.10.0\nnvidia-cudnn-cu12 9.10\n")
    root.program("pip", "echo 'pynacl 1.5.0 is not supported on this platform'; exit 1")


def python(root: Root) -> None:
    root.env["EXPECT_PYTHON"] = "3.11"
    root.program("python3", "echo 3.11")


def part(root: Root) -> None:
    root.file(f"{SITE}/torch-2.10.0.dist-info/RECORD")
    root.file(f"{SITE}/torch/__init__.py")
    root.file(f"{SITE}/numpy/__init__.py")
    for folder, programs in ((SITE, "usr/local/bin"), (DEBIAN, "usr/bin")):  # the base's own
        root.file(f"{folder}/pip/__init__.py")
        root.file(f"{programs}/pip", "#!/usr/bin/python3.11\nimport sys\nfrom pip._internal.cli.main import main\n")
    root.file("usr/local/share/rosml/versions.d/torch", "torch 2.10.0\n")
    root.file(f"{DEBIAN}/numpy/__init__.py")
    root.file(f"{DEBIAN}/yaml/__init__.py")
    root.file(f"{DEBIAN}/rospkg.py")
    root.file("opt/ros/jazzy/lib/python3.11/site-packages/rclpy/__init__.py")
    root.file("usr/local/bin/torchrun", "#!/usr/bin/python3.11\nfrom torch.distributed.run import main\n")
    root.file("usr/local/bin/f2py", "#!/usr/bin/python3.11\nimport sys\nfrom numpy.f2py.f2py2e import main\n")
    for command in ("f2py", "cmake"):
        root.file(f"usr/bin/{command}")
    root.file("usr/lib/x86_64-linux-gnu/libgomp.so.1.0.0")
    root.link("usr/lib/x86_64-linux-gnu/libgomp.so.1", "libgomp.so.1.0.0")
    root.file("var/lib/dpkg/info/libgomp1.list", "/.\n/usr/lib/x86_64-linux-gnu/libgomp.so.1\n/usr/bin/cmake\n")


def middlewares(root: Root) -> None:
    root.env["EXPECT_RMW"] = "rmw_cyclonedds_cpp,rmw_zenoh_cpp"
    root.program("python3", f'echo "$RMW_IMPLEMENTATION=$2" >>{root.programs}/asked')


def distribution(root: Root) -> None:
    root.env |= {"ROS_DISTRO": "noetic", "EXPECT_ROS_DISTRO": "noetic", "ROS_VERSION": "1", "EXPECT_ROS": "1"}
    root.file("etc/catkin/profile.d/1.ros_distro.sh", "ROS_DISTRO=noetic\n")


def wheels(root: Root) -> None:
    root.file("site/ros_jazzy_rclpy-7.1.6.dist-info/METADATA", "Name: ros-jazzy-rclpy\nVersion: 7.1.6\n")
    root.env |= {"EXPECT_WHEELS": "ros-jazzy-rclpy==7.1.6", "PYTHONPATH": f"{root.folder}/site"}
    root.program("pip", "echo 'pynacl 1.5.0 is not supported on this platform'; exit 1")


def rosdep(root: Root) -> None:
    root.file("etc/ros/rosdep/sources.list.d/20-default.list", "yaml https://example.org/base.yaml\n")
    # It knows what the index in the folder says, and that alone.
    resolve = 'sed -n "s/.*debian: .\\(.*\\)]/\\1/p" "$HOME/base.yaml" | grep .'
    root.program("rosdep", f"case $1 in update) grep -q file:// $ROSDEP_SOURCE_PATH/* ;; resolve) {resolve} ;; esac")


def rights(root: Root) -> None:
    root.file("usr/bin/passwd", mode=0o4755)
    root.file("bin/su", mode=0o4755)  # as where /usr is not merged
    root.file("usr/bin/ls", mode=0o755)


def tools(root: Root) -> None:
    script = (STRUCTURE / "checks/tools.sh").read_text()
    for tool in script.split("tools=(")[1].split(")")[0].split():
        root.program(tool, "")
    for program in ("bash", "grep"):
        (root.programs / program).symlink_to(shutil.which(program) or program)
    root.env["PATH"] = str(root.programs)
    root.program("getent", "echo sudo:x:27:; echo video:x:44:")
    root.file("etc/os-release", "VERSION_CODENAME=bookworm\n")
    root.file("usr/share/bash-completion/bash_completion", "x")
    root.file("usr/share/zoneinfo/Europe/Berlin", "x")
    root.file("root/.bashrc", "source /usr/local/share/rosml/shell.bash\n")


def pings(root: Root) -> None:
    """A ping that nobody's rights, or those of the one who runs the tests, have a say in."""
    root.program("ping", '[ "$1" != -c ] || echo 64 bytes from 127.0.0.1')
    root.program("setpriv", 'while [ "${1#--}" != "$1" ]; do shift; done; exec "$@"')


def extensions_of_colcon(root: Root) -> None:
    words = "--base-paths --metas --packages-select console_cohesion --cmake-args --cmake-target --catkin-skip-building-tests"
    root.program("colcon", f"case $3 in list) ;; build|test) echo {words} ;; *) exit 2 ;; esac")
    root.file("modules/colcon_bash.py")
    root.env["PYTHONPATH"] = str(root.folder / "modules")


def built_for(root: Root) -> None:
    """Frameworks that say what they were built for, on amd64."""
    root.file("modules/torch/__init__.py")
    root.file("modules/torch/lib/libtorch_python.so", "code\0sm_90 is a word\0sm_80 sm_90\0 code")
    info = "class sysconfig: get_build_info = lambda: {'cuda_compute_capabilities': ['sm_60', 'compute_90']}\n"
    root.file("modules/tensorflow.py", info)
    root.file("modules/onnxruntime/__init__.py")
    cuda_provider(root, [("sm", 80), ("sm", 90), ("compute", 90)])
    root.program("dpkg", "echo amd64")
    root.env |= {"PYTHONPATH": str(root.folder / "modules"), "EXPECT_CUDA": "12.8.90"}
    root.env["EXPECT_GPU_ONNXRUNTIME_AMD64"] = "sm_80,sm_90a,compute_90"
    root.env |= {"EXPECT_GPU_TORCH_AMD64": "sm_80,sm_90", "EXPECT_GPU_TENSORFLOW_AMD64": "sm_60,compute_90"}
    root.env["NVIDIA_REQUIRE_CUDA"] = "cuda>=12.0"


def cuda_provider(root: Root, several: list[tuple[str, int]]) -> None:
    """ONNX Runtime's library with kernels for several architectures, three times, and for one alone twice. Its code for sm_90 and later
    has that GPU's own instructions."""
    content = b"code"
    for kinds in [several, several, [("sm", 120)], several[1:], several, [("sm", 120)]]:
        entries = b""
        for kind, number in kinds:
            flags = 0x8011 | (1 << 20 if kind == "sm" and number >= 90 else 0)
            entries += struct.pack("<H2xIQ12xI8xQ16x", 2 if kind == "sm" else 1, 64, 8, number, flags) + b"8 bytes."
        content += struct.pack("<IHHQ", 0xBA55ED50, 1, 16, len(entries)) + entries + bytes(8)
    root.file("modules/onnxruntime/capi/libonnxruntime_providers_cuda.so").write_bytes(content)


def environment(root: Root) -> None:
    """An environment beside a ROS 1 with PyTorch."""
    venv.create(root.folder / "opt/env/grasp", symlinks=True)
    for module in ("rospy", "torch", "std_msgs/__init__", "std_msgs/msg"):
        root.file(f"modules/{module}.py")
    root.program("python3", f'exec {sys.executable} "$@"')
    root.env |= {"EXPECT_ENVIRONMENT": "grasp", "EXPECT_ROS": "1", "EXPECT_TORCH": "2.10.0"}
    root.env |= {"PYTHONPATH": str(root.folder / "modules"), "EXPECT_PYTHON": "{}.{}".format(*sys.version_info)}


def runtime(root: Root) -> None:
    root.file("etc/dpkg/dpkg.cfg.d/rosml-runtime", "path-exclude=/usr/include/*\n")
    root.file("usr/lib/python3/dist-packages/torch/lib/libfmt.a")
    (root.folder / "usr/include/boost").mkdir(parents=True)


GOOD: dict[str, Callable[[Root], None]] = {
    "colcon.sh": extensions_of_colcon,
    "cuda_copies.sh": cuda,
    "cuda_runtime.py": loader,
    "dangling_links.sh": links,
    "environment.sh": environment,
    "gpus.py torch": built_for,
    "gpus.py tensorflow": built_for,
    "gpus.py onnxruntime": built_for,
    "gpus.py driver": built_for,
    "locale.sh": language,
    "no_traces.sh": clean,
    "packages.sh desktop-full": debian_packages,
    "part_files.py": recorded_files,
    "pins.py": pinned,
    "ping.sh": pings,
    "pip_check.py": pip,
    "python.sh": python,
    "replaces_nothing.py": part,
    "rmw.sh": middlewares,
    "ros_distro.sh": distribution,
    "ros_wheels.py": wheels,
    "rosdep.sh": rosdep,
    "setuid.sh": rights,
    "tools.sh": tools,
    "runtime.sh": runtime,
}

ELSEWHERE = {
    "apt_source.sh": "tests/e2e/test_apt_source.py",
    "pip_install.py": "tests/e2e/test_faults.py",
    "stop.py": "tests/unit/components/test_stop.py",
    "user.sh": "tests/e2e/test_faults.py",
    "versions.py": "tests/unit/components/test_structure_programs.py",
}
"""Checks that are seen to fail in another test."""


# ---- What is broken, and what must be said ---------------------------------------------------------------------------


def forget(*names: str) -> Callable[[Root], object]:
    return lambda root: [root.env.pop(name) for name in names]


def library(name: str) -> Callable[[Root], object]:
    return lambda root: root.file(f"opt/somewhere/{name}")


def variable(**values: str) -> Callable[[Root], None]:
    return lambda root: root.env.update(values)


def text(path: str, content: str = "", mode: int = 0o644) -> Callable[[Root], object]:
    return lambda root: root.file(path, content, mode)


def gone(path: str) -> Callable[[Root], None]:
    return lambda root: (root.folder / path).unlink()


def says(name: str, script: str) -> Callable[[Root], None]:
    return lambda root: root.program(name, script)


def no_cuda(root: Root) -> None:
    for file in (root.folder / "usr/local/lib/rosml/cuda").iterdir():
        file.unlink()


def silent_zenoh(root: Root) -> None:
    root.program("python3", '[ "$2" != rmw_zenoh_cpp ] || { echo no message over $2 >&2; exit 1; }')


def linked_over(root: Root) -> None:
    root.file("usr/local/lib/rosml/torch/libgomp.so.1")
    (root.folder / "usr/lib/x86_64-linux-gnu/libgomp.so.1").unlink()
    root.link("usr/lib/x86_64-linux-gnu/libgomp.so.1", "../../local/lib/rosml/torch/libgomp.so.1")


def unpacked(root: Root) -> None:
    status = root.folder / "var/lib/dpkg/status"
    whole = status.read_text()
    at = whole.rindex("install ok installed")
    status.write_text(whole[:at] + whole[at:].replace("install ok installed", "install ok unpacked", 1))


BROKEN: dict[str, tuple[str, Callable[[Root], object], str]] = {
    "the same library twice": ("cuda_copies.sh", library("libcudart.so.12"), "more than one copy of libcudart: "),
    "a copy under a name of a wheel's own": ("cuda_copies.sh", library("libcudart-9335f6a2.so.12"), "libcudart-9335f6a2"),
    "no CUDA at all": ("cuda_copies.sh", no_cuda, "no CUDA library at all"),
    "another CUDA": ("cuda_runtime.py", variable(EXPECT_CUDA="12.6.1"), "CUDA runtime 12080, expected 12060"),
    "a loader that is helped by a variable": ("cuda_runtime.py", variable(LD_LIBRARY_PATH="/x"), "LD_LIBRARY_PATH"),
    "a loader that is helped by its cache": ("cuda_runtime.py", says("ldconfig", "echo libcudart.so.12"), "ldconfig"),
    "PyTorch for other GPUs": ("gpus.py torch", variable(EXPECT_GPU_TORCH_AMD64="sm_90"), "expected ['sm_90']"),
    "TensorFlow for GPUs that nobody names": ("gpus.py tensorflow", forget("EXPECT_GPU_TENSORFLOW_AMD64"), "expected []"),
    "ONNX Runtime for newer GPUs": (
        "gpus.py onnxruntime",
        lambda root: cuda_provider(root, [("sm", 90), ("compute", 90)]),
        "['sm_90a', 'compute_90'], expected",
    ),
    "a driver that nobody asks for": ("gpus.py driver", forget("NVIDIA_REQUIRE_CUDA"), "None, expected cuda>=12.0"),
    "a driver without CUDA": ("gpus.py driver", forget("EXPECT_CUDA"), "cuda>=12.0, expected None"),
    "a link to nowhere": ("dangling_links.sh", gone("usr/local/lib/rosml/torch/libtorch.so"), "/libtorch.so\n"),
    "a locale that everything obeys": ("locale.sh", variable(LC_ALL="C.utf8"), "LC_ALL is set: C.utf8"),
    "a locale that is not there": ("locale.sh", variable(LANG="xx_XX.utf8"), "Cannot set"),
    "a proxy": ("no_traces.sh", variable(http_proxy="http://p:1"), "http_proxy=http://p:1"),
    "an index": ("no_traces.sh", says("pip", "echo global.index-url=http://i"), "global.index-url=http://i"),
    "a cache": ("no_traces.sh", text("root/.cache/pip/x"), "/root/.cache"),
    "a certificate": ("no_traces.sh", text("usr/local/share/ca-certificates/ours.crt"), "ours.crt"),
    "a password": ("no_traces.sh", text("root/.netrc"), "/root/.netrc"),
    "a secret": ("no_traces.sh", text("run/secrets/ca-bundle"), "run/secrets/ca-bundle"),
    "apt's proxy": ("no_traces.sh", text("etc/apt/apt.conf.d/p", 'Acquire::http::Proxy "http://p";'), "http::Proxy"),
    "a package half installed": ("packages.sh desktop-full", unpacked, "ros-base: unpacked"),
    "a file missing": ("part_files.py", gone(f"{SITE}/torch/7.py"), "torch/7.py is missing"),
    "a part for another wheel": ("part_files.py", text("usr/local/share/rosml/expected.d/tensorflow-cc", "0" * 64), "tensorflow-cc is not what"),
    "no part on record": ("part_files.py", text(f"{SITE}/torch-2.dist-info/RECORD"), "no part is here"),
    "a package that pip would replace": (
        "pins.py",
        text(f"{SITE}/nvidia_nccl_cu12-2.dist-info/METADATA", "Name: nvidia-nccl-cu12\nVersion: 2\n"),
        "is there, and not pinned",
    ),
    "a pin of another version": ("pins.py", text("usr/local/share/rosml/constraints.d/01.txt", "torch==2.10.0\n"), "is pinned, and not there"),
    "a package that may go too far": (
        "pins.py",
        text("usr/local/share/rosml/constraints.d/01.txt", TORCH_ALONE.replace("!=8.3.*,", "")),
        "asks for pillow!=8.3.*",
    ),
    "a slot that is missing": ("pins.py", gone("usr/local/share/rosml/constraints.d/02.txt"), "02.txt"),
    "a pip that keeps to something else": (
        "pins.py",
        text("etc/pip.conf", "[install]\nconstraint = /usr/local/share/rosml/constraints.txt\n"),
        "/etc/pip.conf names",
    ),
    "a uv that keeps to nothing": ("pins.py", variable(UV_CONSTRAINT=""), "UV_CONSTRAINT names [''], and not "),
    "a numpy of any ABI": ("pins.py", text("usr/local/share/rosml/constraints.txt", "empy<4\n"), "nothing keeps numpy"),
    "a requirement of the part": ("pip_check.py", says("pip", "echo 'torch 2.10.0 requires nvidia-cudnn-cu12.'; exit 1"), "1 complaints about part"),
    "a ping for root alone": ("ping.sh", says("setpriv", "[ $1 != --reuid=65534 ] || exit 2"), "ping fails: setpriv --reuid=65534"),
    "a ping that demands NET_RAW": ("ping.sh", says("setpriv", "[ $1 != --bounding-set=-net_raw ] || exit 126"), "does not start without NET_RAW"),
    "another Python": ("python.sh", says("python3", "echo 3.12"), "Python 3.12, expected 3.11"),
    "what ROS's tools import": ("replaces_nothing.py", text(f"{SITE}/setuptools/x.py"), "never: ['setuptools']"),
    "a module of Debian's": ("replaces_nothing.py", text(f"{SITE}/rospkg.py"), "without a reason: ['rospkg']"),
    "a module in ROS's other folder": (
        "replaces_nothing.py",
        text("opt/ros/humble/local/lib/python3.10/dist-packages/torch/x.py"),
        "without a reason: ['torch']",
    ),
    "a file of a package": ("replaces_nothing.py", linked_over, "['/usr/lib/x86_64-linux-gnu/libgomp.so.1']"),
    "a command of Debian's": (
        "replaces_nothing.py",
        text("usr/local/bin/cmake", "#!/usr/bin/python3.11\nfrom cmake import main\n"),
        "commands hidden: ['cmake']",
    ),
    "an RMW that does not talk": ("rmw.sh", silent_zenoh, "no message over rmw_zenoh_cpp"),
    "another distribution": ("ros_distro.sh", variable(ROS_DISTRO="jazzy"), "ROS_DISTRO=jazzy ROS_VERSION=1, expected"),
    "catkin's complaint": (
        "ros_distro.sh",
        text("etc/catkin/profile.d/1.ros_distro.sh", "echo ROS_DISTRO was set before\n"),
        "ROS_DISTRO was set before",
    ),
    "another wheel": ("ros_wheels.py", variable(EXPECT_WHEELS="ros-jazzy-rclpy==7.2.0"), "ros-jazzy-rclpy 7.1.6, exp"),
    "a requirement of ROS's": ("ros_wheels.py", says("pip", "echo 'ros-rclpy 7.1.6 requires ros-rcl.'; exit 1"), "complaints about ROS's"),
    "rosdep as it comes": ("rosdep.sh", text("etc/ros/rosdep/sources.list.d/20-default.list"), "rosdep is not initialised"),
    "a program with root's rights": ("setuid.sh", text("opt/tool", mode=0o4755), "not in setuid.txt:\n4755 /opt/tool"),
    "a name that begins like a known one": ("setuid.sh", text("usr/bin/passwd2", mode=0o4755), "4755 /usr/bin/passwd2"),
    "a compiler": ("runtime.sh", text("usr/bin/g++", ""), "usr/bin/g++"),
    "a header": ("runtime.sh", text("usr/include/boost/any.hpp", ""), "usr/include/boost/any.hpp"),
    "a static library": ("runtime.sh", text("usr/lib/x86_64-linux-gnu/libz.a", ""), "a static library"),
    "headers later": ("runtime.sh", text("etc/dpkg/dpkg.cfg.d/rosml-runtime", ""), "leaves no headers out"),
    "a colcon that lists nothing": (
        "colcon.sh",
        says("colcon", "[ $3 != list ] || { echo \"invalid choice: '$3'\" >&2; exit 2; }"),
        "invalid choice: 'list'",
    ),
    "a colcon that selects nothing": (
        "colcon.sh",
        says("colcon", "[ $3 = list ] || echo --base-paths --metas console_cohesion"),
        "no --packages-select",
    ),
    "a colcon for other shells": ("colcon.sh", gone("modules/colcon_bash.py"), "colcon_bash"),
    "an environment for everybody": ("environment.sh", variable(PYTHONPATH="/opt/env/grasp/lib"), "has the environment for everybody"),
    "an environment of another Python": ("environment.sh", variable(EXPECT_PYTHON="3.99"), "its Python is 3."),
    "an environment without ROS": ("environment.sh", gone("modules/rospy.py"), "No module named 'rospy'"),
    "an environment that is moved": ("environment.sh", text("opt/env/grasp/bin/activate"), "bin/activate leads to "),
    "a tool": ("tools.sh", lambda root: (root.programs / "rosdep").unlink(), "missing: rosdep"),
    "a group": ("tools.sh", says("getent", "exit 2"), "the groups sudo and video are not both there"),
    "root's own shells": ("tools.sh", text("root/.bashrc", "alias ll=ls\n"), "/root/.bashrc sources no ROS"),
}  # fmt: skip
"""What is broken: the check, how, and what it says."""


@pytest.fixture
def root(tmp_path: Path) -> Root:
    for name in ("root", "programs"):
        (tmp_path / name).mkdir()
    return Root(tmp_path / "root", tmp_path / "programs")


@pytest.mark.parametrize("check", GOOD)
def test_what_is_as_it_should_be_passes(root: Root, check: str) -> None:
    GOOD[check](root)
    done = root.run(*check.split())
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("broken", BROKEN)
def test_what_is_broken_is_named(root: Root, broken: str) -> None:
    check, breaks, words = BROKEN[broken]
    GOOD[check](root)
    breaks(root)
    done = root.run(*check.split())
    assert done.returncode not in (0, 126, 127), done.stdout + done.stderr
    assert words in done.stderr, done.stdout + done.stderr


def test_every_check_is_seen_to_fail() -> None:
    checks = {path.name for path in (STRUCTURE / "checks").iterdir() if path.suffix in (".sh", ".py")}
    tried = {check.split()[0] for check, _, _ in BROKEN.values()}
    assert tried == {check.split()[0] for check in GOOD}
    assert tried | ELSEWHERE.keys() == checks
    for check, file in ELSEWHERE.items():
        assert check in (ROOT / file).read_text()


def test_every_middleware_is_tried(root: Root) -> None:
    """ROS's default one first, then those that the matrix names."""
    middlewares(root)
    assert root.run("rmw.sh").returncode == 0
    calls = (root.programs / "asked").read_text().splitlines()
    assert calls == ["=", "rmw_cyclonedds_cpp=rmw_cyclonedds_cpp", "rmw_zenoh_cpp=rmw_zenoh_cpp"]


# ---- What the runner makes of the tests' reports ---------------------------------------------------------------------


def test_silence_is_no_success(tmp_path: Path) -> None:
    passed = {"Total": 1, "Pass": 1, "Fail": 0, "Results": [{"Name": "a", "Pass": True}]}
    (tmp_path / "good.json").write_text(json.dumps(passed))
    (tmp_path / "empty.json").write_text(json.dumps({"Total": 0}))
    (tmp_path / "torn.json").write_text("{")
    (tmp_path / "torn.log").write_text("no such file")
    wrong = [{"Name": "b", "Pass": False, "Errors": ["expected 1"], "Stderr": "why"}]
    (tmp_path / "bad.json").write_text(json.dumps({"Total": 2, "Pass": 1, "Fail": 1, "Results": wrong}))
    names = ("good", "empty", "torn", "absent", "bad")
    subprocess.run([sys.executable, STRUCTURE / "summary.py", tmp_path, *names], check=True, capture_output=True)
    assert (tmp_path / "failed").read_text() == (
        "empty: no test ran\ntorn: no report: no such file\nabsent: no report: the runner did not start\n"
        "bad: b: expected 1\nwhy\n"
    )
