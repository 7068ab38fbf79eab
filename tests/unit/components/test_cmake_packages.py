"""find_package(Torch) and find_package(TensorFlow) as files.sh makes them, on wheels that have just their outlines.

CMake configures, nothing is compiled: whether programs build and run is tested in the images.
"""

from __future__ import annotations

import base64
import hashlib
import importlib.metadata
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

SITE = "usr/local/lib/python3.12/dist-packages"
TRIPLET = "x86_64-linux-gnu"
SCOPE = "_ZNK10tensorflow5Scope10WithDeviceERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE@@tensorflow"
SESSION = "_ZN10tensorflow13ClientSessionC1ERKNS_5ScopeE@@tensorflow"


SESSION_FUNCTIONS = ("ClientSession(tensorflow::Scope const&)", "Run(std::vector<int>*) const")
"""What the local replacement for the compiler makes of client_session.cc."""

SESSION_HEADER = """\
class ClientSession {
 public:
  explicit ClientSession(const Scope& scope);
  absl::Status Run(std::vector<int>* outputs) const;
};
"""

C_API, INTERNAL = "tensorflow/c/c_api.h", "tensorflow/c/c_api_internal.h"

EMPTY = "sha256=47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU,0"
"""An empty file in a RECORD."""


def files(root: Path, *names: str) -> None:
    for name in names:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text("")


def assemble(root: Path, part: str, *symbols: str) -> None:
    """Runs a part's files.sh with a compiler that makes empty files and a library that exports these symbols."""
    programs = root / "programs"
    programs.mkdir()
    session = "".join(f"echo '0 T tensorflow::ClientSession::{name}'\n" for name in SESSION_FUNCTIONS)
    listed = "".join(f"echo '0 T {symbol}'\n" for symbol in symbols)
    executable(programs / f"{TRIPLET}-nm", f"case $* in *--demangle*)\n{session};; *) :\n{listed};; esac")
    executable(programs / f"{TRIPLET}-strip", ":")
    reads = 'for last; do :; done; case " $* " in *" -M "*) echo "x.o: $last tsl/platform/ctstring.h"; exit;; esac\n'
    executable(programs / f"{TRIPLET}-g++", reads + 'while [ "$1" != -o ]; do shift; done; : >"$2"')
    (root / "usr/lib" / TRIPLET).mkdir(parents=True)
    environment = {"PATH": f"{programs}:{os.environ['PATH']}", "OUT": str(root), "SITE": f"/{SITE}"}
    environment |= {"TRIPLET": TRIPLET, "ACCELERATOR": "cpu"}
    subprocess.run([ROOT / f"components/{part}/files.sh"], env=environment, check=True)
    # Links lead to places in the image.
    for link in [*(root / "usr/lib" / TRIPLET).iterdir(), *(root / SITE / "tensorflow").glob("*")]:
        if link.is_symlink() and os.readlink(link).startswith("/"):
            target = root / os.readlink(link).lstrip("/")
            link.unlink()
            link.symlink_to(target)


ALL = "torch/include/torch/csrc/api/include/torch/all"


@pytest.fixture
def torch(tmp_path: Path) -> Path:
    root = tmp_path / "torch root"
    site = root / SITE
    files(site, "torch-2.10.0+cu128.dist-info/RECORD", *(f"torch/lib/lib{x}.so" for x in ("c10", "torch_cpu", "torch")))
    files(site, "torch/share/cmake/Torch/TorchConfigVersion.cmake")
    (site / "torch/share/cmake/Torch/TorchConfig.cmake").write_text(
        'set(TORCH_CXX_FLAGS "-D_GLIBCXX_USE_CXX11_ABI=1")\nmessage(FATAL_ERROR "cannot find the CUDA libraries")\n'
    )
    (site / "torch/version.py").write_text("__version__ = '2.10.0+cu128'\n")
    files(site, f"{ALL}.h")
    (site / f"{ALL}.h").write_text("#if !defined(_MSC_VER) && __cplusplus < 201703L\n")
    files(site, "torch/share/cmake/Caffe2/Caffe2Targets.cmake")
    (site / "torch/share/cmake/Caffe2/Caffe2Targets.cmake").write_text(
        '  INTERFACE_COMPILE_DEFINITIONS "USE_RPC;USE_A"\n  INTERFACE_COMPILE_DEFINITIONS "USE_A"\n'
        '  INTERFACE_COMPILE_DEFINITIONS "\\$<TARGET_PROPERTY:torch>"\n'
    )
    assemble(root, "torch")
    return root


