"""What somebody reads if pip refuses a package for what the image keeps to: real pip resolves small wheels."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

from fakes.stubs import script_of_a_build

WHEELS = {
    ("numpy", "1.26.4"): (),
    ("numpy", "2.1.0"): (),
    ("torch", "2.9.0"): (),
    ("torch", "2.10.0"): (),
    ("grasp", "1.0"): ("numpy<2",),
    ("grasp", "3.0"): ("numpy>=2",),
    ("seen", "1.0"): ("grasp==3.0",),
    ("trained", "1.0"): ("torch==2.9.0",),
}


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A Python with pip."""
    folder = tmp_path_factory.mktemp("python")
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
    return folder / "bin/python"


@pytest.fixture
def script(python: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """pip_install.py in an image that keeps to numpy below 2, and has PyTorch."""
    (tmp_path / "constraints.d").mkdir()
    (tmp_path / "constraints.txt").write_text("numpy<2\n")
    (tmp_path / "constraints.d/02.txt").write_text("torch==2.10.0\n")
    (tmp_path / "constraints.d/all.txt").write_text("-c ../constraints.txt\n-c 02.txt\n")
    for (name, version), requirements in WHEELS.items():
        info = f"{name}-{version}.dist-info"
        metadata = ["Metadata-Version: 2.1", f"Name: {name}", f"Version: {version}"]
        metadata += [f"Requires-Dist: {item}" for item in requirements]
        with zipfile.ZipFile(tmp_path / f"{name}-{version}-py3-none-any.whl", "w") as file:
            file.writestr(f"{info}/METADATA", "\n".join(metadata))
            file.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
            file.writestr(f"{info}/RECORD", "")
    monkeypatch.setenv("PIP_CONSTRAINT", str(tmp_path / "constraints.d/all.txt"))
    module = script_of_a_build("containerize/pip_install.py")
    monkeypatch.setattr(module, "CONSTRAINTS", tmp_path)
    monkeypatch.setattr(module.sys, "executable", str(python))
    return module


ROS = "and ROS's packages in this image work with numpy<2; ask for {}; or take a base image with another numpy "


@pytest.mark.parametrize(
    ("requirement", "message"),
    [
        ("grasp==3.0", f"error: grasp 3.0 needs numpy>=2, {ROS.format('a release of grasp that takes numpy<2')}"),
        ("seen", f"error: grasp 3.0 needs numpy>=2, {ROS.format('a release of grasp that takes numpy<2')}"),
        ("numpy>=2", f"error: the requirements for pip name numpy>=2, {ROS.format('numpy without a version')}"),
        ("trained", "error: trained 1.0 needs torch==2.9.0, and the image has torch==2.10.0; ask for a release of trained "),
        ("missing", "error: pip ended with 1; the lines above say why"),
        ("grasp", ""),
    ],
)  # fmt: skip
def test_the_error_says_what_the_image_keeps_to_and_what_to_do(
    script: ModuleType, tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes], requirement: str, message: str
) -> None:
    """If the requirement leaves the choice to pip, it takes the release that fits."""
    arguments = ["--dry-run", "--no-index", "--find-links", str(tmp_path), requirement]
    if not message:
        script.run(arguments)
        assert b"Would install grasp-1.0 numpy-1.26.4" in capfdbinary.readouterr().out
        return
    with pytest.raises(SystemExit) as caught:
        script.run(arguments)
    assert str(caught.value).startswith(message)
    assert b"ERROR: " in capfdbinary.readouterr().out, "pip's own words stand above it"
