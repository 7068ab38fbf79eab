"""Emulation of the other architecture: what the kernel is told, and who is told what where it cannot be."""

from __future__ import annotations

import os
import platform
import re
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.machine.setup import emulation
from rosml.machine.setup.state import State

ENTRY = ":qemu-aarch64:M::\\x7fELF:\\xff:/usr/libexec/qemu:POF\n"


class Installer:
    def __init__(self, entries: Path) -> None:
        self.entries, self.packages, self.root = entries, dict[str, str](), list[str]()
        self.state = State(entries, print)

    def debian_packages(self, packages: Mapping[str, str], root: Sequence[str] = ()) -> None:
        self.packages.update(packages)
        self.root = list(root)
        if emulation.PACKAGE in packages:
            (self.entries / "qemu-aarch64.conf").write_text(ENTRY)


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Installer:
    for name in ("table", "entries"):
        (tmp_path / name).mkdir()
    (tmp_path / "table/register").write_text("")
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(emulation, "which_system", lambda name: None)
    return Installer(tmp_path / "entries")


def ensure(machine: Installer, hub: bool = False) -> bool:
    folder = machine.entries.parent
    return emulation.ensure(machine, hub, folder / "table", folder / "entries")  # type: ignore[arg-type]


def test_qemu_is_installed_and_the_kernel_told(machine: Installer) -> None:
    assert ensure(machine)
    assert list(machine.packages) == [emulation.PACKAGE, emulation.PROBE]
    assert (machine.entries.parent / "table/register").read_text() == ENTRY


def test_nothing_to_do(machine: Installer, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    (machine.entries.parent / "table/qemu-aarch64").touch()
    assert not ensure(machine), "the builder is started again only for what it could not do before"
    assert emulation.PROBE in machine.packages
    monkeypatch.setattr(emulation, "which_system", lambda name: f"/usr/bin/{name}")
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    assert not ensure(machine)
    assert "arm64 runs already" in capsys.readouterr().out


def test_a_plain_user(machine: Installer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    (machine.state.root / "tools").mkdir(parents=True)
    shutil.copy(ROOT / "tools/images.txt", machine.state.root / "tools")
    with pytest.raises(RosmlError, match="only root") as caught:
        ensure(machine)
    assert re.search(r"--rm tonistiigi/binfmt:\S+@sha256:[0-9a-f]{64} --install arm64$", caught.value.remedy)


def test_a_user_with_sudo(machine: Installer, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sudo = executable(tmp_path / "sudo", f'echo "$*" >>"{tmp_path}/calls"\nshift\nexec "$@"\n')
    monkeypatch.setattr(emulation, "which_system", lambda name: str(sudo) if name == "sudo" else None)
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    assert ensure(machine, hub=True)
    assert list(machine.packages) == [emulation.PACKAGE]
    assert machine.root == [str(sudo), "-n"]
    assert (machine.entries.parent / "table/register").read_text() == ENTRY
    assert f"-n tee {machine.entries.parent}/table/register" in (tmp_path / "calls").read_text()


def test_a_kernel_that_refuses(machine: Installer) -> None:
    register = machine.entries.parent / "table/register"
    register.unlink()
    register.mkdir()
    with pytest.raises(RosmlError, match="the kernel does not take QEMU's entry"):
        ensure(machine)


def test_another_processor(machine: Installer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, "machine", lambda: "riscv64")
    with pytest.raises(RosmlError, match="no emulation is known for riscv64"):
        ensure(machine)
