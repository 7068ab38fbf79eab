"""What becomes of a wheel's files in a part: pruned ones are forgotten, all others are what the wheel has."""

from __future__ import annotations

import base64
import csv
import hashlib
import os
import re
import subprocess
import sys
from collections.abc import Callable
from importlib.metadata import distributions
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable
from offline.assembler import interpreter

SCRIPT = ROOT / "components/part/records.py"
SITE = "usr/local/lib/python3.11/dist-packages"


class Part:
    """A part in the making: a wheel with some files, and a part's rules."""

    def __init__(self, folder: Path) -> None:
        self.out, self.part = folder / "out", folder / "part"
        self.site = self.out / SITE
        self.part.mkdir()
        self.record = self.site / "thing-1.dist-info/RECORD"
        self.record.parent.mkdir(parents=True)
        self.record.write_text("thing-1.dist-info/RECORD,,\n")
        self.add("thing/__init__.py", "import this\n")
        self.add("thing/deep/tests/test_a.py", "assert True\n")
        self.add("thing/lib/libthing.a", "archive")
        self.add("thing/cmake/config, old.cmake", "theirs\n")

    def add(self, path: str, content: str) -> None:
        file = self.site / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content.encode()).digest()).rstrip(b"=").decode()
        with self.record.open("a", newline="") as stream:
            csv.writer(stream).writerow([path, f"sha256={digest}", len(content)])

    def rules(self, prune: str = "", adapted: str = "", keep: str = "") -> None:
        (self.part / "prune.txt").write_text(prune)
        (self.part / "keep.txt").write_text(keep)
        (self.part / "adapted.txt").write_text(adapted)

    def run(self, *words: str, script: str = SCRIPT.name, **variables: str) -> subprocess.CompletedProcess[str]:
        env = {**os.environ, "OUT": str(self.out), "SITE": f"/{SITE}", "PART_FOLDER": str(self.part), **variables}
        program = [sys.executable] if script.endswith(".py") else []
        command = [*program, str(SCRIPT.with_name(script)), *words]
        return subprocess.run(command, env=env, capture_output=True, text=True, check=False)

    def verifies(self) -> bool:
        return self.run("verify").returncode == 0

    def recorded(self) -> dict[str, tuple[str, str]]:
        with self.record.open(newline="") as stream:
            return {row[0]: (row[1], row[2]) for row in csv.reader(stream)}

    def files(self) -> set[str]:
        return {str(path.relative_to(self.site)) for path in self.site.rglob("*") if not path.is_dir()}


@pytest.fixture
def part(tmp_path: Path) -> Part:
    return Part(tmp_path)


def test_pruned_files_are_gone_and_forgotten(part: Part) -> None:
    part.rules(prune="# why\nthing/*.a\nthing/*tests/*\nother/*\n")
    done = part.run("prune")
    assert "prune: thing/*.a: 1 files" in done.stdout and "prune: other/*: 0 files" in done.stdout
    assert part.recorded().keys() == part.files()
    assert not (part.site / "thing/deep").exists(), "no empty folders are left"
    assert (part.site / "thing/__init__.py").exists()
    assert part.verifies()


def test_a_file_of_two_wheels_is_forgotten_by_both(part: Part) -> None:
    other = part.site / "other-1.dist-info/RECORD"
    other.parent.mkdir()
    other.write_text(f"thing/lib/libthing.a,{','.join(part.recorded()['thing/lib/libthing.a'])}\n")
    part.rules(prune="thing/*.a\n")
    assert part.run("prune").returncode == 0
    assert other.read_text() == ""
    assert part.verifies()


@pytest.mark.parametrize("change", ["missing", "other content", "other size"])
def test_what_differs_from_the_wheel_fails(part: Part, change: str) -> None:
    file = part.site / "thing/__init__.py"
    if change == "missing":
        file.unlink()
    else:
        file.write_text("import that\n" if change == "other content" else "")
    done = part.run("verify")
    assert done.returncode == 1
    what = "is missing" if change == "missing" else "is not what the wheel has"
    assert done.stderr == f"records: thing/__init__.py {what}\n"


def test_bytecode_is_made_anew_and_not_on_record(part: Part) -> None:
    part.add("thing/__pycache__/__init__.cpython-311.pyc", "theirs")
    (part.site / "thing/__pycache__/__init__.cpython-311.pyc").write_text("ours")
    assert part.verifies()
    assert not [path for path in part.recorded() if path.endswith(".pyc")]


