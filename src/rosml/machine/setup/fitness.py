"""Whether a builder can build our images: a small build tells, and no version is guessed."""

from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry.client import Registry

REPOSITORY = "rosml/fitness"

DOCKERFILE = """\
FROM scratch
COPY --link --from=files /fit /
"""
"""It has what the bake file and the Dockerfile need: a context with a name, and a linked layer."""


class Unfit(RosmlError):
    """A builder cannot build our images."""


class Unreached(Unfit):
    """A builder gets no answer from the local registry."""


def require(services: Services) -> None:
    """Builds a small image and pushes it to the local registry, as parts are pushed. Raises Unfit."""
    with tempfile.TemporaryDirectory() as name, Registry(services.registry) as registry:
        folder = Path(name)
        files = folder / "files"
        files.mkdir()
        # Each time another content: what an earlier builder pushed says nothing of this one.
        (files / "fit").write_bytes(os.urandom(16))
        (folder / "Dockerfile").write_text(DOCKERFILE)
        output = (
            buildx.output(services, f"{services.registry}/{REPOSITORY}", "fit")
            + ",compression=zstd,oci-mediatypes=true"
        )
        target = {"context": str(folder), "contexts": {"files": str(files)}, "output": [output]}
        (folder / "bake.json").write_text(json.dumps({"target": {"fit": target}}))
        try:
            _, facts = buildx.run(services, buildx.Bake("fit", "fitness", folder / "bake.json"))
        except buildx.Unanswered as error:
            unreached = error.push_target and not error.answer[:3].isdecimal()
            raise (Unreached if unreached else Unfit)(error.message, error.remedy) from None
        except RosmlError as error:
            if error.remedy == buildx.NO_SPACE_REMEDY:  # it could build before, and has the cache
                raise
            raise Unfit(error.message, error.remedy) from None
        digest = facts.get("containerimage.digest", "")
        manifest = registry.manifest(REPOSITORY, digest) if digest else None
        layers = manifest.content.get("layers", []) if manifest else []
        registry.discard(REPOSITORY, digest)
    if not layers or not all(str(layer.get("mediaType")).endswith("+zstd") for layer in layers):
        raise Unfit("it pushes no layers with zstd", "update it")
