"""A uv.lock as the requirements of an environment."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosml.base.errors import RosmlError
from rosml.images.environments import declaration, uv_lock

INDEX = 'source = { registry = "https://index.example/simple" }'
LOCK = f"""version = 1
revision = 3
requires-python = ">=3.11"

[[package]]
name = "einops"
version = "0.8.2"
{INDEX}

[[package]]
name = "numpy"
version = "2.2.6"
{INDEX}

[[package]]
name = "numpy"
version = "2.5.5"
{INDEX}

[[package]]
name = "torch"
version = "2.10.0+cu128"
{INDEX}
dependencies = [{{ name = "sympy" }}]

[[package]]
name = "sympy"
version = "1.14.0"
{INDEX}

[[package]]
name = "robot"
version = "0.1.0"
source = {{ virtual = "." }}
dependencies = [
    {{ name = "einops", extra = ["jax", "torch"] }},
    {{ name = "numpy", version = "2.2.6", marker = "python_full_version < '3.12'" }},
    {{ name = "numpy", version = "2.5.5", marker = "python_full_version >= '3.12'" }},
    {{ name = "torch" }},
]
"""


def put(tmp_path: Path, text: str = LOCK) -> Path:
    (file := tmp_path / "uv.lock").write_text(text)
    return file


def test_a_project_is_taken_in_its_versions(tmp_path: Path) -> None:
    file = put(tmp_path)
    assert declaration.changed(None, [str(file)], []).requirements == [
        "einops[jax,torch]==0.8.2",
        "numpy==2.2.6; python_full_version < '3.12'",
        "numpy==2.5.5; python_full_version >= '3.12'",
        "torch==2.10.0",
    ]
    assert uv_lock.preferences(file) == "einops==0.8.2\ntorch==2.10.0\nsympy==1.14.0\n"


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (LOCK.replace("version = 1", "version = 2", 1), "is no uv.lock of version 1"),
        (LOCK.replace("[[package]]", "[[package", 1), "is no TOML"),
        (LOCK.replace('"sympy"', '"sympy\\n-r x"'), "is no uv.lock of version 1"),
        (LOCK.replace('virtual = "."', 'registry = "x"'), "is of no project"),
        (LOCK.replace(f'"0.8.2"\n{INDEX}', '"0.8.2"\nsource = { virtual = "b" }'), "is of einops, robot, and"),
        (LOCK.replace(f'"0.8.2"\n{INDEX}', '"0.8.2"\nsource = { git = "https://x" }'), "einops is of no index"),
    ],
)
def test_what_an_environment_cannot_have(text: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        uv_lock.requirements(put(tmp_path, text))
    assert caught.value.exit_code == 2 and caught.value.remedy
