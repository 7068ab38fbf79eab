"""Which tests are about this project's own matrix and documentation, and mean nothing where a fork has another matrix.

A fork says so itself: its `source:` in matrix.yaml is another address than ours.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
HOME: str = (
    tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    .get("urls", {})
    .get("Repository", "")
)
"""The project's public address, which our own matrix.yaml has as `source:`; empty before there is one."""


def source(matrix: str) -> str:
    """The address of the project that a matrix's text names; empty where it names none."""
    match = re.search(r"^source: *([^\s#]+)", matrix, re.MULTILINE)
    return match[1] if match else ""


FORK = any(
    source(file.read_text(encoding="utf-8")) != HOME
    for file in (ROOT / "matrix.yaml", ROOT / "set.yaml")
    if file.exists()
)
REASON = "about this project's own matrix and documentation, of which this is a fork"

OURS = frozenset(
    {
        "e2e/",
        "page/",
        "unit/images/bake/test_bake.py::test_an_excerpt_prints_as_the_whole",
        "unit/images/bake/test_bake.py::test_people_can_read_it",
        "unit/images/bake/test_bake.py::test_works_from_any_folder",
        "unit/images/image_set/test_own_set.py::test_a_fork_takes_what_rosml_changed",
        "unit/images/bake/test_bake.py::test_frameworks_that_do_not_go_together_are_not_named",
        "unit/images/catalogue/test_catalogue.py",
        "unit/images/catalogue/test_catalogue_format.py",
        "unit/images/image_set/test_design.py",
        "unit/project/test_docs.py::test_every_image_that_a_page_builds_on_is_one_that_there_is",
        "unit/project/test_docs.py::test_old_tags_lead_to_tags_that_there_are",
        "unit/project/test_docs.py::test_yaml_of_the_documentation_is_yaml",
        "unit/project/test_docs.py::test_the_page_of_tags_says_which_distributions_lack_an_image",
        "unit/project/test_recording.py",
        "unit/cli/test_documented.py::test_parsers_accept_what_a_page_shows",
        "unit/images/image_set/test_expand.py::test_where_packages_come_from_this_time",
        "unit/images/image_set/test_expand.py::test_what_no_channel_can_change",
        "unit/images/image_set/test_extend.py::test_a_release_and_a_stack",
        "unit/images/image_set/test_extend.py::test_ros_from_an_archive_of_ones_own",
        "unit/images/bake/test_inputs.py::test_every_file_of_structure_tests_is_run_somewhere",
        "unit/images/scan/test_policy.py::test_the_projects_policy_lets_old_pythons_have_images",
        "unit/images/image_set/test_extend.py::test_a_set_of_ones_own",
        "unit/project/test_docs.py::test_the_page_of_tags_says_which_images_lack_a_lock",
        "unit/images/publish/test_scale.py::test_a_second_run_over_the_whole_matrix_does_nothing",
        "unit/cli/test_selections.py",
        "unit/images/builds/test_sync.py::test_the_repository_of_a_distribution",
        "unit/images/builds/test_sync.py::test_what_there_is_not",
        "unit/images/image_set/test_wheels.py::test_inputs",
        "unit/images/image_set/test_wheels.py::test_the_committed_lock_has_nothing_that_the_system_has",
    }
)
"""Files, or tests of them, below tests/; folders with a slash at their end."""


def skip_ours(items: Iterable[pytest.Item]) -> None:
    """Skips in a fork what is about the matrix that it was forked from."""
    for item in items:
        file = item.path.relative_to(ROOT / "tests").as_posix()
        name = f"{file}::{getattr(item, 'originalname', item.name)}"
        if FORK and any(ours in (file, name) or (ours.endswith("/") and file.startswith(ours)) for ours in OURS):
            item.add_marker(pytest.mark.skip(reason=REASON))