def tensorflow(
    folder: Path, version: str, *symbols: str, beside: str = "tensorflow_estimator-2.13.0", header: str = SESSION_HEADER
) -> Path:
    root = folder / "tensorflow root"
    site = root / SITE
    files(site, *(f"tensorflow/libtensorflow_{x}.so.2" for x in ("cc", "framework")))
    wheel = f"tensorflow_cpu-{version}.dist-info"
    files(site, f"{beside}.dist-info/RECORD", f"{wheel}/METADATA", f"{wheel}/RECORD")
    release = "release_version.h" if version != "2.13.1" else "version.h"
    include = "tensorflow/include"
    headers = (f"{include}/tensorflow/core/public/{release}", f"{include}/{C_API}", f"{include}/{INTERNAL}")
    shared = ("tensorflow/libtensorflow_cc.so.2", *headers)
    files(site, *headers)
    files(root / "usr/local/lib/rosml/tensorflow-cc", *shared)
    session = "tensorflow/include/tensorflow/cc/client/client_session.h"
    for folder in (site, root / "usr/local/lib/rosml/tensorflow-cc"):
        files(folder, session)
        (folder / session).write_text(header)
    digest = base64.urlsafe_b64encode(hashlib.sha256(header.encode()).digest()).decode().rstrip("=")
    rows = [*(f"{file},{EMPTY}" for file in shared), f"{session},sha256={digest},{len(header)}"]
    (site / f"tensorflow_cpu-{version}.dist-info/RECORD").write_text("\n".join(rows) + "\n")
    assemble(root, "tensorflow", SCOPE, *symbols)
    return root


@pytest.fixture
def newer(tmp_path: Path) -> Path:
    """A wheel without ClientSession."""
    return tensorflow(tmp_path, "2.20.0")


def test_who_replaces_tensorflow_replaces_the_wheel_that_it_stands_for(newer: Path) -> None:
    alias, wheel = (
        (newer / SITE / f"{name}-2.20.0.dist-info/RECORD").read_text().splitlines()
        for name in ("tensorflow", "tensorflow_cpu")
    )
    assert "tensorflow/libtensorflow_cc.so.2,," in wheel, "as the part has it: a link"
    assert set(wheel) < set(alias)


