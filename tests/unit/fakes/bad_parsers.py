"""Parsers that do what none may: the fuzz must catch each."""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path
from typing import NoReturn

from fakes.fuzz import SECONDS, Parser
from rosml.base.errors import RosmlError


def hang(document: bytes, folder: Path) -> NoReturn:
    while True:
        pass


def crash(document: bytes, folder: Path) -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def slow(document: bytes, folder: Path) -> None:
    started = time.process_time()
    while time.process_time() - started < 1.2 * SECONDS:
        pass


def waste(document: bytes, folder: Path) -> int:
    return len(bytearray(300 << 20))


def traceback(document: bytes, folder: Path) -> None:
    raise KeyError("name")


def helpless(document: bytes, folder: Path) -> None:
    raise RosmlError("it is wrong")


def script(document: bytes, folder: Path) -> None:
    sys.exit("it is wrong")


PARSERS = {
    read.__name__: Parser("json", [b"{}"], read) for read in (hang, crash, slow, waste, traceback, helpless, script)
}
