"""TensorFlow without CUDA: images of two distributions, and parts that are made again, elsewhere and for another architecture."""

from __future__ import annotations

import textwrap
from dataclasses import replace
from pathlib import Path

import pytest

from rosml.images.image_set.model import ImageSet
from rosml.machine.services import Services
from tests.e2e.calls import NAMESPACE
from tests.e2e.images import Publish, build_file, push_part


@pytest.mark.full(proof="systems")
def test_the_cplusplus_part_of_tensorflow_is_the_same_for_every_python(published: Publish) -> None:
    older, newer = published("ros1-bookworm-core-tensorflow-cpu"), published("ros1-trixie-core-tensorflow-cpu")
    shared = older.image.parts.index("tensorflow-cc-cpu")
    assert [one == other for one, other in zip(older.part_layers, newer.part_layers, strict=True)] == [
        index == shared for index in range(len(older.image.parts))
    ]


@pytest.mark.full(proof="arm64")
def test_a_part_for_arm64_is_assembled_without_emulation(
    services: Services, published: Publish, image_set: ImageSet, tmp_path: Path
) -> None:
    """Libraries of that architecture and bytecode, looked at on this one."""
    image = published("ros1-bookworm-core-tensorflow-cpu")
    part = image_set.part_by_name["torch-cpu-py311"]
    push_part(services, image, part, variables={"PLATFORM": "linux/arm64"})
    dockerfile = textwrap.dedent(f"""\
            FROM --platform=linux/arm64 {services.registry}/{NAMESPACE}/part:{part.name} AS part
            FROM --platform=$BUILDPLATFORM {image.result["reference"]}
            COPY --from=part / /arm64/
            COPY look.sh /
            RUN bash /look.sh
        """)
    (tmp_path / "look.sh").write_text(
        textwrap.dedent("""\
            set -euo pipefail
            mapfile -t files < <(find /arm64 -type f -name '*.so*')
            echo "${#files[@]} libraries"
            test "${#files[@]}" -ge 10
            for file in "${files[@]}"; do
              readelf --file-header "$file" | grep -q AArch64 || { echo "$file is not for arm64" >&2; exit 1; }
            done
            test -L /arm64/usr/lib/aarch64-linux-gnu/libtorch_cpu.so
            test -f /arm64/usr/local/lib/python3.11/dist-packages/torch/__pycache__/__init__.cpython-311.pyc
        """)
    )
    build_file(services, tmp_path, dockerfile)


@pytest.mark.full(proof="rebuild")
def test_a_part_assembled_again_elsewhere_has_the_same_digest(
    published: Publish, services: Services, image_set: ImageSet, checkout: Path
) -> None:
    """Without any cache, in another folder: the same lock gives the same layer. Without one, in the same folder:
    tests/e2e/test_containerize.py."""
    image = published("ros1-bookworm-core-tensorflow-cpu")
    elsewhere = replace(services, root=checkout)
    layers = dict(zip(image.image.parts, image.part_layers, strict=True))
    for name in ("common-cpu-py311", "tensorflow-cc-cpu", "tensorflow-cpu-py311"):
        again = push_part(elsewhere, image, image_set.part_by_name[name], "*.no-cache=true")
        assert again == [layers[name]], name
