"""Calls of `rosml run` in processes that are forked from one that has imported it: they begin and end as others do, and leave out
the imports, which take longer than the calls.

    .venv/bin/python tests/unit/fakes/forks.py 3      serves calls that come over file descriptor 3
"""

from __future__ import annotations

import functools
import json
import os
import socket
import subprocess
import sys
from collections.abc import Mapping, Sequence

LENGTH = 8
"""Bytes before a call that say how many it has."""

FIXED = ("LANG", "LC_", "PYTHON")
"""The beginnings of variables that Python reads when it starts."""


class Server:
    """A process that forks one for each call; one call at a time."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        self._connection, theirs = socket.socketpair()
        argv = [sys.executable, __file__, str(theirs.fileno())]
        with theirs:
            self._process = subprocess.Popen(argv, env=environment, pass_fds=[theirs.fileno()])

    def begin(self, code: str, words: Sequence[str], folder: str, environment: Mapping[str, str], *files: int) -> None:
        """Begins a call of Python's `code`, as with `-c`. `files` are standard input, output and error."""
        call = json.dumps([code, words, folder, {**environment}]).encode()
        socket.send_fds(self._connection, [len(call).to_bytes(LENGTH, "big")], files)
        self._connection.sendall(call)

    def end(self) -> int:
        """Waits until a call has ended; gives its exit code."""
        return int.from_bytes(self._connection.recv(LENGTH, socket.MSG_WAITALL), "big", signed=True)


@functools.cache
def _server(fixed: tuple[tuple[str, str], ...]) -> Server:
    return Server(dict(fixed))


def server(environment: Mapping[str, str]) -> Server:
    """The server of calls for which Python starts the same."""
    return _server(tuple(item for item in sorted(environment.items()) if item[0].startswith(FIXED)))


def serve(connection: socket.socket) -> str:
    """Takes calls until nobody makes any more. Returns in each forked process, which is then as a new one: the code that it runs."""
    while True:
        head, files, *_ = socket.recv_fds(connection, LENGTH, 3)
        if not head:
            os._exit(0)
        call = connection.recv(int.from_bytes(head, "big"), socket.MSG_WAITALL)
        child = os.fork()
        if not child:
            break
        for file in files:
            os.close(file)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        connection.sendall(code.to_bytes(LENGTH, "big", signed=True))
    connection.close()
    for number, file in enumerate(files):
        os.dup2(file, number)
        os.close(file)
    code, words, folder, environment = json.loads(call)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = ["-c", *words]
    for name, number, mode, buffering in (("stdin", 0, "r", -1), ("stdout", 1, "w", -1), ("stderr", 2, "w", 1)):
        stream = getattr(sys, name)
        new_stream = open(number, mode, buffering, stream.encoding, stream.errors, closefd=False)  # noqa: SIM115
        setattr(sys, name, new_stream)
        setattr(sys, f"__{name}__", new_stream)
    return str(code)


if __name__ == "__main__":
    from rosml.cli.run import attach, run  # noqa: F401 (each call needs one of them)

    sys.path[0] = ""  # as with `-c`
    exec(serve(socket.socket(fileno=int(sys.argv[1]))), {"__name__": "__main__"})
