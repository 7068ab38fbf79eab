"""Builds Go programs in the user's Docker, on a machine that has no Go."""

from __future__ import annotations

import os
import shlex
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path

from rosml.base.programs import pinned_image
from rosml.machine.setup.process import Call, run
from rosml.machine.setup.state import State

PASSED = ("GOPROXY", "GONOPROXY", "GOPRIVATE", "GOSUMDB", "GONOSUMDB", "HTTP_PROXY", "HTTPS_PROXY", "NO_PROXY")
"""Variables of the user that say where modules come from."""

DOCKERFILE = """\
FROM {image} AS build
{arguments}
WORKDIR /src
COPY . .
ENV CGO_ENABLED=0 GOFLAGS=-mod=readonly GOTOOLCHAIN=auto
RUN --mount=type=secret,id=ca-bundle [ ! -e /run/secrets/ca-bundle ] || export SSL_CERT_FILE=/run/secrets/ca-bundle; \\
    {build}
FROM scratch
COPY --from=build /out/ /
"""
"""`GOTOOLCHAIN=auto` takes the Go that the module asks for; the image's own is older."""


def build(state: State, docker: str, module: Path, command: Sequence[str], program: Path) -> None:
    """Builds the program of a module. `command`: the build, without the name of its output."""
    arguments = [name for name in PASSED if os.environ.get(name)]
    with tempfile.TemporaryDirectory(dir=state.folder) as folder:
        output, dockerfile = Path(folder, "out"), Path(folder, "Dockerfile")
        dockerfile.write_text(
            DOCKERFILE.format(
                image=pinned_image(state.root, "golang"),
                arguments="\n".join(f"ARG {name}" for name in arguments),
                build=shlex.join([command[0], "build", "-o", "/out/program", *command[1:]]),
            )
        )
        argv = [docker, "build", "--progress=plain", f"--file={dockerfile}", f"--output=type=local,dest={output}"]
        argv += [word for name in arguments for word in ("--build-arg", name)]
        argv += [f"--secret=id=ca-bundle,src={state.ca_bundle}"] if state.ca_bundle else []
        log = state.log / f"build-{module.name}.log"
        run(state.say, Call(module.name, [*argv, str(module)], log, {**os.environ, "DOCKER_BUILDKIT": "1"}))
        shutil.move(output / "program", program)