def configure(folder: Path, root: Path, text: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Configures a project without languages; Threads is a local replacement, as the real one wants a compiler."""
    project = folder / "project"
    shutil.rmtree(project, ignore_errors=True)
    project.mkdir()
    (project / "FindThreads.cmake").write_text(
        "if(NOT TARGET Threads::Threads)\n  add_library(Threads::Threads INTERFACE IMPORTED)\nendif()\n"
        "set(Threads_FOUND TRUE)\n"
    )
    (project / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.19)\nproject(x LANGUAGES NONE)\n"
        f"list(APPEND CMAKE_MODULE_PATH ${{CMAKE_SOURCE_DIR}})\n{text}\n"
    )
    prefix = [] if arguments else [f"-DCMAKE_PREFIX_PATH={root / 'usr/local'}"]
    command = [str(Path(sys.executable).parent / "cmake"), "-G", "Unix Makefiles", "-S", str(project), "-B"]
    command += [str(project / "build"), "-DCMAKE_MAKE_PROGRAM=/bin/true", *prefix, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def statuses(done: subprocess.CompletedProcess[str]) -> list[str]:
    """What the project reported with message(STATUS "= ...")."""
    assert done.returncode == 0, done.stderr
    return [line.removeprefix("-- = ") for line in done.stdout.splitlines() if line.startswith("-- = ")]


# ---- Scopes and repeated calls ---------------------------------------------------------------------------------------

FIXTURES = {"Torch": "torch", "TensorFlow": "newer"}
REPORT = {
    "Torch": "${TORCH_FOUND} ${Torch_VERSION} ${TORCH_LIBRARIES} ${TORCH_CXX_FLAGS} ${TORCH_INCLUDE_DIRS}",
    "TensorFlow": "${TensorFlow_FOUND} ${TensorFlow_VERSION} ${TensorFlow_LIBRARIES} ${TensorFlow_CXX_FLAGS} "
    "${TensorFlow_INCLUDE_DIRS}",
}


@pytest.mark.parametrize("package", REPORT)
def test_variables_are_there_in_every_scope_and_after_every_call(
    package: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    root: Path = request.getfixturevalue(FIXTURES[package])
    call = f'find_package({package} REQUIRED)\nmessage(STATUS "= {REPORT[package]}")\n'
    text = (
        f"function(in_a_function)\n{call}endfunction()\nin_a_function()\n{call}{call}"
        f"foreach(name a b)\n  file(WRITE ${{CMAKE_SOURCE_DIR}}/${{name}}/CMakeLists.txt [=[{call}]=])\n"
        "  add_subdirectory(${name})\nendforeach()"
    )
    lines = statuses(configure(tmp_path, root, text))
    assert len(lines) == 5
    assert len(set(lines)) == 1
    values = {
        "Torch": f"TRUE 2.10.0 torch;torch_library -D_GLIBCXX_USE_CXX11_ABI=1 {root / SITE}/torch/include;",
        "TensorFlow": "1 2.20.0 TensorFlow::tensorflow_cc;TensorFlow::tensorflow_framework "
        f"-D_GLIBCXX_USE_CXX11_ABI=1 -DEIGEN_MAX_ALIGN_BYTES=64 {root / SITE}/tensorflow/include",
    }
    assert lines[0].startswith(values[package])


LINKED = {"Torch": "torch_library", "TensorFlow": "TensorFlow::tensorflow_cc"}


@pytest.mark.parametrize("package", LINKED)
def test_the_standard_comes_with_the_target(package: str, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    """C++17, whatever the compiler does by itself and the project asks for; a project without C++ has none to ask for."""
    root: Path = request.getfixturevalue(FIXTURES[package])
    text = (
        "set(CMAKE_CXX_COMPILER_LOADED 1)\n"
        f"find_package({package} REQUIRED)\n"
        f"get_target_property(features {LINKED[package]} INTERFACE_COMPILE_FEATURES)\n"
        'message(STATUS "= ${features}")'
    )
    assert statuses(configure(tmp_path, root, text)) == ["cxx_std_17"]


def test_headers_that_want_newer_c_plus_plus_say_so(tmp_path: Path, torch: Path) -> None:
    """From PyTorch 2.14 on: compilers take C++17 by themselves, so pkg-config's flags ask for it too."""
    pkgconfig = torch / "usr/local/lib/pkgconfig/torch.pc"
    assert "-std=" not in pkgconfig.read_text()
    (torch / SITE / f"{ALL}.h").write_text("#if !defined(_MSC_VER) && __cplusplus < 202002L\n")
    for folder in ("programs", "usr/lib", "usr/local/lib/cmake", "usr/local/lib/pkgconfig"):
        shutil.rmtree(torch / folder)
    assemble(torch, "torch")
    text = 'find_package(Torch REQUIRED)\nget_target_property(features torch_library INTERFACE_COMPILE_FEATURES)\nmessage(STATUS "= ${features}")'
    assert statuses(configure(tmp_path, torch, text)) == ["cxx_std_20"]
    assert "C++20" in pkgconfig.read_text() and "\nCflags: -std=c++20 -isystem " in pkgconfig.read_text()


# ---- Versions --------------------------------------------------------------------------------------------------------

REQUESTS = {
    "": True,
    "2.4": True,
    "2.10": True,
    "2.10.0 EXACT": True,
    "2.4 EXACT": False,
    "2.10.1": False,
    "1.13": False,
    "1": False,
    "2.4...<3": True,
    "2.4...2.10": True,
    "1.13...3": True,
    "2.11...<3": False,
}
"""What is asked of a package of version 2.10.0, and whether that version will do."""


def requests(package: str) -> str:
    return "".join(
        f'find_package({package} {request} QUIET)\nmessage(STATUS "= {request}: ${{{package}_FOUND}}")\n'
        f"unset({package}_DIR CACHE)\nunset({package}_FOUND)\n"
        for request in REQUESTS
    )


def test_versions_of_torch(tmp_path: Path, torch: Path) -> None:
    """As the wheel's own package: programs for an older major version are content with a newer one."""
    lines = statuses(configure(tmp_path, torch, requests("Torch")))
    fits = {**REQUESTS, "1.13": True, "1": True}
    assert [line.endswith((": 1", ": TRUE")) for line in lines] == list(fits.values()), lines


def test_versions_of_tensorflow(tmp_path: Path) -> None:
    root = tensorflow(tmp_path, "2.10.0")
    lines = statuses(configure(tmp_path, root, requests("TensorFlow")))
    assert [line.endswith((": 1", ": TRUE")) for line in lines] == list(REQUESTS.values()), lines


# ---- Torch -----------------------------------------------------------------------------------------------------------


def test_the_path_that_torch_tells_leads_to_the_package_without_a_toolkit(tmp_path: Path, torch: Path) -> None:
    prefix = f"-DCMAKE_PREFIX_PATH={torch / SITE / 'torch/share/cmake'}"
    text = 'find_package(Torch 2.4...<3 REQUIRED)\nmessage(STATUS "= ${TORCH_INSTALL_PREFIX} ${Torch_DIR}")'
    (line,) = statuses(configure(tmp_path, torch, text, prefix))
    assert line == f"{torch / SITE}/torch {torch / SITE}/torch/share/cmake/Torch"
    failed = configure(tmp_path, torch, "find_package(Torch 3 REQUIRED)", prefix)
    assert "version: 2.10.0" in failed.stderr


def test_the_compiler_is_told_what_the_wheels_own_package_tells_it(tmp_path: Path, torch: Path) -> None:
    text = (
        "find_package(Torch REQUIRED)\nget_target_property(definitions torch_library INTERFACE_COMPILE_DEFINITIONS)\n"
        'message(STATUS "= ${definitions}")'
    )
    assert statuses(configure(tmp_path, torch, text)) == ["_GLIBCXX_USE_CXX11_ABI=1;USE_A;USE_RPC"]
    flags = (torch / "usr/local/lib/pkgconfig/torch.pc").read_text()
    assert " -D_GLIBCXX_USE_CXX11_ABI=1 -DUSE_A -DUSE_RPC\n" in flags


# ---- TensorFlow ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["tensorflow", "Tensorflow", "TensorflowCC", "TensorFlowCC"])
def test_tensorflow_under_the_names_of_other_builds(tmp_path: Path, newer: Path, name: str) -> None:
    text = (
        f"find_package({name} 2.4 REQUIRED)\n"
        f"get_target_property(linked {'tensorflow' if name == 'tensorflow' else 'TensorflowCC::Shared'} INTERFACE_LINK_LIBRARIES)\n"
        f'message(STATUS "= ${{linked}} ${{{name}_VERSION}} ${{{name}_INCLUDE_DIRS}} ${{{name}_LIBRARIES}}")\n'
        'message(STATUS "= ${TENSORFLOW_INCLUDE_DIR} ${TensorFlow_LIBRARY} ${TENSORFLOW_FOUND}")'
    )
    libraries = "TensorFlow::tensorflow_cc;TensorFlow::tensorflow_framework"
    include = newer / SITE / "tensorflow/include"
    assert statuses(configure(tmp_path, newer, text)) == [
        f"TensorFlow::tensorflow_cc 2.20.0 {include} {libraries}",
        f"{include} {libraries} TRUE",
    ]


def test_the_c_api_is_on_the_default_path_and_all_headers_in_a_folder_of_their_own(newer: Path) -> None:
    include = newer / "usr/local/include"
    links = {str(path.relative_to(include)) for path in include.rglob("*") if path.is_symlink()}
    assert links == {C_API, "tsl/platform/ctstring.h", "tensorflow/tensorflow", "google/tensorflow"}
    assert os.readlink(include / C_API) == f"/{SITE}/tensorflow/include/{C_API}"
    libraries = newer / "usr/lib" / TRIPLET
    assert "libtensorflow_cc.so.2 AS_NEEDED( " in (libraries / "libtensorflow.so").read_text()


def test_a_wheel_without_the_c_api_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(subprocess.CalledProcessError), pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys.modules[__name__], "C_API", "tensorflow/d/c_api.h")
        tensorflow(tmp_path, "2.20.0")


