"""Calls a parser with documents that are wrong, in a process of its own: one that hangs or ends the process is caught."""

from __future__ import annotations

import importlib
import itertools
import multiprocessing
import os
import re
import resource
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing import forkserver
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import pytest

from fakes import mutations
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.images.scan.trivy import SCANNER_FAILED

SECONDS = 3.0
"""Of the processor, for one document. The longest have 600 kB and take 1.3 s on a busy machine; time that grows with the square of
the length is far above."""

BYTES = 200 << 20
"""Of memory, for one document."""

PATIENCE = 30.0
"""Seconds until a parser that says nothing is taken to wait for something."""

CONTEXT = multiprocessing.get_context("forkserver")


@dataclass(frozen=True)
class Parser:
    """A parser. Attributes: kind: of its documents, as `mutations` has it. documents: valid ones. read: reads one in an empty
    folder. What it gives does not count; what it raises does."""

    kind: str
    documents: Sequence[bytes]
    read: Callable[[bytes, Path], object]


def problem(parser: Parser, document: bytes, folder: Path) -> str:
    """What is wrong with how a parser takes a document; empty where it reads it, or says what is wrong with it."""
    started = time.process_time()
    try:
        parser.read(document, folder)
    except InputError as error:  # each of its lines says what to do
        message = "" if error.message and error.exit_code == 2 else f"no message: {error!r}"
    except RosmlError as error:
        codes = (1, 2, SCANNER_FAILED)
        message = (
            "" if error.remedy and error.exit_code in codes else f"no remedy, or exit code {error.exit_code}: {error}"
        )
    except SystemExit as error:  # of a script: what is wrong; what to do
        message = "" if re.match("error: (.|\n)+; .+", str(error.code)) else f"no remedy: {error.code}"
    except BaseException as error:
        message = f"{type(error).__name__}: {error}"[:300]
    else:
        message = ""
    seconds = time.process_time() - started
    return message or (f"it takes {seconds:.1f} s" if seconds > SECONDS else "")


def _work(module: str, name: str, first: int, count: int, out: Connection) -> None:
    parser: Parser = importlib.import_module(module).PARSERS[name]
    with open("/proc/self/statm") as file:
        resource.setrlimit(resource.RLIMIT_AS, (int(file.read().split()[0]) * resource.getpagesize() + BYTES,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        cases = itertools.islice(mutations.mutated(parser.documents, parser.kind, name), first, count)
        for number, document in enumerate(cases, first):
            out.send((number, document[:200]))
            signal.setitimer(signal.ITIMER_PROF, 2 * SECONDS)  # whose signal ends the process
            message = problem(parser, document, Path(tempfile.mkdtemp(dir=place)))
            signal.setitimer(signal.ITIMER_PROF, 0)
            out.send(message)
        out.send(None)


def _start_server(module: str) -> None:
    """Starts the process from which all others are forked, with the parsers imported: Python 3.11 does not tell it our path."""
    CONTEXT.set_forkserver_preload([module])
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", os.pathsep.join(sys.path))
        forkserver.ensure_running()


def problems(module: str, name: str, count: int) -> Iterator[str]:
    _start_server(module)
    first = 0
    while first < count:
        ours, theirs = CONTEXT.Pipe(duplex=False)
        process = CONTEXT.Process(target=_work, args=(module, name, first, count, theirs), daemon=True)
        process.start()
        theirs.close()
        number, document = first, b""
        try:
            while case := _receive(ours):
                number, document = case
                if message := _receive(ours):
                    yield f"{name} {number}: {message}: {document!r}"
            first = count
        except EOFError:
            process.join()
            yield f"{name} {number}: it ends the process with {process.exitcode}: {document!r}"
            first = number + 1
        except TimeoutError:
            yield f"{name} {number}: it waits for something: {document!r}"
            first = number + 1
        finally:
            process.kill()
            process.join()


def _receive(ours: Connection) -> Any:
    if not ours.poll(PATIENCE):
        raise TimeoutError
    return ours.recv()