def test_an_adapted_file_is_recorded_as_it_is_now(part: Part) -> None:
    """A name with a comma, as RECORD quotes it."""
    part.rules(adapted="thing/cmake/*\n")
    (part.site / "thing/cmake/config, old.cmake").write_text("ours\n")
    assert part.verifies()
    part.rules()
    assert part.verifies(), "its record is what it is"


def test_a_link_to_another_part(part: Part) -> None:
    link = part.site / "thing/lib/libthing.a"
    link.unlink()
    link.symlink_to("/usr/lib/of-another-part.so")
    assert not part.verifies()
    part.rules(adapted="thing/lib/*\n")
    assert part.verifies()
    assert part.recorded()["thing/lib/libthing.a"] == ("", "")


def test_nothing_is_not_taken_for_everything(part: Part) -> None:
    part.record.unlink()
    part.record.parent.rmdir()
    done = part.run("verify")
    assert (done.returncode, done.stderr) == (1, "records: nothing is recorded\n")


def test_a_part_that_takes_little_of_its_wheels_keeps_just_that(part: Part) -> None:
    part.add("thing/lib/deep/libthing.so", "library")
    part.rules(keep="thing/lib/*\n*.dist-info/*\n", prune="*.a\n")
    done = part.run("prune")
    assert "prune: what keep.txt does not name: 3 files" in done.stdout
    assert part.files() == {"thing/lib/deep/libthing.so", "thing-1.dist-info/RECORD"} == part.recorded().keys()
    assert part.verifies()


LINK = ("link", "/usr/local/lib/rosml/other", "thing/lib", "thing/__init__.py")
"""One folder and one file that another part has."""


def test_links_to_another_part_take_the_place_of_files(part: Part) -> None:
    part.add("thing/lib/deep/more", "more\n")
    before = [",".join((path, *fact)) for path, fact in part.recorded().items() if path in TAKEN]
    done = part.run(*LINK)
    assert done.returncode == 0, done.stderr
    for path in ("thing/lib", "thing/__init__.py"):
        assert os.readlink(part.site / path) == f"/usr/local/lib/rosml/other/{path}"
        assert part.recorded()[path] == ("", ""), "pip removes the link, and leaves what it leads to alone"
    assert part.recorded().keys() == part.files()
    expected = hashlib.sha256("\n".join(sorted(before)).encode()).hexdigest()
    assert (part.out / "usr/local/share/rosml/expected.d/other").read_text() == f"{expected}\n"
    assert part.verifies()


def test_a_package_stands_for_a_wheel_of_another_name(part: Part) -> None:
    """pip finds it, and whoever replaces it replaces the wheel's files."""
    facts = {
        "Author-email": "A <a@example.org>",
        "License": "MIT",
        "Classifier": "License :: OSI Approved :: MIT License",
    }
    lines = [f"{name}: {value}" for name, value in facts.items()]
    metadata = "\n".join(["Name: thing", *lines, "Classifier: Topic :: Robots", "", "License: text\n"])
    part.add("thing-1.dist-info/METADATA", metadata)
    done = part.run("alias", "other", "thing-1.dist-info")
    assert done.returncode == 0, done.stderr
    [package] = distributions(name="other", path=[str(part.site)])
    assert (package.version, package.requires) == ("1", ["thing==1"])
    assert {name: package.metadata.get_all(name) for name in facts} == {name: [value] for name, value in facts.items()}
    files = [f"other-1.dist-info/{name}" for name in ("INSTALLER", "METADATA", "RECORD", "WHEEL")]
    assert {str(path) for path in package.files or ()} == {*files, *part.recorded()}
    assert part.verifies()


def test_a_wheel_of_that_name_stands_for_itself(part: Part) -> None:
    before = part.record.read_bytes(), part.files()
    assert part.run("alias", "thing", "thing-1.dist-info").returncode == 0
    assert (part.record.read_bytes(), part.files()) == before


def test_a_package_that_another_wheel_brings_stays(part: Part) -> None:
    other = part.site / "other-1.dist-info"
    other.mkdir()
    (other / "METADATA").write_text("theirs\n")
    (other / "RECORD").write_text("other-1.dist-info/RECORD,,\n")
    assert part.run("alias", "other", "thing-1.dist-info").returncode == 0
    assert (other / "METADATA").read_text() == "theirs\n"
    assert (other / "RECORD").read_bytes() == b"other-1.dist-info/RECORD,,\n" + part.record.read_bytes()