def test_what_depends_on_tensorflow_finds_it_under_its_other_name(newer: Path) -> None:
    """tensorflow-cpu is a package of another name: pip would download TensorFlow again."""
    site = str(newer / SITE)
    (package,) = importlib.metadata.distributions(name="tensorflow", path=[site])
    assert (package.version, package.requires) == ("2.20.0", ["tensorflow_cpu==2.20.0"])
    assert package.files and all(Path(str(file.locate())).exists() for file in package.files)


def test_a_release_that_brings_that_package_itself(tmp_path: Path) -> None:
    """On arm64 `tensorflow` 2.13.1 is a wheel without files, which requires another one."""
    root = tensorflow(tmp_path, "2.13.1", SESSION, beside="tensorflow-2.13.1")
    assert [path.name for path in (root / SITE / "tensorflow-2.13.1.dist-info").iterdir()] == ["RECORD"], "made anew"


def test_libraries_beside_the_package_are_found_by_programs(tmp_path: Path) -> None:
    """Wheels for arm64 bring OpenMP's runtime in a folder of their own, below which no program looks."""
    bundled = f"{SITE}/tensorflow_cpu_aws.libs/libomp-f1025659.so.5"
    files(tmp_path / "tensorflow root", bundled)
    root = tensorflow(tmp_path, "2.20.0")
    assert (root / "usr/lib" / TRIPLET / "libomp-f1025659.so.5").resolve() == root / bundled