TAKEN = ("thing/lib/libthing.a", "thing/lib/deep/more", "thing/__init__.py")


def changed_file(part: Part) -> None:
    (part.site / "thing/lib/libthing.a").write_text("other  ")


def file_on_no_record(part: Part) -> None:
    (part.site / "thing/lib/new").write_text("")


def missing_file(part: Part) -> None:
    part.add("thing/lib/gone", "gone")
    (part.site / "thing/lib/gone").unlink()


@pytest.mark.parametrize("damage", [changed_file, file_on_no_record, missing_file])
def test_what_is_not_the_wheels_is_no_link(part: Part, damage: Callable[[Part], None]) -> None:
    damage(part)
    done = part.run(*LINK)
    assert done.returncode == 1 and "thing/lib is not what the wheel has" in done.stderr


# ---- abseil's hash ---------------------------------------------------------------------------------------------------

HASH = "tensorflow/include/absl/hash/internal/hash.h"
HASH_H = """\
#ifdef __ARM_ACLE
#include <arm_acle.h>
#endif
namespace absl {
  ABSL_ATTRIBUTE_ALWAYS_INLINE static uint64_t WeakMix(uint64_t n) {
#ifdef __ARM_ACLE
    // gbswap_64 compiles to `rev` on ARM, but `rbit` is better because it
    // reverses bits rather than reversing bytes.
    return __rbitll(n * kMul);
#else
    return absl::gbswap_64(n * kMul);
#endif
  }
"""


def adapt(part: Part, architecture: str = "arm64") -> subprocess.CompletedProcess[str]:
    return part.run(script="abseil_for_gcc.py", TARGETARCH=architecture)


def test_the_hash_of_tensorflows_libraries_for_arm64_is_that_of_every_compiler(part: Part) -> None:
    part.add(HASH, HASH_H)
    for _ in range(2):
        assert adapt(part).returncode == 0
        text = (part.site / HASH).read_text()
        assert "rbit %0, %1" in text and "__rbitll" not in text
        assert "gbswap_64(n * kMul)" in text, "for other architectures"
        assert part.verifies(), "its record follows"


def test_other_architectures_and_releases_keep_their_hash(part: Part) -> None:
    assert adapt(part).returncode == 0, "a part without that header"
    earlier = HASH_H.replace("#ifdef __ARM_ACLE\n    //", "#if 0\n    //")
    part.add(HASH, "")
    for text, architecture in ((HASH_H, "amd64"), (earlier, "arm64")):
        (part.site / HASH).write_text(text)
        assert adapt(part, architecture).returncode == 0
        assert (part.site / HASH).read_text() == text


def test_a_hash_that_is_not_known_is_an_error(part: Part) -> None:
    part.add(HASH, HASH_H.replace("return __rbitll(n * kMul)", "return __rbitll(n + kMul)"))
    done = adapt(part)
    assert done.returncode == 1 and "not known" in done.stderr


# ---- Adapted metadata ------------------------------------------------------------------------------------------------

METADATA = """\
Metadata-Version: 2.4
Name: thing
Requires-Dist: setuptools>=77.0.3; python_version >= "3.9"
Requires-Dist: setuptools-scm>=8

Requires-Dist: setuptools>=1
"""


def adapt_metadata(part: Part, lock: str) -> subprocess.CompletedProcess[str]:
    part.add("thing-1.dist-info/METADATA", METADATA)
    (part.out / "lock.txt").write_text(lock)
    return part.run(script="adapt_metadata.py", LOCK=str(part.out / "lock.txt"))


def test_metadata_asks_for_what_the_lock_says(part: Part) -> None:
    done = adapt_metadata(part, "# Part\n# adapted: thing setuptools>=66.1.1\nthing==1 --hash=sha256:aa\n")
    assert done.returncode == 0, done.stderr
    text = (part.site / "thing-1.dist-info/METADATA").read_text()
    assert text == METADATA.replace(">=77.0.3", ">=66.1.1", 1)
    assert part.verifies(), "its record follows"