def test_a_client_session_is_built_where_the_wheel_has_none(tmp_path: Path, newer: Path) -> None:
    libraries = newer / "usr/lib" / TRIPLET
    assert (libraries / "libtensorflow_cc.so").read_text() == (
        f"/* GNU ld script */\nINPUT(/usr/lib/{TRIPLET}/libtensorflow_cc.so.2 "
        f"AS_NEEDED( /usr/lib/{TRIPLET}/libtensorflow_framework.so.2 "
        f"/usr/lib/{TRIPLET}/libtensorflow_client_session.so.2 ))\n"
    )
    text = (
        "find_package(TensorFlow REQUIRED)\n"
        "get_target_property(links TensorFlow::tensorflow_cc INTERFACE_LINK_LIBRARIES)\n"
        'message(STATUS "= ${links}")'
    )
    (line,) = statuses(configure(tmp_path, newer, text))
    assert line.endswith(",--pop-state;TensorFlow::tensorflow_framework;TensorFlow::tensorflow_client_session")


def test_a_newer_header_with_a_function_that_we_do_not_define(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """It would be told by nobody but the linker of whoever calls it."""
    newer = SESSION_HEADER.replace("};", "  absl::Status Close();\n  absl::Status Run() const;\n};")
    with pytest.raises(subprocess.CalledProcessError):
        tensorflow(tmp_path, "2.20.0", header=newer)
    assert "Close (1 declared, 0 defined), Run (2 declared, 1 defined)" in capfd.readouterr().err


def test_nothing_is_built_where_the_wheel_has_one(tmp_path: Path) -> None:
    root = tensorflow(tmp_path, "2.13.1", SESSION)
    libraries = root / "usr/lib" / TRIPLET
    assert "client_session" not in (libraries / "libtensorflow_cc.so").read_text()
    assert not (libraries / "libtensorflow_client_session.so.2").exists()
    text = (
        "find_package(TensorFlow 2.13 REQUIRED)\n"
        'if(TARGET TensorFlow::tensorflow_client_session)\n  message(FATAL_ERROR "not wanted")\nendif()\n'
        'message(STATUS "= ${TensorFlow_CXX_FLAGS}")'
    )
    assert statuses(configure(tmp_path, root, text)) == ["-D_GLIBCXX_USE_CXX11_ABI=1 -DEIGEN_MAX_ALIGN_BYTES=64"]


# ---- Wheels that are gone --------------------------------------------------------------------------------------------


def removed(site: Path) -> None:
    """What `pip uninstall` does."""
    for folder in site.iterdir():
        shutil.rmtree(folder)


def replaced(site: Path) -> None:
    """What `pip install` of another release does."""
    for folder in site.glob("t*[0-9].dist-info"):
        folder.rename(site / f"{folder.name.split('-')[0]}-2.0.0.dist-info")
    for folder in site.glob("torch-2.10.0*"):
        folder.rename(site / "torch-2.0.0.dist-info")


@pytest.mark.parametrize("change", [removed, replaced])
@pytest.mark.parametrize("package", REPORT)
def test_a_wheel_that_is_gone_is_said_to_be(
    package: str, change: Callable[[Path], None], tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    root: Path = request.getfixturevalue(FIXTURES[package])
    change(root / SITE)
    text = f'find_package({package} QUIET)\nmessage(STATUS "= ${{{package}_FOUND}} ${{TORCH_FOUND}}")'
    assert statuses(configure(tmp_path, root, text)) == [{"Torch": "0 FALSE", "TensorFlow": "0 "}[package]]
    failed = configure(tmp_path, root, f"find_package({package} REQUIRED)")
    assert failed.returncode != 0
    assert "was uninstalled from" in " ".join(failed.stderr.split())