def test_metadata_stays_where_the_lock_says_nothing(part: Part) -> None:
    assert adapt_metadata(part, "thing==1 --hash=sha256:aa\n").returncode == 0
    assert (part.site / "thing-1.dist-info/METADATA").read_text() == METADATA


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("# adapted: thing wheel>=1", "thing asks for wheel 0 times"),
        ("# adapted: other setuptools>=1", "0 packages are called other"),
    ],
)
def test_metadata_that_does_not_ask_is_an_error(part: Part, line: str, complaint: str) -> None:
    done = adapt_metadata(part, f"{line}\n")
    assert (done.returncode, complaint in done.stderr) == (1, True)


LOG = "tensorflow/include/absl/log/internal/log_message.h"
LOG_H = """\
extern template LogMessage& LogMessage::operator<<(const bool& v);
extern template LogMessage& LogMessage::operator<<(
    absl::Nullable<void*> const& v);
extern template void LogMessage::CopyToEncodedBuffer<
    LogMessage::StringType::kLiteral>(absl::string_view str);
"""
CORD = "tensorflow/include/absl/strings/cord.h"
CORD_H = """\
extern template Cord::Cord(std::string&& src);
extern template void Cord::Append(std::string&& src);
"""


def test_templates_whose_names_depend_on_the_compiler_are_its_own(part: Part) -> None:
    part.add(LOG, LOG_H)
    part.add(CORD, CORD_H)
    for _ in range(2):
        assert adapt(part, "amd64").returncode == 0
        assert (part.site / LOG).read_text() == (
            "#ifdef __clang__\n"
            "extern template LogMessage& LogMessage::operator<<(const bool& v);\n"
            "extern template LogMessage& LogMessage::operator<<(\n    absl::Nullable<void*> const& v);\n"
            "#endif\n" + LOG_H.partition("const& v);\n")[2]
        )
        text = (part.site / CORD).read_text()
        assert "Cord::Cord(T&& src) : Cord(absl::string_view(src)) {}\n#endif\n" in text
        assert "void Cord::Append(T&& src) { Append(absl::string_view(src)); }\n#endif\n" in text
        assert part.verifies(), "their records follow"


# ---- TensorFlow's headers ----------------------------------------------------------------------------------------------

EIGEN = "tensorflow/include/Eigen/src/Core/util/ConfigureVectorization.h"
EIGEN_H = "#define EIGEN_CONFIGURE_VECTORIZATION_H\n"
VERSION = "tensorflow/include/tensorflow/core/public/version.h"
VERSION_H = "#define TENSORFLOW_CORE_PUBLIC_VERSION_H_\n"
RELEASE = "tensorflow/include/tensorflow/core/public/release_version.h"
MACROS = ("TF_MAJOR_VERSION", "TF_MINOR_VERSION", "TF_PATCH_VERSION", "TF_VERSION_SUFFIX")
RELEASE_H = "".join(f'#ifndef {name}\n#error "{name} is not defined!"\n#endif\n' for name in MACROS)


def tensorflow(part: Part, release: str = RELEASE_H) -> None:
    """The wheel is one of TensorFlow's, with the headers that are completed."""
    part.record = part.record.parent.rename(part.site / "tensorflow_cpu-2.21.0rc1.dist-info") / "RECORD"
    part.record.write_text(
        part.record.read_text().replace("thing-1", part.record.parent.name.removesuffix(".dist-info"))
    )
    for path, text in ((EIGEN, EIGEN_H), (VERSION, VERSION_H), (RELEASE, release)):
        part.add(path, text)


def complete(part: Part) -> subprocess.CompletedProcess[str]:
    return part.run(script="complete_tensorflow.py")


def test_tensorflows_headers_know_their_release_and_the_constants_of_models(part: Part) -> None:
    assert complete(part).returncode == 0, "a part without them"
    tensorflow(part)
    done = complete(part)
    assert done.returncode == 0, done.stderr
    values = zip(MACROS, ("2", "21", "0", '"rc1"'), strict=True)
    defaults = "".join(f"#ifndef {name}\n#define {name} {value}\n#endif\n" for name, value in values)
    assert (part.site / RELEASE).read_text() == defaults
    assert '#include "tensorflow/core/public/release_version.h"' in (part.site / VERSION).read_text()
    assert "#define EIGEN_MAX_ALIGN_BYTES 64" in (part.site / EIGEN).read_text()
    added = part.site / "tensorflow/include/tensorflow/cc/saved_model/tag_constants.h"
    assert 'inline constexpr char kSavedModelTagServe[] = "serve";' in added.read_text()
    assert str(added.relative_to(part.site)) in part.record.read_text()
    eigen = part.site / "tensorflow/include/third_party/eigen3/unsupported/Eigen/CXX11/Tensor"
    assert eigen.read_text() == "#pragma once\n#include <unsupported/Eigen/CXX11/Tensor>\n"
    assert part.verifies(), "their records follow"


def test_headers_that_ask_for_the_release_in_another_way_are_an_error(part: Part) -> None:
    tensorflow(part, "#ifndef TF_MAJOR_VERSION\n#endif\n")
    done = complete(part)
    assert done.returncode == 1 and "asks for TF_MAJOR_VERSION" in done.stderr


# ---- What is not believed --------------------------------------------------------------------------------------------


def test_a_package_without_a_record(part: Part) -> None:
    (part.site / "other-1.dist-info").mkdir()
    done = part.run("verify")
    assert (done.returncode, done.stderr) == (1, "records: other-1.dist-info has no RECORD\n")


# ---- Bytecode --------------------------------------------------------------------------------------------------------


def bytecode(part: Part, python: str, seed: str = "random") -> subprocess.CompletedProcess[str]:
    """Runs bytecode.sh with an interpreter that is what a shell text says; `real` is the one of these tests.

    Args:
        seed: of Python's hashes, as the environment has it.
    """
    programs = part.out.parent / "programs"
    programs.mkdir(exist_ok=True)
    executable(programs / "python3.99", python.replace("real", sys.executable))
    path = f"{programs}:{os.environ['PATH']}"
    variables = {"PATH": path, "PYTHON": "3.99", "BYTECODE": "checked-hash", "PYTHONHASHSEED": seed}
    return part.run(script="bytecode.sh", **variables)


def test_bytecode_of_all_that_compiles(part: Part) -> None:
    part.add("thing/template.py", "def {{ name }}:\n")
    done = bytecode(part, 'exec real "$@"')
    assert done.returncode == 0, done.stdout + done.stderr
    assert "template.py which does not compile" in done.stdout
    [compiled] = (part.site / "thing/__pycache__").iterdir()
    assert b"/usr/local/lib/python3.11/dist-packages/thing" in compiled.read_bytes()


def test_bytecode_is_the_same_in_each_build(part: Part) -> None:
    """Pythons up to 3.10 write sets in the order that they have in memory."""
    _, home = interpreter("3.8")
    if home is None:
        pytest.skip("no Python as old as the oldest one of the matrix is here, nor can it be downloaded")
    part.add("thing/sets.py", "def known(name):\n    return name in {'a', 'b', 'c', 'd', 'e', 'f', 'g'}\n")
    builds = []
    for seed in ("1", "2"):
        for file in part.site.rglob("*.pyc"):
            file.unlink()
        done = bytecode(part, f'exec {home}/bin/python3.8 "$@"', seed)
        assert done.returncode == 0, done.stdout + done.stderr
        builds.append(sorted((file.name, file.read_bytes()) for file in part.site.rglob("*.pyc")))
    assert len(builds[0]) == 3 and builds[0] == builds[1]


def test_each_step_that_compiles_sets_the_seed() -> None:
    scripts = [*(ROOT / "components").rglob("*.sh"), *(ROOT / "components").rglob("Dockerfile")]
    lines = [line.strip() for file in scripts for line in file.read_text().splitlines()]
    compiling = [
        line for line in lines if re.search(r'-m compileall |/app_files\.py", "/run/|/pip_install\.py" "', line)
    ]
    assert len(compiling) == 5
    for line in (line for line in compiling if not line.startswith("PYTHONHASHSEED=0 ")):
        [before, _] = (ROOT / "components/containerize/Dockerfile").read_text().split(line + "\n")
        assert "\nENV PYTHONHASHSEED=0\n" in before.rpartition("\nFROM ")[2], line


def test_bytecode_that_was_not_written(part: Part) -> None:
    """A full disk, a worker that was killed: anything but code that does not compile."""
    error = """echo 'File "/usr/lib/python3/multiprocessing.py", line 1: BrokenProcessPool'"""
    done = bytecode(part, f'case "$2" in compileall) {error}; exit 1 ;; esac; exec real "$@"')
    assert done.returncode == 1 and "although it compiles" in done.stderr and "BrokenProcessPool" in done.stdout


def test_no_interpreter_for_the_bytecode(part: Part) -> None:
    done = part.run(script="bytecode.sh", PYTHON="3.98", BYTECODE="checked-hash")
    assert done.returncode == 69 and "no python3.98" in done.stderr
